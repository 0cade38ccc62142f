"""When the program of a page ends: a moment after its last tab was closed, later if it was cut."""

import pytest

from support.page.server.attendance import Attendance, CLOSED, CUT, LOADING

LOOK = 0.5  # s


class Waiting:
    """The attendance of a program whose time goes on as a test says."""

    def __init__(self):
        self.now = 0.0
        self.attendance = Attendance(lambda: self.now)

    def happens(self, events):
        """Let events happen; a number is the seconds (s) that pass before the next one."""
        for event in events.split(", "):
            if event == "opens":
                self.attendance.welcome()
            elif event == "loads":
                self.attendance.wait(LOADING)
            elif event == "stands still":
                self.now += 300.0
                self.attendance.look()
            elif event in ("closes", "cut"):
                self.attendance.lose(is_cut=event == "cut")
            else:
                self.passes(float(event))

    def passes(self, seconds):
        """Let time pass; return whether the program still waits."""
        for _ in range(round(seconds / LOOK)):
            self.now += LOOK
            waits = self.attendance.look()
        return waits


@pytest.mark.parametrize(
    ("events", "rest"),
    [
        ("opens, closes", CLOSED),
        ("opens, cut", CUT),
        ("opens, cut, opens, closes", CLOSED),
        ("opens, closes, loads", LOADING),  # a reload on a slow connection
        ("opens, loads, closes, 5, opens, closes", CLOSED),
        ("opens, opens, cut, 50, closes", CUT - 50),
        ("opens, cut, 50, stands still", CUT),
        ("opens, 99, stands still, closes", CLOSED),
    ],
)
def test_the_program_ends_when_the_latest_deadline_is_over(events, rest):
    """Before the first tab, it waits for ever."""
    waiting = Waiting()
    assert waiting.passes(999)
    waiting.happens(events)
    assert waiting.passes(rest - LOOK)
    assert not waiting.passes(LOOK)
