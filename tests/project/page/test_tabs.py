"""What each tab still has to get, and what the program takes from it, without a network."""

import json
from fractions import Fraction
from math import inf
from random import Random

import pytest

from support.page.server.changes import Changes
from support.page.server.tabs import MOST_UNSEEN, Tab, Tabs

SPHERE = {"cmd": "sphere", "idx": 1}
CANVAS = {"cmd": "canvas", "idx": 0}
WOOD = {"idx": 1, "texture": {"file": "wood_texture.jpg"}}


def test_changes_merge_into_one_message_with_the_result_of_all():
    """The last value of each attribute, and each call of a method once. Object 12 is not object 1.

    A shape is made with its last texture: glow.min.js mixes up two that it loads.
    """
    changes = Changes()
    changes.add({}, [SPHERE, CANVAS], ["a12a0,0", "a1a0,0", "m0Gkey", "b12a5"])
    changes.add({}, [WOOD], ["a12a4,5", "m0Gkey"])
    drawing = [*changes.later(0)["drawing"].values()]
    assert drawing == [{**SPHERE, **WOOD}, CANVAS, "a1a0,0", "b12a5", "a12a4,5", "m0Gkey"]


def now(function, *arguments):
    """Call a function as in the server's thread, but at once."""
    function(*arguments)


@pytest.fixture
def tabs(monkeypatch):
    """Tabs; drawing has what VPython has changed."""
    tabs = Tabs(in_server=now)
    tabs.drawing = {}
    monkeypatch.setattr("support.page.server.tabs.take_changes", lambda: tabs.drawing)
    return tabs


def given(tabs):
    """Return the names of the commands that tabs have given since the last call."""
    names = []
    while not tabs.commands.empty():
        name, *_ = tabs.commands.get()
        names.append(name)
    return names


def open_tab(tabs):
    """Open a tab; return it, and the list of all that it gets."""
    messages = []
    tab = Tab(lambda message: messages.append(json.loads(message)))
    tabs.open(tab)
    return tab, messages


def test_a_slow_tab_gets_a_bounded_number_of_messages_and_then_the_last_values_of_all(tabs):
    """On a long way, an answer for each one would mean few pictures. The end always goes."""
    tab, sent = open_tab(tabs)
    for number in range(100):
        tabs.drawing = {"attrs": [f"a{number % 2}a{number}"]}
        tabs.show({"t": number})
    assert len(sent) == MOST_UNSEEN
    tabs.show({"ended": True})
    assert len(sent) == MOST_UNSEEN + 1
    assert sent[-1] == {
        "drawing": {"a0a": "a0a98", "a1a": "a1a99"},
        "state": {"t": 99, "ended": True},
    }
    for _ in range(3 * MOST_UNSEEN):  # for more pictures than messages
        tabs.receive(tab, '["seen", 1]')
    assert tab.allowance == MOST_UNSEEN


def test_a_text_of_the_state_has_no_folder_of_this_machine(tabs):
    _, sent = open_tab(tabs)
    for text, told in (
        ("'/home/ann/My files/a.csv'", "'a.csv'"),
        ("'C:\\\\Users\\\\ann\\\\a.csv'", "'a.csv'"),
        ("in /home/ann/a.py", "in a.py"),
        ("src/swinging.py: 1 kg m/s", "src/swinging.py: 1 kg m/s"),
    ):
        tabs.tell({"saved": text, "mistakes": [text], "saved_csv": {"mistake": text}})
        state = sent[-1]["state"]
        assert state == {"saved": told, "mistakes": [told], "saved_csv": {"mistake": told}}


def test_a_tab_gets_only_what_has_changed(tabs):
    _, sent = open_tab(tabs)
    tabs.show({"t": 1, "a": "b"})
    tabs.show({"t": 2, "a": "b"})
    tabs.show({"t": 2})
    assert [message["state"] for message in sent] == [{"t": 1, "a": "b"}, {"t": 2}]


@pytest.mark.parametrize(
    ("number", "told"), [(Fraction(1, 2), 0.5), (1j, "1j"), (-inf, None), ("x,NaN", "x,NaN")]
)
def test_a_number_of_any_kind_reaches_a_tab(tabs, number, told):
    """A student's function can make it."""
    _, sent = open_tab(tabs)
    tabs.show({"t": [number]})
    assert sent[0]["state"]["t"] == [told]


def picture_of(messages):
    """Return what these messages, one after the other, make of a page.

    Shapes are here like VPython's: f sets the length and the direction of one, g its length and its
    width.
    """
    picture = {}
    for message in messages:
        for change in message["drawing"].values():
            if isinstance(change, dict):
                picture |= {(change["idx"], name): value for name, value in change.items()}
                continue
            length, other = change[3:].split(",")
            picture[change[1], "length"] = length
            picture[change[1], change[2]] = other
        picture |= message["state"]
    return picture


CMDS = [SPHERE, {"idx": 0, "range": 1}, {"idx": 0, "range": 2}, {"idx": 0, "fov": 1}]
ATTRS = ["a1f1,2", "a1f3,4", "a1g1,3", "a1g2,2", "a2f1,2", "a2g3,3"]


@pytest.mark.parametrize("seed", range(30))
def test_whenever_a_tab_comes_and_however_slow_it_is_it_shows_the_same_in_the_end(tabs, seed):
    """A change comes after those that it may change: to set a shape's size changes its axis."""
    chance = Random(seed)
    first, all_messages = open_tab(tabs)
    opened = []
    for _ in range(20):
        tab, messages = open_tab(tabs)
        tab.allowance = chance.randrange(3)
        opened.append((tab, messages))
        tabs.drawing = {
            "cmds": chance.sample(CMDS, chance.randrange(2)),
            "attrs": chance.sample(ATTRS, chance.randrange(3)),
        }
        tabs.show({chance.choice("abc"): chance.randrange(3)})
        for answering in (first, chance.choice(opened)[0]):
            tabs.receive(answering, '["seen", 1]')
    for tab, messages in opened:
        tabs.receive(tab, '["seen", 1]')
        assert picture_of(messages) == picture_of(all_messages)


def test_a_tab_that_is_closed_lets_its_own_bob_go(tabs):
    other, _ = open_tab(tabs)
    tab, _ = open_tab(tabs)
    tabs.receive(tab, '["grab"]')
    tabs.close(other)
    assert given(tabs) == ["grab"]
    tabs.close(tab)
    assert given(tabs) == ["let_go"]


@pytest.mark.parametrize("message", ["", "[", "5", '["seen"]', '["seen", "a"]', b"\xff"])
def test_a_message_without_a_command_is_forgotten(tabs, message):
    tab, _ = open_tab(tabs)
    tabs.receive(tab, message)
    assert given(tabs) == []
