"""The start of the browser, and of a program again and again in a session."""

import signal
import sys
from types import SimpleNamespace
from unittest.mock import Mock
from urllib.parse import urlsplit

import programs
import pytest
from programs import CLOSED, end, first_lines, running
from students import change
from web_client import Tab

from support.page.server import browser as browser_start

pytestmark = programs.needs_vpython

# A browser: it writes down who can read the file that it gets, where that leads to, and what the
# page answers at once.
BROWSER = """#!{python}
import os, re, sys, urllib.request as web
address = re.search('url=([^"]*)', web.urlopen(sys.argv[1]).read().decode())[1]
[folder] = os.listdir(os.environ["TMPDIR"])
mode = oct(os.stat(os.path.join(os.environ["TMPDIR"], folder)).st_mode)[-3:]
print(mode, address, web.urlopen(address).status, *sys.argv[1:], file=open("{visited}", "w"))
"""


@pytest.mark.parametrize(("until", "ends"), [("a tab", CLOSED), ("SIGTERM", (143, "", ""))])
def test_a_browser_gets_a_file_that_leads_on(program, tmp_path, until, ends):
    """All users of a machine can read a command; only you the file.

    It goes with the first tab, or with the program.
    """
    folder = tmp_path / "100% ü #1"
    visited = tmp_path / "visited"
    browser = tmp_path / "browser"
    folder.mkdir()
    browser.write_text(BROWSER.format(python=sys.executable, visited=visited))
    browser.chmod(0o755)
    end_soon(program)
    with running(
        program,
        folder=folder,
        BROWSER=str(browser),
        VPYTHON_NO_LAUNCH_BROWSER="",
        TMPDIR=str(folder),
    ) as process:
        address = first_lines(process)
        programs.wait_until(lambda: visited.exists() and visited.read_text().endswith("\n"))
        *seen, file = visited.read_text().split()
        assert seen == ["700", address, "200"]
        assert file.startswith("file://")
        assert address.partition("key=")[2] not in file
        if until == "a tab":
            with Tab(urlsplit(address)) as tab:
                tab.hear()
                assert [*folder.iterdir()] == []
        else:
            process.send_signal(signal.SIGTERM)
        assert end(process) == ends
    assert [*folder.iterdir()] == []


@pytest.mark.parametrize(
    ("name", "release", "places"),
    [
        ("firefox", "5.15.90-Microsoft-WSL2", ["http"]),  # it sees no file of this system
        ("/usr/bin/w3m", "6.1.0-18-amd64", []),  # it has no pictures
    ],
)
def test_what_a_browser_opens(monkeypatch, name, release, places):
    thread = Mock()
    monkeypatch.setattr("platform.release", lambda: release)
    monkeypatch.setattr("webbrowser.get", lambda: SimpleNamespace(name=name, open=None))
    monkeypatch.setattr("threading.Thread", thread)
    browser_start.BrowserStart().open("http")
    assert [call.kwargs["args"][0] for call in thread.call_args_list] == places


def end_soon(program):
    """Let the program end as soon as its last tab is closed."""
    attendance = program.parents[1] / "support" / "page" / "server" / "attendance.py"
    change(attendance, "CLOSED = 3.0", "CLOSED = 0.1")  # s


SESSION = """
import runpy, sys
def start(*line):
    sys.argv = [*line]
    try:
        runpy.run_path(line[0], run_name="__main__")
    except SystemExit as ended:
        print("status", ended.code)

start("{folder}/text_cradle_run.py", "--seconds", "0.01")
for time in "12":
    start("{folder}/visualize_cradle_run.py")
"""


@pytest.mark.slow
def test_in_a_session_a_program_starts_again_and_a_closed_tab_gives_the_prompt_back(program):
    """As in IPython: with and without VPython."""
    end_soon(program)
    session = SESSION.format(folder=program.parent)
    with running("-iuc", session, PYTHONPATH=str(program.parent)) as process:
        for start in ("t", "0.00", "0.01"):
            assert process.stdout.readline().split()[0] == start
        for _ in range(2):
            with Tab(urlsplit(first_lines(process))) as tab:
                while "motion" not in tab.hear()["state"]:
                    pass
            assert process.stdout.readline() == CLOSED[1]
            assert process.stdout.readline() == "status None\n"
        assert end(process)[:2] == (0, "")
