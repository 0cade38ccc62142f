"""A viewer on the stand-in, with a wall clock that a test moves."""

import re
from math import pi
from types import SimpleNamespace

from vpython import scene, vector
from whole_cradles import go_on, make_live, thetas

from src.beyond.live_cradle import LiveCradle
from support.files.live_file import LiveFile
from support.page.viewer import Viewer
from support.playback.real_time import FRAME, RealTime


class Wall:
    """The wall clock, and the viewer that uses it."""

    def __init__(self, csv, *angles, kind=LiveCradle, remark="", lifted: int | None = 1, experiment=None):
        self.now = 100.0
        self.file = csv
        live_file = LiveFile(csv, self.clock)
        self.viewer = Viewer(
            make_live(kind), live_file, thetas(angles or [30]), lifted, remark, {"experiment": experiment}
        )
        self.viewer.pace = RealTime(self.viewer.cradle.dt, self.clock, sleep=None)
        self.panel = self.viewer.panel
        self.viewer.at_once = True  # single ticks give the same result, but take longer
        go_on(self.viewer, self.viewer.open())

    def clock(self):
        return self.now

    def wait(self, seconds=0.0):
        """Let this time (s) pass, frame by frame."""
        for _ in range(max(1, round(seconds / FRAME))):
            self.now += seconds and FRAME
            self.viewer.next_refresh = 0
            go_on(self.viewer, self.viewer.frame())

    def thetas(self):
        return [pend["theta"] for pend in self.viewer.cradle.pend_list]

    def lifts(self):
        """Return the angles of the bobs, in whole degrees."""
        return [round(abs(theta) * 180 / pi) for theta in self.thetas()]

    def time(self):
        return float(self.readout()["t"].split()[0])

    def readout(self):
        """Return the texts of the readout, by their names, as they are while the mouse is elsewhere."""
        rows = re.findall(r'<th scope="row">(\w+)</th><td>(.*?)</td>', self.panel.readout.text)
        return {name: re.sub('<span class="exact">.*?</span>|<.*?>', "", text).strip() for name, text in rows}

    def percents(self):
        """Return the energies of the readout."""
        readout = self.readout()
        return [readout[name] for name in ("energy", "kinetic", "potential")]

    def press(self, key, **modifiers):
        scene.bound["keydown"](SimpleNamespace(**{"key": key, "ctrl": False, "alt": False, **modifiers}))
        self.wait()

    def mouse(self, kind, point):
        """Move the mouse to this point, seen straight from the front, and send this event."""
        scene.mouse.ray = vector(0, 0, -1)
        event = SimpleNamespace(pos=point + vector(0, 0, 0.5))
        function = scene.bound[kind]
        function() if kind == "mouseup" else function(event)
        self.wait()


def set_slider(setting, value):
    """Move a slider as a person does: VPython sets its value, and calls the bound function."""
    setting.slider.value = value
    setting.slider.bind(setting.slider)
