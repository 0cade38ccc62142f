"""What the page draws beside the cradle, to show why it moves so: arrows, bars, ghosts and halos."""

from math import hypot, pi, sqrt

from vpython import arrow, box, cylinder, sphere, vector

from support.constants import G, R_PARAM
from support.energy import bob_motions, momentum
from support.pendulum import arm, discard, make_shape

# s: an arrow is as long as its bob's way in a ninth of a small swing
ARROW_TIME = 2 * pi * sqrt(R_PARAM / G) / 9
GREEN, YELLOW = vector(0.0, 0.62, 0.45), vector(1.0, 0.75, 0.0)  # of the arrows, and of the halos
# The height of the largest bar, and its distance from the base, in reaches of the cradle
BAR = 0.2
BELOW = 0.17
# m/s: a slower bob has no arrow; from 2 degrees on, a bob gets as fast
STILL = 0.035 * sqrt(R_PARAM * G)
FLAT = 0.01  # the least part of that height: no shape can have the size 0
SUM = vector(0.5, 0.5, 0.53)  # the color of the bar of the sum
# Of a ghost: its color, and the part of its bob's color in it
PALE = vector(0.55, 0.55, 0.55)
OWN = 0.35


class Marks:
    """The marks of one cradle; the next cradle takes the same shapes."""

    def __init__(self):
        # And the words beside the bars, each with its place (x, y, in m)
        self.has_arrows = False
        self.words = []
        self.shapes: dict[str, list] = {}

    def surround(self, cradle, bottom) -> None:
        """Take a new cradle; its base is at the height bottom (m)."""
        self.cradle, self.height = cradle, BAR * cradle.reach
        # The height of the lower end of a bar that points up
        self.level = bottom - BELOW * cradle.reach - self.height
        speeds = zip(cradle.pend_list, cradle.top_speeds(), strict=True)
        # Momentum (kg m/s)
        self.largest = sum(cradle.whole_mass(pend) * speed for pend, speed in speeds) or 1.0
        self.place_arrows()

    def enough(self, name, count, kind, **attributes) -> list:
        """Return this number of shapes of a kind: those with this name, and more if they are too
        few; hide the rest.
        """
        shapes = self.shapes.setdefault(name, [])
        shapes += [make_shape(kind, **attributes) for _ in range(count - len(shapes))]
        discard(shapes[count:])
        del shapes[count:]
        return shapes

    def place_arrows(self) -> None:
        """Make the arrows, and below each axle a bar in the color of its bob, and one for the sum;
        or hide them all.
        """
        shown, bobs, reach = self.has_arrows, self.cradle.bobs(), self.cradle.reach
        first, *_, last = self.xs = [
            axle.pos.x for axle in (*self.cradle.axles(), self.cradle.axles()[-1])
        ]
        self.xs[-1] += reach / 3  # of the sum
        self.arrows = self.enough(
            "arrows", shown * len(bobs), arrow, color=GREEN, shaftwidth=bobs[0].radius / 3
        )
        self.bars = self.enough("bars", shown * len(self.xs), box)
        for bar, color in zip(self.bars, (*self.cradle.colors(), SUM), strict=False):
            bar.color = color
        texts = {"momentum\n(up = right)": first - reach / 2, "sum": last + 0.6 * reach}
        self.words = [(x, self.level, text) for text, x in texts.items()] if shown else []
        self.depth = shown * (BELOW + 2 * BAR) * reach  # m: so far the bars reach below the base

    def show_arrows(self, pend_list) -> None:
        """Show the velocities and momenta of these pendula; a bar points up if the momentum is to
        the right.
        """
        if not self.has_arrows:
            return
        moves = [(vx, vy) for pend in pend_list for _, vx, vy in bob_motions(pend, R_PARAM)]
        for each, bob, (vx, vy) in zip(self.arrows, self.cradle.bobs(), moves, strict=True):
            if each.visible != (hypot(vx, vy) > STILL):
                each.visible = not each.visible
            if each.visible:
                each.pos = bob.pos + vector(0, 0, bob.radius)
                each.axis = vector(ARROW_TIME * vx, ARROW_TIME * vy, 0)
        momenta = [momentum([pend], R_PARAM) for pend in pend_list]
        momenta.append(sum(momenta))
        # A light bob that bounces back gives more than it had
        self.largest = max(self.largest, *map(abs, momenta))
        for bar, x, p in zip(self.bars, self.xs, momenta, strict=True):
            height = self.height * p / self.largest
            bar.size = vector(R_PARAM / 8, max(abs(height), FLAT * self.height), R_PARAM / 40)
            bar.pos = vector(x, self.level + height / 2, 0)

    def show_ghosts(self, thetas) -> None:
        """Show a pale upper bob and cord at each of these angles (rad), or none for an empty list."""
        ghosts = self.enough("ghosts", len(thetas), sphere, shininess=0)
        threads = self.enough("threads", len(thetas), cylinder)
        for ghost, thread, pend, theta in zip(
            ghosts, threads, self.cradle.pend_list, thetas, strict=False
        ):
            axle, bob, cord = pend["objects"][:3]
            axis = arm(theta, R_PARAM)
            # Inside of bob and cord, where these are as predicted.
            ghost.pos = axle.pos + axis
            ghost.radius = 0.97 * bob.radius
            ghost.color = PALE + OWN * bob.color
            thread.pos = axle.pos
            thread.axis = axis
            thread.radius = 0.9 * cord.radius
            thread.color = ghost.color

    def show_halos(self, pair) -> None:
        """Light up these pendula (indices), or none."""
        lit = [bob for number in pair for bob in self.cradle.pend_list[number]["objects"][1::2]]
        for halo, bob in zip(
            self.enough("halos", len(lit), cylinder, color=YELLOW), lit, strict=True
        ):
            halo.pos, halo.axis = bob.pos - vector(0, 0, bob.radius), vector(0, 0, bob.radius / 20)
            halo.radius = 1.3 * bob.radius
