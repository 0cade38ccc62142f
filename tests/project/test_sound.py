"""The sound of the hits, in Chromium: what a browser sends to the loudspeaker."""

import pytest
from pages import ANGLE, menu, slide, values
from programs import (
    copy_project,
    first_lines,
    needs_vpython,
    new_page,
    open_cradle,
    press,
    PROGRAM,
    readout,
    running,
    SECONDS,
    wait_for_cradle,
    wait_until,
)
from whole_cradles import FIVE_CSV

pytestmark = needs_vpython

LIMIT = 0.5  # of full scale

# Before the page's own scripts: note ten times a second what the loudspeaker gets, and whether the page asks for it.
# heard(since) is the largest sample since this time of the audio (s), of whole notes only; each is 0.7 s long.
LISTEN = """
const connect = AudioNode.prototype.connect, notes = [];
let tap;
AudioNode.prototype.connect = function (to, ...others) {
    if (to === this.context.destination) {
        tap = new AnalyserNode(this.context, { fftSize: 32768 });
        connect.call(this, tap);
        setInterval(() => {
            const samples = new Float32Array(tap.fftSize);
            tap.getFloatTimeDomainData(samples);
            const peak = samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
            notes.push({ from: now() - tap.fftSize / tap.context.sampleRate, peak });
        }, 100);
    }
    return connect.call(this, to, ...others);
};
const now = () => tap?.context.currentTime;
const heard = since => Math.max(0, ...notes.filter(note => note.from >= since).map(note => note.peak));
Object.assign(window, { now, heard });
"""


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A page that says what it sounds like."""
    program = copy_project(tmp_path_factory.mktemp("sound"), FIVE_CSV) / "src" / PROGRAM.name
    with running(program, "--angle", "45", patience=60 * SECONDS) as process, new_page(chromium) as page:
        page.add_init_script(LISTEN)
        open_cradle(page, first_lines(process))
        page.get_by_text("Advanced").click()
        yield page


@pytest.fixture
def shared(started):
    """This page with all as at the start, and without sound."""
    box(started).uncheck()
    menu(started, "Collisions").select_option("as in the CSV")
    slide(started, ANGLE, 0.25)
    wait_until(lambda: values(started)[ANGLE] == "45°")
    return started


def box(page):
    return page.get_by_role("checkbox", name="Sound")


def heard_for(page, seconds):
    """Return the largest sample of the next seconds."""
    since = page.evaluate("now()")
    wait_until(lambda: page.evaluate("now()") > since + seconds + 0.9)
    return page.evaluate("since => heard(since)", since)


def test_it_is_silent_and_does_nothing_until_you_ask_for_sound(shared):
    """The first test of the page: nobody has asked yet."""
    wait_until(lambda: "1-2-3-4-5" in shared.locator(".impacts").inner_text())
    wait_until(lambda: readout(shared, "t") > 1)
    assert shared.evaluate("now()") is None
    assert shared.locator(".hit").get_attribute("data-speed") is None


def test_a_faster_hit_is_louder_and_none_is_too_loud(shared):
    box(shared).check()
    heard = []
    for part, angle in ((0.028, "5°"), (0.25, "45°"), (0.834, "150°")):
        slide(shared, ANGLE, part)
        wait_until(lambda angle=angle: values(shared)[ANGLE] == angle)
        heard.append(heard_for(shared, 2))
    assert 0.1 < heard[0] < 0.8 * heard[1]
    assert heard[1] < heard[2] <= LIMIT


def test_it_stops_at_once_when_you_switch_it_off(shared):
    box(shared).check()
    wait_until(lambda: heard_for(shared, 1) > 0)
    box(shared).uncheck()
    wait_until(lambda: shared.evaluate("now()") == shared.evaluate("now()"))
    hit = shared.locator(".hit").get_attribute("data-speed")
    t = readout(shared, "t")
    wait_until(lambda: readout(shared, "t") > t + 2)
    assert shared.locator(".hit").get_attribute("data-speed") == hit


def test_very_many_hits_together_are_not_too_loud(shared):
    press(shared, "Pause")
    box(shared).check()
    wait_until(lambda: heard_for(shared, 0.1) == 0)
    since = shared.evaluate("now()")
    shared.evaluate("""async () => {
        const hit = document.querySelector(".hit").parentElement;
        for (let number = 0; number < 500; number++) {
            hit.innerHTML = '<i class="hit" data-speed="100"></i>';
            await null;
        }
    }""")
    wait_until(lambda: shared.evaluate("since => heard(since)", since) > 0)
    assert 0.4 < shared.evaluate("since => heard(since)", since) <= LIMIT
    press(shared, "Run")


def test_bobs_that_stay_together_do_not_buzz(shared):
    menu(shared, "Collisions").select_option("inelastic, e = 0")
    box(shared).check()
    press(shared, "Restart")
    assert heard_for(shared, 1) > 0.1
    wait_until(lambda: "stay together" in shared.locator(".impacts").inner_text())
    t = readout(shared, "t")
    wait_until(lambda: readout(shared, "t") > t + 1)
    assert heard_for(shared, 3) == 0


def test_after_a_reload_it_waits_for_a_click_and_then_sounds_as_before(shared):
    """The last test of the page. A browser lets no page sound that nobody has touched."""
    box(shared).check()
    wait_until(lambda: heard_for(shared, 1) > 0)
    shared.reload()
    wait_for_cradle(shared)
    wait_until(lambda: readout(shared, "t") > 1)
    assert shared.evaluate("now()") is None
    assert shared.locator(".hit").get_attribute("data-speed") is not None
    shared.get_by_text("Advanced").click()
    assert box(shared).is_checked()
    assert heard_for(shared, 2) > 0.1
    press(shared, "Pause")  # the next test needs the processor


def test_the_double_cradle_sounds_too(page, program):
    page.add_init_script(LISTEN)
    with running(program.with_name("visualize_double_cradle_run.py")) as process:
        open_cradle(page, first_lines(process), bobs=10)
        page.get_by_text("Advanced").click()
        box(page).check()
        press(page, "Restart")
        assert heard_for(page, 2) > 0.1
