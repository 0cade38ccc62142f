"""Make an autograder for Gradescope: `python tests/make_autograder.py FILE.zip`.

It is a starter with grade_class.py, and with the two scripts that Gradescope runs. It holds no answers.
"""

import shutil
import tempfile
from pathlib import Path

from grading.begin import ROOT

from make_starter import make_starter

from support.start.options import OneLineParser
from support.start.output import in_one_line, while_it_is_read

# Gradescope unpacks the file into source: https://gradescope-autograders.readthedocs.io/en/latest/specs/
TEACHER = ROOT / "tests" / "teacher"
SCRIPTS = "setup.sh", "run_autograder"


@while_it_is_read()
def main() -> None:
    """Make the file; the status is 2 if this fails."""
    parser = OneLineParser(description="Make an autograder for Gradescope.", allow_abbrev=False)
    parser.add_argument("file", metavar="FILE.zip", type=Path, help="a new file")
    file = parser.parse_args().file
    if file.suffix != ".zip" or file.exists():
        parser.error(f"argument FILE.zip: found '{file}', allowed is a new file that ends in .zip")
    try:
        make_autograder(file)
    except OSError as error:
        parser.error(f"argument FILE.zip: {file} cannot be made: {error.strerror}")
    print(in_one_line(f"{file} is ready. On Gradescope, upload it under Configure Autograder."))


def make_autograder(file) -> None:
    """Make the .zip; raise an OSError if this fails."""
    with tempfile.TemporaryDirectory() as work:
        folder = Path(work, "autograder")
        make_starter(folder)
        shutil.copy(ROOT / "tests" / "grade_class.py", folder / "tests")
        shutil.copytree(TEACHER, folder / "tests" / "teacher", ignore=shutil.ignore_patterns("__*__", *SCRIPTS))
        for name in SCRIPTS:
            (folder / name).write_text((TEACHER / name).read_text(encoding="utf-8"), encoding="utf-8", newline="\n")
            (folder / name).chmod(0o755)
        shutil.copy(shutil.make_archive(f"{folder}", "zip", folder), file)


if __name__ == "__main__":
    main()
