"""What a class sees and hears: colors, shadows, pictures, words."""

import pages
import pytest
from pages import pause, slide, wait_for_angles, wait_for_time
from programs import wait_until
from whole_cradles import HEADER

from support.constants import COLOR_MAP, R_PARAM
from support.page.scene.scenery import TO_BASE


@pytest.fixture
def large(whole):
    """The page in a large window, with its whole canvas."""
    whole.set_viewport_size({"width": 1366, "height": 768})
    wait_until(lambda: whole.evaluate("glowObjs[0].width") > 700)
    return whole


def lights(page, *circles):
    """Return how light the picture is on these circles: each the x, the y and a radius (pixels)."""
    return page.evaluate("circles => lights(circles)", circles)


def test_each_color_stands_out_from_a_white_page_with_a_contrast_of_3(large, file):
    """By its edge or its middle: a yellow bob has a dark edge."""
    file.write_text(HEADER + "".join(f"1,1,0,0,{color},metal\n" for color in COLOR_MAP))
    pages.wait_for_cradle(large, bobs=10)
    slide(large, "Bobs lifted", 0)
    wait_for_angles(large, *[0] * 10)
    pages.draw(large, True)
    large.wait_for_function("() => bobs().every(bob => bob.ready)")
    middles = [pages.pixel(large, bob, 0) for bob in range(10)]
    radius = (middles[1][0] - middles[0][0]) / 2.1
    for color, middle in zip(COLOR_MAP, middles, strict=True):
        darkest = min(lights(large, [*middle, 0.92 * radius], [*middle, 0.4 * radius]))
        assert 1.05 / (darkest + 0.05) >= 3, color


def test_a_bob_has_a_shadow_which_is_paler_when_it_is_lifted(large):
    """The same wood is looked at with a bob above it, and without."""
    pause(large)
    pages.draw(large, True)
    x, y = pages.axle(0)
    below = y - TO_BASE * R_PARAM
    places = [[*pages.plane_pixel(large, x - aside, below), 0] for aside in (0, R_PARAM / 2**0.5)]

    def is_paler():
        found = []
        for lifted in (0, 1):
            large.evaluate("lifted => set('lifted', lifted)", lifted)
            wait_for_angles(large, -45 * lifted, 0, 0, 0, 0)
            found.append(lights(large, *places))
        (hanging, bare_aside), (bare, lifted) = found
        return 1.5 * hanging / bare < lifted / bare_aside < 0.9

    wait_until(is_paler)  # the shadows come after the first picture


def test_an_experiment_is_chosen_by_its_picture_which_says_that_it_was_changed(shared):
    tile = shared.locator(".gallery button[title='Two bobs']")
    pages.choose(shared, "Two bobs")
    wait_until(lambda: tile.get_attribute("aria-pressed") == "true")
    circles = tile.locator("circle").evaluate_all("found => found.map(e => +e.getAttribute('cx'))")
    first, second, *hanging = circles
    assert first < second < 0  # to the left of the first axle
    assert hanging == sorted(hanging)
    slide(shared, "Bobs lifted", 3)
    shared.locator(".choose").get_by_text("Two bobs, changed").wait_for()


def test_the_cradle_in_a_sentence_is_told_when_you_pause_or_ask_never_by_itself(shared):
    summary = shared.get_by_role("status").and_(shared.locator(".summary"))
    before = summary.text_content()
    wait_for_time(shared)
    assert summary.text_content() == before
    shared.keyboard.press("t")
    wait_until(lambda: " degrees " in summary.text_content() != before)
    pause(shared)
    wait_until(lambda: summary.text_content().endswith(shared.evaluate("state.summary")))
