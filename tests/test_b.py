"""B checks: two pendula knock into each other."""

from math import pi

import grading.begin

from vpython import vector

from grading.checks import check
from grading.cradles import hang
from grading.grader import expect
from grading.subject import Several, Subject
from grading.words import text_of
from support.pendulum import contact_distance

STEPS = {
    "handle_collision": "both omegas become linear velocities; the two formulas of Physics 3 "
    "use these; both results become angular again.",
    "handle_two_bobs": "mass, omega and bob of both, e of pend1; if the bobs are close, "
    "handle_collision gives the new omegas; each pendulum stores its own.",
}

# The arguments e, omega1, omega2, m1, m2, and the result; by hand from the two formulas of the
# physics.
HIT = (0.7, 3.0, -4.0, 2.0, 8.0)
AFTER = (-6.52, -1.62)
COLLISIONS = [
    ((0.5, 4.0, 0.0, 1.0, 1.0), (1.0, 3.0)),
    ((1, 2.0, -5.0, 0.7, 0.7), (-5.0, 2.0)),  # equal masses, elastic: velocities change places
    ((0, 3.0, 0.0, 1.0, 1.0), (1.5, 1.5)),  # inelastic: both move on together
    ((1, 4.0, 0.0, 1.0, 3.0), (-2.0, 2.0)),  # a light bob bounces off a heavy one
    ((1, 4.0, 0.0, 3.0, 1.0), (2.0, 6.0)),  # a heavy bob drives a light one ahead
    ((0, 4.0, -2.0, 1.0, 2.0), (0.0, 0.0)),  # opposite momenta, inelastic: both stop
    ((0.9, 2.0, 2.0, 1.0, 5.0), (2.0, 2.0)),  # no approach, no change
    # They move apart; the function does not check this
    ((0.5, -1.0, 2.0, 1.0, 1.0), (1.25, -0.25)),
    ((0.5, -1.0, -4.0, 1.0, 2.0), (-4.0, -2.5)),  # both to the left
    ((0.5, 4.0, 1.0, 1.0, 2.0), (1.0, 2.5)),  # both to the right
    ((0.5, 1.0, 0.0, 0.25, 24.75), (-0.485, 0.015)),  # masses far apart
    ((0.5, 1.0, 0.0, 24.75, 0.25), (0.985, 1.485)),
    ((0.5, 4e-8, 0.0, 1.0, 1.0), (1e-8, 3e-8)),  # slowly
]


# Mistakes in the formulas for the first hit: what they are, the wrong first result, and the wrong
# second one.
FORMULAS = [
    ("e is missing.", -8.2, -1.2),
    ("the sign before e is wrong.", 1.32, -3.58),
    ("the mass before e is wrong: m2 in the first one, m1 in the second one.", -3.58, 1.32),
    ("the mass before e is missing.", -3.09, -2.11),
    (
        "e multiplies only a part of the difference of the velocities: it needs brackets.",
        -3.88,
        -1.78,
    ),
    (
        "only the end is divided by the sum of the masses: brackets are missing around all of it.",
        -29.92,
        -25.02,
    ),
    ("only m1 divides: the sum of the masses needs brackets.", -12.6, 11.9),
    ("both divisions apply only to the end: all of it needs brackets.", -14.32, -9.42),
    ("nothing divides by the sum of the masses.", -65.2, -16.2),
    ("the linear velocity is returned: divide it by r_param.", -2.608, -0.648),
    ("m1 multiplies v2, and m2 multiplies v1.", -2.32, 2.58),
]
RESULTS = [
    ((-8.14, -0.09), "This is the result if omega1 is not converted: r_param multiplies it, too."),
    ((-14.68, -5.58), "This is the result if omega2 is not converted: r_param multiplies it, too."),
    (
        (-16.3, -4.05),
        "This is the result if the omegas are not converted to linear velocities, but the end is "
        "converted back.",
    ),
    (
        (-1.0432, -0.2592),
        "This is the result if r_param multiplies twice. At the end, convert back: divide by "
        "r_param.",
    ),
    (
        (-6.52, -6.52),
        "Both results are the right one of the first bob. The second one comes from the second "
        "formula, with + m1 e.",
    ),
    (
        (-6.52, -2.9528),
        "This is the result with the new velocity of the first bob behind e in the second formula. "
        "Use the old one.",
    ),
    (
        (-6.52, -4.8568),
        "This is the result if the second formula has the new velocity of the first bob at each "
        "place. Use the old one.",
    ),
    (
        (-4.0, 3.0),
        "These are the two omegas of the call, in the other order. So it is only for equal masses "
        "and e = 1.",
    ),
]
for mistake, first, second in FORMULAS:
    RESULTS += [
        ((first, AFTER[1]), f"This is the result if, in the first formula, {mistake}"),
        ((AFTER[0], second), f"This is the result if, in the second formula, {mistake}"),
        ((first, second), f"This is the result if, in both formulas, {mistake}"),
    ]


def check_hit(expected, e, omega1, omega2, m1, m2, r_param, **options):
    """Check the result of handle_collision.

    A student reads the parts of the formulas, which follow from the result.
    """
    v1 = r_param * omega1
    v2 = r_param * omega2
    right = [
        ("v1", v1),
        ("v2", v2),
        ("m1 v1 + m2 v2", m1 * v1 + m2 * v2),
        ("v1 - v2", v1 - v2),
        ("m1 + m2", m1 + m2),
        ("v1_new", r_param * expected[0]),
        ("v2_new", r_param * expected[1]),
    ]
    call = "handle_collision", e, omega1, omega2, m1, m2, r_param
    expect(*call, expected=expected, right=right, **options)


@check("handle_collision")
def test_handle_collision():
    """Both new omegas are right when bobs of different masses meet."""
    check_hit(AFTER, *HIT, 0.4, results=RESULTS)


@check("handle_collision")
def test_collisions_from_elastic_to_inelastic():
    """Both new omegas are right for any e, any masses and any omegas."""
    for arguments, expected in COLLISIONS:
        check_hit(expected, *arguments, 0.4)


@check("handle_collision")
def test_the_cord_length_does_not_matter():
    """Cords of any length give the same new omegas."""
    for r_param in (0.2, 1.0, 3.0):
        check_hit(AFTER, *HIT, r_param)


@check("handle_collision")
def test_laws_of_the_collision():
    """A hit keeps the momentum and, with e = 1, the kinetic energy."""
    momentum = Subject("momentum m1 new_omega1 + m2 new_omega2")
    energy = Subject("energy m1 new_omega1^2 + m2 new_omega2^2")
    for m1, m2 in ((1.0, 1.0), (0.2, 5.0), (7.0, 0.1)):
        for e in (0, 0.3, 1):
            check_law(momentum, 1, e, m1, m2)
        check_law(energy, 2, 1, m1, m2)


def check_law(what, power, e, m1, m2):
    """Check that mass * omega ** power, added up, is the same before and after a collision."""

    def total(omegas):
        return m1 * omegas[0] ** power + m2 * omegas[1] ** power

    omegas = 2.5, -1.5
    call = "handle_collision", e, *omegas, m1, m2, 0.4
    expect(*call, expected=total(omegas), see=total, what=what)


BOTH = Several((Subject(owner="pend1"), Subject(owner="pend2")))
LEFT = 4.0  # omega of pend1 before
# The omegas of both after, with e = 0.5 and equal masses.
HITS = (1.0, 3.0)
MISSES = (4.0, 0.0)
KNOWN_HITS = []  # pairs of arguments of handle_collision, without r_param, and what it gives


def pair(apart=1.0, radius1=0.5, radius2=0.5, **values):
    """Return two pendula. pend1 moves.

    Their axles are apart (m), and the cords 4 times as long, as in a cradle. values are those of
    hang, with a 1 or a 2 behind the name.
    """
    values = {"omega1": LEFT, "e1": 0.5, "e2": 0.5, **values}
    values1 = {}
    values2 = {}
    for name, value in values.items():
        values_of_one = values1 if name.endswith("1") else values2
        values_of_one[name[:-1]] = value
    pend1 = hang(r_param=4 * apart, radius=radius1, **values1)
    pend2 = hang(r_param=4 * apart, axle=(apart, 0, 0), radius=radius2, **values2)
    return pend1, pend2


def check_pair(expected, apart=1.0, *radii, results=(), **values):
    """Check the omegas of two such pendula after the call."""
    pends = pair(apart, *radii, **values)
    expect_omegas(expected, *pends, 4 * apart, results=results)


def expect_omegas(expected, pend1, pend2, r_param, **options):
    """Check the omegas of these pendula after the call."""
    expect(
        "handle_two_bobs",
        pend1,
        pend2,
        r_param,
        expected=expected,
        see=lambda _: (pend1["omega"], pend2["omega"]),
        what=Several((Subject("omega", "pend1"), Subject("omega", "pend2"))),
        help=help_for(pend1, pend2, r_param, expected),
        **options,
    )


def help_for(pend1, pend2, r_param, expected) -> str:
    """Return whether the bobs of these pendula touch, and what handle_collision gives then.

    Its stand-in, known_hit, gives this from now on.
    """
    bob1 = pend1["objects"][1]
    bob2 = pend2["objects"][1]
    apart = (bob1.pos - bob2.pos).mag
    contact = contact_distance(bob1.radius, bob2.radius)
    distance = f"the magnitude of the difference of their positions is {text_of(apart)} m"
    if apart > contact:
        return f"These bobs do not touch: {distance}, more than {text_of(contact)} m."
    values = pend1["e"], pend1["omega"], pend2["omega"], pend1["mass"], pend2["mass"], r_param
    KNOWN_HITS.append((values[:-1], expected))
    gives = f"handle_collision{text_of(values)} gives {text_of(expected)}"
    return f"These bobs touch: {distance}, at most {text_of(contact)} m. {gives}."


@check("handle_two_bobs")
def test_masses_and_omegas_are_those_of_each():
    """Each pendulum goes into the collision with its own mass and omega."""
    again = (
        "This is the result if handle_collision is called again after pend1 has changed. Call it "
        "once, for both."
    )
    results = [
        ((1.125, 1.0390625), again),
        ((1.40625, 1.53125), "This is the result with the product of both e."),
    ]
    check_pair(
        (1.125, 1.625),
        omega1=3.0,
        mass1=2.0,
        e1=0.25,
        omega2=1.0,
        mass2=6.0,
        e2=0.25,
        results=results,
    )
    check_pair((-0.5, 1.5), mass2=3.0)
    check_pair((2.5, 4.5), mass1=3.0)
    check_pair((-0.5, 2.5), omega2=-2.0)


@check("handle_two_bobs")
def test_bobs_that_touch_collide():
    """Two bobs collide up to exactly 1.05 times the sum of their radii."""
    for apart in (0.2, 1.04):
        check_pair(HITS, apart)
    # Every way to compute 1.05 times the sum of the radii gives exactly 21
    check_pair(HITS, 21.0, 10.0, 10.0)
    check_pair(HITS, theta1=0.25, theta2=-0.25)  # bob 2 is to the left of bob 1
    check_pair(HITS, 1.5, theta1=0.15)  # the distance of the axles does not matter
    # The last two are on a diagonal
    for theta1, theta2 in ((0.3, 0.0), (0.02, 0.03), (1.25, 1.05), (-1.05, -1.25)):
        check_pair(HITS, theta1=theta1, theta2=theta2)
    # Above the axles, and turned more than once
    check_pair(HITS, theta1=2.0 - 4 * pi, theta2=2.1 + 2 * pi)


@check("handle_two_bobs")
def test_bobs_that_do_not_touch_go_on():
    """Beyond 1.05 times the sum of their radii, bobs keep their omegas."""
    for apart in (9.0, 1.0504):
        check_pair(MISSES, apart)
    for theta1, theta2 in (
        (0.28, -0.28),
        (-0.3, 0.3),
        (1.5, 1.64),
        (1.64, 1.5),
        (2.05, 2.45),
        (2.0, 1.93),
    ):
        check_pair(MISSES, theta1=theta1, theta2=theta2)


@check("handle_two_bobs")
def test_both_radii_count():
    """The radii of both bobs decide whether they touch."""
    check_pair(HITS)
    for sizes in ((1.0, 0.9, 0.2), (1.0, 0.2, 0.9)):
        check_pair(HITS, *sizes)
    for sizes in ((1.0, 0.2, 0.7), (1.0, 0.7, 0.2), (1.0, 0.05, 0.05)):
        check_pair(MISSES, *sizes)


@check("handle_two_bobs")
def test_e_is_the_first_pendulums():
    """The collision takes e from pend1, and never from pend2."""
    check_pair((1.0, 3.0), e1=0.5, e2=1.0)
    check_pair((0.0, 4.0), e1=1.0, e2=0.5)
    check_pair((2.0, 2.0), e1=0, e2=1.0)
    # e is that of pend1, even if pend2 is heavier, faster, or has its bob on the left.
    check_pair((-0.5, 1.5), e1=0.5, e2=1.0, mass2=3.0)
    check_pair((-3.0, -1.0), e1=0.5, omega1=0.0, e2=1.0, omega2=-4.0)
    check_pair((1.0, 3.0), e1=0.5, theta1=0.25, e2=1.0, theta2=-0.25)


@check("handle_two_bobs")
def test_bobs_that_touch_collide_whatever_their_velocities_are():
    """Bobs that touch collide with any omegas."""
    check_pair((1.25, -0.25), omega1=-1.0, omega2=2.0)
    check_pair((-2.25, -0.75), omega1=0.0, omega2=-3.0)
    check_pair((-2.5, -1.5), omega1=-1.0, omega2=-3.0)
    check_pair((1.75, 3.25), omega2=1.0)
    check_pair((1e-8, 3e-8), omega1=4e-8)


def all_but_omega(pend):
    """Return all values of a pendulum except omega, and the position and the radius of its bob."""
    bob = pend["objects"][1]
    values = {"position of the bob": vector(bob.pos), "radius of the bob": bob.radius, **pend}
    del values["omega"]
    return values


@check("handle_two_bobs")
def test_omegas_are_updated_and_nothing_else():
    """Nothing but the omegas changes, whether the bobs touch or not."""
    for apart in (1.0, 2.0):
        pends = pair(apart, mass1=2.0, theta1=0.01, e2=0.9, theta2=0.02)
        expect(
            "handle_two_bobs",
            *pends,
            4 * apart,
            expected=[*map(all_but_omega, pends)],
            see=lambda _, pends=pends: [*map(all_but_omega, pends)],
            what=BOTH,
        )


@check("handle_two_bobs")
def test_earlier_calls_do_not_matter():
    """Bobs that still touch collide again in the next call."""
    pends = pair()
    for expected in ((1.0, 3.0), (2.5, 1.5), (1.75, 2.25)):
        expect_omegas(expected, *pends, 4.0)


def known_hit(*arguments):
    """Stand in for handle_collision: return what is known, or (7, 8)."""
    for known, expected in KNOWN_HITS:
        if known == arguments[:-1]:
            return expected
    return 7.0, 8.0


@check("handle_two_bobs", handle_collision=known_hit)
def handle_two_bobs_alone():
    """Only bobs that touch get the omegas that handle_collision gives."""
    test_masses_and_omegas_are_those_of_each()
    test_bobs_that_touch_collide()
    test_bobs_that_do_not_touch_go_on()
    test_both_radii_count()
    test_e_is_the_first_pendulums()
    test_omegas_are_updated_and_nothing_else()
    test_earlier_calls_do_not_matter()
