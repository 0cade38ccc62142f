"""Where watched calls were stopped, by an error or by a limit, and how."""

from typing import NamedTuple

from grading.traces import WatchedCall
from grading.tracing import EndlessError, MOST_TURNS
from grading.watch import Watch


class Stop(NamedTuple):
    """Where a call was stopped."""

    line: int
    how: str  # "stops here: TypeError"
    is_error: bool  # and not a limit


def stops_in(watch: Watch) -> dict[WatchedCall, Stop]:
    """Return where the watched calls were stopped, the outer one first."""
    error = watch.error
    if error is None:
        return {}
    found: dict[WatchedCall, Stop] = {}
    step = error.__traceback__
    while step:
        call = watch.calls.get(step.tb_frame)
        if call:
            found[call] = stop_at(step.tb_lineno, error)
            if isinstance(error, RecursionError):
                break  # of these, the outer call is enough
        step = step.tb_next
    return found


def stop_at(line: int, error: BaseException) -> Stop:
    """Return how an error has stopped a line."""
    if isinstance(error, EndlessError):
        return Stop(line, f"still here after {MOST_TURNS} turns", is_error=False)
    if isinstance(error, KeyboardInterrupt):
        return Stop(line, "stopped here", is_error=False)
    return Stop(line, f"stops here: {type(error).__name__}", is_error=True)
