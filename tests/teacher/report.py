"""The grade that a run of pytest has written, and the table and the texts of a class."""

import csv
import json
import re
from collections import Counter
from contextlib import suppress

from grading.assignment import highest, HONOR, SUITES
from support.files.data_file import whole_file
from support.start.output import in_one_line

KEPT = "state", "message"  # of what a run says of a check
MOST_LETTERS = 10_000  # of a text
MOST_LINES = 200  # of a text
MOST_OF_CELL = 2000  # letters of a cell
# The begin of one: of a cell, or where a spreadsheet in many countries splits it. Some read wide
# signs as well.
FORMULA = re.compile(r"(^|;)(\s*[=+\-@\uff1d\uff0b\uff0d\uff20])")


def read_grade(empty, output) -> dict | None:
    """Return what pytest --grade-json has written, without texts that may be forged or too long.

    It has grade, points by tier, next, text, checks, and whether it is final. Return None if it has
    not the form of empty, the grade of the starter.
    """
    with suppress(Exception):  # of another form
        found = json.loads(output)
        if len(found["checks"]) != len(empty["checks"]):
            return None
        checks = {}
        points = Counter()
        for name, check in empty["checks"].items():
            checks[name] = check | {key: safe(found["checks"][name][key]) for key in KEPT}
            if checks[name]["state"] == "passed":
                points[check["tier"]] += 1
        most = {tier: counts["of"] for tier, counts in empty["tiers"].items()}
        return {
            "grade": highest(points, most),
            "points": {tier: points[tier] for tier in SUITES},
            "next": safe(found["next"]),
            "text": safe("\n".join(found["text"])),
            "checks": checks,
            "final": found["final"] is True,
        }
    return None


def no_grade(empty, output) -> dict:
    """Return the grade of a run that has written none, with the start of what it has printed."""
    checks = {}
    for name, check in empty["checks"].items():
        checks[name] = {**check, "message": "was not run"}
    return {
        "grade": None,
        "points": dict.fromkeys(SUITES, 0),
        "next": "",
        "text": safe(output[:MOST_LETTERS].decode(errors="replace")),
        "checks": checks,
    }


def safe(text) -> str:
    """Return the start of a text, without letters that a terminal does not show."""
    lines = text[:MOST_LETTERS].split("\n")[:MOST_LINES]
    return "\n".join(map(in_one_line, lines))


def own_folder(folder) -> None:
    """Make a folder that only this user can read and write, or let one be so.

    Raises an OSError if it cannot be.
    """
    folder.mkdir(parents=True, exist_ok=True)
    folder.chmod(0o700)


def cell(text) -> str:
    """Return a text as a cell that no spreadsheet takes for a formula."""
    return FORMULA.sub(r"\1'\2", in_one_line(text[:MOST_OF_CELL]))


class Report:
    """The files of a class: a text for each student as the results come, and a table in the end."""

    def __init__(self, folder, gradescope):
        self.folder = folder
        self.gradescope = gradescope  # the folder for Gradescope, or None
        self.rows = []
        self.grades = Counter()
        self.file = folder / "grades.csv"

    def add(self, student, seconds, problems, result) -> None:
        """Write a student's text, and take what the table needs. Raises an OSError if this fails.

        result is as read_grade returns it.
        """
        grade = result["grade"] or "none"
        self.grades[grade] += 1
        points = dict(result["points"])
        extra = points.pop(HONOR)
        self.rows.append(
            [
                cell(student),
                grade,
                *points.values(),
                sum(points.values()),
                extra,
                cell(result["next"]),
                round(seconds),  # "1.5" is the first of May in some countries
                cell(". ".join(problems)),
            ]
        )
        text = "\n".join([student, *problems, "", result["text"], ""])
        with whole_file(self.folder / f"{student}.txt") as out:
            out.write(text.encode(errors="backslashreplace").decode())
        if self.gradescope:
            write_gradescope(self.gradescope / student, seconds, problems, result)

    def write(self) -> None:
        """Write the table, with a line for each student. Raises an OSError if this fails."""
        with whole_file(self.file) as out:
            out.write("\ufeff")  # Excel then reads it as UTF-8
            writer = csv.writer(out)
            tiers = [tier for tier in SUITES if tier != HONOR]
            first = ["student", "grade", *tiers, "points", HONOR]
            writer.writerow([*first, "next", "seconds", "problems"])
            writer.writerows(sorted(self.rows))

    def summary(self, count) -> list[str]:
        """Return the lines that a teacher of a class of this count reads in the end."""
        lines = ["grade        solutions"]
        for grade in [*reversed(SUITES), "none"]:
            lines.append(f"{grade:<12} {self.grades[grade]:>9}")
        lines.append("")
        done = f"{len(self.rows)} of {count} solutions are in {self.file}"
        lines.append(in_one_line(f"{done}, with a text for each student next to it"))
        if len(self.rows) < count:
            lines.append(f"Missing: {count - len(self.rows)}")
        return lines


def write_gradescope(folder, seconds, problems, result) -> None:
    """Write results.json as Gradescope reads it. Raises an OSError if this fails.

    It has no field for extra points: only the name of a test says that it is extra.
    https://gradescope-autograders.readthedocs.io/en/latest/specs/
    """
    tests = []
    for check in result["checks"].values():
        tier = f"{HONOR} (extra)" if check["tier"] == HONOR else check["tier"]
        tests.append(
            {
                "name": f"{tier}: {check['function']}: {check['title']}",
                "score": int(check["state"] == "passed"),
                "max_score": 1,
                "output": check["message"] or "passed",
            }
        )
    whole = {
        "output": "\n".join([*problems, result["text"]]),
        "execution_time": round(seconds),
        "score": sum(test["score"] for test in tests),
        "visibility": "visible",
        "tests": tests,
    }
    own_folder(folder)
    with whole_file(folder / "results.json") as out:
        json.dump(whole, out, indent=1)
