"""The names of commands and values, which the page and the program share: each is declared here.

The names of controls stand in declarations.py. mypy finds a name that a Python file spells
in another way, the type checker of JavaScript one in a script (names.js), and test_names.py one in
page.html.
"""

import json
from typing import Any, TypedDict

from support.page.controls import Command


class Commands(TypedDict):
    """What a tab can ask for."""

    set: Command  # a control to a value
    pause: Command
    step: Command
    restart: Command
    next: Command
    previous: Command
    repeat: Command
    answer: Command  # to the question of an experiment
    check: Command  # your value of a hidden mass or e
    edit: Command
    save_csv: Command
    grab: Command
    drag: Command
    let_go: Command
    load_ghosts: Command
    remove_ghosts: Command


class State(TypedDict, total=False):
    """What a tab shows besides VPython's objects; a message has those values that have changed."""

    controls: dict[str, dict[str, Any]]  # their descriptions, with their values
    # The words of the page
    title: str
    remark: str
    error: str  # the mistake in your CSV
    endless: str  # the line where the program stays, or waits
    stopped: str  # the mistake that has ended the last run
    over: str  # why it is over without a mistake
    saved: str  # why what you have saved does not run
    ended: bool  # whether the program has ended
    word: str  # about your last command
    # The motion
    paused: bool
    running: bool
    view: dict[str, Any]  # what the camera shows
    sound: dict[str, float]  # the last hit to hear, the fastest one of its picture
    motion: dict[str, str]  # the readout
    summary: str  # where the farthest bobs are, in words
    bars: dict[str, Any] | None
    hits: list[dict[str, Any]]  # the slow hits of this series
    curves: dict[str, Any]  # of the graph
    # The experiments
    pictures: dict[str, list]
    mistakes: list[str]
    changed: bool
    question: dict[str, Any] | None
    sheets: list[tuple]  # of all experiments with a question: the name, the question, the answers
    unknown: dict[str, str] | None  # the hidden value: its question, name and unit
    checked: str  # about your value of it
    # The ghosts of a file
    ghosts: str
    mistake_in_ghosts: str
    # The table of the pendula
    # For each column its key, the limits of what you can type or None, and the number of rows
    columns: list[tuple]
    cells: list[list[str]]  # the texts of each column
    saved_csv: dict[str, float | str]  # the answer to the last save_csv


class Texts(TypedDict, total=False):
    """Texts that the page has when it is served, so that a tab shows them without the program."""

    command: str  # that starts this program again
    csv: str  # the name of your file
    share: str  # the key of tabs that follow


COMMANDS = [*Commands.__annotations__]
VALUES = [*State.__annotations__]


def names_as_module() -> str:
    """Return the names as names.js, a module for the type checker of JavaScript."""
    return (
        f"export const COMMANDS = /** @type {{const}} */ ({json.dumps(COMMANDS)});\n"
        f"export const VALUES = /** @type {{const}} */ ({json.dumps(VALUES)});\n"
    )
