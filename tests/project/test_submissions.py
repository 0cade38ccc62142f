"""Submissions of a class: the forms in which they are read, and a key for each student."""

import os
import stat
import zipfile
from io import BytesIO

import pytest
from programs import on_posix
from students import put_files

from grading.assignment import FUNCTIONS
from teacher.keys import keys_of, Student
from teacher.submissions import read_submission, submissions_in

SOLUTION = {function.file: f"{name} = 1\n" for name, function in FUNCTIONS.items()}
READ = {file: text.encode() for file, text in SOLUTION.items()}
SWINGING = "src/swinging.py"
NOT_WRITTEN = b"full_swing_update is not written yet"
STARTER = {
    **dict.fromkeys(SOLUTION, NOT_WRITTEN),
    "newton_cradle_pends.csv": b"",
    "support/constants.py": b"",
    "support/pendulum.py": b"",
    "pyproject.toml": b"",
}


def below(folder, files):
    return {f"{folder}/{name}": text for name, text in files.items()}


def renamed(before, after, files):
    return {name.replace(before, after): text for name, text in files.items()}


def zip_of(files) -> bytes:
    """Return a .zip with these files; a name may be a ZipInfo."""
    whole = BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return whole.getvalue()


def read_zip(folder, data):
    """Read a submission that is a .zip with this content."""
    (folder / "a.zip").write_bytes(data)
    return read_submission([("", folder / "a.zip")], STARTER)


PROJECT = {
    **SOLUTION,
    "src/helpers/angles.py": "",
    "src/notes.txt": "n",
    "src/__pycache__/x.py": "x",
    "README.md": "text",
    "support/swinging.py": "mine",
    "tests/swinging.py": "mine",
    ".venv/lib/swinging.py": "x",
}
MAC = {**below("cradle", PROJECT), **below("__MACOSX/cradle", SOLUTION)}
TWO_SWINGS = {**renamed("swinging", "my_swinging", SOLUTION), "src/swinging_old.py": "o"}
# What files ask for is graded, except what belongs to the starter
ASKS = {
    **SOLUTION,
    SWINGING: "full_swing_update = helpers, 'my data.csv', support, constants, pendulum",
    "helpers/__init__.py": "from .angles import *; import tests.mine",
    "helpers/angles.py": "",
    "src/my data.csv": "",
    "support/constants.py": "NC_FP = 'newton_cradle_pends.csv'",
    "newton_cradle_pends.csv": "mine",
    "conftest.py": "",
}
LEFT = {"pyproject.toml": "mine", "support/pendulum.py": "mine", "tests/mine.py": "mine"}
NEWER = ["src/swinging (3).py", "src/swinging-12.py", "src/swinging-3 (1).py"]
# The files of a submission, those that are read, and how the messages about it begin
FORMS = {
    "a project of macOS": (MAC, {**READ, "src/helpers/angles.py": b""}, []),
    "what files ask for": (
        {**ASKS, **LEFT, "notes.csv": "", "tests/test_mine.py": ""},
        {file: text.encode() for file, text in ASKS.items()},
        [
            "left out pyproject.toml, which pytest asks for: it is not the starter's",
            f"left out support/pendulum.py, which {SWINGING} asks for: it is not the starter's",
            "left out tests/mine.py, which helpers/__init__.py asks for: it is not the starter's",
        ],
    ),
    "files without folders": (
        {**renamed("src/", "", SOLUTION), "constants.py": "NC_FP = 'a.csv'", "a.csv": ""},
        {
            **READ,
            **dict.fromkeys(["src/constants.py", "support/constants.py"], b"NC_FP = 'a.csv'"),
            **dict.fromkeys(["src/a.csv", "a.csv"], b""),
        },
        [],
    ),
    "a program beside a missing file": (
        renamed("src/double_cradle", "src/visualize_double_cradle_run", SOLUTION),
        renamed("src/double_cradle", "src/visualize_double_cradle_run", READ),
        [],
    ),
    "two projects": (
        {**below("new", SOLUTION), "old/src/swinging.py": "old"},
        READ,
        ["took new/src, left old/src"],
    ),
    "two candidates": (
        TWO_SWINGS,
        {**renamed("swinging", "my_swinging", READ), "src/swinging_old.py": b"o"},
        [f"{SWINGING} is missing, found src/my_swinging.py, found src/swinging_old.py"],
    ),
    "a file again and again": (
        {**SOLUTION, **dict.fromkeys(NEWER, "2"), SWINGING: "1", NEWER[1]: SOLUTION[SWINGING]},
        READ,
        [f"took {NEWER[1]} as swinging.py, left src/swinging.py, {NEWER[0]}, {NEWER[2]}"],
    ),
    "a long path": (
        {**SOLUTION, f"src/{'a/' * 120}long.py": ""},
        READ,
        [f"left out {'/a' * 21}/long.py: allowed is a path of at most 250 letters"],
    ),
    "nothing": ({}, {}, ["none of the assignment's files is there"]),
    "much": (
        {**SOLUTION, "src/big.py": "#" * 1_000_000},
        READ,
        ["left out src/big.py: allowed are at most 200 files with 1,000,000 bytes"],
    ),
    "many": (
        {**SOLUTION, **{f"src/a{i:03}.py": "" for i in range(196)}},
        {**READ, **{f"src/a{i:03}.py": b"" for i in range(195)}},
        ["left out src/a195.py: allowed are at most 200 files with 1,000,000 bytes"],
    ),
}
for name in ("Swinging.PY", "Copy of swinging.py"):
    FORMS[name] = (
        renamed("swinging.py", name, SOLUTION),
        {**READ, f"src/{name}": READ[SWINGING]},
        [f"took src/{name} as swinging.py"],
    )
for name in (".swinging.py.icloud (not downloaded yet)", "._swinging.py"):
    FORMS[name] = (
        renamed("swinging.py", name.partition(" ")[0], SOLUTION),
        {file: content for file, content in READ.items() if file != SWINGING},
        [f"{SWINGING} is missing, found src/{name}"],
    )
for problem, content in {
    "is empty": b"",
    "is empty ": b"\xef\xbb\xbf\n \n",
    "has none of its functions, and begins with '# full_swing_update'": b"# full_swing_update\n",
    "is as in the starter": NOT_WRITTEN,
}.items():
    FORMS[problem] = (
        {**SOLUTION, SWINGING: content},
        {**READ, SWINGING: content},
        [f"{SWINGING} {problem.strip()}"],
    )


@pytest.mark.parametrize(("files", "found", "beginnings"), FORMS.values(), ids=FORMS)
@pytest.mark.parametrize("is_packed", [False, True])
@pytest.mark.parametrize("place", ["ann", "ann.zip"])
def test_the_files_of_src_are_found_and_problems_named(
    tmp_path, files, found, beginnings, is_packed, place
):
    """is_packed: they are in a .zip, in a folder or in another .zip."""
    if is_packed:
        files = {"cradle.zip": zip_of(files)}
    if place == "ann":
        (tmp_path / "ann").mkdir()
        put_files(tmp_path / "ann", files)
    else:
        (tmp_path / "ann.zip").write_bytes(zip_of(files))
    read, messages = read_submission([("", tmp_path / place)], STARTER)
    assert read == found
    for message, beginning in zip(sorted(messages), beginnings, strict=True):
        assert message.replace("cradle.zip/", "").startswith(beginning)


def test_an_odd_entry_of_a_zip_is_named_and_the_rest_is_taken(tmp_path):
    link = zipfile.ZipInfo("src/link.py")
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    bzip2 = zipfile.ZipInfo("src/bzip2.py")
    bzip2.compress_type = zipfile.ZIP_BZIP2
    odd = {
        "C:/src/swinging.py": "x",
        "/src/swinging.py": "x",
        "src/../../swinging.py": "x",
        "..\\src\\swinging.py": "x",
        "src/large.py": "x" * 20_000_001,
        link: "x",
        bzip2: "x",
    }
    files, problems = read_zip(tmp_path, zip_of({**SOLUTION, **odd}))
    assert files == READ
    for entry, problem in zip(odd, problems, strict=True):
        name = getattr(entry, "filename", entry)
        # As zipfile reads it on Windows
        assert problem.startswith(f"left out {name.replace(os.sep, '/')}: allowed is no link")


def test_an_encrypted_and_a_damaged_entry_are_named_and_the_rest_is_taken(tmp_path):
    data = bytearray(zip_of(SOLUTION))
    content = data.find(b"src/swinging.py") + len("src/swinging.py")
    data[content] ^= 0xFF
    flags = data.rfind(b"src/pds_helper.py") - 38
    data[flags] |= 1  # encrypted
    files, problems = read_zip(tmp_path, data)
    assert files.keys() == READ.keys() - {SWINGING, "src/pds_helper.py"}
    encrypted, missing, damaged, *_ = problems
    assert encrypted.startswith("left out src/pds_helper.py: allowed is no link, no password")
    assert missing == "src/pds_helper.py is missing"
    assert damaged.startswith("left out src/swinging.py: ")


def test_problems_are_few_and_short(tmp_path):
    files = {f"/{'a' * 300}{i}\x1b.py": "" for i in range(99)}
    _, problems = read_zip(tmp_path, zip_of(files))
    assert len(problems) == 9
    assert problems[-1] == "and more"
    assert max(map(len, problems)) <= 203
    assert "".join(problems).isprintable()


@on_posix
def test_pipes_and_links_are_not_read(tmp_path):
    """A link could lead to another student's files."""
    put_files(tmp_path, {"secret.py": "secret", "class/ann/src/pds_helper.py": "a"})
    src = tmp_path / "class" / "ann" / "src"
    (src / "swinging.py").symlink_to(tmp_path / "secret.py")
    (src / "folder").symlink_to(tmp_path)
    os.mkfifo(src / "special_cradles.py")
    (tmp_path / "class" / "link").symlink_to(src)
    submissions, others = submissions_in(tmp_path / "class")
    assert others == ["link"]
    files, problems = read_submission(submissions["ann"], STARTER)
    assert [*files] == ["src/pds_helper.py"]
    for name in ("special_cradles.py", "swinging.py"):
        assert f"left out src/{name}: it is a link, a pipe or a device" in problems


# What is in the folder, and the student's key and the own name of the file: "" is a folder or an
# archive
CLASS = {
    "Bea B/a.py": ("Bea B", ""),
    "a\x7fb/c\x85d/e\x85f": ("a\\x7fb", ""),
    "O'Brien \u00dc (2).ZIP": ("O'Brien \u00dc (2)", ""),
    "dan.rar": ("dan", ""),
    "lab_1_2_x/a.py": ("lab_1_2_x", ""),
    "li_1_5_swinging.py": ("li_1", "swinging.py"),
    "li_1_6_pds_helper-1.py": ("li_1", "pds_helper-1.py"),
    "li_2_7_swinging.py": ("li_2", "swinging.py"),
    "eve_LATE_3_8_a.zip": ("eve", "a.zip"),
    "li_1_9_4_8_swinging.py": ("li_1_9", "swinging.py"),  # a student calls herself li_1_9
    "Fay F_9_assignsubmission_file_swinging.py": ("Fay F", "swinging.py"),
    "Fay F_9_assignsubmission_onlinetext_/onlinetext.html": ("Fay F", ""),
    "Gus_7_assignsubmission_file/swinging.py": ("Gus", ""),
    "14-345 - Jo - Nov 25, 2026 114 PM - swinging.py": ("Jo_14", "swinging.py"),
    "14-345 - Jo - Nov 25, 2026 1114 AM - swinging.py": ("Jo_14", "swinging.py"),
    "15-345 - Jo - 25. November 2026 1314 - swinging.py": ("Jo_15", "swinging.py"),
    "Kim - swinging.py": ("Kim", "swinging.py"),
}


def test_each_folder_each_archive_and_each_name_of_a_flat_download_is_a_student(tmp_path):
    """Letters of a name that cannot be printed are spelled out."""
    names = [*CLASS, ".git/a", "__MACOSX/a", "index.html"]
    put_files(tmp_path, {name: name for name in names})
    submissions, others = submissions_in(tmp_path)
    found = []
    for key, paths in submissions.items():
        found += [(path.name, (key, file)) for file, path in paths]
    assert {*found} == {(path.partition("/")[0], owner) for path, owner in CLASS.items()}
    assert others == ["index.html"]
    _, problems = read_submission(submissions["dan"], STARTER)
    assert problems[0] == "dan.rar is no .zip that can be read: File is not a zip file"
    _, (problem,) = read_submission(submissions["a\\x7fb"], STARTER)
    assert problem.endswith(r", found c\x85d/e\x85f")
    files, _ = read_submission(submissions["li_1"], STARTER)
    assert [*files] == ["src/pds_helper.py", SWINGING]
    files, problems = read_submission(submissions["Jo_14"], STARTER)
    assert files[SWINGING].decode().startswith("14-345 - Jo - Nov 25, 2026 114")
    assert "took the newest upload of swinging.py" in problems


@pytest.mark.parametrize("files", [{}, PROJECT, READ], ids=["nothing", "project", "src"])
def test_a_folder_that_is_no_class_is_refused(tmp_path, files):
    put_files(tmp_path, files)
    with pytest.raises(ValueError, match="allowed is a folder with a folder or a .zip for each"):
        submissions_in(tmp_path)


@pytest.mark.parametrize(
    "names",
    [
        ["ann", "Ann", "ANN"],
        ["\ud800", "\udc80", "\n"],
    ],
)
def test_a_students_key_is_apart_from_all_others(tmp_path, names):
    students = {Student(name, name) for name in names}
    # Others call themselves like the keys
    students |= {Student(key, key) for key in keys_of(students).values()}
    keys = keys_of(students).values()
    assert len({key.upper() for key in keys}) == len(students)
    for key in keys:
        (tmp_path / f"{key}.txt").write_text("")
        assert key.isprintable()
