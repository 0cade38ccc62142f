"""Watch a file while you edit it."""

import time

from support.files.cradle_csv import Snapshot

POLL = 0.2  # s between two looks at the file


class LiveFile:
    """Notices when a file has changed, in place or because an editor has replaced it."""

    def __init__(self, filepath, clock=time.monotonic):
        """Watch this file from now on. A test can replace clock()."""
        self.filepath, self.clock = filepath, clock
        self.current = self.candidate = Snapshot(filepath)
        self.next_look = clock() + POLL

    def changed(self) -> bool:
        """Return whether the file has changed since this last returned True; current then has the new content.

        A change counts when two looks in a row find the same new content: an editor may be in the middle of saving.
        """
        if self.clock() < self.next_look:
            return False
        self.next_look = self.clock() + POLL
        previous, self.candidate = self.candidate, Snapshot(self.filepath)
        if self.candidate != previous or self.candidate == self.current:
            return False
        self.current = self.candidate
        return True

    def look_now(self) -> None:
        """Take the present content of the file as current: a program that has just written it need not wait."""
        self.current = self.candidate = Snapshot(self.filepath)
