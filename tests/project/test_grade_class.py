"""Grading a class: how submissions are read, what a solution can do, and what the teacher gets."""

import asyncio
import csv
import errno
import json
import os
import shutil
import signal
import socket
import stat
import subprocess
import sys
import zipfile
from io import BytesIO
from unittest.mock import AsyncMock, Mock

import grade_class
import make_autograder
import make_starter
import pytest
from programs import call, on_posix, ROOT, SECONDS, wait_until
from students import change, COUNTS, files_of, graded_in, put_files, write

from grading.grader import checks
from grading.handout import FUNCTIONS, SUITES
from teacher import one_run, report, sandbox
from teacher.submissions import LEFT_OUT, MOST_BYTES, MOST_FILES, MOST_PROBLEMS, read_submission, submissions_in

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


OTHERS = {"README.md": "text", "support/swinging.py": "mine", ".venv/lib/swinging.py": "x", "tests/swinging.py": "mine"}
PROJECT = {**SOLUTION, **OTHERS}
MAC = {**below("cradle", PROJECT), **{f"__MACOSX/{name}": "mac" for name in below("cradle")}}
MORE = {"src/helpers/angles.py": "a", "src/notes.txt": "n", "src/__pycache__/x.py": "x"}
NEWER = {**SOLUTION, "src/swinging (1).py": "1", "src/swinging-12.py": "12", "src/swinging-2.py": "2"}
CAPITAL = renamed("swinging", "Swinging"), renamed("swinging", "Swinging", READ)
NONE = "none of the handout's files is there, found: "
TOOK = [f"took src/{name.replace('.py', '-1.py')} as {name}" for name in sorted(READ)]
LEFT = "took src/swinging-12.py as swinging.py, left src/swinging.py, src/swinging (1).py, src/swinging-2.py"
FORMS = {  # the files of a submission, those that count, and the problems
    "the files of src": (READ, READ, []),
    "a project of macOS": (MAC, READ, []),
    "more files": ({**SOLUTION, **MORE}, {**READ, "helpers/angles.py": b"a"}, []),
    "two projects": ({**below("new"), "old/src/swinging.py": "old"}, READ, ["took new/src, left old/src"]),
    "a capital": (*CAPITAL, ["src/swinging.py is missing, found 'Swinging.py'"]),
    "nothing": ({}, {}, [NONE]),
    "much": ({**SOLUTION, "src/big.py": "#" * MOST_BYTES}, {}, ["too large: allowed are at most 200 Python files"]),
    "many": ({**SOLUTION, **{f"src/a{i}.py": "" for i in range(MOST_FILES)}}, {}, ["too large: allowed are"]),
    "all again": (renamed(".py", "-1.py"), READ, TOOK),
    "one again": (NEWER, {**READ, "swinging.py": b"12"}, [LEFT]),
    "again and again": (renamed(".py", "-1 (2).py"), READ, ["took "] * 5),
}


@pytest.mark.parametrize(("files", "found", "problems"), FORMS.values(), ids=FORMS)
@pytest.mark.parametrize("place", ["ann", "ann.zip", "ann/cradle.zip", "ann.zip/cradle.zip"])
def test_the_files_of_src_are_found_and_problems_named(tmp_path, files, found, problems, place):
    (tmp_path / "ann").mkdir()
    forms = {"ann": below("ann", files), "ann.zip/cradle.zip": {"ann.zip": zip_of({"cradle.zip": zip_of(files)})}}
    put_files(tmp_path, forms.get(place, {place: zip_of(files)}))
    read, told = read_submission({"": tmp_path / place.removesuffix("/cradle.zip")})
    assert (read, len(told)) == (found, len(problems))
    for each, problem in zip(sorted(told), sorted(problems), strict=True):
        assert each.replace("cradle.zip/", "").startswith(problem)


ODD = {  # entries of a .zip that are left out, and how they are there
    **dict.fromkeys(("C:/src/swinging.py", "/src/swinging.py", "src/../../swinging.py", "..\\src\\swinging.py"), {}),
    "src/link.py": {"external_attr": (stat.S_IFLNK | 0o777) << 16},
    "src/bzip2.py": {"compress_type": zipfile.ZIP_BZIP2},
    "src/lzma.py": {"compress_type": zipfile.ZIP_LZMA},
}


@pytest.mark.parametrize("name", ODD)
def test_an_odd_entry_of_a_zip_is_named_and_the_rest_is_taken(tmp_path, name):
    info = zipfile.ZipInfo(name)
    for key, value in ODD[name].items():
        setattr(info, key, value)
    (tmp_path / "a.zip").write_bytes(zip_of({**SOLUTION, info: "x", f"src/a-{'9' * 5000}.py": ""}))
    files, problems = read_submission({"": tmp_path / "a.zip"})
    assert (READ.items() <= files.items(), len(files)) == (True, len(READ) + 1)
    assert problems[0] == f"left out {name.replace(os.sep, '/')}: {LEFT_OUT}"  # as zipfile reads it on Windows


def test_an_encrypted_and_a_damaged_entry_are_named_and_the_rest_is_taken(tmp_path):
    data = bytearray(zip_of(SOLUTION))
    local, central = data.find(b"src/swinging.py"), data.rfind(b"src/pds_helper.py")
    data[local + len("src/swinging.py")] ^= 0xFF  # the content
    data[central - 38] |= 1  # a flag: encrypted
    (tmp_path / "a.zip").write_bytes(data)
    files, problems = read_submission({"": tmp_path / "a.zip"})
    assert files == {name: text for name, text in READ.items() if name not in ("swinging.py", "pds_helper.py")}
    assert problems[0] == f"left out src/pds_helper.py: {LEFT_OUT}"
    assert problems[1].startswith("left out src/swinging.py: ")


def test_problems_are_few_and_short(tmp_path):
    (tmp_path / "a.zip").write_bytes(zip_of({f"/{'a' * 300}{i}\x1b.py": "" for i in range(99)}))
    _, problems = read_submission({"": tmp_path / "a.zip"})
    assert (len(problems), problems[-1]) == (MOST_PROBLEMS + 1, "and more")
    assert max(map(len, problems)) <= 203 and "".join(problems).isprintable()


@on_posix
def test_pipes_and_links_are_not_read(tmp_path):
    """A link could lead to another student's files."""
    folder = put_files(tmp_path, {"secret.py": "secret", "ann/src/pds_helper.py": "a"}) / "ann"
    (folder / "src" / "swinging.py").symlink_to(tmp_path / "secret.py")
    (folder / "src" / "folder").symlink_to(tmp_path)
    os.mkfifo(folder / "src" / "special_cradles.py")
    files, problems = read_submission({"": folder})
    assert files == {"pds_helper.py": b"a"}
    assert {"src/special_cradles.py is missing", "src/swinging.py is missing"} <= {*problems}


def test_each_folder_each_archive_and_each_name_of_a_flat_download_is_a_student(tmp_path):
    """Letters of a name that cannot be printed are spelled out."""
    for name in ("ann", "Bea B", ".git", "__MACOSX", "a\x85b"):
        (tmp_path / name).mkdir()
    files = ["ann.zip", "cem.ZIP", "dan.rar", "index.html", "a\x7fb/c\x85d/e\x85f"]
    files += ["li_1_5_swinging.py", "li_1_6_pds_helper-1.py", "li_2_7_swinging.py", "eve_LATE_3_8_a.zip"]
    put_files(tmp_path, dict.fromkeys([*files, "Fay F_9_assignsubmission_file_swinging.py"], ""))
    found, others = submissions_in(tmp_path)
    students = {"Bea B": "Bea B", "ann": "ann", "ann.zip": "ann.zip", "cem": "cem.ZIP", "dan": "dan.rar"}
    whole = {**students, r"a\x7fb": "a\x7fb", r"a\x85b": "a\x85b"}
    assert {name: paths[""].name for name, paths in found.items() if "" in paths} == whole
    flat = {"li_1": {"swinging.py", "pds_helper-1.py"}, "li_2": {"swinging.py"}, "Fay F": {"swinging.py"}}
    assert {name: {*paths} for name, paths in found.items() if "" not in paths} == {**flat, "eve": {"a.zip"}}
    assert others == ["index.html"]
    assert read_submission(found["dan"])[1][0] == "dan.rar is no .zip that can be read: File is not a zip file"
    assert read_submission(found[r"a\x7fb"]) == ({}, [rf"{NONE}c\x85d/e\x85f"])
    assert [*read_submission(found["li_1"])[0]] == ["swinging.py", "pds_helper.py"]


@pytest.mark.parametrize("files", [{}, {"index.html": "a"}, PROJECT, READ], ids=["nothing", "a file", "project", "src"])
def test_a_folder_that_is_no_class_is_refused(tmp_path, files):
    with pytest.raises(ValueError, match="allowed is a folder with a folder or a .zip for each student, or with files"):
        submissions_in(put_files(tmp_path, files))


@pytest.fixture(scope="session")
def empty(made, tmp_path_factory):
    """The grade of the starter."""
    return graded_in(shutil.copytree(made, tmp_path_factory.mktemp("empty") / "starter"))


def passed(grade):
    return {**grade, "checks": {name: {**check, "state": "passed"} for name, check in grade["checks"].items()}}


ENDED = "no grade: pytest ended"
OUTPUTS = {  # the exit status, how the grade of the starter changes, and the problem
    "right": (0, passed, ""),
    "waiting": (1, lambda grade: grade, ""),
    "another status": (1, passed, "no grade: pytest ended with status 1"),
    "a check less": (1, lambda grade: {**grade, "checks": dict([*grade["checks"].items()][1:])}, ENDED),
    "a check more": (1, lambda grade: {**grade, "checks": {**grade["checks"], "a": {}}}, ENDED),
    "another form": (1, lambda grade: {**grade, "checks": dict.fromkeys(grade["checks"], 1)}, ENDED),
    "deep": (1, lambda grade: "[" * 10**5, ENDED),
    "late": (one_run.LATE, passed, "no grade: pytest took longer than 100 s"),
    "not run": ("the files cannot be written", lambda grade: "", "no grade: the files cannot be written"),
}


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_grade_agrees_with_the_checks_and_with_the_exit_status(empty, name):
    status, changed, problem = OUTPUTS[name]
    output = changed(empty)
    text = output if isinstance(output, str) else json.dumps(output)
    grade = report.read_grade(empty, status, text.encode(), ["one"])
    assert grade["grade"] == ("Honor roll" if name == "right" else None)
    assert [*grade["points"].values()] == [*(COUNTS.values() if name == "right" else [0] * 5)]
    assert ([*grade["checks"]], grade["problems"][0]) == ([*empty["checks"]], "one")
    assert "".join(grade["problems"][1:]).startswith(problem) and len(grade["problems"]) == 1 + bool(problem)


def test_what_a_solution_says_is_short_and_has_no_codes_of_a_terminal(empty, tmp_path):
    said = {"message": "\x1b[2J=1;2\n" + "x" * 50_000, "hint": "=1+1;=2"}
    checks = {name: {**check, **said} for name, check in empty["checks"].items()}
    words = {"next": "\t=1;2\x1b" + "y" * 50_000, "text": ["\x1b[2J\ud800" + "z" * 20_000] * 300}
    grade = report.read_grade(empty, 1, json.dumps({**empty, "checks": checks, **words}).encode(), [])
    report.write_grades(tmp_path, [{"student": "@a;b", "digest": "", "seconds": 1.0, **grade}])
    (row,) = tables_of(tmp_path)[0].values()
    assert (row["student"], row["next"][:8]) == ("'@a,b", "\\t=1,2\\x")
    assert len((tmp_path / "grades.csv").read_text()) < 3000
    (text,) = (path.read_text(encoding="utf-8") for path in tmp_path.glob("*.txt"))
    assert len(text) < 11_000 and text.replace("\n", "").isprintable()


def test_names_are_safe_in_files_and_in_tables(tmp_path):
    names = ["Bea B", "Ünal (2)", "=1+1", "a/../b", "x" * 252, "\u00e9" * 252, "con.", "-a", "@b", "+c", ""]
    files = [report.file_name(name) for name in names]
    assert (files[:2], len({*files})) == (names[:2], len(names))
    put_files(tmp_path, dict.fromkeys((f"{file}.txt" for file in files), "a"))
    assert [report.cell(name)[:1] for name in ("=1", "-a", "@b", "+c", " =1", "Bea")] == ["'"] * 5 + ["B"]


@pytest.mark.parametrize("name", ["a" * 300 + ".py", "beyond/a/b.py/c.py", "nul\0.py", "a/" * 1500 + "b.py"])
def test_files_that_cannot_be_written_are_told(made, tmp_path, name):
    files = {"beyond/a/b.py": b"", name: b""}
    status, output = asyncio.run(sandbox.run(made, tmp_path, [], False, files))
    assert status.startswith("the files cannot be written: ")
    assert (output, os.listdir(tmp_path)) == (b"", [])


def test_a_full_disk_stops_the_class_and_is_named(made, tmp_path, monkeypatch):
    """It costs no student a point."""
    monkeypatch.setattr(sandbox, "run_in", AsyncMock(return_value=1))
    monkeypatch.setattr(shutil, "disk_usage", lambda _: Mock(free=1000))
    with pytest.raises(OSError, match="No space left") as raised:
        asyncio.run(sandbox.run(made, tmp_path, [], False, {}))
    assert (raised.value.errno, raised.value.filename) == (errno.ENOSPC, str(tmp_path))
    assert os.listdir(tmp_path) == []


def tables_of(folder):
    """Return the rows of grades.csv and the results in results.jsonl, each by student."""
    rows = csv.DictReader((folder / "grades.csv").read_text(encoding="utf-8").splitlines())
    lines = (folder / "results.jsonl").read_text(encoding="utf-8").splitlines() if len(os.listdir(folder)) > 2 else []
    return tuple({each["student"]: each for each in table} for table in (rows, [*map(json.loads, lines)]))


# In bubblewrap, four at a time: none takes what others need.
FAST = """import grade_class as g, os, shutil
from teacher import one_run, sandbox as s
one_run.WHOLE, s.SPARE, os.cpu_count = 20, 2, lambda: 4 if shutil.which("bwrap") else 2
"""


@pytest.fixture
def grading(made, tmp_path):
    """A function that starts the program for the folder class; a submission has 20 s."""
    (tmp_path / "work").mkdir(mode=0o777)

    def grading(*options, first=""):
        env = {**os.environ, "TMPDIR": str(tmp_path / "work"), "PYTHONPATH": str(ROOT / "tests")}
        words = [sys.executable, "-c", f"{FAST}{first}g.main()", "class", "--starter", str(made), *options]
        return subprocess.Popen(words, cwd=tmp_path, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    return grading


def test_a_class_is_graded_goes_on_and_forgets_who_is_gone(solved, starter, tmp_path, grading):
    write(starter, "extract_and_convert", "double_angle_update")
    for student, files in {"ann": solved, "bea": solved, "cem": files_of(starter), "dan": {"a.txt": b""}}.items():
        put_files(tmp_path / "class" / student / "src", files)
    change(tmp_path / "class" / "bea" / "src" / "swinging.py", "omega + -g", "omega + g")
    put_files(tmp_path / "class", {f"eve_1_{i}_{name}": content for i, (name, content) in enumerate(solved.items())})
    put_files(tmp_path / "class", {"eve_1_9_swinging-1.py": solved["swinging.py"].decode().encode("utf-16")})
    process = grading("--gradescope", "gradescope")
    printed, errors = process.communicate(timeout=2 * SECONDS)
    assert (process.returncode, errors.count("\n")) == (0, int("Without bubblewrap" in errors))
    rows, first = tables_of(out := tmp_path / "class-grades")
    convert, double = (len(checks(function=name)) for name in ("extract_and_convert", "double_angle_update"))
    assert [(row["student"], row["grade"], *(int(row[tier]) for tier in SUITES)) for row in rows.values()] == [
        ("ann", "Honor roll", *COUNTS.values()),
        ("bea", "D", COUNTS["D"], 0, COUNTS["B"], 0, COUNTS["Honor roll"]),
        ("cem", "none", convert, 0, 0, 0, double),
        ("dan", "none", 0, 0, 0, 0, 0),
        ("eve", "D", COUNTS["D"], 0, 0, 0, COUNTS["Honor roll"]),
    ]
    took = "took swinging-1.py as swinging.py, left swinging.py"
    assert [row["problems"] for row in rows.values()] == ["", "", "", f"{NONE}src/a.txt", took]
    assert rows["bea"]["next"].startswith("angle_update in src/swinging.py, line ")
    for student, words in [("ann", "Grade: Honor roll."), ("bea", "Your code, line by line:"), ("eve", "UTF-8")]:
        assert words in (out / f"{student}.txt").read_text(encoding="utf-8")
    hint = "This is the result with + in front of the acceleration. Gravity pulls the bob back down: -."
    assert f"    1  {hint} (angle_update)\n" in printed
    assert "Honor roll           1\n" in printed
    assert os.name == "nt" or stat.S_IMODE(out.stat().st_mode) == 0o700
    result = json.loads((tmp_path / "gradescope" / "bea" / "results.json").read_text())
    (test,) = (test for test in result["tests"] if test["name"].startswith("C: angle_update: Takes in"))
    assert (test["score"], test["max_score"], "wrong       omega_new is 4, not 2." in test["output"]) == (0, 1, True)
    assert (
        result["score"]
        == sum(test["score"] for test in result["tests"])
        == COUNTS["D"] + COUNTS["B"] + COUNTS["Honor roll"]
    )
    assert result["max_score"] == sum(COUNTS.values())

    whole, *others = sorted((out / "results.jsonl").read_text().splitlines())  # the first one is ann's
    damaged = [whole.replace('"passed"', way) for way in ("1", "null", '"excellent"', '{"a": []}')]
    damaged += [whole.replace('"seconds": ', '"seconds": "x'), "[" * 100_000, whole[:99]]
    shutil.rmtree(tmp_path / "class" / "bea")
    (out / "results.jsonl").write_text("\n".join([*damaged, *others, '{"student": "dan", "dig']))
    grading().communicate(timeout=2 * SECONDS)
    rows, results = tables_of(out)
    assert [*rows] == [json.loads(line)["student"] for line in sorted((out / "results.jsonl").read_text().splitlines())]
    assert [*rows] == ["ann", "cem", "dan", "eve"]
    assert results["ann"]["checks"] == first["ann"]["checks"]
    assert [results[name] for name in ("cem", "dan", "eve")] == [first[name] for name in ("cem", "dan", "eve")]
    assert not (out / "bea.txt").exists()
    assert os.listdir(tmp_path / "work") == []


@on_posix
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_class_leaves_nothing_in_the_temporary_folder(solved, tmp_path, grading, number):
    for student in range(8):
        put_files(tmp_path / "class" / f"{student}" / "src", {**solved, "swinging.py": b"while True: pass"})
    process = grading()
    wait_until(lambda: [*tmp_path.glob("work/*/tmp*/own/src")])
    for _ in range(3):
        process.send_signal(number)
    printed, errors = process.communicate(timeout=SECONDS)
    assert (process.returncode, "Traceback" in errors) == (130, False), errors
    assert printed.endswith(" of 8 solutions are graded. The same command goes on from there.\n")
    assert os.listdir(tmp_path / "work") == []


def test_ctrl_c_while_the_starter_is_made_ends_at_once_and_keeps_the_grades(tmp_path, grading):
    put_files(tmp_path, {"class/ann/a.txt": "", "class-grades/grades.csv": "before"})
    process = grading(first="import signal; g.copy_starter = lambda *_: signal.raise_signal(signal.SIGINT); ")
    assert (process.communicate(timeout=SECONDS), process.returncode) == (("", ""), 130)
    assert (tmp_path / "class-grades" / "grades.csv").read_text() == "before"


def test_a_solution_is_run_without_the_limits_that_a_system_refuses(tmp_path, monkeypatch, capfd):
    """macOS refuses DATA and AS with a ValueError, as remove() does here."""
    resource, names = pytest.importorskip("resource"), ("CORE", "CPU", "FSIZE", "NOFILE", "NPROC", "NPROC")
    left = [getattr(resource, f"RLIMIT_{name}") for name in names]
    monkeypatch.setattr(resource, "setrlimit", lambda number, _: left.remove(number))
    monkeypatch.setattr(one_run, "PYTEST", "own")
    monkeypatch.chdir(put_files(tmp_path, {"folder/own.py": "print('it ran')"}))
    assert (one_run.main(0, SECONDS, "folder"), capfd.readouterr().out, left) == (0, "it ran\n", [])


# What solutions do when their file is imported. These keep all their points,
HERE = "import os, shutil, signal, sys, threading, time\nhere = os.path.dirname(os.path.dirname(__file__))\n"
HARMLESS = {
    "leaves a process": "if not os.fork():\n  os.setsid()\n  time.sleep(300)\n  os._exit(0)",
    "makes deep folders": "os.chdir(here)\nfor _ in range(3000): os.mkdir('a'); os.chdir('a')\nos.chdir(here)",
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
    "reads keys": CALLS + "assert calls.syscall(250 if os.uname().machine == 'x86_64' else 219, 0, -4, 1) == -1",
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
    "catches everything": "while True:\n  try: time.sleep(1)\n  except BaseException: pass",
    "ends at once": "os.abort()",
}


@on_posix
@pytest.mark.slow
@pytest.mark.parametrize("boxed", [True, False], ids=["bubblewrap", "limits"])
def test_hostile_solutions_harm_nobody_else(solved, tmp_path, grading, boxed):
    if boxed and shutil.which("bwrap") is None:
        pytest.skip("bubblewrap is not installed")
    (tmp_path / "secret.txt").write_text("secret")
    outside = [str(tmp_path / name) for name in ("secret.txt", "class/an honest one/src/swinging.py", "new.txt")]
    full = {**HARMLESS, **(BOXED if boxed else {})}
    rows = {**full, **SPOILED, **({"kills all": "os.kill(-1, 9)"} if boxed else {}), "writes page.csv": ""}
    put_files(tmp_path / "class" / "an honest one" / "src", solved)
    with socket.create_server(("127.0.0.1", 0)) as listening:
        for name, text in rows.items():
            text = text.replace("{outside}", f"{outside}").replace("{port}", f"{listening.getsockname()[1]}")
            files = {**solved, "swinging.py": solved["swinging.py"] + f"{HERE}{text}".encode()}
            put_files(tmp_path / "class" / name / "src", files)
        main = tmp_path / "class" / "writes page.csv" / "src" / "visualize_cradle_run.py"
        change(main, "    pend_list = make", "    open(page.csv, 'w').close()\n    pend_list = make")
        before = contents(tmp_path)
        process = grading(first="" if boxed else "s.shutil.which = lambda _: None; ")
        _, errors = process.communicate(timeout=10 * SECONDS)
    assert (process.returncode, "Traceback" in errors, "Without bubblewrap" in errors) == (0, False, not boxed), errors
    points = {student: int(row["points"]) for student, row in tables_of(tmp_path / "class-grades")[0].items()}
    assert {points[student] for student in (*full, "an honest one")} == {sum(COUNTS.values())}, points
    shutil.rmtree(tmp_path / "class-grades")
    assert contents(tmp_path) == before
    assert os.listdir(tmp_path / "work") == []


def contents(folder):
    return {path: path.read_bytes() for path in folder.rglob("*.*") if path.is_file() and "work" not in path.parts}


@pytest.fixture
def main(made, monkeypatch, capsys):
    """A function that runs a program in this process; it returns (status, stdout, stderr)."""
    monkeypatch.setattr(make_autograder, "make_starter", lambda folder: shutil.copytree(made, folder))

    def main(program, *arguments):
        monkeypatch.setattr(sys, "argv", [program.__name__ + ".py", *map(str, arguments)])
        return call(program.main, capsys)

    return main


@pytest.mark.parametrize(
    ("program", "arguments", "words"),
    [
        (grade_class, "nowhere", "argument SUBMISSIONS: nowhere: |No such file or directory"),
        (grade_class, "class/ann", "argument SUBMISSIONS: found '{here}/class/ann', allowed is a folder with"),
        (grade_class, "class --out class/grades", "argument --out: found 'class/grades', allowed is a folder outside"),
        (grade_class, "class --starter class", "argument --starter: found 'class', allowed is a folder made by"),
        (grade_class, "class --out file.zip", "file.zip: |File exists"),
        (make_autograder, "file.zip", "argument FILE.zip: found 'file.zip', allowed is a new file that ends in .zip"),
        (make_autograder, "cradle.tar", "argument FILE.zip: found 'cradle.tar', allowed is a new file"),
        (make_autograder, "nowhere/cradle.zip", "nowhere/cradle.zip cannot be made: No such file or directory"),
        (make_starter, "class", "found 'class', allowed is a new or an empty folder"),
        (make_starter, "file.zip/new", "argument FOLDER: file.zip/new cannot be made: |Not a directory"),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(tmp_path, monkeypatch, main, program, arguments, words):
    monkeypatch.chdir(tmp_path)
    put_files(tmp_path, {"file.zip": "mine", "class/ann/a.txt": ""})
    status, printed, errors = main(program, *arguments.split())
    assert (status, printed, errors.count("\n")) == (2, "", 1)
    ours, _, systems = words.format(here=tmp_path.as_posix()).partition("|")  # Windows has other words
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
    convert = len(checks(function="extract_and_convert"))
    assert (results["score"], results["max_score"]) == (convert, sum(COUNTS.values()))
