"""The columns of a cradle's CSV, in the order of the shipped file."""

from collections.abc import Collection
from math import nan
from typing import NamedTuple

from support.constants import COLOR_MAP, TEXTURE_MAP


def to_number(text: str) -> float:
    """Return the number in text, or nan."""
    try:
        return float(text)
    except ValueError:
        return nan


class Column(NamedTuple):
    """A column, with the values that its cells may have."""

    name: str
    example: str = ""  # of its numbers, in a message
    unit: str = ""  # of its numbers
    limits: tuple[float, float] | None = None  # the least and the greatest number
    choices: Collection[str] = ()  # names

    def allows(self, text: str) -> bool:
        """Return whether a cell may have this text."""
        if self.limits is None:
            return text in self.choices or not self.choices
        least, most = self.limits
        return least <= to_number(text) <= most

    def allowed(self) -> str:
        """Return the allowed values, in words."""
        if self.limits is None:
            return f"one of {', '.join(self.choices)}"
        least, most = self.limits
        unit = f" ({self.unit})" if self.unit else ""
        return f"a number from {least:g} to {most:g}{unit}, such as {self.example}"


# theta and omega have no limits: the start of a cradle does not depend on them.
COLUMNS = (
    # In a double cradle, a light bob between two heavy ones can get so fast that a tick has to be
    # done in many small steps (src/double_cradle.py). With these masses, no trial needed more than
    # about two hundred.
    Column("mass", example="1.5", unit="kg", limits=(0.001, 1000)),
    Column("e", example="0.9", limits=(0, 1)),
    Column("theta", unit="rad"),
    Column("omega", unit="rad/s"),
    Column("color", choices=COLOR_MAP),
    Column("texture", choices=TEXTURE_MAP),
)

# The names of the columns of the CSVs that the programs write.
COLUMN_NAMES = [column.name for column in COLUMNS]
# The columns without which a CSV is no cradle, by name; their cells are checked.
CHECKED = {column.name: column for column in COLUMNS if column.limits or column.choices}
# The names of the numbers of each pendulum that you can set.
SETTABLE = [name for name, column in CHECKED.items() if column.limits]
