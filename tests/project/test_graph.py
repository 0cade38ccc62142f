"""Which numbers the graph shows, at which times, and in which colors."""

from math import cos, degrees

import pytest
from rig import Rig
from whole_cradles import GOOD, HEADER, PERIOD

from support.constants import R_PARAM
from support.page.graph import ENERGIES, ENERGY, MOMENTA, MOST_DRAWN, NOTHING, SWINGS
from support.page.viewer import SAMPLES_A_SWING

ANGLES = "Angles theta"
# Of the bobs, as a page has them
RED = "rgb(255, 0, 0)"
CYAN = "rgb(0, 255, 255)"
BLACK = "rgb(0, 0, 0)"


def test_the_graph_shows_the_energies_of_the_last_swings(rig):
    """In percent."""
    rig.wait((SWINGS + 1) * PERIOD)
    curves = rig.state["curves"]
    drawn = {curve["label"]: curve["color"] for curve in curves["curves"]}
    assert drawn == ENERGIES
    assert curves["to"] - curves["from"] == pytest.approx(SWINGS * PERIOD)
    for _, kinetic, potential, total in curves["rows"]:
        assert kinetic + potential == pytest.approx(total, abs=1e-5)
        assert total == pytest.approx(100, abs=0.1)


@pytest.mark.parametrize("factor", [0.25, 100])
def test_the_time_axis_is_full_and_follows_the_swing(csv, monkeypatch, factor):
    """With other cords, a swing has as many points."""
    monkeypatch.setattr("support.cradle.cradle.R_PARAM", factor * R_PARAM)
    rig = Rig(csv)
    assert rig.cradle.period == pytest.approx(factor**0.5 * PERIOD)
    rig.wait((SWINGS + 0.5) * rig.cradle.period)
    curves = rig.state["curves"]
    times = [row[0] for row in curves["rows"]]
    assert times[0] - curves["from"] < 2 * rig.cradle.period / SAMPLES_A_SWING
    assert times[-1] == pytest.approx(curves["to"])
    assert len(times) == pytest.approx(SWINGS * SAMPLES_A_SWING, rel=0.03)


@pytest.mark.parametrize(
    ("choice", "x", "y", "curves"),
    [
        (MOMENTA, "t (s)", "momentum (kg m/s)", {"1": RED, "2": CYAN, "sum": BLACK}),
        (ANGLES, "t (s)", "theta (degrees)", {"1": RED, "2": CYAN}),
        ("Phase 2", "theta (degrees)", "omega (degrees/s)", {"": CYAN}),
    ],
)
def test_a_graph_is_drawn_in_the_colors_of_the_bobs(rig, choice, x, y, curves):
    rig.save(HEADER + GOOD + GOOD.replace("red", "cyan"))
    rig.give("graph", choice)
    rig.wait(0.5)
    rig.viewer.take_sample()
    rig.wait()
    graph = rig.state["curves"]
    assert graph["x"] == x
    assert graph["y"] == y
    assert {curve["label"]: curve["color"] for curve in graph["curves"]} == curves
    thetas = rig.thetas()
    omegas = rig.values("omega")
    time = rig.viewer.motion.time()
    momenta = [R_PARAM * omega * cos(theta) for theta, omega in zip(thetas, omegas, strict=True)]
    moments = {
        MOMENTA: [time, *momenta, sum(momenta)],  # of bobs of 1 kg, to the right
        ANGLES: [time, *map(degrees, thetas)],
        "Phase 2": [degrees(thetas[1]), degrees(omegas[1])],
    }
    assert graph["rows"][-1] == pytest.approx(moments[choice], abs=1e-6)


def test_the_phase_picture_has_rest_in_its_middle_and_an_end(rig):
    rig.give("graph", "Phase 1")
    rig.wait(PERIOD)
    graph = rig.state["curves"]
    for first, last, column in (("from", "to", 0), ("bottom", "top", 1)):
        farthest = max(abs(row[column]) for row in graph["rows"])
        assert graph[first] == -graph[last] == pytest.approx(-1.05 * farthest)


def test_a_new_cradle_keeps_the_chosen_graph_if_it_can(rig):
    rig.give("graph", ANGLES)
    rig.save(HEADER + GOOD * (MOST_DRAWN + 3))
    assert rig.state["graph"] == ANGLES
    assert len(rig.state["curves"]["curves"]) == MOST_DRAWN
    rig.give("graph", "Phase 7")
    rig.save(HEADER + GOOD * 2)
    assert rig.state["graph"] == ENERGY


def test_no_graph_sends_nothing_and_a_restart_empties_it(rig):
    rig.give("graph", NOTHING)
    rig.wait(PERIOD)
    assert not rig.state["curves"]["curves"]
    assert not rig.state["curves"]["rows"]
    rig.give("graph", ENERGY)
    # It shows what was recorded meanwhile
    assert len(rig.state["curves"]["rows"]) == pytest.approx(SAMPLES_A_SWING, abs=2)
    rig.give("restart")
    assert len(rig.state["curves"]["rows"]) == 1
