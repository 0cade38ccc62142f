"""The programs, as far as they need no browser: pds_tester.py, importing the viewer, and what its main does."""

import errno
import os
import shlex
import signal
import subprocess
import sys
from contextlib import nullcontext, suppress
from math import copysign, degrees
from pathlib import Path
from urllib.request import urlopen

import pytest
from programs import copy_project, on_posix, PROGRAM, ROOT, running, SECONDS, wait_until, with_vpython
from whole_cradles import components, FIVE_CSV, go_on

from grading.cradles import MIXED, MIXED_CSV
from src import pds_helper, visualize_cradle_run, visualize_double_cradle_run
from src.beyond.in_browser import show_cradle, show_double_cradle
from src.special_cradles import make_newton_cradle
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.files import cradle_csv
from support.page.local_server import page_sockets, port_of
from support.start.output import spell_out_letters, while_it_is_read


def test_pds_tester_shows_each_step_without_vpython(run, tmp_path):
    done = run(str(copy_project(tmp_path, MIXED_CSV) / "pds_tester.py"))
    assert (done.returncode, done.stderr) == (0, "")
    blocks = [block.splitlines() for block in done.stdout.split("\n\n")]
    assert [block[0].partition(":")[0] for block in blocks] == ["df", "bad_rep", "pend_list"]
    assert [len(block) for block in blocks] == [1 + 1 + 3, 1 + 3, 1 + 3]  # what it is, df's header, three pendula
    assert [block[-1].strip() for block in blocks[1:]] == [f"2: {MIXED[-1]}", str(MIXED[-1])]


def test_pds_tester_refuses_what_is_no_csv(run, tmp_path):
    done = run(str(copy_project(tmp_path, "") / "pds_tester.py"))
    file = tmp_path / "newton_cradle_pends.csv"
    line = f"{file}: is empty, the first line must name the columns\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


def test_letters_that_the_output_lacks_are_written_out(run, tmp_path, monkeypatch):
    """As in a pipe on Windows, which has the letters of one language."""
    monkeypatch.setenv("PYTHONIOENCODING", "cp1252")
    project = copy_project(tmp_path, MIXED_CSV.replace("omega,", "\u03c9,", 1))
    done = run(str(project / "pds_tester.py"))
    assert (done.returncode, done.stderr) == (0, "")
    assert "'\\u03c9': 2.0" in done.stdout
    data = tmp_path / "\u03c9.csv"
    done = run(str(project / "src" / "text_cradle_run.py"), "--seconds", "0.01", "--record", str(data))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.endswith("\\u03c9.csv\n")
    assert data.exists()


def test_an_output_that_is_no_file_is_left_as_it_is(monkeypatch):
    """As that of IDLE's shell."""
    monkeypatch.setattr(sys, "stdout", object())
    spell_out_letters()


@pytest.mark.parametrize("program", ["text_cradle_run", "visualize_cradle_run", "visualize_double_cradle_run"])
def test_an_older_python_is_told_so_before_it_stumbles(program):
    """Python 3.9 has no pairwise, for one."""
    code = (
        f"del itertools.pairwise; sys.version_info = (3, 9, 6); runpy.run_path('src/{program}.py', run_name='__main__')"
    )
    done = subprocess.run(
        [sys.executable, "-c", f"import itertools, runpy, sys; {code}"], cwd=ROOT, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("Newton's cradle needs Python 3.10 or later; ")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("program", "file", "module"),
    [
        ("src/text_cradle_run.py", "src/random.py", "random"),
        ("src/text_cradle_run.py", "src/contextlib.py", "contextlib"),
        ("src/visualize_cradle_run.py", "csv.py", "csv"),
        ("src/visualize_double_cradle_run.py", "src/types.py", "types"),
        ("pds_tester.py", "pandas.py", "pandas"),
    ],
)
def test_a_file_that_hides_a_module_is_named(tmp_path, program, file, module):
    folder = copy_project(tmp_path, FIVE_CSV)
    (folder / file).write_text("x = 1\n")
    done = subprocess.run([sys.executable, folder / program], capture_output=True, text=True, timeout=SECONDS)
    line = f"{Path(file)} hides the module {module} from Python and its packages. Rename it.\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


def test_a_file_that_hides_nothing_is_no_mistake(tmp_path):
    """Nobody needs Python's module test; and only a folder in which Python looks for modules can hide one."""
    folder = copy_project(tmp_path, FIVE_CSV)
    for name in ("test.py", "src/test.py", "random.csv", "support/random.py"):
        (folder / name).write_text("x = 1\n")
    (folder / "random").mkdir()
    done = subprocess.run([sys.executable, folder / "pds_tester.py"], capture_output=True, text=True, timeout=SECONDS)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("error", "status", "line"),
    [
        (BrokenPipeError(), None, ""),
        (OSError(errno.EINVAL, "Invalid argument"), None, ""),  # which is how Windows says it
        (OSError(errno.EINVAL, "Invalid argument", "data.csv"), 2, "data.csv: Invalid argument\n"),
        (BrokenPipeError(errno.EPIPE, "Broken pipe", "data.csv"), 2, "data.csv: Broken pipe\n"),
        (OSError(errno.ENOSPC, "No space left on device"), 2, "The output: No space left on device\n"),
    ],
)
def test_a_program_ends_quietly_or_with_one_line_where_nobody_reads_it(monkeypatch, capsys, error, status, line):
    @while_it_is_read()
    def main():
        raise error

    monkeypatch.setattr(sys, "platform", "win32")
    with pytest.raises(SystemExit) if status else nullcontext() as refused:
        main()
    assert (refused.value.code if status else None) == status
    assert capsys.readouterr() == ("", line)


def told(command, redirection):
    """Return the exit status and the stderr of a program whose output nobody reads, or as the shell redirects it."""
    reader, writer = os.pipe()
    os.close(reader)
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"}
    line = ["sh", "-c", f"{shlex.quote(sys.executable)} {command} {redirection}"]
    try:
        done = subprocess.run(line, cwd=ROOT, env=environment, stdout=writer, stderr=subprocess.PIPE, text=True)
    finally:
        os.close(writer)
    return done.returncode, done.stderr


@on_posix
@pytest.mark.parametrize(
    ("command", "redirection", "outcome"),
    [
        ("src/text_cradle_run.py --seconds 0.01", ">&-", (0, "")),
        ("src/text_cradle_run.py --help", ">&-", (0, "")),
        ("src/text_cradle_run.py --lift 99", "2>/dev/full", (2, "")),
        ("pds_tester.py", "", (0, "")),
        ("pds_tester.py", ">/dev/full", (2, "The output: No space left on device\n")),
        ("tests/watch.py test_angle_update --seconds 0.01", "", (0, "")),
        ("tests/make_starter.py {folder}", ">/dev/full", (2, "The output: No space left on device\n")),
    ],
)
def test_an_output_that_is_closed_or_full_or_unread_gives_one_line_at_most(tmp_path, command, redirection, outcome):
    if redirection.endswith("/dev/full") and not Path("/dev/full").exists():
        pytest.skip("macOS has no /dev/full")
    assert told(command.format(folder=shlex.quote(str(tmp_path))), redirection) == outcome


@with_vpython
@on_posix
def test_the_page_does_not_depend_on_its_output():
    sockets = page_sockets(0)
    port = port_of(sockets[0])
    for each in sockets:
        each.close()
    with running(PROGRAM, "--no-browser", "--port", str(port)) as process:
        process.stdout.close()
        wait_until(lambda: has_page(port) or process.poll() is not None)
        process.send_signal(signal.SIGINT)
        assert (process.wait(SECONDS), process.stderr.read()) == (0, "")


def has_page(port):
    """Return whether a page is at this port."""
    with suppress(OSError), urlopen(f"http://localhost:{port}/favicon.ico", timeout=SECONDS) as answer:
        return answer.status == 200
    return False


@pytest.mark.parametrize(
    "program",
    [
        *("pds_tester", "src/text_cradle_run"),
        *(pytest.param(f"src/visualize_{name}_run", marks=with_vpython) for name in ("cradle", "double_cradle")),
    ],
)
def test_a_program_finds_its_own_project_if_python_leaves_out_its_folder(monkeypatch, tmp_path, program):
    monkeypatch.setenv("PYTHONSAFEPATH", "1")
    command = [sys.executable, str(copy_project(tmp_path, "") / f"{program}.py")]
    done = subprocess.run(command, cwd=os.sep, capture_output=True, text=True, timeout=2 * SECONDS)
    line = f"{tmp_path / 'newton_cradle_pends.csv'}: is empty, the first line must name the columns\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


@pytest.mark.parametrize("program", ["watch", "make_starter", "benchmark", "grade_class", "make_autograder"])
def test_so_does_a_program_of_the_tests_and_it_has_help(monkeypatch, program):
    monkeypatch.setenv("PYTHONSAFEPATH", "1")
    command = [sys.executable, str(ROOT / "tests" / f"{program}.py"), "--help"]
    done = subprocess.run(command, cwd=os.sep, capture_output=True, text=True, timeout=2 * SECONDS)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"usage: {program}.py ")


@with_vpython
def test_importing_the_viewer_starts_nothing():
    """With VPython itself: its server's module is not even loaded, and there is no word on the screen."""
    program = "import sys, src.visualize_cradle_run; sys.exit('vpython.no_notebook' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.fixture
def start(monkeypatch):
    """A function that starts a program with a command line, and returns what its page and its main were given."""
    shown = []
    monkeypatch.setattr("support.page.page.open_page", lambda *given: shown.append(given[:3]))
    monkeypatch.setattr("support.page.page.page_sockets", lambda port: f"sockets at {port}")
    monkeypatch.setattr("support.page.page.run", lambda main, viewer: shown.append(viewer))
    monkeypatch.setattr("os._exit", lambda status: None)

    def start(*arguments, program=visualize_cradle_run, show=show_cradle):
        monkeypatch.setattr(sys, "argv", [program.__name__, *map(str, arguments)])
        show(program.main)
        page, viewer = shown
        go_on(viewer, viewer.open())
        return page, viewer

    return start


def test_main_shows_the_cradle_of_the_csv_in_which_only_approaching_bobs_hit(tmp_path, start):
    csv = copy_project(tmp_path, MIXED_CSV) / "newton_cradle_pends.csv"
    page, viewer = start(csv)
    assert page == ("sockets at 0", "Newton's cradle", True)
    cradle, expected = viewer.cradle.pend_list, make_newton_cradle(str(csv), R_PARAM, THETA_INIT)
    for pend_list in (cradle, expected):  # so that the second pair touches, and parts
        pend_list[1]["objects"][1].radius = R_PARAM
        pend_list[1]["omega"], pend_list[2]["omega"] = -1.0, 1.0
    go_on(viewer, viewer.advance(1))
    visualize_cradle_run.newton_cradle_tick(expected, R_PARAM, DT, G, approaching_only=True)
    for pend, as_expected in zip(cradle, expected, strict=True):
        assert (pend["theta"], pend["omega"]) == (as_expected["theta"], as_expected["omega"])
        assert components(pend["objects"][1].pos) == components(as_expected["objects"][1].pos)
    assert cradle[2]["omega"] > 0  # as it was: by the handout's rule it would have been reversed


def test_main_does_what_the_options_say(tmp_path, start):
    csv = copy_project(tmp_path, MIXED_CSV) / "newton_cradle_pends.csv"
    page, viewer = start(csv, "--inelastic", "--mass", 3, "--angle", 20, "--lift", 2, "--port", 8000, "--no-browser")
    assert page == ("sockets at 8000", "Newton's cradle", False)
    assert [(pend["e"], pend["mass"]) for pend in viewer.cradle.pend_list] == [(0, 3.0)] * 3
    assert [abs(degrees(pend["theta"])) for pend in viewer.cradle.pend_list] == pytest.approx([20, 20, 0])


def test_main_of_the_double_cradle_does_what_the_options_say(tmp_path, start):
    csv = copy_project(tmp_path, MIXED_CSV) / "newton_cradle_pends.csv"
    arguments = ["--inelastic", "--mass", "3", "--angle", "25", "--phi", "-12.5", "--lift", "2", "--no-browser"]
    page, viewer = start(csv, *arguments, program=visualize_double_cradle_run, show=show_double_cradle)
    assert page == ("sockets at 0", "Newton's double cradle", False)
    outwards, pend_list = copysign(1, THETA_INIT), viewer.cradle.pend_list
    lifts = [(outwards * degrees(pend["theta"]), outwards * degrees(pend["phi"])) for pend in pend_list]
    assert lifts == [pytest.approx(expected) for expected in [(25, -12.5), (25, -12.5), (0, 0)]]
    assert [(pend["e"], pend["mass"]) for pend in pend_list] == [(0, 3.0)] * 3


def test_the_csv_is_read_once(tmp_path, start, monkeypatch):
    """By the file system and by pandas, also if e and mass are given."""
    csv, reads = copy_project(tmp_path, MIXED_CSV) / "newton_cradle_pends.csv", []

    def count(owner, name):
        function = getattr(owner, name)

        def counted(first, *others, **named):
            if not isinstance(first, Path) or first == csv:  # a program reads src/, too
                reads.append(name)
            return function(first, *others, **named)

        monkeypatch.setattr(owner, name, counted)

    monkeypatch.setattr("support.page.workbench.EXPERIMENTS", tmp_path)  # none, as they are CSVs, too
    count(cradle_csv, "read_file")
    count(pds_helper.pd, "read_csv")
    _, viewer = start(csv, "--inelastic", "--mass", 3, "--lift", 2)
    assert [(pend["e"], pend["mass"]) for pend in viewer.cradle.pend_list] == [(0, 3.0)] * 3
    assert reads == ["read_file", "read_csv"]


@pytest.mark.parametrize(
    ("csv", "arguments", "line"),
    [
        (MIXED_CSV.replace("0.9", "9"), [], "{csv}, line 2, column e: found '9', allowed is a number from 0 to 1\n"),
        (
            MIXED_CSV,
            ["--lift", "4"],
            "--lift: found '4', allowed is at most 3, the number of pendula in {csv}\n",
        ),
    ],
)
def test_main_refuses_in_one_line_before_a_page_opens(tmp_path, monkeypatch, capsys, csv, arguments, line):
    path = copy_project(tmp_path, csv) / "newton_cradle_pends.csv"
    monkeypatch.setattr(sys, "argv", ["visualize_cradle_run.py", str(path), *arguments])
    monkeypatch.setattr("support.page.page.open_page", lambda *given: pytest.fail("a page was opened"))
    with pytest.raises(SystemExit) as refused:
        show_cradle(visualize_cradle_run.main)
    assert refused.value.code == 2
    assert capsys.readouterr() == ("", line.format(csv=path))
