"""Before and after a program: its Python, signals, and how it ends."""

import ast
import errno
import signal
import sys
from io import BytesIO, TextIOWrapper
from unittest.mock import Mock

import pytest
from programs import call, ROOT

from support.start import end
from support.start.program import require_python


def test_an_older_python_is_named_and_compiles_the_files_that_do_so(monkeypatch):
    for file in ("src/begin.py", "support/start/program.py"):
        ast.parse((ROOT / file).read_text(), feature_version=(3, 6))
    monkeypatch.setattr(sys, "version_info", (3, 10, 14))
    with pytest.raises(SystemExit, match=r"^Newton's cradle needs Python 3\.11 or later; .* is 3"):
        require_python()


@pytest.mark.parametrize(
    ("error", "printed"),
    [
        (OSError(errno.EACCES, "Permission denied", "a.csv"), "a.csv: Permission denied\n"),
        (OSError(errno.ENOSPC, "No space left"), "The output: No space left\n"),
    ],
)
def test_an_error_of_a_file_is_one_line(capsys, error, printed):
    @end.ended_quietly()
    def main():
        raise error

    assert call(main, capsys) == (2, "", printed)


def test_a_pipe_that_is_closed_at_the_end_ends_a_program_quietly(monkeypatch):
    monkeypatch.setattr(sys, "stdout", Mock(flush=Mock(side_effect=BrokenPipeError)))
    with end.ended_quietly():
        pass
    print("lost", flush=True)


def test_letters_that_an_output_lacks_end_no_program(monkeypatch):
    written = BytesIO()
    monkeypatch.setattr(sys, "stdout", TextIOWrapper(written, encoding="ascii"))
    with end.ended_quietly():
        print("\u03c9 = 1")
    assert written.getvalue() == b"? = 1\n"


@pytest.mark.parametrize("number", end.STATUSES)
def test_a_signal_ends_a_program_with_its_status_and_the_handlers_are_put_back(number):
    """128 + the number, as in a shell; Ctrl+C is the usual end, with 0.

    The next signal ends the process, also if a function of a student catches this one.
    """

    def handlers():
        return [signal.getsignal(number) for number in end.STATUSES]

    before = handlers()
    with end.ended_quietly():
        with pytest.raises(SystemExit) as ended:
            signal.raise_signal(number)
        assert {*handlers()} == {signal.SIG_DFL}
    assert ended.value.code == (0 if number == signal.SIGINT else 128 + number)
    assert handlers() == before


def test_a_signal_that_is_ignored_stays_ignored():
    """As with nohup."""
    before = signal.signal(signal.SIGTERM, signal.SIG_IGN)
    with end.ended_quietly():
        signal.raise_signal(signal.SIGTERM)
    assert signal.signal(signal.SIGTERM, before) == signal.SIG_IGN
