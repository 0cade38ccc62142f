"""The graded suites in pytest, as a plugin: each check is an item, and a screen ends a run.

pyproject.toml names the plugin. With pytest-xdist (-n 2), other processes run the tests and report
to the first one, which shows the table.
"""

import json
import os
import pickle
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from unittest.mock import patch

import grading.begin  # noqa: F401

import pytest

from grading.assignment import HONOR, SUITES
from grading.checks import Check
from grading.given import changed_given
from grading.grade import Results
from grading.grader import Grader
from grading.outcomes import FAILED, FAULT, Grading, PASSED, WAITING
from grading.screen import Line, Screen
from support.files.data_file import whole_file

GRADING = pytest.StashKey[Grading]()
RESULTS = pytest.StashKey[Results]()  # of the checks of this run, as they are reported
OUTCOME = "outcome of a check"  # the name under which a report of pytest has it
TIERS = {tier.split()[0]: tier for tier in SUITES}  # as --tier takes them


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("graded suites")
    text = "run the graded suite of one tier only: D, C, B, A or honor"
    group.addoption("--tier", type=str.capitalize, choices=[*TIERS], help=text)
    group.addoption("--grade-json", metavar="FILE", help="write the grade to FILE")


@pytest.hookimpl(trylast=True)  # after that of the terminal
def pytest_configure(config: pytest.Config) -> None:
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    has_terminal = bool(reporter and reporter.isatty)
    grader = Grader(has_terminal, lambda line: end_now(config, line))
    config.stash[GRADING] = Grading(grader)
    config.stash[RESULTS] = Results(grader.checks, {})


def end_now(config: pytest.Config, line: str) -> None:
    """Show a line, and end the process: a student's function does not end."""
    capture = config.pluginmanager.get_plugin("capturemanager")
    if capture:
        capture.suspend_global_capture()
    sys.stderr.write(f"\n{line}\n")
    sys.stderr.flush()
    os._exit(1)


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave out the files of other tiers: an import in them may fail."""
    tier = config.option.tier
    if tier and collection_path.is_file() and collection_path.stem != SUITES[TIERS[tier]]:
        return True
    return None


def pytest_pycollect_makeitem(collector: pytest.Collector, name: str, obj: object) -> "Item | None":
    check = collector.config.stash[GRADING].grader.checks.get(name)
    if check and hasattr(obj, "marks"):
        return Item.from_parent(collector, name=name, check=check)
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
        self.extra_keyword_matches.add(check.function)  # for -k

    def runtest(self) -> None:
        outcome = self.config.stash[GRADING].judge(self.check)
        self.user_properties.append((OUTCOME, pickle.dumps(outcome)))
        if outcome.state == WAITING:
            if self.config.option.maxfail == 1:  # -x
                self.session.shouldfail = "stopping at the first check that waits"
            pytest.skip(outcome.message)
        if outcome.state in (FAILED, FAULT):
            pytest.fail(outcome.message, pytrace=False)

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, self.check.ask.__code__.co_firstlineno - 1, self.check.title


def name_of(report: Any) -> str:
    """Return the name of the test that a report is about."""
    return report.nodeid.rpartition("::")[2]


def pytest_report_teststatus(report: Any, config: pytest.Config) -> tuple[str, str, str] | None:
    """Take the outcome of a check out of its report, which may come from another process.

    Give a check that waits its own letter and word.
    """
    outcomes = config.stash[RESULTS].outcomes
    pickled = dict(report.user_properties).get(OUTCOME)
    if pickled:
        outcomes[name_of(report)] = pickle.loads(pickled)
    outcome = outcomes.get(name_of(report))
    if report.skipped and outcome and outcome.state == WAITING:
        return WAITING, "w", "WAITING"
    return None


def pytest_sessionfinish(session: Any) -> None:
    """Write the grade.

    The exit status is 1 also if checks wait, but not for those of the honor roll, which is extra.
    """
    config = session.config
    if hasattr(config, "workerinput"):  # a process of xdist's, which ran only some of the checks
        return
    results = config.stash[RESULTS]
    needed = [outcome for check, outcome in results.ran if check.tier != HONOR]
    are_passed = all(outcome.state == PASSED for outcome in needed)
    if session.exitstatus == pytest.ExitCode.OK and not are_passed:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
    file = config.option.grade_json
    if file and results.outcomes:
        try:
            with whole_file(file) as out:
                json.dump(grade_of_run(config), out, indent=4)
        except OSError as error:
            raise pytest.UsageError(f"--grade-json: {file}: {error.strerror}") from None


def grade_of_run(config: pytest.Config) -> dict:
    """Return what --grade-json writes."""
    results = config.stash[RESULTS]
    checks = {}
    for check, outcome in results.ran:
        checks[check.name] = {
            "tier": check.tier,
            "function": check.function,
            "title": check.title,
            "state": outcome.state,
            "message": outcome.message,
        }
    # Nothing has failed for want of what other programs use as well, or by a fault of the grader
    are_faults = any(outcome.state == FAULT for outcome in results.outcomes.values())
    is_final = not are_faults and not config.stash[GRADING].grader.shared_was_short
    text = [line.text for line in screen_of_run(config)]
    return {**results.grade(), "checks": checks, "text": text, "final": is_final}


def screen_of_run(config: pytest.Config) -> list[Line]:
    """Return what a student reads about this run."""
    results = config.stash[RESULTS]
    if not results.outcomes:
        return []
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    failed = getattr(reporter, "stats", {}).get("failed", [])
    printed = {name_of(failure): failure.capstdout for failure in failed}
    return Screen(results, changed_given()).lines(printed)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_terminal_summary(terminalreporter: Any, config: Any) -> Iterator[None]:
    """Show what students read below everything else."""
    outcomes = config.stash[RESULTS].outcomes
    failed = terminalreporter.stats.get("failed", [])
    others = [report for report in failed if name_of(report) not in outcomes]
    with patch.dict(terminalreporter.stats, failed=others):  # pytest shows these only
        yield
    terminalreporter.currentfspath = None  # no line is begun: or an empty one would be put in
    for line in screen_of_run(config):
        markup = {line.color: True} if line.color else {}
        terminalreporter.line(line.text, **markup)
