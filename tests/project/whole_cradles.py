"""More cradles for the project's tests: CSV text, double pendula made by hand, and cradles in motion."""

from itertools import combinations
from math import pi, sqrt
from types import SimpleNamespace

from vpython import color, mag, vector

from src.double_cradle import make_double_pendulum
from src.live_cradle import LiveCradle
from src.visualize_cradle_run import advance_cradle
from support.constants import BUFFER, G, R_PARAM
from support.cradle_csv import Snapshot
from support.motion import Motion

# Of a small swing at the shipped constants (s), so that tests wait as long as it takes after someone has edited them.
PERIOD = 2 * pi * sqrt(R_PARAM / G)

# Five equal elastic pendula, as the shipped file has them until someone edits it.
HEADER, GOOD = "mass,e,theta,omega,color,texture\n", "1.0,1.0,0.0,0.0,red,metal\n"
FIVE_CSV = HEADER + GOOD * 5


def hang_double(theta=0.0, phi=0.0, omega=0.0, phi_omega=0.0, mass=1.0, e=1.0, axle=(0, 0), r_param=R_PARAM) -> dict:
    """Return a double pendulum that hangs from axle (x, y in m)."""
    objects = make_double_pendulum(vector(*axle, 0), r_param, theta, phi, color.white, None)
    angles = {"theta": theta, "phi": phi, "omega": omega, "phi_omega": phi_omega}
    return {**angles, "mass": mass, "e": e, "color": "white", "texture": "none", "objects": objects}


def distances(pend_list) -> list[float]:
    """Return how far each two bobs of different pendula, single or double, are apart, 1 being where they touch."""
    return [
        mag(bob2.pos - bob1.pos) / (BUFFER * (bob1.radius + bob2.radius))
        for pend1, pend2 in combinations(pend_list, 2)
        for bob1 in pend1["objects"][1::2]
        for bob2 in pend2["objects"][1::2]
    ]


def make_motion(folder, csv=FIVE_CSV, angle=30, lift=1, impacts=4) -> Motion:
    """Return the motion of the cradle of this CSV (written to the folder), just let go from this angle (degrees)."""
    file = folder / "cradle.csv"
    file.write_text(csv)
    options = SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None)
    cradle = LiveCradle(advance_cradle, options)
    cradle.load(Snapshot(file))
    cradle.release([angle], lift)
    return Motion(cradle, impacts)


def components(v) -> tuple[float, float, float]:
    """Return the components of a vector, for pytest.approx."""
    return v.x, v.y, v.z
