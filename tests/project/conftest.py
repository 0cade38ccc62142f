"""What the project's tests share: they meet VPython itself in other processes, and in a real browser."""

import os
import subprocess
import sys

import pytest
from programs import ARGUMENTS, CHROMIUM, copy_project, PROGRAM, SECONDS
from whole_cradles import FIVE_CSV


@pytest.fixture
def program(tmp_path):
    """The program in a project of its own, with five equal bobs, whatever has become of the shipped CSV."""
    return copy_project(tmp_path, FIVE_CSV) / "src" / PROGRAM.name


@pytest.fixture
def run(tmp_path):
    """A function that runs Python in another folder, with no VPython to be found."""
    (tmp_path / "vpython.py").write_text("raise ModuleNotFoundError('VPython is not installed')\n")

    def run(*arguments):
        environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
        command = [sys.executable, *arguments]
        return subprocess.run(command, cwd=os.sep, env=environment, capture_output=True, text=True, timeout=2 * SECONDS)

    return run


@pytest.fixture(scope="session")
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
