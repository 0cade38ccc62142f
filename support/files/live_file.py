"""A file that is watched while someone edits it."""

import time

from support.files.cradle_csv import Snapshot

POLL = 0.2  # s between two looks at the file


class LiveFile:
    """Notices when a file has become another, whichever way an editor saves it: in place, or by replacing it."""

    def __init__(self, filepath, clock=time.monotonic):
        """Watch this file from now on. clock() may be replaced by a test's."""
        self.filepath, self.clock = filepath, clock
        self.current = self.candidate = Snapshot(filepath)
        self.next_look = clock() + POLL

    def changed(self) -> bool:
        """Return whether the file has become another since this last returned True; it is then in current.

        Something new must stand at two looks in a row before it counts: an editor may be in the middle of saving.
        """
        if self.clock() < self.next_look:
            return False
        self.next_look = self.clock() + POLL
        previous, self.candidate = self.candidate, Snapshot(self.filepath)
        if self.candidate != previous or self.candidate == self.current:
            return False
        self.current = self.candidate
        return True
