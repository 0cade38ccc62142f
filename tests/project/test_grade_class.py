"""Grading a class: what a solution does costs its own points only, and the teacher gets the files and the summary."""

import csv
import json
import os
import shutil
import signal
import subprocess
import sys
import zipfile

import pytest
from programs import ROOT, SECONDS, slow_but_for, wait_until
from students import write_all
from test_starter import ALL, made, start  # noqa: F401

from grading.grader import CHECKS, checks, FAILED, Outcome, PASSED
from grading.handout import FUNCTIONS, SUITES
from teacher import workers
from teacher.alike import body_of, fingerprint, groups_of
from teacher.report import collect, mistakes_of, Result, summary

PROGRAM = ROOT / "tests" / "grade_class.py"
COMPLETE = {tier: (count, count) for tier, count in ALL.items()}  # points, and points in all

for tier in SUITES:
    checks(tier=tier)


@pytest.fixture(scope="module")
def solved(made, tmp_path_factory):  # noqa: F811
    """The files of a complete solution, by their paths below src/."""
    folder = shutil.copytree(made, tmp_path_factory.mktemp("solved") / "starter")
    write_all(folder)
    names = {function.file.removeprefix("src/") for function in FUNCTIONS.values()}
    return {name: (folder / "src" / name).read_bytes() for name in sorted(names)}


@pytest.fixture(scope="module")
def worker(made):  # noqa: F811
    worker = workers.Worker(made)
    yield worker
    worker.close()


def swinging(solved, called="", imported="", instead=None):
    """Return the solution with code in angle_update (called), at the end of its file (imported), or with other code."""
    line = "    omega_new = omega + -g * sin(theta) / r_param * dt\n"
    text = solved["swinging.py"].decode()
    assert line in text
    text = text.replace(line, f"    {called}\n{instead or line}")
    return {**solved, "swinging.py": f"{text}\n{imported}\n".encode()}


def points(outcomes):
    """Return the points of each tier, and those that it could have."""
    names = {tier: [check.name for check in checks(tier=tier)] for tier in SUITES}
    passed = {name for name, outcome in outcomes.items() if outcome.state == PASSED}
    return {tier: (len(passed.intersection(of)), len(of)) for tier, of in names.items()}


# --- a process of its own --------------------------------------------------------------------------------------------

# A mistake in angle_update costs the points of the functions that use it: C and A.
WITHOUT_ANGLE_UPDATE = {**COMPLETE, "C": (0, 6), "A": (0, 12)}

# What angle_update does, and what the student reads.
ATTACKS = {
    "fork": ("import os; os.fork()", "the grader refuses os.fork"),
    "fork for ever": ("import os\n    while True: os.fork()", "the grader refuses os.fork"),
    "processes": ("import subprocess, sys; subprocess.run([sys.executable])", "the grader refuses subprocess.Popen"),
    "shell": ("import os; os.system('true')", "the grader refuses os.system"),
    "network": ("import socket; socket.create_connection(('localhost', 9))", "the grader refuses socket."),
    "C": ("import ctypes; ctypes.CDLL(None)", "the grader refuses ctypes.dlopen"),
    "the grader's process": ("import os; os.kill(os.getppid(), 9)", "the grader refuses signals to other processes"),
    "outside": ("open('../mine.txt', 'w')", "the grader refuses writing outside of the project's folder: ../mine.txt"),
    "outside, removed": ("import os; os.remove('../mine.txt')", "the grader refuses os.remove outside of the project"),
    "processes by the back door": (
        "import multiprocessing.util as util; util.spawnv_passfds(b'/bin/true', [b'true'], [])",
        "the grader refuses new processes",
    ),
    "the answers": (
        f"open({str(ROOT / 'src' / 'swinging.py')!r})",
        "the grader refuses reading outside of the project",
    ),
    "many files": (
        "[open(f'{i}.txt', 'w').close() for i in range(2000)]",
        "the grader refuses more than 1000 changes of files",
    ),
    "a long file": ("open('long.txt', 'w').write('a' * 20_000_000)", "File too large"),
    "much output": ("while True: print('a' * 1000)", "File too large"),
    "much memory": ("[0] * 10**9", "it took more than 1000 MB of memory"),
    "sys.exit": ("import sys; sys.exit(0)", "SystemExit"),
    "os._exit": ("import os; os._exit(0)", "SystemExit"),
    "no files left": ("import os; os.closerange(0, 100)", None),
    "a folder that is removed": ("import shutil; shutil.rmtree('.')", None),
    "a folder that is read-only": ("import os; os.chmod('.', 0o500); 1 / 0", "ZeroDivisionError"),
}


@pytest.mark.skipif(not hasattr(os, "fork"), reason="Windows has neither these calls nor these limits")
@pytest.mark.parametrize("name", slow_but_for(["fork for ever", "outside", "the answers", "much memory"], ATTACKS))
def test_an_attack_costs_the_points_of_its_function(worker, solved, name):
    code, words = ATTACKS[name]
    graded = worker.grade(swinging(solved, code))
    if words:
        assert points(graded.outcomes) == WITHOUT_ANGLE_UPDATE
        assert words in graded.outcomes["test_angle_update"].message
        assert words in graded.output
    assert graded.outcomes["test_angle_update"].state == FAILED


def test_no_file_of_an_open_folder_is_removed(worker, solved):
    """This is how shutil.rmtree removes files."""
    graded = worker.grade(swinging(solved, "import os; os.remove('no such file', dir_fd=os.open('/', os.O_RDONLY))"))
    assert "the grader refuses os.remove outside" in graded.outcomes["test_angle_update"].message


def test_a_solution_can_change_its_own_files(worker, solved):
    code = "import os; open('a', 'w').close(); os.truncate('a', 0); os.rename('a', 'b'); os.remove('b')"
    graded = worker.grade(swinging(solved, code))  # for A, there are more than 1000 changes
    assert points(graded.outcomes)["C"] == COMPLETE["C"]


def test_who_presses_ctrl_c_keeps_the_points_of_the_other_functions(worker, solved):
    graded = worker.grade(swinging(solved, "import signal; signal.raise_signal(signal.SIGINT)"))
    assert points(graded.outcomes) == WITHOUT_ANGLE_UPDATE
    assert graded.problems == ["angle_update ended the process (status 2)"]


GARBAGE = """
    import os, signal
    for fd in range(3, 30):
        try:
            os.write(fd, b"x")
        except OSError:
            pass
    signal.raise_signal(signal.SIGKILL)
"""


def test_the_end_of_a_process_is_heard_after_half_a_line(worker, solved):
    assert worker.grade(swinging(solved, GARBAGE)).problems == ["angle_update ended the process (signal 9)"]


KILL = "import signal; signal.raise_signal(signal.SIGKILL)"


@pytest.mark.parametrize("code", slow_but_for([KILL], [KILL, "import faulthandler; faulthandler._sigsegv()"]))
def test_who_ends_the_process_keeps_the_points_of_the_other_functions(worker, solved, code):
    graded = worker.grade(swinging(solved, code))
    assert points(graded.outcomes) == WITHOUT_ANGLE_UPDATE
    assert len(graded.problems) == 1
    assert graded.problems[0].startswith("angle_update ended the process (signal ")
    assert "not called  angle_update ended the process (signal" in graded.outcomes["test_angle_update"].message
    assert "not called  angle_update ended the process (signal" in graded.output


@pytest.mark.slow
def test_who_ends_the_process_at_the_import_loses_the_file(worker, solved):
    graded = worker.grade(swinging(solved, imported=KILL))
    assert points(graded.outcomes)["C"] == (0, 6)
    assert points(graded.outcomes)["D"] == COMPLETE["D"]
    assert graded.problems[0].startswith("angle_update ended the process")


@pytest.mark.slow
def test_a_call_into_c_that_never_ends_is_ended(worker, solved, monkeypatch):
    """Python cannot interrupt it."""
    monkeypatch.setattr(workers, "SILENCE", 10.0)
    graded = worker.grade(swinging(solved, "sum(range(10**12))"))
    assert points(graded.outcomes) == WITHOUT_ANGLE_UPDATE
    assert graded.problems == ["angle_update did not end within 10 s"]


FORGED = """
    import json, os
    names = %r
    lines = [json.dumps({"key": key, "check": name, "outcome": ["passed", "", ""]}) for name in names
             for key in ("", "0")]
    for fd in range(30):
        try:
            os.write(fd, ("\\n" + "\\n".join(lines) + "\\n").encode())
        except OSError:
            pass
    print("tier  passed\\nD 16 16/16\\nGrade: Honor roll.")
    open("grade.json", "w").write('{"grade": "Honor roll"}')
"""
WRONG = "    omega_new = omega + g * sin(theta) / r_param * dt\n"


def test_an_answer_cannot_be_forged_by_what_a_solution_writes(worker, solved):
    graded = worker.grade(swinging(solved, FORGED % list(CHECKS), instead=WRONG))
    assert points(graded.outcomes) == WITHOUT_ANGLE_UPDATE
    assert "The sign of gravity is wrong." in graded.outcomes["test_angle_update"].message


PATCHES = {
    "grading.grader.same": "import grading.grader as grader; grader.same = lambda *_: True",
    "grading.grader.Grading.make": "from grading.grader import Grading, Outcome; Grading.make = lambda *_: Outcome('')",
    "grading.grader.fits": "from grading import grader; grader.fits.__code__ = (lambda came, wanted: True).__code__",
    "os.write": "import os; w = os.write; os.write = lambda fd, t: w(fd, t.replace(b'failed', b'passed'))",
    "builtins.abs": "import builtins; builtins.abs = lambda value: 0",
    "math.isclose": "import math; math.isclose = lambda *_, **__: True",
    "support.headless_vpython.vector": "import vpython; vpython.vector = list",
}


@pytest.mark.parametrize("name", slow_but_for(["grading.grader.same", "os.write"], PATCHES))
def test_who_changes_the_grader_gets_no_points(worker, solved, name):
    graded = worker.grade(swinging(solved, imported=PATCHES[name], instead=WRONG))
    assert {outcome.state for outcome in graded.outcomes.values()} == {FAILED}
    assert graded.problems == [f"the solution has changed the grader ({name}): no points"]


@pytest.mark.parametrize("name", ["a" * 300 + ".py", "beyond/a/b.py/c.py", "nul\0.py"])
def test_a_name_that_cannot_be_written_costs_that_solution(worker, solved, name):
    graded = worker.grade({"beyond/a/b.py": b"", **solved, name: b""})
    assert graded.outcomes == {}
    assert graded.problems[0].startswith(f"src/{name} cannot be written: ")


def test_after_all_that_a_complete_solution_has_all_points(worker, solved):
    graded = worker.grade(solved)
    assert points(graded.outcomes) == COMPLETE
    assert graded.problems == []
    assert "Grade: Honor roll." in graded.output


# --- the program -----------------------------------------------------------------------------------------------------


def put(folder, files):
    for name, content in files.items():
        (folder / "src" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "src" / name).write_bytes(content)


@pytest.fixture
def a_class(tmp_path, solved):
    """Five submissions: complete, with a mistake, the same mistake in other words, a .zip, and nothing."""
    folder = tmp_path / "class"
    wrong = swinging(solved, instead=WRONG)
    renamed = {**wrong, "swinging.py": wrong["swinging.py"].replace(b"omega_new", b"speed") + b"# of mine\n"}
    put(folder / "ann", solved)
    put(folder / "bea", wrong)
    put(folder / "cem", renamed)
    (folder / "dan").mkdir()
    with zipfile.ZipFile(folder / "eva.zip", "w") as archive:
        for name, content in solved.items():
            archive.writestr(f"eva/src/{name}", content)
    return folder


def rows_of(folder):
    with open(folder / "grades.csv", encoding="utf-8", newline="") as file:
        return {row["student"]: row for row in csv.DictReader(file)}


def results_of(folder):
    lines = (folder / "results.jsonl").read_text(encoding="utf-8").splitlines()
    return {json.loads(line)["student"]: json.loads(line) for line in lines}


def test_a_class_that_is_interrupted_and_goes_on(a_class, tmp_path):
    out = tmp_path / "class-grades"
    process = subprocess.Popen(
        [sys.executable, PROGRAM, a_class], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    wait_until(lambda: (out / "results.jsonl").exists() and results_of(out))
    process.send_signal(signal.SIGINT)
    told, errors = process.communicate(timeout=SECONDS)
    first = results_of(out)
    assert (process.returncode, errors) == (130, "")
    assert told == f"{len(first)} of 5 solutions are graded. The same command goes on from there.\n"
    assert set(rows_of(out)) == set(first)
    assert len(first) < 5

    (out / "results.jsonl").write_text((out / "results.jsonl").read_text() + '{"student": "dan", "dig')  # not whole
    options = ["--gradescope", tmp_path / "gradescope", "--collect", tmp_path / "collected.py"]
    done = start(PROGRAM, a_class, *options, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    results = results_of(out)
    assert {student: results[student] for student in first} == first  # also the seconds: not graded again
    rows = rows_of(out)
    assert {student: (row["grade"], row["points"]) for student, row in rows.items()} == {
        **dict.fromkeys(["ann", "eva"], ("Honor roll", "53")),
        **dict.fromkeys(["bea", "cem"], ("D", "35")),
        "dan": ("none", "0"),
    }
    assert rows["bea"]["next"] == "angle_update in src/swinging.py"
    assert rows["dan"]["problems"] == "none of the handout's files is there; found: nothing"
    assert [rows["bea"][tier] for tier in SUITES] == ["16", "0", "12", "0", "7"]
    assert "The sign of gravity is wrong." in (out / "bea.txt").read_text(encoding="utf-8")
    assert "Grade: Honor roll." in (out / "eva.txt").read_text(encoding="utf-8")
    assert "look at them, this proves nothing\n       ann, eva\n       bea, cem\n" in done.stdout
    assert "    2  The sign of gravity is wrong. Gravity pulls the bob back down. (angle_update)\n" in done.stdout
    assert "    2  test_angle_update (angle_update)\n" in done.stdout
    assert "Honor roll           2\n" in done.stdout

    graded = json.loads((tmp_path / "gradescope" / "bea" / "results.json").read_text())
    assert (graded["score"], graded["max_score"]) == (35, 53)
    (test,) = (test for test in graded["tests"] if test["name"].startswith("C: angle_update: Takes in"))
    assert (test["score"], test["max_score"], test["visibility"]) == (0, 1, "visible")
    assert "hint        The sign of gravity is wrong." in test["output"]
    assert sum(test["score"] for test in graded["tests"]) == 35

    put(a_class / "dan", {"swinging.py": (a_class / "ann/src/swinging.py").read_bytes()})
    assert start(PROGRAM, a_class, folder=tmp_path).returncode == 0
    again = results_of(out)
    assert [student for student in results if again[student] != results[student]] == ["dan"]
    assert rows_of(out)["dan"]["C"] == "6"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere"], "argument SUBMISSIONS: nowhere: No such file or directory"),
        (["."], "argument SUBMISSIONS: found '{here}', allowed is a folder with a folder or a .zip for each student"),
        (["class", "--out", "class/grades"], "argument --out: found 'class/grades', allowed is a folder outside of"),
        (
            ["class", "--starter", "class"],
            "argument --starter: found 'class', allowed is a folder made by",
        ),
        (["class", "--out", "class/ann/file"], "argument --out: found"),
        (["class", "--out", "file"], "file: File exists"),
    ],
)
def test_wrong_arguments(tmp_path, arguments, words):
    (tmp_path / "file").write_text("")
    if arguments != ["."]:
        (tmp_path / "class" / "ann").mkdir(parents=True)
    done = start(PROGRAM, *arguments, folder=tmp_path)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert words.format(here=tmp_path) in done.stderr


# --- the report ------------------------------------------------------------------------------------------------------

ANGLE_UPDATE = """
def angle_update(omega, theta, r_param, dt, g):
    omega_new = omega - g * {f}(theta) / r_param * dt
    return omega_new, theta + omega_new * dt
"""


def of_swinging(text):
    return {"swinging.py": text.encode()}


def test_solutions_are_alike_but_for_names_comments_and_line_breaks():
    one = of_swinging(ANGLE_UPDATE.format(f="sin"))
    renamed = ANGLE_UPDATE.format(f="sin").replace("omega_new", "w").replace("\n    return", "  # w\n\n    return")
    assert fingerprint(of_swinging('"""Of mine."""\nimport math\n' + renamed)) == fingerprint(one)
    assert fingerprint(of_swinging(ANGLE_UPDATE.format(f="cos"))) != fingerprint(one)
    assert fingerprint(of_swinging(ANGLE_UPDATE.format(f="sin").replace("- g", "+ g"))) != fingerprint(one)


@pytest.mark.parametrize(
    "text", ["x = 0x" + "f" * 4000, "def f(:", "(" * 5000 + ")" * 5000, "x = " + "-" * 50_000 + "1", "\0"]
)
def test_what_is_no_python_is_like_nothing(text):
    assert fingerprint(of_swinging(text)) == ""
    assert body_of("angle_update", of_swinging(text), of_swinging("")) is None


def test_groups_leave_out_the_starter_and_what_cannot_be_read():
    marks = {"ann": "1", "bea": "2", "cem": "1", "dan": "", "eva": "", "fay": "s", "gil": "s"}
    assert groups_of(marks, "s") == [["ann", "cem"]]


def a_result(student, message, body):
    """Return a result with one check, which fails without a hint."""
    outcomes = {"test_angle_update": Outcome(FAILED, message)}
    return Result(student, "", outcomes, 1.0, [], "", {"angle_update": body})


def test_a_function_without_a_hint_is_collected_once_and_without_names(tmp_path):
    files = of_swinging(
        "LIMIT = 3\ndef mine(x):\n    return x * LIMIT\ndef swing_update():\n    pass\n"
        "def angle_update(omega, theta, r_param, dt, g):\n"
        '    """By Ann."""\n    # by Ann\n    swing_update()\n    return mine(omega), "a\\\\b"\n'
    )
    starters = of_swinging("def swing_update():\n    pass\n")
    body = body_of("angle_update", files, starters)
    file = tmp_path / "collected.py"
    results = [a_result("ann", "called      angle_update()", body), a_result("bea", "called", body.replace("x", "y"))]
    assert collect(file, results) == 1
    text = file.read_text()
    assert "ann" not in text.lower()
    assert "# of 2 solutions; test_angle_update tells:\n        # called      angle_update()\n" in text
    table = eval("{" + text + "}")  # the form of wrong_solutions.py
    (row,) = table["angle_update"].values()
    assert [line[12:] for line in row.splitlines()] == [
        *(
            "LIMIT = 3",
            "",
            "def mine(x):",
            "    return x * LIMIT",
            "swing_update()",
            "return (mine(omega), 'a\\\\b')",
            "",
        ),
    ]
    assert collect(file, results) == 0
    assert file.read_text() == text
    assert collect(file, [a_result("cem", "called", "return 1")]) == 1
    assert file.read_text().startswith(text)


def test_hints_are_counted_by_function():
    hinted = Outcome(FAILED, "called      a\nhint        Use sin.\nread        b")
    assert mistakes_of({"test_angle_update": hinted}) == {"angle_update": {"Use sin."}}
    assert mistakes_of({"test_angle_update": Outcome(FAILED, "called")}) == {"angle_update": set()}
    assert mistakes_of({"test_angle_update": Outcome(PASSED)}) == {}


def test_the_summary_counts_grades():
    lines = summary([a_result("ann", "called", "return 1")], "")
    assert lines[:7] == [
        "grade        solutions",
        *(f"{tier:<12}         0" for tier in reversed(SUITES)),
        "none                 1",
    ]
