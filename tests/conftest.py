"""The choices of a plain `pytest`: it leaves out tests with one of two marks, and runs the others in two processes."""

import os

import pytest

LEFT_OUT = {
    "browser": "opens a page in a real browser",
    "slow": "repeats at length what another test does in short",
}
CLOCK = "clock: compares the simulated time with the clock, so nothing else must run beside it"


def pytest_configure(config):
    for line in [*map(": ".join, LEFT_OUT.items()), CLOCK]:
        config.addinivalue_line("markers", line)


@pytest.hookimpl(tryfirst=True)  # before pytest-xdist looks for -n
def pytest_cmdline_main(config):
    option = config.option
    has_chosen = option.keyword or option.markexpr or option.tier
    takes_all = config.args_source is pytest.Config.ArgsSource.TESTPATHS and not has_chosen
    is_first = "PYTEST_XDIST_WORKER" not in os.environ  # and not one of the two
    if takes_all and is_first and not option.usepdb and getattr(option, "numprocesses", 0) is None:  # 0 without xdist
        option.numprocesses = 2


@pytest.hookimpl(trylast=True)  # after -k and -m have chosen
def pytest_collection_modifyitems(config, items):
    marked = [item for item in items if any(map(item.get_closest_marker, LEFT_OUT))]
    if marked and not config.option.markexpr:
        items[:] = [item for item in items if item not in marked]
        config.hook.pytest_deselected(items=marked)
        config.left_out = getattr(config, "workeroutput", {})["left_out"] = len(marked)


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node):
    """Take over how many tests a process of pytest-xdist has left out: each leaves out the same."""
    node.config.left_out = getattr(node, "workeroutput", {}).get("left_out", 0)


def pytest_terminal_summary(terminalreporter, config):
    if getattr(config, "left_out", 0):
        command = f'.venv/bin/pytest -m "{" or ".join(LEFT_OUT)}"'
        terminalreporter.write_line(f"Left out ({', '.join(LEFT_OUT)}): {config.left_out}. To run them: {command}")
