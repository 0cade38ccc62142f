"""What each tab still has to get: merged, bounded, and nothing lost; and which tab drags a bob."""

import json
import random
from fractions import Fraction

import pytest

from support.page.tabs import Changes, MOST, Tabs

SPHERE, CANVAS = {"cmd": "sphere", "idx": 1}, {"cmd": "canvas", "idx": 0}
WOOD = {"idx": 1, "texture": {"file": "wood_texture.jpg"}}


@pytest.mark.parametrize(
    ("messages", "cmds", "attrs"),
    [
        # Objects are made in their order.
        ([{"cmds": [CANVAS]}, {"cmds": [SPHERE]}], [CANVAS, SPHERE], []),
        # A shape is made with its last texture: glow.min.js mixes up two that it loads.
        ([{"cmds": [SPHERE, CANVAS]}, {"cmds": [WOOD]}], [{**SPHERE, **WOOD}, CANVAS], []),
        # The last value of a setting of the canvas.
        ([{"cmds": [{"range": size, "idx": 0}]} for size in (1, 2)], [{"range": 2, "idx": 0}], []),
        # The last value of each attribute: object 12 is not object 1, and a1... is not b1...
        (
            [{"attrs": ["a12a0,0", "a1a0,0", "b12a5"]}, {"attrs": ["a12a4,5"]}],
            [],
            ["a1a0,0", "b12a5", "a12a4,5"],
        ),
        # It comes after the values that it may change: to set the size of a shape changes its axis.
        (
            [{"attrs": ["a1f1,0,0"]}, {"attrs": ["a1g2,1,1"]}, {"attrs": ["a1f3,0,0"]}],
            [],
            ["a1g2,1,1", "a1f3,0,0"],
        ),
        # A method is called once with each value.
        (
            [{"attrs": ["m0Gkey", "m0Gmouse"]}, {"attrs": ["a0t1", "m0Gkey"]}],
            [],
            ["m0Gmouse", "a0t1", "m0Gkey"],
        ),
    ],
)
def test_changes_merge_into_one_message_with_the_result_of_all(messages, cmds, attrs):
    changes = Changes()
    for number, message in enumerate(messages, start=1):
        changes.add({'a "name"': ["<b>"], "t": number}, **message)
    state = {'a "name"': ["<b>"], "t": number}
    assert json.loads(changes.message(0)) == {
        "number": number,
        "cmds": cmds,
        "attrs": attrs,
        "state": state,
    }


@pytest.mark.parametrize("words", ["NameError", ""])
def test_a_full_tab_hears_of_the_end_at_once_and_any_number_can_be_in_the_state(tabs, words):
    sent = open_tab(tabs, 1)
    for number in range(MOST):
        tabs.show({"mass": [Fraction(1, 2)], "t": number})
    tabs.show({"ended": words})
    assert (sent[0]["state"]["mass"], sent[-1]["state"]) == ([0.5], {"ended": words})


@pytest.fixture
def tabs(monkeypatch):
    """Tabs; changes has what VPython has changed, given is the list of the commands that reach the
    viewer.
    """
    tabs = Tabs()
    tabs.changes, tabs.given = {}, []
    monkeypatch.setattr("support.page.tabs.vpython_changes", lambda: tabs.changes)
    tabs.give = lambda command, *values: tabs.given.append(command)
    return tabs


def open_tab(tabs, name, *messages):
    """Open a tab that has got these messages; return the list of all that it gets."""
    messages = [*messages]
    has = messages[-1]["number"] if messages else 0
    tabs.open(name, lambda message: messages.append(json.loads(message)), has)
    return messages


@pytest.mark.parametrize(("size", "most"), [(1, 24), (2**16, 4), (2**19, 1)])
def test_a_slow_tab_gets_a_bounded_number_of_messages_and_then_the_last_values_of_all(
    tabs, size, most
):
    """On a long way, an answer for each one would mean few pictures.

    One always goes, however many bytes it has.
    """
    sent, last = open_tab(tabs, 1), 3 * MOST
    for number in range(last + 1):
        assert tabs.have_room() == (number < most)
        tabs.changes = {"attrs": [f"a{number % 2}a{number}"]}
        tabs.show({"t": f"{number:{size}}"})
    assert len(sent) == most
    tabs.receive(1, b"seen " * 2 * MOST)  # for more pictures than messages
    assert len(tabs.tabs[1].under_way) == 1
    tabs.receive(1, b"seen")
    assert (len(sent), tabs.have_room()) == (most + 1, True)
    assert (sent[-1]["attrs"], int(sent[-1]["state"]["t"])) == (
        [f"a1a{last - 1}", f"a0a{last}"],
        last,
    )


def test_a_tab_gets_what_has_changed_and_a_new_one_gets_everything(tabs):
    first = open_tab(tabs, 1)
    for state, tabs.changes in (
        ({"t": 1, "a": "b"}, {"cmds": [CANVAS]}),
        ({"t": 2, "a": "b"}, {}),
        ({"t": 2}, {}),
    ):
        tabs.show(state)
    assert [message["state"] for message in first] == [{"t": 1, "a": "b"}, {"t": 2}]
    for number in range(MOST):
        tabs.show({"a": number})
    assert not tabs.have_room()
    last = 2 + MOST
    everything = {"number": last, "cmds": [CANVAS], "attrs": [], "state": {"t": 2, "a": MOST - 1}}
    assert open_tab(tabs, 2) == open_tab(tabs, 3, {"number": last + 1})[1:] == [everything]
    cut = {"number": last, "cmds": [], "attrs": [], "state": {"a": MOST - 1}}
    assert open_tab(tabs, 4, {"number": last - 1})[1:] == [cut]
    assert tabs.have_room()  # one tab has room


def picture_of(messages):
    """Return what these messages, one after the other, make of a page.

    Shapes are here like VPython's: f sets the length and the direction of one, g its length and its
    width.
    """
    picture = {}
    for message in messages:
        for cmd in message["cmds"]:
            picture |= {(cmd["idx"], name): value for name, value in cmd.items()}
        for text in message["attrs"]:
            length, other = text[3:].split(",")
            picture |= {(text[1], "length"): length, (text[1], text[2]): other}
        picture |= message["state"]
    return picture


@pytest.mark.parametrize("seed", range(20))
def test_nothing_is_lost_whenever_tabs_come_and_go_and_however_slow_they_are(tabs, seed):
    """Also when a line is cut: the messages under way are lost, and the page goes on with what it
    has.
    """
    chance, shown, got = random.Random(seed), [], {}
    for number in range(400):
        cmds = {"idx": 0, "range": number}, {"idx": 0, "fov": number}
        attrs = [
            f"a{i}{chance.choice('fg')}{number},{chance.random()}"
            for i in range(4)
            if chance.random() < 0.4
        ]
        tabs.changes = {
            "cmds": [cmd for cmd in cmds if chance.random() < 0.2] if number else [SPHERE],
            "attrs": attrs,
        }
        tabs.show(state := {name: chance.randrange(3) for name in "abc" if chance.random() < 0.5})
        shown.append({**tabs.changes, "state": state})
        for name in [*got]:
            # Each third tab is so slow that it never answers
            if chance.random() < 0.3 * (name % 3):
                tabs.receive(name, b"seen")
        if len(got) < 3 or chance.random() < 0.03:
            got[number] = open_tab(tabs, number)
        elif chance.random() < 0.02:
            tabs.close(gone := chance.choice([*got]))
            messages = got.pop(gone)
            if chance.random() < 0.7:
                got[number] = open_tab(
                    tabs, number, *messages[: chance.randrange(len(messages) + 1)]
                )
    for name, messages in got.items():
        tabs.receive(name, b"seen")
        assert picture_of(messages) == picture_of(shown)


@pytest.mark.parametrize(
    ("events", "given"),
    [
        (
            "1 drag, 1 grab, 2 grab, 2 drag, 2 let go, 1 drag, 1 let go, 1 drag",
            "grab, drag, let go",
        ),
        ("1 grab, 1 let go, 2 grab, 1 drag, 2 drag", "grab, let go, grab, drag"),
        ("1 grab, 2 closes, 1 drag, 1 closes", "grab, drag, let go"),
        # The viewer refuses what it does not know
        ("1 grab, 2 pause, 2 no command", "grab, pause, no command"),
    ],
)
def test_only_the_tab_that_has_grabbed_a_bob_drags_it_and_it_lets_go_when_it_is_closed(
    tabs, events, given
):
    for name in "12":
        open_tab(tabs, name)
    for name, _, event in (event.partition(" ") for event in events.split(", ")):
        tabs.close(name) if event == "closes" else tabs.receive(
            name, json.dumps([event, 1, 2]).encode()
        )
    assert tabs.given == given.split(", ")
