"""The layout of the page in each state, at each size, in and out of Present."""

import pytest
from layout_rules import FAULTS
from pages import button, pause, press, slide, tick, wait_for_cradle
from whole_cradles import FIVE_CSV, GOOD

from support.files.experiments import EXPERIMENTS, read_experiments

SIZES = (
    (390, 844),  # a phone
    (768, 1024),  # a tablet
    (1024, 768),
    (1280, 720),
    (1366, 768),
    (1600, 900),
    (1920, 1080),
    (2560, 1440),
)


def length_of_texts(experiment):
    return len("".join(answer.text for answer in experiment.answers) + experiment.why)


LONGEST = max(read_experiments(EXPERIMENTS / "single", 1)[0], key=length_of_texts).name


def ask(page, file):
    tick(page, "Predict first")
    button(page, LONGEST).click()
    page.locator(".answers").wait_for()


def count(page, file):
    """Count hands: their buttons are there only in Present."""
    ask(page, file)
    page.keyboard.press("f")
    for answer, hands in (("A", 1), ("C", 10)):
        for number in range(hands):
            press(page, f"{number} hand{'' if number == 1 else 's'} for {answer}")
    button(page, "10 hands for C").wait_for()
    page.keyboard.press("f")


def answer(page, file):
    count(page, file)
    page.keyboard.press("a")
    page.locator(".question").get_by_text("What happened: ").wait_for()


def show_arrows(page, file):
    """Show the bars of as many bobs as the slider has."""
    slide(page, "Bobs", 9)
    wait_for_cradle(page, bobs=9)
    tick(page, "Arrows")
    page.locator(".track").first.wait_for()


def measure(page, file):
    tick(page, "Measure")
    page.locator(".readout").get_by_text("half swings").wait_for()


def show_slow_hits(page, file):
    show_arrows(page, file)
    tick(page, "Slow hits")
    page.locator(".hit-part strong").wait_for()


def show_all(page, file):
    show_arrows(page, file)
    measure(page, file)
    answer(page, file)


def make_a_mistake(page, file):
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    page.locator(".error").first.get_by_text("line 7, column mass").wait_for()


STATES = {
    "asking": ask,
    "counted": count,
    "answered": answer,
    "arrows": show_arrows,
    "measure": measure,
    "slow hits": show_slow_hits,
    "both": show_all,
    "error": make_a_mistake,
}


@pytest.fixture
def wide(shared):
    """The shared page, with the whole place of the cradle."""
    shared.evaluate("document.querySelector('#small').disabled = true")
    yield shared
    if shared.get_by_role("checkbox", name="Measure").is_checked():
        shared.get_by_role("checkbox", name="Measure").uncheck()
    shared.evaluate("document.querySelector('#small').disabled = false")


@pytest.mark.parametrize("state", STATES)
def test_each_part_has_its_place(wide, file, state):
    STATES[state](wide, file)
    if state not in ("asking", "counted"):
        pause(wide)
    faults = []
    for mode in ("page", "Present"):
        for width, height in SIZES:
            wide.set_viewport_size({"width": width, "height": height})
            for fault in wide.evaluate(FAULTS):
                faults.append(f"{width} x {height}, {mode}: {fault}")
        wide.keyboard.press("f")
    assert not faults, "\n".join(faults)
