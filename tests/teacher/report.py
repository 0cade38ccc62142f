"""The grade that a run of pytest has written, and what a teacher gets of a class: tables and a
summary.
"""

import csv
import hashlib
import json
import os
from collections import Counter
from contextlib import suppress
from stat import S_IWGRP, S_IWOTH

from grading.handout import highest, SUITES
from support.files.data_file import whole_file
from support.start.output import in_one_line

SEEN = "state", "message", "place", "hint"  # of a check
MOST_LETTERS, MOST_LINES, MOST_OF_CELL = 10_000, 200, 2000  # of a text, and letters of a cell


def read_grade(empty, output) -> dict | None:
    """Return what pytest --grade-json has written: grade, points by tier, next, text, checks, and
    whether it is final.

    Return None without the form of empty, the grade of the starter.
    """
    with suppress(Exception):  # of another form
        read = json.loads(output)
        if len(read["checks"]) != len(empty["checks"]):
            return None
        checks = {}
        for name, check in empty["checks"].items():
            checks[name] = check | {key: safe(read["checks"][name][key]) for key in SEEN}
        points = Counter(check["tier"] for check in checks.values() if check["state"] == "passed")
        return {
            "grade": highest(
                points, {tier: counts["of"] for tier, counts in empty["tiers"].items()}
            ),
            "points": {tier: points[tier] for tier in SUITES},
            "next": safe(read["next"]),
            "text": safe("\n".join(read["text"])),
            "checks": checks,
            "final": read["final"] is True,
        }
    return None


def no_grade(empty, output) -> dict:
    """Return the grade of a run that has written none, with the beginning of what it has printed."""
    return {
        "grade": None,
        "points": dict.fromkeys(SUITES, 0),
        "next": "",
        "text": safe(output[:MOST_LETTERS].decode(errors="replace")),
        "checks": {
            name: {**check, "message": "was not run"} for name, check in empty["checks"].items()
        },
    }


def safe(text) -> str:
    """Return the beginning of a text, without letters that a terminal does not show."""
    return "\n".join(in_one_line(line) for line in text[:MOST_LETTERS].split("\n")[:MOST_LINES])


def results_in(file):
    """Yield the results in results.jsonl; a line that is damaged, or of another version, is none."""
    if not file.exists():
        return
    with open(file, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            with suppress(Exception):
                result = json.loads(line)
                if result.pop("sum") == digest_of(result):
                    yield result


def line_of(result) -> str:
    """Return a result as a line of results.jsonl, with a check sum."""
    return json.dumps({**result, "sum": digest_of(result)}) + "\n"


def digest_of(*values) -> str:
    """Return a hash of the values."""
    return hashlib.sha256(repr(values).encode()).hexdigest()


def own_folder(folder) -> None:
    """Make a folder that only this user can read and write, or let one be so; raise an OSError if
    it cannot be.

    A link in it could lead the program to another file.
    """
    with suppress(FileExistsError):
        folder.mkdir(mode=0o700, parents=True)
    status = folder.lstat()
    is_ours = (
        not hasattr(os, "geteuid")
        or status.st_uid == os.geteuid()
        and not status.st_mode & (S_IWGRP | S_IWOTH)
    )
    if (
        not is_ours
        or not folder.is_dir()
        or any(path.is_symlink() for path in (folder, *folder.iterdir()))
    ):
        raise OSError(
            0, "allowed is a new folder, or one that only you can write, without links", f"{folder}"
        )
    folder.chmod(0o700)


def cell(text) -> str:
    """Return a text that no spreadsheet takes for a formula or, where it splits at ";", for several
    cells.
    """
    text = in_one_line(text[:MOST_OF_CELL]).replace(";", ",")
    return f"'{text}" if text.lstrip()[:1] in tuple("=+-@") else text


class Report:
    """The files of a class, written as its results come; and the counts for the summary."""

    def __init__(self):
        self.rows = []
        self.grades = Counter()
        self.failed = Counter()  # checks
        self.hints = Counter()  # that a student sees: of the first check that fails

    def add(self, folder, result) -> None:
        """Write a student's text into a folder, and take what the tables need.

        Raises an OSError if this fails.
        """
        student, problems = result["student"], result["problems"]
        points = [*result["points"].values()]
        grade = result["grade"] or "none"
        row = [
            cell(student),
            grade,
            *points,
            sum(points),
            cell(result["next"]),
            f"{result['seconds']:.1f}",
        ]
        self.rows.append([*row, cell(". ".join(problems))])
        text = "\n".join([student, *problems, "", result["text"], ""])
        (folder / f"{student}.txt").write_text(text, encoding="utf-8", errors="backslashreplace")
        self.grades[grade] += 1
        failed = [
            (name, check) for name, check in result["checks"].items() if check["state"] == "failed"
        ]
        self.failed.update(f"{name} ({check['function']})" for name, check in failed)
        if failed:
            _, first = failed[0]
            if first["hint"]:
                self.hints[f"{first['hint']} ({first['function']})"] += 1

    def write(self, file) -> None:
        """Write grades.csv, with a line for each student. Raises an OSError if this fails."""
        with whole_file(file) as out:
            out.write("\ufeff")  # Excel then reads it as UTF-8
            writer = csv.writer(out)
            writer.writerow(["student", "grade", *SUITES, "points", "next", "seconds", "problems"])
            writer.writerows(sorted(self.rows))

    def summary(self) -> list[str]:
        """Return the lines that a teacher reads in the end."""
        lines = ["grade        solutions"]
        lines += [f"{grade:<12} {self.grades[grade]:>9}" for grade in [*reversed(SUITES), "none"]]
        for title, counts in (
            ("Checks that most solutions fail", self.failed),
            ("Hints that most students see", self.hints),
        ):
            rows = [
                f"{count:>5}  {in_one_line(words)[:150]}" for words, count in counts.most_common(5)
            ]
            lines += ["", title, *rows] if rows else []
        return lines


def write_gradescope(folder, result) -> None:
    """Write results.json: https://gradescope-autograders.readthedocs.io/en/latest/specs/. It may
    raise an OSError.
    """
    tests = []
    for check in result["checks"].values():
        title = f"{check['tier']}: {check['function']}: {check['title']}"
        points = int(check["state"] == "passed")
        tests.append(
            {"name": title, "score": points, "max_score": 1, "output": check["message"] or "passed"}
        )
    whole = {
        "output": "\n".join([*result["problems"], result["text"]]),
        "execution_time": round(result["seconds"]),
        "score": sum(test["score"] for test in tests),
        "max_score": len(tests),
        "visibility": "visible",
        "tests": tests,
    }
    own_folder(folder)
    with whole_file(folder / "results.json") as out:
        json.dump(whole, out, indent=1)
