"""Newton's cradle in the terminal: as moving text, as lines to be read out, or as data in a file. Needs no VPython."""

import os
import shutil
import signal
import sys
import time
from contextlib import contextmanager
from math import degrees, inf
from pathlib import Path

if __name__ == "__main__":  # started as a file, from any folder: the project's own modules are one folder up
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from support.page import end_on_interrupt

    end_on_interrupt()  # the imports below take a moment, in which Ctrl+C would print a traceback

from support import headless_vpython

headless_vpython.install()  # nothing is shown in a browser, so VPython itself is not needed

from src.live_cradle import LiveCradle
from src.visualize_cradle_run import advance_cradle
from support.cradle_csv import Snapshot
from support.impacts import shortened
from support.motion import Motion
from support.options import check_lift, read_text_options
from support.real_time import RealTime
from support.recording import check_record, write_data
from support.text_picture import TextPicture

PICTURE = 1 / 20  # s from picture to picture
LINE = 0.5  # s from line to line
WIDTH = 80  # columns that are used, where there are as many
IMPACTS = 4  # lines of the contact strip
PATIENCE = 2.0  # s, after which a bar shows the progress


def main() -> None:
    """Show a cradle, or record its data; status 2 if an option, the CSV or the file to be written is refused."""
    options = read_text_options()
    cradle = LiveCradle(advance_cradle, options)
    try:
        cradle.load(Snapshot(options.csv))
        check_lift(options.lift, cradle.csv)
        if options.record:
            check_record(options.record)
    except ValueError as error:
        refuse(error)
    cradle.release([options.angle], options.lift)
    motion = Motion(cradle, IMPACTS)

    for name in {"SIGINT", "SIGTERM", "SIGHUP"} & set(dir(signal)):  # not every system has all of them
        signal.signal(getattr(signal, name), signal.default_int_handler)
    try:
        if options.record:
            record(motion, options)
        elif sys.stdout.isatty() and os.environ.get("TERM") != "dumb":
            show_pictures(motion, options.seconds)
        else:
            tell_lines(motion, options.seconds)
    except KeyboardInterrupt:
        if options.record:
            print(f"Ended before it was complete: {options.record} is not written.", file=sys.stderr)
            sys.exit(1)
    except BrokenPipeError:  # nobody reads on, as after `| head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        refuse(f"{error.filename}: {error.strerror}")


def refuse(message) -> None:
    """End the program with this message, and status 2."""
    print(message, file=sys.stderr)
    sys.exit(2)


def play(motion, pace, seconds, step, show) -> None:
    """Let a cradle swing in step with the clock of pace (a RealTime), and call show() at the start, after each step (s)
    of simulated time, and at the end, after so many seconds.
    """
    last = seconds if seconds == inf else round(seconds / motion.cradle.dt)  # tick
    ticks_to_show = max(1, round(step / motion.cradle.dt))

    def advance(ticks):
        while ticks > 0 and motion.ticks < last:
            part = min(ticks, ticks_to_show - motion.ticks % ticks_to_show, last - motion.ticks)
            motion.advance(part)
            ticks -= part
            if motion.ticks % ticks_to_show == 0 or motion.ticks == last:
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
    lines: list[str] = []

    def show():
        lines[:] = page(motion, picture, pace.remark())
        # To the top left corner; after each line clear what is left of it, and below the last one everything.
        print("\x1b[H" + "\x1b[K\n".join([*lines, "", "Ctrl+C ends it."]) + "\x1b[J", end="", flush=True)

    try:
        with own_screen():
            play(motion, pace, seconds, PICTURE, show)
    finally:
        print("\n".join(lines))


@contextmanager
def own_screen():
    """Take a screen of one's own, without a cursor; afterwards the terminal is as it was."""
    if os.name == "nt":
        os.system("")  # older consoles then understand what moves the cursor
    print("\x1b[?1049h\x1b[?25l", end="")
    try:
        yield
    finally:
        print("\x1b[?25h\x1b[?1049l", end="", flush=True)


def page(motion, picture, remark) -> list[str]:
    """Return what is to be seen, line by line, for the terminal as large as it is at this moment."""
    size = shutil.get_terminal_size()
    columns = min(WIDTH, size.columns)
    rows = max(3, size.lines - IMPACTS - 6)  # what is left for the picture
    impacts = motion.trains.lines(columns)
    lines = [
        f"{motion.reading()}   {remark}",
        "",
        *picture.lines(motion.cradle, columns, rows),
        "",
        "Impacts",
        *impacts,
        *[""] * (IMPACTS - len(impacts)),
    ]
    return [line[:columns].rstrip() for line in lines]


# --- without one -----------------------------------------------------------------------------------------------------


def tell_lines(motion, seconds) -> None:
    """Print a line every half second."""

    def show():
        print(summary(motion), flush=True)
        motion.trains.clear()

    play(motion, RealTime(motion.cradle.dt), seconds, LINE, show)


def summary(motion) -> str:
    """Return a line: the time, the energy, how far the highest pendulum is to which side, and the latest impacts."""
    thetas = [theta for name, theta in motion.cradle.coordinates().items() if name.startswith("theta")]
    number, theta = max(enumerate(thetas, start=1), key=lambda numbered: abs(numbered[1]))
    total = motion.in_percent(sum(motion.cradle.energies())).strip()
    side = "left" if theta < 0 else "right"
    line = f"t = {motion.time():.2f} s, energy {total}, pendulum {number} at {abs(degrees(theta)):.0f} degrees {side}"
    runs = motion.trains.runs()
    return shortened(f"{line}, impacts {', '.join(reversed(runs))}" if runs else line, WIDTH)


# --- into a file -----------------------------------------------------------------------------------------------------


def record(motion, options) -> None:
    """Write the data of the next seconds to a file, as fast as the machine can."""
    count = int(options.seconds / options.every + 1e-9) + 1
    columns = list(motion.sample())
    write_data(options.record, columns, with_progress(samples(motion, options.every, count), count))
    print(f"{count} rows, from t = 0 to {motion.time():g} s, are in {options.record}")


def samples(motion, every, count):
    """Yield so many rows of data, the first at once, then one after each so many seconds of simulated time."""
    for number in range(count):
        motion.advance(round(number * every / motion.cradle.dt) - motion.ticks)
        yield motion.sample().values()


def with_progress(rows, count, clock=time.monotonic):
    """Yield these rows, so many; if that takes long, show on a terminal how far it is."""
    begin = clock()
    next_look = begin + PATIENCE
    try:
        for done, row in enumerate(rows, start=1):
            yield row
            if sys.stderr.isatty() and clock() > next_look:
                next_look = clock() + PICTURE
                left = (clock() - begin) * (count - done) / done
                bar = f"\r[{'#' * (40 * done // count):<40}] {done / count:4.0%}, {left:.0f} s left "
                print(bar, end="", file=sys.stderr, flush=True)
    finally:
        if next_look > begin + PATIENCE:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
