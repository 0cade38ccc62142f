"""A motion in a file: of a filmed cradle, or as --record writes it; ghosts then move so.

The CSV has a column t (s), and columns of angles: theta_1 (rad, positive to the right), or theta_1
(degrees); for the double cradle also phi_1. Other columns are ignored, and lines before the names,
but for one: start,0.533,-41.5 says that the bobs were let go at t = 0.533 s, the first one at theta
= -41.5 degrees. An empty cell, or NaN, stands for a moment at which the bob was not found.
"""

import re
from collections.abc import Sequence
from itertools import accumulate, takewhile
from math import degrees, inf, isfinite, nan, radians, remainder, sqrt, tau
from pathlib import Path

import numpy as np

from support.columns import to_number
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import in_short
from support.pendulum import cord_angles, Pendulum

IN_DEGREES = " (degrees)", " (°)"  # the end of a column's name
# The line with the names of the columns
NAMES = re.compile(r'(?m)^(.*[,;\t])?"?t( \(s\))?"?([,;\t].*)?$')
# A line with the time (s) of the release, and its angle (degrees)
START = re.compile(r"(?m)^start([,;\t])(.*?)\1*\r?$")
UNKNOWN = [0.0], [nan]  # the times, and the angles, of a column that is not there


class Ghosts:
    """The motion in a file, and how far a cradle is off it. It never changes the cradle."""

    def __init__(self, name: str = "", keys: Sequence[str] = ()) -> None:
        """Begin without angles; name is that of the file, keys are a pendulum's of its angles."""
        self.name = name
        self.keys = keys
        self.mistake = ""  # in a later file, which is not taken
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

    def note(self, pend_list: Sequence[Pendulum], time: float) -> None:
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
    """Return the motion in a file; keys are a pendulum's of its angles, the upper cord's first.

    Raises a ValueError with a one-line message that names the first mistake in it.
    """
    ghosts = Ghosts(Path(file.filepath).name, keys)
    text = file.text()
    release = 0.0  # s: the time in the file
    start = START.search(text)
    if start:
        separator, cells = start.groups()
        if separator != ",":
            cells = cells.replace(",", ".")
        numbers = [*map(to_number, cells.split(separator))]
        if not (len(numbers) == 2 and isfinite(numbers[0]) and -180 <= numbers[1] <= 0):
            line = text.count("\n", 0, start.start()) + 1
            raise ValueError(
                f"{file}, line {line}: found {in_short(repr(start[0]))}, allowed is start, the "
                "time (s) of the release, and its angle, from -180 to 0 (degrees)"
            )
        release = numbers[0]
        ghosts.angle = radians(numbers[1])
        text = text.replace(start[0], "")
    names = NAMES.search(text)
    if not names:
        raise ValueError(f"{file}: found no line with the column t, such as t,theta_1")
    table = Snapshot(file.filepath, with_commas(text, names).encode())
    ghosts.tracks = tracks_in(table, keys, release)
    if not ghosts.tracks:
        raise ValueError(f"{file}: found no angle, allowed is at least one")
    return ghosts


def with_commas(text: str, names: re.Match) -> str:
    """Return the text of a CSV with commas between cells, and blank lines before the names."""
    above = "\n" * text.count("\n", 0, names.start())
    table = text[names.start() :]
    separator = ","
    for sign in ";\t":
        if names[0].count(sign) > names[0].count(separator):
            separator = sign
    if separator != ",":
        table = table.replace(",", ".").replace(separator, ",")
    return above + table


def tracks_in(file: Snapshot, keys: Sequence[str], release: float) -> dict[str, tuple]:
    """Return the times (s) and the angles (rad) of each column of angles, by its name.

    The times are those after the release, whose time (s) in the file is given. The file has commas
    between cells.
    """
    header, *rows = file.rows
    pattern = rf"t|t \(s\)|({'|'.join(keys)})_[1-9]\d*( \((rad|degrees|°)\))?"
    columns: dict[str, list[float]]
    columns = {name: [] for name in header.cells if re.fullmatch(pattern, name)}
    time = "t" if "t" in columns else "t (s)"
    if time not in columns or len(columns) < 2:
        names = in_short(repr(", ".join(header.cells)))
        raise ValueError(
            f"{file}, line {header.line}: found {names}, allowed is a line with t, and "
            f"{keys[0]}_1 (rad), or {keys[0]}_1 (degrees), ..."
        )
    last = -inf
    for row in rows:
        cells = dict(zip(header.cells, row.cells, strict=False))
        for name, numbers in columns.items():
            text = cells.get(name, "")
            number = to_number(text)
            numbers.append(number)
            found = f"{file}, line {row.line}, column {name}: found {in_short(repr(text))}"
            if name == time and not number > last:
                raise ValueError(f"{found}, allowed is a time (s) after that of the line before")
            if not isfinite(number) and text.lower() not in ("", "nan"):
                raise ValueError(f"{found}, allowed is a number, or nothing")
        last = columns[time][-1]
    times = np.array(columns.pop(time)) - release
    tracks = {}
    for name, numbers in columns.items():
        angles = np.array(numbers)
        if name.endswith(IN_DEGREES):
            angles = np.radians(angles)
        known = np.isfinite(angles)
        if any(known):
            tracks[name.partition(" ")[0]] = (times[known], np.unwrap(angles[known]))
    return tracks
