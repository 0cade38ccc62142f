"""Where watched calls were stopped, by an error or by a limit, and how."""

from typing import NamedTuple

from line_by_line.traces import WatchedCall
from line_by_line.watch import EndlessError, MOST_TURNS, Watch


class Stop(NamedTuple):
    """Where a call was stopped."""

    number: int  # of the statement
    line: int
    how: str  # "stops here: TypeError"
    is_error: bool  # and not a limit


def stops_in(watch: Watch) -> dict[WatchedCall, Stop]:
    """Return where the watched calls were stopped, the outer one first."""
    error = watch.error
    found: dict[WatchedCall, Stop] = {}
    step = error.__traceback__ if error else None
    while error and step:
        call = watch.calls.get(step.tb_frame)
        if call:
            number = watch.statement_at(call, step.tb_lineno)
            found[call] = Stop(number, step.tb_lineno, *how_stopped(error))
            if isinstance(error, RecursionError):
                break  # of these, the outer call is enough
        step = step.tb_next
    return found


def how_stopped(error: BaseException) -> tuple[str, bool]:
    """Return how an error has stopped a call, and whether it is no limit."""
    if isinstance(error, EndlessError):
        return f"still here after {MOST_TURNS} turns", False
    if isinstance(error, KeyboardInterrupt):
        return "stopped here", False
    return f"stops here: {type(error).__name__}", True
