"""The command line: accepted options, refused options, and the commands that the page and the
messages show.
"""

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
}
PAGE = {**CRADLE, "port": 0, "host": "127.0.0.1", "browser": True}
PROGRAMS = {
    "page": (options.read_page_options, PAGE),
    "double": (options.read_double_page_options, {**PAGE, "phi": None}),
    "text": (options.read_text_options, {**CRADLE, "seconds": inf, "record": None, "every": 0.01}),
}


@pytest.mark.parametrize(
    ("program", "line", "changed"),
    [
        *((program, "", {}) for program in PROGRAMS),
        ("page", "my.csv --inelastic", {"csv": "my.csv", "inelastic": True}),
        ("page", "--elastic --mass 1e-05 --lift 3", {"elastic": True, "mass": 1e-5, "lift": 3}),
        (
            "page",
            "--e 0 --lift 0 --angle 180",
            {"e": 0.0, "lift": 0, "angle": outwards_to_angle(180)},
        ),
        (
            "page",
            "--e 0.30000000000000004 --angle 33.3",
            {"e": 0.1 + 0.2, "angle": outwards_to_angle(33.3)},
        ),
        (
            "page",
            "--port 65535 --host :: --no-browser",
            {"port": 65535, "host": "::", "browser": False},
        ),
        ("double", "--phi=-180", {"phi": outwards_to_angle(-180)}),
        (
            "double",
            "--angle 77 --phi=-1e-05",
            {"angle": outwards_to_angle(77), "phi": outwards_to_angle(-1e-5)},
        ),
        ("text", "--seconds 1e6 --mass 2 my.csv", {"seconds": 1e6, "mass": 2.0, "csv": "my.csv"}),
        (
            "text",
            f"--seconds 1 --record data.csv --every {DT}",
            {"seconds": 1.0, "record": "data.csv", "every": DT},
        ),
    ],
)
def test_options_are_read_with_their_units(program, line, changed):
    read_options, defaults = PROGRAMS[program]
    assert vars(read_options(line.split())) == {**defaults, **changed}


def test_the_port_may_be_in_vpythons_environment_variable(monkeypatch, capsys):
    for text, port in {"": 0, "8000": 8000}.items():
        monkeypatch.setenv(options.PORT_VARIABLE, text)
        assert options.read_page_options([]).port == port
    for text in ("9" * 5000, "web"):
        monkeypatch.setenv(options.PORT_VARIABLE, text)
        assert f"found '{text}' in VPYTHON_HTTP_PORT, allowed is" in refusal("page", [], capsys)
    assert options.read_page_options(["--port", "9000"]).port == 9000


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        *(("DT", value, "from 1e-06 to 0.001 (s)") for value in (0, 1, "0.0001", float("nan"))),
        *(("R_PARAM", value, "from 0.05 to 100 (m)") for value in (0, -0.2, True, 10**400)),
        ("DOUBLE_DT", 0, "from 1e-06 to 0.001 (s)"),
        ("G", -9.81, "from 0.1 to 100 (m/s^2)"),
        *(("THETA_INIT", value, "from -3.1416 to 0 (rad)") for value in (-45, 0.1)),
        ("PHI_INIT", None, "from -3.1416 to 3.1416 (rad)"),
    ],
)
def test_a_constant_with_which_no_cradle_works_is_refused_in_one_line(
    name, value, allowed, monkeypatch, capsys
):
    for module in (constants, options):  # options has some of them, too
        monkeypatch.setattr(module, name, value, raising=False)
    line = f"support/constants.py, {name}: found {value!r}, allowed is a number {allowed}\n"
    for read_options, _ in PROGRAMS.values():
        assert call(lambda read=read_options: read([]), capsys) == (2, "", line)


def test_a_tick_that_is_long_beside_a_swing_is_refused(monkeypatch, capsys):
    monkeypatch.setattr(constants, "R_PARAM", 0.05)
    monkeypatch.setattr(constants, "G", 100)
    monkeypatch.setattr(constants, "DT", 0.001)
    line = "support/constants.py, DT: found 0.001, allowed with this R_PARAM and G is a number up to 0.000559 (s)\n"
    assert call(lambda: options.read_text_options([]), capsys) == (2, "", line)
    monkeypatch.setattr(constants, "DT", 0.000559)
    assert options.read_text_options([]).record is None


def test_help_has_each_option_with_its_unit_and_default(capsys):
    for program, words in {
        "page": f"from 0 to 180 degrees (default: {abs(degrees(THETA_INIT)):g})",
        "double": f"outwards, from -180 to 180 degrees (default: {abs(degrees(PHI_INIT)):g})",
        "text": "--every S with --record: a row for every S seconds (default: 0.01)",
    }.items():
        with pytest.raises(SystemExit, match="^0$"):
            PROGRAMS[program][0](["--help"])
        assert words in " ".join(capsys.readouterr().out.split())


def refusal(program, words, capsys):
    """Return the one line on stderr with which a program refuses these words, after its name."""
    status, stdout, stderr = call(lambda: PROGRAMS[program][0](words), capsys)
    assert (status, stdout, stderr.count("\n")) == (2, "", 1)
    return stderr.partition(": error: ")[2].removesuffix(" (--help shows all options)\n")


EVERY = f"a multiple of {DT:g} (s), one tick, up to 1e6"
BAD = [  # a program, an option, its bad values, and what is allowed
    ("page", "--e", ["1.1", "-0.1", "nan", "0,9"], "a number from 0 to 1, such as 0.9"),
    ("page", "--mass", ["0", "inf", "1kg"], "a number from 1e-300 to 1e6 (kg), such as 1.5"),
    ("page", "--angle", ["-30", "181"], "a number from 0 to 180 (degrees)"),
    ("page", "--lift", ["-1", "1.5", "²"], "a whole number, 0 or more"),
    ("page", "--port", ["65536", "web", "", "\u0663"], "a whole number from 0 to 65535"),
    ("double", "--phi", ["181", "-180.5", "nan", "right"], "a number from -180 to 180 (degrees)"),
    ("text", "--seconds", ["0", "inf"], "a number above 0 and up to 1e6 (s)"),
    ("text", "--record", [""], "the name of a file"),
    ("text", "--every", ["1e-11", str(DT / 2), str(DT * 1.5), "1e7", "nan"], EVERY),
]


@pytest.mark.parametrize(
    ("program", "line", "message"),
    [
        *(
            (
                program,
                f"{option}={value}",
                f"argument {option}: found {value!r}, allowed is {allowed}",
            )
            for program, option, values, allowed in BAD
            for value in values
        ),
        *(
            (program, f"{option}=--", f"found '{option}=--', allowed is no -- after =")
            for program, option, *_ in [*BAD, ("page", "--host")]
        ),
        ("page", "--elastic --e 0.5", "argument --e: not allowed with argument --elastic"),
        ("page", "--elast", "unrecognized arguments: --elast"),
        ("text", "--no-browser", "unrecognized arguments: --no-browser"),
        ("text", "--record data.csv", "argument --record: needs --seconds, to say how long"),
        ("text", "--every 0.1 --seconds 5", "argument --every: needs --record"),
        # Not shown letters
        ("text", "my.csv \x1b[2J\udcffω", r"unrecognized arguments: \x1b[2J\udcffω"),
    ],
)
def test_bad_options_are_refused_in_one_line(program, line, message, capsys):
    assert refusal(program, line.split(), capsys) == message
