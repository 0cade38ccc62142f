"""What the handout calls provided. In the rooms below: what the programs need of files, time, page and terminal."""

import sys

# Before anything else is read, which an older Python would not understand.
if sys.version_info < (3, 10):  # noqa: UP036
    sys.exit(f"Newton's cradle needs Python 3.10 or later; {sys.executable} is {sys.version.split()[0]}.")
