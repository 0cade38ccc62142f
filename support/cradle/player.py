"""The player shows the cradle of a program, and tells the program's loop when to do a tick.

The loop is main in src/visualize_cradle_run.py; run calls it once for each cradle. A player is the
argument page of main: the cradle's page in the browser (support/page/viewer.py), or its lines or
its data file (support/terminal/players.py).

The loop asks is_running() before each tick. When no tick is due, the player does a frame: it shows
the cradle, and plans the next ticks (plan), or wants another cradle (next_cradle.want). The loop
then ends, and begins again.
"""

from contextlib import ExitStack
from math import inf
from time import perf_counter

from support.cradle.cradle import Cradle
from support.cradle.hits import Hits
from support.cradle.motion import Motion
from support.cradle.real_time import BUSY, RealTime
from support.cradle.settings import NextCradle, Settings
from support.files.valid_cradle import file_for_pandas
from support.main_page import Loop, Page
from support.start.early import import_now
from support.start.end import end_if_signalled, SignalError
from support.start.mistake import MistakeError

# s in the loop, without a frame, after which Ctrl+C has probably ended a loop that never ends.
ENDLESS_AFTER = 1.0
# Questions after is_running was False: a loop in a loop asks again, but not so often.
MOST_REFUSED = 1000
PLAYER_FILE = __file__  # its frames in a traceback are not a student's


class Player(Page):
    """Answers the loop's questions, and keeps the motion of the cradle.

    The ticks of a frame are done in batches, so that take_sample is called every `step` ticks. The
    fast path does a batch in one call, if its result is certain to be that of single ticks in the
    loop.
    """

    loop: Loop  # the loop, which asks; run sets it

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
        self.next_cradle = NextCradle(settings, separating=not cradle.takes_rule)
        self.motion = Motion(cradle)
        self.hits = Hits(cradle)
        self.pace = pace or RealTime(cradle.dt)
        self.step = max(1, round(step_seconds / cradle.dt))  # ticks from sample to sample
        self.path = ""  # of the CSV, or of a copy, for the loop
        self.copy = ExitStack()  # it deletes a copy
        self.is_over = False  # whether the simulation has ended
        self.is_shown = False  # whether the loop has shown its cradle
        self.last_frame = perf_counter()  # s: when the last frame began
        self.refused = 0  # how often the loop has asked again since is_running was False
        # The ticks of this frame.
        self.planned: float = 0  # those that no batch has yet
        self.deadline = inf  # the time on the pace's clock at which no more of them begin
        # The ticks of a batch.
        self.is_in_batch = False
        self.due: float = 0  # those that the loop must still do

    # --- for a kind of player ------------------------------------------------------------------

    def frame(self) -> None:
        """Do the work of one frame: show the cradle, and call plan or want_cradle."""
        raise NotImplementedError

    def show_new_cradle(self) -> None:
        """Show a new cradle, which has just been released; a subclass may define this."""

    def take_sample(self) -> None:
        """Show or record this moment; a subclass may define this."""

    def looks_at_hits(self) -> bool:
        """Return whether a batch ends at a hit; a subclass may define this. The loop then does all
        ticks.
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

    # --- for the loop --------------------------------------------------------------------------

    def begin(self) -> None:
        """Get ready for the loop to make and show a cradle."""
        self.cradle.give_back()
        self.path = self.copy.enter_context(file_for_pandas(self.next_cradle.settings.csv))
        self.next_cradle.is_wanted = False
        self.planned = 0
        self.is_shown = False
        self.refused = 0

    @property
    def csv(self) -> str:
        """The path of the cradle's file; it is there until the loop has shown the cradle."""
        if self.is_shown:
            message = "used page.csv after page.show. Make the cradle once, before the loop."
            raise MistakeError(self.loop, message)
        return self.path

    @property
    def rule(self) -> dict[str, bool]:
        """The keyword for the tick, if it takes one: whether only approaching bobs collide.

        Only this place knows it: called without it, the handout's functions follow the handout.
        """
        if not self.cradle.takes_rule:
            return {}
        return {"approaching_only": not self.next_cradle.separating}

    def show(self, pend_list: list) -> None:
        """Take and release a new cradle.

        Raises a MistakeError if pend_list is no list of complete pendula.
        """
        if self.is_shown:
            message = "called page.show again. Show the cradle once, before the loop."
            raise MistakeError(self.loop, message)
        settings = self.next_cradle.settings
        with self.copy:
            self.cradle.accept(pend_list, settings.csv.columns)
            self.cradle.use_mass(settings.mass, self.path)
            self.cradle.use_e_of(settings.e_source, self.path)
        hidden = settings.hidden
        is_there = hidden is not None and hidden.rows[0] < len(pend_list)
        self.cradle.hidden = hidden if is_there else None
        self.is_shown = True
        if settings.poses and len(settings.poses) == len(pend_list):  # main may read another file
            self.cradle.pose(settings.poses)
        else:
            self.cradle.release(settings.angles, settings.lifted)
        self.motion.restart()
        self.show_new_cradle()

    def is_running(self) -> bool:
        """Return whether the loop must do a tick now.

        False ends the loop, as the simulation is over or begins again. When no tick is due, do
        frames until one is. After the deadline, the rest of a batch waits for the next frame.
        """
        if not self.is_shown:
            raise MistakeError(self.loop, "asked page.is_running() before page.show(pend_list).")
        if self.due and self.must_look():
            self.planned += self.due
            self.due = 0
        while not self.due:
            if self.is_in_batch:
                self.end_batch()
            if self.is_over or self.next_cradle.is_wanted:
                self.refuse()
                return False
            if self.planned and self.pace.clock() < self.deadline:
                self.begin_batch()
            else:
                self.pace.give_back(self.planned)
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

    def refuse(self) -> None:
        """Count this question; raise a MistakeError if the loop does not end."""
        self.refused += 1
        if self.refused > MOST_REFUSED:
            message = "went on after page.is_running() was False. It must leave its loop then."
            raise MistakeError(self.loop, message)

    # --- a batch of ticks ----------------------------------------------------------------------

    def begin_batch(self) -> None:
        """Do the next batch of the planned ticks in one call, or let the loop do it."""
        until_sample = self.step - self.motion.ticks % self.step
        batch = int(min(self.planned, until_sample, self.longest_batch()))
        self.planned -= batch
        self.is_in_batch = True
        self.hits.noted.clear()
        if self.looks_at_hits() or not self.do_at_once(batch):
            self.hits.listen()
            self.due = batch

    def do_at_once(self, ticks: int) -> bool:
        """Do a batch in one call of the fast path, if it is certain of the result.

        Return whether it was.
        """
        cradle = self.cradle
        if not cradle.many_ticks:
            return False
        hits = cradle.many_ticks.many_ticks(cradle.scope, cradle.pend_list, ticks, self.rule)
        if hits is None:
            return False
        before = self.motion.ticks
        self.hits.noted += [hit._replace(tick=before + hit.tick) for hit in hits]
        self.motion.ticks += ticks
        return True

    def end_batch(self) -> None:
        """Look at the result of a batch."""
        self.is_in_batch = False
        self.hits.stop()
        for hit in self.hits.noted:
            self.motion.note_hit(hit)
        self.cradle.require_same_pendula()
        if self.motion.ticks % self.step == 0:
            self.take_sample()


def run(loop: Loop, player: Player) -> None:
    """Run a loop (for instance main) once for each cradle.

    Raises a MistakeError if it ends while it must go on.
    """
    import_now("pandas")  # not in a student's function, which has no part in the time that it takes
    player.loop = loop
    try:
        while player.next_cradle.is_wanted:
            player.begin()
            loop(player)
            if not player.is_shown:
                raise MistakeError(loop, "showed no cradle: page.show(pend_list) is missing.")
            if not (player.next_cradle.is_wanted or player.is_over):
                message = (
                    "ended, but the simulation still runs. Tick while page.is_running() is True."
                )
                raise MistakeError(loop, message)
    except SignalError as stopped:
        seconds = perf_counter() - player.last_frame
        stopped.is_late = seconds > ENDLESS_AFTER  # type: ignore[attr-defined]
        raise
    finally:
        player.hits.stop()
        player.copy.close()
