"""Grade one submission: `one_run.py < SUBMISSION.zip > grade.json`.

The .zip has the files of the submission, by their paths in the project. The grade is what pytest
--grade-json writes or, without one, the end of what pytest prints. The folder `project` of the
working directory is a copy of the starter with these files. This program imports nothing else.
"""

import os
import shutil
import signal
import subprocess
import sys
import zipfile
from contextlib import suppress
from io import BytesIO
from pathlib import Path

STARTER = Path(__file__).resolve().parents[2]
PYTEST = (
    "pytest --assert=plain -p no:cacheprovider -o faulthandler_timeout=20 --grade-json=grade.json"
)
SETTINGS = {
    "COLUMNS": "100",
    "OPENBLAS_NUM_THREADS": "1",  # or it takes memory for each core
    "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
    "PYTHONDONTWRITEBYTECODE": "1",
}
SECONDS = 300  # by the clock; in a container, a process has 60 of processor time
LATE = 124  # the exit status after too many seconds; that of the command timeout
MOST_BYTES = 1_000_000  # of a grade
MOST_OUTPUT = 3000  # bytes of what pytest prints


def main(seconds=SECONDS) -> int:
    """Print the grade; return the exit status of pytest as a shell does, LATE after these
    seconds."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(LATE))  # this ends pytest, too
    shutil.copytree(STARTER, "project", ignore=shutil.ignore_patterns(".*"))
    with zipfile.ZipFile(BytesIO(sys.stdin.buffer.read())) as submission:
        try:
            submission.extractall("project")
        except OSError as error:  # a file may be where another one needs a folder
            print(f"The files cannot be written: {error}")
            return 1
    with open("output.txt", "w+b") as output:
        status = LATE
        with suppress(subprocess.TimeoutExpired):
            status = subprocess.run(
                [sys.executable, "-m", *PYTEST.split()],
                cwd="project",
                env=environment(),
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=output,
                timeout=seconds,
            ).returncode
        output.seek(max(0, output.tell() - MOST_OUTPUT))
        found = output.read()
    grade = Path("project", "grade.json")
    if grade.is_file():  # not a pipe, to which nobody may write
        with open(grade, "rb") as file:
            found = file.read(MOST_BYTES + 1)
    sys.stdout.buffer.write(found)
    return status if status >= 0 else 128 - status


def environment() -> dict[str, str]:
    """Return the environment of pytest, without settings of Python and of pytest."""
    kept = {name: os.environ[name] for name in os.environ if not name.startswith("PY")}
    # If pytest is killed, its temporary files go with the working directory
    return kept | SETTINGS | {"TMPDIR": os.getcwd()}


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
