"""The programs, as far as they need no browser: how they start, and what they print."""

import errno
import io
import os
import re
import shlex
import subprocess
import sys
import textwrap
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from math import dist
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import pytest
from programs import call, copy_project, on_posix, python, ROOT, with_vpython
from students import put_files
from whole_cradles import FIVE_CSV, go_on

import pds_tester
from grading.cradles import MIXED, MIXED_CSV
from src import special_cradles, visualize_cradle_run, visualize_double_cradle_run
from support.constants import R_PARAM
from support.page.page import show_cradle, show_double_cradle
from support.pendulum import outwards_to_angle
from support.start.checks_command import checks_command
from support.start.early import end_on_signals, import_later, import_now, stop_on_signals
from support.start.output import complain, say, while_it_is_read

TEXT = "src/text_cradle_run"
PAGES = "src/visualize_cradle_run", "src/visualize_double_cradle_run"


@pytest.mark.parametrize(
    ("program", "way"),
    [
        ("pds_tester", "file"),
        ("pds_tester", "isolated"),
        (TEXT, "file"),
        (TEXT, "isolated"),
        (TEXT, "module"),
        (TEXT, "pasted"),
        pytest.param(TEXT, "link", marks=on_posix),
        pytest.param(PAGES[0], "file", marks=with_vpython),
        pytest.param(PAGES[1], "file", marks=with_vpython),
    ],
)
def test_a_program_finds_its_own_project_from_any_folder_and_refuses_in_one_line(
    tmp_path, program, way
):
    """It needs no VPython, or it has a page and no pandas so early.

    An old copy of the project does not get in.

    VPython's server does not start so early either: it would wait for a browser.
    """
    project = copy_project(tmp_path / "100% ü #1", "")
    hidden = "pandas.py" if program in PAGES else "vpython.py"
    hiding = dict.fromkeys([hidden, "src/__init__.py", "support/__init__.py"], "raise ImportError")
    put_files(tmp_path / "hiding", hiding)
    file = project / f"{program}.py"
    link = tmp_path / "link"
    if way == "link":
        link.symlink_to(file)
    arguments = {
        "file": [file],
        "isolated": ["-I", file],
        "module": ["-m", program.replace("/", ".")],
        "pasted": ["-c", file.read_text(encoding="utf-8")],
        "link": [link],
    }[way]
    folder = os.sep if way == "file" else project
    done = python(*arguments, folder=folder, PYTHONPATH=str(tmp_path / "hiding"))
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert done.stderr.startswith(f"{project / 'newton_cradle_pends.csv'}: is empty, ")


@pytest.mark.parametrize("program", ["make_starter", "benchmark", "grade_class", "make_autograder"])
def test_a_program_of_the_tests_finds_its_own_project_and_has_help(program):
    done = python(ROOT / "tests" / f"{program}.py", "--help", folder=os.sep)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"usage: {program}.py ")


def test_the_example_of_the_readme_has_thrown_the_last_bob_out():
    example = r"(?ms)^    import support.*?(?=\n\n#)"
    [lines] = re.findall(example, (ROOT / "README.md").read_text())
    done = python("-c", textwrap.dedent(lines))
    bobs = [(float(x), float(y)) for x, y in re.findall(r"x = (.*) m, y = (.*) m\n", done.stdout)]
    height = bobs[0][1]
    for i, bob in enumerate(bobs[:4]):
        assert bob == pytest.approx((-0.1 + i * R_PARAM / 4, height), abs=0.002)
    last = bobs[4]
    assert last[0] > 0.2
    assert dist(last, (R_PARAM - 0.1, height + R_PARAM)) == pytest.approx(R_PARAM, abs=0.002)


# It has no pairwise, for one
OLD = "import itertools, sys; del itertools.pairwise; sys.version_info = (3, 9, 6)"
BARE = "import sys; sys.path[:] = [path for path in sys.path if 'site-packages' not in path]"
FULL = "import tempfile; tempfile._candidate_tempdir_list = list"  # no folder is left to write to


@pytest.mark.parametrize(
    ("obstacle", "status", "part"),
    [(OLD, 1, "needs Python 3.10 or later"), (FULL, 2, "Set TMPDIR"), (BARE, 2, "has no pandas")],
)
def test_an_obstacle_is_named_before_a_program_stumbles(obstacle, status, part):
    run = "import runpy; runpy.run_path('src/visualize_cradle_run.py', run_name='__main__')"
    done = python("-c", f"{obstacle}; {run}")
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (status, "", 1)
    assert part in done.stderr


DRAWN = """
from support.start import program
program.begin()
from vpython import *
sphere().clone()
for refused in {refused}.split():
    try:
        eval(refused)
    except RuntimeError:
        print(refused)
"""
REFUSED = """
text(text='a') compound([box()]) extrusion(path=[],shape=[]) graph() gcurve() slider(bind=abs)
scene.waitfor('click') scene.pause() scene.mouse.pick
"""


@with_vpython
def test_a_program_with_a_page_draws_shapes_and_refuses_all_for_which_vpython_would_wait():
    done = python("-W", "ignore", "-c", DRAWN.format(refused=repr(REFUSED)))
    assert (done.returncode, done.stdout.split(), done.stderr) == (0, REFUSED.split(), "")


def test_a_started_file_may_import_its_neighbours_with_a_point(tmp_path):
    """As it may when pytest imports it."""
    folder = copy_project(tmp_path, FIVE_CSV)
    for file in (folder / "src").glob("*_run.py"):
        file.write_text(
            file.read_text().replace("from src.", "from .").replace("from .text", "from src.text")
        )
    done = python("src/text_cradle_run.py", "--seconds", 0.01, folder=folder)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_file_that_hides_a_module_is_named(tmp_path):
    """test.py is no mistake: nobody needs Python's module test.

    Neither is a file that is no module.
    """
    folder = put_files(
        copy_project(tmp_path, FIVE_CSV), {"test.py": "x = 1\n", "random.csv": "x = 1\n"}
    )
    assert python("src/text_cradle_run.py", "--seconds", 0.01, folder=folder).returncode == 0
    (folder / "src" / "contextlib.py").write_text("x = 1\n")
    # An import never ends a process
    assert python("-c", "import support.constants", folder=folder).returncode == 0
    done = python("src/text_cradle_run.py", folder=folder)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert done.stderr.startswith(f"{Path('src/contextlib.py')} hides the module contextlib ")


def test_a_slow_module_is_imported_once_when_it_is_used(tmp_path, monkeypatch):
    (tmp_path / "slow_module.py").write_text("import sys\nsys.slow_imports.append(1)\nvalue = 7\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "slow_imports", imports := [], raising=False)
    monkeypatch.delitem(sys.modules, "slow_module", raising=False)
    import_later("slow_module")
    early = import_module("slow_module")
    assert find_spec("slow_module").name == "slow_module"  # for the next program in a session
    assert imports == []
    assert early.value == 7
    assert early.value == 7
    assert imports == [1]
    monkeypatch.delitem(sys.modules, "slow_module")
    import_later("slow_module")
    import_now("slow_module")  # for which the page waits while the browser loads
    assert imports == [1, 1]
    import_later("no_such_module")
    assert "no_such_module" not in sys.modules


@pytest.mark.parametrize(
    ("system", "number", "file", "printed"),
    [
        ("win32", errno.EINVAL, [], ""),  # nobody reads it on
        ("win32", errno.EINVAL, ["data.csv"], "data.csv: it failed\n"),
        ("win32", errno.ENOSPC, [], "The output: it failed\n"),
        ("linux", errno.EINVAL, [], "The output: it failed\n"),
    ],
)
def test_an_unread_output_on_windows_ends_a_program_quietly(
    monkeypatch, capsys, system, number, file, printed
):
    @while_it_is_read()
    def main():
        raise OSError(number, "it failed", *file)

    monkeypatch.setattr(sys, "platform", system)
    assert call(main, capsys) == (2 if printed else 0, "", printed)


@on_posix
@pytest.mark.parametrize(
    ("does", "redirection", "status", "line"),
    [
        ("print(1)", "", 0, ""),
        ("print(1)", ">&-", 0, ""),
        ("sys.stdin.read()", "<&-", 0, ""),
        ("print(1)", ">/dev/full", 2, "The output: No space left on device\n"),
        ("refuse('no')", "2>/dev/full", 2, ""),
    ],
)
def test_an_output_that_is_closed_or_full_or_unread_gives_one_line_at_most(
    does, redirection, status, line
):
    if "/dev/full" in redirection and not Path("/dev/full").exists():
        pytest.skip("macOS has no /dev/full")
    does = f"from support.start.output import *\nwith while_it_is_read(): {does}"
    command = f"unset PYTHONUNBUFFERED; {shlex.join([sys.executable, '-c', does])} {redirection}"
    reader, writer = os.pipe()
    os.close(reader)
    with open(writer) as unread:
        done = subprocess.run(
            ["sh", "-c", command], cwd=ROOT, stdout=unread, stderr=subprocess.PIPE, text=True
        )
    assert (done.returncode, done.stderr) == (status, line)


def test_letters_that_the_output_lacks_are_written_out_and_without_an_output_the_program_goes_on(
    monkeypatch,
):
    """A pipe on Windows has the letters of one language.

    IDLE's shell has all, and no way to say so.
    """
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(io.BytesIO(), encoding="cp1252"))
    with while_it_is_read():
        say("\u03c9")
    assert sys.stdout.buffer.getvalue().split() == [b"\\u03c9"]
    closed = Mock(spec=["write", "flush"], **{"write.side_effect": BrokenPipeError})
    monkeypatch.setattr(sys, "stdout", closed)
    monkeypatch.setattr(sys, "stderr", closed)
    with while_it_is_read():
        say("the address")
        complain("a mistake")


@pytest.fixture
def handlers(monkeypatch):
    """The handlers of signals, by their numbers; nohup lets a program ignore SIGHUP."""
    handlers = {1: "ignored"}
    signals = {"SIGHUP": 1, "SIGINT": 2, "SIGQUIT": 3, "SIGTERM": 15, "SIG_IGN": "ignored"}
    module = SimpleNamespace(**signals, getsignal=handlers.get, signal=handlers.__setitem__)
    monkeypatch.setattr("support.start.early.signal", module)
    return handlers


@pytest.mark.parametrize(("number", "status"), [(2, 0), (3, 131), (15, 143)])
def test_each_signal_ends_a_program_once_with_its_status(handlers, number, status):
    """128 + its number, as in a shell; Ctrl+C is the usual end, with 0."""
    stop_on_signals()
    assert handlers.keys() == {1, 2, 3, 15}
    assert handlers[1] == "ignored"
    handle = handlers[number]
    with pytest.raises(KeyboardInterrupt, match=f"^{status}$"):
        handle(number, None)
    handle(number, None)  # a second signal has come before the first one was handled
    assert {*handlers.values()} == {"ignored"}  # nothing interrupts the clean-up


@pytest.mark.parametrize(("option", "status"), [("--lift=1", 143), ("--record=data.csv", 1)])
def test_a_signal_while_a_program_starts_ends_it_at_once(handlers, monkeypatch, option, status):
    """Without its recording, a program has failed."""
    monkeypatch.setattr(sys, "argv", ["program.py", option])
    events = []
    monkeypatch.setattr("os._exit", events.append)
    end_on_signals(first=lambda: events.append("first"))
    handlers[15](15, None)
    assert events == ["first", status]


def test_in_a_session_signals_stay_as_they_are(handlers, monkeypatch):
    """As in IPython and python -i."""
    monkeypatch.setattr(sys, "ps1", ">>> ", raising=False)
    stop_on_signals()
    assert handlers == {1: "ignored"}


MORE = f"Type {checks_command()}: it says more about mistakes.\n"


def test_pds_tester_shows_each_step(csv, monkeypatch, capsys):
    csv.write_text(MIXED_CSV)
    monkeypatch.setattr(pds_tester, "NC_FP", str(csv))
    monkeypatch.setattr(pds_tester, "stop_on_signals", lambda: None)
    pds_tester.main()
    df, bad_rep, pend_list = [block.splitlines() for block in capsys.readouterr().out.split("\n\n")]
    assert df[0].startswith("df: ")
    assert len(df[1:]) == 1 + 3  # a header, three pendula
    assert bad_rep[1:] == [f"  {row}: {pend}" for row, pend in enumerate(MIXED)]
    assert pend_list[1:] == [f"  {pend}" for pend in MIXED]
    monkeypatch.setattr("src.pds_helper.pd", Mock(**{"read_csv.side_effect": KeyboardInterrupt}))
    assert "does a loop in extract_and_convert never end?" in call(pds_tester.main, capsys)[2]
    monkeypatch.setattr("src.pds_helper.pd", Mock(**{"read_csv.side_effect": KeyError("mas")}))
    status, _, stderr = call(pds_tester.main, capsys)
    assert status == 1
    assert stderr.endswith("\nKeyError: 'mas'\n" + MORE)


@pytest.fixture
def start(monkeypatch, csv):
    """A function that starts a program for three unequal pendula.

    It returns where its server listens, whether it has opened a browser, and the viewer.
    """
    csv.write_text(MIXED_CSV)
    server = Mock()
    server.listener.getsockname.return_value = ["127.0.0.1"]
    listen = Mock()
    module = SimpleNamespace(Server=lambda *_: server)
    monkeypatch.setitem(sys.modules, "support.page.server", module)
    monkeypatch.setattr("support.page.port.listen", listen)
    run = Mock()
    monkeypatch.setattr("support.page.page.run", run)
    monkeypatch.setattr("support.page.page.end_on_signals", Mock())
    monkeypatch.setattr("support.page.page.what_there_is", lambda main, scope: (main, REMARK))

    def start(show, program, *arguments):
        monkeypatch.setattr(sys, "argv", ["program.py", str(csv), *arguments])
        show(program.main, special_cradles)
        server.close.assert_called_once()
        [(_, viewer)] = [call.args for call in run.mock_calls]
        viewer.want_cradle()
        go_on(viewer)
        place = listen.call_args.args
        return SimpleNamespace(place=place, browser=server.browser_start.open.called, viewer=viewer)

    return start


REMARK = "Write next: <main>."


def test_a_program_does_as_the_options_say(start):
    line = "--inelastic --mass 3 --angle 20 --port 8000 --no-browser"
    page = start(show_cradle, visualize_cradle_run, *line.split())
    assert page.place == ("127.0.0.1", 8000)
    assert not page.browser
    state = page.viewer.state()
    assert state["title"] == "Newton's cradle"
    assert state["remark"] == REMARK
    assert state["ended"] is None
    cradle = page.viewer.cradle
    assert cradle.values("e") == [0] * 3
    assert cradle.values("mass") == [3] * 3
    assert cradle.values("theta") == [outwards_to_angle(20), 0, 0]


def test_the_program_of_the_double_cradle_also_has_phi(start):
    line = "--angle 25 --phi=-12.5 --lift 2 --host 0.0.0.0"
    page = start(show_double_cradle, visualize_double_cradle_run, *line.split())
    assert page.place == ("0.0.0.0", 0)
    assert page.browser
    state = page.viewer.state()
    assert state["title"] == "Newton's double cradle"
    assert state["remark"] == ""
    cradle = page.viewer.cradle
    assert cradle.values("e") == [0.9, 0.8, 0.7]
    assert cradle.values("mass") == [1.5, 2.5, 0.5]
    assert cradle.values("theta") == [outwards_to_angle(25)] * 2 + [0]
    assert cradle.values("phi") == [outwards_to_angle(-12.5)] * 2 + [0]


def test_a_program_refuses_in_one_line_before_a_page_opens(start, capsys):
    show = partial(start, show_cradle, visualize_cradle_run, "--lift", "4")
    status, stdout, stderr = call(show, capsys)
    assert (status, stdout, stderr.count("\n")) == (2, "", 1)
    assert stderr.startswith("--lift: found '4', allowed is at most 3, ")
