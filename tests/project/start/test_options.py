"""The command line: options that are accepted, options and constants that are refused."""

import sys
from math import inf

import pytest
from programs import call
from whole_cradles import FIVE_CSV

from support import constants
from support.constants import DT, NC_FP
from support.pendulum import outwards_to_angle
from support.start import options

PROGRAMS = {
    "page": options.read_page_options,
    "double": options.read_double_page_options,
    "text": options.read_text_options,
}


@pytest.fixture
def read(monkeypatch):
    """A function that returns the options of a program for this command line."""

    def read(program, line):
        monkeypatch.setattr(sys, "argv", ["program.py", *line.split()])
        return vars(PROGRAMS[program]())

    return read


@pytest.mark.parametrize(
    ("program", "line", "expected"),
    [
        ("page", "", {"csv": NC_FP, "host": "127.0.0.1", "port": 0, "browser": True}),
        ("text", "", {"csv": NC_FP, "seconds": inf, "every": 0.01}),
        ("page", "my.csv --mass 1e-3 --lift 3", {"csv": "my.csv", "mass": 0.001, "lift": 3}),
        ("page", "--e 0 --angle 180", {"e": 0, "angle": outwards_to_angle(180)}),
        ("double", "--phi=-180 --no-browser", {"phi": outwards_to_angle(-180), "browser": False}),
        ("text", "--seconds 1e6 --every 1e6 --record -", {"seconds": 1e6, "every": 1e6}),
    ],
)
def test_options_are_read_with_their_units(read, program, line, expected):
    found = read(program, line)
    assert found == found | expected


def test_the_port_and_the_browser_may_be_in_vpythons_environment_variables(read, monkeypatch):
    for text, port in {"": 0, "8000": 8000}.items():
        monkeypatch.setenv(options.PORT_VARIABLE, text)
        assert read("page", "")["port"] == port
    for text, opens in {"0": True, "1": False}.items():
        monkeypatch.setenv("VPYTHON_NO_LAUNCH_BROWSER", text)
        found = read("page", "--port 9000")
        assert (found["port"], found["browser"]) == (9000, opens)


TICK = "(s, with this R_PARAM and G)"


@pytest.mark.parametrize(
    ("values", "allowed"),
    [
        ({"DT": 0}, f"from 1e-06 to 0.001 {TICK}"),
        ({"R_PARAM": 0.05, "G": 100, "DT": 0.00056}, f"from 1e-06 to 0.000559 {TICK}"),
        ({"R_PARAM": 10**400}, "from 0.05 to 100 (m)"),
        ({"G": -9.81}, "from 0.1 to 100 (m/s^2)"),
        ({"THETA_INIT": -45}, "from -3.1416 to 0 (rad)"),
        ({"PHI_INIT": None}, "from -3.1416 to 3.1416 (rad)"),
    ],
)
def test_a_constant_with_which_no_cradle_works_is_refused(
    read, monkeypatch, capsys, values, allowed
):
    """The last one of these. A tick may not be long beside a swing."""
    for name, value in values.items():
        monkeypatch.setattr(constants, name, value)
    line = f"support/constants.py, {name}: found {value!r}, allowed is a number {allowed}\n"
    assert call(lambda: read("text", ""), capsys) == (2, "", line)


@pytest.mark.parametrize(
    ("program", "option", "values", "allowed"),
    [
        ("page", "--e", ["1.1", "nan"], "a number from 0 to 1"),
        ("page", "--mass", ["0", "1kg"], "a number from 0.001 to 1000 (kg)"),
        ("page", "--angle", ["-30"], "a number from 0 to 180 (degrees)"),
        ("page", "--lift", ["-1", "1.5", "9" * 400], "a whole number from 0 to 1000"),
        ("page", "--port", ["65536"], "a whole number from 0 to 65535"),
        ("double", "--phi", ["181"], "a number from -180 to 180 (degrees)"),
        ("text", "--seconds", ["0", "inf"], f"a number from {DT:g} to 1e+06 (s)"),
    ],
)
def test_a_bad_value_is_named_with_its_option_and_the_allowed_ones(
    read, capsys, program, option, values, allowed
):
    for value in values:
        status, _, line = call(lambda value=value: read(program, f"{option}={value}"), capsys)
        assert status == 2
        assert f": error: argument {option}: found {value!r}"[:300] in line
        assert f", allowed is {allowed} (--help shows all options)\n" in line


@pytest.mark.parametrize(
    ("program", "line", "beginning"),
    [
        ("page", "--elastic --e 0.5", "argument --e: not allowed with argument --elastic"),
        ("page", "--elast", "unrecognized arguments: --elast"),
        (
            "double",
            "--experiment a --phi=0",
            "argument --experiment: not allowed with argument --phi",
        ),
        (
            "page",
            "--html-all a --elastic",
            "argument --html-all: not allowed with argument --elastic",
        ),
        ("text", "--record data.csv", "argument --record: needs --seconds"),
        ("page", "--seconds 5", "argument --seconds: needs --html"),
        ("text", "--every 0.1 --seconds 5", "argument --every: needs --record"),
        # Letters that a terminal does not show
        ("text", "my.csv \x1b[2J\udcffω", r"unrecognized arguments: \x1b[2J\udcffω"),
    ],
)
def test_options_that_do_not_go_together_or_are_none_are_refused_in_one_line(
    read, capsys, program, line, beginning
):
    status, stdout, stderr = call(lambda: read(program, line), capsys)
    assert (status, stdout, stderr.count("\n")) == (2, "", 1)
    assert stderr.startswith(f"program.py: error: {beginning}")


@pytest.mark.parametrize(("program", "option"), [("text", "record"), ("page", "html")])
def test_what_is_written_replaces_no_cradle(read, capsys, tmp_path, monkeypatch, program, option):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "data.csv").write_text("t,theta_1\n0,0\n")
    (tmp_path / "my.csv").write_text(FIVE_CSV)
    assert read(program, f"--seconds 1 --{option} data.csv")[option] == "data.csv"
    status, _, line = call(lambda: read(program, f"--seconds 1 --{option} my.csv"), capsys)
    assert status == 2
    assert f"argument --{option}: found 'my.csv', allowed is a new file, or one to replace" in line
