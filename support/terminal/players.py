"""Show the cradle in the terminal, as a moving picture or as lines of text, or write its data to a file."""

import os
import sys
from csv import writer
from math import degrees, inf, pi, remainder

from support.cradle.motion import in_words
from support.cradle.player import Player, run
from support.files.data_file import whole_file
from support.start.output import in_one_line
from support.terminal.screen import progress_bar, screen, TextPicture, TRAINS, WIDTH

PART = 1000  # ticks from one report of a recording's progress to the next


def has_terminal() -> bool:
    """Return whether the output is a terminal that can show pictures. IDLE's shell claims to be one, but cannot."""
    return sys.stdout.isatty() and sys.stdout is sys.__stdout__ and os.environ.get("TERM") != "dumb"


class TextPlayer(Player):
    """Plays a cradle in step with the clock, and shows it at the start, every step_seconds, and at the end."""

    step_seconds: float

    def __init__(self, cradle, csv, options):
        """Play the cradle of this CSV (a Snapshot); options has angle, lift and seconds, from read_text_options."""
        super().__init__(cradle, csv, [options.angle], options.lift, TRAINS, self.step_seconds)
        self.last = options.seconds if options.seconds == inf else round(options.seconds / cradle.dt)  # tick

    def show_new_cradle(self) -> None:
        self.note()
        self.pace.restart()

    def frame(self) -> None:
        """Rest, and plan the ticks that are due; at the end, show the cradle again."""
        self.is_over = self.motion.ticks >= self.last
        if not self.is_over:
            self.pace.rest()
            self.keep_time(self.last - self.motion.ticks)
        elif self.last % self.step:
            self.note()


class Pictures(TextPlayer):
    """Shows the cradle as a moving picture."""

    step_seconds = 1 / 20

    def __init__(self, cradle, csv, options, remark=""):
        """Show the remark, if there is one, above the picture; for the other arguments, see TextPlayer."""
        super().__init__(cradle, csv, options)
        self.picture, self.remark = TextPicture(), remark
        self.seen: list[str] = []  # the lines of the last picture

    def note(self) -> None:
        """Show a picture: go to the top left corner; clear each line, and at the end all lines below."""
        self.seen = screen(self.motion, self.picture, self.pace.remark(), self.remark)
        text = "\n".join("\x1b[K" + line for line in self.seen)
        print(f"\x1b[H{text}\x1b[J", end="", flush=True)


class Lines(TextPlayer):
    """Prints a line every half second."""

    step_seconds = 0.5

    def note(self) -> None:
        print(summary(self.motion), flush=True)
        self.motion.trains.clear()


def summary(motion) -> str:
    """Return a line: the time, the energy, the angle and side of the highest pendulum, and the latest hits."""
    angles = [degrees(remainder(theta, 2 * pi)) for theta in motion.cradle.values("theta")]
    number, angle = max(enumerate(angles, start=1), key=lambda numbered: abs(numbered[1]))
    total = in_words(motion.percents()["energy"]).strip()
    side = "left" if angle < 0 else "right"
    line = f"t = {motion.time():.2f} s, energy {total}, pendulum {number} at {abs(angle):.0f} degrees {side}"
    trains = motion.trains.trains
    impacts = f", hits: {', '.join(map(str, trains))}" if trains else ""
    return line + (impacts if len(line + impacts) <= WIDTH else ", many hits")


class Recorder(Player):
    """Writes a row of data for every options.every seconds of simulated time, as fast as the machine can."""

    def __init__(self, cradle, csv, options, writer, progress):
        """Write with a csv.writer; call progress(part), 0 to 1, again and again; options: from read_text_options."""
        super().__init__(cradle, csv, [options.angle], options.lift, 1, options.every)
        self.count = int(options.seconds / options.every + 1e-9) + 1  # rows
        self.last = (self.count - 1) * self.step  # tick
        self.writer, self.progress = writer, progress

    def show_new_cradle(self) -> None:
        self.writer.writerow(self.motion.sample())  # its names
        self.note()

    def frame(self) -> None:
        """Report the progress, and plan the next ticks."""
        self.is_over = self.motion.ticks >= self.last
        if self.motion.ticks:
            self.progress(self.motion.ticks / self.last)
        self.plan(min(PART, self.last - self.motion.ticks))

    def note(self) -> None:
        self.writer.writerow(self.motion.sample().values())


def record(loop, cradle, csv, options, remark="") -> None:
    """Write the data of options.seconds to the file options.record, whole or not at all."""
    with whole_file(options.record) as file, progress_bar() as progress:
        recorder = Recorder(cradle, csv, options, writer(file, lineterminator="\n"), progress)
        run(loop, recorder)
    print(remark, end="\n" if remark else "")
    print(in_one_line(f"{recorder.count} rows, from t = 0 to {recorder.motion.time():g} s, are in {options.record}"))
