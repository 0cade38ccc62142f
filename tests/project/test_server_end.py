"""When the program of a page ends: with its last tab, or a minute after it was lost."""

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


class Connection(connections.Connection):
    """A connection of a page, without a network."""

    def __init__(self, silent, page, was=""):
        super().__init__(silent.site, silent.attendance, silent.tabs)
        self.http_request_params = {"page": [page], "was": [was], "has": ["7"]}
        self.state = self.STATE_CLOSED  # so nothing is sent

    def dropConnection(self, abort):  # noqa: N802
        self.is_cut()

    def opens(self):
        self.onOpen()

    def is_cut(self):
        self.onClose(False, 1006, "")

    def closes(self):
        self.onClose(True, 4001, "")

    def loads(self):
        self.asks_for("")

    def says_left(self):
        self.asks_for("left")

    def says_closed(self):
        self.asks_for("closed")

    def asks_for(self, name):
        parameters = {"key": [self.site.key], **self.http_request_params}
        programs.result_of(self.site.response_to(name, parameters))


@pytest.mark.parametrize(
    ("events", "rest"),
    [
        ("first opens, first closes", CLOSED),
        ("first opens, first is_cut", LOST),
        ("first opens, first says_left, first is_cut", LEFT),
        ("first opens, first is_cut, first says_left", LEFT),
        ("first opens, first says_left, first is_cut, first says_closed", CLOSED),
        ("first opens, first is_cut, first opens, first closes", CLOSED),
        ("first opens, first closes, first loads", LOADING),  # a slow machine loads for seconds
        ("first opens, first is_cut, other opens, other closes", LOST),
        # A reload, which names the page before it
        ("first opens, first says_left, first is_cut, again loads, again opens, again closes", 3),
    ],
)
def test_the_program_ends_when_the_time_to_come_back_is_over(silent, events, rest):
    """Before the first tab, it waits for ever."""
    silent.wait(99)
    pages = {name: Connection(silent, name) for name in ("first", "other")}
    pages["again"] = Connection(silent, "again", was="first")
    for event in events.split(", "):
        name, does = event.split()
        getattr(pages[name], does)()
    silent.wait(rest)
    assert not silent.tabs.are_gone
    silent.wait(LOOK_AT_TABS)
    assert silent.tabs.are_gone


def test_main_has_a_moment_to_end_by_itself(silent, monkeypatch):
    stops = []
    monkeypatch.setattr(server, "interrupt_main", lambda: stops.append("now"))
    tab = Connection(silent, "1")
    tab.opens()
    tab.closes()
    silent.wait(CLOSED + LOOK_AT_TABS)
    assert stops == []
    silent.later[-1]()
    assert stops == ["now"]


def test_a_silent_page_is_lost_and_lets_its_bob_go_and_the_terminal_says_so(silent, capsys):
    """A page that answers is not. After a short silence, nothing is said."""
    tab = Connection(silent, "1")
    tab.opens()
    tab.onMessage(b'["grab"]', False)
    assert silent.tabs.commands.get_nowait() == ["grab"]
    silent.wait(connections.SILENT)
    tab.onPong(b"")
    silent.wait(connections.SILENT)
    assert silent.tabs.commands.empty()
    silent.wait(LOOK_AT_TABS)
    assert silent.tabs.commands.get_nowait() == ["let_go"]
    silent.wait(FLICKER - LOOK_AT_TABS)
    assert capsys.readouterr().out == ""
    silent.wait(LOOK_AT_TABS)
    assert capsys.readouterr().out == (
        "The page has gone: you have left or closed it, its line is cut, or its machine sleeps. "
        "The program waits 57 s for it. Ctrl+C ends it at once.\n"
    )
    tab.opens()
    assert capsys.readouterr().out == "The page is back.\n"


def test_a_page_that_is_back_takes_the_place_of_its_old_line(silent):
    """Before anything says that this line is cut."""
    Connection(silent, "1").opens()
    again = Connection(silent, "1")
    again.opens()
    assert [*silent.tabs.tabs] == [again]
