"""many_ticks gives the same bits as the loop of main, on plain numbers; if this is not certain, it
does nothing.
"""

import random
import sys
from functools import cache, partial
from hashlib import sha256
from itertools import product
from math import inf
from types import SimpleNamespace

import pytest
from programs import OF_TESTS, python, ROOT, slow_but_for, with_vpython
from vpython import mag, vector
from whole_cradles import do_at_once, do_one_by_one

from grading.cradles import hang, R, row
from src import swinging, visualize_cradle_run
from support import pendulum
from support.cradle import many_ticks as module
from support.cradle.many_ticks import many_ticks
from support.pendulum import BUFFER

RUN = visualize_cradle_run
DIGEST = module.DIGEST
DT, G = 1e-4, 9.81  # s, m/s^2: these tests do not depend on the shipped constants


def digest() -> str:
    """Return the digest of the files of the motion, as they are now."""
    texts = [(ROOT / file).read_text(encoding="utf-8") for file in module.FILES]
    return sha256("".join(texts).encode()).hexdigest()[:16]


# So that only one test fails if a file has changed, and the others say whether it matters
module.DIGEST = digest()


def random_cradle(seed):
    """Return 0 to 12 random pendula, in every second cradle almost alike, and the arguments
    r_param, dt, g, ticks.
    """
    dice = random.Random(seed)
    pend_list = []
    for i in range(dice.randint(0, 12)):
        theta, omega = dice.uniform(-1, 1), dice.choice([1, 1, 20]) * dice.uniform(-5, 5)
        if seed % 2 and i:
            before, spread = pend_list[-1], dice.choice([0, 1e-6, 1e-3])
            theta, omega = (
                before[key] + dice.uniform(-spread, spread) for key in ("theta", "omega")
            )
        e = dice.choice([0, 1, dice.random()])
        axle = (i * R / 4, dice.choice([0, 0.01]), dice.choice([0, 0.01]))
        pend_list.append(hang(theta, omega, 10 ** dice.uniform(-2, 2), e, axle))
        pend_list[-1]["objects"][1].radius *= dice.choice([1, dice.uniform(0.5, 1.1)])
    ticks = dice.choice([1, 10, 500, 2000, 5000])
    usual = [(DT, G), (DT, G), (10 * DT, G), (DT, 1000)]
    dt, g = dice.choice([*usual, *usual, (1000 * DT, G), (DT, 0), (DT, -G), (0, G), (-DT, G)])
    return pend_list, {"r_param": dice.choice([R, R, R, -R]), "dt": dt, "g": g, "ticks": ticks}


def hair_breadth(seed):
    """Return two bobs far from the origin that swing side by side at the contact distance, except
    for rounding.
    """
    dice = random.Random(seed)
    theta, x = dice.uniform(-1, 1), dice.choice([1, 10, 100])
    radii = [R / 8 / 1.05 * (1 + dice.choice([0, 1e-15, 1e-14, -1e-15, -1e-14])) for _ in range(2)]
    return [
        hang(theta, 0, 3**i, axle=(x + i * R / 4, 0, 0), radius=radius)
        for i, radius in enumerate(radii)
    ]


def just_touching(seed):
    """Return two bobs that are at the contact distance after one tick, except for a rounding error."""
    dice = random.Random(seed)
    places = [(dice.uniform(-1, 1), dice.uniform(-5, 5)) for _ in range(2)]
    axles = [(i * R / 4, dice.uniform(-0.1, 0.1), dice.uniform(-0.1, 0.1)) for i in range(2)]
    pend_list = [hang(*place, axle=axle) for place, axle in zip(places, axles, strict=True)]
    swinging.full_swing_update(pend_list, R, DT, G)
    radius = mag(pend_list[0]["objects"][1].pos - pend_list[1]["objects"][1].pos) / BUFFER / 2
    return [
        hang(*place, axle=axle, radius=radius) for place, axle in zip(places, axles, strict=True)
    ]


def state(pend_list):
    """Return all values that a tick changes as text with every bit, and with the sign of 0.0."""
    shown = [(shape.pos.value, shape.axis.value) for pend in pend_list for shape in pend["objects"]]
    return repr(([[pend[key] for key in pend if key != "objects"] for pend in pend_list], shown))


def same_contacts(make, **by):
    """Check that many_ticks moves a cradle of make() like single ticks, to the last bit."""
    at_once, one_by_one = make(), make()
    assert do_at_once(at_once, **by) == do_one_by_one(one_by_one, **by)
    assert state(at_once) == state(one_by_one)


@pytest.mark.parametrize("approaching_only", [False, True])
@pytest.mark.parametrize("seed", slow_but_for([5, 12, 16, 17, 18, 20, 22], range(30)))
def test_random_cradles_end_in_the_same_bits_as_after_single_ticks(seed, approaching_only):
    same_contacts(
        lambda: random_cradle(seed)[0], **random_cradle(seed)[1], approaching_only=approaching_only
    )


@pytest.mark.parametrize("count", slow_but_for([3], [3, 20]))
def test_bobs_that_touch_or_not_by_a_rounding_error_end_in_the_same_bits(count):
    for make, ticks, seeds in ((hair_breadth, 300, count), (just_touching, 1, 20 * count)):
        for seed in range(seeds):
            same_contacts(lambda: make(seed), ticks=ticks)  # noqa: B023  it is called at once


@pytest.mark.parametrize(("theta", "omega"), [*product([0, 0.0, -0.0, 3], [0, -0.0, 2])])
def test_whole_numbers_and_zeros_of_both_signs_end_in_the_same_bits(theta, omega):
    for ticks, g in ((0, G), (1, 0), (100, -0.0), (3, 10)):
        same_contacts(
            lambda: [hang(theta, omega, 1, 1, (0, -0.0, -0.0)), hang(axle=(R / 4, 0, 0))],
            g=g,
            ticks=ticks,
        )


def is_taken() -> bool:
    """Return whether the fast path replaces the loop of main; if not, check that it changes
    nothing.
    """
    pend_list = row(3, omega=1.0)
    before = state(pend_list)
    taken = many_ticks(vars(RUN), pend_list, 100, {"approaching_only": True}) is not None
    assert (state(pend_list) != before) == taken
    return taken


def test_the_fast_path_knows_the_shipped_files():
    """After a change, the programs do single ticks: the same, but slower."""
    words = "If you want this change, make it in many_ticks.py, too. If the other tests here pass, this is its DIGEST:"
    assert digest() == DIGEST, f"One of {', '.join(module.FILES)} has changed. {words} {digest()}"
    assert is_taken()


@pytest.mark.parametrize("number", range(3))
def test_the_fast_path_steps_back_from_another_text_but_not_from_other_line_ends(
    number, tmp_path, monkeypatch
):
    files = list(module.FILES)
    text = (ROOT / files[number]).read_bytes()
    files[number] = tmp_path / "file.py"
    monkeypatch.setattr(module, "FILES", files)
    for other, same in ((text.replace(b"\n", b"\r\n"), True), (text + b"# a comment\n", False)):
        files[number].write_bytes(other)
        monkeypatch.setattr(module, "shipped_code", cache(module.shipped_code.__wrapped__))
        assert is_taken() == same


USED = {  # what the fast path replaces, by its module
    RUN: "main newton_cradle_tick full_swing_update handle_two_bobs handle_collision mag cos pairwise",
    swinging: "swing_update angle_update show_pendulum sin",
    pendulum: "arm vector",
}
PATCHES = {  # an owner, a name in it, and what makes its new value from the old one
    **{
        f"another {name}": (owner, name, partial)
        for owner, names in USED.items()
        for name in names.split()
    },
    "a changed constant": (
        RUN.handle_two_bobs,
        "__code__",
        lambda code: code.replace(co_consts=(*code.co_consts, 2)),
    ),
    "another distance": (pendulum, "BUFFER", lambda buffer: 2 * buffer),
    "another default": (RUN.handle_two_bobs, "__defaults__", lambda _: (True,)),
    "a default of a keyword": (RUN.newton_cradle_tick, "__kwdefaults__", lambda _: {"wind": 1}),
    "a constant of another kind": (RUN, "G", lambda g: type("Number", (float,), {})(g)),
    "a debugger": (sys, "gettrace", lambda _: lambda: print),
    "a profiler": (sys, "getprofile", lambda _: lambda: print),
    "a tool of Python 3.12": (
        sys,
        "monitoring",
        lambda _: SimpleNamespace(get_tool=lambda number: number == 5),
    ),
}


@pytest.mark.parametrize("name", PATCHES)
def test_the_fast_path_steps_back_after_a_patch(name, monkeypatch):
    owner, attribute, change = PATCHES[name]
    monkeypatch.setattr(owner, attribute, change(getattr(owner, attribute, None)), raising=False)
    assert not is_taken()


STRANGE = {  # changes of a row of three pendula, p
    "a true mass": lambda p: p[1].update(mass=True),
    "a shared bob": lambda p: p[1].update(objects=(p[1]["objects"][0], *p[0]["objects"][1:])),
    "no e": lambda p: p[2].pop("e"),
    "an endless theta": lambda p: p[2].update(theta=inf),
    "one object more": lambda p: p[0].update(objects=(*p[0]["objects"], hang()["objects"][1])),
    "an axle too far away": lambda p: setattr(p[2]["objects"][0].pos, "y", 1e6 * R),
    "a cord that VPython must turn": lambda p: setattr(p[0]["objects"][2], "up", vector(0, 1, 0)),
    "an error at a contact": lambda p: (p[0].update(mass=-1, omega=5), p[1].update(mass=1)),
}


@pytest.mark.parametrize("strange", STRANGE)
def test_the_fast_path_steps_back_from_strange_pendula(strange):
    pend_list = row(3)
    STRANGE[strange](pend_list)
    before = state(pend_list)
    assert (do_at_once(pend_list, ticks=1000), state(pend_list)) == (None, before)
    assert many_ticks(vars(RUN), row(2), 10, {"wind": 1}) is do_at_once(tuple(row(2))) is None


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
