"""Read pend_list from the CSV, and write it to a CSV: each row is one pendulum, a dictionary."""

from importlib.metadata import version

import pandas as pd

from support.constants import NC_FP
from support.files.cradle_csv import cleaned
from support.files.data_file import whole_file
from support.pendulum import PendulumEntry

# pandas reads floats exactly from 3.1 on, and then warns about this option; older versions need it.
EXACT_FLOATS = {} if tuple(map(int, version("pandas").split(".")[:2])) >= (3, 1) else {"float_precision": "round_trip"}


def extract_and_convert(relative_filepath) -> list[PendulumEntry]:
    """Return pend_list: a dictionary for each row of the CSV, with the column names as keys.

    Spaces around names and values do not count. Raises a ValueError with a one-line message if the file
    cannot be read.
    """
    df = pd.read_csv(cleaned(relative_filepath), **EXACT_FLOATS)
    bad_rep = df.to_dict(orient="index")
    return list(bad_rep.values())


def write_to_csv(pend_list, filepath=NC_FP) -> None:
    """Write pend_list, without objects, to a CSV; extract_and_convert reads the same list back.

    The new file replaces the old one only when it is complete on the disk. After a crash, or on a full disk, the old
    file is still whole. Raises an OSError if filepath cannot be written.
    """
    columns = [name for pend_dict in pend_list or [PendulumEntry.__annotations__] for name in pend_dict]
    columns = [name for name in dict.fromkeys(columns) if name != "objects"]  # each once, in their order
    df = pd.DataFrame(pend_list, columns=columns, dtype=object)
    with whole_file(filepath) as file:
        df.to_csv(file, index=False, lineterminator="\n")
