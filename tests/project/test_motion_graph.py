"""The graph on the stand-in: what each choice draws, and when."""

import pytest
from vpython import vector
from wall import Wall
from whole_cradles import components, go_on, GOOD, HEADER

from src.beyond.live_double_cradle import LiveDoubleCradle
from support.constants import COLOR_MAP
from support.files.recording import EVERY
from support.page.motion_graph import ENERGIES, ENERGY, HIDING, INTERVAL, MOST, NOTHING, PHASE, PHASE_SHOWN, SHOWN

ANGLES, VELOCITIES = "Angles theta (rad)", "Velocities omega (rad/s)"


def choose(wall, choice):
    """Choose a graph as a person does."""
    assert choice in wall.panel.graph.choices
    wall.panel.graph.selected = choice
    wall.panel.graph.bind(wall.panel.graph)
    wall.wait()


def drawn(wall):
    """Return the points of the curves that have any, by the curves' labels."""
    return {curve.label: curve.data for curve in wall.viewer.graph.curves.values() if curve.data}


def test_the_graph_shows_the_energies_of_the_last_ten_seconds(single):
    single.wait(SHOWN + 2)
    assert single.panel.graph.selected == ENERGY
    assert list(drawn(single)) == ["kinetic", "potential", "total"]
    kinetic, potential, total = drawn(single).values()
    graph = single.viewer.graph.graph
    assert graph.xmax - graph.xmin == SHOWN
    assert graph.xmin <= total[0][0] < graph.xmin + 0.5
    assert total[-1][0] == pytest.approx(SHOWN + 2, abs=0.1)
    for (t, k), (_, p), (_, both) in zip(kinetic, potential, total, strict=True):
        assert k + p == pytest.approx(both)
        assert 0 <= t - graph.xmin <= SHOWN
    assert len({tuple(components(single.viewer.graph.curves[name].color)) for name in ENERGIES}) == 3


def test_the_graph_is_smooth_on_a_slow_machine_too(wall):
    """Its points do not move from picture to picture, either."""
    for last in (20, 20.4, 20.7):
        go_on(wall.viewer, wall.viewer.make())
        go_on(wall.viewer, wall.viewer.advance(round(last * INTERVAL / wall.viewer.cradle.dt)))
        wall.viewer.graph.draw()
        assert [t for t, _ in drawn(wall)["total"]] == pytest.approx([INTERVAL * i for i in range(21)])


def test_the_angles_and_velocities_of_all_bobs_in_their_colors(csv):
    rows = ["1,1,0,0,red,metal", "1,1,0,0,cyan,metal", "1,1,0,0,orange,metal"]
    csv.write_text(HEADER + "\n".join(rows) + "\n")
    wall = Wall(csv)
    for choice, key in ((ANGLES, "theta"), (VELOCITIES, "omega")):
        choose(wall, choice)
        wall.wait(0.5)
        assert list(drawn(wall)) == ["1", "2", "3"]
        pendula = wall.viewer.cradle.pend_list
        go_on(wall.viewer, wall.viewer.advance(round(1 / wall.viewer.cradle.dt) - wall.viewer.motion.ticks))
        wall.viewer.graph.draw()
        for number, pend in enumerate(pendula, start=1):
            recorded = {
                row[0]: row[wall.viewer.recording.columns.index(f"{key}_{number}")]
                for row in wall.viewer.recording.rows
            }
            assert all(recorded[t] == value for t, value in drawn(wall)[str(number)])
            assert components(wall.viewer.graph.curves[str(number)].color) == components(COLOR_MAP[pend["color"]])
            assert recorded[1.0] == pend[key]
        wall.press("r")


def test_the_phase_picture_of_one_bob(wall):
    choose(wall, "Phase picture of bob 1: omega over theta")
    wall.wait(PHASE_SHOWN + 1)
    assert list(drawn(wall)) == [PHASE]
    points = drawn(wall)[PHASE]
    assert len(points) == pytest.approx(PHASE_SHOWN / EVERY, abs=2)
    pend = wall.viewer.cradle.pend_list[0]
    newest = list(wall.viewer.recording.rows)[-1]
    at = wall.viewer.recording.columns.index
    assert points[-1] == [newest[at("theta_1")], newest[at("omega_1")]]
    assert components(wall.viewer.graph.curves[PHASE].color) == components(COLOR_MAP[pend["color"]])


def test_the_double_cradle_has_graphs_of_both_cords(csv):
    csv.write_text(HEADER + GOOD * 2)
    wall = Wall(csv, 45, 20, kind=LiveDoubleCradle)
    assert wall.panel.graph.choices == [
        *(ENERGY, "Angles theta (rad)", "Angles phi (rad)", "Velocities omega (rad/s)", "Velocities phi_omega (rad/s)"),
        *("Phase picture of bob 1: omega over theta", "Phase picture of bob 1: phi_omega over phi"),
        *("Phase picture of bob 2: omega over theta", "Phase picture of bob 2: phi_omega over phi"),
        NOTHING,
    ]
    choose(wall, "Angles phi (rad)")
    wall.wait(0.2)
    start = drawn(wall)["1"][0]
    assert start == [0, pytest.approx(wall.viewer.angles[1])]


def test_a_new_cradle_has_its_own_choices_and_keeps_the_present_one_if_it_can(wall, csv):
    choose(wall, ANGLES)
    csv.write_text(HEADER + GOOD.replace("red", "green") * 7)
    wall.wait(1)
    assert wall.panel.graph.selected == ANGLES
    assert len(drawn(wall)) == 7
    assert components(wall.viewer.graph.curves["1"].color) == components(vector(0, 1, 0))
    choose(wall, "Phase picture of bob 7: omega over theta")
    csv.write_text(HEADER + GOOD * 2)
    wall.wait(1)
    assert wall.panel.graph.selected == ENERGY
    assert set(drawn(wall)) == set(ENERGIES)


def test_of_many_pendula_the_first_are_drawn(csv):
    csv.write_text(HEADER + GOOD * (MOST + 3))
    wall = Wall(csv)
    choose(wall, ANGLES)
    wall.wait(0.1)
    assert list(drawn(wall)) == [str(number) for number in range(1, MOST + 1)]


def test_restart_empties_the_graph(wall):
    wall.wait(1)
    wall.panel.restart.bind()
    wall.wait()
    assert [len(points) for points in drawn(wall).values()] == [1, 1, 1]


def test_no_graph_is_hidden_and_sends_nothing(wall):
    wall.wait(1)
    choose(wall, NOTHING)
    wall.wait(1)
    assert wall.viewer.graph.style.text == HIDING
    assert not drawn(wall)
    choose(wall, ENERGY)
    assert wall.viewer.graph.style.text == ""
    assert len(drawn(wall)["total"]) == pytest.approx(2 / INTERVAL, abs=2)  # it shows what was recorded meanwhile
