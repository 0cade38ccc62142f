"""Students import, rename, wrap and rebuild: in each way, the hits are found.

The impacts, the sound and slow hits come from them.
"""

import shutil
import sys
from importlib import import_module
from types import SimpleNamespace

import pytest
from programs import ROOT, slow_except
from whole_cradles import settings_for

from support.cradle.cradle import Cradle
from support.cradle.functions import is_yours
from support.cradle.player import Player, run

VISUALIZE_FILE = "visualize_cradle_run.py"
MAKE = "from src.special_cradles import make_newton_cradle\n"
CONSTANTS = "from support.constants import DT, G, R_PARAM, THETA_INIT\n"
MADE = "make_newton_cradle(page.csv, R_PARAM, THETA_INIT)"
TICKS = "newton_cradle_tick(pend_list, R_PARAM, DT, G, **page.rule)"
PAIRS = (
    "    for pend1, pend2 in pairwise(pend_list):\n        handle_two_bobs(pend1, pend2, r_param)\n"
)
TOUCH = "mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius)"
AFTER = '        pend1["omega"], pend2["omega"] = omega1, omega2\n'
# As a student writes them.
OWN = f"""
def handle_two_bobs(pend1, pend2, r_param):
    _, bob1, _ = pend1["objects"]
    _, bob2, _ = pend2["objects"]
    if {TOUCH}:
        e, m1, m2 = pend1["e"], pend1["mass"], pend2["mass"]
        omega1, omega2 = pend1["omega"], pend2["omega"]
        omega1, omega2 = handle_collision(e, omega1, omega2, m1, m2, r_param)
{AFTER}

def newton_cradle_tick(pend_list, r_param, dt, g):
    full_swing_update(pend_list, r_param, dt, g)
{PAIRS}"""
ALONE = f"""    for i in range(len(pend_list) - 1):
        pend1, pend2 = pend_list[i], pend_list[i + 1]
        bob1, bob2 = pend1["objects"][1], pend2["objects"][1]
        if {TOUCH}:
            v1, v2 = pend1["omega"], pend2["omega"]
            m1, m2, e = pend1["mass"], pend2["mass"], pend1["e"]
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
    "the tick by another name in main": [
        ("    page.show", "    tick = newton_cradle_tick\n    page.show"),
        (TICKS, "tick(pend_list, R_PARAM, DT, G)"),
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
    "the constants as a module": [
        (CONSTANTS, "import support.constants as c\n"),
        (MADE, "make_newton_cradle(page.csv, c.R_PARAM, c.THETA_INIT)"),
        (TICKS, "newton_cradle_tick(pend_list, c.R_PARAM, c.DT, c.G)"),
    ],
    "the collision by another name": [
        (DEF, f"collide = handle_two_bobs\n\n\n{DEF}"),
        (COLLIDE, COLLIDE.replace("handle_two_bobs", "collide")),
    ],
    "a tick in a decorator": [(DEF, f"{DECORATOR}@counted\n{DEF}")],
    "a collision in a decorator": [
        ("def handle_two_bobs", f"{DECORATOR}@counted\ndef handle_two_bobs")
    ],
    "a collision as a default": [
        (DEF, DEF.replace("g)", "g, hit=handle_two_bobs)")),
        (COLLIDE, COLLIDE.replace("handle_two_bobs", "hit")),
    ],
    "keywords": [(COLLIDE, "        handle_two_bobs(pend2=pend2, r_param=r_param, pend1=pend1)\n")],
    "an inner function": [(PAIRS, INNER)],
    "a collision that returns both": [(AFTER, f"{AFTER}    return pend1, pend2\n")],
    "other names of parameters": [
        (DEF, DEF.replace("pend_list", "row")),
        (SWING, SWING.replace("pend_list", "row")),
        (PAIRS, PAIRS.replace("pend_list", "row")),
    ],
    "new dictionaries in each tick": [
        (SWING, "    pend_list[:] = [dict(pend) for pend in pend_list]\n" + SWING)
    ],
    "new dictionaries behind the tick": [
        (PAIRS, PAIRS + "    pend_list[:] = [dict(pend) for pend in pend_list]\n")
    ],
    "copies that collide": [(PAIRS, COPIES)],
    "a tick without the other function": [(PAIRS, ALONE)],
    "a main in a class": [("def main(page", f"{CLASS}@Counted\ndef main(page")],
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


# Functions in a file of the student's own: the first one that stays, and how the file is imported
OWN_FILES = {
    "a file of one's own": (
        "def newton_cradle_tick",
        "from src.helpers import handle_collision, handle_two_bobs\n",
    ),
    "a file of one's own, as a module": ("def main", "import src.helpers as helpers\n"),
}


def moved_to_helpers(text, first, imported) -> tuple[str, str]:
    """Return the text of the file with main, and of a file of the student's with the collisions."""
    head, _, rest = text.partition("def handle_collision")
    moved, _, rest = rest.partition(first)
    if "as helpers" in imported:
        rest = rest.replace("newton_cradle_tick", "helpers.newton_cradle_tick")
    return f"{head}{imported}\n\n{first}{rest}", f"{head}\n\ndef handle_collision{moved}"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A copy of src/ that is imported in place of the project's."""
    shutil.copytree(ROOT / "src", tmp_path / "src")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr("support.cradle.functions.SRC", tmp_path / "src")
    for name in [name for name in sys.modules if name.partition(".")[0] == "src"]:
        monkeypatch.delitem(sys.modules, name)
    return tmp_path / "src"


OFTEN = [
    "a module by a short name",
    *OWN_FILES,
    "the constants as a module",
    "a collision as a default",
    "new dictionaries in each tick",
    "copies that collide",
    "a tick without the other function",
]


class Listener(Player):
    """Plays two cradles after each other, and keeps the hits of each."""

    def __init__(self, cradle, csv):
        super().__init__(cradle, settings_for(cradle, csv), impacts=9, step_seconds=0.01)
        self.cradles = []  # the hits of each

    def looks_at_hits(self):
        return True

    def show_new_cradle(self):
        self.cradles.append([])
        self.plan(round(0.6 / self.cradle.dt))

    def frame(self):
        if len(self.cradles) < 2:
            self.next_cradle.want()
        else:
            self.is_over = True

    def note_hits(self, hits):
        self.cradles[-1] += hits


@pytest.mark.parametrize("way", slow_except(OFTEN, [*WAYS, *OWN_FILES]))
def test_whatever_is_right_has_its_hits(way, folder, csv):
    text = (folder / VISUALIZE_FILE).read_text()
    before, _, behind = text.partition("def handle_two_bobs")
    text = before.rstrip() + "\n\n" + OWN + "\n\ndef main" + behind.partition("def main")[2]
    for old, new in WAYS.get(way, []):
        assert old in text
        text = text.replace(old, new, 1)
    if way in OWN_FILES:
        text, helpers = moved_to_helpers(text, *OWN_FILES[way])
        (folder / "helpers.py").write_text(helpers)
    (folder / VISUALIZE_FILE).write_text(text)
    main = import_module("src.visualize_cradle_run").main
    special_cradles = import_module("src.special_cradles")
    options = SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None)
    listener = Listener(Cradle(main, special_cradles, options), csv)
    run(main, listener)
    first, second = listener.cradles
    assert [(hit.left, hit.right) for hit in first[:4]] == [(0, 1), (1, 2), (2, 3), (3, 4)]
    for hit in first[:4]:
        assert hit.before[0]["omega"] > 1
        assert hit.after[0]["omega"] == pytest.approx(0, abs=0.01)
    assert first[0].tick == second[0].tick


@pytest.mark.parametrize(
    ("file", "expected"),
    [("src/a.py", True), ("src/a/b.py", True), ("a.py", True), ("support/a.py", False)],
)
def test_files_in_src_and_beside_it_are_yours(file, expected):
    assert is_yours(ROOT / file) == expected
