"""The mouse on the canvas: it turns the view, and grabs a bob."""

import pages
import pytest
from pages import (
    bob_angles,
    button,
    pixel,
    press,
    slide,
    wait_for_angles,
)
from programs import wait_until


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
