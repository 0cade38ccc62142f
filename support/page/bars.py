"""Bars of the momenta, with the arrows of the velocities."""

from collections.abc import Sequence
from math import inf
from typing import Any, NamedTuple

from vpython import vector

from support.cradle.motion import Motion, signed
from support.page.graph import to_css
from support.page.questions import Questions
from support.page.scene.marks import GREY, Marks


class Bar(NamedTuple):
    """A bar on the page."""

    name: str
    text: str
    color: str  # as CSS has it
    part: float  # -1 to 1: of the full length, negative to the left


class Bars:
    """The bars of now; while the picture rests after a measurement, those after the last hits.

    Most bobs stop for a moment then.
    """

    def __init__(self, motion: Motion, marks: Marks, questions: Questions):
        self.motion = motion
        self.marks = marks
        self.questions = questions
        self.begin()

    def begin(self) -> None:
        """Begin with a new cradle."""
        self.last_hits = -inf  # s: the time of the last hits
        self.after_hits: list[float] = []  # kg m/s: the momenta after them

    def look(self) -> None:
        """Keep the momenta of this moment if there were hits since the last look."""
        if self.motion.last_fast > self.last_hits:
            self.last_hits = self.motion.last_fast
            self.after_hits = self.marks.momenta_of(self.motion.cradle.pend_list)

    def chart(self) -> dict[str, Any] | None:
        """Return a title, and the bars; None without arrows, and while something is hidden."""
        marks = self.marks
        if not marks.has_arrows or self.motion.cradle.hidden:
            return None
        momenta = marks.momenta
        title = "Momentum (kg m/s)"
        if self.questions.rests_after_measurement() and self.after_hits:
            momenta = self.after_hits
            title = "Momentum after the hits (kg m/s)"
        bars = momentum_bars(momenta, marks.largest, self.motion.cradle.colors())
        return {"title": title, "bars": [bar._asdict() for bar in bars]}


def momentum_bars(momenta: Sequence[float], largest: float, colors: Sequence[vector]) -> list[Bar]:
    """Return a bar for the momentum (kg m/s) of each pendulum, and one for the sum.

    A full bar is the largest momentum (kg m/s).
    """
    names = [*map(str, range(1, len(colors) + 1)), "sum"]
    bars = []
    for name, p, color in zip(names, [*momenta, sum(momenta)], [*colors, GREY], strict=True):
        part = max(-1.0, min(1.0, p / largest))
        bars.append(Bar(name, signed(p), to_css(color), round(part, 3)))
    return bars
