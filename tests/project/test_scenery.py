"""The frame around the pendula, and the points that each tab's camera must show."""

from itertools import product
from math import cos, pi, sin

import pytest
from vpython import scene, vector

from grading.cradles import hang, R
from support.page.scene.scenery import Scenery


def pendula(count):
    """Return the axles and bobs of count pendula, with the positions of make_newton_cradle."""
    pend_list = [hang(axle=(-0.1 + i * R / 4, R / 5, 0)) for i in range(count)]
    axles = [pend["objects"][0] for pend in pend_list]
    bobs = [pend["objects"][1] for pend in pend_list]
    return axles, bobs


def surround(count, masses=(1.0,), swing=0.0):
    """Return a Scenery around count pendula."""
    scenery = Scenery()
    scenery.surround(pendula(count)[0], R, masses, swing)
    return scenery


def extent(points):
    """Return the least and the greatest x, y and z (m) of these points."""
    return [(min(parts), max(parts)) for parts in zip(*points, strict=True)]


def view(scenery):
    return extent(scenery.view()["points"])


def outline(count, highest):
    """Return points around the first and the last bob, on swings up to highest (rad)."""
    axles, bobs = pendula(count)
    points = []
    for axle, step in product((axles[0], axles[-1]), range(-20, 21)):
        theta = highest * step / 20
        bob = axle.pos + vector(R * sin(theta), -R * cos(theta), 0)
        for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1)):
            points.append((bob + bobs[0].radius * vector(x, y, 0)).value)
    return points


@pytest.mark.parametrize("count", [1, 5])
def test_the_frame_is_in_view_and_later_swings_that_leave_it(count):
    """The view stays wide when the bob comes down: a camera that you have turned stays so."""
    scenery = surround(count)
    axles, bobs = pendula(count)
    base = scenery.frame[-1]
    frame = [(base.pos + side * base.size / 2).value for side in (-1, 1)]
    frame.append(scenery.frame[0].pos.value)  # a rail
    inside = axles[0].pos + R * vector(-sin(pi / 4), -cos(pi / 4), 0)
    outside = axles[0].pos + R * vector(-0.9, -0.4, 0)
    above = axles[0].pos + vector(0, 0.9 * R, 0)
    for place, highest in ((inside, pi / 4), (outside, pi / 2), (above, pi), (bobs[0].pos, pi)):
        scenery.keep_in_view([place])
        points = frame + outline(count, highest)
        for (least, most), (low, high) in zip(extent(points), view(scenery), strict=True):
            assert low - 1e-9 < least < most < high + 1e-9
            assert high - low < 1.2 * (most - least)


def test_bobs_that_will_swing_wide_have_room_from_the_start():
    """Those with unequal masses, and ghosts of an answer: the camera stays when they come."""
    (left, right), _, _ = view(surround(2))
    for masses, swing in (([5.0, 1.0], 0.0), ([1.0, 1.0], 1.5)):
        (wide_left, wide_right), _, _ = view(surround(2, masses, swing))
        assert wide_left < left
        assert wide_right > right


def test_the_frame_carries_the_axles_and_their_numbers():
    """The rails run along the ends of the axles, and beyond the first and the last axle."""
    axles, bobs = pendula(5)
    scenery = surround(5)
    for side, rail in zip((-1, 1), scenery.frame[:10:5], strict=True):
        assert side * rail.pos.z - axles[0].width / 2 == pytest.approx(rail.radius)
        assert rail.pos.x < axles[0].pos.x < axles[-1].pos.x < rail.pos.x + rail.axis.x
        assert rail.pos.y == axles[0].pos.y
    base = scenery.frame[-1]
    assert base.pos.y + base.height / 2 < bobs[0].pos.y - bobs[0].radius
    _, (_, highest), _ = view(scenery)
    for number, (axle, label) in enumerate(
        zip(axles, scenery.view()["numbers"], strict=True), start=1
    ):
        assert (label["x"], label["text"]) == (axle.pos.x, str(number))
        assert axle.pos.y + axle.height / 2 < label["y"] < highest


def test_a_frame_of_another_size_takes_the_place_of_the_old_one():
    def visible():
        return sum(shape.visible for shape in scene.objects)

    scenery = Scenery()
    for count in (5, 9):
        before = visible()
        scenery.surround(pendula(count)[0], R, [1.0])
    assert visible() - before == 9 * 3  # of the new pendula
