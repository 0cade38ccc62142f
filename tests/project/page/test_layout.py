"""That each part has its place, in each state and size of the page, in and out of Present."""

import pytest
from pages import choose, press, slide, tick
from programs import wait_until
from shared_page import edges
from whole_cradles import FIVE_CSV, GOOD

PHONE = (390, 844)
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
        for width, height in SIZES:
            whole.set_viewport_size({"width": width, "height": height})
            found = whole.evaluate("faults()")
            faults += [f"{width} x {height}, {mode}: {fault}" for fault in found]
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


def test_on_a_phone_the_cradle_stays_in_sight(whole):
    whole.set_viewport_size({"width": PHONE[0], "height": PHONE[1]})
    before = edges(whole, ".stage")
    whole.locator(".graph").scroll_into_view_if_needed()
    wait_until(lambda: whole.evaluate("scrollY") > 100)
    assert edges(whole, ".stage") == before
