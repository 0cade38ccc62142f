"""A page that the tests of a file share, with all settings put back between them."""

import signal

import pages
import programs
import pytest
from whole_cradles import FIVE_CSV

# Put the settings back to those with which the page opens, pause, and restart the cradle.
PUT_BACK = """() => {
    send("reset");
    send("pause");
    set("ask_first", false);
    set("ask_seen", false);
    if (one("#sound").checked) one("#sound").click();
    for (const open of find("details[open]")) open.open = false;
    for (const popover of find("[popover]")) popover.hidePopover();
    if (document.documentElement.matches(".presenting")) present();
    one("#small").disabled = false;
    document.activeElement.blur();
    resetView();
    glowObjs[0].visible = false;
}"""
IS_BACK = """() => {
    const { arrows, speed, lifted, release_angle, mass, e } = state.controls;
    return !state.running && parseFloat(state.motion.t) === 0
        && !arrows.value && !state.question && bobs().length === 5
        && speed.value === 1 && lifted.value === 1 && release_angle.value === 45
        && mass.value === 1 && e.value === 1;
}"""

# Ask the question of the first experiment.
ASK = """async () => {
    set("ask_first", true);
    send("next");
    while (!state.question) await new Promise(requestAnimationFrame);
}"""

# Before the page's own scripts: peak() is the largest sample of the last 0.7 s at the loudspeaker,
# if it is in use.
LISTEN = """
const connect = AudioNode.prototype.connect;
window.peak = () => null;
AudioNode.prototype.connect = function (to, ...others) {
    if (to === this.context.destination) {
        const tap = new AnalyserNode(this.context, { fftSize: 32768 });
        const samples = new Float32Array(tap.fftSize);
        connect.call(this, tap);
        window.audio = this.context;
        window.peak = () => {
            tap.getFloatTimeDomainData(samples);
            return Math.max(...samples.map(Math.abs));
        };
    }
    return connect.call(this, to, ...others);
};"""


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """The CSV of the shared page."""
    project = programs.copy_project(tmp_path_factory.mktemp("shared"), FIVE_CSV)
    return project / "newton_cradle_pends.csv"


@pytest.fixture(scope="module")
def open_page(chromium, file):
    """A page with a touch screen; in the end, nothing more was printed than at the start."""
    program = file.parent / "src" / programs.PROGRAM.name
    patience = 60 * programs.SECONDS
    with (
        programs.running(
            program, "--angle", "45", folder=file.parent, patience=patience
        ) as process,
        pages.new_page(chromium, has_touch=True) as page,
    ):
        page.add_init_script(LISTEN)
        pages.open_cradle(page, programs.first_lines(process))
        yield page
        process.send_signal(signal.SIGINT)
        found = programs.end(process)
        assert found == programs.QUIETLY, found


@pytest.fixture
def shared(open_page, file):
    """The shared page as it opens: with its settings and its CSV.

    The first bob has just been released.
    """
    page = open_page
    page.mouse.up()
    if file.read_text() != FIVE_CSV:
        file.write_text(FIVE_CSV)
    page.set_viewport_size({"width": 1000, "height": 700})
    page.emulate_media(media="screen", forced_colors="none")
    page.evaluate(PUT_BACK)
    page.wait_for_function(IS_BACK)
    pages.press(page, "Run")
    pages.button(page, "Pause").wait_for()  # else the page may still say that it is paused
    return page


@pytest.fixture
def whole(shared):
    """The shared page with its whole canvas, as large as it is for a user."""
    shared.evaluate("document.querySelector('#small').disabled = true")
    return shared


def wait_for_text(page, text):
    page.get_by_text(text).wait_for()


# The edges of an element, in the window: left, top, right, bottom.
EDGES = "e => (r => [r.left, r.top, r.right, r.bottom])(e.getBoundingClientRect())"


def edges(page, selector):
    return page.locator(selector).first.evaluate(EDGES)


def is_whole(page, selector):
    """Return whether an element is in the window as a whole."""
    return page.locator(selector).first.evaluate("""element => {
        const { left, top, right, bottom } = element.getBoundingClientRect();
        return 0 <= left && left < right && right <= innerWidth
            && 0 <= top && top < bottom && bottom <= innerHeight;
    }""")
