"""The server of the page: one port for HTTP and for the websocket, a key, and the page's own files.

- The page asks for everything relative to its own address, and the server looks only at the last
  part of a path. So it works below any path, behind any name and any port: an SSH tunnel, a hosted
  editor's proxy, a container.
- The key decides who gets the page and the websocket; a program has a new one at each start. The
  websocket also needs an Origin, which a browser always sends. Files that everybody can download
  (VPython's and the page's) need no key.
- It listens at 127.0.0.1 alone, unless --host says otherwise, and prints nothing that a client
  sends.
- A page says goodbye when it is left, and whether its tab is closed for sure. When the last page
  has gone, the program waits for it, and then ends: after CLOSED, LEFT or LOST seconds.
- Times are counted in looks, one each LOOK_AT_TABS seconds: while a laptop sleeps, nobody loses
  time.
"""

import asyncio
import logging
import secrets
import socket
import threading
import time
from _thread import interrupt_main
from collections.abc import Mapping
from math import inf

import txaio
from autobahn.asyncio.websocket import WebSocketServerFactory

from support.page.browser import BrowserStart
from support.page.connection import CLOSED, LOADS, Parameters, Protocol
from support.page.tabs import LOOK_AT_TABS, Tabs
from support.page.web_files import keyless_files
from support.start.output import say

FLICKER = 3.0  # s after which the terminal says that the page has gone
FAREWELL = 0.3  # s that the tabs have to hear of the end
# s that main has to end without a tab; then Ctrl+C ends it: it may be in a loop that never ends.
LEAVE = 1.0
# bytes, either way: a tab that sends more loses its websocket, or it would stay in memory.
LARGEST_MESSAGE = 2**26


class Server:
    """Serves the page in a thread of its own, until close or the program's end."""

    def __init__(self, listener: socket.socket, tabs: Tabs, texts: Mapping[str, str]):
        """Serve at this socket, made by listen; the page has these texts, by name."""
        self.listener = listener
        self.tabs = tabs
        self.texts = texts
        # Short, and without signs that end an address in some terminals.
        self.key = secrets.token_hex(12)
        # The connections that are no websocket, the oldest one first.
        self.waiting: dict[Protocol, None] = {}
        # How long (s) the program still waits for pages that have gone, by their names, and for one
        # that loads, whichever it is
        self.rests: dict[str, float] = {LOADS: inf}
        self.absence = 0.0  # s since the last page has gone
        self.is_missed = False  # whether the terminal says so
        self.files = keyless_files()
        self.browser_start = BrowserStart()
        ready = threading.Event()
        threading.Thread(target=self.serve, args=(ready,), daemon=True).start()
        ready.wait()

    def serve(self, ready: threading.Event) -> None:
        """Set ready, and answer requests until the loop is stopped."""
        for name in ("asyncio", "autobahn"):  # they speak of clients: refused ones, cut ones
            logging.getLogger(name).setLevel(logging.CRITICAL)
        # On Windows, the usual loop stops listening if a connection ends before it is accepted.
        self.loop = asyncio.SelectorEventLoop()
        txaio.config.loop = self.loop  # type: ignore[attr-defined]
        self.loop.set_exception_handler(lambda *_: None)  # of autobahn, at requests without sense
        asyncio.set_event_loop(self.loop)
        factory = WebSocketServerFactory(loop=self.loop)
        factory.protocol = type("Protocol", (Protocol,), {"site": self})
        factory.setProtocolOptions(
            maxFramePayloadSize=LARGEST_MESSAGE,
            maxMessagePayloadSize=LARGEST_MESSAGE,
            webStatus=False,
        )
        self.loop.run_until_complete(self.loop.create_server(factory, sock=self.listener))
        self.tabs.in_server = self.loop.call_soon_threadsafe
        self.loop.call_soon(self.look)
        self.loop.call_soon(ready.set)
        self.loop.run_forever()

    def address(self) -> str:
        """Return the address of the page, with the key."""
        host, port, *_ = self.listener.getsockname()
        host = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host)
        if ":" in host:
            host = f"[{host}]"
        return f"http://{host}:{port}/?key={self.key}"

    def close(self, patience: float = FAREWELL) -> None:
        """Tell all tabs that the program has ended, and stop.

        Wait up to patience (s) until they have heard it.
        """
        if self.tabs.last.get("ended") is None:
            self.tabs.in_server(self.tabs.deliver, {"ended": ""}, {})
        self.loop.call_soon_threadsafe(self.close_tabs)
        end = time.monotonic() + patience
        while self.tabs.tabs and time.monotonic() < end:
            time.sleep(0.02)
        self.browser_start.delete_file()
        self.loop.call_soon_threadsafe(self.loop.stop)
        self.listener.close()

    def close_tabs(self) -> None:
        for tab in [*self.tabs.tabs]:
            tab.sendClose()

    def has_key(self, parameters: Parameters) -> bool:
        """Return whether a request with these parameters has the key.

        The answer comes as quickly for each wrong key.
        """
        return secrets.compare_digest(parameters.get("key", [""])[0].encode(), self.key.encode())

    # --- which pages are there, and which will come --------------------------------------------

    def expect(self, page_name: str, seconds: float) -> None:
        """Expect the page with this name for so long from now on, at least."""
        self.rests[page_name] = max(self.rests.get(page_name, 0.0), seconds)

    def welcome(self, page_name: str, was: str) -> None:
        """Hear that a page has its websocket: its name, and the one that it had before a reload."""
        for name in (LOADS, page_name, was):
            self.rests.pop(name, None)
        if self.is_missed:
            say("The page is back.")
        self.is_missed = False
        self.absence = 0.0
        self.browser_start.delete_file()

    def leave(self, page_name: str, seconds: float) -> None:
        """Hear a goodbye of the page with this name; expect it back for no longer than this.

        Its websocket may have ended already, or not.
        """
        for tab in self.tabs.tabs:
            if tab.page_name == page_name:
                tab.rest = min(tab.rest, seconds)
        if page_name in self.rests:
            self.rests[page_name] = min(self.rests[page_name], seconds)

    def look(self) -> None:
        """Look at each tab; end the program when none is there, and none is expected any more."""
        self.loop.call_later(LOOK_AT_TABS, self.look)
        rests = {page_name: rest - LOOK_AT_TABS for page_name, rest in self.rests.items()}
        self.rests = {page_name: rest for page_name, rest in rests.items() if rest >= 0}
        self.tabs.look()
        for tab in [*self.tabs.tabs]:
            tab.look()
        if not (self.tabs.tabs or self.tabs.are_gone or LOADS in self.rests):
            self.absence += LOOK_AT_TABS
            self.wait_or_end()

    def wait_or_end(self) -> None:
        """End the program when no page is expected any more; else say that it waits for one."""
        if not self.rests:
            self.tabs.are_gone = True
            self.loop.call_later(LEAVE, interrupt_main)
            return
        rest = max(self.rests.values())
        if rest > CLOSED and self.absence >= FLICKER and not self.is_missed:
            self.is_missed = True
            say(
                "The page has gone: you have left or closed it, its line is cut, or its machine "
                f"sleeps. The program waits {int(rest)} s for it. Ctrl+C ends it at once."
            )
