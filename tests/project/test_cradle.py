"""The cradles of the programs: options, reloads, release, hits, the dragged bob, and mistakes."""

import re
from collections import defaultdict
from functools import partial
from itertools import pairwise
from math import nan, pi, radians, sin

import pytest
from programs import slow_but_for
from whole_cradles import (
    check_places,
    distances,
    FIVE_CSV,
    GOOD,
    hang_double,
    HEADER,
    make_swing,
    PERIOD,
    thetas,
)

from grading.cradles import MIXED_CSV, R, row
from src import special_cradles, visualize_cradle_run
from support import pendulum
from support.constants import DOUBLE_DT, G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.dragging import drag_bob, drag_pendulum
from support.pendulum import BUFFER, cord_angles, outwards_to_angle
from support.start.mistake import MistakeError

MAKE = "make_newton_cradle"
TICK = "newton_cradle_tick"
BOTH = pytest.mark.parametrize("kind", [Cradle, DoubleCradle])


@pytest.fixture
def swing(tmp_path):
    """make_swing, in a folder of its own."""
    return partial(make_swing, tmp_path)


def values(player, key):
    return player.cradle.values(key)


@BOTH
def test_collisions_can_be_changed_in_full_swing_and_survive_a_reload(swing, kind):
    player = swing(MIXED_CSV, kind=kind, e=0.25, mass=2.0)
    assert values(player, "mass") == [2.0] * 3
    player.swing(100)
    angles = values(player, "theta")
    es = []
    for collision in player.cradle.collisions:
        player.use_collision(collision)
        es.append(values(player, "e"))
    assert es == [[0.9, 0.8, 0.7], [1, 1, 1], [0, 0, 0], [0.25, 0.25, 0.25]]
    assert values(player, "theta") == angles
    assert player.snapshot.filepath.read_text() == MIXED_CSV
    player.read(FIVE_CSV)
    assert values(player, "e") == [0.25] * 5
    player.use_collision("as in the CSV")
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
    for pend, axle in zip(player.cradle.pend_list, player.cradle.axles(), strict=True):
        check_places(pend, (axle.pos.x, axle.pos.y))


@BOTH
def test_reach_is_the_distance_from_an_axle_to_the_lowest_bob_at_rest(swing, kind):
    cradle = swing(kind=kind).cradle
    assert cradle.axles()[-1].pos.y - cradle.bobs()[-1].pos.y == pytest.approx(cradle.reach)


INTO_OTHERS = [(45, -120), (0, -14), (0, -20), (10, -40), (30, -110)]


@pytest.mark.parametrize("lift", [1, 2])
@pytest.mark.parametrize(("theta", "phi"), slow_but_for([(0, -14)], INTO_OTHERS))
def test_a_release_into_hanging_pendula_pushes_them_aside(swing, lift, theta, phi):
    """Otherwise, inelastic bobs would jump apart."""
    player = swing(kind=DoubleCradle, inelastic=True)
    player.cradle.release(thetas([theta, phi]), lift)
    assert min(distances(player.cradle.pend_list)) > 0.98
    least = sum(player.cradle.energies())
    for _ in range(100):
        player.swing(40)
        energy = sum(player.cradle.energies())
        assert energy <= least * (1 + 1e-6)
        least = min(least, energy)


@pytest.mark.parametrize(("theta", "phi"), INTO_OTHERS)
def test_a_single_lifted_pendulum_is_not_pushed_aside(swing, theta, phi):
    pend, *_ = swing(kind=DoubleCradle, angle=theta, phi=phi).cradle.pend_list
    assert [pend["theta"], pend["phi"]] == pytest.approx(thetas([theta, phi]))


@BOTH
def test_a_reload_takes_the_old_shapes_and_hides_the_rest(swing, monkeypatch, kind):
    monkeypatch.setattr(pendulum, "discarded", defaultdict(list))
    player = swing(kind=kind)
    player.hold(4)
    old = [shape for objects in values(player, "objects") for shape in objects]
    player.read(HEADER + "2,0.5,0,0,blue,wood\n" * 2)
    new = [shape for objects in values(player, "objects") for shape in objects]
    assert set(map(id, new)) < set(map(id, old))
    for shape in old:
        assert shape.visible == any(shape is other for other in new)
    assert values(player, "mass") == [2, 2]
    assert player.cradle.held_bob.index is None


def test_when_the_first_file_is_back_each_pendulum_has_its_first_objects_again(swing, monkeypatch):
    monkeypatch.setattr(pendulum, "discarded", defaultdict(list))
    player = swing()
    first = values(player, "objects")
    player.read(HEADER + "2,0.5,0,0,blue,wood\n" * 2)
    player.read(FIVE_CSV)
    assert values(player, "objects") == first


@pytest.mark.parametrize(
    ("kind", "separating", "stay_together"),
    [(Cradle, True, True), (Cradle, False, False), (DoubleCradle, True, False)],
)
def test_ticks_are_those_of_the_handout_and_the_hits_are_noted(
    swing, kind, separating, stay_together
):
    """With e below 1, bobs stay together if separating ones collide too."""
    player = swing(kind=kind, e=0.8)
    same = swing(kind=kind, e=0.8).cradle
    player.separating = separating
    ticks = round(0.6 * PERIOD / kind.dt)
    player.swing(ticks)
    rule = {"approaching_only": not separating} if kind is Cradle else {}
    for _ in range(ticks):
        same.scope[kind.tick_name](same.pend_list, R_PARAM, kind.dt, G, **rule)
    assert player.cradle.coordinates() == same.coordinates()
    impacts = player.impacts()
    assert " s  1" in impacts[-1]
    assert ("stay together" in " ".join(impacts)) == stay_together


@pytest.mark.parametrize(("theta", "phi"), [(30, 0), (60, -50), (10, 120)])
def test_the_speed_of_a_double_hit_is_that_of_the_nearest_bobs(swing, theta, phi):
    player = swing(HEADER + "1,1,0,0,red,wood\n" * 2, theta, phi=phi, kind=DoubleCradle)
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
    message = "^elastic_newton_cradle must return a list of dictionaries; it returned None. Is a"
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


def test_a_strange_tick_that_calls_nothing_has_no_hits(swing, monkeypatch):
    """Hits that nobody has called are seen only in a tick that keeps the momentum."""

    def tick(pend_list, *_):
        pend_list[0]["omega"] = 0.5

    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", tick)
    player = swing()
    player.swing(10)
    assert player.motion.hit_count == 0


def omegas(pendula):
    return [pend["omega"] for pend in pendula]


def test_each_call_that_changes_a_velocity_is_a_hit(swing):
    """Also where a bob has its old velocity after the tick.

    Bobs that move apart hit with a speed below 0.
    """
    cradle = swing(HEADER + GOOD * 3, lift=0).cradle
    for bob in cradle.bobs():
        bob.radius *= 1.01
    first, second, third = cradle.pend_list
    first["omega"] = 2.0
    cradle.hits.listen()
    collide = cradle.scope["handle_two_bobs"]
    collide(first, second, R_PARAM)
    collide(second, third, R_PARAM)
    collide(first, second, R_PARAM)  # these two are at rest
    collide(third, pend2=second, r_param=R_PARAM)  # in any order
    cradle.hits.stop()
    hits = cradle.hits.noted
    assert [(hit.left, hit.right) for hit in hits] == [(0, 1), (1, 2), (1, 2)]
    assert all(hit.rightwards for hit in hits)
    speeds = [hit.speed for hit in hits]
    assert speeds == pytest.approx([2 * R_PARAM, 2 * R_PARAM, -2 * R_PARAM])
    assert [omegas(hit.before) for hit in hits] == [[2, 0], [2, 0], [0, 2]]
    assert [omegas(hit.after) for hit in hits] == [[0, 2], [0, 2], [2, 0]]


# --- the held and dragged bob -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "bob", "separating"),
    [(Cradle, 1, False), (Cradle, 1, True), (DoubleCradle, 2, False), (DoubleCradle, 3, False)],
)
def test_a_held_bob_stays_and_throws_others_back(swing, kind, bob, separating):
    player = swing(kind=kind)
    player.separating = separating
    player.hold(bob)
    cradle = player.cradle
    masses = values(player, "mass")
    energy = sum(cradle.energies())
    momenta = []
    for _ in range(100):
        player.swing(round(0.9 * PERIOD / kind.dt / 100))
        momenta.append(cradle.momentum())
        assert player.impacts() == []
        for key in kind.angle_keys:
            assert values(player, key)[1:] == [0.0] * 4
    assert min(momenta) < -0.2  # as from a wall
    assert sum(cradle.energies()) == pytest.approx(energy, rel=0.01)
    assert values(player, "mass") == masses


@pytest.mark.parametrize("held", range(5))
@pytest.mark.parametrize("theta", [-1.5, -0.3, -1e-4, 1e-4, 0.3, 1.5])
def test_a_dragged_bob_pushes_those_in_its_way(held, theta):
    """Pushed bobs just touch, at rest; the others swing on.

    So do all if the bob moves less than the gap.
    """
    pend_list = row(5, omega=2.0)
    if abs(theta) < 1:  # far up, a smaller bob slips past
        pend_list[4]["objects"][1].radius *= 0.9
    drag_pendulum(pend_list, held, [theta], R)
    assert pend_list[held]["theta"] == pytest.approx(theta)
    pushed = {i for i in range(5) if abs(theta) > 0.01 and (i - held) * theta > 0}
    for i, pend in enumerate(pend_list):
        check_places(pend, (i * R / 4, 0), R)
        if i in pushed | {held}:
            assert pend["theta"] * theta > 0
            assert pend["omega"] == 0
        else:
            assert pend["theta"] == 0
            assert pend["omega"] == 2
    for left, pair in enumerate(pairwise(pend_list)):
        [distance] = distances(pair)
        assert distance > 1
        if pushed & {left, left + 1}:
            assert distance < 1 + 1e-6


@pytest.mark.parametrize(
    ("before", "theta", "after"),
    [
        ([0, 0], -3.0, [-3.0, 0]),  # away from its neighbour, and on over its axle
        ([3.0, 0], -3.0, [2 * pi - 3.0, 0]),  # the short way, over the top
    ],
)
def test_a_dragged_bob_leaves_those_that_are_not_in_its_way(before, theta, after):
    pend_list = row(2)
    for pend, angle in zip(pend_list, before, strict=True):
        pend["theta"] = angle
    drag_pendulum(pend_list, 0, [theta], R)
    assert [pend["theta"] for pend in pend_list] == pytest.approx(after)


def test_a_bob_is_pushed_to_the_same_side_after_a_whole_turn():
    pair, turned = row(2), row(2)
    turned[1]["theta"] = -2 * pi
    drag_pendulum(pair, 0, [0.3], R)
    drag_pendulum(turned, 0, [0.3], R)
    assert turned[1]["theta"] == pytest.approx(pair[1]["theta"])


def double_row(count, phi=0.0):
    """Return double pendula R / 4 apart that move; their upper cords hang straight down."""
    return [
        hang_double(phi=phi, axle=(i * R / 4, 0), omega=2.0, phi_omega=-1.0, r_param=R)
        for i in range(count)
    ]


@pytest.mark.parametrize("phi", [0.3, -0.3, 6.0, -6.0, 0.0, 2 * pi])
@pytest.mark.parametrize(("x", "y"), [(0.3, -0.4), (-0.3, -0.2), (0.1, 0.5), (-0.05, -0.05)])
def test_a_lower_bob_follows_the_mouse_and_its_cords_bend_to_the_same_side_as_before(x, y, phi):
    """Straight cords bend so that the upper bob hangs lower than the line to the mouse."""
    [pend] = pend_list = double_row(1, phi)
    drag_bob(pend_list, 0, 1, x, y, R)
    assert pend["objects"][3].pos.value == pytest.approx([x, y, 0])
    check_places(pend, (0, 0), R)
    bend = sin(phi) if phi % (2 * pi) else x
    assert sin(pend["phi"]) * bend > 0


@pytest.mark.parametrize("bob", [0, 1])
@pytest.mark.parametrize("held", [1, 2])
@pytest.mark.parametrize(("x", "y"), [(0.5, -0.6), (-0.5, -0.6), (0.3, -0.3), (-0.2, -0.5)])
def test_both_bobs_push_those_in_their_way(held, bob, x, y):
    pend_list = double_row(4, 0.5)
    drag_bob(pend_list, held, bob, held * R / 4 + x, y, R)
    assert min(distances(pend_list)) > 1
    in_the_way = pend_list[:held] if x < 0 else pend_list[held + 1 :]
    assert 0 in [pend["omega"] for pend in in_the_way]


def test_an_upper_bob_leaves_the_direction_of_its_lower_cord():
    pend_list = double_row(4, 0.5)
    drag_bob(pend_list, 1, 0, 0.5, -0.6, R)
    assert cord_angles(pend_list[1])[1] == pytest.approx(0.5)


def test_a_bob_stops_if_those_in_its_way_have_no_room():
    """The neighbour's upper bob is stuck between the two bobs of the dragged pendulum."""
    pend_list = double_row(5)
    for held, bob, x, y in [(3, 0, 0.57, 0.17), (3, 1, -0.27, 0.03)]:
        drag_bob(pend_list, held, bob, x, y, R)
        assert min(distances(pend_list)) > 0.999


def test_all_stay_where_they_were_if_there_is_no_room(monkeypatch):
    """It does not jump to the next free place, and the other pendula swing on."""
    pend_list = double_row(3)
    answers = iter([False] + [True] * 99)
    monkeypatch.setattr("support.cradle.dragging.push_others", lambda *_: next(answers))
    drag_bob(pend_list, 0, 0, 0.3, -0.3, R)
    assert [cord_angles(pend) for pend in pend_list] == [[0, 0]] * 3
    assert [pend["omega"] for pend in pend_list] == [0, 2, 2]


def test_a_raised_bob_that_is_held_falls_by_less_than_a_hundredth_of_a_degree(swing, change):
    places = []
    change(TICK, lambda pend_list: places.append(pend_list[0]["theta"]))
    player = swing()
    player.hold(0)
    player.swing(305)
    assert places == pytest.approx([outwards_to_angle(30)] * 305, abs=radians(0.01))


# --- the functions of a student -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("angle", "lift", "angles", "omega"),
    [
        (None, None, [10, 10, 0], -2),
        (20, None, [20, 20, 0], 0),
        (None, 3, [10, 10, 10], 0),
        (5, 1, [5, 0, 0], 0),
    ],
)
def test_the_first_picture_shows_the_cradle_as_it_was_made(
    swing, change, angle, lift, angles, omega
):
    """But for the options. Here, two bobs are lifted by 10 degrees, and the last one moves."""

    def lift_two(pend_list):
        for pend in pend_list[:2]:
            pend["theta"] = outwards_to_angle(10)
        pend_list[2]["omega"] = -2
        return pend_list

    change(MAKE, lift_two)
    player = swing(MIXED_CSV, angle, lift)
    assert values(player, "theta") == pytest.approx(thetas(angles))
    assert values(player, "omega") == [0, 0, omega]


def check_message(swing, message):
    with pytest.raises(MistakeError, match=f"^{re.escape(message)}"):
        swing().swing(1)


@pytest.mark.parametrize(
    ("result", "found"),
    [
        (None, "None. Is a return missing?"),
        ([], "an empty list."),
        ((), "a tuple."),
        (["pendulum"], "a list."),
    ],
)
def test_a_result_that_is_no_cradle_is_named_with_its_function(swing, change, result, found):
    change(MAKE, lambda pend_list: result)
    check_message(
        swing,
        f"{MAKE} must return a list of dictionaries, and main must show it; page.show got {found}",
    )


@pytest.mark.parametrize(
    ("name", "key", "value", "found"),
    [
        (MAKE, "theta", "0", "'0'; it must be a finite number."),
        (MAKE, "objects", [], "a list; it must be a tuple of parts."),
        (TICK, "omega", nan, "nan; it must be a finite number."),
        (TICK, "omega", None, "None; it must be a finite number."),
        (TICK, "theta", (1, 2), "(1, 2); it must be a finite number."),
    ],
)
def test_a_strange_value_is_named_with_its_function(swing, change, name, key, value, found):
    def put(pend_list):
        pend_list[1][key] = value
        return pend_list

    change(name, put)
    check_message(swing, f"{name} set {key} of pendulum 2 to {found}")


def take_omega(pend_list):
    del pend_list[4]["omega"]
    return pend_list


@pytest.mark.parametrize(
    ("name", "mistake", "message"),
    [
        (MAKE, take_omega, "set omega of pendulum 5 to nothing; it must"),
        (TICK, list.pop, "made 4 pendula from 5; it must keep their number."),
    ],
)
def test_what_is_missing_is_named_with_the_function_that_took_it(
    swing, change, name, mistake, message
):
    change(name, mistake)
    check_message(swing, f"{name} {message}")
