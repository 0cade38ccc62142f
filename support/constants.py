"""The constants of the cradle, each with its unit and the reason for its value."""

from math import pi
from pathlib import Path

from vpython import color, textures

# The cradle's file, as an absolute path, so that programs can be started from any folder.
NC_FP = str(Path(__file__).resolve().parents[1] / "newton_cradle_pends.csv")

# Cord length (m). The handout's axle positions, r_param/4 apart from x = -0.1, then centre five pendula.
R_PARAM = 0.2

# Gravitational acceleration (m/s^2), the usual value near the ground.
G = 9.81

# One tick (s). Fine enough for an elastic cradle to keep its energy within 0.1 % a minute.
DT = 0.0001

# Angle (rad from straight down, positive to the right) at which the first pendulum is let go: 45 degrees to the left,
# away from the others, which would be in its way on the right.
THETA_INIT = -pi / 4

# In the double cradle, the angle (rad) at which the first pendulum's lower cord is bent from the direction of its upper
# one: 20 degrees further outwards, nearly as in the slow one of the two ways in which a double pendulum swings steadily
# (phi = 0.41 theta), so that the first hits go through the row as in a single cradle.
PHI_INIT = -pi / 9

# One tick of the double cradle (s). With its more exact steps the energy would bear a longer one; but its bobs are
# faster, and this is short enough for equal ones to get hardly more than two hundredths of the way into one another.
DOUBLE_DT = 0.00025

# Two bobs collide where their centres are within this many times the sum of their radii: the handout's little buffer.
BUFFER = 1.05

# What may stand in the CSV's color column: every color of VPython by name, as VPython's vector of red, green and blue.
COLOR_MAP = {
    "black": color.black,
    "white": color.white,
    "red": color.red,
    "green": color.green,
    "blue": color.blue,
    "yellow": color.yellow,
    "cyan": color.cyan,
    "magenta": color.magenta,
    "orange": color.orange,
    "purple": color.purple,
}

# What may stand in the CSV's texture column: every texture of VPython by name, and "none" for a plain bob.
TEXTURE_MAP = {
    "none": None,
    "flower": textures.flower,
    "granite": textures.granite,
    "gravel": textures.gravel,
    "earth": textures.earth,
    "metal": textures.metal,
    "rock": textures.rock,
    "rough": textures.rough,
    "rug": textures.rug,
    "stones": textures.stones,
    "stucco": textures.stucco,
    "wood": textures.wood,
    "wood_old": textures.wood_old,
}
