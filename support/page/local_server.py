"""Closed doors: who reaches the two servers of VPython's page, its HTTP server and its websocket, and what they give.

VPython's own servers listen on every address of the machine, hand out any picture, script or page on its disk
(GET /../../secret.js), obey a script of any other page that is open in the browser, and end the program as soon as
anyone who has connected to the websocket goes away. Here instead:

- Both listen on 127.0.0.1 only, at neighbouring ports, page and page + 1, so that two `ssh -L` options reach them from
  afar. The ports are taken once, before anything else starts, and kept: nobody can take one in between.
- A request gets VPython's page or one of the files in VPython's own two folders. Its path is looked up in a list of
  these, never joined to a folder, so that no way of writing it leads elsewhere. One more path, /no-webgl, lets the
  page, and no other, say in the terminal that its browser cannot draw.
- The websocket is for the page: a browser says of each connection which page's script has made it, its Origin, and a
  script cannot change that. It is for one tab, as VPython can show a cradle only once, and only that tab's closing ends
  the program.
- A stranger's words do not reach the screen.
"""

import asyncio
import errno
import http.server
import logging
import os
import socket
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import unquote


def page_sockets(port) -> tuple[socket.socket, socket.socket]:
    """Return a socket for the page at this port, and one for its websocket at the next; port 0 finds any free pair.

    Raises a ValueError of one line if one of the two ports cannot be had.
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
    """Return a socket that listens at this port of 127.0.0.1; raises a ValueError that says whose port it would be."""
    listener = socket.socket()
    try:
        # With SO_REUSEADDR, a port whose last user has just ended is free. On Windows it would share a port in use;
        # SO_EXCLUSIVEADDRUSE lets nobody share this one.
        option = getattr(socket, "SO_EXCLUSIVEADDRUSE", socket.SO_REUSEADDR)
        listener.setsockopt(socket.SOL_SOCKET, option, 1)
        listener.bind(("127.0.0.1", port))
        if is_answered(port_of(listener)):
            raise OSError(errno.EADDRINUSE, "another program answers there")
        listener.listen()  # before that, another program can still bind the same port
        return listener
    except (OSError, OverflowError) as error:
        listener.close()
        reason = error.strerror if isinstance(error, OSError) else "ports are numbers from 1 to 65535"
        choice = "choose another --port, or 0 for any free one"
        raise ValueError(f"port {port} ({whose}) cannot be had: {reason}; {choice}") from error


def is_answered(port) -> bool:
    """Return whether a program answers at this port of ::1. Browsers try that before 127.0.0.1."""
    with suppress(OSError), socket.create_connection(("::1", port), timeout=0.2):
        return True
    return False


def port_of(listener) -> int:
    """Return the port of a socket."""
    return listener.getsockname()[1]


class PageServer(http.server.ThreadingHTTPServer):
    """The server of VPython's page, which says where it is as soon as a browser can connect.

    It has a thread for each connection. With the single thread of VPython's own, a connection that a browser has
    opened in advance, and not used yet, would keep the page from loading.
    """

    def __init__(self, sockets, head, no_webgl, address, handler) -> None:
        """Serve at these page_sockets; head is HTML that the page begins with, before anything of VPython's.

        no_webgl is text to print as soon as the page finds that its browser has no WebGL.
        """
        self.page, websocket = sockets
        vpython = sys.modules[handler.__module__]  # where the page's text is, with a websocket port chosen by VPython
        page = vpython.glowcomm_with_socket_port(port_of(websocket))  # type: ignore[attr-defined]
        vpython.glowcomm = page.replace("<head>", "<head>" + head, 1)  # type: ignore[attr-defined]
        super().__init__(address, own_files_only(handler, no_webgl))

    def server_bind(self) -> None:
        """Take the page's socket, whatever the address that VPython asks for."""
        self.socket.close()
        self.socket = self.page
        self.server_name, self.server_port = self.page.getsockname()

    def server_activate(self) -> None:
        super().server_activate()
        print(f"Newton's cradle is at http://localhost:{self.server_port}")
        print("Open it yourself if no browser does. Ctrl+C, or closing the tab, ends the program.", flush=True)

    def handle_error(self, request, client_address) -> None:
        """Say nothing: the browser went away in the middle of an answer."""


def own_files_only(handler: Any, no_webgl) -> Any:
    """Return VPython's request handler, changed to give nothing but its page and the files in its own two folders.

    The page can say that its browser has no WebGL; the text no_webgl is then printed.
    """
    files = {
        f"/{file.relative_to(folder).as_posix()}": (content_type, file)
        for ending, (content_type, folder) in handler.mimes.items()
        for file in Path(folder).rglob(f"*.{ending}")
    }

    class OwnFilesHandler(handler):
        def do_GET(self) -> None:  # noqa: N802
            path = unquote(self.path)
            if self.path == "/":
                super().do_GET()  # the page; VPython waits for this call
            elif path in files:
                content_type, file = files[path]
                self.send_response(200)
                self.send_header("Content-type", content_type)
                self.end_headers()
                self.wfile.write(file.read_bytes())
            elif self.path == "/no-webgl" and self.headers["Sec-Fetch-Site"] == "same-origin":  # from this page only
                self.send_response(204)
                self.end_headers()
                print(no_webgl, flush=True)
            else:
                self.send_error(404)

    return OwnFilesHandler


def page_websocket(sockets) -> Any:
    """Return what is to take the place of an event loop's create_server while VPython starts its websocket."""
    page, websocket = sockets
    origins = [f"http://{host}:{port_of(page)}" for host in ("localhost", "127.0.0.1")]
    create_server = asyncio.BaseEventLoop.create_server

    async def create_page_websocket(loop, factory, *_):
        logging.getLogger("autobahn").setLevel(logging.CRITICAL)  # it quotes those whom it refuses
        factory.setProtocolOptions(allowedOrigins=origins, allowNullOrigin=False, webStatus=False)
        factory.protocol = one_tab_only(factory.protocol)
        return await create_server(loop, factory, sock=websocket)

    return create_page_websocket


def one_tab_only(protocol: Any) -> Any:
    """Return VPython's websocket protocol, changed to accept one connection, which must say its Origin.

    Autobahn has checked an Origin before, but lets pass who says none. It calls onClose for a connection that was
    refused, or never asked for anything, as well. VPython would then end the program, by a Ctrl+C that on Windows
    reaches every program of the console.
    """
    from autobahn.websocket.types import ConnectionDeny  # comes with VPython, which the tests can do without

    tab = None

    class OneTabProtocol(protocol):
        def onConnect(self, request) -> None:  # noqa: N802
            nonlocal tab
            if tab is not None or not request.origin:
                raise ConnectionDeny(ConnectionDeny.FORBIDDEN)
            tab = self
            super().onConnect(request)

        def onClose(self, *how) -> None:  # noqa: N802
            if self is tab:
                os._exit(0)

    return OneTabProtocol
