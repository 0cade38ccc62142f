"""The cradle in the terminal: its pictures, messages, timing, and files."""

import csv
import os
import re
import select
import shlex
import signal
import struct
import subprocess
import sys
import time
from contextlib import suppress
from io import StringIO
from itertools import product
from math import radians
from types import SimpleNamespace

import pandas as pd
import pytest
from programs import copy_project, end, QUIETLY, refusal, ROOT, running, SECONDS
from whole_cradles import FIVE_CSV, GOOD, HEADER, make_live, make_swing, PERIOD

from grading.cradles import MIXED_CSV
from src.special_cradles import make_newton_cradle
from src.visualize_cradle_run import main as cradle_main
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.files.cradle_csv import Snapshot
from support.pendulum import from_lift
from support.playback.real_time import RealTime
from support.terminal import players, recorder
from support.terminal.picture import TextPicture
from support.terminal.screen import screen

PROGRAM = ROOT / "src" / "text_cradle_run.py"
posix = pytest.mark.skipif(os.name != "posix", reason="terminals and signals as on Linux and macOS")


@pytest.fixture
def five(tmp_path):
    """The path of a CSV with five equal bobs."""
    file = tmp_path / "five.csv"
    file.write_text(FIVE_CSV)
    return str(file)


def text_player(folder, kind, seconds):
    """Return a player of this kind for `seconds`, with five equal bobs that start at 30 degrees."""
    (folder / "cradle.csv").write_text(FIVE_CSV)
    csv = Snapshot(folder / "cradle.csv")
    return kind(make_live(), csv, SimpleNamespace(angle=from_lift(30), lift=1, seconds=seconds))


# --- keeping time ----------------------------------------------------------------------------------------------------


class Wall(players.TextPlayer):
    """A player with a clock on which only sleeping takes time."""

    def __init__(self, folder, seconds, step):
        self.step_seconds, self.now = step, 50.0
        (folder / "cradle.csv").write_text(HEADER + GOOD)
        csv = Snapshot(folder / "cradle.csv")
        super().__init__(make_live(), csv, SimpleNamespace(angle=from_lift(30), lift=1, seconds=seconds))
        self.pace = RealTime(self.cradle.dt, lambda: self.now, self.sleep)
        self.at_once = True
        self.shown = []  # (real s, simulated s)

    def sleep(self, seconds):
        self.now += max(seconds, 1e-4)
        assert self.now < 200, "it never ends"

    def note(self):
        self.shown.append((self.now - 50, self.motion.time()))


@pytest.mark.parametrize(("seconds", "step", "times"), [(10, 0.05, 201), (10, 0.5, 21), (0.72, 0.5, 3)])
def test_it_keeps_time_and_shows_each_step(tmp_path, seconds, step, times):
    wall = Wall(tmp_path, seconds, step)
    cradle_main(wall)
    assert [simulated for _, simulated in wall.shown[:-1]] == pytest.approx([step * i for i in range(times - 1)])
    assert wall.shown[-1][1] == pytest.approx(seconds)
    assert len(wall.shown) == times
    for on_the_wall, simulated in wall.shown:
        assert simulated == pytest.approx(on_the_wall, abs=2 / 60)


def test_time_before_the_start_does_not_count(tmp_path):
    wall = Wall(tmp_path, 1, 0.5)
    wall.now += 5
    cradle_main(wall)
    assert wall.shown[-1][0] == pytest.approx(6, abs=2 / 60)


@pytest.mark.parametrize("kind", [players.Lines, players.Pictures])
def test_half_a_second_is_no_less_on_the_wall(tmp_path, kind):
    begin = time.monotonic()
    cradle_main(text_player(tmp_path, kind, 0.5))
    assert time.monotonic() - begin > 0.45


# --- without a terminal ----------------------------------------------------------------------------------------------


def test_into_a_pipe_it_says_a_line_each_half_second_without_vpython(run, five):
    seconds = 0.7 + PERIOD / 2  # after the hits have run through the row and back
    done = run(str(PROGRAM), five, "--seconds", str(seconds), "--angle", "30", "--elastic")
    assert (done.returncode, done.stderr) == (0, "")
    times = [*(f"{0.5 * i:.2f}" for i in range(int(2 * seconds) + 1)), f"{seconds:.2f}"]
    for line, at in zip(done.stdout.splitlines(), times, strict=True):
        state = r"energy (99.9\d|100.\d\d) %, pendulum (1 at \d+ degrees left|5 at \d+ degrees right)"
        assert re.fullmatch(rf"t = {at} s, {state}(, hits: [\d ,-]+|, many hits)?", line)
    assert done.stdout.startswith("t = 0.00 s, energy 100.00 %, pendulum 1 at 30 degrees left\n")
    assert done.stdout.index("hits: 1-2-3-4-5") < done.stdout.index("5-4-3")


def test_lines_are_at_most_80_columns_long(run, tmp_path):
    (tmp_path / "20.csv").write_text(HEADER + GOOD * 20)
    done = run(str(PROGRAM), str(tmp_path / "20.csv"), "--seconds", str(PERIOD / 3), "--lift", "4")
    assert max(map(len, done.stdout.splitlines())) <= 80
    assert done.stdout.endswith(", many hits\n")


def test_the_latest_hits_are_told_in_their_order(tmp_path):
    motion = make_swing(tmp_path).motion
    motion.trains.add(0.1, 0, 1, True)
    motion.trains.add(0.3, 3, 4, False)
    assert players.summary(motion).endswith(" left, hits: 1-2, 5-4")


def test_a_bob_that_has_gone_round_is_told_of_where_it_is(tmp_path):
    motion = make_swing(tmp_path, lift=0).motion
    motion.cradle.pend_list[1]["theta"] = radians(360 * 3 + 20)
    assert "pendulum 2 at 20 degrees right" in players.summary(motion)


@posix
def test_it_ends_quietly_when_nobody_reads_on(five):
    with running(PROGRAM, five) as process:
        assert process.stdout.readline().startswith("t = 0.00 s")
        process.stdout.close()
        assert process.wait(SECONDS) == 0
        assert process.stderr.read() == ""


@posix
def test_ctrl_c_ends_the_lines_quietly(five):
    with running(PROGRAM, five) as process:
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        status, _, stderr = end(process)
    assert (status, stderr) == (0, "")


# --- on a terminal ---------------------------------------------------------------------------------------------------


class Terminal:
    """A program in its own terminal, for the body of a with statement."""

    def __init__(self, *arguments, command=(sys.executable, str(PROGRAM)), lines=24, columns=80, term="xterm"):
        import pty

        self.said, self.deadline = "", time.monotonic() + SECONDS
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            try:
                self.resize(0, lines, columns)
                sizes = {"LINES", "COLUMNS"}  # they would hide the size of the terminal
                environment = {name: value for name, value in os.environ.items() if name not in sizes}
                os.execvpe(command[0], [*command, *arguments], {**environment, "TERM": term})
            finally:
                os._exit(127)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.terminal)
        with suppress(ProcessLookupError, ChildProcessError):
            os.kill(self.process, signal.SIGKILL)
            os.waitpid(self.process, 0)

    @staticmethod
    def resize(descriptor, lines, columns):
        import fcntl
        import termios

        fcntl.ioctl(descriptor, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))

    def read_until(self, condition):
        """Read until condition(text so far) holds, or the program ends; return whether it holds."""
        while not condition(self.said):
            assert time.monotonic() < self.deadline, self.said
            if select.select([self.terminal], [], [], 1)[0]:
                data = b""
                with suppress(OSError):  # on Linux, this means that the program has ended; macOS reads nothing
                    data = os.read(self.terminal, 65536)
                if not data:
                    return condition(self.said)
                self.said += data.decode()
        return True

    def end(self, keys=b""):
        """Press these keys, wait for the end of the program, and return its status and its last text."""
        os.write(self.terminal, keys)
        self.read_until(lambda said: False)
        return self.status(), self.said.rpartition(RESTORED)[2]

    def status(self):
        """Wait for the end of the program, and return its status."""
        ended = 0, 0
        while not ended[0]:
            assert time.monotonic() < self.deadline
            time.sleep(0.02)
            ended = os.waitpid(self.process, os.WNOHANG)
        return os.waitstatus_to_exitcode(ended[1])


def pictures(said):
    """Return all complete pictures, each as a list of lines."""
    return [re.sub(r"\x1b\[K", "", text).splitlines() for text in re.findall(r"\x1b\[H(.*?)\x1b\[J", said, re.DOTALL)]


HOME, TAKEN, RESTORED = "\x1b[H", "\x1b[?1049h\x1b[?25l", "\x1b[?25h\x1b[?1049l"


@posix
def test_on_a_terminal_a_picture_moves_until_ctrl_c(five):
    with Terminal(five, "--angle", "40") as terminal:
        assert terminal.read_until(lambda said: said.count(HOME) > 8 and "1-2-3-4-5" in said)
        status, last_words = terminal.end(b"\x03")
    assert status == 0
    seen = pictures(terminal.said)
    times = [re.match(r"t = (\d+\.\d\d) s +energy", picture[0])[1] for picture in seen]
    assert times[:8] == ["0.00", "0.05", "0.10", "0.15", "0.20", "0.25", "0.30", "0.35"]
    assert {len(picture) for picture in seen} == {len(seen[0])}
    assert len({picture[8] for picture in seen}) > 2  # a line with bobs that swing
    assert max(map(len, seen[0])) <= 80
    assert seen[0][-1] == "Ctrl+C ends it."
    left = last_words.replace("\r", "").splitlines()
    if left[0] != seen[-1][0]:  # Ctrl+C came just before the next picture, so that picture stays on the screen
        assert float(left[0].split()[2]) == pytest.approx(float(seen[-1][0].split()[2]) + 0.05)
    else:
        assert left == seen[-1]
    assert (len(left), left[-1]) == (len(seen[-1]), "Ctrl+C ends it.")
    assert last_words.isascii()


@posix
@pytest.mark.parametrize(("lines", "columns"), [(18, 40), (17, 80), (5, 20)])
def test_the_picture_is_as_large_as_the_terminal_allows(five, lines, columns):
    with Terminal(five, "--seconds", "0.1", lines=lines, columns=columns) as terminal:
        assert terminal.end()[0] == 0
    for picture in pictures(terminal.said):
        assert len(picture) <= lines
        assert max(map(len, picture)) <= columns
        assert any(re.search(r"=(\+=*){5}$", line) for line in picture)
        assert picture[0].startswith("t = 0.")


@pytest.mark.parametrize("count", [1, 5])
def test_the_lines_fit_into_a_terminal_of_any_size(tmp_path, monkeypatch, count):
    motion = make_swing(tmp_path, HEADER + GOOD * count, angle=170).motion
    motion.trains.add(1.0, 0, 1, True)
    for rows, columns in product([1, 2, 3, 4, 17, 18, 19], [*range(1, 12), 40]):
        monkeypatch.setattr("shutil.get_terminal_size", lambda size=(columns, rows): os.terminal_size(size))
        for remark in ("", "Write next: handle_collision."):
            lines = screen(motion, TextPicture(), "x0.6", remark)
            assert 1 <= len(lines) <= rows
            assert max(map(len, lines)) <= columns
            assert lines[0] == motion.reading()[:columns].rstrip()


def test_a_terminal_that_does_not_know_its_size_gets_a_whole_picture(tmp_path, monkeypatch):
    """Python 3.10 then returns 0."""
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size((0, 0)))
    lines = screen(make_swing(tmp_path).motion, TextPicture(), "")
    assert (lines[0][:8], lines[-1]) == ("t = 0.00", "Ctrl+C ends it.")


@posix
def test_a_terminal_may_become_small_while_it_runs(five):
    with Terminal(five) as terminal:
        assert terminal.read_until(lambda said: HOME in said)
        terminal.resize(terminal.terminal, 1, 1)
        assert terminal.read_until(lambda said: ["t"] in pictures(said))
        terminal.resize(terminal.terminal, 2, 9)
        assert terminal.read_until(lambda said: any(len(picture[0]) == 9 for picture in pictures(said)))
        assert terminal.end(b"\x03")[0] == 0


def test_a_screen_of_its_own_is_cleared_line_by_line_and_given_back(tmp_path, capsys):
    players.show_pictures(cradle_main, text_player(tmp_path, players.Pictures, 0.1))
    said, _, last_words = capsys.readouterr().out.partition(RESTORED)
    assert said.startswith("\x1b[?1049h\x1b[?25l\x1b[H")
    assert said.count("\x1b[H") == said.count("\x1b[J") == 3
    assert said.count("\n\x1b[K") == said.count("\n")
    assert last_words.splitlines() == pictures(said)[-1]


def test_what_is_to_be_seen(tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size((200, 24)))
    player = make_swing(tmp_path, HEADER + GOOD * 20, angle=180, lift=3)
    player.swing(1)
    motion = player.motion
    motion.trains.clear()
    for left in [*range(19), *range(18, -1, -1)]:
        motion.trains.add(1.0, left, left + 1, True)
    motion.trains.add(2.0, 0, 1, True)
    lines = screen(motion, TextPicture(), "x0.6")
    assert lines[0].endswith(" %)   x0.6")
    impacts = lines.index("Impacts")
    assert lines[impacts + 1] == "t = 2.00 s  1-2"
    assert lines[impacts + 2].startswith("t = 1.00 s  1-2-3-...-20  ")
    assert len(lines[impacts + 2]) == 80
    assert lines[impacts + 3 :] == ["", "", "", "Ctrl+C ends it."]
    motion = make_swing(tmp_path, angle=180).motion
    assert len(screen(motion, TextPicture(), "")) in (23, 24)
    remark = "Write next: handle_collision, handle_two_bobs, newton_cradle_tick, main. Then the bobs collide."
    lines = screen(motion, TextPicture(), "", remark)
    assert " ".join(lines[1:3]) == remark
    assert len(lines) <= 24
    assert lines[-1] == "Ctrl+C ends it."


@posix
def test_a_terminal_that_cannot_move_its_cursor_gets_lines(five):
    with Terminal(five, "--seconds", "0.1", term="dumb") as terminal:
        assert terminal.end()[0] == 0
    assert "\x1b" not in terminal.said
    assert terminal.said.startswith("t = 0.00 s, energy")


@posix
def test_however_often_ctrl_c_is_pressed_the_terminal_is_restored(five):
    """The test sends signals: at Ctrl+C, a terminal also deletes text that was not read yet."""
    with Terminal(five) as terminal:
        assert terminal.read_until(lambda said: HOME in said)
        for _ in range(4):
            os.kill(terminal.process, signal.SIGINT)
        status, last_words = terminal.end()
    assert (status, last_words[:4]) == (0, "t = ")


@posix
@pytest.mark.parametrize("name", ["SIGQUIT", "SIGTERM", "SIGHUP"])
def test_what_ends_it_otherwise_restores_the_terminal_too(five, name):
    number = getattr(signal, name)
    with Terminal(five) as terminal:
        assert terminal.read_until(lambda said: HOME in said)
        if name != "SIGQUIT":
            os.kill(terminal.process, number)
        status, last_words = terminal.end(b"\x1c" if name == "SIGQUIT" else b"")  # Ctrl+\
    assert (status, last_words[:4]) == (128 + number, "t = ")
    assert "Traceback" not in terminal.said


@posix
def test_a_terminal_that_is_closed_ends_it(five):
    with Terminal(five) as terminal:
        assert terminal.read_until(lambda said: HOME in said)
        os.close(terminal.terminal)
        terminal.terminal = os.open(os.devnull, os.O_RDONLY)
        assert terminal.status() == 128 + signal.SIGHUP


@posix
def test_ctrl_z_gives_the_terminal_back_until_fg(five):
    program = shlex.join([sys.executable, str(PROGRAM), five])
    with Terminal(f'{program}; echo "stopped: $?"; fg; echo "ended: $?"', command=("sh", "-mc")) as terminal:
        assert terminal.read_until(lambda said: HOME in said)
        os.write(terminal.terminal, b"\x1a")
        assert terminal.read_until(lambda said: HOME in said.partition("stopped:")[2])
        _, last_words = terminal.end(b"\x03")
    before, status, after = terminal.said.partition(f"stopped: {128 + signal.SIGTSTP}\r\n")
    assert status
    assert before.count(TAKEN) == before.count(RESTORED) == after.count(TAKEN) == after.count(RESTORED) == 1
    assert HOME not in before.partition(RESTORED)[2]
    assert HOME not in after.partition(TAKEN)[0]
    assert last_words.endswith("ended: 0\r\n")


# --- data ------------------------------------------------------------------------------------------------------------


def test_what_is_recorded_is_what_so_many_ticks_do(run, tmp_path):
    (tmp_path / "mixed.csv").write_text(MIXED_CSV)
    data = tmp_path / "data.csv"
    done = run(str(PROGRAM), str(tmp_path / "mixed.csv"), "--record", str(data), "--seconds", "0.5", "--every", "0.05")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"11 rows, from t = 0 to 0.5 s, are in {data}\n"
    header, *rows = csv.reader(StringIO(data.read_text()))
    assert header[:8] == ["t", "theta_1", "theta_2", "theta_3", "omega_1", "omega_2", "omega_3", "kinetic"]
    assert [row[0] for row in rows] == ["0.0", *(f"{0.05 * i:.2f}".rstrip("0") for i in range(1, 11))]
    pend_list = make_newton_cradle(str(tmp_path / "mixed.csv"), R_PARAM, THETA_INIT)
    for row in rows:
        assert list(map(float, row[1:7])) == [pend[key] for key in ("theta", "omega") for pend in pend_list]
        for _ in range(round(0.05 / DT)):
            newton_cradle_tick(pend_list, R_PARAM, DT, G, approaching_only=True)


def test_the_options_of_the_cradle_count(run, tmp_path):
    csv_file, data = tmp_path / "lossy.csv", tmp_path / "data.csv"
    csv_file.write_text(HEADER + GOOD.replace("1.0,1.0", "1.0,0.5") * 3)

    def record(*options):
        done = run(str(PROGRAM), str(csv_file), "--record", str(data), "--seconds", str(PERIOD / 2), *options)
        assert (done.returncode, done.stderr) == (0, "")
        return pd.read_csv(data)

    plain, elastic, heavy, lifted = record(), record("--elastic"), record("--mass", "2"), record("--lift", "2")
    assert plain["total"].iloc[-1] < 0.9 * plain["total"][0]
    assert elastic["total"].iloc[-1] > 0.99 * elastic["total"][0]
    assert heavy["total"].to_numpy() == pytest.approx(2 * plain["total"].to_numpy())
    assert lifted.loc[0, ["theta_1", "theta_2", "theta_3"]].to_list() == [THETA_INIT, THETA_INIT, 0]


@pytest.mark.parametrize(
    ("seconds", "every", "count", "last"), [(0.3, 0.1, 4, 0.3), (0.35, 0.1, 4, 0.3), (0.02, 0.0007, 29, 0.0196)]
)
def test_rows_are_where_they_should_be(tmp_path, capsys, seconds, every, count, last):
    data, csv = tmp_path / "data.csv", tmp_path / "cradle.csv"
    csv.write_text(FIVE_CSV)
    options = SimpleNamespace(seconds=seconds, every=every, record=str(data), angle=from_lift(30), lift=1)
    recorder.record(cradle_main, make_live(), Snapshot(csv), options)
    assert capsys.readouterr().out == f"{count} rows, from t = 0 to {last:g} s, are in {data}\n"
    assert pd.read_csv(data)["t"].to_list() == pytest.approx([every * i for i in range(count)])


def test_a_row_is_for_a_hundredth_of_a_second(run, five, tmp_path):
    data = tmp_path / "data.csv"
    run(str(PROGRAM), five, "--record", str(data), "--seconds", "0.1")
    assert [line.partition(",")[0] for line in data.read_text().splitlines()[1:4]] == ["0.0", "0.01", "0.02"]
    assert len(data.read_text().splitlines()) == 12


@posix
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_what_is_ended_early_is_not_written(name, five, tmp_path):
    data = tmp_path / "data.csv"
    data.write_text("t,theta_1,momentum\n")
    with running(PROGRAM, five, "--record", str(data), "--seconds", "100000") as process:
        give_up = time.monotonic() + SECONDS
        while len(os.listdir(tmp_path)) == 2:
            assert time.monotonic() < give_up
        process.send_signal(getattr(signal, name))
        assert end(process) == (1, "", f"The recording ended too early. {data} is not written.\n")
    assert sorted(os.listdir(tmp_path)) == ["data.csv", "five.csv"]
    assert data.read_text() == "t,theta_1,momentum\n"


@posix
def test_a_recording_outlives_the_terminal_with_nohup(five, tmp_path):
    data = tmp_path / "data.csv"
    shell = f"trap '' HUP; exec {sys.executable} {PROGRAM} {five} --record {data} --seconds 20"
    with subprocess.Popen(["sh", "-c", shell], stdout=subprocess.PIPE, text=True) as process:
        give_up = time.monotonic() + SECONDS
        while len(os.listdir(tmp_path)) == 1:
            assert time.monotonic() < give_up
        process.send_signal(signal.SIGHUP)
        assert process.communicate(timeout=SECONDS)[0].startswith("2001 rows")
        assert process.returncode == 0


def test_no_progress_bar_gets_into_a_log(monkeypatch):
    monkeypatch.setattr(sys, "stderr", StringIO())
    times = iter(range(10**6))
    with recorder.progress_bar(lambda: next(times)) as progress:
        progress(0.5)
        progress(1.0)
    assert sys.stderr.getvalue() == ""


def test_the_progress_bar_is_redrawn_twenty_times_a_second(monkeypatch):
    monkeypatch.setattr(sys, "stderr", Screen())
    now = 0.0
    with recorder.progress_bar(lambda: now) as progress:
        for number in range(1, 10_001):
            now += 1e-3
            progress(number / 10_000)
    assert sys.stderr.getvalue().count("[#") == pytest.approx(8 * 20, abs=5)


class Screen(StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize(("seconds", "shown"), [(1.9, False), (40, True)])
@pytest.mark.parametrize("columns", [80, 50, 26])
def test_a_progress_bar_is_shown_when_it_takes_more_than_two_seconds(monkeypatch, seconds, shown, columns):
    monkeypatch.setattr(sys, "stderr", Screen())
    monkeypatch.setenv("COLUMNS", str(columns))
    now = 0.0
    with recorder.progress_bar(lambda: now) as progress:
        for number in range(1, 101):
            now += seconds / 100
            progress(number / 100)
    said = sys.stderr.getvalue()
    assert bool(said) == shown
    if shown:
        bars = re.findall(r"\r\[(#* *)\] +(\d+)%, (\d+) s left", said)
        assert len(bars) > 50
        for bar, percent, left in bars:
            assert len(bar) == min(40, columns - 25)
            assert bar.count("#") == len(bar) * int(percent) // 100
            assert int(left) == pytest.approx(seconds * (100 - int(percent)) / 100, abs=1.5)
        assert max(map(len, said.split("\r"))) < columns
        assert said.endswith("\r\x1b[K")


def test_the_progress_is_told_however_rare_the_rows_are(tmp_path):
    file, written, parts = tmp_path / "cradle.csv", StringIO(), []
    file.write_text(HEADER + GOOD)
    options, writer = SimpleNamespace(seconds=10, every=5, angle=from_lift(30), lift=1), csv.writer(written)
    cradle_main(recorder.Recorder(make_live(), Snapshot(file), options, writer, parts.append))
    assert written.getvalue().count("\n") == 1 + 3
    assert parts == pytest.approx([number / 100 for number in range(1, 101)])


# --- refused options -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (["{folder}/none.csv"], "{folder}/none.csv: cannot be read as a CSV file: No such file or directory\n"),
        (["--lift", "9"], "--lift: found '9', allowed is at most 5, the number of pendula in {five}\n"),
        (
            ["--record", "{five}", "--seconds", "1"],
            "--record: found '{five}', which has no data of a cradle; allowed is a new file, or one with data of a "
            "cradle, to replace it\n",
        ),
        (
            ["--record", "{folder}/none/data.csv", "--seconds", "1"],
            "{folder}/none/data.csv: cannot be written: No such file or directory\n",
        ),
    ],
)
def test_what_it_refuses_in_one_line(arguments, line, five, tmp_path):
    names = {"folder": tmp_path, "five": five}
    arguments = [argument.format(**names) for argument in arguments]
    with running(PROGRAM, *([] if arguments[0].endswith("none.csv") else [five]), *arguments) as process:
        assert refusal(process) == line.format(**names)


def test_it_runs_on_the_shipped_cradle(tmp_path):
    program = copy_project(tmp_path, FIVE_CSV) / "src" / PROGRAM.name
    with running(program, "--record", str(tmp_path / "data.csv"), "--seconds", "0.01") as process:
        assert end(process)[0] == QUIETLY[0]
    assert (tmp_path / "data.csv").exists()
