"""What asks the server of a page without a browser: a request, and a tab."""

import asyncio
import json
from concurrent.futures import ThreadPoolExecutor
from http.client import HTTPConnection

from programs import SECONDS
from tornado.httpclient import HTTPRequest
from tornado.websocket import websocket_connect

BELOW = "/user/ann/proxy/8000/"  # a path at which a proxy shows the page


def get(page, path, query="{key}"):
    """Return the status, the headers and the content of the answer to a GET of exactly this path.

    The query is the key if none is given.
    """
    connection = HTTPConnection("127.0.0.1", page.port, timeout=SECONDS)
    connection.request("GET", f"{path}?{query.format(key=page.query)}")
    answer = connection.getresponse()
    return answer.status, answer.headers, answer.read()


class Tab:
    """A tab without a browser: a websocket.

    Raises Tornado's HTTPClientError if it is refused.
    """

    def __init__(self, page, query="{key}", origin="http://127.0.0.1", folder="/"):
        self.loop = asyncio.new_event_loop()
        address = f"ws://127.0.0.1:{page.port}{folder}ws?{query.format(key=page.query)}"
        self.socket = self.do(websocket_connect, HTTPRequest(address, headers={"Origin": origin}))

    def do(self, function, *arguments):
        """Return the result of a function for which one must wait.

        In a thread of its own: in this one, Playwright may have its loop.
        """

        async def wait():
            return await asyncio.wait_for(function(*arguments), SECONDS)

        with ThreadPoolExecutor() as thread:
            return thread.submit(self.loop.run_until_complete, wait()).result()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Say, as a browser, that the tab is closed, and wait until the program has heard it."""
        self.do(self.leave)
        self.loop.close()

    async def leave(self):
        self.socket.close(1001)
        while await self.socket.read_message() is not None:
            pass

    def tell(self, message):
        self.do(self.socket.write_message, message)

    def hear(self):
        """Return the next message of the program, and answer that the picture is drawn."""
        message = ""
        while message == "":  # only a sign of life
            message = self.do(self.socket.read_message)
        self.tell('["seen", 1]')
        return json.loads(message)
