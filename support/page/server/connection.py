"""A connection of a browser to the page's server: a request, or the websocket of a tab."""

import asyncio
import re
from http.client import HTTPException, parse_headers
from io import BytesIO
from typing import Any
from urllib.parse import parse_qs, urlsplit

from autobahn.asyncio.websocket import WebSocketServerProtocol
from autobahn.websocket.types import ConnectionDeny

from support.page.server.attendance import Attendance, CLOSED, LEFT, LOOK_AT_TABS, LOST
from support.page.server.site import HttpResponse, Site
from support.page.server.tabs import Tabs

CODES = {4001: CLOSED, 4000: LEFT, 1001: LEFT}  # with which the websocket of a page ends
SILENT = 10.0  # s after which a tab that does not answer is lost
SLOWEST = 2**13  # bytes/s: for this many bytes under way to it, a tab has 1 s more
LARGEST_HEAD = 2**14  # bytes of a request
MOST_WAITING = 64  # connections that are no websocket: when one more comes, the oldest one goes


class Connection(WebSocketServerProtocol):
    """A connection. Autobahn calls the methods with its own names."""

    def __init__(
        self, site: Site, attendance: Attendance, tabs: Tabs, waiting: dict["Connection", None]
    ) -> None:
        """Answer with this site; waiting has the connections that are no websocket, by age."""
        super().__init__()
        self.site = site
        self.attendance = attendance
        self.tabs = tabs
        self.waiting = waiting
        self.is_answered = False  # whether its request gets an answer
        self.page_name = ""  # the name of the page, which it keeps when its line is cut
        self.silent = 0.0  # s since its last sign of life

    # --- requests ------------------------------------------------------------------------------

    def connection_made(self, transport: Any) -> None:
        super().connection_made(transport)
        self.waiting[self] = None
        if len(self.waiting) > MOST_WAITING:
            oldest = next(iter(self.waiting))
            del self.waiting[oldest]
            oldest.transport.abort()

    def processHandshake(self) -> None:  # noqa: N802
        """Answer a request that asks for no websocket: autobahn would refuse HEAD and HTTP/1.0."""
        head, end, _ = self.data.partition(b"\r\n\r\n")
        if len(head) > LARGEST_HEAD:
            self.dropConnection(abort=True)
            return
        if not end or self.is_answered:
            return
        try:
            first_line, _, lines = head.partition(b"\r\n")
            method, target, version = first_line.decode("latin-1").split(" ")
            is_websocket = "Upgrade" in parse_headers(BytesIO(lines))
            address = urlsplit(target)
        except (ValueError, HTTPException):
            self.dropConnection(abort=True)
            return
        is_known = method in ("GET", "HEAD", "POST") and version.startswith("HTTP/1.")
        if is_websocket or not is_known:
            super().processHandshake()
            return
        self.is_answered = True
        self.openHandshakeTimeoutCall.cancel()  # type: ignore[has-type]
        self.openHandshakeTimeoutCall = None
        asyncio.ensure_future(self.answer(method, address.path, parse_qs(address.query)))

    async def answer(self, method: str, path: str, parameters: dict[str, list[str]]) -> None:
        """Send the answer to a request: its head, and its content."""
        try:
            response = await self.site.response_to(path.rpartition("/")[2], parameters)
        except Exception:
            response = HttpResponse("500 Internal Server Error")
        self.sendData(response.head())
        if method != "HEAD":
            self.sendData(response.content)
        self.dropConnection()

    # --- the websocket of a tab ----------------------------------------------------------------

    def onConnect(self, request: Any) -> None:  # noqa: N802
        has_origin = request.origin not in (None, "", "null")
        if not has_origin or not self.site.has_key(request.params):
            raise ConnectionDeny(ConnectionDeny.FORBIDDEN)

    def onOpen(self) -> None:  # noqa: N802
        parameters = self.http_request_params
        self.waiting.pop(self, None)
        self.page_name = parameters.get("page", [""])[0] or f"without a name, {id(self)}"
        for tab in [*self.tabs.tabs]:
            if tab.page_name == self.page_name:  # its line was cut, and nobody has said so yet
                self.tabs.close(tab)
                tab.dropConnection(abort=True)
        self.attendance.welcome(self.page_name, parameters.get("was", [""])[0])
        has = parameters.get("has", [""])[0]
        self.tabs.open(self, self.send, int(has) if re.fullmatch("[0-9]{1,15}", has) else 0)

    def look(self) -> None:
        """Give a sign of life to the tab, and ask for one.

        The tab is lost when it has given none for too long.
        """
        self.silent += LOOK_AT_TABS
        under_way = sum(self.tabs.tabs[self].under_way)
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
        if self in self.tabs.tabs:
            self.tabs.receive(self, data)

    def onClose(self, was_clean: bool, code: int | None, reason: str) -> None:  # noqa: N802
        """Hear of the end of a connection, also of one that was refused."""
        self.waiting.pop(self, None)
        if self in self.tabs.tabs:
            self.tabs.close(self)
            self.attendance.lose(self.page_name, CODES.get(code or 0, LOST))
