"""VPython's private names are there, and do what support/page/vpython_inside.py says of them.

When another VPython comes, run this file first.
"""

import json

from programs import python, ROOT, with_vpython

from support.page.vpython_inside import NEED_ITS_PAGE

# What the page uses of VPython's script
IN_GLOW = [
    "$.plot=",
    ".color.parse=",
    "__update:function(ev)",
    "__canvas_element=",
    "window.__context",
    "window.Jupyter_VPython",
    "glowscript-canvas-wrapper",
    "userspin:",
    ".resizable(",
    'trigger("draw_complete"',
    'cvs.waitfor_textures=false;cvs.trigger("textures"',
    "userzoom:",
    "tickLabel",
    "legendColorBox",
]

CHECK = f"""
import json, sys
from vpython import vpython
from support.page.vpython_inside import draw_without_its_page, files_for_a_browser, take_changes

OF_EACH_OBJECT = (
    "_view_constructed", "empty", "handle_attach", "updates", "attrs", "initialize",
    "object_registry", "package",
)
missing = [f"baseObj.{{name}}" for name in OF_EACH_OBJECT if not hasattr(vpython.baseObj, name)]
missing += [name for name in ("_wait", *{NEED_ITS_PAGE}) if not hasattr(vpython, name)]
assert not missing, missing

draw_without_its_page()
ball = vpython.sphere(pos=vpython.vector(1, 2, 3))
first = take_changes()
ball.pos = vpython.vector(4, 5, 6)
ball.clear_trail()
files = files_for_a_browser()
files = {{name: content.decode(errors="ignore") for name, content in files.items()}}
json.dump([ball.idx, first, take_changes(), take_changes(), files], sys.stdout)
"""


@with_vpython
def test_the_private_names_of_vpython_are_there_and_do_what_the_page_needs():
    done = python("-c", CHECK, folder=ROOT)
    assert done.returncode == 0, done.stderr
    ball, first, second, third, files = json.loads(done.stdout)
    [made] = [cmd for cmd in first["cmds"] if cmd["idx"] == ball]
    assert made["cmd"] == "sphere"
    assert made["pos"] == [1, 2, 3]
    assert second == {"attrs": [f"a{ball}a4,5,6", f"m{ball}wNone"]}  # pos, and the call
    assert third == {}
    assert {"jquery.min.js", "wood_texture.jpg"} <= files.keys()
    assert files["vpython.js"].startswith("window.__GSlang =")
    for function in ("var glowObjs", "function handler(data)", "function decode(data)"):
        assert function in files["vpython.js"]
    assert [name for name in IN_GLOW if name not in files["glow.min.js"]] == []
    assert 'eval("0")' not in files["glow.min.js"]
