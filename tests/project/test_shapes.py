"""Discarded shapes are used again."""

from collections import defaultdict

import pytest
from vpython import box, color, cylinder, sphere, textures, vector
from whole_cradles import components

from support import shapes
from support.shapes import discard, make_shape


@pytest.fixture(autouse=True)
def nothing_discarded(monkeypatch):
    monkeypatch.setattr(shapes, "discarded", defaultdict(list))


def test_a_discarded_shape_is_hidden_and_used_again():
    ball = make_shape(sphere, radius=2)
    discard([ball])
    assert not ball.visible
    assert make_shape(sphere, radius=3) is ball
    assert (ball.visible, ball.radius) == (True, 3)
    assert make_shape(sphere) is not ball


def test_only_the_same_kind_is_used_again():
    discard([make_shape(box)])
    assert type(make_shape(cylinder)) is cylinder


def test_nothing_is_left_of_the_former_looks():
    ball = make_shape(sphere, color=color.red, texture=textures.wood, shininess=1)
    discard([ball])
    make_shape(sphere, pos=vector(1, 2, 3))
    assert (components(ball.pos), components(ball.color)) == ((1, 2, 3), (1, 1, 1))
    assert (ball.texture, ball.shininess) == (None, sphere().shininess)


def test_it_has_its_new_looks():
    ball = make_shape(sphere, color=color.red)
    discard([ball])
    make_shape(sphere, color=color.blue, texture=textures.wood, shininess=1)
    assert (components(ball.color), ball.texture, ball.shininess) == ((0, 0, 1), textures.wood, 1)
