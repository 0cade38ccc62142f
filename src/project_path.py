"""Put the project's folder on Python's path. A program that you start by its file name imports this first."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
