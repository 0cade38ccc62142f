"""More cradles for the project's tests: CSV text, double pendula made by hand, and cradles that
run.
"""

from bisect import bisect_left
from contextlib import ExitStack, suppress
from itertools import accumulate, combinations
from math import cos, degrees, dist, pi, sin, sqrt
from statistics import fmean
from types import SimpleNamespace
from unittest.mock import patch

import pytest
from vpython import color, mag, vector

from grading.cradles import hang, R
from src import special_cradles, visualize_cradle_run, visualize_double_cradle_run
from src.double_cradle import make_double_pendulum
from support.constants import DT, G, PHI_INIT, R_PARAM, THETA_INIT
from support.cradle.cradle import Cradle
from support.cradle.many_ticks import many_ticks
from support.cradle.player import Player
from support.energy import energies
from support.files.cradle_csv import Snapshot
from support.pendulum import BUFFER, outwards_to_angle

# s, for small swings; it uses the constants, so the tests wait long enough if someone edits them.
PERIOD = 2 * pi * sqrt(R_PARAM / G)

# S between two looks at a cradle; parts of a step in which an exact cradle looks for a hit
SAMPLE = 0.01
FINE = 10**12

# Five equal elastic pendula, as in the shipped file.
HEADER, GOOD = "mass,e,theta,omega,color,texture\n", "1.0,1.0,0.0,0.0,red,metal\n"
FIVE_CSV = HEADER + GOOD * 5


def hang_double(
    theta=0.0, phi=0.0, omega=0.0, phi_omega=0.0, mass=1.0, e=1.0, axle=(0, 0), r_param=R_PARAM
) -> dict:
    """Return a double pendulum that hangs from axle (x, y in m)."""
    objects = make_double_pendulum(vector(*axle, 0), r_param, theta, phi, color.white, None)
    angles = {"theta": theta, "phi": phi, "omega": omega, "phi_omega": phi_omega}
    return {**angles, "mass": mass, "e": e, "color": "white", "texture": "none", "objects": objects}


def along(pend, keys) -> list[float]:
    """Return the sums of a pendulum's values of these keys (upper cord, lower cord), with one cord
    only the first.
    """
    return list(accumulate(pend[key] for key in keys if key in pend))


def check_places(pend, axle, r_param=R_PARAM) -> None:
    """Check that the cords and bobs of a pendulum hang from axle (x, y in m) at its angles."""
    end, (box, *parts) = vector(*axle, 0), pend["objects"]
    found, expected = [box.pos], [end]
    for angle, bob, cord in zip(
        along(pend, ("theta", "phi")), parts[::2], parts[1::2], strict=True
    ):
        arm = r_param * vector(sin(angle), -cos(angle), 0)
        found += [cord.pos, cord.axis, bob.pos]
        expected += [end, arm, end + arm]
        end = end + arm
    assert [v.value for v in found] == [pytest.approx(v.value) for v in expected]


def velocities(pend) -> list:
    """Return the velocities (m/s) of a pendulum's bobs as vectors, the upper one first."""
    turns = zip(along(pend, ("theta", "phi")), along(pend, ("omega", "phi_omega")), strict=True)
    return [
        *accumulate(R_PARAM * rate * vector(cos(angle), sin(angle), 0) for angle, rate in turns)
    ]


def energy(pend_list) -> float:
    """Return the total energy (J)."""
    return sum(energies(pend_list, R_PARAM, G))


def distances(pend_list) -> list[float]:
    """Return the distances of all pairs of bobs of different pendula; at 1, they touch."""
    return [
        mag(bob2.pos - bob1.pos) / (BUFFER * (bob1.radius + bob2.radius))
        for pend1, pend2 in combinations(pend_list, 2)
        for bob1 in pend1["objects"][1::2]
        for bob2 in pend2["objects"][1::2]
    ]


def make_live(kind=Cradle, **options) -> Cradle:
    """Return a cradle with these options, without pendula."""
    none = {"elastic": False, "inelastic": False, "e": None, "mass": None}
    given = SimpleNamespace(**{**none, **options})
    if kind is Cradle:
        return Cradle(visualize_cradle_run.main, special_cradles, given, many_ticks)
    return kind(visualize_double_cradle_run.main, special_cradles, given)


class FrameError(Exception):
    """The player begins its next frame."""


def go_on(player) -> None:
    """Do what run and main do, until the player has nothing more for them to do, and would begin a
    frame.
    """
    cradle, scope = player.cradle, player.cradle.scope
    player.loop, starts = scope["main"], [THETA_INIT, PHI_INIT][: len(cradle.angles)]
    with ExitStack() as stack:
        stack.enter_context(patch.object(player, "frame", side_effect=FrameError))
        stack.enter_context(suppress(FrameError))
        stack.callback(cradle.hits.stop)
        if player.is_wanted:
            player.begin()
            player.show(scope[cradle.make_name](player.csv, R_PARAM, *starts))
        while player.is_running():
            scope[cradle.tick_name](cradle.pend_list, R_PARAM, cradle.dt, G, **player.rule)


def thetas(lifts) -> list:
    """Return theta (rad) for each lift (degrees); None stays None."""
    return [None if lift is None else outwards_to_angle(lift) for lift in lifts]


class Swing(Player):
    """A player with the number of ticks that a test sets."""

    def swing(self, ticks):
        self.plan(ticks)
        go_on(self)

    def read(self, text):
        """Make the cradle of this text, the new content of the CSV."""
        self.snapshot.filepath.write_text(text)
        self.snapshot = Snapshot(self.snapshot.filepath)
        self.want_cradle()
        go_on(self)


def make_swing(
    folder, csv=FIVE_CSV, angle=30, lift=1, impacts=4, kind=Cradle, phi=20, **options
) -> Swing:
    """Write this CSV to the folder; return its cradle with these options, released from angle and
    phi (degrees).
    """
    angles = thetas([angle, phi][: len(kind.angles)])
    player = Swing(
        make_live(kind, **options), Snapshot(folder / "cradle.csv"), angles, lift, impacts, 1e9
    )
    player.read(csv)
    return player


def do_at_once(pend_list, r_param=R, dt=1e-4, g=9.81, ticks=1000, approaching_only=False):
    """Call many_ticks with the shipped functions and these constants; return the contacts, or None."""
    scope = {**vars(visualize_cradle_run), "R_PARAM": r_param, "DT": dt, "G": g}
    return many_ticks(
        scope, pend_list, ticks, {"approaching_only": True} if approaching_only else {}
    )


def make_row(count, theta=0.0, **values) -> list[dict]:
    """Return pendula with these values (as for hang), the first one at theta (rad), the others
    hanging.
    """
    row = [hang(axle=(i * R_PARAM / 4, 0, 0), r_param=R_PARAM, **values) for i in range(count)]
    row[0]["theta"] = theta
    return row


def do_one_by_one(
    pend_list, r_param=R, dt=1e-4, g=9.81, ticks=1000, approaching_only=False
) -> list[tuple]:
    """Call newton_cradle_tick `ticks` times; return the contacts as many_ticks does."""
    contacts, original = [], visualize_cradle_run.handle_two_bobs

    def handle_two_bobs(pend1, pend2, r_param, **rule):
        before = pend1["omega"], pend2["omega"]
        velocities = [pend["omega"] * cos(pend["theta"]) for pend in (pend1, pend2)]
        original(pend1, pend2, r_param, **rule)
        if (pend1["omega"], pend2["omega"]) != before:
            left = next(i for i, pend in enumerate(pend_list) if pend is pend1)
            contacts.append(
                (
                    tick,
                    left,
                    left + 1,
                    sum(velocities) > 0,
                    (velocities[0] - velocities[1]) * r_param,
                )
            )

    with patch.object(visualize_cradle_run, "handle_two_bobs", handle_two_bobs):
        for tick in range(ticks):  # noqa: B007  for the contacts
            visualize_cradle_run.newton_cradle_tick(pend_list, r_param, dt, g, approaching_only)
    return contacts


def advance(pend_list, seconds, dt=DT) -> list[float]:
    """Advance the cradle by the programs' rule, in single ticks of dt (s); return its thetas (rad)."""
    for _ in range(round(seconds / dt)):
        visualize_cradle_run.newton_cradle_tick(pend_list, R_PARAM, dt, G, approaching_only=True)
    return [pend["theta"] for pend in pend_list]


def contacts_in(pend_list, seconds) -> list[tuple]:
    """Advance the cradle in the same way; return its contacts."""
    return do_one_by_one(pend_list, R_PARAM, DT, G, round(seconds / DT), approaching_only=True)


class ExactCradle:
    """Five equal elastic pendula with the programs' gaps, by Runge-Kutta steps of the fourth order;
    hits any time.
    """

    def __init__(self):
        # In cord lengths
        self.reach = 2 * BUFFER * hang(r_param=R_PARAM)["objects"][1].radius / R_PARAM
        # theta (rad) and omega (rad/s)
        self.states = [(theta, 0.0) for theta in (THETA_INIT, 0.0, 0.0, 0.0, 0.0)]

    def after(self, i, dt) -> tuple[float, float]:
        """Return the state of pendulum i after dt (s) without a hit (https://dlmf.nist.gov/3.7.v)."""
        (theta, omega), k = self.states[i], G / R_PARAM
        turn1, pull1 = omega, -k * sin(theta)
        turn2, pull2 = omega + dt / 2 * pull1, -k * sin(theta + dt / 2 * turn1)
        turn3, pull3 = omega + dt / 2 * pull2, -k * sin(theta + dt / 2 * turn2)
        turn4, pull4 = omega + dt * pull3, -k * sin(theta + dt * turn3)
        turn, pull = turn1 + 2 * turn2 + 2 * turn3 + turn4, pull1 + 2 * pull2 + 2 * pull3 + pull4
        return theta + dt / 6 * turn, omega + dt / 6 * pull

    def hit(self, left, dt) -> bool:
        """Return whether this bob and the next one touch and approach each other after dt (s)
        without a hit.
        """
        (theta1, omega1), (theta2, omega2) = self.after(left, dt), self.after(left + 1, dt)
        distance = dist((sin(theta1), cos(theta1)), (1 / 4 + sin(theta2), cos(theta2)))
        return distance <= self.reach and omega1 * cos(theta1) > omega2 * cos(theta2)

    def instant(self, left, dt) -> float:
        """Return after how many seconds, at most dt, this bob and the next one hit each other."""
        return (
            bisect_left(range(FINE), True, key=lambda part: self.hit(left, part / FINE * dt))
            / FINE
            * dt
        )

    def advance(self, seconds, dt=0.001) -> list[float]:
        """Advance the cradle, in steps of dt (s) or up to a hit; return the thetas (rad)."""
        while seconds > 1e-12:
            step, struck = min(dt, seconds), None
            for left in range(4):
                if self.hit(left, step):
                    step, struck = self.instant(left, step), left
            self.states = [self.after(i, step) for i in range(5)]
            seconds -= step
            if struck is not None:  # equal elastic bobs exchange their velocities
                (theta1, omega1), (theta2, omega2) = self.states[struck : struck + 2]
                self.states[struck : struck + 2] = (theta1, omega2), (theta2, omega1)
        return [theta for theta, _ in self.states]


def outer_angles(advance, seconds) -> list[float]:
    """Return theta (degrees) of the first and the last pendulum at each SAMPLE; advance(SAMPLE)
    returns all thetas.
    """
    thetas = (advance(SAMPLE) for _ in range(round(seconds / SAMPLE)))
    return [degrees(theta) for first, *_, last in thetas for theta in (first, last)]


def apart(angles1, angles2) -> float:
    """Return the root of the mean square of the differences."""
    return sqrt(fmean((one - other) ** 2 for one, other in zip(angles1, angles2, strict=True)))
