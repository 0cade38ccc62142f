"""C checks: one pendulum swings, then all pendula swing."""

from math import cos, pi, sin

from vpython import vector

from grading.comparing import cases_of
from grading.cradles import each, hang, LEFT_OVER, left_over, R, shapes, touching
from grading.grader import check, expect
from grading.messages import Wanted

# The arguments omega, theta, r_param, dt, g, and the result; by hand from the two formulas of the appendix.
STEP, AFTER = (3.0, 5 * pi / 6, 0.4, 0.1, 8.0), (2.0, 5 * pi / 6 + 0.2)  # omega falls by 1
STEPS = cases_of("angle_update", globals())


@check("angle_update", watched=True)
def test_angle_update():
    """Takes in theta and omega and updates them for a given timestep dt."""
    expect("angle_update", *STEP, wanted=AFTER)


@check("angle_update", watched=True)
def test_angle_update_of_other_swings():
    """Theta is the angle formed by the cord normal to the axle."""
    for arguments, wanted in STEPS:
        expect("angle_update", *arguments, wanted=wanted)


# theta, omega, mass and e of pendula, and their omega and theta after 0.1 s with g = 10 m/s^2 and cords of 0.5 m. The
# first one is there three times, and they are not sorted.
SWINGING = cases_of("full_swing_update", globals())
START, END = [(omega, theta) for (theta, omega, *_), _ in SWINGING[:3]], [after for _, after in SWINGING[:3]]


def swinging_row(count):
    """Return count pendula, and their (omega, theta) after the swing: SWINGING, again and again."""
    rows = [SWINGING[i % len(SWINGING)] for i in range(count)]
    pend_list = [hang(*values, axle=(7 * i % 10 * 0.1, 0.05, 0), r_param=0.5) for i, (values, _) in enumerate(rows)]
    return pend_list, [after for _, after in rows]


@check("full_swing_update", watched=True)
def test_every_pendulum_swings_once():
    """Uses the helper function swing_update to each pendulum in the Newton's cradle."""
    for count in (3, 10, 40):
        pend_list, after = swinging_row(count)
        states = each(pend_list, "omega", "theta")
        expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, wanted=after, **states)
    other = [hang(theta=-pi / 6, omega=2.0, r_param=0.25)]
    omega = {"see": lambda _: other[0]["omega"], "what": "omega of one pendulum"}
    expect("full_swing_update", other, 0.25, 0.2, 5.0, wanted=4.0, **omega)
    expect("full_swing_update", [], 0.5, 0.1, 10.0, wanted=Wanted("no error for an empty pend_list", lambda _: True))


@check("full_swing_update", watched=True)
def test_bobs_and_cords_move():
    """Updates the angle and position of the pendulum components."""
    pend_list, after = swinging_row(3)
    parts_of = [pend["objects"] for pend in pend_list]

    def see(_):
        return [(axle.pos, bob.pos, ends(cord)) for axle, bob, cord in parts_of]

    def ends(cord):  # a student may draw it from either end
        return sorted([cord.pos, cord.pos + cord.axis], key=lambda end: end.y)

    axles = [vector(axle.pos) for axle, _, _ in parts_of]
    cords = [vector(0.5 * sin(theta), -0.5 * cos(theta), 0) for _, theta in after]
    wanted = [(axle, axle + cord, [axle + cord, axle]) for axle, cord in zip(axles, cords, strict=True)]
    what = "axle, bob, ends of the cord of each pendulum"
    old, parts = shapes(), [part for objects in parts_of for part in objects]
    expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, wanted=wanted, see=see, what=what)
    expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, see=lambda _: left_over(old, parts), **LEFT_OVER)


@check("full_swing_update")
def test_a_swing_changes_nothing_else():
    """The pend_dict is updated."""
    pend_list, *_ = swinging_row(3)
    for pend in pend_list:
        pend["objects"][1].radius = 0.02  # so the bobs do not touch
    pendula, objects = list(pend_list), [pend["objects"] for pend in pend_list]

    def values(_=None):
        kept = [{key: pend[key] for key in ("mass", "e", "color", "texture")} for pend in pend_list]
        return [{**pend, "radius": bob.radius} for pend, (_, bob, _) in zip(kept, objects, strict=True)]

    def are_same(now, old):
        return len(now) == len(old) and all(one is other for one, other in zip(now, old, strict=True))

    def have_objects(_):
        return all(map(are_same, (pend["objects"] for pend in pend_list), objects))

    for what, wanted, see in (
        ("each pendulum", values(), values),
        ("that the list has the same pendula in the same order", True, lambda _: are_same(pend_list, pendula)),
        ("that all pendula have the same objects", True, have_objects),
    ):
        expect("full_swing_update", pend_list, 0.5, 0.1, 10.0, wanted=wanted, see=see, what=what)


@check("full_swing_update", watched=True)
def test_a_swing_is_no_collision():
    """The functionality of each individual pendulum: how each pendulum swings."""
    omegas = [1.0, -1.0, 0.5]
    pend_list = touching(*omegas)
    expect("full_swing_update", pend_list, R, 1e-9, 9.81, wanted=omegas, **each(pend_list, "omega"))
