"""A connection of a browser to the page's server: a request, or the websocket of a tab."""

import asyncio
from typing import Any
from urllib.parse import parse_qs, urlsplit

from autobahn.asyncio.websocket import WebSocketServerProtocol
from autobahn.websocket.types import ConnectionDeny

from support.page.server.attendance import Attendance, CLOSED, LEFT, LOOK_AT_TABS, LOST
from support.page.server.site import Site
from support.page.server.tabs import Tabs

CODES = {4001: CLOSED, 4000: LEFT, 1001: LEFT}  # with which the websocket of a page ends
SILENT = 10.0  # s after which a tab that does not answer is lost
SLOWEST = 2**13  # bytes/s: for this many bytes under way to it, a tab has 1 s more


class Connection(WebSocketServerProtocol):
    """A connection. Autobahn calls the methods with its own names."""

    def __init__(self, site: Site, attendance: Attendance, tabs: Tabs) -> None:
        super().__init__()
        self.site = site
        self.attendance = attendance
        self.tabs = tabs
        self.page_name = ""  # the name of the page, which it keeps when its line is cut
        self.silent = 0.0  # s since its last sign of life

    # --- requests ------------------------------------------------------------------------------

    def processHandshake(self) -> None:  # noqa: N802
        """Answer a request that asks for no websocket; leave the others to autobahn."""
        head, end, _ = self.data.decode("latin-1").partition("\r\n\r\n")
        if not end or "\r\nupgrade:" in head.lower():
            super().processHandshake()
            return
        _, target, _ = head.split(" ", 2)  # GET /?key=... HTTP/1.1
        address = urlsplit(target)
        self.openHandshakeTimeoutCall.cancel()  # type: ignore[has-type]
        asyncio.ensure_future(self.answer(address.path, parse_qs(address.query)))

    async def answer(self, path: str, parameters: dict[str, list[str]]) -> None:
        """Send the answer to a request, and end the connection."""
        try:
            response = await self.site.response_to(path.rpartition("/")[2], parameters)
            self.sendData(response.head() + response.content)
        finally:
            self.dropConnection()

    # --- the websocket of a tab ----------------------------------------------------------------

    def onConnect(self, request: Any) -> None:  # noqa: N802
        if not request.origin or not self.site.has_key(request.params):
            raise ConnectionDeny(ConnectionDeny.FORBIDDEN)

    def onOpen(self) -> None:  # noqa: N802
        parameters = self.http_request_params
        self.page_name = parameters["page"][0]
        for tab in [*self.tabs.tabs]:
            if tab.page_name == self.page_name:  # its line was cut, and nobody has said so yet
                self.tabs.close(tab)
                tab.dropConnection(abort=True)
        self.attendance.welcome(self.page_name, parameters.get("was", [""])[0])
        self.tabs.open(self, self.send, int(parameters["has"][0]))

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
        if self in self.tabs.tabs:
            self.tabs.close(self)
            self.attendance.lose(self.page_name, CODES.get(code or 0, LOST))
