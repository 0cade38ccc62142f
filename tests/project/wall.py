"""A viewer on the stand-in, with a wall clock that a test moves."""

import re
from math import pi
from types import SimpleNamespace

from vpython import scene, vector
from whole_cradles import go_on, make_live, thetas

from support.cradle.cradle import Cradle
from support.cradle.real_time import FRAME, RealTime
from support.files.cradle_csv import LiveFile, POLL
from support.page.viewer import Viewer


class Wall:
    """The wall clock, and the viewer that uses it."""

    def __init__(self, csv, *angles, kind=Cradle, remark="", lifted: int | None = 1):
        self.now = 100.0
        self.file = csv
        self.viewer = Viewer(make_live(kind), LiveFile(csv, self.clock), thetas(angles or [30]), lifted, remark)
        self.viewer.pace = RealTime(self.viewer.cradle.dt, self.clock, sleep=lambda seconds: None)
        self.panel = self.viewer.panel
        self.viewer.want_cradle()
        go_on(self.viewer)

    def clock(self):
        return self.now

    def wait(self, seconds=0.0):
        """Let this time (s) pass, frame by frame."""
        for _ in range(max(1, round(seconds / FRAME))):
            self.now += seconds and FRAME
            self.do_frame()
            while not self.viewer.commands.empty():
                self.do_frame()
            self.viewer.next_refresh = 0
            self.viewer.show_frame()

    def do_frame(self):
        """Do a frame, and all that it asks of the loop."""
        self.viewer.frame()
        go_on(self.viewer)

    def values(self, key):
        """Return pend[key] of each pendulum."""
        return self.viewer.cradle.values(key)

    def thetas(self):
        return self.values("theta")

    def lifts(self):
        """Return the angles of the bobs, in whole degrees."""
        return [round(abs(theta) * 180 / pi) for theta in self.thetas()]

    def time(self):
        return float(self.readout()["t"].split()[0])

    def readout(self):
        """Return the texts of the readout, by their names."""
        rows = re.findall(r'<th scope="row">(\w+)</th><td>(.*?)</td>', self.panel.readout.text)
        return {name: text.strip() for name, text in rows}

    def press(self, key, **modifiers):
        scene.bound["keydown"](SimpleNamespace(**{"key": key, "ctrl": False, "alt": False, **modifiers}))
        self.wait()

    def click(self, button):
        button.bind()
        self.wait()

    def use(self, widget, **values):
        """Use a menu, checkbox or slider as a person does: VPython sets its values, and calls the bound function."""
        for name, value in values.items():
            setattr(widget, name, value)
        widget.bind(widget)
        self.wait()

    def give(self, command, value=None):
        """Give a command as the page's script does."""
        self.viewer.give(command, value)
        self.wait()

    def save(self, text):
        """Save this text as the CSV, and wait until it is noticed."""
        self.file.write_text(text)
        self.wait(3 * POLL)

    def mouse(self, kind, point, ray=(0, 0, -1)):
        """Move the mouse to this point, seen in the direction of the ray, and send this event."""
        scene.mouse.ray = vector(*ray)
        function = scene.bound[kind]
        function() if kind == "mouseup" else function(SimpleNamespace(pos=point - 0.5 * scene.mouse.ray))
        self.wait()
