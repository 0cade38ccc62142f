"""The tabs that show the cradle: how much is under way to each one, and the commands they give.

to a tab    messages of changes.py
from a tab  "seen" for each picture that it has drawn after a message, or [command, value, ...]
"""

import json
from collections import deque
from collections.abc import Callable, Mapping
from queue import SimpleQueue
from threading import Event
from typing import Any

from support.page.server.changes import Changes
from support.page.server.film import Film, FilmPicture
from support.page.vpython_inside import take_changes

# What can be under way to a tab: a far one needs several messages, a slow line not too many bytes.
MOST_MESSAGES = 24  # messages
MOST_BYTES = 2**18  # bytes
NEW = object()  # unlike each value


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

    The program calls have_room, show, tell and begin_run, takes the commands, and looks at is_seen
    and are_gone; the server calls the other methods, in its own thread.
    """

    def __init__(self, in_server: Callable[..., Any], film: Film | None = None) -> None:
        """Begin without a tab; in_server calls a function with arguments in the server's thread."""
        self.in_server = in_server
        self.film = film or Film()  # of the present run
        self.all = Changes()  # VPython never sends a change again
        self.tabs: dict[Any, Tab] = {}  # by the websocket
        self.last: dict[str, Any] = {}  # the state that the tabs have, or will have
        self.commands: SimpleQueue[list] = SimpleQueue()  # [command, value, ...]
        self.holder: Any = None  # the tab with the mouse down
        self.is_seen = Event()  # whether a tab has drawn the first picture
        self.are_gone = False  # whether the last tab was closed for good

    def have_room(self) -> bool:
        """Return whether a tab can take a message now; else, changes had better wait, and merge."""
        return any(tab.has_room for tab in [*self.tabs.values()])

    def show(self, state: Mapping[str, Any]) -> None:
        """Send what VPython's objects have changed, and what differs in the state.

        The state can be a part of it, or all.
        """
        new = self.changes(state)
        drawing = take_changes()
        if new or drawing:
            self.in_server(self.deliver, new, drawing)

    def tell(self, state: Mapping[str, Any]) -> None:
        """Send what differs in these values, from any thread; the picture stays as it is."""
        new = self.changes(state)
        if new:
            self.in_server(self.deliver, new, {})

    def changes(self, state: Mapping[str, Any]) -> dict[str, Any]:
        """Return which of these values differ from the last ones; they are the last ones now."""
        new = {name: value for name, value in state.items() if self.last.get(name, NEW) != value}
        self.last.update(new)
        return new

    def deliver(self, state: Mapping[str, Any], drawing: Mapping[str, list]) -> None:
        """Give changes to all tabs, also to those that come later.

        If they say that the program has ended, give them at once.
        """
        self.all.add(state, **drawing)
        has_ended = state.get("ended") is not None
        for tab in [*self.tabs.values()]:
            tab.update(self.all, at_once=has_ended)
        self.film.take(self.all, at_once=has_ended)

    def pictures(self) -> list[FilmPicture]:
        """Return the film of the present run, up to now."""
        self.film.take(self.all, at_once=True)
        return [*self.film.pictures]

    def begin_run(self) -> None:
        """Begin a film with what is shown next, a new run."""
        self.in_server(self.film.begin)

    def open(self, socket: Any, send: Callable[[bytes], None], has: int = 0) -> None:
        """Let a tab have all that is later than the delivery with the number `has`.

        send sends a message to it.
        """
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
        except (ValueError, TypeError):
            return
        if command in ("grab", "drag", "let_go"):
            is_free = self.holder is None and command == "grab"
            if self.holder is not socket and not is_free:
                return  # one tab alone has the mouse down
            self.holder = None if command == "let_go" else socket
        self.commands.put([command, *values])
