"""A function that does not return is named, and only that one."""

from types import SimpleNamespace

import pytest

from support.page import endless
from support.page.tabs import LOOK

LOOKS = round(endless.TOO_LONG / LOOK)


def frame(name):
    code = SimpleNamespace(co_filename=f"src/{name}.py", co_name=name)
    return SimpleNamespace(f_code=code, f_lineno=7)


@pytest.fixture
def watch():
    """A watch of a player whose loop asks nothing any more."""
    player = SimpleNamespace(motion=SimpleNamespace(ticks=5), pace=SimpleNamespace(frame_start=1.0))
    return endless.Watch(player)


def test_the_innermost_function_that_has_not_returned_meanwhile_is_named(watch, monkeypatch):
    outer = frame("outer")
    stays = frame("stays")
    for number in range(LOOKS + 1):
        frames = [frame("returns"), stays, outer] if number % 2 else [stays, outer]
        monkeypatch.setattr(endless, "running", lambda thread, frames=frames: frames)
        assert watch.words == ""
        message = watch.look()
    assert message.startswith("stays in src/stays.py, line 7, has been running for 3 s")


def test_nothing_is_named_while_the_loop_ticks(watch, monkeypatch):
    monkeypatch.setattr(endless, "running", lambda thread: [frame("main")])
    for _ in range(2 * LOOKS):
        watch.player.motion.ticks += 1
        assert watch.look() == ""
