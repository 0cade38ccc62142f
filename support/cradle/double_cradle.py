"""The double cradle of a program."""

from math import inf

from vpython import dot, mag, vector

from support.constants import DOUBLE_DT, R_PARAM
from support.cradle.cradle import Cradle
from support.energy import bob_motions
from support.pendulum import Pendulum


class DoubleCradle(Cradle):
    """A cradle of double pendula, each with two bobs and two cords of length R_PARAM."""

    title = "Newton's double cradle"
    kind = "double"
    theta_bob = "upper bob"
    dt = DOUBLE_DT
    cord_count = 2
    angle_limits = {"angle_theta": (0, 180), "angle_phi": (-180, 180)}
    angle_keys = ("theta", "phi")
    rate_keys = ("omega", "phi_omega")
    make_name = "make_double_newton_cradle"
    tick_name = "double_cradle_tick"
    # The second one lets only the upper bobs collide.
    collide_names = ("handle_two_double_bobs", "handle_two_bobs")

    def approach(self, left: Pendulum, right: Pendulum) -> float:
        """Return the speed (m/s) at which the nearest two bobs of two pendula approach."""
        nearest, speed = inf, 0.0
        for bob1, motion1 in zip(left["objects"][1::2], bob_motions(left, R_PARAM), strict=True):
            for bob2, motion2 in zip(
                right["objects"][1::2], bob_motions(right, R_PARAM), strict=True
            ):
                apart = bob2.pos - bob1.pos
                distance = mag(apart)
                if distance < nearest:
                    closer = vector(motion1.vx - motion2.vx, motion1.vy - motion2.vy, 0)
                    # A bob in the other's place approaches nothing.
                    nearest, speed = distance, dot(closer, apart) / (distance or 1.0)
        return speed
