"""What a class sees and hears: colors, shadows, pictures, words."""

import pages
import pytest
from pages import pause, press, slide, slider_texts, wait_for_angles, wait_for_time
from programs import wait_until
from shared_page import wait_for_text
from whole_cradles import HEADER

from support.constants import R_PARAM

COLORS = ["black", "white", "red", "green", "blue", "yellow", "cyan", "magenta", "orange", "purple"]

# The contrast (as WCAG 2 defines it) of the cradle's picture with the page, at many points of a
# circle: the median, for each of these circles.
CONTRASTS = """circles => {
    scene().__renderer.render(0);
    const { width, height } = one(".canvas canvas");
    const copy = make("canvas", { width, height });
    const pen = copy.getContext("2d", { willReadFrequently: true });
    pen.drawImage(one(".canvas canvas"), 0, 0);
    const linear = part => part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
    const light = (x, y) => {
        const [r, g, b] = [...pen.getImageData(x, y, 1, 1).data].map(part => linear(part / 255));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const page = light(2, height - 2);
    return circles.map(([x, y, radius]) => {
        const contrasts = [];
        for (let angle = 0; angle < 2 * Math.PI; angle += 0.1) {
            const point = light(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
            contrasts.push((Math.max(point, page) + 0.05) / (Math.min(point, page) + 0.05));
        }
        return contrasts.sort((a, b) => a - b)[contrasts.length >> 1];
    });
}"""

# The places (m) of the shadows that are visible, from left to right: one for each bob and layer.
SHADOWS = """() => scene().objects
    .filter(shape => kindOf(shape) === "cylinder" && !shape.pickable)
    .map(disc => disc.pos.x)"""


@pytest.fixture
def large(whole):
    """The page in a large window, with its whole canvas."""
    whole.set_viewport_size({"width": 1366, "height": 768})
    wait_until(lambda: whole.evaluate("glowObjs[0].width") > 700)
    return whole


def test_each_color_stands_out_from_the_page_with_a_contrast_of_3(large, file):
    """By its edge or its middle: a yellow bob has a dark edge."""
    file.write_text(HEADER + "".join(f"1,1,0,0,{color},metal\n" for color in COLORS))
    pages.wait_for_cradle(large, bobs=10)
    slide(large, "Bobs lifted", 0)
    wait_for_angles(large, *[0] * 10)
    pages.draw(large, True)
    large.wait_for_function("() => bobs().every(bob => bob.ready)")
    middles = [pages.pixel(large, bob, 0) for bob in range(10)]
    radius = (middles[1][0] - middles[0][0]) / 2.1
    edges = [[*middle, 0.92 * radius] for middle in middles]
    insides = [[*middle, 0.4 * radius] for middle in middles]
    axle_x, axle_y = pages.axle(0)
    x, y = large.evaluate(pages.PIXEL, [axle_x, axle_y - R_PARAM / 2])
    cord = [[x + aside, y, 0] for aside in (-1, 0, 1)]  # it is two pixels wide
    contrasts = large.evaluate(CONTRASTS, [*edges, *insides, *cord])
    best = map(max, contrasts[:10], contrasts[10:20])
    for color, contrast in zip([*COLORS, "cord"], [*best, max(contrasts[20:])], strict=True):
        assert contrast >= 3, color


def test_shadows_are_under_the_bobs(shared):
    press(shared, "Pause")
    pages.draw(shared, True)
    shared.wait_for_function(f"() => ({SHADOWS})().length")
    pages.draw(shared, False)
    for lifted in (1, 5):
        shared.evaluate("lifted => set('lifted', lifted)", lifted)
        wait_for_angles(shared, *[-45] * lifted, *[0] * (5 - lifted))
        places = shared.evaluate("() => bobs().map(bob => bob.pos.x)")
        layers = [place for place in places for _ in range(4)]
        wait_until(lambda layers=layers: shared.evaluate(SHADOWS) == layers)


def test_an_experiment_is_chosen_by_its_picture_which_says_that_it_was_changed(shared):
    tile = shared.locator(".gallery button[title='Two bobs']")
    pages.choose(shared, "Two bobs")
    wait_until(lambda: tile.get_attribute("aria-pressed") == "true")
    assert shared.evaluate("document.activeElement === document.body")  # Space pauses
    circles = tile.locator("circle").evaluate_all("found => found.map(e => +e.getAttribute('cx'))")
    first, second, *hanging = circles
    assert first < second < 0  # to the left of the first axle
    assert hanging == sorted(hanging)
    slide(shared, "Bobs lifted", 3)
    shared.locator(".choose").get_by_text("Two bobs, changed").wait_for()


def test_sliders_of_the_bobs_say_in_words_what_they_change(shared):
    """What is refused is in the table, which then opens."""
    slide(shared, "Bob 1: mass", 5)
    wait_until(lambda: slider_texts(shared, "mass") == ["5 kg"])
    word = shared.get_by_text("Bobs", exact=True)
    assert word.get_attribute("title").startswith("Bobs: the balls")
    shared.evaluate("send('edit', 0, 'mass', '-1')")
    wait_for_text(shared, "mass: allowed is a number from ")


def test_the_cradle_in_a_sentence_is_told_when_you_pause_or_ask_never_by_itself(shared):
    summary = shared.get_by_role("status").and_(shared.locator(".summary"))
    before = summary.text_content()
    wait_for_time(shared)
    assert summary.text_content() == before
    shared.keyboard.press("t")
    wait_until(lambda: " degrees " in summary.text_content() != before)
    pause(shared)
    wait_until(lambda: summary.text_content() == shared.evaluate("state.summary"))
