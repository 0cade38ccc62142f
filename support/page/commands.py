"""What a person can ask of the viewer, by widget, key or mouse.

VPython calls what is bound to a widget, a key or the mouse in a thread of its own, in the middle of a tick. So
nothing is done there but to put a pair (command, value) into a queue; the viewer takes it out between two frames.
"""

from enum import auto, Enum


class Command(Enum):
    """All commands. The comment says what their value is, for those that have one."""

    PAUSE = auto()  # or run on
    STEP = auto()  # one frame, while paused
    RESTART = auto()
    SPEED = auto()  # times real time
    ANGLE = auto()  # (which of the cradle's release angles, rad); the cradle restarts from it
    LIFT = auto()  # how many bobs; the cradle restarts
    COLLISIONS = auto()  # the name of one of the cradle's kinds of collisions
    SEPARATING = auto()  # whether separating bobs collide too
    GRAPH = auto()  # whether the graph is shown
    SAVE = auto()  # the data since the last restart, to a file
    GRAB = auto()  # the bob under the mouse; the ray to it, as (a point on it, its direction)
    DRAG = auto()  # the bob that is held, to the ray
    LET_GO = auto()  # of the bob that is held
    RESIZE = auto()  # the view, to the canvas


# What the keys do, by VPython's names for them.
KEYS = {
    " ": (Command.PAUSE, None),
    "right": (Command.STEP, None),
    "r": (Command.RESTART, None),
    **{str(count): (Command.LIFT, count) for count in range(1, 10)},
}
