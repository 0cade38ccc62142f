"""A plain pytest runs the graded tests; the project's own tests need more packages."""

from importlib.util import find_spec

import pytest

PACKAGES = ("hypothesis", "importlinter", "numpy", "pymunk", "scipy", "xdist")
ARE_MISSING = not all(map(find_spec, PACKAGES))


def is_graded_only(config):
    """Return whether pytest leaves out the project's own tests."""
    is_plain = config.args_source is pytest.Config.ArgsSource.TESTPATHS
    return ARE_MISSING or (is_plain and not config.getoption("numprocesses", None))


def pytest_ignore_collect(collection_path, config):
    if collection_path.name == "project" and is_graded_only(config):
        return True
    return None


def pytest_terminal_summary(terminalreporter, config):
    """Say how the project's own tests are run, if they were not."""
    if is_graded_only(config):
        terminalreporter.line(
            "The project's own tests: install tests/requirements.txt, and type pytest -n 2 tests"
        )
