"""The tabs that show the cradle: what each one must still get, and the commands they give.

to a tab    messages of changes.py, and "" as a sign of life
from a tab  ["seen", count of messages shown], [command, value, ...], and "" as a sign of life
"""

import json
import re
from collections.abc import Callable, Mapping
from queue import SimpleQueue
from threading import Event, Lock
from typing import Any

from support.page.server.changes import as_json, Changes
from support.page.server.film import Film, FilmPicture
from support.page.vpython_inside import take_changes

MOST_UNSEEN = 12  # messages that can be under way to a tab: a far one needs several
NEW = object()  # unlike each value
# The folders of this machine before the name of a file, in quotes or not
FOLDERS = re.compile(
    r"(?<=')(?:[A-Za-z]:)?[/\\][^'\n]*[/\\]|(?<![\w.:/\\])(?:[A-Za-z]:)?[/\\](?:[^\s'\"/\\]+[/\\]+)+"
)


class Tab:
    """What one tab has got, and whether it only follows: then it gives no commands."""

    def __init__(
        self,
        send: Callable[[str], None],
        close: Callable[[], None] = lambda: None,
        follows: bool = False,
    ):
        """send sends a message, close ends the connection."""
        self.send = send
        self.close = close
        self.follows = follows
        self.has_bob = False  # whether its mouse has grabbed one, and not yet let it go
        self.delivered = 0  # the number of the last delivery that it has got
        self.allowance = MOST_UNSEEN  # messages that may still be sent

    def update(self, changes: Changes, at_once: bool = False) -> None:
        """Send all that the tab has not got yet, as soon as it can take a message, or at once."""
        is_behind = self.delivered < changes.number
        if is_behind and (self.allowance > 0 or at_once):
            self.send(as_json(changes.later(self.delivered)))
            self.delivered = changes.number
            self.allowance -= 1


class Tabs:
    """All tabs.

    The program calls show, tell and begin_film, from its threads. It takes the commands,
    and looks at is_seen and are_gone. The server calls the other methods, in its own thread.
    """

    def __init__(self, in_server: Callable[..., Any], film: Film | None = None) -> None:
        """Begin without a tab; in_server calls a function with arguments in the server's thread."""
        self.in_server = in_server
        self.film = film or Film()  # of this run
        self.all = Changes()  # VPython never sends a change again
        self.tabs: set[Tab] = set()
        self.last: dict[str, Any] = {}  # the state that the tabs have, or will have
        self.lock = Lock()  # two threads call tell
        self.commands: SimpleQueue[list] = SimpleQueue()  # [command, value, ...]
        self.is_seen = Event()  # whether a tab has drawn the first picture
        self.are_gone = False  # whether no tab will come any more

    def show(self, state: Mapping[str, Any]) -> None:
        """Send what VPython's objects have changed, and what differs in the state.

        The state can be a part of it, or all.
        """
        self.send(state, take_changes())

    def tell(self, state: Mapping[str, Any]) -> None:
        """Send what differs in these values, from any thread; the picture stays as it is."""
        self.send(state, {})

    def send(self, state: Mapping[str, Any], drawing: Mapping[str, list]) -> None:
        """Send a drawing, and what differs in the state: texts without folders of this machine."""
        with self.lock:
            last = self.last
            new = {name: value for name, value in state.items() if last.get(name, NEW) != value}
            last.update(new)
            if new or drawing:
                plain = {name: without_folders(value) for name, value in new.items()}
                self.in_server(self.deliver, plain, drawing)

    def begin_film(self) -> None:
        """Begin a new film, of the run that is shown next."""
        self.in_server(self.film.begin)

    # --- in the server's thread ----------------------------------------------------------------

    def deliver(self, state: Mapping[str, Any], drawing: Mapping[str, list]) -> None:
        """Give changes to all tabs, also to those that come later.

        If they say that the program has ended, give them at once.
        """
        self.all.add(state, **drawing)
        has_ended = "ended" in state
        for tab in self.tabs:
            tab.update(self.all, at_once=has_ended)
        self.film.take(self.all)

    def pictures(self) -> list[FilmPicture]:
        """Return the film of this run, up to now."""
        self.film.take(self.all, at_once=True)
        return [*self.film.pictures]

    def open(self, tab: Tab) -> None:
        """Send a tab all that is shown, now and later."""
        self.tabs.add(tab)
        tab.update(self.all)

    def close(self, tab: Tab) -> None:
        """Forget a tab; a bob that it held swings on."""
        if tab.has_bob:
            self.receive(tab, '["let_go"]')
        self.tabs.discard(tab)

    def receive(self, tab: Tab, message: str | bytes) -> None:
        """Take a message of a tab; ignore one that is no command, or of a tab that follows."""
        try:
            command, *values = json.loads(message)
            seen = int(values[0]) if command == "seen" else 0
        except (ValueError, TypeError, IndexError, OverflowError, RecursionError):
            return
        if seen:
            self.is_seen.set()
            tab.allowance = min(tab.allowance + seen, MOST_UNSEEN)
            tab.update(self.all)
        elif not tab.follows:
            if command in ("grab", "let_go"):
                tab.has_bob = command == "grab"
            self.commands.put([command, *values])


def without_folders(value: Any) -> Any:
    """Return a text with the names of its files alone, and all else as it is."""
    if isinstance(value, str):
        return FOLDERS.sub("", value)
    if isinstance(value, dict):
        return {name: without_folders(part) for name, part in value.items()}
    if isinstance(value, list) and value and isinstance(value[0], str):
        return [without_folders(part) for part in value]
    return value
