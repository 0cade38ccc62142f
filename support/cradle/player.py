"""The player shows the cradle of a program, and tells the program's loop when to do a tick.

The loop is main in src/visualize_cradle_run.py; run calls it once for each cradle. A player is the
cradle's page in the browser (support/page/viewer.py), or its picture, its lines or its data file
(support/terminal/players.py).

The loop asks is_running() before each tick. When no tick is due, the player does a frame: it shows
the cradle, and plans the next ticks (plan), or wants another cradle (want_cradle): the loop then
ends, and begins again.
"""

from collections.abc import Callable
from contextlib import ExitStack
from math import inf

from support.cradle.cradle import Cradle
from support.cradle.motion import Motion
from support.cradle.real_time import BUSY, RealTime
from support.files.cradle_csv import clean_copy
from support.start.early import import_now
from support.start.mistake import MistakeError

# S in the loop, without a frame, after which Ctrl+C has probably ended a loop that never ends
ENDLESS = 1.0
# Questions after is_running was False: a loop in a loop asks again, but not so often
MOST_REFUSED = 1000
# Ticks in a part for slow hits, or while a bob is held: it then falls by less than 0.01 degrees
FEW = 10


class Player:
    """Answers the loop's questions, and keeps the motion of the cradle.

    The ticks of a frame are done in parts, so that note is called every `step` ticks. The fast path
    does a part in one call, if its result is certain to be the same as that of single ticks in the
    loop.
    """

    loop: Callable  # the loop, which asks; run sets it

    def __init__(self, cradle: Cradle, csv, angles, lifted, impacts, step_seconds):
        """Play the cradle of this CSV (a Snapshot); keep the last `impacts` trains of impacts.

        angles (rad) are the release angles, lifted is the number of bobs to lift; None keeps main's
        own value. step_seconds (s) is the time from one call of note to the next, to the nearest
        whole number of ticks.
        """
        self.cradle, self.snapshot = cradle, csv
        self.angles, self.lifted = list(angles), lifted
        self.motion, self.pace = Motion(cradle, impacts), RealTime(cradle.dt)
        # Whether separating bobs collide, too; without the rule they do
        self.separating = not cradle.takes_rule
        # Ticks from one call of note to the next
        self.step = max(1, round(step_seconds / cradle.dt))
        # Of a copy of the snapshot for the loop, and its end
        self.path = ""
        self.copy = ExitStack()
        self.is_over = False  # whether the simulation has ended
        self.is_wanted = False  # whether another cradle is wanted, so that the loop must end
        self.is_shown = False  # whether the loop has shown its cradle
        self.planned: float = 0  # ticks that no part has yet
        self.deadline = inf  # the time on the pace's clock at which no more of them begin
        self.with_calls = False  # whether the loop must do them
        self.looks_at_hits = False  # whether the loop must do all ticks, a few in a part
        # Whether a part is being done, and its ticks for the loop
        self.is_in_part = False
        self.due = 0.0

    def frame(self) -> None:
        """Do the work of one frame: show the cradle, and call plan or want_cradle; a subclass must
        define this.
        """
        raise NotImplementedError

    def show_new_cradle(self) -> None:
        """Show a new cradle, which has just been released; a subclass may define this."""

    def note(self) -> None:
        """Show or record this moment; a subclass may define this."""

    def begin(self) -> None:
        """Get ready for the loop to make and show a cradle."""
        self.cradle.give_back()
        self.path = self.copy.enter_context(clean_copy(self.snapshot))
        self.is_wanted = self.is_shown = False
        self.refused = 0

    @property
    def csv(self) -> str:
        """The path of the cradle's file, for main; it is there until main has shown the cradle."""
        if self.is_shown:
            raise MistakeError(
                self.loop, "used page.csv after page.show. Make the cradle once, before the loop."
            )
        return self.path

    def show(self, pend_list) -> None:
        """Take and release a new cradle; raises a MistakeError if pend_list is no list of complete
        pendula.
        """
        if self.is_shown:
            raise MistakeError(
                self.loop, "called page.show again. Show the cradle once, before the loop."
            )
        with self.copy:
            self.cradle.accept(pend_list, self.path)
        self.is_shown = True
        self.cradle.release(self.angles, self.lifted)
        self.motion.restart()
        self.show_new_cradle()

    def is_running(self) -> bool:
        """Return whether the loop must do a tick now; False ends the loop, as the simulation is
        over or begins again.

        When no tick is due, do frames until one is. After the deadline, the rest of a part waits
        for the next frame.
        """
        if not self.is_shown:
            raise MistakeError(self.loop, "asked page.is_running() before page.show(pend_list).")
        self.note_hits()
        if self.due and self.pace.clock() >= self.deadline:
            self.planned, self.due = self.planned + self.due, 0
        while not self.due:
            if self.is_in_part:
                self.end_part()
            elif self.is_over or self.is_wanted:
                self.refused += 1
                if self.refused > MOST_REFUSED:
                    words = (
                        "went on after page.is_running() was False. It must leave its loop then."
                    )
                    raise MistakeError(self.loop, words)
                return False
            elif self.planned and self.pace.clock() < self.deadline:
                self.begin_part()
            else:
                self.pace.give_back(self.planned)
                self.planned = 0
                self.frame()
        self.due -= 1
        self.motion.ticks += 1
        self.cradle.hits.begin_tick()
        return True

    def note_hits(self) -> None:
        """Add the hits of the last tick to the motion; listen only during a part."""
        hits = self.cradle.hits
        if self.is_in_part:
            hits.end_tick()
        else:
            hits.stop()
        for hit in hits.new:
            self.motion.note_hit(self.motion.ticks, *hit[:4])
        hits.new.clear()

    @property
    def rule(self) -> dict[str, bool]:
        """The keyword for the tick, if the tick takes it: whether only approaching bobs collide."""
        return {"approaching_only": not self.separating} if self.cradle.takes_rule else {}

    def want_cradle(self) -> None:
        """Let the loop end, and make a new cradle: show then releases it, and begins at time 0."""
        self.is_wanted, self.planned = True, 0

    def plan(self, ticks, deadline=inf, with_calls=False) -> None:
        """Let `ticks` ticks be done in this frame, but begin none after the deadline, a time on the
        pace's clock.

        With with_calls, the loop does them, and cradle.hits notes the calls of the collision
        function.
        """
        self.planned, self.deadline, self.with_calls = ticks, deadline, with_calls

    def keep_time(self, most=inf) -> None:
        """Plan the ticks that are due by the clock, but at most `most`; a slow machine does a part
        of them.
        """
        self.plan(self.pace.due(most), self.pace.frame_start + BUSY)

    def collide(self, collision) -> None:
        """Set how bobs collide from now on (a key of the cradle's collisions)."""
        with clean_copy(self.snapshot) as csv:
            self.cradle.collide(collision, csv)

    def longest_part(self) -> int:
        """Return after how many ticks, at most, to look at the cradle; a subclass may look more
        often.
        """
        return FEW if self.looks_at_hits or self.cradle.hand.held is not None else self.step

    def begin_part(self) -> None:
        """Do the next part of the planned ticks in one call, or let the loop do it."""
        part = min(self.planned, self.step - self.motion.ticks % self.step, self.longest_part())
        self.planned -= part
        self.is_in_part = True
        self.cradle.hand.grip()
        if self.with_calls or self.looks_at_hits or not self.do_at_once(part):
            self.cradle.hits.listen(self.with_calls)
            self.due = part

    def do_at_once(self, ticks) -> bool:
        """Do `ticks` ticks in one call of the fast path, if it is certain of the result; return
        whether it was.
        """
        cradle = self.cradle
        contacts = cradle.many_ticks and cradle.many_ticks(
            cradle.scope, cradle.pend_list, ticks, self.rule
        )
        if contacts is None:
            return False
        if cradle.hand.held is None:
            for tick, *contact in contacts:
                self.motion.note_hit(self.motion.ticks + tick + 1, *contact)
        self.motion.ticks += ticks
        return True

    def end_part(self) -> None:
        """Look at the result of a part."""
        self.is_in_part = False
        self.cradle.hits.stop()
        self.cradle.hand.put_back()
        self.cradle.check()
        if self.motion.ticks % self.step == 0:
            self.note()


def run(loop, player) -> None:
    """Run a loop (for instance main) once for each cradle; raises a MistakeError if it ends while
    one must go on.
    """
    import_now("pandas")  # not in a student's function, which has no part in the time that it takes
    player.loop = loop
    player.want_cradle()
    try:
        while player.is_wanted:
            player.begin()
            loop(player)
            if not player.is_shown:
                raise MistakeError(loop, "showed no cradle: page.show(pend_list) is missing.")
            if not (player.is_wanted or player.is_over):
                raise MistakeError(
                    loop,
                    "ended, but the simulation still runs. Tick while page.is_running() is True.",
                )
    except KeyboardInterrupt as stopped:
        stopped.is_late = player.pace.clock() - player.pace.frame_start > ENDLESS  # type: ignore[attr-defined]
        raise
    finally:
        player.cradle.hits.stop()
        player.copy.close()
