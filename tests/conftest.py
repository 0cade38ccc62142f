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
    if not option.markexpr:
        option.markexpr = " and ".join(f"not {mark}" for mark in LEFT_OUT)
        config.left_out = f'Left out: {", ".join(LEFT_OUT)}. To run them: .venv/bin/pytest -m "{" or ".join(LEFT_OUT)}"'


def pytest_terminal_summary(terminalreporter, config):
    # The stats of pytest-xdist do not have them.
    some = "deselected" in terminalreporter.stats or getattr(config.option, "numprocesses", 0)
    if some and hasattr(config, "left_out"):
        terminalreporter.write_line(config.left_out)
