"""Before and after main: slow modules, commands to type, the output, signals."""

import errno
import io
import os
import shlex
import subprocess
import sys
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import pytest
from programs import call, on_posix, ROOT

from support.start import commands
from support.start.early import end_on_signals, import_later, import_now, stop_on_signals
from support.start.output import complain, say, while_it_is_read


def test_a_slow_module_is_imported_once_when_it_is_used(tmp_path, monkeypatch):
    (tmp_path / "slow_module.py").write_text("import sys\nsys.slow_imports.append(1)\nvalue = 7\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "slow_imports", imports := [], raising=False)
    monkeypatch.delitem(sys.modules, "slow_module", raising=False)
    import_later("slow_module")
    early = import_module("slow_module")
    assert find_spec("slow_module").name == "slow_module"  # for the next program in a session
    assert imports == []
    assert early.value == early.value == 7
    assert imports == [1]
    monkeypatch.delitem(sys.modules, "slow_module")
    import_later("slow_module")
    import_now("slow_module")  # for which the page waits while the browser loads
    assert imports == [1, 1]
    import_later("no_such_module")
    assert "no_such_module" not in sys.modules


def test_a_command_to_type_starts_this_python_from_the_folder_of_the_start(monkeypatch):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(sys, "executable", str(ROOT / ".venv" / "python"))
    monkeypatch.setattr(commands, "FOLDER", ROOT)
    assert commands.checks_command() == ".venv/python -m pytest"
    program = commands.python_command(ROOT / "src" / "x.py", "--e", "0.9", "my cradle.csv")
    assert program == ".venv/python src/x.py --e 0.9 'my cradle.csv'"
    monkeypatch.setattr(commands, "FOLDER", ROOT / "src")
    assert commands.checks_command() == f"{ROOT}/.venv/python -m pytest {ROOT}/tests"
    monkeypatch.setattr(sys, "platform", "win32")
    assert commands.python_command("a b.csv").endswith(' "a b.csv"')


@pytest.mark.parametrize(
    ("system", "number", "file", "printed"),
    [
        ("win32", errno.EINVAL, [], ""),  # nobody reads it on
        ("win32", errno.EINVAL, ["data.csv"], "data.csv: it failed\n"),
        ("win32", errno.ENOSPC, [], "The output: it failed\n"),
        ("linux", errno.EINVAL, [], "The output: it failed\n"),
    ],
)
def test_an_unread_output_on_windows_ends_a_program_quietly(
    monkeypatch, capsys, system, number, file, printed
):
    @while_it_is_read()
    def main():
        raise OSError(number, "it failed", *file)

    monkeypatch.setattr(sys, "platform", system)
    assert call(main, capsys) == (2 if printed else 0, "", printed)


@on_posix
@pytest.mark.parametrize(
    ("does", "redirection", "status", "line"),
    [
        ("print(1)", "", 0, ""),
        ("print(1)", ">&-", 0, ""),
        ("sys.stdin.read()", "<&-", 0, ""),
        ("print(1)", ">/dev/full", 2, "The output: No space left on device\n"),
        ("refuse('no')", "2>/dev/full", 2, ""),
    ],
)
def test_an_output_that_is_closed_or_full_or_unread_gives_one_line_at_most(
    does, redirection, status, line
):
    if "/dev/full" in redirection and not Path("/dev/full").exists():
        pytest.skip("macOS has no /dev/full")
    does = f"from support.start.output import *\nwith while_it_is_read(): {does}"
    command = f"unset PYTHONUNBUFFERED; {shlex.join([sys.executable, '-c', does])} {redirection}"
    reader, writer = os.pipe()
    os.close(reader)
    with open(writer) as unread:
        done = subprocess.run(
            ["sh", "-c", command], cwd=ROOT, stdout=unread, stderr=subprocess.PIPE, text=True
        )
    assert (done.returncode, done.stderr) == (status, line)


def test_letters_that_the_output_lacks_are_written_out_and_without_an_output_the_program_goes_on(
    monkeypatch,
):
    """A pipe on Windows has the letters of one language.

    IDLE's shell has all, and no way to say so.
    """
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(io.BytesIO(), encoding="cp1252"))
    with while_it_is_read():
        say("\u03c9")
    assert sys.stdout.buffer.getvalue().split() == [b"\\u03c9"]
    closed = Mock(spec=["write", "flush"], **{"write.side_effect": BrokenPipeError})
    monkeypatch.setattr(sys, "stdout", closed)
    monkeypatch.setattr(sys, "stderr", closed)
    with while_it_is_read():
        say("the address")
        complain("a mistake")


@pytest.fixture
def handlers(monkeypatch):
    """The handlers of signals, by their numbers; nohup lets a program ignore SIGHUP."""
    handlers = {1: "ignored"}
    signals = {"SIGHUP": 1, "SIGINT": 2, "SIGQUIT": 3, "SIGTERM": 15, "SIG_IGN": "ignored"}
    module = SimpleNamespace(**signals, getsignal=handlers.get, signal=handlers.__setitem__)
    monkeypatch.setattr("support.start.early.signal", module)
    return handlers


@pytest.mark.parametrize(("number", "status"), [(2, 0), (3, 131), (15, 143)])
def test_each_signal_ends_a_program_once_with_its_status(handlers, number, status):
    """128 + its number, as in a shell; Ctrl+C is the usual end, with 0."""
    stop_on_signals()
    assert handlers[1] == "ignored"
    handle = handlers[number]
    with pytest.raises(KeyboardInterrupt, match=f"^{status}$"):
        handle(number, None)
    handle(number, None)  # a second signal has come before the first one was handled
    assert {*handlers.values()} == {"ignored"}  # nothing interrupts the clean-up


def test_a_signal_while_a_program_starts_ends_it_at_once(handlers, monkeypatch):
    events = []
    monkeypatch.setattr("os._exit", events.append)
    end_on_signals(first=lambda: events.append("first"))
    handlers[15](15, None)
    assert events == ["first", 143]


def test_in_a_session_signals_stay_as_they_are(handlers, monkeypatch):
    """As in IPython and python -i."""
    monkeypatch.setattr(sys, "ps1", ">>> ", raising=False)
    stop_on_signals()
    assert handlers == {1: "ignored"}
