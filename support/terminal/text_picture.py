"""A picture of a cradle in characters, which are twice as high as wide."""

from math import atan2, pi

from vpython import cylinder, vector

from support.cradle.cradle import Cradle

CORD_COLUMNS = 16  # of a cord, if they fit; neighbouring bobs are then four apart
STROKES = "-\\|/"  # a line to the right, and lines turned down from it by 45, 90 and 135 degrees


class TextPicture:
    """Draws a cradle, always with the same part of space in view."""

    def __init__(self) -> None:
        """Show the space below the axles; once a bob has been above them, up to there, too."""
        self.above = 0.0  # m

    def lines(self, cradle: Cradle, columns: int, rows: int) -> list[str]:
        """Return the lines of a picture, at most `columns` wide and `rows` high.

        If it does not fit, return none.
        """
        axles = [axle.pos for axle in cradle.axles()]
        bobs = [bob.pos for bob in cradle.bobs()]
        top = max(axle.y for axle in axles)
        self.above = max(self.above, *(bob.y - top for bob in bobs))
        grid = Grid(axles, cradle.cords_length, self.above, columns, rows)
        if grid.scale <= 0:
            return []
        for cord in cradle.cords():
            grid.draw_cord(cord)
        grid.draw_bar()
        grid.draw_bobs(bobs)
        return ["".join(row)[:columns].rstrip() for row in grid.rows]


class Grid:
    """The characters of a picture, by row and column."""

    def __init__(
        self, axles: list[vector], cords_length: float, above: float, columns: int, rows: int
    ) -> None:
        """Make room for a cradle whose bobs are up to cords_length (m) from their axles.

        above (m) is the height above the highest axle that is in view.
        """
        self.axles = axles
        xs = [axle.x for axle in axles]
        ys = [axle.y for axle in axles]
        self.left = min(xs) - cords_length
        self.top = max(ys) + above
        width = max(xs) - min(xs) + 2 * cords_length
        height = max(ys) - min(ys) + cords_length + above
        # Columns per metre. Three columns and a row stay free for rounding, and for the brackets of
        # a bob.
        self.scale = min(
            CORD_COLUMNS / cords_length, (columns - 3) / width, 2 * (rows - 1) / height
        )
        apart = (max(xs) - min(xs)) / max(1, len(axles) - 1)
        # Whole columns from bob to bob: unequal gaps look like groups of bobs
        if apart * self.scale >= 1:
            self.scale = int(apart * self.scale + 1e-9) / apart
        self.apart = apart * self.scale  # columns
        self.rows = [[" "] * columns for _ in range(round(height * self.scale / 2) + 1)]

    def cell(self, place: vector) -> tuple[int, int]:
        """Return the row and the column of a place in space."""
        row = round((self.top - place.y) * self.scale / 2)
        return row, round((place.x - self.left) * self.scale) + 1

    def write(self, row: int, column: int, text: str) -> None:
        """Write a text into a row, from this column on."""
        self.rows[row][column : column + len(text)] = text

    def draw_cord(self, cord: cylinder) -> None:
        """Draw a cord, with a stroke for each row or each column."""
        row, column = self.cell(cord.pos)
        end_row, end_column = self.cell(cord.pos + cord.axis)
        down = end_row - row
        aside = end_column - column
        steps = abs(down) if abs(aside) < 1.5 * abs(down) else abs(aside)
        stroke = STROKES[round(4 * atan2(-cord.axis.y, cord.axis.x) / pi) % 4]
        for step in range(steps):
            self.write(
                row + round(down * step / steps), column + round(aside * step / steps), stroke
            )

    def draw_bar(self) -> None:
        """Draw the bar from which the cords hang, with a plus for each axle."""
        cells = [self.cell(axle) for axle in self.axles]
        columns = [column for _, column in cells]
        first = min(columns) - 1
        self.write(cells[0][0], first, "=" * (max(columns) + 2 - first))
        for row, column in cells:
            self.write(row, column, "+")

    def draw_bobs(self, bobs: list[vector]) -> None:
        """Draw the bobs, as their numbers if these fit next to each other."""
        names = [f"({number})" for number in range(1, len(bobs) + 1)]
        if len(bobs) > 1 and len(names[-1]) > self.apart + 1e-9:
            names = ["O"] * len(bobs)
        for bob, name in zip(bobs, names, strict=True):
            row, column = self.cell(bob)
            self.write(row, max(0, column - len(name) // 2), name)
