"""The cradle in the terminal: its pictures, lines, timing, data and messages."""

import os
import re
import select
import shlex
import signal
import sys
import time
from contextlib import nullcontext, suppress
from io import StringIO
from itertools import pairwise, product
from math import radians
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import pandas as pd
import pytest
from programs import call, on_posix, ROOT, SECONDS
from whole_cradles import GOOD, HEADER, make_live, make_swing, PERIOD

from grading.cradles import hang, R
from src import text_cradle_run
from src.visualize_cradle_run import main as cradle_main
from support.constants import DT
from support.cradle.cradle import Cradle
from support.cradle.real_time import RealTime
from support.files.cradle_csv import Snapshot
from support.pendulum import outwards_to_angle
from support.start import output
from support.terminal import players

HOME = "\x1b[H"


@pytest.fixture
def main(monkeypatch, capsys):
    """A function that runs the program with these arguments, and returns its status and its output."""
    # The tests keep their own
    monkeypatch.setattr(text_cradle_run, "stop_on_signals", lambda: None)

    def main(*arguments):
        monkeypatch.setattr(sys, "argv", ["text_cradle_run.py", *map(str, arguments)])
        return call(text_cradle_run.main, capsys)

    return main


def test_it_prints_a_line_each_half_second_in_step_with_the_clock(csv, capsys):
    """On a clock on which only sleeping takes time."""
    seconds, slept = 0.7 + PERIOD / 2, []  # after the hits have run through the row and back
    player = players.Lines(
        make_live(),
        Snapshot(csv),
        SimpleNamespace(angle=outwards_to_angle(30), lift=1, seconds=seconds),
    )
    player.pace = RealTime(
        DT, lambda: 50.0 + sum(slept), lambda pause: slept.append(max(pause, 1e-4))
    )
    players.run(cradle_main, player)
    assert sum(slept) == pytest.approx(seconds, abs=2 / 60)
    printed = capsys.readouterr().out
    shown = [*(f"{0.5 * i:.2f}" for i in range(int(2 * seconds) + 1)), f"{seconds:.2f}"]
    for line, at in zip(printed.splitlines(), shown, strict=True):
        state = r"energy (99.9\d|100.\d\d) %, bob (1 at \d+ degrees left|5 at \d+ degrees right)"
        assert re.fullmatch(rf"t = {at} s, {state}(, hits: [\d ,-]+)?", line)
    assert printed.startswith("t = 0.00 s, energy 100.00 %, bob 1 at 30 degrees left\n")
    assert printed.index("hits: 1-2-3-4-5") < printed.index("5-4-3")


def test_a_line_has_the_latest_train_that_is_not_slow_and_at_most_80_columns(tmp_path):
    motion = make_swing(tmp_path).motion
    motion.trains.add(0.1, 0, 1, True)
    motion.trains.add(0.3, 3, 4, False)
    motion.trains.add(0.5, 1, 2, True, is_fast=False)
    assert players.summary(motion).endswith(" left, hits: 5-4")
    for number in range(9):
        motion.trains.add(0.7, number % 4, number % 4 + 1, True)
    line = players.summary(motion)
    assert (len(line), line.endswith("..."), "hits: 1-2-3-4-5  1-2-" in line) == (80, True, True)
    motion.cradle.pend_list[1]["theta"] = radians(360 * 3 + 50)  # it has gone round three times
    assert "bob 2 at 50 degrees right" in players.summary(motion)


@pytest.mark.parametrize(
    ("error", "status"), [(BrokenPipeError(), 0), (KeyboardInterrupt(131), 131)]
)
def test_it_ends_quietly_when_nobody_reads_on_or_a_signal_comes(
    main, csv, monkeypatch, error, status
):
    monkeypatch.setattr(players, "summary", Mock(side_effect=error))
    assert main(csv) == (status, "", "")


def test_ctrl_c_in_a_loop_without_end_names_it(main, csv, monkeypatch):
    """A loop that takes longer than ENDLESS has no end."""
    monkeypatch.setattr("support.cradle.player.ENDLESS", -1)
    monkeypatch.setattr("src.swinging.sin", Mock(side_effect=KeyboardInterrupt(0)))
    monkeypatch.setattr(text_cradle_run, "many_ticks", None)
    status, _, err = main(csv)
    called = "angle_update or swing_update or full_swing_update or newton_cradle_tick or main"
    assert (status, re.sub("[0-9]+", "N", err)) == (
        0,
        f"swinging.py, line N: does a loop in {called} never end?\n",
    )


# --- on a terminal ---------------------------------------------------------------------------------------------------


def on_a_terminal(command, steps):
    """Run a command in a terminal of its own, with 24 lines and 80 columns; return its output.

    Each step is (condition, key): as soon as condition(output so far) holds, the key is pressed.
    """
    import pty

    text, deadline, data = "", time.monotonic() + SECONDS, b"..."
    process, file = pty.fork()
    if process == 0:
        sized = f"unset LINES COLUMNS; stty rows 24 cols 80; {command}"
        os.execvpe("sh", ["sh", "-mc", sized], {**os.environ, "TERM": "xterm"})
    try:
        while data:
            assert time.monotonic() < deadline, text
            if steps and steps[0][0](text):
                os.write(file, steps.pop(0)[1])
            if select.select([file], [], [], 1)[0]:
                data = b""
                # On Linux, this means that the command has ended; macOS reads nothing
                with suppress(OSError):
                    data = os.read(file, 65536)
                text += data.decode()
    finally:
        os.close(file)
        os.kill(process, signal.SIGKILL)
        os.waitpid(process, 0)
    return text


@on_posix
def test_on_a_terminal_a_picture_moves_until_ctrl_c(csv):
    program = shlex.join(
        [sys.executable, str(ROOT / "src" / "text_cradle_run.py"), str(csv), "--angle", "40"]
    )
    keys = (
        (lambda text: text.count(HOME) > 8, b"\x1a"),
        (lambda text: text.count(HOME) > 12, b"\x03"),
    )
    printed = on_a_terminal(f'{program}; echo "ended: $?"', [*keys]).replace("^Z", "")  # its echo
    # A key may cut a later picture
    whole = re.findall(r"\x1b\[H(.*?)\x1b\[J", printed, re.DOTALL)[:8]
    assert all(text.count("\n\x1b[K") == text.count("\n") for text in whole)  # each line is cleared
    seen = [text.replace("\x1b[K", "").splitlines() for text in whole]
    times = [re.match(r"t = (\d+\.\d\d) s +energy", picture[0])[1] for picture in seen]
    assert times == ["0.00", "0.05", "0.10", "0.15", "0.20", "0.25", "0.30", "0.35"]
    assert {len(picture) for picture in seen} == {len(seen[0])}
    assert len({picture[8] for picture in seen}) > 2  # a line with bobs that swing
    assert (max(map(len, seen[0])) <= 80, seen[0][-1]) == (True, "Ctrl+C ends it.")
    before, _, after = printed.partition(players.OWN_SCREEN)
    assert (HOME in before, printed.isascii(), after.count(players.OLD_SCREEN)) == (False, True, 1)
    last = after.partition(players.OLD_SCREEN)[2]
    assert re.fullmatch(r"t = .*ended: 0\r\n", last, re.DOTALL)  # the last picture stays


@pytest.mark.parametrize(
    ("term", "is_terminal"), [("xterm", True), ("dumb", True), ("xterm", False)]
)
def test_only_a_terminal_that_can_move_its_cursor_shows_pictures(monkeypatch, term, is_terminal):
    # Pytest -vv asks, too
    monkeypatch.setattr(sys, "stdout", Mock(isatty=lambda: is_terminal, fileno=lambda: 1))
    monkeypatch.setattr(sys, "__stdout__", sys.stdout)
    monkeypatch.setenv("TERM", term)
    assert players.has_terminal() == (is_terminal and term != "dumb")


def test_the_lines_fit_into_a_terminal_of_any_size(tmp_path, monkeypatch):
    motion = make_swing(tmp_path, angle=170).motion
    motion.trains.add(1.0, 0, 1, True)
    for rows, columns in product([1, 2, 3, 4, 17, 18, 19], [1, 2, 6, 7, 11, 40]):
        monkeypatch.setattr(
            "shutil.get_terminal_size", lambda size=(columns, rows): os.terminal_size(size)
        )
        for remark in ("", "Write next: handle_collision."):
            lines = players.screen(motion, players.TextPicture(), "0.6x real time", remark)
            assert 1 <= len(lines) <= rows
            assert max(map(len, lines)) <= columns
            assert lines[0] == motion.reading()[:columns].rstrip()
            is_whole = "Impacts" in lines and lines[-1] == "Ctrl+C ends it."[:columns].rstrip()
            assert is_whole == (rows >= 18 and columns >= 7)


# Python 3.10 then returns 0
@pytest.mark.parametrize("size", [(200, 24), (0, 0)], ids=["large", "not known"])
def test_a_screen_has_numbers_remark_picture_and_impacts(tmp_path, monkeypatch, size):
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size(size))
    motion = make_swing(tmp_path, HEADER + GOOD * 20, angle=180, lift=3).motion
    for left in [*range(19), *range(18, -1, -1)]:
        motion.trains.add(1.0, left, left + 1, True)
    for left in range(2):
        motion.trains.add(2.0, left, left + 1, True)
    remark = "Write next: handle_collision, handle_two_bobs, newton_cradle_tick, main. Then the bobs collide."
    lines = players.screen(motion, players.TextPicture(), "0.6x real time", remark)
    assert len(lines) <= 24
    assert lines[0].startswith("t = 0.00 s")
    assert (" ".join(lines[1:3]), lines[3]) == (remark, "0.6x real time")
    _, latest, before, *rest = lines[lines.index("Impacts") :]
    assert (latest, len(before), rest) == ("t = 2.00 s  1-2-3", 80, ["", "", "", "Ctrl+C ends it."])
    assert before.startswith("t = 1.00 s  1-2-3-...-20  ")


# --- the picture -----------------------------------------------------------------------------------------------------


def draw(*thetas, columns=80, rows=20, picture=None):
    """Return the picture of equal pendula at these angles (degrees)."""
    pend_list = [
        hang(theta=radians(theta), axle=(i * R / 4, 0, 0)) for i, theta in enumerate(thetas)
    ]
    axles, bobs, cords = ([pend["objects"][part] for pend in pend_list] for part in range(3))
    cradle = SimpleNamespace(reach=R, axles=lambda: axles, bobs=lambda: bobs, cords=lambda: cords)
    return (picture or players.TextPicture()).lines(cradle, columns, rows)


def test_each_bob_is_in_its_place_on_a_cord_in_its_direction():
    """At 30 degrees, a cord of 8 lines ends one line higher, and 8 columns to the side."""
    assert draw(0, 0, 0) == [
        " " * 16 + line for line in ["=+===+===+=", *[" |   |   |"] * 7, "(1) (2) (3)"]
    ]
    lines = draw(-30, 0, 30)
    assert lines[7:] == ["        (1)          |          (3)", "                    (2)"]
    assert [lines[4].count(stroke) for stroke in "/|\\"] == [1, 1, 1]
    assert draw(90)[0] == "                =+=-------------(1)"
    assert draw(-90)[0] == "(1)-------------=+="
    assert draw(45)[3].strip("/ ") == "\\\\"
    assert draw(-45)[3].strip("\\ ") == "//"


def test_the_space_above_the_axles_comes_into_view_and_stays():
    picture = players.TextPicture()
    assert len(draw(0, picture=picture)) == 9
    lines = draw(180, picture=picture)
    assert (lines[0].strip(), lines[8].strip(), len(lines)) == ("(1)", "=+=", 17)
    assert len(draw(0, picture=picture)) == 17


def test_a_picture_fits_and_is_ascii():
    for count, theta, columns, rows in product([1, 5, 50], [-180, -90, 30], [20, 80], [3, 14]):
        lines = draw(*[theta] * count, columns=columns, rows=rows)
        assert (len(lines) <= rows, max(map(len, lines)) <= columns, "".join(lines).isascii()) == (
            True,
            True,
            True,
        )


@pytest.mark.parametrize(
    ("count", "name"), [(1, "(1)"), (3, "(3)"), (12, "(12)"), (13, "O"), (20, "O")]
)
def test_bobs_have_numbers_while_there_is_room_and_hang_under_their_cords(count, name):
    *_, above, bottom = draw(*[0] * count)
    names = bottom.replace(")(", ") (").split()
    assert (len(names), names[-1]) == (count, name)
    middles = [
        (match.start() + match.end() - 1) // 2 for match in re.finditer(r"\(\d+\)|O", bottom)
    ]
    cords = [match.start() for match in re.finditer(r"\|", above)]
    assert all(abs(middle - cord) <= 1 for middle, cord in zip(middles, cords, strict=True))
    # Unequal gaps look like groups of bobs
    assert len({right - left for left, right in pairwise(cords)}) <= 1


@pytest.mark.parametrize(
    ("dt", "line", "count", "last", "every"),
    [
        (DT, "0.025", 3, 0.02, 0.01),
        (DT, "0.3 --every 0.1", 4, 0.3, 0.1),
        (DT, "0.02 --every 0.0007", 29, 0.0196, 0.0007),
        (3e-4, "1.4", 142, 1.3959, 0.0099),  # nearer to 0.01 than 0.0102
        (7e-4, "1.4", 143, 1.3916, 0.0098),
    ],
)
def test_a_row_is_recorded_at_each_multiple_up_to_the_end(
    main, csv, monkeypatch, dt, line, count, last, every
):
    """With any tick. The progress is reported however rare the rows are."""
    parts = []
    monkeypatch.setattr(Cradle, "dt", dt)
    monkeypatch.setattr(players, "progress_bar", lambda: nullcontext(parts.append))
    data, release = csv.with_name("data.csv"), ["--lift", 2, "--angle", 20]
    words = f"{count} rows, from t = 0 to {last:g} s, are in {data}\n"
    assert main(csv, "--record", data, *release, "--seconds", *line.split()) == (0, words, "")
    table = pd.read_csv(data)
    assert table["t"].to_list() == pytest.approx([every * i for i in range(count)])
    assert table.loc[0, ["theta_1", "theta_2", "theta_3"]].to_list() == [
        outwards_to_angle(20),
        outwards_to_angle(20),
        0,
    ]
    assert (len(parts), parts[-1]) == (max(1, round(last / (players.BATCH * dt))), 1)


def test_a_recording_can_be_the_output_and_all_words_are_then_elsewhere(main, csv, monkeypatch):
    monkeypatch.chdir(csv.parent)
    monkeypatch.setattr(
        text_cradle_run, "what_there_is", lambda loop, scope: (loop, "Write next: main.")
    )
    arguments = csv, "--seconds", "0.02", "--record"
    main(*arguments, "./-")
    assert main(*arguments, "-") == (0, Path("-").read_text(), "Write next: main.\n")
    monkeypatch.setattr(players.Recorder, "note", Mock(side_effect=KeyboardInterrupt(1)))
    assert main(*arguments, "-")[2] == "Write next: main.\nThe recording ended too early.\n"


def test_a_recording_that_is_ended_early_leaves_the_old_file(main, csv, monkeypatch):
    data = csv.with_name("data.csv")
    data.write_text("t,theta_1,momentum\n")
    monkeypatch.setattr(players.Recorder, "note", Mock(side_effect=KeyboardInterrupt(143)))
    line = f"The recording ended too early. {data} is not written.\n"
    assert main(csv, "--record", data, "--seconds", "1") == (1, "", line)
    assert sorted(path.name for path in csv.parent.iterdir()) == ["cradle.csv", "data.csv"]
    assert data.read_text() == "t,theta_1,momentum\n"


@pytest.mark.parametrize(
    ("columns", "seconds", "width"), [(None, 40, 0), (80, 1.9, 0), (80, 40, 40), (26, 40, 1)]
)
def test_a_terminal_shows_a_progress_bar_after_two_seconds(monkeypatch, columns, seconds, width):
    monkeypatch.setattr(sys, "stderr", StringIO())
    monkeypatch.setattr(sys.stderr, "isatty", lambda: columns is not None, raising=False)
    monkeypatch.setenv("COLUMNS", str(columns or 80))
    now = 0.0
    with output.progress_bar(lambda: now) as progress:
        for number in range(1, 10_001):
            now += seconds / 10_000
            progress(number / 10_000)
    printed = sys.stderr.getvalue()
    bars = re.findall(r"\r\[(#* *)\] +(\d+)%, (\d+) s left", printed)
    assert len(bars) == pytest.approx(20 * (seconds - 2) if width else 0, rel=0.05)  # 20 a second
    for bar, percent, left in bars:
        assert (len(bar), bar.count("#")) == (
            width,
            pytest.approx(width * int(percent) / 100, abs=1),
        )
        assert int(left) == pytest.approx(seconds * (100 - int(percent)) / 100, abs=1.5)
    assert max(map(len, printed.split("\r"))) < (columns or 80)
    assert printed.endswith("\r\x1b[K" if width else "")


def test_the_program_refuses_in_one_line(main, csv):
    for option, value, words in (
        ("--lift", "9", "allowed is at most 5"),
        ("--record", str(csv), "which has no data"),
    ):
        status, out, err = main(csv, option, value, "--seconds", "1")
        assert (status, out, err.count("\n")) == (2, "", 1)
        assert err.startswith(f"{option}: found '{value}', {words}")
