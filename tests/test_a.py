"""A checks: the tick, and the program that makes a cradle and lets it run."""

if __name__ == "__main__":
    from grading.begin import refuse_to_run

    refuse_to_run()

from math import pi

from grading.check_page import CheckPage, FOLDER
from grading.comparing import same
from grading.cradles import (
    csv_of,
    hang,
    hang_row,
    LEFT_OVER,
    left_over,
    MIXED,
    R,
    see_each,
    shapes,
    touching,
)
from grading.grader import check, expect, steps, usable_result
from grading.messages import Expected
from grading.subject import Each, Several, Subject
from line_by_line.words import text_of
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import show_pendulum

steps(
    "newton_cradle_tick",
    "full_swing_update once; then a loop, in which handle_two_bobs gets each pendulum and the next "
    "one.",
    "for i in range(len(books)):  # i is 0, then 1, ...; books[i] is a book",
    "sort_pages(book, 3)  # nothing comes back: the call changes the book",
)
steps(
    "main",
    "make_newton_cradle makes pend_list; page.show shows it, once; in the while loop, "
    "newton_cradle_tick moves it.",
    "books = read_all(path)  # calls a function, and stores its result",
    "sort_pages(book, 3)  # nothing comes back: the call changes the book",
)


def check_tick(pend_list, expected, *, dt=1e-9, g=9.81, help="", results=()):
    """Check omega of each pendulum after a tick, with this dt (s) without visible motion."""
    options = see_each(pend_list, "omega")
    expect(
        "newton_cradle_tick",
        pend_list,
        R,
        dt,
        g,
        expected=expected,
        help=help,
        results=results,
        **options,
    )


def check_row(*omegas):
    """Check a tick of equal elastic pendula that touch: in a pair, each takes the other's omega."""
    now = [*omegas]
    steps = []
    for i in range(len(now) - 1):
        now[i], now[i + 1] = now[i + 1], now[i]
        steps.append(f"{i} and {i + 1}: {text_of(now)}")
    help = (
        "Each bob touches the next one, the masses are equal, and e is 1: in a pair, each bob "
        f"takes the omega of the other one. After the pair {'; '.join(steps)}."
    )
    check_tick(touching(*omegas), now, help=help)


@check("newton_cradle_tick")
def test_a_tick_swings_all_pendula():
    """Update the swings of all the pendula."""
    pend_list = [hang(theta=pi / 6, omega=2.0, axle=(i * 1.0, 0, 0), r_param=0.5) for i in range(3)]
    twice = (
        "This is the result if all pendula swing twice. Call full_swing_update once, and outside "
        "of the loop."
    )
    expect(
        "newton_cradle_tick",
        pend_list,
        0.5,
        0.1,
        10.0,
        expected=[(1.0, pi / 6 + 0.1)] * 3,
        results=[([(-0.167920715, 0.606806704)] * 3, twice)],
        **see_each(pend_list, "omega", "theta"),
    )


@check("newton_cradle_tick")
def test_each_pendulum_is_handled_with_the_one_after_it():
    """For each pendulum (except the last) handle the pairwise interaction of that pendulum and the
    one after it.
    """
    check_row(1.0, 2.0, 3.0)
    check_row(3.0, 0.0)
    check_row(3.0, 0.0, 0.0, 0.0, 0.0)
    check_row(0.0, 3.0, 0.0)  # the second pair finds both at rest
    check_row(0.0, 0.0, 3.0)  # from the right, a hit moves one place per tick
    check_row(0.0, 0.0, -3.0)
    check_row(-1.0, -2.0, -3.0)


@check("newton_cradle_tick")
def test_only_neighbours_are_pairs():
    """In a pairwise manner, we only consider the collision of two pendula."""
    large = "These large bobs all touch, but only neighbours are pairs."
    results = [([3.0, 2.0, 1.0], "This is the result if all pairs collide.")]
    check_tick(touching(1.0, 2.0, 3.0, radius=R / 3), [2.0, 3.0, 1.0], help=large, results=results)


@check("newton_cradle_tick")
def test_a_cradle_may_have_any_number_of_pendula():
    """Feel free to play around with the values and the number of pendulums."""
    alone = "There is one pendulum, and no pair."
    check_tick([hang(theta=pi / 6, omega=2.0)], [0.75], dt=0.1, g=10.0, help=alone)
    check_tick([], [])
    check_tick(touching(*[1.0] * 6, 0.0), [*[1.0] * 5, 0.0, 1.0])
    check_tick(touching(4e-8, *[0.0] * 39), [*[0.0] * 39, 4e-8])


@check("newton_cradle_tick")
def test_the_pairs_use_masses_and_restitution():
    """(Hint: Use another function you already wrote!)"""
    pend_list = touching(4.0, 0.0, 0.0)
    for pend, e, mass in zip(pend_list, (0.5, 0.25, 1.0), (1.0, 3.0, 3.0), strict=True):
        pend.update(e=e, mass=mass)
    pairs = "After the pair 0 and 1: [-0.5, 1.5, 0]; 1 and 2: [-0.5, 0.5625, 0.9375]."
    by_left = f"Each bob touches the next one, and e is that of the left one. {pairs}"
    check_tick(pend_list, [-0.5, 0.5625, 0.9375], help=by_left)
    # In the order of the list: these pendula are not sorted by place, angle, mass, e or omega.
    pend_list = [
        hang(axle=(0.1, 0, 0), radius=R / 3),
        hang(theta=0.05, omega=4.0, mass=3.0, e=0.5, axle=(0.2, 0, 0), radius=R / 3),
        hang(theta=-0.05, axle=(0.0, 0, 0), radius=R / 3),
    ]
    check_tick(pend_list, [6.0, 1.25, 2.25])


@check("newton_cradle_tick")
def test_bobs_that_do_not_touch_are_left_alone():
    """The Newton's cradle is defined by the collisions between its pendula."""
    pend_list = hang_row(3)
    pend_list[0]["omega"] = -1.0
    check_tick(pend_list, [-1.0, 0.0, 0.0], help="No bobs touch here.")


@check("newton_cradle_tick")
def test_swings_come_before_collisions():
    """Performs a single timestep or tick of the Newton's cradle."""
    check_row(2.0, 0.0)
    order = "All pendula swing first, then the pairs collide."
    pend_list = [hang(theta=-0.1, omega=1.0, radius=R / 8), hang(axle=(R / 4, 0, 0), radius=R / 8)]
    help = f"These bobs touch only after the swing. {order}"
    check_tick(pend_list, [0.0, 1.0], dt=0.1, g=0.0, help=help)
    pend_list = [hang(radius=R / 8), hang(theta=0.1, omega=-1.0, axle=(R / 4, 0, 0), radius=R / 8)]
    help = f"The second bob swings to the first one. {order}"
    check_tick(pend_list, [-1.0, 0.0], dt=0.1, g=0.0, help=help)


@check("newton_cradle_tick")
def test_a_cradle_passes_the_swing_on():
    """A "chain reaction" when each pendulum knocks into the pendulum next to it."""
    cord = 0.2
    release_angle = pi / 4
    pend_list = []
    for i in range(5):
        theta = -release_angle if i == 0 else 0.0
        pend_list.append(hang(theta=theta, axle=(i * cord / 4, 0, 0), r_param=cord))

    def is_passed_on(thetas):
        *others, last = thetas
        is_high = abs(last / release_angle - 1) < 0.02
        return is_high and all(abs(theta) < 0.1 for theta in others)

    # After half a period: 234 ticks are 0.467 s, a bit more than pi sqrt(R / g), as the swing is
    # large.
    passed_on = "the last one at about 0.785, as high as the first one was; the others at about 0"
    expect(
        "newton_cradle_tick",
        pend_list,
        cord,
        0.002,
        9.81,
        expected=Expected(passed_on, is_passed_on, like=[0.0] * 5),
        times=234,
        **see_each(pend_list, "theta"),
    )


def swings(ticks):
    """Return (omega, theta) at the start and after each tick.

    They are the student's: main waits for angle_update.
    """
    states = [(0.0, THETA_INIT)]
    for _ in range(ticks):
        # The same motion
        states.append(usable_result("angle_update", *states[-1], 2 * R_PARAM, DT, 2 * G))
    return states


@check("main")
def test_the_cradle_is_made_and_shown():
    """Use a helper function you wrote before to create the pend_list."""
    page = CheckPage(0)

    def see(_):
        cradles = []
        for cradle in page.cradles:
            cradles.append([(pend["theta"], length_of_cord(pend)) for pend in cradle])
        return cradles

    def length_of_cord(pend):
        return pend["objects"][2].axis.mag if "objects" in pend else None

    def is_made(found):
        rows = [(0 if i else THETA_INIT, abs(R_PARAM)) for i in range(len(found[0]))]
        return rows and same(found, [rows])  # one cradle was shown

    advice = [
        (
            lambda _: abs(THETA_INIT) > 2 * pi,
            f"THETA_INIT is {THETA_INIT:g} radians. Is it in degrees?",
        ),
        (
            lambda _: DT > 0.001,
            f"DT is {DT:g} s. Such long ticks are not exact, and bobs pass through each other.",
        ),
    ]
    thetas_and_cords = (
        f"({THETA_INIT:g}, {R_PARAM:g}) for the first one, (0, {R_PARAM:g}) for the others"
    )
    expect(
        "main",
        page,
        expected=Expected(thetas_and_cords, is_made, like=[[]]),
        see=see,
        what=Subject("theta and cord length of each pendulum on the page"),
        advice=advice,
        results=[([], "main has not called page.show: the page has no cradle.")],
    )


@check("main")
def test_the_cradle_ticks():
    """In the while loop, call a helper function to perform a single tick."""
    page = CheckPage(3)
    states = []
    for i in range(4):
        after = f"after {i} ticks"
        states.append(Several((Subject(f"omega {after}"), Subject(f"theta {after}"))))
    what = Several(tuple(states), "omega and theta of the first pendulum after each tick")
    expect("main", page, expected=swings(3), see=lambda _: page.states, what=what)


@check("main")
def test_each_cradle_that_is_wanted_is_a_new_one():
    """Creates the Newton's cradle visualisation from data in the CSV file."""
    page = CheckPage(2, 1)
    what = Subject("omega and theta before the last tick, and after it")
    expect("main", page, expected=swings(1), see=lambda _: page.states[-2:], what=what, times=2)
    page = CheckPage(1, 0)
    old = shapes()
    expect("main", page, see=lambda _: left_over(old, page.parts), times=2, **LEFT_OVER)

    # The file changes between the first cradle and the second one.
    before = MIXED[:2]
    after = [{**row, "mass": row["mass"] + 1} for row in MIXED]
    file = FOLDER / "changing.csv"
    file.write_text(csv_of(before))
    masses = []

    def change(pend_list):
        masses.append(masses_of(pend_list))
        file.write_text(csv_of(after))

    def are_new(found):
        first, second = found
        if not same(first, masses_of(before)):  # main reads another file than page.csv
            return same(second, first)
        return same(second, masses_of(after))

    always_same = (
        "main always reads NC_FP. With page.csv, experiments and the CSV of a command would work, "
        "too."
    )
    expect(
        "main",
        CheckPage(0, 0, change=change, csv=str(file)),
        expected=Expected("for each cradle, those that the file has then", are_new),
        see=lambda _: masses,
        what=Subject("masses of the first cradle, and of the second one"),
        advice=[(lambda _: masses[0] != masses_of(before), always_same)],
        times=2,
    )


def masses_of(pend_list):
    return [pend["mass"] for pend in pend_list]


@check("main")
def test_in_the_cradle_bobs_collide():
    """This is where you put everything you have written so far to use."""

    def push(pend_list):
        for i, pend in enumerate(pend_list):
            pend.update(mass=1.0, e=1, theta=0.0, omega=0.0 if i else 10.0)
            show_pendulum(pend, R_PARAM)
            pend["objects"][1].radius = R_PARAM / 8  # all bobs touch

    def is_passed_on(omegas):
        return same(omegas, [*[0.0] * (len(omegas) - 1), 10.0])

    page = CheckPage(1, change=push)
    expect(
        "main",
        page,
        expected=Expected("10 for the last pendulum, 0 for all others", is_passed_on),
        see=lambda _: [pend["omega"] for pend in page.cradles[0]],
        what=Each(("omega",)),
    )
