"""The small pictures of the cradles that you can choose, as numbers for gallery.js."""

from collections.abc import Sequence

from support.constants import COLOR_MAP
from support.files.cradle_csv import Snapshot
from support.page.graph import to_css

CSS = {name: to_css(color) for name, color in COLOR_MAP.items()}  # the colors, as CSS has them

GalleryPicture = list[dict]  # a dictionary for each pendulum


def gallery_picture(csv: Snapshot, poses: Sequence[Sequence[float]]) -> GalleryPicture:
    """Return the picture of a valid CSV's cradle: the color and the mass (kg) of each pendulum.

    And its angles: those of its cords from straight down (rad). poses has them for each pendulum.
    """
    header, *rows = [row.cells for row in csv.rows]
    pendula = []
    for cells, angles in zip(rows, poses, strict=True):
        row = dict(zip(header, cells, strict=False))  # a short row lacks its last cells
        pendula.append({"color": CSS[row["color"]], "mass": float(row["mass"]), "angles": angles})
    return pendula


def at_rest(csv: Snapshot, cords: int) -> GalleryPicture:
    """Return the picture of a CSV's cradle that hangs; a pendulum has this number of cords."""
    return gallery_picture(csv, [[0.0] * cords for _ in csv.rows[1:]])
