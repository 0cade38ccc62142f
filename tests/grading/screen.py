"""What a student reads at the end of a run: the first mistake, the grade and the next step."""

from collections import Counter
from textwrap import wrap
from typing import NamedTuple

from grading.grade import (
    checks_with_outcome,
    failed_checks,
    grade,
    LINE_BY_LINE,
    MORE,
    next_step,
    StepPart,
)
from grading.handout import SUITES
from grading.messages import plural
from grading.outcomes import Outcome, PASSED, WAITING
from grading.ranks import ALWAYS, NEVER
from support.start.output import in_one_line

SCREEN = 40  # lines of a screen; the first one has the dots of pytest, and the last one its counts
PRINTED = 5  # lines that are shown of what a solution has printed
MOST_CAUSES = 3  # for which checks wait


class Line(NamedTuple):
    """A line that a student reads."""

    text: str
    color: str = ""


def report(
    outcomes: dict[str, Outcome], printed: dict[str, str], columns: int, advice: str
) -> list[Line]:
    """Return what a student reads about outcomes.

    printed has the output of the student's code by the names of the checks that fail; advice is
    about something else.
    """
    lines = []
    failed = failed_checks(outcomes)
    if failed:
        first = failed[0]
        message = [Line(text) for text in outcomes[first.name].message.split("\n")]
        if outcomes[first.name].broken_file:  # a file that Python cannot read: nothing else matters
            return [Line(separator("Python cannot read a file", "=", columns)), *message]
        lines.append(Line(separator(first.title, "_", columns), "red"))
        for text in printed_lines(printed.get(first.name, "")):
            lines.append(Line(shorten(f"printed     {text}", columns)))
        lines += message
    else:
        lines += unwritten_lines(outcomes, columns)
    lines.append(Line(separator("Grade", "=", columns)))
    return [*lines, *table(outcomes, columns, advice, SCREEN - 2 - len(lines))]


def printed_lines(output: str) -> list[str]:
    """Return the lines that are shown of the output of a student's code."""
    lines = [in_one_line(line) for line in output.splitlines()]
    if len(lines) > PRINTED:
        lines[PRINTED:] = [f"... ({len(lines)} lines in all)"]
    return lines


def unwritten_lines(outcomes: dict[str, Outcome], columns: int) -> list[Line]:
    """Return the functions that are not written yet, with their places."""
    places = {}
    for check in checks_with_outcome(outcomes):
        if outcomes[check.name].place:
            places[check.function] = outcomes[check.name].place
    if not places:
        return []
    lines = [Line(f"{function} in {place}", "yellow") for function, place in places.items()]
    return [Line(separator("Not written yet", "=", columns)), *lines]


def shorten(text: str, columns: int) -> str:
    """Return a text with at most this number of columns: the end of a longer one is cut off."""
    return text if len(text) <= columns else f"{text[: columns - 3]}..."


def separator(title: str, sign: str, columns: int) -> str:
    """Return a title with a line of signs on both sides."""
    return f" {shorten(title, columns - 4)} ".center(columns, sign)


def table(
    outcomes: dict[str, Outcome], columns: int, advice: str = "", height: int = SCREEN
) -> list[Line]:
    """Return the points and the grade of outcomes, and the next step, in at most height lines.

    Without the first tier, they say which tiers are complete, in place of the grade.
    """
    graded = grade(outcomes)
    lines = [*tier_lines(graded["tiers"]), *waiting_lines(outcomes)]
    sentences = verdict(graded)
    hints = [outcome.advice for outcome in outcomes.values() if outcome.state == PASSED]
    for hint in dict.fromkeys([*hints, advice]):  # each once
        sentences += wrap(hint, columns, initial_indent="Note:  ", subsequent_indent=MORE)
    sentences += next_step_rows(outcomes, columns, height - len(lines) - len(sentences))
    return [*lines, *(Line(sentence, "bold") for sentence in sentences)]


def tier_lines(tiers: dict[str, dict]) -> list[Line]:
    """Return a line for each tier, and one with the titles above them."""
    lines = [Line(tier_row("tier", "passed", "waiting", "failed", "points"), "bold")]
    for tier, counts in tiers.items():
        points = f"{counts['points']}/{counts['of']}"
        text = tier_row(tier, counts["passed"], counts["waiting"], counts["failed"], points)
        lines.append(Line(text, color_of(counts)))
    return lines


def color_of(counts: dict) -> str:
    """Return the color of a tier."""
    if is_complete(counts):
        return "green"
    return "red" if counts["failed"] else "yellow"


def tier_row(tier: str, passed: object, waiting: object, failed: object, points: str) -> str:
    """Return a row of the table of tiers."""
    return f"{tier:<12}{passed:>8}{waiting:>9}{failed:>8}{points:>10}"


def is_complete(counts: dict) -> bool:
    """Return whether a tier has all points."""
    return counts["points"] == counts["of"]


def waiting_lines(outcomes: dict[str, Outcome]) -> list[Line]:
    """Return for what most checks wait."""
    causes: Counter[str] = Counter()
    for outcome in outcomes.values():
        if outcome.state == WAITING and not outcome.place:
            causes[outcome.waits_for] += 1
    lines = []
    for cause, count in causes.most_common(MOST_CAUSES):
        wait = plural(count, "check waits", "checks wait")
        lines.append(Line(f"{wait} for {cause}", "yellow"))
    return lines


def verdict(graded: dict) -> list[str]:
    """Return the grade or, without the first tier, which tiers are complete."""
    if next(iter(SUITES)) in graded["tiers"]:
        return [f"Grade: {graded['grade'] or 'none yet'}."]
    sentences = []
    for tier, counts in graded["tiers"].items():
        sentences.append(f"Tier {tier} is {'complete' if is_complete(counts) else 'not complete'}.")
    return sentences


def next_step_rows(outcomes: dict[str, Outcome], columns: int, height: int) -> list[str]:
    """Return the next step, and as much about it as there is room for in this number of rows."""
    step, parts = next_step(outcomes)
    rows = wrap(f"Next:  {step}.", columns, subsequent_indent=MORE)
    parts = [part._replace(lines=wrapped(part.lines, columns)) for part in parts]
    kept = fitting(parts, height - len(rows))
    for part in kept:
        rows += part.lines
    left_out = number_of_rows(parts) - number_of_rows(kept)
    if left_out:
        left = plural(left_out, "line is", "lines are")
        title = f"{LINE_BY_LINE.removesuffix(':')} ({left} left out):"
        rows = [text.replace(LINE_BY_LINE, title) for text in rows]
    return rows


def number_of_rows(parts: list[StepPart]) -> int:
    """Return how many of these parts are rows of a trace table."""
    return len([part for part in parts if part.is_row])


def wrapped(lines: list[str], columns: int) -> list[str]:
    """Return lines in columns; those that are indented, as in a trace table, stay as they are."""
    found = []
    for line in lines:
        if line.startswith(" "):
            found.append(line)
        else:
            found += wrap(line, columns, initial_indent=MORE, subsequent_indent=MORE)
    return found


def fitting(parts: list[StepPart], height: int) -> list[StepPart]:
    """Return the parts for which there is room, those of the lowest ranks, in their order."""
    kept = set()
    for i in sorted(range(len(parts)), key=lambda i: parts[i].rank):
        has_room = len(parts[i].lines) <= height and parts[i].rank != NEVER
        if has_room or parts[i].rank == ALWAYS:
            kept.add(i)
            height -= len(parts[i].lines)
    found: list[StepPart] = []
    for i in sorted(kept, reverse=True):
        # The title of a helper's table needs a row below it
        if not parts[i].is_title or (found and found[0].is_row):
            found.insert(0, parts[i])
    return found
