"""The cradles of the programs, single and double: options, reloads, release, hits, the dragged bob,
and mistakes.
"""

import random
import re
from collections import defaultdict
from functools import partial
from itertools import pairwise, product
from math import inf, nan, pi, radians, sin

import pytest
from programs import slow_but_for
from whole_cradles import (
    check_places,
    distances,
    FIVE_CSV,
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
from support.cradle.cradle import Cradle, DoubleCradle
from support.cradle.dragging import drag_bob, drag_pendulum
from support.pendulum import BUFFER, cord_angles, outwards_to_angle
from support.start.mistake import MistakeError

BOTH = pytest.mark.parametrize("kind", [Cradle, DoubleCradle])


@pytest.fixture
def swing(tmp_path):
    """make_swing, in a folder of its own."""
    return partial(make_swing, tmp_path)


def values(player, key):
    return player.cradle.values(key)


@BOTH
def test_collisions_are_those_of_the_options_can_be_changed_in_full_swing_and_survive_a_reload(
    swing, kind
):
    for options, e in (
        ({"elastic": True}, 1),
        ({"inelastic": True}, 0),
        ({"e": 0.25, "mass": 2.0}, 0.25),
    ):
        player = swing(MIXED_CSV, kind=kind, **options)
        assert values(player, "e") == [e] * 3
    assert values(player, "mass") == [2.0] * 3
    player.swing(100)
    angles, es = values(player, "theta"), []
    for collision in player.cradle.collisions:
        player.collide(collision)
        es.append(values(player, "e"))
    assert es == [[0.9, 0.8, 0.7], [1, 1, 1], [0, 0, 0], [0.25, 0.25, 0.25]]
    assert values(player, "theta") == angles
    assert player.snapshot.filepath.read_text() == MIXED_CSV
    player.read(FIVE_CSV)
    assert values(player, "e") == [0.25] * 5
    player.collide("as in the CSV")
    assert values(player, "e") == [1.0] * 5


@BOTH
@pytest.mark.parametrize(("lifted", "expected"), [(0, 0), (2, 2), (9, 3)])
def test_release_lifts_the_first_pendula_outwards_and_all_are_at_rest(
    swing, kind, lifted, expected
):
    player = swing(MIXED_CSV, kind=kind)
    player.swing(500)
    player.cradle.release(thetas([30, -20])[: len(kind.angles)], lifted)
    for key, angle in zip(kind.angle_keys, (30, -20), strict=False):
        assert values(player, key) == pytest.approx(
            [outwards_to_angle(angle)] * expected + [0] * (3 - expected)
        )
    assert [values(player, key) for key in kind.rate_keys] == [[0, 0, 0]] * len(kind.rate_keys)
    for pend, axle in zip(player.cradle.pend_list, player.cradle.axles(), strict=True):
        check_places(pend, (axle.pos.x, axle.pos.y))
    assert expected == 3 or axle.pos.y - player.cradle.bobs()[-1].pos.y == pytest.approx(
        player.cradle.reach
    )


INTO_OTHERS = product([1, 2], [(45, -120), (0, -14), (0, -20), (10, -40), (30, -110)])


@pytest.mark.parametrize(("lifted", "angles"), slow_but_for([(1, (0, -14))], INTO_OTHERS))
def test_a_release_into_hanging_pendula_pushes_them_aside(swing, lifted, angles):
    """Otherwise, inelastic bobs would jump apart. A single lifted pendulum stays where it is."""
    player = swing(kind=DoubleCradle, inelastic=True)
    player.cradle.release(thetas(angles), lifted)
    assert lifted > 1 or values(player, "phi")[0] == pytest.approx(outwards_to_angle(angles[1]))
    assert min(distances(player.cradle.pend_list)) > 0.98
    least = sum(player.cradle.energies())
    for _ in range(100):
        player.swing(40)
        assert sum(player.cradle.energies()) <= least * (1 + 1e-6)
        least = min(least, sum(player.cradle.energies()))


@BOTH
def test_a_reload_takes_the_old_shapes_and_hides_the_rest(swing, monkeypatch, kind):
    """When the first file is back, each single pendulum has its first objects again."""
    monkeypatch.setattr(pendulum, "discarded", defaultdict(list))
    player = swing(kind=kind)
    player.cradle.hand.hold(4)
    first = values(player, "objects")
    player.read(HEADER + "2,0.5,0,0,blue,wood\n" * 2)
    new = {id(shape) for objects in values(player, "objects") for shape in objects}
    assert new < {id(shape) for objects in first for shape in objects}
    assert all(shape.visible == (id(shape) in new) for objects in first for shape in objects)
    assert (values(player, "mass"), player.cradle.hand.held) == ([2, 2], None)
    player.read(FIVE_CSV)
    assert kind is DoubleCradle or values(player, "objects") == first


@pytest.mark.parametrize(
    ("kind", "separating"), [(Cradle, True), (Cradle, False), (DoubleCradle, True)]
)
def test_ticks_are_those_of_the_handout_and_the_hits_are_noted(swing, kind, separating):
    """With e below 1, bobs stay together if separating ones collide too."""
    player, same = swing(kind=kind, e=0.8), swing(kind=kind, e=0.8).cradle
    player.separating = separating
    ticks = round(0.6 * PERIOD / kind.dt)
    player.swing(ticks)
    for _ in range(ticks):
        rule = {"approaching_only": not separating} if kind is Cradle else {}
        same.scope[kind.tick_name](same.pend_list, R_PARAM, kind.dt, G, **rule)
    assert player.cradle.coordinates() == same.coordinates()
    trains = " ".join(map(str, player.motion.trains.trains))
    assert (trains[:1], "stay together" in trains) == ("1", separating and kind is Cradle)


@pytest.mark.parametrize(("theta", "phi"), [(30, 0), (60, -50), (10, 120)])
def test_the_speed_of_a_double_hit_is_that_of_the_nearest_bobs(swing, theta, phi):
    player = swing(HEADER + "1,1,0,0,red,wood\n" * 2, theta, phi=phi, kind=DoubleCradle)
    while not player.motion.fastest:
        before = distances(player.cradle.pend_list)
        player.swing(1)
    after = distances(player.cradle.pend_list)
    touching = BUFFER * 2 * player.cradle.bobs()[0].radius
    closer = (before[after.index(min(after))] - min(after)) * touching / DOUBLE_DT
    assert player.motion.fastest == pytest.approx(closer, rel=0.01)


def test_a_function_that_returns_no_pendula_with_the_e_of_the_options_is_named(swing, monkeypatch):
    def elastic_newton_cradle(_):
        pass

    monkeypatch.setattr(special_cradles, "elastic_newton_cradle", elastic_newton_cradle)
    words = "elastic_newton_cradle must return a list of dictionaries; it returned None. Is a return missing?"
    with pytest.raises(MistakeError, match=re.escape(words)):
        swing(elastic=True)


@pytest.mark.parametrize("value", [0.5, None, "0"])
def test_a_strange_tick_that_calls_nothing_has_no_hits_and_a_wrong_value_is_named(
    swing, monkeypatch, value
):
    """Hits that nobody has called are seen only in a tick that keeps the momentum."""

    def tick(pend_list, *_):
        pend_list[0]["omega"] = value

    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", tick)
    player = swing()
    if value == 0.5:
        player.swing(10)
        assert player.motion.hits == 0
    else:
        with pytest.raises(
            MistakeError, match=f"tick set omega of pendulum 1 to {value!r}; it must be a finite"
        ):
            player.swing(10)


def test_each_call_that_changes_a_velocity_is_a_hit(swing):
    """Also where a bob has its old velocity after the tick.

    Bobs that move apart hit with a speed below 0.
    """
    cradle = swing(lift=0).cradle
    for bob in cradle.bobs():
        bob.radius *= 1.01
    cradle.pend_list[0]["omega"] = 2.0
    cradle.hits.listen()
    for left, right in [*pairwise(cradle.pend_list), cradle.pend_list[:2]]:
        cradle.scope["handle_two_bobs"](left, right, R_PARAM)  # the last two are at rest
    # In any order
    cradle.scope["handle_two_bobs"](cradle.pend_list[4], pend2=cradle.pend_list[3], r_param=R_PARAM)
    cradle.hits.stop()
    speed = pytest.approx(2 * R_PARAM)
    *four, last = [
        (*hit[:4], *(pend["omega"] for pend in (*hit.before, *hit.after)))
        for hit in cradle.hits.new
    ]
    assert four == [(i, i + 1, True, speed, 2, 0, 0, 2) for i in range(4)]
    assert last == (3, 4, True, pytest.approx(-2 * R_PARAM), 0, 2, 2, 0)


# --- the held and dragged bob -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "bob", "separating"),
    [(Cradle, 1, False), (Cradle, 1, True), (DoubleCradle, 2, False), (DoubleCradle, 3, False)],
)
def test_a_held_bob_stays_and_throws_others_back(swing, kind, bob, separating):
    player = swing(kind=kind)
    player.separating = separating
    cradle = player.cradle
    cradle.hand.hold(bob)
    masses, energy, thrown_back = values(player, "mass"), sum(cradle.energies()), False
    for _ in range(100):
        player.swing(round(0.9 * PERIOD / kind.dt / 100))
        assert player.motion.trains.lines() == []
        assert [values(player, key)[1:] for key in kind.angle_keys] == [[0.0] * 4] * len(
            kind.angles
        )
        thrown_back = thrown_back or cradle.momentum() < -0.2
    assert thrown_back  # as from a rig
    assert sum(cradle.energies()) == pytest.approx(energy, rel=0.01)
    assert values(player, "mass") == masses


def drag(pend_list, held, theta):
    """Drag the held pendulum to theta in one step; return the thetas of all pendula."""
    drag_pendulum(pend_list, held, [theta], R)
    return [pend["theta"] for pend in pend_list]


@pytest.mark.parametrize("held", range(5))
@pytest.mark.parametrize("theta", [-1.5, -0.3, -1e-4, 1e-4, 0.3, 1.5])
def test_a_dragged_bob_pushes_those_in_its_way(held, theta):
    """Pushed bobs just touch, at rest; the others swing on, and so do all if the bob moves less
    than the gap.
    """
    pend_list = row(5, omega=2.0)
    # Far up, a smaller bob slips past
    pend_list[4]["objects"][1].radius *= 0.9 if abs(theta) < 1 else 1
    assert drag(pend_list, held, theta)[held] == pytest.approx(theta)
    pushed = [abs(theta) > 0.01 and (i - held) * theta > 0 for i in range(5)]
    for i, pend in enumerate(pend_list):
        assert (pend["theta"] != 0, pend["omega"]) == (
            (True, 0) if pushed[i] or i == held else (False, 2)
        )
        check_places(pend, (i * R / 4, 0), R)
    for i, pair in enumerate(pairwise(pend_list)):
        assert 1 < min(distances(pair)) < (1 + 1e-6 if any(pushed[i : i + 2]) else inf)


def test_a_dragged_bob_leaves_those_that_are_not_in_its_way():
    # Away from its neighbour, and on over its axle
    assert drag(row(2), 0, -3.0) == pytest.approx([-3.0, 0])
    pend_list = row(3)
    pend_list[1]["theta"] = 3.0
    # The short way, over the top
    assert drag(pend_list, 1, -3.0) == pytest.approx([0, 2 * pi - 3.0, 0])
    turned = row(2)
    turned[1]["theta"] = -2 * pi
    # Pushed to the same side after a whole turn
    assert drag(turned, 0, 0.3) == pytest.approx(drag(row(2), 0, 0.3))


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
    pend_list = double_row(1, phi)
    drag_bob(pend_list, 0, 1, x, y, R)
    assert pend_list[0]["objects"][3].pos.value == pytest.approx([x, y, 0])
    check_places(pend_list[0], (0, 0), R)
    bend = sin(phi) if phi % (2 * pi) else x
    assert (sin(pend_list[0]["phi"]) > 0) == (bend > 0)
    drag_bob(pend_list, 0, 1, 3.0, -4.0, R)  # out of reach: the cords stretch in this direction
    assert pend_list[0]["objects"][3].pos.value == pytest.approx([1.2 * R, -1.6 * R, 0])


@pytest.mark.parametrize("bob", [0, 1])
@pytest.mark.parametrize("held", range(4))
@pytest.mark.parametrize(("x", "y"), [(0.5, -0.6), (-0.5, -0.6), (0.3, -0.3), (-0.2, -0.5)])
def test_both_bobs_push_those_in_their_way(held, bob, x, y):
    """An upper bob leaves the direction of its lower cord."""
    pend_list = double_row(4, 0.5)
    axle = pend_list[held]["objects"][0].pos
    drag_bob(pend_list, held, bob, axle.x + x, axle.y + y, R)
    assert min(distances(pend_list)) > 1
    assert bob == 1 or cord_angles(pend_list[held])[1] == pytest.approx(0.5)
    moved = [pend["omega"] == 0 for pend in pend_list]
    assert any(moved[:held] if x < 0 else moved[held + 1 :]) == (held != (0 if x < 0 else 3))


@pytest.mark.parametrize("seed", slow_but_for([26], [26, 47, 55, 57]))
def test_a_bob_stops_if_those_in_its_way_have_no_room(seed):
    """The neighbour's upper bob is stuck between the two bobs of the dragged pendulum; without a
    stop, they overlap.
    """
    dice, pend_list = random.Random(seed), double_row(5)
    for _ in range(12):
        held, bob = dice.randrange(5), dice.randrange(2)
        drag_bob(pend_list, held, bob, dice.uniform(-1, 1), dice.uniform(-0.8, 0.2), R)
        assert min(distances(pend_list)) > 0.999


def test_all_stay_where_they_were_if_there_is_no_room(monkeypatch):
    """It does not jump to the next free place, and the other pendula swing on."""
    pend_list, room = double_row(3), iter([False, *[True] * 99])
    monkeypatch.setattr("support.cradle.dragging.push_others", lambda *_: next(room))
    drag_bob(pend_list, 0, 0, 0.3, -0.3, R)
    assert [cord_angles(pend) for pend in pend_list] == [[0, 0]] * 3
    assert [pend["omega"] for pend in pend_list] == [0, 2, 2]


# --- the functions of a student --------------------------------------------------------------------------------------

MAKE, TICK = "make_newton_cradle", "newton_cradle_tick"
SHOWN = "must return a list of dictionaries, and main must show it; page.show got"


@pytest.fixture
def change(monkeypatch):
    """A function that lets change(result) replace the result of make_newton_cradle, or change the
    cradle of a tick.
    """

    def replace(name, change):
        function = vars(visualize_cradle_run)[name]

        def changed(given, *others):
            return change(function(given, *others) or given)

        changed.__name__ = name
        monkeypatch.setattr(visualize_cradle_run, name, changed)

    return replace


def test_a_raised_bob_that_is_held_falls_by_less_than_a_hundredth_of_a_degree(swing, change):
    places = []
    change(TICK, lambda pend_list: places.append(pend_list[0]["theta"]))
    player = swing()
    player.cradle.hand.hold(0)
    player.swing(305)
    assert places == pytest.approx([outwards_to_angle(30)] * 305, abs=radians(0.01))


@pytest.mark.parametrize(
    ("angle", "lifted", "lifts", "omega"),
    [
        (None, None, [10, 10, 0], -2),
        (20, None, [20, 20, 0], 0),
        (None, 3, [10] * 3, 0),
        (5, 1, [5, 0, 0], 0),
    ],
)
def test_the_first_picture_shows_the_cradle_as_it_was_made(
    swing, change, angle, lifted, lifts, omega
):
    """But for the options: make_newton_cradle lifts two bobs by 10 degrees, and the last one moves."""

    def lift_two(pend_list):
        for pend in pend_list[:2]:
            pend["theta"] = outwards_to_angle(10)
        pend_list[2]["omega"] = -2
        return pend_list

    change(MAKE, lift_two)
    player = swing(MIXED_CSV, angle, lifted)
    assert values(player, "theta") == pytest.approx(thetas(lifts))
    assert values(player, "omega") == [0, 0, omega]
    assert player.cradle.as_made == ([pytest.approx(outwards_to_angle(10))], 2)


def put(key, value):
    """Return a function that puts a value into the second pendulum of a cradle, and returns the
    cradle.
    """
    return lambda pend_list: pend_list[1].update({key: value}) or pend_list


@pytest.mark.parametrize(
    ("name", "mistake", "words"),
    [
        (MAKE, lambda pend_list: None, f"{SHOWN} None. Is a return missing?"),
        (MAKE, lambda pend_list: [], f"{SHOWN} an empty list."),
        (MAKE, tuple, f"{SHOWN} a tuple."),
        (MAKE, lambda pend_list: ["pendulum"], f"{SHOWN} a list."),
        (MAKE, put("theta", "0"), "set theta of pendulum 2 to '0'; it must be a finite number."),
        (
            MAKE,
            put("objects", []),
            "set objects of pendulum 2 to a list; it must be a tuple of parts.",
        ),
        (
            MAKE,
            lambda pend_list: pend_list[4].pop("omega") or pend_list,
            "set omega of pendulum 5 to nothing; it must",
        ),
        (TICK, list.pop, "made 4 pendula from 5; it must keep their number."),
        (TICK, put("omega", nan), "set omega of pendulum 2 to nan; it must be a finite number."),
        (
            TICK,
            put("theta", (1, 2)),
            "set theta of pendulum 2 to (1, 2); it must be a finite number.",
        ),
    ],
)
def test_a_result_that_is_no_cradle_is_named_with_its_function(swing, change, name, mistake, words):
    change(name, mistake)
    with pytest.raises(MistakeError, match=f"^{name} {re.escape(words)}"):
        swing().swing(1)
