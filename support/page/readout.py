"""The readout: the numbers of the motion, a line each."""

from support.constants import R_PARAM
from support.cradle.motion import Motion, percent_as_text, signed
from support.cradle.real_time import RealTime
from support.cradle.stopwatch import Stopwatch
from support.energy import momentum
from support.page.ghost_file import GhostFile
from support.page.scene.marks import Marks
from support.page.scene.slow_hits import SlowHits


class Readout:
    """The lines of the readout."""

    def __init__(
        self,
        motion: Motion,
        pace: RealTime,
        slow_hits: SlowHits,
        marks: Marks,
        stopwatch: Stopwatch,
        ghost_file: GhostFile,
    ):
        self.motion = motion
        self.pace = pace
        self.slow_hits = slow_hits
        self.marks = marks
        self.stopwatch = stopwatch
        self.ghost_file = ghost_file

    def lines(self) -> dict[str, str]:
        """Return the text of each line by its name.

        The energy and the momentum are those after the slow hit that is shown, or of now; they
        would show what is hidden. A second line of a text is a note, which the page writes small.
        """
        pend_list = self.slow_hits.shown_pendula()
        lines = {"t": f"{self.motion.time():.2f} s\n{self.pace.remark()}"}
        if not self.motion.cradle.hidden:
            percent = self.motion.energy_percent(pend_list)
            p = momentum_as_text(momentum(pend_list, R_PARAM))
            lines["energy"] = percent_as_text(percent).strip()
            lines["momentum"] = f"{p}\n{what_changes_momentum(self.motion)}"
        if self.marks.measures:
            lines["half swings"] = str(self.stopwatch)
        return lines | self.ghost_file.ghosts.readout()


def what_changes_momentum(motion: Motion) -> str:
    """Return what changes the momentum of the bobs, and what the hits since the start have done."""
    if not motion.hit_count:
        return "gravity changes it"
    if motion.has_kept_momentum:
        return "gravity changes it, hits keep it"
    return "gravity and hits change it"


def momentum_as_text(p: float) -> str:
    """Return a momentum p (kg m/s) with an arrow in its direction."""
    if abs(p) < 0.0005:
        return f"{signed(p)} kg m/s"
    return f"{signed(p)} kg m/s {'→' if p > 0 else '←'}"
