"""B checks: what happens to two pendula when they knock into each other."""

from itertools import permutations

from grading.cradles import hang
from grading.grader import check, expect, find, same

# The arguments e, omega1, omega2, m1, m2, and what comes of them; by hand from the appendix's two formulas.
HIT, AFTER = (0.75, 4.0, -2.0, 1.0, 4.0), (-4.4, 0.1)
COLLISIONS = [
    ((0.5, 4.0, 0.0, 1.0, 1.0), (1.0, 3.0)),
    ((1, 3.0, 0.0, 1.0, 1.0), (0.0, 3.0)),  # equal masses, elastic: the velocities change places
    ((1, 2.0, -5.0, 0.7, 0.7), (-5.0, 2.0)),
    ((0, 3.0, 0.0, 1.0, 1.0), (1.5, 1.5)),  # inelastic: both go on together
    ((1, 4.0, 0.0, 1.0, 3.0), (-2.0, 2.0)),  # a light bob bounces off a heavy one
    ((1, 4.0, 0.0, 3.0, 1.0), (2.0, 6.0)),  # a heavy bob drives a light one ahead
    ((0, 4.0, -2.0, 1.0, 2.0), (0.0, 0.0)),  # opposite momenta, inelastic: all motion ends
    ((0.25, 8.0, 0.0, 1.0, 3.0), (0.5, 2.5)),
    ((0.9, 2.0, 2.0, 1.0, 5.0), (2.0, 2.0)),  # no approach, no change
    ((0.5, -1.0, 2.0, 1.0, 1.0), (1.25, -0.25)),  # whether they approach is not asked here
    ((0.5, 0.0, -3.0, 1.0, 1.0), (-2.25, -0.75)),  # the first one at rest
    ((0.5, -1.0, -4.0, 1.0, 2.0), (-4.0, -2.5)),  # both to the left
    ((0.5, 4.0, 1.0, 1.0, 2.0), (1.0, 2.5)),  # both to the right
    ((0.5, -2.0, 1.0, 1.0, 2.0), (1.0, -0.5)),
    ((0.1, 2.0, 0.0, 1.0, 1.0), (0.9, 1.1)),  # e near 0
    ((0.98, 2.0, 0.0, 1.0, 1.0), (0.02, 1.98)),  # e near 1
    ((0.5, 1.0, 0.0, 0.25, 24.75), (-0.485, 0.015)),  # masses far apart
    ((0.5, 1.0, 0.0, 24.75, 0.25), (0.985, 1.485)),
    ((0.5, 1e-4, 0.0, 1.0, 1.0), (2.5e-5, 7.5e-5)),  # slowly
]

# What certain mistakes make of HIT with a cord of 0.4 m, by hand.
MISTAKES = [
    ((-5.6, 0.4), "This is what e = 1 gives, whatever e is."),
    ((-0.8, -0.8), "This is what e = 0 gives, whatever e is."),
    ((-5.6, 0.1), "The first formula is without e."),
    ((-4.4, 0.4), "The second formula is without e."),
    ((1.9, 6.4), "This is what exchanged masses give."),
    ((2.8, -1.7), "This is what e gives with the wrong sign in both formulas."),
    ((2.8, 0.1), "This is what e gives with the wrong sign in the first formula."),
    ((-4.4, -1.7), "This is what e gives with the wrong sign in the second formula."),
    ((-1.7, 0.1), "In the first formula, m1 stands where m2 must stand."),
    ((-4.4, 2.8), "In the second formula, m2 stands where m1 must stand."),
    ((-2.0, 0.1), "In the first formula, the velocities are added after e; it is their difference."),
    ((-4.4, -0.5), "In the second formula, the velocities are added after e; it is their difference."),
    ((-2.0, -0.5), "In both formulas, the velocities are added after e; it is their difference."),
    ((-1.2, 0.1), "In the first formula, the momenta are subtracted; it is their sum."),
    ((-7.6, 0.1), "In the first formula, brackets are missing: all of it is divided by the sum of the masses."),
    ((-4.4, -3.1), "In the second formula, brackets are missing: all of it is divided by the sum of the masses."),
    ((-7.6, -3.1), "In both formulas, brackets are missing: all of it is divided by the sum of the masses."),
    ((-4.4, -1.16), "The second formula takes the new velocity of the first bob; it must take the old one."),
    ((0.4, -1.1), "This is what e gives in place of 1 + e, if the impulse is computed."),
    ((-1.76, 0.04), "These are the linear velocities, not yet converted back to angular ones."),
    ((-11.0, 0.25), "These are converted back from linear velocities, but were never converted to them."),
    ((-0.704, 0.016), "This is converted to linear velocities twice; the second time it must be back from them."),
    ((-2.0, 4.0), "This exchanges the velocities, as only equal masses do in an elastic hit."),
    ((-12.0, 10.5), "The sum of the masses needs brackets: / divides by m1 alone."),
    ((-22.0, 0.5), "The sum of the masses, by which both are divided, is missing."),
    ((-5.5, 0.125), "This is divided by the product of the masses; it must be their sum."),
    ((-110.0, 2.5), "The sum of the masses multiplies here; it must divide."),
    ((-27.5, 0.625), "v is r_param times omega here; only on the way back, r_param divides."),
    ((-5.0, 0.0), "// divides and rounds down; / only divides."),
    ((4.0, -2.0), "These are the old velocities."),
]


@check("handle_collision", watched=True)
def test_handle_collision():
    """Takes in the initial angular velocities of both bobs (omega1 and omega2), their coefficient of restitution (e),
    their masses (m1 and m2), and the cord length r_param and returns a tuple of the new angular velocities of both bobs
    (new_omega1, new_omega2).
    """
    expect("handle_collision", *HIT, 0.4, gives=AFTER, hints=MISTAKES)


@check("handle_collision", watched=True)
def test_collisions_from_elastic_to_inelastic():
    """If e = 0, it is a perfectly inelastic collision (kinetic energy not conserved), and if e = 1, it is a perfectly
    elastic collision (kinetic energy is conserved).
    """
    for arguments, gives in COLLISIONS:
        hints = [(arguments[1:3], "These are the old velocities.")]
        expect("handle_collision", *arguments, 0.4, gives=gives, hints=hints)


@check("handle_collision", watched=True)
def test_the_cord_length_does_not_matter():
    """If we start off using angular velocities omega, we need to convert them to linear velocities v = R omega for this
    equation, and the new calculated velocities can be converted back to angular velocities with the same equation.
    """
    for r_param in (0.2, 1.0, 3.0):
        expect("handle_collision", *HIT, r_param, gives=AFTER)


@check("handle_collision", watched=True)
def test_laws_of_the_collision():
    """The entire system should conserve kinetic energy in an elastic collision and conserve linear momentum (during a
    collision, we can approximate the momentum to be linear).
    """
    omega1, omega2 = 2.5, -1.5
    for m1, m2 in [(1.0, 1.0), (0.2, 5.0), (7.0, 0.1)]:
        momentum, energy = m1 * omega1 + m2 * omega2, m1 * omega1**2 + m2 * omega2**2
        for e in (0, 0.3, 1):

            def momentum_after(new, m1=m1, m2=m2):
                return m1 * new[0] + m2 * new[1]

            def energy_after(new, m1=m1, m2=m2):
                return m1 * new[0] ** 2 + m2 * new[1] ** 2

            arguments = e, omega1, omega2, m1, m2, 0.4
            what = "m1 new_omega1 + m2 new_omega2"
            expect("handle_collision", *arguments, gives=momentum, see=momentum_after, what=what)
            if e == 1:
                what = "m1 new_omega1^2 + m2 new_omega2^2"
                expect("handle_collision", *arguments, gives=energy, see=energy_after, what=what)


# --- handle_two_bobs -------------------------------------------------------------------------------------------------

LENGTH = 4.0  # m, so that the distances below are numbers without rounding errors
LEFT, HITS, MISSES = 4.0, (1.0, 3.0), (4.0, 0.0)  # omega of the left one before; omegas of both after, with e = 0.5


def pair(distance=(1.0, 0.0, 0.0), radius1=0.5, radius2=0.5, values1=None, values2=None):
    """Return two pendula that hang straight down, their axles this far (x, y, z in m) apart; the left one moves."""
    pend1 = hang(r_param=LENGTH, radius=radius1, **{"omega": LEFT, "e": 0.5, **(values1 or {})})
    pend2 = hang(r_param=LENGTH, axle=distance, radius=radius2, **{"e": 0.5, **(values2 or {})})
    return pend1, pend2


def check_pair(gives, *arguments, hints=(), **values):
    """Check the omegas that two such pendula have afterwards."""
    pend1, pend2 = pair(*arguments, **values)

    def see(_):
        return pend1["omega"], pend2["omega"]

    what = "omega of pend1 and of pend2"
    before = pend1["omega"], pend2["omega"]
    if gives != before:
        hints = [
            *hints,
            (before, "Nothing has changed, though the bobs touch."),
            ((before[0], gives[1]), "pend1 has not got its new omega."),
            ((gives[0], before[1]), "pend2 has not got its new omega."),
        ]
    expect("handle_two_bobs", pend1, pend2, LENGTH, gives=gives, see=see, what=what, hints=hints)


# Two bobs of which no two numbers are alike, and what certain mistakes make of their omegas; by hand.
MEETING = {"values1": {"omega": 3.0, "mass": 2.0, "e": 0.25}, "values2": {"omega": 1.0, "mass": 6.0, "e": 0.25}}
MET, MEETING_HINTS = (
    (1.125, 1.625),
    [
        ((1.75, 2.25), "This is what equal masses give."),
        ((2.375, 2.875), "This is what exchanged masses give."),
        ((2.875, 2.375), "This is what exchanged omegas give."),
        ((0.1875, 0.9375), "This is what omega = 0 of pend2 gives."),
        ((0.0, 2.0), "This is what e = 1 gives; that of pend1 is 0.25."),
        ((1.5, 1.5), "This is what e = 0 gives; that of pend1 is 0.25."),
        ((1.625, 1.125), "pend1 has got the new omega of pend2, and pend2 that of pend1."),
    ],
)


def is_other_order(came):
    """Return whether this is what handle_collision makes of MEETING if its arguments are in another order.

    It is the student's own, which is right: handle_two_bobs waits for it.
    """
    collide = find("handle_collision")
    return any(same(came, collide(*order)) for order in permutations((0.25, 3.0, 1.0, 2.0, 6.0, LENGTH)))


@check("handle_two_bobs", watched=True)
def test_masses_and_omegas_are_those_of_each():
    """For each pendulum dictionary, get the masses, bobs and angular velocity (omega)."""
    other_order = "Are the arguments of handle_collision in its order: e, omega1, omega2, m1, m2, r_param?"
    check_pair(MET, **MEETING, hints=[*MEETING_HINTS, (is_other_order, other_order)])
    check_pair((-0.5, 1.5), values2={"mass": 3.0})
    check_pair((2.5, 4.5), values1={"mass": 3.0})
    check_pair((-0.5, 2.5), values2={"omega": -2.0})


@check("handle_two_bobs", watched=True)
def test_bobs_that_touch_collide():
    """Check if the magnitude of the difference in positions of both bobs is less than or equal to 1.05 times the sum of
    the bobs' radii.
    """
    check_pair(HITS)
    check_pair(HITS, (0.2, 0, 0))
    check_pair(HITS, (1.02, 0, 0), hints=[(MISSES, "This is what comes without the buffer of 1.05.")])
    buffer = "Is it the sum of both radii, all of it, that is multiplied by 1.05, and is the distance not changed?"
    check_pair(HITS, (1.04, 0, 0), hints=[(MISSES, buffer)])
    # However 1.05 times the sum of the radii is computed, it is just 21.
    just = [(MISSES, "At just 1.05 times the sum they collide, too: less than or equal, and not rounded.")]
    check_pair(HITS, (21.0, 0, 0), 10.0, 10.0, hints=just)
    check_pair(HITS, (-1.0, 0, 0), hints=[(MISSES, "A magnitude has no sign.")])
    check_pair(HITS, (0.7, 0.7, 0), hints=[(MISSES, "This is what the sum of the distances along x and y gives.")])
    check_pair(HITS, (0, 0, 1.0))
    lifted = [(MISSES, "Here the axles are further apart than the bobs; it is the bobs that count.")]
    check_pair(HITS, values1={"theta": 0.3}, hints=lifted)
    check_pair(HITS, (1.5, 0, 0), values1={"theta": 0.2}, hints=lifted)
    check_pair(HITS, values1={"theta": 0.02}, values2={"theta": 0.03})


@check("handle_two_bobs", watched=True)
def test_bobs_that_do_not_touch_go_on():
    """We add a little bit of buffer to what is considered a 'collision'."""
    check_pair(MISSES, (9.0, 0, 0), hints=[(HITS, "They are far apart, and collide.")])
    check_pair(MISSES, (1.0504, 0, 0), hints=[(HITS, "The buffer is too large, or the distance too small.")])
    check_pair(MISSES, (-1.2, 0, 0), hints=[(HITS, "The distance has become negative; a magnitude has no sign.")])
    along_x = [(HITS, "This is what the distance along x alone gives.")]
    check_pair(MISSES, (0.8, 0.8, 0), hints=along_x)
    check_pair(MISSES, (0, 1.2, 0), hints=along_x)
    lifted = [(HITS, "Here the axles are close, but not the bobs.")]
    check_pair(MISSES, values1={"theta": -0.3}, values2={"theta": 0.3}, hints=lifted)


@check("handle_two_bobs", watched=True)
def test_both_radii_count():
    """You can access positions and radii of VPython objects with bob.pos and bob.radius."""
    one_radius = [
        (HITS, "The radii of these bobs are not equal: is it the sum of both?"),
        (MISSES, "The radii of these bobs are not equal: is it the sum of both?"),
    ]
    check_pair(HITS)
    check_pair(HITS, (1.0, 0, 0), 0.9, 0.2, hints=one_radius)
    check_pair(HITS, (1.0, 0, 0), 0.2, 0.9, hints=one_radius)
    check_pair(MISSES, (1.0, 0, 0), 0.2, 0.7, hints=one_radius)
    check_pair(MISSES, (1.0, 0, 0), 0.7, 0.2, hints=one_radius)
    check_pair(MISSES, (1.0, 0, 0), 0.05, 0.05, hints=[(HITS, "Here the bobs are small: do the radii count?")])
    check_pair(HITS, (3.1, 0, 0), 2.0, 1.0, hints=[(MISSES, "The bobs are large here: 1.05 is a factor of their sum.")])


@check("handle_two_bobs", watched=True)
def test_e_is_the_first_pendulums():
    """From only the first dictionary, get the coefficient of restitution."""
    hints = [
        ((0.0, 4.0), "This is what e = 1 gives; that of pend1 is 0.5."),
        ((2.0, 2.0), "This is what e = 0 gives; that of pend1 is 0.5."),
        ((0.5, 3.5), "This is what the mean of both e gives."),
    ]
    check_pair((1.0, 3.0), values1={"e": 0.5}, values2={"e": 1.0}, hints=hints)
    hints = [((1.0, 3.0), "This is what e = 0.5 gives; that of pend1 is 1.")]
    check_pair((0.0, 4.0), values1={"e": 1.0}, values2={"e": 0.5}, hints=hints)
    hints = [((0.0, 4.0), "This is what e = 1 gives; that of pend1 is 0.")]
    check_pair((2.0, 2.0), values1={"e": 0}, values2={"e": 1.0}, hints=hints)
    # Whichever of them is heavier, faster, or on the left.
    check_pair((2.5, 4.5), values1={"e": 0.5, "mass": 3.0}, values2={"e": 1.0})
    check_pair((-0.5, 1.5), values1={"e": 0.5}, values2={"e": 1.0, "mass": 3.0})
    check_pair((-3.0, -1.0), values1={"e": 0.5, "omega": 0.0}, values2={"e": 1.0, "omega": -4.0})
    check_pair((1.0, 3.0), (-1.0, 0, 0), values1={"e": 0.5}, values2={"e": 1.0})


@check("handle_two_bobs", watched=True)
def test_bobs_that_touch_collide_whatever_their_velocities_are():
    """If true, use the helper function handle_collision to get the new angular velocity values for both pendula."""
    check_pair(HITS)
    hints = [((-1.0, 2.0), "The handout does not ask whether the bobs approach.")]
    check_pair((1.25, -0.25), values1={"omega": -1.0}, values2={"omega": 2.0}, hints=hints)
    check_pair((-2.25, -0.75), values1={"omega": 0.0}, values2={"omega": -3.0})
    check_pair((-2.5, -1.5), values1={"omega": -1.0}, values2={"omega": -3.0})
    check_pair((1.75, 3.25), values2={"omega": 1.0})
    check_pair((0.001, 0.003), values1={"omega": 0.004})


def all_but_omega(pend1, pend2):
    """Return all values of two pendula but their omegas, and the places and radii of their bobs."""
    values = {}
    for name, pend in (("pend1", pend1), ("pend2", pend2)):
        bob = pend["objects"][1]
        values |= {f"{key} of {name}": pend[key] for key in pend if key != "omega"}
        values |= {f"bob of {name}": (tuple(bob.pos.value), bob.radius)}
    return values


@check("handle_two_bobs")
def test_omegas_are_updated_and_nothing_else():
    """Then, update both dictionaries with their respective new omega values."""
    for distance in (1.0, 2.0):
        pends = pair((distance, 0, 0), values1={"mass": 2.0, "theta": 0.01}, values2={"e": 0.9, "theta": 0.02})

        before = all_but_omega(*pends)

        def changed(_, pends=pends, before=before):
            now = all_but_omega(*pends)
            return {key: now.get(key) for key in before | now if not same(now.get(key), before.get(key))}

        what = "all that has changed but omega"
        expect("handle_two_bobs", *pends, LENGTH, gives={}, see=changed, what=what)


@check("handle_two_bobs")
def test_what_was_before_does_not_matter():
    """Handles the pairwise interactions between two bobs in the Newton's cradle, including checking for and handling
    collisions.
    """
    pend1, pend2 = pair()
    for gives in ((1.0, 3.0), (2.5, 1.5), (1.75, 2.25)):

        def omegas(_):
            return pend1["omega"], pend2["omega"]

        what = "omega of pend1 and of pend2, as of the call before"
        expect("handle_two_bobs", pend1, pend2, LENGTH, gives=gives, see=omegas, what=what)
