"""The programs, as far as they need no browser: how they start, and what they print."""

import os
from unittest.mock import Mock

import pytest
from programs import call, copy_project, python
from students import put_files

import pds_tester
from grading.cradles import MIXED, MIXED_CSV
from support.start.end import SignalError
from support.start.mistake import TYPE_PYTEST


@pytest.mark.parametrize("program", ["pds_tester", "src/text_cradle_run"])
def test_a_program_finds_its_own_project_from_any_folder_and_needs_no_vpython(tmp_path, program):
    project = copy_project(tmp_path / "100% ü #1", "")
    folder = put_files(tmp_path / "hiding", {"vpython.py": "raise ImportError"})
    link = tmp_path / "link"
    link.symlink_to(project)
    done = python(link / f"{program}.py", folder=os.sep, PYTHONPATH=str(folder))
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert done.stderr.startswith(f"{project / 'newton_cradle_pends.csv'}: is empty, ")


def test_pds_tester_shows_each_step(csv, monkeypatch, capsys):
    csv.write_text(MIXED_CSV)
    monkeypatch.setattr(pds_tester, "NC_FP", str(csv))
    pds_tester.main()
    df, bad_rep, pend_list = [block.splitlines() for block in capsys.readouterr().out.split("\n\n")]
    assert df[0].startswith("df: ")
    assert len(df[1:]) == 1 + 3  # a header, three pendula
    assert bad_rep[1:] == [f"  {row}: {pend}" for row, pend in enumerate(MIXED)]
    assert pend_list[1:] == [f"  {pend}" for pend in MIXED]


@pytest.mark.parametrize(
    ("error", "status", "words"),
    [
        (SignalError(0), 0, "pd.read_csv(relative_filepath)\n"),
        (KeyError("mas"), 1, f"\nKeyError: 'mas'\n{TYPE_PYTEST}\n"),
    ],
)
def test_pds_tester_names_a_mistake(monkeypatch, capsys, error, status, words):
    monkeypatch.setattr("src.pds_helper.pd", Mock(**{"read_csv.side_effect": error}))
    ended, _, stderr = call(pds_tester.main, capsys)
    assert ended == status
    assert words in stderr
