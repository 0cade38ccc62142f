"""The table of the pendula on the stand-in: masses and e to change, live numbers, and one tick."""

import json
import re
from html import unescape

import pytest
from wall import Wall
from whole_cradles import FIVE_CSV, GOOD, HEADER

from src import visualize_cradle_run
from support.constants import DT, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.page.table import give_command


@pytest.fixture
def opened(wall):
    """A viewer with an open table."""
    command(wall, "table", True)
    return wall


def command(wall, name, value):
    """Give a command as the page's script does."""
    give_command(wall.viewer.give, json.dumps([name, value]))
    wall.wait()


def data(wtext):
    """Return the data that a text carries for the page's script."""
    return json.loads(unescape(re.search('data-value="(.*?)"', wtext.text)[1]))


def mistakes(wall):
    return data(wall.viewer.table.rows)["mistakes"]


def column(wall, name):
    """Return the texts of a column of the table."""
    return [row[name] for row in data(wall.viewer.table.rows)["rows"]]


def text(wtext):
    return unescape(re.sub("<.*?>", "", wtext.text))


def test_nothing_of_a_folded_table_is_sent(wall):
    """A page that was loaded again has folded it."""
    for fold in (wall.wait, lambda: command(wall, "table", False), lambda: wall.give("show again")):
        fold()
        wall.wait(0.3)
        assert (wall.viewer.table.rows.text, wall.viewer.table.now.text) == ("", "")
        command(wall, "table", True)
        assert (column(wall, "mass"), len(data(wall.viewer.table.now))) == (["1.0"] * 5, 10)


def test_the_table_shows_pend_list_as_it_is_now(opened):
    opened.use(opened.panel.lifted.slider, value=0.4)
    opened.wait(0.3)
    now = data(opened.viewer.table.now)
    assert list(now) == [f"{key}_{i}" for key in ("theta", "omega") for i in range(1, 6)]
    assert [*map(float, now.values())] == pytest.approx(opened.values("theta") + opened.values("omega"), abs=5e-7)
    assert any(opened.values("omega"))
    assert [column(opened, name) for name in ("mass", "e")] == [["1.0"] * 5, ["1.0"] * 5]


def test_main_makes_the_cradle_of_an_edited_cell_with_the_masses_and_e_that_are_shown(opened, csv):
    """They came from --mass and from the menu: nothing else may change with the edit."""
    opened.viewer.cradle.mass = 3.0
    opened.press("r")
    opened.use(opened.panel.collisions, selected="perfectly inelastic, e = 0")
    assert [float(e) for e in column(opened, "e")] == [0] * 5
    opened.wait(0.3)
    command(opened, "edit", [1, "mass", "2.50"])
    assert column(opened, "mass") == ["3.0", "2.5", "3.0", "3.0", "3.0"]
    assert (opened.time(), opened.lifts(), opened.values("e")) == (0, [30, 0, 0, 0, 0], [0] * 5)
    assert opened.panel.collisions.selected == "as in the CSV"
    command(opened, "edit", [4, "e", "0.5"])
    assert (opened.values("mass"), opened.values("e")) == ([3, 2.5, 3, 3, 3], [0, 0, 0, 0, 0.5])
    assert csv.read_text() == FIVE_CSV


def test_a_bad_value_says_the_allowed_ones_and_the_cradle_swings_on(opened):
    opened.wait(0.3)
    command(opened, "edit", [3, "mass", "<b>"])
    mistake = {"3,mass": ["<b>", "mass: allowed is a number from 1e-300 to 1e6, without its unit, kg"]}
    assert (mistakes(opened), opened.time() > 0.2) == (mistake, True)
    command(opened, "edit", [0, "e", "0.25"])  # another cell does not hide the mistake
    assert mistakes(opened) == mistake
    command(opened, "edit", [3, "mass", " 0.5 "])
    assert (mistakes(opened), opened.values("mass")[3], opened.values("e")[0]) == ({}, 0.5, 0.25)
    command(opened, "edit", [1, "e", "2"])
    opened.save(HEADER + GOOD * 3)  # a saved file replaces it all
    command(opened, "edit", [3, "mass", "2"])  # of a row that is no longer there
    assert (opened.values("mass"), mistakes(opened)) == ([1, 1, 1], {})


def test_masses_too_far_apart_are_refused_only_in_the_double_cradle(opened, csv):
    """In the table, and in a saved file: the old cradle stays."""
    command(opened, "edit", [3, "mass", "1e-7"])
    assert opened.values("mass")[3] == 1e-7
    double = Wall(csv, 30, 10, kind=DoubleCradle)
    double.click(double.panel.pause)  # it then needs no ticks
    command(double, "table", True)
    assert data(double.viewer.table.rows)["keys"] == ["theta", "phi", "omega", "phi_omega"]
    command(double, "edit", [3, "mass", "9e-7 "])
    words = "mass: allowed is at most 1e6 times the smallest mass, in a double cradle"
    assert mistakes(double) == {"3,mass": ["9e-7 ", words]}
    command(double, "edit", [3, "mass", "1e-6"])
    double.save(HEADER + "".join(GOOD.replace("1.0", mass, 1) for mass in ("0.5", "500000", "3", ".4")))
    assert double.values("mass") == [1, 1, 1, 1e-6, 1]
    assert "line 3, column mass: found '500000', and '.4' in line 5, allowed is at most 1e6" in text(double.panel.error)


def test_an_edited_experiment_keeps_its_bobs_lifted(opened):
    opened.give("experiment", 4)
    command(opened, "edit", [2, "mass", "2"])
    assert opened.lifts() == [45, 0, 0, 0, 45]


NOT_GIVEN = [
    *("", "{", "7", "[]", "null", '["next"]', '["save", null]', '["next", null, 1]', '["next", 1]', "[" * 100_000),
    *('["table", 1]', '["write", null]', '["answer", "a"]', '["answer", ["a", "0"]]'),
    *('["edit", null]', '["edit", [0, "mass"]]', '["edit", [0, "mass", 2]]', '["edit", [0, "color", "red"]]'),
]


def test_the_page_gives_only_the_commands_of_its_script():
    given, answers = [], [["1_one_bob", 0], ["1_one_bob", None]]
    for message in [*NOT_GIVEN, *(json.dumps(["answer", answer]) for answer in answers)]:
        give_command(lambda *pair: given.append(pair), message)
    assert given == [("answer", answer) for answer in answers]


def shown_tick(wall):
    return text(wall.viewer.table.before_and_after).splitlines()


def test_one_tick_shows_each_pendulum_before_and_after_while_paused(wall, monkeypatch):
    """Also before handle_collision is written."""
    wall.click(wall.viewer.table.tick)
    assert (wall.viewer.table.tick.disabled, shown_tick(wall)) == (True, [])
    wall.click(wall.panel.pause)
    theta = wall.values("theta")[0]
    wall.click(wall.viewer.table.tick)
    assert (wall.viewer.motion.ticks, wall.viewer.table.tick.disabled) == (1, False)
    first, *pendula, last = shown_tick(wall)
    angle = f"[0] theta {theta:.6g} -> {wall.values('theta')[0]:.6g}"
    assert first == f"One tick, {DT:g} s: before -> after"
    assert pendula[0] == angle.ljust(34) + f"omega 0 -> {wall.values('omega')[0]:.6g}"
    assert [line[:9] for line in pendula] == [f"[{i}] theta" for i in range(5)]
    assert last == "handle_collision was not called."
    wall.click(wall.panel.restart)
    assert shown_tick(wall) == []
    monkeypatch.delattr(visualize_cradle_run, "handle_collision")
    wall.click(wall.viewer.table.tick)
    assert shown_tick(wall)[-1] == last


CALLS = {
    Cradle: f"handle_collision(e=1, omega1=2, omega2=0, m1=1, m2=1, r_param={R_PARAM:g}) returned (0, 2)",
    DoubleCradle: "handle_two_double_bobs(pend1=pend_list[0], pend2=pend_list[1], "
    f"r_param={R_PARAM:g}, approaching_only=True) returned True",
}


@pytest.mark.parametrize("kind", CALLS)
def test_one_tick_shows_each_call_of_the_collision_function(csv, kind):
    """Two pendula hang so that they touch, and the first one moves towards the second one."""
    csv.write_text(HEADER + GOOD * 2)
    wall = Wall(csv, *[0] * len(kind.angle_keys), kind=kind)
    wall.click(wall.panel.pause)
    first = wall.viewer.cradle.pend_list[0]
    first["objects"][1].radius *= 1.5
    first["omega"] = 2.0
    wall.click(wall.viewer.table.tick)
    _, *pendula, call = shown_tick(wall)[:4]
    assert call == CALLS[kind]
    assert [line.count("->") for line in pendula] == [2 * len(kind.angle_keys)] * 2
