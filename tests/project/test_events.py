"""The events that the page sends: they reach VPython as they are, and nothing else does."""

import json
from math import inf, nan
from types import SimpleNamespace

import pytest

from support.page.events import known_events, TRIGGER

BUTTON, SLIDER, MENU, BOX, INPUT, CANVAS, SPHERE = range(7)
OBJECTS = {
    BUTTON: SimpleNamespace(objName="button"),
    SLIDER: SimpleNamespace(objName="slider", min=0.1, max=2),
    MENU: SimpleNamespace(objName="menu", choices=["a", "b"]),
    BOX: SimpleNamespace(objName="checkbox"),
    INPUT: SimpleNamespace(objName="winput"),
    CANVAS: SimpleNamespace(handle_event=None),
    SPHERE: SimpleNamespace(_objName="sphere"),
}
HELD = {"alt": False, "ctrl": False, "shift": False, "which": 1}
MOUSE = {"pos": [0, 1e-17, -2.5], "ray": [0, 0, -1], "press": True, "release": False, **HELD}


def widget(kind, idx, value, **others):
    return {"widget": kind, "idx": idx, "value": value, **others}


def event(kind, canvas=CANVAS, **others):
    return {"event": kind, "canvas": canvas, **others}


GOOD = [
    widget("button", BUTTON, 0),
    *(widget("slider", SLIDER, value) for value in (0.1, 1, 2)),
    *(widget("menu", MENU, value) for value in (0, 1)),
    widget("checkbox", BOX, True),
    widget("winput", INPUT, None, text="[]"),
    event("keydown", key="r", **HELD, bind=True),
    *(event(kind, **MOUSE) for kind in ("mousedown", "mousemove", "mouseup")),
    event("resize", width=320, height=200),
    event("update_canvas"),
    event("update_canvas", pos=[0, 0, 0], ray=[0, 0, 1], forward=[0, 0, -1], up=[0, 1, 0], center=[0, 0, 0]),
    event("update_canvas", range=0.3, autoscale=False, keysdown=["r"]),
]


@pytest.mark.parametrize("event", GOOD)
def test_what_the_page_sends_stays_as_it_is(event):
    assert json.loads(known_events(json.dumps([event, event]).encode(), OBJECTS)) == [event, event]


WRONG = [
    *(widget("button", number, 0) for number in (SLIDER, SPHERE, CANVAS, 7, -1, None, "0", 0.0)),
    *(widget("slider", SLIDER, value) for value in (0.09, 2.1, inf, nan, None, "1", [1])),
    *(widget("menu", MENU, value) for value in (-1, 2, 0.5, None, "a")),
    *(widget("checkbox", BOX, value) for value in (None, 1, "true")),
    *(widget("winput", INPUT, None, text=text) for text in (None, 1)),
    widget("radio", BUTTON, 0),
    {"widget": "button"},
    {"idx": BUTTON},
    event("keydown", key=["r"], **HELD),
    *({name: value for name, value in event("keydown", key="r", **HELD).items() if name != left} for left in HELD),
    *({name: value for name, value in event("mousemove", **MOUSE).items() if name != left} for left in MOUSE),
    *(event("mousedown", **{**MOUSE, "ray": ray}) for ray in ([0, 0, 0], [0, 1], None, [0, 0, nan], [0, 0, "1"])),
    *(event("mousedown", **{**MOUSE, "pos": pos}) for pos in ([0, 0], 0, [1e300, 0, 0], [True, 0, 0])),
    *(event("resize", width=width, height=200) for width in (0, -1, "320", inf, None)),
    *(event("update_canvas", **{name: [0, 0, 0]}) for name in ("ray", "forward", "up")),
    event("update_canvas", center=[inf, 0, 0]),
    *(event("update_canvas", range=size) for size in (0, -1, "1", nan)),
    event("update_canvas", autoscale=1),
    *(event("update_canvas", number) for number in (SPHERE, 7, None)),
    *(event(kind) for kind in ("keydown", "click", "pick", None)),
]


@pytest.mark.parametrize("event", WRONG, ids=str)
def test_what_the_page_does_not_send_is_left_out(event):
    assert json.loads(known_events(json.dumps([event, GOOD[0]]).encode(), OBJECTS)) == [GOOD[0]]


@pytest.mark.parametrize("data", [TRIGGER, b"", b"{", b"\xff", b"{}", b"7", b"[" * 100_000, b"9" * 10_000])
def test_what_is_no_list_of_events_only_asks_for_the_changes(data):
    assert known_events(data, OBJECTS) == TRIGGER
