"""VPython's private names are there, and do what support/page/vpython_inside.py says of them.

When another VPython comes, run this file first.
"""

import json

from programs import python, ROOT, with_vpython

CHECK = """
import json, sys
from vpython import sphere, vector
from support.page.vpython_inside import draw_without_its_page, take_changes

draw_without_its_page()
ball = sphere(pos=vector(1, 2, 3))
first = take_changes()
ball.pos = vector(4, 5, 6)
ball.clear_trail()
json.dump([ball.idx, first, take_changes(), take_changes()], sys.stdout)
"""


@with_vpython
def test_the_private_names_of_vpython_are_there_and_do_what_the_page_needs():
    done = python("-c", CHECK)
    assert done.returncode == 0, done.stderr
    ball, first, second, third = json.loads(done.stdout)
    [made] = [cmd for cmd in first["cmds"] if cmd["idx"] == ball]
    assert made["cmd"] == "sphere"
    assert made["pos"] == [1, 2, 3]
    assert second == {"attrs": [f"a{ball}a4,5,6", f"m{ball}wNone"]}  # pos, and the call
    assert third == {}


OTHER = """
import pkg_resources
pkg_resources.get_distribution = lambda name: pkg_resources.Distribution(version='7.6.4')
import begin_page
"""


@with_vpython
def test_another_vpython_is_named():
    done = python("-W", "ignore", "-c", OTHER, PYTHONPATH=str(ROOT / "src"))
    assert done.returncode == 1
    assert "the page needs another VPython than 7.6.4 in " in done.stderr.splitlines()[-1]


DRAWN = """
import begin
from support.page.vpython_inside import draw_without_its_page
draw_without_its_page()
from vpython import *
sphere().clone()
rate(1e-9)
sleep(1e9)
for refused in {refused}.split():
    try:
        eval(refused)
    except RuntimeError:
        print(refused)
"""


REFUSED = """
text(text='a') compound([box()]) graph() slider(bind=abs) scene.waitfor('click') scene.mouse.pick
curve() attach_trail(box()) box(make_trail=True) setattr(box(),'make_trail',True)
"""


@with_vpython
def test_a_program_with_a_page_draws_shapes_and_refuses_all_for_which_vpython_would_wait():
    code = DRAWN.format(refused=repr(REFUSED))
    done = python("-W", "ignore", "-c", code, PYTHONPATH=str(ROOT / "src"))
    assert (done.returncode, done.stdout.split(), done.stderr) == (0, REFUSED.split(), "")
