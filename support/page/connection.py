"""A connection of a browser to the page's server: a request, or the websocket of a tab."""

import re
from pathlib import Path
from typing import Any, NamedTuple, TYPE_CHECKING
from urllib.parse import parse_qs

from autobahn.asyncio.websocket import WebSocketServerProtocol
from autobahn.websocket.types import ConnectionDeny

from support.page.tabs import LOOK_AT_TABS
from support.page.web_files import content_of, page_with

if TYPE_CHECKING:
    from support.page.server import Server

LOADS = ""  # stands for the name of a page that loads
LOADING = 30.0  # s that a page has from its request to its websocket
# s that a page has to come back
CLOSED = 3.0  # whose tab is closed for sure: a closed tab can be opened again
LEFT = 25.0  # that you have left, or closed: Back or a reload shows it again
LOST = 60.0  # that has said nothing: its line is cut, or its machine sleeps
GOODBYES = {"closed": CLOSED, "left": LEFT}  # what a page says in the end
CODES = {4001: CLOSED, 4000: LEFT, 1001: LEFT}  # with which its websocket then ends
SILENT = 10.0  # s after which a tab that does not answer is lost
SLOWEST = 2**13  # bytes/s: for this many bytes under way to it, a tab has 1 s more
LARGEST_HEAD = 2**14  # bytes of a request
MOST_WAITING = 64  # connections that are no websocket: when one more comes, the oldest one goes
# line.js knows by "ends with a key" that another program is at this port now.
NO_KEY = (
    "Open the whole address that the program has printed in the terminal: "
    "it ends with a key, new at each start.\n"
)
RUN_FILE = "run.html"  # the present run, as a file to save
TYPES = {
    ".html": "text/html",
    ".js": "text/javascript",
    ".css": "text/css",
    ".jpg": "image/jpeg",
    "": "text/plain",
}

Parameters = dict[str, list[str]]  # of a request, by name


class HttpResponse(NamedTuple):
    """The response to a request."""

    status: str
    kind: str  # a key of TYPES
    content: bytes


class Protocol(WebSocketServerProtocol):
    """A connection. Autobahn calls these methods."""

    site: "Server"
    page_name = ""  # the name of the page, which it keeps when its line is cut
    silent = 0.0  # s since its last sign of life
    rest = LOST  # s that its page has to come back, when the websocket has ended

    # --- requests ------------------------------------------------------------------------------

    def connection_made(self, transport: Any) -> None:
        super().connection_made(transport)
        waiting = self.site.waiting
        waiting[self] = None
        if len(waiting) > MOST_WAITING:
            oldest = next(iter(waiting))
            del waiting[oldest]
            oldest.transport.abort()

    def processHandshake(self) -> None:  # noqa: N802
        """Answer a request that asks for no websocket: autobahn would refuse HEAD and HTTP/1.0."""
        head, end, _ = self.data.partition(b"\r\n\r\n")
        if len(head) > LARGEST_HEAD:
            self.dropConnection(abort=True)
            return
        if not end:
            return
        request = re.match(r"(GET|HEAD|POST) ([^ ?]*)\??(\S*) HTTP/1\.", head.decode("latin-1"))
        if request and b"\nupgrade:" not in head.lower():
            method, path, query = request.groups()
            response = self.response_to(path.rpartition("/")[2], parse_qs(query))
            self.send_response(response, has_content=method != "HEAD")
            self.dropConnection()
        else:
            super().processHandshake()

    def send_response(self, response: HttpResponse, has_content: bool) -> None:
        """Send the head of a response, and its content."""
        head = [
            f"HTTP/1.1 {response.status}",
            f"Content-Type: {TYPES[response.kind]}; charset=utf-8",
            f"Content-Length: {len(response.content)}",
            "Connection: close",
            "Cache-Control: no-cache",
            "Referrer-Policy: no-referrer",  # no site that the page leads to hears of the key
        ]
        self.sendData("\r\n".join([*head, "", ""]).encode())
        if has_content:
            self.sendData(response.content)

    def response_to(self, name: str, parameters: Parameters) -> HttpResponse:
        """Return the response to a path whose last part is name.

        Without a point in it, it is no file: a proxy's address may lack its last slash. The page
        then adds it.
        """
        site = self.site
        if name in site.files:
            return HttpResponse("200 OK", Path(name).suffix, content_of(site.files[name]))
        has_run = site.tabs.all.number > 0
        if "." in name and not (name == RUN_FILE and has_run):
            return HttpResponse("404 Not Found", "", b"")
        if not site.has_key(parameters):
            return HttpResponse("403 Forbidden", "", NO_KEY.encode())
        if name == RUN_FILE:
            from support.page.run_file import run_as_html  # not at the start: it takes a moment

            return HttpResponse("200 OK", ".html", run_as_html(site.tabs).encode())
        if name == "alive":
            return HttpResponse("200 OK", "", b"alive")
        if name in GOODBYES:
            site.leave(parameters.get("page", ["no name"])[0], GOODBYES[name])
            return HttpResponse("200 OK", "", b"")
        site.expect(LOADS, LOADING)
        return HttpResponse("200 OK", ".html", page_with(site.texts))

    # --- the websocket of a tab ----------------------------------------------------------------

    def onConnect(self, request: Any) -> None:  # noqa: N802
        has_origin = request.origin not in (None, "", "null")
        if not has_origin or not self.site.has_key(request.params):
            raise ConnectionDeny(ConnectionDeny.FORBIDDEN)

    def onOpen(self) -> None:  # noqa: N802
        site = self.site
        parameters = self.http_request_params
        site.waiting.pop(self, None)
        self.page_name = parameters.get("page", [""])[0] or f"without a name, {id(self)}"
        for tab in [*site.tabs.tabs]:
            if tab.page_name == self.page_name:  # its line was cut, and nobody has said so yet
                site.tabs.close(tab)
                tab.dropConnection(abort=True)
        site.welcome(self.page_name, parameters.get("was", [""])[0])
        has = parameters.get("has", [""])[0]
        site.tabs.open(self, self.send, int(has) if re.fullmatch("[0-9]{1,15}", has) else 0)

    def look(self) -> None:
        """Give a sign of life to the tab, and ask for one.

        The tab is lost when it has given none for too long.
        """
        self.silent += LOOK_AT_TABS
        under_way = sum(self.site.tabs.tabs[self].under_way)
        if self.silent > SILENT + under_way / SLOWEST:
            self.dropConnection(abort=True)
        else:
            self.send(b"")
            self.sendPing()

    def send(self, message: bytes) -> None:
        if self.state == self.STATE_OPEN and not self.transport.is_closing():
            self.sendMessage(message)

    def onPong(self, _: bytes) -> None:  # noqa: N802
        self.silent = 0.0

    def onMessage(self, data: bytes, is_binary: bool) -> None:  # noqa: N802
        self.silent = 0.0
        if self in self.site.tabs.tabs:
            self.site.tabs.receive(self, data)

    def onClose(self, was_clean: bool, code: int | None, reason: str) -> None:  # noqa: N802
        """Hear of the end of a connection, also of one that was refused."""
        site = self.site
        site.waiting.pop(self, None)
        if self not in site.tabs.tabs:
            return
        site.tabs.close(self)
        site.expect(self.page_name, min(self.rest, CODES.get(code or 0, LOST)))
