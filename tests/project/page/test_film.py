"""The film of a run: which pictures it has, and at which times."""

import pytest

from support.page.film_recorder import NoTabs
from support.page.server.film import KEPT, LONGEST_PAUSE, PICTURE


@pytest.fixture
def tabs():
    """Tabs whose film has the time that a test sets."""
    return NoTabs()


def show(tabs, now, **state):
    tabs.now = now
    tabs.deliver(state, {})


def film(tabs):
    """Return the time and the state of each picture."""
    return [(picture.time, picture.changes["state"]) for picture in tabs.film.pictures]


def test_a_film_has_thirty_pictures_a_second_and_each_question_and_shortens_a_pause(tabs):
    show(tabs, 0, x=0)
    for part in (0.4, 0.8, 1.2):
        show(tabs, part * PICTURE, x=part)
    show(tabs, 1.3 * PICTURE, question="asked")
    show(tabs, 1.4 * PICTURE, x="too early")
    show(tabs, 600, question=None)
    assert film(tabs) == [
        (0, {"x": 0}),
        (1.2 * PICTURE, {"x": 1.2}),
        (pytest.approx(1.3 * PICTURE), {"question": "asked"}),
        (pytest.approx(1.3 * PICTURE + LONGEST_PAUSE), {"x": "too early", "question": None}),
    ]


def test_a_film_is_that_of_the_present_run_and_a_page_keeps_its_end(tabs):
    """It then begins with a whole picture."""
    show(tabs, -1, x="old")
    tabs.begin_film()
    for now in range(100):
        show(tabs, now, x=now)
    assert len(film(tabs)) == 100
    tabs.film.kept = KEPT
    show(tabs, 100, y="new")
    (start, state), *_, (end, _) = film(tabs)
    assert end - start == KEPT
    assert state == {"x": start}
