"""Grading a class: how submissions are read, what a solution costs its student, and what the teacher gets."""

import ast
import csv
import errno
import importlib
import json
import os
import shutil
import socket
import subprocess
import sys
import zipfile
from textwrap import dedent, indent
from unittest.mock import Mock

import grade_class
import make_autograder
import make_starter
import pytest
from grade_class import given_files
from programs import call, on_posix, ROOT, SECONDS, slow_but_for
from right_solutions import RIGHT
from students import change, COUNTS, files_of, imported_again, put_files, write
from wrong_solutions import HINTED, PLAIN
from wrong_solutions import OTHERS as UNNAMED

from grading import grader, limits, own_process, raised
from grading.grader import checks, Grading, Outcome, PASSED
from grading.handout import FUNCTIONS, SUITES
from grading.messages import message
from teacher import judge, report
from teacher.crossing import bounded, MOST_TEXT
from teacher.judge import Solver
from teacher.submissions import MOST_BYTES, MOST_FILES, read_submission, submissions_in

# --- submissions -----------------------------------------------------------------------------------------------------

SOLUTION = {function.file: f"# {function.file}\n" for function in FUNCTIONS.values()}
READ = {file.removeprefix("src/"): text.encode() for file, text in SOLUTION.items()}


def below(folder, files=SOLUTION):
    """Return files as they are one level deeper."""
    return {f"{folder}/{name}": text for name, text in files.items()}


OTHERS = {"README.md": "text", "support/swinging.py": "mine", ".venv/lib/swinging.py": "x", "tests/swinging.py": "mine"}
PROJECT = {**SOLUTION, **OTHERS}
MAC = {**below("cradle", PROJECT), **{f"__MACOSX/{name}": "mac" for name in below("cradle")}}
MORE = {"src/helpers/angles.py": "a", "src/notes.txt": "n", "src/__pycache__/x.py": "x"}
NAMED = {name.replace("swinging", "Swinging (1)"): text for name, text in SOLUTION.items()}
NAMED_READ = {name.replace("swinging", "Swinging (1)"): text for name, text in READ.items()}
OUTSIDE = ["../src/swinging.py", "src/../../swinging.py", "..\\src\\swinging.py", "C:/swinging.py"]
NONE = "none of the handout's files is there; found: "
FORMS = {  # the files of a submission, those that count, and the problem
    "the files of src": (READ, READ, None),
    "a project of macOS": (MAC, READ, None),
    "more files": ({**SOLUTION, **MORE}, {**READ, "helpers/angles.py": b"a"}, None),
    "paths that lead outside": ({**SOLUTION, **dict.fromkeys(OUTSIDE, "x")}, READ, None),
    "two projects": ({**below("new"), "old/src/swinging.py": "old"}, READ, "took new/src, left old/src"),
    "another name": (NAMED, NAMED_READ, "src/swinging.py is missing, found 'Swinging (1).py'"),
    "nothing": ({}, {}, f"{NONE}nothing"),
    "something else": ({"b.txt": "b", "essay.docx": "a"}, {}, f"{NONE}b.txt, essay.docx"),
    "much": ({**SOLUTION, "src/big.py": "#" * MOST_BYTES}, {}, "too large: found 6 Python files, allowed are at most"),
    "many": ({**SOLUTION, **{f"src/a{i}.py": "" for i in range(MOST_FILES)}}, {}, "too large: found 205 Python files"),
}


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("place", ["ann", "ann.zip", "ann/cradle.zip"])
def test_the_files_of_src_are_found_and_problems_named(tmp_path, name, place):
    files, found, problem = FORMS[name]
    (tmp_path / "ann").mkdir()
    if place.endswith(".zip"):
        with zipfile.ZipFile(tmp_path / place, "w", zipfile.ZIP_DEFLATED) as archive:
            for path, text in files.items():
                archive.writestr(path, text)
    else:
        put_files(tmp_path / place, files)
    student, read, problems = read_submission("ann", tmp_path / place.removesuffix("/cradle.zip"))
    assert (student, read) == ("ann", found)
    assert [each.startswith(problem) for each in problems] == [True] if problem else problems == []


def test_a_damaged_zip_is_a_problem(tmp_path):
    """The names in it can be read, but not the content."""
    with zipfile.ZipFile(tmp_path / "ann.zip", "w", zipfile.ZIP_LZMA) as archive:
        archive.writestr("src/swinging.py", "angle = 1\n" * 100)
    data = (tmp_path / "ann.zip").read_bytes()
    (tmp_path / "ann.zip").write_bytes(data[:60] + b"damaged" + data[67:])
    (problem,) = read_submission("ann", tmp_path / "ann.zip").problems
    assert problem.startswith("ann.zip is no .zip that can be read: ")


@on_posix
def test_pipes_and_links_are_not_read(tmp_path):
    """A link could lead to another student's files."""
    folder = put_files(tmp_path, {"secret.py": "secret", "ann/src/pds_helper.py": "a"}) / "ann"
    (folder / "src" / "swinging.py").symlink_to(tmp_path / "secret.py")
    (folder / "src" / "folder").symlink_to(tmp_path)
    os.mkfifo(folder / "src" / "special_cradles.py")
    read = read_submission("ann", folder)
    assert read.files == {"pds_helper.py": b"a"}
    assert {"src/special_cradles.py is missing", "src/swinging.py is missing"} <= {*read.problems}


def test_each_folder_and_each_archive_is_a_student(tmp_path):
    """Letters of a name that cannot be printed are spelled out."""
    for name in ("ann", "Bea B", ".git", "__MACOSX", "a\nb"):
        (tmp_path / name).mkdir()
    put_files(tmp_path, {"ann.zip": "", "cem.ZIP": "", "dan.rar": "", "index.html": "", "a\tb/c\nd/e\nf": ""})
    found, others = submissions_in(tmp_path)
    students = {"Bea B": "Bea B", "ann": "ann", "ann.zip": "ann.zip", "cem": "cem.ZIP", "dan": "dan.rar"}
    assert {name: path.name for name, path in found.items()} == {**students, r"a\tb": "a\tb", r"a\nb": "a\nb"}
    assert others == ["index.html"]
    (problem,) = read_submission("dan", found["dan"]).problems
    assert problem == "dan.rar is no .zip that can be read: File is not a zip file"
    assert read_submission("a", found[r"a\tb"]).problems == [rf"{NONE}c\nd/e\nf"]


@pytest.mark.parametrize("files", [{}, {"index.html": "a"}, PROJECT, READ], ids=["nothing", "a file", "project", "src"])
def test_a_folder_that_is_no_class_is_refused(tmp_path, files):
    with pytest.raises(ValueError, match="allowed is a folder with a folder or a .zip for each student"):
        submissions_in(put_files(tmp_path, files))


# --- solutions -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["a" * 300 + ".py", "beyond/a/b.py/c.py", "nul\0.py"])
def test_a_name_that_cannot_be_written_costs_that_solution(grade, solved, name):
    outcomes, _, problems = grade({"beyond/a/b.py": b"", **solved, name: b""})
    assert outcomes == {}
    assert problems[0].startswith("the files cannot be written: ")


def test_a_full_disk_stops_the_class(grade, solved, monkeypatch):
    """It costs no student a point."""
    monkeypatch.setattr("test_d.TemporaryDirectory", Mock(side_effect=OSError(errno.ENOSPC, "Full")))
    with pytest.raises(OSError, match="Full"):
        grade(solved)


# --- the program -----------------------------------------------------------------------------------------------------


@pytest.fixture
def main(made, process, monkeypatch, capsys):
    """A function that runs grade_class.py, or another program, in this process; it returns (status, stdout, stderr)."""

    def side_by_side(to_grade, given, *_):
        grade_class.JUDGE.update(given=given, process=process)
        yield from (grade_class.graded(*each) for each in to_grade)

    monkeypatch.setattr(grade_class, "side_by_side", side_by_side)
    monkeypatch.setattr(make_starter, "make_starter", lambda folder: shutil.copytree(made, folder))

    def main(*arguments, program=grade_class):
        monkeypatch.setattr(sys, "argv", [program.__name__ + ".py", *map(str, arguments)])
        return call(program.main, capsys)

    return main


def tables_of(folder):
    """Return the rows of grades.csv and the results in results.jsonl, each by student."""
    with open(folder / "grades.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    results = [json.loads(line) for line in (folder / "results.jsonl").read_text(encoding="utf-8").splitlines()]
    return tuple({each["student"]: each for each in table} for table in (rows, results))


@on_posix
def test_a_class_that_is_interrupted_and_goes_on(solved, starter, tmp_path, main, monkeypatch):
    a_class, out, calls = tmp_path / "class", tmp_path / "class-grades", []
    write(starter, "extract_and_convert", "double_angle_update")
    for student, files in {"ann": solved, "bea": solved, "cem": files_of(starter)}.items():
        put_files(a_class / student / "src", files)
    change(a_class / "bea" / "src" / "swinging.py", "omega + -g", "omega + g")
    (a_class / "dan").mkdir()

    def grade(*arguments):
        calls.append(arguments)
        if len(calls) > 2:
            raise KeyboardInterrupt
        return original(*arguments)

    original = judge.grade
    with monkeypatch.context() as patches:
        patches.setattr(judge, "grade", grade)
        assert main(a_class) == (130, "2 of 4 solutions are graded. The same command goes on from there.\n", "")
    rows, first = tables_of(out)
    assert set(rows) == set(first) == {"ann", "bea"}

    with open(out / "results.jsonl", "a") as file:
        file.write('{"student": "dan", "dig')  # not whole
    status, printed, errors = main(a_class, "--gradescope", tmp_path / "gradescope")
    assert (status, errors) == (0, "")
    rows, results = tables_of(out)
    assert {student: results[student] for student in first} == first  # also the seconds: not graded again
    convert, double = (len(checks(function=name)) for name in ("extract_and_convert", "double_angle_update"))
    assert [(row["student"], row["grade"], *(int(row[tier]) for tier in SUITES)) for row in rows.values()] == [
        ("ann", "Honor roll", *COUNTS.values()),
        ("bea", "D", COUNTS["D"], 0, COUNTS["B"], 0, COUNTS["Honor roll"]),
        ("cem", "none", convert, 0, 0, 0, double),
        ("dan", "none", 0, 0, 0, 0, 0),
    ]
    assert tuple(row["problems"] for row in rows.values()) == ("", "", "", f"{NONE}nothing")
    assert rows["bea"]["next"].startswith("angle_update in src/swinging.py, line ")
    for student, words in [("ann", "Grade: Honor roll."), ("bea", "Grade: D.")]:
        assert words in (out / f"{student}.txt").read_text(encoding="utf-8")
    assert "    1  The sign of gravity is wrong. Gravity pulls the bob back down. (angle_update)\n" in printed
    assert "Honor roll           1\n" in printed

    result = json.loads((tmp_path / "gradescope" / "bea" / "results.json").read_text())
    (test,) = (test for test in result["tests"] if test["name"].startswith("C: angle_update: Takes in"))
    assert (test["score"], test["max_score"], test["visibility"]) == (0, 1, "visible")
    assert "wrong       omega_new is 4, not 2." in test["output"]
    assert (result["score"], result["max_score"], sum(test["score"] for test in result["tests"])) == (35, 53, 35)

    first, *others = (out / "results.jsonl").read_text().splitlines()
    damaged = [first.replace('"passed"', way) for way in ("1", "null", '"excellent"', '{"a": []}')]
    damaged += [first.replace('"seconds": ', '"seconds": "x'), "[" * 100_000]
    shutil.rmtree(a_class / "bea")
    (out / "results.jsonl").write_text("\n".join([*damaged, *others]))
    assert main(a_class)[0] == 0
    rows, results = tables_of(out)
    assert [*rows] == ["ann", "cem", "dan"]
    assert rows["ann"]["grade"] == "Honor roll"
    assert not (out / "bea.txt").exists()  # of who is gone, nothing is left


def test_names_are_safe_in_files_and_in_tables(tmp_path):
    names = ["Bea B", "Ünal (2)", "=1+1", "a/../b", "x" * 252, "\u00e9" * 252, "con.", "-a", "@b", "+c", ""]
    files = [report.file_name(name) for name in names]
    assert files[:2] == names[:2]
    assert len(set(files)) == len(names)
    for file in files:
        (tmp_path / f"{file}.txt").write_text("a")
    assert [report.cell(name)[:1] for name in ("=1", "-a", "@b", "+c", "\t=1", "Bea")] == ["'"] * 5 + ["B"]


def test_a_solutions_words_forge_no_line_and_no_code_of_a_terminal():
    assert message([("read", ["a\nb"])]) == "read        a\n            b"
    assert bounded("\x1b[2J\ud800\n" + "a" * 9999) == "\\x1b[2J\\ud800\n" + "a" * (MOST_TEXT - 6)


# --- the real program, with attackers in the class -------------------------------------------------------------------

IMPORTED = {  # what they add to a starter with nothing written
    "states": "from grading import grader\ngrader.FAILED = grader.FAULT = grader.WAITING = 'passed'",
    "alone": "from grading.grader import ALONE\nALONE.append(-1)",
    "outcome": "from grading.grader import Outcome\nOutcome.state = property(lambda outcome: 'passed')",
    "frames": """
import sys
frame = sys._getframe()
while frame:
    for value in [*frame.f_locals.values()]:
        if hasattr(value, 'outcomes') or hasattr(value, 'ALONE'):
            value.outcomes = value.ALONE = 1
    frame = frame.f_back
""",
    "modules": """
import sys, grading.own_process, grading.raised
for module in [*sys.modules.values()]:
    for name in ('FAILED', 'WAITING', 'FAULT'):
        setattr(module, name, 'passed')
grading.raised.raised_by = lambda error: None
grading.own_process.OwnProcess.run = lambda *_, **__: (2.0, 2.81799)
""",
}
OUTSIDE = """
import os, sqlite3, sys
def tried(function, *arguments, **options):
    try:
        return function(*arguments, **options)
    except BaseException as error:
        return error
folder = {folder!r}
for path in (folder + '/secret.txt', folder + '/class/ann/src/swinging.py'):
    print(tried(lambda: open(path).read()))
tried(lambda: open(folder + '/secret.txt', 'w'))
print(tried(lambda: os.open('secret.txt', os.O_RDWR | os.O_TRUNC, dir_fd=os.open(folder, os.O_RDONLY))))
tried(lambda: sqlite3.connect(folder + '/secret.txt').execute('create table a (b)'))
tried(os.mkfifo, folder + '/pipe')
tried(os.setxattr, folder, 'user.a', b'b')
tried(lambda: __import__('readline').write_history_file(folder + '/secret.txt'))
interpreters = tried(__import__, '_interpreters' if sys.version_info >= (3, 13) else '_xxsubinterpreters')
tried(lambda: interpreters.run_string(interpreters.create(), "open('" + folder + "/secret.txt', 'w')"))
tried(lambda: __import__('subprocess').run(['touch', folder + '/started']))
in_sandbox = os.environ['HOME'] == '/cradle'  # elsewhere, the processes are somebody's
for number in (1, os.getppid(), *range(100, 300)) if in_sandbox else ():  # below, there are threads of its own
    if number != os.getpid():
        tried(os.kill, number, 9)
        tried(lambda: __import__('signal').pidfd_send_signal(os.pidfd_open(number), 9))
        tried(lambda: __import__('resource').prlimit(number, 0, (1, 1)))
print(tried(lambda: __import__('socket').create_connection(('127.0.0.1', {port}), 1)))
"""
FIRST = "    omega_new = "  # in angle_update
BODIES = {  # come before it
    "floods": """
import contextlib, os
while True:
    for fd in range(3, 20):
        with contextlib.suppress(OSError):
            os.write(fd, b'x\\n')
""",
    "hangs": "import signal\nsignal.pthread_sigmask(signal.SIG_BLOCK, [2])\nwhile True: pass",
    "dies": "import signal\nsignal.raise_signal(9)",
    "forks": "import os\nwhile True:\n  try: os.fork()\n  except OSError: pass",
    "grows": "rows = [0]\nwhile True: rows += rows",
    "nests": "a = [0, 0]\nfor _ in range(60): a = [a, a]\nreturn a",
}
ODD = {  # their names, and what they add to this file of a complete solution
    ("closes", "swinging.py"): "import sys\nsys.stdout.close()",
    ("links", "swinging.py"): "import os\nos.symlink('/dev', os.environ['HOME'] + '/link')",
    ("code", "pds_helper.py"): """
import contextlib, time
class Function:
    __call__ = lambda self, file: 5
    @property
    def __code__(self):
        while True:
            with contextlib.suppress(BaseException):
                time.sleep(100)
extract_and_convert = Function()
""",
    ("letters", "pds_helper.py"): """
class Odd:
    __repr__ = lambda self: 'a\\ud800b'
extract_and_convert = lambda file: Odd()
""",
    ("vectors", "double_cradle.py"): """
original = make_double_pendulum
def make_double_pendulum(axle_pos, r_param, theta, phi, color, texture):
    axle_pos.x = color.x = 1e18
    return original(axle_pos, r_param, 0, 0, color, texture)
""",
}
SAID = {
    "floods": "gave an answer that the grader cannot read",
    "hangs": "took longer than 5 s",
    "dies": "ended its process (signal 9)",
    "grows": "took more than 1000 MB of memory",
}


@on_posix
def test_attackers_in_a_class_get_what_their_code_deserves(made, solved, tmp_path):
    """Honest students beside them get all their points, nothing outside changes, and nothing hangs."""
    a_class, ours = tmp_path / "class", {name: content.decode() for name, content in solved.items()}
    empty = {name: content.decode() for name, content in files_of(made).items()}
    secret = put_files(tmp_path, {"secret.txt": "secret"}) / "secret.txt"
    listening = socket.create_server(("127.0.0.1", 0))
    outside = OUTSIDE.format(folder=str(tmp_path), port=listening.getsockname()[1])

    students = dict.fromkeys(["ann", "zoe", "=1+1", "x" * 252], ours)
    for name, text in IMPORTED.items():
        students[f"empty {name}"] = {**empty, "pds_helper.py": f"{text}\n{empty['pds_helper.py']}"}
    for (name, file), text in {**ODD, ("outside", "swinging.py"): outside}.items():
        students[name] = {**ours, file: f"{ours[file]}\n{text}\n"}
    for name, body in BODIES.items():
        changed = ours["swinging.py"].replace(FIRST, f"{indent(body, '    ')}\n{FIRST}", 1)
        students[name] = {**ours, "swinging.py": changed}
    for student, files in students.items():
        put_files(a_class / student / "src", files)
    os.mkfifo(a_class / "pipe.zip")

    device = os.stat(os.devnull).st_mode
    command = [sys.executable, ROOT / "tests" / "grade_class.py", a_class]
    done = subprocess.run(command, capture_output=True, text=True, timeout=4 * SECONDS)
    assert done.returncode == 0, done.stderr
    rows, results = tables_of(tmp_path / "class-grades")
    points = {student.removeprefix("'"): int(row["points"]) for student, row in rows.items()}
    full, rest = sum(COUNTS.values()), sum(COUNTS.values()) - COUNTS["C"] - COUNTS["A"]
    expected = dict.fromkeys([*(f"empty {name}" for name in IMPORTED), "pipe"], 0) | dict.fromkeys(BODIES, rest)
    expected |= {**dict.fromkeys(["code", "letters"], full - COUNTS["D"] - 4), "vectors": full - 3}
    assert {student: number for student, number in points.items() if number != full} == expected
    assert rows["pipe"]["problems"] == "cannot be read: pipe.zip is neither a folder nor a plain file"
    assert "'=1+1" in rows
    for student, said in SAID.items():
        assert f"angle_update {said}" in " ".join(each[1] for each in results[student]["outcomes"].values())
    assert os.stat(os.devnull).st_mode == device
    if "Without bubblewrap" not in done.stderr:
        assert secret.read_text() == "secret"
        assert "secret" not in (tmp_path / "class-grades" / "outside.txt").read_text().replace("secret.txt", "")
        assert sorted(path.name for path in tmp_path.iterdir()) == ["class", "class-grades", "secret.txt"]


@pytest.mark.parametrize(
    ("program", "arguments", "words"),
    [
        (grade_class, "nowhere", "argument SUBMISSIONS: nowhere: No such file or directory"),
        (grade_class, "class/ann", "argument SUBMISSIONS: found '{here}/class/ann', allowed is a folder with"),
        (grade_class, "class --out class/grades", "argument --out: found 'class/grades', allowed is a folder outside"),
        (grade_class, "class --starter class", "argument --starter: found 'class', allowed is a folder made by"),
        (grade_class, "class --out file.zip", "file.zip: File exists"),
        (make_autograder, "file.zip", "argument FILE.zip: found 'file.zip', allowed is a new file that ends in .zip"),
        (make_autograder, "cradle.tar", "argument FILE.zip: found 'cradle.tar', allowed is a new file"),
        (make_autograder, "nowhere/cradle.zip", "nowhere/cradle.zip cannot be made: No such file or directory"),
        (make_starter, "class", "found 'class', allowed is a new or an empty folder"),
        (make_starter, "file.zip/new", "argument FOLDER: file.zip/new cannot be made: Not a directory"),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(tmp_path, monkeypatch, main, program, arguments, words):
    monkeypatch.chdir(tmp_path)
    put_files(tmp_path, {"file.zip": "mine", "class/ann/a.txt": ""})
    status, printed, errors = main(*arguments.split(), program=program)
    assert (status, printed, errors.count("\n")) == (2, "", 1)
    assert words.format(here=tmp_path) in errors
    assert (tmp_path / "file.zip").read_text() == "mine"


# --- Gradescope ------------------------------------------------------------------------------------------------------


@on_posix
@pytest.mark.parametrize("installs", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_the_autograder_grades_a_solution_and_holds_no_answers(tmp_path, main, solved, installs):
    """Without an installation, this Python stands in for that of the autograder."""
    assert main(tmp_path / "cradle.zip", program=make_autograder)[::2] == (0, "")
    with zipfile.ZipFile(tmp_path / "cradle.zip") as archive:
        modes = {info.filename: info.external_attr >> 16 for info in archive.infolist()}
        archive.extractall(tmp_path / "source")
    assert modes["run_autograder"] & modes["setup.sh"] & 0o111 == 0o111
    assert "angle_update is not written yet" in (tmp_path / "source" / "src" / "swinging.py").read_text()
    assert not (tmp_path / "source" / "tests" / "project").exists()

    put_files(tmp_path / "venv" / "bin", {"python": f'#!/bin/sh\nexec "{sys.executable}" "$@"\n'})
    (tmp_path / "venv" / "bin" / "python").chmod(0o755)
    put_files(tmp_path / "submission" / "src", {"pds_helper.py": solved["pds_helper.py"]})
    shutil.copy(tmp_path / "source" / "run_autograder", tmp_path)
    if installs:
        shutil.rmtree(tmp_path / "venv")
        subprocess.run(["bash", tmp_path / "source" / "setup.sh"], check=True, capture_output=True)
    subprocess.run(["bash", tmp_path / "run_autograder"], check=True, capture_output=True, timeout=2 * SECONDS)
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    assert (results["score"], results["max_score"]) == (4, 53)


# --- the judge and the solver say the same as pytest in one process --------------------------------------------------

SOLUTIONS = {
    (function, words): version
    for table in (HINTED, UNNAMED, RIGHT)
    for function, versions in table.items()
    for words, version in versions.items()
}


def with_body(files, function, body):
    """Return the files of a solution with another body of a function."""
    name = FUNCTIONS[function].file
    lines = files[name].decode().splitlines()
    (node,) = (node for node in ast.parse(files[name]).body if getattr(node, "name", "") == function)
    lines[node.body[0].end_lineno : node.end_lineno] = indent(dedent(body).strip("\n"), "    ").splitlines()
    names = "from math import cos, sin", "from vpython import mag, vector"  # so that no row needs to import them
    return {**files, name: "\n".join([*names, *lines, ""]).encode()}


@pytest.fixture
def files(made, solved):
    """The files of a complete solution, by their paths in the project."""
    return {**given_files(made), **{f"src/{name}": content for name, content in solved.items()}}


def outcomes_of(function):
    """Return the outcomes of the checks of this function. All others count as passed."""
    grading = Grading()
    grading.outcomes = {check.name: Outcome(PASSED) for check in grader.CHECKS.values() if check.function != function}
    return {check.name: grading.judge(check) for check in checks(function=function)}


@pytest.fixture
def judged(process, monkeypatch):
    """A function that returns the outcomes of a solution of this function in a solver."""

    def judged(files, function):
        solver = Solver(files, process)
        monkeypatch.setattr(grader, "runner", solver)
        try:
            solver.open()
            return outcomes_of(function)
        finally:
            process.end()

    return judged


@pytest.fixture
def graded_here(tmp_path, monkeypatch):
    """A function that returns the outcomes of a solution of this function in this process."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setattr(limits, "PATIENCE", 60.0)  # also of the solver; a busy machine can stall for seconds
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(raised, "ROOT", tmp_path)

    def graded_here(files, function):
        put_files(tmp_path, files)
        monkeypatch.setattr(grader, "runner", own_process.OwnProcess())
        importlib.invalidate_caches()
        with imported_again():
            return outcomes_of(function)

    return graded_here


@pytest.mark.parametrize(("function", "words"), slow_but_for([*SOLUTIONS][::9], [*SOLUTIONS]))
def test_a_solver_gives_the_same_outcomes_and_words_as_one_process(files, judged, graded_here, function, words):
    version = SOLUTIONS[function, words]
    body = PLAIN[function].replace(*version) if isinstance(version, tuple) else version
    files = with_body(files, function, body)
    assert judged(files, function) == graded_here(files, function)
