"""The mark of the first line with a wrong value: what is right there.

It is found by trying: the function is called again, with a right value in place of the line's own.
"""

import ast
import itertools
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from math import degrees
from numbers import Real
from typing import Any

from vpython import vector

from grading.comparing import same
from grading.messages import own_copies
from line_by_line.expressions import names_in_head
from line_by_line.traces import Store, WatchedCall
from line_by_line.watch import Watch
from line_by_line.words import text_of


def marks_of(
    watch: Watch,
    right: Sequence[tuple[str, Any]],
    arguments: tuple,
    is_mended: Callable[[dict[int, Any]], bool],
) -> dict[int, str]:
    """Return what is right in the first statement with a wrong value, by its number.

    right are pairs of a part of the formula and its value. is_mended says whether the first wrong
    part of the result is right if statements give other values, which it gets by their numbers.

    It is not certain, and there is no mark, if two values would mend the result, if the line has a
    right value already, or its negative (then a later line may use it wrongly), or if it uses a
    value that may be wrong.
    """
    known = [value for value in (*dict(right).values(), *arguments) if is_plain(value)]
    for store in stores_once(watch):
        mending: list[Any] = []
        for value in known:
            is_new = not any(same(value, other) for other in (store.value, *mending))
            if is_new and is_mended_by(is_mended, store.number, value):
                mending.append(value)
        if mending:
            is_certain = len(mending) == 1 and uses_right_values(watch, store, known)
            if not is_certain or is_known(store.value, known):
                return {}
            return {store.number: f"{text_of(mending[0])} is right here"}
    return {}


def is_known(value: Any, known: list) -> bool:
    """Return whether a value is a known one, or its negative."""
    return any(same(value, sign * other) for other in known for sign in (1, -1))


def uses_right_values(watch: Watch, store: Store, known: list) -> bool:
    """Return whether a statement uses only known values in the names that were set before.

    They may be in degrees.
    """
    known = [*known, *(degrees(value) for value in known if isinstance(value, Real))]
    names = names_in_head(watch.statements[store.number].node)
    before = itertools.takewhile(lambda other: other is not store, watch.stores)
    used = [other.value for other in before if other.holder is store.holder and other.key in names]
    return all(is_known(value, known) for value in used)


def is_plain(value: Any) -> bool:
    """Return whether a value is a number or a vector."""
    return isinstance(value, (Real, vector)) and not isinstance(value, bool)


def stores_once(watch: Watch) -> Iterator[Store]:
    """Yield what the lines have stored that ran once, and stored one number or vector in a name.

    The return of the main function is left out.
    """
    stores = [*watch.stores]
    main = next(iter(watch.calls.values()))
    times = Counter(store.number for store in stores)
    for store in stores:
        is_result = store.holder is main and not store.key
        is_in_name = isinstance(store.holder, WatchedCall) and not is_result
        node = watch.statements[store.number].node
        if isinstance(node, ast.AugAssign):
            continue  # it gets another right side, and not another value
        if is_in_name and times[store.number] == 1 and is_plain(store.value):
            yield store


def is_mended_by(is_mended: Callable, number: int, value: Any) -> bool:
    """Return whether this value of a statement mends the result."""
    try:
        return is_mended({number: own_copies([value])[0]})
    except Exception:  # the student's code cannot go on with it
        return False
