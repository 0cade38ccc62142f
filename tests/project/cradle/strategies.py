"""Random values for the project's tests, which are the same in each run."""

import pytest
from hypothesis import given, HealthCheck, Phase, settings
from hypothesis import strategies as st
from programs import slow_except

from grading.cradles import R
from support.pendulum import BUFFER

ALWAYS_THE_SAME = settings(
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=[HealthCheck.too_slow],
    # Without Phase.shrink, which looks for the smallest example that fails: it can take minutes
    phases=[Phase.explicit, Phase.generate],
)


def random_examples(*counts, **strategies):
    """Run a test with this number of values of these strategies; a second count is for CI."""

    def decorate(test):
        @pytest.mark.parametrize("count", slow_except(counts[:1], counts))
        def run(count):
            settings(ALWAYS_THE_SAME, max_examples=count)(given(**strategies)(test))()

        return run

    return decorate


def powers(base, least, most):
    """Powers of the base; both exponents are in the range."""
    return st.floats(least, most).map(lambda exponent: base**exponent)


RESTITUTIONS = st.sampled_from([0, 1]) | st.floats(0, 1)

# --- double pendula -----------------------------------------------------------------------------

# theta, phi, omega, phi_omega, mass and e of a pendulum
TURNS = st.floats(-9, 9)  # rad, or rad/s
DOUBLE_PENDULA = st.tuples(TURNS, TURNS, TURNS, TURNS, powers(10, -3, 3), RESTITUTIONS)

# Two pendula, a bob of each (0 upper, 1 lower), and their distance: at 1, they touch
BOBS = st.sampled_from([0, 1])
DISTANCES = st.sampled_from([0.99, 0.99, 1.01])
DOUBLE_HITS = st.tuples(DOUBLE_PENDULA, DOUBLE_PENDULA, st.tuples(BOBS, BOBS), DISTANCES)


# --- the fast path ------------------------------------------------------------------------------


@st.composite
def pendulum_rows(draw):
    """Return arguments of hang for up to 12 pendula, which move almost together or not at all."""
    spread = draw(st.sampled_from([1, 1, 1e-3, 1e-6, 0]))
    angles = st.floats(-1, 1)
    rates = st.floats(-5, 5) | st.floats(-100, 100)
    offsets = st.sampled_from([0, 0.01])
    sizes = st.sampled_from([1, 1.01]) | st.floats(0.5, 1.1)
    theta, omega = draw(angles), draw(rates)
    row = []
    for i in range(12 - draw(st.integers(0, 11))):
        pendulum = {
            "theta": theta + spread * draw(angles),
            "omega": omega + spread * draw(rates),
            "mass": draw(powers(10, -2, 2)),
            "e": draw(RESTITUTIONS),
            "axle": (i * R / 4, draw(offsets), draw(offsets)),
            "radius": 0.9995 * R / 8 / BUFFER * draw(sizes),
        }
        row.append(pendulum)
    return row


CALLS = st.fixed_dictionaries(  # of do_ticks
    {
        "r_param": st.sampled_from([R, 2 * R]),
        "dt": st.sampled_from([1e-4, 1e-3]),
        "g": st.sampled_from([9.81, 100]),
        "ticks": st.sampled_from([2000, 1000, 500, 10, 1]),
        "separating": st.booleans(),
    }
)

# theta (rad), the place of the first axle (m), and the factors of the radii
FACTORS = st.sampled_from([1, 1 + 1e-15, 1 + 1e-14, 1 - 1e-15, 1 - 1e-14])
HAIRS = st.tuples(st.floats(-1, 1), st.sampled_from([1, 1000]), FACTORS, FACTORS)
