"""The viewer: plays a cradle in step with the clock, and carries out the commands of the page."""

from collections.abc import Sequence
from math import inf
from queue import SimpleQueue
from typing import Any

from support.cradle.cradle import Cradle
from support.cradle.player import Player
from support.cradle.real_time import FRAME
from support.cradle.stopwatch import Stopwatch
from support.files.cradle_csv import LiveFile
from support.files.data_file import EVERY
from support.files.ghosts import Ghosts
from support.page import readout
from support.page.actions import Actions, SLOWLY
from support.page.chooser import Chooser
from support.page.controls import commands_of, is_text
from support.page.declarations import declare_commands, declare_controls
from support.page.endless import Watch
from support.page.graph import Graph
from support.page.questions import Questions
from support.page.scene.marks import Label, Marks
from support.page.scene.scenery import Scenery
from support.page.scene.slow_hits import SlowHits
from support.page.state import state_of_page
from support.page.tabs import Tabs
from support.pendulum import Pendulum

REFRESH = 0.1  # s between two changes of the state
# m/s: a hit makes no sound up to this speed; bobs that rest on each other meet again in each tick.
SLOWEST_SOUND = 0.01
LOOKS_A_SWING = 1000  # of a measurement, in the time of a small swing
FAINTEST = 0.3  # of the arrows of a slow hit
IMPACTS = 5  # series of hits, a line for each


class Viewer(Player):
    """The page with a cradle, its panel and its graph: the argument page of main."""

    def __init__(
        self,
        cradle: Cradle,
        file: LiveFile,
        angles: Sequence[float | None],
        lifted: int | None,
        tabs: Tabs,
        remark: str = "",
    ):
        """Play the cradle of this file as a Player does; tabs show it."""
        super().__init__(cradle, file.current, angles, lifted, IMPACTS, EVERY)
        self.file = file
        self.tabs = tabs
        self.given_remark = remark
        self.is_paused = False
        self.is_dragged = False  # whether you have moved a bob since the start
        self.speed = 1.0  # that you have set, times real time
        # The time on the pace's clock at which the page gets the whole state again; 0 is at once.
        self.next_refresh = 0.0
        # The coordinates before One tick, while it is carried out.
        self.before: dict[str, float] | None = None
        self.error = ""  # the mistake in your CSV
        # (command, values) of tabs, for the next frame; any thread can put one into it.
        self.commands: SimpleQueue[tuple[Any, Sequence]] = SimpleQueue()
        self.tick_lines: list[str] = []  # what One tick has done
        self.sounds = 0  # the number of pictures with a hit to hear
        self.loudest = 0.0  # m/s: the fastest hit of the last one of them

        self.chooser = Chooser(self)
        self.questions = Questions()
        self.scenery = Scenery()
        self.marks = Marks()
        self.ghosts = Ghosts()
        self.stopwatch = Stopwatch()
        # The time (s) of the last hits, and the momenta (kg m/s) after them.
        self.last_hits = -inf
        self.after_hits: list[float] = []
        self.slow_hits = SlowHits(cradle)
        self.graph = Graph(cradle.angle_keys, cradle.rate_keys)

        self.actions = Actions(self)
        self.controls = declare_controls(self)
        self.known_commands = {**commands_of(self.controls), **declare_commands(self.actions)}
        tabs.give = lambda command, *values: self.commands.put((command, values))
        tabs.endless = Watch(self).look

    # --- frames --------------------------------------------------------------------------------

    def frame(self) -> None:
        """Do the work of one frame: show the last ticks, rest, obey, and plan the next ticks."""
        self.show_frame()
        self.pace.rest()
        while not (self.commands.empty() or self.needs_cradle or self.planned):
            self.carry_out(*self.commands.get())
        if not self.needs_cradle and self.file.changed():
            self.actions.reload()
        self.look_longer()
        if self.tabs.are_gone:
            self.is_over = True
            self.planned = 0
        elif self.is_resting() or not self.is_time_running():
            self.pace.restart()
        elif not (self.needs_cradle or self.planned):
            self.pace.speed = self.speed_now()
            self.keep_time()

    def carry_out(self, name: Any, values: Sequence) -> None:
        """Do what a command says; do nothing if there is none, or if it takes no such values."""
        command = self.known_commands.get(name) if is_text(name) else None
        if command and command.takes(values):
            command.do(*values)
            self.next_refresh = 0.0

    def is_time_running(self) -> bool:
        """Return whether the cradle is not paused, and waits for no answer."""
        return not (self.is_paused or self.questions.is_asking)

    def look_longer(self) -> None:
        """Go on with what the time rests for: a measured experiment, then one slow hit by one."""
        now = self.pace.clock()
        self.questions.end_rest(now)
        if self.questions.rest_end is None:
            self.slow_hits.go_on(now, self.is_time_running())

    def is_resting(self) -> bool:
        """Return whether the time rests, so that you can look at something longer."""
        return self.questions.rest_end is not None or self.slow_hits.current is not None

    def speed_now(self) -> float:
        """Return the speed of the present run, times real time."""
        return SLOWLY if self.questions.slowly else self.speed

    def show_frame(self) -> None:
        """Show the result of the last ticks.

        Ten times a second show all of it, else what must be in step with the bobs.
        """
        if self.cradle.held_bob.index is not None:
            self.show_held_bob()
        self.scenery.keep_in_view([*self.cradle.bobs(), *self.marks.ghosts])
        if self.motion.loudest > SLOWEST_SOUND:
            self.sounds += 1
            self.loudest = round(self.motion.loudest, 4)
        self.motion.loudest = 0.0
        if not self.tabs.have_room():
            return
        labels = self.draw()
        state = {
            "sound": {"count": self.sounds, "speed": self.loudest},
            "view": {
                **self.scenery.view(),
                "fade": self.fade(),
                "labels": [label._asdict() for label in labels],
            },
        }
        if self.pace.clock() >= self.next_refresh:
            self.next_refresh = self.pace.clock() + REFRESH
            state |= state_of_page(self)
        self.tabs.show(state)

    def show_held_bob(self) -> None:
        """Take the energy of this moment as 100 %, once the held bob is not where it would be."""
        if self.is_time_running():
            self.actions.begin_drag()
        if self.actions.is_dragging:
            self.motion.set_start()
            if not self.is_time_running():
                self.take_sample()  # one scale: the graph ends at the 100 % of this moment, too

    def shown_pendula(self) -> list[Pendulum]:
        """Return the pendula as they are shown: as after the slow hit, or as they are now."""
        return self.slow_hits.current.pend_list if self.slow_hits.current else self.cradle.pend_list

    def fade(self) -> float:
        """Return how strong the arrows of a slow hit still are; 1 is full, as while paused."""
        if self.slow_hits.current is None or not self.is_time_running():
            return 1.0
        return max(FAINTEST, self.slow_hits.part_left(self.pace.clock()))

    def draw(self) -> list[Label]:
        """Draw all but the pendula: as in the current slow hit, or as it is now.

        Return the texts in the picture.
        """
        slow_hit = self.slow_hits.current
        pend_list = self.shown_pendula()
        self.marks.show_arrows(pend_list)
        self.marks.show_belts()
        self.marks.show_hit(slow_hit)
        time = self.motion.time()
        poses = self.questions.predicted(time)
        name = self.questions.ghost_name()
        if not poses:
            poses = self.ghosts.poses(time, len(pend_list))
            name = self.ghosts.name
        if slow_hit:  # else they cover its arrows
            poses = {}
        self.marks.show_ghosts(poses, name)
        return self.marks.labels(pend_list)

    def show_new_cradle(self) -> None:
        """Show a new cradle. The first one starts when a tab has drawn it: you see the release."""
        cradle = self.cradle
        self.tabs.begin_run()
        self.actions.pose()
        self.is_dragged = False
        self.scenery.surround(
            cradle.axles(), cradle.bobs(), cradle.cords_length, cradle.values("mass")
        )
        self.graph.begin(cradle.colors())
        self.last_hits = -inf
        self.after_hits = []
        self.begin_swing()
        self.before = None
        self.tick_lines = []
        self.next_refresh = 0.0
        while not (self.tabs.is_seen.is_set() or self.tabs.are_gone):
            self.show_frame()
            self.tabs.is_seen.wait(FRAME)
            self.next_refresh = 0.0
            self.pace.restart()

    def begin_swing(self) -> None:
        """Measure from this moment on: bobs were let go."""
        self.slow_hits.clear()
        self.marks.surround(self.cradle)
        self.stopwatch.restart(self.motion.time())
        self.ghosts.begin()
        self.take_sample()

    def take_sample(self) -> None:
        """Add this moment to the graph."""
        sample = self.motion.sample()
        self.graph.add(sample)
        self.stopwatch.look(sample["t"], sample["kinetic"], sample["total"])
        if self.motion.last_fast > self.last_hits:
            self.last_hits = self.motion.last_fast
            self.after_hits = self.marks.momenta_of(self.cradle.pend_list)

    def longest_batch(self) -> int:
        """Return after how many ticks, at most, to look at the cradle.

        A measurement looks a thousand times a swing.
        """
        longest = super().longest_batch()
        if self.questions.is_measuring():
            look = round(self.cradle.period / LOOKS_A_SWING / self.cradle.dt)
            longest = min(longest, max(1, look))
        return longest

    def end_batch(self) -> None:
        """Look at the result of a batch: measure an experiment; show One tick, or its hits."""
        super().end_batch()
        if (
            self.motion.ticks % self.step == 0
        ):  # not take_sample, which a drag calls again and again
            self.ghosts.compare(self.cradle.pend_list, self.motion.time())
        hits = self.cradle.hits
        if self.questions.measure(self.pace.clock()):
            self.planned = 0
        if self.looks_at_hits:
            self.slow_hits.add(hits.noted, self.motion.time(), self.motion.fast_speed)
            if self.slow_hits.waiting:
                self.planned = 0
        if self.before is not None:
            calls = hits.calls or [f"No call of {self.cradle.shown_name} was seen."]
            self.tick_lines = [*readout.changes(self.cradle, self.before), *calls]
            self.before = None
