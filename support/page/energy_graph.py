"""The graph of the energies over the last ten seconds."""

from collections import deque

from vpython import gcurve, graph, vector, wtext

SHOWN = 10.0  # s on the axis
INTERVAL = 0.03  # s from point to point

# Three colors of Okabe and Ito's palette, which color-blind people can tell apart, too.
CURVES = {"kinetic": vector(213, 94, 0) / 255, "potential": vector(0, 114, 178) / 255, "total": vector(0, 0, 0)}

HIDING = "<style>.glowscript-graph { display: none }</style>"


class EnergyGraph:
    """Kinetic, potential and total energy (J) over simulated time (s). While hidden, it takes and sends no points."""

    def __init__(self):
        """Make the graph, without points; panel.css sets its size, and panel.js its colors."""
        self.graph = graph(xmin=0, xmax=SHOWN, ymin=0)
        self.curves = [gcurve(graph=self.graph, color=color, label=name) for name, color in CURVES.items()]
        self.style = wtext()
        self.shown = True
        self.clear()

    def show(self, shown) -> None:
        """Show or hide the graph, and remove its points."""
        self.shown = shown
        self.style.text = "" if shown else HIDING
        self.clear()

    def clear(self) -> None:
        """Remove all points."""
        self.points: deque[tuple] = deque()

    def add(self, time, kinetic, potential) -> None:
        """Add a point at time (s), with energies in J, unless the last one is less than INTERVAL older."""
        if self.shown and not (self.points and time - self.points[-1][0] < 0.99 * INTERVAL):
            self.points.append((time, kinetic, potential, kinetic + potential))
            while self.points[0][0] < time - SHOWN:
                self.points.popleft()

    def draw(self) -> None:
        """Send the points to the page, and move the time axis to the last ten seconds."""
        # VPython never removes points that are plotted one by one. A new list of points replaces the old one.
        if self.shown and self.points:
            for number, curve in enumerate(self.curves, start=1):
                curve.data = [[point[0], point[number]] for point in self.points]
            self.graph.xmax = max(SHOWN, self.points[-1][0])
            self.graph.xmin = self.graph.xmax - SHOWN
