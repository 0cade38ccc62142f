"""The player tells a program's loop when to make a cradle or do a tick, and shows the cradle.

The loop is main in src/visualize_cradle_run.py. A player is the cradle's page in the browser (support/page/viewer.py),
or its picture, its lines or its data file (support/terminal/players.py, support/terminal/recorder.py).
"""

from collections.abc import Callable, Iterator
from math import inf

from support.files.cradle_csv import clean_copy
from support.playback.cradle import Cradle
from support.playback.mistake import MistakeError
from support.playback.motion import Motion
from support.playback.real_time import RealTime

GRIP = 10  # ticks after which a held bob is put back; in this time it falls by less than 0.01 degrees


class Player:
    """Answers the loop's questions, and keeps the motion of the cradle.

    A subclass has the script: a generator that yields whenever the loop must make a cradle or do ticks.
    """

    loop: Callable  # the loop, which asks; run sets it

    def __init__(self, cradle: Cradle, csv, angles, lifted, impacts):
        """Play the cradle of this CSV (a Snapshot); keep the last `impacts` trains of impacts.

        angles (rad) are the release angles, lifted is the number of bobs to lift. None keeps the value with which main
        makes the cradle.
        """
        self.cradle, self.snapshot = cradle, csv
        self.angles, self.lifted = list(angles), lifted
        self.motion, self.pace = Motion(cradle, impacts), RealTime(cradle.dt)
        self.separating = False
        self.at_once = False  # whether to do many ticks in one call, if the result is certain to be the same
        self.was_at_once = False  # whether the last ticks were done in one call
        self.step = inf  # ticks from one call of note to the next
        self.csv = ""
        self.is_wanted, self.due = False, 0
        self.offered = 0  # the ticks that were due when is_running last returned
        self.requests = self.script()

    def script(self) -> Iterator[None]:
        """Do the player's work; yield when the loop must make a cradle or do ticks."""
        raise NotImplementedError

    # --- what the loop asks ------------------------------------------------------------------------------------------

    def is_running(self) -> bool:
        """Return whether the simulation runs; wait until the loop has something to do."""
        if self.is_wanted:
            raise MistakeError(self.loop, "showed no cradle when page.wants_cradle() was True: page.show is missing.")
        if self.due and self.due == self.offered:
            raise MistakeError(self.loop, "did not call page.wants_tick() when ticks were due.")
        if not self.due:
            next(self.requests, None)
        self.offered = self.due
        return self.is_wanted or self.due > 0

    def wants_cradle(self) -> bool:
        """Return whether the loop must make a cradle from the file at the path csv, and show it."""
        return self.is_wanted

    def show(self, pend_list) -> None:
        """Take the pendula of a new cradle; raises a MistakeError if pend_list is no list of complete pendula."""
        self.cradle.take(pend_list, self.csv)
        self.is_wanted = False

    def wants_tick(self) -> bool:
        """Return whether a tick is due."""
        if self.cradle.hits:
            self.motion.note_hits()
        if not self.due:
            return False
        self.due -= 1
        self.motion.ticks += 1
        return True

    @property
    def separating(self) -> bool:
        """Whether separating bobs collide, too; rule has the keyword for the tick, if the tick takes it."""
        return not self.rule.get("approaching_only", False)

    @separating.setter
    def separating(self, separating) -> None:
        self.rule = {"approaching_only": not separating} if self.cradle.takes_rule else {}

    # --- parts of scripts --------------------------------------------------------------------------------------------

    def make(self) -> Iterator[None]:
        """Let the loop make a new cradle, release it, and begin at time 0."""
        self.cradle.give_back()
        with clean_copy(self.snapshot) as self.csv, self.cradle.reading_once():
            self.is_wanted = True
            yield
        self.cradle.release(self.angles, self.lifted)
        self.motion.restart()

    def collide(self, collision) -> None:
        """Set how bobs collide from now on (a key of the cradle's collisions)."""
        with clean_copy(self.snapshot) as csv, self.cradle.reading_once():
            self.cradle.collide(collision, csv)

    def advance(self, ticks) -> Iterator[None]:
        """Do `ticks` ticks, in the loop or in one call; call note at each multiple of step ticks from the start."""
        for part in self.motion.parts(ticks, self.longest_part()):
            with self.cradle.held_still():
                self.was_at_once = self.at_once and self.motion.do_at_once(part, self.rule)
                if not self.was_at_once:
                    with self.cradle.noting_hits():
                        self.due = part
                        yield
            self.cradle.check()
            if self.motion.ticks % self.step == 0:
                self.note()

    def longest_part(self) -> float:
        """Return the number of ticks after which advance looks at the cradle."""
        return self.step if self.cradle.held is None else GRIP

    def keep_time(self, most=inf) -> Iterator[None]:
        """Do the ticks that are due by the clock, but at most `most`; in one call if single ticks take too long.

        With a thousand pendula, such a call costs as much for one tick as a hundred ticks more. In each frame, a slow
        machine therefore does a whole part: if it took the cost of a call for that of a tick, it would do one tick.
        """
        least = self.motion.left(self.longest_part()) if self.was_at_once else 1
        ticks = min(self.pace.due(least), most)
        if ticks:
            yield from self.advance(ticks)
            self.pace.did(ticks)
        self.at_once = self.at_once or self.pace.is_too_slow()

    def note(self) -> None:
        """Show or record this moment; a subclass may define this."""


def run(loop, player) -> None:
    """Run a loop (for instance main) with a player; raises a MistakeError if the loop ends before the player."""
    player.loop = loop
    loop(player)
    if player.is_wanted or player.is_running():
        raise MistakeError(loop, "ended, but the simulation still runs.")
