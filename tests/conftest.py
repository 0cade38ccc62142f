"""The graded suites in pytest: each check is an item of its own, and after a run a table tells the grade."""

import json
from contextlib import suppress
from pathlib import Path

import pytest

from support import headless_vpython

headless_vpython.install()

import command_line
from grade import grade, lines
from grader import CHECKS, FAILED, FAULT, Grading, WAITING
from handout import SUITES

from support.whole_file import whole_file


def pytest_addoption(parser):
    with suppress(ValueError):  # they are there already, as the project is installed
        command_line.pytest_addoption(parser)


def pytest_configure(config):
    config.grading, config.ran = Grading(), {}  # ran: outcomes of this run's checks, by name
    file = config.option.grade_json
    if file and (Path(file).is_dir() or not Path(file).parent.is_dir()):
        raise pytest.UsageError(f"--grade-json: found {file!r}, allowed is a file in a folder that is there")


def pytest_ignore_collect(collection_path, config):
    suites = dict(zip(command_line.TIERS, SUITES.values(), strict=True))
    wanted = suites.get(config.option.tier, collection_path.stem)
    return True if collection_path.is_file() and collection_path.stem != wanted else None


def pytest_pycollect_makeitem(collector, name, obj):
    return Item.from_parent(collector, name=name, check=CHECKS[name]) if getattr(obj, "is_check", False) else None


def pytest_collection_modifyitems(items):
    """Put the checks first, in the order of the handout."""
    tiers = list(SUITES)
    items.sort(key=lambda item: tiers.index(item.check.tier) if isinstance(item, Item) else len(tiers))


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


def pytest_report_teststatus(report):
    if report.when == "call" and report.skipped and "waits for" in str(report.longrepr):
        return "waiting", "w", f"WAITING ({report.longrepr[2].removeprefix('Skipped: ')})"
    return None


def pytest_sessionfinish(session):
    file = session.config.option.grade_json
    if file:
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
