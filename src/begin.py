"""The first import of a program in this folder: it finds the project, and prepares the start."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
from support.start import program

program.begin()
