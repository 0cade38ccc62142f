"""Many reloads of the CSV, on VPython itself: they leave the number of its objects and its memory as they were.

VPython works without a browser once its record says that the page is there; what the page would fetch is thrown away.
"""

import json
import subprocess
import sys
from importlib.machinery import PathFinder

import pytest
from programs import ROOT, slow_but_for
from whole_cradles import HEADER

PROGRAM = """
import gc, json, sys, tracemalloc
from types import SimpleNamespace
import vpython

vpython.baseObj._view_constructed = True

from src import visualize_cradle_run
from src.beyond.live_cradle import LiveCradle
from src.special_cradles import make_newton_cradle
from support.constants import R_PARAM, THETA_INIT
from support.files.cradle_csv import Snapshot
from support.files.live_file import LiveFile
from support.page.viewer import Viewer

options = SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None)
vpython.baseObj.empty = lambda: True
cradle = LiveCradle(vars(visualize_cradle_run), options)
viewer = Viewer(cradle, LiveFile(sys.argv[2]), angles=[-0.8], lifted=1)

def go_on(script):
    for _ in script:
        viewer.show(make_newton_cradle(viewer.csv, R_PARAM, THETA_INIT))

go_on(viewer.open())
tracemalloc.start()
measured = {}
reloads, *files = int(sys.argv[1]), *sys.argv[2:]
for reload in range(1, reloads + 1):
    viewer.file.current = Snapshot(files[reload % len(files)])
    go_on(viewer.reload())
    viewer.show_motion()
    vpython.baseObj.initialize()
    if reload in (10, reloads // 2, reloads):
        gc.collect()
        measured[reload] = len(vpython.baseObj.object_registry), tracemalloc.get_traced_memory()[0]
json.dump(measured, sys.stdout)
"""


@pytest.mark.skipif(PathFinder.find_spec("vpython") is None, reason="VPython is not installed")
@pytest.mark.parametrize("reloads", slow_but_for([100], [100, 1000]))
def test_reloads_leave_nothing_behind(tmp_path, reloads):
    files = []
    for count, looks in [(5, "red,metal"), (7, "blue,wood"), (1, "white,none"), (6, "cyan,earth")]:
        files.append(tmp_path / f"{count}.csv")
        files[-1].write_text(HEADER + f"1,1,0,0,{looks}\n" * count)
    command = [sys.executable, "-c", PROGRAM, str(reloads), *map(str, files)]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    (objects_early, *_, objects_late), (early, middle, late) = zip(*json.loads(done.stdout).values(), strict=True)
    assert objects_late == objects_early
    # What is not used again would come to megabytes; pandas before 3.0 itself keeps a little of each file it has read.
    # Once in a while Python enlarges its table of names, by two megabytes: a leak grows in both halves.
    assert min(middle - early, late - middle) < 250 * reloads
