"""That each part has its place and its size, in each state and size of the page, and in Present."""

import pages
import pytest
from pages import choose, pixel, press, slide, tick
from programs import wait_until
from shared_page import edges, is_whole
from whole_cradles import FIVE_CSV, GOOD

PHONE = (390, 844)
IN_A_COURSE_PAGE = (700, 200)
BOARD = (2560, 1440)
SIZES = [PHONE, (1024, 768), (1366, 768), (1920, 1080)]
LONGEST = "A light one hits heavy ones"  # the experiment with the longest texts

# For each state: the boxes that are ticked, and what shows that the page is in it.
STATES = {
    "asked": (["Ask"], ".answers"),
    "explained": (["Ask", "Arrows", "Momenta", "Measure"], ":text('What happened')"),
    "slow hits": (["Arrows", "Slow hits"], ".hits td"),
    "error": ([], ".error:text('line 7, column mass')"),
}


@pytest.mark.parametrize("state", STATES)
def test_each_part_has_its_place(whole, file, state):
    get_into(whole, file, state)
    faults = []
    for mode in ("page", "Present"):
        for size in SIZES:
            set_size(whole, size)
            faults += [f"{size}, {mode}: {fault}" for fault in whole.evaluate("faults()")]
        whole.keyboard.press("f")
    assert not faults, "\n".join(faults)


def get_into(page, file, state):
    """Bring the page into this state."""
    boxes, sign = STATES[state]
    if state == "error":
        file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    for name in boxes:
        tick(page, name)
    if state in ("asked", "explained"):
        choose(page, LONGEST)
    else:
        slide(page, "Bobs", 9)
    if state == "explained":
        page.locator(".choice").first.click()
        page.get_by_text("What did you see?").wait_for()
        page.locator(".choice").last.click()
    if state == "slow hits":
        press(page, "Next hit")
    page.locator(sign).first.wait_for(state="attached")


def set_size(page, size):
    page.set_viewport_size({"width": size[0], "height": size[1]})


def resize(page, size):
    """Make the window this large (pixels), and wait until the canvas has followed."""
    set_size(page, size)
    wait_until(lambda: page.evaluate("scene().width") == round(edges(page, ".canvas")[2]))


@pytest.mark.parametrize("size", [PHONE, IN_A_COURSE_PAGE])
def test_the_whole_swing_is_in_view(whole, size):
    resize(whole, size)
    assert is_whole(whole, "canvas")
    left, _, right, bottom = edges(whole, "canvas")
    assert bottom >= min(size) / 2
    wait_until(lambda: left < pixel(whole, 0, -45)[0] < pixel(whole, 4, 45)[0] < right)


def test_on_a_phone_the_cradle_and_its_buttons_stay_in_sight(whole):
    resize(whole, PHONE)
    for name in ("Pause", "Step", "Restart"):
        assert is_whole(whole, f".controls button:has-text('{name}')")
    before = edges(whole, ".stage")
    whole.locator(".graph").scroll_into_view_if_needed()
    wait_until(lambda: whole.evaluate("scrollY") > 100)
    assert edges(whole, ".stage") == before


def test_on_a_board_the_cradle_and_the_letters_are_large_and_all_is_in_view(whole):
    resize(whole, BOARD)
    assert whole.evaluate("(e => e.scrollHeight - e.clientHeight)(one('.panel'))") == 0
    apart = pixel(whole, 4, 0)[0] - pixel(whole, 3, 0)[0]
    assert 0.95 * apart >= 60 / 1366 * BOARD[0]  # the width of a bob
    letters = "parseFloat(getComputedStyle(one('.readout')).fontSize)"
    assert whole.evaluate(letters) >= 0.022 * BOARD[1]


def test_the_text_is_as_large_as_the_reader_has_chosen_and_nothing_is_cut(driver, shared):
    """24 pixels in the settings of the browser.

    The small text follows, and the texts in the canvas.
    """
    arguments = [*pages.ARGUMENTS, "--blink-settings=defaultFontSize=24"]
    with (
        driver.chromium.launch(
            executable_path=pages.CHROMIUM, args=arguments, timeout=pages.TIMEOUT
        ) as browser,
        pages.new_page(browser) as page,
    ):
        pages.open_cradle(page, shared.url)
        for selector, size in ("body", "24px"), (".hint", "21px"):
            assert page.evaluate(f"getComputedStyle(one('{selector}')).fontSize") == size
        assert page.evaluate("scene().__overlay_objects.objects[0].height") == 21
        for size in ((1366, 768), PHONE):
            resize(page, size)
            assert page.evaluate("faults()") == []


def test_curves_keep_their_colors_where_the_system_forces_its_own(shared):
    pages.menu(shared, "Graph").select_option("Energies")
    shared.locator(".plot").get_by_text("potential").wait_for()
    shared.emulate_media(forced_colors="active")
    legend = shared.evaluate(
        "find('.legendColorBox div div').map(e => getComputedStyle(e).borderColor)"
    )
    assert len(legend) == len({*legend}) == 3
