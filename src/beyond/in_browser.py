"""Start the programs with a page in the browser: read their options, and run the loop of their main."""

from src.beyond.live_cradle import LiveCradle
from src.beyond.live_double_cradle import LiveDoubleCradle
from src.beyond.preview import end_if_unwritten, what_there_is
from support.page.page import show_page
from support.start.options import read_double_page_options, read_page_options
from support.start.output import while_it_is_read


@while_it_is_read()
def show_cradle(main, many_ticks=None) -> None:
    """Show the cradle of main in the browser until the tab is closed.

    many_ticks is the fast path for many pendula, or None. While functions are missing, show the cradle without them.
    Exits with status 2 if an option or the CSV is wrong, or if there is nothing to show yet.
    """
    options = read_page_options()
    loop, remark = what_there_is(main)
    show_page(loop, LiveCradle(main.__globals__, options, many_ticks), options, [options.angle], remark)


@while_it_is_read()
def show_double_cradle(main) -> None:
    """Show the double cradle of main in the same way; exit with status 2 while a function is missing."""
    options = read_double_page_options()
    end_if_unwritten("pds_helper", "special_cradles", "double_cradle", "visualize_double_cradle_run")
    show_page(main, LiveDoubleCradle(main.__globals__, options), options, [options.angle, options.phi])
