"""Run this file to see, step by step, how newton_cradle_pends.csv becomes pend_list.

It needs no VPython.
"""

if __name__ == "__main__":
    from src import begin

import sys

import pandas as pd

import support.headless_vpython  # first: it takes VPython's place
from src.pds_helper import extract_and_convert
from support.constants import NC_FP
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import file_for_pandas, read_cradle
from support.start.end import ended_quietly, SignalError
from support.start.mistake import is_pend_list, report_endless_loop, report_mistake
from support.start.output import refuse


@ended_quietly()
def main() -> None:
    """Print df, bad_rep and pend_list; exit with status 2 if the CSV is no cradle."""
    try:
        csv = read_cradle(Snapshot(NC_FP))
    except ValueError as error:
        refuse(error)
    with file_for_pandas(csv) as relative_filepath:
        show_steps(relative_filepath)


def show_steps(relative_filepath: str) -> None:
    """Print df, bad_rep and pend_list of this CSV; exit with status 1 if a function fails."""
    df = pd.read_csv(relative_filepath)
    print("df: the CSV as a pandas dataframe, a table with a row for each pendulum.")
    print(df)

    bad_rep = df.to_dict(orient="index")
    print(
        "\nbad_rep: a dictionary of dictionaries. "
        "Its keys are only row numbers; a list needs no keys."
    )
    for row, pendulum in bad_rep.items():
        print(f"  {row}: {pendulum}")

    try:
        pend_list = extract_and_convert(relative_filepath)
    except NotImplementedError as error:
        print(f"\npend_list: missing, because {error}. Its place is in src/pds_helper.py.")
        return
    except SignalError as stopped:
        report_endless_loop(stopped)
        raise
    except Exception as error:
        report_mistake(error)
        sys.exit(1)
    print(
        "\npend_list: the result of extract_and_convert, "
        "a list with one dictionary for each pendulum."
    )
    for pendulum in pend_list if isinstance(pend_list, list) else [pend_list]:
        print(f"  {pendulum}")
    if not is_pend_list(pend_list):
        print("But this is no list of dictionaries. Type pytest: it says what is wrong.")


if __name__ == "__main__":
    main()
