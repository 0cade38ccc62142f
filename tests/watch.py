"""Watch a check that fails, in the terminal: `python tests/watch.py test_angle_update`.

The pendula that the check hands over start as they are then, and swing and collide by the functions in src/, in real
time. Of a function that makes pendula, what it has made is shown.
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from support import headless_vpython

headless_vpython.install()

from cradles import hang
from grader import checks, find, Grading
from handout import FUNCTIONS, SUITES
from telling import raised
from vpython import color, vector

from support.audit import double_kinetic_energy, double_potential_energy, kinetic_energy, potential_energy
from support.constants import DT, G
from support.cradle_csv import to_number
from support.motion import Motion
from support.options import allowed, OneLineParser
from support.text_picture import TextPicture

COLUMNS, ROWS = 80, 20  # of a picture that does not move
IMPACTS = 4  # lines of the contact strip


class Scene:
    """The pendula of a call of a student's function, as far as the terminal needs a cradle (support/cradle.py)."""

    dt = DT

    def __init__(self, pend_list, r_param, g, tick=None):
        """tick() is to move them on by DT and return who hit whom, as (left, right); without it they stand still."""
        self.pend_list = pend_list
        self.r_param, self.g, self.tick = r_param, g, tick
        self.is_double = len(pend_list[0]["objects"]) == 5
        self.reach = 2 * r_param if self.is_double else r_param

    def advance(self, ticks, _) -> list[tuple[int, int, int]]:
        """Move on by so many ticks; return the contacts as (tick, left, right), indices of pendula."""
        return [(tick, *pair) for tick in range(ticks) for pair in self.tick()]

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
    from src import double_cradle, swinging, visualize_cradle_run

    function = find(call.function)
    given = dict(zip(FUNCTIONS[call.function].parameters.split(", "), call.arguments, strict=False))
    r_param, g = given["r_param"], given.get("g", G)

    def pendulum(theta=0.0, omega=0.0, mass=1.0, e=1.0, axle=(0, 0, 0), radius=None, **_):
        pend = hang(theta, omega, mass, e, axle, r_param)
        pend["objects"][1].radius = radius or pend["objects"][1].radius
        return pend

    def swing():
        for pend in pend_list:
            swinging.swing_update(pend, r_param, DT, g)
        return []

    def full_swing():
        function(pend_list, r_param, DT, g)
        return []

    def double_swing():
        state = (pend_list[0][key] for key in ("omega", "phi_omega", "theta", "phi"))
        masses = (given[name] for name in ("m1", "m2") if name in given)
        new = function(*state, r_param, DT, g, *masses)
        pend_list[0].update(zip(("omega", "phi_omega", "theta", "phi"), new, strict=True))
        double_cradle.show_double_pendulum(pend_list[0], r_param)
        return []

    def advance():
        told = visualize_cradle_run.advance_cradle(pend_list, r_param, DT, g, 1, approaching_only=True)
        return [pair for _, *pair in told]

    def two_bobs(pend1, pend2, *arguments):
        before = pend1["omega"], pend2["omega"]
        handle_two_bobs(pend1, pend2, *arguments)
        if before != (pend1["omega"], pend2["omega"]):
            hits.append(tuple(i for i, pend in enumerate(pend_list) if pend is pend1 or pend is pend2))

    def collide():
        swing()
        hits.clear()
        two_bobs(*pend_list, r_param)
        return hits

    def tick():
        hits.clear()
        with patch.object(visualize_cradle_run, "handle_two_bobs", two_bobs):
            function(pend_list, r_param, DT, g)
        return hits

    hits: list = []
    handle_two_bobs = visualize_cradle_run.handle_two_bobs
    match call.function:
        case "make_newton_cradle":
            with TemporaryDirectory() as folder:
                file = Path(folder) / "cradle.csv"
                file.write_text(given["relative_filepath"].text)
                return Scene(function(str(file), r_param, given["theta_init"]), r_param, g)
        case "make_double_pendulum":
            objects = function(*call.arguments)
            return Scene([{"theta": given["theta"], "omega": 0.0, "objects": objects}], r_param, g)
        case "angle_update":
            pend_list, move = [pendulum(given["theta"], given["omega"])], swing
        case "full_swing_update":
            pend_list, move = [pendulum(**plain) for plain in given["pend_list"]], full_swing
        case "newton_cradle_tick":
            pend_list, move = [pendulum(**plain) for plain in given["pend_list"]], tick
        case "handle_collision":
            mass1, mass2, e = given["m1"], given["m2"], given["e"]
            left = pendulum(0.0, given["omega1"], mass1, e)
            pend_list = [left, pendulum(0.0, given["omega2"], mass2, e, (r_param / 4, 0, 0))]
            move = advance
        case "handle_two_bobs":
            pend_list, move = [pendulum(**given["pend1"]), pendulum(**given["pend2"])], collide
        case "double_angle_update":
            angles = {"theta": given["theta"], "phi": given["phi"]}
            objects = double_cradle.make_double_pendulum(vector(0, 0, 0), r_param, *angles.values(), color.white, None)
            rates = {"omega": given["omega_theta"], "phi_omega": given["omega_phi"]}
            pend_list, move = [{**angles, **rates, "mass": 1.0, "objects": objects}], double_swing
    return Scene(pend_list, r_param, g, move)


def main() -> None:
    """Say what is wrong in a check, and play its scene; status 2 if there is no such check, 1 if it has no scene."""
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
    if not outcome.call:
        sys.exit("There is nothing to watch.")
    try:
        play(scene_of(outcome.call), options.seconds)
    except (Exception, SystemExit) as error:
        sys.exit("\n".join(["It cannot be played:", *raised(error)]))


def play(scene, seconds) -> None:
    """Show a scene for so many seconds, or as it is if nothing moves in it."""
    from src.text_cradle_run import show_pictures, tell_lines

    if scene.tick is None:
        print("", *TextPicture().lines(scene, COLUMNS, ROWS), sep="\n")
    elif sys.stdout.isatty():
        show_pictures(Motion(scene, IMPACTS), seconds)
    else:
        tell_lines(Motion(scene, IMPACTS), seconds)


if __name__ == "__main__":
    main()
