"""Honor roll checks: the objects of a double pendulum, and its swing."""

from math import pi

import grading.begin

from vpython import box, cylinder, sphere, textures, vector

from grading.checks import check
from grading.cradles import ends_like, LEFT_OVER, left_over, shapes, within
from grading.grader import expect
from grading.messages import Expected
from grading.subject import Several, Subject
from support.pendulum import arm, make_pendulum

STEPS = {
    "make_double_pendulum": "make_pendulum for the upper one; make_bob_and_cord from the upper "
    "bob, with the angle from straight down; five objects are returned.",
    "double_angle_update": "alpha, beta and their rates; double_accelerations; the new rates, then "
    "the new angles; back to theta and phi.",
}

AXLE = vector(0.3, 0.1, 0)  # m
CORD = 0.5  # m
RED = vector(1, 0, 0)


def check_double_pendulum(
    see, what, expected, theta=0.7, phi=0.4, texture=textures.wood, **options
):
    """Check what see(objects) returns for a double pendulum; options are those of expect."""
    angles = f"the upper cord is at {theta:g}, and the lower one at {theta + phi:g}"
    options = {"help": f"From straight down, {angles}.", **options}
    expect(
        "make_double_pendulum",
        AXLE,
        CORD,
        theta,
        phi,
        RED,
        texture,
        expected=expected,
        see=see,
        what=what,
        **options,
    )


@check("make_double_pendulum")
def test_a_double_pendulum_has_an_axle_two_bobs_and_two_cords():
    """It returns all parts that it makes: axle, bob1, cord1, bob2, cord2."""
    kinds = box, sphere, cylinder, sphere, cylinder

    def are_parts(found):
        return isinstance(found, tuple) and len(found) == 5 and all(map(isinstance, found, kinds))

    parts = "a tuple of axle, upper bob, upper cord, lower bob and lower cord"
    expected = Expected(parts, are_parts, like=(None,) * 5)
    order = "Five objects come back, in this order: axle, bob1, cord1, bob2, cord2."
    check_double_pendulum(None, None, expected, help=order)
    old = shapes()
    check_double_pendulum(lambda objects: left_over(old, objects), **LEFT_OVER)


@check("make_double_pendulum")
def test_bobs_are_where_the_angles_say():
    """Axle and bobs are where axle_pos, theta, phi and r_param put them."""

    def see(objects):
        axle, bob1, _, bob2, _ = objects
        return axle.pos, bob1.pos, bob2.pos

    what = Several(
        (Subject("position", "axle"), Subject("position", "bob1"), Subject("position", "bob2"))
    )
    # theta, phi, and by hand the lower cord's angle from straight down
    for theta, phi, beta in (
        (0.7, 0.4, 1.1),
        (0, 0, 0),
        (0.6, -0.4, 0.2),
        (-2.0, 3.0, 1.0),
        (3.5, 1.0, 4.5),
        (-7.0, -9.0, -16.0),
    ):
        upper = arm(theta, CORD)
        lower = arm(beta, CORD)
        expected = AXLE, AXLE + upper, AXLE + upper + lower
        right = [("bob1 - axle", upper), ("bob2 - bob1", lower)]
        right += zip(("bob1", "bob2"), expected[1:], strict=True)
        check_double_pendulum(see, what, expected, theta, phi, right=right)


@check("make_double_pendulum")
def test_cords_hold_the_bobs():
    """cord1 joins the axle and bob1, cord2 joins both bobs."""

    joint = AXLE + arm(0.7, CORD)
    end = joint + arm(1.1, CORD)

    def see(objects):
        _, _, cord1, _, cord2 = objects
        return (*ends_like(cord1, AXLE, joint), *ends_like(cord2, joint, end))

    what = Several(
        (
            Subject("end at the axle", "cord1"),
            Subject("end at the bob", "cord1"),
            Subject("end at the upper bob", "cord2"),
            Subject("end at the lower bob", "cord2"),
        ),
        "ends of cord1, ends of cord2",
    )
    check_double_pendulum(see, what, (AXLE, joint, joint, end))


@check("make_double_pendulum")
def test_both_bobs_have_the_looks_that_are_given():
    """Both bobs show the given color and texture, in the usual size."""

    looks = "color", "texture", "radius", "visible"

    def see(objects):
        bobs = objects[1::2]
        return tuple(getattr(bob, look) for bob in bobs for look in looks)

    what = Several(
        tuple(Subject(look, bob) for bob in ("bob1", "bob2") for look in looks),
        f"{', '.join(looks)} of bob1, then of bob2",
    )
    radius = make_pendulum(AXLE, CORD, 0, RED, None)[1].radius
    for texture in (textures.wood, None):
        expected = (RED, texture, radius, True) * 2
        check_double_pendulum(see, what, expected, texture=texture)


LENGTH = 0.5  # m
DT = 1e-6  # s
G = 10.0  # m/s^2: g / R is 20 / s^2

# omega_theta, omega_phi, theta, phi, and the accelerations of theta and of phi (rad/s^2), by hand,
# for equal masses.
ACCELERATIONS = [
    ((0.0, 0.0, pi / 6, pi / 3), (-5.71, -11.43)),  # at rest: -40 / 7 and -80 / 7
    # The upper cord hangs straight down, the lower one is level
    ((0.0, 0.0, 0.0, pi / 2), (0.0, -20.0)),
    # Both cords are level: the upper one falls, the lower one stays level
    ((0.0, 0.0, pi / 2, 0.0), (-20.0, 20.0)),
    # The upper cord is level, the lower one hangs straight down
    ((0.0, 0.0, pi / 2, -pi / 2), (-20.0, 20.0)),
    # The lower cord is level and turns: it pulls the upper bob
    ((0.0, 2.0, 0.0, pi / 2), (2.0, -22.0)),
    # The upper bob moves and pulls the lower cord, which is level
    ((2.0, -2.0, 0.0, pi / 2), (0.0, -24.0)),
]


PHI = "phi counts from the direction of the upper cord, and omega_phi is its rate."
EVENLY = (
    "phi is 0, or full turns: both cords are in one line. There is no gravity, so the pendulum "
    "turns evenly."
)


def expect_update(*arguments, help="", **options):
    """Check the result of double_angle_update, as expect does."""
    expect("double_angle_update", *arguments, help=f"{help} {PHI}".lstrip(), **options)


@check("double_angle_update")
def test_both_angles_are_updated():
    """With dt = 0, nothing moves; a straight pendulum without gravity turns evenly."""
    counted = (
        "This is the result if phi is measured from straight down. It is measured from the "
        "upper cord; omega_phi, too."
    )
    results = [((3.0, 1.0, 0.6, 0.2), counted)]
    rest = "With dt = 0, nothing moves."
    for state in ((3.0, -2.0, 0.6, -0.4), (4e-8, -4e-8, 0.6, -0.4)):
        expect_update(*state, LENGTH, 0.0, G, expected=state, help=rest, results=results)
    for omega, before, after, phi in (
        (3.0, 0.6, 0.9, 0.0),
        (3, 1, 1.3, 0),  # whole numbers
        (20.0, 11.0, 13.0, 4 * pi),
        (20.0, 11.0, 13.0, -6 * pi),
        (-20.0, -11.0, -13.0, 0.0),
    ):
        turned = omega, 0.0, after, phi
        expect_update(omega, 0, before, phi, LENGTH, 0.1, 0.0, expected=turned, help=EVENLY)


@check("double_angle_update")
def test_the_accelerations_are_those_of_the_laws_of_motion():
    """In a tiny dt, omega_theta and omega_phi change by the right accelerations."""
    for state, expected in ACCELERATIONS:
        check_accelerations(state, expected, LENGTH, G)
        check_accelerations(state, expected, 2.0, 40.0)


def check_accelerations(state, expected, length, g):
    """Check how both rates change in a short time, at this state."""

    def see(found):
        changes = []
        for new, old in zip(found[:2], state[:2], strict=True):
            changes.append(round((new - old) / DT, 2) + 0)  # no -0
        return tuple(changes)

    omega_theta, omega_phi, theta, phi = state
    angles = f"alpha = {theta:g}, beta = {theta + phi:g}"
    rates = f"their rates are {omega_theta:g} and {omega_theta + omega_phi:g}"
    expect_update(
        *state,
        length,
        DT,
        g,
        expected=expected,
        see=see,
        what=Several((Subject("change of omega_theta / dt"), Subject("change of omega_phi / dt"))),
        results=RESULTS,
        help=f"{angles}, {rates}, k = g/R = {g / length:g}, and mu = m2/(m1 + m2) = 0.5.",
    )


# Wrong accelerations of the first state, and what they are.
SINGLE = (
    "These are the accelerations of two single pendula. Each one pulls at the other: call "
    "double_accelerations."
)
BETA = "This is beta'' in place of that of phi. phi is beta - alpha: subtract alpha''."
RESULTS = [((-10.0, -17.32), SINGLE), ((-10.0, -10.0), SINGLE), ((-5.71, -17.14), BETA)]


# theta, phi, m1, m2, and the state 0.1 s after release, with g = 9.81 m/s^2, from the exact
# equations.
SWINGS = [
    ((0.6, -0.4, 1.0, 1.0), (-1.573797, 2.649524, 0.520225, -0.265745)),
    ((1.5, 1.0, 1.0, 1.0), (-1.870015, 1.553220, 1.405265, 1.083369)),
    ((0.6, -0.4, 3.0, 0.5), (-1.168263, 1.860605, 0.540727, -0.305433)),
    ((1.2, 0.6, 0.5, 3.0), (-1.022774, -0.073444, 1.145768, 0.602682)),
    ((2.0, 4.0, 1.0, 1.0), (-2.008922, 1.406485, 1.898742, 4.066541)),
    ((-4.0, 9.0, 1.0, 1.0), (-1.126101, 1.943725, -4.054955, 9.098001)),
]


@check("double_angle_update")
def test_a_tenth_of_a_second_of_swinging():
    """After 0.1 s in short steps, all four values are nearly exact."""
    for (theta, phi, m1, m2), end in SWINGS:
        # The steps are short enough for every method of the first order
        arguments = 0.0, 0.0, theta, phi, LENGTH, 5e-4, 9.81, m1, m2
        expect_update(
            *arguments,
            expected=tuple(within(0.005, value) for value in end),
            times=200,
            right=[("k", 9.81 / LENGTH), ("mu", m2 / (m1 + m2))],
        )
