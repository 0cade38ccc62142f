"""The page in the browser, from the start of VPython's servers until the tab is closed or Ctrl+C is pressed."""

import http.server
import importlib
import logging
import os
import signal
import socket
import traceback
from contextlib import contextmanager

PORT_VARIABLE = "VPYTHON_HTTP_PORT"  # the environment variable from which VPython takes the page's port


def page_port() -> int:
    """Return the port for the page: the one that the environment asks for, otherwise any free one.

    Raises a ValueError of one line if the port asked for cannot be had (VPython would die of it later, in a NameError).
    """
    wanted = os.environ.get(PORT_VARIABLE, "0")
    with socket.socket() as probe:
        if os.name == "posix":  # as VPython's server does: a port whose last user has just ended is free
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(("", int(wanted)))
        except (ValueError, OverflowError):
            raise ValueError(f"{PORT_VARIABLE}: found {wanted!r}, allowed is a port number from 0 to 65535") from None
        except OSError as error:
            problem = f"port {wanted} cannot be had: {error.strerror}; choose another, or 0 for any free one"
            raise ValueError(f"{PORT_VARIABLE}: {problem}") from error
        return probe.getsockname()[1]


class AnnouncedServer(http.server.ThreadingHTTPServer):
    """The server of VPython's page, which says where it is as soon as a browser can connect.

    It has a thread for each connection. With the single thread of VPython's own, a connection that a browser has
    opened in advance, and not used yet, would keep the page from loading.
    """

    def server_activate(self) -> None:
        super().server_activate()
        print(f"Newton's cradle is at http://localhost:{self.server_port}")
        print("Open it yourself if no browser does. Ctrl+C, or closing the tab, ends the program.", flush=True)

    def handle_error(self, request, client_address) -> None:
        """Say nothing: the browser went away, or asked for what VPython does not have."""


@contextmanager
def open_page(port):
    """Open VPython's page at this port, wait for a browser, and run the body of the with statement.

    Ctrl+C and the closing of the tab end the process with status 0. A mistake in the body ends it with a traceback and
    status 1, where VPython's threads would have kept the process alive.
    """
    os.environ[PORT_VARIABLE] = str(port)
    logging.getLogger("asyncio").addFilter(is_worth_showing)
    end_on_interrupt()
    try:
        with replaced(signal, "signal", lambda *_: None), replaced(http.server, "HTTPServer", AnnouncedServer):
            importlib.import_module("vpython.no_notebook")  # starts the servers, and returns when a browser is there
        yield
    except BaseException:
        traceback.print_exc()
        os._exit(1)


def end_on_interrupt() -> None:
    """Let Ctrl+C end the process at once, with status 0 and no traceback.

    VPython interrupts its own process when the tab is closed. Its handler for that, and for Ctrl+C, waits for its
    servers, which may be waiting for a browser.
    """
    signal.signal(signal.SIGINT, lambda *_: os._exit(0))


def is_worth_showing(record) -> bool:
    """Whether a log record is about anything but VPython having talked to a tab that was just being closed."""
    return not (record.exc_info and type(record.exc_info[1]).__name__ == "Disconnected")


@contextmanager
def replaced(module, name, value):
    """Put value in the place of a module's attribute for the body of the with statement."""
    original = getattr(module, name)
    setattr(module, name, value)
    try:
        yield
    finally:
        setattr(module, name, original)
