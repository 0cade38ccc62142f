"""The grade that a run of pytest has written, and what a teacher gets of a class: tables and a summary."""

import csv
import hashlib
import json
import re
from collections import Counter
from contextlib import suppress

from grading.handout import highest, SUITES
from support.files.data_file import whole_file
from support.start.output import in_one_line
from teacher import one_run

SEEN = "state", "message", "place", "hint"  # of a check
MOST_LETTERS, MOST_LINES, MOST_OF_CELL = 10_000, 200, 2000  # of a text, and letters of a cell


def read_grade(empty, status, output, problems) -> dict:
    """Return what pytest --grade-json has written: grade, points by tier, next, text, checks, and the problems.

    Without the form of empty, the grade of the starter, or if the exit status does not agree, no check is passed.
    """
    checks, told = {}, {"next": "", "text": safe(output[:MOST_LETTERS].decode(errors="replace"))}
    with suppress(Exception):  # of another form
        read = json.loads(output)
        told = {"next": safe(read["next"]), "text": safe("\n".join(read["text"]))}
        for name, check in empty["checks"].items():
            checks[name] = check | {key: safe(read["checks"][name][key]) for key in SEEN}
        points = Counter(check["tier"] for check in checks.values() if check["state"] == "passed")
        if len(read["checks"]) == len(checks) and status == int(points.total() < len(checks)):
            most = {tier: counts["of"] for tier, counts in empty["tiers"].items()}
            grade = {"grade": highest(points, most), "points": {tier: points[tier] for tier in SUITES}}
            return {**grade, **told, "checks": checks, "problems": problems}
    late, ended = f"pytest took longer than {one_run.WHOLE} s", f"pytest ended with status {status}"
    how = status if isinstance(status, str) else late if status == one_run.LATE else ended
    checks = {name: {**check, "message": "was not run"} for name, check in empty["checks"].items()}
    grade = {"grade": None, "points": dict.fromkeys(SUITES, 0)}
    return {**grade, **told, "checks": checks, "problems": [*problems, f"no grade: {how}"]}


def safe(text) -> str:
    """Return the beginning of a text, without letters that a terminal does not show."""
    return "\n".join(in_one_line(line) for line in text[:MOST_LETTERS].split("\n")[:MOST_LINES])


def results_in(file) -> dict[str, dict]:
    """Return the results in results.jsonl by student; a line that is damaged, or of another version, is none."""
    results = {}
    for line in file.read_text(encoding="utf-8", errors="replace").splitlines() if file.exists() else []:
        with suppress(Exception):
            result = json.loads(line)
            if result.pop("sum") == digest_of(result):
                results[result["student"]] = result
    return results


def line_of(result) -> str:
    """Return a result as a line of results.jsonl, with a check sum."""
    return json.dumps({**result, "sum": digest_of(result)}) + "\n"


def file_name(student) -> str:
    """Return a name for a student's files that every system takes: short, and another one for each student."""
    plain = re.sub(r"[^\w .()+@-]", "_", student).strip(" .").encode()[:100].decode(errors="ignore")
    return plain if plain == student else f"{plain}-{digest_of(student)[:8]}"


def digest_of(*values) -> str:
    """Return a hash of the values."""
    return hashlib.sha256(repr(values).encode()).hexdigest()


def cell(text) -> str:
    """Return a text that no spreadsheet takes for a formula or, where it splits at ";", for several cells."""
    text = in_one_line(text[:MOST_OF_CELL]).replace(";", ",")
    return f"'{text}" if text.lstrip()[:1] in tuple("=+-@") else text


def write_grades(folder, results) -> None:
    """Write grades.csv with a line for each student, and each STUDENT.txt. Raises an OSError if this fails."""
    with whole_file(folder / "grades.csv") as out:
        writer = csv.writer(out)
        writer.writerow(["student", "grade", *SUITES, "points", "next", "seconds", "problems"])
        for result in results:
            name, points = result["student"], [*result["points"].values()]
            row = [cell(name), result["grade"] or "none", *points, sum(points), cell(result["next"])]
            writer.writerow([*row, f"{result['seconds']:.1f}", cell(". ".join(result["problems"]))])
            text = "\n".join([name, *result["problems"], "", result["text"], ""])
            (folder / f"{file_name(name)}.txt").write_text(text, encoding="utf-8", errors="backslashreplace")


def write_gradescope(folder, result) -> None:
    """Write results.json: https://gradescope-autograders.readthedocs.io/en/latest/specs/. It may raise an OSError."""
    tests = []
    for check in result["checks"].values():
        title, points = f"{check['tier']}: {check['function']}: {check['title']}", int(check["state"] == "passed")
        tests.append({"name": title, "score": points, "max_score": 1, "output": check["message"] or "passed"})
    whole = {"output": "\n".join([*result["problems"], result["text"]]), "execution_time": round(result["seconds"])}
    whole |= {"score": sum(test["score"] for test in tests), "max_score": len(tests), "visibility": "visible"}
    folder.mkdir(parents=True, exist_ok=True)
    with whole_file(folder / "results.json") as out:
        json.dump({**whole, "tests": tests}, out, indent=1)


def summary(results) -> list[str]:
    """Return the lines that a teacher reads in the end."""
    grades = Counter(result["grade"] for result in results)
    lines = ["grade        solutions"]
    lines += [f"{grade or 'none':<12} {grades[grade]:>9}" for grade in [*reversed(SUITES), None]]
    fails = [[each for each in result["checks"].items() if each[1]["state"] == "failed"] for result in results]
    failed = Counter(f"{name} ({check['function']})" for each in fails for name, check in each)
    shown = [check for each in fails for _, check in each[:1] if check["hint"]]  # a student sees only the first failure
    hints = Counter(f"{check['hint']} ({check['function']})" for check in shown)
    for title, counts in (("Checks that most solutions fail", failed), ("Hints that most students see", hints)):
        rows = [f"{count:>5}  {in_one_line(words)[:150]}" for words, count in counts.most_common(5)]
        lines += ["", title, *rows] if rows else []
    return lines
