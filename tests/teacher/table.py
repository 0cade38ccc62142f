"""The grades of a class: a table, and a text for each student."""

import re
from pathlib import Path

import pandas as pd

from grading.assignment import SUITES
from support.files.data_file import whole_file
from support.start.output import in_one_line
from teacher.one_run import Result

COLUMNS = ["grade", "points", *SUITES, "next", "problems"]
MOST_LETTERS = 2000  # of a cell, and of a line
MOST_LINES = 200
# The beginning of a formula: of a cell, or where a spreadsheet in many countries splits it
FORMULA = re.compile(r'(^|;)([\s"]*[=+\-@])')


def write_table(folder: Path, results: dict[str, Result]) -> Path:
    """Write grades.csv, and STUDENT.txt for each; return the path of the table.

    A solution can have written its result. Raises an OSError if a file cannot be written.
    """
    rows = []
    for student, result in sorted(results.items()):
        row = {column: cell(result.get(column, "")) for column in COLUMNS}
        rows.append({"student": cell(student), **row})
    table = folder / "grades.csv"
    with whole_file(table) as out:
        out.write("\ufeff")  # Excel then reads it as UTF-8
        pd.DataFrame(rows).to_csv(out, index=False)
    for student, result in results.items():
        lines = [student, *map(str, result["problems"]), "", *result["text"].split("\n")]
        with whole_file(folder / f"{student}.txt") as out:
            for line in lines[:MOST_LINES]:
                print(in_one_line(line[:MOST_LETTERS]), file=out)
    return table


def cell(value: object) -> str | int:
    """Return a value as a cell: a number of points, or a text that no spreadsheet calculates."""
    if isinstance(value, int) and 0 <= value < 100:
        return value
    if isinstance(value, list):
        value = ". ".join(map(str, value))
    return FORMULA.sub(r"\1'\2", in_one_line(str(value)[:MOST_LETTERS]))
