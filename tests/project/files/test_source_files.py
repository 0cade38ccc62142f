"""A run has the code of the files as they are, and leaves no module; a save is noticed once."""

import linecache
import os
import py_compile
import sys

import pytest

from support.files import source_files
from support.files.cradle_csv import POLL
from support.files.source_files import fresh_modules, LiveSource, main_module, run_file


@pytest.fixture
def src(tmp_path, monkeypatch):
    """The folder src of an empty project."""
    src = tmp_path / "src"
    (tmp_path / "support").mkdir()
    src.mkdir()
    monkeypatch.setattr(source_files, "ROOT", tmp_path)
    monkeypatch.setattr(source_files, "SRC", src)
    monkeypatch.setattr(source_files, "CONSTANTS", tmp_path / "support" / "constants.py")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.syspath_prepend(src)
    source_files.is_source_folder.cache_clear()
    yield src
    source_files.is_source_folder.cache_clear()


def names_after(file):
    """Run a file as a program does; return its names."""
    module = main_module(file)
    with fresh_modules():
        run_file(module)
    return vars(module)


def test_a_program_runs_as_main_and_its_first_import_does_nothing(src):
    main = sys.modules["__main__"]
    file = src / "go.py"
    file.write_text("import begin_page, begin, sys\nis_main = sys.modules[__name__] is begin\n")
    names = names_after(file)
    assert (names["__name__"], names["__file__"], names["is_main"]) == ("__main__", str(file), True)
    assert sys.modules["__main__"] is main
    assert {"begin", "begin_page"}.isdisjoint(sys.modules)


@pytest.mark.parametrize("name", ["src/mine.py", "mine.py"])
def test_a_run_imports_each_file_of_the_project_as_it_is_now(src, name):
    file = src.parent / name
    go = src / "go.py"
    go.write_text("import mine, json, support\nfound = mine.x\n")
    shared = sys.modules["json"], sys.modules["support"]
    before = {*sys.modules}
    for value in (1, 2):
        file.write_text(f"x = {value}")
        names = names_after(go)
        assert names["found"] == value
        assert (names["json"], names["support"]) == shared
    assert {*sys.modules} == before
    file.unlink()
    with pytest.raises(ImportError):
        names_after(go)


def test_a_run_puts_back_the_modules_that_it_found(src):
    (src / "mine.py").write_text("x = []")
    (src / "go.py").write_text("import mine")
    import mine

    assert names_after(src / "go.py")["mine"] is not mine
    assert sys.modules.pop("mine") is mine


def test_the_text_of_a_file_counts_not_its_stale_pyc(src):
    file = src / "mine.py"
    file.write_text("x = 1")
    py_compile.compile(file)
    times = file.stat()
    file.write_text("x = 2")
    os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))
    (src / "go.py").write_text("from mine import x")
    assert names_after(src / "go.py")["x"] == 2


def test_a_traceback_has_the_lines_that_have_run(src):
    file = src / "go.py"
    file.write_text("\ufeffx = 1  # \u03c9\n", encoding="utf-8")
    names_after(file)
    file.write_text("other\n")
    linecache.checkcache()
    assert linecache.getline(str(file), 1) == "x = 1  # \u03c9\n"


# --- a save --------------------------------------------------------------------------------------


def write(name, text="saved"):
    return lambda root: (root / name).write_text(text)


def remove(name):
    return lambda root: (root / name).unlink()


def touch(root):
    os.utime(root / "src/go.py", (1e9, 1e9))


def keep_time(root):
    file = root / "src/go.py"
    times = file.stat()
    file.write_text("y")
    os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))


GO = "src/go.py"
BACK = write(GO, "x")
STEPS = {  # the number of saves, and the steps, one each 0.4 s
    "a touch": (0, touch),
    "new text with the old time": (1, keep_time),
    "away for a moment": (0, remove(GO), BACK),
    "a formatter saves again": (1, write(GO), write(GO, "tidy")),
    "removed": (1, remove(GO)),
    "a file beside src": (1, write("new.py")),
    "the constants": (1, write("support/constants.py")),
    "a folder with such a name": (0, lambda root: (root / "src/new.py").mkdir()),
}


class Saves:
    """A project with one program, its LiveSource, and a clock that a test moves."""

    def __init__(self, root):
        self.root = root
        self.now = 0.0
        BACK(root)
        self.live = LiveSource(lambda: self.now)

    def wait(self, seconds):
        """Look for as long; return how many saves there were."""
        found = 0
        for _ in range(round(seconds / POLL)):
            self.now += POLL
            found += self.live.changed()
        return found


@pytest.fixture
def saves(src):
    return Saves(src.parent)


@pytest.mark.parametrize("case", STEPS)
def test_only_what_changes_a_file_for_good_is_a_save(saves, case):
    expected, *steps = STEPS[case]
    found = saves.wait(1)
    for step in steps:
        step(saves.root)
        found += saves.wait(0.4)
    assert found + saves.wait(3) == expected
    assert saves.live.has_new_constants() == ("constants" in case)


def test_the_files_are_not_read_in_each_frame(saves):
    saves.wait(POLL)
    saves.live.read = None
    saves.now += POLL / 2
    assert not saves.live.changed()


@pytest.mark.parametrize(
    ("text", "mistake"),
    [
        ("x = 2", ""),
        ("x = sin(\n", "src/go.py, line 1: '(' was never closed"),
    ],
)
def test_a_save_that_cannot_run_says_why(saves, text, mistake):
    """Another file may have a mistake: maybe it is no part of the program."""
    write("notes.py", "(")(saves.root)
    assert saves.wait(1)
    write(GO, text)(saves.root)
    assert saves.wait(1)
    assert saves.live.mistake() == mistake
    BACK(saves.root)
    assert saves.wait(1)
    assert saves.live.mistake() == ""
