"""That each part has its place, in each state and size of the page, in and out of Present."""

import pytest
from layout_rules import FAULTS
from pages import choose, pause, slide, tick
from whole_cradles import FIVE_CSV, GOOD

PHONE, TABLET = (390, 844), (768, 1024)
WIDE = (1024, 768), (1366, 768), (1920, 1080), (2560, 1440)
LONGEST = "A light one hits heavy ones"  # the experiment with the longest texts

# For each state: the boxes that are ticked, and what shows that the page is in it.
STATES = {
    "asked": (["Predict first"], ".answers"),
    "seen": (["Say what you saw", "Predict first"], ":text('What did you see')"),
    "slow hits": (["Arrows", "Slow hits"], ".hit-part table"),
    "both": (["Arrows", "Measure", "Predict first"], ".question :text('What happened')"),
    "error": ([], ".error:text('line 7, column mass')"),
}


@pytest.mark.parametrize("state", STATES)
def test_each_part_has_its_place(whole, file, state):
    get_into(whole, file, state)
    faults = []
    for mode in ("page", "Present"):
        for width, height in (PHONE, TABLET, *WIDE):
            whole.set_viewport_size({"width": width, "height": height})
            faults += [f"{width} x {height}, {mode}: {fault}" for fault in whole.evaluate(FAULTS)]
        whole.keyboard.press("f")
    assert not faults, "\n".join(faults)


def get_into(page, file, state):
    """Bring the page into this state."""
    boxes, sign = STATES[state]
    if state == "error":
        file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    if "Predict first" in boxes:
        choose(page, LONGEST)
    elif boxes:
        slide(page, "Bobs", 9)
    for name in boxes:
        tick(page, name)
    if state in ("seen", "both"):
        page.locator(".choice").first.click()
    page.locator(sign).first.wait_for(state="attached")
    if state not in ("asked", "seen"):
        pause(page)
