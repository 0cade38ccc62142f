"""The autograder for Gradescope, in the folders that Gradescope makes."""

import json
import os
import shutil
import subprocess
import sys
import zipfile

import pytest
from programs import ROOT, SECONDS
from students import write_all
from test_starter import made, start  # noqa: F401

PROGRAM = ROOT / "tests" / "make_autograder.py"

pytestmark = pytest.mark.skipif(os.name == "nt", reason="its scripts are for Linux")


@pytest.fixture
def autograder(tmp_path):
    """The folder of Gradescope, with the autograder in it, but without Python's packages."""
    done = start(PROGRAM, tmp_path / "cradle.zip", folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    folder = tmp_path / "autograder"
    subprocess.run([sys.executable, "-m", "zipfile", "-e", tmp_path / "cradle.zip", folder / "source"], check=True)
    shutil.copy(folder / "source" / "run_autograder", folder)
    return folder


def grade(folder, solution):
    """Submit a solution, and return Gradescope's results."""
    shutil.rmtree(folder / "submission", ignore_errors=True)
    shutil.copytree(solution, folder / "submission")
    subprocess.run(["bash", folder / "run_autograder"], check=True, capture_output=True, timeout=2 * SECONDS)
    return json.loads((folder / "results" / "results.json").read_text())


def test_it_grades_one_solution_after_the_other(autograder, made, tmp_path):  # noqa: F811
    (autograder / "venv" / "bin").mkdir(parents=True)
    (autograder / "venv" / "bin" / "python").write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    (autograder / "venv" / "bin" / "python").chmod(0o755)
    solved = shutil.copytree(made, tmp_path / "solved")
    write_all(solved)
    assert grade(autograder, made)["score"] == 0
    results = grade(autograder, solved)
    assert (results["score"], results["max_score"]) == (53, 53)
    assert {test["score"] for test in results["tests"]} == {1}
    (autograder / "empty").mkdir()
    results = grade(autograder, autograder / "empty")
    assert results["score"] == 0
    assert "none of the handout's files is there; found: nothing" in results["output"]


def test_it_holds_no_answers_and_its_scripts_can_be_run(tmp_path):
    assert start(PROGRAM, tmp_path / "cradle.zip", folder=tmp_path).returncode == 0
    with zipfile.ZipFile(tmp_path / "cradle.zip") as archive:
        modes = {info.filename: info.external_attr >> 16 for info in archive.infolist()}
        text = archive.read("src/swinging.py").decode()
    assert "angle_update is not written yet" in text
    assert not {"src/double_collisions.py", "tests/project/right_solutions.py", "src/README.md"}.intersection(modes)
    assert modes["run_autograder"] & modes["setup.sh"] & 0o111 == 0o111


@pytest.mark.slow
def test_setup_installs_what_it_needs(autograder, made):  # noqa: F811
    subprocess.run(["bash", autograder / "source" / "setup.sh"], check=True, capture_output=True, timeout=10 * SECONDS)
    assert grade(autograder, made)["tests"]


@pytest.mark.parametrize("name", ["there.zip", "cradle.tar", "nowhere/cradle.zip"])
def test_a_wrong_file_is_refused(tmp_path, name):
    (tmp_path / "there.zip").write_text("mine")
    done = start(PROGRAM, name, folder=tmp_path)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert "argument FILE.zip: " in done.stderr
    assert (tmp_path / "there.zip").read_text() == "mine"
