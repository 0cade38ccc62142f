"""The fast path gives the same bits as single ticks, and is only for the shipped functions."""

import json
import linecache
import sys
from types import SimpleNamespace

import pytest
from programs import OF_TESTS, python, with_vpython
from strategies import CALLS, HAIRS, pendulum_rows, random_examples
from whole_cradles import do_at_once, do_one_by_one

from grading.cradles import hang, hang_row, R
from src import visualize_cradle_run
from support.cradle import many_ticks as module
from support.cradle.player import SLOW
from support.pendulum import BUFFER

# --- the same bits ------------------------------------------------------------------------------


def state(pend_list):
    """Return all values that a tick changes as text with every bit, and with the sign of 0.0."""
    values = []
    for pend in pend_list:
        values += [value for key, value in pend.items() if key != "objects"]
        for shape in pend["objects"]:
            values += [*shape.pos.value, *shape.axis.value]
    return repr(values)


def same_hits(pendula, **call) -> int:
    """Check that many_ticks moves pendula like single ticks, to the last bit; return the hits.

    pendula has the arguments of hang for each, call those of do_at_once.
    """
    found = []
    for do in do_at_once, do_one_by_one:
        pend_list = [hang(**values) for values in pendula]
        hits = [(hit[:4], state(hit.before), state(hit.after)) for hit in do(pend_list, **call)]
        found.append((hits, state(pend_list)))
    assert found[0] == found[1]
    return len(found[0][0])


def row(count=5, theta=-1.0, e=1, masses=(1,), step=(R / 4, 0, 0)) -> list[dict]:
    """Return the arguments of hang for pendula with axles this step (m) apart; one is lifted."""
    pendula = []
    for i in range(count):
        axle = tuple(i * part for part in step)
        pendula.append({"e": e, "mass": masses[i % len(masses)], "axle": axle})
    pendula[0]["theta"] = theta
    return pendula


@pytest.mark.parametrize(
    ("pendula", "call"),
    [
        (row(), {}),
        (row(e=0.9), {}),
        (row(e=0), {}),
        (row(e=0.5), {"separating": True}),
        (row(masses=[1, 7, 0.1]), {}),
        (row(20, e=0.9), {}),
        (row(theta=-3), {}),
        (row(step=(R / 4, R / 90, R / 40)), {}),
    ],
)
def test_cradles_end_in_the_same_bits_as_after_single_ticks(pendula, call):
    assert same_hits(pendula, **{"dt": 0.0005, "ticks": 3000, **call}) > 0


@random_examples(10, 80, pendula=pendulum_rows(), call=CALLS)
def test_random_cradles_end_in_the_same_bits_as_after_single_ticks(pendula, call):
    same_hits(pendula, **call)


@random_examples(10, 100, hair=HAIRS)
def test_bobs_that_swing_side_by_side_a_hair_from_touching_end_in_the_same_bits(hair):
    """Far from the origin, rounding decides whether they touch."""
    theta, x, *factors = hair
    left, right = [
        {"theta": theta, "axle": (x + i * R / 4, 0, 0), "radius": R / 8 / BUFFER * factor}
        for i, factor in enumerate(factors)
    ]
    same_hits([{**left, "omega": 1e-10}, right], ticks=20, separating=True)


ON_VPYTHON = """
import sys, vpython
vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser
sys.modules["support.headless_vpython"] = vpython  # or this would take VPython's place
import test_many_ticks as tests

tests.test_random_cradles_end_in_the_same_bits_as_after_single_ticks(10)
tests.test_bobs_that_swing_side_by_side_a_hair_from_touching_end_in_the_same_bits(10)
"""


@with_vpython
def test_cradles_of_vpython_itself_end_in_the_same_bits():
    done = python("-c", ON_VPYTHON, **OF_TESTS)
    assert done.returncode == 0, done.stderr


# --- only for the shipped functions -------------------------------------------------------------


def test_the_fast_path_knows_the_shipped_files():
    """After a change, the programs do single ticks: the same, but slower."""
    found = module.digest_of(*module.texts_of(vars(visualize_cradle_run)))
    assert found == module.DIGEST, (
        "A file of a tick has changed. If you want this change, make it in many_ticks.py, too. If "
        f"the tests of the same bits pass, this is its DIGEST: {found}"
    )


def test_it_is_the_code_that_runs_which_counts(monkeypatch):
    """Somebody may have saved the file since."""
    names = vars(visualize_cradle_run)
    assert module.is_shipped(names)
    file = names["__file__"]
    monkeypatch.setitem(linecache.cache, file, (0, None, ["changed\n"], file))
    assert not module.is_shipped(names)


# Saves each change, and prints whether the fast path takes it, and whether the motion is that of
# single ticks, and that of the files as they are.
SAVES = """
import json, sys
import support.headless_vpython
from support.cradle import many_ticks, player
from support.cradle.cradle import Cradle
from support.cradle.settings import Settings
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import read_cradle
from support.root import ROOT

class Player(player.Player):
    def frame(self):
        self.is_over = self.motion.ticks > 0
        self.plan(3000)

def motion(fast_path):
    player.FAST_PATH = fast_path
    csv = read_cradle(Snapshot(ROOT / "newton_cradle_pends.csv"))
    played = Player(Cradle(), Settings(csv, [None], None), 0.1)
    player.run(many_ticks.PROGRAM, played)
    return played.is_fast, repr(played.cradle.coordinates())

_, shipped = motion(many_ticks)
for name, old, new in json.loads(sys.argv[1]):
    file = ROOT / name
    text = file.read_bytes().decode()
    assert old in text
    file.write_bytes(text.replace(old, new).encode())
    is_shipped, found = motion(many_ticks)
    print(is_shipped, found == motion(None)[1], found == shipped)
    file.write_bytes(text.encode())
"""
SWINGING = "src/swinging.py"
PROGRAM = "src/visualize_cradle_run.py"
SAME = [
    (SWINGING, "\n", "\r\n"),
    (PROGRAM, "\n    full_swing", "  # first\n\n\n    full_swing"),
]
CHANGED = [
    (SWINGING, "theta + omega_new * dt", "theta + omega * dt"),
    (PROGRAM, "momentum - m2", "momentum + m2"),
    (PROGRAM, "from src.swinging import full_swing_update", "full_swing_update = lambda *_: None"),
]


def test_a_saved_change_shows_and_comments_and_line_ends_change_nothing(program):
    rows = json.dumps(SAME + CHANGED)
    done = python("-c", SAVES, rows, folder=program.parents[1])
    assert done.stderr == ""
    expected = ["True True True"] * len(SAME) + ["False True False"] * len(CHANGED)
    assert done.stdout.splitlines() == expected


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("gettrace", lambda: "a debugger"),
        ("getprofile", lambda: "a profiler"),
        ("monitoring", SimpleNamespace(get_tool=lambda number: number == 5)),  # of Python 3.12
    ],
)
def test_each_kind_of_watching_is_noticed(name, value, monkeypatch):
    assert not module.is_watched()
    monkeypatch.setattr(sys, name, value, raising=False)
    assert module.is_watched()


def share_a_bob(pend_list):
    axle, *_ = pend_list[1]["objects"]
    pend_list[1]["objects"] = (axle, *pend_list[0]["objects"][1:])


def test_a_bob_of_two_pendula_hinders_the_fast_path():
    pend_list = hang_row(3)
    assert module.obstacle(pend_list) == ""
    share_a_bob(pend_list)
    assert module.obstacle(pend_list) == "Two pendula have the same bob."


def test_a_run_that_is_slow_because_of_a_debugger_says_so(swing, monkeypatch):
    assert swing().remarks == []
    monkeypatch.setattr(sys, "gettrace", lambda: "a debugger")
    assert swing().remarks == [f"A debugger, a tracer or a profiler watches each call. {SLOW}"]
