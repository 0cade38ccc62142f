"""The sound of a hit."""

from pages import bob_angles, pause
from programs import wait_until

# How loud each sound was that has begun
NOTE_GAINS = """() => {
    const { connect } = AudioNode.prototype;
    window.gains = [];
    AudioNode.prototype.connect = function (to) {
      if (this.gain) gains.push(this.gain.value);
      return connect.call(this, to);
    };
}"""


def test_a_faster_hit_is_louder_and_only_if_you_ask_for_sound(shared):
    shared.evaluate(NOTE_GAINS)
    wait_until(lambda: bob_angles(shared)[4] > 15)  # there was a hit
    assert shared.evaluate("gains") == []
    shared.evaluate("one('#sound').checked = true")  # as Firefox does after F5
    shared.keyboard.press("v")
    shared.wait_for_function("gains.length > 0")  # a hit of the cradle
    pause(shared)
    shared.evaluate("gains.length = 0")
    for speed in (0.1, 2, 100):
        shared.evaluate("speed => { state.sound = { speed }; update('sound'); }", speed)
    slow, fast, fastest = shared.evaluate("gains")
    assert 0 < slow < 0.8 * fast
    assert fastest == fast <= 1
    shared.get_by_role("checkbox", name="Sound").uncheck()
    shared.wait_for_function("(gains.length = 0, update('sound'), gains.length === 0)")
