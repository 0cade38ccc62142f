"""VPython's private names: all that the page uses, what each is, and what breaks without it.

So the page needs one version of VPython (support/requirements.txt). Its tests in the project fail
first when another one comes. The names that the browser uses are in web/glow.js.

    vpython.vpython
        baseObj._view_constructed  whether VPython's own page is there; while it is false, the first
                                   object starts a server and a browser
        baseObj.empty()            whether nothing is on its way to that page; clone() waits for it
        baseObj.handle_attach()    lets attached trails and labels follow their objects
        baseObj.updates, .attrs    what has changed since the last initialize(): whole objects, and
                                   attributes as (number of the object, name)
        baseObj.initialize()       forgets these changes
        baseObj.object_registry    the objects, by their numbers
        baseObj.package(updates)   the changes as cmds and attrs, which glowcomm.html decodes
        _wait                      what waits for an answer of that page
        text, compound, ...        classes whose objects need such an answer, or a place there
        standardAttributes
            ._make_trail           whether an object leaves a trail: a constructor and make_trail
                                   set it
    vpython_libraries              the folder of glow.min.js and glowcomm.html
    vpython_data                   the folder of the textures
"""

from importlib import import_module
from importlib.machinery import PathFinder
from pathlib import Path
from typing import Any, NoReturn

from vpython import baseObj, vector

from support import simulation
from support.root import ROOT

NEED_ITS_PAGE = "text", "compound", "extrusion", "graph", "gobj", "controls", "attach_trail"
GROW = "curve", "points"  # they grow by calls, and a new tab would need all of these calls
# In glowcomm.html, its own websocket and its fonts are before this.
SCRIPT = "window.__GSlang ="
# In glow.min.js: a call without a use, which some sites forbid.
EVAL = b'eval("0");'


def draw_without_its_page() -> None:
    """Let VPython make objects for our page.

    Its own page, and a server for it, would come with the first object. An object that needs an
    answer of VPython's page, or a place on it, raises a RuntimeError: VPython would wait for ever.
    So does a trail, which our page cannot draw. rate is that of the program's loop
    (support/simulation.py). sleep does nothing, and delete hides a shape.

    Raises a ModuleNotFoundError for another version.
    """
    vpython = import_module("vpython.vpython")
    requirements = (ROOT / "support" / "requirements.txt").read_text(encoding="utf-8")
    if f"vpython=={vpython.__version__}\n" not in requirements:
        found = f"{vpython.__version__} in {vpython.__file__}"
        raise ModuleNotFoundError(f"the page needs another VPython than {found}", name="vpython")
    vpython.baseObj._view_constructed = True
    vpython.baseObj.empty = lambda: True

    def refuse(*_: object, **__: object) -> NoReturn:
        raise RuntimeError(
            "the page shows VPython's shapes, but no trail, curve, points, text, compound, "
            "extrusion, graph, button or the like, and nothing can wait for a click"
        )

    def refuse_trail(_: object, makes_trail: bool) -> None:
        if makes_trail:
            refuse()

    def hide(shape: Any) -> None:
        shape.visible = False

    vpython.baseObj.delete = hide  # type: ignore[method-assign]
    for name in NEED_ITS_PAGE + GROW:
        getattr(vpython, name).__new__ = refuse
    vpython._wait = refuse  # type: ignore[attr-defined]
    vpython.standardAttributes._make_trail = property(lambda _: False, refuse_trail)
    package: Any = import_module("vpython")
    package.rate = simulation.rate
    package.sleep = lambda *_: None


def take_changes() -> dict[str, list]:
    """Return what VPython would send to its page now, its cmds and attrs; it then forgets them."""
    baseObj.handle_attach()
    updates = baseObj.updates
    attributes = baseObj.attrs
    baseObj.initialize()
    for number, name in attributes:
        value = getattr(baseObj.object_registry[number], name)
        if isinstance(value, vector):
            value = [value.x, value.y, value.z]
        updates["attrs"].setdefault(number, {})[name] = value
    return baseObj.package(updates)


def files_for_a_browser() -> dict[str, bytes]:
    """Return the content of the scripts that the page uses, and of the textures, by their names.

    vpython.js is the script of VPython's own page, without its websocket.
    """
    [folder] = PathFinder.find_spec("vpython").submodule_search_locations  # type: ignore[union-attr, misc]
    libraries = Path(folder, "vpython_libraries")
    textures = Path(folder, "vpython_data").glob("*.jpg")
    files = {path.name: path.read_bytes() for path in textures}
    files["jquery.min.js"] = (libraries / "jquery.min.js").read_bytes()
    page = (libraries / "glowcomm.html").read_text(encoding="utf-8")
    _, start, script = page.partition(SCRIPT)
    files["vpython.js"] = (start + script).partition("</script>")[0].encode()
    files["glow.min.js"] = (libraries / "glow.min.js").read_bytes().replace(EVAL, b"")
    return files
