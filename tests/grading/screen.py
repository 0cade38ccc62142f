"""What a student reads at the end of a run: the story of the first mistake, and the grade."""

from collections import Counter
from textwrap import wrap
from typing import NamedTuple

from grading.failure import steps_of
from grading.grade import (
    failed_checks,
    grade,
    next_step,
    place_of_failure,
    unwritten_functions,
)
from grading.grader import Check, checks
from grading.handout import HONOR, SUITES
from grading.outcomes import Outcome, PASSED, WAITING
from grading.room import fitting, LABEL, labelled, Part, Rank
from line_by_line.layout import COLUMNS
from support.start.output import in_one_line

SCREEN = 40  # lines of a screen; the first one has the dots of pytest, and the last one its counts
MOST_PRINTED = 5  # lines that are shown of what a solution has printed


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
    failed = failed_checks(outcomes)
    end = grade_lines(outcomes, columns, advice)
    height = SCREEN - 3 - len(end)
    if failed:
        first = failed[0]
        place = place_of_failure(first, outcomes[first.name])
        story = story_of(failed, outcomes, printed.get(first.name, ""))
        lines = [Line(separator(place, "_", columns), "red")]
        lines += map(Line, fitting(story, height))
        return lines if outcomes[first.name].broken_file else [*lines, *end]
    return [*unwritten_lines(outcomes, columns, height), *end]


def story_of(failed: list[Check], outcomes: dict[str, Outcome], output: str) -> list[Part]:
    """Return the story of the first check that fails, with a line for each other one."""
    first = failed[0]
    outcome = outcomes[first.name]
    parts = [Part(Rank.ALWAYS, labelled("check", first.title))] if not outcome.broken_file else []
    parts += outcome.parts or [Part(Rank.ALWAYS, outcome.message.split("\n"))]
    for check in failed[1:]:
        text = shorten(f"{check.function}: {check.title}", COLUMNS - LABEL)
        parts.append(Part(Rank.OTHER_CHECKS, labelled("also fails", text)))
    lines = [in_one_line(line) for line in output.splitlines()]
    if len(lines) > MOST_PRINTED:
        lines[MOST_PRINTED:] = [f"... ({len(lines)} lines in all)"]
    if lines:
        texts = [shorten(line, COLUMNS - LABEL) for line in lines]
        parts.append(Part(Rank.PRINTED, labelled("printed", texts)))
    return parts


def unwritten_lines(outcomes: dict[str, Outcome], columns: int, height: int) -> list[Line]:
    """Return the functions that are not written yet, and the steps of the first one."""
    places = unwritten_functions(outcomes)
    if not places:
        return []
    lines = [Line(separator("Not written yet", "=", columns))]
    lines += [Line(f"{function} in {place}", "yellow") for function, place in places.items()]
    function = next(iter(places))
    steps = fitting(steps_of(function), height - len(lines))
    return [*lines, *map(Line, [f"Next: {function}", *steps])]


def shorten(text: str, columns: int) -> str:
    """Return a text with at most this number of columns: the end of a longer one is cut off."""
    return text if len(text) <= columns else f"{text[: columns - 3]}..."


def separator(title: str, sign: str, columns: int) -> str:
    """Return a title with a line of signs on both sides."""
    return f" {shorten(title, columns - 4)} ".center(columns, sign)


def grade_lines(outcomes: dict[str, Outcome], columns: int, advice: str) -> list[Line]:
    """Return the points of each tier that has begun, the grade, and the next step.

    Without the first tier, they say which tiers are complete, in place of the grade.
    """
    graded = grade(outcomes)
    lines = [Line(separator("Grade", "=", columns))]
    for tier, counts in graded["tiers"].items():
        if counts["passed"] or counts["failed"]:
            lines.append(Line(tier_line(tier, counts, outcomes), color_of(counts)))
    lines += [Line(sentence, "bold") for sentence in verdict(graded)]
    hints = [outcome.advice for outcome in outcomes.values() if outcome.state == PASSED]
    for hint in dict.fromkeys([*hints, advice]):  # each once
        lines += map(Line, wrap(hint, columns, initial_indent="Note:  ", subsequent_indent=" " * 7))
    if not failed_checks(outcomes):
        lines.append(Line(f"Next:  {next_step(outcomes)}.", "bold"))
        if graded["grade"] == HONOR:  # the double cradle has functions without checks
            text = "src/visualize_double_cradle_run.py shows the double cradle, or what it needs."
            lines.append(Line(f"       {text}"))
    return lines


def tier_line(tier: str, counts: dict, outcomes: dict[str, Outcome]) -> str:
    """Return a line about a tier: its points, how many checks failed, and for what others wait."""
    others: Counter[str] = Counter({"failed": counts["failed"]})
    for check in checks(tier=tier):
        outcome = outcomes.get(check.name)
        if outcome and outcome.is_unwritten:
            others["not written"] += 1
        elif outcome and outcome.state == WAITING:
            others[f"wait for {outcome.waits_for}"] += 1
    text = f"{tier:<12}{counts['points']:>3} of {counts['of']} points"
    causes = [f"{count} {cause}" for cause, count in others.items() if count]
    return shorten(f"{text}: {', '.join(causes)}" if causes else text, COLUMNS)


def color_of(counts: dict) -> str:
    """Return the color of a tier."""
    if is_complete(counts):
        return "green"
    return "red" if counts["failed"] else "yellow"


def is_complete(counts: dict) -> bool:
    """Return whether a tier has all points."""
    return counts["points"] == counts["of"]


def verdict(graded: dict) -> list[str]:
    """Return the grade or, without the first tier, which tiers are complete."""
    if next(iter(SUITES)) in graded["tiers"]:
        return [f"Grade: {graded['grade'] or 'none yet'}."]
    sentences = []
    for tier, counts in graded["tiers"].items():
        sentences.append(f"Tier {tier} is {'complete' if is_complete(counts) else 'not complete'}.")
    return sentences
