"""The cradle as a picture of plain ASCII characters, each of them twice as high as it is wide."""

from math import atan2, pi

from support.cradle import Cradle

CORD = 16  # columns that a cord is long where there is room: neighbouring bobs are then four columns apart
STROKES = "-\\|/"  # a line to the right, and one that is turned down from there by 45, 90 and 135 degrees


class TextPicture:
    """Draws a cradle, always with the same part of the world in view."""

    def __init__(self):
        """Begin with what is below the axles; once a bob has been above them, there is room for that as well."""
        self.above = 0.0  # m

    def lines(self, cradle: Cradle, columns, rows) -> list[str]:
        """Return the lines of a picture that is at most so many columns wide and rows high."""
        axles, bobs = [axle.pos for axle in cradle.axles()], [bob.pos for bob in cradle.bobs()]
        self.above = max(self.above, *(bob.y - axles[0].y for bob in bobs))
        left, width = axles[0].x - cradle.reach, axles[-1].x - axles[0].x + 2 * cradle.reach
        top, height = axles[0].y + self.above, cradle.reach + self.above
        # Columns for a metre. Three columns and a row are left for what is rounded up, and for the brackets of a bob.
        scale = min(CORD / cradle.reach, (columns - 3) / width, 2 * (rows - 1) / height)
        apart = (axles[-1].x - axles[0].x) / max(1, len(axles) - 1)
        if apart * scale >= 1:  # whole columns from bob to bob: others look like groups of bobs
            scale = int(apart * scale + 1e-9) / apart
        grid = [[" "] * columns for _ in range(round(height * scale / 2) + 1)]

        def cell(place):
            return round((top - place.y) * scale / 2), round((place.x - left) * scale) + 1

        for cord in cradle.cords():
            (row, column), (end_row, end_column) = cell(cord.pos), cell(cord.pos + cord.axis)
            down, aside = end_row - row, end_column - column
            steps = abs(down) if abs(aside) < 1.5 * abs(down) else abs(aside)  # one stroke a row, or one a column
            stroke = STROKES[round(4 * atan2(-cord.axis.y, cord.axis.x) / pi) % 4]
            for step in range(steps):
                grid[row + round(down * step / steps)][column + round(aside * step / steps)] = stroke

        (bar, first), (_, last) = cell(axles[0]), cell(axles[-1])
        grid[bar][first - 1 : last + 2] = "=" * (last - first + 3)
        for axle in axles:
            grid[bar][cell(axle)[1]] = "+"

        names = [f"({number})" for number in range(1, len(bobs) + 1)]
        there_is_room = len(axles) == 1 or len(names[-1]) <= apart * scale + 1e-9
        for bob, name in zip(bobs, names if there_is_room else "O" * len(bobs), strict=True):
            row, column = cell(bob)
            start = max(0, column - len(name) // 2)
            grid[row][start : start + len(name)] = name
        return ["".join(row)[:columns].rstrip() for row in grid]
