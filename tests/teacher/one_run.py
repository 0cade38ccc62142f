"""Grade one submission by pytest, in a copy of the starter that has this file.

`one_run.py < SUBMISSION.tar` prints the result as JSON, with --gradescope as Gradescope reads it.
The copy is the folder `project` in the working directory.
"""

import ast
import json
import re
import shutil
import signal
import subprocess
import sys
from importlib.util import decode_source
from pathlib import Path
from typing import Any, IO

STARTER = Path(__file__).resolve().parents[2]
if __name__ == "__main__":
    sys.path.insert(0, str(STARTER / "tests"))

from grading.assignment import HONOR
from teacher.submissions import choose, HANDOUT, unpack

PYTEST = "-m pytest --assert=plain -p no:cacheprovider -o faulthandler_timeout=20 --grade-json"
GRADE = Path("project", "grade.json")
OUTPUT = Path("output.txt")
MOST_LETTERS = 3000  # of the end of what pytest prints
MOST_PROBLEMS = 20

# The columns of the table, "text" for the student, and "is_final": nothing that ran beside it can
# have changed it. Without a grade, some are not there.
Result = dict[str, Any]


def main() -> None:
    """Read a submission on stdin, and print its result."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # this ends pytest, too
    result = result_of(sys.stdin.buffer)
    if "--gradescope" in sys.argv:
        # https://gradescope-autograders.readthedocs.io/en/latest/specs/
        output = "\n".join([*result["problems"], result["text"]])
        result = {"score": result["points"], "output": output}
    print(json.dumps(result))


def result_of(submission: IO[bytes]) -> Result:
    """Return the result of a submission, a .tar with its files."""
    problems: list[str] = []
    files = choose(unpack(submission, problems), problems)
    # Another run may just now let Python compile a file of the starter: it is then renamed
    shutil.copytree(STARTER, "project", ignore=shutil.ignore_patterns(".*", "*.pyc.*"))
    for place, content in files.items():
        path = Path("project", place)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        if not content.strip() and place in HANDOUT.values():
            problems.append(f"{place} is empty")
        try:
            ast.parse(decode_source(content), place)
        except Exception as error:  # a SyntaxError, another encoding, or it is too deep
            problems.append(f"{place} is not Python: {error}")
    status = run_pytest()
    try:
        grade = json.loads(GRADE.read_bytes())
    except (OSError, ValueError, RecursionError):  # a solution can have written it
        problems.append(f"no grade: pytest ended with status {status}")
        printed = OUTPUT.read_text(encoding="utf-8", errors="replace")
        return without_grade(problems[-MOST_PROBLEMS:], printed[-MOST_LETTERS:])
    for name in sorted({*re.findall(r"No module named '([\w.]+)", json.dumps(grade))}):
        problems.append(f"no module {name}: a file is missing, or a package (--packages)")
    points = {tier: counts["points"] for tier, counts in grade["tiers"].items()}
    return {
        "grade": grade["grade"] or "none",
        "points": sum(points.values()) - points[HONOR],
        **points,
        "next": grade["next"],
        "problems": problems[:MOST_PROBLEMS],
        "text": "\n".join(grade["text"]),
        "is_final": grade["final"] and status in (0, 1),
    }


def without_grade(problems: list[str], text: str = "") -> Result:
    """Return the result of a run that has given no grade."""
    return {"grade": "none", "points": 0, "problems": problems, "text": text}


def run_pytest() -> int:
    """Run pytest in the project; return its exit status."""
    with open(OUTPUT, "wb") as output:
        command = [sys.executable, *PYTEST.split(), GRADE.name]
        nothing = subprocess.DEVNULL
        return subprocess.run(
            command, cwd="project", stdin=nothing, stdout=output, stderr=output
        ).returncode


if __name__ == "__main__":
    main()
