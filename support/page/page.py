"""Run the page in the browser, from the start of VPython's servers until you close the tab or press Ctrl+C."""

import asyncio
import http.server
import importlib
import os
import signal
import sys
import threading
import webbrowser
from contextlib import contextmanager
from html import escape
from pathlib import Path

from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.player import run
from support.files.cradle_csv import check_cradle, LiveFile
from support.page.local_server import Access, page_sockets, page_websocket, PageServer, port_of
from support.start.early import end_on_interrupt, import_now
from support.start.mistake import tell_mistake
from support.start.options import check_lift, command_line, read_double_page_options, read_page_options
from support.start.output import refuse, say, while_it_is_read
from support.start.preview import end_if_unwritten, what_there_is

# The beginning of the page: its title, the check of the browser's WebGL, and the messages of a page without a cradle.
PAGE_HEAD = Path(__file__).with_name("page_head.html")

UPPER_ONLY = "Only upper bobs collide, and as if nothing hung from them. So each hit changes the energy."


@while_it_is_read()
def show_cradle(main, special_cradles, many_ticks=None) -> None:
    """Show the cradle of main in the browser until the tab is closed.

    special_cradles is the handout's module, many_ticks is the fast path, or None.
    While functions are missing, show the cradle without them. Exits with status 2 if an option or the CSV is wrong, or
    if there is nothing to show yet.
    """
    options = read_page_options()
    loop, remark = what_there_is(main)
    cradle = Cradle(main.__globals__, options, special_cradles, many_ticks)
    show_page(loop, cradle, options, [options.angle], remark)


@while_it_is_read()
def show_double_cradle(main, special_cradles) -> None:
    """Show the double cradle of main in the same way; exit with status 2 while a function is missing."""
    options = read_double_page_options()
    end_if_unwritten("pds_helper", "special_cradles", "double_cradle", "visualize_double_cradle_run")
    cradle = DoubleCradle(main.__globals__, options, special_cradles)
    names = main.__globals__["double_cradle_tick"].__code__.co_names
    show_page(main, cradle, options, [options.angle, options.phi], UPPER_ONLY if "handle_two_bobs" in names else "")


def show_page(main, cradle, options, angles, remark="") -> None:
    """Run main with the page of a cradle, until the tab is closed for good.

    angles are the release angles (rad); None keeps the angle with which main makes the cradle. remark is a line on the
    page. Exits with status 2 if the CSV, --lift or the port is wrong, with status 1 if a function makes a mistake.
    """
    file = LiveFile(options.csv)
    try:
        check_cradle(file.current, len(angles))  # here, because later mistakes in the file appear only on the page
        check_lift(options.lift, file.current)
        sockets = page_sockets(options.port)
    except ValueError as error:
        refuse(error)
    viewer = None
    try:
        open_page(sockets, cradle.title, options.browser, lambda: viewer and viewer.give("show again"))
        # This import needs VPython's canvas and widgets; the code above does not.
        from support.page.viewer import Viewer

        viewer = Viewer(cradle, file, angles, options.lift, remark)
        run(main, viewer)
    except BaseException as error:
        words = tell_mistake(error)
        if viewer:
            viewer.end(words)
    os._exit(1)  # VPython's threads would keep the process alive


def open_page(sockets, title, launch_browser, show_again) -> None:
    """Open VPython's page, with this title, at sockets, made by page_sockets, and wait for a browser.

    From then on, Ctrl+C and closing the tab end the process with status 0. Each time a browser loads the page,
    show_again() is called, in another thread.
    """
    port, access = port_of(sockets[0]), Access(show_again)
    address, browse = f"http://127.0.0.1:{port}/?key={access.key}", webbrowser.open
    os.environ["VPYTHON_HTTP_PORT"] = str(port)
    if not launch_browser:
        os.environ["VPYTHON_NO_LAUNCH_BROWSER"] = "1"
    head = PAGE_HEAD.read_text(encoding="utf-8")
    this_program = command_line(f"src/{Path(sys.argv[0]).name}", Path.cwd(), sys.argv[1:])
    terminal_cradle = command_line("src/text_cradle_run.py", Path.cwd())
    texts = {"TERMINAL_CRADLE": terminal_cradle, "THIS_PROGRAM": this_program, "PAGE_TITLE": title}
    for name, text in texts.items():
        head = head.replace(name, escape(text, quote=False))
    end_on_interrupt()

    def serve(_, handler):
        # From here on, Python waits for the browser to load the page. Not earlier: it would delay the server.
        threading.Thread(target=import_now, args=("pandas",), daemon=True).start()
        server = PageServer(sockets, access, head, handler)
        say(f"Newton's cradle is at {address}")
        say("Open it yourself if no browser opens. To end, press Ctrl+C or close the tab.")
        return server

    with (
        replaced(signal, "signal", lambda *_: None),
        replaced(http.server, "HTTPServer", serve),
        replaced(webbrowser, "open", lambda _: browse(address)),  # VPython's address has no key
        replaced(asyncio.BaseEventLoop, "create_server", page_websocket(sockets, access)),
        # On Windows, the usual loop stops listening if a connection ends before it is accepted.
        replaced(asyncio, "new_event_loop", asyncio.SelectorEventLoop),
    ):
        importlib.import_module("vpython.no_notebook")  # starts the servers, and returns when a browser has connected


@contextmanager
def replaced(owner, name, value):
    """Replace an attribute of a module or class with value during the body of the with statement."""
    original = getattr(owner, name)
    setattr(owner, name, value)
    try:
        yield
    finally:
        setattr(owner, name, original)
