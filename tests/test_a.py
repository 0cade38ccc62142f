"""A checks: the tick, a cradle that runs by it, and the program that makes the cradle and lets it run."""

from itertools import permutations
from math import degrees, pi

from grading.cradles import hang, R, row
from grading.grader import check, expect, find, same
from grading.telling import Wanted
from support.constants import DT, G, NC_FP, R_PARAM, THETA_INIT
from support.files.cradle_csv import read_cells

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
        ([2.0, 1.0, 3.0], "Only the first pair has been handled: a return in the loop, or i - 1 in place of i + 1?"),
        ([1.0, 3.0, 2.0], "Only the last pair has been handled."),
        ([3.0, 1.0, 2.0], "The pairs are handled from the right; they must be from the left."),
        ([1.0, 2.0, 3.0], "These are the velocities from before: has no pair been handled, or each one twice?"),
    ]
    check_tick(touching(1.0, 2.0, 3.0), [2.0, 3.0, 1.0], hints=hints)
    twice = "These two have been handled twice: pend_list[-1], or [i - 1] if i is 0, is the last pendulum."
    check_tick(touching(3.0, 0.0), [0.0, 3.0], hints=[([3.0, 0.0], twice)])
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
    hints = [
        ([-2.0, 0.0, 2.0], "This is what e = 1 gives here: the e of a pair is that of the left one, which comes first.")
    ]
    check_tick(pend_list, [-0.5, 0.0, 1.5], hints=hints)


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
    words = "the last one at about 0.785, as high as the first one was, the others at about 0"
    gives = Wanted(words, is_passed_on, like=[0.0] * 5)
    what = "theta of each pendulum"
    arguments = {"gives": gives, "see": see, "what": what, "times": half_a_period}
    expect("newton_cradle_tick", pend_list, cord, 0.002, 9.81, **arguments)


# --- main ------------------------------------------------------------------------------------------------------------


class Page:
    """A page that the main of a check is given: it says what is due, round by round, and notes what it is shown."""

    csv, rule = NC_FP, {}

    def __init__(self, *rounds, change=lambda pend_list: None):
        """rounds are those of the outer loop, each as (is a cradle wanted, how many ticks are due).

        change(pend_list) is what happens to a cradle when it is shown.
        """
        self.rounds, self.change = rounds, change
        self.begun, self.asked, self.ticks = 0, False, 0
        self.shown: list = []  # the cradles
        self.states: list = []  # (omega, theta) of the first pendulum each time that wants_tick is called

    def __repr__(self):
        return "a page that wants " + ", then ".join(
            f"{'a cradle and ' * wants_cradle}{ticks} tick{'s' * (ticks != 1)}" for wants_cradle, ticks in self.rounds
        )

    def is_running(self):
        self.begun += 1
        if self.begun <= len(self.rounds):
            self.asked, self.ticks = self.rounds[self.begun - 1]
        return self.begun <= len(self.rounds)

    def wants_cradle(self):
        return self.asked

    def show(self, pend_list):
        self.shown.append(pend_list if isinstance(pend_list, list) else [])
        self.change(self.shown[-1])

    def wants_tick(self):
        self.states += [(pend["omega"], pend["theta"]) for cradle in self.shown[-1:] for pend in cradle[:1]]
        self.ticks -= 1
        return self.ticks >= 0


def pendula() -> int:
    """Return how many pendula the shipped file has, or 0 if it cannot be read: then main says why."""
    try:
        return len(read_cells(NC_FP)) - 1
    except ValueError:
        return 0


def swings(ticks, r_param=R_PARAM, dt=DT, g=G):
    """Return (omega, theta) of a pendulum that is let go at THETA_INIT, at the beginning and after each tick.

    It moves by the student's own function for one pendulum, which is right: main waits for it.
    """
    move, states = find("angle_update"), [(0.0, THETA_INIT)]
    while len(states) <= ticks:
        states.append(move(*states[-1], r_param, dt, g))
    return states


@check("main")
def test_the_cradle_is_made_and_shown():
    """Use a helper function you wrote before to create the pend_list that you will use for the entire Newton's cradle.
    Remember to use the appropriate constants from constants.py when calling this function!
    """
    page = Page((True, 0))

    def see(_):
        return [[(pend["theta"], length_of_cord(pend)) for pend in cradle] for cradle in page.shown]

    def length_of_cord(pend):
        return pend["objects"][2].axis.mag if "objects" in pend else None

    def made(theta_init, r_param=R_PARAM):
        return [[(0 if i else theta_init, abs(r_param)) for i in range(pendula())]]

    hints = [
        ([], "The page was shown no cradle: give it yours with page.show."),
        ([[]], "What the page was shown is no pend_list, or an empty one."),
        (lambda came: came[0][0][1] is None, "These pendula have no objects: make_newton_cradle makes them."),
        (made(R_PARAM, THETA_INIT), "make_newton_cradle takes R_PARAM first, and then THETA_INIT."),
        (made(degrees(THETA_INIT)), "THETA_INIT is in rad, as make_newton_cradle wants it."),
        (lambda came: came[0][0][0] != THETA_INIT, "The first pendulum must be lifted to THETA_INIT."),
        (lambda came: not same(came[0][0][1], R_PARAM), "The cords must be R_PARAM long."),
    ]
    what = "of each cradle that was shown, theta of each pendulum and the length of its cord"
    expect("main", page, gives=made(THETA_INIT), see=see, what=what, hints=hints)


@check("main")
def test_the_cradle_ticks():
    """In the (partially provided) while loop (i.e., while the simulation is still running), call a helper function with
    arguments from constants.py to perform a single tick of the Newton's cradle.
    """
    page = Page((True, 2), (False, 1))
    start, first, second, third = swings(3)

    def is_other_order(came):
        orders = list(permutations((R_PARAM, DT, G)))[1:]
        return any(same(came[:2], swings(1, *order)) for order in orders)

    hints = [
        ([], "The page was asked for no tick, or shown no cradle."),
        ([start] * 5, "The cradle that is shown does not tick."),
        ([start, first], "The cradle must tick as long as page.wants_tick() says so: while, not if."),
        ([start, first, second, start, first], "The cradle is made again, though the page wants none."),
        (lambda came: same(came[0], first), "The cradle ticks before a tick is due."),
        (lambda came: same(came[1], second), "Each time a tick is due, the cradle ticks twice."),
        (is_other_order, "Are the arguments of newton_cradle_tick in its order: pend_list, R_PARAM, DT, G?"),
        (lambda came: not same(came[1], first), "Are R_PARAM, DT and G those of constants.py?"),
    ]
    what = "omega and theta of the first pendulum, each time that page.wants_tick is called"
    gives = [start, first, second, second, third]
    expect("main", page, gives=gives, see=lambda _: page.states, what=what, hints=hints)


@check("main")
def test_each_cradle_that_is_wanted_is_a_new_one():
    """It is the culmination of all the helper functions you have written, and creates the Newton's cradle visualisation
    from data in the CSV file called newton_cradle_pends.csv which is stored in the variable NC_FP.
    """
    page = Page((True, 2), (True, 1))
    gone_on = "The second cradle goes on where the first one was: make it again each time that the page wants one."
    hints = [
        (swings(3)[2:], gone_on),
        (swings(1)[:1] * 2, "It is not the second cradle that ticks."),
    ]
    what = "omega and theta of the first pendulum, before and after the last tick"
    expect("main", page, gives=swings(1), see=lambda _: page.states[-2:], what=what, hints=hints)


@check("main")
def test_in_the_cradle_bobs_collide():
    """This is where you put everything you have written so far to use."""

    def push(pend_list):
        for pend, omega in zip(pend_list, (10.0, 0.0), strict=False):
            pend.update(mass=1.0, e=1, theta=0.0, omega=omega)

    page = Page((True, 1), change=push)
    if pendula() > 1:
        hints = [([10.0, 0.0], "full_swing_update lets no bobs collide; newton_cradle_tick does.")]
        what = "omega of the first two, of which the first is pushed against the second"
        see = {"see": lambda _: [pend["omega"] for pend in page.shown[0][:2]], "what": what}
        expect("main", page, gives=[0.0, 10.0], **see, hints=hints)
