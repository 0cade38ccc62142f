"""The graph on the stand-in: what each choice draws, and when."""

import pytest
from wall import Wall
from whole_cradles import components, GOOD, HEADER

from support.constants import COLOR_MAP
from support.cradle.double_cradle import DoubleCradle
from support.files.data_file import EVERY
from support.page.motion_graph import ENERGIES, ENERGY, HIDING, INTERVAL, MOST, NOTHING, PHASE, PHASE_SHOWN, SHOWN

ANGLES, VELOCITIES = "Angles theta (rad)", "Velocities omega (rad/s)"


def choose(wall, choice):
    """Choose a graph as a person does."""
    assert choice in wall.panel.graph.choices
    wall.use(wall.panel.graph, selected=choice)


def drawn(wall):
    """Return the points of the curves that have any, by the curves' labels."""
    return {curve.label: curve.data for curve in wall.viewer.graph.curves.values() if curve.data}


def color_of(wall, name):
    return components(wall.viewer.graph.curves[name].color)


def recorded(wall, column):
    """Return the recorded values of a column, by their times (s)."""
    at = wall.viewer.recording.columns.index(column)
    return {row[0]: row[at] for row in wall.viewer.recording.rows}


def test_the_graph_shows_the_energies_of_the_last_ten_seconds(csv):
    """Its points are always at the same times, so they do not shake."""
    csv.write_text(HEADER + GOOD)
    single = Wall(csv)
    single.wait(SHOWN + 2)
    assert single.panel.graph.selected == ENERGY
    assert list(drawn(single)) == ["kinetic", "potential", "total"]
    kinetic, potential, total = drawn(single).values()
    graph = single.viewer.graph.graph
    assert graph.xmax - graph.xmin == SHOWN
    times = [t for t, _ in total]
    assert times == pytest.approx([INTERVAL * round(t / INTERVAL) for t in times])
    assert times[0] == pytest.approx(graph.xmin, abs=2 * INTERVAL)
    assert times[-1] == pytest.approx(SHOWN + 2, abs=2 * INTERVAL)
    for (t, k), (_, p), (_, both) in zip(kinetic, potential, total, strict=True):
        assert k + p == pytest.approx(both)
        assert 0 <= t - graph.xmin <= SHOWN
    assert len({color_of(single, name) for name in ENERGIES}) == 3


def test_the_angles_and_velocities_of_all_bobs_are_drawn_in_their_colors(csv):
    colors = ["red", "cyan", "orange"]
    csv.write_text(HEADER + "".join(GOOD.replace("red", color) for color in colors))
    wall = Wall(csv)
    for choice, key in ((ANGLES, "theta"), (VELOCITIES, "omega")):
        choose(wall, choice)
        wall.wait(0.5)
        assert list(drawn(wall)) == ["1", "2", "3"]
        for number, color in zip("123", colors, strict=True):
            values = recorded(wall, f"{key}_{number}")
            assert all(values[t] == value for t, value in drawn(wall)[number])
            assert color_of(wall, number) == components(COLOR_MAP[color])


def test_the_phase_picture_is_that_of_one_bob(wall):
    choose(wall, "Phase picture of bob 1: omega over theta")
    wall.wait(PHASE_SHOWN + 1)
    assert list(drawn(wall)) == [PHASE]
    points = drawn(wall)[PHASE]
    assert len(points) == pytest.approx(PHASE_SHOWN / EVERY, abs=2)
    assert points[-1] == [[*recorded(wall, f"{key}_1").values()][-1] for key in ("theta", "omega")]
    assert color_of(wall, PHASE) == components(COLOR_MAP["red"])


def test_the_double_cradle_has_graphs_of_both_cords(csv):
    csv.write_text(HEADER + GOOD * 2)
    wall = Wall(csv, 45, 20, kind=DoubleCradle)
    assert wall.panel.graph.choices == [
        *(ENERGY, "Angles theta (rad)", "Angles phi (rad)", "Velocities omega (rad/s)", "Velocities phi_omega (rad/s)"),
        *("Phase picture of bob 1: omega over theta", "Phase picture of bob 1: phi_omega over phi"),
        *("Phase picture of bob 2: omega over theta", "Phase picture of bob 2: phi_omega over phi"),
        NOTHING,
    ]
    choose(wall, "Angles phi (rad)")
    assert drawn(wall)["1"][0] == [0, pytest.approx(wall.viewer.angles[1])]


def test_a_new_cradle_has_its_own_choices_and_keeps_the_present_one_if_it_can(wall):
    choose(wall, ANGLES)
    wall.save(HEADER + GOOD.replace("red", "green") * (MOST + 3))
    assert wall.panel.graph.selected == ANGLES
    assert list(drawn(wall)) == [str(number) for number in range(1, MOST + 1)]  # the first ones
    assert color_of(wall, "1") == (0, 1, 0)
    choose(wall, "Phase picture of bob 7: omega over theta")
    wall.save(HEADER + GOOD * 2)
    assert wall.panel.graph.selected == ENERGY
    assert set(drawn(wall)) == set(ENERGIES)


def test_no_graph_is_hidden_and_sends_nothing_and_a_restart_empties_it(wall):
    wall.wait(1)
    choose(wall, NOTHING)
    wall.wait(1)
    assert wall.viewer.graph.style.text == HIDING
    assert not drawn(wall)
    choose(wall, ENERGY)
    assert wall.viewer.graph.style.text == ""
    assert len(drawn(wall)["total"]) == pytest.approx(2 / INTERVAL, abs=2)  # it shows what was recorded meanwhile
    wall.click(wall.panel.restart)
    assert [len(points) for points in drawn(wall).values()] == [1, 1, 1]
