"""When the program of a page ends: with its last tab, or a minute after it was lost.

Without a network, and without time.
"""

from types import SimpleNamespace

import programs
import pytest

from support.page.tabs import LOOK_AT_TABS, Tabs

# They need autobahn, which comes with VPython.
server = pytest.importorskip("support.page.server")
connections = pytest.importorskip("support.page.connection")
pytestmark = programs.needs_vpython


@pytest.fixture
def silent_site(monkeypatch):
    """A server without a network, and without time: site.wait(seconds) does the looks of this time.

    site.later are the functions that it wants to call later.
    """

    def serve(site, ready):
        site.later = []
        site.loop = SimpleNamespace(call_later=lambda delay, call: site.later.append(call))
        ready.set()

    def wait(seconds):
        for _ in range(round(seconds / LOOK_AT_TABS)):
            site.look()

    monkeypatch.setattr(server, "keyless_files", dict)
    monkeypatch.setattr(server.Server, "serve", serve)
    site = server.Server(None, Tabs(), {})
    site.wait = wait
    return site


GONE = (
    "The page has gone: you have left or closed it, its line is cut, or its machine sleeps. "
    "The program waits {:g} s for it. Ctrl+C ends it at once.\n"
)


class Connection(connections.Protocol):
    """A connection of a page, without a network."""

    def __init__(self, site, **parameters):
        super().__init__()
        self.site = site
        self.http_request_params = {name: [text] for name, text in parameters.items()}
        self.state = self.STATE_CLOSED  # so nothing is sent

    def dropConnection(self, abort):  # noqa: N802
        self.cut()

    def cut(self):
        self.onClose(False, 1006, "")

    def say(self, word):
        self.response_to(word, {"key": [self.site.key], "page": [self.page_name]})

    def close(self):
        self.onClose(True, 4001, "")


def test_the_program_ends_when_the_time_to_come_back_is_over(silent_site, monkeypatch, capsys):
    """A tab that loads has longer: a slow machine loads the page for seconds.

    Before the first tab, the program waits for ever. A request without the key wins no time.
    """
    site = silent_site
    stops = []
    monkeypatch.setattr(server, "interrupt_main", lambda: stops.append("now"))
    key = {"key": [site.key]}
    site.wait(99)
    Connection(site).cut()  # it was refused
    tab = Connection(site)
    other = Connection(site)
    tab.onOpen()
    other.onOpen()
    other.close()
    for _ in range(3):
        site.wait(9)
        tab.onPong(b"")
    tab.say("left")
    tab.cut()
    tab.say("closed")
    site.wait(0.8 * connections.CLOSED)
    tab.response_to("", key)
    site.wait(0.9 * connections.LOADING)
    tab.response_to("", key)
    site.wait(0.9 * connections.LOADING)
    tab.onOpen()
    tab.close()
    site.wait(connections.CLOSED)
    tab.response_to("", {})
    assert not site.tabs.are_gone
    site.wait(LOOK_AT_TABS)
    assert site.tabs.are_gone
    assert stops == []  # main can end by itself
    site.later[-1]()
    assert stops == ["now"]
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("is_silent", [False, True])
def test_a_page_that_is_lost_without_a_goodbye_has_a_minute(silent_site, capsys, is_silent):
    """Its bob swings on at once.

    When it goes on before the program has noticed, its old websocket costs no minute.
    """
    site = silent_site
    given = []
    site.tabs.give = lambda command, *values: given.append(command)
    tab = Connection(site, page="0.5", has="7")
    tab.onOpen()
    tab.cut()
    site.wait(2)
    tab.onOpen()  # so soon that nothing is said
    tab.onMessage(b'["grab"]', False)
    if is_silent:
        site.wait(connections.SILENT)
        assert given == ["grab"]
        site.wait(LOOK_AT_TABS)
    else:
        tab.cut()
    assert given == ["grab", "let_go"]
    site.wait(connections.LOST)
    assert capsys.readouterr().out == GONE.format(57)
    tab.onOpen()
    assert capsys.readouterr().out == "The page is back.\n"
    again = Connection(site, page="0.5", has="9" * 5000)
    again.onOpen()  # before anything says that tab is lost
    assert [*site.tabs.tabs] == [again]
    other = Connection(site)
    other.onOpen()
    again.cut()
    for _ in range(8):  # longer than a minute
        other.onPong(b"")
        site.wait(8)
    other.close()
    site.wait(connections.CLOSED)
    assert not site.tabs.are_gone
    site.wait(LOOK_AT_TABS)
    assert site.tabs.are_gone
    assert capsys.readouterr().out == ""


def test_a_page_that_is_left_can_come_back_by_back_or_by_a_reload(silent_site, capsys):
    """Under its own name, or as another one that names it; it then leaves nothing to wait for."""
    site = silent_site
    tab = Connection(site, page="1")
    again = Connection(site, page="2", was="1")
    for back in (tab, again):
        tab.onOpen()
        tab.cut()
        tab.say("left")
        site.wait(connections.LEFT)
        assert capsys.readouterr().out == GONE.format(connections.LEFT - server.FLICKER)
        assert not site.tabs.are_gone
        back.onOpen()
        assert capsys.readouterr().out == "The page is back.\n"
    again.close()
    site.wait(connections.CLOSED)
    assert not site.tabs.are_gone
    site.wait(LOOK_AT_TABS)
    assert site.tabs.are_gone


def test_another_page_takes_nothing_from_the_minute_of_a_lost_one(silent_site):
    lost = Connection(silent_site, page="1")
    other = Connection(silent_site, page="2")
    lost.onOpen()
    lost.cut()
    other.onOpen()
    other.close()
    silent_site.wait(connections.LOST)
    assert not silent_site.tabs.are_gone
    silent_site.wait(LOOK_AT_TABS)
    assert silent_site.tabs.are_gone
