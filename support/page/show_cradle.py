"""Run the page in the browser, from the start of its server until you close the last tab."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from functools import partial
from ipaddress import ip_address
from pathlib import Path
from subprocess import list2cmdline
from typing import TYPE_CHECKING

from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.player import PLAYER_FILE, run_for_each_cradle
from support.files.cradle_csv import LiveFile, Snapshot
from support.files.experiments import read_experiment
from support.files.valid_cradle import read_cradle, with_options
from support.page.ghost_file import GhostFile
from support.start.end import ended_quietly, is_in_session, SignalError
from support.start.mistake import report_endless_loop
from support.start.options import (
    read_double_page_options,
    read_page_options,
    require_lifted,
)
from support.start.output import refuse

if TYPE_CHECKING:
    from support.page.server.server import Server
    from support.page.viewer import FirstCradle


DOUBLE_PROGRAM = "visualize_double_cradle_run.py"


@ended_quietly()
def show() -> None:
    """Run the started file in the browser, again for each cradle, until the last tab is closed.

    DOUBLE_PROGRAM makes a double cradle. Exits with status 2 if an option or the CSV is wrong.
    """
    file = Path(str(sys.modules["__main__"].__file__)).resolve()
    if file.name == DOUBLE_PROGRAM:
        options = read_double_page_options()
        show_page(file, DoubleCradle(), options, [options.angle, options.phi])
    else:
        options = read_page_options()
        show_page(file, Cradle(), options, [options.angle])


def show_page(
    file: Path, cradle: Cradle, options: Namespace, angles: Sequence[float | None]
) -> None:
    """Run a program, this file, with the page of a cradle, until the last tab is closed for good.

    angles are the release angles (rad); None keeps the angle with which the program makes the
    cradle. With --html or --html-all, write files in place of a page.
    """
    prepare = partial(with_options, options=options)
    live_file = LiveFile(options.csv)
    ghost_file = GhostFile()
    experiment = None
    server = None
    try:
        # Here, because later mistakes in the file appear only on the page.
        csv = read_cradle(live_file.current)
        require_lifted(options.lift, csv)
        if options.ghosts is not None:
            ghost_file.read(Snapshot(options.ghosts))
        if options.experiment is not None:
            experiment = read_experiment(options.experiment, len(angles))
        if options.html is None and options.html_all is None:
            server = make_server(options)
    except ValueError as error:
        refuse(error)
    try:
        if server:
            announce(server, options.browser)
        from support.page.viewer import FirstCradle  # while the browser starts

        first = FirstCradle(
            prepare(csv), live_file, prepare, angles, options.lift, ghost_file, experiment
        )
        if server:
            run_with_page(file, cradle, first, server)
        else:
            write(file, cradle, first, options)
    finally:
        if server:
            server.close()
            if server.tabs.are_gone:
                print("No page is open any more, so the program ends.")


def run_with_page(file: Path, cradle: Cradle, first: "FirstCradle", server: "Server") -> None:
    """Run a program until the last tab is closed."""
    from support.page.endless import Watch
    from support.page.viewer import Viewer

    viewer = Viewer(cradle, first, server.tabs)
    watch = Watch(viewer.progress, server.tabs.tell, viewer.look_at_source)
    watch.start()
    try:
        run_for_each_cradle(file, viewer)
    except SignalError as stopped:
        report_endless_loop(stopped, PLAYER_FILE)
        raise
    finally:
        watch.stop()
        if is_in_session():  # the prompt has the names of the last run
            vars(sys.modules["__main__"]).update(viewer.names)


def write(file: Path, cradle: Cradle, first: "FirstCradle", options: Namespace) -> None:
    """Write films to files, as the options say."""
    # Not for a page
    from support.page.film_recorder import FilmRecorder, write_all_films, write_films

    recorder = FilmRecorder(cradle, first, options.seconds)
    if options.html is not None:
        write_films(file, recorder, [options.html], options.html)
    else:
        write_all_films(file, recorder, options.html_all)


def make_server(options: Namespace) -> "Server":
    """Return the Server of the page; raises listen's ValueErrors."""
    # Not earlier: it needs packages that come with VPython.
    from support.page.names import Texts
    from support.page.server.port import listen
    from support.page.server.server import Server

    again = list2cmdline([sys.executable, *sys.argv])
    texts: Texts = {"command": again, "csv": Path(options.csv).name}
    return Server(listen(options.host, options.port), texts)


def announce(server: "Server", opens_browser: bool) -> None:
    """Say where the page is, and start a browser, if it is to open one."""
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
    if opens_browser:
        server.browser_start.open(server.address())
