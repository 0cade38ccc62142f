"""Which numbers the graph shows, at which times, and in which colors."""

from itertools import pairwise
from math import cos

import pytest
from rig import Rig
from whole_cradles import GOOD, HEADER

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.files.data_file import EVERY
from support.page.graph import (
    DEGREES,
    ENERGIES,
    ENERGY,
    MOMENTA,
    MOST_DRAWN,
    NOTHING,
    PHASE_SPAN,
    SPANS,
)

ANGLES = "Angles theta"
# Of the bobs, as a page has them
RED = "rgb(255, 0, 0)"
CYAN = "rgb(0, 255, 255)"
BLACK = "rgb(0, 0, 0)"


def test_the_graph_shows_the_energies_of_the_last_seconds(rig):
    """In percent. Its points are always at the same times, so they do not shake."""
    [(span, (seconds, interval)), _] = SPANS.items()
    rig.give("span", span)
    rig.wait(seconds + 1)
    assert span == f"last {seconds:g} s"
    curves = rig.state["curves"]
    drawn = {curve["label"]: curve["color"] for curve in curves["curves"]}
    assert drawn == ENERGIES
    assert curves["names"] == ["t", "kinetic (%)", "potential (%)", "total (%)"]
    times = [row[0] for row in curves["rows"]]
    assert curves["to"] - curves["from"] == pytest.approx(seconds)
    assert times[:-1] == pytest.approx([interval * round(t / interval) for t in times[:-1]])
    for _, kinetic, potential, total in curves["rows"]:
        assert kinetic + potential == pytest.approx(total, abs=1e-5)
        assert total == pytest.approx(100, abs=0.1)


def test_the_time_axis_is_full_with_any_tick(csv, monkeypatch):
    monkeypatch.setattr(Cradle, "dt", 7e-4)
    rig = Rig(csv)
    rig.wait(10.5)
    for span, (_, interval) in SPANS.items():
        rig.give("span", span)
        curves = rig.state["curves"]
        times = [curves["from"], *(row[0] for row in curves["rows"]), rig.time()]
        assert max(after - before for before, after in pairwise(times)) < 2 * interval


@pytest.mark.parametrize(
    ("choice", "x", "y", "curves"),
    [
        (MOMENTA, "t (s)", "momentum (kg m/s)", {"1": RED, "2": CYAN, "sum": BLACK}),
        (ANGLES, "t (s)", "theta (degrees)", {"1": RED, "2": CYAN}),
        ("Velocities omega", "t (s)", "omega (degrees/s)", {"1": RED, "2": CYAN}),
        ("Phase 2", "theta (degrees)", "omega (degrees/s)", {"": CYAN}),
    ],
)
def test_a_graph_is_drawn_in_the_colors_of_the_bobs(rig, choice, x, y, curves):
    rig.save(HEADER + GOOD + GOOD.replace("red", "cyan"))
    rig.give("all_graphs", choice)
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
        ANGLES: [time, *thetas],
        "Velocities omega": [time, *omegas],
        "Phase 2": [thetas[1], omegas[1]],
    }
    assert graph["rows"][-1] == pytest.approx(moments[choice], abs=1e-6)
    # The page draws degrees; the rows, which you can save, have rad
    assert graph["scales"] == [DEGREES if "degrees" in axis else 1 for axis in (x, y)]


def test_the_phase_picture_has_rest_in_its_middle_and_an_end(rig):
    rig.give("all_graphs", "Phase 1")
    rig.wait(PHASE_SPAN[0] + 1)
    graph = rig.state["curves"]
    for first, last, column in (("from", "to", 0), ("bottom", "top", 1)):
        farthest = max(abs(row[column]) for row in graph["rows"])
        assert graph[first] == -graph[last] == pytest.approx(-1.05 * DEGREES * farthest)
    assert len(graph["rows"]) == pytest.approx(PHASE_SPAN[0] / EVERY, abs=2)


def test_a_new_cradle_keeps_the_chosen_graph_if_it_can(rig):
    rig.give("graph", ANGLES)
    rig.save(HEADER + GOOD * (MOST_DRAWN + 3))
    assert rig.state["graph"] == ANGLES
    assert len(rig.state["curves"]["curves"]) == MOST_DRAWN
    rig.give("all_graphs", "Phase 7")
    rig.save(HEADER + GOOD * 2)
    assert rig.state["graph"] == ENERGY


def test_no_graph_sends_nothing_and_a_restart_empties_it(rig):
    rig.give("graph", NOTHING)
    rig.wait(2)
    assert not rig.state["curves"]["curves"]
    assert not rig.state["curves"]["rows"]
    rig.give("graph", ENERGY)
    # It shows what was recorded meanwhile
    assert len(rig.state["curves"]["rows"]) == pytest.approx(2 / EVERY, abs=2)
    rig.give("restart")
    assert len(rig.state["curves"]["rows"]) == 1
