"""Cradles for the suites: CSV text, single pendula made by hand, and whole projects."""

import shutil
from itertools import combinations
from math import pi, sqrt
from pathlib import Path
from types import SimpleNamespace

from vpython import color, mag, vector

from src.double_cradle import make_double_pendulum
from src.live_cradle import LiveCradle
from src.visualize_cradle_run import advance_cradle
from support.constants import BUFFER, G, R_PARAM
from support.cradle_csv import Snapshot
from support.motion import Motion
from support.pendulum import make_pendulum

ROOT = Path(__file__).parents[1]

R = 0.4  # m, not the shipped cord length, so that a constant in place of the parameter shows

# Of a small swing at the shipped constants (s), so that tests wait as long as it takes after someone has edited them.
PERIOD = 2 * pi * sqrt(R_PARAM / G)

# Five equal elastic pendula, as the shipped file has them until someone edits it.
HEADER, GOOD = "mass,e,theta,omega,color,texture\n", "1.0,1.0,0.0,0.0,red,metal\n"
FIVE_CSV = HEADER + GOOD * 5

# No two pendula alike, no value a default, and none of theta and omega what make_newton_cradle is to set.
MIXED_CSV = """\
mass,e,theta,omega,color,texture
1.5,0.9,0.3,2.0,red,metal
2.5,0.8,-0.2,-1.0,blue,none
0.5,0.7,0.1,0.5,yellow,wood
"""
MIXED = [
    {"mass": 1.5, "e": 0.9, "theta": 0.3, "omega": 2.0, "color": "red", "texture": "metal"},
    {"mass": 2.5, "e": 0.8, "theta": -0.2, "omega": -1.0, "color": "blue", "texture": "none"},
    {"mass": 0.5, "e": 0.7, "theta": 0.1, "omega": 0.5, "color": "yellow", "texture": "wood"},
]


def hang(theta=0.0, omega=0.0, mass=1.0, e=1.0, axle=(0.0, 0.0, 0.0), r_param=R) -> dict:
    """Return a pendulum that hangs from axle (x, y, z in m) at theta (rad)."""
    objects = make_pendulum(vector(*axle), r_param, theta, color.white, None)
    values = {"mass": mass, "e": e, "theta": theta, "omega": omega, "color": "white", "texture": "none"}
    return {**values, "objects": objects}


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


def row(count, **values) -> list[dict]:
    """Return count pendula at rest, R / 4 apart, with these values (as for hang)."""
    return [hang(axle=(i * R / 4, 0, 0), **values) for i in range(count)]


def make_motion(folder, csv=FIVE_CSV, angle=30, lift=1, impacts=4) -> Motion:
    """Return the motion of the cradle of this CSV (written to the folder), just let go from this angle (degrees)."""
    file = folder / "cradle.csv"
    file.write_text(csv)
    options = SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None)
    cradle = LiveCradle(advance_cradle, options)
    cradle.load(Snapshot(file))
    cradle.release([angle], lift)
    return Motion(cradle, impacts)


def copy_project(folder, csv) -> Path:
    """Copy what the programs need, and this CSV, into a folder; return it."""
    for name in ("src", "support"):
        shutil.copytree(ROOT / name, folder / name)
    shutil.copy(ROOT / "pds_tester.py", folder)
    (folder / "newton_cradle_pends.csv").write_text(csv)
    return folder


def components(v) -> tuple[float, float, float]:
    """Return the components of a vector, for pytest.approx."""
    return v.x, v.y, v.z
