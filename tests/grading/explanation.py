"""The explanation of a mistake: a failed check is performed again, and its wrong call is traced."""

from contextlib import redirect_stderr, redirect_stdout, suppress
from io import StringIO
from numbers import Real
from typing import Any, NamedTuple

from grading.begin import ROOT

from vpython import vector

from grading.assignment import FUNCTIONS
from grading.checks import Check
from grading.comparing import same
from grading.given import defined_twice
from grading.grader import Grader, place_of, WrongError
from grading.limits import CLOCK
from grading.messages import labelled, place_lines
from grading.students_code import code_of, is_named, is_watched, names_in
from grading.subject import OBJECTS, Subject
from grading.words import text_of, WORDS
from line_by_line.table import returns_in_loops, Row, rows_of, Wanted
from line_by_line.trace import Trace

EXCHANGED = "These are the right values, in another order."


class Explanation(NamedTuple):
    """What a student reads about a mistake, in this order."""

    wrong: list[str]  # what is wrong, the call, and both values
    rows: list[Row] = []  # of the table
    below: list[str] = []  # what is right, what was seen, and the steps
    place: str = ""  # at which Python stopped: a file, and a line of it


def explain(grader: Grader, check: Check, error: WrongError) -> Explanation:
    """Return the explanation of a check that raised this WrongError."""
    facts = []
    trace = Trace(WORDS, lambda code: is_watched(code, check.function), is_named)
    errors = [error]
    # Not in a debugger, and not what waits for long
    if not grader.limits.is_debugged and grader.limits.stopped_by != CLOCK:
        again = ask_again(grader, check, trace)
        if again:
            errors = again
            error = again[0]
        else:
            facts = ["Called again with the same values, it gave the right result."]
    rows = rows_of(trace, wanted_in(error)) if not facts and not trace.fault else []
    if rows:
        facts = facts_of(check, error, trace)
    hint = hint_for(error, errors)
    below = [*right_lines(error), *(line for fact in facts for line in labelled("seen", fact))]
    steps = f"{check.function} in ASSIGNMENT.md: {grader.steps[check.function]}"
    below += labelled("steps", steps)
    place = ""
    if error.raised and not error.raised.limit:
        place = f"{place_of(error.raised, check.function) or ''}"
    return Explanation(what_is_wrong(error, hint, has_rows=bool(rows)), rows, below, place)


def ask_again(grader: Grader, check: Check, trace: Trace) -> list[WrongError]:
    """Perform a check once more; return its wrong calls. The first one is traced.

    The student's code prints nothing now.
    """
    try:
        with redirect_stdout(StringIO()), redirect_stderr(StringIO()):
            grader.perform(check, trace, goes_on=True)
    except (Exception, KeyboardInterrupt):  # a check may need right results to go on
        if grader.limits.is_pressed:
            raise
    return grader.performance.errors


# --- what the table is about ---------------------------------------------------------------------


def wanted_in(error: WrongError) -> Wanted:
    """Return the values that are wrong, as a table looks for them."""
    subject, found = error.mistake.subject, error.mistake.found
    if error.raised and "NoneType" in error.raised.text:
        found = None
    holder = holder_of(subject, error)
    key = subject.attribute or subject.key
    keys = {(id(holder), key), (id(holder), "axis")}  # a wrong axis puts an end at a wrong place

    def is_wrong(value: Any) -> bool:
        is_found = is_plain(found) and same(value, found)
        parts = value if isinstance(value, tuple) else (value,)
        is_holder = subject.attribute and any(part is holder for part in parts)
        return bool(is_found or is_holder)

    return Wanted(frozenset(keys), frozenset({key}), is_wrong)


def is_plain(value: Any) -> bool:
    """Return whether a value says where it comes from: None, a number, a text or a vector."""
    return value is None or isinstance(value, (Real, str, vector)) and not isinstance(value, bool)


def holder_of(subject: Subject, error: WrongError) -> Any:
    """Return the dictionary or the object that has the value of a subject, or None."""
    function = FUNCTIONS[error.call.function]
    names = dict(zip(function.parameters.split(", "), error.arguments, strict=False))
    result = error.result
    parts = result if isinstance(result, tuple) else (result,)
    names |= dict(zip(filter(None, function.returns.split(", ")), parts, strict=False))
    index, part = subject.list_index, subject.object_name
    with suppress(LookupError, TypeError):
        if part in names:
            return names[part]
        owner = names[subject.owner if subject.owner in names else "pend_list"]
        pend = owner if index is None else owner[index]
        return pend["objects"][OBJECTS.index(part)] if part in OBJECTS else pend
    return None


# --- what is said --------------------------------------------------------------------------------


def hint_for(error: WrongError, others: list[WrongError]) -> str:
    """Return what is known about a mistake, or "". others are all wrong calls of its check."""
    function = error.call.function
    twice = defined_twice(FUNCTIONS[function].file, function)
    if twice:
        return twice
    wrong = [other for other in others if not other.raised]
    hints = {other.hint for other in wrong if other.hint}
    if error.hint and hints <= {error.hint}:
        return error.hint
    if error.is_exchanged and all(other.is_exchanged for other in wrong):
        return EXCHANGED
    return ""


def what_is_wrong(error: WrongError, hint: str, has_rows: bool = False) -> list[str]:
    """Return what is wrong, the call, and both values, as lines of the screen.

    has_rows says whether the lines at which an error has stopped are shown below.
    """
    sentence = f"{error}"
    lines = error.lines
    if error.raised:
        places = [] if has_rows else place_lines(error.raised.places)
        lines = [("", places), *lines]
    end = "" if sentence.endswith((".", "?", "!")) else "."
    pairs = [
        ("wrong", f"{sentence}{end} {hint}".strip()),
        ("called", error.call.lines(error.mistake.subject.list_index or 0)),
        *lines,
    ]
    found = []
    for label, text in pairs:
        if text:
            found += labelled(label, text)
    return found


def right_lines(error: WrongError) -> list[str]:
    """Return what is right in this call, as lines of the screen."""
    values = [f"{name} = {text_of(value)}" for name, value in error.right]
    found = labelled("right here", f"{', '.join(values)}.") if values else []
    if error.help:
        found += labelled("right here", error.help)
    return found


def facts_of(check: Check, error: WrongError, trace: Trace) -> list[str]:
    """Return sentences about what was seen: each names a line, a key or an object."""
    function = FUNCTIONS[check.function]
    names = names_in(code_of(check.function))
    for call in trace.calls:
        names |= names_in(call.code)
    facts = []
    if "relative_filepath" in function.parameters and "NC_FP" in names:
        facts.append("Your function names NC_FP: the file to read is relative_filepath.")
    if error.raised:
        return facts
    facts += unchanged(error, trace)
    facts += returns_in_loops(trace)
    must_name = function.must_name or function.waits_for
    missing = [name for name in must_name if name not in names]
    return [*facts, *(f"No line of your function calls {name}." for name in missing)]


def unchanged(error: WrongError, trace: Trace) -> list[str]:
    """Return a sentence if a value is wrong that was there before, and that no line has changed."""
    subject = error.mistake.subject
    holder = holder_of(subject, error)
    if not subject.key or trace.is_full or trace.has_set((id(holder), subject.key)):
        return []
    arguments = [("", value) for value in error.arguments]
    for source, value in [*arguments, *reversed(trace.given)]:
        parts = value if isinstance(value, list) else [value]
        if any(holder is part for part in parts if isinstance(part, dict)):
            came = f" It came so from your call of {source}." if source else ""
            return [f"No line of your function has changed {subject}.{came}"]
    return []
