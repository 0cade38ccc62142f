"""What pytest leaves out as long as no -m says what to run: tests with one of two marks."""

import pytest

MARKS = {
    "browser": "opens a page in a real browser",
    "slow": "repeats at length what another test does in short",
}


def pytest_configure(config):
    for name, words in MARKS.items():
        config.addinivalue_line("markers", f"{name}: {words}")


@pytest.hookimpl(trylast=True)  # after -k and -m have chosen
def pytest_collection_modifyitems(config, items):
    marked = [item for item in items if any(map(item.get_closest_marker, MARKS))]
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
        command = f'.venv/bin/pytest -m "{" or ".join(MARKS)}"'
        terminalreporter.write_line(f"Left out (browser, slow): {config.left_out}. To run them: {command}")
