"""What the server of the page answers at its port: to whom, and at which path."""

import gc
import json
import socket
import time
from contextlib import suppress
from importlib.machinery import PathFinder
from pathlib import Path
from threading import Barrier
from types import SimpleNamespace
from unittest import mock
from urllib.parse import urlsplit

import programs
import pytest
from programs import ROOT
from tornado.httpclient import HTTPClientError
from tornado.websocket import WebSocketClosedError
from web_client import BELOW, get, Tab

from support.page.names import COMMANDS
from support.page.server import server
from support.page.server.port import listen

pytestmark = programs.needs_vpython


@pytest.fixture(scope="module")
def site():
    """A server, its port, and the query with the key of the tab that commands."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(server, "interrupt_main", lambda: None)
        texts = {"command": "py a.py", "csv": "a.csv"}
        running_server = server.Server(listen("127.0.0.1", 0), texts)
        address = urlsplit(running_server.address())
        yield SimpleNamespace(server=running_server, port=address.port, query=address.query)
        running_server.close()


def test_a_file_that_is_not_of_the_page_is_not_there(site):
    assert get(site, "/page.html")[0] == 404


def test_files_that_everybody_can_download_come_whole_without_the_key(site):
    vpython = Path(PathFinder.find_spec("vpython").origin).parent
    libraries = vpython / "vpython_libraries"
    script = ROOT / "support" / "page" / "web" / "page.js"
    picture = vpython / "vpython_data/wood_texture.jpg"
    for file in (script, libraries / "jquery.min.js", picture):
        assert get(site, BELOW + file.name, "")[::2] == (200, file.read_bytes())


def test_the_page_and_its_film_need_a_key_and_a_film_that_of_the_tab_that_commands(site):
    """The page comes below any path, and sends its address to no other site."""
    follow = f"follow={site.server.keys['follow']}"
    for query, page, gets_film in (
        ("", 403, False),
        ("{key}0", 403, False),
        (follow, 200, False),
        ("{key}", 200, True),
    ):
        status, headers, content = get(site, BELOW, query)
        assert status == page
        assert headers["Referrer-Policy"] == "no-referrer"
        assert (b"py a.py</code>" in content) == gets_film
        assert (server.NO_KEY.encode() in content) == (status == 403)
        with mock.patch("support.page.server.film_file.film_as_html", lambda pictures: b"a film"):
            found = get(site, f"{BELOW}film.html", query)[0]
        assert (found == 200) == gets_film


@pytest.mark.parametrize(
    ("query", "origin", "status"),
    [
        ("{key}", "https://a-cradle.example.org", 101),
        ("{key}0", "http://127.0.0.1", 403),
        ("", "http://127.0.0.1", 403),
        ("{key}", "null", 403),  # a frame that a page has shut in, or a file
    ],
)
def test_only_a_browser_with_a_key_gets_the_websocket_at_any_address(site, query, origin, status):
    found = 101
    try:
        with Tab(site, query, origin, BELOW):
            pass
    except HTTPClientError as refused:
        found = refused.code
    assert found == status


def test_a_tab_with_the_second_key_gets_all_and_commands_nothing(site):
    site.server.tabs.tell({"title": "A cradle"})
    query = f"follow={site.server.keys['follow']}"
    with Tab(site, query) as follower, Tab(site) as tab:
        assert follower.hear() == tab.hear()
        for command in COMMANDS:
            follower.tell(json.dumps([command, 1, 1]))
        follower.tell('["seen", 1]')
        programs.wait_until(site.server.tabs.is_seen.is_set)
        tab.tell('["pause"]')
        assert site.server.tabs.commands.get(timeout=programs.SECONDS) == ["pause"]


def test_a_closed_tab_is_not_cut_although_the_program_still_writes(site):
    """The browser says that it closes the tab. This is read before a write, which would fail."""
    attendance = site.server.attendance
    meet = Barrier(2, timeout=programs.SECONDS).wait
    with mock.patch.object(attendance, "lose", wraps=attendance.lose) as lose:
        tab = Tab(site)
        line = tab.socket.protocol.stream.socket
        site.server.tabs.tell({"title": "Not read"})
        for _ in range(2):
            site.server.loop.call_soon_threadsafe(meet)
        site.server.tabs.tell({"title": "Too late"})
        meet()  # the program has written, and stands still
        line.sendall(b"\x88\x82" + bytes(4) + (1001).to_bytes(2, "big"))  # a browser's goodbye
        line.close()
        meet()
        programs.wait_until(lambda: lose.called)
        tab.loop.close()
    lose.assert_called_once_with(is_cut=False)


def test_a_tab_that_would_fill_the_memory_is_cut_off(site):
    with Tab(site) as tab, suppress(WebSocketClosedError):
        tab.tell(10_000_000 * "a")
    assert tab.socket.close_code != 1001  # it was not closed by itself


def test_an_end_at_once_after_a_message_is_quiet(monkeypatch, recwarn):
    gc.collect()  # what earlier tests have left
    recwarn.clear()
    monkeypatch.setattr(server, "FAREWELL", 0)
    ended = server.Server(listen("127.0.0.1", 0), {"command": "", "csv": ""})
    address = urlsplit(ended.address())
    with Tab(SimpleNamespace(port=address.port, query=address.query)):
        ended.loop.call_soon_threadsafe(time.sleep, 0.05)  # so all else comes in one turn
        ended.close()
    gc.collect()
    assert [str(warning.message) for warning in recwarn.list] == []


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
