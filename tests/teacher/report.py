"""What a teacher gets of a graded class: grades.csv, Gradescope's results, and a summary."""

import csv
import hashlib
import json
import re
from collections import Counter
from contextlib import suppress
from typing import NamedTuple

from grading.grade import grade, whole_step
from grading.grader import CHECKS, FAILED, Outcome, PASSED, WAITING
from grading.handout import SUITES
from support.files.data_file import whole_file
from support.start.output import in_one_line


class Result(NamedTuple):
    """A graded solution. results.jsonl has one in each line."""

    student: str
    digest: str  # of the solution and of the grader
    outcomes: dict[str, Outcome]
    seconds: float
    problems: list[str]


def results_in(file) -> dict[str, Result]:
    """Return the results in results.jsonl by student; a line that is damaged, or of another version, is none."""
    results = {}
    for line in file.read_text(encoding="utf-8", errors="replace").splitlines() if file.exists() else []:
        with suppress(ValueError, TypeError, KeyError, AttributeError, RecursionError):
            fields = json.loads(line)
            if fields.pop("sum") == digest_of(fields):
                outcomes = {name: Outcome(*each) for name, each in fields.pop("outcomes").items()}
                results[fields["student"]] = Result(**fields, outcomes=outcomes)
    return results


def line_of(result) -> str:
    """Return a result as a line of results.jsonl, with a check sum."""
    fields = json.loads(json.dumps(result._asdict()))
    return json.dumps({**fields, "sum": digest_of(fields)}) + "\n"


def file_name(student) -> str:
    """Return a name for a student's files that every system takes: short, and another one for each student."""
    plain = re.sub(r"[^\w .()+@-]", "_", student).strip(" .").encode()[:100].decode(errors="ignore")
    return plain if plain == student else f"{plain}-{digest_of(student)[:8]}"


def digest_of(*values) -> str:
    """Return a hash of the values."""
    return hashlib.sha256(repr(values).encode()).hexdigest()


def cell(text) -> str:
    """Return a text that no spreadsheet takes for a formula."""
    return f"'{text}" if text[:1] in tuple("=+-@\t\r") else text


def write_grades(file, results) -> None:
    """Write grades.csv: a line for each student. Raises an OSError if this fails."""
    with whole_file(file) as out:
        writer = csv.writer(out)
        writer.writerow(["student", "grade", *SUITES, "points", "next", "seconds", "problems"])
        for student, _, outcomes, seconds, problems in results:
            graded = grade(outcomes)
            points = [graded["tiers"].get(tier, {"points": 0})["points"] for tier in SUITES]
            row = [cell(student), graded["grade"] or "none", *points, sum(points), cell(graded["next"])]
            writer.writerow([*row, f"{seconds:.1f}", cell("; ".join(problems))])


def write_gradescope(folder, result) -> None:
    """Write the result for Gradescope. Raises an OSError if this fails.

    The keys are those of https://gradescope-autograders.readthedocs.io/en/latest/specs/.
    """
    tests, graded = [], grade(result.outcomes)
    for name, check in CHECKS.items():
        outcome = result.outcomes.get(name, Outcome(WAITING, "was not run"))
        title, score = f"{check.tier}: {check.function}: {check.title}", int(outcome.state == PASSED)
        seen = {"output": outcome.message or "passed", "visibility": "visible"}
        tests.append({"name": title, "score": score, "max_score": 1, **seen})
    words = [f"Grade: {graded['grade'] or 'none yet'}.", f"Next: {whole_step(graded)}.", *result.problems]
    seen = {"output": "\n".join(words), "visibility": "visible"}
    score = {"score": sum(test["score"] for test in tests), "max_score": len(tests)}
    folder.mkdir(parents=True, exist_ok=True)
    with whole_file(folder / "results.json") as out:
        json.dump({**score, "execution_time": round(result.seconds), **seen, "tests": tests}, out, indent=1)


def summary(results) -> list[str]:
    """Return the lines that a teacher reads in the end."""
    grades = Counter(grade(result.outcomes)["grade"] for result in results)
    failed: Counter = Counter()
    hints: Counter = Counter()  # that students read: only the first failure shows its hint
    for result in results:
        fails = [name for name in CHECKS if name in result.outcomes and result.outcomes[name].state == FAILED]
        failed.update(f"{name} ({CHECKS[name].function})" for name in fails)
        seen = [(result.outcomes[name].hint, CHECKS[name].function) for name in fails[:1]]
        hints.update(f"{hint} ({function})" for hint, function in seen if hint)
    lines = ["grade        solutions"]
    lines += [f"{grade or 'none':<12} {grades[grade]:>9}" for grade in [*reversed(SUITES), None]]
    for title, counts in (("Checks that most solutions fail", failed), ("Hints that most students see", hints)):
        rows = [f"{count:>5}  {in_one_line(words)[:150]}" for words, count in counts.most_common(5)]
        lines += ["", title, *rows] if rows else []
    return lines
