"""Watch a check in the terminal: `python tests/watch.py test_angle_update`.

The pendula start as the check gives them to your function. Your function does its part in each tick, in real time. If
it makes pendula, the picture shows them.
"""

import sys
import time
from itertools import count
from math import cos, pi, sin, sqrt
from pathlib import Path
from shutil import get_terminal_size
from tempfile import TemporaryDirectory

import grading.begin  # noqa: F401

from vpython import color, mag, vector

from grading.cradles import hang
from grading.grader import checks, Grading, PASSED, runner
from grading.handout import FUNCTIONS, SUITES
from grading.messages import error_lines
from grading.raised import raised_by
from support.constants import DT, G
from support.cradle.cradle import Cradle
from support.files.cradle_csv import to_number
from support.pendulum import show_double_pendulum, show_pendulum
from support.start.early import stop_on_signals
from support.start.options import allowed, OneLineParser
from support.start.output import is_unread, while_it_is_read
from support.terminal.players import has_terminal
from support.terminal.screen import own_screen, TextPicture

COLUMNS, ROWS = 80, 20  # of a picture
PICTURE, STRIP = 0.05, 0.5  # s from picture to picture on a terminal, and in a file


class Scene(Cradle):
    """The pendula of a call of a student's function: a cradle that the terminal only draws."""

    def __init__(self, pend_list, r_param, tick=None):
        """tick() moves the pendula by DT. Without tick, they stand."""
        if not pend_list:
            raise ValueError("the cradle has no pendulum")
        self.pend_list, self.tick = pend_list, tick
        lengths = [mag(bob.pos - pend["objects"][0].pos) for pend in pend_list for bob in pend["objects"][1::2]]
        # All pendula are in the picture, even with cords of a wrong length.
        self.reach = max(len(pend_list[0]["objects"]) // 2 * r_param, *lengths)


def play(scene, seconds) -> None:
    """Play a scene for seconds in real time, or show one picture if nothing moves in it."""
    if scene.tick is None:
        print("", *TextPicture().lines(scene, COLUMNS, ROWS), sep="\n")
    elif has_terminal():
        last: list[str] = []
        with own_screen(lambda: last):
            for last in moving(scene, seconds, PICTURE):
                print("\x1b[H" + "\x1b[K\n".join(last) + "\x1b[J", end="", flush=True)
    else:
        for lines in moving(scene, seconds, STRIP):
            print("", *lines, sep="\n", flush=True)


def moving(scene, seconds, step):
    """Yield the lines of a picture at the start and after each step (s), not before its time."""
    begin, picture = time.monotonic(), TextPicture()
    for number in range(int(seconds / step) + 1):
        for _ in range(round(step / DT) if number else 0):
            scene.tick()
        time.sleep(max(0.0, begin + number * step - time.monotonic()))
        size = get_terminal_size()  # Python 3.10 returns 0 for a terminal that does not know its size
        size_of_picture = min(COLUMNS, size.columns or COLUMNS), min(ROWS, (size.lines or ROWS + 3) - 3)
        yield [f"t = {number * step:.2f} s   Ctrl+C ends it.", "", *picture.lines(scene, *size_of_picture)]


def scene_of(call) -> Scene:
    """Return the scene of a call, with the function that was called."""
    given = dict(zip(FUNCTIONS[call.function].parameters.split(", "), call.arguments, strict=False))
    return SCENES[call.function](runner.find(call.function), given)


# Each function takes a student's solution and the arguments of the call by name, and returns a scene.


def made_cradle(solution, given):
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        file = Path(folder) / "cradle.csv"
        file.write_text(given["relative_filepath"].text, encoding="utf-8")
        return Scene(solution(str(file), given["r_param"], given["theta_init"]), given["r_param"])


def one_pendulum(_, given):
    from src.swinging import swing_update  # it uses angle_update

    pend, r_param = hang(given["theta"], given["omega"], r_param=given["r_param"]), given["r_param"]
    return Scene([pend], r_param, lambda: swing_update(pend, r_param, DT, given["g"]))


def row_of_pendula(solution, given):
    pend_list, r_param = [pendulum(given["r_param"], **values) for values in given["pend_list"]], given["r_param"]
    return Scene(pend_list, r_param, lambda: solution(pend_list, r_param, DT, given["g"]))


def two_that_meet(solution, given):
    """Both start at their highest points, meet at the bottom, and meet there again after each half period."""
    r_param, e, m1, m2 = (given[name] for name in ("r_param", "e", "m1", "m2"))
    omegas = [given["omega1"], given["omega2"]]  # when they meet
    quarter, ticks = round(pi / 2 * sqrt(r_param / G) / DT), count()

    def tick():
        nonlocal omegas
        if next(ticks) % (2 * quarter) == quarter:
            after = solution(e, *omegas, m1, m2, r_param)
            for pend, omega in zip(pend_list, after, strict=True):
                pend.update(theta=0.0, omega=omega)
            omegas = [-omega for omega in after]
        swing(pend_list, r_param)

    thetas = [-omega * sqrt(r_param / G) for omega in omegas]
    pend_list = [hang(theta, axle=(i * r_param / 4, 0, 0), r_param=r_param) for i, theta in enumerate(thetas)]
    return Scene(pend_list, r_param, tick)


def two_bobs(solution, given):
    r_param = given["r_param"]
    pend_list = [pendulum(r_param, **given[name]) for name in ("pend1", "pend2")]

    def tick():
        solution(*pend_list, r_param)  # the first call has the same values as in the check
        swing(pend_list, r_param)

    return Scene(pend_list, r_param, tick)


def one_double_pendulum(solution, given):
    from src.double_cradle import make_double_pendulum

    r_param, state = given["r_param"], [*given.values()][:4]
    masses = [given[name] for name in ("m1", "m2") if name in given]
    pend = {"objects": make_double_pendulum(vector(0, 0, 0), r_param, *state[2:], color.white, None)}

    def tick():
        state[:] = solution(*state, r_param, DT, given["g"], *masses)
        _, _, pend["theta"], pend["phi"] = state
        show_double_pendulum(pend, r_param)

    return Scene([pend], r_param, tick)


def swing(pend_list, r_param):
    """Move pendula on by DT, at all angles as at small ones: theta'' = -w^2 theta. It needs no function of the student.

    theta becomes theta cos(w DT) + omega / w sin(w DT), and omega its derivative.
    """
    w = sqrt(G / r_param)
    c, s = cos(w * DT), sin(w * DT)
    for pend in pend_list:
        theta, omega = pend["theta"], pend["omega"]
        pend.update(theta=theta * c + omega / w * s, omega=omega * c - theta * w * s)
        show_pendulum(pend, r_param)


def pendulum(r_param, mass, e, theta, omega, axle, radius, **_):
    """Return a pendulum with these plain values."""
    return hang(theta, omega, mass, e, axle, r_param, radius)


SCENES = {
    "make_newton_cradle": made_cradle,
    "angle_update": one_pendulum,
    "full_swing_update": row_of_pendula,
    "handle_collision": two_that_meet,
    "handle_two_bobs": two_bobs,
    "newton_cradle_tick": row_of_pendula,
    "make_double_pendulum": lambda solution, given: Scene([{"objects": solution(*given.values())}], given["r_param"]),
    "double_angle_update": one_double_pendulum,
}


@while_it_is_read()
def main() -> None:
    """Print the outcome of a check, and play it.

    The status is 2 if there is no such check, and 1 if the scene fails, or if the check fails without a scene.
    """
    all_checks = {check.name: check for tier in SUITES for check in checks(tier=tier)}
    names = allowed(str, all_checks.__contains__, "the name of a check, for example test_angle_update")
    parser = OneLineParser(description="Watch a check in the terminal.", allow_abbrev=False)
    parser.add_argument("check", metavar="CHECK", type=names, help="its name, for example test_angle_update")
    seconds = allowed(float, lambda text: 0 < to_number(text) <= 1e6, "a number above 0 and up to 1e6 (s)")
    parser.add_argument("--seconds", metavar="S", type=seconds, default=10.0, help="duration (default: %(default)g)")
    options = parser.parse_args()

    outcome = Grading().judge(all_checks[options.check])
    print(outcome.message or f"{options.check} passes.", flush=True)
    if not outcome.call:
        is_passed = outcome.state == PASSED
        print("There is nothing to watch.", file=sys.stdout if is_passed else sys.stderr)
        sys.exit(0 if is_passed else 1)
    try:
        stop_on_signals()
        play(scene_of(outcome.call), options.seconds)
    except KeyboardInterrupt as stopped:
        sys.exit(*stopped.args)
    except Exception as error:
        raised = raised_by(error)
        if is_unread(error) or isinstance(error, OSError) and not raised.places:
            raise  # while_it_is_read ends the program
        sys.exit(f"It cannot be played: {error_lines(raised)[0]}")


if __name__ == "__main__":
    main()
