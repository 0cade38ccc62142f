"""A checks: the tick, and a cradle that runs by it."""

from math import pi

from cradles import hang, R, row
from grader import check, expect, same
from telling import A

SHORT = 1e-9  # s: in such a tick nothing moves that could be seen


def check_tick(pend_list, gives, *, dt=SHORT, g=9.81, hints=()):
    """Check the omegas after a tick."""

    def see(_):
        return [pend["omega"] for pend in pend_list]

    hints = [*hints, ([pend["omega"] for pend in pend_list], "These are the velocities from before.")]
    what = "omega of each pendulum"
    expect("newton_cradle_tick", pend_list, R, dt, g, gives=gives, see=see, what=what, hints=hints)


def touching(*omegas, radius=R / 8):
    """Return pendula that hang straight down and touch, with these angular velocities (rad/s)."""
    pend_list = row(len(omegas), radius=radius)
    for pend, omega in zip(pend_list, omegas, strict=True):
        pend["omega"] = omega
    return pend_list


@check("newton_cradle_tick", watched=True)
def test_a_tick_swings_all_pendula():
    """Update the swings of all the pendula."""
    pend_list = [hang(theta=pi / 6, omega=2.0, axle=(i * 1.0, 0, 0), r_param=0.5) for i in range(3)]
    before, once = (2.0, pi / 6), (1.0, pi / 6 + 0.1)
    twice = (-0.167919, pi / 6 + 0.0832081)
    hints = [
        ([before] * 3, "No pendulum has swung."),
        (
            lambda came: all(abs(a - b) < 1e-5 for state in came for a, b in zip(state, twice, strict=True)),
            "All have swung twice.",
        ),
        ([once, before, before], "Only the first pendulum has swung."),
        ([once, once, before], "The last pendulum has not swung; it has no pair, but it swings."),
        (lambda came: same(came, came[:1] * 3), "Are r_param, dt and g handed on, in this order?"),
    ]

    def see(_):
        return [(pend["omega"], pend["theta"]) for pend in pend_list]

    what = "omega and theta of each pendulum"
    expect("newton_cradle_tick", pend_list, 0.5, 0.1, 10.0, gives=[once] * 3, see=see, what=what, hints=hints)


@check("newton_cradle_tick", watched=True)
def test_each_pendulum_is_handled_with_the_one_after_it():
    """For each pendulum (except the last) handle the pairwise interaction of that pendulum and the one after it."""
    hints = [
        ([2.0, 1.0, 3.0], "Only the first pair has been handled."),
        ([1.0, 3.0, 2.0], "Only the last pair has been handled."),
        ([3.0, 1.0, 2.0], "The pairs are handled from the right; they are to be from the left."),
        ([1.0, 2.0, 3.0], "These are the velocities from before: has no pair been handled, or each one twice?"),
    ]
    check_tick(touching(1.0, 2.0, 3.0), [2.0, 3.0, 1.0], hints=hints)
    check_tick(touching(3.0, 0.0), [0.0, 3.0])
    check_tick(touching(3.0, 0.0, 0.0, 0.0, 0.0), [0.0, 0.0, 0.0, 0.0, 3.0])
    check_tick(touching(0.0, 0.0, 3.0), [0.0, 3.0, 0.0])  # from the right it gets one place along a tick
    check_tick(touching(0.0, 0.0, -3.0), [0.0, -3.0, 0.0])
    check_tick(touching(-1.0, -2.0, -3.0), [-2.0, -3.0, -1.0])


@check("newton_cradle_tick", watched=True)
def test_only_neighbours_are_pairs():
    """We can approach the entire sequence of pendula in a pairwise manner, so we only consider the collision of two
    pendula.
    """
    hints = [([3.0, 2.0, 1.0], "All bobs touch here, as they are large; but pairs are neighbours only.")]
    check_tick(touching(1.0, 2.0, 3.0, radius=R / 3), [2.0, 3.0, 1.0], hints=hints)


@check("newton_cradle_tick", watched=True)
def test_a_cradle_may_have_any_number_of_pendula():
    """Feel free to play around with the values and the number of pendulums."""
    check_tick([hang(theta=pi / 6, omega=2.0)], [0.75], dt=0.1, g=10.0)
    check_tick([], [])
    check_tick(touching(*[1.0] * 6, 0.0), [*[1.0] * 5, 0.0, 1.0])
    check_tick(touching(0.004, *[0.0] * 9), [*[0.0] * 9, 0.004])


@check("newton_cradle_tick", watched=True)
def test_the_pairs_use_masses_and_restitution():
    """(Hint: Use another function you already wrote!)"""
    pend_list = touching(4.0, 0.0, 0.0)
    pend_list[0]["e"], pend_list[1]["mass"], pend_list[2]["mass"] = 0.5, 3.0, 3.0
    check_tick(pend_list, [-0.5, 0.0, 1.5])


@check("newton_cradle_tick", watched=True)
def test_bobs_that_do_not_touch_are_left_alone():
    """The Newton's cradle is defined by the collisions between its pendula."""
    pend_list = row(3)
    pend_list[0]["omega"] = -1.0
    check_tick(pend_list, [-1.0, 0.0, 0.0])


@check("newton_cradle_tick", watched=True)
def test_swings_come_before_collisions():
    """Performs a single timestep or tick of the Newton's cradle."""
    check_tick(touching(1.0, 0.0), [0.0, 1.0])
    pend_list = [hang(theta=-0.1, omega=1.0, radius=R / 8), hang(axle=(R / 4, 0, 0), radius=R / 8)]
    hints = [([1.0, 0.0], "The swing brings these bobs together: it comes first, and then the collision.")]
    check_tick(pend_list, [0.0, 1.0], dt=0.1, g=0.0, hints=hints)
    pend_list = [hang(radius=R / 8), hang(theta=0.1, omega=-1.0, axle=(R / 4, 0, 0), radius=R / 8)]
    hints = [([0.0, -1.0], "It is the second one that comes to the first here: all swing before any collide.")]
    check_tick(pend_list, [-1.0, 0.0], dt=0.1, g=0.0, hints=hints)


@check("newton_cradle_tick", watched=True)
def test_a_cradle_passes_the_swing_on():
    """A Newton's cradle is a series of pendula that display a "chain reaction" when each pendulum knocks into the
    pendulum next to it.
    """
    cord, lift = 0.2, pi / 4
    pend_list = [hang(theta=-lift if i == 0 else 0.0, axle=(i * cord / 4, 0, 0), r_param=cord) for i in range(5)]

    def see(_):
        return [pend["theta"] for pend in pend_list]

    def is_passed_on(thetas):
        return abs(thetas[-1] / lift - 1) < 0.02 and all(abs(theta) < 0.1 for theta in thetas[:-1])

    half_a_period = 234  # ticks; 0.467 s, a bit more than pi sqrt(R / g), as the swing is large
    gives = A("the last one at about 0.785, as high as the first one was, the others at about 0", is_passed_on)
    what = "theta of each pendulum"
    arguments = {"gives": gives, "see": see, "what": what, "times": half_a_period}
    expect("newton_cradle_tick", pend_list, cord, 0.002, 9.81, **arguments)
