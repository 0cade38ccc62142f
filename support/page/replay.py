"""Keep what VPython has sent to the page, to show it again to a page that has just been loaded.

VPython sends each change once. A message has two lists (package in vpython.py, decode in glowcomm.html):

    cmds    {"cmd": kind, "idx": number, ...}   makes the object with this number
            {"idx": number, name: value}        sets an attribute of the canvas, or adds to its caption
    attrs   "a12Jvalue", "b12ovalue"            sets the attribute J or o of object 12
            "m12Gvalue"                         calls the method G of object 12, for instance bind
"""

import re

ADDING = ("append_to_caption", "append_to_title")


class Replay:
    """The messages to the page, as one with the same result: it keeps only the last value of each attribute."""

    def __init__(self):
        self.cmds: dict[tuple, dict] = {}
        self.attrs: dict[str, str] = {}

    def add(self, message) -> None:
        """Add a message."""
        for cmd in message.get("cmds", []):
            names = ["cmd"] if "cmd" in cmd else sorted(cmd.keys() - {"idx"})
            number = len(self.cmds) if names[0] in ADDING else 0  # the texts are all kept, also equal ones
            put_last(self.cmds, (cmd["idx"], *names, number), cmd)
        for text in message.get("attrs", []):
            key = text if text[0] == "m" else re.match(r"\w\d+.", text)[0]  # type: ignore[index]
            put_last(self.attrs, key, text)

    def message(self) -> dict:
        """Return one message for a page that has nothing yet."""
        return {"cmds": [*self.cmds.values()], "attrs": [*self.attrs.values()]}


def put_last(dictionary, key, value) -> None:
    """Set a value, and move it to the end: an attribute can change another one, as axis and size do."""
    dictionary.pop(key, None)
    dictionary[key] = value
