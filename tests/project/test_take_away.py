"""The fold Take away: a picture, a film and the data as downloads, and the command for the same cradle, in Chromium."""

import csv
import re
import shlex
from base64 import b64encode
from itertools import pairwise
from pathlib import Path

import pytest
from pages import ANGLE, LIFTED, lifts, menu, slide, values, wait_for_lifts
from programs import (
    copy_project,
    first_lines,
    needs_vpython,
    new_page,
    open_cradle,
    pause,
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

# How many colors a picture has, and whether the numbers on the axles are in it, where they are on the canvas.
LOOK = """const look = image => {
    const pixels = source => {
        const paper = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
        paper.drawImage(source, 0, 0, width, height);
        return [...new Uint32Array(paper.getImageData(0, 0, width, height).data.buffer)];
    };
    const labels = glowObjs[0].__overlay_element, { width, height } = labels;
    const light = pixel => (pixel & 255) + (pixel >> 8 & 255) + (pixel >> 16 & 255);
    const seen = pixels(image), ink = pixels(labels).map((pixel, i) => [pixel, seen[i]]);
    const inked = ink.filter(([pixel]) => pixel >>> 24 > 250);
    const alike = inked.filter(([pixel, other]) => Math.abs(light(pixel) - light(other)) < 90);
    const shares = { inked: inked.length, labels: alike.length / inked.length };
    return { width, height, colors: new Set(seen).size, ...shares, seen };
};"""

PICTURE = f"""async address => {{
    {LOOK}
    const image = Object.assign(new Image(), {{ src: address }});
    await image.decode();
    return {{ ...look(image), seen: null, size: [image.naturalWidth, image.naturalHeight] }};
}}"""

# Play a film to its end, or for three seconds; return the fewest colors of a look, the most labels, and the changes.
FILM = f"""async address => {{
    {LOOK}
    const film = Object.assign(document.createElement("video"), {{ src: address, muted: true }});
    await new Promise((resolve, reject) => Object.assign(film, {{ onloadeddata: resolve, onerror: reject }}));
    await film.play();
    let changes = 0, before = [], colors = Infinity, labels = 0;
    for (const start = performance.now(); !film.ended && performance.now() - start < 3000;) {{
        await new Promise(resolve => setTimeout(resolve, 100));
        const now = look(film);
        if (now.seen.some((pixel, i) => pixel !== before[i])) changes++;
        [before, colors, labels] = [now.seen, Math.min(colors, now.colors), Math.max(labels, now.labels)];
    }}
    const size = [film.videoWidth, film.videoHeight];
    return {{ colors, labels, size, changes, seconds: film.currentTime }};
}}"""


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A page whose fold is open, with five bobs; it may use the clipboard. And the folder of its program."""
    program = copy_project(tmp_path_factory.mktemp("taken"), FIVE_CSV) / "src" / PROGRAM.name
    permissions = ["clipboard-read", "clipboard-write"]
    with (
        running(
            program, "--angle", "33.3", "--e", "0.9", "--mass", "2", folder=program.parent, patience=60 * SECONDS
        ) as process,
        new_page(chromium, permissions=permissions) as page,
    ):
        open_cradle(page, first_lines(process))
        page.get_by_text("Take away").click()
        yield page, program.parent


@pytest.fixture
def shared(started):
    return started[0]


@pytest.fixture
def folder(started):
    return started[1]


def download(page, button):
    """Press this button; return the name and the content of the file that comes."""
    with page.expect_download() as coming:
        page.get_by_role("button", name=button).click()
    return coming.value.suggested_filename, Path(coming.value.path()).read_bytes()


def address_of(content, kind):
    """Return an address under which a page finds this content."""
    return f"data:{kind};base64,{b64encode(content).decode()}"


def test_a_picture_is_the_canvas_with_its_numbers(shared):
    name, content = download(shared, "Picture")
    assert name == "newtons_cradle.png"
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    picture = shared.evaluate(PICTURE, address_of(content, "image/png"))
    assert picture["size"] == [picture["width"], picture["height"]]
    assert picture["colors"] > 500
    assert picture["inked"] > 20
    assert picture["labels"] > 0.9


def test_a_film_shows_the_motion_and_the_numbers_in_a_window_that_changes(shared):
    button = shared.locator(".film")
    shared.keyboard.press("Tab")
    while not button.evaluate("button => button === document.activeElement"):
        shared.keyboard.press("Tab")
    shared.keyboard.press("Enter")
    size = shared.evaluate("[glowObjs[0].width & ~1, glowObjs[0].height & ~1]")
    shared.get_by_role("button", name=re.compile(r"Stop film \(\d+ s\)")).wait_for()
    assert button.evaluate("button => getComputedStyle(button, '::before').content") == '"●"'
    shared.set_viewport_size({"width": 300, "height": 300})
    wait_until(lambda: shared.evaluate("[glowObjs[0].width, glowObjs[0].height]") == [300, 144])
    shared.set_viewport_size({"width": 1000, "height": 700})
    wait_until(lambda: shared.evaluate("[glowObjs[0].width & ~1, glowObjs[0].height & ~1]") == size)
    shared.get_by_role("button", name=re.compile(r"Stop film \(([4-9]|\d\d+) s\)")).wait_for()
    name, content = download(shared, "Stop film")
    assert name == "newtons_cradle.webm"
    assert content.startswith(b"\x1a\x45\xdf\xa3")
    film = shared.evaluate(FILM, address_of(content, "video/webm"))
    assert film["size"] == size
    assert film["colors"] > 500  # in each look: no picture is empty
    assert film["labels"] > 0.7  # a film is not exact
    assert film["changes"] > 3
    assert film["seconds"] > 1
    assert button.inner_text() == "Film"


def test_the_data_are_those_that_the_program_saves(shared, folder):
    """They come from the program's own server; the cradle swings on."""
    press(shared, "Restart")
    wait_until(lambda: readout(shared, "t") > 1)
    assert download(shared, "Data (CSV)")[0] == "cradle_data.csv"
    t = readout(shared, "t")
    wait_until(lambda: readout(shared, "t") > t)
    pause(shared)
    _, content = download(shared, "Data (CSV)")
    press(shared, "Save data")
    shared.locator(".saved", has_text="rows are in").wait_for()
    assert content == (folder / "cradle_data_1.csv").read_bytes()
    header, *rows = csv.reader(content.decode().splitlines())
    assert [header[0], header[-1], len(header)] == ["t", "momentum", 15]
    times = [float(row[0]) for row in rows]
    assert times[0] == 0
    assert times[-1] == pytest.approx(readout(shared, "t"), abs=0.011)
    assert {round(b - a, 9) for a, b in pairwise(times)} == {0.01}
    press(shared, "Run")


def test_the_command_starts_the_same_cradle_again(shared, folder, chromium):
    shared.locator(".ui-slider").first.scroll_into_view_if_needed()
    slide(shared, LIFTED, 0.38)
    slide(shared, ANGLE, 0.4)
    wait_until(lambda: values(shared)[LIFTED] == "2 of 5" and values(shared)[ANGLE] not in ("33.3°", "90°"))
    menu(shared, "Collisions").select_option("inelastic, e = 0")
    shared.get_by_text("Advanced").click()
    shared.get_by_role("checkbox", name="Separating").check()
    wait_until(lambda: "--separating" in shared.locator(".command").inner_text())
    press(shared, "Copy command")
    shared.get_by_text("Copied.").wait_for()
    command = shared.evaluate("navigator.clipboard.readText()")
    assert command == shared.locator(".command").inner_text()
    python, program, *arguments = shlex.split(command)
    assert (folder / program).samefile(folder / PROGRAM.name)
    pause(shared)
    with (
        running(folder / program, *arguments, "--no-browser", folder=folder, python=python) as process,
        new_page(chromium) as again,
    ):
        open_cradle(again, first_lines(process))
        pause(again)
        press(again, "Restart")
        lifted = -float(values(shared)[ANGLE].rstrip("°"))
        wait_for_lifts(again, lifted, lifted, 0, 0, 0)
        assert values(again) == values(shared)
        assert menu(again, "Collisions").input_value() == "inelastic, e = 0"
        again.get_by_text("Advanced").click()
        assert again.get_by_role("checkbox", name="Separating").is_checked()
        again.get_by_text("Take away").click()
        assert again.locator(".command").inner_text() == f"{command} --no-browser"
    assert len(lifts(shared)) == 5


def test_a_browser_that_can_do_less_says_so(shared):
    """The last test of the page: no recorder, and no access to the clipboard."""
    shared.add_init_script("delete window.MediaRecorder; navigator.clipboard.writeText = () => Promise.reject();")
    shared.reload()
    wait_for_cradle(shared)
    shared.get_by_text("Take away").click()
    film = shared.get_by_role("button", name="Film")
    assert film.is_disabled()
    assert film.get_attribute("title") == "This browser cannot record a film."
    press(shared, "Copy command")
    shared.get_by_text("Press Ctrl+C to copy it.").wait_for()
    assert shared.evaluate("getSelection().toString().trim()") == shared.locator(".command").inner_text()
