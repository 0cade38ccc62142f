"""The stand around the pendula, and the points that each tab's camera must show."""

from math import cos, pi, sin

import pytest
from vpython import scene, vector

from grading.cradles import hang_row, R
from support.page.scene.scenery import Scenery


def pendula(count):
    """Return the axles and bobs of a row."""
    return zip(*[pend["objects"][:2] for pend in hang_row(count)], strict=True)


def extent(points):
    """Return the least and the greatest x, y and z (m) of these points."""
    return [(min(parts), max(parts)) for parts in zip(*points, strict=True)]


@pytest.mark.parametrize("count", [1, 5])
def test_the_frame_is_in_view_and_later_swings_that_leave_it(count):
    """The view stays wide when the bob comes down: a camera that you have turned stays so."""
    scenery = Scenery()
    axles, bobs = pendula(count)
    scenery.surround(axles, R, [1.0])
    base, rail = scenery.stand[-1], scenery.stand[0]
    stand = [(base.pos - base.size / 2).value, (base.pos + base.size / 2).value, rail.pos.value]
    for angle, highest in ((pi / 4, pi / 4), (1.16, pi / 2), (2.7, pi), (0.0, pi)):
        scenery.keep_in_view([axles[0].pos + R * vector(-sin(angle), -cos(angle), 0)])
        aside = R * sin(min(highest, pi / 2)) + bobs[0].radius
        top = axles[0].pos.y - R * cos(highest) + bobs[0].radius
        swings = [(axles[0].pos.x - aside, top, 0.0), (axles[-1].pos.x + aside, top, 0.0)]
        view = extent(scenery.view()["points"])
        for (least, most), (low, high) in zip(extent(stand + swings), view, strict=True):
            assert low - 1e-9 < least < most < high + 1e-9
            assert high - low < 1.2 * (most - least)


def test_a_frame_of_another_size_takes_the_place_of_the_old_one():
    def visible():
        return sum(shape.visible for shape in scene.objects)

    scenery = Scenery()
    for count in (5, 9):
        before = visible()
        axles, _ = pendula(count)
        scenery.surround(axles, R, [1.0])
    assert visible() - before == 9 * 3  # of the new pendula
