"""Which curves the graph shows, at which times, and in which colors."""

from math import degrees

import pytest
from rig import Rig
from whole_cradles import GOOD, HEADER, PERIOD

from support.constants import R_PARAM
from support.cradle.double_cradle import DoubleCradle
from support.page.graph import ENERGIES, MOST_DRAWN, SUM, SWINGS
from support.page.viewer import SAMPLES_A_SWING

# Red; and yellow, half as light: one could hardly see it.
BOBS = {1: "rgb(255, 0, 0)", 2: "rgb(128, 128, 0)"}


def test_each_graph_has_its_axes_its_colors_and_its_numbers(csv):
    """The last point of the last curve: of the sum, or of the second pendulum."""
    csv.write_text(HEADER + GOOD + GOOD.replace("red", "yellow"))
    rig = Rig(csv, 30, 20, kind=DoubleCradle)
    rig.wait(0.7 * PERIOD)  # until all bobs move
    rig.viewer.take_sample()
    t = rig.viewer.motion.time()
    p = rig.viewer.motion.sample()["momentum"]
    second = rig.cradle.pend_list[1]
    phi, rate = degrees(second["phi"]), degrees(second["phi_omega"])
    expected = {
        "Momenta": ("horizontal momentum (kg m/s) over t (s)", (t, p), BOBS | {"sum": SUM}),
        "Energies": ("energy (%) over t (s)", (t, 100), ENERGIES),
        "Angles phi": ("phi (degrees) over t (s)", (t, phi), BOBS),
        "Velocities phi_omega": ("phi_omega (degrees/s) over t (s)", (t, rate), BOBS),
        "Phase phi": ("phi_omega (degrees/s) over phi (degrees)", (phi, rate), BOBS),
    }
    choices = rig.control("graph")["choices"]
    assert rig.state["graph"] == choices[0] == "Momenta"
    assert choices[2:5] == ["Angles theta", "Velocities omega", "Phase theta"]
    assert [*choices[:2], *choices[5:]] == [*expected]
    for name, (axes, point, colors) in expected.items():
        rig.give("graph", name)
        graph = rig.state["curves"]
        assert graph["axes"] == axes
        assert {label: color for label, _, _, color in graph["curves"]} == colors
        last = [graph["columns"][name][-1] for name in graph["curves"][-1][1:3]]
        assert last == pytest.approx(point, abs=0.01)
        assert graph.get("bottom") == (0 if name == "Energies" else None)


def test_a_graph_shows_the_last_swings_whatever_the_cord(csv, monkeypatch):
    """With as many points in a swing. Energies are recorded while another graph is shown."""
    monkeypatch.setattr("support.cradle.cradle.R_PARAM", R_PARAM / 4)
    rig = Rig(csv)
    span = SWINGS * PERIOD / 2
    assert rig.state["curves"]["to"] == pytest.approx(span)
    rig.wait(1.2 * span)
    rig.give("graph", "Energies")
    graph = rig.state["curves"]
    times = graph["columns"]["t"]
    assert [times[0], times[-1]] == pytest.approx([graph["from"], graph["to"]], abs=span / 100)
    assert graph["to"] - graph["from"] == pytest.approx(span)
    assert len(times) == pytest.approx(SWINGS * SAMPLES_A_SWING, rel=0.03)
    rig.give("restart")
    assert rig.state["curves"]["columns"]["t"] == [0]


def test_a_new_cradle_keeps_the_chosen_graph_and_numbers_without_end_are_left_out(rig):
    rig.give("graph", "Energies")
    rig.save(HEADER + GOOD * (MOST_DRAWN + 3))
    assert rig.state["graph"] == "Energies"
    rig.cradle.pend_list[0]["omega"] = 1e154
    rig.viewer.take_sample()
    rig.wait()
    assert rig.state["curves"]["columns"]["total"][-1] is None
    rig.give("graph", "Angles theta")
    assert len(rig.state["curves"]["curves"]) == MOST_DRAWN
