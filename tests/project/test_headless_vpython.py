"""The stand-in and VPython itself: the same programs give the same numbers and errors.

VPython's vectors and shapes work without a browser if VPython believes that the page is open. Each
side runs all programs in its own process, without a browser. test_page_again.py tests the picture,
on VPython alone.
"""

import json

import pytest
from programs import python, ROOT, with_vpython

from support import headless_vpython, waits


def programs(table):
    """Return the programs of a table: " | " or the end of a line ends a program."""
    return [program.strip() for line in table.strip().splitlines() for program in line.split(" | ")]


# Statements, and at the end an expression; the test compares its value. RUNNER makes v, w, s and c.
# names are those that `from vpython import *` brings; attributes(s) are all public ones of s, with
# their values.
VALUES = programs("""
names | attributes(v) | attributes(color) | attributes(textures) | attributes(box()) | attributes(s)
attributes(cylinder())
[scene.width, scene.height, scene.range, scene.fov, scene.center, scene.forward, scene.up]
v + w | v - w | -v | +v | 2.5 * v | v * 3 | v / 7 | v == vector(1.0, 2.0, 3.0) | v == w | v != v
v == (1, 2, 3)
vector(v) | vector(True, 2, 3) | vec(1, 2, 3) | v.value | str(vector(1/3, -2e10, 0))
repr(vector(1/3, -2e10, 0))
mag(v) | mag(vector(0, 0, 0)) | mag2(v) | v.mag | v.mag2 | hat(v) | norm(v) | v.hat
vector(0, 0, 0).hat | v.norm()
dot(v, w) | v.dot(w) | cross(v, w) | v.cross(w) | v.equals(vector(1, 2, 3)) | comp(v, w) | v.comp(w)
proj(v, w)
v.proj(w) | diff_angle(v, w) | v.diff_angle(-2 * v) | v.rotate(0.3) | v.rotate(angle=0.3, axis=w)
rotate(v, 0.3)
v.mag = 7; v | v.x = 5; v.y += 1; v | u = vector(v); u.z = 9; v
0 <= random() < 1 and all(vector.random().mag2 <= 3 for _ in range(99))
sin(0.3) + cos(0.3) + sqrt(2) + pi | [sign(-2.5), sign(0), sign(7), combin(5, 2)]
[float(x) for x in arange(0, 1, 0.25)]
[color.gray(0.5), color.rgb_to_hsv(v / 4), color.hsv_to_rgb(v / 4), color.rgb_to_grayscale(2 * v)]
version[0] < "8"
b = box(pos=v, size=vector(4, 5, 6)); [b.pos, b.size, b.axis, b.length, b.height, b.width]
b = box(axis=vector(0, 3, 0), height=2, width=5); [b.size, b.axis]
b = box(length=3, height=2); [b.size, b.axis]
b = box(); b.size = vector(2, 3, 4); [b.axis, b.size] | b = box(); b.height = 7; b.width = 8; b.size
s = sphere(radius=0.25, color=color.red); [s.size, s.radius, s.color, s.red]
sphere(texture=textures.metal).texture
s.axis = vector(0, 5, 0); [s.axis, s.size] | s.radius = 3; [s.radius, s.size, s.axis]
s.size = v; s.radius
c = cylinder(axis=vector(3, 4, 0), up=vector(0, 0, 1), radius=0.1); [c.axis, c.up, c.size, c.length]
c.axis = w; [c.axis, c.size] | c.length = 10; [c.axis, c.size] | c.axis.x = 0; [c.axis, c.size]
c.axis.mag = 9; c.size
c.radius = 3; [c.axis, c.size, c.radius] | a = c.axis; c.axis = v; a
c.axis = v; v.x = 9; [c.axis, c.length]
s = sphere(pos=v, color=v); v.x = 9; [s.pos, s.color]
s.pos = s.color = v; v.x = 9; [s.pos, s.color]
p = s.pos; s.pos = v; p | p = s.pos; p.x = 4; s.pos | t = sphere(pos=s.pos); s.pos.x = 7; t.pos
s.velocity = v; s.velocity | sphere(charge=3).charge
s.make_trail = True; s.clear_trail(); s.make_trail
s.rotate(angle=0.3, axis=v, origin=w); [s.pos, s.axis]
c.rotate(angle=0.3, axis=vector(0, 0, 1)); [c.pos, c.axis]
t = sphere(radius=2); u = t.clone(pos=w); u.axis = v; [t.pos, t.axis, u.pos, u.axis, u.size]
sphere(color=v, radius=2).clone().color
[shape in scene.objects for shape in (s, c)] | s.visible = False; s in scene.objects
scene.camera.pos | canvas(background=v).background
scene.range = 2; scene.forward = v; [scene.range, scene.forward] | scene.mouse.ray
b = button(bind=print, text="Pause"); b.disabled = True; [b.text, b.disabled, b.bind is print]
l = label(pos=v, text="a", height=9); l.pos.x = 5; [l.pos, l.text, l.height]
l = label(); [l.pos, l.color]
a = arrow(pos=s.pos, color=v); a.pos.x = a.color.x = 5; [s.pos, v, a.pos, a.color]
a = arrow(); a.axis = v; a.axis.y = 5; [v, a.axis]
a = arrow(); a.axis.x = 5; [a.pos, a.axis, a.up, arrow().axis]
[isinstance(arrow(), arrow), isinstance(arrow(), (box, sphere))]
""")

# Expressions and statements that VPython refuses; the test compares the kind of error.
REFUSED = programs("""
vector(1, 2) | vector() | vector(1, 2, 3, 4) | vector((1, 2, 3)) | vector(None, 0, 0) | v * v
v / v | v + 1 | 1 + v
v - (1, 2, 3) | 1 / v | v / 0 | "x" * v | hash(v) | v[0] | mag((1, 2, 3)) | norm(3) | dot(v, 3)
cross((1, 2, 3), v)
sphere(pos=(1, 2, 3)) | sphere(pos=None) | sphere(color="red") | sphere(radius=None)
sphere(radius=v) | box(size=3)
cylinder(axis=(0, 1, 0)) | cylinder(up=1) | s.pos = (1, 2); s | s.pos = 5; s | s.color = "red"; s
c.axis = (1, 2); c
s.radius = None; s | sphere(1) | box(v) | box().radius | s.radus | c.lenght | box().move(1)
v.lenght | color.pink
lable | __import__("vpython").lable | exec("from vpython import lable"); v | import vpython.lable; v
vector("1", 2, 3)
""")
# VPython's vectors with and without compiled code differ here. The kind of error of the stand-in:
BY_ATTRIBUTE = programs("mag((1, 2, 3)) | norm(3) | dot(v, 3) | cross((1, 2, 3), v)")
EITHER = {
    'vector("1", 2, 3)': "refused: TypeError",
    **dict.fromkeys(BY_ATTRIBUTE, "refused: AttributeError"),
}

# Both sides run this: it reads the programs, and prints the value or the kind of error of each.
RUNNER = """
import json, sys
if sys.argv[1] == "headless":
    import support.headless_vpython
import vpython
if sys.argv[1] == "vpython":
    vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser
    # "And it has all objects": a clone waits for this
    vpython.baseObj.empty = classmethod(lambda cls: True)

def plain(value):
    if isinstance(value, vpython.vector):
        return ["vector", value.x, value.y, value.z]
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    return value

# VPython's own use of its objects: no program of a student's needs these.
MACHINERY = "attrLists canvas delete idx ignore objName resolveargs rotate_in_place setup".split()
MACHINERY += dir(vpython.baseObj)

def attributes(thing):
    found = {}
    for name in dir(thing):
        if name[0] != "_" and name not in MACHINERY and hasattr(thing, name):
            value = getattr(thing, name)
            found[name] = "function" if callable(value) else plain(value)
    return found

def outcome(program):
    names = {}
    exec("from vpython import *", names)
    names["names"] = sorted(names)
    names["attributes"] = attributes
    names["v"] = vpython.vector(1, 2, 3)
    names["w"] = vpython.vector(-1, 0.5, 4)
    names["s"] = vpython.sphere()
    names["c"] = vpython.cylinder(axis=vpython.vector(3, 4, 0))
    *statements, expression = program.split("; ")
    try:
        for statement in statements:
            exec(statement, names)
        return plain(eval(expression, names))
    except Exception as error:
        return "refused: " + type(error).__name__

json.dump([outcome(program) for program in json.loads(sys.argv[2])], sys.stdout, default=repr)
"""


@pytest.fixture(scope="module")
def both():
    """The results of all programs on both sides, each from its own process."""
    sides = []
    for side in ("headless", "vpython"):
        done = python("-c", RUNNER, side, json.dumps(VALUES + REFUSED))
        assert done.returncode == 0, done.stderr
        sides.append(dict(zip(VALUES + REFUSED, json.loads(done.stdout), strict=True)))
    return sides


def flat(value):
    """Return the numbers and words of nested lists and dictionaries as one list."""
    if isinstance(value, dict):
        value = sorted(value.items())
    if not isinstance(value, (list, tuple)):
        return [value]
    leaves = []
    for item in value:
        leaves += flat(item)
    return leaves


@with_vpython
@pytest.mark.parametrize("program", VALUES + REFUSED)
def test_values_and_refusals_are_the_same(program, both):
    headless, real = (outcomes[program] for outcomes in both)
    assert str(headless).startswith("refused") == (program in REFUSED)
    exactly = [
        pytest.approx(leaf, rel=1e-15, abs=1e-15) if isinstance(leaf, float) else leaf
        for leaf in flat(real)
    ]
    assert flat(headless) in (exactly, [EITHER.get(program)])


@pytest.mark.parametrize(
    "name", ["arrow", "curve", "extrusion", "gcurve", "keysdown", "shapes", "slider", "text"]
)
def test_the_rest_accepts_everything_and_does_nothing(name):
    thing = getattr(headless_vpython, name)("a", radius=3)
    thing.start.x = 5
    assert thing is not thing.append(1, text="a").find(2)
    assert [*thing, *thing.points] == []
    assert not thing.is_check  # pytest looks for such attributes of all that a module imports
    assert getattr(headless_vpython, name) is getattr(headless_vpython, name)


def test_nothing_waits():
    """On VPython itself, each of these lines waits, for ever or for a long time."""
    headless_vpython.rate(1e-9)
    headless_vpython.sleep(1e9)
    headless_vpython.scene.waitfor("click").pos.x = 5
    headless_vpython.scene.pause()
    assert headless_vpython.scene.mouse.pick is None


@pytest.mark.parametrize("name", ["rate", "sleep", "scene.pause", "scene.waitfor"])
def test_a_call_in_src_that_waits_is_named(monkeypatch, name):
    monkeypatch.setattr(waits, "calls", {})
    for file in ("support", "src"):
        exec(compile(f"\n{name}(9)", ROOT / file / "swinging.py", "exec"), vars(headless_vpython))
    assert waits.remark().startswith(f"src/swinging.py, line 2 calls {name}. ")
