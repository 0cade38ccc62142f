"""The graph: energies, angles or velocities over the last ten seconds, or the phase picture of a pendulum."""

from itertools import islice

from vpython import color, gcurve, graph, vector

from support.files.data_file import EVERY

SHOWN = 10.0  # s on the axis
INTERVAL = 0.03  # s from point to point
PHASE_SHOWN = 3.0  # s of the phase picture
MOST = 20  # pendula in the graph: more curves could not be told apart

# Three colors of Okabe and Ito's palette, which look different to color-blind people, too.
ENERGIES = {"kinetic": vector(213, 94, 0) / 255, "potential": vector(0, 114, 178) / 255, "total": color.black}
ENERGY, NOTHING = "Energies (J)", "no graph"  # panel.css knows the second one, too
PHASE = "phase"  # the label of its curve; panel.js knows it


class MotionGraph:
    """Draws the rows of a Recording: a choice of curves. While hidden, it sends no points."""

    def __init__(self, recording, angle_keys, rate_keys):
        """Make the graph, without points; panel.css sets its size, and panel.js its colors and its axes' limits.

        angle_keys and rate_keys are the keys of the pendula's angles (rad) and of their rates (rad/s).
        """
        self.recording, self.angle_keys, self.rate_keys = recording, angle_keys, rate_keys
        self.graph = graph(xmin=0, xmax=SHOWN)
        self.curves = {name: gcurve(graph=self.graph, color=hue, label=name) for name, hue in ENERGIES.items()}
        self.curves[PHASE] = gcurve(graph=self.graph, label=PHASE)
        self.choice = ENERGY
        self.take([])

    def take(self, colors) -> None:
        """Take the colors of a new cradle's pendula: each pendulum's curves have its color."""
        self.colors = colors[:MOST]
        for number, hue in enumerate(self.colors, start=1):
            if str(number) not in self.curves:  # VPython keeps every curve for ever
                self.curves[str(number)] = gcurve(graph=self.graph, label=str(number))
            self.curves[str(number)].color = hue
        # What each choice of the menu draws: a column for each curve, over the time or over another column.
        numbers = range(1, len(self.colors) + 1)
        self.choices: dict[str, dict[str, tuple[str, str]]] = {ENERGY: {name: ("t", name) for name in ENERGIES}}
        for title, unit, keys in (("Angles", "rad", self.angle_keys), ("Velocities", "rad/s", self.rate_keys)):
            for key in keys:
                self.choices[f"{title} {key} ({unit})"] = {str(number): ("t", f"{key}_{number}") for number in numbers}
        for number in numbers:
            for angle, rate in zip(self.angle_keys, self.rate_keys, strict=True):
                columns = {PHASE: (f"{angle}_{number}", f"{rate}_{number}")}
                self.choices[f"Phase picture of bob {number}: {rate} over {angle}"] = columns
        self.choices[NOTHING] = {}
        self.show(self.choice)

    def show(self, choice) -> None:
        """Show this one of the choices, or the energies if the present cradle does not have it."""
        self.choice = choice if choice in self.choices else ENERGY
        for name, curve in self.curves.items():
            if curve.data and name not in self.choices[self.choice]:
                curve.data = []
        for number, hue in enumerate(self.colors, start=1):
            if self.choice.startswith(f"Phase picture of bob {number}:"):
                self.curves[PHASE].color = hue

    def draw(self) -> None:
        """Send the points to the page, and move the time axis to the last ten seconds."""
        drawn, recording = self.choices[self.choice], self.recording
        if not drawn or not recording.rows:
            return
        rows = last_rows(recording.rows, *((PHASE_SHOWN, EVERY) if PHASE in drawn else (SHOWN, INTERVAL)))
        # VPython never removes points that are plotted one by one. A new list of points replaces the old one.
        for name, columns in drawn.items():
            x, y = map(recording.columns.index, columns)
            self.curves[name].data = [[row[x], row[y]] for row in rows]
        self.graph.xmax = max(SHOWN, rows[-1][0])
        self.graph.xmin = self.graph.xmax - SHOWN


def last_rows(rows, seconds, interval) -> list:
    """Return the rows of the last seconds, about one for each interval (s); always the same ones, so nothing shakes."""
    step = round(interval / EVERY)
    first = round(rows[-1][0] / EVERY) % step  # the newest row whose time is a multiple of the interval
    newest_first = list(islice(reversed(rows), first, round(seconds / EVERY), step)) or [rows[-1]]
    return newest_first[::-1]
