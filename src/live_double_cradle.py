"""The double cradle as the viewer plays with it."""

from src.double_cradle import advance_double_cradle, make_double_newton_cradle
from src.dragging import push_others
from src.live_cradle import LiveCradle
from support.audit import double_kinetic_energy, double_momentum, double_potential_energy
from support.constants import DOUBLE_DT, G, PHI_INIT, R_PARAM, THETA_INIT


class LiveDoubleCradle(LiveCradle):
    """A cradle of double pendula, each with two cords of the length that single ones have, and two bobs."""

    dt = DOUBLE_DT
    reach = 2 * R_PARAM
    angles = {"Angle theta": (0, 180), "Angle phi": (-180, 180)}
    coordinate_keys = ("theta", "phi", "omega", "phi_omega")

    def __init__(self, options):
        """options has elastic, inelastic, e and mass, as support/options.py reads them."""
        super().__init__(advance_double_cradle, options)

    def make(self, csv) -> list:
        """Return the pend_list of a CSV."""
        return make_double_newton_cradle(csv, R_PARAM, THETA_INIT, PHI_INIT)

    def release(self, angles, lifted) -> None:
        """Lift the first pendula to these angles (degrees, outwards), let the others hang, all at rest.

        Where a lower cord that is bent inwards reaches into those that hang, it pushes them aside.
        """
        super().release(angles, lifted)
        for i in reversed(range(min(lifted, len(self.pend_list)))):
            push_others(self.pend_list, i, R_PARAM)

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""
        return double_kinetic_energy(self.pend_list, R_PARAM), double_potential_energy(self.pend_list, R_PARAM, G)

    def velocities(self) -> list[float]:
        """Return for each pendulum the mean velocity of its two bobs to the right (m/s)."""
        return [double_momentum([pend], R_PARAM) / pend["mass"] / 2 for pend in self.pend_list]

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""
        return double_momentum(self.pend_list, R_PARAM)
