"""Run the page in the browser, from the start of its server until you close the last tab."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from ipaddress import ip_address
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.player import run
from support.files.cradle_csv import LiveFile, Snapshot
from support.files.experiments import read_experiment
from support.files.ghosts import read_ghosts
from support.files.valid_cradle import read_cradle
from support.main_page import Loop
from support.root import ROOT
from support.start.commands import python_command
from support.start.early import end_on_signals
from support.start.mistake import report_endless_loop, report_mistake
from support.start.options import (
    read_double_page_options,
    read_page_options,
    require_lifted,
)
from support.start.output import refuse, say, while_it_is_read
from support.start.preview import end_if_unwritten, what_there_is

if TYPE_CHECKING:
    from support.page.server.server import Server
    from support.page.viewer import Viewer

GOODBYE = 10.0  # s that the page has to fetch the last message
UPPER_ONLY = (
    "Only upper bobs collide, and as if nothing hung from them. So each hit changes the energy."
)


@while_it_is_read()
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
    show_page(loop, cradle, options, [options.angle], remark or cradle.slow_remark())


@while_it_is_read()
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
            experiment = read_experiment(Path(options.experiment), len(angles))
        if options.html is None and options.html_all is None:
            server = open_page(options, python_command(ROOT / cradle.page_program, *sys.argv[1:]))
    except ValueError as error:
        refuse(error)
    from support.page.viewer import Start, Viewer  # while the browser starts

    start = Start(csv, file, angles, options.lift, remark, experiment, ghosts)
    if server:
        play(loop, Viewer(cradle, start, server.tabs), server)
        return
    from support.page.film_recorder import write_all_runs, write_run  # not for a page

    if options.html is not None:
        write_run(loop, cradle, start, options.seconds, options.html)
    else:
        write_all_runs(loop, cradle, start, options.seconds, options.html_all)


def play(loop: Loop, viewer: "Viewer", server: "Server") -> None:
    """Run the loop until the last tab is closed; exit with status 1 if a function fails."""
    from support.page.endless import Watch

    watch = Watch(viewer.progress, lambda words: server.tabs.tell({"endless": words}))
    watch.start()
    try:
        run(loop, viewer)
    except KeyboardInterrupt as stopped:  # in a session; else Ctrl+C has ended the process
        report_endless_loop(stopped)
    except BaseException as error:
        server.tabs.show({"remark": viewer.given_remark, "ended": report_mistake(error)})
        server.tabs.is_seen.wait(GOODBYE)  # the browser may be on its way
        server.close(GOODBYE)
        sys.exit(1)
    finally:
        watch.stop()
    server.close()


def open_page(options: Namespace, command: str) -> "Server":
    """Return the Server of the page, and start a browser, unless --no-browser is given.

    command starts this program again. Raises listen's ValueErrors.
    """
    # Not earlier: it needs packages that come with VPython.
    from support.page.names import Texts
    from support.page.server.port import listen
    from support.page.server.server import Server

    terminal = python_command(ROOT / "src" / "text_cradle_run.py")
    texts: Texts = {"command": command, "terminal": terminal}
    server = Server(listen(options.host, options.port), texts)
    say(f"Newton's cradle is at {server.address()}")
    if not ip_address(server.listener.getsockname()[0]).is_loopback:
        say(
            "Every machine that reaches this one can open it, at this one's name, "
            "with the same port and key."
        )
    say("Open it yourself if no browser shows it. To end, press Ctrl+C or close the tab.")
    end_on_signals(first=server.close)
    if options.browser:
        server.browser_start.open(server.address())
    return server
