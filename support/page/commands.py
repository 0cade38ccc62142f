"""The commands that you give to the viewer with a widget, a key or the mouse.

VPython calls the function of a widget, a key or the mouse in a thread of its own, in the middle of a tick. This
function only puts a pair (command, value) into a queue. The viewer takes it out between two frames.
"""

from enum import auto, Enum


class Command(Enum):
    """All commands. The comments explain them, and their values."""

    PAUSE = auto()  # or run on
    STEP = auto()  # one frame, while paused
    RESTART = auto()
    SPEED = auto()  # times real time
    ANGLE = auto()  # (index of the release angle, angle in rad); the cradle restarts
    LIFT = auto()  # number of bobs; the cradle restarts
    COLLISIONS = auto()  # a key of the cradle's collisions
    SEPARATING = auto()  # whether separating bobs collide too
    SOUND = auto()  # whether hits sound
    GRAPH = auto()  # one of the graph's choices
    EXPERIMENT = auto()  # the index of an experiment, or None for your CSV; the cradle restarts
    ASK_FIRST = auto()  # whether an experiment asks its question first; an experiment restarts
    ANSWER = auto()  # (key of the experiment that asks, index of the answer, or None); the cradle runs
    TABLE = auto()  # whether the table of the pendula is open
    EDIT = auto()  # a cell of the table: (index of the row, column, text); the cradle restarts
    ADD = auto()  # a row to the table; the cradle restarts
    DELETE = auto()  # this row (its index) of the table; the cradle restarts
    WRITE = auto()  # what the table shows to your CSV
    TICK = auto()  # one tick, while paused
    SAVE = auto()  # the data since the last restart, to a file
    SAVED = auto()  # no widget gives this: SAVE has ended, in its own thread
    GRAB = auto()  # the bob under the mouse; the value is the mouse's ray (a point on it, its direction)
    DRAG = auto()  # the held bob to the ray, as for GRAB
    LET_GO = auto()  # the held bob
    RESIZE = auto()  # fit the view to the canvas
    VIEW = auto()  # the camera back to where it was at the start
    SHOW_AGAIN = auto()  # send a page that was loaded again what it needs; the cradle restarts


# The commands of the keys; the names of the keys are VPython's.
KEYS = {
    " ": (Command.PAUSE, None),
    "right": (Command.STEP, None),
    "r": (Command.RESTART, None),
    "v": (Command.VIEW, None),
    **{str(count): (Command.LIFT, count) for count in range(1, 10)},
}
