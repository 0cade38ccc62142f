"""Closed doors: what the running program's two servers do with anyone but its own page in a browser on this machine."""

import asyncio
import http.client
import json
import re
import signal
import socket
from collections import Counter
from contextlib import suppress
from functools import partial
from importlib.machinery import PathFinder
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import quote

import pytest
from programs import (
    BOBS,
    copy_project,
    end,
    first_lines,
    needs_vpython,
    open_cradle,
    port_in,
    PROGRAM,
    QUIETLY,
    refusal,
    running,
    SECONDS,
    wait_until,
)
from whole_cradles import FIVE_CSV

from support.constants import R_PARAM
from support.page.local_server import (
    ELSEWHERE,
    LARGEST_MESSAGE,
    NO_KEY,
    one_tab_only,
    own_files_only,
    page_sockets,
    Place,
    port_of,
    RETURN,
)

pytestmark = needs_vpython

SECRET = "the secret"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A working folder with a secret, in a folder with a secret; both end as something that VPython serves."""
    folder = tmp_path_factory.mktemp("outside") / "working"
    folder.mkdir()
    for place in (folder, folder.parent):
        (place / "secret.js").write_text(SECRET)
    return folder


@pytest.fixture(scope="module")
def address(folder):
    """The address of a program that runs for all tests here, started in that folder."""
    project = copy_project(folder.parent, FIVE_CSV)
    with running(project / "src" / PROGRAM.name, folder=folder) as process:
        yield first_lines(process)
        assert process.poll() is None


@pytest.fixture(scope="module")
def port(address):
    """The port of that program; its websocket is at port + 1."""
    return port_in(address)


def key_in(address):
    """Return the key in the address of the page."""
    return address.partition("?key=")[2]


def answer(port, request):
    """Send a request as it stands, and return all that comes back."""
    with socket.create_connection(("127.0.0.1", port), timeout=SECONDS) as connection:
        connection.sendall(request)
        return b"".join(iter(lambda: connection.recv(100_000), b""))


def get(port, path):
    """Return the (status, body) of the answer to a GET with exactly this path."""
    head, _, body = answer(port, f"GET {path} HTTP/1.0\r\n\r\n".encode()).partition(b"\r\n\r\n")
    return int(head.split()[1]), body


def shake_hands(port, *headers, path="/?tab=any"):
    """Ask this websocket for a connection; return the connection and the answer's status, 101 if it is accepted."""
    connection = socket.create_connection(("127.0.0.1", port), timeout=SECONDS)
    key = "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ=="
    lines = [
        f"GET {path} HTTP/1.1",
        f"Host: localhost:{port}",
        "Upgrade: websocket",
        "Connection: Upgrade",
        key,
        *headers,
    ]
    connection.sendall("".join(f"{line}\r\n" for line in [*lines, ""]).encode())
    reply = connection.makefile("rb", buffering=0)  # takes nothing of the frames that can follow the headers at once
    status = int(reply.readline().split()[1])
    http.client.parse_headers(reply)
    return connection, status


def stranger(port, *headers, path="/?tab=any"):
    """Return the status that a stranger at this websocket gets, who then goes away."""
    connection, status = shake_hands(port, *headers, path=path)
    connection.close()
    return status


def address_in_the_network():
    """Return the address under which other machines know this one; raises an OSError without a network."""
    with socket.socket(type=socket.SOCK_DGRAM) as probe:
        probe.connect(("198.51.100.1", 9))  # sends nothing, only chooses an address
        return probe.getsockname()[0]


@pytest.mark.parametrize("find_address", [lambda: "127.0.0.2", address_in_the_network], ids=["loopback", "network"])
@pytest.mark.parametrize("above", [0, 1], ids=["page", "websocket"])
def test_from_another_address_nobody_answers(port, above, find_address):
    with socket.create_server(("", 0)) as anyone:
        try:
            address = find_address()
            socket.create_connection((address, port_of(anyone)), timeout=SECONDS).close()
        except OSError as error:
            pytest.skip(f"this machine has no such address: {error}")
    socket.create_connection(("127.0.0.1", port + above), timeout=SECONDS).close()
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection((address, port + above), timeout=SECONDS)


SPELLINGS = {
    "plain": lambda path: path,
    "doubled slashes": lambda path: path.replace("/", "//"),
    "backslashes": lambda path: path.replace("/", "\\"),
    "one slash, then backslashes": lambda path: "/" + path[1:].replace("/", "\\"),
    "encoded dots": lambda path: path.replace(".", "%2e").replace("%2ejs", ".js"),
    "encoded slashes": lambda path: "/" + path[1:].replace("/", "%2F"),
    "all encoded": lambda path: "/" + "".join(f"%{ord(letter):02x}" for letter in path[1:]),
    "encoded twice": lambda path: "/" + quote(quote(path[1:].replace("/", "%2f"))),
    "without a slash": lambda path: path[1:],
    "with a null byte": lambda path: path + "%00.js",
    "with a query": lambda path: path + "?.js",
    "with an address": lambda path: "http://localhost" + path,
}


@pytest.mark.parametrize("spelling", SPELLINGS.values(), ids=SPELLINGS)
@pytest.mark.parametrize("where", ["working folder", "its parent", "from the root"])
def test_a_file_outside_is_not_found(port, folder, where, spelling):
    up_to_the_root = "/.." * 40
    path = {
        "working folder": "/secret.js",
        "its parent": "/../secret.js",
        "from the root": up_to_the_root + (folder / "secret.js").as_posix(),
    }[where]
    status, body = get(port, spelling(path))
    assert status == 404
    assert SECRET.encode() not in body


@pytest.mark.parametrize("path", ["vpython_libraries/jquery.min.js", "vpython_data/flower_texture.jpg"])
def test_vpythons_own_files_are_served(port, path):
    file = Path(PathFinder.find_spec("vpython").origin).with_name(path.partition("/")[0]) / path.partition("/")[2]
    assert get(port, f"/{file.name}") == (200, file.read_bytes())


WRONG_KEYS = ["", "?", "?key", "?key=", "?key=wrong", "?KEY={key}", "?key={key}0", "?key=%ff", "?key=x&key={key}"]


@pytest.mark.parametrize("path", ["/", "/no-webgl", "/cradle_data.csv"])
@pytest.mark.parametrize("query", WRONG_KEYS)
def test_who_does_not_know_the_key_gets_words_and_nothing_else(address, port, path, query):
    """A request can say all that a browser says: another program on this machine can send it."""
    lines = [f"GET {path}{query.format(key=key_in(address))} HTTP/1.0", f"Host: localhost:{port}"]
    lines += [f"Origin: http://localhost:{port}", f"Referer: http://localhost:{port}/", "Sec-Fetch-Site: same-origin"]
    reply = answer(port, "".join(f"{line}\r\n" for line in [*lines, ""]).encode())
    assert reply.split()[1] == b"403"
    assert reply.endswith(b"\r\n\r\n" + NO_KEY.encode())
    assert key_in(address).encode() not in reply


def test_without_the_key_the_page_says_which_address_to_open(port):
    assert get(port, "/") == (403, NO_KEY.encode())


def test_the_page_keeps_its_address_to_itself(address, port):
    """It has no link to another site, but a browser would send the address along with one."""
    assert b'<meta name="referrer" content="no-referrer">' in get(port, f"/?key={key_in(address)}")[1]


def test_each_start_has_another_key(address):
    with running() as process:
        assert key_in(first_lines(process)) != key_in(address)


def test_the_page_says_in_the_terminal_that_it_sees_nothing(started):
    process, address = started
    assert get(port_in(address), f"/no-webgl?key={key_in(address)}")[0] == 204
    assert process.stdout.readline().startswith("Your browser cannot draw the cradle")


def test_the_page_gets_the_data(started):
    _, address = started
    all_of_it(Tab(address, "first"))
    request = f"GET /cradle_data.csv?key={key_in(address)} HTTP/1.0\r\n\r\n"
    head, _, body = answer(port_in(address), request.encode()).partition(b"\r\n\r\n")
    assert (
        b"\r\nContent-Type: text/csv; charset=utf-8\r\nContent-Disposition: attachment; filename=cradle_data.csv"
        in head
    )
    columns, *rows = body.decode().split("\n")[:-1]
    assert columns.startswith("t,theta_1,theta_2,theta_3,theta_4,theta_5,omega_1,")
    assert {row.count(",") for row in rows} == {columns.count(",")}
    assert float(rows[0].partition(",")[0]) == 0


def test_the_page_names_the_port_above_its_own_as_its_websockets(address, port):
    status, body = get(port, f"/?key={key_in(address)}")
    assert status == 200
    assert re.search(rb"var sock = '(\d+)'", body)[1] == str(port + 1).encode()


FOREIGN = [
    "http://example.org",
    "http://localhost",
    "http://localhost:{websocket}",
    "http://localhost.example.org:{page}",
    "http://example.org:{page}",
    "https://localhost:{page}",
    "file:///tmp/page.html",
    "null",
    "",
]


@pytest.mark.parametrize("origin", FOREIGN)
def test_a_foreign_page_gets_no_websocket(address, port, origin):
    own = f"Origin: {origin.format(page=port, websocket=port + 1)}"
    assert stranger(port + 1, own, path=f"/?key={key_in(address)}&tab=any") in (400, 403)


def test_who_names_no_origin_gets_no_websocket(address, port):
    assert stranger(port + 1, path=f"/?key={key_in(address)}&tab=any") == 403


def test_who_names_no_tab_gets_no_websocket(address, port):
    assert stranger(port + 1, f"Origin: http://localhost:{port}", path=f"/?key={key_in(address)}") == 403


@pytest.mark.parametrize("query", WRONG_KEYS[1:])
def test_who_does_not_know_the_key_gets_no_websocket(address, port, query):
    """Another program on this machine can forge the Origin."""
    path = f"/{query.format(key=key_in(address))}&tab=any&take=1"
    assert stranger(port + 1, f"Origin: http://localhost:{port}", path=path) == 403


def test_who_forges_the_origin_takes_no_tabs_place(started):
    process, address = started
    for name in ("first", "other&take=1"):
        origin = f"Origin: http://localhost:{port_in(address)}"
        connection, status = shake_hands(port_in(address) + 1, origin, path=f"/?tab={name}")
        assert status == 403
        tab = Tab(address, "first")  # while the refused one is still there
        tab.ask()
        connection.close()
        tab.ask()
    assert process.poll() is None


class Tab:
    """A tab of the page, as the websocket of the page with this address knows it."""

    def __init__(self, address, name, host="localhost"):
        page, path = port_in(address), f"/?key={key_in(address)}&tab={name}"
        self.connection, status = shake_hands(page + 1, f"Origin: http://{host}:{page}", path=path)
        assert status == 101

    def ask(self):
        """Ask for the changes, as the page does, and return the answer."""
        self.send(1, b"trigger")
        return json.loads(self.frame(1))

    def send(self, kind, data):
        """Send a frame (RFC 6455): 1 is text, 8 closes. A client's frames have a mask; this one changes nothing."""
        length = [len(data)] if len(data) < 126 else [126, *len(data).to_bytes(2, "big")]
        self.connection.sendall(bytes([0x80 | kind, 0x80 | length[0], *length[1:], 0, 0, 0, 0]) + data)

    def frame(self, kind):
        """Return the data of the next frame, which must be of this kind."""
        first, length = self.read(2)
        assert first == 0x80 | kind
        longer = {126: 2, 127: 8}.get(length)
        return self.read(int.from_bytes(self.read(longer), "big") if longer else length)

    def read(self, count):
        data = b""
        while len(data) < count:
            part = self.connection.recv(count - len(data))
            assert part, "the connection was closed"
            data += part
        return data

    def is_closed_with(self, code):
        return int.from_bytes(self.frame(8), "big") == code

    def close(self):
        """Close it as a browser does."""
        self.send(8, (1001).to_bytes(2, "big"))
        self.connection.close()


@pytest.fixture
def started():
    """A program that waits for a websocket, and the address of its page."""
    with running() as process:
        address = first_lines(process)
        assert get(port_in(address), f"/?key={key_in(address)}")[0] == 200
        yield process, address


def kinds(answer):
    """Return how many objects of each kind an answer makes."""
    return Counter(cmd["cmd"] for cmd in answer.get("cmds", []) if "cmd" in cmd)


def all_of_it(tab):
    """Ask until all is there; return how many objects of each kind the answers make.

    The graph's curves come last: three energies, the phase picture, and five pendula.
    """
    made: Counter = Counter()
    wait_until(lambda: made.update(kinds(tab.ask())) or made["gcurve"] == 9)
    return made


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1"])
def test_a_tab_that_is_closed_for_good_ends_the_program(started, host):
    process, address = started
    tab = Tab(address, "first", host)
    all_of_it(tab)
    tab.close()
    assert end(process) == QUIETLY


def test_a_tab_that_ends_without_a_word_ends_the_program(started):
    """Its browser has crashed, in the middle of a message."""
    process, address = started
    tab = Tab(address, "first")
    all_of_it(tab)
    tab.connection.sendall(b"\x81\xff")
    tab.connection.close()
    assert end(process) == QUIETLY


def test_ctrl_c_ends_it_while_it_waits_for_a_tab_to_come_back(started):
    process, address = started
    tab = Tab(address, "first")
    all_of_it(tab)
    tab.close()
    process.send_signal(signal.SIGINT)
    assert end(process) == QUIETLY


@pytest.mark.parametrize("name", ["first", "second"])
def test_the_next_tab_gets_in_one_answer_all_that_was_sent(started, name):
    process, address = started
    tab = Tab(address, "first")
    made = all_of_it(tab)
    tab.close()
    again = Tab(address, name)
    answer = again.ask()
    assert kinds(answer) == made
    assert len([text for text in answer["attrs"] if text.startswith("m0G")]) == 5  # keys, mouse, resize
    assert not kinds(again.ask())
    assert process.poll() is None


def test_a_reload_takes_over_from_a_connection_that_the_browser_has_not_closed_yet(started):
    """The old connection then gets none of the changes: they are sent only once."""
    _, address = started
    tab = Tab(address, "first")
    made = all_of_it(tab)
    again = Tab(address, "first")
    assert tab.is_closed_with(ELSEWHERE)
    assert kinds(again.ask()) == made
    wait_until(lambda: "attrs" in again.ask())


def test_another_tab_is_told_so_unless_it_takes_over(started):
    process, address = started
    first = Tab(address, "first")
    made = all_of_it(first)
    second = Tab(address, "second")
    assert second.is_closed_with(ELSEWHERE)
    second.close()
    first.ask()
    taking = Tab(address, "second&take=1")
    assert first.is_closed_with(ELSEWHERE)
    first.close()
    assert kinds(taking.ask()) == made
    taking.close()
    assert end(process) == QUIETLY


def test_what_never_becomes_a_connection_takes_no_tabs_place(started):
    process, address = started
    tab = Tab(address, "first")
    all_of_it(tab)
    annoy(port_in(address))
    page = port_in(address)
    with socket.create_connection(("127.0.0.1", page + 1), timeout=SECONDS) as half:
        request = f"GET /?key={key_in(address)}&tab=first HTTP/1.1\r\nOrigin: http://localhost:{page}\r\n"
        half.sendall(request.encode())
        tab.ask()
    tab.ask()
    assert process.poll() is None


BAD_MESSAGES = [
    *(b"", b"{", b"\xff", b"TRIGGER", b"null", b"7", b'"trigger"', b"{}", b"[7]", b"[[]]", b"[{}]", b"[null]"),
    *(b"[" * 50_000, b"9" * 10_000, b'[{"event": NaN}]'),
]


def test_a_message_that_is_not_of_the_page_does_nothing(started):
    """It gets an answer, as each message does. Text that is not UTF-8 ends a websocket, so it comes as binary data."""
    process, address = started
    tab = Tab(address, "first")
    all_of_it(tab)
    for message in BAD_MESSAGES:
        for kind in (1, 2) if message.isascii() else (2,):
            tab.send(kind, message)
            tab.frame(1)
    unknown = [
        *({"widget": "button", "idx": number, "value": 0} for number in (-1, 0, 10**6, None, "0", [])),
        *({"event": "keydown", "canvas": number, "key": "r"} for number in (0, 10**6, None)),
        {"event": "nothing", "canvas": 0},
    ]
    for event in unknown:
        tab.send(1, json.dumps([event]).encode())
        tab.frame(1)
    wait_until(lambda: "attrs" in tab.ask())  # the cradle swings on
    process.send_signal(signal.SIGINT)
    assert end(process) == QUIETLY


def test_a_message_of_the_page_does_what_it_says_beside_one_that_is_unknown(started):
    _, address = started
    tab = Tab(address, "first")
    buttons = {}

    def note_buttons():
        answer = tab.ask()
        buttons.update({cmd["text"]: cmd["idx"] for cmd in answer.get("cmds", []) if cmd.get("cmd") == "button"})
        return kinds(answer)["gcurve"]

    wait_until(note_buttons)
    tab.send(1, json.dumps([{"idx": 10**6}, {"widget": "button", "idx": buttons["Pause"], "value": 0}]).encode())
    tab.frame(1)
    wait_until(lambda: f"a{buttons['Pause']}$Run" in tab.ask().get("attrs", []))


def test_a_message_that_would_fill_the_memory_closes_the_tab(started):
    process, address = started
    tab = Tab(address, "first")
    made = all_of_it(tab)
    tab.connection.sendall(bytes([0x81, 0x80 | 127]) + (LARGEST_MESSAGE + 1).to_bytes(8, "big") + bytes(4))
    assert tab.connection.recv(1) == b""  # it is closed
    assert kinds(Tab(address, "first").ask()) == made
    process.send_signal(signal.SIGINT)
    assert end(process) == QUIETLY


# --- the place of the tab --------------------------------------------------------------------------------------------


class Clock:
    """A clock, and an event loop, for a Place: time passes only in pass_time."""

    def __init__(self):
        self.now, self.timers = 100.0, []

    def call_later(self, delay, function):
        self.timers.append((self.now + delay, function))

    def pass_time(self, seconds):
        self.now += seconds
        due = [timer for timer in self.timers if timer[0] <= self.now]
        self.timers = [timer for timer in self.timers if timer not in due]
        for _, function in due:
            function()


@pytest.fixture
def clock(monkeypatch):
    clock = Clock()
    monkeypatch.setattr("time.monotonic", lambda: clock.now)
    monkeypatch.setattr("asyncio.get_running_loop", lambda: clock)
    return clock


@pytest.fixture
def ends(monkeypatch):
    """The list of the statuses with which the program has ended."""
    ends = []
    monkeypatch.setattr("os._exit", ends.append)
    return ends


def a_tab(name, takes_over=False):
    return SimpleNamespace(name=name, takes_over=takes_over, sendClose=lambda code: None)


def test_the_program_ends_when_the_time_to_come_back_is_over(clock, ends):
    place, tab = Place(lambda: None), a_tab("first")
    assert place.take(tab)
    clock.pass_time(100)
    place.leave(tab)
    clock.pass_time(RETURN - 0.1)
    assert not ends
    clock.pass_time(0.1)
    assert ends == [0]


def test_a_tab_that_loads_slowly_gets_the_time_that_it_needs(clock, ends):
    """It asks for file after file before it opens its websocket."""
    place, tab = Place(lambda: None), a_tab("first")
    place.take(tab)
    place.leave(tab)
    for _ in range(4):
        clock.pass_time(0.8 * RETURN)
        place.expect_tab()
    place.take(tab)
    clock.pass_time(100)
    assert not ends
    place.leave(tab)
    clock.pass_time(RETURN)
    assert ends == [0]


def test_each_request_for_a_file_counts_as_loading(clock):
    place = Place(lambda: None)

    class Handler:
        mimes: dict = {}
        path = f"/?key={place.key}"
        do_GET = print  # noqa: N815

    clock.pass_time(100)
    own_files_only(Handler, place, "", None)().do_GET()
    assert place.until == clock.now + RETURN


def test_only_the_tab_that_has_the_place_can_leave_it(clock, ends):
    place, first, second, third = Place(lambda: None), a_tab("first"), a_tab("second"), a_tab("third", True)
    assert [place.take(tab) for tab in (first, second, third)] == [True, False, True]
    for tab in (first, second):
        place.leave(tab)
        clock.pass_time(100)
    assert (place.tab, ends) == (third, [])


def test_each_tab_that_gets_the_place_lets_the_cradle_be_shown_again(clock):
    shown = []
    place = Place(lambda: shown.append(place.tab.name))
    for tab in (a_tab("first"), a_tab("second"), a_tab("first"), a_tab("second", True)):
        place.take(tab)
    assert shown == ["first", "first", "second"]


class Connection:
    """In place of VPython's protocol: it answers each message with the next of the changes."""

    changes: list = []

    def __init__(self, tab, key):
        self.sent, self.closed = [], None
        self.onConnect(SimpleNamespace(origin="of the page", params={"key": [key], "tab": [tab]}))
        self.onOpen()

    def onConnect(self, request):  # noqa: N802
        pass

    def onOpen(self):  # noqa: N802
        pass

    async def onMessage(self, data, is_binary):  # noqa: N802
        self.sendMessage(json.dumps({"attrs": [self.changes.pop(0)]}).encode(), isBinary=is_binary)

    def sendMessage(self, payload, isBinary):  # noqa: N802
        from autobahn.exception import Disconnected

        if self.closed:
            raise Disconnected("Attempt to send on a closed protocol")
        self.sent.append(json.loads(payload)["attrs"])

    def sendClose(self, code):  # noqa: N802
        self.closed = code


def ask(connection):
    asyncio.run(connection.onMessage(b"trigger", False))


@pytest.fixture
def connect():
    """A function that connects a tab with this name to a websocket for one tab."""
    place = Place(lambda: None)
    return partial(one_tab_only(Connection, place, {}), key=place.key)


def test_a_tab_that_was_replaced_takes_no_change_from_the_next(connect):
    Connection.changes = ["a1a1", "a1b2", "a1c3"]
    first = connect("first")
    ask(first)
    again = connect("first")
    for tab in (first, again, first, again):
        ask(tab)
    assert (first.sent, again.sent) == ([["a1a1"]], [["a1a1", "a1b2"], ["a1c3"]])


def test_a_change_that_a_closing_tab_did_not_get_is_for_the_next(connect):
    """And that it did not get it is no news: VPython goes on."""
    Connection.changes = ["a1a1", "a1b2", "a1c3"]
    first = connect("first")
    ask(first)
    first.closed = True
    ask(first)
    again = connect("first")
    ask(again)
    assert again.sent == [["a1a1", "a1b2", "a1c3"]]


# --- strangers and ports ---------------------------------------------------------------------------------------------


def test_strangers_neither_end_the_program_nor_appear_on_the_screen(page, program):
    """Neither while it waits for a browser nor while the cradle swings; and the page works as if they had not come."""
    with running(program) as process:
        address = first_lines(process)
        port = port_in(address)
        annoy(port)
        open_cradle(page, address)
        annoy(port)
        for bob, side in ((4, ">"), (0, "<"), (4, ">")):  # it swings to the right, back, and to the right again
            rest = -0.1 + R_PARAM / 4 * bob
            reach = R_PARAM / 4 if side == ">" else -R_PARAM / 4
            page.wait_for_function(f"() => ({BOBS})()[{bob}][0] {side} {rest + reach}")
        assert process.poll() is None
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def annoy(port):
    """Do with both servers of the page at this port what their own browser does not."""
    for one in (port, port + 1):
        socket.create_connection(("127.0.0.1", one), timeout=SECONDS).close()
        for request in (
            b"GET /../secret.js HTTP/1.1\r\nHost: localhost\r\n\r\n",
            b"\0\xff\r\n\r\n",
            b"\x16\x03\r\n\r\n",
        ):
            with suppress(ConnectionResetError):
                answer(one, request)
    for origin in ("http://example.org", "null", "http://[", f"http://localhost:{port + 2}"):
        assert stranger(port + 1, f"Origin: {origin}") != 101


def free_port():
    """Return a port that is free, as is the next one."""
    page, websocket = page_sockets(0)
    with page, websocket:
        return port_of(page)


def test_the_ports_asked_for_are_used():
    port = free_port()
    with running(VPYTHON_HTTP_PORT=str(port)) as process:
        address = first_lines(process)
        assert address.startswith(f"http://localhost:{port}/?key=")
        assert get(port, f"/?key={key_in(address)}")[0] == 200
        assert stranger(port + 1) == 403


@pytest.mark.parametrize("above, whose", [(0, "the page's"), (1, "the websocket's, one above the page's")])
def test_a_taken_port_is_refused(above, whose):
    port = free_port()
    with socket.create_server(("127.0.0.1", port + above)), running(VPYTHON_HTTP_PORT=str(port)) as process:
        problem = f"port {port + above} ({whose}) is not available: "
        assert refusal(process).startswith(problem)


def test_a_port_where_another_program_answers_at_another_address_of_localhost_is_refused():
    """Browsers try ::1 first, and would show that program's page."""
    port = free_port()
    try:
        other = socket.create_server(("::1", port), family=socket.AF_INET6)
    except OSError as error:
        pytest.skip(f"this machine has no such address: {error}")
    with other, pytest.raises(ValueError, match=f"port {port} .*: another program answers there; choose another"):
        page_sockets(port)


def test_ports_are_taken_from_the_start_and_free_at_the_end():
    page, websocket = page_sockets(0)
    with page, websocket:
        port = port_of(page)
        assert port_of(websocket) == port + 1
        with pytest.raises(ValueError, match=f"port {port} "):  # though nobody serves it yet
            page_sockets(port)
        with socket.create_connection(("127.0.0.1", port)):
            page.accept()[0].close()  # who hangs up first keeps the connection's port busy for a while
    for again in page_sockets(port):
        again.close()


@pytest.mark.parametrize("port, refused", [(-1, "-1 (the page's)"), (65535, "65536 (the web"), (10**30, f"{10**30} (")])
def test_what_is_no_port_is_refused(port, refused):
    with pytest.raises(ValueError, match=re.escape(f"port {refused}")):
        page_sockets(port)
