"""A class from its submissions to its grades: what a teacher gets, also from a class that stops."""

import csv
import json
import os
import re
import shutil
import signal
import socket
import stat
import subprocess
import sys
import zipfile
from pathlib import Path
from types import SimpleNamespace

import grade_class
import make_autograder
import pytest
from programs import call, end, on_posix, PROCESS_SECONDS, ROOT
from students import put_files

from teacher.submissions import submissions_in
from teacher.table import write_table

ENDLESS = "import os; os.kill(os.getpid(), 19)"  # pytest stands still
RESULT = {"grade": "B", "points": 33, "next": "", "problems": [], "text": "", "is_final": True}
# A run takes at most SECONDS, and each result prints a line.
BEGIN = """
import contextlib, grade_class
from teacher import containers
containers.SECONDS = {}
grade_class.progress_bar = lambda: contextlib.nullcontext(lambda done: print(done, flush=True))
grade_class.main()
"""


class Classroom:
    """A teacher's folder with a class, and the program that grades it."""

    def __init__(self, folder, starter):
        self.folder = folder
        self.grades = folder / "class-grades"
        self.starter = starter
        self.work = folder / "work"  # for the program's own folders
        self.work.mkdir()
        self.how = ["--here"]
        self.seconds = 300  # of a run; a right solution needs 3

    def hand_in(self, student, swinging, others=()):
        put_files(self.folder / "class" / student, {**dict(others), "swinging.py": swinging})

    def start(self):
        begin = BEGIN.format(self.seconds)
        return subprocess.Popen(
            [sys.executable, "-c", begin, "class", "--starter", str(self.starter), *self.how],
            cwd=self.folder,
            env={**os.environ, "TMPDIR": str(self.work), "PYTHONPATH": str(ROOT / "tests")},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )

    def rows(self):
        """Return the rows of grades.csv by student."""
        lines = (self.grades / "grades.csv").read_text("utf-8-sig").splitlines()
        return {row["student"]: row for row in csv.DictReader(lines)}


@pytest.fixture
def classroom(made, tmp_path):
    classroom = Classroom(tmp_path, made)
    yield classroom
    assert os.listdir(classroom.work) == []


@pytest.mark.slow
def test_a_class_is_graded_in_a_table_and_texts(classroom, solved):
    swinging = solved["swinging.py"].decode()
    classroom.hand_in("ann", swinging, solved)
    classroom.hand_in("bea", swinging.replace("omega + -g", "omega + g"), solved)
    classroom.hand_in("cem", f"import no_such_package\n{swinging}", solved)
    classroom.hand_in("dan", "import os; os.abort()", solved)
    classroom.hand_in("eve", "v = (", {**solved, "pds_helper.py": ""})
    put_files(classroom.folder, {"class/notes.txt": ""})
    status, printed, errors = end(classroom.start())
    assert (status, errors.count("\n")) == (0, 1)
    assert f"5 of 5 solutions are in {classroom.grades}" in printed
    assert printed.endswith("not recognised: notes.txt\n")
    assert stat.S_IMODE(classroom.grades.stat().st_mode) == 0o700 or os.name == "nt"

    rows = classroom.rows()
    assert [row["grade"] for row in rows.values()] == ["Honor roll", "D", "D", "none", "none"]
    assert (rows["ann"]["points"], rows["ann"]["Honor roll"]) == ("45", "7")
    assert rows["bea"]["next"] == "angle_update in src/swinging.py"
    problems = "".join(f"{row['problems']}\n" for row in rows.values())
    assert re.fullmatch(PROBLEMS, problems)
    assert "Grade: Honor roll." in (classroom.grades / "ann.txt").read_text()


PROBLEMS = r"""

no module no_such_package: a file is missing, or a package \(--packages\)
no grade: pytest ended with status .*
src/pds_helper.py is empty. src/swinging.py is not Python: .*
"""


def test_a_run_that_ends_oddly_is_made_once_more_alone(tmp_path):
    """The first run of bea is not sure, and both of cem end without a result."""
    sure = json.dumps(RESULT).encode()
    unsure = sure.replace(b"true", b"false")
    outputs = {
        b"ann": [(0, sure)],
        b"bea": [(0, unsure), (0, sure)],
        b"cem": [(0, b"[" * 10**6), (124, b'{"problems": 1, "text": ""}')],
    }

    def run(submission, _):
        packed = submission.read()
        (student,) = [student for student in outputs if student in packed]
        return outputs[student].pop(0)

    put_files(tmp_path, {"ann/ann.py": "", "bea/bea.py": "", "cem/cem.py": ""})
    students, _ = submissions_in(tmp_path)
    results = {}
    grade_class.grade_all(students, SimpleNamespace(run=run), results)
    assert [results[student]["grade"] for student in students] == ["B", "B", "none"]
    assert results["cem"]["problems"] == ["no grade: the run took longer than 300 s"]
    assert not any(outputs.values())


def test_what_a_solution_forges_is_short_no_formula_and_no_code_of_a_terminal(tmp_path):
    forged = {"grade": 10**9, "points": "=1", "next": 'a;"=1\x1b', "text": "\x1b[2J\n" * 9**5}
    write_table(tmp_path, {"@a;b": {**RESULT, **forged, "problems": ["-x" * 9000, 1]}})
    header, row = (tmp_path / "grades.csv").read_text("utf-8-sig").splitlines()
    assert row.startswith("'@a;b,1000000000,'=1,")
    assert ""","a;'""=1\\x1b",'-x""" in row
    assert len(row) < 3000
    text = (tmp_path / "@a;b.txt").read_text()
    assert text.replace("\n", "").isprintable()
    assert len(text) < 5000


@on_posix
@pytest.mark.parametrize(
    "how",
    [pytest.param("--here", marks=pytest.mark.slow), pytest.param("", marks=pytest.mark.engine)],
)
def test_an_interrupted_class_keeps_what_is_graded_and_leaves_nothing(classroom, how):
    """The signal comes three times."""
    classroom.how = how.split()
    classroom.seconds = 900
    classroom.hand_in("ann", "")
    for student in ("bea", "cem", "dan"):
        classroom.hand_in(student, ENDLESS)
    process = classroom.start()
    while process.stdout.readline() != "0.25\n":
        assert process.poll() is None
    for _ in range(3):
        process.send_signal(signal.SIGINT)
    status, printed, errors = end(process)
    assert status == 128 + signal.SIGINT, errors
    assert [*classroom.rows()] == ["ann"]
    assert printed.startswith("1 of 4 solutions are in ")


# A program that stands in for podman: it has an image, and runs nothing.
ENGINE = """#!/bin/sh
case $1 in
    info) ;;
    build) echo image ;;
    *) echo "cannot $1" >&2; exit 125 ;;
esac
"""
OFF = "#!/bin/sh\necho is off >&2\nexit 1\n"
# It has a result for the first solution, the starter
ENDS = f"run) echo '{json.dumps(RESULT)}'; /bin/rm $0 ;;\n    *)"
ENGINES = {
    "": "No containers: podman is not installed; docker is not installed; on macOS and Windows, ",
    OFF: "No containers: podman does not run: is off; docker does not run: is off; on macOS ",
    ENGINE: "cannot run\nThe starter: no grade: the run ended with status 125\n",
    ENGINE.replace("build)", "build-)"): "cannot build\nThe image: cannot be built\n",
    ENGINE.replace("*)", ENDS): "podman: No such file",
}


@on_posix
@pytest.mark.parametrize(("script", "message"), ENGINES.items())
def test_without_an_engine_one_line_says_why(classroom, monkeypatch, script, message):
    """The script is podman and docker."""
    classroom.hand_in("ann", "")
    classroom.how = []
    folder = classroom.folder / "bin"
    monkeypatch.setenv("PATH", str(folder))
    if script:
        put_files(folder, {"podman": script, "docker": script})
        for program in folder.iterdir():
            program.chmod(0o755)
    status, _, errors = end(classroom.start())
    assert status == 2
    assert errors.startswith(message)
    assert errors.count("\n") == (message.count("\n") or 1)


WRONG = [
    (grade_class, "class/ann", "SUBMISSIONS: found "),
    (grade_class, f"{ROOT}", "allowed is a folder with a folder or a .zip for each student"),
    (grade_class, "/", "SUBMISSIONS: "),
    (grade_class, f"class --starter {ROOT}", "allowed is a folder made by make_starter.py"),
    (make_autograder, "cradle.tar", "FILE.zip: found 'cradle.tar'"),
]


@pytest.mark.parametrize(("program", "arguments", "message"), WRONG)
def test_wrong_arguments_are_refused_in_one_line(
    tmp_path, monkeypatch, capfd, program, arguments, message
):
    monkeypatch.chdir(tmp_path)
    put_files(tmp_path, {"class/ann/a.txt": ""})
    status, printed, errors = run(program, arguments, monkeypatch, capfd)
    assert (status, printed, errors.count("\n")) == (2, "", 1)
    assert message in errors.replace(os.sep, "/")


def run(program, arguments, monkeypatch, capfd):
    """Run a program in this process; return its status, and the output on stdout and stderr."""
    monkeypatch.setattr(sys, "argv", [f"{program.__name__}.py", *arguments.split()])
    return call(program.main, capfd)


@on_posix
@pytest.mark.slow
def test_the_autograder_grades_a_solution_and_holds_no_answers(
    tmp_path, monkeypatch, capfd, solved
):
    """This Python stands in for that which setup.sh installs."""
    monkeypatch.chdir(tmp_path)
    assert run(make_autograder, "cradle.zip", monkeypatch, capfd)[0] == 0
    with zipfile.ZipFile("cradle.zip") as archive:
        archive.extractall("source")
        for name in ("run_autograder", "setup.sh"):
            assert archive.getinfo(name).external_attr >> 16 & 0o111 == 0o111
    assert "angle_update is not written yet" in Path("source/src/swinging.py").read_text()
    program = Path("source/run_autograder").read_text().replace("/autograder", str(tmp_path))
    python = f'#!/bin/sh\nexec "{sys.executable}" "$@"\n'
    wrong = solved["swinging.py"].replace(b"omega + -g", b"omega + g")
    put_files(tmp_path, {"run": program, "venv/bin/python": python, "results/a": ""})
    put_files(tmp_path / "submission", {**solved, "swinging.py": wrong, "README.md": "x"})
    Path("venv/bin/python").chmod(0o755)
    subprocess.run(["bash", "run"], check=True, timeout=PROCESS_SECONDS)
    results = json.loads(Path("results/results.json").read_text())
    assert 15 < results["score"] < 45
    assert "omega_new is 4, not 2." in results["output"]
    assert "cannot be read" not in results["output"]


# --- solutions that look for a way out, in containers ----------------------------------------

BEGIN_HOSTILE = """
import mmap, os, signal, socket
here = os.path.dirname(os.path.dirname(__file__))
address, folder, seconds = {}, '{}', '{}'
"""
# What each does when Python reads its file. These do it in vain, and keep their points.
IN_VAIN = {
    "network": "assert socket.socket().connect_ex(address)",
    "files": """
for folder in (f'{folder}/class/honest', folder, '/tmp', '/autograder/source'):
    assert not os.access(folder, os.W_OK)
""",
    "a process left behind": """
if "LEFT" not in os.environ and not os.fork():
    os.setsid()
    os.execvp("sleep", ["sleep", seconds])
os.environ["LEFT"] = "1"
""",
}
# These spoil their own run.
SPOILED = {
    "processes": "while True: os.fork()",
    "memory": "taken = mmap.mmap(-1, 4 * 10**9)\nfor _ in range(40): taken.write(bytes(10**8))",
    "time": "os.kill(-1, signal.SIGSTOP)",
    "disk": "for i in range(10): open(f'{here}/{i}', 'wb').write(bytes(9_000_000))",
    "output": "open(f'/proc/{os.getppid()}/fd/1', 'wb').write(b'x' * 10**8)",  # that of one_run.py
    "forged": "os.symlink('/dev/zero', here + '/grade.json')\nos.abort()",
}


@on_posix
@pytest.mark.engine
def test_hostile_solutions_harm_nobody_else(classroom, solved):
    classroom.how = []
    classroom.seconds = 40  # one of them takes all of it, twice
    folder = classroom.folder
    swinging = solved["swinging.py"].decode()
    classroom.hand_in("honest", swinging, solved)
    seconds = str(10**9 + os.getpid())  # that no other process sleeps
    with socket.create_server(("127.0.0.1", 0)) as server:
        begin = BEGIN_HOSTILE.format(server.getsockname(), folder, seconds)
        for student, code in {**IN_VAIN, **SPOILED}.items():
            classroom.hand_in(student, f"{swinging}{begin}{code}", solved)
        before = contents(folder)
        status, _, errors = end(classroom.start())
    assert (status, errors) == (0, "")
    points = {student: row["points"] for student, row in classroom.rows().items()}
    assert points.keys() == {"honest", *IN_VAIN, *SPOILED}
    assert {student for student in points if points[student] == "45"} == {"honest", *IN_VAIN}
    shutil.rmtree(classroom.grades)
    assert contents(folder) == before
    processes = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True).stdout
    assert seconds not in processes


def contents(folder):
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
