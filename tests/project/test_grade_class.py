"""A class from its submissions to its grades: what a teacher gets, and a class that is stopped."""

import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import zipfile

import grade_class
import make_autograder
import make_starter
import pytest
from classroom import GRADE, LEAVES, left_processes
from programs import call, end, on_posix, SECONDS, wait_until
from students import put_files

from teacher.report import own_folder


def with_a_mistake(solved):
    """Return the files of a solution whose angle_update has a wrong sign."""
    swinging = solved["swinging.py"].replace(b"omega + -g", b"omega + g")
    assert swinging != solved["swinging.py"]
    return {**solved, "swinging.py": swinging}


def test_a_class_is_graded_in_tables_and_texts(classroom, solved):
    classroom.hand_in("ann", solved)
    classroom.hand_in("bea", with_a_mistake(solved))
    classroom.hand_in("dan", {"a.txt": b""})
    status, printed, errors = classroom.grade("one_run.SECONDS = 99")
    assert status == 0, errors

    rows = classroom.rows()
    grades = {student: row["grade"] for student, row in rows.items()}
    assert grades == {"ann": "Honor roll", "bea": "D", "dan": "none"}
    assert rows["bea"]["D"] == "15"
    assert rows["ann"]["points"] == "45"
    assert rows["bea"]["next"] == "angle_update in src/swinging.py"
    problem = "none of the assignment's files is there, found src/a.txt"
    assert [row["problems"] for row in rows.values()] == ["", "", problem]

    texts = {path.stem: path.read_text(encoding="utf-8") for path in classroom.grades.glob("*.txt")}
    assert "Grade: Honor roll." in texts["ann"]
    assert "your code   line by line" in texts["bea"]
    assert problem in texts["dan"]
    assert "Honor roll           1\n" in printed
    assert f"\n3 of 3 solutions are in {classroom.grades}/grades.csv, with a text" in printed
    classroom.require_clean()


# The starter and three students: two of their runs are spoiled from outside. The last two statuses
# are those of the new runs.
SPOILED = f"""
import atexit
statuses = [1, 137, 124, 1, 1, 1]
runners.Runner.run_package = lambda *_: (statuses.pop(0), {json.dumps(GRADE).encode()})
runners.Runner.cores = 1
atexit.register(lambda: print(statuses))
"""


def test_a_run_that_is_not_final_is_made_once_more_alone(classroom):
    for student in ("ann", "bea", "cem"):
        classroom.hand_in(student, {"swinging.py": ""})
    _, printed, _ = classroom.grade(SPOILED)
    assert [*classroom.rows()] == ["ann", "bea", "cem"]
    assert printed.endswith("[]\n")


IN_CONTAINERS = pytest.mark.slow, pytest.mark.xdist_group("engine")


@on_posix
@pytest.mark.slow
@pytest.mark.parametrize(
    ("is_contained", "name"),
    [(False, "SIGINT"), pytest.param(True, "SIGTERM", marks=IN_CONTAINERS)],
)
def test_an_interrupted_class_leaves_no_folder_and_no_process(
    classroom, request, is_contained, name
):
    endless = "import time\nwhile True:\n    try: time.sleep(999)\n    except BaseException: pass"
    if is_contained:
        request.getfixturevalue("engine")
        classroom.how = []
        endless = f"{LEAVES}\n{endless}"
    classroom.hand_in("ann", {"a.txt": ""})
    for student in ("bea", "cem", "dan"):
        classroom.hand_in(student, {"pds_helper.py": endless})
    process = classroom.start("one_run.SECONDS = 999")
    wait_until((classroom.grades / "ann.txt").exists)
    wait_until(left_processes if is_contained else lambda: [*classroom.work.glob("*/project/src")])
    number = getattr(signal, name)
    for _ in range(3):
        process.send_signal(number)
    status, printed, errors = end(process)
    assert status == 128 + number, errors
    assert "Traceback" not in errors
    assert [*classroom.rows()] == ["ann"]
    assert "\n1 of 4 solutions are in " in printed
    assert printed.endswith("\nMissing: 3\n")
    classroom.require_clean()


# A program that stands in for podman: it has an image, and runs nothing.
ENGINE = """#!/bin/sh
case $1 in
    info) echo "1 8000000000" ;;
    image) ;;
    *) echo "cannot $1" >&2; exit 125 ;;
esac
"""
WITHOUT_IMAGE = ENGINE.replace("image)", "images)")


def put_engine(classroom, monkeypatch, script):
    """Let this script be podman, or nothing, if it is "", be an engine."""
    folder = put_files(classroom.folder / "bin", {"podman": script, "docker": script})
    for program in folder.iterdir():
        program.chmod(0o755 if script else 0o644)
    others = os.environ["PATH"] if script else ""
    monkeypatch.setenv("PATH", f"{folder}:{others}")
    classroom.how = []


@on_posix
@pytest.mark.parametrize(
    ("script", "message"),
    [
        ("", "podman: it is not installed; tests/starter/README.md says how\n"),
        ("#!/bin/sh\necho 0 0\necho is down >&2", "docker: it does not run: is down\n"),
        (ENGINE, "cannot run\nThe starter: no grade: the run ended with status 125\n"),
        (WITHOUT_IMAGE, "cannot build\nThe image: cannot be built\n"),
    ],
)
def test_without_a_container_one_line_says_why(classroom, monkeypatch, run, script, message):
    classroom.hand_in("ann", {"a.txt": ""})
    put_engine(classroom, monkeypatch, script)
    monkeypatch.chdir(classroom.folder)
    status, _, errors = run(grade_class, "class", "--starter", classroom.starter)
    assert status == 2
    assert errors.startswith(message)


@on_posix
def test_ctrl_c_ends_the_building_of_the_image(classroom, monkeypatch):
    classroom.hand_in("ann", {"a.txt": ""})
    put_engine(
        classroom, monkeypatch, WITHOUT_IMAGE.replace("*)", "build) exec sleep 999 ;;\n    *)")
    )
    process = classroom.start()
    assert "is built once" in process.stdout.readline()
    process.send_signal(signal.SIGINT)
    assert end(process) == (130, "", "")
    classroom.require_clean()


@on_posix
def test_an_engine_that_ends_during_the_class_ends_it_with_one_line(classroom, monkeypatch):
    """The stand-in for podman has a grade for the first solution, the starter."""
    classroom.hand_in("ann", {"a.txt": ""})
    grade = put_files(classroom.folder, {"grade.json": json.dumps(GRADE)}) / "grade.json"
    down = r"#!/bin/sh\necho is down >&2\nexit 125\n"
    put_engine(
        classroom,
        monkeypatch,
        ENGINE.replace("*)", f"run) cat {grade}; printf '{down}' >$0 ;;\n*)"),
    )
    assert classroom.grade() == (2, "", "podman: it does not run: is down\n")
    classroom.require_clean()


@on_posix
def test_a_folder_of_grades_is_nobody_elses(tmp_path):
    put_files(tmp_path, {"teachers/a": ""})
    (tmp_path / "teachers").chmod(0o755)
    for name in ("teachers", "a/new/one"):
        own_folder(tmp_path / name)
        assert stat.S_IMODE((tmp_path / name).stat().st_mode) == 0o700


@pytest.fixture
def run(monkeypatch, capfd):
    """A function that runs a program in this process; it returns (status, stdout, stderr)."""

    def run(program, *arguments):
        monkeypatch.setattr(sys, "argv", [f"{program.__name__}.py", *map(str, arguments)])
        return call(program.main, capfd)

    return run


@pytest.mark.parametrize(
    ("program", "arguments", "message"),
    [
        (grade_class, "class/ann", "SUBMISSIONS: found "),
        (grade_class, "class --out class/grades", "--out: found 'class/grades'"),
        (grade_class, "class --starter class", "--starter: found 'class'"),
        (grade_class, "class --out file.zip", "file.zip: File exists"),
        (make_autograder, "cradle.tar", "FILE.zip: found 'cradle.tar'"),
        (make_autograder, "nowhere/cradle.zip", "nowhere/cradle.zip: No such file"),
        (make_starter, "class", "FOLDER: found 'class'"),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(
    tmp_path, monkeypatch, run, program, arguments, message
):
    monkeypatch.chdir(tmp_path)
    put_files(tmp_path, {"file.zip": "mine", "class/ann/a.txt": ""})
    status, printed, errors = run(program, *arguments.split())
    assert status == 2
    assert printed == ""
    assert errors.count("\n") == 1
    assert message in errors.replace(os.sep, "/")
    assert "None" not in errors
    assert (tmp_path / "file.zip").read_text() == "mine"


@on_posix
def test_the_autograder_grades_a_solution_and_holds_no_answers(tmp_path, monkeypatch, run, solved):
    """This Python stands in for that which setup.sh installs, as in the image of the class."""
    status, _, errors = run(make_autograder, tmp_path / "cradle.zip")
    assert (status, errors) == (0, "")
    source = tmp_path / "source"
    with zipfile.ZipFile(tmp_path / "cradle.zip") as archive:
        archive.extractall(source)
        for name in ("run_autograder", "setup.sh"):
            assert archive.getinfo(name).external_attr >> 16 & 0o111 == 0o111
    assert "angle_update is not written yet" in (source / "src" / "swinging.py").read_text()
    assert not (source / "tests" / "project").exists()

    shutil.copy(source / "run_autograder", tmp_path)
    put_files(tmp_path / "submission" / "src", with_a_mistake(solved))
    script = f'#!/bin/sh\nexec "{sys.executable}" "$@"\n'
    put_files(tmp_path, {"venv/bin/python": script})
    (tmp_path / "venv" / "bin" / "python").chmod(0o755)
    subprocess.run(
        ["bash", tmp_path / "run_autograder"], check=True, capture_output=True, timeout=2 * SECONDS
    )
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    assert 15 < results["score"] < 45 + 7
    assert "max_score" not in results
    assert str(results).count("(extra): ") == 7
    (test,) = [test for test in results["tests"] if "C: angle_update: Gravity" in test["name"]]
    assert test["score"] == 0
    assert "wrong       omega_new is 4, not 2." in test["output"]
