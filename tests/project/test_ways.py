"""In whichever way a student writes the tick, and wherever, its hits are found."""

import shutil
import sys
from importlib import import_module
from types import SimpleNamespace

import pytest
from programs import ROOT
from whole_cradles import PERIOD, settings_for

from support.cradle.cradle import Cradle
from support.cradle.functions import is_yours
from support.cradle.player import Player, run

VISUALIZE_FILE = "visualize_cradle_run.py"
MAKE = "from src.special_cradles import make_newton_cradle\n"
MADE = "make_newton_cradle(page.csv, R_PARAM, THETA_INIT)"
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
        omega1, omega2 = pend1["omega"], pend2["omega"]
        omega1, omega2 = handle_collision(e, omega1, omega2, m1, m2, r_param)
        pend1["omega"], pend2["omega"] = omega1, omega2


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

WAYS = {  # the changes: (old text, new text) in the file with main
    "a module by a short name": [
        (MAKE, "import src.special_cradles as sc\n"),
        (MADE, f"sc.{MADE}"),
    ],
    "copies that collide": [(PAIRS, COPIES)],
    "a tick without the other function": [(PAIRS, ALONE)],
    "a main in a class": [("def main(page", f"{CLASS}@Counted\ndef main(page")],
    "a file of one's own": [],
}


def moved_to_helpers(text) -> tuple[str, str]:
    """Return the text of the file with main, and of a file of the student's with all else."""
    head, _, rest = text.partition("def handle_collision")
    moved, _, main = rest.partition("def main")
    main = main.replace("newton_cradle_tick", "helpers.newton_cradle_tick")
    return (
        f"import src.helpers as helpers\n{head}def main{main}",
        f"{head}def handle_collision{moved}",
    )


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A copy of src/ that is imported in place of the project's."""
    shutil.copytree(ROOT / "src", tmp_path / "src")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr("support.cradle.functions.SRC", tmp_path / "src")
    for name in [name for name in sys.modules if name.partition(".")[0] == "src"]:
        monkeypatch.delitem(sys.modules, name)
    return tmp_path / "src"


class Listener(Player):
    """Plays two cradles after each other, and keeps the hits of each."""

    def __init__(self, cradle, csv):
        super().__init__(cradle, settings_for(cradle, csv), step_seconds=0.01)
        self.cradles = []  # the hits of each

    def looks_at_hits(self):
        return True

    def show_new_cradle(self):
        self.cradles.append([])
        self.plan(round(0.3 * PERIOD / self.cradle.dt))

    def frame(self):
        if len(self.cradles) < 2:
            self.next_cradle.want()
        else:
            self.is_over = True

    def note_hits(self, hits):
        self.cradles[-1] += hits


@pytest.mark.parametrize("way", WAYS)
def test_whatever_is_right_has_its_hits(way, folder, csv):
    text = (folder / VISUALIZE_FILE).read_text()
    before, _, behind = text.partition("def handle_two_bobs")
    text = before.rstrip() + "\n\n" + OWN + "\n\ndef main" + behind.partition("def main")[2]
    for old, new in WAYS[way]:
        assert old in text
        text = text.replace(old, new, 1)
    if way == "a file of one's own":
        text, helpers = moved_to_helpers(text)
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
