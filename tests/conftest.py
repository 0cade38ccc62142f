"""A plain `pytest` runs the tests in two processes."""

import os

import pytest


@pytest.hookimpl(tryfirst=True)  # before pytest-xdist looks for -n
def pytest_cmdline_main(config):
    option = config.option
    has_chosen = option.keyword or option.tier or option.markexpr not in config.getini("addopts")
    takes_all = config.args_source is pytest.Config.ArgsSource.TESTPATHS and not has_chosen
    is_first = "PYTEST_XDIST_WORKER" not in os.environ  # and not one of the two
    if takes_all and is_first and not option.usepdb and getattr(option, "numprocesses", 0) is None:  # 0 without xdist
        option.numprocesses = 2
