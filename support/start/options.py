"""The options of the programs, and their command lines.

A wrong option ends the program with status 2 and one line.
"""

import argparse
import os
import shlex
import subprocess
import sys
from math import inf, sqrt
from pathlib import Path

from support import constants
from support.constants import DT, NC_FP, PHI_INIT, THETA_INIT
from support.files.cradle_csv import read_cells, RULES, to_number
from support.files.data_file import EVERY
from support.pendulum import angle_to_outwards, outwards_to_angle
from support.start.output import refuse

ROOT = Path(__file__).resolve().parents[2]

# VPython's environment variables; --port and --no-browser override them.
PORT_VARIABLE, CLOSED_VARIABLE = "VPYTHON_HTTP_PORT", "VPYTHON_NO_LAUNCH_BROWSER"

# The least and the greatest value of a constant, and its unit.
CONSTANTS: dict[str, tuple[float, float, str]] = {
    "R_PARAM": (0.05, 100, "m"),
    "G": (0.1, 100, "m/s^2"),
}
CONSTANTS |= dict.fromkeys(("DT", "DOUBLE_DT"), (1e-6, 1e-3, "s"))
CONSTANTS |= {"THETA_INIT": (-3.1416, 0, "rad"), "PHI_INIT": (-3.1416, 3.1416, "rad")}


class OneLineParser(argparse.ArgumentParser):
    """A parser that prints an error in one line, without the usage."""

    def parse_known_args(self, args=None, namespace=None):
        for word in sys.argv[1:] if args is None else args:
            # Up to Python 3.12, its value would be an empty list
            if word.startswith("-") and word.endswith("=--"):
                self.error(f"found {word!r}, allowed is no -- after =")
        return super().parse_known_args(args, namespace)

    def error(self, message):
        refuse(f"{self.prog}: error: {message} (--help shows all options)")


def allowed(kind, is_allowed, words):
    """Return a type for argparse: it converts a text with kind if is_allowed(text); words name the
    allowed values.
    """

    def convert(text):
        if not is_allowed(text):
            raise argparse.ArgumentTypeError(f"found {text!r}, allowed is {words}")
        return kind(text)

    return convert


def angle_from(least):
    """Return a type for argparse: the angle (rad) of a cord with a lift outwards from least to 180
    (degrees).
    """
    words = f"a number from {least} to 180 (degrees)"
    return allowed(
        lambda text: outwards_to_angle(float(text)),
        lambda text: least <= to_number(text) <= 180,
        words,
    )


def require_constants() -> None:
    """Exit with status 2 and one line if a constant is out of its range."""
    for name, (least, most, unit) in CONSTANTS.items():
        found = getattr(constants, name)
        if not (
            isinstance(found, (int, float)) and type(found) is not bool and least <= found <= most
        ):
            words = f"allowed is a number from {least:g} to {most:g} ({unit})"
            refuse(f"support/constants.py, {name}: found {found!r}, {words}")
    # s, in whole microseconds: with longer ticks, the energy grows quickly.
    longest = int(1e6 / 40 * sqrt(constants.R_PARAM / constants.G)) / 1e6
    for name in ("DT", "DOUBLE_DT"):
        found = getattr(constants, name)
        if found > longest:
            words = f"allowed with this R_PARAM and G is a number up to {longest:g} (s)"
            refuse(f"support/constants.py, {name}: found {found!r}, {words}")


def to_port(text) -> int:
    """Return the number of a port, for argparse; the name of VPython's variable stands for its
    value, or 0.
    """
    text, place = (
        (os.environ.get(text) or "0", f" in {text}") if text == PORT_VARIABLE else (text, "")
    )
    if not (text.isascii() and text.isdecimal() and len(text) < 6 and int(text) <= 65535):
        raise argparse.ArgumentTypeError(
            f"found {text!r}{place}, allowed is a whole number from 0 to 65535"
        )
    return int(text)


def cradle_options(description) -> OneLineParser:
    """Return a parser with the options of a cradle; each program adds its own options."""
    require_constants()
    e, mass = (allowed(float, *RULES[column]) for column in ("e", "mass"))
    lift = allowed(int, str.isdecimal, "a whole number, 0 or more")

    parser = OneLineParser(description=description, allow_abbrev=False)
    add = parser.add_argument
    add(
        "csv",
        metavar="CSV",
        nargs="?",
        default=NC_FP,
        help="file of the cradle (default: newton_cradle_pends.csv)",
    )
    kinds = parser.add_mutually_exclusive_group()
    kinds.add_argument(
        "--elastic",
        action="store_true",
        help="e = 1 for all pendula: a hit keeps the kinetic energy",
    )
    kinds.add_argument(
        "--inelastic",
        action="store_true",
        help="e = 0 for all pendula: bobs stay together after a hit",
    )
    kinds.add_argument(
        "--e", type=e, metavar="E", help="one e, from 0 to 1, for all pendula (default: the CSV's)"
    )
    add(
        "--mass",
        type=mass,
        metavar="KG",
        help="one mass, in kg, for all pendula (default: the CSV's)",
    )
    text = f"release angle of the lifted bobs, from 0 to 180 degrees (default: {angle_to_outwards(THETA_INIT):g})"
    add("--angle", type=angle_from(0), metavar="DEGREES", help=text)
    add("--lift", type=lift, metavar="K", help="number of lifted bobs, from the left (default: 1)")
    return parser


def page_options(description) -> OneLineParser:
    """Return a parser with the options of a cradle and of its page."""
    parser = cradle_options(description + " When you save its CSV, the page shows the new cradle.")
    add = parser.add_argument
    text = "port of the page (default: any free one)"
    add("--port", type=to_port, metavar="N", default=PORT_VARIABLE, help=text)
    text = "address at which the page is, for a container 0.0.0.0 (default: 127.0.0.1, for this machine alone)"
    add("--host", metavar="ADDRESS", default="127.0.0.1", help=text)
    text = "open no browser, only print the address of the page"
    opens = os.environ.get(CLOSED_VARIABLE, "") in ("", "0")
    add("--no-browser", action="store_false", dest="browser", default=opens, help=text)
    return parser


def read_page_options(arguments=None) -> argparse.Namespace:
    """Return the options of the page, from the command line or from arguments.

    They are csv, elastic, inelastic, e, mass, angle (rad), lift, port, host and browser. None for e
    or mass keeps the values of the CSV. None for angle or lift keeps the values with which main
    makes the cradle.
    """
    return page_options("Newton's cradle in the browser, to play with.").parse_args(arguments)


def read_double_page_options(arguments=None) -> argparse.Namespace:
    """Return the options of the double cradle's page: those of read_page_options, and phi (rad, or
    None like angle).
    """
    parser = page_options("The double Newton's cradle in the browser, to play with.")
    text = "angle of the lifted lower cords from the upper ones, outwards, from -180 to 180 degrees"
    text = f"{text} (default: {angle_to_outwards(PHI_INIT):g})"
    parser.add_argument("--phi", type=angle_from(-180), metavar="DEGREES", help=text)
    return parser.parse_args(arguments)


def command_line(program, folder, arguments=()) -> str:
    """Return the command that starts a program (its path in the project) from this folder, with the
    running Python.
    """
    paths = Path(sys.executable), ROOT / program
    words = [
        str(path.relative_to(folder) if path.is_relative_to(folder) else path) for path in paths
    ]
    join = subprocess.list2cmdline if sys.platform == "win32" else shlex.join
    return join([*words, *arguments])


def read_text_options(arguments=None) -> argparse.Namespace:
    """Return the options of the cradle in the terminal: those of the cradle, seconds (inf if
    missing), record (a path, - for the output, or None) and every (s).
    """
    parser = cradle_options(
        "Newton's cradle as moving text, in real time; or, with --record, its data in a file."
    )
    seconds = allowed(
        float, lambda text: 0 < to_number(text) <= 1e6, "a number above 0 and up to 1e6 (s)"
    )
    every = allowed(float, is_in_ticks, f"a multiple of {DT} (s), one tick, up to 1e6")
    add = parser.add_argument
    add(
        "--seconds",
        type=seconds,
        metavar="S",
        default=inf,
        help="end after S seconds (default: until Ctrl+C)",
    )
    text = "write the data of S seconds (--seconds S) to FILE, a CSV (- is the output), as fast as the machine can"
    add("--record", type=allowed(str, bool, "the name of a file"), metavar="FILE", help=text)
    text = f"with --record: a row for every S seconds (default: {round(EVERY / DT) * DT:g})"
    add("--every", type=every, metavar="S", help=text)
    options = parser.parse_args(arguments)
    if options.record is not None and options.seconds == inf:
        parser.error("argument --record: needs --seconds, to say how long")
    if options.every is not None and options.record is None:
        parser.error("argument --every: needs --record")
    options.every = options.every or EVERY
    return options


def is_in_ticks(text) -> bool:
    """Return whether the text is a time (s) of a whole number of ticks, at least one."""
    ticks = to_number(text) / DT
    return 0.5 < ticks <= 1e6 / DT and abs(ticks - round(ticks)) < 1e-6


def require_lifted(lift, csv) -> None:
    """Raise a ValueError with a one-line message if this CSV has fewer than lift pendula; lift can
    be None.
    """
    count = len(read_cells(csv)) - 1  # without the header
    if lift is not None and lift > count:
        raise ValueError(
            f"--lift: found '{lift}', allowed is at most {count}, the number of pendula in {csv}"
        )
