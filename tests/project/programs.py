"""The programs as processes: how the suites start them, what they say first, what their page shows, how they end."""

import os
import re
import shutil
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from importlib.machinery import PathFinder
from pathlib import Path
from urllib.parse import urlsplit

import pytest

ROOT = Path(__file__).parents[2]
PROGRAM = ROOT / "src" / "visualize_cradle_run.py"
CHROMIUMS = [
    *("chromium", "chromium-browser", "google-chrome"),
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
]
CHROMIUM = next(filter(None, map(shutil.which, CHROMIUMS)), None)
FIREFOX = next(filter(None, map(shutil.which, ("firefox-esr", "firefox"))), None)
ARGUMENTS = [
    *("--no-sandbox", "--no-first-run", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    "--disable-gpu-compositing",  # without a graphics card it is what slows everything, thirty times
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
]
SECONDS = 60  # after which something that is waited for counts as never coming

# The bobs' positions, as the page has them.
BOBS = "() => glowObjs.filter(o => o && o.constructor.name === 'sphere' && o.visible).map(o => [o.pos.x, o.pos.y])"

# How often the bobs are elsewhere than before, over a third of a second.
MOVES = f"""async () => {{
    const where = () => JSON.stringify(({BOBS})());
    let before = where(), moves = 0;
    for (const start = performance.now(); performance.now() - start < 333; before = where()) {{
        await new Promise(requestAnimationFrame);
        if (where() !== before) moves++;
    }}
    return moves;
}}"""

# Wait until the program has pointed the camera at a canvas of another size: it does so before it shows three new times.
CAMERA_FOLLOWS = """async () => {
    const says = () => document.querySelector(".readout").innerText;
    for (let before = says(), changes = 0; changes < 3 && document.querySelector("button").innerText === "Pause";) {
        await new Promise(requestAnimationFrame);
        if (says() !== before) changes++, before = says();
    }
}"""

with_vpython = pytest.mark.skipif(PathFinder.find_spec("vpython") is None, reason="VPython is not installed")
on_posix = pytest.mark.skipif(os.name != "posix", reason="programs are sent signals as on Linux and macOS")
needs_vpython = [with_vpython, on_posix]


def slow_but_for(kept, values):
    """Return the values as parameters of a test; all except the kept ones have the mark slow."""
    each = {value: value if isinstance(value, tuple) else (value,) for value in values}
    assert {*kept} <= {*each}
    return [value if value in kept else pytest.param(*each[value], marks=pytest.mark.slow) for value in each]


in_both_browsers = pytest.mark.parametrize("page", ["chromium", "firefox"], indirect=True)


def copy_project(folder, csv) -> Path:
    """Copy what the programs need, and this CSV, into a folder; return it."""
    for name in ("src", "support"):
        shutil.copytree(ROOT / name, folder / name)
    shutil.copy(ROOT / "pds_tester.py", folder)
    (folder / "newton_cradle_pends.csv").write_text(csv, encoding="utf-8")
    return folder


@contextmanager
def running(program=None, *arguments, folder=os.sep, python=sys.executable, patience=5 * SECONDS, **environment):
    """Start the program as a user would, from this folder; yield the process, and end it in any case.

    After `patience` seconds it ends, too: a test that waits for its output then fails.
    """
    environment = {**os.environ, "VPYTHON_NO_LAUNCH_BROWSER": "1", **environment}
    environment.pop("PYTHONUNBUFFERED", None)  # it must not wait for a full buffer with what it has to say
    process = subprocess.Popen(
        [python, str(program or PROGRAM), *arguments],
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    timer = threading.Timer(patience, process.kill)
    timer.start()
    try:
        yield process
    finally:
        timer.cancel()
        process.kill()
        process.communicate()


def first_lines(process):
    """Return the address of the page, from what the program prints before it waits for a browser."""
    address = re.fullmatch(r"Newton's cradle is at (http://localhost:\d+/\?key=\w+)\n", process.stdout.readline())[1]
    assert "Ctrl+C" in process.stdout.readline()
    return address


def port_in(address):
    """Return the port in the address of the page."""
    return urlsplit(address).port


def end(process):
    """Wait until the program ends by itself; return its status, and what else it has printed on stdout and stderr."""
    stdout, stderr = process.communicate(timeout=SECONDS)
    return process.returncode, stdout, stderr


QUIETLY = (0, "", "")


def refusal(process):
    """Return the one line on stderr with which the program refuses to start."""
    status, stdout, stderr = end(process)
    assert (status, stdout) == (2, "")
    assert stderr.count("\n") == 1
    return stderr


@contextmanager
def new_page(browser, **settings):
    """Open a new tab in this browser, with Playwright's settings, and close it in the end."""
    page = browser.new_page(viewport={"width": 1000, "height": 700}, **settings)
    page.set_default_timeout(SECONDS * 1000)
    yield page
    page.close()


def open_cradle(page, address, bobs=5, small=True):
    """Open the page, and wait until it shows the cradle."""
    page.goto(address)
    wait_for_cradle(page, bobs, small)


def wait_for_cradle(page, bobs=5, small=True):
    """Wait for the bobs and their numbers; if small, make the canvas small: no graphics card draws it."""
    page.wait_for_function(f"() => window.glowObjs && ({BOBS})().length === {bobs}")
    page.wait_for_function("() => $('.readout').length")
    if small:
        page.add_style_tag(content=".canvas { max-width: 320px !important; max-height: 200px !important; }")
        page.wait_for_function("() => glowObjs[0].width <= 320 && glowObjs[0].height <= 200")
        page.evaluate(CAMERA_FOLLOWS)


def readout(page, name):
    """Return a number of the readout, by the word before it."""
    return float(re.search(rf"^{name}\s+([-+0-9.]+)", page.locator(".readout").inner_text(), re.MULTILINE)[1])


def wait_until(condition, seconds=SECONDS):
    """Wait until condition() holds; fail after `seconds`."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, "it never came"
        time.sleep(0.02)


def press(page, name):
    page.get_by_role("button", name=name, exact=True).click()


def pause(page):
    """Pause, and wait until nothing moves any more."""
    press(page, "Pause")
    page.get_by_role("button", name="Run").wait_for()
    wait_until(lambda: page.evaluate(MOVES) == 0)
