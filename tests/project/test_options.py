"""The command line: accepted options, refused options, and their messages."""

import random
from math import degrees, inf, pi

import pytest
from whole_cradles import FIVE_CSV

from support.constants import DT, NC_FP, PHI_INIT
from support.pendulum import from_lift
from support.start.options import (
    check_lift,
    page_arguments,
    PORT_VARIABLE,
    read_double_page_options,
    read_page_options,
    read_text_options,
)


def read(line):
    return vars(read_page_options(line.split()))


DEFAULTS = {
    "csv": NC_FP,
    "elastic": False,
    "inelastic": False,
    "e": None,
    "mass": None,
    "angle": None,
    "lift": None,
    "separating": False,
    "port": 0,
    "experiment": None,
    "browser": True,
}


@pytest.mark.parametrize(
    ("line", "changed"),
    [
        ("", {}),
        ("my.csv", {"csv": "my.csv"}),
        ("--elastic", {"elastic": True}),
        ("--inelastic", {"inelastic": True}),
        ("--e 0.5", {"e": 0.5}),
        ("--e 0", {"e": 0.0}),
        ("--mass 2.5 --angle 12.5 --lift 3", {"mass": 2.5, "angle": from_lift(12.5), "lift": 3}),
        ("--experiment 1_one_bob", {"experiment": "1_one_bob"}),
        ("--lift 0 --angle 180", {"lift": 0, "angle": from_lift(180.0)}),
        ("--separating", {"separating": True}),
        ("--port 8000 --no-browser my.csv", {"port": 8000, "browser": False, "csv": "my.csv"}),
    ],
)
def test_what_it_takes(line, changed):
    assert read(line) == {**DEFAULTS, **changed}


@pytest.mark.parametrize(("line", "phi"), [("", None), ("--phi -180", from_lift(-180)), ("--phi 180", from_lift(180))])
def test_what_the_double_cradle_takes_besides(line, phi):
    assert vars(read_double_page_options(line.split())) == {**DEFAULTS, "phi": phi}


@pytest.mark.parametrize(
    "line",
    [
        "",
        "my.csv",
        "--elastic",
        "--inelastic",
        "--e 0",
        "--e 1e-07 --mass 1e-05",
        "--e 0.30000000000000004 --mass 2.5",
        "--lift 0",
        "--angle 0 --lift 12",
        "--angle 1e-05",
        "--separating",
        "--port 8000",
        "--experiment 2_two_bobs --separating",
        "--no-browser",
        "my.csv --inelastic --separating --mass 3 --angle 33.3 --lift 2 --port 8000 --no-browser",
    ],
)
def test_the_arguments_of_the_options_make_the_same_options_again(line):
    options = read(line)
    arguments = page_arguments(options)
    assert vars(read_page_options(arguments)) == options
    assert sorted(arguments) == sorted(line.split())


@pytest.mark.parametrize("phi", ["-180", "-12.5", "-1e-05", "0", "77"])
def test_so_they_do_for_the_double_cradle(phi):
    options = vars(read_double_page_options([f"--phi={phi}", "--angle", "45"]))
    assert vars(read_double_page_options(page_arguments(options))) == options


@pytest.mark.parametrize("outwards", [-1, 1])
def test_an_angle_comes_back_to_the_last_bit(monkeypatch, outwards):
    monkeypatch.setattr("support.pendulum.OUTWARDS", outwards)
    dice = random.Random(1)
    for lift in [*range(181), *(dice.uniform(-180, 180) for _ in range(5000)), 1e-9, 179.99999999999997]:
        angle = from_lift(lift)
        [argument] = [word for word in page_arguments({"phi": angle}) if word != "--phi"]
        assert from_lift(float(argument.removeprefix("--phi="))) == angle
        if lift == round(lift):
            assert argument == str(lift)


TEXT_DEFAULTS = {
    **{name: value for name, value in DEFAULTS.items() if name not in ("separating", "port", "browser", "experiment")},
    "seconds": inf,
    "record": None,
    "every": 0.01,
}


@pytest.mark.parametrize(
    ("line", "changed"),
    [
        ("", {}),
        (
            "--inelastic --mass 2 --angle 5 --lift 2 my.csv",
            {"inelastic": True, "mass": 2.0, "angle": from_lift(5.0), "lift": 2, "csv": "my.csv"},
        ),
        ("--seconds 2.5 --angle 0", {"seconds": 2.5, "angle": from_lift(0.0)}),
        ("--seconds 1e6", {"seconds": 1e6}),
        (f"--seconds 1 --record data.csv --every {DT}", {"seconds": 1.0, "record": "data.csv", "every": DT}),
        ("--seconds 60 --record data.csv", {"seconds": 60.0, "record": "data.csv"}),
        ("--seconds 60 --record data.csv --every 0.5", {"seconds": 60.0, "record": "data.csv", "every": 0.5}),
    ],
)
def test_what_the_cradle_in_the_terminal_takes(line, changed):
    assert vars(read_text_options(line.split())) == {**TEXT_DEFAULTS, **changed}


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("--seconds 0", "argument --seconds: found '0', allowed is a number above 0 and up to 1e6 (s)"),
        ("--seconds inf", "argument --seconds: found 'inf', allowed is a number above 0 and up to 1e6 (s)"),
        ("--record data.csv", "argument --record: needs --seconds, to say how long"),
        ("--record=", "argument --record: found '', allowed is the name of a file"),
        ("--every 0.1", "argument --every: needs --record"),
        ("--every 0.1 --seconds 5", "argument --every: needs --record"),
        (
            f"--record data.csv --seconds 5 --every {DT / 2}",
            f"argument --every: found '{DT / 2}', allowed is a multiple of {DT:g} (s), one tick, up to 1e6",
        ),
        (
            f"--record data.csv --seconds 5 --every {DT * 1.5}",
            f"argument --every: found '{DT * 1.5}', allowed is a multiple of {DT:g} (s), one tick, up to 1e6",
        ),
        (
            "--record data.csv --seconds 5 --every 1e7",
            f"argument --every: found '1e7', allowed is a multiple of {DT:g} (s), one tick, up to 1e6",
        ),
        (
            "--record data.csv --seconds 5 --every nan",
            f"argument --every: found 'nan', allowed is a multiple of {DT:g} (s), one tick, up to 1e6",
        ),
        ("--no-browser", "unrecognized arguments: --no-browser"),
    ],
)
def test_what_the_cradle_in_the_terminal_refuses_in_one_line(line, message, capsys):
    with pytest.raises(SystemExit) as refused:
        read_text_options(line.split())
    stdout, stderr = capsys.readouterr()
    assert (refused.value.code, stdout) == (2, "")
    assert stderr.endswith(f": error: {message} (--help shows all options)\n")
    assert stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("--e 1.1", "argument --e: found '1.1', allowed is a number from 0 to 1"),
        ("--e -0.1", "argument --e: found '-0.1', allowed is a number from 0 to 1"),
        ("--e nan", "argument --e: found 'nan', allowed is a number from 0 to 1"),
        ("--e", "argument --e: expected one argument"),
        ("--mass 0", "argument --mass: found '0', allowed is a number from 1e-300 to 1e6 (kg)"),
        ("--mass inf", "argument --mass: found 'inf', allowed is a number from 1e-300 to 1e6 (kg)"),
        ("--mass 1kg", "argument --mass: found '1kg', allowed is a number from 1e-300 to 1e6 (kg)"),
        ("--angle -30", "argument --angle: found '-30', allowed is a number from 0 to 180 (degrees)"),
        ("--angle 181", "argument --angle: found '181', allowed is a number from 0 to 180 (degrees)"),
        ("--lift -1", "argument --lift: found '-1', allowed is a whole number, 0 or more"),
        ("--lift 1.5", "argument --lift: found '1.5', allowed is a whole number, 0 or more"),
        ("--lift ²", "argument --lift: found '²', allowed is a whole number, 0 or more"),
        ("--port 65535", "argument --port: found '65535', allowed is a whole number from 0 to 65534"),
        ("--port web", "argument --port: found 'web', allowed is a whole number from 0 to 65534"),
        ("--elastic --e 0.5", "argument --e: not allowed with argument --elastic"),
        ("--elast", "unrecognized arguments: --elast"),
        ("a.csv b.csv", "unrecognized arguments: b.csv"),
    ],
)
def test_what_it_refuses_in_one_line(line, message, capsys):
    with pytest.raises(SystemExit) as refused:
        read(line)
    stdout, stderr = capsys.readouterr()
    assert (refused.value.code, stdout) == (2, "")
    assert stderr.endswith(f": error: {message} (--help shows all options)\n")
    assert stderr.count("\n") == 1


@pytest.mark.parametrize("read_options", [read_page_options, read_double_page_options, read_text_options])
@pytest.mark.parametrize(
    ("word", "shown"),
    [
        ("--el\nast", r"--el\nast"),
        ("a\x1b[2J\r.csv", r"a\x1b[2J\r.csv"),
        ("\udcff\u2028ω", r"\udcff\u2028ω"),
    ],
)
def test_what_a_terminal_does_not_show_is_written_out(read_options, word, shown, capsys):
    with pytest.raises(SystemExit):
        read_options(["my.csv", word])
    assert capsys.readouterr().err.endswith(f": error: unrecognized arguments: {shown} (--help shows all options)\n")


def test_the_port_may_come_from_vpythons_environment_variable(monkeypatch, capsys):
    monkeypatch.setenv(PORT_VARIABLE, "8000")
    assert read("")["port"] == 8000
    assert read("--port 9000")["port"] == 9000
    monkeypatch.setenv(PORT_VARIABLE, "web")
    with pytest.raises(SystemExit):
        read("")
    assert "--port: found 'web'" in capsys.readouterr().err


def help_of(read_options, capsys):
    """Return the text of --help on one line."""
    with pytest.raises(SystemExit) as ended:
        read_options(["--help"])
    assert ended.value.code == 0
    return " ".join(capsys.readouterr().out.split())


def test_help_has_each_option_with_its_unit_and_default(capsys):
    text = help_of(read_page_options, capsys)
    for words in (
        "CSV file of the cradle (default: newton_cradle_pends.csv)",
        "--elastic e = 1",
        "--inelastic e = 0",
        "--e E one e, from 0 to 1, for all pendula (default: the CSV's)",
        "--mass KG one mass, in kg, for all pendula (default: the CSV's)",
        "from 0 to 180 degrees (default: ",
        "number of lifted bobs, from the left (default: 1)",
        "--port N",
        "--separating",
        "--no-browser",
    ):
        assert words in text


def test_phi_is_outwards_by_default_if_theta_and_phi_have_one_sign(monkeypatch, capsys):
    monkeypatch.setattr("support.start.options.PHI_INIT", pi / 18)
    for outwards, default in ((-1, -10), (1, 10)):
        monkeypatch.setattr("support.pendulum.OUTWARDS", outwards)
        with pytest.raises(SystemExit):
            read_double_page_options(["--help"])
        assert f"(default: {default})" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize("phi", ["181", "-180.5", "nan", "right"])
def test_what_the_double_cradle_refuses_besides(phi, capsys):
    with pytest.raises(SystemExit) as refused:
        read_double_page_options(["--phi", phi])
    assert refused.value.code == 2
    message = f"argument --phi: found '{phi}', allowed is a number from -180 to 180 (degrees)"
    assert message in capsys.readouterr().err


def test_so_has_the_help_of_the_double_cradle(capsys):
    text = help_of(read_double_page_options, capsys)
    assert "double Newton's cradle" in text
    assert "--angle DEGREES" in text
    assert "When you save its CSV, the page shows the new cradle." in text
    outwards = f"{abs(degrees(PHI_INIT)):g}"
    assert (
        f"angle of the lifted lower cords from the upper ones, outwards, from -180 to 180 degrees (default: {outwards})"
        in text
    )


def test_so_has_the_help_of_the_cradle_in_the_terminal(capsys):
    text = help_of(read_text_options, capsys)
    for words in (
        "number of lifted bobs, from the left (default: 1)",
        "--seconds S end after S seconds (default: until Ctrl+C)",
        "--record FILE write the data of S seconds (--seconds S) to FILE, a CSV",
        "--every S with --record: a row for every S seconds (default: 0.01)",
    ):
        assert words in text


def test_as_many_bobs_as_there_are_may_be_lifted(tmp_path):
    csv = tmp_path / "cradle.csv"
    csv.write_text(FIVE_CSV)
    check_lift(5, csv)
    with pytest.raises(ValueError, match="^--lift: found '6', allowed is at most 5, the number of pendula in "):
        check_lift(6, csv)
