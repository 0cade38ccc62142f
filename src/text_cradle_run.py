"""Newton's cradle in the terminal, a line each half second, or as data in a file.

Needs no VPython.
"""

if __name__ == "__main__":
    import begin

import sys

import support.headless_vpython  # first: it takes VPython's place
from support.cradle.cradle import Cradle
from support.cradle.player import PLAYER_FILE
from support.cradle.settings import Settings, settings_of
from support.files.cradle_csv import Snapshot
from support.files.experiments import read_experiment
from support.files.valid_cradle import read_cradle, with_options
from support.root import SRC
from support.start.end import ended_quietly, SignalError
from support.start.mistake import report_endless_loop, report_mistake, students_frames
from support.start.options import read_text_options, require_lifted
from support.start.output import refuse
from support.start.preview import UnwrittenError
from support.terminal.players import record, show

PROGRAM = SRC / "visualize_cradle_run.py"


@ended_quietly()
def main() -> None:
    """Print where the bobs of src/visualize_cradle_run.py are, or record the data.

    The exit status is 2 if an option or a file is wrong, or if functions for a cradle are missing;
    1 if a function makes a mistake, or if a signal ends a recording; else that of ended_quietly.
    """
    options = read_text_options()
    try:
        if options.experiment is None:
            csv = read_cradle(Snapshot(options.csv))
            require_lifted(options.lift, csv)
            settings = Settings(with_options(csv, options), [options.angle], options.lift)
        else:
            settings = settings_of(read_experiment(options.experiment, cords=1))
    except ValueError as error:
        refuse(error)

    play = record if options.record else show
    try:
        play(PROGRAM, Cradle(), settings, options)
    except SignalError as stopped:
        report_endless_loop(stopped, PLAYER_FILE)
        if options.record:
            sys.exit("The recording ended too early.")
        raise
    except UnwrittenError as error:
        refuse(error)
    except BrokenPipeError:  # maybe of a student's print
        raise
    except (Exception, SystemExit) as error:
        if isinstance(error, OSError) and not students_frames(error, PLAYER_FILE):
            raise  # ended_quietly names the file
        report_mistake(error, PLAYER_FILE)
        sys.exit(1)


if __name__ == "__main__":
    main()
