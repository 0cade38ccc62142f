"""The double cradle: its objects, laws of motion, hits, and page."""

import random
from collections import defaultdict
from math import cos, hypot, pi, sin, sqrt
from unittest.mock import patch

import pytest
from programs import (
    BOBS,
    end,
    first_lines,
    MOVES,
    needs_vpython,
    open_cradle,
    pause,
    press,
    QUIETLY,
    readout,
    running,
    slow_but_for,
    wait_until,
)
from test_csv import NO_CRADLE, UNREADABLE
from test_honor_roll import LENGTH, SWINGS
from vpython import color, textures, vector
from whole_cradles import components, distances, GOOD, hang_double, HEADER, PERIOD

from grading.cradles import MIXED, MIXED_CSV
from src import double_collisions, double_cradle, visualize_double_cradle_run
from src.beyond.in_browser import show_double_cradle
from support import shapes
from support.constants import BUFFER, COLOR_MAP, DOUBLE_DT, G, PHI_INIT, R_PARAM, TEXTURE_MAP, THETA_INIT
from support.energy import double_kinetic_energy, double_potential_energy
from support.files.cradle_csv import check_cradle, MOST_TIMES

SAMPLE = 0.01  # s between two measurements of the energy


def make_row(count, theta, phi, **values):
    """Return a row of double pendula, the first one at theta and phi (rad), the others straight down."""
    row = [hang_double(axle=(i * R_PARAM / 4, 0), **values) for i in range(count)]
    row[0]["theta"], row[0]["phi"] = theta, phi
    return row


def energy(pend_list):
    """Return the total energy (J)."""
    return double_kinetic_energy(pend_list, R_PARAM) + double_potential_energy(pend_list, R_PARAM, G)


def tick(pend_list, ticks, dt=DOUBLE_DT, r_param=R_PARAM, g=G):
    """Do `ticks` ticks; return the hits as (tick, left, right): ticks from 0, and indices of pendula."""
    hits = []

    def noting_hits(*arguments):
        pairs = double_collisions.collide_pairs(*arguments)
        hits.append(pairs)
        return pairs

    with patch.object(double_cradle, "collide_pairs", noting_hits):
        for _ in range(ticks):
            double_cradle.double_cradle_tick(pend_list, r_param, dt, g)
    return [(number, *pair) for number, pairs in enumerate(hits) for pair in pairs]


# --- its objects -----------------------------------------------------------------------------------------------------


def check_objects(objects, axle, r_param, theta, phi):
    """Check the positions of axle, bobs and cords; both angles are positive to the right."""
    arm1 = (r_param * sin(theta), -r_param * cos(theta), 0)
    arm2 = (r_param * sin(theta + phi), -r_param * cos(theta + phi), 0)
    box, bob1, cord1, bob2, cord2 = objects
    for place in (box.pos, cord1.pos):
        assert components(place) == pytest.approx(axle)
    for arm in (cord1.axis, bob1.pos - box.pos):
        assert components(arm) == pytest.approx(arm1)
    for arm in (cord2.axis, bob2.pos - bob1.pos, bob2.pos - cord2.pos):
        assert components(arm) == pytest.approx(arm2)


@pytest.mark.parametrize(("theta", "phi"), [(0, 0), (0.7, 0), (0, 0.7), (0.6, -0.4), (-2.0, 3.0)])
@pytest.mark.parametrize("r_param", [0.2, 1.5])
def test_make_double_pendulum(r_param, theta, phi):
    """make_double_pendulum makes the double-pendulum structure with correctly calculated positions."""
    objects = double_cradle.make_double_pendulum(vector(0.3, 0.1, 0), r_param, theta, phi, color.red, textures.wood)
    check_objects(objects, (0.3, 0.1, 0), r_param, theta, phi)
    for bob in (objects[1], objects[3]):
        assert (components(bob.color), bob.texture) == ((1, 0, 0), textures.wood)


def test_make_double_newton_cradle(tmp_path):
    """The first pendulum starts at (theta_init, phi_init), the others hang; each bob has the mass of its row."""
    file = tmp_path / "mixed.csv"
    file.write_text(MIXED_CSV)
    pend_list = double_cradle.make_double_newton_cradle(str(file), 0.4, 0.6, -0.4)
    assert [(pend["theta"], pend["phi"]) for pend in pend_list] == [(0.6, -0.4), (0, 0), (0, 0)]
    for i, (pend, row) in enumerate(zip(pend_list, MIXED, strict=True)):
        assert (pend["omega"], pend["phi_omega"]) == (0, 0)
        assert {key: pend[key] for key in ("mass", "e", "color", "texture")} == {
            key: row[key] for key in ("mass", "e", "color", "texture")
        }
        check_objects(pend["objects"], (-0.1 + 0.4 / 4 * i, 0.4 / 5, 0), 0.4, pend["theta"], pend["phi"])
        for bob in (pend["objects"][1], pend["objects"][3]):
            assert components(bob.color) == components(COLOR_MAP[row["color"]])
            assert bob.texture == TEXTURE_MAP[row["texture"]]


def test_the_single_cradles_objects_become_the_double_ones(tmp_path, monkeypatch):
    """No object is left over: VPython keeps every object until the end."""

    def make_newton_cradle(*arguments):
        pend_list = original(*arguments)
        single.extend(shape for pend in pend_list for shape in pend["objects"])
        return pend_list

    single: list = []
    original = double_cradle.make_newton_cradle
    monkeypatch.setattr(double_cradle, "make_newton_cradle", make_newton_cradle)
    monkeypatch.setattr(shapes, "discarded", defaultdict(list))
    file = tmp_path / "mixed.csv"
    file.write_text(MIXED_CSV)
    pend_list = double_cradle.make_double_newton_cradle(str(file), 0.4, 0.6, -0.4)
    double = [shape for pend in pend_list for shape in pend["objects"]]
    assert {id(shape) for shape in single} <= {id(shape) for shape in double}
    assert all(shape.visible for shape in double)


@pytest.mark.parametrize(("content", "message"), [*UNREADABLE.values(), *NO_CRADLE.values()])
def test_a_bad_csv_is_refused_as_for_the_single_cradle(tmp_path, monkeypatch, capsys, content, message):
    file = tmp_path / "cradle.csv"
    file.write_bytes(content.encode() if isinstance(content, str) else content)
    with pytest.raises(ValueError) as caught:
        double_cradle.make_double_newton_cradle(str(file), R_PARAM, THETA_INIT, PHI_INIT)
    assert str(caught.value) == f"{file}{message}"
    monkeypatch.setattr("sys.argv", ["visualize_double_cradle_run.py", str(file)])
    monkeypatch.setattr("support.page.page.open_page", lambda *_: pytest.fail("a browser was to be opened"))
    with pytest.raises(SystemExit) as ended:
        show_double_cradle(visualize_double_cradle_run.main)
    assert (ended.value.code, *capsys.readouterr()) == (2, "", f"{file}{message}\n")


def test_masses_too_far_apart_are_refused_only_for_the_double_cradle(tmp_path, monkeypatch, capsys):
    rows = [GOOD.replace("1.0", mass, 1) for mass in ("0.5", "500000", "3", ".4")]
    file = tmp_path / "cradle.csv"
    file.write_text(HEADER + "".join(rows[:3]))
    check_cradle(file, cords=2)
    file.write_text(HEADER + "".join(rows))
    check_cradle(file)
    monkeypatch.setattr("sys.argv", ["visualize_double_cradle_run.py", str(file)])
    monkeypatch.setattr("support.page.page.open_page", lambda *_: pytest.fail("a browser was to be opened"))
    with pytest.raises(SystemExit) as ended:
        show_double_cradle(visualize_double_cradle_run.main)
    words = "found '500000', and '.4' in line 5, allowed is at most 1e6 times the smallest mass, in a double cradle"
    assert (ended.value.code, *capsys.readouterr()) == (2, "", f"{file}, line 3, column mass: {words}\n")


# --- the laws of motion ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("sign", "swings"), [(-1, 10), (1, 20)])
def test_the_normal_modes_of_small_swings(sign, swings):
    """Their angular frequencies squared are g/R (2 - sqrt 2) and g/R (2 + sqrt 2), for equal masses.

    For small angles and equal masses the equations of motion are 2 alpha'' + beta'' = -2 g/R alpha and alpha'' + beta''
    = -g/R beta; with alpha = A cos(w t) and beta = B cos(w t), B / A is sqrt 2 or -sqrt 2.
    """
    alpha, beta = 1e-3, -sign * sqrt(2) * 1e-3
    state, crossings, time = (0.0, 0.0, alpha, beta - alpha), [], 0.0
    while len(crossings) <= swings:
        assert time < 60, "it does not swing"
        before = state[2]
        state = double_cradle.double_angle_update(*state, R_PARAM, DOUBLE_DT, G)
        if before > 0 >= state[2]:
            crossings.append(time + DOUBLE_DT * before / (before - state[2]))
        time += DOUBLE_DT
    frequency = 2 * pi * swings / (crossings[-1] - crossings[0])
    assert frequency**2 == pytest.approx(G / R_PARAM * (2 + sign * sqrt(2)), rel=0.001)


def reference(theta, phi, r_param, g, m1, m2, seconds):
    """Return the state of double_angle_update some seconds after release, from Hamilton's equations.

    They have the angles q = (alpha, beta) of the two cords from straight down, and the momenta p = M q'.
    M is in src/double_collisions.py, and L in src/double_cradle.py: p' = dL/dq is
    (-A - (m1 + m2) g R sin(alpha), A - m2 g R sin(beta)), with A = m2 R^2 alpha' beta' sin(alpha - beta).
    """

    def rates(_, state):
        alpha, beta, p1, p2 = state
        c, s = cos(alpha - beta), sin(alpha - beta)
        alpha_rate = (p1 - c * p2) / (r_param**2 * (m1 + m2 * s**2))
        beta_rate = ((m1 + m2) * p2 / m2 - c * p1) / (r_param**2 * (m1 + m2 * s**2))
        a = m2 * r_param**2 * alpha_rate * beta_rate * s
        forces = -a - (m1 + m2) * g * r_param * sin(alpha), a - m2 * g * r_param * sin(beta)
        return alpha_rate, beta_rate, *forces

    solve_ivp = pytest.importorskip("scipy.integrate").solve_ivp
    end = solve_ivp(rates, (0, seconds), (theta, theta + phi, 0, 0), "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    alpha_rate, beta_rate = rates(seconds, end)[:2]
    return alpha_rate, beta_rate - alpha_rate, end[0], end[1] - end[0]


@pytest.mark.parametrize(("m1", "m2"), [(1.0, 1.0), (3.0, 0.5), (0.5, 3.0)])
@pytest.mark.parametrize(("theta", "phi"), [(0.6, -0.4), (2.0, 1.0)])
def test_two_seconds_of_one_double_pendulum(theta, phi, m1, m2):
    """double_angle_update updates both angles, and agrees with the exact equations."""
    state = (0.0, 0.0, theta, phi)
    for _ in range(round(2 / DOUBLE_DT)):
        state = double_cradle.double_angle_update(*state, R_PARAM, DOUBLE_DT, G, m1, m2)
    assert state == pytest.approx(reference(theta, phi, R_PARAM, G, m1, m2, 2), rel=0, abs=1e-3)


@pytest.mark.parametrize(("start", "end"), SWINGS)
def test_the_graded_swings_are_exact(start, end):
    assert reference(*start[:2], LENGTH, 9.81, *start[2:], 0.1) == pytest.approx(end, rel=0, abs=1e-6)


def test_the_masses_are_equal_by_default_and_length_and_gravity_those_given():
    state = (0.0, 0.0, 0.6, -0.4)
    for _ in range(2000):
        state = double_cradle.double_angle_update(*state, 0.5, 1e-3, 3.7)
    assert state == pytest.approx(reference(0.6, -0.4, 0.5, 3.7, 2.0, 2.0, 2), rel=0, abs=1e-3)


@pytest.mark.parametrize("seconds", slow_but_for([6], [6, 60]))
def test_one_double_pendulum_keeps_the_energy(seconds):
    pend_list = make_row(1, 2.5, 1.0)
    at_start = energy(pend_list)
    for _ in range(round(seconds / SAMPLE)):
        tick(pend_list, round(SAMPLE / DOUBLE_DT))
        assert energy(pend_list) == pytest.approx(at_start, rel=1e-6)


def test_double_swing_update_swings_and_shows_one_pendulum():
    pend = hang_double(0.6, -0.4, 3.0, -2.0, mass=2.0, axle=(0.3, 0.1))
    expected = double_cradle.double_angle_update(3.0, -2.0, 0.6, -0.4, R_PARAM, 0.01, G, 2.0, 2.0)
    double_cradle.double_swing_update(pend, R_PARAM, 0.01, G)
    assert [pend[key] for key in ("omega", "phi_omega", "theta", "phi")] == pytest.approx(expected)
    check_objects(pend["objects"], (0.3, 0.1, 0), R_PARAM, pend["theta"], pend["phi"])


def test_a_tick_is_one_step_unless_a_cord_turns_far_in_it(monkeypatch):
    """Five equal pendula, let go from far up: they do what double_angle_update does, to the last bit."""
    steps = []

    def double_angle_update(*arguments):
        steps.append(arguments[5])
        return original(*arguments)

    original = double_cradle.double_angle_update
    monkeypatch.setattr(double_cradle, "double_angle_update", double_angle_update)
    tick(make_row(5, -2.5, 0.5), 1500)
    assert steps == [DOUBLE_DT] * 7500
    steps.clear()
    double_cradle.double_swing_update(hang_double(omega=-500.0), R_PARAM, DOUBLE_DT, G)
    assert len(steps) > 1
    assert sum(steps) == pytest.approx(DOUBLE_DT)


@pytest.mark.parametrize("rates", [(float("inf"), 0.0), (0.0, float("nan")), (float("nan"), 1.0), (1.0, 1e300)])
def test_a_pendulum_that_is_too_fast_is_named(rates):
    pend = hang_double(omega=rates[0], phi_omega=rates[1])
    with pytest.raises(ValueError, match="^a pendulum with omega = .* and phi_omega = .* rad/s is too fast$"):
        double_cradle.double_swing_update(pend, R_PARAM, DOUBLE_DT, G)


# --- hits ------------------------------------------------------------------------------------------------------------


def velocities(pend):
    """Return the velocities of the upper and of the lower bob as (x, y), in m/s."""
    alpha, beta = pend["theta"], pend["theta"] + pend["phi"]
    upper, lower = R_PARAM * pend["omega"], R_PARAM * (pend["omega"] + pend["phi_omega"])
    x, y = upper * cos(alpha), upper * sin(alpha)
    return (x, y), (x + lower * cos(beta), y + lower * sin(beta))


def touching_pair(dice):
    """Return two random double pendula with one pair of bobs that touch and approach each other, the numbers of these
    bobs (0 or 1), and the unit vector from one to the other.
    """
    while True:
        values = [
            {
                **{key: dice.uniform(-pi, pi) for key in ("theta", "phi")},
                **{key: dice.uniform(-20, 20) for key in ("omega", "phi_omega")},
                "mass": 10 ** dice.uniform(-3, 3),
                "e": dice.choice([0, 1, dice.random()]),
            }
            for _ in range(2)
        ]
        direction, bob1, bob2 = dice.uniform(-pi, pi), dice.randint(0, 1), dice.randint(0, 1)
        x, y = cos(direction), sin(direction)
        pend1, pend2 = (hang_double(**of_one) for of_one in values)
        one, other = pend1["objects"][1 + 2 * bob1], pend2["objects"][1 + 2 * bob2]
        axle = one.pos + dice.uniform(0.97, 1) * BUFFER * (one.radius + other.radius) * vector(x, y, 0) - other.pos
        pend2 = hang_double(**values[1], axle=(axle.x, axle.y))
        if [distance < 1 for distance in distances([pend1, pend2])] == [i == 2 * bob1 + bob2 for i in range(4)]:
            if closing_speed(pend1, pend2, bob1, bob2, x, y) < 0:
                turn_back(pend1, pend2)
            return pend1, pend2, bob1, bob2, (x, y)


def turn_back(*pend_list):
    """Reverse the motion of these pendula."""
    for pend in pend_list:
        pend["omega"], pend["phi_omega"] = -pend["omega"], -pend["phi_omega"]


@pytest.mark.parametrize("contacts", slow_but_for([1000], [1000, 10_000]))
def test_random_contacts(contacts):
    """They separate with e times the speed of approach. The energy stays the same at e = 1, and never grows below."""
    dice = random.Random(3)
    for _ in range(contacts):
        pend1, pend2, bob1, bob2, (x, y) = touching_pair(dice)
        angles = [(pend["theta"], pend["phi"]) for pend in (pend1, pend2)]
        approach = closing_speed(pend1, pend2, bob1, bob2, x, y)
        kinetic = double_kinetic_energy([pend1, pend2], R_PARAM)
        assert double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM)
        parting = -closing_speed(pend1, pend2, bob1, bob2, x, y)
        fastest = max(hypot(*velocity) for pend in (pend1, pend2) for velocity in velocities(pend))
        assert parting == pytest.approx(pend1["e"] * approach, rel=0, abs=1e-9 * (fastest + approach))
        kinetic_after = double_kinetic_energy([pend1, pend2], R_PARAM)
        assert kinetic_after <= kinetic * (1 + 1e-9)
        if pend1["e"] == 1:
            assert kinetic_after == pytest.approx(kinetic, rel=1e-9)
        assert [(pend["theta"], pend["phi"]) for pend in (pend1, pend2)] == angles


def test_bobs_at_just_the_distance_touch():
    pend1, pend2 = hang_double(omega=1.0), hang_double()
    pend2["objects"][0].pos.x = BUFFER * (pend1["objects"][1].radius + pend2["objects"][1].radius)
    assert double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM)


def test_lower_bobs_collide_though_the_upper_ones_separate():
    pend1 = hang_double(omega=-1.0, phi_omega=3.0)  # the upper bob goes to the left, the lower one to the right
    pend2 = hang_double(axle=(0.999 * R_PARAM / 4, 0))
    assert double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM)
    assert pend2["omega"] + pend2["phi_omega"] > 0


def test_separating_bobs_are_left_alone():
    dice = random.Random(4)
    for _ in range(100):
        pend1, pend2, *_ = touching_pair(dice)
        turn_back(pend1, pend2)
        before = [dict(pend1), dict(pend2)]
        assert not double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM)
        assert [pend1, pend2] == before


def closing_speed(pend1, pend2, bob1, bob2, x, y):
    """Return the speed (m/s) at which two bobs approach each other along the unit vector (x, y)."""
    (vx1, vy1), (vx2, vy2) = velocities(pend1)[bob1], velocities(pend2)[bob2]
    return (vx1 - vx2) * x + (vy1 - vy2) * y


def test_the_cords_carry_part_of_a_hit_to_the_other_bob():
    """By hand: two double pendula hang straight down; one swings stiffly at 1 rad/s.

    Both cords turn at 1 rad/s: the upper bobs hit with speed R, the lower ones with 2 R. The pendula exchange all
    velocities, as single pendula do: in the velocities of the two bobs, the mass matrix is diagonal.
    """
    pend1, pend2 = hang_double(omega=1.0), hang_double(axle=(0.999 * R_PARAM / 4, 0))
    double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM)
    assert [pend["omega"] for pend in (pend1, pend2)] == pytest.approx([0, 1])
    assert [pend["phi_omega"] for pend in (pend1, pend2)] == pytest.approx([0, 0])


def test_an_upper_bob_that_is_hit_draws_its_lower_one_along():
    """By hand: the hit is at a right angle to the upper cord, along the lower cord, so both bobs take part.

    The lower bob of the other pendulum is right above its upper bob, so the hit does not change its velocity. So a mass
    of 1 hits a mass of 2.
    """
    hit = hang_double(phi=pi / 2, axle=(0.999 * R_PARAM / 4, 0))
    hitting = hang_double(omega=1.0, phi=-pi, phi_omega=-1.0)  # both its bobs move at R, its lower cord does not turn
    assert double_collisions.handle_two_double_bobs(hitting, hit, R_PARAM)
    (x1, _), _ = velocities(hitting)
    (x2, _), (x3, _) = velocities(hit)
    assert [x1, x2, x3] == pytest.approx([-R_PARAM / 3, 2 / 3 * R_PARAM, 2 / 3 * R_PARAM])


def test_bobs_that_do_not_touch_are_left_alone():
    row = make_row(2, 0.0, 0.0, omega=3.0)
    row[1]["omega"] = 0.0
    assert not double_collisions.handle_two_double_bobs(*row, R_PARAM)
    assert [pend["omega"] for pend in row] == [3.0, 0.0]


@pytest.mark.parametrize("bob", [0, 1])
def test_the_radii_count(bob):
    """Only the two bobs with different sizes touch."""
    row = make_row(2, 0.0, 0.0)
    row[0]["omega"] = 3.0
    row[1]["objects"][1 + 2 * bob].radius *= 1.1
    assert double_collisions.handle_two_double_bobs(*row, R_PARAM)
    rates = [[pend["omega"], pend["phi_omega"]] for pend in row]
    assert rates == [pytest.approx(expected) for expected in ([[0, 6], [3, -6]] if bob == 0 else [[3, -6], [0, 6]])]


@pytest.mark.parametrize("larger", [0, 1])
def test_an_upper_and_a_lower_bob_touch_by_their_own_radii(larger):
    """The second pendulum hangs one cord higher: its lower bob is beside the upper bob of the first one."""
    pair = hang_double(omega=1.0), hang_double(axle=(R_PARAM / 4, R_PARAM))
    assert not double_collisions.handle_two_double_bobs(*pair, R_PARAM)
    pair[larger]["objects"][3 if larger else 1].radius *= 1.1
    assert double_collisions.handle_two_double_bobs(*pair, R_PARAM)
    assert (pair[1]["omega"], pair[1]["phi_omega"]) == pytest.approx((0, 1))


@pytest.mark.parametrize("approaching_only", [True, False])
def test_separating_bobs_collide_only_if_they_are_to(approaching_only):
    """This holds for a pair, and for a tick."""
    for tick in (False, True):
        pend1, pend2 = hang_double(e=0.5), hang_double(omega=1.0, axle=(0.999 * R_PARAM / 4, 0))
        if tick:
            double_cradle.double_cradle_tick([pend1, pend2], R_PARAM, 1e-9, G, approaching_only=approaching_only)
        else:
            double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM, approaching_only=approaching_only)
        assert pend2["omega"] - pend1["omega"] == pytest.approx(1 if approaching_only else -0.5)


@pytest.mark.parametrize("approaching_only", [True, False])
def test_bobs_that_move_together_do_not_hit(approaching_only):
    pend1, pend2 = hang_double(omega=1.0), hang_double(omega=1.0, axle=(0.999 * R_PARAM / 4, 0))
    assert not double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM, approaching_only)


def test_bobs_in_one_place_have_no_line_of_centres_and_are_left_alone():
    pend1, pend2 = hang_double(omega=1.0), hang_double()
    assert not double_collisions.handle_two_double_bobs(pend1, pend2, R_PARAM)
    assert (pend1["omega"], pend2["omega"]) == (1.0, 0.0)


# --- the cradle ------------------------------------------------------------------------------------------------------


STARTS = [(THETA_INIT, PHI_INIT, 20), (THETA_INIT, PHI_INIT, 3), (-0.8, -0.8, 6), (-1.2, 0.5, 6)]


@pytest.mark.parametrize(("theta", "phi", "seconds"), slow_but_for([(THETA_INIT, PHI_INIT, 3)], STARTS))
def test_twenty_seconds_of_five_elastic_double_pendula(monkeypatch, theta, phi, seconds):
    """The energy stays the same, and neighbouring bobs never come closer than 0.97 of the contact distance.

    The shorter tests suffice for other angles: bobs come closest in the first seconds.
    """
    closest = []

    def touching_bobs(*arguments):
        for touch in original(*arguments):
            closest.append(touch.distance / touch.touching)
            yield touch

    original = double_collisions.touching_bobs
    monkeypatch.setattr(double_collisions, "touching_bobs", touching_bobs)
    pend_list = make_row(5, theta, phi)
    at_start, hits = energy(pend_list), 0
    for _ in range(round(seconds / SAMPLE)):
        hits += len(tick(pend_list, round(SAMPLE / DOUBLE_DT)))
        assert energy(pend_list) == pytest.approx(at_start, rel=1e-6)
        closest.append(min(distances(pend_list)))  # from VPython's objects
    assert min(closest) > 0.98  # the limit is 0.97
    assert hits > 13.5 * seconds / PERIOD


@pytest.mark.parametrize("seconds", slow_but_for([0.5], [0.5, 1.5]))
def test_masses_far_apart_keep_the_energy(seconds):
    """A bob of a gram is squeezed between two heavy ones, and turns by a radian in a tick."""
    pend_list = make_row(5, -124 * pi / 180, 29 * pi / 180)
    for pend, mass in zip(pend_list, (52000, 0.001, 0.36, 12, 2400), strict=True):
        pend["mass"] = mass
    at_start = energy(pend_list)
    for _ in range(round(seconds / SAMPLE)):
        tick(pend_list, round(SAMPLE / DOUBLE_DT))
        assert energy(pend_list) == pytest.approx(at_start, rel=1e-5)


@pytest.mark.parametrize("cradles", slow_but_for([2], [2, 30]))
def test_random_masses_in_the_range_of_a_csv_gain_nothing(cradles):
    """By both rules; the masses of neighbours often differ by the largest ratio."""
    dice = random.Random(31)
    for number in range(cradles):
        count = dice.randint(3, 5)
        masses = [MOST_TIMES ** dice.choice([0, 1, dice.random()]) for _ in range(count)]
        es = [dice.choice([1, 1, dice.random()]) for _ in range(count)]
        pend_list = make_row(count, -dice.uniform(0.8, 2.5), dice.uniform(-1, 1))
        for pend, mass, e in zip(pend_list, masses, es, strict=True):
            pend.update(mass=mass, e=e)
        at_start = least = energy(pend_list)
        for _ in range(2000):
            double_cradle.double_cradle_tick(pend_list, R_PARAM, DOUBLE_DT, G, number % 3 > 0)
            assert energy(pend_list) <= least + 1e-4 * at_start
            least = min(least, energy(pend_list))


def test_bobs_that_lie_on_one_another_do_not_sink_in_and_gain_nothing():
    """Two inelastic pendula with axles closer than one bob diameter lean against each other for ever."""
    pend1, pend2 = hang_double(-0.1, 0.0, e=0.0), hang_double(0.1, 0.0, e=0.0, axle=(R_PARAM / 10, 0))
    at_start = least = energy([pend1, pend2])
    closest, hits = [], 0
    for _ in range(round(5 / SAMPLE)):
        hits += len(tick([pend1, pend2], round(SAMPLE / DOUBLE_DT)))
        closest.append(min(distances([pend1, pend2])))
        assert energy([pend1, pend2]) <= least + 1e-9 * at_start
        least = min(least, energy([pend1, pend2]))
    assert hits > 10_000
    assert min(closest) > 0.97


@pytest.mark.parametrize(("e", "apart", "expected"), [(0.5, 0.97, 0.98), (1, 0.97, 0.97), (0.5, 0.9, 0.9)])
def test_bobs_that_lie_on_one_another_are_moved_apart(e, apart, expected):
    """To 0.98 of the contact distance, but not elastic bobs, and not bobs that a person put so close."""
    pend1, pend2 = hang_double(0.3, 0.4, omega=0.1, e=e), hang_double(0.3, -0.5, omega=-0.1, axle=(0.1, 0.0))
    bob1, bob2 = pend1["objects"][3], pend2["objects"][3]
    direction = (bob2.pos - bob1.pos).hat
    shift = bob1.pos + apart * BUFFER * (bob1.radius + bob2.radius) * direction - bob2.pos
    pend2 = hang_double(0.3, -0.5, omega=-0.1, axle=(0.1 + shift.x, shift.y))
    if closing_speed(pend1, pend2, 1, 1, direction.x, direction.y) < 0:
        turn_back(pend1, pend2)
    double_cradle.double_cradle_tick([pend1, pend2], R_PARAM, 1e-9, G)
    assert min(distances([pend1, pend2])) == pytest.approx(expected, abs=1e-4)


def test_bobs_that_their_cords_hold_back_are_not_moved_apart():
    """One hangs straight down above the other, which stands on its cord: only a large turn would separate them."""
    pend1, pend2 = hang_double(1e-3, pi, e=0.0), hang_double(pi, pi, omega=1e-3, e=0.0, axle=(0.0, -0.45))
    upper, standing = pend1["objects"][1], pend2["objects"][1]
    lower_by = standing.pos.y - upper.pos.y + 0.97 * BUFFER * 2 * upper.radius
    pend2 = hang_double(pi, pi, omega=1e-3, e=0.0, axle=(0.0, -0.45 - lower_by))
    before = [(pend["theta"], pend["phi"]) for pend in (pend1, pend2)]
    double_collisions.keep_apart(pend1, pend2, R_PARAM)
    assert [(pend["theta"], pend["phi"]) for pend in (pend1, pend2)] == before


def test_inelastic_bobs_that_begin_in_each_other_gain_nothing():
    """For example at theta = 0, phi = -14 degrees, where the lower bobs overlap."""
    pend_list = make_row(3, 0.0, 14 * pi / 180, e=0.0)
    least = energy(pend_list)
    for _ in range(200):
        tick(pend_list, 20)
        assert energy(pend_list) <= least * 1.001
        least = min(least, energy(pend_list))


def test_a_tick_swings_and_then_handles_each_pair():
    """The pairs are handled from left to right: a hit runs through a whole row in one tick."""
    pend_list = [hang_double(axle=(i * 0.999 * R_PARAM / 4, 0)) for i in range(5)]
    pend_list[0]["omega"] = 1.0
    double_cradle.double_cradle_tick(pend_list, R_PARAM, 1e-7, G)
    assert [pend["omega"] for pend in pend_list] == pytest.approx([0, 0, 0, 0, 1], abs=1e-3)
    for i, pend in enumerate(pend_list):
        check_objects(pend["objects"], (i * 0.999 * R_PARAM / 4, 0, 0), R_PARAM, pend["theta"], pend["phi"])


@pytest.mark.parametrize("larger", [0, 1])
def test_a_tick_finds_bobs_of_any_size(larger):
    pend_list = make_row(2, 0.0, 0.0)
    pend_list[0]["omega"] = 3.0
    pend_list[larger]["objects"][3].radius *= 1.1
    assert tick(pend_list, 1, 1e-9) == [(0, 0, 1)]


def test_a_cradle_without_pendula_has_no_hits():
    assert tick([], 10) == []


def test_bobs_that_come_to_touch_in_a_tick_hit_at_its_end():
    pend_list = make_row(2, 0.0, 0.0)
    pend_list[0]["omega"] = 3.0
    assert tick(pend_list, 1, 1e-3) == [(0, 0, 1)]


def test_a_hit_that_sets_off_another_one_to_the_left_does_so_in_its_tick():
    """A hit from the right moves on by one pair per sweep."""
    pend_list = [hang_double(axle=(i * 0.999 * R_PARAM / 4, 0)) for i in range(3)]
    pend_list[2]["omega"] = -1.0
    assert tick(pend_list, 1, 1e-7) == [(0, 1, 2), (0, 0, 1)]
    assert [pend["omega"] for pend in pend_list] == pytest.approx([-1, 0, 0], abs=1e-3)


def test_a_cradle_of_twice_the_size_in_twice_the_gravity_moves_alike():
    """The equations have only g/R, and the bobs touch at the same angles."""
    cradles = []
    for scale in (1, 2):
        r_param = scale * R_PARAM
        pend_list = [hang_double(axle=(i * r_param / 4, 0), e=0.7, r_param=r_param) for i in range(3)]
        pend_list[0].update(theta=-0.8, phi=0.3)
        hits = tick(pend_list, 2000, DOUBLE_DT, r_param, scale * G)
        cradles.append([hits, *([pend[key] for key in ("theta", "phi", "omega", "phi_omega")] for pend in pend_list)])
    assert cradles[0] == cradles[1]
    assert cradles[0][0]


def test_not_only_neighbours_collide():
    """The lower bobs of the first and the third pendulum hit, while the second one is lifted out of the way."""
    pend_list = [hang_double(axle=(i * R_PARAM / 8, 0)) for i in range(3)]
    pend_list[1]["theta"] = pi
    pend_list[0]["omega"] = 1.0
    double_cradle.double_cradle_tick(pend_list, R_PARAM, 1e-4, G)
    double_cradle.double_cradle_tick(pend_list, R_PARAM, 1e-9, G)
    assert pend_list[2]["phi_omega"] == pytest.approx(2, abs=0.01)  # the lower cord alone takes over the speed 2 R


def test_the_first_one_comes_down_and_hits_go_along_the_row():
    hits = tick(make_row(3, -0.8, 0.3, e=0.7), 4000)
    assert hits[0][0] > 100
    assert hits[0][1:] == (0, 1)
    assert {(left, right) for _, left, right in hits} == {(0, 1), (1, 2)}


# --- the page --------------------------------------------------------------------------------------------------------


class TestPage:
    """In a real Chromium."""

    pytestmark = needs_vpython

    def test_it_starts_moves_pauses_restarts_and_ends_with_the_tab(self, page, program):
        (program.parents[1] / "newton_cradle_pends.csv").write_text(HEADER + GOOD * 3)
        with running(program.with_name("visualize_double_cradle_run.py")) as process:
            open_cradle(page, first_lines(process), bobs=6)
            at_rest = [[-0.1 + R_PARAM / 4 * i, R_PARAM / 5 - R_PARAM * cord] for i in range(3) for cord in (1, 2)]
            wait_until(lambda: bobs_on(page)[-1][0] > at_rest[-1][0] + R_PARAM / 4)  # the last one had a hit
            pause(page)
            assert page.evaluate(MOVES) == 0
            press(page, "Restart")
            wait_until(lambda: readout(page, "t") == 0)
            alpha, beta = THETA_INIT, THETA_INIT + PHI_INIT
            x, y = -0.1 + R_PARAM * sin(alpha), R_PARAM / 5 - R_PARAM * cos(alpha)
            lifted = [[x, y], [x + R_PARAM * sin(beta), y - R_PARAM * cos(beta)]]
            expected = [pytest.approx(bob, abs=1e-6) for bob in sorted(lifted + at_rest[2:])]
            wait_until(lambda: bobs_on(page) == expected)
            press(page, "Run")
            wait_until(lambda: readout(page, "t") > 0.3)
            page.close()
            assert end(process) == QUIETLY


def bobs_on(page):
    """Return the positions of the bobs (x, y in m), from left to right, and from the bottom up."""
    return sorted(page.evaluate(BOBS))
