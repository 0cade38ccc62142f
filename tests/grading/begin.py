"""The grader and the programs of tests/ import this first.

It finds the project, and lets a stand-in be VPython.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from support.start.program import require_python  # noqa: E402

require_python()

import support.headless_vpython  # noqa: E402, F401
from support.root import ROOT  # noqa: E402, F401
