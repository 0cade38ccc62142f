"""The two servers of the page: what they do for the page, and for everyone else; and what they keep for a reload."""

import asyncio
import json
import re
import signal
import socket
from contextlib import suppress
from functools import partial
from http.client import HTTPConnection
from types import SimpleNamespace
from urllib.parse import urlsplit

import programs
import pytest
from programs import copy_project, end, first_lines, QUIETLY, running, SECONDS
from students import put_files
from whole_cradles import FIVE_CSV

from support.page import local_server
from support.page.local_server import Access, ELSEWHERE, NO_KEY, one_tab_only, page_sockets, port_of, RETURN
from support.page.replay import Replay

pytestmark = programs.needs_vpython

SECRET = "the secret"


def get(port, path, **headers):
    """Send a GET with exactly this path; return the connection, the answer, and its content."""
    connection = HTTPConnection("127.0.0.1", port, timeout=SECONDS)
    connection.request("GET", path, headers={name.replace("_", "-"): value for name, value in headers.items()})
    answer = connection.getresponse()
    return connection, answer, answer.read()


def shake_hands(port, query, **origin):
    """Ask this websocket for a connection; return it, and the status of the answer: 101 if it is accepted."""
    key = {"Sec_WebSocket_Version": "13", "Sec_WebSocket_Key": "dGhlIHNhbXBsZSBub25jZQ=="}
    connection, answer, _ = get(port, f"/{query}", Upgrade="websocket", Connection="Upgrade", **key, **origin)
    return connection.sock, answer.status


def open_tab(page):
    """Return the connection of a tab of the page with this address; the websocket is at the next port."""
    own = {"Origin": f"http://localhost:{page.port}"}
    connection, status = shake_hands(page.port + 1, f"?{page.query}", **own)
    assert status == 101
    return connection


# --- one program for most tests --------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A working folder with a secret, in a folder with a secret; both end as something that VPython serves."""
    return put_files(tmp_path_factory.mktemp("outside"), {"secret.js": SECRET, "working/secret.js": SECRET}) / "working"


@pytest.fixture(scope="module")
def site(folder):
    """The address of a program that waits for a browser, and prints nothing more; its query is the key."""
    program = copy_project(folder.parent, FIVE_CSV) / "src" / programs.PROGRAM.name
    with running(program, folder=folder, patience=60 * SECONDS) as process:
        yield urlsplit(first_lines(process))
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


@pytest.mark.parametrize("above", [0, 1], ids=["page", "websocket"])
def test_another_address_of_this_machine_does_not_answer(site, above):
    with pytest.raises(OSError):
        socket.create_connection(("127.0.0.2", site.port + above), timeout=SECONDS)


@pytest.mark.parametrize(
    "path", ["/secret.js", "/../secret.js", "/%2e%2e%2fsecret.js", "/.." * 40 + "{folder}/secret.js"]
)
def test_a_file_outside_is_not_found(site, folder, path):
    _, answer, content = get(site.port, path.format(folder=folder))
    assert answer.status == 404
    assert SECRET.encode() not in content


WRONG_KEYS = ["?", "?key=wrong", "?{key}0"]


@pytest.mark.parametrize("query", WRONG_KEYS)
def test_without_the_key_the_page_is_a_sentence(site, query):
    """A request can have all headers of a browser: another program on this machine can send it."""
    browser = {"Origin": f"http://localhost:{site.port}", "Sec_Fetch_Site": "same-origin"}
    _, answer, content = get(site.port, f"/{query.format(key=site.query)}", **browser)
    assert (answer.status, content.decode()) == (403, NO_KEY)
    assert site.query.removeprefix("key=") not in str(answer.headers)


def test_with_the_key_the_page_comes(site):
    """The page sends its address to no other site."""
    page = get(site.port, f"/?{site.query}")[2].decode()
    assert re.search(r"var sock = '(\d+)'", page)[1] == str(site.port + 1)
    assert '<meta name="referrer" content="no-referrer">' in page


@pytest.mark.parametrize(
    ("origin", "query"),
    [
        *((origin, "?{key}") for origin in ("http://example.org", "http://localhost:{websocket}", "null", None)),
        *(("http://localhost:{page}", query) for query in WRONG_KEYS),
    ],
)
def test_only_a_tab_of_the_page_gets_the_websocket(site, origin, query):
    """Another program on this machine can forge the Origin."""
    own = {"Origin": origin.format(page=site.port, websocket=site.port + 1)} if origin else {}
    assert shake_hands(site.port + 1, query.format(key=site.query), **own)[1] in (400, 403)


def test_connections_and_requests_without_sense_change_nothing(site):
    """A browser opens connections in advance; VPython's own server would wait for their requests."""
    for one in (site.port, site.port + 1):
        for request in (b"", b"GET /../secret.js HTTP/1.1\r\n\r\n", b"\0\xff\r\n\r\n", b"\x16\x03\r\n\r\n"):
            with suppress(ConnectionResetError), socket.create_connection(("127.0.0.1", one), timeout=SECONDS) as idle:
                idle.sendall(request)
                assert get(site.port, f"/?{site.query}")[1].status == 200


def test_a_tab_whose_browser_crashes_ends_the_program():
    """In the middle of a message. Before that, a message that would fill the memory closes the tab."""
    with running() as process:
        page = urlsplit(first_lines(process))
        get(page.port, f"/?{page.query}")
        with open_tab(page) as tab:
            tab.sendall(bytes([0x81, 0x80 | 127]) + (local_server.LARGEST_MESSAGE + 1).to_bytes(8, "big") + bytes(4))
            assert tab.recv(1) == b""
        with open_tab(page) as tab:
            tab.sendall(b"\x81\xff")
        assert end(process) == QUIETLY


@pytest.mark.parametrize(("options", "opened"), [([], True), (["--no-browser"], False)])
def test_the_program_opens_a_browser_unless_it_must_not(tmp_path, options, opened):
    """The browser here is a script that writes the address into a file. It never connects; Ctrl+C ends the program."""
    browser, visited = tmp_path / "browser", tmp_path / "visited"
    browser.write_text(f'#!/bin/sh\necho "$1" > {visited}.new && mv {visited}.new {visited}\n')
    browser.chmod(0o755)
    with running(None, *options, VPYTHON_NO_LAUNCH_BROWSER="", BROWSER=str(browser)) as process:
        address = first_lines(process)
        page = urlsplit(address)
        assert get(page.port, f"/?{page.query}")[1].status == 200  # VPython opens the browser, and then serves the page
        assert visited.exists() == opened
        assert not opened or visited.read_text().strip() == address
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_ports_are_taken_from_the_start_and_free_at_the_end():
    page, websocket = page_sockets(0)
    with page, websocket:
        port = port_of(page)
        assert port_of(websocket) == port + 1
        for number, whose in ((port, "the page's"), (port - 1, "the websocket's, one above")):
            with pytest.raises(ValueError, match=rf"port {port} \({whose}.* is not available: "):
                page_sockets(number)
        with socket.create_connection(("127.0.0.1", port)):
            page.accept()[0].close()  # the side that closes first keeps the connection's port busy for a while
    for again in page_sockets(port):
        again.close()


# --- the tab and the time it has to come back ------------------------------------------------------------------------


class Clock:
    """A clock, and an event loop, for an Access: time passes only in pass_time. It notes when the program ends."""

    def __init__(self, monkeypatch):
        self.now, self.timers, self.ends = 100.0, [], []
        monkeypatch.setattr("time.monotonic", lambda: self.now)
        monkeypatch.setattr("asyncio.get_running_loop", lambda: self)
        monkeypatch.setattr("os._exit", self.ends.append)

    def call_later(self, delay, function):
        self.timers.append((self.now + delay, function))

    def pass_time(self, seconds):
        self.now += seconds
        for timer in [timer for timer in self.timers if timer[0] <= self.now]:
            self.timers.remove(timer)
            timer[1]()


def test_the_program_ends_when_the_time_to_come_back_is_over(monkeypatch):
    """A tab that loads has longer: a slow machine loads the page for seconds before it opens the websocket."""
    clock, told = Clock(monkeypatch), []
    tab, other = (SimpleNamespace(tell=told.append) for _ in range(2))
    access = Access(lambda: None)
    assert access.key != Access(None).key  # each start has its own
    handler = type("Handler", (), {"mimes": {}, "path": f"/?key={access.key}", "do_GET": print})
    access.admit(tab)
    access.admit(other)
    clock.pass_time(100)
    access.tab_closed(other)
    clock.pass_time(0.8 * RETURN)
    local_server.own_files_only(handler, access)().do_GET()
    clock.pass_time(5 * RETURN)
    assert access.tab is None
    access.admit(tab)
    access.admit(other)
    access.tab_closed(tab)
    clock.pass_time(100)
    assert (access.tab, told) == (other, [ELSEWHERE] * 2)
    access.tab_closed(other)
    clock.pass_time(RETURN - 0.1)
    assert not clock.ends
    clock.pass_time(0.1)
    assert clock.ends == [0]


class Protocol:
    """In place of VPython's protocol: it answers each message with the next change. changes is one list for all."""

    changes: list = []
    onConnect = onOpen = lambda *_: None  # noqa: N815

    def __init__(self, key):
        self.got, self.sent, self.is_lost = b"", [], False
        self.onConnect(SimpleNamespace(origin="of the page", params={"key": [key]}))
        self.onOpen()

    async def onMessage(self, data, is_binary):  # noqa: N802
        self.got = data
        self.sendMessage(json.dumps({"attrs": [self.changes.pop(0)]}).encode(), isBinary=is_binary)

    def sendMessage(self, payload, isBinary=False):  # noqa: N802
        from autobahn.exception import Disconnected

        if self.is_lost:
            raise Disconnected("Attempt to send on a closed protocol")
        self.sent.append(payload if payload == ELSEWHERE else json.loads(payload)["attrs"])

    def ask(self, data=b"trigger"):
        asyncio.run(self.onMessage(data, False))


@pytest.fixture
def connect(monkeypatch):
    """A function that connects a tab to a websocket for one tab. Object 2 is a menu."""
    monkeypatch.setattr(Protocol, "changes", ["a1a1", "a1b2", "a1c3"])
    access, menu = Access(lambda: None), SimpleNamespace(choices=["a", "b"])
    return partial(one_tab_only(Protocol, access, {2: menu}), key=access.key)


def test_each_change_reaches_the_last_tab(connect):
    """A tab that was replaced takes none, and what a closing tab did not get is for the next one."""
    first = connect()
    first.ask()
    again = connect()
    first.ask()
    again.is_lost = True
    again.ask()
    again.is_lost = False
    last = connect()
    last.ask()
    assert (first.sent, again.sent, last.sent) == ([["a1a1"], ELSEWHERE], [ELSEWHERE], [["a1a1", "a1b2", "a1c3"]])


POSSIBLE = [
    *({"widget": "menu", "idx": 2, "value": value} for value in (0, 1)),
    *({"widget": kind, "idx": 3, "value": 0} for kind in ("button", "slider", "checkbox")),
    {"widget": "winput", "idx": 4, "value": None, "text": "[]"},
    {"event": "mousemove", "canvas": 0, "pos": [0, 1e-17, -2.5], "ray": [0, 0, -1]},
    {"event": "update_canvas", "canvas": 0, "forward": [0, 0, -1], "range": 0.3, "autoscale": False},
    {"event": "resize", "canvas": 0, "width": 320, "height": 200},
]
IMPOSSIBLE = [
    *({"widget": "menu", "idx": 2, "value": value} for value in (-1, 2)),
    *({"event": "resize", "canvas": 0, "width": width, "height": 200} for width in (0, None)),
    *({"event": "update_canvas", "canvas": 0, "range": size} for size in (0, None)),
    {"event": "mousemove", "canvas": 0, "pos": [0, 0, 0], "ray": [0, None, 0]},
]


def test_only_possible_events_reach_vpython(connect):
    tab = connect()
    tab.ask()
    assert tab.got == b"trigger"
    tab.ask(json.dumps([*IMPOSSIBLE, *POSSIBLE]).encode())
    assert json.loads(tab.got) == POSSIBLE


SPHERE, TEXT, CANVAS = {"cmd": "sphere", "idx": 1}, {"append_to_caption": "a", "idx": 0}, {"cmd": "canvas", "idx": 0}


@pytest.mark.parametrize(
    ("messages", "cmds", "attrs"),
    [
        ([], [], []),
        # Objects are made in their order, and texts are all kept.
        ([{"cmds": [CANVAS, TEXT]}, {"cmds": [SPHERE, TEXT]}], [CANVAS, TEXT, SPHERE, TEXT], []),
        # The last value of a setting of the canvas.
        ([{"cmds": [{"range": size, "idx": 0}]} for size in (1, 2)], [{"range": 2, "idx": 0}], []),
        # The last value of each attribute: object 12 is not object 1, and a1... is not b1...
        ([{"attrs": ["a12a0,0", "a1a0,0", "b12a5"]}, {"attrs": ["a12a4,5"]}], [], ["a1a0,0", "b12a5", "a12a4,5"]),
        # It comes after the values that it may change: to set the size of a shape changes its axis.
        ([{"attrs": ["a1f1,0,0"]}, {"attrs": ["a1g2,1,1"]}, {"attrs": ["a1f3,0,0"]}], [], ["a1g2,1,1", "a1f3,0,0"]),
        # A method is called once with each value.
        ([{"attrs": ["m0Gkey", "m0Gmouse"]}, {"attrs": ["a0t1", "m0Gkey"]}], [], ["m0Gmouse", "a0t1", "m0Gkey"]),
    ],
)
def test_a_reload_gets_one_message_with_the_result_of_all(messages, cmds, attrs):
    replay = Replay()
    for message in messages:
        replay.add(message)
    assert replay.message() == {"cmds": cmds, "attrs": attrs}
