"""Make an autograder for Gradescope: `python tests/make_autograder.py FILE.zip`.

It holds no answers.
"""

import os
import shutil
import sys
import zipfile
from pathlib import Path
from tempfile import TemporaryDirectory

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

from grading.begin import ROOT

from grade_class import copy_starter

from support.files.data_file import whole_file
from support.start.options import OneLineParser
from support.start.output import in_one_line, while_it_is_read


@while_it_is_read()
def main() -> None:
    """Make the file; the status is 2 if this fails."""
    parser = OneLineParser(description="Make an autograder for Gradescope.", allow_abbrev=False)
    parser.add_argument("file", metavar="FILE.zip", type=Path, help="a new file")
    file = parser.parse_args().file
    if file.suffix != ".zip" or file.exists():
        parser.error(f"argument FILE.zip: found '{file}', allowed is a new file that ends in .zip")
    with whole_file(file) as archive, TemporaryDirectory() as work:
        folder = Path(work, "autograder")
        copy_starter(None, folder)
        shutil.copy(ROOT / "tests" / "grade_class.py", folder / "tests")
        # https://gradescope-autograders.readthedocs.io/en/latest/specs/
        for name in ("setup.sh", "run_autograder"):
            script = (ROOT / "tests" / "teacher" / name).read_bytes()
            (folder / name).write_bytes(script.replace(b"\r", b""))
            (folder / name).chmod(0o755)
        pack(folder, archive.buffer)
    print(in_one_line(f"{file} is ready. On Gradescope, upload it under Configure Autograder."))


def pack(folder, archive) -> None:
    """Pack a folder into a .zip, a file to write to."""
    # A file may be of 1970, and a .zip has no dates before 1980
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, strict_timestamps=False) as packed:
        for path in sorted(folder.rglob("*")):
            packed.write(path, path.relative_to(folder))


if __name__ == "__main__":
    main()
