"""The sound of a hit, at the loudspeaker."""

from pages import bob_angles, pause
from programs import wait_until


def test_a_faster_hit_is_louder_and_only_if_you_ask_for_sound(shared):
    wait_until(lambda: bob_angles(shared)[4] > 15)  # there was a hit
    assert shared.evaluate("peak()") is None
    shared.evaluate("one('#sound').checked = true")  # as Firefox does after F5
    shared.keyboard.press("v")
    shared.wait_for_function("() => peak() > 0.1")  # a hit of the cradle
    pause(shared)
    peaks = []
    for speed in (0.1, 2, 100):
        shared.wait_for_function("peak() === 0")
        shared.evaluate("speed => { state.sound = { speed }; update('sound'); }", speed)
        peaks.append(shared.wait_for_function("peak()").json_value())
    slow, fast, fastest = peaks
    assert 0 < slow < 0.8 * fast
    assert fastest < 1.2 * fast
    shared.get_by_role("checkbox", name="Sound").uncheck()
    shared.wait_for_function("() => audio.state === 'suspended'")
