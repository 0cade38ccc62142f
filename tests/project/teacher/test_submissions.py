"""The rule that finds the files of a submission: what each student has handed in, what counts."""

import stat
import tarfile
import zipfile
from io import BytesIO

import pytest
from programs import on_posix
from students import put_files

from grading.assignment import FUNCTIONS
from teacher.submissions import choose, pack, submissions_in, unpack

SRC = {function.file: f"{name} = 1\n" for name, function in FUNCTIONS.items()}
READ = {file: text.encode() for file, text in SRC.items()}
SWINGING = "src/swinging.py"


def renamed(before, after, files=SRC):
    return {name.replace(before, after): content for name, content in files.items()}


def below(folder, files=SRC):
    return {folder + name: content for name, content in files.items()}


def zip_of(files) -> bytes:
    """Return a .zip with these files; a name may be a ZipInfo."""
    whole = BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return whole.getvalue()


def tar_of(files) -> bytes:
    """Return a .tar.gz with these files."""
    whole = BytesIO()
    with tarfile.open(fileobj=whole, mode="w:gz") as archive:
        for name, content in files.items():
            info = tarfile.TarInfo(name)
            info.size = len(content)
            archive.addfile(info, BytesIO(content.encode()))
    return whole.getvalue()


def found_in(folder):
    """Return the files and the problems of each student, as host and container find them."""
    found = {}
    for student, paths in submissions_in(folder)[0].items():
        stream = BytesIO()
        pack(paths, stream)
        stream.seek(0)
        problems = []
        found[student] = choose(unpack(stream, problems), problems), problems
    return found


FLAT = renamed("src/", "")
MAC = {**below("cradle/"), "cradle/src/._swinging.py": "x", "__MACOSX/src/swinging.py": "x"}
# A class, and the student who has handed all in
FORMS = {
    "a folder": (below("Bea B\u00e9/my cradle/"), "Bea B\u00e9"),
    "without src": (below("2026_11_301_ann/", FLAT), "2026_11_301_ann"),
    "a .zip of macOS": ({"O'Brien.ZIP": zip_of(MAC)}, "O'Brien"),
    "a .zip of Windows": ({"lab_3_1_li.zip": zip_of(renamed("/", "\\"))}, "lab_3_1_li"),
    "a .tar.gz": ({"cy.tar.gz": tar_of(below("./"))}, "cy"),
    "Canvas": (below("li_LATE_12_345_", FLAT), "li_12"),
    "Canvas, a .zip": ({"li_12_345_my_1_222_cradle.zip": zip_of(SRC)}, "li_12"),
    "Moodle": (below("Fay F_9_assignsubmission_file_", FLAT), "Fay F_9"),
    "Moodle, a .zip": ({"Fay F_9_assignsubmission_file/a.zip": zip_of(SRC)}, "Fay F_9"),
}


@pytest.mark.parametrize(("files", "student"), FORMS.values(), ids=FORMS)
def test_each_form_of_a_submission_is_found(tmp_path, files, student):
    put_files(tmp_path, {**files, "notes.txt": "", ".git/a": "", "__MACOSX/a.py": ""})
    assert found_in(tmp_path) == {student: (READ, [])}
    assert submissions_in(tmp_path)[1] == ["notes.txt"]


def test_files_of_two_students_are_kept_apart(tmp_path):
    """A student calls a file as if it were another one's."""
    names = "li_1_555_B_2_assignsubmission_file_x.py", "A_1_assignsubmission_file_li_2_777_x.py"
    put_files(tmp_path, dict.fromkeys(names, ""))
    assert submissions_in(tmp_path)[0].keys() == {"li_1", "A_1"}


AGAIN = {"src/swinging-3.py": "3", "src/swinging (12).py": "12", SWINGING: "0"}
OWN = {"src/my/a.py": "", "src/constants.py": "G = 1"}
DOUBLE = "visualize_double_cradle_run.py"
OF_STARTER = {"support/pendulum.py": "x", "tests/test_a.py": "x", ".venv/swinging.py": "x"}
CONSTANTS = {"src/constants.py": "NC_FP = 1"}
OLD = zipfile.ZipInfo("swinging.py")  # of 1980
LINK = zipfile.ZipInfo("link.py")
LINK.external_attr = (stat.S_IFLNK | 0o777) << 16
# The files of a submission, those that are found beside or in place of READ, and the problems
RULE = {
    "what is one's own": ({**OWN, **OF_STARTER, "src/pendulum.py": "x", "notes.txt": ""}, OWN, []),
    "in another folder": ({f"a/{DOUBLE}": "", "a/b.py": ""}, {f"src/{DOUBLE}": ""}, []),
    "constants": (CONSTANTS, {**CONSTANTS, "support/constants.py": "NC_FP = 1"}, []),
    "a file again": (
        AGAIN,
        {SWINGING: "12"},
        [
            f"took src/swinging-3.py for {SWINGING}, left {SWINGING}",
            f"took src/swinging (12).py for {SWINGING}, left src/swinging-3.py",
        ],
    ),
    "an older file": (
        {"a.zip": zip_of({OLD: "old"})},
        {},
        [f"took {SWINGING} for {SWINGING}, left a.zip/swinging.py"],
    ),
    "the same twice": ({"old/swinging.py": SRC[SWINGING]}, {}, []),
    "an archive that is none": ({"a.rar": "x"}, {}, ["a.rar cannot be read: "]),
    "an archive in one": ({"a.zip": zip_of({"b.zip": zip_of({SWINGING: ""})})}, {}, []),
    "odd files": (
        {"a.zip": zip_of({"../a.py": "", LINK: "/", "large.py": "#" * 1_000_001})},
        {},
        [
            "left out a.zip/../a.py: it is outside of the folder",
            "left out a.zip/link.py: it is a link or a device",
            "left out a.zip/large.py: it has more than 1,000,000 bytes",
        ],
    ),
    "too much": (
        {"a.zip": zip_of({f"{i}.py": "#" * 1_000_000 for i in range(21)})},
        {},
        ["a.zip cannot be read: its Python files have more than 20,000,000 bytes"],
    ),
}


@pytest.mark.parametrize(("files", "more", "problems"), RULE.values(), ids=RULE)
def test_a_file_counts_by_its_name_and_problems_are_named(tmp_path, files, more, problems):
    put_files(tmp_path, below("ann/", {**SRC, **files}))
    found, named = found_in(tmp_path)["ann"]
    assert found == {**READ, **{name: text.encode() for name, text in more.items()}}
    for beginning, problem in zip(problems, named, strict=True):
        assert problem.startswith(beginning)


@on_posix
def test_links_lead_to_nobody_elses_files(tmp_path):
    src = (
        put_files(tmp_path, {"secret.py": "x", "class/ann/src/swinging.py": "a"}) / "class" / "ann"
    )
    (src / "link.py").symlink_to(tmp_path / "secret.py")
    (tmp_path / "class" / "bea").symlink_to(src)
    assert submissions_in(tmp_path / "class")[1] == ["bea"]
    files, problems = found_in(tmp_path / "class")["ann"]
    assert [*files] == [SWINGING]
    assert "left out link.py: it is a link or a device" in problems
    assert "src/pds_helper.py is missing" in problems
