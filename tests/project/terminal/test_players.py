"""The program in the terminal: its lines in step with the clock, its data, and its end."""

import sys
from contextlib import nullcontext
from math import degrees
from pathlib import Path
from unittest.mock import Mock

import pandas as pd
import pytest
from whole_cradles import PROGRAMS, settings_for

from support.constants import DT, THETA_INIT
from support.cradle.cradle import Cradle
from support.cradle.real_time import RealTime
from support.pendulum import outwards_to_angle
from support.start import output
from support.start.end import SignalError
from support.terminal import players


def test_it_prints_a_line_each_half_second_in_step_with_the_clock(csv, capsys):
    """On a clock on which only sleeping takes time."""
    cradle = Cradle()
    settings = settings_for(csv, [outwards_to_angle(30)], 1)
    player = players.Lines(cradle, settings, seconds=1.2)
    slept = []
    player.pace = RealTime(
        DT, lambda: 50.0 + sum(slept), lambda pause: slept.append(max(pause, 1e-4))
    )
    players.run_for_each_cradle(PROGRAMS["single"], player)
    assert sum(slept) == pytest.approx(1.2, abs=2 / 60)
    heading, first, *lines = capsys.readouterr().out.splitlines()
    assert (
        heading == "   t (s)          energy   angle of each bob (degrees, positive to the right)"
    )
    assert first == "    0.00         100.0 %   -30.0     0.0     0.0     0.0     0.0"
    assert [line[:24] for line in lines] == [
        f"{time:8.2f}         100.0 %" for time in (0.5, 1.0, 1.2)
    ]
    shown = [float(angle) for angle in lines[-1][24:].split()]
    assert shown == pytest.approx([degrees(pend["theta"]) for pend in cradle.pend_list], abs=0.05)


def test_a_remark_about_the_run_is_printed_once(csv, capsys):
    player = players.Lines(Cradle(), settings_for(csv), 1.0)
    player.pace = Mock(due=lambda most: most, frame_start=0.0, clock=lambda: 0.0)
    player.pace.remark = lambda: "0.6x real time"
    players.run_for_each_cradle(PROGRAMS["single"], player)
    _, remark, *lines = capsys.readouterr().out.splitlines()
    assert remark == "0.6x real time"
    assert [float(line.split()[0]) for line in lines] == [0, 0.5, 1]


def test_it_ends_quietly_when_nobody_reads_on(main, csv, write_program):
    """Also in a student's function, which may print."""
    write_program("raise BrokenPipeError")
    assert main(csv) == (0, "", "")


NEVER_ENDS = """from support.start.end import SignalError
raise SignalError(143)
"""


def test_a_signal_in_a_loop_without_end_names_it(main, csv, monkeypatch, write_program):
    """A loop that takes longer than ENDLESS_AFTER has no end."""
    write_program(NEVER_ENDS)
    assert main(csv) == (143, "", "")
    monkeypatch.setattr("support.cradle.player.ENDLESS_AFTER", -1)
    status, _, stderr = main(csv)
    assert status == 143
    assert stderr.startswith("Is there a loop that never ends?\n")
    assert 'program.py", line 2, in <module>' in stderr


# --- the recorder ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("dt", "line", "count", "last", "every"),
    [
        (DT, "0.09", 10, 0.09, 0.01),  # 899.99999999999999 ticks
        (3e-4, "1.4", 142, 1.3959, 0.0099),  # nearer to 0.01 than 0.0102
    ],
)
def test_a_row_is_recorded_at_each_multiple_up_to_the_end(
    main, csv, monkeypatch, dt, line, count, last, every
):
    """With any tick. The progress is reported however rare the rows are."""
    parts = []
    monkeypatch.setattr(Cradle, "dt", dt)
    monkeypatch.setattr(players, "progress_bar", lambda: nullcontext(parts.append))
    data = csv.with_name("data.csv")
    status, out, err = main(csv, "--record", data, "--lift", 2, "--seconds", *line.split())
    assert (status, err) == (0, "")
    assert out == f"{count} rows, from t = 0 to {last:g} s, are in {data}\n"
    table = pd.read_csv(data)
    assert table["t"].to_list() == pytest.approx([every * i for i in range(count)])
    assert table.loc[0, ["theta_1", "theta_2", "theta_3"]].to_list() == [THETA_INIT, THETA_INIT, 0]
    assert len(parts) == max(1, round(last / (1000 * dt)))
    assert parts[-1] == 1


def test_a_recording_can_be_the_output_and_all_words_are_then_elsewhere(
    main, csv, monkeypatch, write_program
):
    """A student's own, and remarks about the run."""
    monkeypatch.chdir(csv.parent)
    own = "print('words'); pend_list[0]['mass'] = 2\n    while"
    write_program(PROGRAMS["single"].read_text().replace("while", own))
    arguments = csv, "--seconds", "0.02", "--e", 0.5, "--record"
    remark = "The program does not take mass from NC_FP.\n"
    assert main(*arguments, "./-")[1].startswith(f"words\n{remark}3 rows, ")
    assert main(*arguments, "-") == (0, Path("-").read_text(), f"words\n{remark}")


def test_a_recording_that_is_ended_early_says_so(main, csv, monkeypatch):
    monkeypatch.setattr(players.DataRecorder, "take_sample", Mock(side_effect=SignalError(143)))
    status, _, _ = main(csv, "--record", csv.with_name("data.csv"), "--seconds", 1)
    assert status == "The recording ended too early."  # Python prints it, with status 1


@pytest.mark.parametrize(("is_terminal", "seconds"), [(True, 3), (True, 1), (False, 3)])
def test_a_terminal_shows_the_progress_of_what_takes_longer_than_two_seconds(
    monkeypatch, capsys, is_terminal, seconds
):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: is_terminal)
    monkeypatch.setattr(output, "time", Mock(monotonic=Mock(side_effect=[0, *[seconds] * 9])))
    with output.progress_bar() as progress:
        for done in (0.25, 0.251, 1):
            progress(done)
    shown = is_terminal and seconds > output.BAR_AFTER
    assert capsys.readouterr().err == ("\r25 % \r100 % \n" if shown else "")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("--lift 6", "--lift: found '6', allowed is at most 5, the number of pendula in five.csv"),
        ("--seconds 1 --record no/x.csv", "no/x.csv: No such file or directory"),
    ],
)
def test_the_program_refuses_in_one_line(main, csv, monkeypatch, options, words):
    monkeypatch.chdir(csv.parent)
    csv.rename("five.csv")
    assert main("five.csv", *options.split()) == (2, "", f"{words}\n")


HIDDEN = """\
name = "Unknown"
theta = [-45, 0]
mass = [3.8, 1]
hidden = "mass 1"
question = "Find it."
why = "So it is found."
"""


def test_lines_and_recorded_data_do_not_show_a_hidden_value(main, csv):
    experiment = csv.with_name("one.toml")
    experiment.write_text(HIDDEN)
    data = csv.with_name("data.csv")
    arguments = "--experiment", experiment, "--seconds", "0.1"
    _, shown, _ = main(*arguments)
    assert "energy" not in shown
    assert "0.00   -45.0     0.0\n" in shown
    main(*arguments, "--record", data)
    names, _ = data.read_text().split("\n", 1)
    assert names == "t,theta_1,theta_2,omega_1,omega_2"
