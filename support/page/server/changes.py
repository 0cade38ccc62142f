"""What has changed in VPython's drawing and in the state, for tabs that lack more or less of it.

VPython keeps a list of its changes, and forgets them when they are sent. Here, each change has the
number of the delivery in which it came last, and each message the number of the last delivery in
it. What a tab lacks is all with a later number than that of its last message. So a new tab, a slow
one, and one whose line was cut are one case: it gets the last value of each attribute, less often
maybe, and loses nothing.

    a message   {"number": number, "cmds": [...], "attrs": [...], "state": {...}}

cmds and attrs are VPython's (package in vpython.py, decode in glowcomm.html):

    cmds    {"cmd": kind, "idx": number, ...}   makes the object with this number
            {"idx": number, name: value}        sets an attribute of the canvas
    attrs   "a12Jvalue", "b12ovalue"            sets the attribute J or o of object 12
            "m12Gvalue"                         calls the method G of object 12: clear_trail, ...

state has what the page shows outside the canvas, by name (names.py): only what has changed.
"""

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

Changed = dict[Any, tuple[int, Any]]  # the number of the delivery and the change, by its key


class Changes:
    """All changes of VPython's and of the state, by what they change, the latest one last."""

    def __init__(self) -> None:
        """Begin with nothing."""
        self.number = 0  # of the last delivery
        self.drawing: Changed = {}  # cmds are dictionaries, attrs are texts
        self.state: Changed = {}  # by the name of the value

    def add(
        self, state: Mapping[str, Any], cmds: Iterable[dict] = (), attrs: Iterable[str] = ()
    ) -> None:
        """Add a delivery, its changes last.

        The order matters: one attribute can change another, as axis and size do.
        """
        self.number += 1
        for cmd in cmds:
            names = ["cmd"] if "cmd" in cmd else sorted(cmd.keys() - {"idx"})
            self.put(self.drawing, (cmd["idx"], *names), cmd)
        for text in attrs:
            self.put(self.drawing, attribute_in(text), text)
        for name, value in state.items():
            self.put(self.state, name, value)

    def put(self, changed: Changed, key: Any, change: Any) -> None:
        """Put a change of this delivery last."""
        changed.pop(key, None)
        changed[key] = (self.number, change)

    def message(self, has: int) -> bytes:
        """Return all that is later than the delivery with the number `has` as one message."""
        drawing = later(self.drawing, has)
        for key in [*drawing]:
            # A shape is made with its last texture: glow.min.js mixes up two that it loads.
            is_texture = isinstance(key, tuple) and key[1] == "texture"
            maker = (key[0], "cmd")
            if is_texture and maker in drawing:
                drawing[maker] = drawing[maker] | drawing.pop(key)
        message = {
            "number": self.number,
            "cmds": [change for change in drawing.values() if isinstance(change, dict)],
            "attrs": [change for change in drawing.values() if isinstance(change, str)],
            "state": later(self.state, has),
        }
        # A student's number can be numpy's.
        return json.dumps(message, separators=(",", ":"), default=float).encode()


def attribute_in(text: str) -> str:
    """Return which attribute an attr of VPython sets; a call of a method stands for itself."""
    found = re.match(r"[^m]\d+.", text)
    return found[0] if found else text


def later(changed: Changed, has: int) -> dict[Any, Any]:
    """Return the changes that are later than the delivery with the number `has`, in their order."""
    found = []
    for key, (number, change) in reversed(changed.items()):
        if number <= has:
            break
        found.append((key, change))
    return dict(reversed(found))
