"""many_ticks gives the same bits as the loop of main, on plain numbers; if this is not certain, it does nothing."""

import ast
import os
import random
import subprocess
import sys
from collections import OrderedDict
from functools import partial, wraps
from importlib.machinery import PathFinder
from importlib.util import module_from_spec, spec_from_file_location
from math import cos, inf, nan, pi, sin
from types import FunctionType, SimpleNamespace

import pytest
from programs import ROOT, slow_but_for
from vpython import mag, sphere, vector
from whole_cradles import do_at_once

from grading.cradles import hang, R, row
from src import visualize_cradle_run
from src.beyond import many_ticks as many_ticks_module
from src.beyond.many_ticks import digest, free_ticks, many_ticks, STANDS_IN_FOR
from src.swinging import angle_update, full_swing_update
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import BUFFER

SEEDS = 30
DT, G = 1e-4, 9.81  # s, m/s^2: these tests do not depend on the shipped constants


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
    pend_list = [hang(theta, mass=mass, axle=(x + i * R / 4, 0, 0)) for i, mass in enumerate([1, 3])]
    for pend in pend_list:
        pend["objects"][1].radius = R / 8 / 1.05 * (1 + dice.choice([0, 1e-15, 1e-14, -1e-15, -1e-14]))
    return pend_list


def just_touching(seed):
    """Return two bobs that are at the contact distance after one tick, except for a rounding error."""
    dice = random.Random(seed)
    places = [(dice.uniform(-1, 1), dice.uniform(-5, 5)) for _ in range(2)]
    axles = [(i * R / 4, dice.uniform(-0.1, 0.1), dice.uniform(-0.1, 0.1)) for i in range(2)]
    pend_list = [hang(*place, axle=axle) for place, axle in zip(places, axles, strict=True)]
    full_swing_update(pend_list, R, DT, G)
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
            newton_cradle_tick(pend_list, r_param, dt, g, approaching_only)
            contacts += [(tick, *hit) for hit in hits]
            hits.clear()
    return contacts


def state(pend_list):
    """Return all values that a tick changes as text with every bit, and with the sign of 0.0."""
    shown = [(shape.pos.value, shape.axis.value) for pend in pend_list for shape in pend["objects"]]
    return repr(([[pend[key] for key in pend if key != "objects"] for pend in pend_list], shown))


# --- the same bits ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("approaching_only", [False, True])
@pytest.mark.parametrize("seed", slow_but_for(range(10), range(SEEDS)))
def test_it_does_to_the_last_bit_what_so_many_ticks_do(seed, approaching_only):
    (at_once, by), (one_by_one, _) = random_cradle(seed), random_cradle(seed)
    contacts = do_at_once(at_once, **by, approaching_only=approaching_only)
    assert contacts == do_one_by_one(one_by_one, **by, approaching_only=approaching_only)
    assert state(at_once) == state(one_by_one)


@pytest.mark.parametrize("seed", range(20))
def test_so_it_does_where_bobs_are_out_of_reach_by_a_rounding_error(seed):
    at_once, one_by_one = hair_breadth(seed), hair_breadth(seed)
    assert do_at_once(at_once, ticks=300) == do_one_by_one(one_by_one, ticks=300)
    assert state(at_once) == state(one_by_one)


def test_so_it_does_where_bobs_just_touch():
    for seed in range(200):
        at_once, one_by_one = just_touching(seed), just_touching(seed)
        assert do_at_once(at_once, ticks=1) == do_one_by_one(one_by_one, ticks=1), seed
        assert state(at_once) == state(one_by_one), seed


def test_so_it_does_where_angles_are_so_large_that_they_are_rounded_coarsely():
    """In each tick, one angle grows by a rounding error more than the other, with equal velocities."""
    bit = 2.0**-23  # rad, the step between two floats from 2**29 to 2**30

    def pair():
        turned = (2**29 + 40000) // (2 * pi) * 2 * pi
        velocities = [bit / DT * count for count in (838.501, 838.499)]
        gap = 20 * bit * R
        row = [hang(turned, omega, axle=(i * (R / 4 + gap), 0, 0)) for i, omega in enumerate(velocities)]
        for pend in row:
            pend["objects"][1].radius = R / 8 / 1.05
        return row

    at_once, one_by_one = pair(), pair()
    contacts = do_one_by_one(one_by_one, g=0, ticks=200)
    assert contacts
    assert do_at_once(at_once, g=0, ticks=200) == contacts
    assert state(at_once) == state(one_by_one)


@pytest.mark.parametrize("mass", [1, 1.0])
@pytest.mark.parametrize("theta", [0, 0.0, -0.0, 3])
@pytest.mark.parametrize("omega", [0, 0.0, -0.0, 2])
def test_so_it_does_with_whole_numbers_and_zeros_of_both_signs(theta, omega, mass):
    (at_once, one_by_one) = ([hang(theta, omega, mass, 1, (0, -0.0, -0.0)), hang(axle=(R / 4, 0, 0))] for _ in range(2))
    for ticks, g in ((1, 0), (1, G), (100, -0.0), (3, 10)):
        assert do_at_once(at_once, g=g, ticks=ticks) == do_one_by_one(one_by_one, g=g, ticks=ticks)
        assert state(at_once) == state(one_by_one)


def test_the_random_cradles_are_worth_it():
    """Many cradles have hits; in some of them, separating bobs hit, so the two rules differ."""
    hits = differ = 0
    for seed in range(SEEDS):
        ends = []
        for approaching_only in (False, True):
            pend_list, by = random_cradle(seed)
            hits += bool(do_at_once(pend_list, **by, approaching_only=approaching_only))
            ends.append(state(pend_list))
        differ += ends[0] != ends[1]
    assert hits > 20
    assert differ > 5


def test_no_ticks_change_nothing():
    pend_list, _ = random_cradle(1)
    pend_list[0]["theta"] += 1  # its bob has not moved yet
    before = state(pend_list)
    assert do_at_once(pend_list, ticks=0) == []
    assert state(pend_list) == before


def test_no_pendula_have_no_contacts():
    assert do_at_once([]) == []


def test_the_rule_can_say_that_separating_bobs_collide():
    ends = []
    for rule in ({}, {"approaching_only": False}, {"approaching_only": True}):
        pair = [hang(omega=-1.0), hang(omega=1.0, axle=(R / 8, 0, 0))]
        ends.append((many_ticks(vars(visualize_cradle_run), pair, 1, rule), state(pair)))
    assert ends[0] == ends[1] != ends[2]


# --- contacts --------------------------------------------------------------------------------------------------------


def test_it_tells_of_contacts_in_their_order():
    """The hit of the first bob runs through the row. The tick of a contact is the tick that changes omega."""
    pend_list = row(4)
    pend_list[0]["theta"] = -0.2
    contacts = do_at_once(pend_list, ticks=4000, approaching_only=True)
    assert [told for _, *told, _ in contacts] == [[0, 1, True], [1, 2, True], [2, 3, True]]
    first = contacts[0][0]
    again = row(4)
    again[0]["theta"] = -0.2
    assert do_at_once(again, ticks=first, approaching_only=True) == []
    assert do_at_once(again, ticks=1, approaching_only=True)[0][:4] == (0, 0, 1, True)


def test_a_contact_is_to_the_left_if_the_bobs_move_there():
    pend_list = row(2)
    pend_list[1]["theta"] = 0.2
    assert [told for _, *told, _ in do_at_once(pend_list, ticks=4000, approaching_only=True)] == [[0, 1, False]]


def test_bobs_that_touch_without_a_change_are_no_contact():
    pair = hang(omega=1.0), hang(omega=1.0, axle=(R / 8, 0, 0))
    assert do_at_once(list(pair), g=0, ticks=10) == []


def test_bobs_that_move_together_have_no_contacts_from_rounding():
    for masses in ((0.1, 0.7), (0.3, 0.1)):
        pair = [hang(0.3, 0.1, mass=mass, axle=(i * R / 8, 0, 0)) for i, mass in enumerate(masses)]
        assert do_at_once(pair, ticks=300, approaching_only=True) == []


def test_a_contact_that_only_the_right_bob_notices_is_told():
    pair = [hang(omega=1.0, mass=1e20), hang(axle=(R / 8, 0, 0))]
    assert do_at_once(pair, g=0, ticks=1, approaching_only=True) == [(0, 0, 1, True, pytest.approx(R))]
    assert [pend["omega"] for pend in pair] == [1, pytest.approx(2)]


# --- free bobs -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("g", [0, G])
@pytest.mark.parametrize(("angle", "velocity"), [(1e-6, 1e-6), (0.1, 0.1), (3, 0.001), (1, 5), (0.01, 5), (3, 50)])
def test_no_two_bobs_touch_while_they_are_said_to_be_free(angle, velocity, g):
    """The number of free ticks is lower than the number of ticks in which two bobs can close the gap.

    Slow bobs side by side, without gravity, are free for just one tick fewer: the bound is tight.
    """
    dice = random.Random(1)
    for _ in range(50):
        theta1, theta2 = (dice.choice([0, pi / 2, pi]) + angle * dice.uniform(-1, 1) for _ in range(2))
        omega1, omega2 = (velocity * dice.choice([0, 1, dice.uniform(-1, 1)]) for _ in range(2))
        start = theta1, theta2, omega1, omega2
        before = arm(theta2) - arm(theta1)
        for tick in range(1, 150):
            omega1, theta1 = angle_update(omega1, theta1, R, DT, g)
            omega2, theta2 = angle_update(omega2, theta2, R, DT, g)
            closer = abs(arm(theta2) - arm(theta1) - before)
            free = free_ticks(closer, *start, R, DT, g)
            assert free < tick, (tick, start)
            if velocity == 1e-6 and g == 0 and abs(theta1 - theta2) < 0.1 and closer > 1e-6 * R:
                assert free == tick - 1


def arm(theta):
    """Return the position of a bob relative to its axle (m), as a complex number."""
    return R * (sin(theta) - 1j * cos(theta))


# --- not with other functions ----------------------------------------------------------------------------------------


def copies(folder, changed="", old="", new=""):
    """Copy swinging and visualize_cradle_run to this folder, replace old by new in one of them, and return the modules.

    The changed file may also be a copy of pendulum, which swinging then uses.
    """
    modules = []
    for name, place in (("pendulum", "support"), ("swinging", "src"), ("visualize_cradle_run", "src")):
        code = (ROOT / place / f"{name}.py").read_text(encoding="utf-8")
        if name == changed:
            assert code.count(old) == 1, f"{old!r} is in {name} {code.count(old)} times: change this test"
            code = code.replace(old, new)
        (folder / f"{name}.py").write_text(code, encoding="utf-8")
        modules.append(load(folder / f"{name}.py"))
    pendulum, swinging, cradle = modules
    swinging.show_pendulum = pendulum.show_pendulum
    cradle.full_swing_update = swinging.full_swing_update
    return swinging, cradle


def load(path):
    """Return the module from this file."""
    spec = spec_from_file_location("copy_of_" + path.stem, path)
    made = module_from_spec(spec)
    sys.dont_write_bytecode, before = True, sys.dont_write_bytecode
    spec.loader.exec_module(made)
    sys.dont_write_bytecode = before
    return made


def is_taken(cradle) -> bool:
    """Return whether the fast path replaces the loop of this module; if not, check that it changes nothing."""
    pend_list = row(3, omega=1.0)
    before = state(pend_list)
    taken = many_ticks(vars(cradle), pend_list, 100, {"approaching_only": True}) is not None
    assert (state(pend_list) != before) == taken
    return taken


def test_it_stands_in_for_the_shipped_functions(tmp_path):
    assert is_taken(visualize_cradle_run)
    assert is_taken(copies(tmp_path)[1])


@pytest.mark.parametrize("name", STANDS_IN_FOR)
def test_it_knows_the_shipped_function(name):
    files = [ROOT / name for name in ("src/swinging.py", "src/visualize_cradle_run.py", "support/pendulum.py")]
    nodes = [node for file in files for node in ast.parse(file.read_bytes()).body]
    (tree,) = (node for node in nodes if isinstance(node, ast.FunctionDef) and node.name == name)
    assert digest(tree) == STANDS_IN_FOR[name], (
        f"{name} has changed, so many_ticks does not run. If you want this change, make it in src/beyond/many_ticks.py "
        f'too. When the other tests here pass, put "{digest(tree)}" for {name} into STANDS_IN_FOR.'
    )


PENDULUM, SWINGING, CRADLE = "pendulum", "swinging", "visualize_cradle_run"
ANGLE, THETA = "omega_new = omega - g * sin(theta) / r_param * dt", "theta_new = theta + omega_new * dt"
SWING = "    full_swing_update(pend_list, r_param, dt, g)\n"
LOOP = "            newton_cradle_tick(pend_list, R_PARAM, DT, G, **page.rule)\n"
TOUCH = "if mag(bob1.pos - bob2.pos) > BUFFER * (bob1.radius + bob2.radius):"
PART = "<= omega2 * cos"
VALUES = 'm1, m2 = pend1["mass"], pend2["mass"]'
BOBS = 'bob1, bob2 = pend1["objects"][1], pend2["objects"][1]'
TICK = "def newton_cradle_tick(pend_list, r_param, dt, g, approaching_only=False)"
EDITS = {  # changes: (file, old code, new code)
    "air resistance in the tick": (CRADLE, SWING, SWING + '    for p in pend_list:\n        p["omega"] *= 0.999\n'),
    "a wall": (CRADLE, SWING, SWING + '    if pend_list[0]["theta"] < -1:\n        pend_list[0]["omega"] *= -1\n'),
    "swinging after the collisions": (
        CRADLE,
        SWING + "    rule = {",
        "    for a, b in pairwise(pend_list):\n        handle_two_bobs(a, b, r_param)\n" + SWING + "    rule = {",
    ),
    "two swings": (CRADLE, SWING, SWING * 2),
    "pass": (CRADLE, SWING, "    pass\n"),
    "an error": (CRADLE, SWING, "    raise ValueError('not yet')\n"),
    "a new default": (CRADLE, TICK, TICK.replace("False", "True")),
    "an equal default": (CRADLE, TICK, TICK.replace("False", "0")),
    "one parameter more": (CRADLE, TICK, TICK.replace("=False", "=False, wind=0")),
    "a decorator": (CRADLE, TICK, "@(lambda f: f)\n" + TICK),
    "a second definition": (CRADLE, TICK, "def newton_cradle_tick(*_):\n    pass\n\n\n" + TICK),
    "two ticks": (CRADLE, LOOP, LOOP * 2),
    "a global": (CRADLE, LOOP, LOOP + "            globals()['DT'] = 2 * DT\n"),
    "a print": (CRADLE, LOOP, LOOP + "            print('tick')\n"),
    "half a tick": (CRADLE, LOOP, LOOP.replace("DT", "DT / 2")),
    "no buffer": (CRADLE, TOUCH, TOUCH.replace("BUFFER * ", "")),
    "a number for the buffer": (CRADLE, TOUCH, TOUCH.replace("BUFFER", "1.05")),
    "the buffer on the other side": (
        CRADLE,
        TOUCH,
        "if mag(bob1.pos - bob2.pos) / BUFFER > bob1.radius + bob2.radius:",
    ),
    ">= for >": (CRADLE, TOUCH, TOUCH.replace(">", ">=")),
    "< for <=": (CRADLE, PART, PART.replace("<=", "<")),
    "the other bob's mass": (CRADLE, VALUES, 'm2, m1 = pend1["mass"], pend2["mass"]'),
    "an equal index": (CRADLE, BOBS, BOBS.replace('pend1["objects"][1]', 'pend1["objects"][True]')),
    "the right one's e": (CRADLE, 'handle_collision(pend1["e"]', 'handle_collision(pend2["e"]'),
    "another order of a sum": (CRADLE, "momentum = m1 * v1 + m2 * v2", "momentum = m2 * v2 + m1 * v1"),
    "another order of a product": (CRADLE, "(momentum - m2 * e * (v1 - v2))", "(momentum - e * m2 * (v1 - v2))"),
    "no division by r_param": (CRADLE, "return v1_new / r_param,", "return v1_new,"),
    "another order in the formula": (SWINGING, ANGLE, "omega_new = omega - g * dt * sin(theta) / r_param"),
    "a small angle": (SWINGING, ANGLE, ANGLE.replace("sin(theta)", "theta")),
    "the old omega": (SWINGING, THETA, THETA.replace("omega_new", "omega")),
    "air resistance in the swing": (SWINGING, THETA, "omega_new *= 0.9999\n    " + THETA),
    "a bob above its axle": (PENDULUM, "axle.pos + axis, axis", "axle.pos - axis, axis"),
    "a cord of its own": (PENDULUM, "axle.pos + axis, axis", "axle.pos + axis, 2 * axis"),
    "the last one hangs still": (SWINGING, "for pend_dict in pend_list:", "for pend_dict in pend_list[:-1]:"),
    "an import": (CRADLE, "from math import cos\n", "from math import sin as cos\n"),
    "a definition under an if": (SWINGING, "def full_swing_update", "if True:\n  def full_swing_update"),
    "a name for itself": (CRADLE, TICK, "handle_two_bobs = handle_two_bobs.__call__\n\n\n" + TICK),
}


@pytest.mark.parametrize("edit", EDITS)
def test_it_steps_back_after_a_change_in_a_file(edit, tmp_path):
    assert not is_taken(copies(tmp_path, *EDITS[edit])[1])


SAME = {  # changes without effect: (file, old code, new code)
    "a docstring": (SWINGING, '"""Swing every pendulum of the cradle for dt (s)."""', '"""Swing all."""'),
    "no docstring": (SWINGING, '    """Swing every pendulum of the cradle for dt (s)."""\n', ""),
    "a comment": (SWINGING, THETA, THETA + "  # semi-implicit"),
    "a blank line": (SWINGING, THETA, "\n\n    " + THETA),
    "brackets": (SWINGING, THETA, "theta_new = theta + (omega_new * dt)"),
    "annotations": (
        SWINGING,
        "def full_swing_update(pend_list, r_param, dt, g) -> None:",
        "def full_swing_update(pend_list: list, r_param: float, dt, g):",
    ),
    "another way to write 1": (CRADLE, BOBS, BOBS.replace('pend1["objects"][1]', "pend1['objects'][0x1]")),
    "one more function": (CRADLE, TICK, "def friction():\n    pass\n\n\n" + TICK),
    "other starts": (
        CRADLE,
        "make_newton_cradle(page.csv, R_PARAM, THETA_INIT)",
        "make_newton_cradle(page.csv, R_PARAM, THETA_INIT )",
    ),
}


@pytest.mark.parametrize("edit", SAME)
def test_it_stands_in_where_an_edit_makes_no_difference(edit, tmp_path):
    assert is_taken(copies(tmp_path, *SAME[edit])[1])


def wrapped(function):
    """Return a wrapper that does the same as the function, and looks the same."""

    @wraps(function)
    def wrapper(*arguments, **others):
        return function(*arguments, **others)

    return wrapper


def recode(function, **parts):
    function.__code__ = function.__code__.replace(**parts)


def replace_constant(function, old, new):
    constants = function.__code__.co_consts
    if not any(constant is old for constant in constants):
        pytest.skip("this version of Python has no such constant in the code")
    recode(function, co_consts=tuple(new if constant is old else constant for constant in constants))


class Globals(dict):
    """Global names with one more name that appears only on access."""

    def __missing__(self, name):
        return sin


def with_globals(function, names):
    """Return the same function with these global names."""
    return FunctionType(function.__code__, names, function.__name__, function.__defaults__)


PATCHES = {  # changes of the copies of swinging (s) and visualize_cradle_run (c)
    "a lambda": lambda s, c: vars(c).update(newton_cradle_tick=lambda *_, **__: None),
    "a wrapper": lambda s, c: vars(c).update(newton_cradle_tick=wrapped(c.newton_cradle_tick)),
    "a partial": lambda s, c: vars(c).update(newton_cradle_tick=partial(c.newton_cradle_tick)),
    "an object": lambda s, c: vars(c).update(handle_two_bobs=SimpleNamespace(__code__=c.handle_two_bobs.__code__)),
    "None": lambda s, c: vars(c).update(handle_collision=None),
    "a deleted function": lambda s, c: vars(c).pop("handle_two_bobs"),
    "main": lambda s, c: vars(c).update(main=lambda page: None),
    "main's code": lambda s, c: setattr(c.main, "__code__", (lambda page: None).__code__),
    "exec": lambda s, c: exec(
        "def angle_update(omega, theta, r_param, dt, g): return omega, theta + omega * dt", vars(s)
    ),
    "exec with the file's name": lambda s, c: exec(
        compile("def angle_update(omega, theta, r_param, dt, g): return omega, theta", s.__file__, "exec"), vars(s)
    ),
    "a file that cannot be": lambda s, c: recode(s.angle_update, co_filename="\0"),
    "another function's code": lambda s, c: setattr(s.swing_update, "__code__", s.full_swing_update.__code__),
    "the wrong function": lambda s, c: vars(c).update(full_swing_update=s.swing_update),
    "a constant in the code": lambda s, c: replace_constant(c.handle_two_bobs, "objects", "things"),
    "an equal constant in the code": lambda s, c: replace_constant(c.newton_cradle_tick, True, 1),
    "a name in the code": lambda s, c: recode(
        s.angle_update, co_names=tuple("cos" if name == "sin" else name for name in s.angle_update.__code__.co_names)
    ),
    "defaults": lambda s, c: setattr(c.newton_cradle_tick, "__defaults__", (True,)),
    "equal defaults": lambda s, c: setattr(c.handle_two_bobs, "__defaults__", (0,)),
    "more defaults": lambda s, c: setattr(s.angle_update, "__defaults__", (9.81,)),
    "keyword defaults": lambda s, c: setattr(c.newton_cradle_tick, "__kwdefaults__", {"wind": 1}),
    "sin": lambda s, c: vars(s).update(sin=lambda theta: theta),
    "an arm": lambda s, c: s.show_pendulum.__globals__.update(arm=lambda theta, r_param: vector(theta, -r_param, 0)),
    "cos of an arm": lambda s, c: s.show_pendulum.__globals__.update(cos=sin),
    "cos in the collisions": lambda s, c: vars(c).update(cos=lambda theta: 1.0),
    "vector": lambda s, c: s.show_pendulum.__globals__.update(vector=lambda x, y, z: vector(x, y, z)),
    "mag": lambda s, c: vars(c).update(mag=lambda difference: difference.mag),
    "pairwise": lambda s, c: vars(c).update(pairwise=lambda items: list(zip(items[:-1], items[1:], strict=True))),
    "no sin": lambda s, c: vars(s).pop("sin"),
    "no BUFFER": lambda s, c: vars(c).pop("BUFFER"),
    "a wide BUFFER": lambda s, c: vars(c).update(BUFFER=inf),
    "a BUFFER of its own kind": lambda s, c: vars(c).update(BUFFER=type("Buffer", (float,), {})(1.05)),
    "a true DT": lambda s, c: vars(c).update(DT=True),
    "an endless G": lambda s, c: vars(c).update(G=nan),
    "no cord": lambda s, c: vars(c).update(R_PARAM=0),
    "a huge cord": lambda s, c: vars(c).update(R_PARAM=10**400),
    "strange globals": lambda s, c: vars(s).update(angle_update=with_globals(s.angle_update, Globals(sin=sin))),
    "a copy with another sin": lambda s, c: vars(s).update(angle_update=with_globals(s.angle_update, {"sin": cos})),
}


@pytest.mark.parametrize("patch", PATCHES)
def test_it_steps_back_after_a_patch(patch, tmp_path):
    swinging, cradle = copies(tmp_path)
    assert is_taken(cradle)
    PATCHES[patch](swinging, cradle)
    assert not is_taken(cradle)


@pytest.mark.parametrize("name", ["sin", "cos", "mag", "vector"])
def test_it_steps_back_from_another_math_or_vpython(name, tmp_path, monkeypatch):
    """The test imitates modules that were imported after a patch."""
    swinging, cradle = copies(tmp_path)
    other = type("vector", (vector,), {}) if name == "vector" else lambda number: number
    importers = [vars(module) for module in (swinging, cradle, many_ticks_module)]
    for importer in [*importers, swinging.show_pendulum.__globals__]:
        if name in importer:
            monkeypatch.setitem(importer, name, other)
    monkeypatch.setitem(many_ticks_module.MEANT, name, other)
    assert not is_taken(cradle)


def test_it_asks_again_after_a_patch_is_taken_back(tmp_path, monkeypatch):
    swinging, cradle = copies(tmp_path)
    with monkeypatch.context() as patch:
        patch.setattr(swinging, "sin", cos)
        assert not is_taken(cradle)
    assert is_taken(cradle)


def test_it_does_not_ask_again_while_nothing_changes(tmp_path, monkeypatch):
    cradle = copies(tmp_path)[1]
    assert is_taken(cradle)
    monkeypatch.setattr(many_ticks_module, "is_shipped", None)
    assert is_taken(cradle)


@pytest.mark.parametrize("edit", ["a small angle", "another order of a sum", "a new default"])
def test_what_runs_counts_and_not_what_its_file_says_now(edit, tmp_path):
    """If someone corrects a file after its import, the module in memory is still wrong."""
    cradle = copies(tmp_path, *EDITS[edit])[1]
    for name in ("swinging", "visualize_cradle_run"):
        (tmp_path / f"{name}.py").write_bytes((ROOT / "src" / f"{name}.py").read_bytes())
    assert not is_taken(cradle)


def test_it_steps_back_where_a_file_has_two_functions_of_a_name(tmp_path):
    other = "if True:\n\n    def angle_update(*state):\n        return state[:2]\n\n    first = angle_update\n"
    swinging, cradle = copies(tmp_path, SWINGING, "from math import sin\n", "from math import sin\n" + other)
    assert not is_taken(cradle)
    swinging.angle_update = swinging.first
    assert not is_taken(cradle)


def test_a_change_of_the_file_does_not_matter_to_what_runs(tmp_path):
    swinging, cradle = copies(tmp_path)
    assert is_taken(cradle)
    (tmp_path / "swinging.py").write_text("changed", encoding="utf-8")
    assert is_taken(cradle)


@pytest.mark.parametrize("text", [None, "pass", "def angle_update(:", "\0", "\N{LATIN SMALL LETTER E WITH ACUTE}"])
def test_it_steps_back_where_the_file_cannot_say_what_runs(text, tmp_path):
    cradle = copies(tmp_path)[1]
    (tmp_path / "swinging.py").unlink()
    if text is not None:
        (tmp_path / "swinging.py").write_text(text, encoding="latin-1")
    assert not is_taken(cradle)


# --- not with other pendula ------------------------------------------------------------------------------------------


def in_objects(pend, part, new):
    objects = list(pend["objects"])
    objects[part] = new
    pend["objects"] = tuple(objects)


class Ball(sphere):
    """A bob of another kind."""


STRANGE = {  # changes of a row of three pendula, p
    "a mass that is text": lambda p: p[0].update(mass="1"),
    "a true mass": lambda p: p[1].update(mass=True),
    "a mass of its own kind": lambda p: p[1].update(mass=type("Mass", (float,), {})(1)),
    "a huge mass": lambda p: p[1].update(mass=10**400),
    "no e": lambda p: p[2].pop("e"),
    "an e of None": lambda p: p[2].update(e=None),
    "an endless theta": lambda p: p[2].update(theta=inf),
    "an omega that is no number": lambda p: p[2].update(omega=nan),
    "no objects": lambda p: p[0].pop("objects"),
    "None for objects": lambda p: p[0].update(objects=None),
    "a list of objects": lambda p: p[0].update(objects=list(p[0]["objects"])),
    "one object more": lambda p: p[0].update(objects=(*p[0]["objects"], hang()["objects"][1])),
    "a bob of another kind": lambda p: in_objects(p[0], 1, Ball()),
    "objects in another order": lambda p: p[0].update(objects=p[0]["objects"][::-1]),
    "a pendulum of another kind": lambda p: p.insert(0, OrderedDict(p.pop(0))),
    "None for a pendulum": lambda p: p.append(None),
    "the same pendulum twice": lambda p: p.append(p[0]),
    "two pendula with one bob": lambda p: in_objects(p[0], 1, p[1]["objects"][1]),
    "a pendulum with its neighbour's objects": lambda p: p[0].update(objects=p[1]["objects"]),
    "one vector for two places": lambda p: setattr(p[0]["objects"][1], "_pos", p[1]["objects"][1]._pos),
    "a cord along with its axle": lambda p: setattr(p[0]["objects"][2], "_axis", p[0]["objects"][0]._pos),
    "an axle that is no place": lambda p: setattr(p[0]["objects"][0].pos, "x", nan),
    "an axle too far away": lambda p: setattr(p[2]["objects"][0].pos, "y", 1e6 * R),
    "a bob without an end": lambda p: setattr(p[0]["objects"][1], "radius", inf),
    "a bob with a trail": lambda p: setattr(p[0]["objects"][1], "make_trail", True),
    "a cord that VPython must turn": lambda p: setattr(p[0]["objects"][2], "up", vector(0, 1, 0)),
    "an error at a contact": lambda p: (p[0].update(mass=-1, omega=5), p[1].update(mass=1)),
    "an error from growing numbers": lambda p: p[0].update(e=1e308, omega=5),
}


@pytest.mark.parametrize("strange", STRANGE)
def test_it_steps_back_from_strange_pendula(strange):
    pend_list = row(3)
    assert do_at_once(row(3), ticks=1000) == []
    STRANGE[strange](pend_list)
    before = [dict(pend) if pend else pend for pend in pend_list]
    shapes = [shape for pend in pend_list if pend for shape in pend.get("objects") or ()]
    shown = repr([vars(shape) for shape in shapes])
    assert do_at_once(pend_list, ticks=1000) is None
    assert repr(before) == repr([dict(pend) if pend else pend for pend in pend_list])
    assert shown == repr([vars(shape) for shape in shapes])


def test_it_steps_back_from_another_kind_of_list_or_rule():
    assert do_at_once(tuple(row(2))) is None
    assert many_ticks(vars(visualize_cradle_run), row(2), 10, {"approaching_only": True, "wind": 1}) is None


def test_single_ticks_end_in_the_error_from_which_it_stepped_back():
    pend_list = row(3)
    STRANGE["an error at a contact"](pend_list)
    with pytest.raises(ZeroDivisionError):
        do_one_by_one(pend_list)
    assert state(pend_list) != state(row(3))


# --- on VPython itself -----------------------------------------------------------------------------------------------

PROGRAM = """
import vpython
vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser
from test_many_ticks import do_at_once, do_one_by_one, hair_breadth, just_touching, random_cradle, state

seeds = [1074, 3402, *range(100)]  # at the first two, the last bit of VPython's mag is not that of Python
pairs = [(just_touching(seed), just_touching(seed), {"ticks": 1}) for seed in seeds]
pairs += [(hair_breadth(seed), hair_breadth(seed), {"ticks": 300}) for seed in range(20)]
pairs += [(random_cradle(seed)[0], *random_cradle(seed)) for seed in range(20)]
for number, (at_once, one_by_one, by) in enumerate(pairs):
    assert do_at_once(at_once, **by) == do_one_by_one(one_by_one, **by), number
    assert state(at_once) == state(one_by_one), number
"""


@pytest.mark.skipif(PathFinder.find_spec("vpython") is None, reason="VPython is not installed")
def test_so_it_does_on_vpython_itself():
    path = os.pathsep.join(map(str, (ROOT, ROOT / "tests", ROOT / "tests" / "project")))
    done = subprocess.run([sys.executable, "-c", PROGRAM], env={**os.environ, "PYTHONPATH": path}, capture_output=True)
    assert done.returncode == 0, done.stderr.decode()
