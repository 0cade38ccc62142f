"""The double Newton's cradle in the browser: the program to play with."""

import sys
from pathlib import Path

if __name__ == "__main__":  # started as a file, from any folder: the project's own modules are one folder up
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from support.interrupt import end_on_interrupt

    end_on_interrupt()  # the imports below take a moment, in which Ctrl+C would print a traceback

from src.live_double_cradle import LiveDoubleCradle
from support.options import read_double_page_options
from support.page import show_cradle
from support.unwritten import end_if_unwritten


def main() -> None:
    """Show a double cradle in the browser until the tab is closed; status 2 if an option or the CSV is refused, or a
    function is not written yet.
    """
    options = read_double_page_options()
    end_if_unwritten("pds_helper", "special_cradles", "double_cradle")
    show_cradle(LiveDoubleCradle(options), options, [options.angle, options.phi])


if __name__ == "__main__":
    main()
