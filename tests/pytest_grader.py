"""The graded suites in pytest, as a plugin (pyproject.toml): each check is an item, and a table ends a run."""

import json
from pathlib import Path

import pytest

from support import headless_vpython

headless_vpython.install()

from grade import grade, lines
from grader import CHECKS, FAILED, FAULT, Grading, WAITING
from handout import SUITES

from support.whole_file import whole_file

TIERS = {tier.split()[0].upper(): tier for tier in SUITES}  # as --tier takes them


def pytest_addoption(parser):
    group = parser.getgroup("graded suites")
    text = "run the graded suite of one tier only: D, C, B, A or honor"
    group.addoption("--tier", type=str.upper, choices=list(TIERS), metavar="TIER", help=text)
    group.addoption("--grade-json", metavar="FILE", help="write the grade to FILE")


def pytest_configure(config):
    config.grading, config.ran = Grading(), {}  # ran: the outcomes of this run's checks, by name
    file = config.option.grade_json
    if file is not None and (Path(file).is_dir() or not Path(file).parent.is_dir()):
        raise pytest.UsageError(f"--grade-json: found {file!r}, allowed is a file in a folder that is there")


def pytest_ignore_collect(collection_path, config):
    """Leave out what is not of the tier that is wanted, unread: it may not even be possible to import it."""
    tier = config.option.tier
    return True if tier and collection_path.is_file() and collection_path.stem != SUITES[TIERS[tier]] else None


def pytest_pycollect_makeitem(collector, name, obj):
    return Item.from_parent(collector, name=name, check=CHECKS[name]) if getattr(obj, "is_check", False) else None


def pytest_collection_modifyitems(items):
    """Put the checks first, in the order of the handout."""
    tiers = [*SUITES, None]
    items.sort(key=lambda item: tiers.index(item.check.tier if isinstance(item, Item) else None))


class Item(pytest.Item):
    """A check, as pytest runs it."""

    def __init__(self, *, check, **of_pytest):
        super().__init__(**of_pytest)
        self.check = check

    def runtest(self):
        outcome = self.config.ran[self.name] = self.config.grading.judge(self.check)
        if outcome.state == WAITING:
            pytest.skip(outcome.message)
        if outcome.state in (FAILED, FAULT):
            pytest.fail(outcome.message, pytrace=False)

    def reportinfo(self):
        return self.path, self.check.ask.__code__.co_firstlineno - 1, self.check.title()


def pytest_report_teststatus(report, config):
    outcome = config.ran.get(report.nodeid.rpartition("::")[2])
    if outcome and outcome.state == WAITING and report.skipped:
        return WAITING, "w", "WAITING"
    return None


def pytest_sessionfinish(session):
    """Write the grade. If the file cannot be written the exit status says so, which else is pytest's own."""
    file = session.config.option.grade_json
    if file and session.config.ran:
        try:
            with whole_file(file) as out:
                json.dump(grade(session.config.ran), out, indent=4)
                out.write("\n")
        except OSError as error:
            session.exitstatus = pytest.ExitCode.USAGE_ERROR
            session.config.not_written = f"--grade-json: {file}: {error.strerror}"


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_terminal_summary(terminalreporter, config):
    """Show the table below everything else."""
    yield
    if config.ran:
        terminalreporter.section("Grade")
        for line, color in lines(config.ran):
            terminalreporter.write_line(line, **{color: True})
    if hasattr(config, "not_written"):
        terminalreporter.write_line(config.not_written, red=True)
