"""Make an autograder for Gradescope: `python tests/make_autograder.py FILE.zip`.

It holds no answers.
"""

import os
import shutil
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

import grading.begin  # noqa: F401

from grade_class import make_grader

from support.files.data_file import whole_file
from support.start.end import ended_quietly
from support.start.options import OneLineParser
from support.start.output import in_one_line


@ended_quietly()
def main() -> None:
    """Make the file; the status is 2 if this fails."""
    parser = OneLineParser(description="Make an autograder for Gradescope.", allow_abbrev=False)
    parser.add_argument("file", metavar="FILE.zip", type=Path, help="a new file")
    file = parser.parse_args().file
    if file.suffix != ".zip" or file.exists():
        parser.error(f"argument FILE.zip: found '{file}', allowed is a new file that ends in .zip")
    with whole_file(file) as archive, TemporaryDirectory() as work:
        folder = Path(work, "autograder")
        make_grader(folder)
        # https://gradescope-autograders.readthedocs.io/en/latest/specs/
        for name in ("setup.sh", "run_autograder"):
            shutil.copy(folder / "tests" / "teacher" / name, folder)
            (folder / name).chmod(0o755)
        packed = shutil.make_archive(f"{folder}", "zip", folder)
        archive.buffer.write(Path(packed).read_bytes())
    print(in_one_line(f"{file} is ready. On Gradescope, upload it under Configure Autograder."))


if __name__ == "__main__":
    main()
