"""The programs, as far as they need no browser: how they start, their output, pds_tester.py, and
the viewer's main.
"""

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
from math import hypot
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
from support.constants import R_PARAM, THETA_INIT
from support.page.page import show_cradle, show_double_cradle
from support.pendulum import angle_to_outwards
from support.start.checks_command import checks_command
from support.start.early import import_later, stop_on_signals
from support.start.output import complain, say, while_it_is_read

TEXT = "src/text_cradle_run"
PAGES = [f"src/visualize_{name}_run" for name in ("cradle", "double_cradle")]


@pytest.mark.parametrize(
    ("program", "way"),
    [
        *[
            ("pds_tester", "file"),
            (TEXT, "file"),
            ("pds_tester", "isolated"),
            (TEXT, "isolated"),
            (TEXT, "module"),
        ],
        *[(TEXT, "pasted"), pytest.param(TEXT, "link", marks=on_posix)],
        *[pytest.param(page, "file", marks=with_vpython) for page in PAGES],
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
    old_copy = dict.fromkeys(
        [hidden, "src/__init__.py", "support/__init__.py"], "raise ModuleNotFoundError"
    )
    file, link = project / f"{program}.py", tmp_path / "link"
    if way == "link":
        link.symlink_to(file)
    ways = {"file": [file], "isolated": ["-I", file], "module": ["-m", program.replace("/", ".")]}
    ways |= {"pasted": ["-c", file.read_text(encoding="utf-8")], "link": [link]}
    folder = os.sep if way == "file" else project
    done = python(
        *ways[way], folder=folder, PYTHONPATH=str(put_files(tmp_path / "hiding", old_copy))
    )
    line = (
        f"{project / 'newton_cradle_pends.csv'}: is empty, the first line must name the columns\n"
    )
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


@pytest.mark.parametrize("program", ["make_starter", "benchmark", "grade_class", "make_autograder"])
def test_a_program_of_the_tests_finds_its_own_project_and_has_help(program):
    done = python(ROOT / "tests" / f"{program}.py", "--help", folder=os.sep)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"usage: {program}.py ")


def test_the_example_of_the_readme_has_thrown_the_last_bob_out():
    [lines] = re.findall(
        r"^    import support.*?(?=\n\n#)",
        (ROOT / "README.md").read_text(),
        re.DOTALL | re.MULTILINE,
    )
    done = python("-c", textwrap.dedent(lines))
    *hanging, (x, y) = [
        tuple(map(float, bob)) for bob in re.findall(r"x = (.*) m, y = (.*) m\n", done.stdout)
    ]
    height = hanging[0][1] + R_PARAM  # of the axles
    assert hanging == [
        pytest.approx((-0.1 + i * R_PARAM / 4, height - R_PARAM), abs=0.002) for i in range(4)
    ]
    assert x > 0.2 and hypot(x - (R_PARAM - 0.1), y - height) == pytest.approx(R_PARAM, abs=0.002)


# It has no pairwise, for one
OLD = "import itertools, sys; del itertools.pairwise; sys.version_info = (3, 9, 6)"
FULL = "import tempfile; tempfile._candidate_tempdir_list = list"  # no folder is left to write to


@pytest.mark.parametrize(
    ("obstacle", "status", "words"),
    [
        (OLD, 1, "Newton's cradle needs Python 3.10 or later; "),
        (
            FULL,
            2,
            "Python finds no folder for temporary files in which it can write. Set TMPDIR to such a folder.",
        ),
    ],
)
def test_an_obstacle_is_named_before_a_program_stumbles(obstacle, status, words):
    run = "import runpy; runpy.run_path('src/visualize_cradle_run.py', run_name='__main__')"
    done = python("-c", f"{obstacle}; {run}")
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (status, "", 1)
    assert done.stderr.startswith(words)


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
def test_a_program_with_a_page_draws_shapes_of_vpython_and_refuses_all_for_which_vpython_would_wait():
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
    """test.py is no mistake, because nobody needs Python's module test; neither is a file that is
    no module.
    """
    folder = put_files(
        copy_project(tmp_path, FIVE_CSV), {"test.py": "x = 1\n", "random.csv": "x = 1\n"}
    )
    assert python("src/text_cradle_run.py", "--seconds", 0.01, folder=folder).returncode == 0
    (folder / "src" / "contextlib.py").write_text("x = 1\n")
    # An import never ends a process
    assert python("-c", "import support.constants", folder=folder).returncode == 0
    done = python("src/text_cradle_run.py", folder=folder)
    line = f"{Path('src/contextlib.py')} hides the module contextlib from Python and its packages. Rename it.\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


def test_a_slow_module_is_imported_once_when_it_is_used(tmp_path, monkeypatch):
    (tmp_path / "slow_module.py").write_text("import sys\nsys.slow_imports.append(1)\nvalue = 7\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "slow_imports", imports := [], raising=False)
    monkeypatch.delitem(sys.modules, "slow_module", raising=False)
    import_later("slow_module")
    early = import_module("slow_module")
    assert find_spec("slow_module").name == "slow_module"  # for the next program in a session
    assert imports == []
    assert (early.value, early.value, imports) == (7, 7, [1])
    import_later("no_such_module")
    assert "no_such_module" not in sys.modules


def test_an_unread_output_on_windows_ends_a_program_quietly_and_a_full_file_with_its_name(
    monkeypatch, capsys
):
    @while_it_is_read()
    def main(*filename):
        raise OSError(errno.EINVAL, "Invalid argument", *filename)

    monkeypatch.setattr(sys, "platform", "win32")
    main()
    with pytest.raises(SystemExit, match="2"):
        main("data.csv")
    assert capsys.readouterr() == ("", "data.csv: Invalid argument\n")


@on_posix
@pytest.mark.parametrize(
    ("does", "redirection", "status", "line"),
    [
        *(("print(1)", "", 0, ""), ("print(1)", ">&-", 0, ""), ("sys.stdin.read()", "<&-", 0, "")),
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


def test_each_signal_ends_a_program_once_with_its_status_unless_it_is_ignored_or_in_a_session(
    monkeypatch,
):
    """128 + its number, as in a shell; Ctrl+C is the usual end. nohup lets a program ignore SIGHUP."""
    handlers = {}
    signals = {"SIGHUP": 1, "SIGINT": 2, "SIGQUIT": 3, "SIGTERM": 15, "SIG_IGN": "ignored"}
    module = SimpleNamespace(**signals, getsignal=handlers.get, signal=handlers.__setitem__)
    monkeypatch.setattr("support.start.early.signal", module)
    for number, status in ((2, 0), (3, 131), (15, 143)):
        handlers.clear()
        handlers[1] = "ignored"
        stop_on_signals()
        assert (handlers.keys(), handlers[1]) == ({1, 2, 3, 15}, "ignored")
        handle = handlers[number]
        with pytest.raises(KeyboardInterrupt, match=f"^{status}$"):
            handle(number, None)
        handle(number, None)  # a second signal has come before the first one was handled
        assert {*handlers.values()} == {"ignored"}  # nothing interrupts the clean-up
    handlers.clear()
    monkeypatch.setattr(sys, "ps1", ">>> ", raising=False)  # as in IPython and python -i
    stop_on_signals()
    assert handlers == {}


MORE = f"Type {checks_command()}: it says more about mistakes."


def test_pds_tester_shows_each_step(csv, monkeypatch, capsys):
    csv.write_text(MIXED_CSV)
    monkeypatch.setattr(pds_tester, "NC_FP", str(csv))
    monkeypatch.setattr(pds_tester, "stop_on_signals", lambda: None)
    pds_tester.main()
    df, bad_rep, pend_list = [block.splitlines() for block in capsys.readouterr().out.split("\n\n")]
    # The name df, a header, three pendula
    assert (df[0].partition(":")[0], len(df)) == ("df", 1 + 1 + 3)
    assert bad_rep[1:] == [f"  {row}: {pend}" for row, pend in enumerate(MIXED)]
    assert pend_list[1:] == [f"  {pend}" for pend in MIXED]
    monkeypatch.setattr("src.pds_helper.pd", Mock(**{"read_csv.side_effect": KeyboardInterrupt}))
    assert "does a loop in extract_and_convert never end?" in call(pds_tester.main, capsys)[2]
    monkeypatch.setattr("src.pds_helper.pd", Mock(**{"read_csv.side_effect": KeyError("mas")}))
    status, _, stderr = call(pds_tester.main, capsys)
    assert (status, stderr.splitlines()[-2:]) == (1, ["KeyError: 'mas'", MORE])


@pytest.fixture
def start(monkeypatch, csv):
    """A function that starts a program for three unequal pendula; it returns what its server and
    its main got.
    """
    csv.write_text(MIXED_CSV)
    shown, server = [], Mock(**{"listener.getsockname.return_value": ["127.0.0.1"]})
    stand_in = SimpleNamespace(
        listen=lambda *given: given, Server=lambda *given: shown.append(given) or server
    )
    monkeypatch.setitem(sys.modules, "support.page.server", stand_in)
    monkeypatch.setattr("support.page.page.run", lambda main, viewer: shown.append(viewer))
    monkeypatch.setattr("support.page.page.end_on_signals", Mock())
    monkeypatch.setattr("support.page.page.what_there_is", lambda main, scope: (main, REMARK))

    def start(*arguments, is_double=False):
        monkeypatch.setattr(sys, "argv", ["program.py", str(csv), *arguments])
        program = visualize_double_cradle_run if is_double else visualize_cradle_run
        (show_double_cradle if is_double else show_cradle)(program.main, special_cradles)
        (listener, _), viewer = shown
        viewer.want_cradle()
        go_on(viewer)
        return (*listener, server.open_browser.called, server.close.called), viewer

    return start


SOME = "--inelastic --mass 3 --angle 20 --lift 3 --port 8000 --no-browser"
DOUBLED = "--mass 3 --angle 25 --phi=-12.5 --lift 2 --host 0.0.0.0"
HERE, ALL, REMARK = "127.0.0.1", "0.0.0.0", "Write next: <main>."


@pytest.mark.parametrize(
    # A pendulum has e, mass (kg), and each angle (degrees)
    ("program", "line", "given", "pendula"),
    [
        (
            "Newton's cradle",
            "",
            (HERE, 0, True),
            [(0.9, 1.5, angle_to_outwards(THETA_INIT)), (0.8, 2.5, 0), (0.7, 0.5, 0)],
        ),
        ("Newton's cradle", SOME, (HERE, 8000, False), [(0, 3, 20)] * 3),
        (
            "Newton's double cradle",
            DOUBLED,
            (ALL, 0, True),
            [(0.9, 3, 25, -12.5), (0.8, 3, 25, -12.5), (0.7, 3, 0, 0)],
        ),
    ],
)
def test_main_does_as_the_options_say(start, program, line, given, pendula):
    used, viewer = start(*line.split(), is_double="double" in program)
    state, remark = viewer.state(), "" if "double" in program else REMARK
    assert (state["title"], state["remark"], state["ended"], *used) == (
        program,
        remark,
        None,
        *given,
        True,
    )
    for pend, (e, mass, *lifts) in zip(viewer.cradle.pend_list, pendula, strict=True):
        assert (pend["e"], pend["mass"]) == (e, mass)
        assert [angle_to_outwards(pend[key]) for key in viewer.cradle.angle_keys] == pytest.approx(
            lifts
        )


def test_main_refuses_in_one_line_before_a_page_opens(start, capsys):
    status, stdout, stderr = call(partial(start, "--lift", "4"), capsys)
    assert (status, stdout, stderr.count("\n")) == (2, "", 1)
    assert stderr.startswith("--lift: found '4', allowed is at most 3, ")
