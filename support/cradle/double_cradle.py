"""The double cradle of a program."""

from support.constants import DOUBLE_DT
from support.cradle.cradle import Cradle


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
