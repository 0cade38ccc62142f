"""The table of the pendula on the stand-in: edit, add, delete, write, live numbers, and one tick."""

import json
import os
import re
from html import escape, unescape

import pytest
from wall import Wall
from whole_cradles import FIVE_CSV, GOOD, HEADER

from src import pds_helper, visualize_cradle_run
from src.pds_helper import extract_and_convert
from support.constants import COLOR_MAP, DT, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.files.cradle_csv import Snapshot, WHY_NOT_MORE
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


# --- the numbers -----------------------------------------------------------------------------------------------------


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
    assert [column(opened, name) for name in ("mass", "e", "color")] == [["1.0"] * 5, ["1.0"] * 5, ["red"] * 5]


# --- edit ------------------------------------------------------------------------------------------------------------


def test_main_makes_the_cradle_of_an_edited_cell_with_the_masses_and_e_that_are_shown(opened, csv):
    """They came from --mass and from the menu: nothing else may change with the edit."""
    opened.viewer.cradle.mass = 3.0
    opened.press("r")
    opened.use(opened.panel.collisions, selected="perfectly inelastic, e = 0")
    assert [float(e) for e in column(opened, "e")] == [0] * 5
    opened.wait(0.3)
    command(opened, "edit", [1, "mass", "2.50"])
    assert column(opened, "mass") == ["3.0", "2.50", "3.0", "3.0", "3.0"]
    assert (opened.time(), opened.lifts(), opened.values("e")) == (0, [30, 0, 0, 0, 0], [0] * 5)
    assert opened.panel.collisions.selected == "as in the CSV"
    command(opened, "edit", [4, "e", "0.5"])
    command(opened, "edit", [2, "color", "blue"])
    assert (opened.values("mass"), opened.values("e")) == ([3, 2.5, 3, 3, 3], [0, 0, 0, 0, 0.5])
    assert (opened.viewer.cradle.bobs()[2].color, csv.read_text()) == (COLOR_MAP["blue"], FIVE_CSV)


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


def test_pendula_are_added_up_to_the_limit_and_deleted_but_for_the_last_one(opened, monkeypatch):
    """The page names the limit. You may click faster than the page shows the new table."""
    monkeypatch.setattr("support.page.source.MOST_PENDULA", 6)
    command(opened, "edit", [4, "mass", "7"])
    for _ in range(2):
        command(opened, "add", None)
        assert opened.values("mass") == [1, 1, 1, 1, 7, 7]
    assert text(opened.viewer.table.written) == f"Add a pendulum: {WHY_NOT_MORE}"
    for _ in range(2):
        command(opened, "delete", 0)
        assert "Add" not in text(opened.viewer.table.written)
    assert (opened.values("mass"), opened.lifts()) == ([1, 1, 7, 7], [30, 0, 0, 0])
    for _ in range(4):
        command(opened, "delete", 0)
    command(opened, "edit", [3, "mass", "2"])
    assert (opened.values("mass"), mistakes(opened)) == ([7], {})


def test_an_edited_experiment_keeps_its_bobs_lifted(opened):
    opened.give("experiment", 4)
    command(opened, "edit", [2, "mass", "2"])
    assert opened.lifts() == [45, 0, 0, 0, 45]
    opened.give("experiment", 2)
    command(opened, "add", None)
    assert opened.lifts() == [45, 45, 0, 0, 0, 0]


NOT_GIVEN = [
    *("", "{", "7", "[]", "null", '["add"]', '["save", null]', '["add", null, 1]', '["undo", 1]', "[" * 100_000),
    *('["table", 1]', '["delete", "0"]', '["delete", null]', '["answer", "a"]', '["answer", ["a", "0"]]'),
    *('["edit", null]', '["edit", [0, "mass"]]', '["edit", [0, "mass", 2]]', '["edit", [0, "texture", "metal"]]'),
]


def test_the_page_gives_only_the_commands_of_its_script():
    given, answers = [], [["1_one_bob", 0], ["1_one_bob", None]]
    for message in [*NOT_GIVEN, *(json.dumps(["answer", answer]) for answer in answers)]:
        give_command(lambda *pair: given.append(pair), message)
    assert given == [("answer", answer) for answer in answers]


# --- write -----------------------------------------------------------------------------------------------------------


BLUE = GOOD.replace("1", "2", 1).replace("red", "blue")
WRITTEN, UNDONE = "cradle.csv has these pendula now.", "cradle.csv is again as it was before the write."
CHANGES = {  # what a click changes in your file, if the table has five equal red bobs
    HEADER + GOOD.replace("1.0", " 1") * 5: "cradle.csv has these pendula.",
    HEADER + BLUE + GOOD * 5: "changes cradle.csv: row 1: mass 2.0 to 1.0, color blue to red; removes row 6",
    HEADER + BLUE: "changes cradle.csv: row 1: mass 2.0 to 1.0, color blue to red; adds row 2; adds row 3; and 2 more",
    FIVE_CSV.replace("theta", "my"): "changes cradle.csv: removes column my; adds column theta",
    FIVE_CSV + "\0\r": "replaces all of cradle.csv, which has a mistake now",
}


@pytest.mark.parametrize(("old", "words"), CHANGES.items())
def test_the_page_says_what_a_click_writes_and_undoes_it_once(opened, csv, old, words):
    opened.save(old)
    opened.viewer.snapshot = Snapshot(csv, FIVE_CSV.encode())
    steps = [("restart", old, words)] + [("write", FIVE_CSV, f"{WRITTEN} Undo")] * 2 + [("undo", old, UNDONE)] * 2
    for name, *expected in steps:
        opened.give(name)
        assert [csv.read_bytes().decode(), text(opened.viewer.table.written)] == expected
    assert (opened.viewer.snapshot == opened.viewer.source.file.current) != bool(opened.panel.error.text)


def test_write_to_my_csv_writes_the_pendula_of_the_table_with_write_to_csv(opened, csv, monkeypatch):
    """Not to your file at once: it may fail."""
    paths, write = [], pds_helper.write_to_csv
    monkeypatch.setattr(pds_helper, "write_to_csv", lambda pends, path: paths.append(path) or write(pends, path))
    opened.save(FIVE_CSV.replace("texture\n", "texture,note\n").replace("metal\n", "metal,mine\n"))
    command(opened, "edit", [1, "mass", "2.5"])
    opened.use(opened.panel.collisions, selected="perfectly inelastic, e = 0")
    opened.click(opened.viewer.table.write)
    rows = extract_and_convert(csv)
    assert [(row["mass"], row["e"]) for row in rows] == [(1, 0), (2.5, 0), (1, 0), (1, 0), (1, 0)]
    assert {(row["note"], row["theta"]) for row in rows} == {("mine", 0)}  # not the present angles
    assert (len(paths), csv in paths, opened.values("mass")) == (1, False, [1, 2.5, 1, 1, 1])
    csv.write_text(FIVE_CSV.replace("1.0,0.0", "0.5,0.0"))
    command(opened, "undo", None)  # before the page has seen the edit
    assert text(opened.viewer.table.written) == "Your CSV has changed since the write, so Undo leaves it as it is."
    opened.wait(1)
    assert re.fullmatch(r"changes cradle.csv: (row \d: e 0.5 to 0.0; ){3}and 2 more", text(opened.viewer.table.written))


def test_an_experiment_is_written_only_if_you_press_the_button(opened, csv):
    """The page then shows the pendula of your file: --mass and the menu belonged to the old file."""
    opened.viewer.cradle.mass = 3.0
    opened.use(opened.panel.collisions, selected="perfectly inelastic, e = 0")
    opened.give("experiment", 5)
    assert csv.read_text() == FIVE_CSV
    opened.click(opened.viewer.table.write)
    assert [row["mass"] for row in extract_and_convert(csv)] == [5, 1, 1, 1, 1]
    assert (opened.values("mass"), opened.values("e")) == ([5, 1, 1, 1, 1], [1] * 5)
    assert opened.panel.collisions.selected == "as in the CSV"
    assert opened.viewer.questions.menu.selected == "My cradle (CSV)"


def write_half(pend_list, filepath):
    filepath.write_text("mass,e")
    raise ValueError("no more\n<ink>")


OTHER, WRITE = "write_to_csv has written other pendula, so your CSV stays as it is", pds_helper.write_to_csv
WRONG = {write_half: "no more <ink>", lambda pends, path: WRITE(pends[1:], path): OTHER, lambda *_: None: OTHER}


@pytest.mark.parametrize(("write_to_csv", "words"), WRONG.items())
def test_a_write_to_csv_with_a_mistake_leaves_your_csv_alone(opened, csv, monkeypatch, write_to_csv, words):
    monkeypatch.setattr(pds_helper, "write_to_csv", write_to_csv)
    command(opened, "edit", [1, "mass", "2"])
    opened.click(opened.viewer.table.write)
    assert opened.viewer.table.written.text == f'<span class="failed">ValueError: {escape(words)}</span>'
    assert (csv.read_text(), opened.values("mass")) == (FIVE_CSV, [1, 2, 1, 1, 1])


def test_a_file_that_cannot_be_written_is_named_in_a_line(opened, csv):
    os.rename(csv.parent, csv.parent.with_name("elsewhere"))
    opened.wait(1)
    assert text(opened.viewer.table.written) == "replaces all of cradle.csv, which cannot be read, so without Undo"
    opened.click(opened.viewer.table.write)
    assert text(opened.viewer.table.written) == f"{csv}: cannot be written: No such file or directory"
    csv.parent.mkdir()
    opened.click(opened.viewer.table.write)
    assert text(opened.viewer.table.written) == WRITTEN


# --- one tick --------------------------------------------------------------------------------------------------------


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
