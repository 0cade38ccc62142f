"""What stands between a program's loop and what it shows: it tells the loop when a cradle or a tick is wanted.

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

GRIP = 10  # ticks after which a bob that is held is put back; until then it falls by less than 0.01 degrees


class Player:
    """Answers the loop's questions, and keeps account of what the cradle does.

    A subclass has the script: a generator that comes to a yield wherever the loop must do something, a cradle or ticks.
    """

    loop: Callable  # the one that asks: run sets it

    def __init__(self, cradle: Cradle, csv, angles, lifted, impacts):
        """Play the cradle of this CSV (a Snapshot); so many trains of impacts are remembered.

        angles (rad) are the release angles, and lifted is the number of bobs to lift. None leaves it as the cradle is
        made.
        """
        self.cradle, self.snapshot = cradle, csv
        self.angles, self.lifted = list(angles), lifted
        self.motion, self.pace = Motion(cradle, impacts), RealTime(cradle.dt)
        self.separating = False
        self.at_once = False  # whether many ticks are done at once, where they are certain to do the same
        self.step = inf  # ticks from one call of note to the next
        self.csv = ""
        self.is_wanted, self.due = False, 0
        self.offered = 0  # the ticks that were due when the loop was last told that there is something to do
        self.requests = self.script()

    def script(self) -> Iterator[None]:
        """Do what the player does, and yield where a cradle is wanted, or ticks are due."""
        raise NotImplementedError

    # --- what the loop asks ------------------------------------------------------------------------------------------

    def is_running(self) -> bool:
        """Return whether the simulation runs; wait until there is something to do for the loop."""
        if self.is_wanted:
            raise MistakeError(self.loop, "was asked for a cradle, and showed none: page.show is missing.")
        if self.due and self.due == self.offered:
            raise MistakeError(self.loop, "was told that ticks are due, and did not ask page.wants_tick() for one.")
        if not self.due:
            next(self.requests, None)
        self.offered = self.due
        return self.is_wanted or self.due > 0

    def wants_cradle(self) -> bool:
        """Return whether a cradle must be made of the file at the path csv, and shown."""
        return self.is_wanted

    def show(self, pend_list) -> None:
        """Take the pendula of a new cradle; raises a MistakeError if they are none."""
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
        """Whether separating bobs collide, too; rule is the argument that tells the tick so, if it takes one."""
        return not self.rule.get("approaching_only", False)

    @separating.setter
    def separating(self, separating) -> None:
        self.rule = {"approaching_only": not separating} if self.cradle.takes_rule else {}

    # --- parts of scripts --------------------------------------------------------------------------------------------

    def make(self) -> Iterator[None]:
        """Have the cradle made anew, and begin at time 0."""
        self.cradle.give_back()
        with clean_copy(self.snapshot) as self.csv, self.cradle.reading_once():
            self.is_wanted = True
            yield
        self.cradle.release(self.angles, self.lifted)
        self.motion.restart()

    def collide(self, collision) -> None:
        """Let the cradle collide from now on in this way, one of its collisions."""
        with clean_copy(self.snapshot) as csv, self.cradle.reading_once():
            self.cradle.collide(collision, csv)

    def advance(self, ticks) -> Iterator[None]:
        """Have so many ticks done, and note each moment that is a multiple of step ticks from the start."""
        for part in self.motion.parts(ticks, self.step if self.cradle.held is None else GRIP):
            with self.cradle.held_still():
                if not (self.at_once and self.motion.do_at_once(part, self.rule)):
                    with self.cradle.noting_hits():
                        self.due = part
                        yield
            self.cradle.check()
            if self.motion.ticks % self.step == 0:
                self.note()

    def keep_time(self, most=inf) -> Iterator[None]:
        """Have the ticks done that are due by the clock, at most so many; at once, if single ones take too long."""
        ticks = min(self.pace.due(), most)
        if ticks:
            yield from self.advance(ticks)
            self.pace.did(ticks)
        self.at_once = self.at_once or self.pace.is_too_slow()

    def note(self) -> None:
        """Take note of this moment, if the player does that."""


def run(loop, player) -> None:
    """Let a loop such as main run with a player; raises a MistakeError if it ends before the player does."""
    player.loop = loop
    loop(player)
    if player.is_wanted or player.is_running():
        raise MistakeError(loop, "came to its end, but the simulation runs on.")
