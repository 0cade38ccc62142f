"""Reuse shapes: VPython keeps every shape for ever, so a new cradle takes the shapes of the old one."""

from collections import defaultdict

from vpython import color

# VPython's default values. make_shape gives them to a used shape first.
PLAIN = {"color": color.white, "texture": None, "shininess": 0.6, "visible": True}

discarded: defaultdict[type, list] = defaultdict(list)  # kind -> shapes


def make_shape(kind, **attributes):
    """Return a box, sphere or cylinder (kind) with these attributes: a discarded one, or a new one if there is none."""
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
