"""The mouse and fingers on the canvas: they grab a bob, drag it, or turn the view."""

import pages
import pytest
from pages import bob_angles, button, pause, pixel, press, slide, wait_for_angles
from programs import wait_until
from rig import Rig
from vpython import vector

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle

# The direction of the view: onto the row, along it, and slanting
AHEAD = (0, 0, -1)
ALONG = (-1, 0, 0)
SLANTING = (-0.3, -0.2, -1)


@pytest.mark.parametrize(("kind", "bob"), [(Cradle, 4), (DoubleCradle, 9)])
def test_a_bob_is_dragged_while_the_time_stands_and_swings_from_there(csv, kind, bob):
    """Also in a slanting view, and where no point in the plane of swing is under the mouse."""
    rig = Rig(csv, *[0] * kind.cord_count, kind=kind)
    axle = rig.cradle.axles()[4].pos
    bob = rig.cradle.bobs()[bob]
    rig.mouse("grab", bob.pos + vector(bob.radius / 2, 0, 0), SLANTING)
    time = rig.time()
    rig.mouse("drag", axle + vector(3, -3, 0), SLANTING)  # far away
    rig.mouse("drag", vector(1, 1, 1), ALONG)
    rig.give("pause")
    rig.give("step")
    rig.give("pause")
    rig.wait(0.5)
    assert rig.time() == time
    side = kind.cord_count * R_PARAM / 2**0.5
    assert (bob.pos - axle).value == pytest.approx([side, -side, 0])
    assert rig.state["motion"]["energy"] == "100.0 %"
    rig.give("let_go")
    rig.mouse("drag", axle)
    rig.wait(0.1)
    assert rig.time() > time
    assert rig.bob_angles()[4] < 45


@pytest.mark.parametrize("is_held", [True, False])
def test_while_paused_the_graph_ends_at_the_energy_of_a_bob_that_was_dragged(rig, is_held):
    """Also if it was let go in the same picture. In the graph, this energy is 100 %."""
    rig.give("pause")
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    rig.tell("drag", [3, -3, 0], [*AHEAD])
    if not is_held:
        rig.tell("let_go")
    rig.give("graph", "Energies")
    assert rig.state["curves"]["columns"]["total"] == [100]


@pytest.mark.parametrize(
    ("bob", "radii", "direction", "taken"),
    [(4, 1.4, AHEAD, 4), (4, -1.4, AHEAD, 3), (2, 0, ALONG, 4), (4, 1.6, AHEAD, None)],
)
def test_the_nearest_bob_is_taken_or_the_foremost_one_or_none_far_away(
    rig, bob, radii, direction, taken
):
    """A finger may be beside it."""
    rig.give("lifted", 0)
    bob = rig.cradle.bobs()[bob]
    rig.mouse("grab", bob.pos + vector(radii * bob.radius, 0, 0), direction)
    assert rig.viewer.held_bob.index == taken


# --- in a browser ----------------------------------------------------------------------------


def test_the_view_is_turned_with_the_right_button_and_put_back(shared):
    shared.mouse.move(100, 100)
    shared.mouse.down(button="right")
    shared.mouse.move(160, 100, steps=3)
    shared.mouse.up(button="right")
    press(shared, "Reset view")
    button(shared, "Reset view").wait_for(state="hidden")


def test_the_cursor_shows_that_a_bob_can_be_grabbed_and_it_is_let_go_outside_of_the_canvas(shared):
    """In a second tab, which is then moved to a display with twice the pixels.

    The canvas has them, too.
    """
    with pages.new_page(shared.context.browser) as sharp:
        pages.open_cradle(sharp, shared.url)
        display = {"width": 1000, "height": 700, "deviceScaleFactor": 2, "mobile": False}
        sharp.context.new_cdp_session(sharp).send("Emulation.setDeviceMetricsOverride", display)
        sharp.wait_for_function("scene().width === 2 * one('.canvas canvas').clientWidth")
        sharp.wait_for_function("scene().__overlay_objects.objects[0].height === 28")
        slide(sharp, "Bobs lifted", 0)
        wait_for_angles(sharp, 0, 0, 0, 0, 0)
        sharp.mouse.move(*pixel(sharp, 0, 0))
        sharp.wait_for_function("cursor() === 'grab'")
        pages.drag(sharp, 0, -15)
        wait_until(lambda: bob_angles(sharp)[0] == pytest.approx(-15, abs=1))
        sharp.wait_for_function("cursor() === 'grabbing'")
        sharp.mouse.move(20, 230, steps=3)  # below the canvas
        wait_until(lambda: -32 < bob_angles(sharp)[0] < -20)
        sharp.mouse.up()
        wait_until(lambda: bob_angles(sharp)[4] > 15)
        sharp.mouse.move(20, 20)
        sharp.wait_for_function("cursor() === 'auto'")


def test_a_finger_drags_a_bob_or_turns_the_camera(whole):
    pause(whole)
    slide(whole, "Bobs lifted", 0)
    wait_for_angles(whole, 0, 0, 0, 0, 0)
    fingers = whole.context.new_cdp_session(whole)

    def touch(kind, *point):
        """Kind is Start or Move, to a point (x, y), or End."""
        points = [dict(zip("xy", point, strict=True))] if point else []
        fingers.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})

    def turn():
        return whole.evaluate("scene().forward.x")

    before = turn()
    x, y = pixel(whole, 4, 0)
    radius = (x - pixel(whole, 3, 0)[0]) / 2.1
    touch("Start", x, y + 1.3 * radius)  # a finger is not exact
    touch("Move", *pixel(whole, 4, 20))
    touch("Move", *pixel(whole, 4, 40))
    wait_until(lambda: bob_angles(whole)[4] == pytest.approx(40, abs=3))
    assert turn() == before
    touch("End")
    touch("Start", 60, 60)
    touch("Move", 90, 60)
    touch("Move", 140, 60)
    touch("End")
    wait_until(lambda: turn() != before)
    whole.evaluate("scene().forward = vec(0, 0.5, -1)")
    whole.wait_for_function("() => scene().forward.y === 0")  # never below the base
