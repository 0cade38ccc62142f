"""Grading a class: how submissions are read, what a solution costs its student, and what the teacher gets."""

import csv
import json
import os
import shutil
import subprocess
import sys
import zipfile
from types import SimpleNamespace

import grade_class
import make_autograder
import make_starter
import pytest
import watch
from programs import on_posix, SECONDS
from students import COUNTS, files_of, put_files, write

from grading.grader import checks
from grading.handout import FUNCTIONS, SUITES
from teacher.submissions import MOST_BYTES, MOST_FILES, read_submission, submissions_in

for tier in SUITES:
    checks(tier=tier)  # imports them

# --- submissions -----------------------------------------------------------------------------------------------------

SOLUTION = {function.file: f"# {function.file}\n" for function in FUNCTIONS.values()}
READ = {file.removeprefix("src/"): text.encode() for file, text in SOLUTION.items()}


def pack(file, files):
    """Write files into a .zip; return its path."""
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return file


def below(folder, files=SOLUTION):
    """Return files as they are one level deeper."""
    return {f"{folder}/{name}": text for name, text in files.items()}


OTHERS = {"README.md": "text", "support/swinging.py": "mine", ".venv/lib/swinging.py": "x", "tests/swinging.py": "mine"}
PROJECT = {**SOLUTION, **OTHERS}
MAC = {**below("cradle", PROJECT), **{f"__MACOSX/{name}": "mac" for name in below("cradle")}}
MORE = {"src/helpers/angles.py": "a", "src/notes.txt": "n", "src/__pycache__/x.py": "x"}
NAMED = {name.replace("swinging", "Swinging (1)"): text for name, text in SOLUTION.items()}
OUTSIDE = ["../src/swinging.py", "src/../../swinging.py", "..\\src\\swinging.py", "C:/swinging.py"]
NONE = "none of the handout's files is there; found: "
FORMS = {  # the files of a submission, those that count, and the problem
    "the files of src": (READ, READ, None),
    "a project of macOS": (MAC, READ, None),
    "more files": ({**SOLUTION, **MORE}, {**READ, "helpers/angles.py": b"a"}, None),
    "paths that lead outside": ({**SOLUTION, **dict.fromkeys(OUTSIDE, "x")}, READ, None),
    "two projects": ({**below("new"), "old/src/swinging.py": "old"}, READ, "took new/src, left old/src"),
    "another name": (
        *(NAMED, {name.replace("swinging", "Swinging (1)"): text for name, text in READ.items()}),
        "src/swinging.py is missing, found 'Swinging (1).py'",
    ),
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
    pack(tmp_path / place, files) if place.endswith(".zip") else put_files(tmp_path / place, files)
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
    """A name that cannot be printed has ? in place of its letters."""
    for name in ("ann", "Bea B", ".git", "__MACOSX", "a\nb"):
        (tmp_path / name).mkdir()
    put_files(tmp_path, {"ann.zip": "", "cem.ZIP": "", "dan.rar": "", "index.html": "", "a\tb/c\nd/e\nf": ""})
    found, others = submissions_in(tmp_path)
    students = {"Bea B": "Bea B", "ann": "ann", "ann.zip": "ann.zip", "cem": "cem.ZIP", "dan": "dan.rar"}
    assert {name: path.name for name, path in found.items()} == {**students, "a?b": "a\tb", "a?b_": "a\nb"}
    assert others == ["index.html"]
    assert read_submission("dan", found["dan"]).problems == [
        "dan.rar is no .zip that can be read: File is not a zip file"
    ]
    assert read_submission("a?b", found["a?b"]).problems == [f"{NONE}c?d/e?f"]


@pytest.mark.parametrize("files", [{}, {"index.html": "a"}, PROJECT, READ], ids=["nothing", "a file", "project", "src"])
def test_a_folder_that_is_no_class_is_refused(tmp_path, files):
    with pytest.raises(ValueError, match="allowed is a folder with a folder or a .zip for each student"):
        submissions_in(put_files(tmp_path, files))


# --- solutions -------------------------------------------------------------------------------------------------------

FORGED = f"""
import os
for check in {[check.name for check in checks(tier="C")]}:
    line = ascii({{"key": "", "check": check, "outcome": ["passed", "", ""]}})
    for fd in range(3, 30):
        try:
            os.write(fd, f"\\n{{line}}\\n".encode())
        except OSError:
            pass
print("Grade: Honor roll.")
open("grade.json", "w").write('{{"grade": "Honor roll"}}')
"""
PATCH = "import os; w = os.write; os.write = lambda fd, text: w(fd, text.replace(b'failed', b'passed'))"
ATTACKS = {  # bodies of functions
    "uniform_mass_newton_cradle": "import os; open(os.environ['HOME'] + '/../mine.txt', 'w')",
    "angle_update": "import signal; signal.raise_signal(signal.SIGKILL)",
    "handle_collision": "import time\nwhile True: time.sleep(1)",
    "make_double_pendulum": "[0] * 10**9",
}


def with_wrong_sign(solved, imported):
    """Return swinging.py with a mistake in angle_update, and with code that runs when the file is imported."""
    text = solved["swinging.py"].decode()
    assert "omega + -g" in text
    return {"swinging.py": f"{text.replace('omega + -g', 'omega + g')}\n{imported}\n".encode()}


@pytest.mark.parametrize("name", ["a" * 300 + ".py", "beyond/a/b.py/c.py", "nul\0.py"])
def test_a_name_that_cannot_be_written_costs_that_solution(worker, solved, name):
    graded = worker.grade({"beyond/a/b.py": b"", **solved, name: b""})
    assert graded.outcomes == {}
    assert graded.problems[0].startswith(f"src/{name} cannot be written: ")


# --- the program -----------------------------------------------------------------------------------------------------


@pytest.fixture
def main(made, worker, monkeypatch, capsys):
    """A function that runs grade_class.py or another program; it returns the status, stdout and stderr."""
    shared = SimpleNamespace(grade=worker.grade, close=lambda: None)
    monkeypatch.setattr(grade_class, "Worker", lambda *_: shared)
    monkeypatch.setattr(grade_class, "new_starter", lambda _: made)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0}, raising=False)  # one core, for one worker

    def main(*arguments, program=grade_class):
        monkeypatch.setattr(sys, "argv", [program.__name__ + ".py", *map(str, arguments)])
        try:
            program.main()
        except SystemExit as ended:
            return ended.code, *capsys.readouterr()
        return 0, *capsys.readouterr()

    return main


def tables_of(folder):
    """Return the rows of grades.csv and the results in results.jsonl, each by student."""
    with open(folder / "grades.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    results = [json.loads(line) for line in (folder / "results.jsonl").read_text(encoding="utf-8").splitlines()]
    return tuple({each["student"]: each for each in table} for table in (rows, results))


@on_posix
def test_a_class_that_is_interrupted_and_goes_on(solved, starter, tmp_path, main, worker, monkeypatch):
    a_class, out, graded = tmp_path / "class", tmp_path / "class-grades", []
    write(starter, "extract_and_convert", "double_angle_update", *ATTACKS, **ATTACKS)
    put_files(a_class / "ann" / "src", solved)
    put_files(a_class / "bea" / "src", {**solved, **with_wrong_sign(solved, FORGED)})
    put_files(a_class / "cem" / "src", files_of(starter))
    (a_class / "dan").mkdir()

    def grade(files):
        if len(graded) == 2:
            raise KeyboardInterrupt
        graded.append(files)
        return worker.grade(files)

    with monkeypatch.context() as patches:
        patches.setattr(grade_class, "Worker", lambda *_: SimpleNamespace(grade=grade, close=lambda: None))
        line = "2 of 4 solutions are graded. The same command goes on from there.\n"
        assert main(a_class) == (130, line, "")
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
    problems = "", "", "angle_update ended the process (signal 9)", f"{NONE}nothing"
    assert tuple(row["problems"] for row in rows.values()) == problems
    assert rows["bea"]["next"] == "angle_update in src/swinging.py"
    for student, words in [("ann", "Grade: Honor roll."), ("bea", "Grade: D.")]:
        assert words in (out / f"{student}.txt").read_text(encoding="utf-8")  # of bea, although it printed another
    messages = "\n".join(words for _, words, *_ in results["cem"]["outcomes"].values())
    for words in ("handle_collision took longer than 5 s", "writing outside of the project's", "more than 1000 MB"):
        assert words in messages
    assert "    1  The sign of gravity is wrong. Gravity pulls the bob back down. (angle_update)\n" in printed
    assert "Honor roll           1\n" in printed

    result = json.loads((tmp_path / "gradescope" / "bea" / "results.json").read_text())
    (test,) = (test for test in result["tests"] if test["name"].startswith("C: angle_update: Takes in"))
    assert (test["score"], test["max_score"], test["visibility"]) == (0, 1, "visible")
    assert "hint        The sign of gravity is wrong." in test["output"]
    assert (result["score"], result["max_score"], sum(test["score"] for test in result["tests"])) == (35, 53, 35)

    put_files(a_class / "dan" / "src", with_wrong_sign(solved, PATCH))
    assert main(a_class)[0] == 0
    rows, again = tables_of(out)
    assert [student for student in results if again[student] != results[student]] == ["dan"]
    assert rows["dan"]["problems"].split("; ")[-1] == "the solution has changed the grader (os.write): no points"


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
        (watch, "test_angle", "found 'test_angle', allowed is the name of a check, for example test_angle_update"),
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
