"""The scenes of tests/watch.py: the motion of a check's pendula, and the message if a scene fails."""

from math import cos, pi, sin, sqrt

import pytest
import watch
from vpython import mag
from whole_cradles import components

from grading.cradles import hang, MIXED_CSV, R, row
from grading.grader import FAILED, Outcome, PASSED
from grading.telling import Call, plain
from src import special_cradles, swinging, visualize_cradle_run
from support.constants import DT, G
from support.pendulum import make_pendulum
from support.terminal.picture import TextPicture

W = sqrt(G / R)  # 1/s, for small swings


def scene_of(function, *arguments):
    """Return the scene of a call with these arguments."""
    return watch.scene_of(Call(function, tuple(plain(argument) for argument in arguments)))


def play(scene, seconds):
    """Play a scene; return its hits as (time in s, left, right)."""
    ticks = range(1, round(seconds / DT) + 1)
    return [(round(tick * DT, 9), *pair) for tick in ticks for pair in scene.tick() or []]


def never(*_, **__):
    raise NotImplementedError("this function of the student is not the one that is checked")


@pytest.fixture
def without_swings(monkeypatch):
    for name in ("angle_update", "swing_update", "full_swing_update"):
        monkeypatch.setattr(swinging, name, never)
    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", never)


# --- handle_collision ------------------------------------------------------------------------------------------------


def meeting(monkeypatch, handle_collision, *arguments):
    """Return the scene of a call of handle_collision, and a list with the arguments of all its calls."""
    calls: list = []

    def noting_calls(*given):
        calls.append(given)
        return handle_collision(*given)

    monkeypatch.setattr(visualize_cradle_run, "handle_collision", noting_calls)
    return scene_of("handle_collision", *arguments), calls


def test_two_meet_at_the_bottom_and_again_after_each_half_of_a_period(monkeypatch, without_swings):
    given = 0.5, 4.0, -2.0, 1.0, 1.0, R
    scene, calls = meeting(monkeypatch, visualize_cradle_run.handle_collision, *given)
    assert scene.thetas() == pytest.approx([-4.0 / W, 2.0 / W])
    hits = play(scene, 2.2 * pi / W)
    quarter = pi / W / 2
    assert hits == [(pytest.approx(time, abs=3 * DT), 0, 1) for time in (quarter, 3 * quarter)]
    # -0.5 and 2.5 came back; half a period later these velocities have the other sign.
    assert calls == [given, pytest.approx((0.5, 0.5, -2.5, 1.0, 1.0, R))]
    assert scene.thetas() != pytest.approx([0, 0], abs=0.1)


def test_what_comes_back_is_how_they_go_on(monkeypatch, without_swings):
    scene, _ = meeting(monkeypatch, lambda *_: (-1.0, 0.5), 1, 3.0, 0.0, 1.0, 1.0, R)
    play(scene, pi / W / 2 + 0.1)
    assert scene.thetas() == pytest.approx([-1.0 / W * sin(0.1 * W), 0.5 / W * sin(0.1 * W)], rel=0.01)
    check_that_it_shows_where_they_are(scene, R)


def test_velocities_that_stay_are_no_hit(monkeypatch, without_swings):
    scene, calls = meeting(monkeypatch, lambda e, omega1, omega2, *_: (omega1, omega2), 1, 3.0, 1.0, 1.0, 1.0, R)
    assert play(scene, 2.2 * pi / W) == []
    assert [call[1:3] for call in calls] == [(3.0, 1.0), (-3.0, -1.0)]


def test_small_swings_and_elastic_hits_keep_the_energy(monkeypatch, without_swings):
    scene, calls = meeting(monkeypatch, visualize_cradle_run.handle_collision, 1, 4.0, -2.0, 1.0, 3.0, 3.0)
    at_start = sum(scene.energies())
    for _ in range(30):
        play(scene, 0.1)
        assert sum(scene.energies()) == pytest.approx(at_start, rel=1e-3)
    assert len(calls) > 1


def check_that_it_shows_where_they_are(scene, r_param):
    for pend in scene.pend_list:
        axle, bob, cord = pend["objects"]
        arm = r_param * sin(pend["theta"]), -r_param * cos(pend["theta"]), 0
        assert components(bob.pos - axle.pos) == pytest.approx(arm)
        assert components(cord.axis) == pytest.approx(arm)


# --- handle_two_bobs -------------------------------------------------------------------------------------------------


def test_two_bobs_are_first_handled_as_the_check_handed_them_over(monkeypatch, without_swings):
    def handle_two_bobs(pend1, pend2, r_param):
        seen.append((pend1["theta"], pend1["omega"], pend1["mass"], pend2["e"], pend2["objects"][1].radius, r_param))

    seen: list = []
    monkeypatch.setattr(visualize_cradle_run, "handle_two_bobs", handle_two_bobs)
    scene = scene_of("handle_two_bobs", hang(0.2, 3.0, mass=2.0), hang(e=0.25, radius=0.125), R)
    assert play(scene, 2 * DT) == []
    assert seen[0] == (0.2, 3.0, 2.0, 0.25, 0.125, R)
    assert seen[1][0] == pytest.approx(0.2 + 3.0 * DT, abs=1e-5)


def test_two_bobs_swing_from_their_last_change(monkeypatch, without_swings):
    def handle_two_bobs(pend1, pend2, _):
        if pend2["theta"] > 0 and pend1["omega"] < 0 and not changed:
            pend1["omega"] = -1.0
            changed.append(pend1["theta"])

    changed: list = []
    monkeypatch.setattr(visualize_cradle_run, "handle_two_bobs", handle_two_bobs)
    scene = scene_of("handle_two_bobs", hang(0.2, 0.5), hang(-0.1, axle=(R, 0, 0)), R)
    change = pi / W / 2  # s: then pend2 is at the bottom, and pend1 is at omega / W
    (hit,) = play(scene, change + 0.1)
    assert hit == (pytest.approx(change, abs=3 * DT), 0, 1)
    assert changed == [pytest.approx(0.5 / W, abs=1e-3)]
    c, s = cos(0.1 * W), sin(0.1 * W)
    assert scene.thetas() == pytest.approx([0.5 / W * c - 1.0 / W * s, 0.1 * s], abs=1e-3)
    check_that_it_shows_where_they_are(scene, R)


def test_the_handouts_two_bobs_hit(without_swings):
    scene = scene_of("handle_two_bobs", hang(omega=4.0), hang(axle=(R / 5, 0, 0)), R)
    assert play(scene, DT) == [(DT, 0, 1)]
    assert [pend["omega"] for pend in scene.pend_list] == pytest.approx([0.0, 4.0], abs=0.01)


# --- rows ------------------------------------------------------------------------------------------------------------


def test_a_row_swings_by_full_swing_update_alone(monkeypatch):
    """The scene ignores its return value: it is no list of hits."""

    def full_swing_update(*arguments):
        calls.append(arguments[1:])
        original(*arguments)
        return arguments[0]

    original, calls = swinging.full_swing_update, []
    monkeypatch.setattr(swinging, "full_swing_update", full_swing_update)
    scene = scene_of("full_swing_update", row(2, theta=0.3), R, 0.1, 5.0)
    assert play(scene, 100 * DT) == []
    assert calls == [(R, DT, 5.0)] * 100
    assert scene.thetas()[1] < 0.3


@pytest.mark.parametrize("by_name", [False, True])
def test_a_row_ticks_by_newton_cradle_tick_alone_and_tells_of_hits(monkeypatch, by_name):
    """It may call handle_two_bobs in any way, and gets its return value."""

    def newton_cradle_tick(pend_list, r_param, dt, g):
        calls.append((r_param, dt, g))
        for left in (1, 0):
            pair = {"pend1": pend_list[left], "pend2": pend_list[left + 1], "r_param": r_param}
            handle = visualize_cradle_run.handle_two_bobs
            returned.append(handle(**pair) if by_name else handle(*pair.values()))

    def handle_two_bobs(pend1, pend2, r_param):
        pend1["omega"], pend2["omega"] = pend2["omega"], pend1["omega"]
        return "swapped"

    calls, returned = [], []
    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", newton_cradle_tick)
    monkeypatch.setattr(visualize_cradle_run, "handle_two_bobs", handle_two_bobs)
    pend_list = row(3)
    pend_list[2]["omega"] = -3.0
    scene = scene_of("newton_cradle_tick", pend_list, R, 0.1, 5.0)
    assert play(scene, DT) == [(DT, 1, 2), (DT, 0, 1)]
    assert play(scene, DT) == [(DT, 0, 1)]  # the two others are at rest
    assert calls == [(R, DT, 5.0)] * 2
    assert returned == ["swapped"] * 4
    assert visualize_cradle_run.handle_two_bobs is handle_two_bobs


# --- one pendulum ----------------------------------------------------------------------------------------------------


def test_one_pendulum_swings_by_angle_update(monkeypatch):
    monkeypatch.setattr(swinging, "angle_update", lambda omega, theta, *_: (omega, theta + 0.01))
    scene = scene_of("angle_update", 2.0, 0.3, R, 0.1, G)
    assert play(scene, 10 * DT) == []
    assert scene.thetas() == pytest.approx([0.4])


@pytest.mark.parametrize("masses", [(), (0.5, 3.0), (3.0, 0.5)])
def test_a_double_pendulum_of_any_masses_keeps_its_energy(masses):
    scene = scene_of("double_angle_update", 0.5, -0.2, 1.2, 0.6, R, 1e-3, G, *masses)
    kinetic, potential = scene.energies()
    play(scene, 0.3)
    assert sum(scene.energies()) == pytest.approx(kinetic + potential, rel=1e-6)
    assert scene.energies()[0] > 2 * kinetic


# --- made pendula ----------------------------------------------------------------------------------------------------


def test_the_picture_has_room_for_cords_that_are_too_long(monkeypatch, tmp_path):
    """The cords are too long if theta and r_param are exchanged: here, theta is three times r_param, or 0."""

    def exchanged(axle, r_param, theta, *looks):
        return make_pendulum(axle, theta, r_param, *looks)

    monkeypatch.setattr(special_cradles, "make_pendulum", exchanged)
    (tmp_path / "mixed.csv").write_text(MIXED_CSV)
    scene = scene_of("make_newton_cradle", str(tmp_path / "mixed.csv"), 0.2, 0.6)
    assert scene.tick is None
    assert scene.reach == pytest.approx(0.6)
    assert mag(scene.bobs()[0].pos - scene.axles()[0].pos) == pytest.approx(0.6)
    assert "".join(TextPicture().lines(scene, 80, 20)).count("O") == 3


# --- the program -----------------------------------------------------------------------------------------------------


def say(scene, seconds):
    print(f"playing {scene.thetas()} for {seconds} s")


def draw(scene, _):
    scene.tick()
    print(*TextPicture().lines(scene, 80, 20))


@pytest.fixture
def main(monkeypatch, capsys):
    """A function that watches test_angle_update with this outcome; it returns status, stdout and stderr."""
    signals: list = []

    def main(outcome, play=say):
        monkeypatch.setattr("sys.argv", ["watch.py", "test_angle_update", "--seconds", "3"])
        monkeypatch.setattr(watch.Grading, "judge", lambda *_: outcome)
        monkeypatch.setattr(watch, "play", play)
        monkeypatch.setattr(watch, "stop_on_signals", lambda: signals.append("stop"))
        try:
            watch.main()
        except SystemExit as ended:
            status, words = (1, f"{ended.code}\n") if isinstance(ended.code, str) else (ended.code, "")
            out, err = capsys.readouterr()
            return status, out, err + words
        finally:
            assert signals == ["stop"] * bool(outcome.call)
        return 0, *capsys.readouterr()

    return main


CALL = Call("angle_update", (2.0, 0.3, R, 0.1, G))


@pytest.mark.parametrize(
    ("outcome", "told"),
    [
        (Outcome(FAILED, "It is wrong.", CALL), (0, "It is wrong.\nplaying [0.3] for 3.0 s\n", "")),
        (Outcome(PASSED, "", CALL), (0, "test_angle_update passes.\nplaying [0.3] for 3.0 s\n", "")),
        (Outcome(PASSED), (0, "test_angle_update passes.\nThere is nothing to watch.\n", "")),
        (Outcome(FAILED, "It is wrong."), (1, "It is wrong.\n", "There is nothing to watch.\n")),
    ],
)
def test_a_check_is_played_whether_it_passes_or_fails(main, outcome, told):
    assert main(outcome) == told


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (Call("full_swing_update", ([], R, 0.1, G)), "ValueError: the cradle has no pendulum"),
        (Call("handle_collision", (1, "4", 0.0, 1.0, 1.0, R)), "TypeError: bad operand type for unary -: 'str'"),
    ],
)
def test_a_scene_that_cannot_be_made_is_told_in_one_line(main, call, words):
    assert main(Outcome(FAILED, "It is wrong.", call)) == (1, "It is wrong.\n", f"It cannot be played: {words}\n")


@pytest.mark.parametrize(
    ("place", "kind"),
    [
        ((2.0, float("nan")), "ValueError"),
        ((2.0, float("inf")), "ValueError"),
        ((2.0, "0.3"), "TypeError"),
        (None, "TypeError"),
    ],
)
def test_so_is_one_that_cannot_go_on(main, monkeypatch, place, kind):
    monkeypatch.setattr(swinging, "angle_update", lambda *_: place)
    status, out, err = main(Outcome(FAILED, "It is wrong.", CALL), draw)
    assert (status, out) == (1, "It is wrong.\n")
    assert err.count("\n") == 1
    assert err.startswith(f"It cannot be played: {kind}: ")


@pytest.mark.parametrize(
    ("error", "status", "line"),
    [
        (KeyboardInterrupt(131), 131, ""),
        (OSError(28, "No space left on device"), 2, "The output: No space left on device\n"),
        (BrokenPipeError(), 0, ""),
    ],
)
def test_it_ends_with_one_line_at_most_if_it_is_stopped_or_its_output_fails(main, error, status, line):
    def stop(*_):
        raise error

    assert main(Outcome(FAILED, "It is wrong.", CALL), stop) == (status, "It is wrong.\n", line)
