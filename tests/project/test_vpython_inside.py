"""VPython's private names are there, and do what support/page/vpython_inside.py says of them.

When another VPython comes, run this file first.
"""

import json

from programs import python, with_vpython

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
