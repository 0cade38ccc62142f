"""The tabs that show the cradle: what each one still has to get, and the commands that it gives.

VPython keeps a list of its changes, and forgets them when they are sent. Here, each change has the
number of the delivery in which it came last, and each message the number of the last delivery in
it. What a tab lacks is all with a later number than that of its last message. So a new tab, a slow
one, and one whose line was cut are one case: it gets the last value of each attribute, less often
maybe, and loses nothing.

    to a tab    {"number": number, "cmds": [...], "attrs": [...], "state": {...}}
    from a tab  "seen" for each picture that it has drawn after a message, or [command, value, ...]

cmds and attrs are VPython's (package in vpython.py, decode in glowcomm.html):

    cmds    {"cmd": kind, "idx": number, ...}   makes the object with this number
            {"idx": number, name: value}        sets an attribute of the canvas
    attrs   "a12Jvalue", "b12ovalue"            sets the attribute J or o of object 12
            "m12Gvalue"                         calls the method G of object 12, for instance clear_trail

state has what the page shows beside the canvas, by name (Viewer.state): only what has changed.
"""

import json
import re
from collections import deque
from threading import Event
from typing import Any

from vpython import baseObj, vector

LOOK = 0.5  # s from one look of the server at the tabs to the next
# Messages under way to a tab, and bytes: a far tab needs several, a slow line not too many
MOST = 24
LARGEST = 2**18


class Changes:
    """All changes of VPython's and of the state, by what they change, the latest one last."""

    def __init__(self):
        """Begin with nothing."""
        self.number = 0  # of the last delivery
        # Numbers and changes: cmds are dictionaries, attrs are texts
        self.drawing: dict[Any, tuple[int, Any]] = {}
        self.state: dict[str, tuple[int, Any]] = {}

    def add(self, state, cmds=(), attrs=()) -> None:
        """Add a delivery.

        A change comes last: an attribute can change another one, as axis and size do.
        """
        self.number += 1
        for cmd in cmds:
            names = ["cmd"] if "cmd" in cmd else sorted(cmd.keys() - {"idx"})
            self.put(self.drawing, (cmd["idx"], *names), cmd)
        for text in attrs:
            key = text if text[0] == "m" else re.match(r"\w\d+.", text)[0]  # type: ignore[index]
            self.put(self.drawing, key, text)
        for name, value in state.items():
            self.put(self.state, name, value)

    def put(self, changes, key, change) -> None:
        """Put a change of this delivery last."""
        changes.pop(key, None)
        changes[key] = self.number, change

    def message(self, has) -> bytes:
        """Return all that is later than the delivery with the number `has` as one message."""
        drawing, state = later(self.drawing, has), later(self.state, has)
        for key in [*drawing]:
            maker = key[0], "cmd"
            # A shape is made with its last texture: glow.min.js mixes up two that it loads.
            if key[1] == "texture" and maker in drawing:
                drawing[maker] = drawing[maker] | drawing.pop(key)
        cmds = [change for change in drawing.values() if isinstance(change, dict)]
        attrs = [change for change in drawing.values() if isinstance(change, str)]
        parts = {"number": self.number, "cmds": cmds, "attrs": attrs, "state": state}
        # A student's number can be numpy's
        return json.dumps(parts, separators=(",", ":"), default=float).encode()


def later(changes, has) -> dict:
    """Return the changes that are later than the delivery with the number `has`, in their order."""
    found = []
    for key, (number, change) in reversed(changes.items()):
        if number <= has:
            break
        found.append((key, change))
    return dict(reversed(found))


def vpython_changes() -> dict:
    """Return what VPython would send now, its cmds and attrs; it then forgets them."""
    baseObj.handle_attach()
    updates, attributes = baseObj.updates, baseObj.attrs
    baseObj.initialize()
    for number, name in attributes:
        value = getattr(baseObj.object_registry[number], name)
        values = updates["attrs"].setdefault(number, {})
        values[name] = [value.x, value.y, value.z] if isinstance(value, vector) else value
    return baseObj.package(updates)


class Tab:
    """What one tab has got, and how much is under way to it: the sizes of messages (bytes)."""

    def __init__(self, send, has):
        """Begin with all up to the delivery with the number `has`; send(message) sends bytes."""
        self.send, self.has = send, has
        self.under_way: deque[int] = deque()
        self.has_room = True  # for one message more

    def take(self, changes, at_once=False) -> None:
        """Send all that the tab lacks, if it lacks something, as soon as there is room, or at once."""
        if self.has < changes.number and (self.has_room or at_once):
            message, self.has = changes.message(self.has), changes.number
            self.under_way.append(len(message))
            self.send(message)
            self.measure()

    def seen(self, count) -> None:
        """Count pictures that the tab has drawn: as many messages, the oldest ones, are no longer
        under way.
        """
        for _ in range(min(count, len(self.under_way))):
            self.under_way.popleft()
        self.measure()

    def measure(self) -> None:
        """Find out whether there is room."""
        self.has_room = len(self.under_way) < MOST and sum(self.under_way) < LARGEST


class Tabs:
    """All tabs.

    The viewer calls have_room and show, the server the other methods, in its own thread.
    """

    def __init__(self):
        """Begin without a tab; the server sets in_server, which calls a function in its thread."""
        self.all = Changes()  # VPython never sends a change again
        self.tabs: dict[Any, Tab] = {}  # by the websocket
        self.last: dict = {}  # the state that the tabs have, or will have
        self.in_server = lambda function, *arguments: function(*arguments)
        self.give = lambda command, *values: None  # the viewer sets it; takes a command of a tab
        # The viewer sets it; returns words on a function that does not return
        self.endless = lambda: ""
        self.holder: Any = None  # the tab with the mouse down
        self.is_seen = Event()  # whether a tab has drawn the first picture
        self.are_gone = False  # whether the last tab was closed for good

    def have_room(self) -> bool:
        """Return whether a tab can take a message now: else, changes had better wait where they
        are, and merge.
        """
        return any(tab.has_room for tab in [*self.tabs.values()])

    def show(self, state) -> None:
        """Send what VPython's objects have changed, and what differs in the state, a part of it or
        all.
        """
        new = {
            name: value
            for name, value in state.items()
            if name not in self.last or self.last[name] != value
        }
        self.last.update(new)
        drawing = vpython_changes()
        if new or drawing:
            self.in_server(self.deliver, new, drawing)

    def deliver(self, state, drawing) -> None:
        """Give changes to all tabs, also to those that come later; at once, that the program has
        ended, and why.
        """
        self.all.add(state, **drawing)
        for tab in [*self.tabs.values()]:
            tab.take(self.all, at_once=state.get("ended") is not None)

    def look(self) -> None:
        """Tell the tabs of a function that does not return, and when it has; the server calls it
        each LOOK seconds.
        """
        words = self.endless()
        if words != self.last.get("endless", ""):
            self.last["endless"] = words
            self.deliver({"endless": words}, {})

    def open(self, socket, send, has=0) -> None:
        """Let a tab have all that is later than the delivery with the number `has`; send(message)
        sends bytes to it.
        """
        self.tabs[socket] = Tab(send, has if has <= self.all.number else 0)
        self.tabs[socket].take(self.all)

    def close(self, socket) -> None:
        """Forget a tab; a bob that it held swings on."""
        self.receive(socket, b'["let go"]')
        del self.tabs[socket]

    def receive(self, socket, data) -> None:
        """Take a message of a tab; forget one that is no command.

        While one tab has the mouse down, others cannot.
        """
        if data.startswith(b"seen"):
            self.is_seen.set()
            self.tabs[socket].seen(data.count(b"seen"))
            self.tabs[socket].take(self.all)
            return
        try:
            command, *values = json.loads(data)
        except (ValueError, TypeError, RecursionError):
            return
        if command in ("grab", "drag", "let go"):
            if self.holder not in (socket, None if command == "grab" else socket):
                return
            self.holder = None if command == "let go" else socket
        self.give(command, *values)
