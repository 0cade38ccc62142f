"""Draw the cradle with plain ASCII characters, which are twice as high as wide."""

from math import atan2, pi

from support.playback.cradle import Cradle

CORD = 16  # length of a cord in columns if there is room; neighbouring bobs are then four columns apart
STROKES = "-\\|/"  # a line to the right, and lines turned down from it by 45, 90 and 135 degrees


class TextPicture:
    """Draws a cradle, always with the same part of space in view."""

    def __init__(self):
        """Show the space below the axles; once a bob has been above them, show the space up to there, too."""
        self.above = 0.0  # m

    def lines(self, cradle: Cradle, columns, rows) -> list[str]:
        """Return the lines of a picture, at most `columns` wide and `rows` high; no line if there is no room."""
        axles, bobs = [axle.pos for axle in cradle.axles()], [bob.pos for bob in cradle.bobs()]
        xs, ys = sorted(axle.x for axle in axles), sorted(axle.y for axle in axles)
        self.above = max(self.above, *(bob.y - ys[-1] for bob in bobs))
        left, width = xs[0] - cradle.reach, xs[-1] - xs[0] + 2 * cradle.reach
        top, height = ys[-1] + self.above, ys[-1] - ys[0] + cradle.reach + self.above
        # Columns per metre. Three columns and a row stay free for rounding, and for the brackets of a bob.
        scale = min(CORD / cradle.reach, (columns - 3) / width, 2 * (rows - 1) / height)
        if scale <= 0:
            return []
        apart = (xs[-1] - xs[0]) / max(1, len(axles) - 1)
        if apart * scale >= 1:  # whole columns from bob to bob: unequal gaps look like groups of bobs
            scale = int(apart * scale + 1e-9) / apart
        grid = [[" "] * columns for _ in range(round(height * scale / 2) + 1)]

        def cell(place):
            return round((top - place.y) * scale / 2), round((place.x - left) * scale) + 1

        for cord in cradle.cords():
            (row, column), (end_row, end_column) = cell(cord.pos), cell(cord.pos + cord.axis)
            down, aside = end_row - row, end_column - column
            steps = abs(down) if abs(aside) < 1.5 * abs(down) else abs(aside)  # one stroke per row, or per column
            stroke = STROKES[round(4 * atan2(-cord.axis.y, cord.axis.x) / pi) % 4]
            for step in range(steps):
                grid[row + round(down * step / steps)][column + round(aside * step / steps)] = stroke

        places = sorted(map(cell, axles), key=lambda place: place[1])
        bar, first, last = places[0][0], places[0][1], places[-1][1]
        grid[bar][first - 1 : last + 2] = "=" * (last - first + 3)
        for row, column in places:
            grid[row][column] = "+"

        names = [f"({number})" for number in range(1, len(bobs) + 1)]
        there_is_room = len(axles) == 1 or len(names[-1]) <= apart * scale + 1e-9
        for bob, name in zip(bobs, names if there_is_room else "O" * len(bobs), strict=True):
            row, column = cell(bob)
            start = max(0, column - len(name) // 2)
            grid[row][start : start + len(name)] = name
        return ["".join(row)[:columns].rstrip() for row in grid]
