"""The viewer: plays a cradle in step with the clock, and carries out your commands on the page."""

import time
from math import inf
from pathlib import Path
from queue import SimpleQueue
from threading import Thread

from vpython import baseObj, scene

from support.files.recording import EVERY, Recording
from support.page.commands import Command, KEYS
from support.page.motion_graph import MotionGraph
from support.page.mouse import bob_at, point_in_plane
from support.page.panel import Panel, TRAINS
from support.page.scenery import Scenery
from support.page.workbench import OF_BENCH, Workbench
from support.playback.cradle import Cradle
from support.playback.real_time import FRAME
from support.start.command_line import same_program
from support.start.options import ANGLES, page_arguments

REFRESH = 0.1  # s between two changes of the numbers and the graph
QUIET = 0.01  # m/s: a hit makes no sound up to this speed; bobs that rest on each other meet again in each tick
GOODBYE = 10.0  # s that the page has to fetch the last message


class Viewer(Workbench):
    """The page with a cradle, its panel and its graph: the argument page of main."""

    def __init__(self, cradle: Cradle, file, angles, lifted, remark="", options=None):
        """Build the page for the cradle of this file (a LiveFile), with the remark, if there is one.

        angles (rad) are the release angles, lifted is the number of bobs to lift. None keeps the value with which main
        makes the cradle. options are those of the command line, as a dictionary.
        """
        super().__init__(cradle, file, angles, lifted, TRAINS)
        self.options = options or {}
        self.separating = self.options.get("separating", False)
        self.commands: SimpleQueue = SimpleQueue()
        self.running = True
        self.step = max(1, round(EVERY / cradle.dt))
        self.recording = Recording()
        self.next_refresh = -inf
        self.swung_through = False  # whether a bob has swung through others since the last restart
        self.sound = False
        self.saving: Thread | None = None  # the thread that writes data to a file
        self.saved = "", False  # the message of the last one, and whether it failed

        self.scenery = Scenery()
        self.panel = Panel(self.give, cradle, self.questions, self.table, remark)
        self.panel.separating.checked = self.separating
        if self.options.get("experiment") is not None:
            self.begin_with(self.options["experiment"])
        self.graph = MotionGraph(self.recording, cradle.angle_keys, cradle.rate_keys)
        self.listen()

    def script(self):
        """Show the cradle, and play it for ever."""
        yield from self.open()
        while True:
            yield from self.frame()
            self.pace.rest()

    def open(self):
        """Show the cradle; start it when the page has it, so that you see the release."""
        yield from self.make()
        self.wait_for_page()
        self.pace.restart()

    def wait_for_page(self, patience=inf) -> None:
        """Wait until the page has fetched all changes, but at most patience (s)."""
        begin = time.monotonic()
        while not baseObj.empty() and time.monotonic() - begin < patience:
            time.sleep(FRAME)

    def frame(self):
        """Do the work of one frame."""
        while not self.commands.empty():
            yield from self.carry_out(*self.commands.get())
        if self.file.changed():
            yield from self.reload()
        if self.running:
            yield from self.keep_time()
        else:
            self.pace.restart()
        if self.cradle.held is not None:
            self.motion.set_start()
        self.scenery.keep_in_view(self.cradle.bobs())
        self.scenery.limit_view()
        fastest = self.motion.take_fastest()
        if self.sound and fastest > QUIET:
            self.panel.click(fastest)
        self.show_motion()

    def end(self, words) -> None:
        """Show on the page that the program has ended, and why; wait a moment until the page has the message.

        If data are being saved, complete their file.
        """
        self.panel.show_end(words)
        self.wait_for_page(GOODBYE)
        if self.saving:
            self.saving.join()
        # The page fetches this after it has shown the message.
        self.panel.show_saved(*self.saved if self.saving else ("",))
        self.wait_for_page(GOODBYE)

    # --- commands ----------------------------------------------------------------------------------------------------

    def give(self, command, value=None) -> None:
        """Put a command into the queue, for the next frame; any thread can call this."""
        self.commands.put((command, value))

    def listen(self) -> None:
        """Turn the keys and the mouse into commands."""

        def press(event):
            if event.key in KEYS and not (event.ctrl or event.alt):
                self.give(*KEYS[event.key])

        def ray(event):  # of the mouse: a point on it, and its direction
            return event.pos, scene.mouse.ray

        scene.bind("keydown", press)
        scene.bind("mousedown", lambda event: self.give(Command.GRAB, ray(event)))
        scene.bind("mousemove", lambda event: self.give(Command.DRAG, ray(event)))
        scene.bind("mouseup", lambda: self.give(Command.LET_GO))
        scene.bind("resize", lambda: self.give(Command.RESIZE))

    def carry_out(self, command, value):
        """Carry out a command."""
        match command:
            case Command.PAUSE:
                self.running = not self.running
                self.questions.skip()
            case Command.ANSWER:
                self.running = self.questions.answer(*value) or self.running
            case Command.STEP if not self.running:
                self.questions.skip()
                yield from self.advance(round(FRAME * self.pace.speed / self.cradle.dt))
            case Command.TICK if not self.running:
                self.questions.skip()
                yield from self.show_one_tick()
            case Command.RESTART:
                yield from self.make()
            case _ if command in OF_BENCH:
                yield from self.work(command, value)
            case Command.GRAB | Command.DRAG | Command.LET_GO:
                self.follow_mouse(command, value)
            case Command.SHOW_AGAIN:
                self.panel.send_again()
                self.table.open(False)
                self.scenery.reset_view()
                yield from self.open()
            case _:
                self.set(command, value)
        self.show_settings()

    def set(self, command, value) -> None:
        """Carry out a command that neither makes nor moves pendula."""
        match command:
            case Command.SPEED:
                self.pace.speed = value
                self.try_single_ticks()
            case Command.SEPARATING:
                self.leave_experiment()
                self.separating = value
            case Command.SOUND:
                self.sound = value
            case Command.GRAPH:
                self.graph.show(value)
            case Command.SAVE:
                self.save()
            case Command.SAVED:
                self.saving = None
                self.panel.show_saved(*self.saved)
            case Command.RESIZE:
                self.scenery.point_camera()
            case Command.VIEW:
                self.scenery.reset_view()

    def make(self):
        """Let main make a new cradle, lift it as set or as the experiment says, and release it."""
        yield from super().make()
        self.pose()
        self.scenery.surround(self.cradle.axles(), self.cradle.bobs(), self.cradle.reach, self.cradle.masses())
        self.scenery.come_closer()
        self.recording.clear()
        self.graph.take(self.cradle.colors())
        self.swung_through = False
        self.note()
        self.table.refresh()
        self.show_rows()
        self.show_settings()

    def save(self) -> None:
        """Write the data since the last restart to a new file in the current folder, in a thread: it may take long.

        If you press the button again before the file is complete, nothing more happens.
        """
        if self.saving is None:
            self.panel.show_saved(f"Saving {len(self.recording.rows)} rows ...")
            self.saving = Thread(target=self.write_data, args=[self.recording.copy()], daemon=True)
            self.saving.start()

    def write_data(self, recording) -> None:
        """Write this Recording to a new file in the current folder; then give the command SAVED."""
        try:
            path = recording.save(Path.cwd())
            self.saved = f"{len(recording.rows)} rows are in {path}", False
        except OSError as error:
            self.saved = f"{error.filename or 'The current folder'}: {error.strerror}", True
        self.give(Command.SAVED)

    def arguments(self) -> list[str] | None:
        """Return the arguments with which the program starts with the present settings; None if no file has its CSV."""
        experiment = self.questions.experiment
        if self.snapshot != (experiment.csv if experiment else self.file.current):  # it was edited in the table
            return None
        lifted = None if self.lifted is None else min(self.lifted, len(self.cradle.axles()))
        separating = self.separating and self.cradle.takes_rule
        now = {**dict(zip(ANGLES, self.angles, strict=False)), "lift": lifted, "separating": separating}
        now["experiment"] = experiment.key if experiment else None
        return page_arguments({**self.options, **self.cradle.options(), **now})

    # --- the mouse ---------------------------------------------------------------------------------------------------

    def follow_mouse(self, command, value) -> None:
        """Grab a bob, drag the held bob, or let it go; value is the mouse's ray."""
        if command is Command.GRAB:
            bob = bob_at(self.cradle.bobs(), *value)
            if bob is not None:
                self.cradle.hold(bob)
                self.leave_experiment()
        elif self.cradle.held is not None:
            if command is Command.LET_GO:
                self.cradle.let_go()
                self.motion.set_start()
            else:
                point = point_in_plane(*value)
                if point is not None:
                    self.cradle.drag(self.cradle.held, point.x, point.y)

    # --- time ---------------------------------------------------------------------------------------------------

    def note(self) -> None:
        """Add this moment to the recording, and to the measurement of an experiment."""
        sample = self.motion.sample()
        self.recording.add(sample)
        self.questions.note(sample, self.motion.has_hit())

    # --- texts and numbers -------------------------------------------------------------------------------------------

    def show_settings(self) -> None:
        """Show the present settings."""
        made_angles, made_lifted = self.cradle.as_made()
        angles = [made if angle is None else angle for angle, made in zip(self.angles, made_angles, strict=True)]
        count = len(self.cradle.axles())
        lifted = made_lifted if self.lifted is None else min(self.lifted, count)
        self.panel.show_settings(self.running, self.pace.speed, angles, lifted, count)
        arguments = self.arguments()
        self.panel.show_command("" if arguments is None else same_program(arguments))
        self.panel.show_graphs(list(self.graph.choices), self.graph.choice)

    def show_motion(self) -> None:
        """Show time, energy, momentum, impacts and graph, ten times a second."""
        if self.pace.clock() < self.next_refresh:
            return
        self.next_refresh = self.pace.clock() + REFRESH
        self.panel.show_motion(self.motion.time(), self.motion.percents(), self.cradle.momentum(), self.pace.remark())
        self.swung_through = self.swung_through or self.cradle.swings_through()
        self.panel.show_impacts(self.motion.trains.lines(), self.swung_through)
        self.graph.draw()
        if self.table.is_open:
            self.table.show_now(self.cradle.coordinates())
