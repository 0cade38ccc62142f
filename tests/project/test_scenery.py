"""The frame, and the points that each tab's camera must show; the tests compute the cradle point by
point.
"""

from itertools import product
from math import cos, pi, sin, tan

import pytest
from vpython import box, cross, cylinder, dot, mag, scene, vector

from grading.cradles import hang, R
from support.page.scene.scenery import Scenery, TEXT

FORWARD, MARGIN = vector(-0.25, -0.18, -1).norm(), 1.04  # of the camera in camera.js
SIDEWAYS = cross(FORWARD, vector(0, 1, 0)).norm()
UPWARDS = cross(SIDEWAYS, FORWARD)


def pendula(count):
    """Return the axles and bobs of count pendula, with the positions of make_newton_cradle."""
    pend_list = [hang(axle=(-0.1 + i * R / 4, R / 5, 0)) for i in range(count)]
    return tuple([pend["objects"][i] for pend in pend_list] for i in (0, 1))


def surround(count, masses=None, scenery=None):
    """Return a Scenery, a new one if there is none, around count pendula."""
    scenery = scenery or Scenery()
    scenery.surround(*pendula(count), R, masses or [1.0] * count)
    return scenery


def largest(places, scenery, size=(1000, 400)):
    """Return how near these places come to the edges, at 1, of a canvas of this size that shows the
    scenery's points.

    camera.js says what the range of a camera is, and how a point appears; its camera looks at the
    middle of the points.
    """
    points, center = [vector(*point) for point in scenery.view()["points"]], vector(0, 0, 0)
    for direction in (FORWARD, SIDEWAYS, UPWARDS):
        parts = [dot(point, direction) for point in points]
        center += direction * (max(parts) + min(parts)) / 2

    def least_range(shown):
        return max(
            abs(dot(place - center, direction)) * min(size) / side
            - dot(place - center, FORWARD) * tan(scene.fov / 2)
            for place in shown
            for direction, side in zip((SIDEWAYS, UPWARDS), size, strict=True)
        )

    return least_range(places) / (MARGIN * least_range(points))


def outline(count, lowest, highest):
    """Return points around the first and the last bob of count pendula, on swings from lowest to
    highest (rad).
    """
    axles, bobs = pendula(count)
    thetas = [side * (lowest + (highest - lowest) * i / 20) for i in range(21) for side in (-1, 1)]
    ends = [
        axles[i].pos + vector(R * sin(theta), -R * cos(theta), 0)
        for i in (0, -1)
        for theta in thetas
    ]
    return [
        end + vector(cos(a), sin(a), 0) * bobs[0].radius
        for end in ends
        for a in (0, pi / 2, pi, 3 * pi / 2)
    ]


@pytest.mark.parametrize("count", [1, 5, 50])
@pytest.mark.parametrize("size", [(1000, 400), (300, 600), (1900, 300)])
def test_every_swing_up_to_the_horizontal_is_in_view(count, size):
    scenery = surround(count)
    (base,) = (shape for shape in scenery.frame if type(shape) is box)
    corners = [
        base.pos + vector(*half)
        for half in product(*((-part / 2, part / 2) for part in base.size.value))
    ]
    ends = [
        end
        for bar in scenery.frame
        if type(bar) is cylinder
        for end in (bar.pos, bar.pos + bar.axis)
    ]
    # As large as possible
    assert 0.85 < largest(outline(count, 0, pi / 2) + corners + ends, scenery, size) <= 1


@pytest.mark.parametrize("count", [1, 5, 50])
def test_a_bob_above_the_frame_widens_the_view_until_the_cradle_restarts(count):
    """A camera that you have turned or moved stays so while the view is the same."""
    scenery, (axles, bobs) = surround(count), pendula(count)
    near = scenery.view()
    scenery.keep_in_view(bobs)
    assert scenery.view() == near
    bobs[0].pos.y = axles[0].pos.y + 0.9 * R
    for bob in (bobs[0], axles[0]):  # also when the bob comes down
        scenery.keep_in_view([bob])
        assert largest(outline(count, 0, pi), scenery) <= 1
    assert surround(count, scenery=scenery).view() == near


def test_the_frame_carries_the_axles():
    """The rails run along the ends of the axles, and beyond the first and the last axle; posts
    stand on the base.
    """
    scenery, (axles, bobs) = surround(5), pendula(5)
    bars = [shape for shape in scenery.frame if type(shape) is cylinder]
    rails, posts = ([bar for bar in bars if bool(bar.axis.y) == stands] for stands in (False, True))
    (base,) = (shape for shape in scenery.frame if type(shape) is box)
    assert len(posts) == 4
    assert sorted(rail.pos.z for rail in rails) == pytest.approx(
        [-axles[0].width / 2, axles[0].width / 2]
    )
    for rail in rails:
        assert rail.pos.x < axles[0].pos.x < axles[-1].pos.x < rail.pos.x + rail.axis.x
        assert rail.pos.y == axles[0].pos.y
    for post in posts:
        assert post.pos.y + post.axis.y == pytest.approx(axles[0].pos.y)
        assert mag(post.pos - base.pos) < mag(base.size) / 2
    assert base.pos.y + base.height / 2 < min(bob.pos.y - bob.radius for bob in bobs)


def test_a_frame_of_another_size_takes_the_place_of_the_old_one():
    scenery = surround(5)
    before, short = len(scene.objects), scenery.frame[0].axis.x
    surround(9, scenery=scenery)
    assert (len(scene.objects) - before, scenery.frame[0].axis.x - short) == (
        9 * 3,
        pytest.approx(4 * R / 4),
    )


@pytest.mark.parametrize(
    ("masses", "texts"), [([2.5] * 3, ["1", "2", "3"]), ([1, 2.5, 1], ["1\n1", "2\n2.5", "3\n1"])]
)
def test_the_axles_carry_their_numbers_and_masses_that_differ(masses, texts):
    """Above the axles; the view has space for them, and for more lines."""
    scenery, (axles, _) = surround(3, masses), pendula(3)
    view = scenery.view()
    assert view["numbers"] == [(axle.pos.x, text) for axle, text in zip(axles, texts, strict=True)]
    assert view["top"] > axles[0].pos.y + axles[0].height / 2
    lines = 1 + texts[0].count("\n")
    for more in (0, 5):
        scenery.lines = more
        heights = [y for _, y, _ in scenery.view()["points"]]
        assert max(heights) - view["top"] > (lines + more) * TEXT * (max(heights) - min(heights))
