"""The numbers of the motion: a line each, and bars of the momenta."""

from math import inf
from typing import Any

from support.cradle.motion import Motion, percent_as_text, signed
from support.cradle.real_time import RealTime
from support.page.graph import legible, SUM
from support.page.scene.slow_hits import SlowHits

DIRECTIONS = {"+": " →", "-": " ←"}


def readout_lines(motion: Motion, pace: RealTime, slow_hits: SlowHits) -> dict[str, str]:
    """Return the text of each line of the readout by its name.

    The energy and the momentum are those after the slow hit that is shown, or now. A second line
    of a text is a note, which the page writes small.
    """
    pend_list = slow_hits.shown_pendula()
    p = signed(motion.momenta(pend_list)[-1], motion.momentum_digits)
    arrow = DIRECTIONS.get(p[0], "")
    return {
        "t": f"{motion.time():.2f} s\n{pace.remark()}",
        "energy": percent_as_text(motion.energy_percent(pend_list)),
        "horizontal momentum": f"{p} kg m/s{arrow}\n{what_changes_momentum(motion)}",
    }


def what_changes_momentum(motion: Motion) -> str:
    """Return what changes the momentum of the bobs, and what the hits since the start have done."""
    if not motion.hit_count:
        return "the cords change it"
    if motion.has_kept_momentum:
        return "the cords change it, hits keep it"
    return "the cords and hits change it"


class Bars:
    """The momenta of this moment as bars.

    While the picture rests after a measurement, they are those after the last hits: at that moment,
    most bobs stand still.
    """

    def __init__(self, motion: Motion, slow_hits: SlowHits):
        self.motion = motion
        self.slow_hits = slow_hits
        self.is_on = False  # whether the bars are shown
        self.last_hits = -inf  # s: the time of the last hits
        self.after_hits: list[float] = []  # kg m/s: the momenta after them

    def keep_momenta(self) -> None:
        """Keep the momenta of this moment if there were hits since the last call."""
        if self.motion.last_fast != self.last_hits:
            self.last_hits = self.motion.last_fast
            self.after_hits = self.motion.momenta(self.motion.cradle.pend_list)

    def chart(self, is_resting: bool) -> dict[str, Any] | None:
        """Return a title, and the bars: one for each pendulum, and one for the sum.

        is_resting says whether the picture rests after a measurement.

        A bar is a name, a text, a color as CSS has it, and its part of the full length, negative to
        the left. There is no chart while Momenta is off.
        """
        motion = self.motion
        if not self.is_on:
            return None
        title = "Horizontal momentum (kg m/s)"
        momenta = motion.momenta(self.slow_hits.shown_pendula())
        if is_resting and self.last_hits > -inf:
            title = "Horizontal momentum after the hits (kg m/s)"
            momenta = self.after_hits
        names = [*range(1, len(momenta)), "sum"]
        texts = [signed(p, motion.momentum_digits) for p in momenta]
        colors = [*map(legible, motion.cradle.colors()), SUM]
        parts = [p / motion.most_momentum for p in momenta]
        return {"title": title, "bars": [*zip(names, texts, colors, parts, strict=True)]}
