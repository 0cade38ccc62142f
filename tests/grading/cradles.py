"""Cradles for the checks and the tests: CSV text, and pendula made by hand, without src/."""

from vpython import color, vector

from support.pendulum import make_pendulum

R = 0.4  # m; R_PARAM differs, so a check finds the constant in place of the parameter

# All pendula differ, no value is a default, and make_newton_cradle must change theta and omega.
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


def hang(theta=0.0, omega=0.0, mass=1.0, e=1.0, axle=(0.0, 0.0, 0.0), r_param=R, radius=None) -> dict:
    """Return a pendulum at theta (rad) below axle (x, y, z in m); without radius (m), the bob has the usual one."""
    objects = make_pendulum(vector(*axle), r_param, theta, color.white, None)
    objects[1].radius = radius or objects[1].radius
    values = {"mass": mass, "e": e, "theta": theta, "omega": omega, "color": "white", "texture": "none"}
    return {**values, "objects": objects}


def row(count, **values) -> list[dict]:
    """Return count pendula with axles R / 4 apart, and these values for hang."""
    return [hang(axle=(i * R / 4, 0, 0), **values) for i in range(count)]
