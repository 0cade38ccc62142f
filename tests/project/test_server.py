"""The server of the page: what it does for a tab and for everyone else, at one port.

And when the program ends.
"""

import json
import signal
import socket
import sys
import threading
from contextlib import ExitStack, suppress
from http.client import HTTPConnection
from types import SimpleNamespace
from unittest.mock import Mock
from urllib.parse import urlsplit

import programs
import pytest
from hypothesis import example, given, settings, strategies
from programs import copy_project, end, first_lines, QUIETLY, ROOT, running, SECONDS
from students import change, put_files
from whole_cradles import FIVE_CSV

from support.page import browser
from support.page.port import listen

# They need autobahn, which comes with VPython.
server = pytest.importorskip("support.page.server")
connections = pytest.importorskip("support.page.connection")
pytestmark = programs.needs_vpython

WEB = ROOT / "support" / "page" / "web"


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


# The first bytes of messages of a websocket
TEXT, GOODBYE, PING, PONG = 0x81, 0x88, 0x89, 0x8A


class Tab(ExitStack):
    """A tab without a browser: a websocket, if the status of the answer is 101."""

    def __init__(self, page, query="{key}", origin="http://127.0.0.1"):
        super().__init__()
        headers = {
            "Upgrade": "websocket",
            "Connection": "Upgrade",
            "Sec_WebSocket_Version": "13",
            "Sec_WebSocket_Key": "dGhlIHNhbXBsZSBub25jZQ==",
            "Origin": origin,
        }
        self.connection, self.answer = ask(page, "/ws", query, **headers)
        self.callback(self.connection.close)
        self.callback(self.answer.close)
        if self.answer.status == 101:
            self.callback(self.leave)

    def leave(self):
        """Say goodbye, and wait until it is heard.

        A socket that closes with unread bytes takes it back.
        """
        with suppress(OSError):  # the program may have ended
            self.tell(b"\x03\xe9", GOODBYE)
            self.connection.sock.shutdown(socket.SHUT_WR)
            self.answer.fp.read()

    def tell(self, message, kind=TEXT):
        """Send a short message, with an empty mask."""
        head = bytes([kind, len(message) | 0x80, 0, 0, 0, 0])
        self.connection.sock.sendall(head + message)

    def hear(self):
        """Return the next message of the program, and answer that the picture is drawn.

        Answer each ping before it.
        """
        read = self.answer.fp.read
        while True:
            kind, size = read(2)
            if size > 125:
                size = int.from_bytes(read({126: 2, 127: 8}[size]), "big")
            data = read(size)
            if kind == PING:
                self.tell(data, PONG)
            elif data:  # else it is only a sign of life
                self.tell(b"seen")
                return json.loads(data)

    def stay(self):
        """Answer the program until it ends."""
        with suppress(ValueError):  # no more bytes
            while True:
                self.hear()


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
    "name",
    ["page.html", "secret.js", "../secret.js", "%2e%2e%2fsecret.js", "../../../{folder}/secret.js"],
)
def test_a_file_that_is_not_of_the_page_is_not_there(site, folder, name):
    status, _, content = get(site, f"/{name}".format(folder=folder))
    assert status == 404
    assert content == b""


@pytest.mark.parametrize("query", ["", "key=", "key=wrong", "{key}0", "key=%ff%00"])
def test_without_the_key_the_page_is_a_sentence_and_the_websocket_is_refused(site, query):
    """A request can have all headers of a browser: another program on this machine can send it."""
    for path in ("/", "/alive"):
        status, headers, content = get(
            site, path, query, Origin="http://a", Sec_Fetch_Site="same-origin"
        )
        assert status == 403
        assert content.decode() == connections.NO_KEY
        assert site.query.removeprefix("key=") not in str(headers)
    with Tab(site, query) as tab:
        assert tab.answer.status in (400, 403)


def test_with_the_key_a_browser_gets_the_page_which_sends_its_address_to_no_other_site(site):
    for path, expected in (("/", (WEB / "page.html").read_bytes()), ("/alive", b"alive")):
        status, headers, content = get(site, path)
        assert status == 200
        assert content == expected
        assert headers["Referrer-Policy"] == "no-referrer"


@pytest.mark.parametrize(
    ("origin", "statuses"),
    [
        ("http://127.0.0.1:19000", [101]),
        ("https://a-cradle.example.org", [101]),
        (None, [400, 403]),  # no browser
        ("", [400, 403]),
        ("null", [400, 403]),  # a file, or a frame that a page has shut in
    ],
)
def test_only_a_browser_at_any_address_gets_the_websocket(site, origin, statuses):
    with Tab(site, origin=origin) as tab:
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


# A browser: it writes down who can read the file that it gets, where that leads to, and what the
# page answers at once.
BROWSER = """#!{python}
import os, re, sys, urllib.request as web
address = re.search('url=([^"]*)', web.urlopen(sys.argv[1]).read().decode())[1]
mode = oct(os.stat(*os.listdir()).st_mode)[-3:]
print(mode, address, web.urlopen(address).status, *sys.argv[1:], file=open("{visited}", "w"))
"""


@pytest.mark.parametrize(("until", "status"), [("a tab", 0), ("SIGTERM", 143)])
def test_a_browser_gets_a_file_that_leads_on(tmp_path, until, status):
    """All users of a machine can read a command; only you the file.

    It goes with the first tab, or with the program.
    """
    folder = tmp_path / "100% ü #1"
    visited = tmp_path / "visited"
    browser = tmp_path / "browser"
    folder.mkdir()
    browser.write_text(BROWSER.format(python=sys.executable, visited=visited))
    browser.chmod(0o755)
    with running(folder=folder, BROWSER=str(browser), VPYTHON_NO_LAUNCH_BROWSER="") as process:
        address = first_lines(process)
        programs.wait_until(lambda: visited.exists() and visited.read_text().endswith("\n"))
        *seen, file = visited.read_text().split()
        assert seen == ["600", address, "200"]
        assert file.startswith("file://")
        assert address.partition("key=")[2] not in file
        if until == "a tab":
            with Tab(urlsplit(address)) as tab:
                tab.hear()
                assert [*folder.iterdir()] == []
        else:
            process.send_signal(signal.SIGTERM)
        assert end(process) == (status, "", "")
    assert [*folder.iterdir()] == []


@pytest.mark.parametrize(
    ("name", "release", "places"),
    [
        ("firefox", "6.1.0-18-amd64", ["file"]),
        ("firefox", "5.15.90-Microsoft-WSL2", ["http"]),  # it sees no file of this system
        ("/usr/bin/w3m", "6.1.0-18-amd64", []),  # it has no pictures
    ],
)
def test_what_a_browser_opens(monkeypatch, name, release, places):
    thread = Mock()
    monkeypatch.setattr("platform.release", lambda: release)
    monkeypatch.setattr("webbrowser.get", lambda: SimpleNamespace(name=name, open=None))
    monkeypatch.setattr("threading.Thread", thread)
    start = browser.BrowserStart()
    monkeypatch.setattr(start, "make_file", lambda address: "file")
    start.open("http")
    assert [call.kwargs["args"][0] for call in thread.call_args_list] == places


SESSION = """exec "{python}" -W ignore -i <<'END'
import runpy, sys
def start(name, *options):
    sys.argv = [f"{folder}/src/{{name}}.py", *options]
    try:
        runpy.run_path(sys.argv[0], run_name="__main__")
    except SystemExit as ended:
        print("status", ended.code)
    print("the prompt")

start("text_cradle_run", "--seconds", "0.01")
with open("{folder}/src/swinging.py", "a") as file:
    _ = file.write("\\nfrom vpython import sphere\\nsphere()\\nprint('the new file')\\n")

start("text_cradle_run", "--seconds", "0.01")
start("visualize_cradle_run", "--help")
start("visualize_cradle_run", "--no-browser")
start("visualize_cradle_run", "--no-browser")
END"""


def test_in_a_session_each_start_is_fresh_and_a_closed_tab_gives_the_prompt_back(program):
    """As in IPython: with changed files, with and without VPython.

    The page shows what a file draws, and that once.
    """
    folder = program.parents[1]
    site = folder / "support" / "page" / "connection.py"
    change(site, "RETURN = 3.0", "RETURN = 0.1")  # s: quickly
    session = SESSION.format(python=sys.executable, folder=folder)
    with running("-c", session, python="sh") as process:

        def until_the_prompt():
            return [*iter(process.stdout.readline, "the prompt\n")]

        assert [line[:3] for line in until_the_prompt()] == ["t ="] * 2
        assert [line[:3] for line in until_the_prompt()] == ["the", "t =", "t ="]
        assert until_the_prompt()[-1] == "status 0\n"
        for _ in range(2):
            assert process.stdout.readline() == "the new file\n"
            spheres = 0
            with Tab(urlsplit(first_lines(process))) as tab:
                is_swinging = False
                while not is_swinging:
                    message = tab.hear()
                    spheres += sum(cmd.get("cmd") == "sphere" for cmd in message["cmds"])
                    is_swinging = "motion" in message["state"]
            assert spheres == 5 + 1
            assert until_the_prompt() == []
        assert end(process)[:2] == (0, "")


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


@pytest.mark.parametrize("path", ["/", "", "/user/ann/proxy/8000", "/user/ann/proxy/8000/"])
@pytest.mark.parametrize(
    "request_line", ["HEAD {} HTTP/1.1", "GET {} HTTP/1.0", "HEAD {} HTTP/1.0"]
)
def test_a_request_in_another_way_is_answered_as_well(site, path, request_line):
    """Without the last slash of a proxy's address; its head only; of an older version, without a
    Host.
    """
    page = (WEB / "page.html").read_bytes()
    request = request_line.format(f"{path}?{site.query}")
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
