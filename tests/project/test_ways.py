"""The ways in which students import, rename, wrap and rebuild: each has its impacts, its sound and
its experiments.
"""

import shutil
import sys
from importlib import import_module
from threading import Event
from types import SimpleNamespace

import pytest
from programs import ROOT, slow_but_for

from support.cradle.cradle import Cradle
from support.cradle.player import run
from support.cradle.real_time import RealTime
from support.files.cradle_csv import LiveFile
from support.page.viewer import Viewer

RUN = "visualize_cradle_run.py"
MAKE = "from src.special_cradles import make_newton_cradle\n"
CONSTANTS = "from support.constants import DT, G, R_PARAM, THETA_INIT\n"
MADE = "make_newton_cradle(page.csv, R_PARAM, THETA_INIT)"
TICKS = "newton_cradle_tick(pend_list, R_PARAM, DT, G, **page.rule)"
PAIRS = (
    "    for pend1, pend2 in pairwise(pend_list):\n        handle_two_bobs(pend1, pend2, r_param)\n"
)
TOUCH = "mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius)"
# As a student writes them.
OWN = f"""
def handle_two_bobs(pend1, pend2, r_param):
    _, bob1, _ = pend1["objects"]
    _, bob2, _ = pend2["objects"]
    if {TOUCH}:
        e, m1, m2 = pend1["e"], pend1["mass"], pend2["mass"]
        pend1["omega"], pend2["omega"] = handle_collision(e, pend1["omega"], pend2["omega"], m1, m2, r_param)


def newton_cradle_tick(pend_list, r_param, dt, g):
    full_swing_update(pend_list, r_param, dt, g)
{PAIRS}"""
ALONE = f"""    for i in range(len(pend_list) - 1):
        pend1, pend2 = pend_list[i], pend_list[i + 1]
        bob1, bob2 = pend1["objects"][1], pend2["objects"][1]
        if {TOUCH}:
            v1, v2, m1, m2, e = pend1["omega"], pend2["omega"], pend1["mass"], pend2["mass"], pend1["e"]
            pend1["omega"] = (m1 * v1 + m2 * v2 - m2 * e * (v1 - v2)) / (m1 + m2)
            pend2["omega"] = (m1 * v1 + m2 * v2 + m1 * e * (v1 - v2)) / (m1 + m2)
"""
DECORATOR = """
def counted(function):
    def wrapper(*given, **named):
        wrapper.calls += 1
        return function(*given, **named)
    wrapper.calls = 0
    return wrapper


"""
CLASS = """
class Counted:
    def __init__(self, function):
        self.function = function
    def __call__(self, *given):
        return self.function(*given)


"""
COPIES = """    for i in range(len(pend_list) - 1):
        left, right = dict(pend_list[i]), dict(pend_list[i + 1])
        handle_two_bobs(left, right, r_param)
        pend_list[i], pend_list[i + 1] = left, right
"""
INNER = """    def hit(i):
        handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)
    i = 0
    while i + 1 < len(pend_list):
        hit(i)
        i += 1
"""
COLLIDE = "        handle_two_bobs(pend1, pend2, r_param)\n"
SWING = "    full_swing_update(pend_list, r_param, dt, g)\n"
DEF = "def newton_cradle_tick(pend_list, r_param, dt, g):\n"

WAYS = {  # the changes: (old text, new text) in the file with main
    "as in the handout": [],
    "a module by a short name": [
        (MAKE, "import src.special_cradles as sc\n"),
        (MADE, f"sc.{MADE}"),
    ],
    "a module from its folder": [
        (MAKE, "from src import special_cradles\n"),
        (MADE, f"special_cradles.{MADE}"),
    ],
    "a module by its whole name": [
        (MAKE, "import src.special_cradles\n"),
        (MADE, f"src.special_cradles.{MADE}"),
    ],
    "a function by another name": [
        (MAKE, MAKE.strip() + " as make\n"),
        (MADE, MADE.replace("make_newton_cradle", "make")),
    ],
    "all names of a module": [(MAKE, "from src.special_cradles import *\n")],
    "an import in main": [
        (MAKE, ""),
        (f"    pend_list = {MADE}", f"    {MAKE}    pend_list = {MADE}"),
    ],
    "the swings as a module": [
        ("from src.swinging import full_swing_update", "import src.swinging as s"),
        ("    full_s", "    s.full_s"),
    ],
    "all constants": [(CONSTANTS, "from support.constants import *\n")],
    "the constants as a module": [
        (CONSTANTS, "import support.constants as c\n"),
        (MADE, "make_newton_cradle(page.csv, c.R_PARAM, c.THETA_INIT)"),
        (TICKS, "newton_cradle_tick(pend_list, c.R_PARAM, c.DT, c.G)"),
    ],
    "the collision by another name": [
        (DEF, f"collide = handle_two_bobs\n\n\n{DEF}"),
        (COLLIDE, COLLIDE.replace("handle_two_bobs", "collide")),
    ],
    "the tick by another name": [
        ("def main(page)", "tick = newton_cradle_tick\n\n\ndef main(page)"),
        (TICKS, "tick(pend_list, R_PARAM, DT, G)"),
    ],
    "the tick by another name in main": [
        ("    page.show", "    tick = newton_cradle_tick\n    page.show"),
        (TICKS, "tick(pend_list, R_PARAM, DT, G)"),
    ],
    "a tick in a decorator": [(DEF, f"{DECORATOR}@counted\n{DEF}")],
    "a collision in a decorator": [
        ("def handle_two_bobs", f"{DECORATOR}@counted\ndef handle_two_bobs")
    ],
    "a collision as a default": [
        (DEF, DEF.replace("g)", "g, hit=handle_two_bobs)")),
        (COLLIDE, COLLIDE.replace("handle_two_bobs", "hit")),
    ],
    "a collision in a class": [
        (DEF, f"class Physics:\n    hit = staticmethod(handle_two_bobs)\n\n\n{DEF}"),
        (COLLIDE, COLLIDE.replace("handle_two_bobs", "Physics.hit")),
    ],
    "a collision in a dictionary": [
        (DEF, f"TOOLS = {{'hit': handle_two_bobs}}\n\n\n{DEF}"),
        (COLLIDE, COLLIDE.replace("handle_two_bobs", "TOOLS['hit']")),
    ],
    "a partial collision": [
        (
            PAIRS,
            "    from functools import partial\n\n    hit = partial(handle_two_bobs, r_param=r_param)\n"
            "    for pair in pairwise(pend_list):\n        hit(*pair)\n",
        )
    ],
    "map": [
        (
            PAIRS,
            "    list(map(lambda pair: handle_two_bobs(*pair, r_param), pairwise(pend_list)))\n",
        )
    ],
    "a comprehension": [
        (PAIRS, "    [handle_two_bobs(a, b, r_param) for a, b in zip(pend_list, pend_list[1:])]\n")
    ],
    "keywords": [(COLLIDE, "        handle_two_bobs(pend2=pend2, r_param=r_param, pend1=pend1)\n")],
    "numbers of pendula": [
        (
            PAIRS,
            "    for i in range(4):\n        handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)\n",
        )
    ],
    "an inner function": [(PAIRS, INNER)],
    "a collision that returns both": [
        (
            "m2, r_param)\n\n\ndef newton_cradle_tick",
            "m2, r_param)\n    return pend1, pend2\n\n\ndef newton_cradle_tick",
        )
    ],
    "other names of parameters": [
        (DEF, DEF.replace("pend_list", "row")),
        (SWING, SWING.replace("pend_list", "row")),
        (PAIRS, PAIRS.replace("pend_list", "row")),
    ],
    "new dictionaries in each tick": [
        (SWING, "    pend_list[:] = [dict(pend) for pend in pend_list]\n" + SWING)
    ],
    "a new dictionary in each place": [
        (
            SWING,
            "    for i, pend in enumerate(pend_list):\n        pend_list[i] = {**pend}\n" + SWING,
        )
    ],
    "new dictionaries behind the tick": [
        (PAIRS, PAIRS + "    pend_list[:] = [dict(pend) for pend in pend_list]\n")
    ],
    "copies that collide": [(PAIRS, COPIES)],
    "a tick without the other function": [(PAIRS, ALONE)],
    "a main in a class": [("def main(page)", f"{CLASS}@Counted\ndef main(page)")],
    "a loop in a function": [
        (
            "    while page.is_running():",
            "    run(page, pend_list)\n\n\ndef run(page, pend_list):\n    while page.is_running():",
        )
    ],
    "is_running by another name": [
        ("    while page.is_running():", "    goes_on = page.is_running\n    while goes_on():")
    ],
    "an endless while with break": [
        (
            "    while page.is_running():",
            "    while True:\n        if not page.is_running():\n            break",
        )
    ],
}


def moved_to_helpers(text) -> tuple[str, str]:
    """Return the text of the file with main, and of a file of the student's own that has the
    collisions.
    """
    head, _, rest = text.partition("def handle_collision")
    collisions, _, tick = rest.partition("def newton_cradle_tick")
    own = f"from vpython import mag\n\n\ndef handle_collision{collisions}"
    return (
        f"{head}from src.helpers import handle_collision, handle_two_bobs\n\n\ndef newton_cradle_tick{tick}",
        own,
    )


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A copy of src/ that is imported in place of the project's."""
    shutil.copytree(ROOT / "src", tmp_path / "src")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr("support.cradle.cradle.SRC", tmp_path / "src")
    for name in [name for name in sys.modules if name.partition(".")[0] == "src"]:
        monkeypatch.delitem(sys.modules, name)
    return tmp_path / "src"


OFTEN = [
    "a module by a short name",
    "a file of one's own",
    "the constants as a module",
    "a collision as a default",
]
OFTEN += [
    "new dictionaries in each tick",
    "copies that collide",
    "a tick without the other function",
]


@pytest.mark.parametrize("way", slow_but_for(OFTEN, [*WAYS, "a file of one's own"]))
def test_whatever_is_right_has_its_impacts_its_sound_and_its_experiments(way, folder, csv):
    """A student's main runs as in the program, on a clock on which only rests take time."""
    text = (folder / RUN).read_text()
    before, _, behind = text.partition("def handle_two_bobs")
    text = before.rstrip() + "\n\n" + OWN + "\n\ndef main" + behind.partition("def main")[2]
    for old, new in WAYS.get(way, []):
        assert old in text
        text = text.replace(old, new, 1)
    if way not in WAYS:
        text, own = moved_to_helpers(text)
        (folder / "helpers.py").write_text(own)
    (folder / RUN).write_text(text)
    main = import_module("src.visualize_cradle_run").main
    special_cradles = import_module("src.special_cradles")
    cradle = Cradle(
        main, special_cradles, SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None)
    )
    now, state = [100.0], {}
    tabs = SimpleNamespace(
        have_room=lambda: True, show=state.update, is_seen=Event(), are_gone=False
    )
    tabs.is_seen.set()
    viewer = Viewer(cradle, LiveFile(csv, lambda: now[0]), [None], None, tabs)
    viewer.pace = RealTime(
        cradle.dt, lambda: now[0], lambda seconds: now.append(now.pop() + seconds)
    )

    def lesson():
        yield 0.6
        assert "1-2-3-4-5" in state["impacts"][-1]
        assert state["sound"][0] > 0
        tabs.give("ask first", True)
        tabs.give("experiment", "Two bobs")
        tabs.give("answer", "2_two_bobs", 2)
        yield 1
        assert state["question"]["happened"]["title"] == "That is what happened."
        tabs.give("slow hits", True)
        tabs.give("restart")
        tabs.give("answer", "2_two_bobs", 2)
        yield 0.5
        assert state["hit"]["title"].startswith("Hit ")

    do_frame, steps, until = viewer.frame, lesson(), [0.0]

    def frame():
        do_frame()
        if now[0] >= until[0]:
            pause = next(steps, None)
            tabs.are_gone = pause is None
            until[0] = now[0] + (pause or 0)

    viewer.frame = frame
    run(main, viewer)
    assert [*steps] == []
