"""many_ticks gives the same bits as the loop of main, on plain numbers; if this is not certain, it does nothing."""

import random
import sys
from cmath import rect
from collections import OrderedDict
from importlib.util import module_from_spec, spec_from_file_location
from math import cos, inf, pi, sin
from types import FunctionType, SimpleNamespace

import pytest
from programs import OF_TESTS, python, ROOT, slow_but_for, with_vpython
from vpython import mag, vector
from whole_cradles import do_at_once

from grading.cradles import hang, R, row
from src import swinging, visualize_cradle_run
from support import pendulum
from support.constants import BUFFER
from support.cradle import many_ticks as many_ticks_module
from support.cradle.many_ticks import digest_of, free_ticks, many_ticks, MEANT, STANDS_IN_FOR

DT, G = 1e-4, 9.81  # s, m/s^2: these tests do not depend on the shipped constants


@pytest.fixture(autouse=True)
def forget_digests():
    """Equal code of another test's file would be known."""
    digest_of.cache_clear()
    yield
    digest_of.cache_clear()


def random_cradle(seed):
    """Return a row of 1 to 12 random pendula (mass, e, angle, radius, place), and the arguments r_param, dt, g, ticks.

    In every second cradle, each pendulum swings almost like the one before it, as after a common lift.
    """
    dice = random.Random(seed)
    pend_list = []
    for i in range(dice.randint(1, 12)):
        theta, omega = dice.uniform(-1, 1), dice.choice([1, 1, 20]) * dice.uniform(-5, 5)
        if seed % 2 and i:
            before, spread = pend_list[-1], dice.choice([0, 1e-6, 1e-3])
            theta, omega = (before[key] + dice.uniform(-spread, spread) for key in ("theta", "omega"))
        values = {"theta": theta, "omega": omega, "e": dice.choice([0, 1, dice.random()])}
        axle = (i * R / 4, dice.choice([0, 0.01]), dice.choice([0, 0.01]))
        pend_list.append(hang(**values, mass=10 ** dice.uniform(-2, 2), axle=axle))
        pend_list[-1]["objects"][1].radius *= dice.choice([1, dice.uniform(0.5, 1.1)])
    ticks = dice.choice([1, 10, 500, 2000, 5000])
    usual = [(DT, G), (DT, G), (10 * DT, G), (DT, 1000)]
    dt, g = dice.choice([*usual, *usual, (1000 * DT, G), (DT, 0), (DT, -G), (0, G), (-DT, G)])
    return pend_list, {"r_param": dice.choice([R, R, R, -R]), "dt": dt, "g": g, "ticks": ticks}


def hair_breadth(seed):
    """Return two bobs far from the origin that swing side by side at the contact distance, except for rounding."""
    dice = random.Random(seed)
    theta, x = dice.uniform(-1, 1), dice.choice([1, 10, 100])
    radii = [R / 8 / 1.05 * (1 + dice.choice([0, 1e-15, 1e-14, -1e-15, -1e-14])) for _ in range(2)]
    return [hang(theta, 0, 3**i, axle=(x + i * R / 4, 0, 0), radius=radius) for i, radius in enumerate(radii)]


def just_touching(seed):
    """Return two bobs that are at the contact distance after one tick, except for a rounding error."""
    dice = random.Random(seed)
    places = [(dice.uniform(-1, 1), dice.uniform(-5, 5)) for _ in range(2)]
    axles = [(i * R / 4, dice.uniform(-0.1, 0.1), dice.uniform(-0.1, 0.1)) for i in range(2)]
    pend_list = [hang(*place, axle=axle) for place, axle in zip(places, axles, strict=True)]
    swinging.full_swing_update(pend_list, R, DT, G)
    radius = mag(pend_list[0]["objects"][1].pos - pend_list[1]["objects"][1].pos) / BUFFER / 2
    return [hang(*place, axle=axle, radius=radius) for place, axle in zip(places, axles, strict=True)]


def do_one_by_one(pend_list, r_param=R, dt=DT, g=G, ticks=1000, approaching_only=False):
    """Call newton_cradle_tick `ticks` times; return the contacts as many_ticks does."""
    contacts, hits = [], []  # for all ticks, and for one
    original = visualize_cradle_run.handle_two_bobs

    def handle_two_bobs(pend1, pend2, r_param, **rule):
        before = pend1["omega"], pend2["omega"]
        velocities = [pend["omega"] * cos(pend["theta"]) for pend in (pend1, pend2)]
        original(pend1, pend2, r_param, **rule)
        if (pend1["omega"], pend2["omega"]) != before:
            left = next(i for i, pend in enumerate(pend_list) if pend is pend1)
            hits.append((left, left + 1, sum(velocities) > 0, (velocities[0] - velocities[1]) * r_param))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(visualize_cradle_run, "handle_two_bobs", handle_two_bobs)
        for tick in range(ticks):
            visualize_cradle_run.newton_cradle_tick(pend_list, r_param, dt, g, approaching_only)
            contacts += [(tick, *hit) for hit in hits]
            hits.clear()
    return contacts


def state(pend_list):
    """Return all values that a tick changes as text with every bit, and with the sign of 0.0."""
    shown = [(shape.pos.value, shape.axis.value) for pend in pend_list for shape in pend["objects"]]
    return repr(([[pend[key] for key in pend if key != "objects"] for pend in pend_list], shown))


def same_contacts(make, **by):
    """Check that many_ticks moves a cradle of make() like single ticks, to the last bit; return the contacts."""
    at_once, one_by_one = make(), make()
    contacts = do_at_once(at_once, **by)
    assert contacts == do_one_by_one(one_by_one, **by)
    assert state(at_once) == state(one_by_one)
    return contacts


# --- the same bits ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("approaching_only", [False, True])
@pytest.mark.parametrize("seed", slow_but_for([5, 12, 16, 17, 18, 20, 22], range(30)))
def test_random_cradles_end_in_the_same_bits_as_after_single_ticks(seed, approaching_only):
    same_contacts(lambda: random_cradle(seed)[0], **random_cradle(seed)[1], approaching_only=approaching_only)


@pytest.mark.parametrize("count", slow_but_for([3], [3, 20]))
def test_bobs_that_touch_or_not_by_a_rounding_error_end_in_the_same_bits(count):
    for make, ticks, seeds in ((hair_breadth, 300, count), (just_touching, 1, 20 * count)):
        for seed in range(seeds):
            same_contacts(lambda: make(seed), ticks=ticks)  # noqa: B023  it is called at once


def test_large_angles_end_in_the_same_bits_though_they_are_rounded_coarsely():
    """In each tick, one angle grows by a rounding error more than the other, with equal velocities."""
    bit = 2.0**-23  # rad, the step between two floats from 2**29 to 2**30
    turned = (2**29 + 40000) // (2 * pi) * 2 * pi
    omegas = [bit / DT * count for count in (838.501, 838.499)]

    def pair():
        axles = [(i * (R / 4 + 20 * bit * R), 0, 0) for i in range(2)]
        return [hang(turned, omegas[i], axle=axles[i], radius=R / 8 / 1.05) for i in range(2)]

    assert same_contacts(pair, g=0, ticks=200)


@pytest.mark.parametrize("theta", [0, 0.0, -0.0, 3])
@pytest.mark.parametrize("omega", [0, 0.0, -0.0, 2])
def test_whole_numbers_and_zeros_of_both_signs_end_in_the_same_bits(theta, omega):
    for ticks, g in ((1, 0), (1, G), (100, -0.0), (3, 10)):
        same_contacts(lambda: [hang(theta, omega, 1, 1, (0, -0.0, -0.0)), hang(axle=(R / 4, 0, 0))], g=g, ticks=ticks)


def test_no_ticks_change_nothing_and_no_pendula_have_no_contacts():
    pend_list, _ = random_cradle(1)
    pend_list[0]["theta"] += 1  # its bob has not moved yet
    before = state(pend_list)
    assert (do_at_once(pend_list, ticks=0), state(pend_list)) == ([], before)
    assert do_at_once([]) == []


def test_a_contact_changes_a_velocity_by_more_than_rounding():
    assert do_at_once([hang(omega=1.0), hang(omega=1.0, axle=(R / 8, 0, 0))], g=0, ticks=10) == []
    for masses in ((0.1, 0.7), (0.3, 0.1)):
        pair = [hang(0.3, 0.1, mass=mass, axle=(i * R / 8, 0, 0)) for i, mass in enumerate(masses)]
        assert do_at_once(pair, ticks=300, approaching_only=True) == []
    pair = [hang(omega=1.0, mass=1e20), hang(axle=(R / 8, 0, 0))]  # the hit changes only the right one
    assert do_at_once(pair, g=0, ticks=1, approaching_only=True) == [(0, 0, 1, True, pytest.approx(R))]


@pytest.mark.parametrize("g", [0, G])
@pytest.mark.parametrize(("angle", "velocity"), [(1e-6, 1e-6), (0.1, 0.1), (3, 0.001), (1, 5), (0.01, 5), (3, 50)])
def test_no_two_bobs_touch_while_they_are_said_to_be_free(angle, velocity, g):
    """The number of free ticks is lower than the number of ticks in which two bobs can close the gap.

    Slow bobs side by side, without gravity, are free for just one tick fewer: the bound is tight.
    """
    dice = random.Random(1)
    for _ in range(20):
        theta1, theta2 = (dice.choice([0, pi / 2, pi]) + angle * dice.uniform(-1, 1) for _ in range(2))
        omega1, omega2 = (velocity * dice.choice([0, 1, dice.uniform(-1, 1)]) for _ in range(2))
        start = theta1, theta2, omega1, omega2
        before = rect(R, theta2) - rect(R, theta1)
        for tick in range(1, 150):
            omega1, theta1 = swinging.angle_update(omega1, theta1, R, DT, g)
            omega2, theta2 = swinging.angle_update(omega2, theta2, R, DT, g)
            closer = abs(rect(R, theta2) - rect(R, theta1) - before)
            free = free_ticks(closer, *start, R, DT, g)
            assert free < tick, (tick, start)
            if velocity == 1e-6 and g == 0 and abs(theta1 - theta2) < 0.1 and closer > 1e-6 * R:
                assert free == tick - 1


# --- not with other functions or pendula -----------------------------------------------------------------------------


def copies(folder, changed="", old="", new=""):
    """Copy pendulum, swinging and visualize_cradle_run to this folder, and return the modules.

    Replace old by new in the changed one. swinging uses the copy of pendulum.
    """
    modules = []
    for name, place in (("pendulum", "support"), ("swinging", "src"), ("visualize_cradle_run", "src")):
        code = (ROOT / place / f"{name}.py").read_text(encoding="utf-8")
        if name == changed:
            assert code.count(old) == 1, f"{old!r} is in {name} {code.count(old)} times: change this test"
            code = code.replace(old, new)
        (folder / f"{name}.py").write_text(code, encoding="utf-8")
        spec = spec_from_file_location(f"copy_of_{name}", folder / f"{name}.py")
        modules.append(module_from_spec(spec))
        spec.loader.exec_module(modules[-1])
    pendulum, swinging, cradle = modules
    swinging.show_pendulum = pendulum.show_pendulum
    cradle.full_swing_update = swinging.full_swing_update
    return modules


def is_taken(cradle) -> bool:
    """Return whether the fast path replaces the loop of this module; if not, check that it changes nothing."""
    pend_list = row(3, omega=1.0)
    before = state(pend_list)
    taken = many_ticks(vars(cradle), pend_list, 100, {"approaching_only": True}) is not None
    assert (state(pend_list) != before) == taken
    return taken


@pytest.mark.parametrize("name", STANDS_IN_FOR)
def test_the_fast_path_knows_the_shipped_function(name):
    (function,) = {vars(module)[name] for module in (visualize_cradle_run, swinging, pendulum) if name in vars(module)}
    digest = digest_of(function.__code__, repr(function.__defaults__))
    assert digest == STANDS_IN_FOR[name], (
        f"{name} has changed, so many_ticks does not run. If you want this change, make it in "
        "support/cradle/many_ticks.py, too. When the other tests here pass, "
        f'put "{digest}" for {name} into STANDS_IN_FOR.'
    )


PENDULUM, SWINGING, CRADLE = "pendulum", "swinging", "visualize_cradle_run"
OMEGA = "g * sin(theta) / r_param * dt"
SWING = "    full_swing_update(pend_list, r_param, dt, g)\n"
LOOP = "newton_cradle_tick(pend_list, R_PARAM, DT, G, **page.rule)"
TICK = "def newton_cradle_tick(pend_list, r_param, dt, g, approaching_only=False)"
EDITS = {  # changes: (file, old code, new code)
    "a wall": (CRADLE, SWING, SWING + '    if pend_list[0]["theta"] < -1:\n        pend_list[0]["omega"] *= -1\n'),
    "a decorator": (CRADLE, TICK, "@(lambda f: f)\n" + TICK),
    "half a tick": (CRADLE, LOOP, LOOP.replace("DT", "DT / 2")),
    "a small angle": (SWINGING, OMEGA, OMEGA.replace("sin(theta)", "theta")),
    "a bob above its axle": (PENDULUM, "axle.pos + axis, axis", "axle.pos - axis, axis"),
    "a definition under an if": (SWINGING, "def full_swing_update", "if True:\n  def full_swing_update"),
}
SAME = {  # changes without effect: (file, old code, new code)
    "no docstring": (SWINGING, '    """Swing every pendulum of the cradle for dt (s)."""\n', ""),
    "annotations": (SWINGING, "(pend_list, r_param, dt, g)", "(pend_list: list, r_param: float, dt, g)"),
    "one more function": (CRADLE, TICK, "def friction():\n    pass\n\n\n" + TICK),
}


@pytest.mark.parametrize("edit", [*EDITS, *SAME])
def test_the_fast_path_steps_back_after_an_edit_that_makes_a_difference(edit, tmp_path):
    """The code in memory counts: someone can correct a file after its import."""
    *_, cradle = copies(tmp_path, *{**EDITS, **SAME}[edit])
    assert is_taken(cradle) == (edit in SAME)
    copies(tmp_path)
    digest_of.cache_clear()
    assert edit in SAME or not is_taken(cradle)


PATCHES = {  # changes of the copies of swinging (s) and visualize_cradle_run (c)
    "a lambda": lambda s, c: vars(c).update(newton_cradle_tick=lambda *_, **__: None),
    "an object": lambda s, c: vars(c).update(handle_two_bobs=SimpleNamespace(__code__=c.handle_two_bobs.__code__)),
    "the wrong function": lambda s, c: vars(c).update(full_swing_update=s.swing_update),
    "equal defaults": lambda s, c: setattr(c.handle_two_bobs, "__defaults__", (0,)),
    "keyword defaults": lambda s, c: setattr(c.newton_cradle_tick, "__kwdefaults__", {"wind": 1}),
    "odd globals": lambda s, c: setattr(s, "angle_update", FunctionType(s.angle_update.__code__, OrderedDict(sin=sin))),
    "a BUFFER of its own kind": lambda s, c: vars(c).update(BUFFER=type("Buffer", (float,), {})(1.05)),
}


@pytest.mark.parametrize("patch", PATCHES)
def test_the_fast_path_steps_back_after_a_patch(patch, tmp_path):
    _, swinging, cradle = copies(tmp_path)
    assert is_taken(cradle)
    PATCHES[patch](swinging, cradle)
    assert not is_taken(cradle)


@pytest.mark.parametrize("name", MEANT)
def test_the_fast_path_steps_back_from_another_global(name, tmp_path, monkeypatch):
    """Also from an unknown math or VPython, which many_ticks has imported, too."""
    *others, cradle = copies(tmp_path)
    other = type("vector", (vector,), {}) if name == "vector" else lambda *given: given
    readers = [module for module in (*others, cradle) if name in vars(module)]
    for module in readers:
        with monkeypatch.context() as patch:
            patch.setattr(module, name, other)
            assert not is_taken(cradle)
    for module in (*readers, many_ticks_module):
        monkeypatch.setattr(module, name, other)
    monkeypatch.setitem(MEANT, name, other)
    assert not is_taken(cradle) or name == "pairwise"


@pytest.mark.parametrize("watcher", ["gettrace", "getprofile", "monitoring"])
def test_the_fast_path_steps_back_while_a_debugger_or_a_profiler_watches(watcher, monkeypatch):
    """The test imitates Python's answers; sys.monitoring exists from Python 3.12 on."""
    tools = SimpleNamespace(get_tool=lambda number: "debugger" if number == 5 else None)
    monkeypatch.setattr(sys, watcher, tools if watcher == "monitoring" else lambda: print, raising=False)
    assert not is_taken(visualize_cradle_run)


@pytest.mark.parametrize("text", [None, b"pass", b"def angle_update(:", b"\0"])
def test_the_fast_path_needs_a_file_that_says_what_runs_but_only_once(text, tmp_path):
    *_, cradle = copies(tmp_path)
    assert is_taken(cradle)
    path = tmp_path / "swinging.py"
    path.unlink()
    if text is not None:
        path.write_bytes(text)
    assert is_taken(cradle)
    digest_of.cache_clear()
    assert not is_taken(cradle)


STRANGE = {  # changes of a row of three pendula, p
    "a true mass": lambda p: p[1].update(mass=True),
    "a huge mass": lambda p: p[1].update(mass=10**400),
    "no e": lambda p: p[2].pop("e"),
    "an endless theta": lambda p: p[2].update(theta=inf),
    "one object more": lambda p: p[0].update(objects=(*p[0]["objects"], hang()["objects"][1])),
    "a pendulum of another kind": lambda p: p.insert(0, OrderedDict(p.pop(0))),
    "one vector for two places": lambda p: setattr(p[0]["objects"][1], "_pos", p[1]["objects"][1]._pos),
    "an axle too far away": lambda p: setattr(p[2]["objects"][0].pos, "y", 1e6 * R),
    "a bob without an end": lambda p: setattr(p[0]["objects"][1], "radius", inf),
    "a bob with a trail": lambda p: setattr(p[0]["objects"][1], "make_trail", True),
    "a cord that VPython must turn": lambda p: setattr(p[0]["objects"][2], "up", vector(0, 1, 0)),
    "an error at a contact": lambda p: (p[0].update(mass=-1, omega=5), p[1].update(mass=1)),
    "an error from growing numbers": lambda p: p[0].update(e=1e308, omega=5),
}


@pytest.mark.parametrize("strange", STRANGE)
def test_the_fast_path_steps_back_from_strange_pendula(strange):
    pend_list = row(3)
    assert do_at_once(row(3), ticks=1000) == []
    STRANGE[strange](pend_list)
    before = state(pend_list)
    assert do_at_once(pend_list, ticks=1000) is None
    assert state(pend_list) == before


def test_the_fast_path_steps_back_from_another_kind_of_list_or_rule():
    assert do_at_once(tuple(row(2))) is None
    assert many_ticks(vars(visualize_cradle_run), row(2), 10, {"approaching_only": True, "wind": 1}) is None


# --- on VPython itself -----------------------------------------------------------------------------------------------

PROGRAM = """
import sys, vpython
vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser
from test_many_ticks import hair_breadth, just_touching, random_cradle, same_contacts

count = int(sys.argv[1])
for seed in [1074, 3402, *range(5 * count)]:  # at the first two, the last bit of VPython's mag is not that of Python
    same_contacts(lambda: just_touching(seed), ticks=1)
for seed in range(count):
    same_contacts(lambda: hair_breadth(seed), ticks=300)
    same_contacts(lambda: random_cradle(seed + 11)[0], **random_cradle(seed + 11)[1])
"""


@with_vpython
@pytest.mark.parametrize("count", slow_but_for([5], [5, 20]))
def test_cradles_of_vpython_itself_end_in_the_same_bits(count):
    done = python("-c", PROGRAM, count, **OF_TESTS)
    assert done.returncode == 0, done.stderr
