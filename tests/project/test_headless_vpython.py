"""The stand-in and VPython itself: the same short programs give the same numbers and the same errors.

VPython's vectors and shapes work without a browser if VPython believes that the page is open. Each side runs all
programs in its own process, without a browser. test_browser.py tests the picture, on VPython alone.
"""

import json
import subprocess
import sys
from importlib.machinery import PathFinder

import pytest
from programs import ROOT

from support import headless_vpython

# Statements, and at the end an expression; the test compares its value.
VALUES = """
vector(1, 2, 3) + vector(0.1, 0.2, 0.3)
vector(1, 2, 3) - vector(0.1, 0.2, 0.3)
-vector(1, -2, 0.5)
+vector(1, -2, 0.5)
2.5 * vector(1, 2, 3)
vector(1, 2, 3) * 3
vector(1, 2, 3) / 7
vector(1, 2, 3) == vector(1.0, 2.0, 3.0)
vector(1, 2, 3) == vector(1, 2, 4)
vector(1, 2, 3) != vector(1, 2, 3)
vector(1, 2, 3) == (1, 2, 3)
vector(vector(1, 2, 3))
vector(True, 2, 3)
vec(1, 2, 3)
vector(1, 2, 3).value
str(vector(1/3, -2e10, 0))
repr(vector(1/3, -2e10, 0))
mag(vector(1, 2, 3))
mag(vector(0, 0, 0))
mag2(vector(1, 2, 3))
vector(3, -4, 12).mag
vector(3, -4, 12).mag2
hat(vector(1, 2, 3))
norm(vector(1, 2, 3))
vector(1, 2, 3).hat
vector(0, 0, 0).hat
vector(1, 2, 3).norm()
dot(vector(1, 2, 3), vector(-1, 0.5, 4))
vector(1, 2, 3).dot(vector(-1, 0.5, 4))
cross(vector(1, 2, 3), vector(-1, 0.5, 4))
vector(1, 2, 3).cross(vector(-1, 0.5, 4))
vector(1, 2, 3).equals(vector(1, 2, 3))
vector(1, 2, 3).rotate(0.3)
vector(1, 2, 3).rotate(angle=0.3, axis=vector(1, 1, 0))
rotate(vector(1, 2, 3), angle=0.3, axis=vector(1, 1, 0))
rotate(vector(1, 2, 3), 0.3)
comp(vector(1, 2, 3), vector(-1, 0.5, 4))
proj(vector(1, 2, 3), vector(-1, 0.5, 4))
vector(1, 2, 3).proj(vector(-1, 0.5, 4))
diff_angle(vector(1, 2, 3), vector(-1, 0.5, 4))
diff_angle(vector(1, 2, 3), vector(-2, -4, -6))
v = vector(1, 2, 3); v.mag = 7; v
c = cylinder(axis=vector(3, 4, 0)); c.axis.mag = 10; [c.axis, c.size]
v = vector(1, 2, 3); v.x = 5; v.y += 1; v
sin(0.3) + cos(0.3) + sqrt(2) + pi
b = box(); [b.pos, b.axis, b.up, b.size, b.length, b.height, b.width, b.color]
s = sphere(); [s.pos, s.axis, s.up, s.size, s.radius, s.color]
c = cylinder(); [c.pos, c.axis, c.up, c.size, c.length, c.radius, c.color]
s = sphere(); [s.texture, s.opacity, s.shininess, s.emissive, s.visible, s.pickable]
b = box(pos=vector(1, 2, 3), size=vector(4, 5, 6)); [b.pos, b.size, b.axis, b.length, b.height, b.width]
b = box(axis=vector(0, 3, 0), height=2, width=5); [b.size, b.axis]
b = box(length=3, height=2); [b.size, b.axis]
s = sphere(radius=0.25, color=color.red, texture=textures.metal); [s.size, s.radius, s.texture, s.color]
c = cylinder(pos=vector(1, 2, 3), axis=vector(0, -2, 0), radius=0.1); [c.size, c.axis, c.length, c.radius]
c = cylinder(axis=vector(3, 4, 0), up=vector(0, 0, 1), radius=0.1, shininess=1); [c.axis, c.up, c.size, c.shininess]
c = cylinder(radius=0.1); c.axis = vector(3, 4, 0); [c.axis, c.size, c.length]
c = cylinder(axis=vector(3, 4, 0)); c.length = 10; [c.axis, c.size]
c = cylinder(axis=vector(3, 4, 0)); c.axis.x = 0; [c.axis, c.size]
c = cylinder(axis=vector(3, 4, 0)); c.radius = 3; [c.axis, c.size, c.radius]
b = box(); b.size = vector(2, 3, 4); [b.axis, b.size]
b = box(); b.height = 7; b.width = 8; b.size
s = sphere(); s.axis = vector(0, 5, 0); [s.axis, s.size]
s = sphere(); s.radius = 3; [s.radius, s.size, s.axis]
s = sphere(radius=2); s.size = vector(1, 1, 1); s.radius
v = vector(1, 2, 3); s = sphere(pos=v); v.x = 9; s.pos
v = vector(1, 2, 3); s = sphere(color=v); v.x = 9; s.color
v = vector(1, 2, 3); s = sphere(); s.pos = v; v.x = 9; s.pos
v = vector(1, 2, 3); s = sphere(); s.color = v; v.x = 9; s.color
v = vector(3, 4, 0); c = cylinder(); c.axis = v; v.x = 9; [c.axis, c.length]
s = sphere(); p = s.pos; s.pos = vector(1, 2, 3); p
s = sphere(); p = s.pos; p.x = 4; s.pos
c = cylinder(); a = c.axis; c.axis = vector(0, 2, 0); a
a = sphere(pos=vector(1, 2, 3)); b = sphere(pos=a.pos); a.pos.x = 7; b.pos
s = sphere(); s.velocity = vector(1, 0, 0); s.velocity
s = sphere(charge=3); s.charge
s = sphere(pos=vector(0, -1, 0)); s.rotate(angle=0.3, axis=vector(0, 0, 1), origin=vector(0, 0, 0)); s.pos
c = cylinder(axis=vector(0, -1, 0)); c.rotate(angle=0.3, axis=vector(0, 0, 1)); [c.pos, c.axis]
color.gray(0.5)
{name: value.value for name, value in vars(color).items() if isinstance(value, vector)}
{name: value for name, value in vars(textures).items() if name[0] != "_"}
b = button(bind=print, text="Pause"); b.disabled = True; [b.text, b.disabled]
c = checkbox(bind=print, text="Graph"); [c.text, c.checked]
c = checkbox(bind=print, checked=True); c.checked
m = menu(bind=print, choices=["a", "b"], selected="b"); [m.choices, m.selected]
s = slider(bind=print, min=0.1, max=2); [s.min, s.max, s.value, s.disabled]
s = slider(bind=print, max=2, step=0.5, value=1, length=180); s.value = 1.5; [s.min, s.max, s.step, s.value, s.length]
s = slider(bind=print); s.bind is print
wtext().text
w = wtext(text="old"); w.text = "new"; w.text
g = graph(xmin=0, xmax=10, xtitle="t (s)"); g.xmax = 12; [g.width, g.height, g.xmin, g.xmax, g.xtitle]
c = gcurve(graph=graph(), label="total", color=color.red); c.data = [[0, 1]]; [c.data, c.label, c.color]
[scene.width, scene.height, scene.range, scene.fov, scene.center, scene.forward, scene.up, scene.caption]
scene.width = 300; scene.range = 2; scene.forward = vector(1, 2, 3); [scene.width, scene.range, scene.forward]
scene.append_to_caption("a"); scene.append_to_caption("b"); scene.caption
scene.lights = []; distant_light(direction=vector(0, 0, 1)); len(scene.lights)
scene.mouse.ray
""".strip().splitlines()

# Expressions and statements that VPython refuses; the test compares the kind of error.
REFUSED = """
vector(1, 2)
vector()
vector(1, 2, 3, 4)
vector((1, 2, 3))
vector(None, 0, 0)
vector(1, 2, 3) * vector(1, 2, 3)
vector(1, 2, 3) / vector(1, 2, 3)
vector(1, 2, 3) + 1
1 + vector(1, 2, 3)
vector(1, 2, 3) - (1, 2, 3)
1 / vector(1, 2, 3)
vector(1, 2, 3) / 0
"x" * vector(1, 2, 3)
hash(vector(1, 2, 3))
vector(1, 2, 3)[0]
mag((1, 2, 3))
mag(3)
sphere(pos=(1, 2, 3))
sphere(pos=None)
sphere(color="red")
sphere(radius=None)
sphere(radius=vector(1, 2, 3))
box(size=3)
cylinder(axis=(0, 1, 0))
cylinder(up=1)
s = sphere(); s.pos = (1, 2, 3); s
s = sphere(); s.pos = 5; s
s = sphere(); s.color = "red"; s
s = sphere(); s.radius = None; s
c = cylinder(); c.axis = (1, 2, 3); c
box().radius
sphere(1)
box(vector(1, 2, 3))
""".strip().splitlines()

# VPython's vectors without compiled code refuse these with a different error.
UNCOMPILED = dict.fromkeys(["mag((1, 2, 3))", "mag(3)"], "refused: AttributeError")
WHOSE_VECTOR = "vector.__module__"

# Both sides run this: it reads the programs, and prints the value or the kind of error of each.
RUNNER = """
import json, sys
if sys.argv[1] == "headless":
    from support.headless_vpython import install
    install()
import vpython
if sys.argv[1] == "vpython":
    vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser

def plain(value):
    if isinstance(value, vpython.vector):
        return ["vector", value.x, value.y, value.z]
    return [plain(item) for item in value] if isinstance(value, (list, tuple)) else value

def outcome(program):
    names = {}
    exec("from vpython import *", names)
    *statements, expression = program.split("; ")
    try:
        for statement in statements:
            exec(statement, names)
        return plain(eval(expression, names))
    except Exception as error:
        return "refused: " + type(error).__name__

json.dump([outcome(program) for program in json.load(sys.stdin)], sys.stdout, default=repr)
"""


def outcomes(side):
    """Return the results of all programs on this side, from its own process."""
    command = [sys.executable, "-c", RUNNER, side]
    programs = [*VALUES, *REFUSED, WHOSE_VECTOR]
    words = json.dumps(programs)
    done = subprocess.run(command, input=words, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return dict(zip(programs, json.loads(done.stdout), strict=True))


@pytest.fixture(scope="module")
def both():
    if PathFinder.find_spec("vpython") is None:
        pytest.skip("VPython is not installed")
    return outcomes("headless"), outcomes("vpython")


def flat(value):
    """Return the numbers and words of nested lists and dictionaries as one list."""
    if isinstance(value, dict):
        value = sorted(value.items())
    return [leaf for item in value for leaf in flat(item)] if isinstance(value, (list, tuple)) else [value]


@pytest.mark.parametrize("program", VALUES)
def test_the_same_values(program, both):
    headless, real = (flat(outcomes[program]) for outcomes in both)
    assert not str(real[0]).startswith("refused")
    exactly = {"rel": 1e-15, "abs": 1e-15}
    assert headless == [pytest.approx(leaf, **exactly) if isinstance(leaf, float) else leaf for leaf in real]


@pytest.mark.parametrize("program", REFUSED)
def test_the_same_refusals(program, both):
    headless, real = (outcomes[program] for outcomes in both)
    assert str(headless).startswith("refused")
    is_compiled = both[1][WHOSE_VECTOR] == "vpython.cyvector"
    assert real == (headless if is_compiled else UNCOMPILED.get(program, headless))


def test_text_is_no_number():
    """VPython's compiled vector refuses it too; its slower vector without compiled code accepts it."""
    with pytest.raises(TypeError):
        headless_vpython.vector("1", 2, 3)
