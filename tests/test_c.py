"""C checks: one pendulum swings, then all pendula swing."""

from math import cos, pi, sin

from vpython import vector

from grading.cradles import hang, R, row
from grading.grader import check, expect, same
from grading.telling import Wanted

# The arguments omega, theta, r_param, dt, g, and the result; by hand from the two formulas of the appendix.
STEP, AFTER = (2.0, 5 * pi / 6, 0.4, 0.1, 8.0), (1.0, 5 * pi / 6 + 0.1)  # omega falls by 1
STEPS = [
    ((2.0, -pi / 6, 0.5, 0.1, 10.0), (3.0, -pi / 6 + 0.3)),  # on the left, gravity pulls to the right
    ((0.0, pi / 2, 2.0, 0.01, 9.8), (-0.049, pi / 2 - 0.00049)),  # from rest, cord level
    ((1.5, 0.0, 0.2, 0.01, 9.81), (1.5, 0.015)),  # straight down, gravity does not turn it
    ((0.0, 0.0, 0.2, 0.01, 9.81), (0.0, 0.0)),  # it stays at rest
    ((1.0, pi, 0.3, 0.5, 9.81), (1.0, pi + 0.5)),  # straight up, gravity does not turn it either
    ((-1.0, 5 * pi / 6, 0.25, 0.2, 5.0), (-3.0, 5 * pi / 6 - 0.6)),  # more than 90 degrees: sin, not the angle itself
    ((1.0, -5 * pi / 6, 0.25, 0.2, 5.0), (3.0, -5 * pi / 6 + 0.6)),
    ((20.0, 3 * pi / 2, 0.5, 0.1, 10.0), (22.0, 3 * pi / 2 + 2.2)),  # it may go full circles, in both directions
    ((-9.0, -3 * pi, 0.5, 1.0, 10.0), (-9.0, -3 * pi - 9.0)),
    ((1e-4, 0.0, 0.5, 0.1, 10.0), (1e-4, 1e-5)),  # very slowly
    ((1.0, pi / 6, 0.5, 0.0, 10.0), (1.0, pi / 6)),  # no time, no change
    ((1.0, pi / 6, 0.5, 0.1, 0.0), (1.0, pi / 6 + 0.1)),  # no gravity: theta still moves with omega
]

# Results of common mistakes for STEP, by hand.
MISTAKES = [
    ((1.0, 5 * pi / 6 + 0.2), "You used the old omega; theta moves with the new one."),
    ((3.0, 5 * pi / 6 + 0.3), "The sign of gravity is wrong. Gravity pulls the bob back down."),
    ((1.908647, 5 * pi / 6 + 0.190865), "This is the result with degrees. sin() takes radians."),
    ((3.732051, 5 * pi / 6 + 0.373205), "You used cos in place of sin."),
    ((-3.235988, 5 * pi / 6 - 0.323599), "You used theta in place of its sine."),
    ((-8.0, 5 * pi / 6 - 0.8), "You forgot dt in the change of omega."),
    ((1.0, 5 * pi / 6 + 1.0), "You forgot dt in the change of theta."),
    ((1.6, 5 * pi / 6 + 0.16), "You forgot to divide by r_param."),
    ((1.84, 5 * pi / 6 + 0.184), "You multiplied by r_param. Divide by it."),
    ((1.875, 5 * pi / 6 + 0.1875), "You forgot g."),
    ((1.364039, 5 * pi / 6 + 0.2), "You changed theta first. Change omega first, then theta."),
    ((-1.0, 5 * pi / 6 - 0.1), "You forgot to add the old omega."),
    ((1.0, 0.1), "You forgot to add the old theta."),
    ((1.0, 5 * pi / 6), "theta has not changed."),
    ((2.0, 5 * pi / 6 + 0.2), "omega has not changed."),
    ((2.0, 5 * pi / 6), "You returned the old values."),
    ((-0.8, 5 * pi / 6 - 0.08), "In the first formula, multiply only the acceleration by dt, not the old omega."),
    ((1.0, pi / 12 + 0.1), "In the second formula, multiply only the new omega by dt, not the old theta."),
    ((1.792945, 5 * pi / 6 + 0.179294), "You divided theta by r_param. Divide its sine."),
    ((-10.0, 5 * pi / 6 + 0.1), "You returned the angular acceleration in place of the new omega."),
]


# Results of // for the first two STEPS, by hand: with the minus before g, and before the whole product.
ROUNDED = [(2.9, -pi / 6 + 0.29), (-0.05, pi / 2 - 0.0005), (-0.04, pi / 2 - 0.0004)]


def nearly(mistaken):
    """Return a test for this result, with the digits that MISTAKES has."""

    def is_it(came):
        return isinstance(came, tuple) and all(abs(a - b) < 1e-5 for a, b in zip(came, mistaken, strict=True))

    return is_it


@check("angle_update", watched=True)
def test_angle_update():
    """Takes in the current values of angle theta and angular velocity omega and updates them for a given timestep dt
    and gravitational acceleration g.
    """
    hints = [(nearly(mistaken), sentence) for mistaken, sentence in MISTAKES]
    expect("angle_update", *STEP, gives=AFTER, hints=hints)


@check("angle_update", watched=True)
def test_angle_update_of_other_swings():
    """omega' = -g sin(theta) / R where g is the gravitational acceleration and theta is the angle formed by the cord
    normal to the axle.
    """
    hints = [(nearly(mistaken), "This is the result with //, which rounds down. Use /.") for mistaken in ROUNDED]
    for arguments, gives in STEPS:
        expect("angle_update", *arguments, gives=gives, hints=hints)


def swinging_row(count):
    """Return count (up to 7) pendula on cords of 0.5 m, and their omegas and thetas after 0.1 s with g = 10 m/s^2."""
    thetas, omegas = (pi / 6, -pi / 6, pi / 2, 0.0, 0.0, 0.0, 3 * pi / 2), (2.0, 2.0, 0.0, 1.5, 0.0, 1e-3, 20.0)
    pend_list = [
        hang(theta=theta, omega=omega, axle=(i * 0.1, 0.05, 0), r_param=0.5, mass=7.0 - i, e=0.5)
        for i, (theta, omega) in enumerate(zip(thetas, omegas, strict=True))
    ]
    after = [pi / 6 + 0.1, -pi / 6 + 0.3, pi / 2 - 0.2, 0.15, 0.0, 1e-4, 3 * pi / 2 + 2.2]
    return pend_list[:count], [1.0, 3.0, -2.0, 1.5, 0.0, 1e-3, 22.0][:count], after[:count]


# omega and theta of the first pendulum for each wrong order of r_param, dt and g, by hand.
OTHER_ORDERS = [
    (1.0, pi / 6 + 10.0),
    (-23.0, pi / 6 - 11.5),
    (-23.0, pi / 6 - 230.0),
    (1.9975, pi / 6 + 0.19975),
    (1.9975, pi / 6 + 0.99875),
]


def swing_hints(pend_list, omegas, thetas):
    """Return hints for swinging_row: omega and theta of each pendulum for common mistakes."""
    before = [(pend["omega"], pend["theta"]) for pend in pend_list]
    after = list(zip(omegas, thetas, strict=True))

    def is_other_order(came):
        return any(same(came[0], state) for state in OTHER_ORDERS)

    def is_angle_update(came):
        return isinstance(came, TypeError) and "angle_update()" in str(came)

    return [
        (is_angle_update, "angle_update takes no pendulum. swing_update takes one."),
        (before, "omega and theta have not changed. swing_update changes them, angle_update does not."),
        ([after[0], *before[1:]], "Only the first pendulum has swung. Is there a return inside your loop?"),
        ([*before[:-1], after[-1]], "Only the last pendulum has swung."),
        ([*after[:-1], before[-1]], "The last pendulum has not swung."),
        ([before[0], *after[1:]], "The first pendulum has not swung."),
        (is_other_order, "Check the order of the arguments of swing_update: pend_dict, r_param, dt, g."),
    ]


@check("full_swing_update", watched=True)
def test_every_pendulum_swings_once():
    """Uses the helper function swing_update to each pendulum in the Newton's cradle."""
    for count in (3, 7):
        pend_list, omegas, thetas = swinging_row(count)

        def see(_, pend_list=pend_list):
            return [(pend["omega"], pend["theta"]) for pend in pend_list]

        after, hints = list(zip(omegas, thetas, strict=True)), swing_hints(pend_list, omegas, thetas)
        what = "omega and theta of each pendulum"
        expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, gives=after, see=see, what=what, hints=hints)
    other = [hang(theta=-pi / 6, omega=2.0, r_param=0.25)]
    what = "omega of one pendulum"
    gives = {"gives": 4.0, "see": lambda _: other[0]["omega"], "what": what}
    expect("full_swing_update", other, 0.25, 0.2, 5.0, **gives)
    expect("full_swing_update", [], 0.5, 0.1, 10.0, gives=Wanted("no error for an empty pend_list", lambda _: True))


@check("full_swing_update", watched=True)
def test_bobs_and_cords_move():
    """Updates the angle and position of the pendulum components."""
    pend_list, _, thetas = swinging_row(3)

    def see(_):
        shapes = [pend["objects"] for pend in pend_list]
        return [(axle.pos, bob.pos, ends(cord)) for axle, bob, cord in shapes]

    def ends(cord):  # a student may draw it from either end
        return sorted([cord.pos, cord.pos + cord.axis], key=lambda end: end.y)

    axles = [vector(i * 0.1, 0.05, 0) for i in range(3)]
    bobs = [axle + vector(0.5 * sin(theta), -0.5 * cos(theta), 0) for axle, theta in zip(axles, thetas, strict=True)]
    gives = [(axle, bob, [bob, axle]) for axle, bob in zip(axles, bobs, strict=True)]
    what = "position of each axle and bob, and the ends of each cord"
    expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, gives=gives, see=see, what=what)


@check("full_swing_update")
def test_a_swing_changes_nothing_else():
    """The pend_dict is updated."""
    pend_list, *_ = swinging_row(3)
    for pend in pend_list:
        pend["objects"][1].radius = 0.02  # so the bobs do not touch
    pendula, objects = list(pend_list), [pend["objects"] for pend in pend_list]

    def see(_):
        same_objects = [all(map(is_same, pend["objects"], old)) for pend, old in zip(pend_list, objects, strict=True)]
        values = [
            (*(pend[key] for key in ("mass", "e", "color", "texture")), pend["objects"][1].radius) for pend in pend_list
        ]
        return values, same_objects, list(map(is_same, pend_list, pendula))

    def is_same(one, other):
        return one is other

    gives = [(7.0 - i, 0.5, "white", "none", 0.02) for i in range(3)], [True] * 3, [True] * 3
    what = "mass, e, color, texture and radius of each; same objects? same dictionary?"
    expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, gives=gives, see=see, what=what)


@check("full_swing_update", watched=True)
def test_a_swing_is_no_collision():
    """In the second part of the project, you will focus on the functionality of each individual pendulum; specifically,
    how each pendulum swings.
    """
    omegas = [1.0, -1.0, 0.5]
    pend_list = row(3, radius=R / 8)
    for pend, omega in zip(pend_list, omegas, strict=True):
        pend["omega"] = omega
    exchanged = (lambda came: sorted(came) == sorted(omegas), "Your bobs collided. full_swing_update only swings them.")

    def see(_):
        return [pend["omega"] for pend in pend_list]

    expect(
        "full_swing_update", pend_list, R, 1e-9, 9.81, gives=omegas, see=see, what="omega of each", hints=[exchanged]
    )
