"""The graph: energies, angles or velocities over the last seconds, or the phase picture of a
pendulum, as rows.
"""

from array import array
from collections import deque
from math import isfinite

from support.files.data_file import EVERY

# The times on the axis, and from row to row (s)
SPANS = {"last 2 s": (2.0, 0.01), "last 10 s": (10.0, 0.03)}
PHASE_SPAN = 3.0, EVERY  # of the phase picture
MOST_ROWS = 1100  # the last 10 s: from row to row it is EVERY, rounded to ticks of at most 0.001 s
MOST_DRAWN = 20  # pendula in the graph: more curves could not be told apart

# Three colors of Okabe and Ito's palette, which look different to color-blind people, too.
ENERGIES = {"kinetic": "rgb(213, 94, 0)", "potential": "rgb(0, 114, 178)", "total": "rgb(0, 0, 0)"}
ENERGY, NOTHING = "Energies", "no graph"


class Graph:
    """Keeps the last samples of Motion, and gives the numbers of the chosen graph; graph.js draws
    them.
    """

    def __init__(self, angle_keys, rate_keys):
        """Begin without samples; angle_keys and rate_keys are those of a pendulum."""
        self.angle_keys, self.rate_keys = angle_keys, rate_keys
        self.rows: deque[array] = deque(maxlen=MOST_ROWS)
        self.choice, self.span = ENERGY, next(iter(SPANS))  # a key of choices, and one of SPANS
        self.begin([])

    def begin(self, colors) -> None:
        """Forget all samples, and take the colors (VPython's) of a new cradle's pendula: so are
        their curves.
        """
        self.rows.clear()
        parts = [
            ", ".join(str(round(255 * part)) for part in color.value)
            for color in colors[:MOST_DRAWN]
        ]
        numbered = [(number, f"rgb({color})") for number, color in enumerate(parts, start=1)]
        # The names of the axes, the number along x, and the number and color of each curve, by its
        # label.
        # By the name in the menu
        self.choices: dict[str, tuple[str, str, str, dict[str, tuple[str, str]]]] = {}
        self.choices[ENERGY] = (
            "t (s)",
            "%",
            "t",
            {name: (name, hue) for name, hue in ENERGIES.items()},
        )
        for title, unit, keys in (
            ("Angles", "rad", self.angle_keys),
            ("Velocities", "rad/s", self.rate_keys),
        ):
            for key in keys:
                curves = {str(number): (f"{key}_{number}", color) for number, color in numbered}
                self.choices[f"{title} {key}"] = "t (s)", f"{key} ({unit})", "t", curves
        for number, color in numbered:
            for angle, rate in zip(self.angle_keys, self.rate_keys, strict=True):
                name = (
                    f"Phase {number}" if len(self.angle_keys) == 1 else f"Phase {number}, {angle}"
                )
                curves = {"": (f"{rate}_{number}", color)}
                self.choices[name] = (
                    f"{angle} (rad)",
                    f"{rate} (rad/s)",
                    f"{angle}_{number}",
                    curves,
                )
        self.choices[NOTHING] = "", "", "t", {}
        self.show(self.choice)

    def add(self, sample) -> None:
        """Add a sample, in place of one of the same time; all samples of a cradle have the same
        names.
        """
        self.names = list(sample)  # of the numbers in a row
        if self.rows and self.rows[-1][0] == sample["t"]:
            self.rows.pop()
        # A twentieth of the memory that dictionaries take
        self.rows.append(array("d", sample.values()))

    def show(self, choice) -> None:
        """Show this one of the choices, or the energies if the present cradle does not have it."""
        self.choice = choice if choice in self.choices else ENERGY

    def state(self, start_energy) -> dict:
        """Return the names of the axes, the curves with their colors, the rows, and the ends of the
        time axis (s).
        """
        x, y, along, curves = self.choices[self.choice]
        state: dict = {
            "x": x,
            "y": y,
            "curves": [(label, color) for label, (_, color) in curves.items()],
            "rows": [],
        }
        if not curves or not self.rows:
            return state
        seconds, interval = SPANS[self.span] if along == "t" else PHASE_SPAN
        places = [
            self.names.index(name) for name in (along, *(name for name, _ in curves.values()))
        ]
        # A row has the number along x, and one for each curve; start_energy (J) is 100 %.
        units = [1, *((start_energy or 1) / 100 if label in ENERGIES else 1 for label in curves)]
        pairs = list(zip(places, units, strict=True))
        rows = [
            [row[place] / unit for place, unit in pairs]
            for row in last_rows(self.rows, seconds, interval)
        ]
        state["rows"] = [
            [round(number, 6) for number in row] for row in rows if all(map(isfinite, row))
        ]
        if along == "t":
            state["to"] = max(seconds, rows[-1][0])
            state["from"] = state["to"] - seconds
        return state


def last_rows(rows, seconds, interval) -> list:
    """Return the rows of the last seconds: the first one in each interval (s), as long as it is
    drawn, and the last.

    A row begins with its time (s).
    """
    firsts: dict[int, array] = {}
    for row in rows:
        # 0.09 / 0.03 could be 2.9999999999999996
        firsts.setdefault(int(row[0] / interval + 1e-6), row)
    drawn = [*firsts.values()]
    if drawn[-1] is not rows[-1]:
        drawn.append(rows[-1])
    return [row for row in drawn if row[0] >= rows[-1][0] - seconds]
