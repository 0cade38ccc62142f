"""The page itself: its messages and its scripts."""

import programs
from pages import wait_for_cradle, wait_for_moves
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
