"""The page in the browser, from the start of VPython's servers until the tab is closed or Ctrl+C is pressed."""

import asyncio
import http.server
import importlib
import logging
import os
import signal
import sys
from contextlib import contextmanager
from functools import partial
from html import escape
from pathlib import Path

from support.files.cradle_csv import check_cradle
from support.files.live_file import LiveFile
from support.page.local_server import page_sockets, page_websocket, PageServer, port_of
from support.playback.mistake import tell_mistake
from support.playback.player import run
from support.start.command_line import command_line
from support.start.interrupt import end_on_interrupt
from support.start.options import check_lift

# What the page begins with: its title, and what it needs of a browser.
PAGE_HEAD = Path(__file__).with_name("page_head.html")

NO_WEBGL = """\
Your browser cannot draw the cradle: WebGL 2 is missing or switched off.
Use another browser. Or press Ctrl+C and type this, to see the single cradle as text:"""


def show_page(main, cradle, options, angles, remark="") -> None:
    """Let main run with the page of a cradle, until the tab is closed; status 2 if something is refused.

    cradle is as support/playback/cradle.py says, still without pendula. options are the viewer's, from
    support/start/options.py. angles are the release angles (rad), each None to leave it as the cradle is made. The
    page shows the remark, a line.
    """
    file = LiveFile(options.csv)
    try:
        check_cradle(file.current)  # here, as later on it would be said on the page only
        check_lift(options.lift, file.current)
        sockets = page_sockets(options.port)
    except ValueError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
    viewer = None
    try:
        open_page(sockets, options.browser)
        # It needs VPython's canvas and widgets, which all of the above does without.
        from support.page.viewer import Viewer

        viewer = Viewer(cradle, file, angles, options.lift, remark)
        run(main, viewer)
    except BaseException as error:
        words = tell_mistake(error)
        if viewer:
            viewer.end(words)
    os._exit(1)  # VPython's threads would keep the process alive


def open_page(sockets, launch_browser=True) -> None:
    """Open VPython's page at these page_sockets, and wait for a browser.

    From then on Ctrl+C and the closing of the tab end the process with status 0.
    """
    os.environ["VPYTHON_HTTP_PORT"] = str(port_of(sockets[0]))  # where VPython sends the browser that it opens
    if not launch_browser:
        os.environ["VPYTHON_NO_LAUNCH_BROWSER"] = "1"
    logging.getLogger("asyncio").addFilter(is_worth_showing)
    terminal_cradle = command_line("src/text_cradle_run.py", Path.cwd())
    head = PAGE_HEAD.read_text(encoding="utf-8").replace("TERMINAL_CRADLE", escape(terminal_cradle))
    no_webgl = f"{NO_WEBGL}\n    {terminal_cradle}"
    end_on_interrupt()
    with (
        replaced(signal, "signal", lambda *_: None),
        replaced(http.server, "HTTPServer", partial(PageServer, sockets, head, no_webgl)),
        replaced(asyncio.BaseEventLoop, "create_server", page_websocket(sockets)),
        # On Windows the usual loop stops listening if a connection ends before it is accepted.
        replaced(asyncio, "new_event_loop", asyncio.SelectorEventLoop),
    ):
        importlib.import_module("vpython.no_notebook")  # starts the servers, and returns when a browser is there


def is_worth_showing(record) -> bool:
    """Whether a log record is about anything but VPython having talked to a tab that was just being closed."""
    return not (record.exc_info and type(record.exc_info[1]).__name__ == "Disconnected")


@contextmanager
def replaced(owner, name, value):
    """Put value in the place of a module's or class's attribute for the body of the with statement."""
    original = getattr(owner, name)
    setattr(owner, name, value)
    try:
        yield
    finally:
        setattr(owner, name, original)
