"""A checks: the tick, and the program that makes a cradle and lets it run."""

if __name__ == "__main__":
    from grading.begin import refuse_to_run

    refuse_to_run()

from math import pi
from pathlib import Path
from tempfile import TemporaryDirectory

from grading.comparing import same
from grading.cradles import (
    csv_of,
    each,
    hang,
    LEFT_OVER,
    left_over,
    MIXED,
    MIXED_CSV,
    R,
    row,
    shapes,
    touching,
)
from grading.grader import check, expect, result_of, steps
from grading.messages import shown, Wanted
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import show_pendulum

steps(
    "newton_cradle_tick",
    "full_swing_update once; then a loop, in which handle_two_bobs gets each pendulum and the next one.",
    "for i in range(len(books)):  # i is 0, then 1, ...; books[i] is a book",
    "sort_pages(book, 3)  # nothing comes back: the call changes the book",
)
steps(
    "main",
    "make_newton_cradle makes pend_list; page.show shows it, once; in the while loop, newton_cradle_tick moves it.",
    "books = read_all(path)  # calls a function, and stores its result",
    "sort_pages(book, 3)  # nothing comes back: the call changes the book",
)


def check_tick(pend_list, wanted, *, dt=1e-9, g=9.81, help="", results=()):
    """Check omega of each pendulum after a tick, with this dt (s) without visible motion."""
    options = {"help": help, "results": results, **each(pend_list, "omega")}
    expect("newton_cradle_tick", pend_list, R, dt, g, wanted=wanted, **options)


def check_row(*omegas):
    """Check a tick of equal elastic pendula that touch: the two of a pair exchange their omegas."""
    steps, now = [], [*omegas]
    for i in range(len(now) - 1):
        now[i], now[i + 1] = now[i + 1], now[i]
        steps.append(f"{i} and {i + 1}: {shown(now)}")
    words = "Each bob touches the next one, the masses are equal, and e is 1: a pair exchanges its omegas."
    check_tick(touching(*omegas), now, help=f"{words} After the pair {'; '.join(steps)}.")


@check("newton_cradle_tick")
def test_a_tick_swings_all_pendula():
    """Update the swings of all the pendula."""
    pend_list = [hang(theta=pi / 6, omega=2.0, axle=(i * 1.0, 0, 0), r_param=0.5) for i in range(3)]
    states = each(pend_list, "omega", "theta")
    twice = "This is the result if all pendula swing twice. Call full_swing_update once, and outside of the loop."
    results = [([(-0.167920715, 0.606806704)] * 3, twice)]
    wanted = [(1.0, pi / 6 + 0.1)] * 3
    expect(
        "newton_cradle_tick", pend_list, 0.5, 0.1, 10.0, wanted=wanted, results=results, **states
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
    words = "These large bobs all touch, but only neighbours are pairs."
    results = [([3.0, 2.0, 1.0], "This is the result if all pairs collide.")]
    check_tick(touching(1.0, 2.0, 3.0, radius=R / 3), [2.0, 3.0, 1.0], help=words, results=results)


@check("newton_cradle_tick")
def test_a_cradle_may_have_any_number_of_pendula():
    """Feel free to play around with the values and the number of pendulums."""
    check_tick(
        [hang(theta=pi / 6, omega=2.0)],
        [0.75],
        dt=0.1,
        g=10.0,
        help="There is one pendulum, and no pair.",
    )
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
    words = f"Each bob touches the next one, and e is that of the left one. {pairs}"
    check_tick(pend_list, [-0.5, 0.5625, 0.9375], help=words)
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
    pend_list = row(3)
    pend_list[0]["omega"] = -1.0
    check_tick(pend_list, [-1.0, 0.0, 0.0], help="No bobs touch here.")


@check("newton_cradle_tick")
def test_swings_come_before_collisions():
    """Performs a single timestep or tick of the Newton's cradle."""
    check_row(2.0, 0.0)
    pend_list = [hang(theta=-0.1, omega=1.0, radius=R / 8), hang(axle=(R / 4, 0, 0), radius=R / 8)]
    words = (
        "These bobs touch only after the swing. All pendula swing first, then the pairs collide."
    )
    check_tick(pend_list, [0.0, 1.0], dt=0.1, g=0.0, help=words)
    pend_list = [hang(radius=R / 8), hang(theta=0.1, omega=-1.0, axle=(R / 4, 0, 0), radius=R / 8)]
    words = (
        "The second bob swings to the first one. All pendula swing first, then the pairs collide."
    )
    check_tick(pend_list, [-1.0, 0.0], dt=0.1, g=0.0, help=words)


@check("newton_cradle_tick")
def test_a_cradle_passes_the_swing_on():
    """A "chain reaction" when each pendulum knocks into the pendulum next to it."""
    cord, lift = 0.2, pi / 4
    pend_list = [
        hang(theta=-lift if i == 0 else 0.0, axle=(i * cord / 4, 0, 0), r_param=cord)
        for i in range(5)
    ]

    def is_passed_on(thetas):
        return abs(thetas[-1] / lift - 1) < 0.02 and all(abs(theta) < 0.1 for theta in thetas[:-1])

    # After half a period: 234 ticks are 0.467 s, a bit more than pi sqrt(R / g), as the swing is
    # large.
    words = "the last one at about 0.785, as high as the first one was; the others at about 0"
    wanted = Wanted(words, is_passed_on, like=[0.0] * 5)
    expect(
        "newton_cradle_tick",
        pend_list,
        cord,
        0.002,
        9.81,
        wanted=wanted,
        times=234,
        **each(pend_list, "theta"),
    )


FOLDER = TemporaryDirectory(ignore_cleanup_errors=True)
CRADLE = Path(FOLDER.name) / "cradle.csv"
CRADLE.write_text(MIXED_CSV)


class Page:
    """The page for main in a check: it says when to tick, and records the result."""

    def __init__(self, *ticks, change=lambda pend_list: None, csv=str(CRADLE)):
        """ticks has the number of ticks of each cradle; change(pend_list) is called when main shows
        one.
        """
        self.ticks, self.change = ticks, change
        self.csv = csv
        self.rule: dict = {}
        self.answers = iter([answer for number in ticks for answer in (*[True] * number, False)])
        self.is_shown, self.shown = False, []  # whether this cradle is, and all cradles
        self.parts: list = []  # the objects of their pendula
        self.states: list = []  # (omega, theta) of the first pendulum at each call of is_running

    def __repr__(self):
        wishes = ["1 tick" if number == 1 else f"{number} ticks" for number in self.ticks]
        return f"a page that wants {', then a new cradle and '.join(wishes)}"

    def show(self, pend_list):
        if self.is_shown:
            raise RuntimeError("page.show was called again. Show the cradle once, before the loop.")
        self.is_shown = True
        self.shown.append(pend_list if isinstance(pend_list, list) else [])
        self.parts += [part for pend in self.shown[-1] for part in pend.get("objects", ())]
        self.change(self.shown[-1])

    def is_running(self):
        if self.is_shown:
            self.states += [(pend["omega"], pend["theta"]) for pend in self.shown[-1][:1]]
            self.is_shown = next(self.answers, False)
        return self.is_shown


def swings(ticks):
    """Return (omega, theta) at the start and after each tick.

    They are the student's: main waits for angle_update.
    """
    states = [(0.0, THETA_INIT)]
    for _ in range(ticks):
        # The same motion
        states.append(result_of("angle_update", *states[-1], 2 * R_PARAM, DT, 2 * G))
    return states


@check("main")
def test_the_cradle_is_made_and_shown():
    """Use a helper function you wrote before to create the pend_list."""
    page = Page(0)

    def see(_):
        return [[(pend["theta"], length_of_cord(pend)) for pend in cradle] for cradle in page.shown]

    def length_of_cord(pend):
        return pend["objects"][2].axis.mag if "objects" in pend else None

    def is_made(found):
        rows = [(0 if i else THETA_INIT, abs(R_PARAM)) for i in range(len(found[0]))]
        return rows and same(found, [rows])  # one cradle was shown

    notes = [
        (
            lambda _: abs(THETA_INIT) > 2 * pi,
            f"THETA_INIT is {THETA_INIT:g} radians. Is it in degrees?",
        ),
        (
            lambda _: DT > 0.001,
            f"DT is {DT:g} s. Such long ticks are not exact, and bobs pass through each other.",
        ),
    ]
    what = "theta and cord length of each pendulum on the page"
    words = f"({THETA_INIT:g}, {R_PARAM:g}) for the first one, (0, {R_PARAM:g}) for the others"
    results = [([], "main has not called page.show: the page has no cradle.")]
    options = {"see": see, "what": what, "notes": notes, "results": results}
    expect("main", page, wanted=Wanted(words, is_made, like=[[]]), **options)


@check("main")
def test_the_cradle_ticks():
    """In the while loop, call a helper function to perform a single tick."""
    page = Page(3)
    what = "omega and theta of the first pendulum at each call of page.is_running"
    expect("main", page, wanted=swings(3), see=lambda _: page.states, what=what)


@check("main")
def test_each_cradle_that_is_wanted_is_a_new_one():
    """Creates the Newton's cradle visualisation from data in the CSV file."""
    page = Page(2, 1)
    what = "omega and theta before the last tick, omega and theta after the last tick"
    expect("main", page, wanted=swings(1), see=lambda _: page.states[-2:], what=what, times=2)
    page, shown = Page(1, 0), shapes()
    expect("main", page, see=lambda _: left_over(shown, page.parts), times=2, **LEFT_OVER)

    # The file changes between the first cradle and the second one.
    before, after = MIXED[:2], [{**row, "mass": row["mass"] + 1} for row in MIXED]
    old, new = ([row["mass"] for row in rows] for rows in (before, after))
    file, masses = Path(FOLDER.name) / "changing.csv", []

    def show(pend_list):
        masses.append([pend["mass"] for pend in pend_list])
        file.write_text(csv_of(after))

    def is_new(found):  # a main that reads another file than page.csv finds no change in it
        return same(found[1], new if same(found[0], old) else found[0]) and len(found) == 2

    file.write_text(csv_of(before))
    own = "main always reads NC_FP. With page.csv, experiments and the CSV of a command would work, too."
    wanted = Wanted("for each cradle, those that the file has then", is_new)
    notes = [(lambda _: masses[0] != old, own)]
    see = {"see": lambda _: masses, "what": "masses of the first cradle, and of the second one"}
    expect(
        "main", Page(0, 0, change=show, csv=str(file)), wanted=wanted, notes=notes, times=2, **see
    )


@check("main")
def test_in_the_cradle_bobs_collide():
    """This is where you put everything you have written so far to use."""

    def push(pend_list):
        for i, pend in enumerate(pend_list):
            pend.update(mass=1.0, e=1, theta=0.0, omega=0.0 if i else 10.0)
            show_pendulum(pend, R_PARAM)
            pend["objects"][1].radius = R_PARAM / 8  # all bobs touch

    page, words = Page(1, change=push), "10 for the last pendulum, 0 for all others"
    wanted = Wanted(words, lambda omegas: same(omegas, [0.0] * (len(omegas) - 1) + [10.0]))
    see = {
        "see": lambda _: [pend["omega"] for pend in page.shown[0]],
        "what": "omega of each pendulum",
    }
    expect("main", page, wanted=wanted, **see)
