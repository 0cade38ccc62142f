"""The pictures of the experiments, by which you choose one."""

from math import degrees

import pages
from pages import slide
from programs import wait_until


def test_an_experiment_is_chosen_by_its_picture_which_says_that_it_was_changed(shared):
    tile = shared.locator(".gallery button[title='Two bobs']")
    pages.choose(shared, "Two bobs")
    wait_until(lambda: tile.get_attribute("aria-pressed") == "true")
    circles = tile.locator("circle").evaluate_all("found => found.map(e => +e.getAttribute('cx'))")
    first, second, *hanging = circles
    assert first < second < 0  # to the left of the first axle
    assert hanging == sorted(hanging)
    slide(shared, "Bobs lifted", 3)
    shared.locator(".choose").get_by_text("Two bobs, changed").wait_for()


def test_the_picture_of_a_choice_has_its_colors_masses_and_angles(rig):
    """Those of your CSV follow the file, and hang."""
    rig.save("mass,e,color,texture,note\n3,1,blue,metal,x\n")
    pictures = rig.state["pictures"]
    assert list(pictures) == rig.control("experiment")["choices"]
    assert pictures["My cradle"] == [{"mass": 3, "color": "rgb(0, 0, 255)", "angles": [0]}]
    angles = [round(degrees(bob["angles"][0])) for bob in pictures["From both sides"]]
    assert angles == [-45, 0, 0, 0, 45]
