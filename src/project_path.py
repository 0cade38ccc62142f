"""Put the project's folder on Python's path. A program that you start by its file name imports this first."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.realpath(__file__))))

import support  # noqa: E402, F401  it refuses a file that hides a module, before anything else is imported
