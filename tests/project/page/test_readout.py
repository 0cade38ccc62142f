"""The numbers of the motion: a line each, bars of the momenta, and a sentence."""

from math import sqrt

import pytest
from pages import pause, wait_for_time
from programs import wait_until
from rig import Rig
from vpython import vector
from whole_cradles import GOOD, HEADER, PERIOD, velocities

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle


@pytest.mark.parametrize(
    ("omega", "text"),
    [
        (3, "+{:.2f} kg m/s →"),
        (-3, "-{:.2f} kg m/s ←"),
        (0, "{:.2f} kg m/s"),
        (1e154, "+{:.2e} kg m/s →"),
    ],
)
def test_the_readout(rig, omega, text):
    """The momentum has the arrow of its sign.

    A percentage is at most 999, also if it has no end, and 0 of 0 is 0.
    """
    rig.give("pause")
    rig.cradle.pend_list[0].update(theta=0.0, omega=omega)
    rig.wait()
    start = G * R_PARAM * (1 - 3**0.5 / 2)  # J: 1 kg at 30 degrees
    percent = 100 * (omega * R_PARAM) ** 2 / 2 / start
    assert rig.state["motion"] == {
        "t": "0.00 s\n",
        "energy": "> 999 %" if percent > 999 else f"{percent:.1f} %",
        "horizontal momentum": text.format(abs(omega) * R_PARAM) + "\nthe cords change it",
    }
    rig.give("lifted", 0)
    assert rig.state["motion"]["energy"] == "0.0 %"


@pytest.mark.parametrize(
    ("kind", "caption"), [(Cradle, "hits keep it"), (DoubleCradle, "the cords and hits change it")]
)
def test_bars_show_horizontal_momenta_and_a_caption_says_what_hits_do(csv, kind, caption):
    """A full bar is the most momentum that all masses M can have with the energy E, sqrt(2 M E)."""
    csv.write_text(HEADER + "3.0,1.0,0,0,blue,metal\n" + GOOD)
    rig = Rig(csv, *[30] * kind.cord_count, kind=kind)
    rig.give("momenta", True)
    rig.wait(0.15)  # the first pendulum is on its way to the second one
    largest = sqrt(2 * 4.0 * kind.cord_count * sum(rig.cradle.energies()))
    p = 3.0 * sum(velocity.x for velocity in velocities(rig.cradle.pend_list[0]))
    chart = rig.state["bars"]
    assert chart["title"] == "Horizontal momentum (kg m/s)"
    bar = [f"{p:+.2f}", "rgb(0, 0, 255)", pytest.approx(p / largest, abs=0.001)]
    assert chart["bars"][0] == [1, *bar]
    assert [text for _, text, *_ in chart["bars"]] == [bar[0], "0.00", bar[0]]
    rig.wait(2 * PERIOD)
    assert rig.state["motion"]["horizontal momentum"].endswith(caption)


def test_half_swings_are_counted_from_the_first_stop_and_again_after_a_drag(csv):
    """By the series of the period's elliptic integral, one of 45 degrees takes 1.0400 as long."""
    rig = Rig(csv, 45)
    rig.give("measure", True)
    rig.give("lifted", 5)
    rig.wait(0.25 * PERIOD)
    rig.viewer.stopwatch.restart(rig.time())
    rig.wait(1.9 * PERIOD)
    assert rig.state["motion"]["half swings"] == f"2 in {1.04 * PERIOD:.2f} s"
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    rig.mouse("drag", vector(1, 0, 0))
    rig.give("let_go")
    assert rig.state["motion"]["half swings"] == "0 in 0.00 s"


def test_the_cradle_in_a_sentence_is_told_when_you_pause_or_ask_never_by_itself(shared):
    summary = shared.get_by_role("status").and_(shared.locator(".summary"))
    before = summary.text_content()
    wait_for_time(shared)
    assert summary.text_content() == before
    shared.keyboard.press("t")
    wait_until(lambda: " degrees " in summary.text_content() != before)
    pause(shared)
    wait_until(lambda: summary.text_content().endswith(shared.evaluate("state.summary")))
