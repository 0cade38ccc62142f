"""The frame around the pendula, and the points that each tab's camera must show."""

from itertools import product
from math import cos, pi, sin

import pytest
from vpython import box, scene, vector

from grading.cradles import hang, R
from support.page.scene.scenery import HIT_LINES, Scenery, TEXT


def pendula(count):
    """Return the axles and bobs of count pendula, with the positions of make_newton_cradle."""
    pend_list = [hang(axle=(-0.1 + i * R / 4, R / 5, 0)) for i in range(count)]
    axles = [pend["objects"][0] for pend in pend_list]
    bobs = [pend["objects"][1] for pend in pend_list]
    return axles, bobs


def surround(masses):
    """Return a Scenery around pendula with these masses (kg)."""
    scenery = Scenery()
    scenery.surround(*pendula(len(masses)), R, masses)
    return scenery


def extent(points):
    """Return the least and the greatest x, y and z (m) of these points."""
    return [(min(parts), max(parts)) for parts in zip(*points, strict=True)]


def view(scenery):
    return extent(scenery.view(has_text_above=False)["points"])


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
    scenery = surround([1.0] * count)
    axles, bobs = pendula(count)
    base = scenery.frame[-1]
    frame = [(base.pos - base.size / 2).value, (base.pos + base.size / 2).value]
    for bar in scenery.frame[:-1]:
        frame += [bar.pos.value, (bar.pos + bar.axis).value]
    inside = [box(pos=axles[0].pos + R * vector(-sin(pi / 4), -cos(pi / 4), 0))]
    outside = [box(pos=axles[0].pos + R * vector(-0.9, -0.4, 0))]
    above = [box(pos=axles[0].pos + vector(0, 0.9 * R, 0))]
    for moved, highest in ((inside, pi / 4), (outside, pi / 2), (above, pi), (bobs, pi)):
        scenery.keep_in_view(moved)
        points = frame + outline(count, highest)
        for (least, most), (low, high) in zip(extent(points), view(scenery), strict=True):
            assert low - 1e-9 < least < most < high + 1e-9
            assert high - low < 1.2 * (most - least)


def test_the_frame_carries_the_axles():
    """The rails run along the ends of the axles, and beyond the first and the last axle."""
    axles, bobs = pendula(5)
    *bars, base = surround([1.0] * 5).frame
    rails = [bar for bar in bars if bar.axis.x]
    depth = axles[0].width / 2
    assert [rail.pos.z for rail in rails] == pytest.approx([-depth, depth])
    for rail in rails:
        assert rail.pos.x < axles[0].pos.x < axles[-1].pos.x < rail.pos.x + rail.axis.x
        assert rail.pos.y == axles[0].pos.y
    assert base.pos.y + base.height / 2 < bobs[0].pos.y - bobs[0].radius


def test_a_frame_of_another_size_takes_the_place_of_the_old_one():
    def visible():
        return sum(shape.visible for shape in scene.objects)

    scenery = Scenery()
    for count in (5, 9):
        before = visible()
        scenery.surround(*pendula(count), R, [1.0] * count)
    assert visible() - before == 9 * 3  # of the new pendula


def test_unequal_bobs_get_room_for_wide_swings_from_the_start():
    """They probably swing wider than those that come in: no view changes in the middle of a hit."""
    (left, right), _, _ = view(surround([1.0, 1.0]))
    (wide_left, wide_right), _, _ = view(surround([5.0, 1.0]))
    assert wide_left < left
    assert wide_right > right


def test_the_axles_carry_their_numbers():
    """Above the axles; the view has space for them, and for more lines."""
    scenery = surround([1.0] * 3)
    axles, _ = pendula(3)
    places = [axle.pos.x for axle in axles]
    numbers = [{"x": x, "text": text} for x, text in zip(places, "123", strict=True)]
    assert scenery.view(has_text_above=False)["numbers"] == numbers
    top = scenery.view(has_text_above=False)["top"]
    assert top > axles[0].pos.y + axles[0].height / 2
    for has_text_above, lines in ((False, 1), (True, 1 + HIT_LINES)):
        points = scenery.view(has_text_above)["points"]
        _, (low, high), _ = extent(points)
        assert lines < (high - top) / TEXT / (high - low) < 2 * lines
