"""Shapes that are used again: VPython keeps every shape for ever, so a new cradle is built of what the old one was."""

from collections import defaultdict

from vpython import color

# How VPython makes a shape unless it is told otherwise. A used shape first becomes plain again.
PLAIN = {"color": color.white, "texture": None, "shininess": 0.6, "visible": True}

discarded: defaultdict[type, list] = defaultdict(list)  # kind -> shapes


def make_shape(kind, **attributes):
    """Return a box, sphere or cylinder (kind) with these attributes: a discarded one if there is one, or a new one."""
    if not discarded[kind]:
        return kind(**attributes)
    shape = discarded[kind].pop()
    for name, value in {**PLAIN, **attributes}.items():
        setattr(shape, name, value)
    return shape


def discard(shapes) -> None:
    """Hide these shapes, and let make_shape use them again."""
    for shape in shapes:
        shape.visible = False
        discarded[type(shape)].append(shape)
