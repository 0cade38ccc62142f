"""The frame and the camera; the tests compute the view point by point."""

from itertools import pairwise
from math import cos, pi, sin, tan

import pytest
from vpython import box, cross, cylinder, dot, mag, norm, scene, vector
from whole_cradles import components

from grading.cradles import hang, R
from support.page.scenery import FARTHEST, FORWARD, NEAREST, Scenery, TEXT


def pendula(count):
    """Return the axles and bobs of count pendula, with the positions of make_newton_cradle."""
    pend_list = [hang(axle=(-0.1 + i * R / 4, R / 5, 0)) for i in range(count)]
    return tuple([pend["objects"][i] for pend in pend_list] for i in (0, 1))


def seen_at(point):
    """Return the position of a point on the canvas: 0 is the middle, +-1 are the edges, to the right and upwards."""
    forward, sideways = norm(scene.forward), norm(cross(scene.forward, scene.up))
    camera = scene.center - forward * (scene.range / tan(scene.fov / 2))
    arm = point - camera
    shorter = min(scene.width, scene.height)
    scale = shorter / (dot(arm, forward) * tan(scene.fov / 2))
    return scale * dot(arm, sideways) / scene.width, scale * dot(arm, cross(sideways, forward)) / scene.height


def outline(axle, bob, lowest, highest):
    """Return points around a bob on its swing from lowest to highest (rad)."""
    thetas = [side * (lowest + (highest - lowest) * i / 20) for i in range(21) for side in (-1, 1)]
    centres = [axle.pos + vector(R * sin(theta), -R * cos(theta), 0) for theta in thetas]
    return [c + vector(cos(a), sin(a), 0) * bob.radius for c in centres for a in (0, pi / 2, pi, 3 * pi / 2)]


def is_in_view(points):
    return all(abs(part) <= 1 for point in points for part in seen_at(point))


@pytest.mark.parametrize("count", [1, 2, 5, 13, 50])
@pytest.mark.parametrize("size", [(1000, 400), (300, 600), (1900, 300)])
def test_every_swing_up_to_the_horizontal_is_in_view(count, size):
    axles, bobs = pendula(count)
    scenery = Scenery()
    scene.width, scene.height = size
    scenery.surround(axles, bobs, R, [1] * len(axles))
    swings = outline(axles[0], bobs[0], 0, pi / 2) + outline(axles[-1], bobs[-1], 0, pi / 2)
    corners = [
        shape.pos + vector(*(side * part / 2 for side, part in zip(sides, components(shape.size), strict=True)))
        for shape in scenery.frame
        if type(shape) is box
        for sides in [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    ]
    ends = [end for bar in scenery.frame if type(bar) is cylinder for end in (bar.pos, bar.pos + bar.axis)]
    assert is_in_view(swings + corners + ends)
    largest = max(abs(part) for point in swings + corners + ends for part in seen_at(point))
    assert largest > 0.85  # and not smaller than necessary


@pytest.mark.parametrize("count", [1, 5, 50])
def test_a_bob_above_the_frame_widens_the_view_until_it_starts_anew(count):
    axles, bobs = pendula(count)
    scenery = Scenery()
    scenery.surround(axles, bobs, R, [1] * len(axles))
    near = scene.range
    scenery.keep_in_view(bobs)
    assert scene.range == near
    bobs[0].pos.y = axles[0].pos.y + 0.9 * R
    scenery.keep_in_view(bobs)
    circles = outline(axles[0], bobs[0], 0, pi) + outline(axles[-1], bobs[-1], 0, pi)
    assert is_in_view(circles)
    scenery.come_closer()
    assert scene.range == near
    scene.range = 7  # as a person zooms
    scenery.come_closer()
    assert scene.range == 7


def test_the_view_is_widened_once():
    """A person may zoom in after that."""
    axles, bobs = pendula(5)
    scenery = Scenery()
    scenery.surround(axles, bobs, R, [1] * len(axles))
    bobs[0].pos.y = axles[0].pos.y + 0.9 * R
    scenery.keep_in_view(bobs)
    scene.range = 0.1 * R
    scenery.keep_in_view(bobs)
    assert scene.range == 0.1 * R


def test_a_turned_and_zoomed_view_is_kept_as_long_as_the_cradle_is_as_large():
    scenery = Scenery()
    scenery.surround(*pendula(5), R, [1] * 5)
    scene.range, scene.forward = 7, vector(0, 0, -1)
    scenery.surround(*pendula(5), R, [1] * 5)
    assert scene.range == 7
    scenery.surround(*pendula(6), R, [1] * 6)
    assert scene.range < 7
    assert components(scene.forward) == (0, 0, -1)


def test_a_reset_view_is_as_at_the_start():
    scenery = Scenery()
    scenery.surround(*pendula(5), R, [1] * 5)
    near, center = scene.range, components(scene.center)
    scene.range, scene.forward, scene.center = 7, vector(0, 0, -1), vector(9, 9, 9)
    scenery.reset_view()
    assert components(scene.forward) == components(FORWARD)
    assert (scene.range, components(scene.center)) == (near, center)


@pytest.mark.parametrize(("zoomed", "kept"), [(0.01, NEAREST), (0.5, 0.5), (2.0, 2.0), (50.0, FARTHEST)])
def test_the_view_is_neither_too_near_nor_too_far(zoomed, kept):
    scenery = Scenery()
    scenery.surround(*pendula(5), R, [1] * 5)
    near = scene.range
    scene.range = zoomed * near
    scenery.limit_view()
    assert scene.range == pytest.approx(kept * near)


@pytest.mark.parametrize(("moved", "kept"), [(0.5, 0.5), (9.0, 1.0)])
def test_the_view_stays_at_the_cradle(moved, kept):
    scenery = Scenery()
    scenery.surround(*pendula(5), R, [1] * 5)
    near, center = scene.range, vector(scene.center)
    scene.center = center + moved * near * vector(0, 1, 0)
    scenery.limit_view()
    assert components(scene.center - center) == pytest.approx((0, kept * near, 0))


def test_another_cradle_is_looked_at_from_nearby_again():
    scenery = Scenery()
    scenery.surround(*pendula(5), R, [1] * 5)
    near = scene.range
    axles, bobs = pendula(6)
    bobs[0].pos.y = axles[0].pos.y + R
    scenery.surround(axles, bobs, R, [1] * len(axles))
    scenery.keep_in_view(bobs)
    scenery.surround(*pendula(5), R, [1] * 5)
    assert scene.range == near


def test_the_frame_carries_the_axles():
    """The rails run along the ends of the axles, and beyond the first and the last axle; posts stand on the base."""
    axles, bobs = pendula(5)
    scenery = Scenery()
    scenery.surround(axles, bobs, R, [1] * len(axles))
    bars = [shape for shape in scenery.frame if type(shape) is cylinder]
    rails = [bar for bar in bars if bar.axis.y == 0]
    posts = [bar for bar in bars if bar.axis.y != 0]
    (base,) = (shape for shape in scenery.frame if type(shape) is box)
    assert (len(rails), len(posts)) == (2, 4)
    assert sorted(rail.pos.z for rail in rails) == pytest.approx([-axles[0].width / 2, axles[0].width / 2])
    for rail in rails:
        assert rail.pos.x < axles[0].pos.x < axles[-1].pos.x < rail.pos.x + rail.axis.x
        assert rail.pos.y == axles[0].pos.y
    for post in posts:
        assert post.pos.y + post.axis.y == pytest.approx(axles[0].pos.y)
        assert mag(post.pos - base.pos) < mag(base.size) / 2
    lowest_bob = min(bob.pos.y - bob.radius for bob in bobs)
    assert base.pos.y + base.height / 2 < lowest_bob


def test_an_outgrown_frame_is_used_again():
    scenery = Scenery()
    scenery.surround(*pendula(5), R, [1] * 5)
    small = scenery.frame
    scenery.surround(*pendula(7), R, [1] * 7)
    assert {id(shape) for shape in scenery.frame} == {id(shape) for shape in small}
    assert all(shape.visible for shape in scenery.frame)


# --- numbers ---------------------------------------------------------------------------------------------------------


def numbered(count, masses=None, scenery=None, size=(1000, 400)):
    """Return what is written above the axles of count pendula, from left to right: {text: its middle on the canvas}."""
    scenery = scenery or Scenery()
    scene.width, scene.height = size
    scenery.surround(*pendula(count), R, masses or [1.0] * count)
    return {label.text: seen_at(label.pos) for label in scenery.labels if label.visible}


def test_the_axles_carry_their_numbers():
    scenery = Scenery()
    assert [*numbered(5, scenery=scenery)] == ["1", "2", "3", "4", "5"]
    for label, axle in zip(scenery.labels, pendula(5)[0], strict=True):
        assert (label.pos.x, label.pos.z) == (axle.pos.x, 0)
        assert label.pos.y > axle.pos.y + axle.height / 2


def test_masses_that_differ_are_below_the_numbers():
    assert [*numbered(3, [1.0, 2.5, 1.0])] == ["1\n1", "2\n2.5", "3\n1", " \nkg"]
    assert [*numbered(3, [2.5] * 3)] == ["1", "2", "3"]


@pytest.mark.parametrize("masses", [None, [1, 2.25]])
@pytest.mark.parametrize("count", [1, 2, 5, 10, 20, 50, 100, 500])
def test_the_numbers_do_not_overlap_and_are_in_view(count, masses):
    labels = numbered(count, masses and (masses * count)[:count])
    places = sorted((x * 1000 / 2, max(map(len, text.split("\n")))) for text, (x, _) in labels.items())
    for (x1, letters1), (x2, letters2) in pairwise(places):
        assert x2 - x1 > 0.5 * TEXT * 400 * (letters1 + letters2) / 2
    lines = max(text.count("\n") for text in labels) + 1
    assert all(abs(x) < 1 and y + 2 * TEXT * (1.3 * lines + 0.4) < 1 for x, y in labels.values())


def test_of_many_pendula_every_fifth_or_tenth_has_a_number():
    assert [*numbered(20)] == [str(number) for number in range(1, 21)]
    assert [*numbered(50)] == ["1", *(str(number) for number in range(5, 51, 5))]
    assert [*numbered(200)] == ["1", *(str(number) for number in range(10, 201, 10))]


def test_the_numbers_follow_the_size_of_the_canvas():
    scenery = Scenery()
    numbered(20, scenery=scenery)
    small = scenery.labels[0].height
    scene.width, scene.height = 2 * 1000, 2 * 400
    scenery.point_camera()
    assert {label.height for label in scenery.labels} == {2 * small}
    scene.width = 300
    scenery.point_camera()
    assert sum(label.visible for label in scenery.labels) < 20


def test_a_new_cradle_takes_the_labels_of_the_old_one():
    scenery = Scenery()
    numbered(5, [1, 2, 1, 1, 1], scenery=scenery)
    before = list(scenery.labels)
    assert [*numbered(3, scenery=scenery)] == ["1", "2", "3"]
    for mass in (2, 3):  # the second cradle needs the same space
        assert [*numbered(5, [1, mass, 1, 1, 1], scenery=scenery)][1] == f"2\n{mass}"
    assert list(map(id, scenery.labels)) == list(map(id, before))


def test_masses_get_room_above_the_numbers():
    scenery = Scenery()
    numbered(5, scenery=scenery)
    near = scene.range
    numbered(5, [1, 2, 1, 1, 1], scenery=scenery)
    assert scene.range > near
