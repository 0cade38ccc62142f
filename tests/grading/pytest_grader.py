"""The graded suites in pytest, as a plugin: each check is an item, and a screen ends a run.

pyproject.toml names the plugin. With pytest-xdist (-n 2), other processes run the tests and report
to the first one, which shows the table.
"""

import json
import os
import sys
import threading
from argparse import ArgumentTypeError
from collections.abc import Iterator
from pathlib import Path
from shutil import get_terminal_size
from typing import Any
from unittest.mock import patch

import grading.begin  # noqa: F401

import pytest

from grading.grade import checks_with_outcome, grade
from grading.grader import Check, CHECKS
from grading.handout import SUITES
from grading.outcomes import FAILED, FAULT, Grading, Outcome, PASSED, WAITING
from grading.present import present
from grading.screen import Line, report
from support.constants import NC_FP
from support.files.cradle_csv import Snapshot
from support.files.data_file import whole_file
from support.files.valid_cradle import read_cradle

GRADING = pytest.StashKey[Grading]()
OUTCOME = "outcome of a check"  # the name under which a report of pytest has it
RAN: dict[str, Outcome] = {}  # the outcomes of this run's checks, by name, as they are reported
TIERS = {tier.split()[0].upper(): tier for tier in SUITES}  # as --tier takes them


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("graded suites")
    text = "run the graded suite of one tier only: D, C, B, A or honor"
    group.addoption("--tier", type=tier_name, metavar="TIER", help=text)
    group.addoption("--grade-json", metavar="FILE", help="write the grade to FILE")


def tier_name(text: str) -> str:
    """Return the name of a tier as TIERS has it: HONOR for honor, and for "Honor roll"."""
    name = text.upper().partition(" ")[0]
    if name not in TIERS:
        raise ArgumentTypeError(f"found {text!r}, allowed is D, C, B, A or honor")
    return name


def pytest_configure(config: pytest.Config) -> None:
    if not __debug__:
        raise pytest.UsageError(
            "Run pytest without -O, -OO and PYTHONOPTIMIZE: with them, Python leaves out checks."
        )
    config.stash[GRADING] = Grading()
    RAN.clear()
    file = config.option.grade_json
    if file is not None and (Path(file).is_dir() or not Path(file).parent.is_dir()):
        raise pytest.UsageError(
            f"--grade-json: found {file!r}, allowed is a file in a folder that is there"
        )


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave out the files of other tiers, without reading them: an import in them may fail."""
    tier = config.option.tier
    if tier and collection_path.is_file() and collection_path.stem != SUITES[TIERS[tier]]:
        return True
    return None


def pytest_pycollect_makeitem(collector: pytest.Collector, name: str, obj: object) -> "Item | None":
    if getattr(obj, "is_check", False) is True:
        return Item.from_parent(collector, name=name, check=CHECKS[name])
    return None


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the checks first, in the order of the handout."""
    tiers = [*SUITES, None]
    items.sort(key=lambda item: tiers.index(item.check.tier if isinstance(item, Item) else None))


class Item(pytest.Item):
    """A check, as pytest runs it."""

    def __init__(self, *, check: Check, **of_pytest: Any) -> None:
        super().__init__(**of_pytest)
        self.check = check

    def runtest(self) -> None:
        outcome = self.config.stash[GRADING].judge(self.check)
        self.user_properties.append((OUTCOME, outcome.plain()))
        if outcome.state == WAITING:
            if self.config.option.maxfail == 1:  # -x
                self.session.shouldfail = "stopping at the first check that waits"
            pytest.skip(outcome.message)
        if outcome.state in (FAILED, FAULT):
            pytest.fail(outcome.message, pytrace=False)

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, self.check.ask.__code__.co_firstlineno - 1, self.check.title


@pytest.hookimpl(tryfirst=True)  # before the terminal shows the report
def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Take the outcome of a check out of its report, which may come from another process."""
    for key, fields in report.user_properties:
        if key == OUTCOME:
            RAN[name_of(report)] = Outcome.from_plain(fields)


def name_of(report: pytest.TestReport) -> str:
    """Return the name of the test that a report is about."""
    return report.nodeid.rpartition("::")[2]


def pytest_report_teststatus(report: pytest.TestReport) -> tuple[str, str, str] | None:
    """Give a check that waits its own letter and word."""
    outcome = RAN.get(name_of(report))
    if report.skipped and outcome and outcome.state == WAITING:
        return WAITING, "w", "WAITING"
    return None


def pytest_sessionfinish(session: Any) -> None:
    """Write the grade.

    The exit status is 1 also if checks wait, and another one if the file cannot be written.
    """
    config = session.config
    config.session = session
    if hasattr(config, "workerinput"):  # a process of xdist's, which ran only some of the checks
        return
    are_passed = all(outcome.state == PASSED for outcome in RAN.values())
    if session.exitstatus == pytest.ExitCode.OK and not are_passed:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
    file = config.option.grade_json
    if file and RAN:
        try:
            graded = grade_of_run(config)
            with whole_file(file) as out:
                json.dump(graded, out, indent=4)
                out.write("\n")
        except OSError as error:
            session.exitstatus = pytest.ExitCode.USAGE_ERROR
            config.not_written = f"--grade-json: {file}: {error.strerror}"


def grade_of_run(config: pytest.Config) -> dict:
    """Return what --grade-json writes."""
    # Whether nothing has failed for want of what other programs use as well, or by a fault of the
    # grader.
    is_fault = any(outcome.state == FAULT for outcome in RAN.values())
    is_final = not is_fault and not present.shared_was_short
    results = {}
    for check in checks_with_outcome(RAN):
        outcome = RAN[check.name]
        results[check.name] = {
            "tier": check.tier,
            "function": check.function,
            "title": check.title,
            "state": outcome.state,
            "message": outcome.message,
            "place": outcome.place,
            "hint": outcome.hint or outcome.advice,
        }
    text = [line.text for line in report_of_run(config)]
    return {**grade(RAN), "checks": results, "text": text, "final": is_final}


def report_of_run(config: pytest.Config) -> list[Line]:
    """Return what a student reads about this run."""
    if not RAN:
        return []
    advice = ""
    try:
        read_cradle(Snapshot(NC_FP))
    except ValueError as error:  # the checks have files of their own
        advice = f"your CSV has a mistake. {error}".replace(f"{config.rootpath}{os.sep}", "")
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    failed = getattr(reporter, "stats", {}).get("failed", [])
    printed = {name_of(failure): failure.capstdout for failure in failed}
    return report(RAN, printed, get_terminal_size().columns, advice)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_terminal_summary(terminalreporter: Any, config: Any) -> Iterator[None]:
    """Show what students read below everything else."""
    failed = terminalreporter.stats.get("failed", [])
    others = [failure for failure in failed if name_of(failure) not in RAN]
    with patch.dict(terminalreporter.stats, failed=others):  # pytest shows these only
        yield
    terminalreporter.currentfspath = None  # no line is begun: or an empty one would be put in
    for line in report_of_run(config):
        markup = {line.color: True} if line.color else {}
        terminalreporter.line(line.text, **markup)
    if not RAN and config.session.exitstatus == pytest.ExitCode.NO_TESTS_COLLECTED:
        text = "The checks are not here. Type pytest in the folder that has tests and src."
        terminalreporter.write_line(text, red=True)
    if hasattr(config, "not_written"):
        terminalreporter.write_line(config.not_written, red=True)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: Any) -> None:
    """End the process with its exit status if a thread of a student's code still runs.

    Python would wait for it. Everything is printed and written by now; with pytest-xdist, this
    process has sent its reports.
    """
    if hasattr(config, "session") and any(map(is_left, threading.enumerate())):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(config.session.exitstatus)


def is_left(thread: threading.Thread) -> bool:
    """Return whether Python would wait for the end of a thread."""
    return not thread.daemon and thread is not threading.main_thread()
