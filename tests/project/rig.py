"""A viewer on the stand-in, with a clock that a test moves, and the state as a tab has it."""

import json
from math import pi
from threading import Event
from types import SimpleNamespace

from vpython import vector
from whole_cradles import go_on, make_live, thetas

from support.cradle.cradle import Cradle
from support.cradle.real_time import FRAME, RealTime
from support.files.cradle_csv import LiveFile, POLL
from support.page.viewer import Viewer


class Rig:
    """The clock, the viewer that uses it, and its only tab, which has drawn a picture and
    always has room.
    """

    def __init__(self, csv, *angles, kind=Cradle, lifted: int | None = 1, **texts):
        self.now, self.file, self.state = 100.0, csv, {}
        self.tabs = SimpleNamespace(
            have_room=lambda: True, show=self.take, is_seen=Event(), are_gone=False
        )
        self.tabs.is_seen.set()
        file = LiveFile(csv, self.clock)
        self.viewer = Viewer(
            make_live(kind), file, thetas(angles or [30]), lifted, self.tabs, **texts
        )
        self.viewer.pace = RealTime(self.viewer.cradle.dt, self.clock, sleep=lambda seconds: None)
        self.viewer.want_cradle()
        go_on(self.viewer)
        self.wait()

    def clock(self):
        return self.now

    def take(self, state):
        """Take a part of the state, or all, as JSON has it, which a browser reads without nan."""
        self.state |= json.loads(json.dumps(state, allow_nan=False))

    def wait(self, seconds=0.0):
        """Let this time (s) pass, frame by frame; the state is then that of this moment."""
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
        return float(self.state["motion"]["t"].split()[0])

    def give(self, command, *values):
        """Give a command as a tab does, and wait until it is carried out."""
        self.tabs.give(command, *values)
        self.wait()

    def save(self, text):
        """Save this text as the CSV, and wait until it is noticed."""
        self.file.write_text(text)
        self.wait(3 * POLL)

    def mouse(self, command, point, direction=(0, 0, -1)):
        """Give a command with the ray through this point in this direction."""
        self.give(command, (point - 0.5 * vector(*direction)).value, [*direction])
