"""The CSV: refused files and their messages, accepted files, and writing."""

import errno
import os
import random
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from whole_cradles import GOOD, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src import visualize_cradle_run
from src.beyond.in_browser import show_cradle
from src.pds_helper import extract_and_convert, write_to_csv
from src.special_cradles import make_newton_cradle
from support.constants import COLOR_MAP, NC_FP, R_PARAM, TEXTURE_MAP
from support.files.cradle_csv import LARGEST, Snapshot

COLORS, TEXTURES = f"allowed is one of {', '.join(COLOR_MAP)}", f"allowed is one of {', '.join(TEXTURE_MAP)}"
MASS, E = "allowed is a number from 1e-300 to 1e6 (kg)", "allowed is a number from 0 to 1"


def cell(column, text):
    """Return a CSV with this text in this column of its third line."""
    values = {"mass": "1", "e": "1", "theta": "0", "omega": "0", "color": "red", "texture": "none", column: text}
    return HEADER + GOOD + ",".join(values.values()) + "\n"


# extract_and_convert refuses these files, too. The message comes after the name of the file.
UNREADABLE = {
    "empty": (b"", ": is empty, the first line must name the columns"),
    "two byte-order marks only": ("\ufeff\ufeff", ": is empty, the first line must name the columns"),
    "blank lines only": (b"\n  \n\n", ": is empty, the first line must name the columns"),
    "binary": (b"\x89PNG\r\n\x1a\n\x00\x00", ", line 1: found byte 0x89, allowed is text only, saved as UTF-8"),
    "zero byte": (b"mass,e\n1,\x00\n", ", line 2: found a zero byte, allowed is text only, saved as UTF-8"),
    "latin-1": (
        (HEADER + GOOD).encode() + "1,1,0,0,ros\xe9,none\n".encode("latin-1"),
        ", line 3: found byte 0xe9, allowed is text only, saved as UTF-8",
    ),
    "utf-16": ((HEADER + GOOD).encode("utf-16"), ", line 1: found byte 0xff, allowed is text only, saved as UTF-8"),
    "too many cells": (
        HEADER + GOOD + "1,1,0,0,red,metal,7\n",
        ", line 3: found 7 cells, allowed are at most 6, as in line 1; a comma starts a new cell, also inside a number",
    ),
    "too many cells everywhere": (
        HEADER + "1,1,0,0,red,metal,7\n",
        ", line 2: found 7 cells, allowed are at most 6, as in line 1; a comma starts a new cell, also inside a number",
    ),
    "semicolons and decimal commas": (
        HEADER.replace(",", ";") + "1,0;1,0;0;0;red;metal\n",
        ", line 2: found 3 cells, allowed are at most 1, as in line 1; separate cells with commas, not semicolons",
    ),
    "endless cell": (HEADER + '"' + "x" * 200_000, ", line 2: field larger than field limit (131072)"),
}

NEEDS = "a cradle needs one column of each of mass, e, color, texture"

# Readable files that give no cradle.
NO_CRADLE = {
    "header only": (HEADER, ": names columns but has no pendulum, a cradle needs at least one row below them"),
    "semicolons": (
        (HEADER + GOOD).replace(",", ";"),
        f", line 1, column mass: found 'mass;e;theta;omega;color;texture'; {NEEDS}; "
        "separate cells with commas, not semicolons",
    ),
    "tabs": (
        (HEADER + GOOD).replace(",", "\t"),
        f", line 1, column mass: found 'mass\\te\\ttheta\\tomega\\tcolor\\ttexture'; {NEEDS}; "
        "separate cells with commas, not tabs",
    ),
    "no column e": (
        "mass,theta,omega,color,texture\n1,0,0,red,none\n",
        f", line 1, column e: found 'mass', 'theta', 'omega', 'color', 'texture'; {NEEDS}",
    ),
    "open quotation": (HEADER + '1,1,0,0,"red,metal\n', f", line 2, column color: found 'red,metal', {COLORS}"),
    "line break in a name": (
        '"ma\nss",e,color,texture\n1,1,red,none\n',
        f", line 1, column mass: found 'ma\\nss', 'e', 'color', 'texture'; {NEEDS}",
    ),
    "two columns color": (
        "mass,e,color,color,texture\n1,1,red,blue,none\n",
        f", line 1, column color: found 'mass', 'e', 'color', 'color', 'texture'; {NEEDS}",
    ),
    "mass is text": (cell("mass", "heavy"), f", line 3, column mass: found 'heavy', {MASS}"),
    "mass is empty": (cell("mass", ""), f", line 3, column mass: found nothing, {MASS}"),
    "mass is nan": (cell("mass", "nan"), f", line 3, column mass: found 'nan', {MASS}"),
    "mass is beyond reckoning": (cell("mass", "1e7"), f", line 3, column mass: found '1e7', {MASS}"),
    "mass is infinite": (cell("mass", "inf"), f", line 3, column mass: found 'inf', {MASS}"),
    "mass overflows": (cell("mass", "1e400"), f", line 3, column mass: found '1e400', {MASS}"),
    "mass is zero": (cell("mass", "0"), f", line 3, column mass: found '0', {MASS}"),
    "mass is too small for floats": (cell("mass", "1e-310"), f", line 3, column mass: found '1e-310', {MASS}"),
    "mass is negative": (cell("mass", "-1.5"), f", line 3, column mass: found '-1.5', {MASS}"),
    "mass with a unit": (cell("mass", "1 kg"), f", line 3, column mass: found '1 kg', {MASS}"),
    "mass with underscore": (cell("mass", "1_000"), f", line 3, column mass: found '1_000', {MASS}"),
    "mass in other digits": (cell("mass", "\u0663"), f", line 3, column mass: found '\u0663', {MASS}"),
    "mass is truth": (cell("mass", "True"), f", line 3, column mass: found 'True', {MASS}"),
    "e below 0": (cell("e", "-0.1"), f", line 3, column e: found '-0.1', {E}"),
    "e above 1": (cell("e", "1.01"), f", line 3, column e: found '1.01', {E}"),
    "e is no number": (cell("e", "bouncy"), f", line 3, column e: found 'bouncy', {E}"),
    "e is nan": (cell("e", "nan"), f", line 3, column e: found 'nan', {E}"),
    "e is empty": (cell("e", ""), f", line 3, column e: found nothing, {E}"),
    "color unknown": (cell("color", "mauve"), f", line 3, column color: found 'mauve', {COLORS}"),
    "color is empty": (cell("color", ""), f", line 3, column color: found nothing, {COLORS}"),
    "texture unknown": (cell("texture", "velvet"), f", line 3, column texture: found 'velvet', {TEXTURES}"),
    "row too short": (HEADER + "1,1,0,0,red\n", f", line 2, column texture: found nothing, {TEXTURES}"),
    "too many pendula": (
        HEADER + "\n" + GOOD * 1001,
        ", line 1003: found pendulum 1001, allowed are at most 1000, which already move in slow motion on the page",
    ),
    "a long line": (
        "x" * 1000 + "\n",
        f", line 1, column mass: found '{'x' * 299}...; {NEEDS}",
    ),
    "a long cell": (cell("color", "x" * 1000), f", line 3, column color: found '{'x' * 299}..., {COLORS}"),
    "after blank lines": (
        HEADER + "\n" + GOOD + "   \n\n" + GOOD.replace("red", "rod"),
        f", line 6, column color: found 'rod', {COLORS}",
    ),
    "after a cell of two lines": (
        'note,mass,e,color,texture\n"one\ntwo",1,1,red,none\nx,0,1,red,none\n',
        f", line 4, column mass: found '0', {MASS}",
    ),
}


@pytest.fixture
def save(tmp_path):
    """A function that puts text or bytes into a file and returns the file's path."""

    def save(content):
        file = tmp_path / "cradle.csv"
        file.write_bytes(content.encode() if isinstance(content, str) else content)
        return str(file)

    return save


def complaint(function, *arguments):
    with pytest.raises(ValueError) as caught:
        function(*arguments)
    return str(caught.value)


def the_programs_complaint(monkeypatch, capsys, filepath):
    """Return the message on stderr for this file; the program must end with status 2, and print nothing else."""
    monkeypatch.setattr(sys, "argv", ["visualize_cradle_run.py", filepath])
    monkeypatch.setattr("support.page.page.open_page", lambda *_: pytest.fail("a browser was to be opened"))
    with pytest.raises(SystemExit) as ended:
        show_cradle(visualize_cradle_run.main)
    printed = capsys.readouterr()
    assert (ended.value.code, printed.out) == (2, "")
    return printed.err


def refuse_everywhere(filepath, message, monkeypatch, capsys):
    """Assert that each reader refuses this file, in one line: extract_and_convert, the cradle's maker, the program."""
    assert complaint(extract_and_convert, filepath) == filepath + message
    assert complaint(make_newton_cradle, filepath, R_PARAM, 0) == filepath + message
    assert the_programs_complaint(monkeypatch, capsys, filepath) == filepath + message + "\n"


@pytest.mark.parametrize(("content", "message"), UNREADABLE.values(), ids=UNREADABLE)
def test_unreadable(content, message, save, monkeypatch, capsys):
    refuse_everywhere(save(content), message, monkeypatch, capsys)


@pytest.mark.parametrize(("content", "message"), NO_CRADLE.values(), ids=NO_CRADLE)
def test_no_cradle(content, message, save, monkeypatch, capsys):
    filepath = save(content)
    extract_and_convert(filepath)  # it accepts any CSV
    assert complaint(make_newton_cradle, filepath, R_PARAM, 0) == filepath + message
    assert the_programs_complaint(monkeypatch, capsys, filepath) == filepath + message + "\n"


@pytest.mark.parametrize("name", ["missing.csv", ""], ids=["missing", "folder"])
def test_no_file(name, tmp_path, monkeypatch, capsys):
    filepath = str(tmp_path / name)
    with pytest.raises(OSError) as caught:
        Path(filepath).read_bytes()
    message = f": cannot be read as a CSV file: {caught.value.strerror}"
    refuse_everywhere(filepath, message, monkeypatch, capsys)


NO_FILE = ": cannot be read as a CSV file: found a pipe or a device, allowed is a file"
TOO_LARGE = ": cannot be read as a CSV file: found more than 10 MB, allowed are at most 10 MB"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no such pipes")
def test_a_pipe_is_refused_and_not_waited_for(tmp_path, monkeypatch, capsys):
    filepath = str(tmp_path / "pipe.csv")
    os.mkfifo(filepath)
    refuse_everywhere(filepath, NO_FILE, monkeypatch, capsys)


def test_a_device_is_refused_and_not_read(monkeypatch, capsys):
    """/dev/zero, for instance, never ends."""
    refuse_everywhere("/dev/zero" if os.name == "posix" else os.devnull, NO_FILE, monkeypatch, capsys)


def test_a_large_file_is_refused(tmp_path, monkeypatch, capsys):
    file = tmp_path / "large.csv"
    file.touch()
    os.truncate(file, LARGEST + 1)
    refuse_everywhere(str(file), TOO_LARGE, monkeypatch, capsys)


@pytest.mark.parametrize("beyond", [0, 1])
def test_a_file_whose_size_is_not_known_is_read_up_to_the_limit(beyond, save, monkeypatch):
    """The system says 0 for files that it makes up, and a file may grow while it is read."""
    content = (HEADER + GOOD).ljust(LARGEST + beyond, "\n")
    filepath = save(content)
    made_up = SimpleNamespace(st_mode=os.stat(filepath).st_mode, st_size=0)
    monkeypatch.setattr("support.files.cradle_csv.os", SimpleNamespace(open=os.open, fstat=lambda _: made_up))
    snapshot = Snapshot(filepath)
    assert bool(snapshot.error) == bool(beyond)
    assert snapshot.data == (b"" if beyond else content.encode())


def test_a_row_after_the_last_one_that_is_allowed_is_not_even_read(save):
    """The rows of a file of 10 MB would take a gigabyte."""
    filepath = save(HEADER + GOOD * 1001 + '"' + "x" * 200_000)  # the last cell is longer than a CSV's can be
    assert ", line 1002: found pendulum 1001, " in complaint(make_newton_cradle, filepath, R_PARAM, 0)


def test_a_line_break_in_the_name_of_a_file_is_written_out(tmp_path, monkeypatch, capsys):
    line = rf"{tmp_path / 'two'}\nlines.csv: cannot be read as a CSV file: {os.strerror(errno.ENOENT)}" + "\n"
    assert the_programs_complaint(monkeypatch, capsys, f"{tmp_path / 'two'}\nlines.csv") == line


PADDED = "\n".join("  " + line.replace(",", " ,\t ") + "  " for line in MIXED_CSV.splitlines())
TURNED = "\n".join(",".join(reversed(line.split(","))) for line in MIXED_CSV.splitlines())


@pytest.mark.parametrize(
    "content",
    [
        MIXED_CSV,
        "\ufeff" + MIXED_CSV,
        MIXED_CSV.replace("mass", '\ufeff\ufeff"\ufeffmass"').replace("2.5", "\ufeff2.5"),
        MIXED_CSV.replace("\n", "\r\n"),
        MIXED_CSV.rstrip("\n"),
        MIXED_CSV.replace("\n", "\n\n"),
        PADDED,
        TURNED,
        '"mass","e","theta","omega","color","texture"\n' + MIXED_CSV.partition("\n")[2].replace("red", ' "red" '),
        MIXED_CSV.replace(",", "\u00a0,\u00a0"),
        MIXED_CSV + '""\n\u00a0\n',
    ],
    ids=[
        "plain",
        "mark",
        "marks",
        "windows",
        "no end",
        "blank lines",
        "spaces",
        "order",
        "quotes",
        "hard spaces",
        "blanks",
    ],
)
def test_accepted_silently(content, save):
    filepath = save(content)
    assert extract_and_convert(filepath) == MIXED
    assert [pend["mass"] for pend in make_newton_cradle(filepath, R_PARAM, 0)] == [1.5, 2.5, 0.5]


def test_extra_columns_are_kept(save):
    filepath = save("note,mass,e,color,texture,note ,\nmine,1,1,red,none,too,\n")
    pend_dict = make_newton_cradle(filepath, R_PARAM, 0.5)[0]
    assert (pend_dict["note"], pend_dict["theta"], pend_dict["omega"]) == ("mine", 0.5, 0)


@pytest.mark.parametrize(("column", "text", "value"), [("e", "0", 0), ("e", "1", 1), ("mass", "1e-300", 1e-300)])
def test_what_is_just_allowed(column, text, value, save):
    assert make_newton_cradle(save(cell(column, text)), R_PARAM, 0)[1][column] == value


@pytest.mark.parametrize("count", [1, 1000])
def test_any_number_of_pendula(count, save):
    pend_list = make_newton_cradle(save(HEADER + GOOD * count), R_PARAM, 0.5)
    assert [pend_dict["theta"] for pend_dict in pend_list] == [0.5] + [0] * (count - 1)


def test_what_the_check_takes_for_a_number_is_one_for_pandas(save):
    """The check reads the text of a cell itself. A cell that it accepts must not become text in pend_list."""
    random_text, passed = random.Random(1), 0
    for _ in range(2000):
        text = "".join(random_text.choices("0123456789.eE+-x ", k=random_text.randint(1, 6)))
        filepath = save(f"mass,e,color,texture\n{text},1,red,none\n")
        try:
            mass = make_newton_cradle(filepath, R_PARAM, 0)[0]["mass"]
        except ValueError:
            continue
        passed += 1
        assert isinstance(mass, (int, float)) and mass == float(text), text
    assert passed > 200


# --- write_to_csv ----------------------------------------------------------------------------------------------------


def numbers(count):
    """Return floats of all sizes; a careless reader loses the last bit of some of them."""
    source = random.Random(2)
    return [0.1 + 0.2, 1 / 3, 5e-324, 1.7976931348623157e308, -0.0] + [
        source.uniform(-1, 1) * 10.0 ** source.randint(-30, 30) for _ in range(count)
    ]


def test_reading_back_gives_the_same_to_the_last_bit(tmp_path):
    file = tmp_path / "cradle.csv"
    pend_list = [{**MIXED[0], "theta": theta, "omega": -theta} for theta in numbers(2000)]
    write_to_csv(pend_list, file)
    assert list(map(repr, extract_and_convert(file))) == list(map(repr, pend_list))


def test_objects_are_not_written_and_pend_list_is_left_alone(tmp_path, save):
    pend_list = make_newton_cradle(save(MIXED_CSV), R_PARAM, 0.25)
    before = [dict(pend_dict) for pend_dict in pend_list]
    file = tmp_path / "written.csv"
    write_to_csv(pend_list, file)
    assert pend_list == before
    assert file.read_text() == (
        "mass,e,theta,omega,color,texture\n1.5,0.9,0.25,0,red,metal\n2.5,0.8,0,0,blue,none\n0.5,0.7,0,0,yellow,wood\n"
    )


def test_every_key_is_a_column(tmp_path):
    """Also a key that only some pendula have, and text in any language."""
    file = tmp_path / "cradle.csv"
    write_to_csv([MIXED[0], {**MIXED[1], "note": "schön, \u03c9"}], file)
    first, second = extract_and_convert(file)
    assert second == {**MIXED[1], "note": "schön, \u03c9"}
    assert {name: first[name] for name in MIXED[0]} == MIXED[0]


def test_the_shipped_file_makes_a_cradle():
    assert make_newton_cradle(NC_FP, R_PARAM, 0)


def test_the_file_is_nc_fp_by_default():
    assert write_to_csv.__defaults__ == (NC_FP,)


def test_an_empty_list_leaves_a_header(tmp_path):
    file = tmp_path / "cradle.csv"
    write_to_csv([], file)
    assert file.read_text() == HEADER
    assert extract_and_convert(file) == []


@pytest.mark.parametrize("step", ["write", "fsync", "replace"])
def test_a_failure_leaves_the_old_file_whole(step, tmp_path, monkeypatch):
    file = tmp_path / "cradle.csv"
    file.write_text(MIXED_CSV)

    def fail(*arguments, **keywords):
        raise OSError(28, "No space left on device")

    target = {"write": ("pandas.DataFrame.to_csv",), "fsync": ("os.fsync",), "replace": ("os.replace",)}[step]
    monkeypatch.setattr(*target, fail)
    with pytest.raises(OSError, match=r"cannot be written: No space left on device: '.*cradle\.csv'"):
        write_to_csv(MIXED * 2, file)
    assert file.read_text() == MIXED_CSV
    assert os.listdir(tmp_path) == ["cradle.csv"]


def test_a_half_written_file_is_never_seen(tmp_path, monkeypatch):
    """The name stands for the old file until the new one is complete."""
    file = tmp_path / "cradle.csv"
    file.write_text(MIXED_CSV)
    seen = []
    monkeypatch.setattr("os.fsync", lambda descriptor: seen.append(file.read_text()))
    write_to_csv(MIXED[:1], file)
    assert seen == [MIXED_CSV]
    assert extract_and_convert(file) == MIXED[:1]


@pytest.mark.skipif(os.name != "posix", reason="links and permissions as on Linux and macOS")
def test_permissions_and_links_stay(tmp_path):
    file, link = tmp_path / "cradle.csv", tmp_path / "link.csv"
    file.write_text(MIXED_CSV)
    file.chmod(0o640)
    link.symlink_to(file)
    write_to_csv(MIXED[:1], link)
    assert link.is_symlink()
    assert extract_and_convert(file) == MIXED[:1]
    assert file.stat().st_mode & 0o777 == 0o640


def test_only_a_file_is_replaced(tmp_path):
    """Not a folder, and not a device such as /dev/full."""
    with pytest.raises(OSError, match="cannot be written: it is not a file, or is write-protected"):
        write_to_csv(MIXED, tmp_path)
    for name in (os.devnull, os.path.abspath(os.sep)):
        with pytest.raises(OSError, match="cannot be written: it is not a file, or is write-protected"):
            write_to_csv(MIXED, name)


def test_a_write_protected_file_is_not_replaced(tmp_path, monkeypatch):
    file = tmp_path / "cradle.csv"
    file.write_text(MIXED_CSV)
    monkeypatch.setattr("os.access", lambda path, mode: False)  # for example, the administrator may still write it
    with pytest.raises(OSError, match="write-protected"):
        write_to_csv(MIXED[:1], file)
    assert file.read_text() == MIXED_CSV


def test_a_file_that_cannot_even_be_begun(tmp_path, monkeypatch):
    """On a read-only disk, opening for writing fails, and deleting too; the message names the first error."""

    def fail(*arguments, **keywords):
        raise OSError(30, "Read-only file system")

    monkeypatch.setattr("builtins.open", fail)
    monkeypatch.setattr("pathlib.Path.unlink", fail)
    with pytest.raises(OSError, match=r"cannot be written: Read-only file system: '.*cradle\.csv'"):
        write_to_csv(MIXED, tmp_path / "cradle.csv")


def test_a_missing_folder_is_named(tmp_path):
    with pytest.raises(OSError, match=r"cannot be written: No such file or directory: '.*gone[/\\]+cradle\.csv'"):
        write_to_csv(MIXED, tmp_path / "gone" / "cradle.csv")
