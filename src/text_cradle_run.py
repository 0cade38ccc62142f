"""Newton's cradle in the terminal, a line each half second, or as data in a file.

Needs no VPython.
"""

if __name__ == "__main__":
    import begin

import sys
from argparse import Namespace
from pathlib import Path
from typing import NoReturn

import support.headless_vpython  # first: it takes VPython's place
from src import special_cradles
from src.visualize_cradle_run import main as cradle_main
from support.cradle import many_ticks
from support.cradle.cradle import Cradle
from support.cradle.player import PLAYER_FILE
from support.cradle.settings import Settings, settings_of
from support.files.cradle_csv import Snapshot
from support.files.experiments import read_experiment
from support.files.valid_cradle import read_cradle
from support.start.end import ended_quietly, SignalError
from support.start.mistake import report_endless_loop, report_mistake, students_frames
from support.start.options import read_text_options, require_lifted
from support.start.output import complain, refuse
from support.start.preview import what_there_is
from support.terminal.players import record, show


@ended_quietly()
def main() -> None:
    """Print where the bobs of src/visualize_cradle_run.py are, or record the data.

    The exit status is 2 if an option, the CSV, the data file or the output is wrong, or if
    functions for a cradle are missing. It is 1 if a function makes a mistake, or if a signal ends a
    recording. Another program that a signal ends has the status of end.STATUSES.
    """
    options = read_text_options()
    cradle = Cradle(cradle_main, special_cradles, options, many_ticks)
    try:
        settings = settings_from(options, cradle)
    except ValueError as error:
        refuse(error)
    loop, remark = what_there_is(cradle_main, cradle)

    try:
        play = record if options.record else show
        play(loop, cradle, settings, options, remark or cradle.slow_remark())
    except SignalError as stopped:
        end_stopped(stopped, options.record)
    except BrokenPipeError:
        raise  # ended_quietly ends the program
    except (Exception, SystemExit) as error:
        end_failed(error)


def settings_from(options: Namespace, cradle: Cradle) -> Settings:
    """Return what options say: an experiment, or a CSV. Raises a ValueError with one line."""
    if options.experiment is not None:
        return settings_of(read_experiment(Path(options.experiment), cords=1))
    csv = read_cradle(Snapshot(options.csv))
    require_lifted(options.lift, csv)
    return Settings(csv, [options.angle], options.lift, cradle.e_source, cradle.mass)


def end_stopped(stopped: SignalError, record: str | None) -> NoReturn:
    """End the program after a signal; record is the file of a recording, or None."""
    report_endless_loop(stopped, PLAYER_FILE)
    if record is None:
        raise stopped
    message = "The recording ended too early."
    if record != "-":
        message += f" {record} is not written."
    complain(message)
    sys.exit(1)


def end_failed(error: BaseException) -> NoReturn:
    """Name the mistake of a function, and end the program; raise an error of the output again."""
    if isinstance(error, OSError) and not students_frames(error, PLAYER_FILE):
        raise error  # ended_quietly names the file
    report_mistake(error, PLAYER_FILE)
    sys.exit(1)


if __name__ == "__main__":
    main()
