"""Cradles for the checks and the tests: CSV text, and pendula made by hand, without src/."""

from operator import itemgetter
from typing import Any

from pandas import DataFrame
from vpython import color, scene, vector

from grading.messages import Expected
from grading.subject import Each, Subject
from support.pendulum import discarded, make_pendulum

R = 0.4  # m; R_PARAM differs, so a check finds the constant in place of the parameter

# All pendula differ, no value is a default, and make_newton_cradle must change theta and omega.
MIXED = [
    {"mass": 1.5, "e": 0.9, "theta": 0.3, "omega": 2.0, "color": "red", "texture": "metal"},
    {"mass": 2.5, "e": 0.8, "theta": -0.2, "omega": -1.0, "color": "blue", "texture": "none"},
    {"mass": 0.5, "e": 0.7, "theta": 0.1, "omega": 0.5, "color": "yellow", "texture": "wood"},
]


def csv_of(rows: list[dict[str, Any]]) -> str:
    """Return rows as the text of a CSV, without a line break at the end."""
    return DataFrame(rows).to_csv(index=False, lineterminator="\n").rstrip()


MIXED_CSV = f"{csv_of(MIXED)}\n"


def see_each(pend_list: list[dict], *keys: str) -> dict[str, Any]:
    """Return options of expect to compare the values of these keys in each pendulum.

    The values are those after the call.
    """
    return {
        "see": lambda _: [*map(itemgetter(*keys), pend_list)],
        "what": Each(keys),
    }


def hang(
    theta: float = 0.0,
    omega: float = 0.0,
    mass: float = 1.0,
    e: float = 1.0,
    axle: tuple[float, float, float] = (0.0, 0.0, 0.0),
    r_param: float = R,
    radius: float | None = None,
) -> dict[str, Any]:
    """Return a pendulum at theta (rad) below axle (x, y, z in m).

    Without radius (m), the bob has the usual one.
    """
    objects = make_pendulum(vector(*axle), r_param, theta, color.white, None)
    objects[1].radius = radius or objects[1].radius
    return {
        "mass": mass,
        "e": e,
        "theta": theta,
        "omega": omega,
        "color": "white",
        "texture": "none",
        "objects": objects,
    }


def hang_row(count: int, **values: Any) -> list[dict]:
    """Return count pendula with axles R / 4 apart, and these values for hang."""
    return [hang(axle=(i * R / 4, 0, 0), **values) for i in range(count)]


def touching(*omegas: float, radius: float = R / 8) -> list[dict]:
    """Return pendula that hang straight down and touch, with these omegas (rad/s)."""
    pend_list = hang_row(len(omegas), radius=radius)
    for pend, omega in zip(pend_list, omegas, strict=True):
        pend["omega"] = omega
    return pend_list


def ends_like(cord: Any, first: vector, last: vector) -> tuple[vector, vector]:
    """Return the ends of a cord, in the order of the two that are expected.

    A student may draw it from either end.
    """
    start = vector(cord.pos)
    end = start + cord.axis
    is_turned = (start - last).mag < (start - first).mag
    return (end, start) if is_turned else (start, end)


def within(distance: float, value: float) -> Expected:
    """Return the expectation of a number near a value."""
    return Expected(
        f"within {distance:g} of {value:g}",
        lambda found: abs(found - value) < distance,
        like=value,
    )


def shapes() -> set[int]:
    """Return the ids of the shapes in the scene. From now on, make_shape makes new ones."""
    discarded.clear()
    return set(map(id, scene.objects))


# Options of expect for the number of left_over.
LEFT_OVER = {"expected": 0, "what": Subject("number of shapes that no pendulum has")}


def left_over(old: set[int], parts: list) -> int:
    """Return how many shapes of the scene look like one of parts, but are none, and not in old.

    old is from shapes(), parts are the objects of pendula. Shapes of another thickness are for
    show: a frame.
    """
    kinds = {kind_of(part) for part in parts}
    known = old | set(map(id, parts))
    others = [shape for shape in scene.objects if shape.visible and id(shape) not in known]
    return sum(kind_of(shape) in kinds for shape in others)


def kind_of(shape: Any) -> tuple:
    """Return the kind of a shape, and its thickness."""
    return type(shape), *shape.size.value[1:]
