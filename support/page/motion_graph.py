"""The graph: energies, angles or velocities over the last seconds, or the phase picture of a pendulum."""

from array import array
from collections import deque
from itertools import islice
from typing import NamedTuple

from vpython import color, gcurve, graph, vector

from support.files.data_file import EVERY

SPANS = {"last 2 s": (2.0, 0.01), "last 10 s": (10.0, 0.03)}  # the times on the axis, and from point to point (s)
LONGEST_SPAN = max(seconds for seconds, _ in SPANS.values())
PHASE_SPAN = 3.0, EVERY  # of the phase picture
MOST_DRAWN = 20  # pendula in the graph: more curves could not be told apart

# Three colors of Okabe and Ito's palette, which look different to color-blind people, too.
ENERGIES = {"kinetic": vector(213, 94, 0) / 255, "potential": vector(0, 114, 178) / 255, "total": color.black}
ENERGY, NOTHING = "Energies", "no graph"  # panel.css knows the second one, too
PHASE = "phase"  # the label of its curve; panel.js knows it


class Choice(NamedTuple):
    """A choice of the menu: the names of the axes, and for each curve the two names of the numbers that it draws."""

    x: str
    y: str
    columns: dict[str, tuple[str, str]]  # by the curve's label


class MotionGraph:
    """Draws a choice of curves of the last samples of Motion. While hidden, it sends no points."""

    def __init__(self, angle_keys, rate_keys):
        """Make the graph of these keys of a pendulum; panel.css sets its size, panel.js its colors and limits."""
        self.angle_keys, self.rate_keys = angle_keys, rate_keys
        self.names: list[str] = []  # of the numbers in a row
        self.rows: deque[array] = deque(maxlen=round(LONGEST_SPAN / EVERY))
        self.graph = graph()
        self.curves = {name: gcurve(graph=self.graph, color=hue, label=name) for name, hue in ENERGIES.items()}
        self.curves[PHASE] = gcurve(graph=self.graph, label=PHASE)
        self.choice, self.span = ENERGY, next(iter(SPANS))
        self.begin([])

    def begin(self, colors) -> None:
        """Forget all samples, and take the colors of a new cradle's pendula: each pendulum's curves have its color."""
        self.rows.clear()
        self.colors = colors[:MOST_DRAWN]
        for number, hue in enumerate(self.colors, start=1):
            if str(number) not in self.curves:  # VPython keeps every curve for ever
                self.curves[str(number)] = gcurve(graph=self.graph, label=str(number))
            self.curves[str(number)].color = hue
        numbers = range(1, len(self.colors) + 1)
        self.choices = {ENERGY: Choice("t (s)", "%", {name: ("t", name) for name in ENERGIES})}
        for title, unit, keys in (("Angles", "rad", self.angle_keys), ("Velocities", "rad/s", self.rate_keys)):
            for key in keys:
                columns = {str(number): ("t", f"{key}_{number}") for number in numbers}
                self.choices[f"{title} {key}"] = Choice("t (s)", f"{key} ({unit})", columns)
        for number in numbers:
            for angle, rate in zip(self.angle_keys, self.rate_keys, strict=True):
                columns = {PHASE: (f"{angle}_{number}", f"{rate}_{number}")}
                name = f"Phase {number}" if len(self.angle_keys) == 1 else f"Phase {number}, {angle}"
                self.choices[name] = Choice(f"{angle} (rad)", f"{rate} (rad/s)", columns)
        self.choices[NOTHING] = Choice("", "", {})
        self.show(self.choice)

    def add(self, sample) -> None:
        """Add a sample; all samples of a cradle have the same names."""
        self.names = list(sample)
        self.rows.append(array("d", sample.values()))  # a twentieth of the memory that dictionaries take

    def show(self, choice) -> None:
        """Show this one of the choices, or the energies if the present cradle does not have it."""
        self.choice = choice if choice in self.choices else ENERGY
        columns = self.choices[self.choice].columns
        for name, curve in self.curves.items():
            if curve.data and name not in columns:
                curve.data = []
        if PHASE in columns:
            self.curves[PHASE].color = self.colors[int(columns[PHASE][0].split("_")[-1]) - 1]

    def draw(self, start_energy) -> None:
        """Send the points to the page, and move the time axis to the last seconds; start_energy (J) is 100 %."""
        drawn = self.choices[self.choice].columns
        if not drawn or not self.rows:
            return
        seconds, interval = PHASE_SPAN if PHASE in drawn else SPANS[self.span]
        rows = last_rows(self.rows, seconds, interval)
        # VPython never removes points that are plotted one by one. A new list of points replaces the old one.
        for name, columns in drawn.items():
            x, y = map(self.names.index, columns)
            unit = (start_energy or 1) / 100 if name in ENERGIES else 1
            self.curves[name].data = [[row[x], row[y] / unit] for row in rows]
        self.graph.xmax = max(seconds, rows[-1][0])
        self.graph.xmin = self.graph.xmax - seconds


def last_rows(rows, seconds, interval) -> list:
    """Return the rows of the last seconds, about one for each interval (s). It keeps a row as long as it is drawn."""
    step = round(interval / EVERY)
    first = round(rows[-1][0] / EVERY) % step  # the newest row whose time is a multiple of the interval
    newest_first = list(islice(reversed(rows), first, round(seconds / EVERY), step)) or [rows[-1]]
    return newest_first[::-1]
