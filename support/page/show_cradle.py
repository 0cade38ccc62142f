"""Run the page in the browser, from the start of its server until you close the last tab."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from ipaddress import ip_address
from subprocess import list2cmdline
from types import ModuleType
from typing import TYPE_CHECKING

from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.player import PLAYER_FILE, run
from support.files.cradle_csv import LiveFile, Snapshot
from support.files.experiments import read_experiment
from support.files.ghosts import read_ghosts
from support.files.valid_cradle import read_cradle
from support.main_page import Loop
from support.root import SRC
from support.start.end import ended_quietly, SignalError
from support.start.mistake import report_endless_loop, report_mistake
from support.start.options import (
    read_double_page_options,
    read_page_options,
    require_lifted,
)
from support.start.output import refuse
from support.start.preview import end_if_unwritten, what_there_is

if TYPE_CHECKING:
    from support.page.server.server import Server
    from support.page.viewer import Start

GOODBYE = 10.0  # s that the page has to fetch the last message
UPPER_ONLY = (
    "Only upper bobs collide, and as if nothing hung from them. So each hit changes the energy."
)


@ended_quietly()
def show_cradle(
    main: Loop, special_cradles: ModuleType, many_ticks: ModuleType | None = None
) -> None:
    """Show the cradle of main in the browser until the tab is closed.

    special_cradles is the handout's module, many_ticks is the module of the fast path, or None.
    While functions are missing, show the cradle without them. Exits with status 2 if an option or
    the CSV is wrong, or if there is nothing to show yet.
    """
    options = read_page_options()
    cradle = Cradle(main, special_cradles, options, many_ticks)
    loop, remark = what_there_is(main, cradle)
    show_page(loop, cradle, options, [options.angle], remark)


@ended_quietly()
def show_double_cradle(main: Loop, special_cradles: ModuleType) -> None:
    """Show the double cradle of main in the same way.

    Exits with status 2 while a function is missing.
    """
    options = read_double_page_options()
    end_if_unwritten(
        "pds_helper", "special_cradles", "double_cradle", "visualize_double_cradle_run"
    )
    cradle = DoubleCradle(main, special_cradles, options)
    remark = UPPER_ONLY if cradle.collide_name == "handle_two_bobs" else ""
    show_page(main, cradle, options, [options.angle, options.phi], remark)


def show_page(
    loop: Loop,
    cradle: Cradle,
    options: Namespace,
    angles: Sequence[float | None],
    remark: str,
) -> None:
    """Run the loop of a program with the page of a cradle, until the last tab is closed for good.

    angles are the release angles (rad); None keeps the angle with which main makes the cradle.
    remark is a line on the page. With --html or --html-all, write files in place of it. Exits with
    status 2 if an option, or a file that it names, is wrong, with 1 if a function makes a mistake.
    """
    file = LiveFile(options.csv)
    ghosts = None
    experiment = None
    server = None
    try:
        # Here, because later mistakes in the file appear only on the page.
        csv = read_cradle(file.current, len(angles))
        require_lifted(options.lift, csv)
        if options.ghosts is not None:
            ghosts = read_ghosts(Snapshot(options.ghosts), cradle.angle_keys)
        if options.experiment is not None:
            experiment = read_experiment(options.experiment, len(angles))
        if options.html is None and options.html_all is None:
            server = open_page(options)
    except ValueError as error:
        refuse(error)
    from support.page.viewer import Start  # while the browser starts

    start = Start(csv, file, angles, options.lift, remark, experiment, ghosts)
    if server:
        play(loop, cradle, start, server)
        return
    from support.page.film_recorder import write_all_runs, write_run  # not for a page

    if options.html is not None:
        write_run(loop, cradle, start, options.seconds, options.html)
    else:
        write_all_runs(loop, cradle, start, options.seconds, options.html_all)


def play(loop: Loop, cradle: Cradle, start: "Start", server: "Server") -> None:
    """Run the loop until the last tab is closed; exit with status 1 if a function fails."""
    from support.page.endless import Watch
    from support.page.viewer import Viewer

    viewer = Viewer(cradle, start, server.tabs)
    watch = Watch(viewer.progress, lambda words: server.tabs.tell({"endless": words}))
    watch.start()
    try:
        run(loop, viewer)
    except SignalError as stopped:
        report_endless_loop(stopped, PLAYER_FILE)
        server.close()
        raise
    except BaseException as error:
        ended = report_mistake(error, PLAYER_FILE)
        server.tabs.show({"remark": viewer.given_remark, "ended": ended})
        server.tabs.is_seen.wait(GOODBYE)  # the browser may be on its way
        server.close(GOODBYE)
        sys.exit(1)
    finally:
        watch.stop()
    server.close()


def open_page(options: Namespace) -> "Server":
    """Return the Server of the page, and start a browser, unless --no-browser is given.

    Raises listen's ValueErrors.
    """
    # Not earlier: it needs packages that come with VPython.
    from support.page.names import Texts
    from support.page.server.port import listen
    from support.page.server.server import Server

    again = list2cmdline([sys.executable, *sys.argv])
    terminal = list2cmdline([sys.executable, str(SRC / "text_cradle_run.py")])
    texts: Texts = {"command": again, "terminal": terminal}
    server = Server(listen(options.host, options.port), texts)
    print(f"Newton's cradle is at {server.address()}")
    if not ip_address(server.listener.getsockname()[0]).is_loopback:
        print(
            "Every machine that reaches this one can open it, at this one's name, "
            "with the same port and key."
        )
    print(
        "Open it yourself if no browser shows it. To end, press Ctrl+C or close the tab.",
        flush=True,
    )
    if options.browser:
        server.browser_start.open(server.address())
    return server
