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
            "m12Gvalue"                         calls the method G of object 12: clear_trail, ...

state has what the page shows outside the canvas, by name (state.py): only what has changed.
"""

import json
import re
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from threading import Event
from typing import Any

from vpython import baseObj, vector

from support.page.film import Film

LOOK_AT_TABS = 0.5  # s from one look of the server at the tabs to the next
# What can be under way to a tab: a far one needs several messages, a slow line not too many bytes.
MOST_MESSAGES = 24  # messages
MOST_BYTES = 2**18  # bytes

NEW = object()  # unlike each value

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


def vpython_changes() -> dict[str, list]:
    """Return what VPython would send now, its cmds and attrs; it then forgets them."""
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


class Tab:
    """What one tab has got, and how much is under way to it."""

    def __init__(self, send: Callable[[bytes], None], has: int):
        """Begin with all up to the delivery with the number `has`; send sends a message."""
        self.send = send
        self.has = has
        self.under_way: deque[int] = deque()  # the sizes of messages (bytes), the oldest one first
        self.has_room = True  # for one message more

    def update(self, changes: Changes, at_once: bool = False) -> None:
        """Send all that the tab lacks as soon as there is room, or at once."""
        lacks_something = self.has < changes.number
        if lacks_something and (self.has_room or at_once):
            message = changes.message(self.has)
            self.has = changes.number
            self.under_way.append(len(message))
            self.send(message)
            self.measure()

    def count_drawn(self, count: int) -> None:
        """Count pictures that the tab has drawn: as many messages have arrived, the oldest ones."""
        for _ in range(min(count, len(self.under_way))):
            self.under_way.popleft()
        self.measure()

    def measure(self) -> None:
        """Find out whether there is room."""
        self.has_room = len(self.under_way) < MOST_MESSAGES and sum(self.under_way) < MOST_BYTES


class Tabs:
    """All tabs.

    The program calls have_room, show and begin_run, and looks at is_seen and are_gone; the server
    calls the other methods, in its own thread.
    """

    def __init__(self) -> None:
        """Begin without a tab."""
        self.all = Changes()  # VPython never sends a change again
        self.film = Film()  # of the present run
        self.tabs: dict[Any, Tab] = {}  # by the websocket
        self.last: dict[str, Any] = {}  # the state that the tabs have, or will have
        self.holder: Any = None  # the tab with the mouse down
        self.is_seen = Event()  # whether a tab has drawn the first picture
        self.are_gone = False  # whether the last tab was closed for good
        # The viewer sets these two: what takes a command of a tab, and what returns a message
        # about a function that does not return.
        self.give: Callable[..., None] = lambda command, *values: None
        self.endless: Callable[[], str] = lambda: ""
        # The server sets this: what calls a function in its thread.
        self.in_server: Callable[..., Any] = lambda function, *arguments: function(*arguments)

    def have_room(self) -> bool:
        """Return whether a tab can take a message now; else, changes had better wait, and merge."""
        return any(tab.has_room for tab in [*self.tabs.values()])

    def show(self, state: Mapping[str, Any]) -> None:
        """Send what VPython's objects have changed, and what differs in the state.

        The state can be a part of it, or all.
        """
        new = {name: value for name, value in state.items() if self.last.get(name, NEW) != value}
        self.last.update(new)
        drawing = vpython_changes()
        if new or drawing:
            self.in_server(self.deliver, new, drawing)

    def deliver(self, state: Mapping[str, Any], drawing: Mapping[str, list]) -> None:
        """Give changes to all tabs, also to those that come later.

        If they say that the program has ended, give them at once.
        """
        self.all.add(state, **drawing)
        has_ended = state.get("ended") is not None
        for tab in [*self.tabs.values()]:
            tab.update(self.all, at_once=has_ended)
        self.film.take(self.all, at_once=has_ended)

    def begin_run(self) -> None:
        """Begin a film with what is shown next, a new run."""
        self.in_server(self.film.begin)

    def look(self) -> None:
        """Tell the tabs of a function that does not return, and when it has.

        The server calls it each LOOK_AT_TABS seconds.
        """
        message = self.endless()
        if message != self.last.get("endless", ""):
            self.last["endless"] = message
            self.deliver({"endless": message}, {})

    def open(self, socket: Any, send: Callable[[bytes], None], has: int = 0) -> None:
        """Let a tab have all that is later than the delivery with the number `has`.

        send sends a message to it.
        """
        if has > self.all.number:  # of an earlier program
            has = 0
        self.tabs[socket] = Tab(send, has)
        self.tabs[socket].update(self.all)

    def close(self, socket: Any) -> None:
        """Forget a tab; a bob that it held swings on."""
        self.receive(socket, b'["let_go"]')
        del self.tabs[socket]

    def receive(self, socket: Any, data: bytes) -> None:
        """Take a message of a tab; forget one that is no command."""
        if data.startswith(b"seen"):
            self.is_seen.set()
            self.tabs[socket].count_drawn(data.count(b"seen"))
            self.tabs[socket].update(self.all)
            return
        try:
            command, *values = json.loads(data)
        except (ValueError, TypeError, RecursionError):
            return
        if command in ("grab", "drag", "let_go"):
            is_free = self.holder is None and command == "grab"
            if self.holder is not socket and not is_free:
                return  # one tab alone has the mouse down
            self.holder = None if command == "let_go" else socket
        self.give(command, *values)
