"""The command line: options that are accepted, options and constants that are refused."""

from math import degrees, inf

import pytest
from programs import call

from support import constants
from support.constants import DT, NC_FP, PHI_INIT, THETA_INIT
from support.pendulum import outwards_to_angle
from support.start import options

CRADLE = {
    "csv": NC_FP,
    "elastic": False,
    "inelastic": False,
    "e": None,
    "mass": None,
    "angle": None,
    "lift": None,
    "experiment": None,
}
PAGE = {
    **CRADLE,
    "ghosts": None,
    "port": 0,
    "host": "127.0.0.1",
    "browser": True,
    "html": None,
    "html_all": None,
    "seconds": 10,
}
DOUBLE = {**PAGE, "phi": None}
TEXT = {**CRADLE, "seconds": inf, "record": None, "every": 0.01}
PROGRAMS = {
    "page": options.read_page_options,
    "double": options.read_double_page_options,
    "text": options.read_text_options,
}


@pytest.mark.parametrize(
    ("program", "line", "expected"),
    [
        ("page", "", PAGE),
        ("double", "", DOUBLE),
        ("text", "", TEXT),
        ("page", "my.csv --inelastic", {"csv": "my.csv", "inelastic": True}),
        ("page", "--elastic --mass 1e-300 --lift 3", {"elastic": True, "mass": 1e-300, "lift": 3}),
        (
            "page",
            "--e 0 --lift 0 --angle 180",
            {"e": 0, "lift": 0, "angle": outwards_to_angle(180)},
        ),
        ("page", "--e 1 --mass 1e6 --angle 0", {"e": 1, "mass": 1e6, "angle": 0}),
        ("page", "--port 65535 --host ::", {"port": 65535, "host": "::"}),
        ("page", "--no-browser", {"browser": False}),
        ("page", "--html a.html --seconds 600", {"html": "a.html", "seconds": 600}),
        ("double", "--angle 77 --phi=180", {"angle": outwards_to_angle(77)}),
        ("double", "--phi=-180", {"phi": outwards_to_angle(-180)}),
        ("text", "--seconds 1e6 --every 1e6 --record -", {"seconds": 1e6, "every": 1e6}),
        ("text", f"--seconds 1 --record a.csv --every {DT}", {"record": "a.csv", "every": DT}),
    ],
)
def test_options_are_read_with_their_units(program, line, expected):
    found = vars(PROGRAMS[program](line.split()))
    assert {name: found[name] for name in expected} == expected
    assert line or found == expected


def test_the_port_and_the_browser_may_be_in_vpythons_environment_variables(monkeypatch, capsys):
    for text, port in {"": 0, "8000": 8000}.items():
        monkeypatch.setenv(options.PORT_VARIABLE, text)
        assert options.read_page_options([]).port == port
    monkeypatch.setenv(options.PORT_VARIABLE, "web")
    assert refusal("page", [], capsys).startswith("argument --port: found 'web', allowed is ")
    assert options.read_page_options(["--port", "9000"]).port == 9000
    for text, opens in {"0": True, "1": False}.items():
        monkeypatch.setenv("VPYTHON_NO_LAUNCH_BROWSER", text)
        assert options.read_page_options(["--port", "9000"]).browser == opens


def check_refused_constant(read_options, name, ending, capsys):
    """Check that a program refuses this constant in a line with this ending."""
    status, _, line = call(lambda: read_options([]), capsys)
    assert status == 2
    assert line.startswith(f"support/constants.py, {name}: found {getattr(constants, name)!r}, ")
    assert line.endswith(ending)


@pytest.mark.parametrize(
    ("name", "values", "allowed"),
    [
        ("DT", [0, 1, "0.0001", float("nan")], "from 1e-06 to 0.001 (s, with this R_PARAM and G)"),
        ("DOUBLE_DT", [0], "from 1e-06 to 0.001 (s, with this R_PARAM and G)"),
        ("R_PARAM", [0, -0.2, 10**400], "from 0.05 to 100 (m)"),
        ("G", [-9.81], "from 0.1 to 100 (m/s^2)"),
        ("THETA_INIT", [-45, 0.1], "from -3.1416 to 0 (rad)"),
        ("PHI_INIT", [None], "from -3.1416 to 3.1416 (rad)"),
    ],
)
def test_a_constant_with_which_no_cradle_works_is_refused_by_each_program_in_one_line(
    name, values, allowed, monkeypatch, capsys
):
    for value in values:
        monkeypatch.setattr(constants, name, value)
        for read_options in PROGRAMS.values():
            check_refused_constant(read_options, name, f" {allowed}\n", capsys)


@pytest.mark.parametrize("name", ["DT", "DOUBLE_DT"])
def test_a_tick_that_is_long_beside_a_swing_is_refused(name, monkeypatch, capsys):
    monkeypatch.setattr(constants, "R_PARAM", 0.05)
    monkeypatch.setattr(constants, "G", 100)
    monkeypatch.setattr(constants, name, 0.00056)
    check_refused_constant(
        options.read_text_options, name, " to 0.000559 (s, with this R_PARAM and G)\n", capsys
    )
    monkeypatch.setattr(constants, name, 0.000559)
    assert options.read_text_options([]).record is None


def test_help_has_the_default_of_an_option(capsys):
    with pytest.raises(SystemExit, match="^0$"):
        options.read_double_page_options(["--help"])
    printed = " ".join(capsys.readouterr().out.split())
    assert f"from 0 to 180 degrees (default: {abs(degrees(THETA_INIT)):g})" in printed
    assert f"from -180 to 180 degrees (default: {abs(degrees(PHI_INIT)):g})" in printed


def refusal(program, words, capsys):
    """Return the one line on stderr with which a program refuses these words, after its name."""
    status, stdout, stderr = call(lambda: PROGRAMS[program](words), capsys)
    assert (status, stdout, stderr.count("\n")) == (2, "", 1)
    return stderr.partition(": error: ")[2]


@pytest.mark.parametrize(
    ("program", "option", "values", "allowed"),
    [
        ("page", "--e", ["1.1", "-0.1", "nan", "0,9"], "from 0 to 1"),
        ("page", "--mass", ["0", "inf", "1kg"], "from 1e-300 to 1e+06 (kg)"),
        ("page", "--angle", ["-30", "181"], "from 0 to 180 (degrees)"),
        ("page", "--lift", ["-1", "1.5", "²", "9" * 5000], "from 0 to 1000"),
        ("page", "--port", ["65536", "web", "nan"], "from 0 to 65535"),
        ("double", "--phi", ["181", "-180.5", "right"], "from -180 to 180 (degrees)"),
        ("text", "--seconds", ["0", "inf"], f"from {DT:g} to 1e+06 (s)"),
        ("text", "--every", [str(DT / 2), "1e7"], f"from {DT:g} to 1e+06 (s)"),
    ],
)
def test_a_bad_value_is_named_with_its_option_and_the_allowed_ones(
    program, option, values, allowed, capsys
):
    for value in values:
        message = refusal(program, [f"{option}={value}"], capsys)
        assert message.startswith(f"argument {option}: found {value!r}"[:300])
        assert allowed in message


@pytest.mark.parametrize(
    ("program", "line", "beginning"),
    [
        ("page", "--elastic --e 0.5", "argument --e: not allowed with argument --elastic"),
        ("page", "--elast", "unrecognized arguments: --elast"),
        ("text", "--no-browser", "unrecognized arguments: --no-browser"),
        ("text", "--record=", "argument --record: expected one argument"),
        ("page", "--html-all=", "argument --html-all: expected one argument"),
        ("text", "--angle=--", "argument --angle: "),  # in Python 3.11, it is a list
        (
            "page",
            "--experiment a.txt --e 0",
            "argument --experiment: not allowed with argument --e",
        ),
        (
            "double",
            "--experiment a --phi=0",
            "argument --experiment: not allowed with argument --phi",
        ),
        ("page", "--html-all f --e 0", "argument --html-all: not allowed with argument --e"),
        (
            "page",
            "--html-all f --experiment a",
            "argument --html-all: not allowed with argument --experiment",
        ),
        ("text", "--record data.csv", "argument --record: needs --seconds"),
        ("page", "--seconds 5", "argument --seconds: needs --html"),
        ("text", "--every 0.1 --seconds 5", "argument --every: needs --record"),
        # Letters that a terminal does not show
        ("text", "my.csv \x1b[2J\udcffω", r"unrecognized arguments: \x1b[2J\udcffω"),
    ],
)
def test_options_that_do_not_go_together_or_are_none_are_refused(program, line, beginning, capsys):
    assert refusal(program, line.split(), capsys).startswith(beginning)
