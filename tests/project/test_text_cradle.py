"""The program in the terminal: its lines in step with the clock, its data, and its end."""

import os
import re
import signal
import sys
from contextlib import nullcontext
from io import StringIO
from math import radians
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import pandas as pd
import pytest
from programs import call
from whole_cradles import make_live, PERIOD, settings_for

from src import text_cradle_run
from src.visualize_cradle_run import main as cradle_main
from support.constants import DT, THETA_INIT
from support.cradle.cradle import Cradle
from support.cradle.real_time import RealTime
from support.pendulum import outwards_to_angle
from support.start import output
from support.terminal import players

REMARK = "Write next: main."


@pytest.fixture
def main(monkeypatch, capsys):
    """A function that runs the program with these arguments; it returns its status and output."""
    # The tests keep their own signals
    monkeypatch.setattr(text_cradle_run, "stop_on_signals", lambda: None)

    def main(*arguments):
        monkeypatch.setattr(sys, "argv", ["text_cradle_run.py", *map(str, arguments)])
        return call(text_cradle_run.main, capsys)

    return main


def test_it_prints_a_line_each_half_second_in_step_with_the_clock(csv, capsys):
    """On a clock on which only sleeping takes time."""
    seconds = 0.7 + PERIOD / 2  # after the hits have run through the row and back
    cradle = make_live()
    settings = settings_for(cradle, csv, [outwards_to_angle(30)], 1)
    player = players.Lines(cradle, settings, SimpleNamespace(seconds=seconds))
    slept = []
    player.pace = RealTime(
        DT, lambda: 50.0 + sum(slept), lambda pause: slept.append(max(pause, 1e-4))
    )
    players.run(cradle_main, player)
    assert sum(slept) == pytest.approx(seconds, abs=2 / 60)
    printed = capsys.readouterr().out
    times = [*(f"{0.5 * i:.2f}" for i in range(int(2 * seconds) + 1)), f"{seconds:.2f}"]
    assert re.findall(r"(?m)^t = (.*?) s, ", printed) == times
    for line in printed.splitlines():
        assert re.search(r", energy (99\.9|100\.\d) %, bob (1 .* left|5 .* right)", line)
    assert printed.startswith("t = 0.00 s, energy 100.0 %, bob 1 at 30 degrees left\n")
    assert printed.index("hits: 1-2-3-4-5\n") < printed.index("hits: 5-4-3")


def test_a_line_has_the_latest_series_that_is_not_slow_and_at_most_80_columns(swing, capsys):
    motion = swing().motion
    motion.impacts.add(0.1, 0, 1, True)
    motion.impacts.add(0.3, 3, 4, False)
    motion.impacts.add(0.5, 1, 2, True, is_fast=False)
    assert motion.summary().endswith(" left, hits: 5-4")
    for number in range(9):
        motion.impacts.add(0.7, number % 4, number % 4 + 1, True)
    players.Lines.take_sample(SimpleNamespace(motion=motion))
    line = capsys.readouterr().out
    assert len(line) == 80 + 1
    assert line.endswith("...\n")
    motion.cradle.pend_list[1]["theta"] = radians(360 * 3 + 50)  # it has gone round three times
    assert "bob 2 at 50 degrees right" in motion.summary()
    motion.cradle.pend_list[2]["theta"] = radians(48)
    assert "bobs 2, 3 at 50 degrees right" in motion.summary()
    for pend in motion.cradle.pend_list:
        pend["theta"] = 0.0
    assert "bobs 1, 2, 3, 4, 5 at 0 degrees right" in motion.summary()


@pytest.mark.parametrize(
    ("error", "status"), [(BrokenPipeError(), 0), (KeyboardInterrupt(131), 131)]
)
def test_it_ends_quietly_when_nobody_reads_on_or_a_signal_comes(
    main, csv, monkeypatch, error, status
):
    monkeypatch.setattr(players, "in_line", Mock(side_effect=error))
    assert main(csv) == (status, "", "")


def test_ctrl_c_in_a_loop_without_end_names_it(main, csv, monkeypatch):
    """A loop that takes longer than ENDLESS_AFTER has no end."""
    monkeypatch.setattr("support.cradle.player.ENDLESS_AFTER", -1)
    monkeypatch.setattr("src.swinging.sin", Mock(side_effect=KeyboardInterrupt(0)))
    monkeypatch.setattr(text_cradle_run, "many_ticks", None)
    status, _, err = main(csv)
    assert status == 0
    assert re.match(r"swinging\.py, line \d+: .* in angle_update or .* or main never end\?\n$", err)


# --- on a terminal --------------------------------------------------------------------------------


def test_on_a_terminal_a_picture_moves_on_a_screen_of_its_own(main, csv, monkeypatch):
    """Ctrl+Z would leave this screen to the shell. The last picture stays."""
    monkeypatch.setattr(text_cradle_run, "has_terminal", lambda: True)
    monkeypatch.setattr(text_cradle_run, "what_there_is", lambda loop, _: (loop, REMARK))
    ignore = Mock()
    monkeypatch.setattr("signal.signal", ignore)
    status, out, _ = main(csv, "--seconds", "0.12")
    assert status == 0
    before, _, pictures = out.partition(players.OWN_SCREEN)
    assert before == ""
    pictures, last = pictures.split(players.OLD_SCREEN)
    times = re.findall(rf"\x1b\[H\x1b\[Kt = (\S+) s .*\n\x1b\[K{REMARK}\n", pictures)
    assert times == ["0.00", "0.05", "0.10", "0.12"]
    assert pictures.endswith("\n\x1b[KCtrl+C ends it.\x1b[J")
    assert last.startswith("t = 0.12 s ")
    if os.name == "posix":
        ignore.assert_called_once_with(signal.SIGTSTP, signal.SIG_IGN)


@pytest.mark.parametrize(
    ("term", "is_terminal"), [("xterm", True), ("dumb", True), ("xterm", False)]
)
def test_only_a_terminal_that_can_move_its_cursor_shows_pictures(monkeypatch, term, is_terminal):
    # Pytest -vv asks, too
    monkeypatch.setattr(sys, "stdout", Mock(isatty=lambda: is_terminal, fileno=lambda: 1))
    monkeypatch.setattr(sys, "__stdout__", sys.stdout)
    monkeypatch.setenv("TERM", term)
    assert players.has_terminal() == (is_terminal and term != "dumb")


# --- the recorder ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("dt", "line", "count", "last", "every"),
    [
        (DT, "0.025", 3, 0.02, 0.01),
        (DT, "0.3 --every 0.1", 4, 0.3, 0.1),
        (DT, "0.001 --every 0.0001", 11, 0.001, 0.0001),
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


def test_a_recording_can_be_the_output_and_all_words_are_then_elsewhere(main, csv, monkeypatch):
    monkeypatch.chdir(csv.parent)
    monkeypatch.setattr(text_cradle_run, "what_there_is", lambda loop, _: (loop, REMARK))
    arguments = csv, "--seconds", "0.02", "--record"
    main(*arguments, "./-")
    assert main(*arguments, "-") == (0, Path("-").read_text(), f"{REMARK}\n")
    monkeypatch.setattr(players.DataRecorder, "take_sample", Mock(side_effect=KeyboardInterrupt(1)))
    assert main(*arguments, "-")[2] == f"{REMARK}\nThe recording ended too early.\n"


def test_a_recording_that_is_ended_early_leaves_the_old_file(main, csv, monkeypatch):
    data = csv.with_name("data.csv")
    data.write_text("t,theta_1,momentum\n")
    monkeypatch.setattr(
        players.DataRecorder, "take_sample", Mock(side_effect=KeyboardInterrupt(143))
    )
    line = f"The recording ended too early. {data} is not written.\n"
    assert main(csv, "--record", data, "--seconds", "1") == (1, "", line)
    assert sorted(path.name for path in csv.parent.iterdir()) == ["cradle.csv", "data.csv"]
    assert data.read_text() == "t,theta_1,momentum\n"


@pytest.fixture
def bar(monkeypatch):
    """A function that returns what stderr gets while something takes these seconds."""

    def bar(seconds, columns=80, is_terminal=True):
        stderr = StringIO()
        stderr.isatty = lambda: is_terminal
        monkeypatch.setattr(sys, "stderr", stderr)
        monkeypatch.setenv("COLUMNS", str(columns))
        now = 0.0
        with output.progress_bar(lambda: now) as progress:
            for number in range(1, 10_001):
                now += seconds / 10_000
                progress(number / 10_000)
        return stderr.getvalue()

    return bar


def test_only_a_terminal_shows_the_progress_and_only_after_two_seconds(bar):
    assert bar(40, is_terminal=False) == ""
    assert bar(1.9) == ""


@pytest.mark.parametrize(("columns", "width"), [(80, 40), (26, 1)])
def test_a_bar_shows_the_progress_and_the_seconds_that_are_left(bar, columns, width):
    printed = bar(40, columns)
    bars = re.findall(r"\r\[(#* *)\] +(\d+)%, (\d+) s left", printed)
    assert len(bars) == pytest.approx(20 * (40 - 2), rel=0.05)  # 20 a second
    for text, percent, left in bars:
        assert len(text) == width
        assert text.count("#") == pytest.approx(width * int(percent) / 100, abs=1)
        assert int(left) == pytest.approx(0.4 * (100 - int(percent)), abs=1)
    assert max(map(len, printed.split("\r"))) < columns
    assert printed.endswith("\r\x1b[K")


@pytest.mark.parametrize(
    ("option", "value", "allowed"),
    [
        ("--lift", "6", "allowed is at most 5"),
        ("--record", "cradle.csv", "which has something else"),
    ],
)
def test_the_program_refuses_in_one_line(main, csv, monkeypatch, option, value, allowed):
    monkeypatch.chdir(csv.parent)
    status, out, err = main(csv, option, value, "--seconds", "1")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert err.startswith(f"{option}: found '{value}', {allowed}")
