"""A function that does not return is named, and only that one; test_show_cradle.py has the page."""

from types import SimpleNamespace

from support.page import endless
from support.root import SRC

LOOKS = round(endless.TOO_LONG / endless.LOOK)


def frame(name):
    """Return a frame of swinging.py, in a function with this name."""
    code = SimpleNamespace(co_filename=SRC / "swinging.py")
    return SimpleNamespace(f_code=code, f_lineno=len(name))


class Watched:
    """A watch of a loop that a test moves, the frames that it is in, and what the watch tells."""

    def __init__(self, monkeypatch):
        self.done = 5
        self.frames = []
        self.told = []
        self.stopped = []
        self.watch = endless.Watch(lambda: self.done, self.tell, lambda: True)
        monkeypatch.setattr(endless, "running", lambda thread: self.frames)
        monkeypatch.setattr(endless, "raise_in", lambda thread, error: self.stopped.append(error))

    def tell(self, state):
        self.told.append(state["endless"])

    def does(self, *frames):
        self.frames = frames
        self.done += 1
        self.watch.look()

    def stands(self, looks):
        for _ in range(looks):
            self.watch.look()


def test_the_innermost_function_that_has_not_returned_meanwhile_is_named_until_it_does(monkeypatch):
    """It is stopped after a save: again and again, as a bare except can catch the end."""
    watched = Watched(monkeypatch)
    outer = frame("outer")
    stays = frame("stays")
    watched.does(frame("returns"), stays, outer)
    watched.frames = [stays, outer]
    watched.stands(LOOKS - 1)
    assert watched.told == watched.stopped == []
    watched.stands(2)
    assert watched.told == [
        "src/swinging.py, line 5: the program has been here for 3 s. If it asks in the "
        "terminal, answer there. If a loop never ends here, mend it, and save the file."
    ]
    assert len(watched.stopped) == 2
    watched.does(outer)
    watched.stands(1)
    assert watched.told[1:] == [""]
    assert len(watched.stopped) == 2


def test_a_loop_at_the_beginning_of_a_run_is_named(monkeypatch):
    watched = Watched(monkeypatch)
    watched.does()  # the run begins, in no function of src/
    watched.stands(2)
    watched.frames = [frame("loops")]
    watched.stands(1 + LOOKS)
    assert len(watched.told) == 1
