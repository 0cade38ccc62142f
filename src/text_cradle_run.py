"""Newton's cradle in the terminal: as moving text, as lines to be read out, or as data in a file. Needs no VPython."""

import os
import shutil
import signal
import sys
import textwrap
import time
from contextlib import contextmanager, suppress
from math import degrees, inf, pi, remainder
from pathlib import Path

if __name__ == "__main__":  # started as a file, from any folder: the project's own modules are one folder up
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from support.interrupt import end_on_interrupt

    # The imports below take a moment, in which Ctrl+C would print a traceback.
    end_on_interrupt(status=1 if "--record" in " ".join(sys.argv) else 0)

from support import headless_vpython

headless_vpython.install()  # nothing is shown in a browser, so VPython itself is not needed

from src.beyond.live_cradle import LiveCradle
from src.beyond.many_ticks import many_ticks
from src.beyond.preview import what_there_is
from src.visualize_cradle_run import main as cradle_main
from support.cradle_csv import check_cradle, Snapshot
from support.mistake import own_frames, tell_mistake
from support.options import check_lift, read_text_options
from support.output import spell_out_letters, while_it_is_read
from support.player import Player, run
from support.recording import check_record, data_file
from support.text_picture import TextPicture

PICTURE = 1 / 20  # s from picture to picture
LINE = 0.5  # s from line to line
WIDTH = 80  # columns that are used, where there are as many
IMPACTS = 4  # lines of the contact strip
LOW = 18  # lines, and with fewer a terminal has room for the cradle only
PATIENCE = 2.0  # s, after which a bar shows the progress
PART = 1000  # ticks from one look at the progress to the next


def main() -> None:
    """Show the cradle of src/visualize_cradle_run.py, or record its data.

    Status 2 if an option, the CSV or the file for the data is refused, or too little is written for a cradle; 1 if a
    function makes a mistake.
    """
    spell_out_letters()
    options = read_text_options()
    loop, remark = what_there_is(cradle_main)
    csv = Snapshot(options.csv)
    try:
        check_cradle(csv)
        check_lift(options.lift, csv)
        if options.record is not None:
            check_record(options.record)
    except ValueError as error:
        refuse(error)
    cradle = LiveCradle(cradle_main.__globals__, options, many_ticks)

    try:
        stop_on_signals()
        with while_it_is_read():
            if options.record is not None:
                record(loop, cradle, csv, options, remark)
            elif has_terminal():
                show_pictures(loop, Pictures(cradle, csv, options, remark))
            else:
                print(remark, end="\n" if remark else "", flush=True)
                run(loop, Lines(cradle, csv, options))
    except KeyboardInterrupt:
        if options.record is not None:
            print(f"Ended before it was complete: {options.record} is not written.", file=sys.stderr)
            sys.exit(1)
    except (Exception, SystemExit) as error:
        cause = error.__cause__ or error  # whole_file says of every OSError that the file cannot be written
        if isinstance(error, OSError) and not own_frames(cause):
            refuse(f"{error.filename or 'The output'}: {error.strerror}")
        tell_mistake(cause)
        sys.exit(1)


def has_terminal() -> bool:
    """Return whether there is a terminal that can show pictures. IDLE's shell says that it is one, and cannot."""
    return sys.stdout.isatty() and sys.stdout is sys.__stdout__ and os.environ.get("TERM") != "dumb"


def refuse(message) -> None:
    """End the program with this message, and status 2."""
    print(message, file=sys.stderr)
    sys.exit(2)


def stop_on_signals() -> None:
    """Let Ctrl+C, a closed terminal and kill raise a KeyboardInterrupt, once: cleaning up is not interrupted again.

    A signal that was to be ignored from the start, as with nohup, still is. Windows has no signal for a closed
    terminal, but one for Ctrl+Break.
    """
    numbers = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name)]
    numbers = [number for number in numbers if signal.getsignal(number) != signal.SIG_IGN]

    def stop(*_):
        for number in numbers:
            signal.signal(number, signal.SIG_IGN)
        raise KeyboardInterrupt

    for number in numbers:
        signal.signal(number, stop)


class TextPlayer(Player):
    """Plays a cradle in step with the clock, and shows it at the start, after each step (s), and at the end."""

    step_seconds: float

    def __init__(self, cradle, csv, options):
        """Play the cradle of this CSV (a Snapshot); options has angle, lift and seconds, as the options of main do."""
        super().__init__(cradle, csv, [options.angle], options.lift, IMPACTS)
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
        """The remark, if there is one, stands below the picture; for the rest see TextPlayer."""
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


def switch_on_escapes() -> None:
    """Let an older console of Windows understand what moves the cursor."""
    if sys.platform == "win32":
        os.system("")


@contextmanager
def own_screen():
    """Take a screen of one's own, without a cursor; afterwards the terminal is as it was."""
    switch_on_escapes()
    print("\x1b[?1049h\x1b[?25l", end="")
    try:
        yield
    finally:
        print("\x1b[?25h\x1b[?1049l", end="", flush=True)


def screen(motion, picture, speed, remark="") -> list[str]:
    """Return what is to be seen, line by line, for the terminal as large as it is at this moment.

    speed is the remark about the speed, and remark the one about the cradle.
    """
    size = shutil.get_terminal_size()
    columns = min(WIDTH, size.columns)
    lines = [f"{motion.reading()}   {speed}", *textwrap.wrap(remark, columns), ""]
    rest = size.lines - len(lines)
    if size.lines < LOW:
        lines += picture.lines(motion.cradle, columns, rest)
    else:
        impacts = motion.trains.lines(columns)
        lines += picture.lines(motion.cradle, columns, rest - IMPACTS - 4)
        lines += ["", "Impacts", *impacts, *[""] * (IMPACTS - len(impacts)), "", "Ctrl+C ends it."]
    return [line[:columns].rstrip() for line in lines[: size.lines]]


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


# --- into a file -----------------------------------------------------------------------------------------------------


class Recorder(Player):
    """Writes a row of data after each so many seconds of simulated time, as fast as the machine can."""

    def __init__(self, cradle, csv, options, writer, progress):
        """Write by this writer (of data_file); progress(part) is told again and again how much is done.

        options has angle, lift, seconds and every, as the options of main do.
        """
        super().__init__(cradle, csv, [options.angle], options.lift, IMPACTS)
        self.at_once, self.step = True, round(options.every / cradle.dt)
        self.count = int(options.seconds / options.every + 1e-9) + 1  # rows
        self.writer, self.progress = writer, progress

    def script(self):
        """Write all rows, the first at once."""
        yield from self.make()
        self.writer.writerow(self.motion.sample())
        self.note()
        last = (self.count - 1) * self.step
        while self.motion.ticks < last:
            yield from self.advance(min(PART, last - self.motion.ticks))
            self.progress(self.motion.ticks / last)

    def note(self) -> None:
        """Write a row."""
        self.writer.writerow(self.motion.sample().values())


def record(loop, cradle, csv, options, remark="") -> None:
    """Write the data of the next seconds to a file, whole or not at all."""
    with data_file(options.record) as writer, progress_bar() as progress:
        recorder = Recorder(cradle, csv, options, writer, progress)
        run(loop, recorder)
    print(remark, end="\n" if remark else "")
    print(f"{recorder.count} rows, from t = 0 to {recorder.motion.time():g} s, are in {options.record}")


@contextmanager
def progress_bar(clock=time.monotonic):
    """Yield a function to be told how much is done, from 0 to 1; if it takes long, a terminal shows that."""
    begin = clock()
    next_look = begin + PATIENCE

    def progress(part):
        nonlocal next_look
        if clock() > next_look and sys.stderr.isatty():
            next_look = clock() + PICTURE
            left = (clock() - begin) * (1 - part) / part
            width = max(1, min(40, shutil.get_terminal_size().columns - 25))
            show_progress(f"\r[{'#' * int(part * width):<{width}}] {part:4.0%}, {left:.0f} s left ")

    try:
        yield progress
    finally:
        if next_look > begin + PATIENCE:
            switch_on_escapes()
            show_progress("\r\x1b[K")


def show_progress(text) -> None:
    """Write this to the terminal, if it is still there: the file does not depend on it."""
    with suppress(OSError):
        print(text, end="", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
