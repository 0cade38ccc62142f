"""The fast path gives the same bits as single ticks, and is only for the shipped functions."""

import linecache
import sys
from types import SimpleNamespace

import pytest
from strategies import CALLS, HAIRS, pendulum_rows, random_examples
from whole_cradles import do_ticks

from grading.cradles import hang, R
from src import visualize_cradle_run
from support.cradle import many_ticks as module
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

    pendula has the arguments of hang for each, call those of do_ticks.
    """
    found = []
    for at_once in (True, False):
        pend_list = [hang(**values) for values in pendula]
        hits = [
            (hit[:4], state(hit.before), state(hit.after))
            for hit in do_ticks(pend_list, at_once, **call)
        ]
        found.append((hits, state(pend_list)))
    assert found[0] == found[1]
    return len(found[0][0])


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


def test_comments_and_empty_lines_change_nothing():
    texts = module.texts_of(vars(visualize_cradle_run))
    changed = [text.replace("\n    full_swing", "  # first\n\n\n    full_swing") for text in texts]
    assert changed != texts
    assert module.digest_of(*changed) == module.DIGEST


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
