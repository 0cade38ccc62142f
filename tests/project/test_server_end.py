"""When the program of a page ends: with its last tab, or a minute after it was lost."""

import asyncio
from types import SimpleNamespace

import programs
import pytest

from support.page.server.attendance import CLOSED, FLICKER, LEFT, LOADING, LOOK_AT_TABS, LOST

# They need autobahn, which comes with VPython.
server = pytest.importorskip("support.page.server.server")
connections = pytest.importorskip("support.page.server.connection")
pytestmark = programs.needs_vpython


@pytest.fixture
def silent(monkeypatch):
    """A server without a network, and without time: wait(seconds) does the looks of this time.

    later has the functions that it wants to call later.
    """

    def wait(seconds):
        for _ in range(round(seconds / LOOK_AT_TABS)):
            silent.look()

    monkeypatch.setattr("support.page.server.site.keyless_files", dict)
    monkeypatch.setattr(server.Server, "serve", lambda silent, ready: ready.set())
    silent = server.Server(None, {})
    silent.loop.close()
    silent.later = []
    silent.loop = SimpleNamespace(call_later=lambda delay, call: silent.later.append(call))
    silent.wait = wait
    return silent


GONE = (
    "The page has gone: you have left or closed it, its line is cut, or its machine sleeps. "
    "The program waits {:g} s for it. Ctrl+C ends it at once.\n"
)


class Connection(connections.Connection):
    """A connection of a page, without a network."""

    def __init__(self, silent, **parameters):
        super().__init__(silent.site, silent.attendance, silent.tabs, silent.waiting)
        self.http_request_params = {name: [text] for name, text in parameters.items()}
        self.state = self.STATE_CLOSED  # so nothing is sent

    def dropConnection(self, abort):  # noqa: N802
        self.cut()

    def cut(self):
        self.onClose(False, 1006, "")

    def say(self, word):
        self.ask_for(word, {"key": [self.site.key], "page": [self.page_name]})

    def ask_for(self, name, parameters):
        asyncio.run(self.site.response_to(name, parameters))

    def close(self):
        self.onClose(True, 4001, "")


def test_the_program_ends_when_the_time_to_come_back_is_over(silent, monkeypatch, capsys):
    """A tab that loads has longer: a slow machine loads the page for seconds.

    Before the first tab, the program waits for ever. A request without the key wins no time.
    """
    stops = []
    monkeypatch.setattr(server, "interrupt_main", lambda: stops.append("now"))
    key = {"key": [silent.site.key]}
    silent.wait(99)
    Connection(silent).cut()  # it was refused
    tab = Connection(silent)
    other = Connection(silent)
    tab.onOpen()
    other.onOpen()
    other.close()
    for _ in range(3):
        silent.wait(9)
        tab.onPong(b"")
    tab.say("left")
    tab.cut()
    tab.say("closed")
    silent.wait(0.8 * CLOSED)
    tab.ask_for("", key)
    silent.wait(0.9 * LOADING)
    tab.ask_for("", key)
    silent.wait(0.9 * LOADING)
    tab.onOpen()
    tab.close()
    silent.wait(CLOSED)
    tab.ask_for("", {})
    assert not silent.tabs.are_gone
    silent.wait(LOOK_AT_TABS)
    assert silent.tabs.are_gone
    assert stops == []  # main can end by itself
    silent.later[-1]()
    assert stops == ["now"]
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("is_silent", [False, True])
def test_a_page_that_is_lost_without_a_goodbye_has_a_minute(silent, capsys, is_silent):
    """Its bob swings on at once.

    When it goes on before the program has noticed, its old websocket costs no minute.
    """
    tab = Connection(silent, page="0.5", has="7")
    tab.onOpen()
    tab.cut()
    silent.wait(2)
    tab.onOpen()  # so soon that nothing is said
    tab.onMessage(b'["grab"]', False)
    while not silent.tabs.commands.empty():
        last = silent.tabs.commands.get()
    assert last == ["grab"]
    if is_silent:
        silent.wait(connections.SILENT)
        assert silent.tabs.commands.empty()
        silent.wait(LOOK_AT_TABS)
    else:
        tab.cut()
    assert silent.tabs.commands.get() == ["let_go"]
    silent.wait(LOST)
    assert capsys.readouterr().out == GONE.format(57)
    tab.onOpen()
    assert capsys.readouterr().out == "The page is back.\n"
    again = Connection(silent, page="0.5", has="9" * 5000)
    again.onOpen()  # before anything says that tab is lost
    assert [*silent.tabs.tabs] == [again]
    other = Connection(silent)
    other.onOpen()
    again.cut()
    for _ in range(8):  # longer than a minute
        other.onPong(b"")
        silent.wait(8)
    other.close()
    silent.wait(CLOSED)
    assert not silent.tabs.are_gone
    silent.wait(LOOK_AT_TABS)
    assert silent.tabs.are_gone
    assert capsys.readouterr().out == ""


def test_a_page_that_is_left_can_come_back_by_back_or_by_a_reload(silent, capsys):
    """Under its own name, or as another one that names it; it then leaves nothing to wait for."""
    tab = Connection(silent, page="1")
    again = Connection(silent, page="2", was="1")
    for back in (tab, again):
        tab.onOpen()
        tab.cut()
        tab.say("left")
        silent.wait(LEFT)
        assert capsys.readouterr().out == GONE.format(LEFT - FLICKER)
        assert not silent.tabs.are_gone
        back.onOpen()
        assert capsys.readouterr().out == "The page is back.\n"
    again.close()
    silent.wait(CLOSED)
    assert not silent.tabs.are_gone
    silent.wait(LOOK_AT_TABS)
    assert silent.tabs.are_gone


def test_another_page_takes_nothing_from_the_minute_of_a_lost_one(silent):
    lost = Connection(silent, page="1")
    other = Connection(silent, page="2")
    lost.onOpen()
    lost.cut()
    other.onOpen()
    other.close()
    silent.wait(LOST)
    assert not silent.tabs.are_gone
    silent.wait(LOOK_AT_TABS)
    assert silent.tabs.are_gone
