"""Read pend_list from the CSV, and write it to a CSV: each row is one pendulum, a dictionary."""

import pandas as pd

from support.columns import COLUMN_NAMES
from support.constants import NC_FP
from support.files.data_file import whole_file
from support.pendulum import PendulumEntry


def extract_and_convert(relative_filepath: str) -> list[PendulumEntry]:
    """Return pend_list: a dictionary for each row of the CSV, with the column names as keys."""
    df = pd.read_csv(relative_filepath)
    bad_rep = df.to_dict(orient="index")
    return list(bad_rep.values())


def write_to_csv(pend_list: list[PendulumEntry], filepath: str = NC_FP) -> None:
    """Write pend_list, without objects, to a CSV, which extract_and_convert can read.

    The new file replaces the old one only when it is complete. Raises an OSError if filepath cannot
    be written.
    """
    columns = [] if pend_list else list(COLUMN_NAMES)  # an empty list still gives a header
    for pend_dict in pend_list:
        for name in pend_dict:
            if name not in columns and name != "objects":
                columns.append(name)
    df = pd.DataFrame(pend_list, columns=columns, dtype=object)
    with whole_file(filepath) as file:
        df.to_csv(file, index=False, lineterminator="\n")
