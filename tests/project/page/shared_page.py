"""A page that tests share, with all settings put back between them."""

import signal

import pages
import programs
import pytest
from whole_cradles import FIVE_CSV


@pytest.fixture(scope="session")
def file(tmp_path_factory):
    """The CSV of the shared page."""
    project = programs.copy_project(tmp_path_factory.mktemp("shared"), FIVE_CSV)
    return project / "newton_cradle_pends.csv"


@pytest.fixture(scope="session")
def open_page(chromium, file):
    """A page with a touch screen; in the end, nothing more was printed than at the start."""
    program = file.parent / "src" / programs.PROGRAM.name
    patience = 60 * programs.SECONDS
    with (
        programs.running(
            program, "--angle", "45", folder=file.parent, patience=patience
        ) as process,
        pages.new_page(chromium, has_touch=True) as page,
    ):
        pages.open_cradle(page, programs.first_lines(process))
        yield page
        process.send_signal(signal.SIGINT)
        found = programs.end(process)
        assert found == programs.QUIETLY, found


@pytest.fixture
def shared(open_page, file):
    """The shared page as it opens: with its settings and its CSV.

    The first bob has just been released.
    """
    page = open_page
    page.mouse.up()
    if file.read_text() != FIVE_CSV:
        file.write_text(FIVE_CSV)
    page.set_viewport_size({"width": 1000, "height": 700})
    page.emulate_media(media="screen", forced_colors="none")
    page.evaluate("putBack()")
    page.wait_for_function("isBack()")
    pages.press(page, "Run")
    pages.button(page, "Pause").wait_for()  # else the page may still say that it is paused
    yield page
    # Other tests have the machine for themselves
    page.evaluate("scene().visible = false; state.paused || send('pause')")


@pytest.fixture
def whole(shared):
    """The shared page with its whole canvas, as large as it is for a user."""
    shared.evaluate("document.querySelector('#small').disabled = true")
    return shared


def edges(page, selector):
    """Return the edges of an element, in the window: left, top, right, bottom."""
    box = page.locator(selector).first.bounding_box()
    return box["x"], box["y"], box["x"] + box["width"], box["y"] + box["height"]


def is_whole(page, selector):
    """Return whether an element is in the window as a whole."""
    left, top, right, bottom = edges(page, selector)
    size = page.viewport_size
    return 0 <= left < right <= size["width"] and 0 <= top < bottom <= size["height"]
