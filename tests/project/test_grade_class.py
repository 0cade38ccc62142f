"""Grading a class: how submissions are read, what a solution can do, and what the teacher gets."""

import csv
import errno
import json
import os
import re
import shutil
import signal
import socket
import stat
import subprocess
import sys
import sysconfig
import threading
import zipfile
from contextlib import suppress
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from unicodedata import normalize
from unittest.mock import Mock

import grade_class
import make_autograder
import make_starter
import pytest
from programs import call, on_posix, python, ROOT, SECONDS, wait_until
from students import change, COUNTS, files_of, graded_in, put_files, write

from grading.grader import checks
from grading.handout import FUNCTIONS, SUITES
from teacher import memory, one_run, report, sandbox
from teacher.keys import keys_of, Student
from teacher.submissions import (
    LEFT_OUT,
    MOST_BYTES,
    MOST_FILES,
    MOST_LIST,
    MOST_PROBLEMS,
    read_submission,
    submissions_in,
    TOO_LONG,
)

SOLUTION = {function.file: f"# {function.file}\n" for function in FUNCTIONS.values()}
READ = {file.removeprefix("src/"): text.encode() for file, text in SOLUTION.items()}


def below(folder, files=SOLUTION):
    return {f"{folder}/{name}": text for name, text in files.items()}


def renamed(before, after, files=SOLUTION):
    return {name.replace(before, after): text for name, text in files.items()}


def zip_of(files) -> bytes:
    """Return a .zip with these files; a name may be a ZipInfo."""
    with zipfile.ZipFile(whole := BytesIO(), "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return whole.getvalue()


OTHERS = {
    "README.md": "text",
    "support/swinging.py": "mine",
    ".venv/lib/swinging.py": "x",
    "tests/swinging.py": "mine",
}
PROJECT = {**SOLUTION, **OTHERS}
MAC = {**below("cradle", PROJECT), **{f"__MACOSX/{name}": "mac" for name in below("cradle")}}
MORE = {"src/helpers/angles.py": "a", "src/notes.txt": "n", "src/__pycache__/x.py": "x"}
NEWER = {
    **SOLUTION,
    "src/swinging (1).py": "1",
    "src/swinging-12.py": "12",
    "src/swinging-2.py": "2",
}
CANDIDATES = (
    "Swinging.py",
    "swinging.PY",
    "swinging copy.py",
    "Copy of swinging.py",
    "swinging - Copy.py",
)
NONE = "none of the handout's files is there, found: "
TOOK = [f"took src/{name.replace('.py', '-1.py')} as {name}" for name in sorted(READ)]
LEFT = "took src/swinging-12.py as swinging.py, left src/swinging.py, src/swinging (1).py, src/swinging-2.py"
FORMS = {  # the files of a submission, those that count, and the problems
    "the files of src": (READ, READ, []),
    "a project of macOS": (MAC, READ, []),
    "more files": ({**SOLUTION, **MORE}, {**READ, "helpers/angles.py": b"a"}, []),
    "two projects": (
        {**below("new"), "old/src/swinging.py": "old"},
        READ,
        ["took new/src, left old/src"],
    ),
    "two candidates": (
        {**renamed("swinging", "my_swinging"), "src/swinging_old.py": "o"},
        {**renamed("swinging", "my_swinging", READ), "swinging_old.py": b"o"},
        ["src/swinging.py is missing, found 'my_swinging.py' and 'swinging_old.py'"],
    ),
    "two versions": (
        {**below("Version 2"), **below("Version 1")},
        READ,
        ["took Version 2/src, left Version 1/src"],
    ),
    "a long path": (
        {**SOLUTION, f"src/{'a/' * 120}long.py": ""},
        READ,
        [f"left out {'/a' * 21}/long.py: {TOO_LONG}"],
    ),
    "nothing": ({}, {}, [NONE]),
    "much": (
        {**SOLUTION, "src/big.py": "#" * MOST_BYTES},
        {},
        ["too large: allowed are at most 200 Python files"],
    ),
    "many": (
        {**SOLUTION, **{f"src/a{i}.py": "" for i in range(MOST_FILES)}},
        {},
        ["too large: allowed are"],
    ),
    "all again": (renamed(".py", "-1.py"), READ, TOOK),
    "one again": (NEWER, {**READ, "swinging.py": b"12"}, [LEFT]),
    "again and again": (renamed(".py", "-1 (2).py"), READ, ["took "] * 5),
}
for name in CANDIDATES:
    own = {name: READ["swinging.py"]}
    FORMS[name] = (
        renamed("swinging.py", name),
        {**READ, **own},
        [f"took src/{name} as swinging.py"],
    )


@pytest.mark.parametrize(("files", "found", "problems"), FORMS.values(), ids=FORMS)
@pytest.mark.parametrize("place", ["ann", "ann.zip", "ann/cradle.zip", "ann.zip/cradle.zip"])
def test_the_files_of_src_are_found_and_problems_named(tmp_path, files, found, problems, place):
    (tmp_path / "ann").mkdir()
    forms = {
        "ann": below("ann", files),
        "ann.zip/cradle.zip": {"ann.zip": zip_of({"cradle.zip": zip_of(files)})},
    }
    put_files(tmp_path, forms.get(place, {place: zip_of(files)}))
    read, told = read_submission([("", tmp_path / place.removesuffix("/cradle.zip"))])
    assert (read, len(told)) == (found, len(problems))
    for each, problem in zip(sorted(told), sorted(problems), strict=True):
        assert each.replace("cradle.zip/", "").startswith(problem)


ODD = {  # entries of a .zip that are left out, and how they are there
    **dict.fromkeys(
        ("C:/src/swinging.py", "/src/swinging.py", "src/../../swinging.py", "..\\src\\swinging.py"),
        {},
    ),
    "src/link.py": {"external_attr": (stat.S_IFLNK | 0o777) << 16},
    "src/bzip2.py": {"compress_type": zipfile.ZIP_BZIP2},
    "src/lzma.py": {"compress_type": zipfile.ZIP_LZMA},
}


@pytest.mark.parametrize("name", ODD)
def test_an_odd_entry_of_a_zip_is_named_and_the_rest_is_taken(tmp_path, name):
    info = zipfile.ZipInfo(name)
    for key, value in ODD[name].items():
        setattr(info, key, value)
    (tmp_path / "a.zip").write_bytes(zip_of({**SOLUTION, info: "x", f"src/a-{'9' * 200}.py": ""}))
    files, problems = read_submission([("", tmp_path / "a.zip")])
    assert (READ.items() <= files.items(), len(files)) == (True, len(READ) + 1)
    # As zipfile reads it on Windows
    assert problems[0] == f"left out {name.replace(os.sep, '/')}: {LEFT_OUT}"


def test_an_encrypted_and_a_damaged_entry_are_named_and_the_rest_is_taken(tmp_path):
    data = bytearray(zip_of(SOLUTION))
    local, central = data.find(b"src/swinging.py"), data.rfind(b"src/pds_helper.py")
    data[local + len("src/swinging.py")] ^= 0xFF  # the content
    data[central - 38] |= 1  # a flag: encrypted
    (tmp_path / "a.zip").write_bytes(data)
    files, problems = read_submission([("", tmp_path / "a.zip")])
    assert files == {
        name: text for name, text in READ.items() if name not in ("swinging.py", "pds_helper.py")
    }
    assert problems[:2] == [
        f"left out src/pds_helper.py: {LEFT_OUT}",
        "src/pds_helper.py is missing",
    ]
    assert problems[2].startswith("left out src/swinging.py: ")


def test_a_zip_with_too_long_a_list_of_files_is_not_read(tmp_path):
    data = bytearray(zip_of(SOLUTION))
    data[-10:-6] = (MOST_LIST + 1).to_bytes(4, "little")
    (tmp_path / "a.zip").write_bytes(data)
    files, problems = read_submission([("", tmp_path / "a.zip")])
    assert (files, problems[0]) == (
        {},
        "a.zip is no .zip that can be read: its list of files has more than 5,000,000 bytes",
    )


def test_problems_are_few_and_short(tmp_path):
    (tmp_path / "a.zip").write_bytes(zip_of({f"/{'a' * 300}{i}\x1b.py": "" for i in range(99)}))
    _, problems = read_submission([("", tmp_path / "a.zip")])
    assert (len(problems), problems[-1]) == (MOST_PROBLEMS + 1, "and more")
    assert max(map(len, problems)) <= 203 and "".join(problems).isprintable()


@on_posix
def test_pipes_and_links_are_not_read(tmp_path):
    """A link could lead to another student's files."""
    folder = put_files(tmp_path, {"secret.py": "secret", "ann/src/pds_helper.py": "a"}) / "ann"
    (folder / "src" / "swinging.py").symlink_to(tmp_path / "secret.py")
    (folder / "src" / "folder").symlink_to(tmp_path)
    os.mkfifo(folder / "src" / "special_cradles.py")
    files, problems = read_submission([("", folder)])
    assert files == {"pds_helper.py": b"a"}
    assert {"src/special_cradles.py is missing", "src/swinging.py is missing"} <= {*problems}


# What is in the folder, and the student's key and the own name of the file: "" is a folder or an
# archive
CLASS = {
    "Bea B/a.py": ("Bea B", ""),
    "a\x7fb/c\x85d/e\x85f": ("a_x7fb", ""),
    "cem.ZIP": ("cem", ""),
    "dan.rar": ("dan", ""),
    "li_1_5_swinging.py": ("li_1", "swinging.py"),
    "li_1_6_pds_helper-1.py": ("li_1", "pds_helper-1.py"),
    "li_2_7_swinging.py": ("li_2", "swinging.py"),
    "eve_LATE_3_8_a.zip": ("eve", "a.zip"),
    "li_1_9_4_8_swinging.py": ("li_1_9", "swinging.py"),  # a student calls herself li_1_9
    "Fay F_9_assignsubmission_file_swinging.py": ("Fay F", "swinging.py"),
    "Fay F_9_assignsubmission_onlinetext_/onlinetext.html": ("Fay F", ""),
    "Gus_7_assignsubmission_file/swinging.py": ("Gus", ""),
}


def test_each_folder_each_archive_and_each_name_of_a_flat_download_is_a_student(tmp_path):
    """Letters of a name that cannot be printed are spelled out.

    A link may lead to somebody else's files.
    """
    put_files(tmp_path, dict.fromkeys([*CLASS, ".git/a", "__MACOSX/a", "index.html"], ""))
    if os.name == "posix":
        (tmp_path / "link").symlink_to(tmp_path / "Bea B")
    found, others = submissions_in(tmp_path)
    read = {(key, name, path.name) for key, paths in found.items() for name, path in paths}
    assert read == {(*owner, path.partition("/")[0]) for path, owner in CLASS.items()}
    assert others == (["index.html", "link"] if os.name == "posix" else ["index.html"])
    assert (
        read_submission(found["dan"])[1][0]
        == "dan.rar is no .zip that can be read: File is not a zip file"
    )
    assert read_submission(found["a_x7fb"]) == ({}, [rf"{NONE}c\x85d/e\x85f"])
    assert [*read_submission(found["li_1"])[0]] == ["swinging.py", "pds_helper.py"]


@pytest.mark.parametrize(
    "names",
    [
        ["ann", "Ann", "ANN"],
        ["Zo\u00e9", "Zoe\u0301"],
        ["a/b", "a:b", "a_b"],
        ["x" * 300 + "1", "x" * 300 + "2"],
        ["con", "_con", "CON.txt", "", ".", "..", " "],
        ["=1", "\ud800", "\udc80", "\n"],
    ],
)
def test_a_students_key_is_apart_from_all_others_on_any_file_system(tmp_path, names):
    students = {Student(name, name) for name in names}
    # Of others, who call themselves so
    guesses = {Student(key, key) for key in keys_of(students).values()}
    keys = keys_of(students | guesses)
    # As macOS and Windows compare names
    alike = {normalize("NFC", key.upper()) for key in keys.values()}
    assert len(alike) == len(students | guesses)
    for key in keys.values():
        # As a file is called before it is whole
        (tmp_path / f".{key}.txt.12345678.tmp").write_text("")
        assert key == key.strip(" .") and not {*key} & {*'<>:"/|?*\\\n'}
        assert key.partition(".")[0].upper() not in ("CON", "NUL")


def test_a_key_is_the_plain_name_where_no_other_one_is_like_it():
    names = "Bea B", "Ünal (2)", "O'Brien", "con", "nul.txt"
    assert [*keys_of([Student(name, name) for name in names]).values()] == [
        *names[:3],
        "_con",
        "_nul.txt",
    ]


@pytest.mark.parametrize(
    "files", [{}, {"index.html": "a"}, PROJECT, READ], ids=["nothing", "a file", "project", "src"]
)
def test_a_folder_that_is_no_class_is_refused(tmp_path, files):
    with pytest.raises(
        ValueError,
        match="allowed is a folder with a folder or a .zip for each student, or with files",
    ):
        submissions_in(put_files(tmp_path, files))


@pytest.fixture(scope="session")
def empty(made, tmp_path_factory):
    """The grade of the starter."""
    return graded_in(shutil.copytree(made, tmp_path_factory.mktemp("empty") / "starter"))


def passed(grade):
    return {
        **grade,
        "checks": {name: {**check, "state": "passed"} for name, check in grade["checks"].items()},
    }


FORGED = {  # how a solution could change what pytest writes
    "a check less": lambda grade: {**grade, "checks": dict([*grade["checks"].items()][1:])},
    "a check more": lambda grade: {**grade, "checks": {**grade["checks"], "a": {}}},
    "another form": lambda grade: {**grade, "checks": dict.fromkeys(grade["checks"], 1)},
    "deep": lambda grade: "[" * 10**5,
    "not final": lambda grade: {**grade, "final": None},
    "nothing": lambda grade: "",
}
# How a run has ended, what it has written, the points, the problem, and whether this is final
ENDS = {
    "right": (0, passed, sum(COUNTS.values()), "", True),
    "waiting": (1, dict, 0, "", True),
    "a thread is left": (1, passed, sum(COUNTS.values()), "", True),
    "killed": (137, passed, sum(COUNTS.values()), "", False),
    "late": (one_run.LATE, FORGED["nothing"], 0, "no grade: pytest took longer than 600 s", False),
    "not run": (
        "the files cannot be written",
        FORGED["nothing"],
        0,
        "no grade: the files cannot be written",
        False,
    ),
    **{
        name: (1, form, 0, "no grade: pytest ended with status 1", False)
        for name, form in FORGED.items()
    },
    "not final": (1, FORGED["not final"], 0, "", False),
}


@pytest.fixture
def box(made, empty, tmp_path):
    """A sandbox for tests of run: they replace the function that starts processes."""
    (tmp_path / "work").mkdir()
    box = sandbox.Sandbox(made, tmp_path / "work", has_bubblewrap=False, stopped=threading.Event())
    box.empty = empty
    box.processes.end_orphans = lambda: None  # a browser of other tests may be one
    return box


@pytest.mark.parametrize("name", ENDS)
def test_a_grade_is_whole_and_only_that_of_a_run_with_an_end_is_final(box, name):
    status, changed, points, problem, is_final = ENDS[name]
    output = changed(box.empty)
    text = output if isinstance(output, str) else json.dumps(output)
    box.run_files = lambda *_: (status, text.encode())
    run = box.run({}, jobs=2)
    assert (sum(run.grade["points"].values()), run.problem, run.is_final) == (
        points,
        problem,
        is_final,
    )
    assert [*run.grade["checks"]] == [*box.empty["checks"]]


def test_what_a_solution_says_is_short_and_has_no_codes_of_a_terminal(empty, tmp_path):
    said = {"message": "\x1b[2J=1;2\n" + "x" * 50_000, "hint": "=1+1;=2"}
    checks = {name: {**check, **said} for name, check in empty["checks"].items()}
    words = {"next": "\t=1;2\x1b" + "y" * 50_000, "text": ["\x1b[2J\ud800" + "z" * 20_000] * 300}
    grade = report.read_grade(empty, json.dumps({**empty, "checks": checks, **words}).encode())
    table = report.Report()
    table.add(tmp_path, {"student": "@a;b", "seconds": 1.0, "problems": [], **grade})
    table.write(tmp_path / "grades.csv")
    (row,) = tables_of(tmp_path)[0].values()
    assert (row["student"], row["next"][:8]) == ("'@a,b", "\\t=1,2\\x")
    assert len((tmp_path / "grades.csv").read_text()) < 3000
    (text,) = (path.read_text(encoding="utf-8") for path in tmp_path.glob("*.txt"))
    assert len(text) < 11_000 and text.replace("\n", "").isprintable()


def test_a_cell_is_no_formula():
    assert [report.cell(name)[:1] for name in ("=1", "-a", "@b", "+c", " =1", "Bea")] == [
        "'"
    ] * 5 + ["B"]


@pytest.mark.parametrize(
    "name", ["a" * 300 + ".py", "beyond/a/b.py/c.py", "nul\0.py", "a/" * 1500 + "b.py"]
)
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
    assert (run.problem, run.is_final) == ("no grade: the disk was full", False)
    with pytest.raises(OSError, match="No space left") as raised:
        box.run({}, jobs=1, is_alone=True)
    assert (raised.value.errno, raised.value.filename) == (errno.ENOSPC, str(box.work))
    assert os.listdir(box.work) == []


def tables_of(folder):
    """Return the rows of grades.csv and the results in results.jsonl, each by student."""
    rows = csv.DictReader((folder / "grades.csv").read_text(encoding="utf-8-sig").splitlines())
    lines = (
        (folder / "results.jsonl").read_text(encoding="utf-8").splitlines()
        if len(os.listdir(folder)) > 2
        else []
    )
    return tuple(
        {each["student"]: each for each in table} for table in (rows, [*map(json.loads, lines)])
    )


# In bubblewrap, four at a time: none takes what others need.
FAST = """import grade_class as g, os, shutil
from teacher import sandbox as s
s.LAST, s.ALONE, s.SPARE, os.cpu_count = 12, 8, 2, lambda: 4 if shutil.which("bwrap") else 2
"""
UNBOXED = "--without-bubblewrap"
needs_bwrap = pytest.mark.skipif(
    shutil.which("bwrap") is None, reason="bubblewrap is not installed"
)


@pytest.fixture
def work():
    """A folder for the program's own folders, which other users can pass; those of pytest they
    cannot.
    """
    with TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        yield Path(folder)


@pytest.fixture(scope="session")
def python_for_all():
    """The path of a Python that other users can start: that of root may lie where they cannot pass."""
    if not sandbox.IS_ROOT or is_for_all(sys.executable):
        yield sys.executable
        return
    name = f"python3.{sys.version_info.minor}"
    with TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        python = f"{folder}/bin/python"
        with suppress(FileNotFoundError):  # the system has another version
            subprocess.run([f"/usr/bin/{name}", "-m", "venv", "--without-pip", folder], check=True)
            put_files(
                Path(folder), {f"lib/{name}/site-packages/all.pth": sysconfig.get_path("purelib")}
            )
        if not is_for_all(python):
            pytest.skip("other users cannot start this Python")
        yield python


def is_for_all(python) -> bool:
    """Return whether other users can start this Python, and find pytest."""
    nobody = {"user": 65534, "group": 65534, "extra_groups": []}
    with suppress(OSError):
        return (
            subprocess.run(
                [python, "-c", "import pandas, pytest"], cwd="/", **nobody, check=False
            ).returncode
            == 0
        )
    return False


@pytest.fixture
def grading(made, tmp_path, work, request):
    """A function that starts the program for the folder class."""

    def grading(*options, first=""):
        python = request.getfixturevalue("python_for_all") if UNBOXED in options else sys.executable
        env = {**os.environ, "TMPDIR": str(work), "PYTHONPATH": str(ROOT / "tests")}
        words = [python, "-c", f"{FAST}{first}g.main()", "class", "--starter", str(made), *options]
        return subprocess.Popen(
            words, cwd=tmp_path, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )

    return grading


def test_a_class_is_graded_goes_on_and_forgets_who_is_gone(
    solved, starter, tmp_path, grading, work
):
    write(starter, "extract_and_convert", "double_angle_update")
    for student, files in {
        "ann": solved,
        "bea": solved,
        "cem": files_of(starter),
        "dan": {"a.txt": b""},
    }.items():
        put_files(tmp_path / "class" / student / "src", files)
    change(tmp_path / "class" / "bea" / "src" / "swinging.py", "omega + -g", "omega + g")
    put_files(
        tmp_path / "class",
        {f"eve_1_{i}_{name}": content for i, (name, content) in enumerate(solved.items())},
    )
    put_files(
        tmp_path / "class",
        {"eve_1_9_swinging-1.py": solved["swinging.py"].decode().encode("utf-16")},
    )
    process = grading("--gradescope", "gradescope", first="g.SOME = 2; ")
    printed, errors = process.communicate(timeout=2 * SECONDS)
    assert (process.returncode, errors.count("\n")) == (0, int("Without bubblewrap" in errors))
    rows, first = tables_of(out := tmp_path / "class-grades")
    convert, double = (
        len(checks(function=name)) for name in ("extract_and_convert", "double_angle_update")
    )
    assert [
        (row["student"], row["grade"], *(int(row[tier]) for tier in SUITES))
        for row in rows.values()
    ] == [
        ("ann", "Honor roll", *COUNTS.values()),
        ("bea", "D", COUNTS["D"], 0, COUNTS["B"], 0, COUNTS["Honor roll"]),
        ("cem", "none", convert, 0, 0, 0, double),
        ("dan", "none", 0, 0, 0, 0, 0),
        ("eve", "D", COUNTS["D"], 0, 0, 0, COUNTS["Honor roll"]),
    ]
    took = "took swinging-1.py as swinging.py, left swinging.py"
    assert [row["problems"] for row in rows.values()] == ["", "", "", f"{NONE}src/a.txt", took]
    assert rows["bea"]["next"].startswith("angle_update in src/swinging.py, line ")
    for student, words in [
        ("ann", "Grade: Honor roll."),
        ("bea", "Your code, line by line:"),
        ("eve", "UTF-8"),
    ]:
        assert words in (out / f"{student}.txt").read_text(encoding="utf-8")
    hint = "This is the result with + in front of the acceleration. Gravity pulls the bob back down: -."
    assert f"    1  {hint} (angle_update)\n" in printed
    assert "Honor roll           1\n" in printed
    assert re.search(
        r"^2 solutions are graded. At this pace, the other 3 take \d+ s.$", printed, re.MULTILINE
    )
    assert os.name == "nt" or stat.S_IMODE(out.stat().st_mode) == 0o700
    result = json.loads((tmp_path / "gradescope" / "bea" / "results.json").read_text())
    (test,) = (
        test for test in result["tests"] if test["name"].startswith("C: angle_update: Takes in")
    )
    assert (
        test["score"],
        test["max_score"],
        "wrong       omega_new is 4, not 2." in test["output"],
    ) == (0, 1, True)
    assert (
        result["score"]
        == sum(test["score"] for test in result["tests"])
        == COUNTS["D"] + COUNTS["B"] + COUNTS["Honor roll"]
    )
    assert result["max_score"] == sum(COUNTS.values())

    # The first one is ann's
    whole, *others = sorted((out / "results.jsonl").read_text().splitlines())
    damaged = [whole.replace('"passed"', way) for way in ("1", "null", '"excellent"', '{"a": []}')]
    damaged += [whole.replace('"seconds": ', '"seconds": "x'), "[" * 100_000, whole[:99]]
    shutil.rmtree(tmp_path / "class" / "bea")
    (out / "results.jsonl").write_text("\n".join([*damaged, *others, '{"student": "dan", "dig']))
    grading().communicate(timeout=2 * SECONDS)
    rows, results = tables_of(out)
    assert len(results) == 4, rows
    assert [*rows] == [
        json.loads(line)["student"]
        for line in sorted((out / "results.jsonl").read_text().splitlines())
    ]
    assert [*rows] == ["ann", "cem", "dan", "eve"]
    assert results["ann"]["checks"] == first["ann"]["checks"]
    assert [results[name] for name in ("cem", "dan", "eve")] == [
        first[name] for name in ("cem", "dan", "eve")
    ]
    assert not (out / "bea.txt").exists()
    assert os.listdir(work) == []


# A solution that leaves a process, which no group has, and then a file that says so.
LEAVES = "if not os.fork():\n  os.setsid()\n  if os.fork(): os._exit(0)\n  os.execvp('sleep', ['sleep', '{sleeping}'])"


def sleeping(work) -> str:
    """Return seconds that only the sleeping processes of this test have."""
    return f"{10**9 + int(work.name[-4:].encode().hex(), 16)}"


def left_by(work) -> list[Path]:
    """Return the processes that LEAVES has left. They are found in Linux."""
    found = []
    for file in Path("/proc").glob("[0-9]*/cmdline"):
        with suppress(OSError):  # it has just ended
            if sleeping(work).encode() in file.read_bytes():
                found.append(file)
    return found


@on_posix
@pytest.mark.parametrize(
    ("options", "name"),
    [
        pytest.param((), "SIGINT", marks=needs_bwrap),
        ((UNBOXED,), "SIGTERM"),
        ((UNBOXED,), "SIGHUP"),
    ],
)
def test_an_interrupted_class_leaves_no_folder_and_no_process(
    solved, tmp_path, grading, work, options, name
):
    number = getattr(signal, name)
    file = f"import os\n{LEAVES}\nwhile True: pass".replace("{sleeping}", sleeping(work))
    for student in range(8):
        put_files(
            tmp_path / "class" / f"{student}" / "src", {**solved, "pds_helper.py": file.encode()}
        )
    process = grading(*options)
    wait_until(lambda: left_by(work) or sys.platform != "linux" and [*work.glob("*/tmp*/own/src")])
    for _ in range(3):
        process.send_signal(number)
    printed, errors = process.communicate(timeout=SECONDS)
    status = 128 + number
    assert (process.returncode, "Traceback" in errors) == (status, False), (printed, errors)
    assert printed.endswith(" of 8 solutions are graded. The same command goes on from there.\n")
    assert (os.listdir(work), left_by(work)) == ([], [])


def test_ctrl_c_while_the_starter_is_made_ends_at_once_and_keeps_the_grades(tmp_path, grading):
    put_files(tmp_path, {"class/ann/a.txt": "", "class-grades/grades.csv": "before"})
    process = grading(
        first="import signal; g.copy_starter = lambda *_: signal.raise_signal(signal.SIGINT); "
    )
    assert (process.communicate(timeout=SECONDS), process.returncode) == (("", ""), 130)
    assert (tmp_path / "class-grades" / "grades.csv").read_text() == "before"


def test_a_solution_is_run_without_the_limits_that_a_system_refuses(tmp_path, monkeypatch, capfd):
    """macOS refuses DATA and AS with a ValueError, as remove() does here."""
    resource = pytest.importorskip("resource")
    names = ("CORE", "CPU", "FSIZE", "NOFILE", "NPROC", "NPROC")
    left = [getattr(resource, f"RLIMIT_{name}") for name in names]
    monkeypatch.setattr(resource, "setrlimit", lambda number, _: left.remove(number))
    monkeypatch.setattr(one_run, "PYTEST", "own")
    monkeypatch.setattr(os, "geteuid", lambda: 1)
    monkeypatch.chdir(put_files(tmp_path, {"folder/own.py": "print('it ran')"}))
    assert (one_run.main(0, SECONDS, "folder"), capfd.readouterr().out, left) == (0, "it ran\n", [])


@on_posix
def test_a_solution_never_runs_as_root(monkeypatch):
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    with pytest.raises(PermissionError, match="a solution does not run as root"):
        one_run.main(0, SECONDS)


@on_posix
def test_a_bubblewrap_that_fails_ends_the_class_with_one_line(tmp_path, grading, monkeypatch):
    put_files(
        tmp_path,
        {"class/ann/a.txt": "", "bin/bwrap": "#!/bin/sh\necho bwrap: No permissions >&2\nexit 1\n"},
    )
    (tmp_path / "bin" / "bwrap").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}:{os.environ['PATH']}")
    process = grading()
    printed, errors = process.communicate(timeout=SECONDS)
    words = "pytest does not grade it in bubblewrap: bwrap: No permissions. See --help"
    assert (process.returncode, printed, errors) == (2, "", f"The starter: {words}\n")


@on_posix
def test_a_folder_of_grades_is_nobody_elses(tmp_path):
    planted = put_files(tmp_path / "planted", {"results.jsonl": ""})
    planted.chmod(0o777)
    linked = put_files(tmp_path / "linked", {"ann.txt": ""})
    (linked / "grades.csv").symlink_to(tmp_path / "others.csv")
    (tmp_path / "link").symlink_to(put_files(tmp_path / "own", {"a": ""}))
    for folder in (planted, linked, tmp_path / "link", linked / "ann.txt"):
        with pytest.raises(
            OSError, match="allowed is a new folder, or one that only you can write, without links"
        ):
            report.own_folder(folder)
    (tmp_path / "own").chmod(0o755)
    for folder in (tmp_path / "own", tmp_path / "new" / "one"):
        report.own_folder(folder)
        assert stat.S_IMODE(folder.stat().st_mode) == 0o700


# Two processes outlive the first one. One makes its successor, and ends. The other one is traced by
# a third process.
LEFT_OVER = """import ctypes, os, time
if not os.fork():
    os.setsid()
    while not os.fork(): pass
    os._exit(0)
if not os.fork():
    os.setsid()
    traced = os.fork()
    if traced: ctypes.CDLL(None).ptrace(0x4206, traced, 0, 0)
    time.sleep(999)
time.sleep(1)"""
RUNS = """import sys
from teacher.processes import children, Processes
print(Processes().run(sys.executable, "-c", sys.argv[1]), children("self"))"""


@pytest.mark.skipif(sys.platform != "linux", reason="on other systems, nobody finds such processes")
def test_of_a_process_nothing_is_left():
    done = python("-c", RUNS, LEFT_OVER, PYTHONPATH=f"{ROOT / 'tests'}")
    assert (done.stdout, done.stderr) == ("0 []\n", "")


FAMILY = """import os, time
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
        assert subprocess.run(command, check=False).returncode


# Runs of solutions are spoiled from outside: the first two, after that of the starter.
SPOILS = """
real, runs = s.Sandbox.run_files, []
def run_files(self, files, seconds, jobs):
    runs.append((len(files) > 0, seconds, jobs))
    spoiled = {2: 137, 3: s.one_run.LATE}.get(len(runs))
    return (spoiled, b"") if spoiled else real(self, files, seconds, jobs)
s.Sandbox.run_files = run_files
"""


def test_a_run_that_is_not_final_is_made_once_more_alone_and_only_a_grade_is_kept(
    solved, tmp_path, grading
):
    for student in ("ann", "bea", "cem"):
        put_files(tmp_path / "class" / student / "src", solved)
    put_files(
        tmp_path / "class" / "dan" / "src", {**solved, "swinging.py": b"import os\nos.abort()"}
    )
    process = grading(first=f"{SPOILS}import atexit; atexit.register(lambda: print(runs[-3:])); ")
    printed, _ = process.communicate(timeout=SECONDS)
    rows, results = tables_of(tmp_path / "class-grades")
    assert {name: row["grade"] for name, row in rows.items()} == {
        **dict.fromkeys(results, "Honor roll"),
        "dan": "none",
    }
    assert sorted(results) == ["ann", "bea", "cem"]
    assert rows["dan"]["problems"] == "no grade: pytest ended with status 134"
    assert printed.endswith(f"{[(True, 8, 1)] * 3}\n")


# What solutions do when their file is imported. These keep all their points,
HERE = "import os, shutil, signal, sys, threading, time\nhere = os.path.dirname(os.path.dirname(__file__))\n"
HARMLESS = {
    "leaves a process": LEAVES,
    "starts 60 processes": """begun = []
try:
  for _ in range(60):
    begun.append(os.fork())
    while not begun[-1]: pass
except OSError: pass
for process in begun:
  os.kill(process, 9)
  os.waitpid(process, 0)
assert 0 < len(begun) < 8""",
    "prints 10 MB": "print('x' * 10**7)",
    "closes the output": "sys.stdout.close()\nsys.stderr.close()",
    "makes warnings errors": "import warnings\nwarnings.simplefilter('error')\nleft_open = open(__file__)",
    "makes deep folders": "os.chdir(here)\nfor _ in range(3000): os.mkdir('a'); os.chdir('a')\nos.chdir(here)",
    "gets no rights": "import ctypes\nassert sys.platform != 'linux' or ctypes.CDLL(None).prctl(39, 0, 0, 0, 0) == 1",
    "takes rights away": "os.mkdir(here + '/a')\nos.chmod(here + '/a', 0)\nos.chmod(here + '/src', 0o500)",
}
# these too, in bubblewrap (outside of it, they write, kill and take what a line names),
CALLS = "import ctypes, socket\ncalls = ctypes.CDLL(None)\n"
BOXED = {
    "writes": "for path in {outside}:\n  try: open(path, 'w').write('x')\n  except OSError: pass",
    "reads": "for path in {outside}:\n  assert not os.path.exists(path)",
    "connects": CALLS + "assert socket.socket().connect_ex(('127.0.0.1', {port}))",
    "takes shared memory": CALLS + "assert calls.shmget(0, 10 ** 6, 0o1666) == -1",
    "takes memory in a file": "try: os.memfd_create('a')\nexcept OSError: pass\nelse: 1 / 0",
    "takes memory without a file": "import mmap\ntry: mmap.mmap(-1, 9)\nexcept OSError: pass\nelse: 1 / 0",
    "takes zeros": "assert not os.path.exists('/dev/zero')",
    "calls in a ring": CALLS
    + "assert calls.syscall(425, 1, ctypes.create_string_buffer(120)) == -1",
    "reads keys": CALLS
    + "assert calls.syscall(250 if os.uname().machine == 'x86_64' else 219, 0, -4, 1) == -1",
    "locks": "import fcntl\ntry: fcntl.flock(open('/one_run.py'), fcntl.LOCK_EX)\nexcept OSError: pass\nelse: 1 / 0",
    "leases": "import fcntl\ntry: fcntl.fcntl(open(__file__), 1024, 1)\nexcept OSError as e: assert e.errno == 38",
    "attaches": CALLS + "assert calls.ptrace(16, 1, 0, 0) == -1",
    "calls machines": "try: __import__('socket').socket(40, 1)\nexcept OSError: pass\nelse: 1 / 0",
    "makes namespaces": CALLS + "assert calls.unshare(0x10000000) == -1",
}
# and these spoil their own run.
SPOILED = {
    "kills its parent": "os.kill(os.getppid(), 9)",
    "stops its parent": "os.kill(os.getppid(), signal.SIGSTOP)",
    "forks": "while True:\n  try: os.fork()\n  except OSError: pass",
    "starts threads": "while True: threading.Thread(target=time.sleep, args=(300,)).start()",
    "takes memory": "rows = [0]\nwhile True: rows += rows",
    "fills its folder": "for i in range(100): open(here + '/' + str(i), 'wb').write(bytes(9_000_000))",
    "removes all": "shutil.rmtree(here, ignore_errors=True)",
    "makes a pipe": "os.mkfifo(here + '/grade.json')",
    "makes a link": "os.symlink('/dev/zero', here + '/grade.json')",
    "prints without end": "while True: os.write(1, b'x' * 100_000)",
    "ends at once": "os.abort()",
}


@on_posix
@pytest.mark.slow
@pytest.mark.parametrize(
    "options", [pytest.param((), marks=needs_bwrap), (UNBOXED,)], ids=["bubblewrap", "limits"]
)
def test_hostile_solutions_harm_nobody_else(solved, tmp_path, grading, work, options):
    boxed = not options
    (tmp_path / "secret.txt").write_text("secret")
    outside = [
        str(tmp_path / name)
        for name in ("secret.txt", "class/an honest one/src/swinging.py", "new.txt")
    ]
    full = {**HARMLESS, **(BOXED if boxed else {})}
    rows = {
        **full,
        **SPOILED,
        **({"kills all": "os.kill(-1, 9)"} if boxed else {}),
        "writes page.csv": "",
    }
    put_files(tmp_path / "class" / "an honest one" / "src", solved)
    with socket.create_server(("127.0.0.1", 0)) as listening:
        for name, text in rows.items():
            text = text.replace("{outside}", f"{outside}").replace(
                "{port}", f"{listening.getsockname()[1]}"
            )
            text = text.replace("{sleeping}", sleeping(work))
            files = {**solved, "swinging.py": solved["swinging.py"] + f"{HERE}{text}".encode()}
            put_files(tmp_path / "class" / name / "src", files)
        main = tmp_path / "class" / "writes page.csv" / "src" / "visualize_cradle_run.py"
        change(
            main, "    pend_list = make", "    open(page.csv, 'w').close()\n    pend_list = make"
        )
        before = contents(tmp_path)
        process = grading(*options)
        _, errors = process.communicate(timeout=10 * SECONDS)
    assert (process.returncode, "Traceback" in errors, "Without bubblewrap" in errors) == (
        0,
        False,
        not boxed,
    ), errors
    table, results = tables_of(tmp_path / "class-grades")
    points = {student: int(row["points"]) for student, row in table.items()}
    assert {points[student] for student in (*full, "an honest one")} == {sum(COUNTS.values())}, (
        points
    )
    assert {*results} == {
        student for student, row in table.items() if "no grade" not in row["problems"]
    }
    shutil.rmtree(tmp_path / "class-grades")
    assert contents(tmp_path) == before
    assert (os.listdir(work), left_by(work)) == ([], [])


def contents(folder):
    return {path: path.read_bytes() for path in folder.rglob("*.*") if path.is_file()}


@pytest.fixture
def main(made, monkeypatch, capsys):
    """A function that runs a program in this process; it returns (status, stdout, stderr)."""

    def make_old(folder):
        shutil.copytree(made, folder)
        os.utime(folder / "src" / "swinging.py", (0, 0))  # of 1970, as in a Nix store

    monkeypatch.setattr(make_autograder, "make_starter", make_old)

    def main(program, *arguments):
        monkeypatch.setattr(sys, "argv", [program.__name__ + ".py", *map(str, arguments)])
        return call(program.main, capsys)

    return main


@pytest.mark.parametrize(
    ("program", "arguments", "words"),
    [
        (grade_class, "nowhere", "argument SUBMISSIONS: nowhere: |No such file or directory"),
        (
            grade_class,
            "class/ann",
            "argument SUBMISSIONS: found '{here}/class/ann', allowed is a folder with",
        ),
        (
            grade_class,
            "class --out class/grades",
            "argument --out: found 'class/grades', allowed is a folder outside",
        ),
        (
            grade_class,
            "class --starter class",
            "argument --starter: found 'class', allowed is a folder made by",
        ),
        (
            grade_class,
            "class --out file.zip",
            "file.zip: allowed is a new folder, or one that only you can write",
        ),
        (
            make_autograder,
            "file.zip",
            "argument FILE.zip: found 'file.zip', allowed is a new file that ends in .zip",
        ),
        (
            make_autograder,
            "cradle.tar",
            "argument FILE.zip: found 'cradle.tar', allowed is a new file",
        ),
        (
            make_autograder,
            "nowhere/cradle.zip",
            "nowhere/cradle.zip cannot be made: No such file or directory",
        ),
        (make_starter, "class", "found 'class', allowed is a new or an empty folder"),
        (
            make_starter,
            "file.zip/new",
            "argument FOLDER: file.zip/new cannot be made: |Not a directory",
        ),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(
    tmp_path, monkeypatch, main, program, arguments, words
):
    monkeypatch.chdir(tmp_path)
    put_files(tmp_path, {"file.zip": "mine", "class/ann/a.txt": ""})
    status, printed, errors = main(program, *arguments.split())
    assert (status, printed, errors.count("\n")) == (2, "", 1)
    # Windows has other words
    ours, _, systems = words.format(here=tmp_path.as_posix()).partition("|")
    assert ours + systems * (os.name == "posix") in errors.replace(os.sep, "/")
    assert (tmp_path / "file.zip").read_text() == "mine"


@on_posix
@pytest.mark.parametrize("installs", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_the_autograder_grades_a_solution_and_holds_no_answers(tmp_path, main, solved, installs):
    """Without an installation, this Python stands in for that of the autograder."""
    assert main(make_autograder, tmp_path / "cradle.zip")[::2] == (0, "")
    with zipfile.ZipFile(tmp_path / "cradle.zip") as archive:
        modes = {info.filename: info.external_attr >> 16 for info in archive.infolist()}
        archive.extractall(tmp_path / "source")
    assert modes["run_autograder"] & modes["setup.sh"] & 0o111 == 0o111
    assert (
        "angle_update is not written yet"
        in (tmp_path / "source" / "src" / "swinging.py").read_text()
    )
    assert not (tmp_path / "source" / "tests" / "project").exists()
    put_files(tmp_path / "venv" / "bin", {"python": f'#!/bin/sh\nexec "{sys.executable}" "$@"\n'})
    (tmp_path / "venv" / "bin" / "python").chmod(0o755)
    put_files(tmp_path / "submission" / "src", {"pds_helper.py": solved["pds_helper.py"]})
    shutil.copy(tmp_path / "source" / "run_autograder", tmp_path)
    if installs:
        shutil.rmtree(tmp_path / "venv")
        subprocess.run(["bash", tmp_path / "source" / "setup.sh"], check=True, capture_output=True)
    subprocess.run(
        ["bash", tmp_path / "run_autograder"], check=True, capture_output=True, timeout=2 * SECONDS
    )
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    convert = len(checks(function="extract_and_convert"))
    assert (results["score"], results["max_score"]) == (convert, sum(COUNTS.values()))
