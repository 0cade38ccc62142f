"""Watch a check in the terminal: `python tests/watch.py test_angle_update`.

The pendula start as the check gives them to your function. Your function does its part in each tick, in real time. If
it makes pendula, the picture shows them.
"""

import sys
from functools import partial
from math import cos, pi, sin, sqrt
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parent))  # so that Python finds grading, also with -P

from grading import project_path  # noqa: F401  finds the imports below
from support import headless_vpython

headless_vpython.install()

from vpython import color, mag, vector

from grading.cradles import hang
from grading.grader import checks, Grading, PASSED, student
from grading.handout import FUNCTIONS, SUITES
from grading.messages import error_lines
from grading.own_process import module_of
from grading.raised import raised_by
from support.constants import DT, G
from support.cradle.cradle import Cradle
from support.cradle.dragging import Hand
from support.cradle.impacts import Hits
from support.cradle.player import run
from support.energy import double_kinetic_energy, double_potential_energy, kinetic_energy, potential_energy
from support.files.cradle_csv import to_number
from support.pendulum import show_pendulum
from support.start.early import stop_on_signals
from support.start.options import allowed, OneLineParser
from support.start.output import is_unread, while_it_is_read
from support.terminal.players import has_terminal, Lines, Pictures, show_pictures
from support.terminal.screen import TextPicture

COLUMNS, ROWS = 80, 20  # of a still picture


class Scene(Cradle):
    """The pendula of a call of a student's function.

    It has only the parts of a cradle (support/cradle/cradle.py) that the terminal needs.
    """

    dt = DT
    takes_rule, many_ticks = False, None

    def __init__(self, pend_list, r_param, g, tick=None):
        """tick() moves the pendula by DT. Without tick, they stand."""
        if not pend_list:
            raise ValueError("the cradle has no pendulum")
        self.pend_list, self.hand, self.hits = pend_list, Hand(self), Hits(self)
        self.numbers = {id(pend): number for number, pend in enumerate(pend_list)}
        self.r_param, self.g, self.tick = r_param, g, tick
        lengths = [mag(bob.pos - pend["objects"][0].pos) for pend in pend_list for bob in pend["objects"][1::2]]
        # All pendula are in the picture, even with cords of a wrong length.
        self.reach = max(len(pend_list[0]["objects"]) // 2 * r_param, *lengths)

    def check(self):
        """A scene shows the pendula also if a solution makes a mistake with them."""

    def approach(self, left, right):
        return (self.velocity(*left) - self.velocity(*right)) * self.r_param

    def energies(self):
        return kinetic_energy(self.pend_list, self.r_param), potential_energy(self.pend_list, self.r_param, self.g)


def play(scene, seconds) -> None:
    """Play a scene for seconds, or show one picture if nothing moves in it."""

    class WatchedPictures(Pictures):
        make = Pictures.made  # the cradle exists already

    class WatchedLines(Lines):
        make = Lines.made

    def loop(player):
        while player.is_running():
            while player.wants_tick():
                scene.tick()

    options = SimpleNamespace(angle=None, lift=None, seconds=seconds)
    if scene.tick is None:
        print("", *TextPicture().lines(scene, COLUMNS, ROWS), sep="\n")
    elif has_terminal():
        show_pictures(loop, WatchedPictures(scene, None, options))
    else:
        run(loop, WatchedLines(scene, None, options))


class SmallSwings(Scene):
    """Two pendula with the swing of small angles, theta'' = -w^2 theta with w = sqrt(G / R), at all angles.

    It needs no function of the student.
    """

    def __init__(self, pend_list, r_param, tick):
        super().__init__(pend_list, r_param, G, tick)
        self.w = sqrt(G / r_param)

    def swing(self):
        """Move the pendula on by DT: theta becomes theta cos(w DT) + omega / w sin(w DT), and omega its derivative."""
        c, s = cos(self.w * DT), sin(self.w * DT)
        for pend in self.pend_list:
            theta, omega = pend["theta"], pend["omega"]
            pend["theta"], pend["omega"] = theta * c + omega / self.w * s, omega * c - theta * self.w * s
            show_pendulum(pend, self.r_param)

    def energies(self):
        kinetic, _ = super().energies()
        return kinetic, sum(pend["mass"] * G * self.r_param * pend["theta"] ** 2 / 2 for pend in self.pend_list)


class DoubleScene(Scene):
    """One double pendulum, whose bobs may have different masses."""

    def energies(self):
        # The energies of two bobs of mass m2, and of an upper bob with the rest of m1.
        (pend,) = self.pend_list
        both, more = [{**pend, "mass": pend["m2"]}], [{**pend, "mass": pend["m1"] - pend["m2"]}]
        kinetic = double_kinetic_energy(both, self.r_param) + kinetic_energy(more, self.r_param)
        potential = double_potential_energy(both, self.r_param, self.g) + potential_energy(more, self.r_param, self.g)
        return kinetic, potential


def scene_of(call) -> Scene:
    """Return the scene of a call, with the function that was called."""
    function = FUNCTIONS[call.function]
    given = dict(zip(function.parameters.split(", "), call.arguments, strict=False))
    scene = SCENES[call.function](student.find(call.function), given)
    scene.scope = vars(sys.modules[module_of(function.file)])  # whose handle_two_bobs makes the hits
    return scene


# Each function takes a student's solution and the arguments of the call by name, and returns a scene.


def made_cradle(solution, given):
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        file = Path(folder) / "cradle.csv"
        file.write_text(given["relative_filepath"].text, encoding="utf-8")
        return Scene(solution(str(file), given["r_param"], given["theta_init"]), given["r_param"], G)


def made_double_pendulum(solution, given):
    return Scene([{"objects": solution(*given.values())}], given["r_param"], G)


def one_pendulum(_, given):
    from src.swinging import swing_update  # it uses angle_update

    pend = hang(given["theta"], given["omega"], r_param=given["r_param"])
    return moved_by(partial(swing_update, pend), [pend], given)


def row_of_pendula(solution, given):
    pend_list = [pendulum(given["r_param"], **values) for values in given["pend_list"]]
    return moved_by(partial(solution, pend_list), pend_list, given)


def two_that_meet(solution, given):
    """Both start at their highest points, meet at the bottom, and meet there again after each half period."""
    r_param, e, m1, m2 = (given[name] for name in ("r_param", "e", "m1", "m2"))
    omegas = given["omega1"], given["omega2"]  # at the moment when they meet
    time, meet = 0.0, pi / sqrt(G / r_param) / 2  # s

    def tick():
        nonlocal omegas, time, meet
        scene.swing()
        time += DT
        if time >= meet:
            before = [(pend, (omega,)) for pend, omega in zip(scene.pend_list, omegas, strict=True)]
            after = tuple(solution(e, *omegas, m1, m2, r_param))
            for pend, omega in zip(scene.pend_list, after, strict=True):
                pend["theta"], pend["omega"] = 0.0, omega
            if after != omegas:
                scene.hits.add(*before)
            omegas, meet = tuple(-omega for omega in after), time + pi / scene.w

    axles = (0, 0, 0), (r_param / 4, 0, 0)
    thetas = [-omega / sqrt(G / r_param) for omega in omegas]
    values = zip(thetas, (m1, m2), axles, strict=True)
    pend_list = [hang(theta, 0.0, m, 1.0, axle, r_param) for theta, m, axle in values]
    scene = SmallSwings(pend_list, r_param, tick)
    return scene


def two_bobs(_, given):
    r_param = given["r_param"]

    def tick():
        scene.scope["handle_two_bobs"](*pend_list, r_param)  # the first call has the same values as in the check
        scene.swing()

    pend_list = [pendulum(r_param, **given[name]) for name in ("pend1", "pend2")]
    scene = SmallSwings(pend_list, r_param, tick)
    return scene


def one_double_pendulum(solution, given):
    from src.double_cradle import make_double_pendulum
    from support.pendulum import show_double_pendulum

    r_param = given["r_param"]
    objects = make_double_pendulum(vector(0, 0, 0), r_param, given["theta"], given["phi"], color.white, None)
    keys = {"omega": "omega_theta", "phi_omega": "omega_phi", "theta": "theta", "phi": "phi"}
    masses = {name: given[name] for name in ("m1", "m2") if name in given}
    pend = {"m1": 1.0, "m2": 1.0, **masses, **{key: given[name] for key, name in keys.items()}, "objects": objects}

    def tick():
        new = solution(*(pend[key] for key in keys), r_param, DT, given["g"], *masses.values())
        pend.update(zip(keys, new, strict=True))
        show_double_pendulum(pend, r_param)

    return DoubleScene([pend], r_param, given["g"], tick)


def moved_by(move, pend_list, given):
    """Return the scene of pendula that move(r_param, dt, g) moves by dt."""
    r_param, g = given["r_param"], given["g"]
    return Scene(pend_list, r_param, g, lambda: move(r_param, DT, g))


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
    "make_double_pendulum": made_double_pendulum,
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
    text = "duration in seconds (default: %(default)g)"
    parser.add_argument("--seconds", metavar="S", type=seconds, default=10.0, help=text)
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
