"""The CSV files that the checks of tier D let students' functions read."""

from collections.abc import Iterator
from contextlib import chdir, contextmanager
from itertools import cycle, islice
from pathlib import Path
from tempfile import TemporaryDirectory

from grading.cradles import csv_of, MIXED_CSV
from support.constants import COLOR_MAP, TEXTURE_MAP

# Equal rows, also the first and the last one, zeros, e = 0 and e = 1, and many digits.
HEAVY = {
    "mass": 12.625,
    "e": 1.0,
    "theta": 0.4375,
    "omega": 0.0,
    "color": "white",
    "texture": "none",
}
LIGHT = {"mass": 0.25, "e": 0.0, "theta": 0.0, "omega": 0.0, "color": "red", "texture": "rug"}
FIVE = [
    HEAVY,
    LIGHT,
    LIGHT,
    {"mass": 2.0, "e": 0.5, "theta": -0.125, "omega": 3.5, "color": "green", "texture": "none"},
    HEAVY,
]
ONE = {"mass": 3.0, "e": 0.5, "theta": 0.1, "omega": 0.2, "color": "green", "texture": "rug"}
# All names and values of COLOR_MAP and TEXTURE_MAP, and rows with them, whose columns are in
# another order.
COLORS_AND_TEXTURES = [*islice(zip(cycle(COLOR_MAP.items()), cycle(TEXTURE_MAP.items())), 40)]
MANY = [
    {"e": 0.5, "color": name, "omega": 0.0, "mass": 0.5 + i, "texture": image, "theta": 0.0}
    for i, ((name, _), (image, _)) in enumerate(COLORS_AND_TEXTURES)
]
FILES = {
    "mixed.csv": MIXED_CSV,
    "five.csv": csv_of(FIVE),  # no line break at the end
    "one.csv": csv_of([ONE]),
    "none.csv": f"{','.join(ONE)}\n",
    "many.csv": csv_of(MANY),
}


@contextmanager
def files(*names: str) -> Iterator[Path]:
    """Make a folder with these FILES the working directory, and yield it.

    On Windows, it is not deleted if a solution left a file open.
    """
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder, chdir(folder):
        for name in names:
            Path(name).write_text(FILES[name], encoding="utf-8")
        yield Path(folder)
