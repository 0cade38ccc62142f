"""The table of the pendula, and the CSV that it saves."""

import pages
import pytest
from pages import pause, press, violations
from programs import wait_until
from rig import Rig
from whole_cradles import FIVE_CSV

from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle


def test_the_table_shows_pend_list_as_it_is_now(rig):
    rig.wait(0.3)
    expected = {key: [*map(str, rig.values(key))] for key in ("mass", "e")}
    for key in ("theta", "omega"):
        expected[key] = [f"{number:.6f}" for number in rig.values(key)]
    titles = [title for title, *_ in rig.state["columns"]]
    assert dict(zip(titles, rig.state["cells"], strict=True)) == expected


def test_the_cradle_of_an_edited_cell_has_the_masses_and_e_that_are_shown(rig, csv):
    """They came from a slider: nothing else may change with the edit. The sliders show it, too."""
    rig.give("e", 0)
    rig.give("edit", 0, "mass", 12.5)  # beyond the end of its slider
    assert rig.bob_angles() == [30, 0, 0, 0, 0]
    rig.give("edit", 4, "e", 0.5)
    assert rig.values("mass") == [12.5, 1, 1, 1, 1]
    assert rig.values("e") == [0, 0, 0, 0, 0.5]
    assert rig.control("mass")["text"] == "12.5 kg"
    assert rig.control("e")["text"] == "0 to 0.5"
    assert csv.read_text() == FIVE_CSV


@pytest.mark.parametrize(
    ("line", "name", "text"),
    [
        ("pend_list[1]['e'] = 0.5", "e", "0.5 to 1"),
        ("pend_list[0]['mass'] = 2", "mass", "2 kg"),
        ("pend_list.pop()", "count", "4"),
    ],
)
def test_what_the_program_sets_itself_cannot_be_changed_and_says_so(csv, write, line, name, text):
    write("make_newton_cradle", line)
    rig = Rig(csv)
    text += ", set by the program"
    assert rig.control(name) == rig.control(name) | {"enabled": False, "text": text}
    assert not any(limits for title, limits, _ in rig.state["columns"] if title == name)


# --- Save as CSV ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "name"),
    [(Cradle, "My cradle"), (Cradle, "A soft hit"), (DoubleCradle, "My cradle")],
)
def test_the_saved_csv_makes_the_same_cradle_and_has_no_angles(csv, tmp_path, kind, name):
    angles = [30] * kind.cord_count
    rig = Rig(csv, *angles, kind=kind)
    rig.give("experiment", name)
    rig.give("edit", 1, "mass", 2.5)
    rig.wait(0.1)
    rig.give("save_csv", 0.25)
    answer = rig.state["saved_csv"]
    assert (answer["ticket"], answer["mistake"]) == (0.25, "")
    assert csv.read_text() == FIVE_CSV
    saved = tmp_path / "saved.csv"
    saved.write_text(answer["text"])
    columns = answer["text"].split("\n")[0].split(",")
    assert columns == ["mass", "e", "color", "texture"]
    again = Rig(saved, *angles, kind=kind)
    assert [*map(again.values, columns)] == [*map(rig.values, columns)]


def test_a_write_to_csv_that_fails_is_told_and_the_cradle_swings_on(rig, monkeypatch):
    monkeypatch.setattr("src.pds_helper.write_to_csv", lambda rows, file: rows[0].pop("theta"))
    rig.wait(0.3)
    rig.give("save_csv", 1)
    assert rig.state["saved_csv"]["mistake"].startswith("KeyError: 'theta' (")
    assert rig.time() > 0.2
    assert "theta" in rig.cradle.pend_list[0]


def test_the_table_shows_theta_and_takes_a_mass_and_saves_a_csv(shared):
    mass = shared.get_by_label("mass of pend_list[1]", exact=True)
    shared.locator(".bobs summary").click()
    pause(shared)
    press(shared, "Restart")
    theta = shared.locator(".pendula td:nth-child(4)").first
    wait_until(lambda: theta.inner_text() == "-0.785398")
    for text, message in (("-3", "Type a number from 0.001 to 1000."), ("2,5", "")):
        mass.fill(text)
        mass.press("Tab")
        assert mass.evaluate("field => field.validationMessage") == message
    wait_until(lambda: mass.input_value() == "2.5")
    assert violations(shared) == {}
    name, path = pages.saved(shared, "Save as CSV")
    assert name == "My cradle.csv"
    assert path.read_text().splitlines()[2] == "2.5,1.0,red,metal"
