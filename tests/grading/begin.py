"""The grader and the programs of tests/ import this first.

It finds the project, and lets a stand-in be VPython.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]  # the project's folder

if not (ROOT / "support" / "__init__.py").is_file():
    print("The folder support is not next to src and tests. Put it back.", file=sys.stderr)
    sys.exit(2)
sys.path.insert(0, str(ROOT))

from support.start.unfit import refuse_unfit  # noqa: E402

refuse_unfit()

import support.headless_vpython  # noqa: E402, F401
from support.start.commands import checks_command  # noqa: E402


def refuse_to_run() -> None:
    """Say how checks are run, and exit with status 1."""
    sys.exit(f"These are checks. Type {checks_command()} to run them.")
