"""Watch a check in the terminal: `python tests/watch.py test_angle_update`.

The pendula start as the check gives them to your function. Your function does its part in each tick, in real time. If
it makes pendula, the picture shows them.
"""

import sys
from math import cos, pi, sin, sqrt
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace
from unittest.mock import patch

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parent))  # so that Python finds grading, also with -P

from grading import project_path  # noqa: F401  finds the imports below
from support import headless_vpython

headless_vpython.install()

from vpython import color, mag, vector

from grading.cradles import hang
from grading.grader import checks, find, Grading, PASSED
from grading.handout import FUNCTIONS, SUITES
from grading.telling import own_places, raised
from support.constants import DT, G
from support.energy import double_kinetic_energy, double_potential_energy, kinetic_energy, potential_energy
from support.files.cradle_csv import to_number
from support.pendulum import show_pendulum
from support.playback.cradle import Cradle
from support.playback.player import run
from support.start.interrupt import stop_on_signals
from support.start.options import allowed, OneLineParser
from support.start.output import is_unread, while_it_is_read
from support.terminal.picture import TextPicture
from support.terminal.players import has_terminal, Lines, Pictures, show_pictures

COLUMNS, ROWS = 80, 20  # of a still picture


class Scene(Cradle):
    """The pendula of a call of a student's function.

    It has only the parts of a cradle (support/playback/cradle.py) that the terminal needs.
    """

    dt = DT
    held, takes_rule = None, False

    def __init__(self, pend_list, r_param, g, tick=None):
        """tick() moves the pendula by DT, and may return hits as (left, right) indices. Without tick, they stand."""
        if not pend_list:
            raise ValueError("the cradle has no pendulum")
        self.pend_list, self.hits = pend_list, []
        self.r_param, self.g, self.tick = r_param, g, tick
        lengths = [mag(bob.pos - pend["objects"][0].pos) for pend in pend_list for bob in pend["objects"][1::2]]
        # All pendula are in the picture, even with cords of a wrong length.
        self.reach = max(len(pend_list[0]["objects"]) // 2 * r_param, *lengths)

    def axles(self):
        return [pend["objects"][0] for pend in self.pend_list]

    def bobs(self):
        return [bob for pend in self.pend_list for bob in pend["objects"][1::2]]

    def cords(self):
        return [cord for pend in self.pend_list for cord in pend["objects"][2::2]]

    def thetas(self):
        return [pend["theta"] for pend in self.pend_list]

    def energies(self):
        return kinetic_energy(self.pend_list, self.r_param), potential_energy(self.pend_list, self.r_param, self.g)


class SmallSwings(Scene):
    """Two pendula with the swing of small angles, theta'' = -w^2 theta with w = sqrt(G / R), at all angles.

    It needs no function of the student. At the time t after theta0 and omega0, theta is
    theta0 cos(w t) + omega0 / w sin(w t), and omega is omega0 cos(w t) - theta0 w sin(w t).
    """

    def __init__(self, pend_list, r_param):
        super().__init__(pend_list, r_param, G)
        self.w = sqrt(G / r_param)
        self.begin([(pend["theta"], pend["omega"]) for pend in pend_list])

    def begin(self, states):
        """Start again now, with (theta0, omega0) in rad and rad/s for each pendulum."""
        self.states = states
        self.move_to(0.0)

    def move_to(self, time):
        """Move the pendula to this time (s) after begin."""
        self.time = time
        c, s = cos(self.w * time), sin(self.w * time)
        for pend, (theta0, omega0) in zip(self.pend_list, self.states, strict=True):
            pend["theta"] = theta0 * c + omega0 / self.w * s
            pend["omega"] = omega0 * c - theta0 * self.w * s
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
    given = dict(zip(FUNCTIONS[call.function].parameters.split(", "), call.arguments, strict=False))
    return SCENES[call.function](find(call.function), given)


# Each function takes a student's solution and the arguments of the call by name, and returns a scene.


def made_cradle(solution, given):
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        file = Path(folder) / "cradle.csv"
        file.write_text(given["relative_filepath"].text, encoding="utf-8")
        return Scene(solution(str(file), given["r_param"], given["theta_init"]), given["r_param"], G)


def made_double_pendulum(solution, given):
    objects = solution(*given.values())
    return Scene([{"objects": objects}], given["r_param"], G)


def one_pendulum(_, given):
    from src.swinging import swing_update  # it uses angle_update

    pend = hang(given["theta"], given["omega"], r_param=given["r_param"])

    def tick():
        swing_update(pend, given["r_param"], DT, given["g"])

    return Scene([pend], given["r_param"], given["g"], tick)


def row_that_swings(solution, given):
    pend_list = [pendulum(given["r_param"], **values) for values in given["pend_list"]]

    def tick():
        solution(pend_list, given["r_param"], DT, given["g"])

    return Scene(pend_list, given["r_param"], given["g"], tick)


def two_that_meet(solution, given):
    """Both start at their highest points, meet at the bottom, and meet there again after each half period."""
    r_param, e, m1, m2 = (given[name] for name in ("r_param", "e", "m1", "m2"))
    pend_list = [hang(mass=m1, r_param=r_param), hang(mass=m2, axle=(r_param / 4, 0, 0), r_param=r_param)]
    scene = SmallSwings(pend_list, r_param)
    omegas = given["omega1"], given["omega2"]  # at the moment when they meet
    scene.begin([(-omega / scene.w, 0.0) for omega in omegas])
    meet = pi / scene.w / 2  # s after begin

    def tick():
        nonlocal omegas, meet
        scene.move_to(scene.time + DT)
        if scene.time < meet:
            return []
        before, after = omegas, tuple(solution(e, *omegas, m1, m2, r_param))
        scene.begin([(0.0, omega) for omega in after])
        omegas, meet = tuple(-omega for omega in after), pi / scene.w
        return [(0, 1)] if after != before else []

    scene.tick = tick
    return scene


def two_bobs(solution, given):
    r_param = given["r_param"]
    scene = SmallSwings([pendulum(r_param, **given[name]) for name in ("pend1", "pend2")], r_param)

    def states():
        return [(pend["theta"], pend["omega"]) for pend in scene.pend_list]

    def tick():
        before = states()
        solution(*scene.pend_list, r_param)  # the first call has the same values as in the check
        hits = [(0, 1)] if states() != before else []
        if hits:
            scene.begin(states())
        scene.move_to(scene.time + DT)
        return hits

    scene.tick = tick
    return scene


def row_that_ticks(solution, given):
    from src import visualize_cradle_run

    pend_list = [pendulum(given["r_param"], **values) for values in given["pend_list"]]
    meet, hits = visualize_cradle_run.handle_two_bobs, []

    def noting_hits(*arguments, **named):
        before = [pend["omega"] for pend in pend_list]
        result = meet(*arguments, **named)
        if before != [pend["omega"] for pend in pend_list]:
            taken = [*arguments, *named.values()]
            pair = [i for i, pend in enumerate(pend_list) if any(pend is one for one in taken)]
            hits.append((pair[0], pair[-1]))
        return result

    def tick():
        hits.clear()
        with patch.object(visualize_cradle_run, "handle_two_bobs", noting_hits):
            solution(pend_list, given["r_param"], DT, given["g"])
        return hits

    return Scene(pend_list, given["r_param"], given["g"], tick)


def one_double_pendulum(solution, given):
    from src.double_cradle import make_double_pendulum, show_double_pendulum

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


def pendulum(r_param, mass, e, theta, omega, axle, radius, **_):
    """Return a pendulum with these plain values."""
    return hang(theta, omega, mass, e, axle, r_param, radius)


SCENES = {
    "make_newton_cradle": made_cradle,
    "angle_update": one_pendulum,
    "full_swing_update": row_that_swings,
    "handle_collision": two_that_meet,
    "handle_two_bobs": two_bobs,
    "newton_cradle_tick": row_that_ticks,
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
        if is_unread(error) or isinstance(error, OSError) and not own_places(error):
            raise  # while_it_is_read ends the program
        sys.exit(f"It cannot be played: {raised(error)[0]}")


def play(scene, seconds) -> None:
    """Play a scene for seconds, or show one picture if nothing moves in it."""

    class WatchedPictures(Pictures):
        script = Pictures.play  # the cradle exists already

    class WatchedLines(Lines):
        script = Lines.play

    def loop(player):
        while player.is_running():
            while player.wants_tick():
                omegas = [pend["omega"] for pend in scene.pend_list]
                pairs = scene.tick() or []
                for left, right in pairs:
                    speed = (omegas[left] - omegas[right]) * scene.r_param
                    scene.hits.append((left, right, omegas[left] + omegas[right] > 0, speed))

    options = SimpleNamespace(angle=None, lift=None, seconds=seconds)
    if scene.tick is None:
        print("", *TextPicture().lines(scene, COLUMNS, ROWS), sep="\n")
    elif has_terminal():
        show_pictures(loop, WatchedPictures(scene, None, options))
    else:
        run(loop, WatchedLines(scene, None, options))


if __name__ == "__main__":
    main()
