"""The viewer: shows a cradle in step with the clock, and does with it what the person in front of the page asks for."""

import time
from math import inf
from pathlib import Path
from queue import SimpleQueue

from vpython import baseObj, cross, dot, mag, scene

from support.commands import Command, KEYS
from support.cradle import Cradle
from support.energy_graph import EnergyGraph
from support.motion import Motion
from support.panel import IMPACTS, Panel
from support.real_time import FRAME, RealTime
from support.recording import EVERY, Recording
from support.scenery import CANVAS_WIDTH, Scenery

REFRESH = 0.1  # s between two changes of the numbers and the graph


class Viewer:
    """The page with a cradle, its panel and its graph, and the loop that keeps them going."""

    def __init__(self, cradle: Cradle, file, angles, lifted):
        """Show the cradle of this file (a LiveFile) with the first lifted pendula at these angles (degrees).

        Raises the ValueError of cradle.load. Returns when the page has all this, so that the release will be seen.
        """
        self.cradle, self.file = cradle, file
        self.commands: SimpleQueue = SimpleQueue()
        self.pace = RealTime(cradle.dt)
        self.running, self.separating = True, False
        self.angles, self.lifted = list(angles), lifted
        self.recording = Recording()
        self.next_refresh = -inf

        self.scenery = Scenery()
        self.panel = Panel(self.give, cradle)
        self.graph = EnergyGraph(CANVAS_WIDTH - 26)  # its borders, in panel.html
        self.motion = Motion(cradle, IMPACTS)
        self.load()
        self.listen()
        while not baseObj.empty():  # what the page has not fetched yet
            time.sleep(FRAME)

    def run(self) -> None:
        """Keep the cradle going for ever."""
        self.pace.restart()
        while True:
            self.frame()
            self.pace.rest()

    def frame(self) -> None:
        """Do what is to be done for one picture."""
        while not self.commands.empty():
            command, value = self.commands.get()
            self.carry_out(command, value)
        if self.file.changed():
            self.reload()
        if self.running:
            self.pace.frame(self.advance)
        else:
            self.pace.restart()
        if self.cradle.held is not None:
            self.motion.set_start()
        self.scenery.keep_in_view(self.cradle.bobs())
        self.show_motion()

    # --- commands ----------------------------------------------------------------------------------------------------

    def give(self, command, value=None) -> None:
        """Put a command into the queue, for the next frame; may be called from any thread."""
        self.commands.put((command, value))

    def listen(self) -> None:
        """Turn the keys and the mouse into commands."""

        def press(event):
            if event.key in KEYS and not (event.ctrl or event.alt):
                self.give(*KEYS[event.key])

        def ray(event):  # to where the mouse points: a place on it, and its direction
            return event.pos, scene.mouse.ray

        scene.bind("keydown", press)
        scene.bind("mousedown", lambda event: self.give(Command.GRAB, ray(event)))
        scene.bind("mousemove", lambda event: self.give(Command.DRAG, ray(event)))
        scene.bind("mouseup", lambda: self.give(Command.LET_GO))
        scene.bind("resize", lambda: self.give(Command.RESIZE))

    def carry_out(self, command, value) -> None:
        """Do what a command says."""
        match command:
            case Command.PAUSE:
                self.running = not self.running
            case Command.STEP if not self.running:
                self.advance(round(FRAME * self.pace.speed / self.cradle.dt))
            case Command.RESTART:
                self.restart()
            case Command.SPEED:
                self.pace.speed = value
            case Command.ANGLE:
                number, angle = value
                self.angles[number] = angle
                self.restart()
            case Command.LIFT:
                self.lifted = value
                self.restart()
            case Command.COLLISIONS:
                self.cradle.collide(value)
            case Command.SEPARATING:
                self.separating = value
            case Command.GRAPH:
                self.graph.show(value)
            case Command.GRAB:
                self.grab(*value)
            case Command.DRAG if self.cradle.held is not None:
                self.drag(*value)
            case Command.LET_GO if self.cradle.held is not None:
                self.cradle.let_go()
                self.motion.set_start()
            case Command.SAVE:
                self.save()
            case Command.RESIZE:
                self.scenery.point_camera()
        self.show_settings()

    def restart(self) -> None:
        """Lift the bobs as it is set, and let them go anew."""
        self.cradle.let_go()
        self.cradle.release(self.angles, self.lifted)
        self.scenery.come_closer()
        self.motion.restart()
        self.recording.clear()
        self.graph.clear()
        self.note()

    def save(self) -> None:
        """Write what has happened since the last restart to a file in the folder where the program was started."""
        try:
            path = self.recording.save(Path.cwd())
            self.panel.show_saved(f"{len(self.recording.rows)} rows are in {path}")
        except OSError as error:
            self.panel.show_saved(f"{error.filename or 'The present folder'}: {error.strerror}", failed=True)
        self.pace.restart()  # what this took (ten minutes of a hundred pendula: ten seconds) is not made up for

    # --- the mouse ---------------------------------------------------------------------------------------------------

    def grab(self, place, direction) -> None:
        """Hold the bob to which this ray points, the foremost if there are several, if there is one."""
        hits = [
            (dot(bob.pos - place, direction), number)
            for number, bob in enumerate(self.cradle.bobs())
            if mag(cross(bob.pos - place, direction)) <= bob.radius * mag(direction)
        ]
        if hits:
            self.cradle.hold(min(hits)[1])

    def drag(self, place, direction) -> None:
        """Drag the bob that is held to where this ray meets the plane of swing, z = 0."""
        if abs(direction.z) > 0.01 * mag(direction):  # seen from the side, the plane is a line
            point = place - direction * (place.z / direction.z)
            self.cradle.drag(self.cradle.held, point.x, point.y)

    # --- time, and the file ------------------------------------------------------------------------------------------

    def advance(self, ticks) -> None:
        """Move the cradle on by so many ticks, from sample to sample."""
        step = max(1, round(EVERY / self.cradle.dt))
        for part in self.motion.parts(ticks, step):
            self.motion.advance(part, not self.separating)
            if self.motion.ticks % step == 0:
                self.note()

    def note(self) -> None:
        """Add this moment to the recording and to the graph."""
        sample = self.motion.sample()
        self.recording.add(sample)
        self.graph.add(sample["t"], sample["kinetic"], sample["potential"])

    def load(self) -> None:
        """Build the cradle of the file as it is now, and let it go."""
        self.cradle.load(self.file.current)
        self.scenery.surround(self.cradle.axles(), self.cradle.bobs(), self.cradle.reach)
        self.restart()
        self.show_settings()

    def reload(self) -> None:
        """Build the cradle anew, or say why the file makes none; the old one then swings on."""
        try:
            self.load()
        except ValueError as error:
            self.panel.show_error(str(error))
        else:
            self.panel.show_error("")

    # --- what is to be read ------------------------------------------------------------------------------------------

    def show_settings(self) -> None:
        """Show what is set."""
        count = len(self.cradle.axles())
        self.panel.show_settings(self.running, self.pace.speed, self.angles, min(self.lifted, count), count)

    def show_motion(self) -> None:
        """Show time, energy, momentum, impacts and graph, ten times a second."""
        if self.pace.clock() < self.next_refresh:
            return
        self.next_refresh = self.pace.clock() + REFRESH
        self.panel.show_motion(self.motion.reading(), self.cradle.momentum(), self.pace.remark())
        self.panel.show_impacts(self.motion.trains.lines())
        self.graph.draw()
