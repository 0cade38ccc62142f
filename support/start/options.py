"""The options of the programs, and their command lines.

A wrong option ends the program with status 2 and one line.
"""

import argparse
import os
from collections.abc import Callable
from math import inf, sqrt
from pathlib import Path
from typing import NoReturn

from support import constants
from support.columns import to_number
from support.constants import DT, NC_FP, PHI_INIT, THETA_INIT
from support.files.valid_cradle import CradleCsv, is_cradle, MOST_PENDULA
from support.found import found
from support.pendulum import angle_to_outwards, outwards_to_angle
from support.start.output import refuse

# VPython's environment variables; --port and --no-browser override them.
PORT_VARIABLE = "VPYTHON_HTTP_PORT"
CLOSED_VARIABLE = "VPYTHON_NO_LAUNCH_BROWSER"

HTML_SECONDS = 10.0  # s
EVERY = 0.01  # s from row to row of a recording, or the nearest whole number of ticks
OF_THE_CSV = ("e", "mass", "angle", "phi", "lift")
# Options that bring their own cradles, and those that they exclude.
EXCLUDED = {"experiment": OF_THE_CSV, "html_all": (*OF_THE_CSV, "experiment")}


class OneLineParser(argparse.ArgumentParser):
    """A parser that prints an error in one line, without the usage."""

    def error(self, message: str) -> NoReturn:
        refuse(f"{self.prog}: error: {message} (--help shows all options)")


def number(least: float, most: float, unit: str = "", kind: type = float) -> Callable:
    """Return a type for argparse: a number from least to most, of this kind (float or int)."""

    def convert(text: str) -> float:
        value = to_number(text)
        if not least <= value <= most or value != kind(value):
            noun = "a whole number" if kind is int else "a number"
            allowed = f"{noun} from {least:g} to {most:g}"
            if unit:
                allowed += f" ({unit})"
            raise argparse.ArgumentTypeError(found(text, allowed))
        return kind(value)

    return convert


def file_to_write(text: str) -> str:
    """Return the name of a file, as a type for argparse; what is written must replace no cradle."""
    if is_cradle(text):
        allowed = "a new file, or one to replace that is no cradle"
        raise argparse.ArgumentTypeError(found(text, allowed))
    return text


def require_constants() -> None:
    """Exit with status 2 and one line if a constant is out of its range."""
    require_constant("R_PARAM", 0.05, 100, "m")
    require_constant("G", 0.1, 100, "m/s^2")
    require_constant("THETA_INIT", -3.1416, 0, "rad")
    require_constant("PHI_INIT", -3.1416, 3.1416, "rad")
    # s, in whole microseconds: with longer ticks, the energy grows quickly.
    longest = int(1e6 / 40 * sqrt(constants.R_PARAM / constants.G)) / 1e6
    for name in ("DT", "DOUBLE_DT"):
        require_constant(name, 1e-6, min(1e-3, longest), "s, with this R_PARAM and G")


def require_constant(name: str, least: float, most: float, unit: str) -> None:
    """Exit with status 2 and one line if this constant is no number from least to most."""
    value = getattr(constants, name)
    if not (isinstance(value, (int, float)) and least <= value <= most):
        allowed = f"a number from {least:g} to {most:g} ({unit})"
        refuse(f"support/constants.py, {name}: found {value!r}, allowed is {allowed}")


def cradle_options(description: str) -> OneLineParser:
    """Return a parser with the options of a cradle; each program adds its own options."""
    require_constants()
    parser = OneLineParser(description=description, allow_abbrev=False)
    add = parser.add_argument
    text = "file of the cradle (default: newton_cradle_pends.csv)"
    add("csv", metavar="CSV", nargs="?", default=NC_FP, help=text)
    add_kind = parser.add_mutually_exclusive_group().add_argument
    text = "e = 1 for all pendula: a hit keeps the kinetic energy"
    add_kind("--elastic", action="store_const", const=1.0, dest="e", help=text)
    text = "e = 0 for all pendula: bobs stay together after a hit"
    add_kind("--inelastic", action="store_const", const=0.0, dest="e", help=text)
    text = "one e, from 0 to 1, for all pendula (default: the CSV's)"
    add_kind("--e", type=number(0, 1), metavar="E", help=text)
    text = "one mass, in kg, for all pendula (default: the CSV's)"
    add("--mass", type=number(1e-3, 1e3, "kg"), metavar="KG", help=text)
    text = (
        "release angle of the lifted bobs, from 0 to 180 degrees "
        f"(default: {angle_to_outwards(THETA_INIT):g})"
    )
    add("--angle", type=number(0, 180, "degrees"), metavar="DEGREES", help=text)
    text = "number of lifted bobs, from the left (default: 1)"
    add("--lift", type=number(0, MOST_PENDULA, kind=int), metavar="K", help=text)
    text = "file of an experiment, to begin with it in place of the CSV"
    add("--experiment", type=Path, metavar="FILE", help=text)
    return parser


def parse(parser: OneLineParser) -> argparse.Namespace:
    """Return the options, with angles as the programs take them (rad)."""
    options = parser.parse_args()
    values = vars(options)
    for whole, names in EXCLUDED.items():
        for name in names:
            is_given = values.get(name) != parser.get_default(name)
            if is_given and values.get(whole) is not None:
                parser.error(f"argument {flag(whole)}: not allowed with argument {flag(name)}")
    for name in ("angle", "phi"):
        if values.get(name) is not None:
            values[name] = outwards_to_angle(values[name])
    return options


def flag(name: str) -> str:
    """Return an option as you type it; e has three."""
    if name == "e":
        return "--elastic, --inelastic or --e"
    return f"--{name.replace('_', '-')}"


def page_options(description: str) -> OneLineParser:
    """Return a parser with the options of a cradle and of its page."""
    parser = cradle_options(description + " When you save its CSV, the page shows the new cradle.")
    add = parser.add_argument
    text = (
        "CSV of a motion that pale bobs show with the cradle: "
        "columns t (s), theta_1 (rad), ..., as --record writes them"
    )
    add("--ghosts", metavar="FILE", help=text)
    text = "port of the page (default: any free one)"
    port = os.environ.get(PORT_VARIABLE) or "0"
    add("--port", type=number(0, 65535, kind=int), metavar="N", default=port, help=text)
    text = (
        "address at which the page is served; "
        "0.0.0.0 lets other machines open it, as in a container "
        "(default: 127.0.0.1, for this machine alone)"
    )
    add("--host", metavar="ADDRESS", default="127.0.0.1", help=text)
    text = "open no browser, only print the address of the page"
    opens = os.environ.get(CLOSED_VARIABLE, "") in ("", "0")
    add("--no-browser", action="store_false", dest="browser", default=opens, help=text)
    text = "write a film to FILE, one HTML page that any browser plays, and open no page"
    add_html = parser.add_mutually_exclusive_group().add_argument
    add_html("--html", type=file_to_write, metavar="FILE", help=text)
    text = "write a film of each experiment to FOLDER, with index.html, for a course page"
    add_html("--html-all", metavar="FOLDER", help=text)
    text = f"with --html or --html-all: the seconds of a film (default: {HTML_SECONDS:g})"
    add("--seconds", type=number(DT, 600, "s"), metavar="S", help=text)
    return parser


def parse_page(parser: OneLineParser) -> argparse.Namespace:
    options = parse(parser)
    if options.seconds is not None and options.html is None and options.html_all is None:
        parser.error("argument --seconds: needs --html or --html-all")
    options.seconds = options.seconds or HTML_SECONDS
    return options


def read_page_options() -> argparse.Namespace:
    """Return the options of the page, from the command line.

    They are csv, e, mass, angle (rad), lift, port, host, browser, seconds, and
    the paths experiment, ghosts, html and html_all. None for e or mass keeps the values of the CSV.
    None for angle or lift keeps those of the program. None is no such file.
    """
    parser = page_options("Newton's cradle in the browser, to play with.")
    return parse_page(parser)


def read_double_page_options() -> argparse.Namespace:
    """Return the options of the double cradle's page.

    They are those of read_page_options, and phi (rad, or None like angle).
    """
    parser = page_options("The double Newton's cradle in the browser, to play with.")
    text = (
        "angle of the lifted lower cords from the upper ones, outwards, from -180 to 180 degrees "
        f"(default: {angle_to_outwards(PHI_INIT):g})"
    )
    parser.add_argument("--phi", type=number(-180, 180, "degrees"), metavar="DEGREES", help=text)
    return parse_page(parser)


def read_text_options() -> argparse.Namespace:
    """Return the options of the cradle in the terminal.

    They are those of the cradle, seconds (inf if missing), record (a path, - for the output, or
    None) and every (s). experiment is a Path, or None.
    """
    parser = cradle_options(
        "Newton's cradle in the terminal, a line each half second; or, with --record, its data."
    )
    add = parser.add_argument
    text = "end after S seconds (default: until Ctrl+C)"
    add("--seconds", type=number(DT, 1e6, "s"), metavar="S", default=inf, help=text)
    text = "write the data of --seconds S to FILE, a CSV (- prints it), as fast as the machine can"
    add("--record", type=file_to_write, metavar="FILE", help=text)
    text = f"with --record: a row for every T seconds, in whole ticks (default: {EVERY:g})"
    add("--every", type=number(DT, 1e6, "s"), metavar="T", help=text)
    options = parse(parser)
    if options.record is not None and options.seconds == inf:
        parser.error("argument --record: needs --seconds, to say how long")
    if options.every is not None and options.record is None:
        parser.error("argument --every: needs --record")
    options.every = options.every or EVERY
    return options


def require_lifted(lift: int | None, csv: CradleCsv) -> None:
    """Raise a ValueError with a one-line message if the CSV has fewer than lift pendula."""
    count = len(csv.pendula)
    if lift is not None and lift > count:
        raise ValueError(
            f"--lift: found '{lift}', allowed is at most {count}, "
            f"the number of pendula in {csv.filepath}"
        )
