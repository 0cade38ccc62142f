"""The player shows the cradle of a program, and tells the program's loop when to do a tick.

run_for_each_cradle runs the program. Its loop asks is_running (support/simulation.py) before
each tick, and this asks the player: the page in the browser (support/page/viewer.py), or lines or a
data file (support/terminal/players.py). The first question shows the cradle. When no tick is due,
the player does a frame: it shows the cradle, and plans the next ticks (plan), or wants another
cradle (next_cradle.want): the run is then over.
"""

from bdb import BdbQuit
from functools import partial
from importlib.util import find_spec
from math import inf
from pathlib import Path
from time import perf_counter
from typing import Any

from support import constants, simulation
from support.cradle.cradle import Cradle
from support.cradle.hits import Hits
from support.cradle.motion import Motion
from support.cradle.real_time import BUSY, RealTime
from support.cradle.settings import NextCradle, Settings
from support.files.source_files import fresh_modules, main_module, run_file
from support.files.valid_cradle import CradleCsv, file_for_pandas
from support.pendulum import discard_all, Pendulum
from support.start.end import end_if_signalled, SignalError
from support.start.mistake import MistakeError
from support.start.preview import missing_in, preview, UnwrittenError

FAST_PATH: Any = None
if find_spec(".many_ticks", "support.cradle"):  # a student gets the project without it
    from support.cradle import many_ticks

    FAST_PATH = many_ticks

# s in the loop, without a frame, after which Ctrl+C has probably ended a loop that never ends.
ENDLESS_AFTER = 1.0
PLAYER_FILE = __file__  # its frames in a traceback are not a student's


class Player:
    """Answers the loop's questions, and keeps the motion of the cradle.

    The ticks of a frame are done in batches, so that take_sample is called every `step` ticks.
    """

    def __init__(
        self,
        cradle: Cradle,
        settings: Settings,
        step_seconds: float,
        pace: RealTime | None = None,
    ):
        """Play the cradle of these settings.

        step_seconds (s) is the time from sample to sample, to the nearest whole number of ticks.
        pace keeps the time; without one, it is real time.
        """
        self.cradle = cradle
        self.next_cradle = NextCradle(settings)
        self.motion = Motion(cradle)
        self.hits = Hits(cradle, self.next_cradle)
        self.pace = pace or RealTime(cradle.dt)
        self.step = max(1, round(step_seconds / cradle.dt))  # ticks from sample to sample
        self.last_frame = perf_counter()  # s: when the last frame began
        self.is_over = False  # whether the simulation has ended
        self.run_count = 0  # runs that have begun
        self.names: dict[str, Any] = {}  # of the program

    # --- for a kind of player ------------------------------------------------------------------

    def frame(self) -> None:
        """Do the work of one frame: show the cradle, and call plan or next_cradle.want."""
        raise NotImplementedError

    def show_new_cradle(self) -> None:
        """Show a new cradle, which has just been released; a subclass may define this."""

    def take_sample(self) -> None:
        """Show or record this moment; a subclass may define this."""

    def own_shapes(self) -> list:
        """Return the shapes that are not the program's; a subclass with some may define this."""
        return []

    def go_on_after(self, error: BaseException | None) -> None:
        """Raise this error, with which a run has ended, or one that says that it ended too early.

        A subclass that can wait for the next run waits in its place.
        """
        if error:
            raise error
        message = "has ended, but the simulation goes on. Tick while is_running(pend_list) is True."
        raise MistakeError("The program", message)

    def looks_at_hits(self) -> bool:
        """Return whether a batch ends at a hit: the loop then does all ticks.

        A subclass may define this.
        """
        return False

    def longest_batch(self) -> int:
        """Return after how many ticks to look at the cradle; a subclass may define this."""
        return self.step

    def plan(self, ticks: float, deadline: float = inf) -> None:
        """Let `ticks` ticks be done in this frame, but begin none after the deadline.

        The deadline is a time on the pace's clock.
        """
        self.planned = ticks
        self.deadline = deadline

    def keep_time(self, most: float = inf) -> None:
        """Plan the ticks that are due by the clock, but at most `most`.

        A slow machine does only some of them.
        """
        self.plan(self.pace.due(most), self.pace.frame_start + BUSY)

    # --- a run ---------------------------------------------------------------------------------

    def begin(self) -> None:
        """Get ready for the next run, and take away what the last one has shown."""
        self.run_count += 1
        self.next_cradle.is_wanted = False
        self.is_shown = False  # whether the run has shown its cradle
        self.is_preview = False  # whether it shows only the functions that are written
        self.remarks: list[str] = []  # what there is to say about it
        self.planned = 0  # the ticks of this frame that are in no batch yet
        self.is_in_batch = False
        self.due = 0  # the ticks of a batch that the loop must still do
        self.hits.stop()
        self.cradle.pend_list = []
        discard_all(but=self.own_shapes())

    def show(self, pend_list: list[Pendulum]) -> None:
        """Take and release a new cradle, the program's list.

        Raises a MistakeError if pend_list is no list of complete pendula.
        """
        settings = self.next_cradle.settings
        cradle = self.cradle
        cradle.find_functions(self.names)
        cradle.accept(pend_list)
        hidden = settings.hidden
        is_there = hidden is not None and hidden.rows[-1] < len(pend_list)
        cradle.hidden = hidden if is_there else None
        if settings.poses and len(settings.poses) == len(pend_list):  # it may read another file
            cradle.pose(settings.poses)
        else:
            cradle.release(settings.angles, settings.lifted)
        self.is_shown = True
        self.note_set_by_program(settings.csv)
        self.is_fast = FAST_PATH and FAST_PATH.is_shipped(self.names)
        self.hits.listen()
        self.motion.restart()
        self.show_new_cradle()

    def note_set_by_program(self, csv: CradleCsv) -> None:
        """Note what the program sets itself; if NC_FP is a copy of the CSV, say so.

        A preview takes only some of the pendula: that is no difference.
        """
        self.cradle.set_by_program = [] if self.is_preview else self.cradle.differences_from(csv)
        if self.cradle.set_by_program and str(csv.filepath) != constants.NC_FP:
            set_by_program = " and ".join(self.cradle.set_by_program)
            self.remarks.append(f"The program does not take {set_by_program} from NC_FP.")

    # --- for the loop --------------------------------------------------------------------------

    def is_running(self, pend_list: list[Pendulum]) -> bool:
        """Return whether the loop must do a tick now.

        False ends the loop, as the run is over. When no tick is due, do frames until one is. Leave
        out the ticks that are not done at the deadline.
        """
        if not self.is_shown:
            self.show(pend_list)
        self.cradle.pend_list = pend_list  # some loops make a new one for each tick
        if self.due and self.must_look():
            self.planned += self.due
            self.due = 0
        while not self.due:
            if self.is_in_batch:
                self.end_batch()
            if self.is_over or self.next_cradle.is_wanted:
                return False
            if self.planned and self.pace.clock() < self.deadline:
                self.begin_batch()
            else:
                self.pace.leave_out(self.planned)
                self.planned = 0
                self.last_frame = perf_counter()
                end_if_signalled()
                self.frame()
        self.due -= 1
        self.motion.ticks += 1
        self.hits.tick = self.motion.ticks
        return True

    def must_look(self) -> bool:
        """Return whether the batch ends before its time: at the deadline, or with a hit to show."""
        has_hit = self.looks_at_hits() and bool(self.hits.noted)
        return has_hit or self.pace.clock() >= self.deadline

    # --- a batch of ticks ----------------------------------------------------------------------

    def begin_batch(self) -> None:
        """Do the next batch of the planned ticks in one call, or let the loop do it."""
        until_sample = self.step - self.motion.ticks % self.step
        batch = int(min(self.planned, until_sample, self.longest_batch()))
        self.planned -= batch
        self.is_in_batch = True
        self.hits.noted.clear()
        if self.do_at_once(batch):
            self.motion.ticks += batch
        else:
            self.due = batch

    def do_at_once(self, ticks: int) -> bool:
        """Do a batch in one call of the fast path; return whether this was possible."""
        if not self.is_fast or self.looks_at_hits() or FAST_PATH.is_watched():
            return False
        FAST_PATH.many_ticks(self.cradle, self.hits, ticks, self.names)
        return True

    def end_batch(self) -> None:
        """Look at the result of a batch."""
        self.is_in_batch = False
        for hit in self.hits.noted:
            self.motion.note_hit(hit)
        self.cradle.require_same_pendula()
        if self.motion.ticks % self.step == 0:
            self.take_sample()


def run_for_each_cradle(file: Path, player: Player) -> None:
    """Run a program, this file of src/, once for each cradle; its loop asks this player."""
    try:
        while player.next_cradle.is_wanted:
            player.begin()
            error: BaseException | None = None
            try:
                run_once(file, player)
            except (BdbQuit, SignalError):  # also a debugger's q
                raise
            except SystemExit as end:  # exit() in a program only ends the run
                error = end if end.code else None
            except Exception as raised:
                error = raised
            if error or not (player.is_over or player.next_cradle.is_wanted):
                player.go_on_after(error)
    except SignalError as stopped:
        seconds = perf_counter() - player.last_frame
        stopped.is_late = seconds > ENDLESS_AFTER
        raise
    finally:
        player.hits.stop()


def run_once(file: Path, player: Player) -> None:
    """Run a program for one cradle: NC_FP is then the path of its CSV."""
    before = constants.NC_FP
    with file_for_pandas(player.next_cradle.settings.csv) as path, fresh_modules():
        constants.NC_FP = path
        try:
            run_or_preview(file, player)
        finally:
            constants.NC_FP = before


def run_or_preview(file: Path, player: Player) -> None:
    """Run a program; while functions are missing, show what there is."""
    program = main_module(file)
    player.names = vars(program)
    try:
        simulation.run(partial(run_file, program), player)
        return
    except NotImplementedError as error:
        unwritten = error
    if player.cradle.cord_count == 2:  # it has no tiers
        raise UnwrittenError(*missing_in(unwritten))
    player.begin()
    player.is_preview = True
    simulation.run(partial(preview, player.names, unwritten, player.remarks), player)
