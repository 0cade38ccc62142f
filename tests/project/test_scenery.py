"""The frame and the camera; the tests compute the view point by point."""

from itertools import pairwise, product
from math import cos, pi, sin, tan

import pytest
from vpython import box, cross, cylinder, dot, mag, norm, scene, vector

from grading.cradles import hang, R
from support.page.scenery import FARTHEST, NEAREST, Scenery, TEXT


def pendula(count):
    """Return the axles and bobs of count pendula, with the positions of make_newton_cradle."""
    pend_list = [hang(axle=(-0.1 + i * R / 4, R / 5, 0)) for i in range(count)]
    return tuple([pend["objects"][i] for pend in pend_list] for i in (0, 1))


def surround(count, masses=None, scenery=None, size=(1000, 400)):
    """Return a Scenery, a new one if there is none, around count pendula on a canvas of this size (pixels)."""
    scenery = scenery or Scenery()
    scene.width, scene.height = size
    scenery.surround(*pendula(count), R, masses or [1.0] * count)
    return scenery


def seen_at(point):
    """Return the position of a point on the canvas: 0 is the middle, +-1 are the edges, to the right and upwards."""
    forward, sideways = norm(scene.forward), norm(cross(scene.forward, scene.up))
    camera = scene.center - forward * (scene.range / tan(scene.fov / 2))
    arm = point - camera
    scale = min(scene.width, scene.height) / (dot(arm, forward) * tan(scene.fov / 2))
    return scale * dot(arm, sideways) / scene.width, scale * dot(arm, cross(sideways, forward)) / scene.height


def outline(count, lowest, highest):
    """Return points around the first and the last bob of count pendula, on swings from lowest to highest (rad)."""
    axles, bobs = pendula(count)
    thetas = [side * (lowest + (highest - lowest) * i / 20) for i in range(21) for side in (-1, 1)]
    ends = [axles[i].pos + vector(R * sin(theta), -R * cos(theta), 0) for i in (0, -1) for theta in thetas]
    return [end + vector(cos(a), sin(a), 0) * bobs[0].radius for end in ends for a in (0, pi / 2, pi, 3 * pi / 2)]


def largest(points):
    """Return the largest distance of these points from the middle of the canvas; below 1, all are in view."""
    return max(abs(part) for point in points for part in seen_at(point))


@pytest.mark.parametrize("count", [1, 5, 50])
@pytest.mark.parametrize("size", [(1000, 400), (300, 600), (1900, 300)])
def test_every_swing_up_to_the_horizontal_is_in_view(count, size):
    frame = surround(count, size=size).frame
    (base,) = (shape for shape in frame if type(shape) is box)
    corners = [base.pos + vector(*half) for half in product(*((-part / 2, part / 2) for part in base.size.value))]
    ends = [end for bar in frame if type(bar) is cylinder for end in (bar.pos, bar.pos + bar.axis)]
    assert 0.85 < largest(outline(count, 0, pi / 2) + corners + ends) <= 1  # and not smaller than necessary


@pytest.mark.parametrize("count", [1, 5, 50])
def test_a_bob_above_the_frame_widens_the_view_until_the_cradle_restarts(count):
    """Once: you may zoom in after that."""
    scenery, (axles, bobs) = surround(count), pendula(count)
    near = scene.range
    scenery.keep_in_view(bobs)
    assert scene.range == near
    bobs[0].pos.y = axles[0].pos.y + 0.9 * R
    scenery.keep_in_view(bobs)
    assert largest(outline(count, 0, pi)) <= 1
    scene.range = 0.1 * R
    scenery.keep_in_view(bobs)
    assert scene.range == 0.1 * R
    surround(count, scenery=scenery)
    assert scene.range == near


def test_a_turned_and_zoomed_view_is_kept_while_the_cradle_has_the_same_size():
    scenery = surround(5)
    scene.range, scene.forward = 7, vector(0, 0, -1)
    surround(5, scenery=scenery)
    assert scene.range == 7
    surround(6, scenery=scenery)
    assert scene.range < 7
    assert scene.forward == vector(0, 0, -1)


@pytest.mark.parametrize(
    ("zoomed", "zoom", "moved", "way"),
    [(0.01, NEAREST, 0.5, 0.5), (0.5, 0.5, 9.0, 1.0), (2.0, 2.0, 0.0, 0.0), (50.0, FARTHEST, 0.5, 0.5)],
)
def test_the_view_stays_at_the_cradle_neither_too_near_nor_too_far(zoomed, zoom, moved, way):
    scenery = surround(5)
    near, center = scene.range, vector(scene.center)
    scene.range, scene.center = zoomed * near, center + moved * near * vector(0, 1, 0)
    scenery.bring_camera_back()
    assert scene.range == pytest.approx(zoom * near)
    assert (scene.center - center).value == pytest.approx([0, way * near, 0])


def test_the_frame_carries_the_axles():
    """The rails run along the ends of the axles, and beyond the first and the last axle; posts stand on the base."""
    scenery, (axles, bobs) = surround(5), pendula(5)
    bars = [shape for shape in scenery.frame if type(shape) is cylinder]
    rails = [bar for bar in bars if bar.axis.y == 0]
    posts = [bar for bar in bars if bar.axis.y != 0]
    (base,) = (shape for shape in scenery.frame if type(shape) is box)
    assert len(posts) == 4
    assert sorted(rail.pos.z for rail in rails) == pytest.approx([-axles[0].width / 2, axles[0].width / 2])
    for rail in rails:
        assert rail.pos.x < axles[0].pos.x < axles[-1].pos.x < rail.pos.x + rail.axis.x
        assert rail.pos.y == axles[0].pos.y
    for post in posts:
        assert post.pos.y + post.axis.y == pytest.approx(axles[0].pos.y)
        assert mag(post.pos - base.pos) < mag(base.size) / 2
    assert base.pos.y + base.height / 2 < min(bob.pos.y - bob.radius for bob in bobs)


def numbers(scenery):
    """Return the visible texts above the axles, from left to right."""
    return [label.text for label in scenery.labels if label.visible]


def test_the_axles_carry_their_numbers_and_masses_that_differ():
    scenery = surround(3, [2.5] * 3)
    assert numbers(scenery) == ["1", "2", "3"]
    for label, axle in zip(scenery.labels, pendula(3)[0], strict=True):
        assert (label.pos.x, label.pos.z) == (axle.pos.x, 0)
        assert label.pos.y > axle.pos.y + axle.height / 2
    near = scene.range
    assert numbers(surround(3, [1.0, 2.5, 1.0], scenery)) == ["1\n1", "2\n2.5", "3\n1", " \nkg"]
    assert scene.range > near  # the masses get room


@pytest.mark.parametrize("masses", [None, [1, 2.25]])
@pytest.mark.parametrize("count", [1, 5, 20, 50, 500])
def test_the_numbers_do_not_overlap_and_are_in_view(count, masses):
    labels = [label for label in surround(count, masses and (masses * count)[:count]).labels if label.visible]
    spots = {label.text: seen_at(label.pos) for label in labels}
    widths = sorted((x * 1000 / 2, max(map(len, text.split("\n")))) for text, (x, _) in spots.items())
    for (x1, letters1), (x2, letters2) in pairwise(widths):
        assert x2 - x1 > 0.5 * TEXT * 400 * (letters1 + letters2) / 2
    lines = max(text.count("\n") for text in spots) + 1
    assert all(abs(x) < 1 and y + 2 * TEXT * (1.3 * lines + 0.4) < 1 for x, y in spots.values())


def test_with_many_pendula_or_a_narrow_canvas_every_fifth_or_tenth_has_a_number():
    """The numbers follow the size of the canvas."""
    assert numbers(surround(50)) == ["1", *(str(number) for number in range(5, 51, 5))]
    assert numbers(surround(200)) == ["1", *(str(number) for number in range(10, 201, 10))]
    scenery = surround(20)
    assert numbers(scenery) == [str(number) for number in range(1, 21)]
    small = scenery.labels[0].height
    surround(20, scenery=scenery, size=(2000, 800)).point_camera()
    assert {label.height for label in scenery.labels} == {2 * small}
    surround(20, scenery=scenery, size=(300, 800)).point_camera()
    assert len(numbers(scenery)) < 20
