"""C checks: one pendulum swings, then all pendula swing."""

from math import pi, sin

import grading.begin

from vpython import vector

from grading.checks import check
from grading.cradles import ends_like, hang, LEFT_OVER, left_over, R, see_each, shapes, touching
from grading.grader import expect
from grading.messages import Expected
from grading.subject import Each
from support.pendulum import arm

STEPS = {
    "angle_update": "the acceleration from g, theta and r_param; omega plus its change in dt; "
    "theta plus its change, with the new omega; return both.",
    "full_swing_update": "one loop over pend_list calls swing_update for each pendulum.",
}

# The arguments omega, theta, r_param, dt, g; omega after the step, and the change of theta; by hand
# from the two formulas of the physics.
STEP = (3.0, 5 * pi / 6, 0.4, 0.1, 8.0), 2.0, 0.2  # omega falls by 1
OTHER_SWINGS = [
    ((2.0, -pi / 6, 0.5, 0.1, 10.0), 3.0, 0.3),  # on the left, gravity pulls to the right
    ((1.5, 0.0, 0.2, 0.01, 9.81), 1.5, 0.015),  # straight down, gravity does not turn it
    # More than 90 degrees: sin, not the angle itself
    ((1.0, -5 * pi / 6, 0.25, 0.2, 5.0), 3.0, 0.6),
    # A small angle is not its own sine
    ((0.0, 0.05, 0.5, 0.1, 10.0), -0.09995833854, -0.00999583385),
    # It may go full circles, in both directions
    ((200.0, 3 * pi / 2, 0.5, 0.1, 10.0), 202.0, 20.2),
    ((-9.0, -3 * pi, 0.5, 1.0, 10.0), -9.0, -9.0),
    ((4e-8, 0.0, 0.5, 0.1, 10.0), 4e-8, 4e-9),  # very slowly
    ((1.0, pi / 6, 0.5, 0.0, 10.0), 1.0, 0.0),  # no time, no change
    ((1.0, pi / 6, 0.5, 0.1, 0.0), 1.0, 0.1),  # no gravity: theta still moves with omega
    # Whole numbers: an array of them would cut off the results
    ((0, 1, 0.5, 0.1, 10.0), -1.6829419696, -0.16829419696),
]


# Wrong results of the first step, and what they are.
DEGREES = (
    "This is the result with degrees. theta is in radians already, as sin() takes it. Do not "
    "convert it."
)
RESULTS = [
    (
        (2.0, 2.917993878),
        "This is the result with the old omega in the change of theta. Take the new one.",
    ),
    (
        (4.0, 3.017993878),
        "This is the result with + in front of the acceleration. Gravity pulls the bob back "
        "down: -.",
    ),
    ((2.908647, 2.908858878), DEGREES),
    ((4.429753, 3.060968878), DEGREES),
    ((4.732051, 3.091198878), "This is the result with cos in place of sin."),
    ((-2.235988, 2.394394878), "This is the result with theta in place of its sine."),
    ((-7.0, 1.917993878), "This is the result without dt in the change of omega."),
    ((2.0, 4.617993878), "This is the result without dt in the change of theta."),
    ((2.6, 2.877993878), "This is the result without r_param: the acceleration is divided by it."),
    (
        (2.84, 2.901993878),
        "This is the result if r_param multiplies. The acceleration is divided by it.",
    ),
    (
        (2.55652, 2.917993878),
        "This is the result if theta changes first. omega changes first, then theta.",
    ),
    (
        (-1.0, 2.517993878),
        "This is the result without the old omega: the new one is the old one plus its change.",
    ),
    (
        (-10.0, 1.617993878),
        "This is the acceleration in place of the new omega: the old omega plus acceleration * dt.",
    ),
    (
        (2.0, 2.867993878),
        "This is the result with an average. Only the new omega moves theta: no 1/2 a t^2.",
    ),
]


def check_step(arguments, omega_new, change, **options):
    """Check the result of angle_update.

    A student reads the parts of both formulas, which follow from the result.
    """
    omega, theta, _, dt, _ = arguments
    theta_new = theta + change
    right = [("sin(theta)", sin(theta)), ("omega_new", omega_new), ("theta_new", theta_new)]
    if dt:
        right.insert(1, ("acceleration", (omega_new - omega) / dt))
    expect("angle_update", *arguments, expected=(omega_new, theta_new), right=right, **options)


@check("angle_update")
def test_angle_update():
    """Gravity changes omega, then the new omega moves theta."""
    check_step(*STEP, results=RESULTS)


@check("angle_update")
def test_angle_update_of_other_swings():
    """A step is right at all angles, fast or slow, also without gravity."""
    for swing in OTHER_SWINGS:
        check_step(*swing)


# theta, omega, mass and e of pendula, their omega after 0.1 s with g = 10 m/s^2 and cords of 0.5 m,
# and the change of theta. They are not sorted.
SWINGING = [
    ((pi / 6, 2.0, 2.0, 0.5), 1.0, 0.1),
    ((pi / 2, 0.0, 1.0, 0.25), -2.0, -0.2),
    ((-pi / 6, 2.0, 3.0, 0.75), 3.0, 0.3),
    ((0.0, 1.5, 3.0, 1.0), 1.5, 0.15),
    ((0.0, 0.0, 1.0, 0.5), 0.0, 0.0),
    ((0.0, 4e-8, 3.0, 0.5), 4e-8, 4e-9),
    ((7 * pi / 2, 20.0, 2.0, 0.5), 22.0, 2.2),
    ((-5 * pi / 2, -5.0, 2.0, 0.5), -3.0, -0.3),
]


def swinging_row(count):
    """Return count pendula, and their (omega, theta) after the swing: SWINGING, again and again."""
    pend_list = []
    after = []
    for i in range(count):
        values, omega, change = SWINGING[i % len(SWINGING)]
        pend_list.append(hang(*values, axle=(7 * i % 10 * 0.1, 0.05, 0), r_param=0.5))
        after.append((omega, values[0] + change))
    return pend_list, after


def expect_swing(pend_list, **options):
    """Check what full_swing_update does in 0.1 s with g = 10 m/s^2 and cords of 0.5 m."""
    expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, **options)


@check("full_swing_update")
def test_every_pendulum_swings_once():
    """Each pendulum swings exactly once, also in a long or empty pend_list."""
    for count in (3, 10, 40):
        pend_list, after = swinging_row(count)
        expect_swing(pend_list, expected=after, **see_each(pend_list, "omega", "theta"))
    expect_swing([], expected=Expected("no error for an empty pend_list", lambda _: True))


@check("full_swing_update")
def test_bobs_and_cords_move():
    """The same bob and cord move to the new theta; the axle stays."""
    pend_list, after = swinging_row(3)
    objects = [pend["objects"] for pend in pend_list]

    places = []  # of the axle and the bob
    parts = []
    for (axle, bob, cord), (_, theta) in zip(objects, after, strict=True):
        places.append((vector(axle.pos), axle.pos + arm(theta, 0.5)))
        parts += [axle, bob, cord]

    def see(_):
        found = []
        for (axle, bob, cord), (upper, lower) in zip(objects, places, strict=True):
            found.append((axle.pos, bob.pos, *ends_like(cord, upper, lower)))
        return found

    names = (
        "position of the axle",
        "position of the bob",
        "end at the axle of the cord",
        "end at the bob of the cord",
    )
    what = Each(names, name="axle, bob and ends of the cord of each pendulum")
    old = shapes()
    expect_swing(pend_list, expected=[pair * 2 for pair in places], see=see, what=what)
    expect_swing(pend_list, see=lambda _: left_over(old, parts), **LEFT_OVER)


@check("full_swing_update")
def test_a_swing_changes_nothing_else():
    """Each pendulum keeps its objects, and all values but omega and theta."""
    pend_list, _ = swinging_row(3)

    def kept(pend):
        values = {key: pend[key] for key in ("mass", "e", "color", "texture")}
        values["radius of the bob"] = pend["objects"][1].radius
        return {**values, **dict(zip(PARTS, pend["objects"], strict=True))}

    before = [*map(kept, pend_list)]
    for values in before:
        for part in PARTS:
            values[part] = as_before(values[part])
    pendula = [*map(as_before, pend_list)]
    expect_swing(pend_list, expected=pendula, see=lambda _: pend_list, what=Each(()))
    expect_swing(pend_list, expected=before, see=lambda _: [*map(kept, pend_list)], what=Each(()))


PARTS = "axle", "bob", "cord"


def as_before(thing):
    """Return the expectation of this dictionary, or of this object."""
    return Expected("the same one as before", lambda now: now is thing)


@check("full_swing_update")
def test_a_swing_is_no_collision():
    """Bobs that touch only swing: they do not collide here."""
    omegas = [1.0, -1.0, 0.5]
    pend_list = touching(*omegas)
    states = see_each(pend_list, "omega")
    expect("full_swing_update", pend_list, R, 1e-9, 9.81, expected=omegas, **states)


# What angle_update gives, by its arguments
STEPPED = {}
for (theta, omega, *_), omega_new, change in SWINGING:
    STEPPED[omega, theta, 0.5, 0.1, 10.0] = omega_new, theta + change


@check("full_swing_update", angle_update=lambda *arguments: STEPPED.get(arguments, (7.0, 8.0)))
def full_swing_update_alone():
    """Each pendulum gets the omega and theta that angle_update gives for its values."""
    test_every_pendulum_swings_once()
    test_bobs_and_cords_move()
    test_a_swing_changes_nothing_else()
