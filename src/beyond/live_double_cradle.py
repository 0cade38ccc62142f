"""The double cradle of the programs."""

from inspect import isfunction
from typing import Any

from src.beyond.dragging import push_others
from src.beyond.live_cradle import LiveCradle
from support.constants import DOUBLE_DT, G, R_PARAM
from support.energy import double_kinetic_energy, double_momentum, double_potential_energy


class LiveDoubleCradle(LiveCradle):
    """A cradle of double pendula, each with two bobs and two cords of length R_PARAM."""

    title = "Newton's double cradle"
    kind = "double"
    dt = DOUBLE_DT
    reach = 2 * R_PARAM
    angles = {"Angle theta": (0, 180), "Angle phi": (-180, 180)}
    angle_keys = ("theta", "phi")
    rate_keys = ("omega", "phi_omega")
    tick_name = "DOUBLE_DT"
    maker, ticker, meeter = "make_double_newton_cradle", "double_cradle_tick", "handle_two_double_bobs"
    collider = meeter

    def make_room(self, lifted) -> None:
        """Push pendula out of the way of the lifted ones: a lower cord that is bent inwards reaches far."""
        for i in reversed(range(min(lifted, len(self.pend_list)))):
            push_others(self.pend_list, i, R_PARAM)

    def swings_through(self) -> bool:
        """Return whether a bob swings through others: never, because any two bobs can collide."""
        return False

    def meeting_place(self) -> dict[str, Any]:
        """Return the globals with the function that lets two pendula hit: the tick's, or those of a function there."""
        place = self.scope[self.ticker].__globals__
        places = [place, *(function.__globals__ for function in place.values() if isfunction(function))]
        return next((place for place in places if self.meeter in place), place)

    def velocity(self, pend, rates) -> float:
        """Return the mean velocity of a pendulum's two bobs to the right (m/s) at these rates (rad/s)."""
        before = {**pend, **dict(zip(self.rate_keys, rates, strict=True))}
        return double_momentum([before], R_PARAM) / pend["mass"] / 2

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""
        return double_kinetic_energy(self.pend_list, R_PARAM), double_potential_energy(self.pend_list, R_PARAM, G)

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""
        return double_momentum(self.pend_list, R_PARAM)
