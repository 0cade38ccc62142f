"""The cradle in the terminal: a picture that moves, or lines to be read out."""

import os
import sys
from math import degrees, inf, pi, remainder

from support.playback.player import Player, run
from support.terminal.picture import TextPicture
from support.terminal.screen import own_screen, screen, TRAINS, WIDTH

PICTURE = 1 / 20  # s from picture to picture
LINE = 0.5  # s from line to line


def has_terminal() -> bool:
    """Return whether there is a terminal that can show pictures. IDLE's shell says that it is one, and cannot."""
    return sys.stdout.isatty() and sys.stdout is sys.__stdout__ and os.environ.get("TERM") != "dumb"


class TextPlayer(Player):
    """Plays a cradle in step with the clock, and shows it at the start, after each step (s), and at the end."""

    step_seconds: float

    def __init__(self, cradle, csv, options):
        """Play the cradle of this CSV (a Snapshot); options has angle, lift and seconds, as the options of main do."""
        super().__init__(cradle, csv, [options.angle], options.lift, TRAINS)
        self.step = max(1, round(self.step_seconds / cradle.dt))
        self.last = options.seconds if options.seconds == inf else round(options.seconds / cradle.dt)  # tick

    def script(self):
        """Play the cradle from its start to its end."""
        yield from self.make()
        yield from self.play()

    def play(self):
        """Play the cradle that is there to its end."""
        self.note()
        self.pace.restart()
        while self.motion.ticks < self.last:
            yield from self.keep_time(self.last - self.motion.ticks)
            self.pace.rest()
        if self.last % self.step:
            self.note()


# --- on a terminal ---------------------------------------------------------------------------------------------------


class Pictures(TextPlayer):
    """Shows the cradle as a picture that moves."""

    step_seconds = PICTURE

    def __init__(self, cradle, csv, options, remark=""):
        """The remark, if there is one, stands above the picture; for the rest see TextPlayer."""
        super().__init__(cradle, csv, options)
        self.picture, self.remark = TextPicture(), remark
        self.seen: list[str] = []

    def note(self) -> None:
        """Show a picture."""
        # To the top left corner; clear each line, and in the end what is below.
        lines = screen(self.motion, self.picture, self.pace.remark(), self.remark)
        text = "\n".join("\x1b[K" + line for line in lines)
        self.seen = lines  # before it is shown: Ctrl+C is often pressed just when it is
        print(f"\x1b[H{text}\x1b[J", end="", flush=True)


def show_pictures(loop, player) -> None:
    """Let the loop run with a player of Pictures, and leave the last one on the screen."""
    try:
        with own_screen():
            run(loop, player)
    finally:
        print("\n".join(player.seen))


# --- without one -----------------------------------------------------------------------------------------------------


class Lines(TextPlayer):
    """Prints a line every half second."""

    step_seconds = LINE

    def note(self) -> None:
        """Print a line."""
        print(summary(self.motion), flush=True)
        self.motion.trains.clear()


def summary(motion) -> str:
    """Return a line: the time, the energy, how far the highest pendulum is to which side, and the latest hits."""
    angles = [degrees(remainder(theta, 2 * pi)) for theta in motion.cradle.thetas()]
    number, angle = max(enumerate(angles, start=1), key=lambda numbered: abs(numbered[1]))
    total = motion.in_percent(sum(motion.cradle.energies())).strip()
    side = "left" if angle < 0 else "right"
    line = f"t = {motion.time():.2f} s, energy {total}, pendulum {number} at {abs(angle):.0f} degrees {side}"
    impacts = f", hits {', '.join(reversed(motion.trains.runs()))}" if motion.trains.runs() else ""
    return line + (impacts if len(line + impacts) <= WIDTH else ", many hits")
