"""The server of the page: one port for HTTP and for the websocket.

It listens at 127.0.0.1 alone, unless --host says otherwise, and prints nothing that a client sends.
The websocket needs the key, and an Origin, which a browser always sends.
"""

import asyncio
import logging
import socket
import threading
import time
from _thread import interrupt_main
from functools import partial

import txaio
from autobahn.asyncio.websocket import WebSocketServerFactory

from support.page.names import Texts
from support.page.server.attendance import Attendance, LOOK_AT_TABS
from support.page.server.browser import BrowserStart
from support.page.server.connection import Connection
from support.page.server.site import Site
from support.page.server.tabs import Tabs

FAREWELL = 0.3  # s that the tabs have to hear of the end
# s that a program has to end without a tab; then Ctrl+C ends it: a loop in it may never end.
LEAVE = 1.0
LARGEST_MESSAGE = 2**24  # bytes, either way: a tab that sends more loses its websocket


class Server:
    """Serves the page in a thread of its own, until close or the program's end."""

    def __init__(self, listener: socket.socket, texts: Texts):
        """Serve at this socket, made by listen; the page has these texts, by name."""
        self.listener = listener
        # On Windows, the usual loop stops listening if a connection ends before it is accepted.
        self.loop = asyncio.SelectorEventLoop()
        self.tabs = Tabs(self.loop.call_soon_threadsafe)
        self.browser_start = BrowserStart()
        self.attendance = Attendance(self.browser_start.delete_file)
        self.site = Site(texts, self.attendance, self.tabs.pictures)
        ready = threading.Event()
        threading.Thread(target=self.serve, args=(ready,), daemon=True).start()
        ready.wait()

    def serve(self, ready: threading.Event) -> None:
        """Set ready, and answer requests until the loop is stopped."""
        for name in ("asyncio", "autobahn"):  # they speak of clients: refused ones, cut ones
            logging.getLogger(name).setLevel(logging.CRITICAL)
        txaio.config.loop = self.loop  # type: ignore[attr-defined]
        asyncio.set_event_loop(self.loop)
        factory = WebSocketServerFactory(loop=self.loop)
        factory.protocol = partial(Connection, self.site, self.attendance, self.tabs)
        factory.setProtocolOptions(maxMessagePayloadSize=LARGEST_MESSAGE)
        self.loop.run_until_complete(self.loop.create_server(factory, sock=self.listener))
        self.loop.call_soon(self.look)
        self.loop.call_soon(ready.set)
        self.loop.run_forever()

    def address(self) -> str:
        """Return the address of the page, with the key."""
        host, port, *_ = self.listener.getsockname()
        host = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host)
        if ":" in host:
            host = f"[{host}]"
        return f"http://{host}:{port}/?key={self.site.key}"

    def close(self) -> None:
        """Tell all tabs that the program has ended, wait until they have heard it, and stop."""
        self.tabs.tell({"ended": ""})
        self.loop.call_soon_threadsafe(self.close_tabs)
        end = time.monotonic() + FAREWELL
        while self.tabs.tabs and time.monotonic() < end:
            time.sleep(0.02)
        self.browser_start.delete_file()
        self.loop.call_soon_threadsafe(self.loop.stop)
        self.listener.close()

    def close_tabs(self) -> None:
        for tab in [*self.tabs.tabs]:
            tab.sendClose()

    def look(self) -> None:
        """Look at each tab; end the program when none is there, and none is expected any more."""
        self.loop.call_later(LOOK_AT_TABS, self.look)
        if not self.tabs.are_gone and not self.attendance.look(self.tabs.tabs):
            self.tabs.are_gone = True
            self.loop.call_later(LEAVE, interrupt_main)
        for tab in [*self.tabs.tabs]:
            tab.look()
