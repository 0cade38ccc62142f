"""The program as a person meets it: VPython itself, a page in Chromium and Firefox, Ctrl+C and closed tabs."""

import shlex
import signal
import socket
import subprocess
from collections import Counter
from math import hypot
from urllib.parse import urlsplit

import pytest
from programs import (
    BOBS,
    CHROMIUM,
    copy_project,
    end,
    first_lines,
    in_both_browsers,
    needs_vpython,
    open_cradle,
    port_in,
    PROGRAM,
    QUIETLY,
    refusal,
    running,
    SECONDS,
)

from support.constants import R_PARAM

pytestmark = needs_vpython


@in_both_browsers
def test_the_cradle_swings_until_the_tab_is_closed(page, program):
    with running(program) as process:
        open_cradle(page, first_lines(process))
        rest = [-0.1 + R_PARAM / 4 * i for i in range(5)]
        page.wait_for_function(f"() => ({BOBS})()[4][0] > {rest[4] + R_PARAM / 4}")  # the last bob has been hit
        bobs, picture = page.evaluate(BOBS), page.locator("canvas").first.screenshot()
        page.wait_for_function(f"() => ({BOBS})()[0][0] < {rest[0] - R_PARAM / 4}")  # and then the first one again
        later = page.locator("canvas").first.screenshot()
        for (x, y), axle in zip(bobs, rest, strict=True):
            assert hypot(x - axle, y - R_PARAM / 5) == pytest.approx(R_PARAM, abs=1e-9)  # all are on their cords
        assert picture != later
        assert colors(page, picture) > 100  # a picture, not a plain area
        page.close()
        assert end(process) == QUIETLY


def test_the_cradle_stands_in_its_frame(page, program):
    """Rails, posts and base; and light and camera as the scenery sets them."""
    with running(program) as process:
        open_cradle(page, first_lines(process))
        kinds = Counter(page.evaluate("() => glowObjs.filter(o => o).map(o => o.constructor.name)"))
        assert (kinds["box"], kinds["cylinder"], kinds["sphere"]) == (5 + 1, 5 + 6, 5)
        scene = page.evaluate("() => (s => [s.fov, s.lights.length, s.background.x])(glowObjs[0])")
        assert scene == pytest.approx([0.25, 2, 241 / 255])


def colors(page, picture):
    """Return how many different colors a PNG picture has; the browser decodes it."""
    return page.evaluate(
        """async bytes => {
            const image = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
            const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
            context.drawImage(image, 0, 0);
            return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
        }""",
        list(picture),
    )


def test_a_browser_without_webgl_is_offered_the_terminal_cradle(driver, page, program):
    """On the page and in the terminal; and the cradle is still there for another browser."""
    folder = program.parents[1]
    with running(program, folder=folder) as process:
        address = first_lines(process)
        with driver.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox", "--disable-3d-apis"]) as browser:
            blind = browser.new_page()
            blind.goto(address, wait_until="commit")
            words = blind.locator("main").inner_text().splitlines()
            assert "This browser cannot draw the cradle: WebGL 2 is missing or switched off." in words
            assert blind.title() == "Newton's cradle"
        complaint, _, offer = (process.stdout.readline() for _ in range(3))
        assert complaint == "Your browser cannot draw the cradle: WebGL 2 is missing or switched off.\n"
        assert offer == f"    {words[-1]}\n"
        done = subprocess.run([*shlex.split(words[-1]), "--seconds", "0.1"], cwd=folder, capture_output=True, text=True)
        assert "t = 0.10 s" in done.stdout
        open_cradle(page, address)


def test_the_page_loads_while_a_browser_holds_an_idle_connection(page, program):
    """Browsers open connections in advance; VPython's own server would answer no one else until it gets a request."""
    with running(program) as process:
        address = first_lines(process)
        with socket.create_connection(("localhost", port_in(address)), timeout=SECONDS):
            open_cradle(page, address)


def test_ctrl_c_ends_it_while_the_page_is_open(page, program):
    with running(program) as process:
        open_cradle(page, first_lines(process))
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_what_a_browser_asks_for_in_vain_is_no_news():
    """VPython's request handler then prints a traceback, on a screen that is for the user."""
    with running() as process:
        port = port_in(first_lines(process))
        with socket.create_connection(("localhost", port), timeout=SECONDS) as connection:
            connection.sendall(b"GET /nothing.js HTTP/1.0\r\n\r\n")
            while connection.recv(1000):
                pass
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_ctrl_c_ends_it_while_it_waits_for_a_browser():
    with running() as process:
        first_lines(process)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


@pytest.mark.parametrize(("options", "opened"), [([], True), (["--no-browser"], False)])
def test_a_browser_is_opened_unless_it_is_not_to_be(tmp_path, options, opened):
    """The browser here is a script that writes down where it was sent."""
    browser, visited = tmp_path / "browser", tmp_path / "visited"
    browser.write_text(f'#!/bin/sh\necho "$1" > {visited}.new && mv {visited}.new {visited}\n')
    browser.chmod(0o755)
    with running(None, *options, VPYTHON_NO_LAUNCH_BROWSER="", BROWSER=str(browser)) as process:
        address = first_lines(process)
        page = urlsplit(address)
        with socket.create_connection(("localhost", page.port), timeout=SECONDS) as connection:
            connection.sendall(f"GET /?{page.query} HTTP/1.0\r\n\r\n".encode())
            assert connection.recv(1000)  # the page is served only after the browser was sent there
        assert visited.exists() == opened
        assert not opened or visited.read_text().strip() == address


def test_what_is_no_port_is_refused():
    with running(VPYTHON_HTTP_PORT="web") as process:
        assert "'web'" in refusal(process)


def test_a_bad_csv_is_refused_before_a_browser_opens(tmp_path):
    project = copy_project(tmp_path, "mass,e,color,texture\n-1,1,red,metal\n")
    with running(project / "src" / PROGRAM.name) as process:
        assert "newton_cradle_pends.csv, line 2, column mass: found '-1'" in refusal(process)


def test_a_students_mistake_ends_it_with_a_traceback(page, program):
    """VPython's threads would keep the process alive for ever."""
    swinging = program.with_name("swinging.py")
    swinging.write_text(swinging.read_text().replace("omega_new = omega -", "omega_new = omegaa -"))
    with running(program) as process:
        page.goto(first_lines(process))
        status, _, stderr = end(process)
        assert status == 1
        assert stderr.splitlines()[-1].startswith("NameError: name 'omegaa' is not defined")
