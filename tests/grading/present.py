"""What is known of the check that runs now, in one object: the suites call functions without it."""

from typing import TYPE_CHECKING

from support import waits

if TYPE_CHECKING:
    from grading.watch import Watch


class PresentCheck:
    """The check that runs now, or ran last."""

    def __init__(self) -> None:
        # Whether a call, of any check, failed for want of something that other programs use as
        # well: time by the clock, memory, the disk
        self.shared_was_short = False
        self.is_in_check = False
        self.begin()

    def begin(self, watch: "Watch | None" = None) -> None:
        """A check begins. A watch is for one of its calls."""
        waits.calls.clear()
        self.watch = watch
        self.calls = 0  # of students' functions
        self.advice: list[str] = []  # sentences for a student whose solution is right
        # By which time the grader stopped it: CLOCK or PROCESSOR of limits.py, "" if it did not
        self.stopped_by = ""
        self.is_pressed = False  # somebody pressed Ctrl+C
        self.is_debugged = False  # no limit of time holds


present = PresentCheck()
