"""B tests: what happens to two pendula when they knock into each other."""

import pytest
from cradles import hang
from vpython import vector

from src import visualize_cradle_run

# e, omega1, omega2, m1, m2 -> new_omega1, new_omega2; by hand from the appendix's two formulas.
COLLISIONS = [
    (1, 3.0, 0.0, 1.0, 1.0, 0.0, 3.0),  # equal masses, elastic: the velocities change places
    (1, 2.0, -5.0, 0.7, 0.7, -5.0, 2.0),
    (0, 3.0, 0.0, 1.0, 1.0, 1.5, 1.5),  # inelastic: both go on together
    (0.5, 4.0, 0.0, 1.0, 1.0, 1.0, 3.0),
    (1, 4.0, 0.0, 1.0, 3.0, -2.0, 2.0),  # a light bob bounces off a heavy one
    (1, 4.0, 0.0, 3.0, 1.0, 2.0, 6.0),  # a heavy bob drives a light one ahead
    (0, 4.0, -2.0, 1.0, 2.0, 0.0, 0.0),  # opposite momenta, inelastic: all motion ends
    (0.25, 8.0, 0.0, 1.0, 3.0, 0.5, 2.5),
    (0.9, 2.0, 2.0, 1.0, 5.0, 2.0, 2.0),  # no approach, no change
    (0.5, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0),
]


@pytest.mark.parametrize("r_param", [0.2, 1.0, 3.0])
@pytest.mark.parametrize(("e", "omega1", "omega2", "m1", "m2", "new_omega1", "new_omega2"), COLLISIONS)
def test_handle_collision(e, omega1, omega2, m1, m2, new_omega1, new_omega2, r_param):
    """handle_collision returns a tuple of the new angular velocities of both bobs (new_omega1, new_omega2)."""
    result = visualize_cradle_run.handle_collision(e, omega1, omega2, m1, m2, r_param)
    assert isinstance(result, tuple)
    assert result == pytest.approx((new_omega1, new_omega2), abs=1e-12)


@pytest.mark.parametrize("e", [0, 0.3, 1])
@pytest.mark.parametrize(("m1", "m2"), [(1.0, 1.0), (0.2, 5.0), (7.0, 0.1)])
def test_laws_of_the_collision(e, m1, m2):
    """Linear momentum is conserved, e = (v2_new - v1_new) / (v1 - v2), and e = 1 conserves kinetic energy."""
    omega1, omega2, r_param = 2.5, -1.5, 0.4
    new1, new2 = visualize_cradle_run.handle_collision(e, omega1, omega2, m1, m2, r_param)
    assert m1 * new1 + m2 * new2 == pytest.approx(m1 * omega1 + m2 * omega2)
    assert new2 - new1 == pytest.approx(e * (omega1 - omega2), abs=1e-12)
    if e == 1:
        assert m1 * new1**2 + m2 * new2**2 == pytest.approx(m1 * omega1**2 + m2 * omega2**2)


def pair(distance, radius1=0.5, radius2=0.5, **values1):
    """Return two pendula, bobs of these radii with centres apart by the vector distance; the left one moves right."""
    pend1, pend2 = hang(**{"omega": 3.0, "mass": 1.0, "e": 1.0, **values1}), hang(omega=0.0, mass=1.0, e=1.0)
    for pend, pos, radius in ((pend1, vector(0, 0, 0), radius1), (pend2, vector(*distance), radius2)):
        pend["objects"][1].pos, pend["objects"][1].radius = pos, radius
    return pend1, pend2


def omegas_after(pend1, pend2, r_param=0.4):
    visualize_cradle_run.handle_two_bobs(pend1, pend2, r_param)
    return pend1["omega"], pend2["omega"]


HIT, MISS = (0.0, 3.0), (3.0, 0.0)


@pytest.mark.parametrize(
    ("distance", "radius1", "radius2", "expected"),
    [
        ((1.0, 0, 0), 0.5, 0.5, HIT),  # they touch
        ((1.04, 0, 0), 0.5, 0.5, HIT),  # a bit of buffer: 1.05 times the sum of the radii
        ((1.05, 0, 0), 0.5, 0.5, HIT),  # less than or equal
        ((1.06, 0, 0), 0.5, 0.5, MISS),
        ((9.0, 0, 0), 0.5, 0.5, MISS),
        ((0.2, 0, 0), 0.5, 0.5, HIT),
        ((-1.0, 0, 0), 0.5, 0.5, HIT),  # a magnitude has no sign
        ((-1.2, 0, 0), 0.5, 0.5, MISS),
        ((0.8, 0.8, 0), 0.5, 0.5, MISS),  # a distance in the plane, not along x alone
        ((0.7, 0.7, 0), 0.5, 0.5, HIT),
        ((0.7, 0.0, 0.9), 0.5, 0.5, MISS),
        ((0.0, 1.2, 0), 0.5, 0.5, MISS),
        ((1.0, 0, 0), 0.9, 0.2, HIT),  # both radii count
        ((1.0, 0, 0), 0.2, 0.9, HIT),
        ((1.0, 0, 0), 0.2, 0.7, MISS),
        ((1.0, 0, 0), 0.7, 0.2, MISS),
    ],
)
def test_bobs_collide_within_105_percent_of_the_radii(distance, radius1, radius2, expected):
    """Check if the magnitude of the difference in positions is at most 1.05 times the sum of the bobs' radii."""
    assert omegas_after(*pair(distance, radius1, radius2)) == pytest.approx(expected, abs=1e-12)


def test_e_is_the_first_pendulums():
    """From only the first dictionary, get the coefficient of restitution."""
    pend1, pend2 = pair((1, 0, 0), e=0.5, omega=4.0)
    assert omegas_after(pend1, pend2) == pytest.approx((1.0, 3.0))


@pytest.mark.parametrize(("mass1", "mass2", "expected"), [(1.0, 3.0, (-2.0, 2.0)), (3.0, 1.0, (2.0, 6.0))])
def test_each_pendulum_has_its_mass(mass1, mass2, expected):
    """For each pendulum dictionary, get the masses, bobs and angular velocity (omega)."""
    pend1, pend2 = pair((1, 0, 0), omega=4.0, mass=mass1)
    pend2["mass"] = mass2
    assert omegas_after(pend1, pend2) == pytest.approx(expected)


def test_the_second_pendulums_omega_counts():
    """For each pendulum dictionary, get the angular velocity (omega); update both dictionaries with the new values."""
    pend1, pend2 = pair((1, 0, 0), omega=1.0)
    pend2["omega"] = -2.0
    assert omegas_after(pend1, pend2) == pytest.approx((-2.0, 1.0))


def test_the_handout_does_not_ask_whether_bobs_approach():
    """If true, get the new angular velocity values: whatever the velocities are."""
    pend1, pend2 = pair((1, 0, 0), omega=-1.0)
    pend2["omega"] = 2.0
    assert omegas_after(pend1, pend2) == pytest.approx((2.0, -1.0))


def test_only_omega_changes():
    """Update both dictionaries with their respective new omega values, and nothing else."""
    pend1, pend2 = pair((1, 0, 0))
    before = [{name: pend[name] for name in pend if name != "omega"} for pend in (pend1, pend2)]
    positions = [pend["objects"][1].pos.value for pend in (pend1, pend2)]
    omegas_after(pend1, pend2)
    assert [{name: pend[name] for name in pend if name != "omega"} for pend in (pend1, pend2)] == before
    assert [pend["objects"][1].pos.value for pend in (pend1, pend2)] == positions
