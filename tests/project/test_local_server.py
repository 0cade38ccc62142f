"""Closed doors: what the running program's two servers do with anyone but its own page in a browser on this machine."""

import http.client
import re
import signal
import socket
from contextlib import suppress
from importlib.machinery import PathFinder
from pathlib import Path
from urllib.parse import quote

import pytest
from programs import (
    BOBS,
    copy_project,
    end,
    first_lines,
    needs_vpython,
    open_cradle,
    PROGRAM,
    QUIETLY,
    refusal,
    running,
    SECONDS,
)
from whole_cradles import FIVE_CSV

from support.constants import R_PARAM
from support.page.local_server import page_sockets, port_of

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
def port(folder):
    """The port of a program that runs for all tests here, started in that folder; its websocket is at port + 1."""
    project = copy_project(folder.parent, FIVE_CSV)
    with running(project / "src" / PROGRAM.name, folder=folder) as process:
        yield int(first_lines(process).rpartition(":")[2])
        assert process.poll() is None


def answer(port, request):
    """Send a request as it stands, and return all that comes back."""
    with socket.create_connection(("127.0.0.1", port), timeout=SECONDS) as connection:
        connection.sendall(request)
        return b"".join(iter(lambda: connection.recv(100_000), b""))


def get(port, path):
    """Return the (status, body) of the answer to a GET with exactly this path."""
    head, _, body = answer(port, f"GET {path} HTTP/1.0\r\n\r\n".encode()).partition(b"\r\n\r\n")
    return int(head.split()[1]), body


def shake_hands(port, *headers):
    """Ask this websocket for a connection; return the connection and the answer's status, 101 if it is accepted."""
    connection = socket.create_connection(("127.0.0.1", port), timeout=SECONDS)
    key = "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ=="
    lines = ["GET / HTTP/1.1", f"Host: localhost:{port}", "Upgrade: websocket", "Connection: Upgrade", key, *headers]
    connection.sendall("".join(f"{line}\r\n" for line in [*lines, ""]).encode())
    reply = http.client.HTTPResponse(connection)
    reply.begin()
    return connection, reply.status


def stranger(port, *headers):
    """Return the status that a stranger at this websocket gets, who then goes away."""
    connection, status = shake_hands(port, *headers)
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


def test_only_the_page_itself_can_say_in_the_terminal_that_it_sees_nothing():
    """A browser says of each request whose script has made it."""
    with running() as process:
        port = int(first_lines(process).rpartition(":")[2])
        assert get(port, "/no-webgl")[0] == 404
        for whose in ("cross-site", "same-site", "none"):
            assert answer(port, f"GET /no-webgl HTTP/1.0\r\nSec-Fetch-Site: {whose}\r\n\r\n".encode())[9:12] == b"404"
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_the_page_names_the_port_above_its_own_as_its_websockets(port):
    status, body = get(port, "/")
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
def test_a_foreign_page_gets_no_websocket(port, origin):
    assert stranger(port + 1, f"Origin: {origin.format(page=port, websocket=port + 1)}") in (400, 403)


def test_who_names_no_origin_gets_no_websocket(port):
    assert stranger(port + 1) == 403


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1"])
def test_the_page_gets_one_websocket_and_ends_the_program(host):
    with running() as process:
        page = int(first_lines(process).rpartition(":")[2])
        origin = f"Origin: http://{host}:{page}"
        tab, status = shake_hands(page + 1, origin)
        assert status == 101
        for _ in range(2):  # the first one's going away would have ended the program
            assert stranger(page + 1, origin) == 403
        assert process.poll() is None
        tab.close()
        assert end(process) == QUIETLY


def test_strangers_neither_end_the_program_nor_appear_on_the_screen(page, program):
    """Neither while it waits for a browser nor while the cradle swings; and the page works as if they had not come."""
    with running(program) as process:
        address = first_lines(process)
        port = int(address.rpartition(":")[2])
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
        assert first_lines(process) == f"http://localhost:{port}"
        assert get(port, "/")[0] == 200
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
