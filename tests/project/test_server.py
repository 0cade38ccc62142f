"""The server of the page: what it does for a tab and for everyone else, at one port; and when the
program ends.
"""

import json
import random
import re
import signal
import socket
import sys
import threading
from contextlib import ExitStack, suppress
from http.client import HTTPConnection
from importlib.machinery import PathFinder
from pathlib import Path
from queue import Queue
from types import SimpleNamespace
from urllib.parse import urlsplit

import programs
import pytest
from programs import copy_project, end, first_lines, QUIETLY, ROOT, running, SECONDS
from students import change, put_files
from whole_cradles import FIVE_CSV, GOOD, HEADER

from support.page.tabs import LOOK, Tabs

server = pytest.importorskip("support.page.server")  # it needs autobahn, which comes with VPython
pytestmark = programs.needs_vpython

WEB, BELOW = ROOT / "support" / "page" / "web", "/user/ann/proxy/8000/"


def ask(page, path, query="{key}", host="127.0.0.1", method="GET", **headers):
    """Send a request with exactly this path and query, by default the key; return the connection
    and the answer.
    """
    connection = HTTPConnection(host, page.port, timeout=SECONDS)
    headers = {name.replace("_", "-"): text for name, text in headers.items() if text is not None}
    connection.request(method, f"{path}?{query.format(key=page.query)}", headers=headers)
    return connection, connection.getresponse()


def get(*request, **headers):
    """Return the status and the headers of the answer to a GET, and its content."""
    answer = ask(*request, **headers)[1]
    return answer.status, answer.headers, answer.read()


PING = 0x89  # the first byte of a websocket's ping


class Tab(ExitStack):
    """A tab without a browser: a websocket, if the status of the answer is 101."""

    def __init__(self, page, path="/ws", query="{key}", origin="http://127.0.0.1"):
        super().__init__()
        headers = {
            "Sec_WebSocket_Version": "13",
            "Sec_WebSocket_Key": "dGhlIHNhbXBsZSBub25jZQ==",
            "Origin": origin,
        }
        self.connection, self.answer = ask(
            page, path, query, Upgrade="websocket", Connection="Upgrade", **headers
        )
        self.callback(self.connection.close)
        self.callback(self.answer.close)
        if self.answer.status == 101:
            self.callback(self.leave)

    def leave(self):
        """Say goodbye, and wait until it is heard: a socket that closes with unread bytes takes it
        back.
        """
        with suppress(OSError):  # the program may have ended
            self.tell(b"\x03\xe9", kind=8)  # it goes away
            self.connection.sock.shutdown(socket.SHUT_WR)
            self.answer.fp.read()

    def tell(self, message, kind=1):
        """Send a message; of kind 1 it is a text, of kind 2 it is bytes."""
        size = (
            [len(message) | 0x80]
            if len(message) < 126
            else [126 | 0x80, *len(message).to_bytes(2, "big")]
        )
        self.connection.sock.sendall(bytes([0x80 | kind, *size, *bytes(4)]) + message)

    def hear(self):
        """Return the next message of the program, and answer that the picture is drawn.

        Answer each ping before it.
        """
        read = self.answer.fp.read
        while True:
            kind, size = read(2)
            data = read(int.from_bytes(read({126: 2, 127: 8}[size]), "big") if size > 125 else size)
            if kind == PING:
                self.tell(data, kind=10)
            elif data:  # else it is only a sign of life
                self.tell(b"seen")
                return json.loads(data)

    def stay(self):
        """Answer the program until it ends."""
        with suppress(ValueError):  # no more bytes
            while True:
                self.hear()

    def state(self, *names):
        """Return the next state that has these names."""
        return next(
            state for state in iter(lambda: self.hear()["state"], None) if state.keys() >= {*names}
        )


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A working folder with a secret, in a folder with a secret; both end as something that the
    server has.
    """
    files = dict.fromkeys(["secret.js", "working/secret.js"], "secret")
    return put_files(tmp_path_factory.mktemp("outside"), files) / "working"


@pytest.fixture(scope="module")
def site(folder):
    """The address of a program that has a tab from beginning to end, and prints nothing more; its
    query is the key.
    """
    program = copy_project(folder.parent, FIVE_CSV) / "src" / programs.PROGRAM.name
    with running(program, folder=folder, patience=60 * SECONDS) as process:
        tab = Tab(page := urlsplit(first_lines(process)))
        threading.Thread(target=tab.stay, daemon=True).start()
        yield page
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_only_this_machine_reaches_the_page_unless_you_ask_for_more_and_then_the_program_says_so(
    site,
):
    other_address = "127.0.0.2"  # of this machine
    with pytest.raises(OSError):
        socket.create_connection((other_address, site.port), timeout=SECONDS)
    with running(None, "--host", "0.0.0.0") as process:
        page, warning = urlsplit(process.stdout.readline().split()[-1]), process.stdout.readline()
        assert warning.startswith("Every machine that reaches this one can open it")
        for host in (page.hostname, other_address):
            assert [get(page, "/", query, host)[0] for query in ("", "{key}")] == [403, 200]


def test_only_files_that_everybody_can_download_come_without_the_key(site, folder):
    """They come whole. vpython.js is a part of VPython's page, without the websocket there, which
    goes to localhost.
    """
    for name in (
        "secret.js",
        "../secret.js",
        "%2e%2e%2fsecret.js",
        f"{'../' * 40}{folder}/secret.js",
        "page.html",
    ):
        status, _, content = get(site, f"/{name}")
        assert (name, status, content) == (name, 404, b"")
    vpython = Path(PathFinder.find_spec("vpython").origin).parent
    libraries, pictures = vpython / "vpython_libraries", vpython / "vpython_data"
    for file in (WEB / "page.js", libraries / "glow.min.js", pictures / "wood_texture.jpg"):
        assert get(site, BELOW + file.name, "")[::2] == (200, file.read_bytes())
    script = get(site, "/vpython.js", "")[2]
    assert b"function decode(" in script and script in (libraries / "glowcomm.html").read_bytes()
    assert b"WebSocket" not in script


@pytest.mark.parametrize(
    "query", ["", "key=", "key=wrong", "{key}0", "key=%ff%00", "redirect=http://evil.example"]
)
@pytest.mark.parametrize("path", ["/", BELOW])
def test_without_the_key_the_page_is_a_sentence_and_the_websocket_is_refused(site, path, query):
    """A request can have all headers of a browser: another program on this machine can send it."""
    for name in ("", "alive"):
        status, headers, content = get(
            site, path + name, query, Origin="http://a", Sec_Fetch_Site="same-origin"
        )
        assert (status, content.decode()) == (403, server.NO_KEY) and site.query[4:] not in str(
            headers
        )
    with Tab(site, f"{path}ws", query) as tab:
        assert tab.answer.status in (400, 403)


@pytest.mark.parametrize("query", ["{key}", "{key}&redirect=http://evil.example"])
@pytest.mark.parametrize("path", ["/", BELOW])
def test_with_the_key_a_browser_gets_all_below_any_path_from_any_address(site, path, query):
    """The page sends its address to no other site, and leads to none.

    Without an Origin it is no browser; the Origin null is that of a file, or of a frame that a page
    has shut in.
    """
    for name, expected in (("", (WEB / "page.html").read_bytes()), ("alive", b"alive")):
        status, headers, content = get(site, path + name, query)
        assert (status, content, headers["Location"]) == (200, expected, None)
        assert headers["Referrer-Policy"] == "no-referrer"
    for origin in ("http://127.0.0.1:19000", "https://a-cradle.example.org", None, "", "null"):
        with Tab(site, f"{path}ws", query, origin) as tab:
            assert tab.answer.status in ([101] if origin and "://" in origin else [400, 403])


TEXTS = [
    b"",
    b"[",
    b"{}",
    b"[]",
    b"seen ",
    b'"pause"',
    b"\0",
    b"[" * 60_000,
    b'["speed",' + b"9" * 5000 + b"]",
]
TEXTS += [
    b"5",
    b'["speed", 1e400]',
    b'["lifted", "<b>"]',
    b'["restart", 1]',
    b"[[], 1]",
    b'[null, {"a": []}]',
]
KEPT = (
    "title",
    "running",
    "lifted",
    "lifts",
    "collision",
    "experiment",
    "arrows",
    "slow hits",
    "mass",
    "e",
)


def test_rubbish_changes_nothing_and_prints_nothing(site):
    """Messages of a tab; and connections that a browser has opened in advance, or that somebody
    tries out.

    test_table.py has more commands that are refused.
    """
    chance = random.Random(45)
    with Tab(site) as tab:
        before = tab.state(*KEPT)
        for text in TEXTS:
            tab.tell(text)
            tab.tell(chance.randbytes(99), kind=2)
        tab.tell(b'["speed", 0.5]')  # when this has been done, so has all before it
        while tab.state("speed")["speed"] != 0.5:
            pass
        assert tab.state("motion") != tab.state("motion")  # it swings on
    for request in (
        b"",
        b"GET /../secret.js HTTP/1.1\r\n\r\n",
        b"\x16\x03\r\n\r\n",
        *map(chance.randbytes, range(99)),
    ):
        with (
            suppress(ConnectionError),
            socket.create_connection(("127.0.0.1", site.port), SECONDS) as idle,
        ):
            idle.sendall(request)
            assert get(site, "/")[0] == 200
    with Tab(site) as tab:
        after = tab.state(*KEPT)
        assert {name: after[name] for name in KEPT} == {name: before[name] for name in KEPT}


@pytest.mark.slow
def test_the_program_waits_for_a_tab_whose_browser_crashes_and_says_so(csv):
    """In the middle of a message.

    Before that: a tab gets the largest cradle; one that would fill the memory ends.
    """
    csv.write_text(HEADER + GOOD * 1000)
    with running(None, str(csv)) as process:
        page, named = urlsplit(first_lines(process)), "{key}&page=1"
        with Tab(page) as tab:
            assert len(tab.hear()["cmds"]) > 3000
        with Tab(page, query=named) as tab, suppress(ConnectionResetError):
            tab.connection.sock.sendall(
                b"\x81\xff" + (server.LARGEST_MESSAGE + 1).to_bytes(8, "big") + bytes(4)
            )
            tab.answer.fp.read()  # until the end
        with Tab(page, query=named) as tab:
            tab.connection.sock.sendall(b"\x81\xff")
        assert process.stdout.readline().startswith("A page does not answer")
        with Tab(page, query=named):
            assert process.stdout.readline() == "The page is back.\n"
        assert end(process) == QUIETLY


# A browser: it writes down who can read the file that it gets, where that leads to, and what the
# page answers at once.
BROWSER = """#!{python}
import os, re, sys, urllib.request as web
address = re.search('url=([^"]*)', web.urlopen(sys.argv[1]).read().decode())[1]
mode = oct(os.stat(*os.listdir()).st_mode)[-3:]
print(mode, address, web.urlopen(address).status, *sys.argv[1:], file=open("{visited}", "w"))
"""


@pytest.mark.parametrize(
    ("until", "status"), [("a tab", 0), ("SIGINT", 0), ("SIGTERM", 143), ("SIGHUP", 129), ("", 0)]
)
def test_a_browser_with_pictures_gets_a_file_that_leads_on(tmp_path, until, status):
    """All users of a machine can read a command; only you the file.

    It goes with the first tab, or with the program.
    """
    name = "browser" if until else "w3m"
    folder, visited, browser = (tmp_path / path for path in ("100% ü #1", "visited", name))
    folder.mkdir()
    browser.write_text(BROWSER.format(python=sys.executable, visited=visited))
    browser.chmod(0o755)
    with running(folder=folder, BROWSER=str(browser), VPYTHON_NO_LAUNCH_BROWSER="") as process:
        address = first_lines(process)
        if until:
            programs.wait_until(lambda: visited.exists() and visited.read_text().endswith("\n"))
            *seen, given = visited.read_text().split()
            assert seen == ["600", address, "200"]
            assert given.startswith("file://") and address.partition("key=")[2] not in given
        if until.startswith("SIG"):
            process.send_signal(getattr(signal, until))
        else:
            with Tab(urlsplit(address)) as tab:
                tab.state("motion")  # the program would have started a browser before it swings
                assert not [*folder.iterdir()]
        assert end(process) == (status, "", "")
    assert (visited.exists(), [*folder.iterdir()]) == (bool(until), [])


@pytest.mark.parametrize(
    ("release", "place"), [("6.1.0-18-amd64", "file"), ("5.15.90-Microsoft-WSL2", "http")]
)
def test_a_browser_that_sees_no_file_of_this_system_gets_the_address(monkeypatch, release, place):
    opened = Queue()
    monkeypatch.setattr("platform.release", lambda: release)
    monkeypatch.setattr("webbrowser.get", lambda: SimpleNamespace(open=opened.put))
    server.Server.open_browser(SimpleNamespace(address=lambda: "http", make_way=lambda: "file"))
    assert opened.get(timeout=SECONDS) == place


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
    site = folder / "support" / "page" / "server.py"
    # s: quickly
    site.write_text(site.read_text().replace("RETURN, LOADING = 3.0", "RETURN, LOADING = 0.1"))
    with running(
        "-c", SESSION.format(python=sys.executable, folder=folder), python="sh"
    ) as session:

        def until_the_prompt():
            return [*iter(session.stdout.readline, "the prompt\n")]

        assert [line[:3] for line in until_the_prompt()] == ["t ="] * 2
        assert [line[:3] for line in until_the_prompt()] == ["the", "t =", "t ="]
        assert until_the_prompt()[-1] == "status 0\n"
        for _ in range(2):
            assert session.stdout.readline() == "the new file\n"
            with Tab(urlsplit(first_lines(session))) as tab:
                kinds, message = [], {"state": {}}
                while "motion" not in message["state"]:  # until it swings
                    message = tab.hear()
                    kinds += [cmd.get("cmd") for cmd in message["cmds"]]
                assert kinds.count("sphere") == 5 + 1
            assert until_the_prompt() == []
        assert end(session)[:2] == (0, "")


def test_an_address_that_the_page_cannot_have_is_refused_in_one_line_and_a_port_is_free_at_the_end():
    """192.0.2.1 is no address of this machine; browsers refuse 6000."""
    with server.listen("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        none = [
            ("127.0.0.1", port, port),
            ("127.0.0.1", 6000, "6000.* browsers"),
            ("192.0.2.1", 0, "192.0.2.1"),
        ]
        for host, number, words in (*none, ("no such host", 0, "host: found 'no such host")):
            with pytest.raises(ValueError, match=rf"^[^\n]*\b{words}\b[^\n]+$"):
                server.listen(host, number)
        with socket.create_connection(("127.0.0.1", port)):
            # The side that closes first keeps the connection's port busy for a while
            listener.accept()[0].close()
    server.listen("127.0.0.1", port).close()


# How a websocket closes: its line was cut, its page was left
CUT = (False, 1006, "")
LEFT = (True, 1001, "")


@pytest.fixture
def silent_site(monkeypatch):
    """A server without a network, and without time: site.wait(seconds) does the looks of this time."""
    loop = SimpleNamespace(call_later=lambda delay, function: site.later.append(function))
    monkeypatch.setattr(server, "own_files", dict)
    monkeypatch.setattr(
        server.Server, "serve", lambda site, ready: setattr(site, "loop", loop) or ready.set()
    )
    site = server.Server(None, Tabs())
    site.later = []
    site.wait = lambda seconds: [site.look() for _ in range(round(seconds / LOOK))]
    return site


def connection(site, **parameters):
    """Return a connection of a request with these parameters, without a network."""
    tab = type("Connection", (server.Protocol,), {"site": site})()
    tab.http_request_params = {name: [text] for name, text in parameters.items()}
    tab.state = tab.STATE_CLOSED  # so nothing is sent
    tab.dropConnection = lambda abort: tab.onClose(*CUT)
    return tab


def test_the_program_ends_when_the_time_to_come_back_is_over(silent_site, monkeypatch, capsys):
    """A tab that loads has longer: a slow machine loads the page for seconds before it opens the
    websocket.

    Before the first tab, the program waits for ever. A request without the key wins no time.
    """
    site, stops = silent_site, []
    monkeypatch.setattr(server, "interrupt_main", lambda: stops.append("now"))
    tab, other, stranger = connection(site), connection(site), connection(site)
    for event, *how in (
        (stranger.onClose, *CUT),
        (tab.onOpen,),
        (other.onOpen,),
        (other.onClose, *LEFT),
    ):
        event(*how)
        tab.onPong(b"")
        site.wait(9)
    tab.onClose(*CUT)
    tab.content("goodbye", {"key": [site.key], "page": [tab.page]})
    for seconds in (0.8 * server.RETURN, 0.9 * server.LOADING):
        site.wait(seconds)
        tab.content("", {"key": [site.key]})
    tab.onOpen()
    tab.onClose(*LEFT)
    site.wait(server.RETURN)
    tab.content("", {})
    assert not site.tabs.are_gone
    site.wait(LOOK)
    assert (site.tabs.are_gone, stops) == (True, [])  # main can end by itself
    site.later[-1]()
    assert (stops, capsys.readouterr().out) == (["now"], "")
    assert site.key != server.Server(None, Tabs()).key  # each start has its own


@pytest.mark.parametrize("is_silent", [False, True])
def test_a_page_that_is_lost_without_a_goodbye_has_a_minute(silent_site, capsys, is_silent):
    """Its bob swings on at once.

    When it goes on before the program has noticed, its old websocket costs no minute.
    """
    site, given = silent_site, []
    site.tabs.give = lambda command, *values: given.append(command)
    tab, again = connection(site, page="0.5", has="7"), connection(site, page="0.5", has="9" * 5000)
    tab.onOpen()
    tab.onMessage(b'["grab"]', False)
    if is_silent:
        site.wait(server.SILENT)
        assert given == ["grab"]
        site.wait(LOOK)
    else:
        tab.onClose(*CUT)
    assert given == ["grab", "let go"]
    site.wait(server.LOST)
    words = (
        "A page does not answer: its line is cut, its machine sleeps, or its browser has ended. "
    )
    assert capsys.readouterr().out == f"{words}The program waits 57 s for it.\n"
    tab.onOpen()
    again.onOpen()  # before anything says that tab is lost
    assert ([*site.tabs.tabs], capsys.readouterr().out) == ([again], "The page is back.\n")
    other = connection(site)
    other.onOpen()
    again.onClose(*CUT)
    for _ in range(8):  # longer than a minute
        other.onPong(b"")
        site.wait(8)
    other.onClose(*LEFT)
    site.wait(server.RETURN)
    assert (site.tabs.are_gone, capsys.readouterr().out) == (False, "")
    site.wait(LOOK)
    assert site.tabs.are_gone


def test_another_page_takes_nothing_from_the_minute_of_a_lost_one(silent_site):
    lost, other = connection(silent_site, page="1"), connection(silent_site, page="2")
    lost.onOpen()
    lost.onClose(*CUT)
    other.onOpen()
    other.onClose(*LEFT)
    silent_site.wait(server.LOST)
    assert not silent_site.tabs.are_gone
    silent_site.wait(LOOK)
    assert silent_site.tabs.are_gone


@pytest.mark.parametrize("path", ["/", "", "/user/ann/proxy/8000", BELOW])
@pytest.mark.parametrize(
    "request_line", ["HEAD {} HTTP/1.1", "GET {} HTTP/1.0", "HEAD {} HTTP/1.0"]
)
def test_a_request_in_another_way_is_answered_as_well(site, path, request_line):
    """Without the last slash of a proxy's address; its head only; of an older version, without a
    Host.
    """
    expected = get(site, path)
    assert expected[::2] == (200, (WEB / "page.html").read_bytes())
    with socket.create_connection((site.hostname, site.port), timeout=SECONDS) as client:
        client.sendall(f"{request_line}\r\n\r\n".format(f"{path}?{site.query}").encode())
        head, _, content = b"".join(iter(lambda: client.recv(2**16), b"")).partition(b"\r\n\r\n")
    assert f"Content-Length: {len(expected[2])}".encode() in head
    assert content == (expected[2] if request_line.startswith("GET") else b"")


def test_neither_many_connections_nor_an_endless_request_keep_others_away(site):
    """The oldest connection ends when there are too many; so does one that sends too long a head.

    Another one stays.
    """
    with ExitStack() as stack:
        place = site.hostname, site.port
        idle = [
            stack.enter_context(socket.create_connection(place, SECONDS))
            for _ in range(server.MOST_WAITING + 1)
        ]
        idle[-1].sendall(bytes(server.LARGEST_HEAD + 1))
        for ended in (idle[0], idle[-1]):
            with suppress(ConnectionResetError):
                assert ended.recv(1) == b""
        assert get(site, "/")[0] == 200
        idle[2].setblocking(False)
        with pytest.raises(BlockingIOError):
            idle[2].recv(1)


@pytest.mark.slow
def test_the_page_names_the_function_that_does_not_return_until_it_does(tmp_path):
    """The one with the loop, not one that it calls again and again."""
    program = copy_project(tmp_path, FIVE_CSV) / "src" / programs.PROGRAM.name
    stuck = tmp_path / "stuck"
    begin = "    for pend_dict in pend_list:\n"
    loop = f"    while __import__('os').path.exists({str(stuck)!r}):\n"
    call = "        swing_update(pend_list[0], r_param, dt, g)\n"
    change(tmp_path / "src" / "swinging.py", begin, loop + call + begin)
    with running(program) as process:
        with Tab(urlsplit(first_lines(process))) as tab:
            tab.state("motion")
            stuck.touch()
            words = r"full_swing_update in src/swinging\.py, line \d+, has been running for 3 s and has not returned\."
            assert re.fullmatch(words, tab.state("endless")["endless"])
            stuck.unlink()
            assert tab.state("endless")["endless"] == ""
        assert end(process) == QUIETLY
