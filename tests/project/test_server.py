"""What the server of the page answers at its port: to whom, at which path, to any request."""

import signal
import socket
import threading
from contextlib import ExitStack, suppress
from importlib.machinery import PathFinder
from pathlib import Path
from urllib.parse import urlsplit

import programs
import pytest
from hypothesis import example, given, settings, strategies
from programs import copy_project, end, first_lines, QUIETLY, ROOT, running, SECONDS
from students import put_files
from web_client import BELOW, get, Tab
from whole_cradles import FIVE_CSV

from support.page.server.port import listen
from support.page.server.site import NO_KEY

# They need autobahn, which comes with VPython.
server = pytest.importorskip("support.page.server.server")
connections = pytest.importorskip("support.page.server.connection")
pytestmark = programs.needs_vpython

WEB = ROOT / "support" / "page" / "web"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A working folder with a secret, in a folder with a secret.

    Both secrets end as something that the server has.
    """
    files = dict.fromkeys(["secret.js", "working/secret.js"], "secret")
    return put_files(tmp_path_factory.mktemp("outside"), files) / "working"


@pytest.fixture(scope="module")
def site(folder):
    """The address of a program that has a tab from beginning to end, and prints nothing more.

    Its query is the key.
    """
    program = copy_project(folder.parent, FIVE_CSV) / "src" / programs.PROGRAM.name
    with running(program, folder=folder, patience=60 * SECONDS) as process:
        page = urlsplit(first_lines(process))
        threading.Thread(target=Tab(page).stay, daemon=True).start()
        yield page
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def connect(site, host="127.0.0.1"):
    return socket.create_connection((host, site.port), timeout=SECONDS)


def test_only_this_machine_reaches_the_page_unless_you_ask_for_more_and_then_the_program_says_so(
    site,
):
    other_address = "127.0.0.2"  # of this machine
    with pytest.raises(OSError):
        connect(site, other_address)
    with running(None, "--host", "0.0.0.0") as process:
        page = urlsplit(process.stdout.readline().split()[-1])
        warning = process.stdout.readline()
        assert warning.startswith("Every machine that reaches this one can open it")
        assert get(page, "/", "", other_address)[0] == 403
        assert get(page, "/", "{key}", other_address)[0] == 200


@pytest.mark.parametrize(
    "name", ["page.html", "../secret.js", "%2e%2e%2fsecret.js", "../../../{folder}/secret.js"]
)
def test_a_file_that_is_not_of_the_page_is_not_there(site, folder, name):
    status, _, content = get(site, f"/{name}".format(folder=folder))
    assert status == 404
    assert content == b""


def test_files_that_everybody_can_download_come_whole_without_the_key(site):
    """vpython.js is a part of VPython's page, without its websocket, which goes to localhost."""
    vpython = Path(PathFinder.find_spec("vpython").origin).parent
    libraries = vpython / "vpython_libraries"
    picture = vpython / "vpython_data/wood_texture.jpg"
    for file in (WEB / "page.js", libraries / "jquery.min.js", picture):
        assert get(site, BELOW + file.name, "")[::2] == (200, file.read_bytes())
    script = get(site, "/vpython.js", "")[2]
    assert b"function decode(" in script
    assert script in (libraries / "glowcomm.html").read_bytes()
    assert b"WebSocket" not in script


@pytest.mark.parametrize("query", ["", "{key}0", "key=%ff%00"])
def test_without_the_key_the_page_is_a_sentence_and_the_websocket_is_refused(site, query):
    """A request can have all headers of a browser: another program on this machine can send it."""
    for name in ("", "alive"):
        status, headers, content = get(
            site, BELOW + name, query, Origin="http://a", Sec_Fetch_Site="same-origin"
        )
        assert status == 403
        assert content.decode() == NO_KEY
        assert site.query.removeprefix("key=") not in str(headers)
    with Tab(site, query) as tab:
        assert tab.answer.status in (400, 403)


def test_with_the_key_a_browser_gets_all_below_any_path(site):
    """The page sends its address to no other site.

    It has the command that starts the program again, should it never hear from the program.
    """
    for name, part in (("", b"/src/visualize_cradle_run.py</code>"), ("alive", b"alive")):
        status, headers, content = get(site, BELOW + name)
        assert status == 200
        assert part in content
        assert headers["Referrer-Policy"] == "no-referrer"


@pytest.mark.parametrize(
    ("origin", "statuses"),
    [
        ("https://a-cradle.example.org", [101]),
        (None, [400, 403]),  # no browser
        ("", [400, 403]),
        ("null", [400, 403]),  # a file, or a frame that a page has shut in
    ],
)
def test_only_a_browser_at_any_address_gets_the_websocket(site, origin, statuses):
    with Tab(site, origin=origin, folder=BELOW) as tab:
        assert tab.answer.status in statuses


@settings(max_examples=50, deadline=None, derandomize=True, database=None)
@example(b"")  # a browser opens it in advance
@example(b"GET /../secret.js HTTP/1.1\r\n\r\n")
@example(b"\x16\x03\r\n\r\n")
@given(strategies.binary())
def test_any_bytes_on_a_connection_change_nothing_for_others(site, data):
    with suppress(ConnectionError), connect(site) as idle:
        idle.sendall(data)
        assert get(site, "/")[0] == 200


def test_a_tab_that_would_fill_the_memory_is_cut_off(site):
    with Tab(site) as tab, suppress(ConnectionResetError):
        size = (server.LARGEST_MESSAGE + 1).to_bytes(8, "big")
        tab.connection.sock.sendall(b"\x81\xff" + size + bytes(4))  # the begin of a message
        tab.answer.fp.read()  # until the end


def test_an_address_that_the_page_cannot_have_is_refused_and_a_port_is_free_at_the_end():
    with listen("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        for host, number, part in (
            ("127.0.0.1", port, str(port)),
            ("127.0.0.1", 6000, "6000.* browsers"),  # they refuse it
            ("192.0.2.1", 0, "192.0.2.1"),  # no address of this machine
            ("no such host", 0, "host: found 'no such host"),
        ):
            with pytest.raises(ValueError, match=rf"^[^\n]*\b{part}\b[^\n]+$"):
                listen(host, number)
        with socket.create_connection(("127.0.0.1", port)):
            # The side that closes first keeps the connection's port busy for a while
            listener.accept()[0].close()
    listen("127.0.0.1", port).close()


# --- other requests --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "request_line", ["HEAD {} HTTP/1.1", "GET {} HTTP/1.0", "HEAD {} HTTP/1.0"]
)
def test_a_request_in_another_way_is_answered_as_well(site, request_line):
    """Without the last slash of a proxy's address; its head only; of an older version, without a
    Host.
    """
    page = get(site, "/")[2]
    request = request_line.format(f"{BELOW.rstrip('/')}?{site.query}")
    with connect(site) as client:
        client.sendall(f"{request}\r\n\r\n".encode())
        answer = b"".join(iter(lambda: client.recv(2**16), b""))
    head, _, content = answer.partition(b"\r\n\r\n")
    assert f"Content-Length: {len(page)}".encode() in head
    assert content == (page if request.startswith("GET") else b"")


def test_neither_many_connections_nor_an_endless_request_keep_others_away(site):
    """The oldest connection ends when there are too many; so does one that sends too long a head.

    Another one stays.
    """
    with ExitStack() as stack:
        idle = [stack.enter_context(connect(site)) for _ in range(connections.MOST_WAITING + 1)]
        idle[-1].sendall(bytes(connections.LARGEST_HEAD + 1))
        for ended in (idle[0], idle[-1]):
            with suppress(ConnectionResetError):
                assert ended.recv(1) == b""
        assert get(site, "/")[0] == 200
        idle[2].setblocking(False)
        with pytest.raises(BlockingIOError):
            idle[2].recv(1)
