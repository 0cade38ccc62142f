"""The tabs that show the cradle: what each one still has to get, and the commands that it gives.

VPython keeps a list of its changes, and forgets them when they are sent. Here, each tab has a list of its own: what it
has not got yet. The last value of an attribute counts, so a slow tab gets less often, and loses nothing. A new tab gets
all that there is.

    to a tab    {"cmds": [...], "attrs": [...], "state": {...}}
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

MOST, LARGEST = 24, 2**18  # messages under way to a tab, and bytes: a far tab needs several, a slow line not too many


class Changes:
    """Changes by what they change: VPython's commands and attributes, and the state."""

    def __init__(self, cmds=(), attrs=(), state=()):
        """Take the changes in a message of VPython's, and in the state."""
        self.drawing: dict[Any, Any] = {}  # cmds are dictionaries, attrs are texts
        self.state: dict[str, Any] = dict(state)
        for cmd in cmds:
            names = ["cmd"] if "cmd" in cmd else sorted(cmd.keys() - {"idx"})
            self.put((cmd["idx"], *names), cmd)
        for text in attrs:
            self.put(text if text[0] == "m" else re.match(r"\w\d+.", text)[0], text)  # type: ignore[index]

    def __bool__(self):
        return bool(self.drawing or self.state)

    def put(self, key, change) -> None:
        """Put a change of VPython's last: an attribute can change another one, as axis and size do."""
        maker = (key[0], "cmd")
        # A shape is made with its last texture: glow.min.js mixes up two that it loads.
        if key[1] == "texture" and maker in self.drawing:
            self.drawing[maker] = {**self.drawing[maker], **change}
        else:
            self.drawing.pop(key, None)
            self.drawing[key] = change

    def add(self, later) -> None:
        """Add later changes."""
        for key, change in later.drawing.items():
            self.put(key, change)
        self.state |= later.state

    def message(self) -> bytes:
        """Return them as one message."""
        cmds = [change for change in self.drawing.values() if isinstance(change, dict)]
        attrs = [change for change in self.drawing.values() if isinstance(change, str)]
        parts = {"cmds": cmds, "attrs": attrs, "state": self.state}
        return json.dumps(parts, separators=(",", ":"), default=float).encode()  # a student's number can be numpy's


def vpython_changes() -> dict:
    """Return what VPython would send now, as a message; it then forgets it."""
    baseObj.handle_attach()
    updates, attributes = baseObj.updates, baseObj.attrs
    baseObj.initialize()
    for number, name in attributes:
        value = getattr(baseObj.object_registry[number], name)
        values = updates["attrs"].setdefault(number, {})
        values[name] = [value.x, value.y, value.z] if isinstance(value, vector) else value
    return baseObj.package(updates)


class Tab:
    """What one tab still has to get, and how much is under way to it: the sizes of messages (bytes)."""

    def __init__(self, send):
        """Begin with nothing; send(message) sends bytes."""
        self.send, self.pending = send, Changes()
        self.under_way: deque[int] = deque()
        self.has_room = True  # for one message more

    def take(self, changes) -> None:
        """Send these changes, with those that wait, as soon as there is room; at once, why the program has ended."""
        self.pending.add(changes)
        if self.pending and (self.has_room or self.pending.state.get("ended")):
            message, self.pending = self.pending.message(), Changes()
            self.under_way.append(len(message))
            self.send(message)
            self.measure()

    def seen(self, count) -> None:
        """Count pictures that the tab has drawn: as many messages, the oldest ones, are no longer under way."""
        for _ in range(min(count, len(self.under_way))):
            self.under_way.popleft()
        self.measure()
        self.take(Changes())

    def measure(self) -> None:
        """Find out whether there is room."""
        self.has_room = len(self.under_way) < MOST and sum(self.under_way) < LARGEST


class Tabs:
    """All tabs. The viewer calls have_room and show, the server calls open, close and receive in its own thread."""

    all = Changes()  # of each start in this Python: VPython never sends a change again

    def __init__(self):
        """Begin without a tab; the server sets in_server, which calls a function in its thread."""
        self.all.state.clear()
        self.tabs: dict[Any, Tab] = {}  # by the websocket
        self.is_begun = False  # whether this run has shown something; what an earlier one has left must not appear
        self.last: dict = {}  # the state that the tabs have, or will have
        self.in_server = lambda function, *arguments: function(*arguments)
        self.give = lambda command, *values: None  # the viewer sets it; takes a command of a tab
        self.holder: Any = None  # the tab with the mouse down
        self.is_seen = Event()  # whether a tab has drawn the first picture
        self.are_gone = False  # whether the last tab was closed for good

    def have_room(self) -> bool:
        """Return whether a tab can take a message now: else, changes had better wait where they are, and merge."""
        return any(tab.has_room for tab in [*self.tabs.values()])

    def show(self, state) -> None:
        """Send what VPython's objects have changed, and what differs in the state, a part of it or all."""
        new = {name: value for name, value in state.items() if name not in self.last or self.last[name] != value}
        self.last.update(new)
        changes = Changes(**vpython_changes(), state=new)
        if changes:
            self.in_server(self.deliver, changes)

    def deliver(self, changes) -> None:
        """Give changes to all tabs, also to those that come later; show calls it in the server's thread."""
        self.all.add(changes)
        for tab in [*self.tabs.values()]:
            tab.take(changes if self.is_begun else self.all)
        self.is_begun = True

    def open(self, socket, send) -> None:
        """Let a new tab have all that there is; send(message) sends bytes to it."""
        self.tabs[socket] = Tab(send)
        self.tabs[socket].take(self.all if self.is_begun else Changes())

    def close(self, socket) -> None:
        """Forget a tab; a bob that it held swings on."""
        self.receive(socket, b'["let go"]')
        del self.tabs[socket]

    def receive(self, socket, data) -> None:
        """Take a message of a tab; forget one that is no command. While one tab has the mouse down, others cannot."""
        if data.startswith(b"seen"):
            self.is_seen.set()
            self.tabs[socket].seen(data.count(b"seen"))
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
