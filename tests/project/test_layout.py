"""The layout of the page in each state, at each size, in and out of Present."""

import pytest
from layout_rules import FAULTS
from pages import pause, press, slide, tick
from whole_cradles import FIVE_CSV, GOOD

PHONE, TABLET = (390, 844), (768, 1024)
WIDE = (1024, 768), (1280, 720), (1366, 768), (1600, 900), (1920, 1080), (2560, 1440)
LONGEST = "A light one hits heavy ones"  # the experiment with the longest texts

# For each state: the boxes that are ticked, and what shows that the page is in it.
STATES = {
    "asking": (["Predict first"], ".answers"),
    "counted": (["Predict first"], ".more:text('10 hands')"),
    "answered": (["Predict first"], ".question :text('What happened')"),
    "arrows": (["Arrows"], ".momenta :text-is('9')"),
    "measure": (["Measure"], ".readout :text('half swings')"),
    "slow hits": (["Arrows", "Slow hits"], ".hit-part strong"),
    "both": (["Arrows", "Measure", "Predict first"], ".question :text('What happened')"),
    "error": ([], ".error:text('line 7, column mass')"),
}


@pytest.mark.parametrize("state", STATES)
def test_each_part_has_its_place(whole, file, state):
    boxes, sign = STATES[state]
    if state == "error":
        file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    for name in boxes:
        tick(whole, name)
    if "Predict first" in boxes:
        press(whole, LONGEST)
    elif boxes:
        slide(whole, "Bobs", 9)
    if state in ("counted", "answered", "both"):
        count_hands(whole)
    if state in ("answered", "both"):
        whole.keyboard.press("a")
    whole.locator(sign).first.wait_for(state="attached")
    if state not in ("asking", "counted"):
        pause(whole)
    faults = []
    for mode in ("page", "Present"):
        for width, height in (PHONE, TABLET, *WIDE):
            whole.set_viewport_size({"width": width, "height": height})
            faults += [f"{width} x {height}, {mode}: {fault}" for fault in whole.evaluate(FAULTS)]
        whole.keyboard.press("f")
    assert not faults, "\n".join(faults)


def count_hands(page):
    """Press the buttons of the hands for the answers A and C; without Present they are hidden."""
    buttons = page.locator(".hands.more")
    for answer, hands in ((0, 1), (2, 10)):
        for _ in range(hands):
            buttons.nth(answer).dispatch_event("click")
