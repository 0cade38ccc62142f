"""The server of the page: one port for HTTP and for the websocket, a key, and the page's own files.

- The page asks for everything relative to its own address, and the server looks only at the last
part of a path. So it
  works below any path, behind any name and any port: an SSH tunnel, a hosted editor's proxy, a
  container.
- The key decides who gets the page and the websocket; a program has a new one at each start. The
websocket also needs
  an Origin, which a browser always sends. Files that everybody can download (VPython's and the
  page's) need no key.
- It listens at 127.0.0.1 alone, unless --host says otherwise, and prints nothing that a client
sends. - A page says goodbye when it is left. When the last tab is closed, and none begins to load
within RETURN seconds, the
  program ends. A page that is lost without a goodbye has a longer time, LOST.
- Times are counted in looks, one each LOOK seconds: while a laptop sleeps, nobody loses time.
"""

import asyncio
import logging
import platform
import re
import secrets
import socket
import tempfile
import threading
import time
import webbrowser
from _thread import interrupt_main
from contextlib import suppress
from importlib.util import find_spec
from math import inf
from pathlib import Path
from urllib.parse import parse_qs

import txaio
from autobahn.asyncio.websocket import WebSocketServerFactory, WebSocketServerProtocol
from autobahn.websocket.types import ConnectionDeny

from support.page.tabs import LOOK, Tabs
from support.start.output import say

# S that a closed tab has to come back, and a page from its request to its websocket
RETURN = 3.0
LOADING = 30.0
FLICKER = 3.0  # s after which the terminal says that a page is lost
# S that a page has to come back which has said no goodbye: its line is cut, or its machine sleeps
LOST = 60.0
# S after which a tab that does not answer is lost; bytes/s of what is under way to it
SILENT = 10.0
SLOWEST = 2**13
FAREWELL = 0.3  # s that the tabs have to hear of the end
# S that main has to end without a tab; then Ctrl+C ends it: it may be in a loop that never ends
LEAVE = 1.0
# bytes, either way; closes the websocket of a tab that sends more: it would stay in memory
LARGEST_MESSAGE = 2**26
LARGEST_HEAD = 2**14  # bytes of a request
MOST_WAITING = 64  # connections that are no websocket: when one more comes, the oldest one goes
NO_KEY = "Open the whole address that the program has printed in the terminal: it ends with a key, new at each start.\n"
TYPES = {
    ".html": "text/html",
    ".js": "text/javascript",
    ".css": "text/css",
    ".jpg": "image/jpeg",
    "": "text/plain",
}
# Where glowcomm.html has its fonts and its own websocket behind it
VPYTHON_SCRIPT = "window.__GSlang ="
TEXT_BROWSERS = {"www-browser", "links", "links2", "elinks", "lynx", "w3m"}  # they have no canvas
# Ports that browsers refuse (https://fetch.spec.whatwg.org/#port-blocking).
REFUSED = """
1 7 9 11 13 15 17 19 20 21 22 23 25 37 42 43 53 69 77 79 87 95 101 102 103 104 109 110 111 113 115 117 119 123 135 137
139 143 161 179 389 427 465 512 513 514 515 526 530 531 532 540 548 554 556 563 587 601 636 989 990 993 995 1719 1720
1723 2049 3659 4045 4190 5060 5061 6000 6566 6665 6666 6667 6668 6669 6679 6697 10080
"""


def listen(host, port) -> socket.socket:
    """Return a socket that listens at this address and port; port 0 finds a free one.

    Raises a ValueError with a one-line message if it is not available, or if browsers refuse the
    port.
    """
    try:
        if str(port) in REFUSED.split():
            raise OSError(0, "browsers refuse it")
        family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        listener = socket.socket(family, kind)
        # With SO_REUSEADDR, the port of a program that has just ended is free. On Windows,
        # SO_REUSEADDR would share a port in use; SO_EXCLUSIVEADDRUSE prevents this.
        listener.setsockopt(
            socket.SOL_SOCKET, getattr(socket, "SO_EXCLUSIVEADDRUSE", socket.SO_REUSEADDR), 1
        )
        listener.bind(address)
        listener.listen()
    except (socket.gaierror, UnicodeError) as error:
        raise ValueError(
            f"--host: found {host!r}, allowed is an address of this machine"
        ) from error
    except OSError as error:
        choice = "choose another --port, or 0 for any free one"
        raise ValueError(
            f"port {port} of {host} is not available: {error.strerror}; {choice}"
        ) from error
    # Of port 0
    return listener if str(listener.getsockname()[1]) not in REFUSED.split() else listen(host, port)


def own_files() -> dict[str, bytes | Path]:
    """Return the files that need no key, by name: the content or the path."""
    [vpython] = find_spec("vpython").submodule_search_locations  # type: ignore[union-attr, misc]
    libraries, web = Path(vpython, "vpython_libraries"), Path(__file__).with_name("web")
    paths = [
        path
        for folder in (libraries, Path(vpython, "vpython_data"), web)
        for path in folder.iterdir()
    ]
    files: dict[str, bytes | Path] = {
        path.name: path for path in paths if path.suffix in (".js", ".css", ".jpg")
    }
    _, begin, script = (
        (libraries / "glowcomm.html").read_text(encoding="utf-8").partition(VPYTHON_SCRIPT)
    )
    files["vpython.js"] = (begin + script).partition("</script>")[0].encode()
    return files


def browser_is_outside() -> bool:
    """Return whether the browser belongs to another system around this one: Windows around WSL, or
    ChromeOS.
    """
    return "microsoft" in platform.release().lower() or Path("/dev/.cros_milestone").exists()


class Server:
    """Serves the page in a thread of its own, from the moment when it is made until close or the
    program's end.
    """

    def __init__(self, listener, tabs: Tabs):
        """Serve at this socket, made by listen."""
        self.listener, self.tabs = listener, tabs
        # short, and without signs that end an address in some terminals
        self.key = secrets.token_hex(12)
        # The connections that are no websocket, the oldest one first
        self.waiting: dict[Protocol, None] = {}
        # S for which a page is expected yet, by the name of a lost page; "" is any page
        self.expected = {"": inf}
        self.is_missed = False  # whether the terminal says that a page does not answer
        self.files, self.page = own_files(), Path(__file__).with_name("web") / "page.html"
        self.way: Path | None = None  # the file that leads a browser to the page
        ready = threading.Event()
        threading.Thread(target=self.serve, args=(ready,), daemon=True).start()
        ready.wait()

    def serve(self, ready) -> None:
        """Set ready, and answer requests until the loop is stopped."""
        logging.getLogger("autobahn").setLevel(logging.CRITICAL)  # it quotes refused clients
        # On Windows, the usual loop stops listening if a connection ends before it is accepted.
        self.loop = txaio.config.loop = asyncio.SelectorEventLoop()  # type: ignore[attr-defined]
        self.loop.set_exception_handler(lambda *_: None)  # of autobahn, at requests without sense
        asyncio.set_event_loop(self.loop)
        factory = WebSocketServerFactory(loop=self.loop)
        factory.protocol = type("Protocol", (Protocol,), {"site": self})
        factory.setProtocolOptions(
            maxFramePayloadSize=LARGEST_MESSAGE, maxMessagePayloadSize=LARGEST_MESSAGE
        )
        factory.setProtocolOptions(webStatus=False)
        self.loop.run_until_complete(self.loop.create_server(factory, sock=self.listener))
        self.tabs.in_server = self.loop.call_soon_threadsafe
        self.loop.call_soon(self.look)
        self.loop.call_soon(ready.set)
        self.loop.run_forever()

    def address(self) -> str:
        """Return the address of the page, with the key."""
        host, port, *_ = self.listener.getsockname()
        host = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host)
        return f"http://{f'[{host}]' if ':' in host else host}:{port}/?key={self.key}"

    def open_browser(self) -> None:
        """Open the page in the usual browser, if it is one with pictures.

        All users of a machine can read the command of a browser. So the browser gets a file that
        only you can read, and that leads on to the address with the key; Jupyter does the same. The
        file is in the working folder, if it can be: a browser from a snap cannot read the folder
        for temporary files. Where the browser cannot see any file of this system, it gets the
        address itself; such a system has one user.
        """
        with suppress(webbrowser.Error, OSError):
            browser = webbrowser.get()
            if Path(getattr(browser, "name", "")).name in TEXT_BROWSERS:
                return
            place = self.address() if browser_is_outside() else self.make_way()
            threading.Thread(target=browser.open, args=(place,), daemon=True).start()

    def make_way(self) -> str:
        """Make the file that leads a browser to the page; return its address. Raises an OSError."""
        try:
            number, name = tempfile.mkstemp(".html", "open-cradle-", Path.cwd())  # with mode 600
        except OSError:
            number, name = tempfile.mkstemp(".html", "open-cradle-")
        self.way = Path(name)
        with open(number, "w", encoding="utf-8") as file:
            file.write(f'<meta http-equiv="refresh" content="0; url={self.address()}">')
        return self.way.as_uri()

    def forget_way(self) -> None:
        """Delete the file that leads a browser to the page."""
        with suppress(OSError):
            if self.way:
                self.way.unlink(missing_ok=True)

    def close(self, patience=FAREWELL) -> None:
        """Tell all tabs that the program has ended, wait so long (s) until they have heard it, and
        stop.
        """
        if self.tabs.last.get("ended") is None:
            self.tabs.in_server(self.tabs.deliver, {"ended": ""}, {})
        self.loop.call_soon_threadsafe(lambda: [tab.sendClose() for tab in [*self.tabs.tabs]])
        end = time.monotonic() + patience
        while self.tabs.tabs and time.monotonic() < end:
            time.sleep(0.02)
        self.forget_way()
        self.loop.call_soon_threadsafe(self.loop.stop)
        self.listener.close()

    def has_key(self, parameters) -> bool:
        """Return whether a request with these parameters, lists by name, has the key; as quickly
        for each wrong key.
        """
        return secrets.compare_digest(parameters.get("key", [""])[0].encode(), self.key.encode())

    def expect(self, seconds, page="") -> None:
        """Expect the page with this name, or any page, for so long from now on, at least."""
        self.expected[page] = max(self.expected.get(page, 0.0), seconds)

    def leave(self, page) -> None:
        """Hear that the page with this name is left, before or after its websocket has ended."""
        for tab in self.tabs.tabs:
            if tab.page == page:
                tab.has_said_goodbye = True
        if self.expected.pop(page, None) is not None:
            self.expect(RETURN)

    def look(self) -> None:
        """Look at each tab, and end the program when none is there, and none is expected any more."""
        self.loop.call_later(LOOK, self.look)
        rests = {page: rest - LOOK for page, rest in self.expected.items()}
        self.expected = {page: rest for page, rest in rests.items() if rest >= 0}
        self.tabs.look()
        for tab in [*self.tabs.tabs]:
            tab.look()
        if self.tabs.tabs or self.tabs.are_gone:
            return
        if not self.expected:
            self.tabs.are_gone = True
            self.loop.call_later(LEAVE, interrupt_main)
        lost = max((rest for page, rest in self.expected.items() if page), default=inf)
        if lost <= LOST - FLICKER and not self.is_missed:
            self.is_missed = True
            cause = "its line is cut, its machine sleeps, or its browser has ended"
            say(f"A page does not answer: {cause}. The program waits {lost:.0f} s for it.")


class Protocol(WebSocketServerProtocol):
    """A connection: a request for a file or for the page, or a tab's websocket.

    Autobahn calls these methods.
    """

    site: Server
    page = ""  # the name of the page, which it keeps when its line is cut
    silent = 0.0  # s since its last sign of life
    has_said_goodbye = False

    def connection_made(self, transport) -> None:
        super().connection_made(transport)
        self.site.waiting[self] = None
        if len(self.site.waiting) > MOST_WAITING:
            oldest = next(iter(self.site.waiting))
            del self.site.waiting[oldest]
            oldest.transport.abort()

    def processHandshake(self) -> None:  # noqa: N802
        """Answer a request that asks for no websocket: autobahn would refuse HEAD and HTTP/1.0."""
        head, end, _ = self.data.partition(b"\r\n\r\n")
        request = re.match(r"(GET|HEAD|POST) ([^ ?]*)\??(\S*) HTTP/1\.", head.decode("latin-1"))
        if len(head) > LARGEST_HEAD:
            self.dropConnection(abort=True)
        elif end and request and b"\nupgrade:" not in head.lower():
            self.answer(*request.groups())
            self.dropConnection()
        elif end:
            super().processHandshake()

    def answer(self, method, path, query) -> None:
        status, kind, content = self.content(path.rpartition("/")[2], parse_qs(query))
        head = [
            f"HTTP/1.1 {status}",
            f"Content-Type: {TYPES[kind]}; charset=utf-8",
            f"Content-Length: {len(content)}",
        ]
        # No site that the page leads to hears of the key.
        head += [
            "Connection: close",
            "Cache-Control: no-cache",
            "Referrer-Policy: no-referrer",
            "",
            "",
        ]
        self.sendData("\r\n".join(head).encode())
        if method != "HEAD":
            self.sendData(content)

    def content(self, name, parameters) -> tuple[str, str, bytes]:
        """Return the status, the kind and the content for a path whose last part is name.

        Without a point in it, it is no file: a proxy's address may lack its last slash. The page
        then adds it.
        """
        site = self.site
        if name in site.files:
            content = site.files[name]
            return (
                "200 OK",
                Path(name).suffix,
                content if isinstance(content, bytes) else content.read_bytes(),
            )
        if "." in name:
            return "404 Not Found", "", b""
        if not site.has_key(parameters):
            return "403 Forbidden", "", NO_KEY.encode()
        if name == "alive":
            return "200 OK", "", b"alive"
        if name == "goodbye":
            site.leave(parameters.get("page", ["no name"])[0])
            return "200 OK", "", b""
        site.expect(LOADING)
        return "200 OK", ".html", site.page.read_bytes()

    def onConnect(self, request) -> None:  # noqa: N802
        if request.origin in (None, "", "null") or not self.site.has_key(request.params):
            raise ConnectionDeny(ConnectionDeny.FORBIDDEN)

    def onOpen(self) -> None:  # noqa: N802
        site, parameters = self.site, self.http_request_params
        site.waiting.pop(self, None)
        self.page = parameters.get("page", [""])[0] or f"without a name, {id(self)}"
        has = parameters.get("has", [""])[0]
        for tab in [*site.tabs.tabs]:
            if tab.page == self.page:  # its line was cut, and nobody has said so yet
                site.tabs.close(tab)
                tab.dropConnection(abort=True)
        site.expected.pop("", None)
        rest = site.expected.pop(self.page, None)
        if site.is_missed and rest is not None:
            say("The page is back.")
        site.is_missed = False
        site.tabs.open(self, self.tell, int(has) if re.fullmatch("[0-9]{1,15}", has) else 0)
        site.forget_way()

    def look(self) -> None:
        """Give a sign of life to the tab, and ask for one; the tab is lost when it has given none
        for too long.
        """
        self.silent += LOOK
        if self.silent > SILENT + sum(self.site.tabs.tabs[self].under_way) / SLOWEST:
            self.dropConnection(abort=True)
        else:
            self.tell(b"")
            self.sendPing()

    def tell(self, message) -> None:
        if self.state == self.STATE_OPEN and not self.transport.is_closing():
            self.sendMessage(message)

    def onPong(self, _) -> None:  # noqa: N802
        self.silent = 0.0

    def onMessage(self, data, is_binary) -> None:  # noqa: N802
        self.silent = 0.0
        if self in self.site.tabs.tabs:
            self.site.tabs.receive(self, data)

    def onClose(self, was_clean, code, reason) -> None:  # noqa: N802  also of a connection that was refused
        site = self.site
        site.waiting.pop(self, None)
        if self not in site.tabs.tabs:
            return
        site.tabs.close(self)
        # Firefox's word, if you go on from it
        if self.has_said_goodbye or code == self.CLOSE_STATUS_CODE_GOING_AWAY:
            site.expect(RETURN)
        else:
            site.expect(LOST, self.page)
