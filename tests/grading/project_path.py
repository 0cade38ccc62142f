"""Import this first in a file that is started by its name, from any folder: the project's modules are then found."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]  # the project's folder

sys.path.insert(0, str(ROOT))
