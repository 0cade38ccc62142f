"""B checks: two pendula knock into each other."""

if __name__ == "__main__":
    raise SystemExit("These are checks. Type pytest to run them.")

from itertools import cycle, product
from math import pi

from grading.comparing import same
from grading.cradles import hang
from grading.grader import check, expect, result_of

# The arguments e, omega1, omega2, m1, m2, and the result; by hand from the two formulas of the appendix.
HIT, AFTER = (0.7, 3.0, -4.0, 2.0, 8.0), (-6.52, -1.62)
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
    ((0.5, 1.0, 0.0, 4.9, 5.1), (0.235, 0.735)),  # masses nearly equal
    ((0.5, 1.0, 0.0, 0.25, 249.75), (-0.4985, 0.0015)),  # masses very far apart
    ((0.5, 1.0, 0.0, 249.75, 0.25), (0.9985, 1.4985)),
    ((0.5, 4e-8, 0.0, 1.0, 1.0), (1e-8, 3e-8)),  # slowly
    ((0.5, 400.0, 0.0, 1.0, 1.0), (100.0, 300.0)),  # fast
]


@check("handle_collision")
def test_handle_collision():
    """Returns a tuple of the new angular velocities of both bobs."""
    expect("handle_collision", *HIT, 0.4, wanted=AFTER)


@check("handle_collision")
def test_collisions_from_elastic_to_inelastic():
    """If e = 0, it is a perfectly inelastic collision; if e = 1, elastic."""
    for arguments, wanted in COLLISIONS:
        expect("handle_collision", *arguments, 0.4, wanted=wanted)


@check("handle_collision")
def test_the_cord_length_does_not_matter():
    """Convert omega to linear velocities v = R omega, and back."""
    for r_param in (0.2, 1.0, 3.0):
        expect("handle_collision", *HIT, r_param, wanted=AFTER)


@check("handle_collision")
def test_laws_of_the_collision():
    """The system should conserve kinetic energy and linear momentum."""
    omega1, omega2 = 2.5, -1.5
    for m1, m2 in [(1.0, 1.0), (0.2, 5.0), (7.0, 0.1)]:
        momentum, energy = m1 * omega1 + m2 * omega2, m1 * omega1**2 + m2 * omega2**2
        laws = [("momentum m1 new_omega1 + m2 new_omega2", 1, momentum)] * 3
        energy_law = ("energy m1 new_omega1^2 + m2 new_omega2^2", 2, energy)
        for e, (what, power, wanted) in zip((0, 0.3, 1, 1), [*laws, energy_law], strict=True):

            def see(new, m1=m1, m2=m2, power=power):
                return m1 * new[0] ** power + m2 * new[1] ** power

            expect("handle_collision", e, omega1, omega2, m1, m2, 0.4, wanted=wanted, see=see, what=what)


# --- handle_two_bobs -------------------------------------------------------------------------------------------------

# omega of pend1 before, and the omegas of both after, with e = 0.5 and equal masses.
LEFT, HITS, MISSES = 4.0, (1.0, 3.0), (4.0, 0.0)


def pair(apart=1.0, radius1=0.5, radius2=0.5, values1=None, values2=None):
    """Return two pendula. Their axles are apart (m), and the cords 4 times as long, as in a cradle. pend1 moves."""
    pend1 = hang(r_param=4 * apart, radius=radius1, **{"omega": LEFT, "e": 0.5, **(values1 or {})})
    pend2 = hang(r_param=4 * apart, axle=(apart, 0, 0), radius=radius2, **{"e": 0.5, **(values2 or {})})
    return pend1, pend2


def check_pair(wanted, apart=1.0, *radii, **values):
    """Check the omegas of two such pendula after the call."""
    pend1, pend2 = pair(apart, *radii, **values)
    expect("handle_two_bobs", pend1, pend2, 4 * apart, wanted=wanted, **omegas(pend1, pend2))


def omegas(pend1, pend2):
    """Return options of expect to compare both omegas after the call."""
    return {"see": lambda _: (pend1["omega"], pend2["omega"]), "what": "omega of pend1, omega of pend2"}


def check_places(wanted, theta1, theta2, apart=1.0):
    """Check whether two bobs at these angles collide."""
    check_pair(wanted, apart, values1={"theta": theta1}, values2={"theta": theta2})


# Two bobs with different values, and their omegas after the hit, by hand.
MEETING = {"values1": {"omega": 3.0, "mass": 2.0, "e": 0.25}, "values2": {"omega": 1.0, "mass": 6.0, "e": 0.25}}
MET = (1.125, 1.625)


@check("handle_two_bobs")
def test_masses_and_omegas_are_those_of_each():
    """For each pendulum dictionary, get the masses, bobs and angular velocity (omega)."""
    check_pair(MET, **MEETING)
    check_pair((-0.5, 1.5), values2={"mass": 3.0})
    check_pair((2.5, 4.5), values1={"mass": 3.0})
    check_pair((-0.5, 2.5), values2={"omega": -2.0})


@check("handle_two_bobs")
def test_bobs_that_touch_collide():
    """Check if the bobs are at most 1.05 times the sum of their radii apart."""
    for apart in (1.0, 0.2, 1.02, 1.04):
        check_places(HITS, 0, 0, apart)
    check_pair(HITS, 21.0, 10.0, 10.0)  # every way to compute 1.05 times the sum of the radii gives exactly 21
    check_places(HITS, 0.25, -0.25)  # bob 2 is to the left of bob 1
    check_places(HITS, 0.15, 0.0, 1.5)  # the distance of the axles does not matter
    for thetas in ((0.3, 0.0), (0.02, 0.03), (1.25, 1.05), (-1.05, -1.25)):  # the last two are on a diagonal
        check_places(HITS, *thetas)
    check_places(HITS, pi / 2, pi / 2)  # level
    check_places(HITS, 2.0, 2.1)  # above the axles
    check_places(HITS, 2.0 - 4 * pi, 2.1 + 2 * pi)  # turned more than once


@check("handle_two_bobs")
def test_bobs_that_do_not_touch_go_on():
    """We add a little bit of buffer to what is considered a 'collision'."""
    for apart in (9.0, 1.0504):
        check_places(MISSES, 0, 0, apart)
    for thetas in ((0.28, -0.28), (-0.3, 0.3), (1.5, 1.64), (1.64, 1.5), (2.05, 2.45), (2.0, 1.93)):
        check_places(MISSES, *thetas)


@check("handle_two_bobs")
def test_both_radii_count():
    """You can access positions and radii of VPython objects with bob.pos and bob.radius."""
    check_pair(HITS)
    for sizes in ((1.0, 0.9, 0.2), (1.0, 0.2, 0.9)):
        check_pair(HITS, *sizes)
    for sizes in ((1.0, 0.2, 0.7), (1.0, 0.7, 0.2), (1.0, 0.05, 0.05)):
        check_pair(MISSES, *sizes)


@check("handle_two_bobs")
def test_e_is_the_first_pendulums():
    """From only the first dictionary, get the coefficient of restitution."""
    check_pair((1.0, 3.0), values1={"e": 0.5}, values2={"e": 1.0})
    check_pair((0.0, 4.0), values1={"e": 1.0}, values2={"e": 0.5})
    check_pair((2.0, 2.0), values1={"e": 0}, values2={"e": 1.0})
    # pend1 counts, even if pend2 is heavier, faster, or has its bob on the left.
    check_pair((2.5, 4.5), values1={"e": 0.5, "mass": 3.0}, values2={"e": 1.0})
    check_pair((-0.5, 1.5), values1={"e": 0.5}, values2={"e": 1.0, "mass": 3.0})
    check_pair((-3.0, -1.0), values1={"e": 0.5, "omega": 0.0}, values2={"e": 1.0, "omega": -4.0})
    check_pair((1.0, 3.0), values1={"e": 0.5, "theta": 0.25}, values2={"e": 1.0, "theta": -0.25})


@check("handle_two_bobs")
def test_bobs_that_touch_collide_whatever_their_velocities_are():
    """If true, use the helper function handle_collision to get the new angular velocity values for both pendula."""
    check_pair(HITS)
    check_pair((1.25, -0.25), values1={"omega": -1.0}, values2={"omega": 2.0})
    check_pair((-2.25, -0.75), values1={"omega": 0.0}, values2={"omega": -3.0})
    check_pair((-2.5, -1.5), values1={"omega": -1.0}, values2={"omega": -3.0})
    check_pair((1.75, 3.25), values2={"omega": 1.0})
    check_pair((1e-8, 3e-8), values1={"omega": 4e-8})
    for (e, mass), omega in zip(product((0, 0.1, 0.5, 0.9, 0.98, 1), (0.05, 1.0, 3.0, 600.0)), cycle((-5.0, 0.0, 6.0))):
        wanted = result_of("handle_collision", e, LEFT, omega, 1.0, mass, 4.0)
        check_pair(wanted, values1={"e": e}, values2={"e": 0.25, "mass": mass, "omega": omega})


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
    for apart in (1.0, 2.0):
        pends = pair(apart, values1={"mass": 2.0, "theta": 0.01}, values2={"e": 0.9, "theta": 0.02})

        before = all_but_omega(*pends)

        def changed(_, pends=pends, before=before):
            now = all_but_omega(*pends)
            return {key: now.get(key) for key in before | now if not same(now.get(key), before.get(key))}

        what = "changed values (besides omega)"
        expect("handle_two_bobs", *pends, 4 * apart, wanted={}, see=changed, what=what)


@check("handle_two_bobs")
def test_earlier_calls_do_not_matter():
    """Handles the pairwise interactions between two bobs."""
    pend1, pend2 = pair()
    for wanted in ((1.0, 3.0), (2.5, 1.5), (1.75, 2.25)):
        expect("handle_two_bobs", pend1, pend2, 4.0, wanted=wanted, **omegas(pend1, pend2))
