"""The scenes of tests/watch.py: the motion of a check's pendula, and the message if a scene fails."""

import sys
from functools import partial
from math import pi, sqrt
from unittest.mock import Mock

import pytest
import watch
from programs import call

from grading.cradles import hang, R, row
from grading.grader import FAILED, Outcome, PASSED
from grading.messages import Call, plain
from src import swinging, visualize_cradle_run
from support.constants import DT, G
from support.terminal.screen import TextPicture

W = sqrt(G / R)  # 1/s, for small swings
QUARTER = pi / W / 2  # s, of a period


def scene_of(function, *arguments):
    """Return the scene of a call with these arguments."""
    return watch.scene_of(Call(function, tuple(plain(argument) for argument in arguments)))


def play(scene, quarters):
    """Do the ticks of this number of quarters of a period; return theta of each pendulum."""
    for _ in range(round(quarters * QUARTER / DT) + 1):
        scene.tick()
    return scene.values("theta")


TWO = hang(-0.01), hang(axle=(R / 4, 0, 0))
LEFTWARDS = [*row(2), hang(omega=-0.03, axle=(R / 2, 0, 0))]
SCENES = [  # a call, for how many quarters of a period it is played, and the thetas then, by hand, for small swings
    ("angle_update", (0.02, 0.01, R, 0.1, G), 1, [0.02 / W]),
    ("full_swing_update", (row(3, theta=0.01), R, 0.1, G), 2, [-0.01] * 3),
    ("handle_collision", (1, 0.4, -0.2, 1.0, 3.0, R), 2, [-0.5 / W, 0.1 / W]),
    ("handle_collision", (1, 0.4, -0.2, 1.0, 3.0, R), 4, [-0.4 / W, 0.2 / W]),  # they have met twice
    ("handle_two_bobs", (*TWO, R), 2, [0.0, 0.01]),
    ("newton_cradle_tick", (LEFTWARDS, R, 0.1, G), 1, [-0.03 / W, 0.0, 0.0]),
    ("double_angle_update", (3.0, 0.0, 0.6, 0.0, R, 0.1, 0.0), 1, [0.6 + 3 * QUARTER]),  # without gravity
]


@pytest.mark.parametrize(("function", "arguments", "quarters", "thetas"), SCENES)
def test_a_scene_plays_what_the_function_does(monkeypatch, function, arguments, quarters, thetas):
    approaching = partial(visualize_cradle_run.handle_two_bobs, approaching_only=True)
    monkeypatch.setattr(visualize_cradle_run, "handle_two_bobs", approaching)
    assert play(scene_of(function, *arguments), quarters) == pytest.approx(thetas, abs=1e-3)


def test_two_bobs_start_with_the_values_of_the_check(monkeypatch):
    """They need no function that swings."""
    for name in ("angle_update", "swing_update", "full_swing_update"):
        monkeypatch.delattr(swinging, name)
    for name in ("handle_collision", "handle_two_bobs"):
        monkeypatch.setattr(visualize_cradle_run, name, Mock())
    collide, given = visualize_cradle_run.handle_collision, (1, 4.0, -2.0, 1.0, 3.0, R)
    collide.side_effect = [(-5.0, 1.0), (5.0, -1.0)]  # half a period later, the velocities have the other sign
    play(scene_of("handle_collision", *given), 3.2)
    assert [call.args for call in collide.mock_calls] == [given, (1, 5.0, -1.0, 1.0, 3.0, R)]

    pend1, pend2 = hang(0.2, 0.5, mass=2.0), hang(-0.1, e=0.25, axle=(R, 0, 0), radius=0.125)
    visualize_cradle_run.handle_two_bobs.side_effect = lambda *given: seen.append(plain([*given]))
    seen: list = []
    play(scene_of("handle_two_bobs", pend1, pend2, R), 0.1)
    first, second, r_param = seen[0]
    assert (first, r_param) == (plain(pend1), R)
    assert {**second, "bob": 0} == {**plain(pend2), "bob": 0}


def test_the_picture_has_room_for_cords_that_are_too_long():
    scene = watch.Scene([hang(0.2, r_param=0.6), hang(axle=(0.05, 0, 0), r_param=0.2)], 0.2)
    assert scene.reach == pytest.approx(0.6)
    assert "".join(TextPicture().lines(scene, 80, 20)).count("O") == 2


# --- the program -----------------------------------------------------------------------------------------------------

CALL = Call("angle_update", (2.0, 0.3, R, 0.1, G))
NO_ROW = Call("full_swing_update", ([], R, 0.1, G))
WRONG, PASSES, NOTHING = "Wrong.\n", "test_angle_update passes.\n", "There is nothing to watch.\n"
NOT_PLAYED, START = "It cannot be played: ", "\nt = 0.00 s   Ctrl+C ends it.\n"


@pytest.mark.parametrize(
    ("outcome", "result", "status", "printed", "complaint"),
    [
        (Outcome(FAILED, "Wrong.", CALL), (2.0, 0.3), 0, WRONG + START, ""),
        (Outcome(PASSED, "", CALL), (2.0, 0.3), 0, PASSES + START, ""),
        (Outcome(PASSED), None, 0, PASSES + NOTHING, ""),
        (Outcome(FAILED, "Wrong."), None, 1, WRONG, NOTHING),
        (Outcome(FAILED, "Wrong.", NO_ROW), None, 1, WRONG, f"{NOT_PLAYED}ValueError: the cradle has no pendulum\n"),
        (Outcome(FAILED, "Wrong.", CALL), (2.0, "0.3"), 1, WRONG + START, f"{NOT_PLAYED}TypeError: "),
        (Outcome(FAILED, "Wrong.", CALL), None, 1, WRONG + START, f"{NOT_PLAYED}TypeError: "),
        (Outcome(FAILED, "Wrong.", CALL), KeyboardInterrupt(131), 131, WRONG, ""),
        (Outcome(FAILED, "Wrong.", CALL), OSError(28, "Full"), 2, WRONG, "The output: Full\n"),
    ],
)
def test_a_check_is_played_or_one_line_says_why_not(monkeypatch, capsys, outcome, result, status, printed, complaint):
    """result is that of angle_update, or the error with which the scene stops."""
    if isinstance(result, BaseException):
        monkeypatch.setattr(watch, "play", Mock(side_effect=result))
    monkeypatch.setattr(swinging, "angle_update", lambda *_: result)
    monkeypatch.setattr(watch.Grading, "judge", lambda *_: outcome)
    monkeypatch.setattr(watch, "stop_on_signals", lambda: None)
    monkeypatch.setattr(watch, "STRIP", 0.001)
    monkeypatch.setattr("sys.argv", ["watch.py", "test_angle_update", "--seconds", "0.001"])
    code, out, err = call(lambda: sys.exit(watch.main()), capsys)
    if isinstance(code, str):  # Python prints it, and the status is 1
        code, err = 1, f"{err}{code}\n"
    assert (code or 0, err.count("\n")) == (status, bool(complaint))
    assert out.startswith(printed)
    assert err.startswith(complaint)
