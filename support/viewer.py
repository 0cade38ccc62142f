"""The viewer: shows a cradle in step with the clock, and does with it what the person in front of the page asks for."""

import time
from collections.abc import Sequence
from math import inf
from queue import SimpleQueue
from typing import Any, Protocol

from vpython import baseObj, cross, dot, mag, scene

from support.commands import Command, KEYS
from support.energy_graph import EnergyGraph, INTERVAL
from support.impacts import ImpactTrains
from support.panel import IMPACTS, Panel
from support.real_time import FRAME, RealTime
from support.scenery import CANVAS_WIDTH, Scenery

REFRESH = 0.1  # s between two changes of the numbers and the graph


class Cradle(Protocol):
    """What the viewer is told about a cradle and asks of it. What is inside a pendulum is none of its business."""

    dt: float  # one tick (s)
    reach: float  # how far below its axle a pendulum hangs (m)
    angles: Sequence[str]  # the names of its release angles
    collisions: dict[str, Any]  # the names of the ways in which it can collide are the keys
    collision: str  # the present one of them
    held: int | None  # which of its bobs is held

    def load(self, csv) -> None:
        """Build the cradle anew from a Snapshot, or raise a ValueError and stay as it was."""

    def release(self, angles, lifted) -> None:
        """Lift the first pendula to these angles (degrees), let the others hang, all at rest."""

    def collide(self, collision) -> None:
        """Collide from now on in this way, one of collisions."""

    def advance(self, ticks, approaching_only) -> list[tuple[int, int]]:
        """Move on by so many ticks; return the contacts as (tick, index of the left pendulum)."""

    def axles(self) -> list:
        """Return the axles, from left to right."""

    def bobs(self) -> list:
        """Return all bobs that can be dragged."""

    def hold(self, bob) -> None:
        """Hold this bob, an index into bobs, where it is."""

    def drag(self, bob, x, y) -> None:
        """Drag this bob, which is held, as near as it can come to x, y (m) in the plane of swing."""

    def let_go(self) -> None:
        """Let go of the bob that is held, if there is one."""

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""

    def velocities(self) -> list[float]:
        """Return the velocities of the pendula's bobs to the right (m/s)."""

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""


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
        self.trains = ImpactTrains(IMPACTS)
        self.next_refresh = -inf

        self.scenery = Scenery()
        self.panel = Panel(self.give, cradle)
        self.graph = EnergyGraph(CANVAS_WIDTH - 26)  # its borders, in panel.html
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
            self.set_start()
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
                self.set_start()
            case Command.RESIZE:
                self.scenery.point_camera()
        self.show_settings()

    def restart(self) -> None:
        """Lift the bobs as it is set, and let them go anew."""
        self.cradle.let_go()
        self.cradle.release(self.angles, self.lifted)
        self.scenery.come_closer()
        self.ticks = 0
        self.trains.clear()
        self.set_start()
        self.graph.clear()
        self.graph.add(0.0, *self.cradle.energies())

    def set_start(self) -> None:
        """Take the energy of this moment as that of the start, which is 100 %."""
        self.start_energy = sum(self.cradle.energies())

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

    def elapsed(self) -> float:
        """Return the simulated time since the bobs were let go (s)."""
        return self.ticks * self.cradle.dt

    def advance(self, ticks) -> None:
        """Move the cradle on by so many ticks, in parts that are short enough for the graph to be smooth."""
        longest = round(INTERVAL / self.cradle.dt)
        while ticks > 0:
            part, velocities = min(ticks, longest), self.cradle.velocities()
            for tick, left in self.cradle.advance(part, not self.separating):
                rightwards = velocities[left] + velocities[left + 1] > 0
                self.trains.add(self.elapsed() + (tick + 1) * self.cradle.dt, left, rightwards)
            self.ticks += part
            ticks -= part
            self.graph.add(self.elapsed(), *self.cradle.energies())

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
        kinetic, potential = self.cradle.energies()
        momentum, kept_up = self.cradle.momentum(), self.pace.kept_up
        self.panel.show_motion(self.elapsed(), kinetic, potential, self.start_energy, momentum, kept_up)
        self.panel.show_impacts(self.trains.lines())
        self.graph.draw()
