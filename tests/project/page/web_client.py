"""What asks the server of a page without a browser: a request, and a tab."""

import json
import socket
from contextlib import ExitStack, suppress
from http.client import HTTPConnection

from programs import SECONDS

BELOW = "/user/ann/proxy/8000/"  # a path at which a proxy shows the page


def ask(page, path, query="{key}", host="127.0.0.1", **headers):
    """Send a GET with exactly this path and query; return the connection and the answer.

    The query is the key if none is given.
    """
    connection = HTTPConnection(host, page.port, timeout=SECONDS)
    headers = {name.replace("_", "-"): text for name, text in headers.items() if text is not None}
    connection.request("GET", f"{path}?{query.format(key=page.query)}", headers=headers)
    return connection, connection.getresponse()


def get(*request, **headers):
    """Return the status, the headers and the content of the answer to a GET."""
    answer = ask(*request, **headers)[1]
    return answer.status, answer.headers, answer.read()


TEXT, GOODBYE = 0x81, 0x88  # the first bytes of messages of a websocket


class Tab(ExitStack):
    """A tab without a browser: a websocket, if the status of the answer is 101."""

    def __init__(self, page, query="{key}", origin="http://127.0.0.1", folder="/"):
        super().__init__()
        headers = {
            "Upgrade": "websocket",
            "Connection": "Upgrade",
            "Sec_WebSocket_Version": "13",
            "Sec_WebSocket_Key": "dGhlIHNhbXBsZSBub25jZQ==",
            "Origin": origin,
        }
        self.connection, self.answer = ask(page, f"{folder}ws", query, **headers)
        self.callback(self.connection.close)
        self.callback(self.answer.close)
        if self.answer.status == 101:
            self.callback(self.leave)

    def leave(self):
        """Say, as a browser, that the tab is closed, and wait until this is heard.

        A socket that closes with unread bytes takes it back.
        """
        with suppress(OSError):  # the program may have ended
            self.tell((1001).to_bytes(2, "big"), GOODBYE)
            self.connection.sock.shutdown(socket.SHUT_WR)
            self.answer.fp.read()

    def tell(self, message, kind=TEXT):
        """Send a short message, with an empty mask."""
        head = bytes([kind, len(message) | 0x80, 0, 0, 0, 0])
        self.connection.sock.sendall(head + message)

    def hear(self):
        """Return the next message of the program, and answer that the picture is drawn."""
        read = self.answer.fp.read
        while True:
            _, size = read(2)
            if size > 125:
                size = int.from_bytes(read({126: 2, 127: 8}[size]), "big")
            data = read(size)
            if data:  # else it is only a sign of life
                self.tell(b'["seen", 1]')
                return json.loads(data)
