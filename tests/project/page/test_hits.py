"""The table of slow hits, in a browser; test_slow_hits.py has what it shows."""

from pages import (
    tick,
)


def test_a_slow_hit_is_in_the_table_and_a_screen_reader_hears_it(shared):
    tick(shared, "Slow hits")
    for place in (".hits .now", ".summary"):
        shared.locator(place).get_by_text("1. handle_two_bobs(pend_list[").wait_for()
