"""The cradle in a sentence, for a screen reader."""

from pages import pause, wait_for_time
from programs import wait_until


def test_the_cradle_in_a_sentence_is_told_when_you_pause_or_ask_never_by_itself(shared):
    summary = shared.get_by_role("status").and_(shared.locator(".summary"))
    before = summary.text_content()
    wait_for_time(shared)
    assert summary.text_content() == before
    shared.keyboard.press("t")
    wait_until(lambda: " degrees " in summary.text_content() != before)
    pause(shared)
    wait_until(lambda: summary.text_content().endswith(shared.evaluate("state.summary")))
