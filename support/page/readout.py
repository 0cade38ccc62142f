"""What the page says of the motion."""

from collections.abc import Sequence
from typing import NamedTuple

from vpython import vector

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.motion import Motion, percent_as_text
from support.cradle.real_time import RealTime
from support.energy import momentum
from support.page.graph import ENERGIES, to_css
from support.page.scene.marks import GREY
from support.pendulum import Pendulum


def readout(motion: Motion, pace: RealTime, pend_list: list[Pendulum]) -> dict[str, str]:
    """Return the time, and the energy and the momentum of these pendula, as text.

    A second line of a text is a note, which the page writes small.
    """
    p = momentum_as_text(momentum(pend_list, R_PARAM))
    return {
        "t": f"{motion.time():.2f} s\n{pace.remark()}",
        "energy": percent_as_text(motion.percents(pend_list)["energy"]).strip(),
        "momentum": f"{p}\n{what_changes_momentum(motion)}",
    }


def what_changes_momentum(motion: Motion) -> str:
    """Return what changes the momentum of the bobs, and what the hits since the start have done."""
    if not motion.hit_count:
        return "gravity changes it"
    if motion.has_kept_momentum:
        return "gravity changes it, hits keep it"
    return "gravity and hits change it"


class Bar(NamedTuple):
    """A bar on the page."""

    name: str
    text: str
    color: str  # as CSS has it
    part: float  # -1 to 1: of the full length, negative to the left
    zero: float  # where the bar begins: 0 at the left end of its place, 0.5 in the middle


def momentum_bars(momenta: Sequence[float], largest: float, colors: Sequence[vector]) -> list[Bar]:
    """Return a bar for the momentum (kg m/s) of each pendulum, and one for the sum.

    A full bar is the largest momentum (kg m/s).
    """
    names = [*map(str, range(1, len(colors) + 1)), "sum"]
    bars = []
    for name, p, color in zip(names, [*momenta, sum(momenta)], [*colors, GREY], strict=True):
        part = max(-1.0, min(1.0, p / largest))
        bars.append(Bar(name, signed(p), to_css(color), round(part, 3), zero=0.5))
    return bars


def energy_bar(percent: float) -> Bar:
    """Return a bar of the energy, in percent of that at the start."""
    text = percent_as_text(percent).strip()
    return Bar("energy", text, ENERGIES["total"], min(1.0, percent / 100), zero=0.0)


def momentum_as_text(p: float) -> str:
    """Return a momentum p (kg m/s) with an arrow in its direction."""
    if abs(p) < 0.0005:
        return f"{signed(p)} kg m/s"
    return f"{signed(p)} kg m/s {'→' if p > 0 else '←'}"


def signed(p: float) -> str:
    """Return a momentum p (kg m/s) as text with its sign."""
    # + 0.0: not -0.000
    return f"{round(p, 3) + 0.0:+.3f}" if abs(p) < 1e4 else f"{p:+.2e}"


def changes(cradle: Cradle, before: dict[str, float]) -> list[str]:
    """Return what one tick has done with the coordinates `before`, in a line for each pendulum."""
    after = cradle.coordinates()
    lines = [f"One tick, {cradle.dt:g} s: before -> after"]
    for i in range(len(cradle.pend_list)):
        texts = []
        for key in (*cradle.angle_keys, *cradle.rate_keys):
            name = f"{key}_{i + 1}"
            texts.append(f"{key} {before[name]:.6g} -> {after[name]:.6g}".ljust(29))
        lines.append(f"[{i}] {' '.join(texts)}".rstrip())
    return lines


def constants(cradle: Cradle) -> str:
    """Return where the constants of the program stand, and why the page cannot change them."""
    gravity = f"G = {G} m/s^2"
    cord = f"R_PARAM = {R_PARAM} m"
    tick = f"{cradle.dt_name} = {cradle.dt} s"
    return (
        f"Gravity ({gravity}), the length of a cord ({cord}) and a tick ({tick}) are constants of "
        "the program, in support/constants.py. The page cannot change them: main has the handout's "
        "line, which takes them from there."
    )
