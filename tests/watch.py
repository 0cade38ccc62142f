"""Watch a check that fails, in the terminal: `python tests/watch.py test_angle_update`.

The pendula that the check hands over start as they are then, and swing and collide by the functions in src/, in real
time, tick by tick of DT. Of a function that makes pendula, what it has made is shown.
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from support import headless_vpython

headless_vpython.install()

from cradles import hang
from grader import checks, find, Grading, PASSED
from handout import FUNCTIONS, SUITES
from telling import raised
from vpython import color, vector

from support.audit import double_kinetic_energy, double_potential_energy, kinetic_energy, potential_energy
from support.constants import DT, G
from support.cradle_csv import to_number
from support.motion import Motion
from support.options import allowed, OneLineParser
from support.output import while_it_is_read
from support.text_picture import TextPicture

COLUMNS, ROWS = 80, 20  # of a picture that does not move
IMPACTS = 4  # lines of the contact strip


class Scene:
    """The pendula of a call of a student's function, as far as the terminal needs a cradle (support/cradle.py)."""

    dt = DT

    def __init__(self, pend_list, r_param, g, tick=None):
        """tick() is to move them on by DT, and may return who hit whom, as (left, right); without it they stand."""
        self.pend_list = pend_list
        self.r_param, self.g, self.tick = r_param, g, tick
        self.is_double = len(pend_list[0]["objects"]) == 5
        self.reach = 2 * r_param if self.is_double else r_param

    def advance(self, ticks, _) -> list[tuple[int, int, int]]:
        """Move on by so many ticks; return the contacts as (tick, left, right), indices of pendula."""
        return [(tick, *pair) for tick in range(ticks) for pair in self.tick() or []]

    def axles(self):
        return [pend["objects"][0] for pend in self.pend_list]

    def bobs(self):
        return [bob for pend in self.pend_list for bob in pend["objects"][1::2]]

    def cords(self):
        return [cord for pend in self.pend_list for cord in pend["objects"][2::2]]

    def thetas(self):
        return [pend["theta"] for pend in self.pend_list]

    def velocities(self):
        return [pend["omega"] for pend in self.pend_list]  # of which only the sign is looked at

    def energies(self):
        kinetic, potential = kinetic_energy, potential_energy
        if self.is_double:
            kinetic, potential = double_kinetic_energy, double_potential_energy
        return kinetic(self.pend_list, self.r_param), potential(self.pend_list, self.r_param, self.g)


def scene_of(call) -> Scene:
    """Return the scene of a call, in which the function that was called does its part."""
    given = dict(zip(FUNCTIONS[call.function].parameters.split(", "), call.arguments, strict=False))
    return SCENES[call.function](find(call.function), given)


def made_cradle(make_newton_cradle, given):
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        file = Path(folder) / "cradle.csv"
        file.write_text(given["relative_filepath"].text, encoding="utf-8")
        return Scene(make_newton_cradle(str(file), given["r_param"], given["theta_init"]), given["r_param"], G)


def made_double_pendulum(make_double_pendulum, given):
    objects = make_double_pendulum(*given.values())
    return Scene([{"theta": given["theta"], "omega": 0.0, "objects": objects}], given["r_param"], G)


def one_pendulum(_, given):
    from src.swinging import swing_update  # which uses angle_update

    pend = hang(given["theta"], given["omega"], r_param=given["r_param"])
    return Scene([pend], given["r_param"], given["g"], lambda: swing_update(pend, given["r_param"], DT, given["g"]))


def row_that_swings(full_swing_update, given):
    pend_list = [pendulum(given["r_param"], **values) for values in given["pend_list"]]
    arguments = pend_list, given["r_param"], DT, given["g"]
    return Scene(pend_list, given["r_param"], given["g"], lambda: full_swing_update(*arguments))


def two_that_meet(_, given):
    from src.visualize_cradle_run import advance_cradle  # which uses handle_collision

    r_param, e = given["r_param"], given["e"]
    left = hang(0.0, given["omega1"], given["m1"], e, r_param=r_param)
    right = hang(0.0, given["omega2"], given["m2"], e, (r_param / 4, 0, 0), r_param)
    arguments = [left, right], r_param, DT, G, 1
    return Scene([left, right], r_param, G, lambda: [pair for _, *pair in advance_cradle(*arguments, True)])


def two_bobs(handle_two_bobs, given):
    from src.swinging import swing_update

    r_param = given["r_param"]
    pend_list = [pendulum(r_param, **given[name]) for name in ("pend1", "pend2")]

    def tick():
        for pend in pend_list:
            swing_update(pend, r_param, DT, G)
        before = [pend["omega"] for pend in pend_list]
        handle_two_bobs(*pend_list, r_param)
        return [] if before == [pend["omega"] for pend in pend_list] else [(0, 1)]

    return Scene(pend_list, r_param, G, tick)


def row_that_ticks(newton_cradle_tick, given):
    from src import visualize_cradle_run

    pend_list = [pendulum(given["r_param"], **values) for values in given["pend_list"]]
    handle_two_bobs, hits = visualize_cradle_run.handle_two_bobs, []

    def noting_hits(pend1, pend2, *arguments):
        before = pend1["omega"], pend2["omega"]
        handle_two_bobs(pend1, pend2, *arguments)
        if before != (pend1["omega"], pend2["omega"]):
            hits.append([i for i, pend in enumerate(pend_list) if pend is pend1 or pend is pend2])

    def tick():
        hits.clear()
        with patch.object(visualize_cradle_run, "handle_two_bobs", noting_hits):
            newton_cradle_tick(pend_list, given["r_param"], DT, given["g"])
        return hits

    return Scene(pend_list, given["r_param"], given["g"], tick)


def one_double_pendulum(double_angle_update, given):
    from src.double_cradle import make_double_pendulum, show_double_pendulum

    r_param = given["r_param"]
    objects = make_double_pendulum(vector(0, 0, 0), r_param, given["theta"], given["phi"], color.white, None)
    keys = {"omega": "omega_theta", "phi_omega": "omega_phi", "theta": "theta", "phi": "phi"}
    pend = {**{key: given[name] for key, name in keys.items()}, "mass": 1.0, "objects": objects}
    masses = [given[name] for name in ("m1", "m2") if name in given]

    def tick():
        new = double_angle_update(*(pend[key] for key in keys), r_param, DT, given["g"], *masses)
        pend.update(zip(keys, new, strict=True))
        show_double_pendulum(pend, r_param)

    return Scene([pend], r_param, given["g"], tick)


def pendulum(r_param, mass, e, theta, omega, axle, radius, **_):
    """Return a pendulum again from what it was as plain values."""
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


def main() -> None:
    """Say what is wrong in a check, and play it; status 2 if there is no such check, 1 if it cannot be played."""
    all_checks = {check.name: check for tier in SUITES for check in checks(tier=tier)}
    names = allowed(str, all_checks.__contains__, "the name of a check, as test_angle_update")
    parser = OneLineParser(description="Watch a check that fails, in the terminal.", allow_abbrev=False)
    parser.add_argument("check", metavar="CHECK", type=names, help="its name, as test_angle_update")
    seconds = allowed(float, lambda text: 0 < to_number(text) <= 1e6, "a number above 0 and up to 1e6 (s)")
    text = "for how long (default: %(default)g)"
    parser.add_argument("--seconds", metavar="S", type=seconds, default=10.0, help=text)
    options = parser.parse_args()

    outcome = Grading().judge(all_checks[options.check])
    print(outcome.message or f"{options.check} passes.", flush=True)
    if outcome.state == PASSED:
        return
    if not outcome.call:
        sys.exit("There is nothing to watch.")
    try:
        with while_it_is_read():
            play(scene_of(outcome.call), options.seconds)
    except KeyboardInterrupt:
        pass
    except Exception as error:
        sys.exit(f"It cannot be played: {raised(error)[0]}")


def play(scene, seconds) -> None:
    """Show a scene for so many seconds, or as it is if nothing moves in it."""
    from src.text_cradle_run import has_terminal, show_pictures, tell_lines

    if scene.tick is None:
        print("", *TextPicture().lines(scene, COLUMNS, ROWS), sep="\n")
    elif has_terminal():
        show_pictures(Motion(scene, IMPACTS), seconds)
    else:
        tell_lines(Motion(scene, IMPACTS), seconds)


if __name__ == "__main__":
    main()
