"""What a solution can do: to its grade, to the machine, and to other solutions."""

import json
import os
import shutil
import socket
import subprocess
import sys
from contextlib import contextmanager

import pytest
from classroom import GRADE, rows_in
from grade_class import copy_starter
from hostile_solutions import HARMLESS, HEADER, SPOILED
from programs import on_posix

from teacher import one_run, report
from teacher.runners import package, Runner

POINTS = 45  # of D to A


# --- the grade -----------------------------------------------------------------------------------


@pytest.fixture
def runner():
    """A runner that is open."""
    runner = Runner("starter")
    runner.empty = GRADE
    return runner


def run_that_prints(runner, status, output):
    """Return the run of a solution that has ended with this status and this output."""
    runner.run_package = lambda _: (status, output.encode())
    return runner.run({})


@pytest.mark.parametrize(
    ("status", "is_complete", "is_final"),
    [
        (0, True, True),
        (1, True, True),  # pytest had to end a thread
        (1, False, False),
        (one_run.LATE, True, False),
    ],
)
def test_the_grade_of_a_run_that_came_to_its_end_is_final(runner, status, is_complete, is_final):
    checks = {name: {**check, "state": "passed"} for name, check in runner.empty["checks"].items()}
    grade = {**runner.empty, "checks": checks, "final": is_complete}
    run = run_that_prints(runner, status, json.dumps(grade))
    assert run.grade["points"]["D"] == 1
    assert run.problem == ""
    assert run.is_final == is_final


def test_a_run_without_a_whole_grade_has_none(runner):
    checks = runner.empty["checks"]
    fewer = dict([*checks.items()][1:])
    more = {**checks, "a": {}}
    other = dict.fromkeys(checks, 1)
    ends = [(1, json.dumps({**runner.empty, "checks": form})) for form in (fewer, more, other)]
    ends += [(1, "[" * 100_000), (one_run.LATE, "")]
    problems = []
    for status, output in ends:
        run = run_that_prints(runner, status, output)
        problems.append(run.problem)
        assert not run.is_final
        assert sum(run.grade["points"].values()) == 0
        assert run.grade["checks"].keys() == checks.keys()
    assert problems == [
        *["no grade: the run ended with status 1"] * 4,
        "no grade: the run took longer than 300 s",
    ]


def test_what_a_solution_says_is_short_and_has_no_codes_of_a_terminal(tmp_path):
    texts = {"message": "\x1b[2J=1;2\n" + "x" * 50_000}
    output = {
        **GRADE,
        "checks": {name: {**check, **texts} for name, check in GRADE["checks"].items()},
        "next": "\t=1;=2,=3\x1b" + "y" * 50_000,
        "text": ["\x1b[2J\ud800" + "z" * 20_000] * 300,
    }
    grade = report.read_grade(GRADE, json.dumps(output).encode())
    table = report.Report(tmp_path, None)
    table.add("@a;b", 1.0, [], grade)
    table.write()
    (row,) = rows_in(tmp_path).values()
    assert row["student"] == "'@a;b"
    assert row["next"].startswith("\\t=1;'=2,=3\\x")
    assert (tmp_path / "grades.csv").stat().st_size < 3000
    text = (tmp_path / "@a;b.txt").read_text(encoding="utf-8")
    assert len(text) < 11_000
    assert text.replace("\n", "").isprintable()


def test_a_cell_is_no_formula():
    for name in ("=1", "-a", "@b", "+c", " =1", "\uff1d1"):
        assert report.cell(name) == f"'{name}"
    assert report.cell("Bea") == "Bea"


# --- a run ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("files", "status", "problem"),
    [
        ({"a.py": b"", "a.py/b.py": b""}, 1, "The files cannot be written: "),
        ({"\udce9.py": b"", "conftest.py": b"raise OSError('read')"}, 4, "OSError: read"),
        ({"conftest.py": b"import os\nos.abort()"}, 134, ""),
    ],
)
def test_a_run_says_why_there_is_no_grade(made, tmp_path, files, status, problem):
    copy_starter(made, tmp_path / "starter")
    program = tmp_path / "starter" / "tests" / "teacher" / "one_run.py"
    done = subprocess.run(
        [sys.executable, program], input=package(files), capture_output=True, cwd=tmp_path
    )
    assert done.returncode == status
    assert problem in done.stdout.decode()


# --- the machine and the others ------------------------------------------------------------------


def contents(folder):
    return {path: path.read_bytes() for path in folder.rglob("*.*") if path.is_file()}


@contextmanager
def servers():
    """Listen at an address of the network, and at one of this machine without a file."""
    with socket.create_server(("127.0.0.1", 0)) as net, socket.socket(socket.AF_UNIX) as unix:
        unix.bind(f"\0cradle-{os.getpid()}")
        unix.listen()
        yield net.getsockname(), unix.getsockname()


@on_posix
@pytest.mark.slow
@pytest.mark.xdist_group("engine")
def test_hostile_solutions_harm_nobody_else(classroom, solved, tmp_path, engine):
    classroom.how = []
    (tmp_path / "secret.txt").write_text("secret")
    names = ["secret.txt", "class/an honest one/src/swinging.py", "new.txt"]
    with servers() as (net, unix):
        in_vain = [
            f"assert socket.socket().connect_ex({net})",
            f"assert error_of(socket.socket(socket.AF_UNIX).connect, {unix})",
        ]
        for name in names:
            in_vain.append(f"assert error_of(open, {str(tmp_path / name)!r}, 'w')")
            in_vain.append(f"assert not os.path.exists({str(tmp_path / name)!r})")
        unharmed = {**HARMLESS, "tries all in vain": "\n".join(in_vain)}
        for student, code in {**unharmed, **SPOILED}.items():
            swinging = solved["swinging.py"] + f"{HEADER}{code}".encode()
            classroom.hand_in(student, {**solved, "swinging.py": swinging})
        classroom.hand_in("an honest one", solved)
        before = contents(tmp_path)
        status, _, errors = classroom.grade()
    assert (status, errors) == (0, "")
    rows = classroom.rows()
    points = {student: int(rows[student]["points"]) for student in ("an honest one", *unharmed)}
    assert points == dict.fromkeys(points, POINTS)
    for student in SPOILED:
        assert int(rows[student]["points"]) < POINTS, student
    shutil.rmtree(classroom.grades)
    assert contents(tmp_path) == before
    classroom.require_clean()
