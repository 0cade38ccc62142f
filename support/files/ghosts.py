"""A motion in a file, which ghosts then follow: of a filmed cradle, or as --record writes it.

The CSV has a column t (s), and columns of angles: theta_1 (rad, positive to the right), or theta_1
(degrees); for the double cradle also phi_1. Other columns are ignored, and so are lines before the
names, except one: start,0.533,-41.5 says that the bobs were let go at t = 0.533 s, the first one at
theta = -41.5 degrees. An empty cell, or NaN, stands for a moment at which the bob was not found.
"""

import re
from collections.abc import Sequence
from itertools import accumulate, takewhile
from math import degrees, isfinite, nan, radians, remainder, sqrt, tau
from pathlib import Path
from typing import NamedTuple

import numpy as np

from support.columns import to_number
from support.files.cradle_csv import plain_cell, separator_in, Snapshot
from support.found import found
from support.pendulum import cord_angles, Pendulum

# The units of a time (s) and of an angle (rad), by their names in a file
UNITS = dict.fromkeys((None, "s", "sec", "seconds", "rad", "radians"), 1.0)
UNITS |= dict.fromkeys(("degrees", "deg", "°"), radians(1))
UNKNOWN = [0.0], [nan]  # the times, and the angles, of a column that is not there


class Column(NamedTuple):
    place: int  # in a row
    unit: float  # of its numbers (s or rad)


class Ghosts:
    """The motion in a file, and how far a cradle is off it. It never changes the cradle."""

    def __init__(self, name: str = "", keys: Sequence[str] = ()) -> None:
        """Begin without angles; name is that of the file, keys are a pendulum's of its angles."""
        self.name = name
        self.keys = keys
        self.angle: float | None = None  # rad: of the release, if the file says it
        # The times (s) after the release and the angles (rad), by theta_1, ...
        self.tracks: dict[str, tuple] = {}
        self.begin()

    def begin(self) -> None:
        """Forget the differences: the cradle is released."""
        self.squares = 0.0  # rad^2: their sum
        self.count = 0

    def poses(self, time: float, count: int) -> dict[int, list[float]]:
        """Return the angles (rad) of the cords from straight down, by the pendulum's index.

        They are those of the first `count` pendula, at this time (s) after the release. From one
        angle to the next, a cord turns evenly, the shorter way. Without the upper cord, nothing is
        known of the lower one.
        """
        found = {}
        for index in range(count):
            angles = []
            for key in self.keys:
                times, known = self.tracks.get(f"{key}_{index + 1}", UNKNOWN)
                angles.append(np.interp(time, times, known, left=nan, right=nan))
            cords = [*takewhile(isfinite, accumulate(angles))]
            if cords:
                found[index] = cords
        return found

    def compare(self, pend_list: Sequence[Pendulum], time: float) -> None:
        """Add the differences of the cords of these pendula from the poses at this time (s)."""
        for index, cords in self.poses(time, len(pend_list)).items():
            for now, angle in zip(cord_angles(pend_list[index]), cords, strict=False):
                self.squares += remainder(now - angle, tau) ** 2
                self.count += 1

    def readout(self) -> dict[str, str]:
        """Return the root of the mean square of the differences as text, by its name.

        As long as there is none, return the times (s) of the ghosts.
        """
        if not self.tracks:
            return {}
        if not self.count:
            first = min(times[0] for times, _ in self.tracks.values())
            last = max(times[-1] for times, _ in self.tracks.values())
            return {"ghosts": f"{first:.1f} to {last:.1f} s"}
        off = degrees(sqrt(self.squares / self.count))
        return {"off by": f"{off:.2f} degrees"}


def read_ghosts(file: Snapshot, keys: Sequence[str]) -> Ghosts:
    """Return the motion in a file; keys name a pendulum's angles, that of the upper cord first.

    Raises a ValueError with a one-line message that names the first mistake in it.
    """
    ghosts = Ghosts(Path(file.filepath).name, keys)
    release = 0.0  # s: the time in the file
    text = file.text().replace("\t", ";")  # Tracker puts tabs between cells
    lines = text.splitlines(keepends=True)
    for above, line in enumerate(lines):
        name, *cells = cells_in(line)
        columns = columns_in([name, *cells], keys)
        if "t" in columns and len(columns) > 1:
            table = "\n" * above + "".join(lines[above:])
            ghosts.tracks = tracks_in(Snapshot(file.filepath, table.encode()), keys, release)
            return ghosts
        if name == "start":
            release, angle = release_in(f"{file}, line {above + 1}", cells)
            ghosts.angle = radians(angle)
    raise ValueError(
        f"{file}: names no columns, allowed is a line with t, and {keys[0]}_1 (rad), or "
        f"{keys[0]}_1 (degrees), ..., with a comma, a semicolon or a tab between them"
    )


def cells_in(line: str) -> list[str]:
    """Return the cells of a line, without quotes, and without empty cells at its end."""
    separator = separator_in(line)
    cells = line.strip().rstrip(separator).split(separator)
    return [plain_cell(cell.strip(' "'), separator) for cell in cells]


def release_in(place: str, cells: list[str]) -> list[float]:
    """Return the time (s) and the angle (degrees) of the release from the cells after start.

    Raises a ValueError if they say something else; place is their line.
    """
    numbers = [*map(to_number, cells)]
    if not (len(numbers) == 2 and isfinite(numbers[0]) and -180 <= numbers[1] <= 0):
        allowed = "the time (s) of the release, and its angle, from -180 to 0 (degrees)"
        raise ValueError(f"{place}, after start: {found(', '.join(cells), allowed)}")
    return numbers


def columns_in(names: Sequence[str], keys: Sequence[str]) -> dict[str, Column]:
    """Return the columns of the time, t, and of angles, theta_1, ..., from the names in a file."""
    angle = rf"(?:{'|'.join(keys)})_[1-9]\d*"
    # `t`, `# t`, `Time (s)`, `theta_1 [rad]`, `theta_1 / degrees`
    pattern = re.compile(rf"#?\s*(t|time|{angle})\s*(?:[([/]\s*(.+?)[)\]]?)?")
    columns = {}
    for place, text in enumerate(names):
        match = pattern.fullmatch(text.lower())
        if match and match[2] in UNITS:
            columns[match[1].replace("time", "t")] = Column(place, UNITS[match[2]])
    return columns


def tracks_in(file: Snapshot, keys: Sequence[str], release: float) -> dict[str, tuple]:
    """Return the times (s) and the angles (rad) of each column of angles, by its name.

    The times are those after the release, whose time (s) in the file is given. Raises a ValueError
    for the first mistake, or if there is no angle.
    """
    header, *rows = file.rows()
    columns = columns_in(header.cells, keys)
    numbers: dict[str, list[float]] = {name: [] for name in columns}
    times = numbers["t"]
    for row in rows:
        for name, column in columns.items():
            text = row.cells[column.place]
            number = to_number(text) * column.unit
            if name == "t":
                allowed = "a time (s), after that of the row above"
                is_allowed = isfinite(number) and (not times or number > times[-1])
            else:
                allowed = "a number, or nothing"
                is_allowed = isfinite(number) or text.lower() in ("", "nan")
            if not is_allowed:
                place = f"{file}, line {row.line}, column {header.cells[column.place]}"
                raise ValueError(f"{place}: {found(text, allowed)}")
            numbers[name].append(number)
    del numbers["t"]
    tracks = {}
    for name, angles in numbers.items():
        known = np.isfinite(angles)
        if any(known):
            tracks[name] = (np.array(times)[known] - release, np.unwrap(np.array(angles)[known]))
    if not tracks:
        raise ValueError(f"{file}: found no angle, allowed is at least one")
    return tracks
