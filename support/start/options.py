"""The options of the programs, and their command lines.

A wrong option ends the program with status 2 and one line.
"""

import argparse
import os
from collections.abc import Callable, Sequence
from math import inf, isfinite, sqrt
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from support import constants
from support.columns import CHECKED, to_number
from support.constants import DT, NC_FP, PHI_INIT, THETA_INIT
from support.files.data_file import EVERY
from support.files.valid_cradle import CradleCsv
from support.found import found
from support.pendulum import angle_to_outwards, outwards_to_angle
from support.start.output import refuse

# VPython's environment variables; --port and --no-browser override them.
PORT_VARIABLE = "VPYTHON_HTTP_PORT"
CLOSED_VARIABLE = "VPYTHON_NO_LAUNCH_BROWSER"


class Range(NamedTuple):
    """The allowed values of a constant."""

    least: float
    most: float
    unit: str


# An experiment has its own.
OF_THE_CSV = "elastic", "inelastic", "e", "mass", "angle", "phi", "lift"

CONSTANTS = {
    "R_PARAM": Range(0.05, 100, "m"),
    "G": Range(0.1, 100, "m/s^2"),
    "DT": Range(1e-6, 1e-3, "s"),
    "DOUBLE_DT": Range(1e-6, 1e-3, "s"),
    "THETA_INIT": Range(-3.1416, 0, "rad"),
    "PHI_INIT": Range(-3.1416, 3.1416, "rad"),
}


class OneLineParser(argparse.ArgumentParser):
    """A parser that prints an error in one line, without the usage."""

    def error(self, message: str) -> NoReturn:
        refuse(f"{self.prog}: error: {message} (--help shows all options)")


def type_of(
    convert: Callable[[str], Any], is_allowed: Callable[[str], bool], allowed: str
) -> Callable[[str], Any]:
    """Return a type for argparse: it converts a text if is_allowed(text).

    allowed names the allowed values.
    """

    def convert_allowed(text: str) -> Any:
        if not is_allowed(text):
            raise argparse.ArgumentTypeError(found(text, allowed))
        return convert(text)

    return convert_allowed


def number_of(column: str) -> Callable[[str], Any]:
    """Return a type for argparse: a number that this column of the CSV may have."""
    return type_of(float, CHECKED[column].allows, CHECKED[column].allowed())


def angle_from(least: float) -> Callable[[str], Any]:
    """Return a type for argparse: the angle (rad) of a cord.

    The option has its angle outwards, from least to 180 (degrees).
    """
    return type_of(
        lambda text: outwards_to_angle(float(text)),
        lambda text: least <= to_number(text) <= 180,
        f"a number from {least} to 180 (degrees)",
    )


def require_constants() -> None:
    """Exit with status 2 and one line if a constant is out of its range."""
    for name, (least, most, unit) in CONSTANTS.items():
        found = getattr(constants, name)
        is_number = isinstance(found, (int, float)) and type(found) is not bool
        if not (is_number and least <= found <= most):
            refuse_constant(name, f"is a number from {least:g} to {most:g} ({unit})")
    # s, in whole microseconds: with longer ticks, the energy grows quickly.
    longest = int(1e6 / 40 * sqrt(constants.R_PARAM / constants.G)) / 1e6
    for name in ("DT", "DOUBLE_DT"):
        if getattr(constants, name) > longest:
            refuse_constant(name, f"with this R_PARAM and G is a number up to {longest:g} (s)")


def refuse_constant(name: str, allowed: str) -> NoReturn:
    """Exit with status 2 and one line that names a constant, its value and the allowed values."""
    found = getattr(constants, name)
    refuse(f"support/constants.py, {name}: found {found!r}, allowed {allowed}")


def cradle_options(description: str) -> OneLineParser:
    """Return a parser with the options of a cradle; each program adds its own options."""
    require_constants()
    parser = OneLineParser(description=description, allow_abbrev=False)
    add = parser.add_argument
    text = "file of the cradle (default: newton_cradle_pends.csv)"
    add("csv", metavar="CSV", nargs="?", default=NC_FP, help=text)
    add_kind = parser.add_mutually_exclusive_group().add_argument
    text = "e = 1 for all pendula: a hit keeps the kinetic energy"
    add_kind("--elastic", action="store_true", help=text)
    text = "e = 0 for all pendula: bobs stay together after a hit"
    add_kind("--inelastic", action="store_true", help=text)
    text = "one e, from 0 to 1, for all pendula (default: the CSV's)"
    add_kind("--e", type=number_of("e"), metavar="E", help=text)
    text = "one mass, in kg, for all pendula (default: the CSV's)"
    add("--mass", type=number_of("mass"), metavar="KG", help=text)
    text = (
        "release angle of the lifted bobs, from 0 to 180 degrees "
        f"(default: {angle_to_outwards(THETA_INIT):g})"
    )
    add("--angle", type=angle_from(0), metavar="DEGREES", help=text)
    count = type_of(int, is_whole, "a whole number, 0 or more")
    text = "number of lifted bobs, from the left (default: 1)"
    add("--lift", type=count, metavar="K", help=text)
    text = "file of an experiment, to begin with it in place of the CSV"
    add("--experiment", type=Path, metavar="FILE", help=text)
    return parser


def seconds_up_to(most: str) -> Callable[[str], Any]:
    """Return a type for argparse: a time (s) above 0 and up to the number in this text."""
    return type_of(
        float,
        lambda text: 0 < to_number(text) <= float(most),
        f"a number above 0 and up to {most} (s)",
    )


HTML_SECONDS = 10.0  # s
FILE = type_of(str, bool, "the name of a file")
PORT = "a whole number from 0 to 65535"


def is_whole(text: str) -> bool:
    """Return whether the text is a whole number, 0 or more."""
    return text.isdecimal() and isfinite(to_number(text))


def is_port(text: str) -> bool:
    """Return whether the text is the number of a port."""
    return is_whole(text) and int(text) <= 65535


def parse(parser: OneLineParser, arguments: Sequence[str] | None) -> argparse.Namespace:
    """Return the options.

    --experiment and --html-all bring their own cradles: options that change the CSV's are refused.
    """
    options = parser.parse_args(arguments)
    for whole in ("experiment", "html_all"):
        for name in OF_THE_CSV:
            is_given = getattr(options, name, None) != parser.get_default(name)
            if is_given and getattr(options, whole, None) is not None:
                option = whole.replace("_", "-")
                parser.error(f"argument --{option}: not allowed with argument --{name}")
    return options


def page_options(description: str) -> OneLineParser:
    """Return a parser with the options of a cradle and of its page."""
    parser = cradle_options(description + " When you save its CSV, the page shows the new cradle.")
    add = parser.add_argument
    text = (
        "CSV of a motion that pale bobs show with the cradle:  "
        "columns t (s), theta_1 (rad), ..., as --record writes them"
    )
    add("--ghosts", type=FILE, metavar="FILE", help=text)
    text = "port of the page (default: any free one)"
    add("--port", type=type_of(int, is_port, PORT), metavar="N", help=text)
    text = (
        "address at which the page is served; "
        "0.0.0.0 lets other machines open it, as in a container "
        "(default: 127.0.0.1, for this machine alone)"
    )
    add("--host", metavar="ADDRESS", default="127.0.0.1", help=text)
    text = "open no browser, only print the address of the page"
    opens = os.environ.get(CLOSED_VARIABLE, "") in ("", "0")
    add("--no-browser", action="store_false", dest="browser", default=opens, help=text)
    text = "write a run to FILE, one HTML page that any browser plays, and open no page"
    add_html = parser.add_mutually_exclusive_group().add_argument
    add_html("--html", type=FILE, metavar="FILE", help=text)
    text = "write a run of each experiment to FOLDER, with index.html, for a course page"
    add_html("--html-all", type=FILE, metavar="FOLDER", help=text)
    text = f"with --html or --html-all: the seconds of a run (default: {HTML_SECONDS:g})"
    add("--seconds", type=seconds_up_to("600"), metavar="S", help=text)
    return parser


def parse_page(parser: OneLineParser, arguments: Sequence[str] | None) -> argparse.Namespace:
    """Return the options of a page; without --port, VPython's variable names the port."""
    options = parse(parser, arguments)
    if options.port is None:
        text = os.environ.get(PORT_VARIABLE) or "0"
        if not is_port(text):
            parser.error(f"argument --port: found {text!r} in {PORT_VARIABLE}, allowed is {PORT}")
        options.port = int(text)
    if options.html_all is not None and options.experiment is not None:
        parser.error("argument --html-all: not allowed with argument --experiment")
    if options.seconds is not None and options.html is None and options.html_all is None:
        parser.error("argument --seconds: needs --html or --html-all")
    options.seconds = options.seconds or HTML_SECONDS
    return options


def read_page_options(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """Return the options of the page, from the command line or from arguments.

    They are csv, elastic, inelastic, e, mass, angle (rad), lift, port, host, browser, seconds, and
    the paths experiment, ghosts, html and html_all. None for e or mass keeps the values of the CSV.
    None for angle or lift keeps the values with which main makes the cradle. None is no such file.
    """
    parser = page_options("Newton's cradle in the browser, to play with.")
    return parse_page(parser, arguments)


def read_double_page_options(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """Return the options of the double cradle's page.

    They are those of read_page_options, and phi (rad, or None like angle).
    """
    parser = page_options("The double Newton's cradle in the browser, to play with.")
    text = (
        "angle of the lifted lower cords from the upper ones, outwards, from -180 to 180 degrees "
        f"(default: {angle_to_outwards(PHI_INIT):g})"
    )
    parser.add_argument("--phi", type=angle_from(-180), metavar="DEGREES", help=text)
    return parse_page(parser, arguments)


def read_text_options(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """Return the options of the cradle in the terminal.

    They are those of the cradle, seconds (inf if missing), record (a path, - for the output, or
    None) and every (s). experiment is a Path, or None.
    """
    parser = cradle_options(
        "Newton's cradle in the terminal, a line each half second; or, with --record, its data."
    )
    add = parser.add_argument
    text = "end after S seconds (default: until Ctrl+C)"
    add("--seconds", type=seconds_up_to("1e6"), metavar="S", default=inf, help=text)
    text = "write the data of --seconds S to FILE, a CSV (- prints it), as fast as the machine can"
    add("--record", type=FILE, metavar="FILE", help=text)
    every = type_of(float, is_in_ticks, f"a multiple of {DT} (s), one tick, up to 1e6")
    text = f"with --record: a row for every T seconds (default: {round(EVERY / DT) * DT:g})"
    add("--every", type=every, metavar="T", help=text)
    options = parse(parser, arguments)
    if options.record is not None and options.seconds == inf:
        parser.error("argument --record: needs --seconds, to say how long")
    if options.every is not None and options.record is None:
        parser.error("argument --every: needs --record")
    options.every = options.every or EVERY
    return options


def is_in_ticks(text: str) -> bool:
    """Return whether the text is a time (s) of a whole number of ticks, at least one."""
    ticks = to_number(text) / DT
    return 0.5 < ticks <= 1e6 / DT and abs(ticks - round(ticks)) < 1e-6


def require_lifted(lift: int | None, csv: CradleCsv) -> None:
    """Raise a ValueError with a one-line message if the CSV has fewer than lift pendula."""
    count = len(csv.pendula)
    if lift is not None and lift > count:
        raise ValueError(
            f"--lift: found '{lift}', allowed is at most {count}, "
            f"the number of pendula in {csv.filepath}"
        )
