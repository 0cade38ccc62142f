"""The double cradle of the programs."""

from vpython import dot, mag, vector

from support.constants import DOUBLE_DT, R_PARAM
from support.cradle.cradle import Cradle
from support.energy import bob_motions


class DoubleCradle(Cradle):
    """A cradle of double pendula, each with two bobs and two cords of length R_PARAM."""

    title = "Newton's double cradle"
    kind = "double"
    dt = DOUBLE_DT
    reach = 2 * R_PARAM
    angles = {"Angle theta": (0, 180), "Angle phi": (-180, 180)}
    angle_keys = ("theta", "phi")
    rate_keys = ("omega", "phi_omega")
    make_name, tick_name, dt_name = "make_double_newton_cradle", "double_cradle_tick", "DOUBLE_DT"
    collide_name = shown_name = "handle_two_double_bobs"

    def approach(self, left, right) -> float:
        """Return the speed (m/s) at which the nearest two bobs of two pendula approach each other."""
        moves = [
            (bob2.pos - bob1.pos, vector(vx1 - vx2, vy1 - vy2, 0))
            for bob1, (_, vx1, vy1) in zip(left["objects"][1::2], bob_motions(left, R_PARAM), strict=True)
            for bob2, (_, vx2, vy2) in zip(right["objects"][1::2], bob_motions(right, R_PARAM), strict=True)
        ]
        apart, closer = min(moves, key=lambda move: mag(move[0]))
        return dot(closer, apart) / (mag(apart) or 1.0)  # 0, if one is in the other's place
