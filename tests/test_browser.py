"""The program as a person meets it: VPython itself, a page in Chromium, Ctrl+C and closed tabs."""

import logging
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
from collections import Counter
from contextlib import contextmanager
from importlib.machinery import PathFinder
from math import hypot

import pytest
from cradles import copy_project, FIVE_CSV, ROOT

from support.constants import R_PARAM
from support.page import is_worth_showing

PROGRAM = ROOT / "src" / "visualize_cradle_run.py"
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
ARGUMENTS = [
    *("--no-sandbox", "--no-first-run", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    "--disable-gpu-compositing",  # without a graphics card it is what slows everything, thirty times
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
]
SECONDS = 60  # after which something that is waited for counts as never coming

# The bobs' positions, as the page has them.
BOBS = "() => glowObjs.filter(o => o && o.constructor.name === 'sphere').map(o => [o.pos.x, o.pos.y])"

pytestmark = [
    pytest.mark.skipif(PathFinder.find_spec("vpython") is None, reason="VPython is not installed"),
    pytest.mark.skipif(os.name != "posix", reason="programs are sent signals as on Linux and macOS"),
]


@contextmanager
def running(program=None, **environment):
    """Start the program as a user would, from another folder; yield the process, and end it in any case."""
    environment = {**os.environ, "VPYTHON_NO_LAUNCH_BROWSER": "1", **environment}
    environment.pop("PYTHONUNBUFFERED", None)  # it must not wait for a full buffer with what it has to say
    process = subprocess.Popen(
        [sys.executable, str(program or PROGRAM)],
        cwd=os.sep,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    patience = threading.Timer(2 * SECONDS, process.kill)
    patience.start()
    try:
        yield process
    finally:
        patience.cancel()
        process.kill()
        process.communicate()


@pytest.fixture
def program(tmp_path):
    """The program in a project of its own, with five equal bobs, whatever has become of the shipped CSV."""
    return copy_project(tmp_path, FIVE_CSV) / "src" / PROGRAM.name


def first_lines(process):
    """Return the address of the page, from what the program prints before it waits for a browser."""
    address = re.search(r"http://localhost:\d+", process.stdout.readline())[0]
    assert "Ctrl+C" in process.stdout.readline()
    return address


def end(process):
    """Wait until the program ends by itself; return its status, and what else it has printed on stdout and stderr."""
    stdout, stderr = process.communicate(timeout=SECONDS)
    return process.returncode, stdout, stderr


QUIETLY = (0, "", "")


@pytest.fixture(scope="module")
def browser():
    playwright = pytest.importorskip("playwright.sync_api")
    if CHROMIUM is None:
        pytest.skip("Chromium is not installed")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield browser
        browser.close()


@pytest.fixture
def page(browser):
    page = browser.new_page(viewport={"width": 1000, "height": 700})
    page.set_default_timeout(SECONDS * 1000)
    yield page
    page.close()


def open_cradle(page, address):
    """Open the page, wait until it has five bobs, and make its canvas small: it is drawn without a graphics card."""
    page.goto(address)
    page.wait_for_function(f"() => window.glowObjs && ({BOBS})().length === 5")
    page.evaluate("() => Object.assign(glowObjs[0], {width: 320, height: 200})")


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
    """Rails, posts and base; light and camera as the scenery sets them; and the axles in the middle of the view."""
    with running(program) as process:
        open_cradle(page, first_lines(process))
        kinds = Counter(page.evaluate("() => glowObjs.filter(o => o).map(o => o.constructor.name)"))
        assert (kinds["box"], kinds["cylinder"], kinds["sphere"]) == (5 + 1, 5 + 6, 5)
        scene = page.evaluate("() => (s => [s.fov, s.lights.length, s.center.x, s.background.x])(glowObjs[0])")
        assert scene == pytest.approx([0.25, 2, -0.1 + R_PARAM / 4 * 2, 241 / 255])


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


def test_the_page_loads_while_a_browser_holds_an_idle_connection(page, program):
    """Browsers open connections in advance; VPython's own server would answer no one else until it gets a request."""
    with running(program) as process:
        address = first_lines(process)
        with socket.create_connection(("localhost", int(address.rpartition(":")[2])), timeout=SECONDS):
            open_cradle(page, address)


def test_ctrl_c_ends_it_while_the_page_is_open(page, program):
    with running(program) as process:
        open_cradle(page, first_lines(process))
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_what_a_browser_asks_for_in_vain_is_no_news():
    """VPython's request handler then prints a traceback, on a screen that is for the user."""
    with running() as process:
        port = int(first_lines(process).rpartition(":")[2])
        with socket.create_connection(("localhost", port), timeout=SECONDS) as connection:
            connection.sendall(b"GET /nothing.js HTTP/1.0\r\n\r\n")
            while connection.recv(1000):
                pass
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def test_only_talking_to_a_closing_tab_is_no_news():
    """A student's own error in VPython's thread is shown, a connection lost in the middle of a message is not."""

    class Disconnected(RuntimeError):  # noqa: N818
        """As autobahn's, which VPython's websocket raises."""

    def is_shown(error):
        return is_worth_showing(logging.makeLogRecord({"exc_info": (type(error), error, None)}))

    assert is_worth_showing(logging.makeLogRecord({}))
    assert is_shown(ValueError("a student's own"))
    assert not is_shown(Disconnected("Attempt to send on a closed protocol"))


def test_ctrl_c_ends_it_while_it_waits_for_a_browser():
    with running() as process:
        first_lines(process)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY


def refusal(process):
    """Return the one line on stderr with which the program refuses to start."""
    status, stdout, stderr = end(process)
    assert (status, stdout) == (2, "")
    assert stderr.count("\n") == 1
    return stderr


def test_a_taken_port_is_refused():
    with socket.socket() as other:
        other.bind(("", 0))
        other.listen()
        port = str(other.getsockname()[1])
        with running(VPYTHON_HTTP_PORT=port) as process:
            assert f"VPYTHON_HTTP_PORT: port {port} cannot be had: " in refusal(process)


@pytest.mark.parametrize("port", ["web", "-1", "65536", ""])
def test_what_is_no_port_is_refused(port):
    with running(VPYTHON_HTTP_PORT=port) as process:
        line = f"VPYTHON_HTTP_PORT: found {port!r}, allowed is a port number from 0 to 65535\n"
        assert refusal(process) == line


def test_the_port_asked_for_is_used():
    with socket.socket() as probe:
        probe.bind(("", 0))
        port = probe.getsockname()[1]
    with running(VPYTHON_HTTP_PORT=str(port)) as process:
        assert first_lines(process) == f"http://localhost:{port}"


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
