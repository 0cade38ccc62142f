"""More cradles for the project's tests: CSV text, double pendula made by hand, and cradles that run."""

from itertools import combinations
from math import pi, sqrt
from types import SimpleNamespace

from vpython import color, mag, vector

from grading.cradles import R
from src import visualize_cradle_run, visualize_double_cradle_run
from src.beyond.live_cradle import LiveCradle
from src.beyond.live_double_cradle import LiveDoubleCradle
from src.beyond.many_ticks import many_ticks
from src.double_cradle import make_double_pendulum
from support.constants import BUFFER, G, PHI_INIT, R_PARAM, THETA_INIT
from support.files.cradle_csv import Snapshot
from support.pendulum import from_lift
from support.playback.player import Player

MAINS = {LiveCradle: visualize_cradle_run.main, LiveDoubleCradle: visualize_double_cradle_run.main}

# s, for small swings; it uses the constants, so the tests wait long enough if someone edits them.
PERIOD = 2 * pi * sqrt(R_PARAM / G)

# Five equal elastic pendula, as in the shipped file.
HEADER, GOOD = "mass,e,theta,omega,color,texture\n", "1.0,1.0,0.0,0.0,red,metal\n"
FIVE_CSV = HEADER + GOOD * 5


def hang_double(theta=0.0, phi=0.0, omega=0.0, phi_omega=0.0, mass=1.0, e=1.0, axle=(0, 0), r_param=R_PARAM) -> dict:
    """Return a double pendulum that hangs from axle (x, y in m)."""
    objects = make_double_pendulum(vector(*axle, 0), r_param, theta, phi, color.white, None)
    angles = {"theta": theta, "phi": phi, "omega": omega, "phi_omega": phi_omega}
    return {**angles, "mass": mass, "e": e, "color": "white", "texture": "none", "objects": objects}


def distances(pend_list) -> list[float]:
    """Return the distances of all pairs of bobs of different pendula; at 1, they touch."""
    return [
        mag(bob2.pos - bob1.pos) / (BUFFER * (bob1.radius + bob2.radius))
        for pend1, pend2 in combinations(pend_list, 2)
        for bob1 in pend1["objects"][1::2]
        for bob2 in pend2["objects"][1::2]
    ]


def make_live(kind=LiveCradle, **options) -> LiveCradle:
    """Return a cradle with these options, without pendula."""
    main, none = MAINS[kind], {"elastic": False, "inelastic": False, "e": None, "mass": None}
    many = many_ticks if kind is LiveCradle else None
    return kind(main.__globals__, SimpleNamespace(**{**none, **options}), many)


def go_on(player, script) -> None:
    """Run the loop of main until this part of the player's script ends."""
    scope = player.cradle.scope
    for _ in script:
        if player.wants_cradle():
            if isinstance(player.cradle, LiveDoubleCradle):
                player.show(scope["make_double_newton_cradle"](player.csv, R_PARAM, THETA_INIT, PHI_INIT))
            else:
                player.show(scope["make_newton_cradle"](player.csv, R_PARAM, THETA_INIT))
        while player.wants_tick():
            scope[player.cradle.ticker](player.cradle.pend_list, R_PARAM, player.cradle.dt, G, **player.rule)


def thetas(lifts) -> list:
    """Return theta (rad) for each lift (degrees); None stays None."""
    return [None if lift is None else from_lift(lift) for lift in lifts]


class Swing(Player):
    """A player with the number of ticks that a test sets."""

    def __init__(self, csv, angles, lifted, impacts=4, kind=LiveCradle, **options):
        """Make the cradle of this CSV (a Snapshot) with these options, and release it from angles (degrees)."""
        super().__init__(make_live(kind, **options), csv, thetas(angles), lifted, impacts)
        go_on(self, self.make())

    def script(self):
        return iter(())

    def swing(self, ticks):
        """Do `ticks` ticks, and return the hits."""
        go_on(self, self.advance(ticks))

    def read(self, csv):
        """Make the cradle of this CSV (a Snapshot)."""
        self.snapshot = csv
        go_on(self, self.make())


def make_swing(folder, csv=FIVE_CSV, angle=30, lift=1, impacts=4) -> Swing:
    """Write this CSV to the folder; return its cradle, released from this angle (degrees)."""
    file = folder / "cradle.csv"
    file.write_text(csv)
    return Swing(Snapshot(file), [angle], lift, impacts)


def do_at_once(pend_list, r_param=R, dt=1e-4, g=9.81, ticks=1000, approaching_only=False):
    """Call many_ticks with the shipped functions and these constants; return the contacts, or None."""
    scope = {**vars(visualize_cradle_run), "R_PARAM": r_param, "DT": dt, "G": g}
    return many_ticks(scope, pend_list, ticks, {"approaching_only": True} if approaching_only else {})


def components(v) -> tuple[float, float, float]:
    """Return the components of a vector, for pytest.approx."""
    return v.x, v.y, v.z
