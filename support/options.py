"""The options of the programs. A bad one ends the program with one line that says what is allowed, and status 2."""

import argparse
import os
import sys
from math import degrees

from support.constants import NC_FP, THETA_INIT
from support.cradle_csv import read_cells, RULES, to_number

# What VPython takes the page's port from; --port comes before it.
PORT_VARIABLE = "VPYTHON_HTTP_PORT"


class OneLineParser(argparse.ArgumentParser):
    """A parser that complains in one line, without the usage before it."""

    def error(self, message):
        print(f"{self.prog}: error: {message} (--help shows all options)", file=sys.stderr)
        sys.exit(2)


def allowed(kind, is_allowed, words):
    """Return a type for argparse: the text of an argument as a kind (float, int), if is_allowed(text)."""

    def convert(text):
        if not is_allowed(text):
            raise argparse.ArgumentTypeError(f"found {text!r}, allowed is {words}")
        return kind(text)

    return convert


def read_options(description, arguments=None) -> argparse.Namespace:
    """Return the options on the command line (or in arguments): csv, elastic, inelastic, e, mass, angle (degrees),
    lift, port and browser; e and mass are None where the CSV's are to be kept.
    """
    e, mass = (allowed(float, *RULES[column]) for column in ("e", "mass"))
    angle = allowed(float, lambda text: 0 <= to_number(text) <= 180, "a number from 0 to 180 (degrees)")
    lift = allowed(int, str.isdecimal, "a whole number, 0 or more")
    port = allowed(int, lambda text: text.isdecimal() and int(text) <= 65534, "a whole number from 0 to 65534")

    parser = OneLineParser(description=description, allow_abbrev=False)
    add = parser.add_argument
    add("csv", metavar="CSV", nargs="?", default=NC_FP, help="file of the cradle (default: newton_cradle_pends.csv)")
    kinds = parser.add_mutually_exclusive_group()
    kinds.add_argument("--elastic", action="store_true", help="e = 1 for all pendula: a hit keeps the kinetic energy")
    kinds.add_argument("--inelastic", action="store_true", help="e = 0 for all pendula: bobs leave a hit together")
    kinds.add_argument("--e", type=e, metavar="E", help="one e, from 0 to 1, for all pendula (default: the CSV's)")
    add("--mass", type=mass, metavar="KG", help="one mass, above 0 kg, for all pendula (default: the CSV's)")
    text = "how far the first bobs are lifted, from 0 to 180 degrees (default: %(default)g)"
    add("--angle", type=angle, metavar="DEGREES", default=abs(degrees(THETA_INIT)), help=text)
    add("--lift", type=lift, metavar="K", default=1, help="how many bobs are lifted (default: %(default)d)")
    text = "port of the page on this machine; N + 1 is taken as well (default: any two that are free)"
    add("--port", type=port, metavar="N", default=os.environ.get(PORT_VARIABLE, "0"), help=text)
    text = "open no browser, only say where the page is"
    add("--no-browser", action="store_false", dest="browser", help=text)
    return parser.parse_args(arguments)


def check_lift(lift, csv) -> None:
    """Raise a ValueError of one line if the cradle of this CSV has fewer bobs than are to be lifted."""
    count = len(read_cells(csv)) - 1  # without the header
    if lift > count:
        raise ValueError(f"--lift: found '{lift}', allowed is at most {count}, the number of pendula in {csv}")
