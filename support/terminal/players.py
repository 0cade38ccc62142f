"""Show the cradle in the terminal: as a moving picture, or as lines of text."""

import os
import sys
from math import degrees, inf, pi, remainder

from support.playback.motion import in_words
from support.playback.player import Player, run
from support.terminal.picture import TextPicture
from support.terminal.screen import own_screen, screen, TRAINS, WIDTH

PICTURE = 1 / 20  # s from picture to picture
LINE = 0.5  # s from line to line


def has_terminal() -> bool:
    """Return whether the output is a terminal that can show pictures. IDLE's shell claims to be one, but cannot."""
    return sys.stdout.isatty() and sys.stdout is sys.__stdout__ and os.environ.get("TERM") != "dumb"


class TextPlayer(Player):
    """Plays a cradle in step with the clock, and shows it at the start, every step_seconds, and at the end."""

    step_seconds: float

    def __init__(self, cradle, csv, options):
        """Play the cradle of this CSV (a Snapshot); options has angle, lift and seconds, from read_text_options."""
        super().__init__(cradle, csv, [options.angle], options.lift, TRAINS)
        self.step = max(1, round(self.step_seconds / cradle.dt))
        self.last = options.seconds if options.seconds == inf else round(options.seconds / cradle.dt)  # tick

    def script(self):
        """Play the cradle from its start to its end."""
        yield from self.make()
        yield from self.play()

    def play(self):
        """Play the present cradle to its end."""
        self.note()
        self.pace.restart()
        while self.motion.ticks < self.last:
            yield from self.keep_time(self.last - self.motion.ticks)
            self.pace.rest()
        if self.last % self.step:
            self.note()


# --- on a terminal ---------------------------------------------------------------------------------------------------


class Pictures(TextPlayer):
    """Shows the cradle as a moving picture."""

    step_seconds = PICTURE

    def __init__(self, cradle, csv, options, remark=""):
        """Show the remark, if there is one, above the picture; for the other arguments, see TextPlayer."""
        super().__init__(cradle, csv, options)
        self.picture, self.remark = TextPicture(), remark
        self.seen: list[str] = []

    def note(self) -> None:
        """Show a picture."""
        # Go to the top left corner; clear each line, and at the end all lines below.
        lines = screen(self.motion, self.picture, self.pace.remark(), self.remark)
        text = "\n".join("\x1b[K" + line for line in lines)
        self.seen = lines  # before print: Ctrl+C often comes during it
        print(f"\x1b[H{text}\x1b[J", end="", flush=True)


def show_pictures(loop, player) -> None:
    """Run the loop with player (Pictures), and leave the last picture on the screen."""
    with own_screen(lambda: player.seen):
        run(loop, player)


# --- without a terminal ----------------------------------------------------------------------------------------------


class Lines(TextPlayer):
    """Prints a line every half second."""

    step_seconds = LINE

    def note(self) -> None:
        """Print a line."""
        print(summary(self.motion), flush=True)
        self.motion.trains.clear()


def summary(motion) -> str:
    """Return a line: the time, the energy, the angle and side of the highest pendulum, and the latest hits."""
    angles = [degrees(remainder(theta, 2 * pi)) for theta in motion.cradle.thetas()]
    number, angle = max(enumerate(angles, start=1), key=lambda numbered: abs(numbered[1]))
    total = in_words(motion.percents()["energy"]).strip()
    side = "left" if angle < 0 else "right"
    line = f"t = {motion.time():.2f} s, energy {total}, pendulum {number} at {abs(angle):.0f} degrees {side}"
    trains = motion.trains.trains
    impacts = f", hits: {', '.join(map(str, trains))}" if trains else ""
    return line + (impacts if len(line + impacts) <= WIDTH else ", many hits")
