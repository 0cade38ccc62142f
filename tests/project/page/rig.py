"""A viewer on the stand-in, with a clock that a test moves, and the state as a tab has it."""

import json
from math import degrees
from queue import SimpleQueue
from threading import Event
from types import SimpleNamespace

from vpython import vector
from whole_cradles import checked, go_on, thetas

from support.cradle.cradle import Cradle
from support.cradle.real_time import FRAME, RealTime
from support.files.cradle_csv import LiveFile, POLL
from support.headless_vpython import ForShow, Shape
from support.page.ghost_file import GhostFile
from support.page.viewer import FirstCradle, Viewer

Shape.idx = ForShow.idx = property(id)  # VPython numbers its objects


class Rig:
    """The clock, the viewer that uses it, and its only tab, which has drawn a picture."""

    def __init__(self, csv, *angles, kind=Cradle, lifted: int | None = 1):
        self.now = 100.0
        self.file = csv
        self.state = {}
        self.tabs = SimpleNamespace(
            show=self.take,
            tell=self.take,
            begin_film=lambda: None,
            commands=SimpleQueue(),
            is_seen=Event(),
            are_gone=False,
        )
        self.tabs.is_seen.set()
        self.viewer = Viewer(
            kind(),
            FirstCradle(
                checked(csv),
                LiveFile(csv, self.clock),
                lambda csv: csv,
                thetas(angles or [30]),
                lifted,
                GhostFile(),
            ),
            self.tabs,
            RealTime(kind.dt, self.clock, sleep=lambda seconds: None),
        )
        self.cradle = self.viewer.cradle
        self.begin()

    def begin(self):
        """Let the program make the cradle, as at the start."""
        self.viewer.next_cradle.want()
        go_on(self.viewer)
        self.wait()

    def clock(self):
        return self.now

    def take(self, state):
        """Take a part of the state, or all, as JSON has it, which a browser reads without nan.

        And the value of each control by its name.
        """
        self.state |= json.loads(json.dumps(state, allow_nan=False))
        for name, control in self.state.get("controls", {}).items():
            self.state[name] = control["value"]

    def wait(self, seconds=0.0):
        """Let this time (s) pass, frame by frame; the state is then that of this moment."""
        for _ in range(max(1, round(seconds / FRAME))):
            if seconds:
                self.now += FRAME
            self.do_frame()
            while not self.tabs.commands.empty():
                self.do_frame()
        self.viewer.next_refresh = 0
        self.viewer.show_frame()

    def do_frame(self):
        """Do a frame, and all that it asks of the loop."""
        self.viewer.frame()
        go_on(self.viewer)

    # --- what the cradle is, and what the page shows -----------------------------------------

    def values(self, key):
        """Return pend[key] of each pendulum."""
        return self.cradle.values(key)

    def bob_angles(self):
        """Return by how many degrees the bobs are raised, as whole numbers."""
        return [round(abs(degrees(theta))) for theta in self.values("theta")]

    def time(self):
        return float(self.state["motion"]["t"].split()[0])

    def marks(self, name):
        """Return the marks with this name that are shown."""
        return [shape for shape in self.viewer.marks.shapes.get(name, []) if shape.visible]

    def control(self, name):
        """Return what the page knows of a control, without its value."""
        return self.state["controls"][name]

    # --- what a user does --------------------------------------------------------------------

    def give(self, command, *values):
        """Give a command as a tab does, and wait until it is carried out."""
        self.tell(command, *values)
        self.wait()

    def tell(self, command, *values):
        """Give a command, or set a control, as a tab does; the next frame carries it out."""
        if command in [*self.state.get("controls", {})]:
            values = (command, *values)
            command = "set"
        self.tabs.commands.put([command, *values])

    def mouse(self, command, point, direction=(0, 0, -1)):
        """Give a command with the ray through this point in this direction."""
        self.give(command, (point - 0.5 * vector(*direction)).value, [*direction])

    def save(self, text):
        """Save this text as the CSV, and wait until it is noticed."""
        self.file.write_text(text)
        self.wait(3 * POLL)
