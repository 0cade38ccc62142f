"""One tick: what it changes, and the collisions in it."""

from support.cradle.cradle import Cradle
from support.cradle.hits import Hits


class OneTick:
    """The lines about the last tick that you have asked for."""

    def __init__(self, cradle: Cradle, hits: Hits):
        self.cradle = cradle
        self.hits = hits
        self.clear()

    def clear(self) -> None:
        """Show nothing: there is a new cradle."""
        self.before: dict[str, float] | None = None  # the coordinates, while the tick is done
        self.lines: list[str] = []

    def begin(self) -> None:
        """Keep the coordinates before the tick."""
        self.before = self.cradle.coordinates()

    def end(self) -> None:
        """Compare the coordinates after the tick, if it was asked for, and take its calls."""
        if self.before is None:
            return
        calls = self.hits.calls or [f"No call of {self.cradle.shown_name} was seen."]
        self.lines = changes(self.cradle, self.before)
        if not self.cradle.hidden:  # a call has all masses and e
            self.lines += calls
        self.before = None


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
