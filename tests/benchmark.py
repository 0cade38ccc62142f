"""The speed and the accuracy of the cradle, also compared with pymunk, a physics engine for games.

Run it by hand: `.venv/bin/python tests/benchmark.py`. It takes a few minutes. Compare numbers only within one run.
"""

import sys
import tempfile
import time
from functools import partial
from math import cos, inf, sin
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parent))  # so that Python finds grading, also with -P

import vpython

from grading import project_path  # noqa: F401  finds the imports below

vpython.baseObj._view_constructed = True  # VPython then believes that the page is open: no server, no browser

from grading.cradles import csv_of
from src import visualize_cradle_run
from src.special_cradles import make_newton_cradle
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.cradle.many_ticks import many_ticks
from support.energy import kinetic_energy, potential_energy
from support.start.options import OneLineParser
from support.start.output import while_it_is_read

MINUTE, SAMPLE = 60.0, 0.01  # s: simulated, and between two measurements of the energy
TICKS = [DT * times for times in (1, 2, 5, 10, 20)]  # s
STEPS = [1 / 200, 1 / 1000, 1 / 5000]  # s, of pymunk


class OurCradle:
    """Equal elastic pendula, the first one lifted, by many_ticks or by newton_cradle_tick."""

    def __init__(self, count=5, at_once=True):
        self.at_once = at_once
        with tempfile.TemporaryDirectory() as folder:
            csv = Path(folder, "cradle.csv")
            csv.write_text(csv_of([{"mass": 1, "e": 1, "color": "red", "texture": "metal"}] * count))
            self.pend_list = make_newton_cradle(csv, R_PARAM, THETA_INIT)

    def energy(self) -> float:
        """Return the kinetic and potential energy (J)."""
        return kinetic_energy(self.pend_list, R_PARAM) + potential_energy(self.pend_list, R_PARAM, G)

    def advance(self, dt, seconds) -> None:
        """Move on by seconds, in ticks of dt (s), with the rule of the programs."""
        ticks, scope = round(seconds / dt), {**vars(visualize_cradle_run), "DT": dt}
        if not self.at_once:
            for _ in range(ticks):
                newton_cradle_tick(self.pend_list, R_PARAM, dt, G, approaching_only=True)
        elif many_ticks(scope, self.pend_list, ticks, {"approaching_only": True}) is None:
            raise ValueError("many_ticks does not know these functions: see tests/project/test_many_ticks.py")


class PymunkCradle:
    """The same five pendula, with circles and pin joints of pymunk."""

    def __init__(self):
        import pymunk

        self.space = pymunk.Space()
        self.space.gravity = 0, -G
        self.space.collision_slop = 0
        for i in range(5):
            theta, x = THETA_INIT if i == 0 else 0, i * R_PARAM / 4
            body = pymunk.Body(mass=1, moment=inf)
            body.position = x + R_PARAM * sin(theta), -R_PARAM * cos(theta)
            bob = pymunk.Circle(body, 0.9995 * R_PARAM / 8)  # at rest, there is a small gap between the bobs
            bob.elasticity = 1
            self.space.add(body, bob, pymunk.PinJoint(self.space.static_body, body, (x, 0)))

    def energy(self) -> float:
        """Return the kinetic and potential energy (J)."""
        return sum(body.velocity.length**2 / 2 + G * (body.position.y + R_PARAM) for body in self.space.bodies)

    def advance(self, dt, seconds) -> None:
        """Move on by seconds, in steps of dt (s)."""
        for _ in range(round(seconds / dt)):
            self.space.step(dt)


def cpu_time(make, dt, seconds) -> float:
    """Return the processor time (s) that a cradle takes for these simulated seconds: the least of five."""
    times = []
    for _ in range(5):
        cradle, start = make(), time.process_time()
        cradle.advance(dt, seconds)
        times.append(time.process_time() - start)
    return min(times)


def energy_error(cradle, dt) -> float:
    """Return the largest energy error in a MINUTE, at each SAMPLE, as a part of the energy at the start."""
    start, error = cradle.energy(), 0.0
    for _ in range(round(MINUTE / SAMPLE)):
        cradle.advance(dt, SAMPLE)
        error = max(error, abs(cradle.energy() / start - 1))
    return error


def show_row(*cells) -> None:
    """Print cells as a row of a table in Markdown."""
    print(f"| {' | '.join(map(str, cells))} |", flush=True)


@while_it_is_read()
def main() -> None:
    """Print all measurements."""
    OneLineParser(description="Measure the speed and the accuracy of the cradle.", allow_abbrev=False).parse_args()
    print("Ticks a second on VPython's objects; times: many_ticks against single ticks.\n")
    show_row("pendula", "newton_cradle_tick", "many_ticks", "times", "us a pendulum and tick")
    show_row(*["---"] * 5)
    for count in (5, 50, 500):
        few, many = 20_000 // count, 1_000_000 // count  # ticks
        single = cpu_time(partial(OurCradle, count, at_once=False), DT, few * DT) / few
        fast = cpu_time(partial(OurCradle, count), DT, many * DT) / many
        speeds = f"{1 / single:,.0f}", f"{1 / fast:,.0f}"
        show_row(count, *speeds, f"{single / fast:.1f}", f"{1e6 * fast / count:.3f}")
    print(f"\n{MINUTE:g} simulated seconds of five pendula. Energy error: the largest at any {SAMPLE:g} s.\n")
    show_row("engine", "step", "processor time", "energy error")
    show_row(*["---"] * 4)
    cradles = [("many_ticks", OurCradle, dt) for dt in TICKS]
    for engine, make, dt in [*cradles, *(("pymunk, its own settings", PymunkCradle, dt) for dt in STEPS)]:
        cpu = cpu_time(make, dt, MINUTE)
        show_row(engine, f"{1000 * dt:g} ms", f"{cpu:.3f} s", f"{energy_error(make(), dt):.2g}")


if __name__ == "__main__":
    main()
