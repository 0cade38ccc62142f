"""A cradle as main makes it: options, reloads, release, hits, and results that are no cradle."""

import re
from collections import defaultdict
from inspect import getsource
from itertools import chain
from math import nan

import pytest
from whole_cradles import distances, FIVE_CSV, GOOD, HEADER, make_live, PERIOD, thetas

from grading.cradles import MIXED_CSV
from src import special_cradles, visualize_cradle_run
from support import pendulum
from support.constants import DOUBLE_DT, G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.pendulum import BUFFER, outwards_to_angle
from support.start.mistake import MistakeError

MAKE = "make_newton_cradle"
TICK = "newton_cradle_tick"
BOTH = pytest.mark.parametrize("kind", [Cradle, DoubleCradle])


def values(player, key):
    return player.cradle.values(key)


def test_the_mass_and_e_of_all_survive_a_reload(swing):
    player = swing(MIXED_CSV, e=0.25, mass=2.0)
    assert values(player, "mass") == [2.0] * 3
    assert values(player, "e") == [0.25] * 3
    player.read(FIVE_CSV)
    assert values(player, "e") == [0.25] * 5
    player.next_cradle.want(e_source=None)
    player.read(FIVE_CSV)
    assert values(player, "e") == [1.0] * 5


@BOTH
@pytest.mark.parametrize(("lift", "lifted"), [(0, 0), (2, 2), (9, 3)])
def test_release_lifts_the_first_pendula_outwards_and_all_are_at_rest(swing, kind, lift, lifted):
    player = swing(MIXED_CSV, kind=kind)
    player.swing(500)
    angles = thetas([30, -20])[: kind.cord_count]
    player.cradle.release(angles, lift)
    for key, angle in zip(kind.angle_keys, angles, strict=True):
        assert values(player, key) == pytest.approx([angle] * lifted + [0] * (3 - lifted))
    for key in kind.rate_keys:
        assert values(player, key) == [0, 0, 0]


def test_without_the_function_for_all_bobs_only_upper_ones_of_a_double_cradle_collide(monkeypatch):
    monkeypatch.delattr("src.double_cradle.handle_two_double_bobs")
    monkeypatch.setattr("src.double_cradle.handle_two_bobs", None, raising=False)
    assert make_live(DoubleCradle).collide_name == "handle_two_bobs"


@BOTH
def test_reach_is_the_distance_from_an_axle_to_the_lowest_bob_at_rest(swing, kind):
    cradle = swing(kind=kind).cradle
    assert cradle.axles()[-1].pos.y - cradle.bobs()[-1].pos.y == pytest.approx(cradle.cords_length)


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


@pytest.mark.parametrize(
    ("kind", "separating"), [(Cradle, False), (Cradle, True), (DoubleCradle, True)]
)
def test_ticks_are_those_of_the_handout_and_the_hits_are_noted(swing, kind, separating):
    """With e below 1, the bobs of a single cradle move otherwise if separating ones collide."""
    player = swing(kind=kind, e=0.8)
    same = swing(kind=kind, e=0.8).cradle
    player.next_cradle.separating = separating
    ticks = round(0.4 * PERIOD / kind.dt)
    player.swing(ticks)
    rule = {"approaching_only": not separating} if kind is Cradle else {}
    for _ in range(ticks):
        same.scope[kind.tick_name](same.pend_list, R_PARAM, kind.dt, G, **rule)
    assert player.cradle.coordinates() == same.coordinates()
    assert player.motion.hit_count > 0


@pytest.mark.parametrize(("kind", "lengths"), [(Cradle, 1), (DoubleCradle, 1.5)])
def test_the_velocity_of_a_pendulum_is_the_mean_of_its_bobs(swing, kind, lengths):
    """A pendulum that hangs straight swings as a whole; lengths are those of a cord."""
    cradle = swing(kind=kind, lift=0).cradle
    pend = cradle.pend_list[0]
    pend["omega"] = 2.0
    assert cradle.velocity(pend) == pytest.approx(2.0 * lengths * R_PARAM)


@pytest.mark.parametrize(("theta", "phi"), [(60, -50), (20, -60)])
def test_the_speed_of_a_double_hit_is_that_of_the_nearest_bobs(swing, theta, phi):
    """First of the upper bobs, then of the lower ones."""
    player = swing(HEADER + GOOD * 2, theta, phi=phi, kind=DoubleCradle)
    while not player.motion.loudest:
        before = distances(player.cradle.pend_list)
        player.swing(1)
    after = distances(player.cradle.pend_list)
    touching = BUFFER * 2 * player.cradle.bobs()[0].radius
    closer = (before[after.index(min(after))] - min(after)) * touching / DOUBLE_DT
    assert player.motion.loudest == pytest.approx(closer, rel=0.01)


def test_a_function_that_returns_no_pendula_with_the_e_of_the_options_is_named(swing, monkeypatch):
    def elastic_newton_cradle(_):
        pass

    monkeypatch.setattr(special_cradles, "elastic_newton_cradle", elastic_newton_cradle)
    message = "^elastic_newton_cradle must return a list of dictionaries; it returned None.$"
    with pytest.raises(MistakeError, match=message):
        swing(elastic=True)


@pytest.fixture
def change(monkeypatch):
    """A function that lets mistake(pend_list) change what make_newton_cradle or a tick has done.

    make_newton_cradle then returns its result.
    """

    def change(name, mistake):
        function = vars(visualize_cradle_run)[name]

        def changed(given, *others):
            pend_list = function(given, *others) or given
            return mistake(pend_list)

        changed.__name__ = name
        monkeypatch.setattr(visualize_cradle_run, name, changed)

    return change


def test_hits_are_calls_of_the_function_beside_the_tick(swing, monkeypatch):
    """Also where a student has both in another file. Afterwards, the function is back."""
    names = dict(vars(visualize_cradle_run))
    exec(getsource(visualize_cradle_run.newton_cradle_tick), names)
    monkeypatch.setattr(visualize_cradle_run, TICK, names[TICK])
    player = swing()
    player.cradle.many_ticks = None
    player.swing(round(0.4 * PERIOD / player.cradle.dt))
    assert player.motion.hit_count >= 4
    assert names["handle_two_bobs"] is visualize_cradle_run.handle_two_bobs


def test_each_call_that_changes_a_velocity_is_a_hit(swing):
    """Also where a bob has its old velocity after the tick, and where a function gets copies.

    Bobs that move apart hit with a speed below 0. Only two pendula of the cradle can hit.
    """
    player = swing(HEADER + GOOD * 3, lift=0)
    cradle = player.cradle
    for bob in cradle.bobs():
        bob.radius *= 1.01
    first, second, third = cradle.pend_list
    first["omega"] = 2.0
    player.hits.listen()
    collide = cradle.tick_names["handle_two_bobs"]
    collide(first, second, R_PARAM)
    collide(second, third, R_PARAM)
    collide(first, second, R_PARAM)  # these two are at rest
    collide(third, pend2=second, r_param=R_PARAM)  # in any order
    collide(dict(first), dict(second), R_PARAM)
    player.hits.stop()
    for others in ((), (first,), ({"omega": 0},)):
        player.hits.note_hit(lambda pend, *_: pend.update(omega=1), dict(first), *others)
    hits = player.hits.noted
    assert [(hit.left, hit.right) for hit in hits] == [(0, 1), (1, 2), (1, 2), (0, 1)]
    speeds = [hit.speed / R_PARAM for hit in hits]
    assert speeds == pytest.approx([2, 2, -2, -2])
    away, apart = [2, 0, 0, 2], [0, 2, 2, 0]
    for hit, omegas in zip(hits, (away, away, apart, apart), strict=True):
        assert [pend["omega"] for pend in hit.before + hit.after] == omegas


# --- the functions of a student -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("angle", "lift", "angles", "omega"),
    [
        (None, None, [10, 10, 0], -2),
        (20, None, [20, 20, 0], 0),
        (None, 3, [10, 10, 10], 0),
    ],
)
def test_the_first_picture_shows_the_cradle_as_it_was_made(
    swing, change, angle, lift, angles, omega
):
    """Only options change it. Here, two bobs are lifted by 10 degrees, and the last one moves."""

    def lift_two(pend_list):
        for pend in pend_list[:2]:
            pend["theta"] = outwards_to_angle(10)
        pend_list[2]["omega"] = -2
        return pend_list

    change(MAKE, lift_two)
    player = swing(MIXED_CSV, angle, lift)
    assert values(player, "theta") == pytest.approx(thetas(angles))
    assert values(player, "omega") == [0, 0, omega]


def put(key, value):
    """Return a mistake: it sets pend[key] of the second pendulum."""

    def mistake(pend_list):
        pend_list[1][key] = value
        return pend_list

    return mistake


def take_omega(pend_list):
    del pend_list[4]["omega"]
    return pend_list


NO_LIST = "must return a list of dictionaries, and main must show it; page.show got "


@pytest.mark.parametrize(
    ("name", "mistake", "message"),
    [
        (MAKE, lambda pend_list: None, f"{NO_LIST}None."),
        (MAKE, lambda pend_list: [], f"{NO_LIST}[]."),
        (MAKE, lambda pend_list: ["pendulum"], f"{NO_LIST}['pendulum']."),
        (MAKE, put("theta", "0"), "set theta of pendulum 2 to '0'; it must be a number "),
        (MAKE, put("theta", 1e200), "set theta of pendulum 2 to 1e+200; it must"),
        (MAKE, put("objects", []), "set objects of pendulum 2 to a list; it must be a tuple"),
        (MAKE, take_omega, "set omega of pendulum 5 to nothing; it must"),
        (TICK, put("omega", nan), "set omega of pendulum 2 to nan; it must"),
        (TICK, list.pop, "made 4 pendula from 5; it must keep their number."),
    ],
)
def test_a_result_that_is_no_cradle_is_named_with_its_function(
    swing, change, name, mistake, message
):
    change(name, mistake)
    with pytest.raises(MistakeError, match=f"^{re.escape(f'{name} {message}')}"):
        swing().swing(1)
