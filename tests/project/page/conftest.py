"""What the tests of the page share: they meet VPython itself, and real browsers."""

import os
import shutil
import subprocess
import sys
from types import SimpleNamespace
from unittest.mock import Mock

import pytest
from pages import ARGUMENTS, CHROMIUM, FIREFOX, new_page, TIMEOUT
from programs import needs_vpython
from rig import Rig
from shared_page import file, open_page, shared, whole  # noqa: F401  fixtures
from whole_cradles import go_on, PROGRAMS

from grading.cradles import MIXED_CSV
from support.page.show_cradle import show


def pytest_itemcollected(item):
    """Mark the tests that open a page; the program of a page needs VPython, and gets signals.

    With --dist loadgroup, one process has Firefox, and one process the shared page.
    """
    if {"page", "chromium"}.intersection(item.fixturenames):
        for mark in (pytest.mark.browser, *needs_vpython):
            item.add_marker(mark)
    if "firefox" in item.fixturenames or "[firefox]" in item.name:
        item.add_marker(pytest.mark.xdist_group("firefox"))
    elif "shared" in item.fixturenames:
        item.add_marker(pytest.mark.xdist_group("shared"))


@pytest.fixture
def rig(csv):
    """A viewer of five bobs, on the stand-in."""
    return Rig(csv)


@pytest.fixture
def start(monkeypatch, csv):
    """A function that starts a program for three unequal pendula.

    It takes the kind of the cradle, and options; it returns the host and the port of its server,
    whether it has opened a browser, and the viewer.
    """
    csv.write_text(MIXED_CSV)
    monkeypatch.chdir(csv.parent)
    server = Mock()
    run = Mock()

    def make_server(options):
        server.listener.getsockname.return_value = options.host, options.port
        return server

    monkeypatch.setattr("support.page.show_cradle.make_server", make_server)
    monkeypatch.setattr("support.page.show_cradle.run_for_each_cradle", run)

    def start(kind, line):
        monkeypatch.setattr(sys, "argv", ["program.py", str(csv), *line.split()])
        monkeypatch.setattr("__main__.__file__", str(PROGRAMS[kind]), raising=False)
        show()
        server.close.assert_called()
        program, viewer = run.call_args.args
        assert program == PROGRAMS[kind]
        go_on(viewer)
        place = server.listener.getsockname()
        return SimpleNamespace(place=place, browser=server.browser_start.open.called, viewer=viewer)

    return start


@pytest.fixture(scope="session")
def driver():
    with pytest.importorskip("playwright.sync_api").sync_playwright() as driver:
        yield driver


@pytest.fixture(scope="session")
def chromium(driver):
    program = CHROMIUM or driver.chromium.executable_path  # Playwright's own
    if not os.path.exists(program):
        pytest.skip("Chromium is not installed")
    browser = driver.chromium.launch(executable_path=program, args=ARGUMENTS, timeout=TIMEOUT)
    yield browser
    browser.close()


@pytest.fixture(scope="session")
def firefox(driver):
    """Firefox on a screen that is only in memory: without any screen it has no WebGL."""
    if FIREFOX is None or shutil.which("Xvfb") is None:
        pytest.skip("Firefox or Xvfb is not installed")
    command = ["Xvfb", "-displayfd", "1"]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    with subprocess.Popen(command, **pipes) as screen:
        try:
            browser = driver.firefox.launch(
                channel="moz-firefox",
                executable_path=FIREFOX,
                headless=False,
                timeout=TIMEOUT,
                env={**os.environ, "DISPLAY": f":{int(screen.stdout.readline())}"},
            )
            yield browser
            browser.close()
        except Exception as error:
            # Playwright may not speak with this version, as 1.60 does not with 140.
            is_unknown = "unknown command" in str(error)
            if not is_unknown or os.environ.get("CI"):
                raise
            pytest.skip("Playwright does not know this version of Firefox")
        finally:
            screen.terminate()


@pytest.fixture
def page(request):
    """A new tab in Chromium, or in the browser that a test names in its parameter."""
    with new_page(request.getfixturevalue(getattr(request, "param", "chromium"))) as page:
        yield page
