"""Import this first in a program: Python then finds the project's modules from any folder."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]  # the project's folder

sys.path.insert(0, str(ROOT))

import support  # noqa: E402, F401  it refuses a file that hides a module
