"""Files: CSVs, read or refused, edited and written; each is written whole or not at all; the
recorded data.
"""

import errno
import os
import random
import re
from contextlib import suppress
from pathlib import Path
from unittest.mock import Mock, patch

import pytest
from programs import on_posix, ROOT, running
from students import put_files
from vpython import color, textures, vector
from whole_cradles import FIVE_CSV, GOOD, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import extract_and_convert, write_to_csv
from src.special_cradles import make_newton_cradle
from support.constants import COLOR_MAP, NC_FP, R_PARAM, TEXTURE_MAP
from support.files.cradle_csv import (
    clean_copy,
    LARGEST,
    LiveFile,
    POLL,
    Snapshot,
)
from support.files.data_file import require_replaceable, whole_file
from support.files.valid_cradle import require_cradle
from support.page.chooser import with_numbers

ALLOWED = {
    "mass": "allowed is a number from 1e-300 to 1e6 (kg), such as 1.5",
    "e": "allowed is a number from 0 to 1, such as 0.9",
    "color": f"allowed is one of {', '.join(COLOR_MAP)}",
    "texture": f"allowed is one of {', '.join(TEXTURE_MAP)}",
}
PLAIN = "; separate cells with plain commas (,)"
NEEDS = "a cradle needs one column of each of mass, e, color, texture"

# Files that are no CSV, or give no cradle. The message comes after the name of the file.
REFUSED = {
    "blank": ("\ufeff\ufeff\n  \n\n", ": is empty, the first line must name the columns"),
    "zero byte": (
        b"mass,e\n1,\x00\n",
        ", line 2: found a zero byte, allowed is text only, saved as UTF-8",
    ),
    "latin-1": (
        b"mass\n1\nros\xe9\n",
        ", line 3: found byte 0xe9, allowed is text only, saved as UTF-8",
    ),
    "endless cell": (
        HEADER + '"' + "x" * 200_000,
        ", line 2: field larger than field limit (131072)",
    ),
    "large": (
        " " * (LARGEST + 1),
        ": cannot be read: found more than 10 MB, allowed are at most 10 MB",
    ),
    "too many cells": (  # below a column without a name
        "color,texture,mass,e,\nred,metal,1,0,9\n",
        ", line 2: found 5 cells, allowed are at most 4, as in line 1; a comma starts a new cell, also inside a number",
    ),
    "a separator in line 3": (
        HEADER + GOOD + "sep=,,,,,\n",
        f", line 3, column mass: found 'sep=', {ALLOWED['mass']}",
    ),
    "header only": (
        HEADER,
        ": names columns but has no pendulum, a cradle needs at least one row below them",
    ),
    "two columns mass": (
        "mass,mass\n",
        f", line 1: found 2 columns mass in 'mass', 'mass'; {NEEDS}",
    ),
    "no column": (
        "mass,E,color,texture\n",
        f", line 1: found no column e in 'mass', 'E', 'color', 'texture'; {NEEDS}",
    ),
    **{  # the line, what is found in it, and a hint
        kind: (content, f", line {line} must name the columns: found {found}; {NEEDS}{hint}")
        for kind, (content, line, found, hint) in {
            "tabs": ("mass\te\n", 1, "'mass\\te'", "; separate cells with commas, not tabs"),
            "a decimal comma": (
                "sep=;\ne;mass\n1;1,0",
                2,
                "'e;mass'",
                "; separate cells with commas, not semicolons",
            ),
            "quotes": (
                '"mass, e"\n"1,1"\n',
                1,
                "'mass, e'",
                "; take away the quotes around each line",
            ),
            "a title": (f"Cradle; e, 1,,,\n{HEADER}{GOOD}", 1, "'Cradle; e', '1'", ""),
            "names in quotes": (
                '"Mass";"E"\n',
                1,
                """'Mass;"E"'""",
                "; separate cells with commas, not semicolons",
            ),
            "full-width commas": ("mass\uff0ce\n", 1, "'mass\uff0ce'", PLAIN),
            "a long line": ("x" * 1000 + "\n", 1, f"'{'x' * 299}...", ""),
        }.items()
    },
    "a workbook": (
        b"PK\3\4\xff",
        ": is a workbook; open it in Excel or the like, and save it as CSV",
    ),
    "an old workbook": (
        b"\xd0\xcf\x11\xe0",
        ": is a workbook; open it in Excel or the like, and save it as CSV",
    ),
    "row too short": (
        HEADER + "1,1,0,0,red\n",
        f", line 2, column texture: found nothing, {ALLOWED['texture']}; this line has 5 cells, not 6",
    ),
    "an Arabic comma": (
        HEADER + "1\u060c1,0,0,red,metal\n",
        f", line 2, column mass: found '1\u060c1', {ALLOWED['mass']}; this line has 5 cells, not 6{PLAIN}",
    ),
    # The row after them, with a cell that is too long for a CSV, is not even read
    "too many pendula": (
        HEADER + "\n" + GOOD * 1001 + '"' + "x" * 200_000,
        ", line 1003: found pendulum 1001, allowed are at most 1000, which already move in slow motion on the page",
    ),
    "after blank lines and a cell of two lines": (
        'note,mass,e,color,texture\n   \n\n"one\ntwo",1,1,red,none\nx,0,1,red,none\n',
        f", line 6, column mass: found '0', {ALLOWED['mass']}",
    ),
}


def cell(column, text):
    """Return a CSV with this text in this column of its third line."""
    values = {
        "mass": "1",
        "e": "1",
        "theta": "0",
        "omega": "0",
        "color": "red",
        "texture": "none",
        column: text,
    }
    return HEADER + GOOD + ",".join(values.values()) + "\n"


for column, text in [
    *(("mass", text) for text in ("heavy", "nan", "1e7", "0", "1e-310", "1_000", "\u0663")),
    *(("e", "-0.1"), ("e", "1.01"), ("e", "nan"), ("color", "mauve"), ("texture", "velvet")),
]:
    words = f", line 3, column {column}: found {text!r}, {ALLOWED[column]}"
    REFUSED[f"{column} {text}"] = (cell(column, text), words)


@pytest.fixture
def save(tmp_path):
    """A function that puts text or bytes into a file and returns the file's path."""
    return lambda content: str(put_files(tmp_path, {"cradle.csv": content}) / "cradle.csv")


@pytest.mark.parametrize("mistake", REFUSED)
def test_a_csv_is_refused_with_the_place_of_its_mistake(mistake, save):
    content, message = REFUSED[mistake]
    filepath = save(content)
    with pytest.raises(ValueError, match=f"^{re.escape(filepath + message)}$"):
        require_cradle(Snapshot(filepath))


@on_posix
def test_a_missing_file_a_folder_a_pipe_and_a_device_are_refused_at_once(tmp_path):
    """A pipe may have no writer, and /dev/zero never ends."""
    os.mkfifo(pipe := tmp_path / "pipe.csv")
    found = "found a pipe or a device, allowed is a file"
    reasons = {tmp_path / "missing.csv": "No such file or directory", pipe: found}
    for file, reason in {**reasons, Path("/dev/zero"): found}.items():
        with pytest.raises(ValueError, match=f"^{re.escape(str(file))}: cannot be read: {reason}$"):
            Snapshot(file).text()


@pytest.mark.parametrize("system", ["win32", "linux"])
def test_windows_denies_the_permission_for_a_folder_and_for_a_file_that_excel_holds_open(
    system, csv, monkeypatch
):
    """It says the same of both."""
    monkeypatch.setattr("sys.platform", system)
    monkeypatch.setattr(
        "os.open", Mock(side_effect=PermissionError(errno.EACCES, "Permission denied"))
    )
    held = "Permission denied" + "; another program may have it open" * (system == "win32")
    for file, reason in {csv: held, csv.parent: "found a folder, allowed is a file"}.items():
        with pytest.raises(ValueError, match=f"^{re.escape(str(file))}: cannot be read: {reason}$"):
            Snapshot(file).text()


READABLE = {
    "marks": MIXED_CSV.replace("mass", '\ufeff\ufeff"\ufeffmass"').replace("2.5", "\ufeff2.5"),
    "windows": MIXED_CSV.replace("\n", "\r\n\r\n") + "\x1a",
    "spaces": "\n".join(
        "  " + line.replace(",", " ,\t ") + "  " for line in MIXED_CSV.splitlines()
    ),
    "order": "\n".join(",".join(reversed(line.split(","))) for line in MIXED_CSV.splitlines()),
    "quotes": MIXED_CSV.replace("red", ' "red" '),
    "a spreadsheet": "Sep=,\n" + MIXED_CSV.replace("\n", ",,\n,,,,,,,,\n"),
    "hard spaces": MIXED_CSV.replace(",", "\u00a0,\u00a0") + '""\n\u00a0\n',
}


@pytest.mark.parametrize("content", READABLE.values(), ids=READABLE)
def test_a_csv_is_read_however_a_program_has_written_it_and_also_when_it_is_gone(content, save):
    """A plain pd.read_csv reads its clean copy, whose path is a plain one."""
    snapshot = Snapshot(save(content))
    os.remove(snapshot.filepath)
    with clean_copy(snapshot) as copy:
        assert (type(copy), Path(copy).name) == (str, "cradle.csv")
        assert extract_and_convert(copy) == MIXED
        assert [pend["mass"] for pend in make_newton_cradle(copy, R_PARAM, 0)] == [1.5, 2.5, 0.5]
    assert not Path(copy).exists()


def test_the_smallest_and_the_largest_cradle_are_allowed(save):
    for content in (
        HEADER + GOOD,
        HEADER + GOOD * 1000,
        cell("e", "0"),
        cell("e", "1"),
        cell("mass", "1e-300"),
    ):
        require_cradle(Snapshot(save(content)))


def test_a_number_for_the_check_is_a_number_for_pandas(save):
    """The check reads the text of a cell itself.

    A cell that it accepts must not become text in pend_list.
    """
    source, accepted = random.Random(1), []
    for _ in range(800):
        text = "".join(source.choices("0123456789.eE+-x ", k=source.randint(1, 6)))
        with suppress(ValueError):
            require_cradle(
                Snapshot("cradle.csv", f"mass,e,color,texture\n{text},1,red,none\n".encode())
            )
            accepted.append(text)
    assert len(accepted) > 80
    for text in accepted:  # each in a file of its own: a column has one type
        with clean_copy(Snapshot("cradle.csv", f"mass\n{text}\n".encode())) as copy:
            [pend_dict] = extract_and_convert(copy)
        assert isinstance(pend_dict["mass"], (int, float)) and pend_dict["mass"] == float(text), (
            text
        )


def test_the_copy_of_a_long_number_has_only_digits_that_pandas_2_reads():
    data = b"id,mass,e\n00000000000000001,0.00000000000000000000012345,0.02000000000000000045\n"
    with clean_copy(Snapshot("cradle.csv", data)) as copy:
        assert Path(copy).read_text().split() == ["id,mass,e", "00000000000000001,1.2345e-22,2e-2"]


def test_the_maps_have_all_names_of_vpython_and_none_for_a_plain_bob():
    """test_headless_vpython.py compares the colors of the stand-in with those of VPython."""
    for namespace, names in ((color, COLOR_MAP), (textures, TEXTURE_MAP)):
        public = {name: value for name, value in vars(namespace).items() if name[0] != "_"}
        values = {
            name: getattr(namespace, name)
            for name, value in public.items()
            if isinstance(value, (str, vector))
        }
        assert {**values, **({"none": None} if namespace is textures else {})} == names


def test_an_edit_leaves_the_other_cells_and_the_file_as_they_are(save):
    text = 'note,mass , e\n"a, b",1.50,1\nshort,2\n'
    original = Snapshot(save(text))
    edited = with_numbers(original, {"mass": [1.5, 0.1 + 0.2], "e": [1]})
    rows = [["note", "mass", "e"], ["a, b", "1.50", "1"], ["short", "0.30000000000000004"]]
    assert (str(edited), [cells for _, cells in edited.rows]) == (str(original), rows)
    assert Path(original.filepath).read_text() == text


def test_write_to_csv_keeps_each_number_to_the_last_bit(tmp_path):
    source, file = random.Random(2), tmp_path / "cradle.csv"
    numbers = [0.1 + 0.2, 1 / 3, 5e-324, 1.7976931348623157e308, -0.0]
    numbers += [source.uniform(-1, 1) * 10.0 ** source.randint(-30, 30) for _ in range(2000)]
    pend_list = [{**MIXED[0], "theta": theta, "omega": -theta} for theta in numbers]
    write_to_csv(pend_list, file)
    written = [
        (float(theta), float(omega)) for _, (_, _, theta, omega, *_) in Snapshot(file).rows[1:]
    ]
    assert list(map(repr, written)) == [repr((theta, -theta)) for theta in numbers]


def test_write_to_csv_makes_a_column_of_each_key_but_objects_and_leaves_pend_list_alone(
    tmp_path, save
):
    """Also of a key that only some pendula have, and with text in any language."""
    pend_list, file = make_newton_cradle(save(MIXED_CSV), R_PARAM, 0.25), tmp_path / "written.csv"
    pend_list[1]["note"] = "schön, \u03c9"
    before = [dict(pend_dict) for pend_dict in pend_list]
    write_to_csv(pend_list, file)
    assert pend_list == before
    assert file.read_text(encoding="utf-8").splitlines() == [
        *("mass,e,theta,omega,color,texture,note", "1.5,0.9,0.25,0,red,metal,"),
        *('2.5,0.8,0,0,blue,none,"schön, \u03c9"', "0.5,0.7,0,0,yellow,wood,"),
    ]


def test_write_to_csv_writes_a_header_for_an_empty_list_and_by_default_the_shipped_file(tmp_path):
    write_to_csv([], file := tmp_path / "cradle.csv")
    assert (file.read_text(), extract_and_convert(file)) == (HEADER, [])
    assert (write_to_csv.__defaults__, os.path.isabs(NC_FP)) == ((NC_FP,), True)  # from any folder
    assert make_newton_cradle(NC_FP, R_PARAM, 0)


# --- whole files -----------------------------------------------------------------------------------------------------


def contents(folder):
    """Return the text of each file in this folder, by its name."""
    return {path.name: path.read_text() for path in folder.iterdir()}


@pytest.mark.parametrize(
    "step", ["pandas.DataFrame.to_csv", "os.fsync", "shutil.copymode", "os.replace"]
)
def test_a_full_disk_leaves_the_old_file_and_nothing_else(step, csv, monkeypatch):
    monkeypatch.setattr(step, Mock(side_effect=OSError(errno.ENOSPC, "No space left on device")))
    with pytest.raises(
        OSError, match=r"cannot be written: No space left on device: '.*cradle\.csv'"
    ) as caught:
        write_to_csv(MIXED * 2, csv)
    assert (caught.value.errno, caught.value.filename) == (errno.ENOSPC, str(csv))
    assert contents(csv.parent) == {"cradle.csv": FIVE_CSV}


HALF = """
import sys, time
from support.files.data_file import whole_file
with whole_file(sys.argv[1]) as file:
    file.write("half \\u03c9")
    file.flush()
    print("half", flush=True)
    time.sleep(1000)
"""


@on_posix
def test_a_killed_program_leaves_the_old_file_and_a_hidden_part_that_git_does_not_see(csv):
    """The part is UTF-8, also if the locale is another one, and a program that writes later does
    not need its name.
    """
    c_locale = {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}
    with running("-c", HALF, csv, folder=ROOT, **c_locale) as process:
        assert process.stdout.readline() == "half\n"
    [part] = {*os.listdir(csv.parent)} - {"cradle.csv"}
    assert re.fullmatch(r"\.cradle\.csv\.\w+\.tmp", part)
    assert ".*.tmp" in (ROOT / ".gitignore").read_text().split()
    assert (csv.parent / part).read_bytes() == "half \u03c9".encode()
    assert csv.read_text() == FIVE_CSV
    write_to_csv(MIXED[:1], csv)
    assert extract_and_convert(csv) == MIXED[:1]


def test_the_name_stays_with_the_old_file_until_the_new_one_is_complete_and_on_the_disk(
    csv, monkeypatch
):
    seen = []
    monkeypatch.setattr(
        "os.fsync", lambda number: seen.append((csv.read_text(), os.fstat(number).st_size))
    )
    with pytest.raises(ZeroDivisionError), whole_file(csv) as new:
        new.write("half")
        raise ZeroDivisionError
    assert (seen, contents(csv.parent)) == ([], {"cradle.csv": FIVE_CSV})
    with whole_file(csv) as new:
        new.write("new")
    assert (seen, contents(csv.parent)) == ([(FIVE_CSV, 3)], {"cradle.csv": "new"})


@on_posix
def test_permissions_and_links_stay_and_a_new_file_has_the_usual_permissions(csv):
    link, other, usual = (csv.with_name(name) for name in ("link.csv", "other.csv", "usual"))
    usual.touch()
    csv.chmod(0o640)
    link.symlink_to(csv)
    for path in (link, other):
        write_to_csv(MIXED[:1], path)
        assert extract_and_convert(path) == MIXED[:1]
    assert (link.is_symlink(), csv.stat().st_mode & 0o777, other.stat().st_mode) == (
        True,
        0o640,
        usual.stat().st_mode,
    )


def test_only_a_file_that_may_be_written_is_replaced_and_the_message_has_the_given_name(
    csv, monkeypatch
):
    """Not a folder, a device such as /dev/full, or a protected file, which the administrator could
    still replace.
    """
    monkeypatch.chdir(csv.parent)
    words = "cannot be written: it is not a file, or is write-protected"
    for path in (csv.parent, os.devnull, os.path.abspath(os.sep)):
        with pytest.raises(PermissionError, match=words):
            write_to_csv(MIXED, path)
    with pytest.raises(
        FileNotFoundError, match="cannot be written: No such file or directory: 'gone/cradle.csv'$"
    ):
        write_to_csv(MIXED, "gone/cradle.csv")
    monkeypatch.setattr("os.access", lambda path, mode: False)
    with pytest.raises(PermissionError, match=words):
        write_to_csv(MIXED[:1], csv)
    assert contents(csv.parent) == {"cradle.csv": FIVE_CSV}


def test_a_saved_file_is_noticed_once_when_two_looks_find_the_same_also_if_it_goes_and_comes_back(
    csv,
):
    """While it is gone or empty, the page says so."""
    csv.write_text("old\n")
    times = [0.0]
    live_file = LiveFile(csv, lambda: times[-1])

    def look(seconds=POLL * 1.01):
        times.append(times[-1] + seconds)
        return live_file.changed()

    before = csv.stat()
    csv.write_text("ne")  # the editor is still at work
    assert not look()
    csv.write_text("new\n")
    # Size and time do not show the change
    os.utime(csv, ns=(before.st_atime_ns, before.st_mtime_ns))
    # The program does not read the file in each frame
    assert [look(), look(0), look(0)] == [False] * 3
    assert [look() for _ in range(3)] == [True, False, False]
    assert live_file.current.rows == [(1, ["new"])]
    assert 2 * POLL < 1  # s
    for change, words in ((csv.unlink, "No such file or directory$"), (csv.touch, "is empty")):
        change()
        assert [look(), look(), look()] == [False, True, False]
        with pytest.raises(ValueError, match=words):
            require_cradle(live_file.current)
    csv.write_text("new\n")
    assert [look(), look(), look()] == [False, True, False]
    assert live_file.current.rows == [(1, ["new"])]
    # The program, or the machine, can open no more files
    for number in (errno.EMFILE, errno.ENFILE):
        with patch(
            "support.files.cradle_csv.read_file", side_effect=OSError(number, os.strerror(number))
        ):
            assert not (look() or look() or look())
    assert not (look() or look())


def test_data_can_replace_only_data(tmp_path, monkeypatch):
    file = tmp_path / "data.csv"
    require_replaceable(file)
    for text in ("", "t,theta_1,momentum\n0.0,1.0,2.0\n"):
        file.write_text(text)
        require_replaceable(file)
    for text in (MIXED_CSV, "t,theta_1,mine\n", "t,mine,momentum\n"):
        file.write_text(text)
        with pytest.raises(
            ValueError, match=f"^--record: found '{re.escape(str(file))}', which has no data"
        ):
            require_replaceable(file)
    opened = Mock(side_effect=PermissionError(errno.EACCES, "Permission denied"))
    monkeypatch.setattr("builtins.open", opened)
    with pytest.raises(ValueError, match="^--record: .*: Permission denied(; another|$)"):
        require_replaceable(file)
    # Excel lets other programs read its file, but not write it
    opened.assert_called_once_with(file, "r+b")
