"""A function that does not return is named, and only that one."""

import re
import threading
from types import SimpleNamespace

import pytest
from programs import ROOT

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


def test_nothing_is_named_while_the_loop_ticks(watched, monkeypatch):
    monkeypatch.setattr(endless, "running", lambda thread: [frame("main")])
    for _ in range(2 * LOOKS):
        watched.done += 1
        watched.watch.look()
    assert watched.told == []


@pytest.fixture
def clocked(rig):
    """The rig, whose time passes while the viewer rests."""

    def sleep(seconds):
        rig.now += seconds

    rig.viewer.pace.sleep = sleep
    return rig


def test_the_page_names_the_function_that_does_not_return_until_it_does(clocked, monkeypatch):
    """The one with the loop, not one that it calls again and again."""
    told = []
    watch = endless.Watch(clocked.viewer.progress, told.append)

    def does_not_return(*arguments):
        clocked.tabs.are_gone = True
        for _ in range(LOOKS + 1):
            if not told:
                watch.look()

    monkeypatch.setattr(visualize_cradle_run, "full_swing_update", does_not_return)
    clocked.viewer.next_cradle.want()
    run(visualize_cradle_run.main, clocked.viewer)
    [message] = told
    assert re.fullmatch(
        r"newton_cradle_tick in src/visualize_cradle_run\.py, line \d+,"
        r" has been running for 3 s and has not returned\. If a loop in it never ends, press"
        r" Ctrl\+C in the terminal, and mend it\.",
        message,
    )


def test_a_file_of_yours_may_have_the_name_of_the_players(clocked, monkeypatch):
    names = {}
    exec(compile("def stays(look): look()", ROOT / "src" / "player.py", "exec"), names)
    found = []

    def look():
        frames = endless.running(threading.get_ident())
        found.append(frames[0].f_code.co_name)
        clocked.tabs.are_gone = True

    monkeypatch.setattr(visualize_cradle_run, "full_swing_update", lambda *_: names["stays"](look))
    clocked.viewer.next_cradle.want()
    run(visualize_cradle_run.main, clocked.viewer)
    assert set(found) == {"stays"}
