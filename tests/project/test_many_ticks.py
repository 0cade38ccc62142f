"""many_ticks gives the same bits as the loop of main; if this is not certain, it does nothing."""

import sys
from functools import cache, partial
from math import inf
from pkgutil import resolve_name
from types import SimpleNamespace

import pytest
from hypothesis import example
from programs import OF_TESTS, python, with_vpython
from strategies import CALLS, DT, G, HAIRS, NEIGHBOURS, pendulum_rows, random_examples
from vpython import mag, vector
from whole_cradles import do_at_once, do_one_by_one

from grading.cradles import hang, hang_row, R
from src import swinging, visualize_cradle_run
from support import pendulum
from support.cradle import certainty as module
from support.cradle.many_ticks import free_ticks, many_ticks
from support.pendulum import BUFFER

DIGEST = module.DIGEST


def digest_now() -> str:
    """Return the digest of the files of the motion as they are."""
    return module.digest_of(module.texts_of_files())


@pytest.fixture(scope="module", autouse=True)
def files_as_they_are():
    """Take the files as they are for the shipped ones.

    So only one test fails if a file has changed, and the others say whether it matters.
    """
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(module, "DIGEST", digest_now())
        # Nothing that was read with the other digest is used, neither here nor afterwards.
        monkeypatch.setattr(module, "shipped_code", cache(module.shipped_code.__wrapped__))
        yield


# --- the same bits ------------------------------------------------------------------------------


def state(pend_list):
    """Return all values that a tick changes as text with every bit, and with the sign of 0.0."""
    values = []
    for pend in pend_list:
        values += [value for key, value in pend.items() if key != "objects"]
        for shape in pend["objects"]:
            values += [*shape.pos.value, *shape.axis.value]
    return repr(values)


def same_hits(pendula, **call):
    """Check that many_ticks moves pendula like single ticks, to the last bit.

    pendula has the arguments of hang for each, call those of do_at_once.
    """
    at_once = [hang(**values) for values in pendula]
    one_by_one = [hang(**values) for values in pendula]
    assert do_at_once(at_once, **call) == do_one_by_one(one_by_one, **call)
    assert state(at_once) == state(one_by_one)


@random_examples(40, 80, pendula=pendulum_rows(), call=CALLS)
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
    same_hits([left, {**right, "mass": 3}], ticks=300)


# The last bit of VPython's mag is here not that of Python.
@random_examples(100, 500, neighbours=NEIGHBOURS)
@example(
    (
        (0.6192143952711302, -1.1846127869847498, 0.04605164039394538, -0.07220118183976446),
        (-0.6293534791635063, -4.521365101161975, -0.004824247013347938, 0.041995179065634575),
    )
)
@example(
    (
        (0.5439759097213486, 3.4474842529138296, -0.09255396424366132, -0.09227003413877306),
        (-0.40148653915597277, -2.8721669084994392, 0.06162712485397276, -0.08273654361441451),
    )
)
def test_bobs_that_just_touch_after_one_tick_end_in_the_same_bits(neighbours):
    pendula = [
        {"theta": theta, "omega": omega, "axle": (i * R / 4, y, z)}
        for i, (theta, omega, y, z) in enumerate(neighbours)
    ]
    swung = [hang(**values) for values in pendula]
    swinging.full_swing_update(swung, R, DT, G)
    left, right = (pend["objects"][1].pos for pend in swung)
    radius = mag(left - right) / BUFFER / 2
    same_hits([{**values, "radius": radius} for values in pendula], ticks=1)


@pytest.mark.parametrize("theta", [0, 0.0, -0.0, 3])
@pytest.mark.parametrize("omega", [0, -0.0, 2])
def test_whole_numbers_and_zeros_of_both_signs_end_in_the_same_bits(theta, omega):
    first = {"theta": theta, "omega": omega, "mass": 1, "e": 1, "axle": (0, -0.0, -0.0)}
    for ticks, g in ((0, G), (1, 0), (100, -0.0), (3, 10)):
        same_hits([first, {"axle": (R / 4, 0, 0)}], g=g, ticks=ticks)


ON_VPYTHON = """
import vpython
vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser
import test_many_ticks as tests

tests.module.DIGEST = tests.digest_now()
tests.test_random_cradles_end_in_the_same_bits_as_after_single_ticks(10)
tests.test_bobs_that_swing_side_by_side_a_hair_from_touching_end_in_the_same_bits(10)
tests.test_bobs_that_just_touch_after_one_tick_end_in_the_same_bits(50)
"""


@with_vpython
def test_cradles_of_vpython_itself_end_in_the_same_bits():
    done = python("-c", ON_VPYTHON, **OF_TESTS)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("gap", "omega", "is_free"), [(1e-11, 0, False), (1e-9, 1e6, False), (1e-9, 0, True)]
)
def test_no_tick_is_free_if_rounding_could_close_the_gap(gap, omega, is_free):
    assert (free_ticks(gap, 0, 0, omega, omega, R, DT, G) > 0) == is_free


# --- the fast path steps back -------------------------------------------------------------------


def is_taken() -> bool:
    """Return whether the fast path replaces the loop of main.

    If not, check that it changes nothing.
    """
    pend_list = hang_row(3, omega=1.0)
    before = state(pend_list)
    taken = (
        many_ticks(vars(visualize_cradle_run), pend_list, 100, {"approaching_only": True})
        is not None
    )
    assert (state(pend_list) != before) == taken
    return taken


def test_the_fast_path_knows_the_shipped_files():
    """After a change, the programs do single ticks: the same, but slower."""
    assert digest_now() == DIGEST, (
        f"One of {', '.join(module.FILES)} has changed. If you want this change, make it in "
        "many_ticks.py, too. If the other tests here pass, this is the DIGEST of certainty.py: "
        f"{digest_now()}"
    )
    assert is_taken()


SWING = "    omega_new = omega - g * sin(theta) / r_param * dt\n"


@pytest.mark.parametrize(
    ("old", "new", "is_same"),
    [
        ('    """Return (omega_new', '    """Return the new (omega_new', True),
        (SWING, SWING.replace("_new", "_new: float"), True),
        ("angle_update(omega", "angle_update(omega: float", True),
        ("from math import sin", "from math import pi, sin\n\nTURN: float = 2 * pi", True),
        (SWING, SWING.replace("dt", "dt + 0"), False),
        ("(omega, theta, r_param, dt, g)", "(omega, theta, r_param, dt, g=10)", False),
    ],
)
def test_the_digest_is_of_the_code_of_the_functions(old, new, is_same):
    """A docstring, a type and a name for other code change nothing."""
    pendulums, swings, run = module.texts_of_files()
    assert old in swings
    changed = [pendulums, swings.replace(old, new), run]
    assert (module.digest_of(changed) == digest_now()) == is_same


@pytest.mark.parametrize(
    "place",
    [
        "src.visualize_cradle_run.main",
        "src.visualize_cradle_run.handle_two_bobs",
        "src.visualize_cradle_run.mag",
        "src.visualize_cradle_run.cos",
        "src.visualize_cradle_run.pairwise",
        "src.swinging.sin",
        "support.pendulum.arm",
        "support.pendulum.vector",
    ],
)
def test_the_fast_path_steps_back_if_a_function_is_replaced(place, monkeypatch):
    monkeypatch.setattr(place, partial(resolve_name(place)))
    assert not is_taken()
    assert place.rpartition(".")[2] in module.obstacle(vars(visualize_cradle_run))


class Number(float):
    """A constant of another kind."""


CODE = visualize_cradle_run.handle_two_bobs.__code__
TOOLS = SimpleNamespace(get_tool=lambda number: number == 5)  # of Python 3.12


@pytest.mark.parametrize(
    ("owner", "name", "value"),
    [
        (
            visualize_cradle_run.handle_two_bobs,
            "__code__",
            CODE.replace(co_consts=(*CODE.co_consts, 2)),
        ),
        (visualize_cradle_run.handle_two_bobs, "__defaults__", (True,)),
        (visualize_cradle_run.newton_cradle_tick, "__kwdefaults__", {"wind": 1}),
        (pendulum, "BUFFER", 2 * BUFFER),
        (visualize_cradle_run, "G", Number(visualize_cradle_run.G)),
        (sys, "gettrace", lambda: "a debugger"),
        (sys, "getprofile", lambda: "a profiler"),
        (sys, "monitoring", TOOLS),
    ],
)
def test_the_fast_path_steps_back_after_a_patch(owner, name, value, monkeypatch):
    assert module.obstacle(vars(visualize_cradle_run)) == ""
    monkeypatch.setattr(owner, name, value, raising=False)
    assert not is_taken()
    assert module.obstacle(vars(visualize_cradle_run))  # in words


def test_of_a_changed_function_nothing_is_said(monkeypatch):
    """Whoever has changed it knows it."""
    monkeypatch.setattr(module, "shipped_code", dict)
    assert not is_taken()
    assert module.obstacle(vars(visualize_cradle_run)) == ""


def test_the_fast_path_steps_back_from_an_unknown_keyword_and_from_a_tuple_of_pendula():
    assert many_ticks(vars(visualize_cradle_run), hang_row(2), 10, {"wind": 1}) is None
    assert do_at_once(tuple(hang_row(2))) is None


def give_a_true_mass(pend_list):
    pend_list[1]["mass"] = True


def share_a_bob(pend_list):
    axle, *_ = pend_list[1]["objects"]
    pend_list[1]["objects"] = (axle, *pend_list[0]["objects"][1:])


def take_e_away(pend_list):
    del pend_list[2]["e"]


def turn_endlessly_far(pend_list):
    pend_list[2]["theta"] = inf


def add_a_bob(pend_list):
    pend_list[0]["objects"] += (hang()["objects"][1],)


def put_an_axle_too_far_away(pend_list):
    pend_list[2]["objects"][0].pos.y = 1e6 * R


def let_vpython_turn_a_cord(pend_list):
    pend_list[0]["objects"][2].up = vector(0, 1, 0)


def let_a_contact_divide_by_zero(pend_list):
    pend_list[0].update(mass=-1, omega=5)
    pend_list[1]["mass"] = 1


@pytest.mark.parametrize(
    "change",
    [
        give_a_true_mass,
        share_a_bob,
        take_e_away,
        turn_endlessly_far,
        add_a_bob,
        put_an_axle_too_far_away,
        let_vpython_turn_a_cord,
        let_a_contact_divide_by_zero,
    ],
)
def test_the_fast_path_steps_back_from_strange_pendula_and_changes_nothing(change):
    pend_list = hang_row(3)
    change(pend_list)
    before = state(pend_list)
    assert do_at_once(pend_list, ticks=1000) is None
    assert state(pend_list) == before
