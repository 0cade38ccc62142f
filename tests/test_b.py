"""B checks: two pendula knock into each other."""

from itertools import permutations

from grading.cradles import hang
from grading.grader import check, expect, find, same

# The arguments e, omega1, omega2, m1, m2, and the result; by hand from the two formulas of the appendix.
HIT, AFTER = (0.75, 4.0, -2.0, 1.0, 4.0), (-4.4, 0.1)
COLLISIONS = [
    ((0.5, 4.0, 0.0, 1.0, 1.0), (1.0, 3.0)),
    ((1, 3.0, 0.0, 1.0, 1.0), (0.0, 3.0)),  # equal masses, elastic: the velocities change places
    ((1, 2.0, -5.0, 0.7, 0.7), (-5.0, 2.0)),
    ((0, 3.0, 0.0, 1.0, 1.0), (1.5, 1.5)),  # inelastic: both move on together
    ((1, 4.0, 0.0, 1.0, 3.0), (-2.0, 2.0)),  # a light bob bounces off a heavy one
    ((1, 4.0, 0.0, 3.0, 1.0), (2.0, 6.0)),  # a heavy bob drives a light one ahead
    ((0, 4.0, -2.0, 1.0, 2.0), (0.0, 0.0)),  # opposite momenta, inelastic: both stop
    ((0.25, 8.0, 0.0, 1.0, 3.0), (0.5, 2.5)),
    ((0.9, 2.0, 2.0, 1.0, 5.0), (2.0, 2.0)),  # no approach, no change
    ((0.5, -1.0, 2.0, 1.0, 1.0), (1.25, -0.25)),  # they move apart; the function does not check this
    ((0.5, 0.0, -3.0, 1.0, 1.0), (-2.25, -0.75)),  # the first one is at rest
    ((0.5, -1.0, -4.0, 1.0, 2.0), (-4.0, -2.5)),  # both to the left
    ((0.5, 4.0, 1.0, 1.0, 2.0), (1.0, 2.5)),  # both to the right
    ((0.5, -2.0, 1.0, 1.0, 2.0), (1.0, -0.5)),
    ((0.1, 2.0, 0.0, 1.0, 1.0), (0.9, 1.1)),  # e near 0
    ((0.98, 2.0, 0.0, 1.0, 1.0), (0.02, 1.98)),  # e near 1
    ((0.5, 1.0, 0.0, 0.25, 24.75), (-0.485, 0.015)),  # masses far apart
    ((0.5, 1.0, 0.0, 24.75, 0.25), (0.985, 1.485)),
    ((0.5, 1e-4, 0.0, 1.0, 1.0), (2.5e-5, 7.5e-5)),  # slowly
]

# Results of common mistakes for HIT with a cord of 0.4 m, by hand.
MISTAKES = [
    ((-5.6, 0.4), "This is the result with e = 1, but e is 0.75."),
    ((-0.8, -0.8), "This is the result with e = 0, but e is 0.75."),
    ((-5.6, 0.1), "You forgot e in the first formula."),
    ((-4.4, 0.4), "You forgot e in the second formula."),
    ((1.9, 6.4), "You exchanged the masses."),
    ((2.8, -1.7), "The sign of e is wrong in both formulas."),
    ((2.8, 0.1), "The sign of e is wrong in the first formula."),
    ((-4.4, -1.7), "The sign of e is wrong in the second formula."),
    ((-1.7, 0.1), "In the first formula, you used m1 in place of m2."),
    ((-4.4, 2.8), "In the second formula, you used m2 in place of m1."),
    ((-2.0, 0.1), "In the first formula, you added the velocities after e. Subtract them."),
    ((-4.4, -0.5), "In the second formula, you added the velocities after e. Subtract them."),
    ((-2.0, -0.5), "In both formulas, you added the velocities after e. Subtract them."),
    ((-1.2, 0.1), "In the first formula, you subtracted the momenta. Add them."),
    ((-7.6, 0.1), "In the first formula, brackets are missing: divide all of it by the sum of the masses."),
    ((-4.4, -3.1), "In the second formula, brackets are missing: divide all of it by the sum of the masses."),
    ((-7.6, -3.1), "In both formulas, brackets are missing: divide all of it by the sum of the masses."),
    ((-4.4, -1.16), "In the second formula, you used the new velocity of the first bob. Use the old one."),
    ((0.4, -1.1), "If you compute the impulse, use 1 + e in place of e."),
    ((-1.76, 0.04), "These are the linear velocities. Convert them back to angular ones."),
    ((-11.0, 0.25), "You forgot to convert to linear velocities. You only converted back."),
    ((-0.704, 0.016), "You converted to linear velocities twice. The second time, convert back."),
    ((-2.0, 4.0), "You exchanged the velocities. That is right only for equal masses and e = 1."),
    ((-12.0, 10.5), "The sum of the masses needs brackets: you divided only by m1."),
    ((-22.0, 0.5), "You forgot to divide by the sum of the masses."),
    ((-5.5, 0.125), "You divided by the product of the masses. Divide by their sum."),
    ((-110.0, 2.5), "You multiplied by the sum of the masses. Divide by it."),
    ((-27.5, 0.625), "You divided by r_param twice. v is r_param times omega."),
    ((-5.0, 0.0), "This is the result with //, which rounds down. Use /."),
    ((4.0, -2.0), "You returned the old velocities."),
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
        hints = [(arguments[1:3], "You returned the old velocities.")]
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

LENGTH = 4.0  # m; with it, the distances below have no rounding errors
LEFT, HITS, MISSES = 4.0, (1.0, 3.0), (4.0, 0.0)  # omega of pend1 before; omegas of both after, with e = 0.5


def pair(distance=(1.0, 0.0, 0.0), radius1=0.5, radius2=0.5, values1=None, values2=None):
    """Return two pendula that hang straight down; distance (x, y, z in m) is between their axles. pend1 moves."""
    pend1 = hang(r_param=LENGTH, radius=radius1, **{"omega": LEFT, "e": 0.5, **(values1 or {})})
    pend2 = hang(r_param=LENGTH, axle=distance, radius=radius2, **{"e": 0.5, **(values2 or {})})
    return pend1, pend2


def check_pair(gives, *arguments, hints=(), **values):
    """Check the omegas of two such pendula after the call."""
    pend1, pend2 = pair(*arguments, **values)

    def see(_):
        return pend1["omega"], pend2["omega"]

    what = "omega of pend1 and of pend2"
    before = pend1["omega"], pend2["omega"]
    if gives != before:
        hints = [
            *hints,
            (before, "The bobs touch, but no omega has changed."),
            ((before[0], gives[1]), "omega of pend1 has not changed."),
            ((gives[0], before[1]), "omega of pend2 has not changed."),
        ]
    expect("handle_two_bobs", pend1, pend2, LENGTH, gives=gives, see=see, what=what, hints=hints)


# Two bobs with different values, their omegas after the hit, and the results of common mistakes; by hand.
MEETING = {"values1": {"omega": 3.0, "mass": 2.0, "e": 0.25}, "values2": {"omega": 1.0, "mass": 6.0, "e": 0.25}}
MET, MEETING_HINTS = (
    (1.125, 1.625),
    [
        ((1.75, 2.25), "This is the result with equal masses."),
        ((2.375, 2.875), "You exchanged the masses."),
        ((2.875, 2.375), "This is the result with exchanged omegas."),
        ((0.1875, 0.9375), "This is the result with omega2 = 0, but omega of pend2 is 1."),
        ((0.0, 2.0), "This is the result with e = 1, but e of pend1 is 0.25."),
        ((1.5, 1.5), "This is the result with e = 0, but e of pend1 is 0.25."),
        ((1.625, 1.125), "You exchanged the new omegas of pend1 and pend2."),
    ],
)


def is_other_order(came):
    """Return whether handle_collision gives this for MEETING with its arguments in a wrong order.

    It is the student's own function. It is correct: handle_two_bobs waits for it.
    """
    collide = find("handle_collision")
    return any(same(came, collide(*order)) for order in permutations((0.25, 3.0, 1.0, 2.0, 6.0, LENGTH)))


@check("handle_two_bobs", watched=True)
def test_masses_and_omegas_are_those_of_each():
    """For each pendulum dictionary, get the masses, bobs and angular velocity (omega)."""
    other_order = "Check the order of the arguments of handle_collision: e, omega1, omega2, m1, m2, r_param."
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
    check_pair(HITS, (1.02, 0, 0), hints=[(MISSES, "These bobs are within the buffer. Did you forget 1.05?")])
    buffer = "Multiply the whole sum of both radii by 1.05, and nothing else."
    check_pair(HITS, (1.04, 0, 0), hints=[(MISSES, buffer)])
    # Every way to compute 1.05 times the sum of the radii gives exactly 21.
    just = [(MISSES, "At exactly 1.05 times the sum, bobs collide too: less than or equal, not rounded.")]
    check_pair(HITS, (21.0, 0, 0), 10.0, 10.0, hints=just)
    check_pair(HITS, (-1.0, 0, 0), hints=[(MISSES, "Here pend2 is to the left. Is your distance a magnitude?")])
    check_pair(HITS, (0.7, 0.7, 0), hints=[(MISSES, "Did you add the distances along x and y? Use the magnitude.")])
    check_pair(HITS, (0, 0, 1.0))
    lifted = [(MISSES, "Here the axles are further apart than the bobs. Only the bobs count.")]
    check_pair(HITS, values1={"theta": 0.3}, hints=lifted)
    check_pair(HITS, (1.5, 0, 0), values1={"theta": 0.2}, hints=lifted)
    check_pair(HITS, values1={"theta": 0.02}, values2={"theta": 0.03})


@check("handle_two_bobs", watched=True)
def test_bobs_that_do_not_touch_go_on():
    """We add a little bit of buffer to what is considered a 'collision'."""
    check_pair(MISSES, (9.0, 0, 0), hints=[(HITS, "These bobs are far apart, but your function lets them collide.")])
    check_pair(MISSES, (1.0504, 0, 0), hints=[(HITS, "Your buffer is too large, or your distance is too small.")])
    check_pair(MISSES, (-1.2, 0, 0), hints=[(HITS, "Here pend2 is to the left. A magnitude is never negative.")])
    along_x = [(HITS, "Did you use only the distance along x? Use the magnitude.")]
    check_pair(MISSES, (0.8, 0.8, 0), hints=along_x)
    check_pair(MISSES, (0, 1.2, 0), hints=along_x)
    lifted = [(HITS, "Here the axles are close, but the bobs are not. Only the bobs count.")]
    check_pair(MISSES, values1={"theta": -0.3}, values2={"theta": 0.3}, hints=lifted)


@check("handle_two_bobs", watched=True)
def test_both_radii_count():
    """You can access positions and radii of VPython objects with bob.pos and bob.radius."""
    one_radius = [
        (HITS, "These bobs have different radii. Do you add both?"),
        (MISSES, "These bobs have different radii. Do you add both?"),
    ]
    check_pair(HITS)
    check_pair(HITS, (1.0, 0, 0), 0.9, 0.2, hints=one_radius)
    check_pair(HITS, (1.0, 0, 0), 0.2, 0.9, hints=one_radius)
    check_pair(MISSES, (1.0, 0, 0), 0.2, 0.7, hints=one_radius)
    check_pair(MISSES, (1.0, 0, 0), 0.7, 0.2, hints=one_radius)
    check_pair(MISSES, (1.0, 0, 0), 0.05, 0.05, hints=[(HITS, "These bobs are small. Do you use their radii?")])
    check_pair(HITS, (3.1, 0, 0), 2.0, 1.0, hints=[(MISSES, "These bobs are large. Use 1.05 as a factor.")])


@check("handle_two_bobs", watched=True)
def test_e_is_the_first_pendulums():
    """From only the first dictionary, get the coefficient of restitution."""
    hints = [
        ((0.0, 4.0), "This is the result with e = 1, but e of pend1 is 0.5."),
        ((2.0, 2.0), "This is the result with e = 0, but e of pend1 is 0.5."),
        ((0.5, 3.5), "This is the result with the mean of both e. Use only e of pend1."),
    ]
    check_pair((1.0, 3.0), values1={"e": 0.5}, values2={"e": 1.0}, hints=hints)
    hints = [((1.0, 3.0), "This is the result with e = 0.5, but e of pend1 is 1.")]
    check_pair((0.0, 4.0), values1={"e": 1.0}, values2={"e": 0.5}, hints=hints)
    hints = [((0.0, 4.0), "This is the result with e = 1, but e of pend1 is 0.")]
    check_pair((2.0, 2.0), values1={"e": 0}, values2={"e": 1.0}, hints=hints)
    # pend1 counts, even if pend2 is heavier, faster, or on the left.
    check_pair((2.5, 4.5), values1={"e": 0.5, "mass": 3.0}, values2={"e": 1.0})
    check_pair((-0.5, 1.5), values1={"e": 0.5}, values2={"e": 1.0, "mass": 3.0})
    check_pair((-3.0, -1.0), values1={"e": 0.5, "omega": 0.0}, values2={"e": 1.0, "omega": -4.0})
    check_pair((1.0, 3.0), (-1.0, 0, 0), values1={"e": 0.5}, values2={"e": 1.0})


@check("handle_two_bobs", watched=True)
def test_bobs_that_touch_collide_whatever_their_velocities_are():
    """If true, use the helper function handle_collision to get the new angular velocity values for both pendula."""
    check_pair(HITS)
    hints = [((-1.0, 2.0), "These bobs move apart, but they touch. In the handout, they collide too.")]
    check_pair((1.25, -0.25), values1={"omega": -1.0}, values2={"omega": 2.0}, hints=hints)
    check_pair((-2.25, -0.75), values1={"omega": 0.0}, values2={"omega": -3.0})
    check_pair((-2.5, -1.5), values1={"omega": -1.0}, values2={"omega": -3.0})
    check_pair((1.75, 3.25), values2={"omega": 1.0})
    check_pair((0.001, 0.003), values1={"omega": 0.004})


def all_but_omega(pend1, pend2):
    """Return all values of two pendula except omega, with the positions and radii of their bobs."""
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

        what = "changed values, without omega"
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

        what = "omega of pend1 and of pend2 (each call starts from the last omegas)"
        expect("handle_two_bobs", pend1, pend2, LENGTH, gives=gives, see=omegas, what=what)
