"""The table of the pendula on the stand-in: edit, add, delete, write, live numbers, and one tick."""

import json
import os
import re
from html import unescape

import pytest
from wall import set_slider, Wall
from whole_cradles import components, FIVE_CSV, GOOD, HEADER

from src import pds_helper, visualize_cradle_run
from src.beyond.live_double_cradle import LiveDoubleCradle
from src.pds_helper import extract_and_convert
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import COLOR_MAP, DT, G, R_PARAM
from support.page.commands import Command
from support.page.table import give_command

MASS_RULE = "mass: allowed is a number from 1e-300 to 1e6 (kg)"


@pytest.fixture
def opened(wall):
    """A viewer with an open table."""
    tell(wall, "TABLE", True)
    return wall


def tell(wall, name, value):
    """Give a command as the page's script does."""
    give_command(wall.viewer.give, json.dumps([name, value]))
    wall.wait()


def data(wtext):
    """Return the data that a text carries for the page's script."""
    return json.loads(unescape(re.search('data-value="(.*?)"', wtext.text)[1]))


def column(wall, name):
    """Return the texts of a column of the table."""
    return [row[name] for row in data(wall.viewer.table.rows)["rows"]]


def of(wall, key):
    """Return the values of this key in pend_list."""
    return [pend[key] for pend in wall.viewer.cradle.pend_list]


def text(wtext):
    return unescape(re.sub("<.*?>", "", wtext.text))


# --- what it shows ---------------------------------------------------------------------------------------------------


def test_nothing_of_a_folded_table_is_sent(wall):
    wall.wait(1)
    assert (wall.viewer.table.rows.text, wall.viewer.table.now.text) == ("", "")
    tell(wall, "TABLE", True)
    assert wall.viewer.table.now.text != ""
    tell(wall, "TABLE", False)
    wall.wait(1)
    assert (wall.viewer.table.rows.text, wall.viewer.table.now.text) == ("", "")


def test_a_page_that_was_loaded_again_gets_the_whole_table_when_it_is_opened(opened):
    opened.viewer.give(Command.SHOW_AGAIN)
    opened.wait()
    assert opened.viewer.table.rows.text == ""
    tell(opened, "TABLE", True)
    assert column(opened, "mass") == ["1.0"] * 5


def test_it_shows_pend_list_as_it_is_now(opened):
    set_slider(opened.panel.lifted, 0.4)
    opened.wait(0.3)
    pend_list = opened.viewer.cradle.pend_list
    now = data(opened.viewer.table.now)
    assert list(now) == [f"{key}_{i}" for key in ("theta", "omega") for i in range(1, 6)]
    for i, pend in enumerate(pend_list, start=1):
        for key in ("theta", "omega"):
            assert float(now[f"{key}_{i}"]) == pytest.approx(pend[key], abs=5e-7)
    assert any(of(opened, "omega"))
    assert column(opened, "mass") == column(opened, "e") == ["1.0"] * 5
    assert column(opened, "color") == ["red"] * 5


def test_it_shows_the_masses_and_e_of_the_settings(opened):
    opened.panel.collisions.selected = "inelastic, e = 0"
    opened.panel.collisions.bind(opened.panel.collisions)
    opened.wait()
    assert [float(e) for e in column(opened, "e")] == [0] * 5


def test_the_double_cradle_has_four_numbers_a_row(csv):
    wall = Wall(csv, 30, 10, kind=LiveDoubleCradle)
    tell(wall, "TABLE", True)
    assert data(wall.viewer.table.rows)["keys"] == ["theta", "phi", "omega", "phi_omega"]
    assert len(data(wall.viewer.table.now)) == 20


# --- edit ------------------------------------------------------------------------------------------------------------


def test_a_cell_is_edited_and_main_makes_the_new_cradle(opened, csv):
    opened.wait(1)
    tell(opened, "EDIT", [1, "mass", "2.50"])
    assert of(opened, "mass") == [1, 2.5, 1, 1, 1]
    assert column(opened, "mass") == ["1.0", "2.50", "1.0", "1.0", "1.0"]
    assert (opened.time(), opened.lifts()) == (0, [30, 0, 0, 0, 0])
    tell(opened, "EDIT", [4, "e", "0.5"])
    tell(opened, "EDIT", [2, "color", "blue"])
    assert of(opened, "mass") == [1, 2.5, 1, 1, 1]
    assert of(opened, "e") == [1, 1, 1, 1, 0.5]
    assert components(opened.viewer.cradle.pend_list[2]["objects"][1].color) == components(COLOR_MAP["blue"])
    assert csv.read_text() == FIVE_CSV


@pytest.mark.parametrize(
    ("name", "typed", "rule"),
    [
        ("mass", "0", MASS_RULE),
        ("mass", "heavy", MASS_RULE),
        ("mass", "", MASS_RULE),
        ("mass", "1_000", MASS_RULE),
        ("e", "1.1", "e: allowed is a number from 0 to 1"),
        ("e", "<b>", "e: allowed is a number from 0 to 1"),
    ],
)
def test_a_bad_value_says_what_is_allowed_and_the_cradle_swings_on(opened, name, typed, rule):
    opened.wait(1)
    tell(opened, "EDIT", [3, name, typed])
    assert data(opened.viewer.table.rows)["mistakes"] == {f"3,{name}": [typed, rule]}
    assert opened.time() > 0.9
    tell(opened, "EDIT", [0, "e", "0.25"])  # another cell does not hide the mistake
    assert data(opened.viewer.table.rows)["mistakes"] == {f"3,{name}": [typed, rule]}
    tell(opened, "EDIT", [3, name, " 0.5 "])
    assert data(opened.viewer.table.rows)["mistakes"] == {}
    assert of(opened, name)[3] == 0.5
    assert of(opened, "e")[0] == 0.25


def test_a_mass_too_far_from_the_others_is_refused_only_in_the_double_cradle(opened, csv):
    tell(opened, "EDIT", [3, "mass", "1e-7"])
    assert of(opened, "mass")[3] == 1e-7
    double = Wall(csv, 30, 10, kind=LiveDoubleCradle)
    tell(double, "TABLE", True)
    tell(double, "EDIT", [3, "mass", "9e-7 "])
    words = "mass: allowed is at most 1e6 times the smallest mass, in a double cradle"
    assert data(double.viewer.table.rows)["mistakes"] == {"3,mass": ["9e-7 ", words]}
    assert of(double, "mass") == [1] * 5
    tell(double, "EDIT", [3, "mass", "1e-6"])
    assert of(double, "mass") == [1, 1, 1, 1e-6, 1]
    assert data(double.viewer.table.rows)["mistakes"] == {}


def test_a_saved_file_with_masses_too_far_apart_leaves_the_old_double_cradle(csv):
    double = Wall(csv, 30, 10, kind=LiveDoubleCradle)
    double.press(" ")  # paused, it needs no ticks
    csv.write_text(HEADER + GOOD + GOOD.replace("1.0", "1e-7", 1))
    double.wait(1)
    assert of(double, "mass") == [1] * 5
    assert "in a double cradle" in double.panel.error.text


def test_pendula_are_added_and_deleted(opened, csv):
    tell(opened, "EDIT", [4, "mass", "7"])
    tell(opened, "ADD", None)
    assert of(opened, "mass") == [1, 1, 1, 1, 7, 7]
    tell(opened, "DELETE", 0)
    tell(opened, "DELETE", 0)
    assert of(opened, "mass") == [1, 1, 7, 7]
    assert opened.lifts() == [30, 0, 0, 0]
    assert csv.read_text() == FIVE_CSV


def test_pendula_are_added_up_to_the_limit_and_the_page_says_why(opened, monkeypatch):
    monkeypatch.setattr("support.page.workbench.MOST_PENDULA", 6)
    for _ in range(2):
        tell(opened, "ADD", None)
    assert len(opened.thetas()) == len(column(opened, "mass")) == 6
    assert text(opened.viewer.table.written) == (
        "Add a pendulum: allowed are at most 1000, which already move in slow motion on the page"
    )
    tell(opened, "DELETE", 0)
    assert "Add" not in text(opened.viewer.table.written)


def test_clicks_on_rows_that_are_gone_do_nothing(opened):
    for _ in range(6):
        tell(opened, "DELETE", 0)
    tell(opened, "EDIT", [3, "mass", "2"])
    assert of(opened, "mass") == [1]
    assert data(opened.viewer.table.rows)["mistakes"] == {}


def test_an_edit_takes_the_masses_and_e_that_are_shown(csv):
    """They came from --mass and from the menu: nothing else may change with the edit."""
    wall = Wall(csv)
    wall.viewer.cradle.mass = 3.0
    wall.press("r")
    wall.panel.collisions.selected = "inelastic, e = 0"
    wall.panel.collisions.bind(wall.panel.collisions)
    wall.wait()
    tell(wall, "EDIT", [1, "mass", "2"])
    assert of(wall, "mass") == [3, 2, 3, 3, 3]
    assert of(wall, "e") == [0] * 5
    assert wall.panel.collisions.selected == "as in the CSV"
    tell(wall, "EDIT", [1, "e", "1"])
    assert of(wall, "e") == [0, 1, 0, 0, 0]


def test_an_edited_experiment_keeps_its_bobs_lifted(opened):
    opened.viewer.give(Command.EXPERIMENT, 3)
    opened.wait()
    tell(opened, "EDIT", [2, "mass", "2"])
    assert opened.lifts() == [45, 0, 0, 0, 45]
    tell(opened, "DELETE", 2)
    assert opened.lifts() == [45, 0, 0, 0]
    opened.viewer.give(Command.EXPERIMENT, 1)
    opened.wait()
    tell(opened, "ADD", None)
    assert opened.lifts() == [45, 45, 0, 0, 0, 0]


def test_a_saved_file_comes_before_what_was_edited(opened, csv):
    tell(opened, "EDIT", [1, "mass", "2"])
    tell(opened, "EDIT", [1, "e", "2"])
    csv.write_text(HEADER + GOOD * 3)
    opened.wait(1)
    assert of(opened, "mass") == [1, 1, 1]
    assert data(opened.viewer.table.rows)["mistakes"] == {}


GIVEN = [
    *(("TABLE", True), ("ADD", None), ("DELETE", 0), ("EDIT", [0, "mass", "2"])),
    *(("ANSWER", ["1_one_bob", 0]), ("ANSWER", ["1_one_bob", None])),
]
NOT_GIVEN = [
    *("", "{", "7", "[]", "null", '["ADD"]', '["SAVE", null]', '["ADD", null, 1]', '["ADD", 1]', "[" * 100_000),
    *('["TABLE", 1]', '["DELETE", "0"]', '["DELETE", null]', '["ANSWER", "a"]', '["ANSWER", ["a", "0"]]'),
    *('["EDIT", null]', '["EDIT", [0, "mass"]]', '["EDIT", [0, "mass", 2]]', '["EDIT", [0, "texture", "metal"]]'),
]


def test_the_page_gives_only_the_commands_of_its_script():
    given: list = []
    for text in [*NOT_GIVEN, *map(json.dumps, GIVEN)]:
        give_command(lambda *command: given.append(command), text)
    assert given == [(Command[name], value) for name, value in GIVEN]


# --- write -----------------------------------------------------------------------------------------------------------


def press(widget, wall):
    widget.bind()
    wall.wait()


def test_write_to_my_csv_writes_what_the_table_shows(opened, csv):
    csv.write_text(FIVE_CSV.replace("texture\n", "texture,note\n").replace("metal\n", "metal,mine\n"))
    opened.wait(1)
    tell(opened, "EDIT", [1, "mass", "2.5"])
    opened.panel.collisions.selected = "inelastic, e = 0"
    opened.panel.collisions.bind(opened.panel.collisions)
    opened.wait(0.1)
    press(opened.viewer.table.write, opened)
    rows = extract_and_convert(csv)
    assert [row["mass"] for row in rows] == [1, 2.5, 1, 1, 1]
    assert [row["e"] for row in rows] == [0] * 5
    assert {row["note"] for row in rows} == {"mine"}
    assert {row["theta"] for row in rows} == {0}  # not where the bobs are now
    assert text(opened.viewer.table.written) == f"{csv} has these pendula now."
    opened.wait(1)
    assert of(opened, "mass") == [1, 2.5, 1, 1, 1]


def test_an_experiment_is_written_only_if_you_press_the_button(opened, csv):
    opened.viewer.give(Command.EXPERIMENT, 4)
    opened.wait(3)
    assert csv.read_text() == FIVE_CSV
    press(opened.viewer.table.write, opened)
    assert [row["mass"] for row in extract_and_convert(csv)] == [5, 1, 1, 1, 1]
    opened.wait(1)
    assert opened.viewer.questions.menu.selected == "your CSV"
    assert of(opened, "mass") == [5, 1, 1, 1, 1]


def test_what_the_settings_replace_is_shown_no_more_after_it_is_written(csv):
    """The page shows what the file has: --mass and the menu belonged to the old file."""
    wall = Wall(csv)
    wall.viewer.cradle.mass = 3.0
    wall.panel.collisions.selected = "inelastic, e = 0"
    wall.panel.collisions.bind(wall.panel.collisions)
    wall.wait()
    wall.viewer.give(Command.EXPERIMENT, 4)
    wall.wait()
    press(wall.viewer.table.write, wall)
    assert of(wall, "mass") == [5, 1, 1, 1, 1]
    assert of(wall, "e") == [1] * 5
    assert wall.panel.collisions.selected == "as in the CSV"


def test_the_command_is_there_again_after_writing_what_the_file_already_had(opened):
    for mass in ("2", "1"):
        tell(opened, "EDIT", [1, "mass", mass])
    assert opened.viewer.arguments() is None
    press(opened.viewer.table.write, opened)
    assert opened.viewer.arguments() is not None


def test_it_is_the_handouts_write_to_csv_that_writes(opened, csv, monkeypatch):
    """Not to your file at once: it may fail."""
    calls, write = [], pds_helper.write_to_csv
    monkeypatch.setattr(pds_helper, "write_to_csv", lambda *given: calls.append(given) or write(*given))
    tell(opened, "EDIT", [1, "mass", "2"])
    press(opened.viewer.table.write, opened)
    [(pend_list, filepath)] = calls
    assert filepath != csv
    assert pend_list == extract_and_convert(csv)
    assert [pend["mass"] for pend in pend_list] == [1, 2, 1, 1, 1]


def half(pend_list, filepath):
    filepath.write_text("mass,e")
    raise ValueError("no more <ink>")


def other(pend_list, filepath):
    pds_helper_write(pend_list[1:], filepath)


def unwritten(pend_list, filepath):
    raise NotImplementedError("write_to_csv is not\nwritten yet")


pds_helper_write = pds_helper.write_to_csv


@pytest.mark.parametrize(
    ("write_to_csv", "words"),
    [
        (half, "ValueError: no more <ink>"),
        (other, "ValueError: write_to_csv has written other pendula, so your CSV stays as it is"),
        (unwritten, "NotImplementedError: write_to_csv is not written yet"),
        (lambda *_: None, "write_to_csv has written other pendula"),
    ],
)
def test_a_write_to_csv_with_a_mistake_leaves_your_csv_alone(opened, csv, monkeypatch, write_to_csv, words):
    monkeypatch.setattr(pds_helper, "write_to_csv", write_to_csv)
    tell(opened, "EDIT", [1, "mass", "2"])
    press(opened.viewer.table.write, opened)
    assert words in text(opened.viewer.table.written)
    assert '<span class="failed">' in opened.viewer.table.written.text
    assert csv.read_text() == FIVE_CSV
    assert of(opened, "mass") == [1, 2, 1, 1, 1]


def test_a_file_that_cannot_be_written_is_named_in_a_line_and_the_cradle_swings_on(opened, csv):
    os.rename(csv.parent, csv.parent.with_name("elsewhere"))
    press(opened.viewer.table.write, opened)
    assert text(opened.viewer.table.written) == f"{csv}: cannot be written: No such file or directory"
    time = opened.time()
    opened.wait(1)
    assert opened.time() > time + 0.9


# --- one tick --------------------------------------------------------------------------------------------------------


def shown_tick(wall):
    return text(wall.viewer.table.before_and_after).splitlines()


def test_one_tick_shows_each_pendulum_before_and_after(wall):
    wall.panel.pause.bind()
    wall.wait()
    theta = of(wall, "theta")[0]
    press(wall.viewer.table.tick, wall)
    assert wall.viewer.motion.ticks == 1
    first, *pendula, last = shown_tick(wall)
    assert first == f"One tick, {DT:g} s: before -> after"
    omega = of(wall, "omega")[0]
    assert pendula[0] == f"[0] theta {theta:.6g} -> {of(wall, 'theta')[0]:.6g}".ljust(34) + f"omega 0 -> {omega:.6g}"
    assert pendula[4].split() == ["[4]", "theta", "0", "->", "0", "omega", "0", "->", "0"]
    assert last == "handle_collision was not called."
    assert len(pendula) == 5
    press(wall.panel.restart, wall)
    assert shown_tick(wall) == []


def test_one_tick_shows_each_call_of_handle_collision(wall):
    reference = Wall(wall.file)
    while not any(of(reference, "omega")[1:]):
        newton_cradle_tick(reference.viewer.cradle.pend_list, R_PARAM, DT, G, approaching_only=True)
        reference.viewer.motion.ticks += 1
    before_it = reference.viewer.motion.ticks - 1
    wall.panel.pause.bind()
    wall.wait()
    for _ in wall.viewer.advance(before_it):
        while wall.viewer.wants_tick():
            newton_cradle_tick(wall.viewer.cradle.pend_list, R_PARAM, DT, G, approaching_only=True)
    press(wall.viewer.table.tick, wall)
    [call] = [line for line in shown_tick(wall) if line.startswith("handle_collision")]
    omega = f"{of(reference, 'omega')[1]:.6g}"
    assert (
        call
        == f"handle_collision(e=1, omega1={omega}, omega2=0, m1=1, m2=1, r_param={R_PARAM:g}) returned (0, {omega})"
    )
    assert of(wall, "omega") == of(reference, "omega")  # to see it changes nothing


def test_one_tick_works_only_while_paused(wall):
    assert wall.viewer.table.tick.disabled
    press(wall.viewer.table.tick, wall)
    assert shown_tick(wall) == []
    wall.panel.pause.bind()
    wall.wait()
    assert not wall.viewer.table.tick.disabled


def test_one_tick_of_the_double_cradle_shows_its_collisions(csv):
    csv.write_text(HEADER + GOOD * 2)
    wall = Wall(csv, 45, 20, kind=LiveDoubleCradle)
    wall.panel.pause.bind()
    wall.wait()
    for _ in range(4000):
        press(wall.viewer.table.tick, wall)
        if "returned" in shown_tick(wall)[3]:
            break
    call = f"handle_two_double_bobs(pend1=pend_list[0], pend2=pend_list[1], r_param={R_PARAM:g}, approaching_only=True)"
    assert shown_tick(wall)[3] == f"{call} returned True"
    assert len(re.findall("->", shown_tick(wall)[1])) == 4


def test_a_student_without_handle_collision_sees_the_tick_too(wall, monkeypatch):
    monkeypatch.delattr(visualize_cradle_run, "handle_collision")
    wall.panel.pause.bind()
    wall.wait()
    press(wall.viewer.table.tick, wall)
    assert shown_tick(wall)[-1] == "handle_collision was not called."
