"""What the server answers: the page, its files, and the run as a file to save.

The page asks for everything relative to its own address, and the server looks only at the last part
of a path. So it works below any path, behind any name and any port: an SSH tunnel, a hosted
editor's proxy, a container. The key decides who gets the page and the websocket; a program has a
new one at each start. Files that everybody can download (VPython's and the page's) need no key.
"""

import asyncio
import secrets
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from support.page.names import Texts
from support.page.server.attendance import Attendance, CLOSED, LEFT
from support.page.server.film import FilmPicture
from support.page.server.web_files import content_of, keyless_files, page_with

GOODBYES = {"closed": CLOSED, "left": LEFT}  # what a page says in the end
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
    kind: str = ""  # a key of TYPES
    content: bytes = b""

    def head(self) -> bytes:
        """Return the lines before the content."""
        lines = [
            f"HTTP/1.1 {self.status}",
            f"Content-Type: {TYPES[self.kind]}; charset=utf-8",
            f"Content-Length: {len(self.content)}",
            "Connection: close",
            "Cache-Control: no-cache",
            "Referrer-Policy: no-referrer",  # no site that the page leads to hears of the key
        ]
        return "\r\n".join([*lines, "", ""]).encode()


class Site:
    """The files, the key, and the answers."""

    def __init__(
        self,
        texts: Texts,
        attendance: Attendance,
        film: Callable[[], Sequence[FilmPicture]],
    ) -> None:
        """Answer with these texts in the page (by name), and with the pictures of film()."""
        self.texts = texts
        self.attendance = attendance
        self.film = film
        self.files = keyless_files()
        # Short, and without signs that end an address in some terminals.
        self.key = secrets.token_hex(12)

    def has_key(self, parameters: Parameters) -> bool:
        """Return whether a request with these parameters has the key.

        The answer comes as quickly for each wrong key.
        """
        return secrets.compare_digest(parameters.get("key", [""])[0].encode(), self.key.encode())

    async def response_to(self, name: str, parameters: Parameters) -> HttpResponse:
        """Return the response to a path whose last part is name.

        Without a point in it, it is no file: a proxy's address may lack its last slash. The page
        then adds it.
        """
        if name in self.files:
            return HttpResponse("200 OK", Path(name).suffix, content_of(self.files[name]))
        if "." in name and name != RUN_FILE:
            return HttpResponse("404 Not Found")
        if not self.has_key(parameters):
            return HttpResponse("403 Forbidden", content=NO_KEY.encode())
        if name == RUN_FILE:
            pictures = self.film()
            if not pictures:
                return HttpResponse("404 Not Found")
            from support.page.server.run_file import (
                run_as_html,  # not at the start: it takes a moment
            )

            # In a thread of its own: a long run takes seconds, and the tabs go on meanwhile.
            return HttpResponse("200 OK", ".html", await asyncio.to_thread(run_as_html, pictures))
        if name == "alive":
            return HttpResponse("200 OK", content=b"alive")
        if name in GOODBYES:
            self.attendance.lose(parameters["page"][0], GOODBYES[name])
            return HttpResponse("200 OK")
        self.attendance.expect_one_that_loads()
        return HttpResponse("200 OK", ".html", page_with(self.texts))
