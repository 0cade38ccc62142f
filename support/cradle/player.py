"""The player tells a program's loop when to make a cradle or do a tick, and shows the cradle.

The loop is main in src/visualize_cradle_run.py. A player is the cradle's page in the browser (support/page/viewer.py),
or its picture, its lines or its data file (support/terminal/players.py).

The loop asks is_running() again and again. When nothing is left to do, the player does a frame: it shows the cradle,
and plans the next ticks (plan) or a new cradle (make). The loop then gets this work.
"""

from collections.abc import Callable
from contextlib import ExitStack
from math import inf

from support.cradle.cradle import Cradle
from support.cradle.motion import Motion
from support.cradle.real_time import RealTime
from support.files.cradle_csv import clean_copy
from support.start.mistake import MistakeError

ENDLESS = 1.0  # s in the loop, without a frame, after which Ctrl+C has probably ended a loop that never ends
FEW = 10  # ticks in a part for slow hits, or while a bob is held: it then falls by less than 0.01 degrees


class Player:
    """Answers the loop's questions, and keeps the motion of the cradle. A subclass has frame, and maybe made and note.

    Ticks are done in parts: a part ends at each multiple of step ticks, for note. The fast path does a part in one
    call, if its result is certain to be the same as that of single ticks in the loop.
    """

    loop: Callable  # the loop, which asks; run sets it

    def __init__(self, cradle: Cradle, csv, angles, lifted, impacts, step_seconds):
        """Play the cradle of this CSV (a Snapshot); keep the last `impacts` trains of impacts.

        step_seconds (s) is the time from one call of note to the next, at least one tick.
        angles (rad) are the release angles, lifted is the number of bobs to lift. None keeps the value with which main
        makes the cradle.
        """
        self.cradle, self.snapshot = cradle, csv
        self.angles, self.lifted = list(angles), lifted
        self.motion, self.pace = Motion(cradle, impacts), RealTime(cradle.dt)
        self.separating = not cradle.takes_rule  # whether separating bobs collide, too; without the rule they do
        self.step = max(1, round(step_seconds / cradle.dt))  # ticks from one call of note to the next
        self.path, self.copy = "", ExitStack()  # of a copy of the snapshot for the loop, and its end
        self.is_over = False  # whether the simulation has ended
        self.is_wanted = False  # whether the loop must make a cradle
        self.planned: float = 0  # ticks that no part has yet
        self.deadline = inf  # the time on the pace's clock at which no more of them begin
        self.with_calls = False  # whether the loop must do them
        self.looks_at_hits = False  # whether the loop must do all ticks, a few in a part
        self.is_in_part, self.due = False, 0.0  # whether a part is being done, and its ticks for the loop
        self.offered = False, 0.0  # is_wanted and due when is_running last returned

    def frame(self) -> None:
        """Do the work of one frame: show the cradle, and call plan or make."""
        raise NotImplementedError

    def made(self) -> None:
        """Show a new cradle, which has just been released; a subclass may define this."""

    def note(self) -> None:
        """Show or record this moment; a subclass may define this."""

    # --- what the loop asks ------------------------------------------------------------------------------------------

    def is_running(self) -> bool:
        """Return whether the simulation runs; do frames until the loop has something to do."""
        was_wanted, was_due = self.offered
        if self.is_wanted and was_wanted:
            raise MistakeError(self.loop, "showed no cradle when page.wants_cradle() was True: page.show is missing.")
        if self.due and self.due == was_due:
            raise MistakeError(self.loop, "did not call page.wants_tick() when ticks were due.")
        while not (self.is_over or self.is_wanted or self.due):
            if self.is_in_part:
                self.end_part()
            elif self.planned and self.pace.clock() < self.deadline:
                self.begin_part()
            else:
                self.pace.give_back(self.planned)
                self.planned = 0
                self.frame()
        self.offered = self.is_wanted, self.due
        return not self.is_over

    def wants_cradle(self) -> bool:
        """Return whether the loop must make a cradle from the file at the path csv, and show it."""
        return self.is_wanted

    def show(self, pend_list) -> None:
        """Take and release a new cradle; raises a MistakeError if pend_list is no list of complete pendula."""
        with self.copy:
            self.cradle.take(pend_list, self.csv)
        self.is_wanted = False
        self.cradle.release(self.angles, self.lifted)
        self.motion.restart()
        self.made()

    @property
    def csv(self) -> str:
        """The path of the cradle's file, for main; it is there while a cradle is wanted."""
        if not self.is_wanted:
            raise MistakeError(self.loop, "used page.csv when page.wants_cradle() was False: a tick makes no cradle.")
        return self.path

    def wants_tick(self) -> bool:
        """Return whether a tick is due; after the deadline, the rest waits for the next frame."""
        if self.cradle.hits.new:
            self.motion.note_hits()
        if self.due and self.pace.clock() >= self.deadline:
            self.planned, self.due = self.planned + self.due, 0
        if not self.due:
            return False
        self.due -= 1
        self.motion.ticks += 1
        return True

    @property
    def rule(self) -> dict[str, bool]:
        """The keyword for the tick, if the tick takes it: whether only approaching bobs collide."""
        return {"approaching_only": not self.separating} if self.cradle.takes_rule else {}

    # --- what a frame asks for ---------------------------------------------------------------------------------------

    def make(self) -> None:
        """Let the loop make a new cradle; show then releases it, and begins at time 0."""
        self.cradle.give_back()
        self.path = self.copy.enter_context(clean_copy(self.snapshot))
        self.is_wanted, self.planned, self.offered = True, 0, (False, 0.0)

    def plan(self, ticks, deadline=inf, with_calls=False) -> None:
        """Let `ticks` ticks be done in this frame, but begin none after the deadline, a time on the pace's clock.

        With with_calls, the loop does them, and cradle.hits notes the calls of the collision function.
        """
        self.planned, self.deadline, self.with_calls = ticks, deadline, with_calls

    def keep_time(self, most=inf) -> None:
        """Plan the ticks that are due by the clock, but at most `most`; a slow machine does a part of them."""
        self.plan(self.pace.due(most), self.pace.deadline())

    def collide(self, collision) -> None:
        """Set how bobs collide from now on (a key of the cradle's collisions)."""
        with clean_copy(self.snapshot) as csv:
            self.cradle.collide(collision, csv)

    # --- parts -------------------------------------------------------------------------------------------------------

    def begin_part(self) -> None:
        """Do the next part of the planned ticks in one call, or let the loop do it."""
        longest = FEW if self.looks_at_hits or self.cradle.hand.held is not None else self.step
        part = min(self.planned, longest - self.motion.ticks % longest)
        self.planned -= part
        self.is_in_part = True
        self.cradle.hand.grip()
        if self.with_calls or self.looks_at_hits or not self.motion.do_at_once(part, self.rule):
            self.cradle.hits.listen(self.with_calls)
            self.due = part

    def end_part(self) -> None:
        """Look at the result of a part."""
        self.is_in_part = False
        self.cradle.hits.stop()
        self.cradle.hand.put_back()
        self.cradle.check()
        if self.motion.ticks % self.step == 0:
            self.note()


def run(loop, player) -> None:
    """Run a loop (for instance main) with a player; raises a MistakeError if the loop ends before the player."""
    player.loop = loop
    player.make()
    try:
        loop(player)
        if player.is_wanted or player.is_running():
            raise MistakeError(loop, "ended, but the simulation still runs.")
    except KeyboardInterrupt as stopped:
        stopped.is_late = player.pace.clock() - player.pace.frame_start > ENDLESS  # type: ignore[attr-defined]
        raise
    finally:
        player.cradle.hits.stop()
        player.copy.close()
