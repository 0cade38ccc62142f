"""Newton's cradle in the terminal: as moving text, as lines of text, or as data in a file.

Needs no VPython.
"""

if __name__ == "__main__":
    import os
    import sys

    sys.path.insert(0, os.path.realpath(f"{sys.argv[0]}/../.."))  # the project's folder
    from support.start import program

    program.begin(needs_vpython=False)

import sys

from src import special_cradles
from src.visualize_cradle_run import main as cradle_main
from support.cradle.cradle import Cradle
from support.cradle.many_ticks import many_ticks
from support.cradle.player import run
from support.files.cradle_csv import require_cradle, Snapshot
from support.files.data_file import require_replaceable
from support.start.early import stop_on_signals
from support.start.mistake import own_frames, report_endless_loop, report_mistake
from support.start.options import read_text_options, require_lifted
from support.start.output import complain, is_unread, refuse, while_it_is_read
from support.start.preview import what_there_is
from support.terminal.players import has_terminal, Lines, own_screen, Pictures, record


@while_it_is_read()
def main() -> None:
    """Show the cradle of src/visualize_cradle_run.py, or record its data.

    Exits with status 2 if an option, the CSV, the data file or the output is wrong, or if functions
    for a cradle are missing; with status 1 if a function makes a mistake, or a signal ends a
    recording; else stop_on_signals has it.
    """
    options = read_text_options()
    csv = Snapshot(options.csv)
    try:
        require_cradle(csv)
        require_lifted(options.lift, csv)
        if options.record:
            require_replaceable(options.record)
    except ValueError as error:
        refuse(error)
    cradle = Cradle(cradle_main, special_cradles, options, many_ticks)
    loop, remark = what_there_is(cradle_main, cradle)

    try:
        stop_on_signals()
        if options.record:
            record(loop, cradle, csv, options, remark)
        elif has_terminal():
            pictures = Pictures(cradle, csv, options, remark)
            with own_screen(lambda: pictures.seen):
                run(loop, pictures)
        else:
            run(loop, Lines(cradle, csv, options, remark))
    except KeyboardInterrupt as stopped:
        report_endless_loop(stopped)
        if options.record is None:
            sys.exit(*stopped.args)
        words = "The recording ended too early."
        if options.record != "-":
            words += f" {options.record} is not written."
        complain(words)
        sys.exit(1)
    except (Exception, SystemExit) as error:
        # whole_file replaces every OSError, also one of a student's function
        cause = error.__cause__ or error
        if is_unread(error) or isinstance(error, OSError) and not own_frames(cause):
            raise  # while_it_is_read ends the program
        report_mistake(cause)
        sys.exit(1)


if __name__ == "__main__":
    main()
