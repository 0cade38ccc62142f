"""Protect the two servers of VPython's page, its HTTP server and its websocket.

VPython's own servers listen on every address of the machine. They send any picture, script or page on its disk
(GET /../../secret.js). They obey the scripts of all other pages that are open in the browser. They end the program when
any client disconnects from the websocket, and show a page that is loaded again nothing. This module changes that:

- Both servers listen only on 127.0.0.1, at the ports page and page + 1, so that two `ssh -L` options reach them from
  another machine. The program takes both ports before anything else starts, and keeps them: no other program can take
  one in between.
- A request gets VPython's page, or one of the files in VPython's own two folders. The server looks its path up in a
  list of these files, and never joins it to a folder, so no spelling of a path leads elsewhere. On two more paths, only
  the page gets an answer, and no other page: at /no-webgl, it reports to the terminal that its browser cannot draw, and
  at /cradle_data.csv, it downloads the data.
- Only the page can use the websocket: for each connection, the browser names the page of the script, its Origin, and a
  script cannot change it.
- Only one tab shows the cradle: VPython sends each change once. Each tab has a name (page_head.html). A second tab is
  closed with the code ELSEWHERE, unless it asks to take the cradle over: then, the first one is closed with this code.
- If the tab comes back, because you reloaded it or opened it again, it gets all that VPython has sent so far, and the
  cradle restarts. If it does not begin to load within RETURN seconds, the program ends.
- The program never prints text from other clients.
"""

import asyncio
import codecs
import errno
import http.server
import json
import logging
import os
import socket
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from support.page.replay import Replay
from support.start.output import say

RETURN = 3.0  # s that a closed tab has to come back
ELSEWHERE = 4001  # closes the websocket of a tab because another one shows the cradle; page_head.html knows it


def page_sockets(port) -> tuple[socket.socket, socket.socket]:
    """Return a socket for the page at this port, and one for its websocket at the next; port 0 finds any free pair.

    Raises a ValueError with a one-line message if one of the two ports is not available.
    """
    while True:
        page = listening_socket(port, "the page's")
        try:
            return page, listening_socket(port_of(page) + 1, "the websocket's, one above the page's")
        except ValueError:
            page.close()
            if port != 0:
                raise


def listening_socket(port, whose) -> socket.socket:
    """Return a socket that listens at this port of 127.0.0.1; raises a ValueError that says whose port it is."""
    listener = socket.socket()
    try:
        # With SO_REUSEADDR, the port of a program that has just ended is free. On Windows, SO_REUSEADDR would share a
        # port in use; SO_EXCLUSIVEADDRUSE prevents this.
        option = getattr(socket, "SO_EXCLUSIVEADDRUSE", socket.SO_REUSEADDR)
        listener.setsockopt(socket.SOL_SOCKET, option, 1)
        listener.bind(("127.0.0.1", port))
        if is_answered(port_of(listener)):
            raise OSError(errno.EADDRINUSE, "another program answers there")
        listener.listen()  # until then, another program can bind the same port
        return listener
    except (OSError, OverflowError) as error:
        listener.close()
        reason = error.strerror if isinstance(error, OSError) else "ports are numbers from 1 to 65535"
        choice = "choose another --port, or 0 for any free one"
        raise ValueError(f"port {port} ({whose}) is not available: {reason}; {choice}") from error


def is_answered(port) -> bool:
    """Return whether a program answers at this port of ::1. Browsers try ::1 before 127.0.0.1."""
    with suppress(OSError), socket.create_connection(("::1", port), timeout=0.2):
        return True
    return False


def port_of(listener) -> int:
    """Return the port of a socket."""
    return listener.getsockname()[1]


class Place:
    """The place of the one tab that shows the cradle. Each tab here is a websocket's connection."""

    def __init__(self, show_again) -> None:
        """Begin without a tab; call show_again() for each tab that gets the place."""
        self.show_again = show_again
        self.tab: Any = None
        self.expect_tab()

    def take(self, tab) -> bool:
        """Give the place to this tab, and return True, unless another tab has it and need not give it up."""
        if self.tab and self.tab.name != tab.name and not tab.takes_over:
            tab.sendClose(ELSEWHERE)
            return False
        if self.tab:
            self.tab.sendClose(ELSEWHERE)
        self.tab = tab
        self.show_again()
        return True

    def leave(self, tab) -> None:
        """If the tab of this place was closed, end the program soon, unless a tab comes."""
        if tab is self.tab:
            self.tab = None
            self.expect_tab()
            self.end_if_left()

    def expect_tab(self) -> None:
        """Wait RETURN seconds for a tab, from now on, because one has just left or loads; any thread can call this."""
        self.until = time.monotonic() + RETURN

    def end_if_left(self) -> None:
        """End the program if no tab has come in time; otherwise, look again when the time is over."""
        rest = self.until - time.monotonic()
        if not self.tab and rest <= 0:
            os._exit(0)
        elif not self.tab:
            asyncio.get_running_loop().call_later(rest, self.end_if_left)


class PageServer(http.server.ThreadingHTTPServer):
    """The server of VPython's page. It prints its address as soon as a browser can connect.

    It has a thread for each connection. VPython's own server has a single thread: a connection that a browser opens in
    advance, without using it, would block the page.
    """

    def __init__(self, sockets, place, head, no_webgl, write_data, address, handler) -> None:
        """Serve at sockets, made by page_sockets; head is HTML for the beginning of the page, before VPython's own.

        Tell place of each request. no_webgl is the text to print if the page reports that its browser has no WebGL.
        write_data(file) writes the data since the last restart to a file, as text.
        """
        self.page, websocket = sockets
        vpython = sys.modules[handler.__module__]  # has the page's text, with a websocket port that VPython chose
        page = vpython.glowcomm_with_socket_port(port_of(websocket))  # type: ignore[attr-defined]
        vpython.glowcomm = page.replace("<head>", "<head>" + head, 1)  # type: ignore[attr-defined]
        super().__init__(address, own_files_only(handler, place, no_webgl, write_data))

    def server_bind(self) -> None:
        """Use the page's socket, and ignore the address from VPython."""
        self.socket.close()
        self.socket = self.page
        self.server_name, self.server_port = self.page.getsockname()

    def server_activate(self) -> None:
        super().server_activate()
        say(f"Newton's cradle is at http://localhost:{self.server_port}")
        say("Open it yourself if no browser opens. To end, press Ctrl+C or close the tab.")

    def handle_error(self, request, client_address) -> None:
        """Print nothing: the browser disconnected in the middle of an answer."""


def own_files_only(handler: Any, place, no_webgl, write_data) -> Any:
    """Return VPython's request handler, limited to VPython's page and the files in VPython's own two folders.

    It tells place of each request: a slow machine loads a page for seconds before it opens the websocket. If the page
    reports that its browser has no WebGL, the handler prints the text no_webgl. It calls write_data(file) for the data.
    """
    files = {
        f"/{file.relative_to(folder).as_posix()}": (content_type, file)
        for ending, (content_type, folder) in handler.mimes.items()
        for file in Path(folder).rglob(f"*.{ending}")
    }

    class OwnFilesHandler(handler):
        def do_GET(self) -> None:  # noqa: N802
            place.expect_tab()
            path = unquote(self.path)
            if self.path == "/":
                super().do_GET()  # the page; VPython waits for this call
            elif path in files:
                content_type, file = files[path]
                self.send_response(200)
                self.send_header("Content-type", content_type)
                self.end_headers()
                self.wfile.write(file.read_bytes())
            elif self.headers["Sec-Fetch-Site"] != "same-origin":  # the rest is for this page only
                self.send_error(404)
            elif self.path == "/no-webgl":
                self.send_response(204)
                self.end_headers()
                say(no_webgl)
            elif self.path == "/cradle_data.csv":
                self.send_response(200)
                self.send_header("Content-Type", "text/csv; charset=utf-8")
                self.send_header("Content-Disposition", "attachment; filename=cradle_data.csv")
                self.end_headers()
                write_data(codecs.getwriter("utf-8")(self.wfile))
            else:
                self.send_error(404)

    return OwnFilesHandler


def page_websocket(sockets, place) -> Any:
    """Return a replacement for an event loop's create_server, for the moment when VPython starts its websocket.

    Only the tab in this place can use the websocket.
    """
    page, websocket = sockets
    origins = [f"http://{host}:{port_of(page)}" for host in ("localhost", "127.0.0.1")]
    create_server = asyncio.BaseEventLoop.create_server

    async def create_page_websocket(loop, factory, *_):
        logging.getLogger("autobahn").setLevel(logging.CRITICAL)  # it quotes refused clients
        factory.setProtocolOptions(allowedOrigins=origins, allowNullOrigin=False, webStatus=False)
        factory.protocol = one_tab_only(factory.protocol, place)
        return await create_server(loop, factory, sock=websocket)

    return create_page_websocket


def one_tab_only(protocol: Any, place) -> Any:
    """Return VPython's websocket protocol, limited to the tab in this place, which must name itself and its Origin.

    Autobahn checks the Origin before this, but accepts a connection without one. It also calls onClose for a connection
    that was refused, or that never sent a request. VPython would then end the program with a Ctrl+C, which on Windows
    reaches every program of the console.
    """
    from autobahn.exception import Disconnected  # comes with VPython, which the tests do not need
    from autobahn.websocket.types import ConnectionDeny

    replay = Replay()

    class OneTabProtocol(protocol):
        def onConnect(self, request) -> None:  # noqa: N802
            if not request.origin or "tab" not in request.params:
                raise ConnectionDeny(ConnectionDeny.FORBIDDEN)
            self.name, self.takes_over = request.params["tab"], "take" in request.params
            self.is_new = True  # has nothing of the cradle yet
            super().onConnect(request)

        def onOpen(self) -> None:  # noqa: N802
            if place.take(self):
                super().onOpen()

        async def onMessage(self, *message) -> None:  # noqa: N802
            if self is place.tab:  # VPython forgets each change when it answers a message
                await super().onMessage(*message)

        def sendMessage(self, payload, **options) -> None:  # noqa: N802
            replay.add(json.loads(payload))
            if self.is_new:
                self.is_new = False
                payload = json.dumps(replay.message()).encode()
            with suppress(Disconnected):  # the tab was just closed, and the next one gets it
                super().sendMessage(payload, **options)

        def onClose(self, *how) -> None:  # noqa: N802
            place.leave(self)

    return OneTabProtocol
