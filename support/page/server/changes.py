"""What has changed in VPython's drawing and in the state: a tab gets what it does not have yet.

VPython keeps a list of its changes, and forgets them when they are sent. Here, each change has the
number of the delivery in which it came last. A tab gets all changes with a later number than
that of its last message. So a new tab, a slow one, one whose connection was cut, and a film are one
case: each gets the last value of each attribute, less often maybe, and loses nothing.

    a message   {"drawing": {key: change, ...}, "state": {name: value, ...}}

drawing has VPython's cmds and attrs (package in vpython.py, decode in glowcomm.html), each one by a
key that says what it changes:

    "12 cmd"    {"cmd": kind, "idx": 12, ...}   makes object 12
    "0 fov"     {"idx": 0, "fov": value}        sets an attribute of the canvas
    "a12J"      "a12Jvalue"                     sets the attribute J of object 12
    "m12Gvalue" "m12Gvalue"                     calls the method G of object 12: clear_trail, ...

state has what the page shows outside the canvas, by name (names.py): only what has changed.
"""

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

# As json has it: not in JSON
NOT_FINITE = re.compile(r"(?<=[\[:,])(?:NaN|-?Infinity)(?=[\]},])")
Changed = dict[Any, tuple[int, Any]]  # the number of the delivery and the change, by its key


class Changes:
    """All changes of VPython's and of the state, by what they change, the latest one last."""

    def __init__(self) -> None:
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
            self.put(self.drawing, " ".join([str(cmd["idx"]), *names]), cmd)
        for text in attrs:
            self.put(self.drawing, attribute_in(text), text)
        for name, value in state.items():
            self.put(self.state, name, value)

    def put(self, changed: Changed, key: Any, change: Any) -> None:
        """Put a change of this delivery last."""
        changed.pop(key, None)
        changed[key] = (self.number, change)

    def later(self, delivered: int) -> dict[str, dict]:
        """Return the changes after the delivery with the number `delivered`, by their keys."""
        drawing = later(self.drawing, delivered)
        for key in [*drawing]:
            # A shape is made with its last texture: glow.min.js mixes up two that it loads.
            number, _, name = key.partition(" ")
            maker = f"{number} cmd"
            if name == "texture" and maker in drawing:
                drawing[maker] = drawing[maker] | drawing.pop(key)
        return {"drawing": drawing, "state": later(self.state, delivered)}


def as_json(found: object) -> str:
    """Return this as JSON; a student's number can be of any kind, and null if it is not finite."""
    text = json.dumps(found, separators=(",", ":"), default=as_number)
    return NOT_FINITE.sub("null", text) if "NaN" in text or "Infinity" in text else text


def as_number(value: object) -> float | str:
    """Return the number that this value is, or else its text."""
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return str(value)


def attribute_in(text: str) -> str:
    """Return which attribute an attr of VPython sets; a call of a method stands for itself."""
    found = re.match(r"[^m]\d+.", text)
    return found[0] if found else text


def later(changed: Changed, delivered: int) -> dict[Any, Any]:
    """Return the changes after the delivery with the number `delivered`, in their order."""
    found = []
    for key, (number, change) in reversed(changed.items()):
        if number <= delivered:
            break
        found.append((key, change))
    return dict(reversed(found))
