"""The server of the page: one port for HTTP and for the websocket, a key, and the page's own files.

- The page asks for everything relative to its own address, and the server looks only at the last
  part of a path. So it works below any path, behind any name and any port: an SSH tunnel, a hosted
  editor's proxy, a container.
- The key decides who gets the page and the websocket; a program has a new one at each start. The
  websocket also needs an Origin, which a browser always sends. Files that everybody can download
  (VPython's and the page's) need no key.
- It listens at 127.0.0.1 alone, unless --host says otherwise, and prints nothing that a client
  sends.
- A page says goodbye when it is left. When the last tab is closed, and none begins to load within
  RETURN seconds, the program ends. A page that is lost without a goodbye has a longer time, LOST.
- Times are counted in looks, one each LOOK seconds: while a laptop sleeps, nobody loses time.
"""

import asyncio
import logging
import secrets
import socket
import threading
import time
from _thread import interrupt_main
from math import inf

import txaio
from autobahn.asyncio.websocket import WebSocketServerFactory

from support.page.browser import BrowserStart
from support.page.connection import LOST, Parameters, Protocol, RETURN
from support.page.tabs import LOOK, Tabs
from support.page.web_files import keyless_files
from support.start.output import say

FLICKER = 3.0  # s after which the terminal says that a page is lost
FAREWELL = 0.3  # s that the tabs have to hear of the end
# s that main has to end without a tab; then Ctrl+C ends it: it may be in a loop that never ends.
LEAVE = 1.0
# bytes, either way: a tab that sends more loses its websocket, or it would stay in memory.
LARGEST_MESSAGE = 2**26


class Server:
    """Serves the page in a thread of its own, until close or the program's end."""

    def __init__(self, listener: socket.socket, tabs: Tabs):
        """Serve at this socket, made by listen."""
        self.listener = listener
        self.tabs = tabs
        # Short, and without signs that end an address in some terminals.
        self.key = secrets.token_hex(12)
        # The connections that are no websocket, the oldest one first.
        self.waiting: dict[Protocol, None] = {}
        # s for which a page is expected yet: any page, below 0 none, and lost ones by their names
        self.rest_of_any = inf
        self.rest_of_lost: dict[str, float] = {}
        self.is_missed = False  # whether the terminal says that a page does not answer
        self.files = keyless_files()
        self.browser_start = BrowserStart()
        ready = threading.Event()
        threading.Thread(target=self.serve, args=(ready,), daemon=True).start()
        ready.wait()

    def serve(self, ready: threading.Event) -> None:
        """Set ready, and answer requests until the loop is stopped."""
        logging.getLogger("autobahn").setLevel(logging.CRITICAL)  # it quotes refused clients
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

    def expect(self, seconds: float) -> None:
        """Expect any page for so long from now on, at least."""
        self.rest_of_any = max(self.rest_of_any, seconds)

    def lose(self, page: str) -> None:
        """Hear that the page with this name is lost, without a goodbye; expect it back."""
        self.rest_of_lost[page] = LOST

    def welcome(self, page: str) -> None:
        """Hear that the page with this name has its websocket."""
        self.rest_of_any = -1.0
        was_lost = self.rest_of_lost.pop(page, None) is not None
        if self.is_missed and was_lost:
            say("The page is back.")
        self.is_missed = False
        self.browser_start.delete_file()

    def leave(self, page: str) -> None:
        """Hear that the page with this name is left, before or after its websocket has ended."""
        for tab in self.tabs.tabs:
            if tab.page == page:
                tab.has_said_goodbye = True
        if self.rest_of_lost.pop(page, None) is not None:
            self.expect(RETURN)

    def look(self) -> None:
        """Look at each tab; end the program when none is there, and none is expected any more."""
        self.loop.call_later(LOOK, self.look)
        self.rest_of_any -= LOOK
        rests = {page: rest - LOOK for page, rest in self.rest_of_lost.items()}
        self.rest_of_lost = {page: rest for page, rest in rests.items() if rest >= 0}
        self.tabs.look()
        for tab in [*self.tabs.tabs]:
            tab.look()
        if self.tabs.tabs or self.tabs.are_gone:
            return
        if self.rest_of_any < 0 and not self.rest_of_lost:
            self.tabs.are_gone = True
            self.loop.call_later(LEAVE, interrupt_main)
        rest = max(self.rest_of_lost.values(), default=inf)
        if rest <= LOST - FLICKER and not self.is_missed:
            self.is_missed = True
            cause = "its line is cut, its machine sleeps, or its browser has ended"
            say(f"A page does not answer: {cause}. The program waits {rest:.0f} s for it.")
