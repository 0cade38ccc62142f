"""The colors of the shipped cradle, as people see them who lack one kind of cones.

The matrices are for a full lack, in linear red, green and blue: Machado, Oliveira and Fernandes, "A Physiologically-
based Model for Simulation of Color Vision Deficiency" (2009). The distance is that of two colors in CIELAB; at 2, you
just see a difference.
"""

from itertools import combinations
from math import dist

import pytest
from programs import ROOT

from support.constants import COLOR_MAP
from support.files.cradle_csv import read_cells

TOLD_APART = 25
SIGHT = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.152, 1.053, -0.205), (0.115, 0.786, 0.099), (-0.004, -0.048, 1.052)),
    "deuteranopia": ((0.367, 0.861, -0.228), (0.280, 0.673, 0.047), (-0.012, 0.043, 0.969)),
    "tritanopia": ((1.256, -0.077, -0.179), (-0.078, 0.931, 0.148), (0.005, 0.691, 0.304)),
}
TO_XYZ = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))
WHITE = (0.9505, 1.0, 1.0888)


def times(matrix, triple):
    return [sum(a * b for a, b in zip(row, triple, strict=True)) for row in matrix]


def linear(part):
    """Return a part of an sRGB color, 0 to 1, in proportion to its light."""
    return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4


def lab(light):
    """Return linear red, green and blue in CIELAB."""
    parts = [part / white for part, white in zip(times(TO_XYZ, light), WHITE, strict=True)]
    x, y, z = (part ** (1 / 3) if part > 0.008856 else 7.787 * part + 16 / 116 for part in parts)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def nearest(names, sight):
    """Return the smallest distance of two of these colors to a person with this sight."""
    lights = [[linear(part) for part in COLOR_MAP[name].value] for name in names]
    seen = [lab([min(1, max(0, part)) for part in times(SIGHT[sight], light)]) for light in lights]
    return min(dist(one, other) for one, other in combinations(seen, 2))


@pytest.mark.parametrize("sight", SIGHT)
def test_the_colors_of_the_shipped_cradle_can_be_told_apart(sight):
    header, *rows = [cells for _, cells in read_cells(ROOT / "newton_cradle_pends.csv")]
    assert nearest([row[header.index("color")] for row in rows], sight) > TOLD_APART


def test_the_simulation_finds_colors_that_are_mixed_up():
    assert nearest(["orange", "green"], "all cones") > TOLD_APART
    assert nearest(["orange", "green"], "deuteranopia") < TOLD_APART
    assert nearest(["yellow", "white"], "tritanopia") < TOLD_APART
