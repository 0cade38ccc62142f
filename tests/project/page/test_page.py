"""The page itself: its messages, its scripts, and texts that are no HTML."""

import pages
import programs
from pages import open_cradle, wait_for_cradle, wait_for_moves
from shared_page import is_whole
from whole_cradles import FIVE_CSV, GOOD


def test_a_mistake_in_the_csv_is_shown_and_stays_in_view_until_it_is_corrected(shared, file):
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = shared.locator(".error").first
    error.get_by_text(f"{file.name}, line 7, column mass: found '-1', allowed is ").wait_for()
    shared.set_viewport_size({"width": 1000, "height": 300})
    shared.locator(".bobs summary").scroll_into_view_if_needed()
    assert is_whole(shared, ".error")  # it sticks to the top
    file.write_text(FIVE_CSV)
    error.wait_for(state="hidden")


def test_a_page_whose_script_did_not_arrive_loads_again(page, program):
    page.route("**/questions.js", lambda route: route.abort())
    with programs.running(program) as process:
        page.goto(programs.first_lines(process), wait_until="commit")
        page.get_by_text("A part of this page did not arrive.").wait_for()
        page.unroute_all(behavior="ignoreErrors")
        wait_for_cradle(page)
        wait_for_moves(page)


def test_hostile_texts_are_shown_as_texts(page, program):
    """In an experiment's name, question, answers, explanation and mistake, and in the CSV."""
    evil = "<s><img src onerror>"  # a text that makes elements, where it is HTML
    folder = program.parents[1]
    file = folder / "support" / "experiments" / "single" / "02_two_bobs.toml"
    file.write_text(file.read_text().replace("Two bobs", evil))
    file.with_name("17_bad.toml").write_text(f"name = '{evil}'\ntheta = '{evil}'")
    with programs.running(program, folder=folder) as process:
        open_cradle(page, programs.first_lines(process))
        page.get_by_text(f"17_bad.toml: theta: found '{evil}'").wait_for(state="attached")
        pages.choose(page, evil)
        page.get_by_text(f"{evil} come in.").first.wait_for()
        page.get_by_text(f"C\u2002{evil}, as far as the two").wait_for()
        page.keyboard.press("a")
        page.get_by_text("What did you see?").wait_for()
        page.keyboard.press("a")
        page.get_by_text(f"{evil} came in at").first.wait_for()
        (folder / "newton_cradle_pends.csv").write_text(FIVE_CSV.replace("red", evil, 1))
        page.get_by_text(f"found '{evil}'").wait_for()
        assert page.locator("s, [onerror]").count() == 0
