"""What a student reads at the end of a run: the explanation of the first mistake, and the grade."""

import os
import sys
from collections import Counter
from dataclasses import dataclass
from textwrap import wrap
from typing import NamedTuple

from grading.assignment import HONOR
from grading.explanation import Explanation
from grading.grade import place_of_failure, Results
from grading.messages import LABEL, labelled
from grading.outcomes import FAILED, FAULT, WAITING
from grading.words import plural
from line_by_line.table import COLUMNS, fitting
from support.root import ROOT
from support.start.output import in_one_line

SCREEN = 40  # lines of a screen; the first one has the dots of pytest, and the last one its counts
MOST_PRINTED = 5  # lines that are shown of what a solution has printed


class Line(NamedTuple):
    """A line that a student reads."""

    text: str
    color: str = ""


@dataclass
class Screen:
    """The screen about the results of a run."""

    results: Results
    notes: list[str]  # about something else

    def lines(self, printed: dict[str, str]) -> list[Line]:
        """Return what a student reads.

        printed has the output of the student's code by the names of the checks that fail.
        """
        failed = self.results.failed()
        end = self.grade_lines()
        if not failed:
            return [*self.unwritten_lines(), *end]
        check, outcome = failed[0]
        title = Line(separator(place_of_failure(check, outcome), "_"), "red")
        explanation = outcome.explanation
        above = explanation.wrong or outcome.message.split("\n")
        below = [*explanation.below, *self.others_line()]
        height = SCREEN - 3 - len([*end, *above, *below])
        table = table_lines(explanation, height)
        output = printed_lines(printed.get(check.name, ""))
        if len([*table, *output]) > height:
            output = []
        return [title, *map(Line, [*above, *table, *below, *output]), *end]

    def others_line(self) -> list[str]:
        """Return a line about the other checks of the first wrong function that fail, if any."""
        functions = [check.function for check, _ in self.results.failed()]
        count = functions.count(functions[0]) - 1
        if not count:
            return []
        checks = plural(count, "more check", "more checks")
        return labelled("also fails", f"{checks} of {functions[0]}")

    def unwritten_lines(self) -> list[Line]:
        """Return the functions that are not written yet, and where the text has the first one."""
        places = self.results.unwritten()
        if not places:
            return []
        lines = [Line(separator("Not written yet", "="))]
        lines += [Line(f"{function} in {place}", "yellow") for function, place in places.items()]
        function = next(iter(places))
        return [*lines, *map(Line, labelled("steps", f"{function} in ASSIGNMENT.md"))]

    def grade_lines(self) -> list[Line]:
        """Return the points of each tier that has begun, the grade, and the next step."""
        graded = self.results.grade()
        lines = [Line(separator("Grade", "="))]
        for tier, counts in graded["tiers"].items():
            if counts["points"] or counts["failed"]:
                lines.append(Line(self.tier_line(tier, counts), color_of(counts)))
        lines += [Line(sentence, "bold") for sentence in self.verdict(graded)]
        for note in self.notes:
            indent = " " * 7
            lines += map(Line, wrap(f"Note:  {note}", COLUMNS, subsequent_indent=indent))
        if self.results.failed():
            return lines
        complete = [tier for tier, counts in graded["tiers"].items() if is_complete(counts)]
        shown = graded["grade"] if self.results.is_whole else "".join(complete[-1:])
        if shown:
            lines.append(Line(f"Look at it:  {command_of(shown)}"))
        if graded["next"]:
            lines.append(Line(f"Next:  {graded['next']}.", "bold"))
        return lines

    def verdict(self, graded: dict) -> list[str]:
        """Return the grade or, if not all checks ran, which tiers are complete."""
        tiers = graded["tiers"]
        if self.results.is_whole:
            missing = self.results.missing_for_a_letter(tiers)
            return wrap(f"Grade: {graded['grade'] or 'none yet'}. {missing}", COLUMNS)
        return [f"Tier {tier} is complete." for tier in tiers if is_complete(tiers[tier])]

    def tier_line(self, tier: str, counts: dict) -> str:
        """Return a line about a tier: points, how many checks failed, and for what others wait."""
        not_run = counts["of"] - counts["points"] - counts["waiting"] - counts["failed"]
        others: Counter[str] = Counter({"not run": not_run})
        for check, outcome in self.results.ran:
            if check.tier == tier and outcome.state in (FAILED, FAULT):
                where = "" if outcome.broken_file else f" in {check.function}"
                others[f"failed{where}"] += 1
            elif check.tier == tier and outcome.is_unwritten:
                others["not written"] += 1
            elif check.tier == tier and outcome.state == WAITING:
                cause = outcome.waits_for
                others[f"wait for {'it' if cause == check.function else cause}"] += 1
        extra = " (extra)" if tier == HONOR else ""
        text = f"{tier:<12}{counts['points']:>3} of {counts['of']} points{extra}"
        causes = [f"{count} {cause}" for cause, count in others.items() if count]
        return shorten(f"{text}: {', '.join(causes)}" if causes else text, COLUMNS)


def separator(title: str, sign: str) -> str:
    """Return a title with a line of signs on both sides."""
    return f" {shorten(title, COLUMNS - 4)} ".center(COLUMNS, sign)


def table_lines(explanation: Explanation, height: int) -> list[str]:
    """Return the rows of an explanation's table for which there is room, below their title."""
    if not explanation.rows:
        return []
    lines, left_out = fitting(explanation.rows, height - 1)
    title = "line by line"
    if left_out:
        title = f"{title} ({plural(left_out, 'row is', 'rows are')} left out)"
    return [f"{'your code':<{LABEL}}{title}", *lines]


def printed_lines(output: str) -> list[str]:
    """Return the first lines of what a solution has printed."""
    lines = [in_one_line(line) for line in output.splitlines()]
    if len(lines) > MOST_PRINTED:
        lines[MOST_PRINTED:] = [f"... ({len(lines)} lines in all)"]
    texts = [shorten(line, COLUMNS - LABEL) for line in lines]
    return labelled("printed", texts) if texts else []


def shorten(text: str, columns: int) -> str:
    """Return a text with at most this number of columns: the end of a longer one is cut off."""
    return text if len(text) <= columns else f"{text[: columns - 3]}..."


def color_of(counts: dict) -> str:
    """Return the color of a tier."""
    if is_complete(counts):
        return "green"
    return "red" if counts["failed"] else "yellow"


def is_complete(counts: dict) -> bool:
    """Return whether a tier has all points."""
    return counts["points"] == counts["of"]


def command_of(tier: str) -> str:
    """Return the command that shows the cradle of a complete tier, in the project's folder."""
    program = "visualize_double_cradle_run.py" if tier == HONOR else "visualize_cradle_run.py"
    python = sys.executable.removeprefix(f"{ROOT}{os.sep}")
    if os.path.isabs(python):  # it is in another folder, maybe of another computer
        python = "python"
    return f"{python} src/{program}"
