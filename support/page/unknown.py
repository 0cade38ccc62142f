"""The hidden value of an experiment: you type yours, and the page says how far it is off."""

from support.columns import CHECKED
from support.cradle.cradle import Cradle
from support.page.names import State

EXACT = 0.05  # %: a value that is off by less is right
NEAR = 5.0  # %: a value that is off by at most this is found
FAR = 10.0  # %: for a value farther off, no number is said: one guess would give the value away


class Unknown:
    """The value that is hidden in the cradle of this run, until it is found."""

    def __init__(self, cradle: Cradle):
        self.cradle = cradle
        self.begin()

    def begin(self) -> None:
        """Begin with a new cradle: say nothing."""
        self.hidden = self.cradle.hidden
        self.word = ""

    def check(self, text: str) -> None:
        """Say by how many percent the value in this text is off.

        A value near the right one is found: then show the right one, and say how it is found.
        """
        hidden = self.hidden
        if hidden is None:
            return
        column = CHECKED[hidden.column]
        right = self.cradle.values(hidden.column)[hidden.rows[0]]
        text = text.strip().replace(",", ".")
        if not column.allows(text):
            self.word = f"Allowed is {column.allowed()}."
        else:
            off = 100 * (float(text) / right - 1)  # %
            self.word = f"{text} is {how_far(off)}."
            if abs(off) <= NEAR:
                unit = f" {column.unit}" if column.unit else ""
                self.word += f" It is {right:g}{unit}. {hidden.why}"
                self.cradle.hidden = None

    def without_hidden(self, state: State) -> State:
        """Return the whole state of the page without what gives the hidden value away."""
        cradle = self.cradle
        if cradle.hidden:
            for hit in state["hits"]:
                hit["bobs"] = [*map(cradle.without_hidden, hit["bobs"])]
            motion = cradle.without_hidden(state["motion"])
            state |= {"motion": motion, "bars": None, "saved_csv": {}}
        return state

    def state(self) -> State:
        """Return the question, the name and the unit of the value, and a sentence about yours."""
        hidden = self.hidden
        unknown = None
        if hidden:
            name = "e" if hidden.column == "e" else f"mass of bob {hidden.rows[0] + 1}"
            unit = CHECKED[hidden.column].unit
            unknown = {"question": hidden.question, "name": name, "unit": unit}
        return {"unknown": unknown, "checked": self.word}


def how_far(off: float) -> str:
    """Return in words how far a value is off (%)."""
    side = "large" if off > 0 else "small"
    if abs(off) < EXACT:
        return "right"
    if abs(off) > FAR:
        return f"more than {FAR:.0f} % too {side}"
    return f"{abs(off):.1f} % too {side}"
