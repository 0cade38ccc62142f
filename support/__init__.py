"""The functions that the handout provides. The folders below are for files, time, options, page and terminal."""

import sys

# This comes first: an older Python cannot even compile the other modules.
if sys.version_info < (3, 10):  # noqa: UP036
    sys.exit(f"Newton's cradle needs Python 3.10 or later; {sys.executable} is {sys.version.split()[0]}.")
