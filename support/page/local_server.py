"""Protect the two servers of VPython's page, its HTTP server and its websocket.

VPython's own servers listen on every address of the machine. They send any picture, script or page on its disk
(GET /../../secret.js). They obey the scripts of all other pages that are open in the browser. They end the program when
any client disconnects from the websocket, and show a page that is loaded again nothing. This module changes that:

- Both servers listen only on 127.0.0.1, at the ports page and page + 1, so that two `ssh -L` options reach them from
  another machine. The program takes both before anything else starts: no other program can take one in between.
- The address that the program prints and opens has a key, a new one at each start. A request for the page must have it.
- Files in VPython's own two folders need no key. The server looks a path up in a list of them, so none leads elsewhere.
- Only the page can use the websocket: it sends the key, and the browser sends the Origin, which no script can change.
- Only one tab shows the cradle, because VPython sends each change once: the tab that was loaded last. The server sends
  ELSEWHERE to the one before it.
- If you reload the tab, or open it again, it gets all that VPython has sent so far, and the cradle restarts. If no tab
  begins to load within RETURN seconds, the program ends.
- The program never prints text from other clients.
"""

import asyncio
import http.server
import json
import logging
import os
import secrets
import socket
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, unquote

from support.page.replay import Replay

RETURN, LOADING = 3.0, 30.0  # s that a closed tab has to come back, and a page from its request to its websocket
ELSEWHERE = b"elsewhere"  # the message to a tab that no longer shows the cradle; page_head.html knows it
LARGEST_MESSAGE = 2**26  # bytes; closes the websocket of a tab that sends more: the program would keep it in memory
PLOTLY = '<script type="text/javascript" src="plotly.min.js"></script>'  # draws graphs with fast=False: none here
NO_KEY = "Open the whole address that the program has printed in the terminal: it ends with a key.\n"


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
        listener.listen()  # until then, another program can bind the same port
        return listener
    except (OSError, OverflowError) as error:
        listener.close()
        reason = error.strerror if isinstance(error, OSError) else "ports are numbers from 1 to 65535"
        choice = "choose another --port, or 0 for any free one"
        raise ValueError(f"port {port} ({whose}) is not available: {reason}; {choice}") from error


def port_of(listener) -> int:
    """Return the port of a socket."""
    return listener.getsockname()[1]


class Access:
    """Decides which requests may see the page, those with the key, and which tab (its websocket) shows the cradle."""

    def __init__(self, show_again) -> None:
        """Begin without a tab; call show_again() for each tab that begins to show the cradle."""
        self.show_again = show_again
        self.tab: Any = None
        self.key = secrets.token_hex(12)  # short, and without signs that end an address in some terminals
        self.until = 0.0

    def has_key(self, parameters) -> bool:
        """Return whether a request with these parameters, a list of texts for each name, has the key."""
        given = parameters.get("key", [""])[0]
        return secrets.compare_digest(given.encode(), self.key.encode())  # takes equally long for every wrong key

    def admit(self, tab) -> None:
        """Let this new tab show the cradle, and no longer the one before it."""
        if self.tab:
            self.tab.tell(ELSEWHERE)
        self.tab, self.until = tab, 0.0  # it is loaded
        self.show_again()

    def tab_closed(self, tab) -> None:
        """If no tab shows the cradle now, end the program soon, unless a tab opens."""
        if tab is self.tab:
            self.tab = None
            self.wait_for_tab(RETURN)
            self.end_without_tab()

    def wait_for_tab(self, seconds) -> None:
        """Wait so long from now on, at least: a tab was closed, or a tab loads. Any thread can call this."""
        self.until = max(self.until, time.monotonic() + seconds)

    def end_without_tab(self) -> None:
        """End the program when the time is over, if no tab shows the cradle by then."""
        rest = self.until - time.monotonic()
        if not self.tab and rest > 0:
            asyncio.get_running_loop().call_later(rest, self.end_without_tab)
        elif not self.tab:
            os._exit(0)


class PageServer(http.server.ThreadingHTTPServer):
    """The server of VPython's page, with a thread for each connection: browsers open some long before they use them."""

    def __init__(self, sockets, access, head, handler) -> None:
        """Serve the page at sockets, made by page_sockets; access checks the key, head is HTML before VPython's own."""
        page_socket, websocket = sockets
        vpython = sys.modules[handler.__module__]  # has the page's text, with a websocket port that VPython chose
        page = vpython.glowcomm_with_socket_port(port_of(websocket))  # type: ignore[attr-defined]
        page = page.replace(PLOTLY, "")  # takes half of the time until the page is loaded
        vpython.glowcomm = page.replace("<head>", "<head>" + head, 1)  # type: ignore[attr-defined]
        super().__init__(page_socket.getsockname(), own_files_only(handler, access), bind_and_activate=False)
        self.socket.close()
        self.socket = page_socket  # it listens already

    def handle_error(self, request, client_address) -> None:
        """Print nothing: the browser disconnected in the middle of an answer."""


def own_files_only(handler: Any, access) -> Any:
    """Return VPython's request handler, limited to the page, which needs the key, and VPython's own two folders.

    A request for the page lets access wait for its tab: a slow machine needs seconds until it opens the websocket.
    """
    files = {
        f"/{file.relative_to(folder).as_posix()}": (content_type, file)
        for ending, (content_type, folder) in handler.mimes.items()
        for file in Path(folder).rglob(f"*.{ending}")
    }

    class OwnFilesHandler(handler):
        path: str  # with the query, as the request has it

        def do_GET(self) -> None:  # noqa: N802
            path, _, query = self.path.partition("?")
            if unquote(path) in files:
                content_type, file = files[unquote(path)]
                self.begin({"Content-Type": content_type})
                self.wfile.write(file.read_bytes())
            elif path != "/":
                self.send_error(404)
            elif not access.has_key(parse_qs(query)):
                self.begin({"Content-Type": "text/plain; charset=utf-8"}, 403)
                self.wfile.write(NO_KEY.encode())
            else:
                access.wait_for_tab(LOADING)
                self.path = path  # VPython knows no query
                super().do_GET()  # the page; VPython waits for this call

        def begin(self, headers, status=200) -> None:
            self.send_response(status)
            for name, value in headers.items():
                self.send_header(name, value)
            self.end_headers()

    return OwnFilesHandler


def page_websocket(sockets, access) -> Any:
    """Return a replacement for an event loop's create_server, for the moment when VPython starts its websocket.

    Only the tab that access (an Access) admits can use the websocket.
    """
    page, websocket = sockets
    origins = [f"http://{host}:{port_of(page)}" for host in ("localhost", "127.0.0.1")]
    create_server = asyncio.BaseEventLoop.create_server

    async def create_page_websocket(loop, factory, *_):
        logging.getLogger("autobahn").setLevel(logging.CRITICAL)  # it quotes refused clients
        factory.setProtocolOptions(allowedOrigins=origins, allowNullOrigin=False, webStatus=False)
        factory.setProtocolOptions(maxFramePayloadSize=LARGEST_MESSAGE, maxMessagePayloadSize=LARGEST_MESSAGE)
        objects = sys.modules[factory.protocol.__module__].baseObj.object_registry  # of VPython, by number
        factory.protocol = one_tab_only(factory.protocol, access, objects)
        return await create_server(loop, factory, sock=websocket)

    return create_page_websocket


def one_tab_only(protocol: Any, access, objects) -> Any:
    """Return VPython's websocket protocol, limited to the tab that access (an Access) admits, with its key and Origin.

    objects has VPython's objects by number. Autobahn checks the Origin before this, but accepts a connection without
    one. It also calls onClose for a connection that was refused; VPython would then end the program.
    """
    from autobahn.exception import Disconnected  # comes with VPython, which the tests do not need
    from autobahn.websocket.types import ConnectionDeny

    replay = Replay()

    class OneTabProtocol(protocol):
        def onConnect(self, request) -> None:  # noqa: N802
            if not (request.origin and access.has_key(request.params)):
                raise ConnectionDeny(ConnectionDeny.FORBIDDEN)
            self.is_new = True  # has nothing of the cradle yet
            super().onConnect(request)

        def onOpen(self) -> None:  # noqa: N802
            access.admit(self)
            super().onOpen()

        async def onMessage(self, data, is_binary) -> None:  # noqa: N802
            if self is access.tab:  # VPython forgets each change when it answers a message
                await super().onMessage(possible_events(data, objects), is_binary)

        def sendMessage(self, payload, **options) -> None:  # noqa: N802
            replay.add(json.loads(payload))
            self.tell(json.dumps(replay.message()).encode() if self.is_new else payload, **options)
            self.is_new = False

        def tell(self, payload, **options) -> None:
            with suppress(Disconnected):  # the tab was just closed, and the next one gets it
                super().sendMessage(payload, **options)

        def onClose(self, *how) -> None:  # noqa: N802
            access.tab_closed(self)

    return OneTabProtocol


def possible_events(data, objects) -> bytes:
    """Return a message of the page without the events at which VPython would print a traceback.

    A message is the text "trigger", or a list of events (glowcomm.html). objects has VPython's objects by number.
    """
    if data == b"trigger":
        return data
    return json.dumps([event for event in json.loads(data) if is_possible(event, objects)]).encode()


def is_possible(event, objects) -> bool:
    """Return whether a menu still has the choice of this event, and no number in it is infinite, or 0 for a size."""
    if event.get("widget") == "menu":  # the program can replace the choices while you choose
        return 0 <= event["value"] < len(objects[event["idx"]].choices)
    sizes = [event[name] for name in ("width", "height", "range") if name in event]
    parts = [part for name in ("pos", "ray", "forward", "up", "center") for part in event.get(name, [])]
    return all(sizes) and None not in parts  # JSON has null in place of an infinite number
