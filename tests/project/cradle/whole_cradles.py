"""More cradles for the project's tests: CSV text, double pendula made by hand, and live cradles."""

from contextlib import suppress
from itertools import accumulate, combinations
from math import cos, pi, sin, sqrt
from types import SimpleNamespace
from unittest.mock import patch

import pytest
from vpython import color, mag, vector

from grading.cradles import hang, R
from src import visualize_cradle_run
from src.double_cradle import make_double_pendulum
from support.constants import DT, G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.hits import Hit, Hits
from support.cradle.many_ticks import is_shipped, many_ticks
from support.cradle.player import Player, run_once
from support.cradle.settings import Settings
from support.energy import energies
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import CradleCsv, read_cradle, with_numbers
from support.pendulum import contact_distance, outwards_to_angle
from support.root import SRC

# Of each kind of cradle
PROGRAMS = {
    "single": SRC / "visualize_cradle_run.py",
    "double": SRC / "visualize_double_cradle_run.py",
}
# s, for small swings; it uses the constants, so the tests wait long enough if someone edits them.
PERIOD = 2 * pi * sqrt(R_PARAM / G)

# Five equal elastic pendula, as in the shipped file.
HEADER = "mass,e,theta,omega,color,texture\n"
GOOD = "1.0,1.0,0.0,0.0,red,metal\n"
FIVE_CSV = HEADER + GOOD * 5


def hang_double(
    theta=0.0, phi=0.0, omega=0.0, phi_omega=0.0, mass=1.0, e=1.0, axle=(0, 0), r_param=R_PARAM
) -> dict:
    """Return a double pendulum that hangs from axle (x, y in m)."""
    return {
        "theta": theta,
        "phi": phi,
        "omega": omega,
        "phi_omega": phi_omega,
        "mass": mass,
        "e": e,
        "objects": make_double_pendulum(vector(*axle, 0), r_param, theta, phi, color.white, None),
    }


def along(pend, keys) -> list[float]:
    """Return the sums of a pendulum's values of these keys, the upper cord's and the lower cord's.

    With one cord, there is only the first.
    """
    return list(accumulate(pend[key] for key in keys if key in pend))


def check_places(pend, axle, r_param=R_PARAM) -> None:
    """Check that the cords and bobs of a pendulum hang from axle (x, y in m) at its angles."""
    box, *parts = pend["objects"]
    end = vector(*axle, 0)
    assert box.pos.value == pytest.approx(end.value)
    angles = along(pend, ["theta", "phi"])
    for angle, bob, cord in zip(angles, parts[::2], parts[1::2], strict=True):
        arm = r_param * vector(sin(angle), -cos(angle), 0)
        assert cord.pos.value == pytest.approx(end.value)
        assert cord.axis.value == pytest.approx(arm.value)
        end = end + arm
        assert bob.pos.value == pytest.approx(end.value)


def velocities(pend) -> list:
    """Return the velocities (m/s) of a pendulum's bobs as vectors, the upper one first."""
    found = []
    velocity = vector(0, 0, 0)
    angles, rates = along(pend, ["theta", "phi"]), along(pend, ["omega", "phi_omega"])
    for angle, rate in zip(angles, rates, strict=True):
        velocity = velocity + R_PARAM * rate * vector(cos(angle), sin(angle), 0)
        found.append(velocity)
    return found


def energy(pend_list) -> float:
    """Return the total energy (J)."""
    return sum(energies(pend_list, R_PARAM, G))


def distances(pend_list) -> list[float]:
    """Return the distances of all pairs of bobs of different pendula; at 1, they touch."""
    bobs_of_pends = [pend["objects"][1::2] for pend in pend_list]
    found = []
    for bobs1, bobs2 in combinations(bobs_of_pends, 2):
        for bob1 in bobs1:
            for bob2 in bobs2:
                contact = contact_distance(bob1.radius, bob2.radius)
                found.append(mag(bob2.pos - bob1.pos) / contact)
    return found


def let_bobs_touch(cradle):
    """Let all bobs touch, and the first one move; return the function of the program for a hit."""
    for bob in cradle.bobs():
        bob.radius *= 1.01
    cradle.pend_list[0]["omega"] = 2.0
    return cradle.tick_names["handle_two_bobs"]


class FrameError(Exception):
    """The player begins its next frame."""


def go_on(player) -> None:
    """Run the program of the cradle, or go on in its loop, until the player would begin a frame."""
    cradle = player.cradle
    with patch.object(player, "frame", side_effect=FrameError), suppress(FrameError):
        if player.next_cradle.is_wanted:
            player.begin()
            run_once(PROGRAMS[cradle.kind], player)
        while player.is_running(cradle.pend_list):
            cradle.tick_function(cradle.pend_list, R_PARAM, cradle.dt, G)


def thetas(release_angles) -> list:
    """Return theta (rad) for each release angle (degrees); None stays None."""
    return [None if angle is None else outwards_to_angle(angle) for angle in release_angles]


def checked(filepath) -> CradleCsv:
    """Return the CSV in this file, checked."""
    return read_cradle(Snapshot(filepath))


def settings_for(file, angles=(None,), lifted=None, **numbers) -> Settings:
    """Return the settings of a CSV's cradle, released from these angles (rad).

    numbers take the place of those in the columns with these names.
    """
    csv = with_numbers(checked(file), numbers)
    return Settings(csv, [*angles], lifted)


class Swing(Player):
    """A player that does as many ticks as a test says."""

    def __init__(self, cradle, settings):
        super().__init__(cradle, settings, 1e9)
        go_on(self)

    def swing(self, ticks):
        self.plan(ticks)
        go_on(self)

    def read(self, text):
        """Make the cradle of this text, the new content of the CSV."""
        filepath = self.next_cradle.settings.csv.filepath
        filepath.write_text(text)
        self.next_cradle.want(csv=checked(filepath))
        go_on(self)


def make_swing(folder, csv=FIVE_CSV, angle=30, lift=1, kind=Cradle, phi=20, **numbers) -> Swing:
    """Write this CSV to the folder; return a player of its cradle with these numbers.

    It is released from angle and phi (degrees).
    """
    angles = thetas([angle, phi][: kind.cord_count])
    path = folder / "cradle.csv"
    path.write_text(csv)
    return Swing(kind(), settings_for(path, angles, lift, **numbers))


def make_row(count, theta=0.0, **values) -> list[dict]:
    """Return pendula with these values for hang, the first one at theta (rad), the others at 0."""
    row = [hang(axle=(i * R_PARAM / 4, 0, 0), r_param=R_PARAM, **values) for i in range(count)]
    row[0]["theta"] = theta
    return row


def do_ticks(
    pend_list, at_once, r_param=R, dt=1e-4, g=9.81, ticks=1000, separating=False
) -> list[Hit]:
    """Do `ticks` ticks with the functions of src/; return the hits.

    at_once is whether the fast path does them; else newton_cradle_tick does.
    """
    cradle = Cradle()
    cradle.find_functions(vars(visualize_cradle_run))
    cradle.pend_list = pend_list
    settings = SimpleNamespace(separating=separating)
    hits = Hits(cradle, SimpleNamespace(settings=settings))
    hits.listen()
    try:
        if at_once:
            many_ticks(cradle, hits, ticks, {"R_PARAM": r_param, "DT": dt, "G": g})
        else:
            for tick in range(1, ticks + 1):
                hits.tick = tick
                visualize_cradle_run.newton_cradle_tick(pend_list, r_param, dt, g)
    finally:
        hits.stop()
    return hits.noted


def hits_in(pend_list, seconds, dt=DT) -> list[Hit]:
    """Advance the cradle as the programs do, in ticks of dt (s); return its hits."""
    at_once = is_shipped(vars(visualize_cradle_run))
    return do_ticks(pend_list, at_once, R_PARAM, dt, G, round(seconds / dt))


def advance(pend_list, seconds, dt=DT) -> list[float]:
    """Advance the cradle in the same way; return its thetas (rad)."""
    hits_in(pend_list, seconds, dt)
    return [pend["theta"] for pend in pend_list]
