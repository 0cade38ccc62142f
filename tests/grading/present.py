"""What is known of the check that runs now, in one object: the suites call functions without it."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from line_by_line.watch import Watch


class PresentCheck:
    """The check that runs now, or ran last."""

    def __init__(self) -> None:
        # Whether a call, of any check, failed for want of something that other programs use as
        # well: time by the clock, memory, the disk
        self.shared_was_short = False
        self.is_in_check = False
        self.begin()

    def begin(
        self,
        function: str = "",
        watch: "Watch | None" = None,
        seen: dict[str, bool] | None = None,
    ) -> None:
        """A check begins. A watch is for its calls of this function.

        If a check goes on after a wrong result, seen gets its calls with numbers alone, in words,
        and whether their results are right.
        """
        self.watched_function = function
        self.watch = watch
        self.lasting: dict[str, str] = {}  # how the watched call has changed values that live on
        self.seen = seen
        self.advice: list[str] = []  # sentences for a student whose solution is right
        # By which time the grader stopped it: CLOCK or PROCESSOR of limits.py, "" if it did not
        self.stopped_by = ""
        self.has_read_real_csv = False  # the program has, by a path of its own
        self.is_pressed = False  # somebody pressed Ctrl+C
        self.is_debugged = False  # no limit of time holds


present = PresentCheck()
