"""Newton's cradle in the terminal: as moving text, as lines to be read out, or as data in a file. Needs no VPython."""

import os
import shutil
import signal
import sys
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

from src.live_cradle import LiveCradle
from src.visualize_cradle_run import advance_cradle
from support.cradle_csv import Snapshot
from support.motion import Motion
from support.options import check_lift, read_text_options
from support.output import spell_out_letters, while_it_is_read
from support.real_time import RealTime
from support.recording import check_record, write_data
from support.text_picture import TextPicture
from support.unwritten import end_if_unwritten

PICTURE = 1 / 20  # s from picture to picture
LINE = 0.5  # s from line to line
WIDTH = 80  # columns that are used, where there are as many
IMPACTS = 4  # lines of the contact strip
LOW = 18  # lines, and with fewer a terminal has room for the cradle only
PATIENCE = 2.0  # s, after which a bar shows the progress


def main() -> None:
    """Show a cradle, or record its data; status 2 if an option, the CSV or the file to be written is
    refused, or a function is not written yet.
    """
    spell_out_letters()
    options = read_text_options()
    end_if_unwritten("pds_helper", "special_cradles", "swinging", "visualize_cradle_run")
    cradle = LiveCradle(advance_cradle, options)
    try:
        cradle.load(Snapshot(options.csv))
        check_lift(options.lift, cradle.csv)
        if options.record is not None:
            check_record(options.record)
    except ValueError as error:
        refuse(error)
    cradle.release([options.angle], options.lift)
    motion = Motion(cradle, IMPACTS)

    try:
        stop_on_signals()
        with while_it_is_read():
            if options.record is not None:
                record(motion, options)
            elif has_terminal():
                show_pictures(motion, options.seconds)
            else:
                tell_lines(motion, options.seconds)
    except KeyboardInterrupt:
        if options.record is not None:
            print(f"Ended before it was complete: {options.record} is not written.", file=sys.stderr)
            sys.exit(1)
    except OSError as error:
        refuse(f"{error.filename or 'The output'}: {error.strerror}")


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


def play(motion, pace, seconds, step, show) -> None:
    """Let a cradle swing for so many seconds in step with the clock of pace (a RealTime).

    show() is called at the start, after each step (s) of simulated time, and at the end.
    """
    last = seconds if seconds == inf else round(seconds / motion.cradle.dt)  # tick
    step_ticks = max(1, round(step / motion.cradle.dt))

    def advance(ticks):
        for part in motion.parts(min(ticks, last - motion.ticks), step_ticks):
            motion.advance(part)
            if motion.ticks % step_ticks == 0 or motion.ticks == last:
                show()

    show()
    pace.restart()
    while motion.ticks < last:
        pace.frame(advance)
        pace.rest()


# --- on a terminal ---------------------------------------------------------------------------------------------------


def show_pictures(motion, seconds) -> None:
    """Show the cradle as a picture that moves, and leave the last one on the screen."""
    picture, pace = TextPicture(), RealTime(motion.cradle.dt)
    seen: list[str] = []

    def show():
        lines = screen(motion, picture, pace.remark())
        # To the top left corner; clear each line, and in the end what is below.
        text = "\n".join("\x1b[K" + line for line in lines)
        seen[:] = lines  # before it is shown: Ctrl+C is often pressed just when it is
        print(f"\x1b[H{text}\x1b[J", end="", flush=True)

    try:
        with own_screen():
            play(motion, pace, seconds, PICTURE, show)
    finally:
        print("\n".join(seen))


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


def screen(motion, picture, remark) -> list[str]:
    """Return what is to be seen, line by line, for the terminal as large as it is at this moment."""
    size = shutil.get_terminal_size()
    columns = min(WIDTH, size.columns)
    lines = [f"{motion.reading()}   {remark}", ""]
    if size.lines < LOW:
        lines += picture.lines(motion.cradle, columns, size.lines - 2)
    else:
        impacts = motion.trains.lines(columns)
        lines += picture.lines(motion.cradle, columns, size.lines - IMPACTS - 6)
        lines += ["", "Impacts", *impacts, *[""] * (IMPACTS - len(impacts)), "", "Ctrl+C ends it."]
    return [line[:columns].rstrip() for line in lines[: size.lines]]


# --- without one -----------------------------------------------------------------------------------------------------


def tell_lines(motion, seconds) -> None:
    """Print a line every half second."""

    def show():
        print(summary(motion), flush=True)
        motion.trains.clear()

    play(motion, RealTime(motion.cradle.dt), seconds, LINE, show)


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


def record(motion, options) -> None:
    """Write the data of the next seconds to a file, as fast as the machine can."""
    count = int(options.seconds / options.every + 1e-9) + 1
    with progress_bar() as progress:
        write_data(options.record, list(motion.sample()), rows(motion, options.every, count, progress))
    print(f"{count} rows, from t = 0 to {motion.time():g} s, are in {options.record}")


def rows(motion, every, count, progress):
    """Yield so many rows of data, the first at once, then one after each so many seconds of simulated time.

    progress(part) is told again and again how much is done.
    """
    between = round(every / motion.cradle.dt)  # ticks
    for number in range(count):
        for part in motion.parts(number * between - motion.ticks, 1000):
            motion.advance(part)
            progress(motion.ticks / between / (count - 1))
        yield motion.sample().values()


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
