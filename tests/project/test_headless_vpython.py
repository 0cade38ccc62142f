"""The stand-in and VPython itself: the same short programs give the same numbers and the same errors.

VPython's vectors and shapes work without a browser if VPython believes that the page is open. Each side runs all
programs in its own process, without a browser. test_browser.py tests the picture, on VPython alone.
"""

import json
import subprocess
import sys
from importlib.machinery import PathFinder

import pytest
from programs import ROOT, SECONDS

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
scene.camera.pos = vector(0, 1, 5); scene.camera.axis = vector(0, -1, -3); [scene.camera.pos, scene.center, scene.range]
c = canvas(title="Cradle", width=300, background=color.white); [c.title, c.width, c.background, c.selected is c]
c = canvas(); b = box(); s = sphere(visible=False); label(); [len(c.objects), b in c.objects, s in c.objects]
c = canvas(); s = sphere(canvas=scene); [len(c.objects), s.canvas is scene, s in scene.objects]
l = label(pos=vector(1, 2, 3), text="a", box=False); l.height = 20; [l.pos, l.text, l.box, l.height, l.color]
a = arrow(pos=vector(1, 2, 3), axis=vector(0, 2, 0), shaftwidth=0.1); [a.pos, a.axis, a.size, a.shaftwidth]
r = ring(radius=2, thickness=0.5); [r.radius, r.thickness, r.size]
c = cone(radius=2, axis=vector(0, 3, 0)); [c.radius, c.size, c.axis]
h = helix(radius=2, coils=9); [h.radius, h.coils, h.size]
t = curve(vector(1, 2, 3)); t.append(vector(4, 5, 6)); t.append(pos=vector(7, 8, 9)); [t.npoints, t.point(1)["pos"]]
t = curve(pos=[vector(1, 2, 3), vector(4, 5, 6)]); p = t.pop(); t.clear(); [p["pos"], t.npoints]
g = gcurve(); g.plot(1, 2); g.plot([3, 4]); g.plot([[5, 6], [7, 8]]); g.plot(pos=[9, 10]); g.data
s = sphere(pos=vector(1, 2, 3), radius=2, color=color.red); c = s.clone(pos=s.pos * 2); [s.pos, c.pos, c.size, c.color]
s = sphere(); c = s.clone(); c.pos.x = 5; c.radius = 3; [s.pos, s.size]
cylinder(pos=vector(1, 2, 3), axis=vector(2, 0, 0), radius=3).bounding_box()
box(size=vector(1, 2, 3)).bounding_box()
b = box(color=color.red); b.make_trail = True; b.clear_trail(); [b.red, b.green, b.make_trail]
[isinstance(each, (box, cylinder, sphere)) for each in (cone(), ellipsoid(), simple_sphere(), arrow(), label())]
[color.rgb_to_hsv(color.orange), color.hsv_to_rgb(vector(0.2, 0.5, 1)), color.rgb_to_grayscale(color.purple)]
[float(x) for x in arange(0, 1, 0.25)]
[sign(-2.5), sign(0), sign(3), combin(5, 2)]
0 <= random() < 1 and vector.random().mag2 <= 3
a = attach_arrow(sphere(color=color.red), "pos", scale=2); [a.color, a.scale]
[wtext(text=3) is None, keysdown(), clock() > 0]
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
label(pos=(1, 2, 3))
label(color="red")
label(background="red")
arrow(axis=3)
sphere().radus
label().txt
arrow().lenght
scene.titel
scene.camera.position
box().move(1)
curve().pos
button(text="a")
text()
extrusion()
frame()
faces()
lable()
attach_arrow(sphere(), "velocity")
attach_arrow(sphere(), "radius")
canvas(center=(0, 0, 0))
canvas(lights=[])
""".strip().splitlines()

# VPython's vectors without compiled code refuse these with a different error.
UNCOMPILED = dict.fromkeys(["mag((1, 2, 3))", "mag(3)"], "refused: AttributeError")
WHOSE_VECTOR = "vector.__module__"

# The names that `from vpython import *` brings, and the attributes of these things.
NAMES = "sorted({*globals()} - {'attributes', '__builtins__'})"
THINGS = (
    """
vector(1, 2, 3); color; textures; bumpmaps; shapes; paths; scene; scene.camera; scene.mouse; canvas(title="a")
box(); sphere(); cylinder(); simple_sphere(); cone(); pyramid(); ellipsoid(); ring(); helix(); arrow(); label()
curve(); points(); attach_trail(sphere()); attach_arrow(sphere(), "pos"); vertex(pos=vector(1, 1, 1)); compound; text
extrusion; triangle; quad; local_light(pos=vector(1, 1, 1)); distant_light(direction=vector(1, 1, 1)); wtext()
button(bind=print); checkbox(bind=print); radio(bind=print); winput(bind=print); menu(bind=print, choices=["a"])
slider(bind=print); graph(); gcurve(); gdots(); gvbars(); ghbars(); meta_canvas(); GlowWidget
""".replace("\n", ";")
    .strip(";")
    .split(";")
)
THINGS = [thing.strip() for thing in THINGS]
# VPython's own use of its objects: no program of a student's needs these.
MACHINERY = {
    *("attrLists", "attrlists", "handle_event", "hasmouse", "idx", "ignore", "maxVertices", "objName", "objz"),
    *("canvas", "path", "shape", "check_shape", "checkjointlist", "level", "vecs_to_list"),
    *("decrementTriangleCount", "incrementTriangleCount", "triangleCount", "parse_pos", "process_args"),
    *("preresolve1", "preresolve2", "resolveargs", "rotate_in_place", "setpick", "setup", "vertexCount"),
}
ADDED = {"bound", "delete", "empty"}  # a test uses the first one; VPython's other objects have the others, too

# Both sides run this: it reads the programs, and prints the value or the kind of error of each.
RUNNER = """
import json, sys
if sys.argv[1] == "headless":
    from support.headless_vpython import install
    install()
import vpython
if sys.argv[1] == "vpython":
    vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser
    vpython.baseObj.empty = classmethod(lambda cls: True)  # "and it has all objects": a clone waits for this

def plain(value):
    if isinstance(value, vpython.vector):
        return ["vector", value.x, value.y, value.z]
    return [plain(item) for item in value] if isinstance(value, (list, tuple)) else value

def attributes(thing):
    # Return the public attributes: a plain value, or else "function", "other", or "refused". pick waits for a page.
    told, machinery = {}, {"pick"} | set(dir(vpython.baseObj) if sys.argv[1] == "vpython" else ())
    for name in {name for name in dir(thing) if name[0] != "_"} - machinery:
        try:
            value = plain(getattr(thing, name))
        except AttributeError:
            value = "refused"
        is_vector = isinstance(value, list) and value[:1] == ["vector"]
        is_plain = is_vector or isinstance(value, (bool, float, int, str, type(None)))
        told[name] = value if is_plain else "function" if callable(value) else "other"
    return told

def outcome(program):
    names = {"attributes": attributes}
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
    programs = [WHOSE_VECTOR, NAMES, *map("attributes({})".format, THINGS), *VALUES, *REFUSED]
    words = json.dumps(programs)
    options = {"cwd": ROOT, "text": True, "timeout": SECONDS}
    done = subprocess.run(command, input=words, stdout=subprocess.PIPE, check=True, **options)
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


def test_the_same_names(both):
    headless, real = (outcomes[NAMES] for outcomes in both)
    assert len(real) > 100
    assert headless == real


@pytest.mark.parametrize("thing", THINGS)
def test_the_same_attributes(thing, both):
    """The stand-in has no attribute that VPython lacks. It has those of VPython, with their values at the start."""
    headless, real = (outcomes[f"attributes({thing})"] for outcomes in both)
    assert headless.keys() <= real.keys() | ADDED
    real = {name: value for name, value in real.items() if name not in MACHINERY and value != "refused"}
    assert real.keys() <= headless.keys()
    if "(" in thing or "." in thing:
        assert {name: flat([headless[name]]) for name in real} == {
            name: [pytest.approx(leaf) if isinstance(leaf, float) else leaf for leaf in flat([value])]
            for name, value in real.items()
        }


def test_nothing_waits():
    """On VPython itself, each of these lines waits, for ever or for a long time."""
    assert headless_vpython.rate(1e-9) is None
    assert headless_vpython.sleep(1e9) is None
    scene = headless_vpython.scene
    assert [scene.waitfor("click").event, scene.waitfor("keydown").key, scene.pause().event] == ["click", "", "click"]
    assert scene.mouse.pick is None
    assert headless_vpython.text(text="a").text == "a"
    parts = [headless_vpython.box(), headless_vpython.cone()]
    assert headless_vpython.compound(parts).visible
    assert not [part for part in parts if part.visible]


def test_text_is_no_number():
    """VPython's compiled vector refuses it too; its slower vector without compiled code accepts it."""
    with pytest.raises(TypeError):
        headless_vpython.vector("1", 2, 3)
