"""Import this first in a program that is started by its name, from any folder: src and support are then found."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
