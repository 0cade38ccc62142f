"""What a student reads at the end of a run: the story of the first mistake, and the grade."""

from collections import Counter
from dataclasses import dataclass
from textwrap import wrap
from typing import NamedTuple

from grading.grade import place_of_failure, Results
from grading.handout import HONOR, SUITES
from grading.messages import LABEL, labelled
from grading.outcomes import PASSED, WAITING
from grading.story import Story
from grading.words import plural
from line_by_line.table import COLUMNS, fitting
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
    steps: dict[str, str]  # how each function is written
    columns: int
    notes: list[str]  # about something else
    changed: list[str]  # which given functions have changed

    def lines(self, printed: dict[str, str]) -> list[Line]:
        """Return what a student reads.

        printed has the output of the student's code by the names of the checks that fail.
        """
        failed = self.results.failed()
        end = self.grade_lines()
        if not failed:
            return [*self.unwritten_lines(), *end]
        check, outcome = failed[0]
        title = Line(self.separator(place_of_failure(check, outcome), "_"), "red")
        story = outcome.story
        if outcome.broken_file:
            return [title, *map(Line, story.wrong)]
        above = [line for sentence in self.changed for line in labelled("given", sentence)]
        above += story.wrong or outcome.message.split("\n")
        below = [*story.below, *self.others_line()]
        height = SCREEN - 3 - len([*end, *above, *below])
        table = table_lines(story, height)
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
        """Return the functions that are not written yet, and the steps of the first one."""
        places = self.results.unwritten()
        if not places:
            return []
        lines = [Line(self.separator("Not written yet", "="))]
        lines += [Line(f"{function} in {place}", "yellow") for function, place in places.items()]
        function = next(iter(places))
        return [
            *lines,
            Line(f"Next: {function}"),
            *map(Line, labelled("steps", self.steps[function])),
        ]

    def separator(self, title: str, sign: str) -> str:
        """Return a title with a line of signs on both sides."""
        return f" {shorten(title, self.columns - 4)} ".center(self.columns, sign)

    def grade_lines(self) -> list[Line]:
        """Return the points of each tier that has begun, the grade, and the next step.

        Without the first tier, they say which tiers are complete, in place of the grade.
        """
        graded = self.results.grade()
        lines = [Line(self.separator("Grade", "="))]
        for tier, counts in graded["tiers"].items():
            if counts["passed"] or counts["failed"]:
                lines.append(Line(self.tier_line(tier, counts), color_of(counts)))
        lines += [Line(sentence, "bold") for sentence in verdict(graded)]
        passed = [outcome for _, outcome in self.results.ran if outcome.state == PASSED]
        notes = [*(outcome.advice for outcome in passed if outcome.advice), *self.notes]
        failed = self.results.failed()
        if not failed:
            notes += self.changed
        for note in dict.fromkeys(notes):  # each once
            indent = " " * 7
            lines += map(Line, wrap(f"Note:  {note}", self.columns, subsequent_indent=indent))
        if not failed:
            lines.append(Line(f"Next:  {graded['next']}.", "bold"))
            if graded["grade"] == HONOR:  # the double cradle has functions without checks
                text = "src/visualize_double_cradle_run.py shows the double cradle."
                lines.append(Line(f"       {text}"))
        return lines

    def tier_line(self, tier: str, counts: dict) -> str:
        """Return a line about a tier: points, how many checks failed, and for what others wait."""
        others: Counter[str] = Counter({"failed": counts["failed"]})
        for check, outcome in self.results.ran:
            if check.tier == tier and outcome.is_unwritten:
                others["not written"] += 1
            elif check.tier == tier and outcome.state == WAITING:
                others[f"wait for {outcome.waits_for}"] += 1
        text = f"{tier:<12}{counts['points']:>3} of {counts['of']} points"
        causes = [f"{count} {cause}" for cause, count in others.items() if count]
        return shorten(f"{text}: {', '.join(causes)}" if causes else text, COLUMNS)


def table_lines(story: Story, height: int) -> list[str]:
    """Return the rows of a story's table for which there is room, below their title."""
    if not story.rows:
        return []
    lines, left_out = fitting(story.rows, height - 1)
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


def verdict(graded: dict) -> list[str]:
    """Return the grade or, without the first tier, which tiers are complete."""
    if next(iter(SUITES)) in graded["tiers"]:
        return [f"Grade: {graded['grade'] or 'none yet'}."]
    sentences = []
    for tier, counts in graded["tiers"].items():
        sentences.append(f"Tier {tier} is {'complete' if is_complete(counts) else 'not complete'}.")
    return sentences
