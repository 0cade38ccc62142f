"""What each tab still has to get, and what the program takes from it, without a network."""

import json
from fractions import Fraction
from unittest.mock import patch

import pytest
from hypothesis import settings, strategies
from hypothesis.stateful import rule, RuleBasedStateMachine, run_state_machine_as_test

from support.page.server.changes import Changes
from support.page.server.tabs import MOST_MESSAGES, Tabs

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
    message = json.loads(changes.message(0))
    assert message["cmds"] == [{**SPHERE, **WOOD}, CANVAS]
    assert message["attrs"] == ["a1a0,0", "b12a5", "a12a4,5", "m0Gkey"]


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

    One always goes, however many bytes it has, and so does the end of the program.
    """
    sent = open_tab(tabs, 1)
    for number in range(100):
        assert tabs.have_room() == (number < most)
        tabs.drawing = {"attrs": [f"a{number % 2}a{number}"]}
        tabs.show({"t": f"{number:{size}}"})
    assert len(sent) == most
    tabs.show({"ended": ""})
    assert len(sent) == most + 1
    assert sent[-1]["attrs"] == ["a0a98", "a1a99"]
    assert int(sent[-1]["state"]["t"]) == 99
    tabs.receive(1, b"seen " * 2 * MOST_MESSAGES)  # for more pictures than messages
    assert tabs.have_room()


def test_a_tab_gets_only_what_has_changed(tabs):
    sent = open_tab(tabs, 1)
    tabs.show({"t": Fraction(1, 2), "a": "b"})  # a student's number can be of any kind
    tabs.show({"t": 2, "a": "b"})
    tabs.show({"t": 2})
    assert [message["state"] for message in sent] == [{"t": 0.5, "a": "b"}, {"t": 2}]


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
            picture[text[1], "length"] = length
            picture[text[1], text[2]] = other
        picture |= message["state"]
    return picture


CMDS = [SPHERE, {"idx": 0, "range": 1}, {"idx": 0, "range": 2}, {"idx": 0, "fov": 1}]
ATTRS = ["a1f1,2", "a1f3,4", "a1g1,3", "a1g2,2", "a2f1,2", "a2g3,3"]


class ComingAndGoing(RuleBasedStateMachine):
    """Whenever tabs come, answer, and lose their line, all show the same in the end.

    A change comes after those that it may change: to set the size of a shape changes its axis.
    """

    def __init__(self):
        super().__init__()
        self.tabs = Tabs(now)
        self.drawings = []
        self.sent = {}  # the messages of each tab, by its name
        self.come()

    @rule()
    def come(self, *messages):
        name = max(self.sent, default=0) + 1
        self.sent[name] = open_tab(self.tabs, name, *messages)

    @rule(
        cmds=strategies.lists(strategies.sampled_from(CMDS), max_size=1),
        attrs=strategies.lists(strategies.sampled_from(ATTRS), max_size=2),
        state=strategies.dictionaries(strategies.sampled_from("abc"), strategies.integers(0, 2)),
    )
    def show(self, cmds, attrs, state):
        drawing = {"cmds": cmds, "attrs": attrs}
        with patch("support.page.server.tabs.take_changes", lambda: drawing):
            self.tabs.show(state)
        self.drawings.append({**drawing, "state": state})

    @rule(data=strategies.data())
    def answer(self, data):
        self.tabs.receive(data.draw(strategies.sampled_from([*self.sent])), b"seen")

    @rule(data=strategies.data())
    def lose_a_line(self, data):
        """Lose the last messages; the page comes back with the others, or without any."""
        name = data.draw(strategies.sampled_from([*self.sent]))
        self.tabs.close(name)
        messages = self.sent.pop(name)
        self.come(*messages[: data.draw(strategies.integers(0, len(messages)))])

    def teardown(self):
        for name, messages in self.sent.items():
            self.tabs.receive(name, b"seen")
            assert picture_of(messages) == picture_of(self.drawings)


def test_nothing_is_lost_whenever_tabs_come_and_go_and_however_slow_they_are(monkeypatch):
    monkeypatch.setattr("support.page.server.tabs.MOST_MESSAGES", 2)
    run_state_machine_as_test(
        ComingAndGoing,
        settings=settings(
            max_examples=100,
            stateful_step_count=15,
            deadline=None,
            derandomize=True,
            database=None,
        ),
    )


@pytest.mark.parametrize(
    ("events", "commands"),
    [
        (
            "1 drag, 1 grab, 2 grab, 2 drag, 2 let_go, 1 drag, 1 let_go, 1 drag",
            "grab, drag, let_go",
        ),
        # The viewer refuses what it does not know
        ("1 grab, 2 no command, 2 closes, 1 drag, 1 closes", "grab, no command, drag, let_go"),
    ],
)
def test_only_the_tab_that_has_grabbed_a_bob_drags_it_and_it_lets_go_when_it_is_closed(
    tabs, events, commands
):
    open_tab(tabs, "1")
    open_tab(tabs, "2")
    for event in events.split(", "):
        name, event = event.split(" ", 1)
        if event == "closes":
            tabs.close(name)
        else:
            tabs.receive(name, json.dumps([event, 1, 2]).encode())
    assert given(tabs) == commands.split(", ")


@pytest.mark.parametrize("message", [b"", b"[", b"5", b"\xff"])
def test_a_message_without_a_command_is_forgotten(tabs, message):
    open_tab(tabs, 1)
    tabs.receive(1, message)
    assert given(tabs) == []
