"""A function that does not return is named, and only that one."""

import re
from types import SimpleNamespace

import pytest

from src import visualize_cradle_run
from support.cradle.player import run
from support.page import endless

LOOKS = round(endless.TOO_LONG / endless.LOOK)


def frame(name):
    code = SimpleNamespace(co_filename=f"src/{name}.py", co_name=name)
    return SimpleNamespace(f_code=code, f_lineno=7)


class Watched:
    """A watch, what its loop has done, and what it tells."""

    def __init__(self):
        self.done = 5
        self.told = []
        self.watch = endless.Watch(lambda: self.done, self.told.append)


@pytest.fixture
def watched():
    return Watched()


def test_the_innermost_function_that_has_not_returned_meanwhile_is_named_until_it_does(
    watched, monkeypatch
):
    outer = frame("outer")
    stays = frame("stays")
    watched.done += 1
    for number in range(LOOKS + 1):
        frames = [frame("returns"), stays, outer] if number % 2 else [stays, outer]
        monkeypatch.setattr(endless, "running", lambda thread, frames=frames: frames)
        assert watched.told == []
        watched.watch.look()
    watched.watch.look()
    [message] = watched.told
    assert message.startswith("stays in src/stays.py, line 7, has been running for 3 s")
    watched.done += 1
    watched.watch.look()
    assert watched.told == [message, ""]


def test_the_page_names_the_function_that_does_not_return_until_it_does(rig, monkeypatch):
    """The one with the loop, not one that it calls again and again."""
    told = []
    watch = endless.Watch(rig.viewer.progress, told.append)

    def sleep(seconds):
        rig.now += seconds

    def does_not_return(*arguments):
        rig.tabs.are_gone = True
        for _ in range(LOOKS + 1):
            if not told:
                watch.look()

    monkeypatch.setattr(rig.viewer.pace, "sleep", sleep)
    monkeypatch.setattr(visualize_cradle_run, "full_swing_update", does_not_return)
    rig.viewer.next_cradle.want()
    run(visualize_cradle_run.main, rig.viewer)
    [message] = told
    assert re.fullmatch(
        r"newton_cradle_tick in src/visualize_cradle_run\.py, line \d+,"
        r" has been running for 3 s and has not returned\. If a loop in it never ends, press"
        r" Ctrl\+C in the terminal, and mend it\.",
        message,
    )
