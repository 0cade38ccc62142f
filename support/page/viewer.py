"""The viewer: plays a cradle in step with the clock, and gives each part of the page its work."""

from collections.abc import Callable, Sequence
from itertools import chain
from typing import Any, NamedTuple

from support.cradle.cradle import Cradle
from support.cradle.player import Player, PLAYER_FILE
from support.cradle.real_time import FRAME, RealTime
from support.cradle.settings import Settings
from support.files.cradle_csv import LiveFile
from support.files.experiments import Experiment
from support.files.source_files import CONSTANTS, LiveSource
from support.files.valid_cradle import CradleCsv
from support.page import declarations
from support.page.chooser import Chooser
from support.page.cradle_editor import CradleEditor
from support.page.ghost_file import GhostFile
from support.page.graph import Graph
from support.page.held_bob import HeldBob
from support.page.lesson import Lesson
from support.page.names import State
from support.page.readout import Bars, readout_lines
from support.page.scene.marks import GhostPoses, Marks
from support.page.scene.scenery import Scenery
from support.page.scene.slow_hits import SlowHits
from support.page.server.tabs import Tabs
from support.page.stopwatch import Stopwatch
from support.page.unknown import Unknown
from support.start.end import end_if_signalled
from support.start.mistake import report_mistake
from support.start.preview import UnwrittenError

REFRESH = 0.1  # s between two changes of the state
# m/s: a hit makes no sound up to this speed; bobs that rest on each other meet again in each tick.
SLOWEST_SOUND = 0.01
SAMPLES_A_SWING = 90  # for the graph, in the time of a small swing
LOOKS_A_SWING = 1000  # of a measurement, in this time
YOURS = "your answer"  # above the ghosts of an answer
MEND = "Mend it, and save the file; pytest says more."
ENDED = "The program has come to its end. Restart runs it again."
NEW_CONSTANTS = "support/constants.py has changed. Start the program again."
ALSO_AFTER_THE_END = "restart", "next", "previous"  # commands
UPPER_ONLY = (
    "Only upper bobs collide, and as if nothing hung from them. So each hit changes the energy."
)


class FirstCradle(NamedTuple):
    """The first cradle of the page, as the options say."""

    csv: CradleCsv
    file: LiveFile  # in which this CSV is
    prepare: Callable[[CradleCsv], CradleCsv]  # returns a CSV with what the options say
    angles: Sequence[float | None]  # rad: of the release; None keeps that of the program
    lifted: int | None  # bobs
    ghost_file: GhostFile
    experiment: Experiment | None = None  # of your own, to begin with


class Viewer(Player):
    """The page with a cradle, its panel and its graph.

    It makes the parts, and hands each one what it uses: no part knows the viewer.
    """

    def __init__(
        self,
        cradle: Cradle,
        first: FirstCradle,
        tabs: Tabs,
        pace: RealTime | None = None,
    ):
        """Play the cradle as a Player does, in this pace; tabs show it."""
        settings = Settings(first.csv, [*first.angles], first.lifted)
        super().__init__(cradle, settings, cradle.period / SAMPLES_A_SWING, pace)
        self.tabs = tabs
        self.source = LiveSource()
        # The time on the pace's clock at which the page gets the whole state again; 0 is at once.
        self.next_refresh = 0.0

        # Which cradle
        self.chooser = Chooser(
            cradle, self.next_cradle, first.file, first.prepare, first.experiment
        )
        self.cradle_editor = CradleEditor(cradle, self.chooser)
        self.ghost_file = first.ghost_file
        # Its motion
        self.slow_hits = SlowHits(self.motion)
        self.lesson = Lesson(self.chooser, self.slow_hits, self.pace, self.plan)
        self.unknown = Unknown(cradle)
        self.held_bob = HeldBob(cradle)
        self.stopwatch = Stopwatch()
        # What shows it
        self.scenery = Scenery()
        self.marks = Marks()
        self.graph = Graph(cradle)
        self.bars = Bars(self.motion, self.slow_hits)
        # What you can do
        self.controls = declarations.controls(
            cradle,
            self.chooser,
            self.cradle_editor,
            self.lesson,
            self.marks,
            self.bars,
            self.slow_hits,
            self.graph,
        )
        self.commands = declarations.commands(
            self.controls,
            self.lesson,
            self.unknown,
            self.cradle_editor,
            self.ghost_file,
            self.held_bob.grab,
            self.drag,
            self.let_go,
            self.next_cradle.want,
        )

    # --- frames --------------------------------------------------------------------------------

    def frame(self) -> None:
        """Do the work of one frame: show the last ticks, rest, take commands, and plan the next."""
        self.show_frame()
        self.pace.rest()
        while not (self.tabs.commands.empty() or self.next_cradle.is_wanted or self.planned):
            self.carry_out(*self.tabs.commands.get())
        if not self.next_cradle.is_wanted:
            self.look_at_files()
        self.lesson.end_if_changed()
        if self.tabs.are_gone:
            self.is_over = True
            self.planned = 0
        elif self.held_bob.index is not None:
            self.planned = 0  # also of a step
            self.pace.restart()
        elif not self.lesson.is_running():
            self.pace.restart()
        elif not (self.next_cradle.is_wanted or self.planned):
            self.pace.speed = self.lesson.speed_now()
            self.keep_time()

    def look_at_files(self) -> None:
        """Ask for a new run if you have saved your CSV, or a file of src/."""
        self.chooser.look_at_file()
        self.look_at_source()

    def look_at_source(self) -> bool:
        """Ask for a new run if you have saved a file of src/ that can run; say why one cannot.

        Return whether a new run is wanted, also for another reason.
        """
        if self.source.changed():
            mistake = self.source.mistake()
            self.tell_of_files(mistake)
            if not mistake and self.source.saved != [CONSTANTS]:
                self.next_cradle.want()
        return self.next_cradle.is_wanted

    def tell_of_files(self, mistake: str = "") -> None:
        """Say what is wrong with the files; mistake is that of the last save."""
        words = []
        if mistake:
            words.append(f"Saved, but not run: {mistake}.")
        if self.source.has_new_constants():
            words.append(NEW_CONSTANTS)
        self.tabs.tell({"saved": " ".join(words)})

    def carry_out(self, name: Any, *values: Any) -> None:
        """Carry out a command; do nothing if there is none with this name, or with such values."""
        command: Any = self.commands.get(str(name))
        if command and command.takes(values):
            command.do(*values)
            self.next_refresh = 0.0

    def progress(self) -> tuple[float, ...]:
        """Return what changes with each run, each tick and each frame."""
        return self.run_count, self.motion.ticks, self.pace.frame_start

    def show_frame(self) -> None:
        """Show the result of the last ticks.

        Ten times a second show all of it, otherwise only what must keep step with the bobs.
        """
        if self.held_bob.has_moved:
            self.motion.set_start()  # 100 % is the energy of this moment
            self.take_sample()  # one scale: the graph ends at the 100 % of this moment, too
        self.scenery.keep_in_view(bob.pos for bob in self.cradle.bobs())
        state = self.state_in_step()
        if self.pace.clock() >= self.next_refresh:
            self.next_refresh = self.pace.clock() + REFRESH
            state |= self.state()
        self.tabs.show(state)

    def state_in_step(self) -> State:
        """Draw all but the pendula; return what a tab shows in the same picture."""
        ghosts = self.marks.show(self.slow_hits, self.ghost_poses())
        state: State = {"view": {**self.scenery.view(), "ghosts": ghosts}}
        if self.motion.loudest > SLOWEST_SOUND:
            speed = round(self.motion.loudest, 4)
            state["sound"] = {"speed": speed, "time": self.motion.time()}  # unlike the last one
        self.motion.loudest = 0.0
        return state

    def ghost_poses(self) -> list[GhostPoses]:
        """Return where ghosts are now: those of each answer, or else those of a file."""
        time = self.motion.time()
        predicted = self.lesson.ghosts(time)
        if predicted:
            return [GhostPoses(poses, YOURS, answer) for answer, poses in enumerate(predicted)]
        poses = self.ghost_file.poses(time, len(self.cradle.pend_list))
        return [GhostPoses(poses, self.ghost_file.name)]

    def state(self) -> State:
        """Return what the page shows outside VPython's canvas, all texts plain.

        Each part says all that it knows; what gives a hidden value away is then taken out.
        """
        said = (*self.remarks, self.why_no_hits())
        lines = readout_lines(self.motion, self.pace, self.slow_hits)
        if self.marks.measures:
            lines["half swings"] = str(self.stopwatch)
        state: State = {
            "title": self.cradle.title,
            "remark": " ".join(filter(None, said)),
            "hits": self.slow_hits.state(),
            "motion": lines | self.ghost_file.readout(),
            "summary": self.motion.summary(),
            "bars": self.bars.chart(self.lesson.is_resting()),
            "curves": self.graph.state(self.motion.start_energy),
            "controls": {name: control.description() for name, control in self.controls.items()},
        }
        for part in (
            self.chooser,
            self.cradle_editor,
            self.ghost_file,
            self.unknown,
        ):
            state |= part.state()
        return self.unknown.without_hidden(state | self.lesson.view())

    def why_no_hits(self) -> str:
        """Return why Slow hits stay empty, or ""."""
        can_come = self.hits.was_asked or not self.motion.ticks
        if can_come or not self.slow_hits.is_on or self.cradle.count == 1:
            return ""
        return f"The tick does not call {self.cradle.collide_name}: there are no hits to show."

    # --- a run ---------------------------------------------------------------------------------

    def begin(self) -> None:
        """Get ready for the next run, of the files as they are now."""
        super().begin()
        self.source.take()
        self.tell_of_files()

    def own_shapes(self) -> list:
        return [
            self.scenery.board,
            self.scenery.ground,
            *self.scenery.stand,
            *chain(*self.marks.shapes.values()),
        ]

    def go_on_after(self, error: BaseException | None) -> None:
        """Say why a run has ended, until another one is wanted; the picture stays as it is."""
        over, stopped = ENDED, ""
        if isinstance(error, UnwrittenError):
            over = str(error)
            print(over)
        elif error:
            over, stopped = "", f"{report_mistake(error, PLAYER_FILE).rstrip('.')}. {MEND}"
        self.tabs.tell({"title": self.cradle.title, "over": over, "stopped": stopped})
        while not (self.next_cradle.is_wanted or self.tabs.are_gone):
            end_if_signalled()
            self.pace.rest()
            self.pace.restart()
            while not (self.tabs.commands.empty() or self.next_cradle.is_wanted):
                name, *values = self.tabs.commands.get()
                if name in ALSO_AFTER_THE_END or values[:1] == ["experiment"]:
                    self.carry_out(name, *values)
            self.look_at_files()
            self.tabs.tell({"error": self.chooser.error})
        self.tabs.tell({"over": "", "stopped": ""})
        self.is_over = not self.next_cradle.is_wanted

    def show_new_cradle(self) -> None:
        """Show a new cradle. The first one starts when a tab has drawn it: you see the release."""
        cradle = self.cradle
        if cradle.cord_count == 2 and cradle.collide_name == "handle_two_bobs":
            self.remarks.append(UPPER_ONLY)
        self.held_bob.let_go()
        if not self.lesson.repeats:  # a film has the whole lesson
            self.tabs.begin_film()
        self.lesson.begin(self.motion)
        self.scenery.surround(
            cradle.axles(),
            cradle.cords_length,
            cradle.values("mass"),
            self.lesson.largest_swing(),
        )
        self.graph.begin()
        self.unknown.begin()
        self.begin_swing()
        self.next_refresh = 0.0
        self.show_frame()
        while not (self.tabs.is_seen.is_set() or self.tabs.are_gone):
            end_if_signalled()
            self.tabs.is_seen.wait(FRAME)
            self.pace.restart()

    def drag(self, place: Sequence[float], direction: Sequence[float]) -> None:
        """Move the held bob: the cradle is no longer that of an experiment, and shows no hit."""
        self.held_bob.drag(place, direction)
        if self.held_bob.has_moved:
            self.chooser.leave_experiment()
            self.slow_hits.clear()

    def let_go(self) -> None:
        """Let the held bob, if there is one, swing from where it is."""
        if self.held_bob.has_moved:
            self.motion.set_start()
            self.begin_swing()
        self.held_bob.let_go()

    def begin_swing(self) -> None:
        """Measure from this moment on: bobs were let go."""
        self.slow_hits.clear()
        self.marks.surround(self.cradle, self.motion.digits)
        self.stopwatch.restart(self.motion.time())
        self.ghost_file.begin()
        self.take_sample()

    def take_sample(self) -> None:
        """Add this moment to the graph."""
        sample = self.motion.sample()
        self.stopwatch.measure(sample["t"], sample["kinetic"], sample["total"])
        self.bars.keep_momenta()
        self.graph.add(sample)

    def looks_at_hits(self) -> bool:
        return self.slow_hits.is_on

    def longest_batch(self) -> int:
        """Return after how many ticks, at most, to look at the cradle.

        A measurement looks a thousand times a swing.
        """
        longest = super().longest_batch()
        if self.lesson.is_measuring():
            look = round(self.cradle.period / LOOKS_A_SWING / self.cradle.dt)
            longest = min(longest, max(1, look))
        return longest

    def end_batch(self) -> None:
        """Look at the result of a batch: measure an experiment, or show its hits."""
        super().end_batch()
        # Not in take_sample, which a drag calls again and again.
        if self.motion.ticks % self.step == 0:
            self.ghost_file.compare(self.cradle.pend_list, self.motion.time())
        if self.lesson.measure():
            self.planned = 0
        if self.slow_hits.is_on:
            self.slow_hits.add(self.hits.noted)
            if self.slow_hits.current:
                self.planned = 0
