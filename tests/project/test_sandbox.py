"""What a solution can do: to its grade, to the machine, and to other solutions."""

import json
import os
import re
import shutil
import socket
import subprocess
import sys
import threading
from unittest.mock import Mock

import pytest
from classroom import needs_bwrap, rows_in, UNBOXED
from hostile_solutions import BOXED, HARMLESS, HEADER, SPOILED
from programs import on_posix, python, ROOT, SECONDS
from students import COUNTS, graded_in, put_files

from teacher import memory, one_run, report, sandbox

POINTS = sum(COUNTS.values())


# --- the grade -----------------------------------------------------------------------------------


@pytest.fixture(scope="session")
def empty(made, tmp_path_factory):
    """The grade of the starter."""
    return graded_in(shutil.copytree(made, tmp_path_factory.mktemp("empty") / "starter"))


@pytest.fixture
def box(made, empty, tmp_path):
    """A sandbox that no process of a test has to start in."""
    (tmp_path / "work").mkdir()
    box = sandbox.Sandbox(made, tmp_path / "work", has_bubblewrap=False, stopped=threading.Event())
    box.empty = empty
    box.processes.end_orphans = lambda: None  # a browser of other tests may be one
    return box


def run_that_writes(box, status, output):
    """Return the run of a solution whose pytest has ended with this status and this output."""
    box.run_files = lambda *_: (status, output.encode())
    return box.run({}, jobs=2)


@pytest.mark.parametrize(
    ("status", "is_complete", "is_final"),
    [
        (0, True, True),
        (1, True, True),  # pytest had to end a thread
        (1, False, False),
        (one_run.LATE, True, False),
        (137, True, False),  # killed
    ],
)
def test_the_grade_of_a_run_that_came_to_its_end_is_final(box, status, is_complete, is_final):
    checks = {name: {**check, "state": "passed"} for name, check in box.empty["checks"].items()}
    grade = {**box.empty, "checks": checks, "final": is_complete}
    run = run_that_writes(box, status, json.dumps(grade))
    assert sum(run.grade["points"].values()) == POINTS
    assert run.problem == ""
    assert run.is_final == is_final


def test_a_run_without_a_whole_grade_has_none(box):
    checks = box.empty["checks"]
    fewer = dict([*checks.items()][1:])
    more = {**checks, "a": {}}
    other = dict.fromkeys(checks, 1)
    ends = [(1, json.dumps({**box.empty, "checks": form})) for form in (fewer, more, other)]
    ends += [(1, "[" * 100_000), (one_run.LATE, ""), ("it cannot be written", "")]
    problems = []
    for status, output in ends:
        run = run_that_writes(box, status, output)
        problems.append(run.problem)
        assert not run.is_final
        assert sum(run.grade["points"].values()) == 0
        assert run.grade["checks"].keys() == checks.keys()
    assert problems == [
        *["no grade: pytest ended with status 1"] * 4,
        "no grade: pytest took longer than 600 s",
        "no grade: it cannot be written",
    ]


def test_what_a_solution_says_is_short_and_has_no_codes_of_a_terminal(empty, tmp_path):
    texts = {"message": "\x1b[2J=1;2\n" + "x" * 50_000, "hint": "=1+1;=2"}
    output = {
        **empty,
        "checks": {name: {**check, **texts} for name, check in empty["checks"].items()},
        "next": "\t=1;2\x1b" + "y" * 50_000,
        "text": ["\x1b[2J\ud800" + "z" * 20_000] * 300,
    }
    grade = report.read_grade(empty, json.dumps(output).encode())
    table = report.Report()
    table.add(tmp_path, {"student": "@a;b", "seconds": 1.0, "problems": [], **grade})
    table.write(tmp_path)
    (row,) = rows_in(tmp_path).values()
    assert row["student"] == "'@a,b"
    assert row["next"].startswith("\\t=1,2\\x")
    assert (tmp_path / "grades.csv").stat().st_size < 3000
    text = (tmp_path / "@a;b.txt").read_text(encoding="utf-8")
    assert len(text) < 11_000
    assert text.replace("\n", "").isprintable()


def test_a_cell_is_no_formula():
    for name in ("=1", "-a", "@b", "+c", " =1"):
        assert report.cell(name) == f"'{name}"
    assert report.cell("Bea") == "Bea"


# --- the machine ---------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["beyond/a/b.py/c.py", "nul\0.py", "a/" * 1500 + "b.py"])
def test_files_that_cannot_be_written_are_told(box, name):
    run = box.run({"beyond/a/b.py": b"", name: b""}, jobs=2)
    assert run.problem.startswith("no grade: the files cannot be written: ")
    assert os.listdir(box.work) == []


def test_a_full_disk_costs_no_student_a_point(box, monkeypatch):
    """The cause may be another solution, whose files go.

    If it is still full later, this ends the class.
    """
    box.run_in = lambda *_: 1
    monkeypatch.setattr(shutil, "disk_usage", lambda _: Mock(free=1000))
    run = box.run({}, jobs=2)
    assert run.problem == "no grade: the disk was full"
    assert not run.is_final
    with pytest.raises(OSError, match=re.escape(f"No space left: '{box.work}'")):
        box.run({}, jobs=1, is_alone=True)
    assert os.listdir(box.work) == []


def test_a_solution_is_run_without_the_limits_that_a_system_refuses(tmp_path, monkeypatch, capfd):
    """macOS refuses DATA and AS with a ValueError, as remove() does here."""
    resource = pytest.importorskip("resource")
    names = ("CORE", "CPU", "FSIZE", "NOFILE", "NPROC", "NPROC")
    limits = [getattr(resource, f"RLIMIT_{name}") for name in names]
    monkeypatch.setattr(resource, "setrlimit", lambda number, _: limits.remove(number))
    monkeypatch.setattr(one_run, "PYTEST", "solution")
    monkeypatch.setattr(os, "geteuid", lambda: 1)
    monkeypatch.chdir(put_files(tmp_path, {"folder/solution.py": "print('it ran')"}))
    assert one_run.main(0, SECONDS, "folder") == 0
    assert capfd.readouterr().out == "it ran\n"
    assert limits == []


@on_posix
def test_a_solution_never_runs_as_root(monkeypatch):
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    with pytest.raises(PermissionError, match="a solution does not run as root"):
        one_run.main(0, SECONDS)


# Two processes outlive the first one. One makes its successor, and ends. The other one is traced by
# a third process.
LEFT_OVER = """
import ctypes, os, time
if not os.fork():
    os.setsid()
    while not os.fork():
        pass
    os._exit(0)
if not os.fork():
    os.setsid()
    traced = os.fork()
    if traced:
        ctypes.CDLL(None).ptrace(0x4206, traced, 0, 0)
    time.sleep(999)
time.sleep(1)
"""
RUNS = """
import sys
from teacher.processes import children, Processes
print(Processes().run(sys.executable, "-c", sys.argv[1]), children("self"))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="on other systems, nobody finds such processes")
def test_of_a_process_nothing_is_left():
    done = python("-c", RUNS, LEFT_OVER, PYTHONPATH=f"{ROOT / 'tests'}")
    assert done.stderr == ""
    assert done.stdout == "0 []\n"


FAMILY = """
import os, time
def take():
    taken = bytearray(5 * 10**7)
    time.sleep(1)
    os._exit(0)
children = [os.fork() or take() for _ in range(3)]
os._exit(any(os.waitpid(child, 0)[1] for child in children))
"""


def test_a_group_bounds_the_memory_of_all_processes_that_a_command_starts():
    """They have 100 MB, and three of them take 50 MB each."""
    group = memory.new_group(10**8)
    if group is None:
        pytest.skip("this user cannot make a group")
    group.rmdir()
    with memory.bounded([sys.executable, "-c", FAMILY], 10**8, has_systemd=False) as command:
        assert subprocess.run(command).returncode


# --- the others ----------------------------------------------------------------------------------


def contents(folder):
    return {path: path.read_bytes() for path in folder.rglob("*.*") if path.is_file()}


@on_posix
@pytest.mark.slow
@pytest.mark.parametrize("is_boxed", [pytest.param(True, marks=needs_bwrap), False])
def test_hostile_solutions_harm_nobody_else(classroom, solved, tmp_path, is_boxed):
    (tmp_path / "secret.txt").write_text("secret")
    names = ["secret.txt", "class/an honest one/src/swinging.py", "new.txt"]
    outside = [str(tmp_path / name) for name in names]
    options = [UNBOXED]
    unharmed = dict(HARMLESS)
    spoiled = dict(SPOILED)
    with socket.create_server(("127.0.0.1", 0)) as server:
        if is_boxed:
            options = []
            address = server.getsockname()
            in_vain = [
                *BOXED.values(),
                f"for path in {outside}: error_of(open, path, 'w')",
                f"for path in {outside}: assert not os.path.exists(path)",
                f"assert socket.socket().connect_ex({address})",
            ]
            unharmed["tries all in vain"] = "\n".join(in_vain)
            spoiled["kills all"] = "os.kill(-1, 9)"
        for student, code in {**unharmed, **spoiled}.items():
            swinging = solved["swinging.py"] + f"{HEADER}{code}".encode()
            classroom.hand_in(student, {**solved, "swinging.py": swinging})
        classroom.hand_in("an honest one", solved)
        main = solved["visualize_cradle_run.py"].replace(
            b"    page.show", b"    open(page.csv, 'w').close()\n    page.show"
        )
        classroom.hand_in("writes page.csv", {**solved, "visualize_cradle_run.py": main})
        before = contents(tmp_path)
        status, _, errors = classroom.grade(*options)
    assert status == 0, errors
    assert "Traceback" not in errors
    assert ("Without bubblewrap" in errors) != is_boxed
    rows = classroom.rows()
    points = {student: int(rows[student]["points"]) for student in ("an honest one", *unharmed)}
    assert points == dict.fromkeys(points, POINTS)
    graded = [student for student, row in rows.items() if "no grade" not in row["problems"]]
    assert sorted(classroom.results()) == sorted(graded)
    shutil.rmtree(classroom.grades)
    assert contents(tmp_path) == before
    classroom.require_clean()
