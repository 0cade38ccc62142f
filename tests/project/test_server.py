"""What the server of the page answers at its port: to whom, and at which path."""

import signal
import socket
import threading
from importlib.machinery import PathFinder
from pathlib import Path
from urllib.parse import urlsplit

import programs
import pytest
from programs import copy_project, end, first_lines, QUIETLY, ROOT, running, SECONDS
from web_client import BELOW, get, PING, Tab
from whole_cradles import FIVE_CSV

from support.page.server.port import listen
from support.page.server.site import NO_KEY

# It needs autobahn, which comes with VPython.
server = pytest.importorskip("support.page.server.server")
pytestmark = programs.needs_vpython


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The address of a program that has a tab from beginning to end, and prints nothing more.

    Its query is the key.
    """
    folder = copy_project(tmp_path_factory.mktemp("site"), FIVE_CSV)
    program = folder / "src" / programs.PROGRAM.name
    with running(program, patience=60 * SECONDS) as process:
        page = urlsplit(first_lines(process))
        tab = Tab(page)
        tab.hear()  # now all is imported: some imports would catch the end
        threading.Thread(target=tab.stay, daemon=True).start()
        yield page
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_only_this_machine_reaches_the_page_unless_you_ask_for_more_and_then_the_program_says_so(
    site,
):
    other_address = "127.0.0.2"  # of this machine
    with pytest.raises(OSError):
        get(site, "/", "{key}", other_address)
    with running(None, "--host", "0.0.0.0") as process:
        page = urlsplit(process.stdout.readline().split()[-1])
        warning = process.stdout.readline()
        assert warning.startswith("Every machine that reaches this one can open it")
        assert get(page, "/", "", other_address)[0] == 403
        assert get(page, "/", "{key}", other_address)[0] == 200


@pytest.mark.parametrize("name", ["page.html", "../server/site.py", "%2e%2e%2fserver%2fsite.py"])
def test_a_file_that_is_not_of_the_page_is_not_there(site, name):
    assert get(site, f"/{name}")[::2] == (404, b"")


def test_files_that_everybody_can_download_come_whole_without_the_key(site):
    """vpython.js is a part of VPython's page, without its websocket, which goes to localhost."""
    vpython = Path(PathFinder.find_spec("vpython").origin).parent
    libraries = vpython / "vpython_libraries"
    script = ROOT / "support" / "page" / "web" / "page.js"
    picture = vpython / "vpython_data/wood_texture.jpg"
    for file in (script, libraries / "jquery.min.js", picture):
        assert get(site, BELOW + file.name, "")[::2] == (200, file.read_bytes())
    script = get(site, "/vpython.js", "")[2]
    assert b"function decode(" in script
    assert script in (libraries / "glowcomm.html").read_bytes()
    assert b"WebSocket" not in script


@pytest.mark.parametrize("query", ["", "{key}0", "key=%ff%00"])
def test_without_the_key_the_page_is_a_sentence(site, query):
    for name in ("", "alive"):
        status, headers, content = get(site, BELOW + name, query)
        assert (status, content.decode()) == (403, NO_KEY)
        assert site.query.removeprefix("key=") not in str(headers)


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
    ("query", "origin", "status"),
    [
        ("{key}", "https://a-cradle.example.org", 101),
        ("", "http://127.0.0.1", 403),
        ("{key}0", "http://127.0.0.1", 403),
        ("{key}", None, 403),  # no browser
        ("{key}", "null", 400),  # a frame that a page has shut in
        ("{key}", "file://", 400),
    ],
)
def test_only_a_browser_with_the_key_gets_the_websocket_at_any_address(site, query, origin, status):
    with Tab(site, query, origin, BELOW) as tab:
        assert tab.answer.status == status


def test_a_tab_that_would_fill_the_memory_is_cut_off(site):
    """At the begin of its message, not when it has been silent for some time."""
    with Tab(site) as tab:
        size = (20_000_000).to_bytes(8, "big")
        tab.connection.sock.sendall(b"\x81\xff" + size + bytes(4))
        heard = tab.answer.fp.read()  # until the end
        assert heard.count(bytes([PING, 0])) < 3


def test_an_address_that_the_page_cannot_have_is_named_and_a_port_is_free_at_the_end():
    with listen("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        for host, number in (
            ("127.0.0.1", port),
            ("192.0.2.1", 0),  # no address of this machine
            ("no such host", 0),
        ):
            with pytest.raises(ValueError, match=rf"^port {number} of {host} is not [^\n]+$"):
                listen(host, number)
        with socket.create_connection(("127.0.0.1", port)):
            # The side that closes first keeps the connection's port busy for a while
            listener.accept()[0].close()
    listen("127.0.0.1", port).close()
