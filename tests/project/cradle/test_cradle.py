"""The cradle of a program: release, hits, what a program sets itself, and bad results."""

import re
from collections import defaultdict
from itertools import chain

import pytest
from whole_cradles import distances, FIVE_CSV, GOOD, HEADER, let_bobs_touch, thetas

from grading.cradles import MIXED_CSV
from support import pendulum
from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.pendulum import outwards_to_angle
from support.start.mistake import MistakeError

MAKE = "make_newton_cradle"
TICK = "newton_cradle_tick"


def values(player, key):
    return player.cradle.values(key)


def test_without_the_function_for_all_bobs_only_upper_ones_of_a_double_cradle_collide():
    cradle = DoubleCradle()
    for name in ("handle_two_bobs", "handle_two_double_bobs"):
        names = {name: None, "handle_two_bobs": None}
        cradle.find_functions(names)
        assert cradle.collide_name == name


def test_the_lowest_bob_hangs_at_the_end_of_both_cords(swing):
    cradle = swing(kind=DoubleCradle).cradle
    assert cradle.axles()[0].pos.y - cradle.bobs()[-1].pos.y == pytest.approx(cradle.cords_length)


@pytest.mark.parametrize("lift", [1, 2])
@pytest.mark.parametrize(("theta", "phi"), [(45, -120), (0, -20), (30, -110)])
def test_a_release_into_hanging_pendula_pushes_them_aside(swing, lift, theta, phi):
    """Otherwise, inelastic bobs would jump apart. They do not push the lifted one."""
    pend_list = swing(kind=DoubleCradle, angle=theta, phi=phi, lift=lift).cradle.pend_list
    assert min(distances(pend_list)) > 0.98
    if lift == 1:
        assert [pend_list[0]["theta"], pend_list[0]["phi"]] == pytest.approx(thetas([theta, phi]))


def test_a_reload_takes_the_old_shapes_and_hides_the_rest(swing, monkeypatch):
    """When the first file is back, each pendulum has its first shapes again."""
    monkeypatch.setattr(pendulum, "discarded", defaultdict(list))
    player = swing()
    first = values(player, "objects")
    shapes = [*chain(*first)]
    player.read(HEADER + GOOD * 2)
    reused = [*chain(*values(player, "objects"))]
    assert len(reused) == 2 * len(first[0])
    for shape in shapes:
        assert shape.visible == any(shape is other for other in reused)
    player.read(FIVE_CSV)
    assert values(player, "objects") == first


@pytest.mark.parametrize(("phi_omega", "speed"), [(0, 2), (-1, 1), (-4, 1)])
def test_the_speed_of_a_double_hit_is_that_of_the_upper_or_the_lower_bobs(swing, phi_omega, speed):
    cradle = swing(kind=DoubleCradle, lift=0).cradle
    left, right, *_ = cradle.pend_list
    left.update(omega=1.0, phi_omega=phi_omega)
    assert cradle.approach(left, right) == pytest.approx(speed * R_PARAM)


def test_each_call_that_changes_a_velocity_is_a_hit(swing):
    """Also where a bob has its old velocity after the tick.

    Bobs that move apart hit with a speed below 0.
    """
    player = swing(HEADER + GOOD * 3, lift=0)
    player.next_cradle.settings = player.next_cradle.settings._replace(separating=True)
    cradle = player.cradle
    collide = let_bobs_touch(cradle)
    first, second, third = cradle.pend_list
    collide(first, second, R_PARAM)
    collide(second, third, R_PARAM)
    collide(first, second, R_PARAM)  # these two are at rest
    collide(third, pend2=second, r_param=R_PARAM)  # in any order
    collide(first, second, R_PARAM)
    player.hits.stop()
    assert cradle.tick_names["handle_two_bobs"] is not collide
    hits = player.hits.noted
    assert [(hit.left, hit.right) for hit in hits] == [(0, 1), (1, 2), (1, 2), (0, 1)]
    speeds = [hit.speed / R_PARAM for hit in hits]
    assert speeds == pytest.approx([2, 2, -2, -2])
    away, apart = [2, 0, 0, 2], [0, 2, 2, 0]
    for hit, omegas in zip(hits, (away, away, apart, apart), strict=True):
        assert [pend["omega"] for pend in hit.before + hit.after] == omegas


@pytest.mark.parametrize(
    ("kind", "theta", "omega", "is_asked"),
    [
        (Cradle, 0, 1, True),
        (Cradle, 0, -1, False),
        (Cradle, 0, 0, False),
        (Cradle, 2.5, 1, False),  # above the axle, it moves to the left
        (Cradle, 2.5, -1, True),
        (DoubleCradle, 0, -1, True),
    ],
)
def test_the_function_is_asked_only_about_single_bobs_that_approach(
    swing, kind, theta, omega, is_asked
):
    """What is not two pendula is for the function to refuse."""
    player = swing(kind=kind, lift=0)
    left, right, *_ = player.cradle.pend_list
    left.update(theta=theta, omega=omega)
    right["theta"] = theta

    def collide(*arguments):
        return player.hits.collide(lambda *_: "asked", *arguments)

    assert not player.hits.was_asked
    assert collide(left, right, R_PARAM) == ("asked" if is_asked else None)
    assert player.hits.was_asked
    right["theta"] = "0"
    for others in [(), (5,), (left, R_PARAM), (right,)]:
        assert collide(left, *others) == "asked"


# --- the program of a student --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("angle", "lift", "angles", "omega"),
    [
        (None, None, [10, 10, 0], -2),
        (20, None, [20, 20, 0], 0),
        (None, 3, [10, 10, 10], 0),
    ],
)
def test_the_first_picture_shows_the_cradle_as_it_was_made(
    swing, write, angle, lift, angles, omega
):
    """Only options change it. Here, two bobs are lifted by 10 degrees, and the last one moves."""
    write(MAKE, f"pend_list[0]['theta'] = pend_list[1]['theta'] = {outwards_to_angle(10)}")
    write(MAKE, "pend_list[2]['omega'] = -2")
    player = swing(MIXED_CSV, angle, lift)
    assert values(player, "theta") == pytest.approx(thetas(angles))
    assert values(player, "omega") == [0, 0, omega]


@pytest.mark.parametrize(
    ("line", "remarks"),
    [
        ("pass", []),
        (
            "pend_list[0].update(mass=2, e=0.25)",
            ["The program does not take mass and e from NC_FP."],
        ),
        ("pend_list.pop()", ["The program does not take the number of bobs from NC_FP."]),
    ],
)
@pytest.mark.parametrize("numbers", [{}, {"e": [0.5] * 5}])
def test_what_a_program_does_not_take_from_a_changed_csv_is_said(
    swing, write, numbers, line, remarks
):
    """With an option, or a slider, it gets a copy."""
    write(MAKE, line)
    assert swing(**numbers).remarks == (remarks if numbers else [])


NO_LIST = "must return a list of dictionaries, for is_running(pend_list); it got "


@pytest.mark.parametrize(
    ("name", "line", "message"),
    [
        (MAKE, "pend_list = []", f"{NO_LIST}[]."),
        (MAKE, "pend_list = 5", f"{NO_LIST}5."),
        (MAKE, "pend_list = ['pendulum']", f"{NO_LIST}['pendulum']."),
        (MAKE, "pend_list[1]['theta'] = '0'", "set theta of pendulum 2 to '0'; it must be a "),
        (MAKE, "pend_list[1]['theta'] = 1e200", "set theta of pendulum 2 to 1e+200; it must"),
        (MAKE, "pend_list[1]['mass'] = -1", "set mass of pendulum 2 to -1; it must be above 0."),
        (MAKE, "pend_list[1]['objects'] = []", "set objects of pendulum 2 to a list; it must be"),
        (
            MAKE,
            "pend_list[1]['objects'] = ()",
            "set objects of pendulum 2 to a tuple; it must be",
        ),
        (MAKE, "del pend_list[4]['omega']", "set omega of pendulum 5 to nothing; it must"),
        (TICK, "pend_list[1]['omega'] = float('nan')", "set omega of pendulum 2 to nan; it must"),
        (TICK, "pend_list.pop()", "made 4 pendula from 5; it must keep their number."),
    ],
)
def test_a_result_that_is_no_cradle_is_named_with_its_function(swing, write, name, line, message):
    write(name, line)
    with pytest.raises(MistakeError, match=f"^{re.escape(f'{name} {message}')}"):
        swing().swing(1)
