"""Many reloads of the CSV, on VPython itself: they leave the number of its objects and its memory as they were."""

import json

import pytest
from programs import needs_vpython, OF_TESTS, python
from whole_cradles import GOOD, HEADER

pytestmark = needs_vpython

# VPython works without a browser once it believes that the page is there. Nobody fetches what is sent: throw it away.
PROGRAM = """
import gc, json, sys, tracemalloc
import vpython

vpython.baseObj._view_constructed = True
vpython.baseObj.empty = lambda: True

from pathlib import Path
from wall import Wall

csv, reloads, texts = Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
wall, measured = Wall(csv, 45), {}
wall.viewer.give("pause", None)  # the time goes to the reloads
tracemalloc.start()
for reload in range(1, reloads + 1):
    csv.write_text(texts[reload % len(texts)])
    for _ in range(3):  # the viewer looks twice at a new file
        wall.now += 0.3
        wall.wait()
    assert len(wall.thetas()) == texts[reload % len(texts)].count("\\n") - 1
    vpython.baseObj.initialize()
    if reload in (10, reloads // 2, reloads):
        gc.collect()
        measured[reload] = len(vpython.baseObj.object_registry), tracemalloc.get_traced_memory()[0]
json.dump(measured, sys.stdout)
"""


@pytest.mark.slow
def test_reloads_leave_nothing_behind(tmp_path):
    reloads, csv = 100, tmp_path / "cradle.csv"
    looks = [(5, "red,metal"), (7, "blue,wood"), (1, "white,none"), (6, "cyan,earth")]
    texts = [HEADER + GOOD + f"2,1,0,0,{look}\n" * count for count, look in looks]
    csv.write_text(texts[0])
    done = python("-c", PROGRAM, csv, reloads, *texts, **OF_TESTS)
    assert done.returncode == 0, done.stderr
    (objects_early, *_, objects_late), (early, middle, late) = zip(*json.loads(done.stdout).values(), strict=True)
    assert objects_late == objects_early
    # Memory that is not used again would come to megabytes; pandas before 3.0 itself keeps a little of each file it has
    # read. Once in a while Python enlarges its table of names, by two megabytes: a leak grows in both halves.
    assert min(middle - early, late - middle) < 250 * reloads
