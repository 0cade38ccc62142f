"""A checks: the tick, and the program that makes a cradle and lets it run."""

from contextlib import suppress
from math import pi
from pathlib import Path

import grading.begin

from grading.assignment import PROGRAM
from grading.check_player import CheckPlayer
from grading.checks import check
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
    within,
)
from grading.grader import expect, running, usable_result
from grading.messages import Expected
from grading.subject import Each, Several, Subject
from grading.words import plural, text_of
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import show_pendulum
from support.root import ROOT

STEPS = {
    "newton_cradle_tick": "full_swing_update once; then a loop, in which handle_two_bobs gets each "
    "pendulum and the next one.",
    PROGRAM: "make_newton_cradle makes pend_list, once, before the while loop; in the loop, "
    "newton_cradle_tick moves it.",
}


def check_tick(pend_list, expected, dt=1e-9, g=9.81, **options):
    """Check omega of each pendulum after a tick, with this dt (s) without visible motion.

    options are those of expect.
    """
    options |= see_each(pend_list, "omega")
    expect("newton_cradle_tick", pend_list, R, dt, g, expected=expected, **options)


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
    """A tick swings each pendulum once, for dt."""
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
    """Neighbours that touch collide once in a tick, from left to right."""
    check_row(1.0, 2.0, 3.0)
    check_row(3.0, 0.0)
    check_row(3.0, 0.0, 0.0, 0.0, 0.0)
    check_row(0.0, 3.0, 0.0)  # the second pair finds both at rest
    check_row(0.0, 0.0, 3.0)  # from the right, a hit moves one place per tick
    check_row(-1.0, -2.0, -3.0)


@check("newton_cradle_tick")
def test_only_neighbours_are_pairs():
    """Only neighbours collide, even if a bob touches others, too."""
    large = "These large bobs all touch, but only neighbours are pairs."
    results = [([3.0, 2.0, 1.0], "This is the result if all pairs collide.")]
    check_tick(touching(1.0, 2.0, 3.0, radius=R / 3), [2.0, 3.0, 1.0], help=large, results=results)


@check("newton_cradle_tick")
def test_a_cradle_may_have_any_number_of_pendula():
    """A cradle can have any number of pendula: none, one, or forty."""
    alone = "There is one pendulum, and no pair."
    check_tick([hang(theta=pi / 6, omega=2.0)], [0.75], dt=0.1, g=10.0, help=alone)
    check_tick([], [])
    check_tick(touching(*[1.0] * 6, 0.0), [*[1.0] * 5, 0.0, 1.0])
    check_tick(touching(4e-8, *[0.0] * 39), [*[0.0] * 39, 4e-8])


@check("newton_cradle_tick")
def test_the_pairs_use_masses_and_restitution():
    """Each pair has its own masses, and the e of its first pendulum."""
    pend_list = touching(4.0, 0.0, 0.0)
    for pend, e, mass in zip(pend_list, (0.5, 0.25, 1.0), (1.0, 3.0, 3.0), strict=True):
        pend.update(e=e, mass=mass)
    pairs = "After the pair 0 and 1: [-0.5, 1.5, 0]; 1 and 2: [-0.5, 0.5625, 0.9375]."
    by_left = f"Each bob touches the next one, and e is that of the left one. {pairs}"
    check_tick(pend_list, [-0.5, 0.5625, 0.9375], help=by_left)


@check("newton_cradle_tick")
def test_bobs_that_do_not_touch_are_left_alone():
    """In a tick, bobs that do not touch do not collide."""
    pend_list = hang_row(3)
    pend_list[0]["omega"] = -1.0
    check_tick(pend_list, [-1.0, 0.0, 0.0], help="No bobs touch here.")


@check("newton_cradle_tick")
def test_swings_come_before_collisions():
    """Bobs that touch after the swing collide in the same tick."""
    check_row(2.0, 0.0)
    pend_list = [hang(theta=-0.1, omega=1.0, radius=R / 8), hang(axle=(R / 4, 0, 0), radius=R / 8)]
    help = "These bobs touch only after the swing. All pendula swing first, then the pairs collide."
    check_tick(pend_list, [0.0, 1.0], dt=0.1, g=0.0, help=help)


@check("newton_cradle_tick")
def test_a_cradle_passes_the_swing_on():
    """After 234 ticks, the last pendulum is as high as the first was."""
    cord = 0.2
    release_angle = pi / 4
    pend_list = []
    for i in range(5):
        theta = -release_angle if i == 0 else 0.0
        pend_list.append(hang(theta=theta, axle=(i * cord / 4, 0, 0), r_param=cord))
    # After half a period: 234 ticks are 0.467 s, a bit more than pi sqrt(R / g), as the swing is
    # large.
    expect(
        "newton_cradle_tick",
        pend_list,
        cord,
        0.002,
        9.81,
        expected=[*[within(0.1, 0.0)] * 4, within(0.015, release_angle)],
        times=234,
        help="Now the last pendulum is as high as the first one was; the others hardly move.",
        **see_each(pend_list, "theta"),
    )


def add_count(pend_list, *constants):
    """Stand in for full_swing_update: add the number of pendula to each omega."""
    for pend in pend_list:
        if constants == (R, 0.1, 9.0):
            pend["omega"] += len(pend_list)


def add_left(pend1, pend2, _):
    """Stand in for handle_two_bobs: add ten times the omega of pend1 to that of pend2."""
    pend2["omega"] += 10 * pend1["omega"]


@check("newton_cradle_tick", full_swing_update=add_count, handle_two_bobs=add_left)
def newton_cradle_tick_alone():
    """All pendula swing, then each pair of neighbours is handled, from left to right."""
    help = (
        "Here, full_swing_update adds the number of pendula to each omega, and handle_two_bobs "
        "adds ten times the omega of pend1 to that of pend2."
    )
    for omegas, after in (
        ((), []),
        ((5.0,), [6.0]),
        ((0.0, 5.0), [2.0, 27.0]),
        ((0.0, 1.0, 2.0, 3.0, 4.0), [5.0, 56.0, 567.0, 5678.0, 56789.0]),
    ):
        check_tick(touching(*omegas), after, dt=0.1, g=9.0, help=help)


# --- the program, below if __name__ == "__main__" ------------------------------------------------


def swings(ticks):
    """Return (omega, theta) at the start and after each tick.

    They are the student's: the program waits for angle_update.
    """
    states = [(0.0, THETA_INIT)]
    for _ in range(ticks):
        # The same motion
        states.append(tuple(usable_result("angle_update", *states[-1], 2 * R_PARAM, DT, 2 * G)))
    return states


@check(PROGRAM)
def test_the_cradle_is_made():
    """The program makes a cradle, with R_PARAM and THETA_INIT."""
    player = CheckPlayer(0)

    def see(_):
        return [(pend["theta"], length_of_cord(pend)) for pend in player.pend_list]

    def length_of_cord(pend):
        return pend["objects"][2].axis.mag if "objects" in pend else None

    def is_made(found):
        others = [(0, R_PARAM)] * (len(found) - 1)
        thetas = [theta for _, theta in swings(1)]  # a loop with rate may do a tick before it
        return any(same(found, [(theta, R_PARAM), *others]) for theta in thetas)

    thetas_and_cords = (
        f"({THETA_INIT:g}, {R_PARAM:g}) for the first one, (0, {R_PARAM:g}) for the others"
    )
    expect(
        PROGRAM,
        player,
        expected=Expected(thetas_and_cords, is_made),
        see=see,
        what=Subject("theta and cord length of each pendulum"),
        results=[([], "No loop with a cradle has called is_running, or rate.")],
    )


@check(PROGRAM)
def test_the_cradle_ticks():
    """Each turn of the loop makes one tick, and no new cradle."""

    def release(pend_list):
        for pend in pend_list[:1]:  # your program may have another angle
            pend.update(theta=THETA_INIT, omega=0.0)

    player = CheckPlayer(3, change=release)
    states = []
    for i in range(4):
        after = f"after {plural(i, 'tick', 'ticks')}"
        states.append(Several((Subject(f"omega {after}"), Subject(f"theta {after}"))))
    what = Several(tuple(states), "omega and theta of the first pendulum after each tick")
    right = swings(3)
    results = [
        ([*right[:2], right[1], right[1]], "This is the result if each turn makes a new cradle."),
        (swings(6)[::2], "This is the result of two ticks in each turn."),
        (lambda found: len(found) < 4, "The program ended by itself before the check was over."),
    ]
    expect(
        PROGRAM,
        player,
        expected=right,
        see=lambda _: [pendula[0] for pendula in player.states],
        what=what,
        results=results,
    )
    old = shapes()

    def see_left_over(_):
        parts = [part for pend in player.pend_list for part in pend["objects"]]
        return left_over(old, parts)

    expect(PROGRAM, player, see=see_left_over, **LEFT_OVER)


@check(PROGRAM)
def test_a_new_run_reads_the_csv_again():
    """Each run of the program makes a new cradle from the CSV."""
    files = [*running.get().code.shipped.parent.glob("*.csv")]  # NC_FP, and your own

    def write(rows):
        for file in files:
            file.write_text(csv_of(rows))

    cradles = []
    are_those_of_a_file = []

    def change(pend_list):
        cradles.append([*pend_list])
        # The program may have written a file, or have a path of its own
        known = numbers_in([*files, *ROOT.glob("*.csv")])
        are_those_of_a_file.append(len(pend_list) in known)
        write(MIXED)

    def are_new(_):
        first, second = cradles
        return are_those_of_a_file == [True, True] and first[0] is not second[0]

    write(MIXED[:2])
    expect(
        PROGRAM,
        CheckPlayer(1, change),
        expected=Expected("[2, 3], as many as NC_FP then has", are_new),
        see=lambda _: [*map(len, cradles)],
        what=Subject("number of pendula in each run"),
        times=2,
    )


def numbers_in(files) -> set[int]:
    """Return the numbers of pendula in CSV files."""
    found = set()
    for file in files:
        with suppress(OSError):  # another program may have it open
            lines = file.read_text(errors="replace").splitlines()
            found.add(len([line for line in lines if line.strip()]) - 1)
    return found


@check(PROGRAM)
def test_in_the_cradle_bobs_collide():
    """In one turn of the loop, a push reaches the last bob."""

    def push(pend_list):
        for i, pend in enumerate(pend_list):
            pend.update(mass=1.0, e=1, theta=0.0, omega=0.0 if i else 10.0)
            show_pendulum(pend, R_PARAM)
            pend["objects"][1].radius = R_PARAM / 8  # all bobs touch

    def is_passed_on(omegas):
        return same(omegas, [*[0.0] * (len(omegas) - 1), 10.0])

    player = CheckPlayer(1, change=push)
    expect(
        PROGRAM,
        player,
        expected=Expected("10 for the last pendulum, 0 for all others", is_passed_on),
        see=lambda _: [omega for omega, _ in player.states[-1]],
        what=Each(("omega",)),
    )


def new_row(relative_filepath, *constants):
    """Stand in for make_newton_cradle: return three pendula; the first one has the arguments."""
    pend_list = hang_row(3)
    pend_list[0]["made with"] = Path(relative_filepath).is_file(), *constants
    return pend_list


def turn(pend_list, *constants):
    """Stand in for newton_cradle_tick: add 1 to theta of the first pendulum."""
    pend_list[0]["theta"] += 1
    pend_list[0]["moved with"] = constants


@check(PROGRAM, make_newton_cradle=new_row, newton_cradle_tick=turn)
def the_program_alone():
    """The program makes one cradle; each turn of the loop does one tick."""
    player = CheckPlayer(3)

    def see(_):
        first = player.pend_list[0] if player.pend_list else {}
        thetas = [pendula[0][1] for pendula in player.states]
        ticks = [theta - thetas[0] for theta in thetas]
        return first.get("made with"), first.get("moved with"), ticks

    constants = (True, R_PARAM, THETA_INIT), (R_PARAM, DT, G)
    what = Several(
        (
            Subject("CSV and constants of make_newton_cradle"),
            Subject("constants of newton_cradle_tick"),
            Subject("ticks before each turn of the loop"),
        )
    )
    expect(PROGRAM, player, expected=(*constants, [0, 1, 2, 3]), see=see, what=what)
