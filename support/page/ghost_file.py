"""The ghosts of a file: pale bobs that move as a cradle in a video did, or as --record has written.

The CSV has a column t, or Time (s; 0 is the release), and columns of angles, positive to the right:
theta_1 (rad), or theta_1 (degrees), ... Other columns are ignored. A row without a number in t or
in theta_1 says nothing of theta_1.
"""

import re
from base64 import b64decode
from collections.abc import Callable
from math import degrees, isfinite, remainder, sqrt, tau
from pathlib import Path

import numpy as np

from support.columns import to_number
from support.files.cradle_csv import Snapshot
from support.found import found
from support.page.names import State

TIME = r"^t(ime)?( \(s\))?$"
ANGLE = r"theta_([1-9]\d{0,3})(?: \(rad\)| (\(degrees\)))?"
COLUMNS = "a column t, and theta_1 or theta_1 (degrees), ..., with a number in the same row"


class GhostFile:
    """The motion in a file, or none, and how far a cradle differs from it."""

    def __init__(self) -> None:
        self.remove()

    # --- the file --------------------------------------------------------------------------------

    def remove(self) -> None:
        self.name = ""
        self.mistake = ""  # in a later file, which is not taken
        # The times (s) after the release and the angles (rad), by the pendulum's index
        self.tracks: dict[int, tuple[np.ndarray, np.ndarray]] = {}
        self.begin()

    def load(self, restart: Callable[[], None], name: str, url: str) -> None:
        """Take a file, and restart the cradle; or show the mistake in the file.

        The url has its content, as FileReader of the browser makes it.
        """
        try:
            self.read(Snapshot(name, b64decode(url.partition(",")[2])))
            restart()
        except Exception as error:  # a file can be anything: the cradle of the class swings on
            self.mistake = f"Not taken: {error}"

    def read(self, file: Snapshot) -> None:
        """Take the motion in a file.

        Raises a ValueError with a one-line message that names the first mistake in it.
        """
        columns = {}
        for name, *cells in zip(*(row.cells for row in file.rows()), strict=True):
            columns[re.sub(TIME, "t", name.lower())] = [*map(to_number, cells)]
        tracks = {}
        for name, numbers in columns.items():
            match = re.fullmatch(ANGLE, name)
            rows = zip(columns.get("t", []), numbers, strict=False)
            known = sorted(row for row in rows if all(map(isfinite, row)))
            if match and known:
                number, is_in_degrees = match.groups()
                # Each in one piece, which np.interp uses as it is
                times, angles = np.transpose(known).copy()
                largest = max(angles, key=abs)
                if is_in_degrees:
                    angles = np.radians(angles)
                elif abs(largest) > tau:
                    allowed = f"-6.28 to 6.28 (rad), or name the column {name} (degrees)"
                    raise ValueError(f"{file}, {name}: {found(str(largest), allowed)}")
                tracks[int(number) - 1] = times, angles
        if not tracks:
            raise ValueError(f"{file}: {found(', '.join(columns), COLUMNS)}")
        self.remove()
        self.name = Path(file.filepath).name
        self.tracks = tracks

    def state(self) -> State:
        """Return the name of the file, and the mistake."""
        return {"ghosts": self.name, "mistake_in_ghosts": self.mistake}

    # --- the motion ------------------------------------------------------------------------------

    def poses(self, time: float, count: int) -> dict[int, list[float]]:
        """Return the theta (rad) of ghosts at this time (s) after the release, each in a list.

        They are those of the first `count` pendula, by their index. From one row of the file to the
        next, a cord turns evenly.
        """
        poses = {}
        for index, (times, angles) in self.tracks.items():
            if index < count and times[0] <= time <= times[-1]:
                poses[index] = [np.interp(time, times, angles)]
        return poses

    def begin(self) -> None:
        """Forget the differences: the cradle is released."""
        self.squares = 0.0  # rad^2: their sum
        self.count = 0

    def compare(self, pend_list: list[dict], time: float) -> None:
        """Add the differences of theta of these pendula from that of their ghosts at this time (s).

        The pendula stay as they are.
        """
        for index, [angle] in self.poses(time, len(pend_list)).items():
            self.squares += remainder(pend_list[index]["theta"] - angle, tau) ** 2
            self.count += 1

    def readout(self) -> dict[str, str]:
        """Return the root of the mean square of the differences as text, by its name.

        As long as there is none, return the times (s) of the ghosts.
        """
        if self.count:
            off = degrees(sqrt(self.squares / self.count))
            return {"off by": f"{off:.2f} degrees"}
        if self.tracks:
            times = np.concatenate([times for times, _ in self.tracks.values()])
            return {"ghosts": f"{times.min():.1f} to {times.max():.1f} s"}
        return {}
