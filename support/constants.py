"""The constants of the cradle, each with its unit and the reason for its value."""

from math import pi
from pathlib import Path

from vpython import color, textures, vector

# The cradle's file. The path is absolute, so that you can start a program in any folder.
NC_FP = str(Path(__file__).resolve().parents[1] / "newton_cradle_pends.csv")

# Cord length (m). With it, five pendula are centred: the axles are r_param/4 apart, from
# x = -0.1 on.
R_PARAM = 0.2

# Gravitational acceleration (m/s^2), the usual value near the ground.
G = 9.81

# One tick (s). It is short enough: an elastic cradle keeps its energy within 0.1 % for a minute.
DT = 0.0001

# Release angle of the first pendulum (rad from straight down, positive to the right): 45 degrees to
# the left. It cannot be positive: on the right, the other pendula are in its way.
THETA_INIT = -pi / 4

# Double cradle: angle (rad) of the first pendulum's lower cord from its upper one, 20 degrees
# further outwards. This is near the slow normal mode (phi = 0.41 theta), so the first hits go
# through the row as in a single cradle.
PHI_INIT = -pi / 9

# One tick of the double cradle (s). A longer tick would keep the energy well enough. But the
# bobs of the double cradle are faster than those of the single one: in this tick, equal bobs hardly
# come closer than 98 % of the distance at which they touch.
DOUBLE_DT = 0.00025

# The names allowed in the CSV's color column: all colors of VPython, each as a vector of red, green
# and blue.
COLOR_MAP = {name: value for name, value in vars(color).items() if isinstance(value, vector)}

# The names allowed in the CSV's texture column: all textures of VPython, "none" for a plain bob.
TEXTURE_MAP = {"none": None}
TEXTURE_MAP |= {name: value for name, value in vars(textures).items() if name[0] != "_"}
