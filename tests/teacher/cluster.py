"""A class on a cluster: its packages go out, and its grades come back.

FOLDER/0/submission.zip and so on are for the jobs with these numbers; each writes grade.json beside
its package. packages.txt stays with the teacher: no job can give itself the package of another.
"""

from support.files.cradle_csv import naming
from support.files.data_file import whole_file
from teacher import one_run
from teacher.report import digest_of, own_folder
from teacher.runners import Runner


def write_packages(folder, version, packages) -> None:
    """Write packages for a cluster into a new folder. Raises an OSError if this fails."""
    own_folder(folder)
    digests = []
    for number, package in enumerate(packages):
        digests.append(digest_of(version, package))
        place = folder / f"{number}"
        with naming(folder):
            place.mkdir()
            (place / "submission.zip").write_bytes(package)
    with whole_file(folder / "packages.txt") as file:
        file.write("\n".join(digests))


class Collected(Runner):
    """Takes the grades that the jobs of a cluster have written."""

    def __init__(self, version, packed):
        super().__init__()
        self.version = version  # of the starter
        self.packed = packed  # the folder of write_packages
        self.digests = (packed / "packages.txt").read_text(errors="replace").split()

    def run_package(self, content) -> tuple[int | str, bytes]:
        digest = digest_of(self.version, content)
        if digest not in self.digests:
            return f"{self.packed} has no package of it, or is of another version", b""
        file = self.packed / f"{self.digests.index(digest)}" / "grade.json"
        # A link could lead to another file, and a pipe would never end
        if file.is_symlink() or not file.is_file():
            return f"{file} is not there, or no plain file", b""
        with open(file, "rb") as grade:
            return 0, grade.read(one_run.MOST_BYTES + 1)
