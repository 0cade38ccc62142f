"""The small pictures of the cradles that you can choose, as numbers for gallery.js."""

from collections.abc import Sequence

from support.constants import COLOR_MAP
from support.files.experiments import Hidden
from support.files.valid_cradle import CradleCsv
from support.page.graph import to_css

CSS = {name: to_css(color) for name, color in COLOR_MAP.items()}  # the colors, as CSS has them


def gallery_picture(
    csv: CradleCsv, poses: Sequence[Sequence[float]], hidden: Hidden | None = None
) -> list[dict]:
    """Return the picture of a CSV's cradle: the color and the mass (kg) of each pendulum.

    And its angles: those of its cords from straight down (rad). poses has them for each pendulum.
    A hidden mass is None.
    """
    pendula: list[dict] = []
    for cells, angles in zip(csv.pendula, poses, strict=True):
        row = dict(zip(csv.columns, cells, strict=True))
        pendula.append({"color": CSS[row["color"]], "mass": float(row["mass"]), "angles": angles})
    if hidden and hidden.column == "mass":
        for index in hidden.rows:
            pendula[index]["mass"] = None
    return pendula
