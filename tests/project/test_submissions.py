"""The forms in which course systems hand out what students have submitted."""

import os
import zipfile

import pytest

from grading.handout import FUNCTIONS
from teacher.submissions import MOST_BYTES, MOST_FILES, read_submission, submissions_in

SOLUTION = {function.file: f"# {function.file}\n" for function in FUNCTIONS.values()}
READ = {file.removeprefix("src/"): text.encode() for file, text in SOLUTION.items()}


def put(folder, files):
    """Write files into a folder, by their paths; return the folder."""
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(text.encode() if isinstance(text, str) else text)
    return folder


def pack(file, files):
    """Write files into a .zip; return its path."""
    with zipfile.ZipFile(file, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return file


def below(folder, files=SOLUTION):
    """Return files as they are one level deeper."""
    return {f"{folder}/{name}": text for name, text in files.items()}


PROJECT = {
    **SOLUTION,
    "README.md": "text",
    "tests/test_d.py": "mine",
    "support/swinging.py": "mine",
    ".venv/lib/swinging.py": "x",
}
MAC = {**below("cradle", PROJECT), **{f"__MACOSX/{name}": "mac" for name in below("cradle")}}
FORMS = {
    "a project": PROJECT,
    "src only": SOLUTION,
    "one level too deep": below("my cradle", PROJECT),
    "two levels too deep": below("a/b", PROJECT),
    "of macOS": MAC,
    "the files of src": READ,
    "tests with the handout's names": {**SOLUTION, **{f"tests/{name}": "mine" for name in READ}},
}


@pytest.mark.parametrize("files", FORMS.values(), ids=FORMS)
@pytest.mark.parametrize("is_zip", [False, True], ids=["folder", "zip"])
def test_the_files_of_src_are_found(tmp_path, files, is_zip):
    path = pack(tmp_path / "ann.zip", files) if is_zip else put(tmp_path / "ann", files)
    assert read_submission("ann", path) == ("ann", READ, [])


def test_a_zip_in_the_students_folder(tmp_path):
    (tmp_path / "Ann Lee_12_file").mkdir()
    pack(tmp_path / "Ann Lee_12_file" / "cradle.zip", MAC)
    assert read_submission("ann", tmp_path / "Ann Lee_12_file").files == READ


def test_more_files_of_the_student_and_nothing_but_python(tmp_path):
    more = {"src/helpers/angles.py": "a", "src/__init__.py": "", "src/notes.txt": "n", "src/__pycache__/x.py": "x"}
    read = read_submission("ann", put(tmp_path / "ann", {**SOLUTION, **more}))
    assert read == ("ann", {**READ, "helpers/angles.py": b"a", "__init__.py": b""}, [])


def test_what_is_missing_is_told(tmp_path):
    files = {name: text for name, text in SOLUTION.items() if name != "src/swinging.py"}
    read = read_submission("ann", put(tmp_path / "ann", {**files, "src/Swinging (1).py": "a"}))
    assert read.problems == ["src/swinging.py is missing, found 'Swinging (1).py'"]


def test_of_two_projects_the_complete_one_is_taken_and_the_other_told(tmp_path):
    two = {**below("new"), "old/src/swinging.py": "old"}
    assert read_submission("ann", put(tmp_path / "ann", two)) == ("ann", READ, ["took new/src, left old/src"])


OTHERS = {
    "nothing": ({}, "none of the handout's files is there; found: nothing"),
    "something else": (
        {"essay.docx": "a", "b.txt": "b"},
        "none of the handout's files is there; found: b.txt, essay.docx",
    ),
    "much": ({**SOLUTION, "src/big.py": "#" * MOST_BYTES}, "too large: found 6 Python files, allowed are at most"),
    "many": ({**SOLUTION, **{f"src/a{i}.py": "" for i in range(MOST_FILES)}}, "too large: found 205 Python files"),
}


@pytest.mark.parametrize("name", OTHERS)
@pytest.mark.parametrize("is_zip", [False, True], ids=["folder", "zip"])
def test_what_is_no_solution_is_told(tmp_path, name, is_zip):
    files, words = OTHERS[name]
    folder = put(tmp_path / "ann", files)
    folder.mkdir(exist_ok=True)
    path = pack(tmp_path / "ann.zip", dict(sorted(files.items()))) if is_zip else folder
    read = read_submission("ann", path)
    assert read.files == {}
    assert read.problems[0].startswith(words)


def test_no_zip(tmp_path):
    (tmp_path / "ann.zip").write_bytes(b"Rar!")
    assert read_submission("ann", tmp_path / "ann.zip").problems == [
        "ann.zip is no .zip that can be read: File is not a zip file"
    ]


def test_a_damaged_zip(tmp_path):
    """The names can be read, but not the content."""
    with zipfile.ZipFile(tmp_path / "ann.zip", "w", zipfile.ZIP_LZMA) as archive:
        archive.writestr("src/swinging.py", "angle = 1\n" * 100)
    data = (tmp_path / "ann.zip").read_bytes()
    (tmp_path / "ann.zip").write_bytes(data[:60] + b"damaged" + data[67:])
    assert read_submission("ann", tmp_path / "ann.zip").problems[0].startswith("ann.zip is no .zip that can be read: ")


def test_a_zip_that_would_fill_the_memory_is_read_up_to_the_limit(tmp_path):
    with zipfile.ZipFile(tmp_path / "ann.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("src/swinging.py", bytes(200_000_000))
    assert (tmp_path / "ann.zip").stat().st_size < 1_000_000
    assert "too large" in read_submission("ann", tmp_path / "ann.zip").problems[0]


@pytest.mark.parametrize(
    "name", ["../src/swinging.py", "src/../../swinging.py", "..\\src\\swinging.py", "C:/swinging.py"]
)
def test_a_path_of_a_zip_that_leads_outside_is_left(tmp_path, name):
    assert read_submission("ann", pack(tmp_path / "ann.zip", {name: "x", **SOLUTION})) == ("ann", READ, [])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with names")
def test_pipes_and_links_are_not_read(tmp_path):
    """A link could lead to another student's files."""
    (tmp_path / "secret.py").write_text("secret")
    folder = put(tmp_path / "ann", {"src/pds_helper.py": "a"})
    (folder / "src" / "swinging.py").symlink_to(tmp_path / "secret.py")
    (folder / "src" / "folder").symlink_to(tmp_path)
    os.mkfifo(folder / "src" / "special_cradles.py")
    read = read_submission("ann", folder)
    assert read.files == {"pds_helper.py": b"a"}
    assert "src/special_cradles.py is missing" in read.problems
    assert "src/swinging.py is missing" in read.problems


def test_each_folder_and_each_archive_is_a_student(tmp_path):
    for name in ("ann", "Bea B", ".git", "__MACOSX"):
        (tmp_path / name).mkdir()
    for name in ("ann.zip", "cem.ZIP", "dan.rar", "index.html"):
        (tmp_path / name).write_text("")
    found, others = submissions_in(tmp_path)
    assert {student: path.name for student, path in found.items()} == {
        "Bea B": "Bea B",
        "ann": "ann",
        "ann.zip": "ann.zip",
        "cem": "cem.ZIP",
        "dan": "dan.rar",
    }
    assert others == ["index.html"]
    assert read_submission("dan", found["dan"]).problems[0].startswith("dan.rar is no .zip")


def test_names_that_cannot_be_printed(tmp_path):
    (tmp_path / "a\nb").mkdir()
    (tmp_path / "a\tb" / "c\nd").mkdir(parents=True)
    (tmp_path / "a\tb" / "c\nd" / "e\nf").write_text("")
    found, _ = submissions_in(tmp_path)
    assert {student: path.name for student, path in found.items()} == {"a?b": "a\tb", "a?b_": "a\nb"}
    problems = read_submission("a?b", found["a?b"]).problems
    assert problems == ["none of the handout's files is there; found: c?d/e?f"]


@pytest.mark.parametrize("files", [{}, {"index.html": "a"}, PROJECT, READ], ids=["nothing", "a file", "project", "src"])
def test_what_is_no_class_is_refused(tmp_path, files):
    with pytest.raises(ValueError, match="allowed is a folder with a folder or a .zip for each student"):
        submissions_in(put(tmp_path, files))
