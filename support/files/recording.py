"""Write the motion of a cradle to a CSV, with a row for each sample."""

import csv
from array import array
from collections import deque
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from stat import S_ISREG
from threading import Lock

from support.files.atomic_write import whole_file, write_new_file
from support.files.cradle_csv import LARGEST

EVERY = 0.01  # s from sample to sample
REMEMBERED = 600.0  # s of samples that a Recording keeps


def check_record(filepath) -> None:
    """Raise a ValueError with a one-line message if this file exists, and has no data of a cradle to replace."""
    try:
        if not S_ISREG(Path(filepath).stat().st_mode):
            return  # data_file will raise the error
        with open(filepath, "r+b") as file:  # opened to write, too: another program may have it open
            columns = file.readline(LARGEST).strip()
    except FileNotFoundError:
        return  # a new file; if its folder is missing, data_file will raise the error
    except OSError as error:
        raise ValueError(f"--record: {filepath}: {error.strerror}") from error
    if columns and not (columns.startswith(b"t,theta_1,") and columns.endswith(b",momentum")):
        allowed = "a new file, or one with data of a cradle, to replace it"
        raise ValueError(f"--record: found '{filepath}', which has no data of a cradle; allowed is {allowed}")


def data_writer(file):
    """Return a writer to this file for the rows of a CSV: first the names of the columns, then the data."""
    return csv.writer(file, lineterminator="\n")


@contextmanager
def data_file(filepath):
    """Yield a data_writer to a new file.

    The file is written whole, or not at all. Raises an OSError if filepath cannot be written.
    """
    with whole_file(filepath) as file:
        yield data_writer(file)


class Recording:
    """The samples of the last ten minutes. One thread adds them; any thread can write them."""

    def __init__(self):
        """Begin without samples."""
        self.lock = Lock()  # between two cradles, the rows and the columns may not belong together
        self.columns: list[str] = []
        self.rows: deque[array] = deque(maxlen=round(REMEMBERED / EVERY))

    def clear(self) -> None:
        """Forget all samples."""
        with self.lock:
            self.rows.clear()

    def add(self, sample) -> None:
        """Add a sample of Motion; all samples have the same names."""
        with self.lock:
            self.columns = list(sample)
            self.rows.append(array("d", sample.values()))  # a twentieth of the memory that dictionaries take

    def copy(self) -> "Recording":
        """Return a Recording with the samples of this moment."""
        copy = Recording()
        with self.lock:
            copy.columns, copy.rows = self.columns, self.rows.copy()
        return copy

    def write(self, writer) -> None:
        """Write all samples of this moment to a data_writer, however many are added meanwhile."""
        with self.lock:
            columns, rows = self.columns, list(self.rows)
        writer.writerow(columns)
        for row in rows:  # not writerows: between two rows, Python lets the other threads run
            writer.writerow(row)

    def save(self, folder) -> Path:
        """Write all samples to a new file in this folder, and return its path; raises an OSError if that fails."""
        paths = (Path(folder, f"cradle_data_{number}.csv") for number in count(1))
        return write_new_file(paths, lambda file: self.write(data_writer(file)))
