"""What starts from a shell and needs no browser: pds_tester.py, and importing the viewer."""

import os
import shutil
import subprocess
import sys
from importlib.machinery import PathFinder
from pathlib import Path

import pytest

from support.constants import NC_FP

ROOT = Path(__file__).parents[1]


@pytest.fixture
def run(tmp_path):
    """A function that runs Python in another folder, with no VPython to be found."""
    (tmp_path / "vpython.py").write_text("raise ModuleNotFoundError('VPython is not installed')\n")

    def run(*arguments):
        environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
        return subprocess.run([sys.executable, *arguments], cwd=os.sep, env=environment, capture_output=True, text=True)

    return run


def test_pds_tester_shows_each_step_without_vpython(run):
    done = run(str(ROOT / "pds_tester.py"))
    assert (done.returncode, done.stderr) == (0, "")
    blocks = [block.splitlines() for block in done.stdout.split("\n\n")]
    assert [block[0].partition(":")[0] for block in blocks] == ["df", "bad_rep", "pend_list"]
    assert [len(block) for block in blocks] == [1 + 1 + 5, 1 + 5, 1 + 5]  # what it is, df's header, five pendula
    last = "{'mass': 1.0, 'e': 1.0, 'theta': 0.0, 'omega': 0.0, 'color': 'cyan', 'texture': 'metal'}"
    assert [block[-1].strip() for block in blocks[1:]] == [f"4: {last}", last]


def test_pds_tester_refuses_what_is_no_csv(run, tmp_path):
    for name in ("src", "support"):
        shutil.copytree(ROOT / name, tmp_path / name)
    shutil.copy(ROOT / "pds_tester.py", tmp_path)
    file = tmp_path / Path(NC_FP).name
    file.write_text("")
    done = run(str(tmp_path / "pds_tester.py"))
    line = f"{file}: is empty, the first line must name the columns\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


@pytest.mark.skipif(PathFinder.find_spec("vpython") is None, reason="VPython is not installed")
def test_importing_the_viewer_starts_nothing():
    """With VPython itself: its server's module is not even loaded, and there is no word on the screen."""
    program = "import sys, src.visualize_cradle_run; sys.exit('vpython.no_notebook' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
