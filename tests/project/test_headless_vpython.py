"""The stand-in and VPython itself: vectors and shapes give the same numbers and errors.

VPython's vectors and shapes work without a browser if VPython believes that the page is open. Each
side has its own process.
"""

import json

import pytest
from programs import python, with_vpython
from vpython import button, gcurve, label, rate, scene, shapes, sleep, sphere

# Programs: statements, and at the end an expression. SIDE makes v, w, b, s and c.
PROGRAMS = """
sorted(name for name in globals() if name[0] != "_")
[v + w, v - w, -v, 2.5 * v, v * 3, v / 7, vector(v), vec(True, 2, 3), str(v / 3), repr(w)]
[v == vector(1.0, 2.0, 3.0), v == w, v != v, v == (1, 2, 3), v.equals(vector(v))]
[mag(v), mag2(v), v.mag, v.mag2, hat(v), norm(v), v.hat, v.norm(), vector(0, 0, 0).hat]
[dot(v, w), cross(v, w), v.cross(w), comp(v, w), proj(v, w), v.proj(w)]
[diff_angle(v, w), v.diff_angle(-2 * v), rotate(v, 0.3), v.rotate(angle=0.3, axis=w)]
v.x = 5; v.y += 1; w.mag = 7; [v, w]
[sin(0.3) + sqrt(pi), sign(-2.5), sign(0), combin(5, 2), [*map(float, arange(0, 1, 0.4))]]
[color.orange, color.gray(0.5), color.hsv_to_rgb(v / 4), textures.wood_old]
[[t.pos, t.axis, t.up, t.size, t.color, t.texture, t.shininess, t.opacity] for t in (b, s)]
b.size = v; b.height = 7; b.width = 8; [b.size, b.axis]
s.radius = 3; s.axis = w; [s.size, s.axis]
c.axis = w; c.radius = 3; c.length = 10; [c.axis, c.size]
s.pos = c.axis = v; v.x = 9; [s.pos, c.axis, c.length]
p = s.pos; s.pos = v; p.y = 4; [p, s.pos, sphere(pos=p, texture=textures.metal, charge=3).charge]
s.rotate(angle=0.3, axis=v, origin=w); c.rotate(angle=0.3, axis=vector(0, 0, 1)); [s.pos, c.axis]
vector(1, 2)
v * v
sphere(pos=(1, 2, 3))
sphere(1)
b.radius
color.pink
from vpython import lable; v
""".strip().splitlines()

# Each side runs this: it prints the value, or the kind of error, of each program.
SIDE = """
import json, sys
if sys.argv[1] == "headless":
    import support.headless_vpython
import vpython
if sys.argv[1] == "vpython":
    vpython.baseObj._view_constructed = True

def outcome(program):
    names = {}
    exec("from vpython import *", names)
    if "globals" not in program:
        exec("v = vector(1, 2, 3); w = vector(-1, 0.5, 4); b = box(); s = sphere()", names)
        exec("c = cylinder(axis=vector(3, 4, 0), radius=0.1)", names)
    *statements, expression = program.split("; ")
    try:
        for statement in statements:
            exec(statement, names)
        return eval(expression, names)
    except Exception as error:
        return type(error).__name__

outcomes = [outcome(program) for program in json.loads(sys.argv[2])]
json.dump(outcomes, sys.stdout, default=lambda v: v.value)
"""


@pytest.fixture(scope="module")
def sides():
    """The outcomes of all programs on each side, by the program."""
    sides = []
    for side in ("headless", "vpython"):
        done = python("-c", SIDE, side, json.dumps(PROGRAMS))
        outcomes = json.loads(done.stdout, parse_float=lambda text: round(float(text), 14))
        sides.append(dict(zip(PROGRAMS, outcomes, strict=True)))
    return sides


@with_vpython
@pytest.mark.parametrize("program", PROGRAMS)
def test_vectors_and_shapes_give_the_same_values_and_errors(program, sides):
    headless, vpython = sides
    assert headless[program] == vpython[program]


def test_the_rest_takes_any_call_and_attribute_and_moves_no_bob():
    """On VPython itself, the last lines wait."""
    bob = sphere()
    name = label(pos=bob.pos, text="a")
    name.pos.x = 5
    assert (bob.pos.x, name.pos.x, name.text) == (0, 5, "a")
    scene.title = "cradle"
    button(bind=print, text="Run").disabled = True
    gcurve(color=bob.color).plot(0, 1)
    shapes.circle(radius=1).append(2)
    scene.waitfor("click").pos.x = 5
    rate(1e-9)
    sleep(1e9)
