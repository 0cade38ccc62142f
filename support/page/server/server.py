"""The server of the page: one port for the page, its files and the websockets of tabs, by Tornado.

It listens at 127.0.0.1 alone, unless --host says otherwise.
The page asks for everything relative to its own address, and only the last part of a path counts.
So it works below any path, behind any name and any port: an SSH tunnel, a hosted editor's proxy, a
container. A key decides who gets the page and the websocket; a program has new ones at each start:

    ?key=...     the address that the program prints: this tab commands
    ?follow=...  the address that Share shows: this tab sees the same, and its commands are dropped

Files that everybody can download (VPython's and the page's) need no key.
"""

import asyncio
import logging
import secrets
import signal
import socket
import threading
import time
from _thread import interrupt_main
from contextlib import suppress
from pathlib import Path
from typing import Any

from tornado.httpserver import HTTPServer
from tornado.web import Application, HTTPError, RequestHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler

from support.page.names import Texts
from support.page.server.attendance import Attendance, LOADING
from support.page.server.browser import BrowserStart
from support.page.server.tabs import Tab, Tabs
from support.page.server.web_files import page_with, public_files

LOOK = 0.5  # s from one look at the tabs to the next
PING = 10  # s from one ping to the next; a tab that does not answer is cut after 10 to 25 s
IDLE = 20  # s after which a connection without a request is closed
FAREWELL = 0.3  # s that the tabs have to hear of the end
# s that a program has to end without a tab; then it is stopped: a loop in it may never end.
LEAVE = 1.0
LARGEST = 2**23  # bytes of a message, or of a request: who sends more is cut off
TAB_IS_CLOSED = 1001  # the code with which a browser ends the websocket of a page that it leaves
# Not those of the system, where somebody may have changed them.
TYPES = {".js": "text/javascript", ".css": "text/css", ".jpg": "image/jpeg"}
NO_KEY = (
    "Open the whole address that the program has printed in the terminal: "
    "it ends with a key, new at each start."
)


class Server:
    """Serves the page in a thread of its own, until close or the program's end."""

    def __init__(self, listener: socket.socket, texts: Texts):
        """Serve at this socket, made by listen; the page has these texts, by name."""
        self.listener = listener
        # Letters and digits, which no terminal splits; the second one is short, to be typed.
        self.keys = {"key": secrets.token_hex(12), "follow": secrets.token_hex(4)}
        self.pages = {
            "key": page_with({**texts, "share": self.keys["follow"]}),
            "follow": page_with({"csv": texts["csv"]}),
        }
        # On Windows, the usual loop stops listening if a connection ends before it is accepted.
        self.loop = asyncio.SelectorEventLoop()
        self.tabs = Tabs(self.loop.call_soon_threadsafe)
        self.browser_start = BrowserStart()
        self.attendance = Attendance()
        self.is_closing = False  # whether the program ends by itself
        ours = {"server": self}
        self.application = Application(
            [
                (r".*/ws", Socket, ours),
                (r".*/film\.html", SavedFilm, ours),
                (r".*/([^/]*\.[^/]*)", File, {"files": public_files()}),
                (r".*", Page, ours),
            ],
            compress_response=True,
            websocket_ping_interval=PING,
            websocket_max_message_size=LARGEST,
        )
        self.thread = threading.Thread(target=self.serve, daemon=True)
        self.thread.start()

    def serve(self) -> None:
        """Answer requests until the loop is stopped."""
        asyncio.set_event_loop(self.loop)
        self.loop.set_exception_handler(report)
        for name in ("access", "general"):  # they report refused and lost browsers
            logging.getLogger(f"tornado.{name}").setLevel(logging.CRITICAL)
        server = HTTPServer(self.application, idle_connection_timeout=IDLE, max_buffer_size=LARGEST)
        self.listener.setblocking(False)
        self.loop.call_soon(server.add_socket, self.listener)
        self.loop.call_soon(self.look)
        self.loop.run_forever()
        self.loop.run_until_complete(asyncio.sleep(0))  # Tornado warns of a message not begun
        self.listener.close()
        self.loop.close()

    def address(self) -> str:
        """Return the address of the page that commands."""
        host, port = self.listener.getsockname()
        if host == "0.0.0.0":
            host = "127.0.0.1"
        return f"http://{host}:{port}/?key={self.keys['key']}"

    def close(self) -> None:
        """Tell all tabs that the program has ended, wait until they have heard it, and stop."""
        self.is_closing = True
        self.tabs.tell({"ended": True})
        for tab in [*self.tabs.tabs]:
            self.loop.call_soon_threadsafe(tab.close)
        end = time.monotonic() + FAREWELL
        while self.tabs.tabs and time.monotonic() < end:
            time.sleep(0.02)
        self.browser_start.delete_file()
        self.loop.call_soon_threadsafe(self.loop.stop)
        self.thread.join()

    def look(self) -> None:
        """Send each tab a sign of life; end the program when no tab may still come."""
        self.loop.call_later(LOOK, self.look)
        for tab in self.tabs.tabs:
            tab.send("")
        if not self.tabs.are_gone and not self.attendance.look():
            self.tabs.are_gone = True
            self.loop.call_later(LEAVE, self.stop_main)

    def stop_main(self) -> None:
        """Stop the program as Ctrl+C does; not on Windows, if it waits for you in the terminal."""
        if self.is_closing:
            return
        if hasattr(signal, "pthread_kill"):
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
        else:  # Windows
            interrupt_main()


class Guarded(RequestHandler):
    """A request that needs a key."""

    keys: tuple[str, ...] = ("key",)  # the names of the keys that are enough

    def initialize(self, server: Server) -> None:
        self.server = server

    def prepare(self) -> None:
        """Refuse a request without a key."""
        if not any(map(self.has, self.keys)):
            raise HTTPError(403, reason=NO_KEY)

    def has(self, name: str) -> bool:
        """Return whether the request has this key; the time that this takes betrays nothing."""
        given = self.get_query_argument(name, "")
        return secrets.compare_digest(given.encode(), self.server.keys[name].encode())

    def set_default_headers(self) -> None:
        self.set_header("Cache-Control", "no-cache")
        self.set_header("Referrer-Policy", "no-referrer")  # no other site hears of the key


class Page(Guarded):
    """The page: a path without a file name; the page itself adds a slash that is missing."""

    keys = "key", "follow"

    def get(self) -> None:
        if self.has("key"):
            self.server.attendance.wait(LOADING)
        self.finish(self.server.pages["key" if self.has("key") else "follow"])

    head = get  # a page whose connection was cut asks whether the program answers


class SavedFilm(Guarded):
    """The film of this run, as a file to save."""

    async def get(self) -> None:
        from support.page.server.film_file import film_as_html  # it takes a moment

        pictures = self.server.tabs.pictures()
        # In a thread of its own: a long run takes seconds, and the tabs go on meanwhile.
        self.finish(await asyncio.to_thread(film_as_html, pictures))


class File(RequestHandler):
    """A file that everybody can download."""

    def initialize(self, files: dict) -> None:
        self.files = files

    def get(self, name: str) -> None:
        if name not in self.files:
            raise HTTPError(404)
        self.set_header("Content-Type", TYPES[Path(name).suffix])
        self.set_header("Cache-Control", "no-cache")
        self.finish(self.files[name])


class Socket(Guarded, WebSocketHandler):
    """The websocket of a tab."""

    keys = "key", "follow"

    def check_origin(self, origin: str) -> bool:
        """Return whether a page from this address may connect: the key decides, not the name.

        "null" is a page that another one has shut in, or a file.
        """
        return origin != "null"

    def get_compression_options(self) -> dict[str, Any]:
        return {"compression_level": 1}  # a higher one takes more time than it saves

    def open(self) -> None:
        self.set_nodelay(True)
        connection: Any = self.ws_connection
        self.stream = connection.stream
        self.write_to_fd = self.stream.write_to_fd
        self.stream.write_to_fd = self.write_after_reading
        self.tab = Tab(self.send, self.close, not self.has("key"))
        if not self.tab.follows:
            self.server.attendance.welcome()
            self.server.browser_start.delete_file()
        self.server.tabs.open(self.tab)

    def send(self, message: str) -> None:
        with suppress(WebSocketClosedError):
            self.write_message(message)

    def write_after_reading(self, data: memoryview) -> int:
        """Write for Tornado; but let it first read what the browser has sent.

        This can say that the browser closes the tab. If a write failed before it is read, the tab
        would look like a cut connection.
        """
        if self.has_unread():
            raise BlockingIOError  # Tornado reads, and then writes again
        return self.write_to_fd(data)

    def has_unread(self) -> bool:
        """Return whether the browser has sent something that is not yet read."""
        try:
            return bool(self.stream.socket.recv(1, socket.MSG_PEEK))
        except OSError:  # there is nothing, or the browser has gone
            return False

    def on_message(self, message: str | bytes) -> None:
        self.server.tabs.receive(self.tab, message)

    def on_close(self) -> None:
        self.server.tabs.close(self.tab)
        if not self.tab.follows:
            self.server.attendance.lose(is_cut=self.close_code != TAB_IS_CLOSED)


def report(loop: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    """Print an error of the server, unless it only says that a browser has gone."""
    if not isinstance(context.get("exception"), OSError | WebSocketClosedError | None):
        loop.default_exception_handler(context)
