"""The list of impacts: it joins single contacts to trains."""

import pytest

from support.playback.impacts import GAP, ImpactTrains

TICK = 1e-4  # s


def lines(contacts, rightwards=True, count=5):
    """Return the strip after these contacts (index of the left bob), one per tick, from t = 0.71 s on."""
    trains = ImpactTrains(count)
    for tick, left in enumerate(contacts):
        trains.add(0.71 + tick * TICK, left, left + 1, rightwards)
    return trains.lines()


@pytest.mark.parametrize(
    ("contacts", "rightwards", "train"),
    [
        ([0], True, "1-2"),
        ([0, 1, 2, 3], True, "1-2-3-4-5"),
        ([3, 2, 1, 0], False, "5-4-3-2-1"),
        ([1, 0, 2, 1, 3, 2], True, "2-3-4-5  1-2-3-4"),  # two bobs come in from the left, two go out
        ([2, 3, 1, 2, 0, 1], False, "4-3-2-1  5-4-3-2"),
        ([2, 1, 3, 0, 2, 1], True, "3-4-5  2-3-4  1-2-3"),
        ([0, 3], True, "1-2  4-5"),
        ([0, 0, 0, 0], True, "1-2"),  # two bobs that touch for a moment
        (range(8), True, "1-2-3-4-5-6-7-8-9"),
        (range(9), True, "1-2-3-...-10"),
        ([0, 1, 2, 3] * 15, True, "1-2-3-4-5  1-2-3-4-5  1-2-3-4..."),
        ([0, 1, 2, 3] * 1000, True, "1 to 5 stay together"),
        ([0] * 1000, True, "1 and 2 stay together"),
        ([0, 3, 1] * 1000, True, "1 to 3, 4 and 5 stay together"),
        ([0] + [1, 2] * 1000, True, "2 to 4 stay together"),
    ],
)
def test_a_train_is_written_in_the_order_of_the_hits(contacts, rightwards, train):
    assert lines(contacts, rightwards) == [f"t = 0.71 s  {train}"]


@pytest.mark.parametrize("middle", [1, 2])
def test_two_hits_run_through_each_other(middle):
    """The first and the last bob come in; the hits meet between the bobs 2 and 3, or one place further on."""
    trains = ImpactTrains(5)
    there, back = [0, 1, 2, 3][: middle + 1], [3, 2, 1, 0][: 3 - middle]
    contacts = [*((left, True) for left in there[:-1]), *((left, False) for left in back), (middle, True)]
    contacts += [(left, True) for left in range(middle - 1, -1, -1)] + [(left, True) for left in range(middle + 1, 4)]
    for tick, (left, rightwards) in enumerate(contacts):
        trains.add(tick * TICK, left, left + 1, rightwards)
    assert trains.lines() == ["t = 0.00 s  1-2-3-4-5  5-4-3-2-1"]


def test_contacts_further_apart_are_trains_of_their_own_the_latest_first():
    trains = ImpactTrains(2)
    for number in range(4):
        trains.add(number * 2 * GAP, number, number + 1, True)
    assert trains.lines() == ["t = 0.03 s  4-5", "t = 0.02 s  3-4"]


def test_a_train_goes_on_as_long_as_its_contacts_follow_one_another():
    trains = ImpactTrains(5)
    for number in range(4):
        trains.add(number * 0.9 * GAP, number, number + 1, True)
    assert trains.lines() == ["t = 0.00 s  1-2-3-4-5"]


def test_a_hit_may_go_past_a_neighbour():
    """In a double cradle: from the first pendulum to the third one, and on from there."""
    trains = ImpactTrains(5)
    trains.add(0.0, 0, 2, True)
    trains.add(TICK, 2, 3, True)
    trains.add(2 * TICK, 2, 4, True)
    assert trains.lines() == ["t = 0.00 s  1-3-4  3-5"]


def strip(*hits):
    """Return the strip after hits that are 0.1 s apart; each has the contacts of one train."""
    trains = ImpactTrains(5)
    for number, contacts in enumerate(hits):
        for tick, left in enumerate(contacts):
            trains.add(0.1 * number + tick * TICK, left, left + 1, True)
    return trains.lines()


def test_single_hits_after_a_train_are_summed_up():
    assert strip([0, 1], [0], [2], [1], [0, 3], [0, 1, 2]) == [
        "t = 0.50 s  1-2-3-4",
        "t = 0.10 s  5 single hits",
        "t = 0.00 s  1-2-3",
    ]


def test_the_hits_of_many_lifted_bobs_are_a_train():
    """Half of a hundred bobs: the two in the middle hit fifty times."""
    lifted = range(50)
    contacts = [bob + hit for bob in reversed(lifted) for hit in lifted]
    assert contacts.count(49) == 50
    assert lines(contacts)[0].startswith("t = 0.71 s  50-51-52-...-100")


def test_the_latest_hit_is_shown_as_long_as_it_may_become_a_train():
    assert strip([0, 1], [0], [2], [1])[:2] == ["t = 0.30 s  2-3", "t = 0.10 s  2 single hits"]


def test_a_single_hit_between_trains_is_shown():
    assert strip([0, 1], [2], [0, 1]) == ["t = 0.20 s  1-2-3", "t = 0.10 s  3-4", "t = 0.00 s  1-2-3"]


def test_two_pendula_have_no_trains_so_each_hit_is_shown():
    assert strip([0], [0], [0]) == ["t = 0.20 s  1-2", "t = 0.10 s  1-2", "t = 0.00 s  1-2"]


def test_bobs_that_stay_together_from_swing_to_swing_take_one_line():
    """So do those that join them; a train or a single hit begins a new line."""
    lie = [0, 1] * 100
    assert strip([0, 1], lie, [*lie, *[2] * 100], lie) == ["t = 0.10 s  1 to 4 stay together", "t = 0.00 s  1-2-3"]
    assert strip(lie, [0], lie) == [
        "t = 0.20 s  1 to 3 stay together",
        "t = 0.10 s  1-2",
        "t = 0.00 s  1 to 3 stay together",
    ]


def test_which_bobs_stay_together():
    lie = [0, 1] * 100
    assert strip(lie, [3] * 21) == ["t = 0.00 s  1 to 3, 4 and 5 stay together"]
    assert strip(*[[*lie, 3]] * 25) == [
        "t = 0.00 s  1 to 3 stay together"
    ]  # a hit in each swing is no staying together
    assert strip([0, 1], [0] * 100, [0], [0], [0])[1:3] == [
        "t = 0.20 s  2 single hits",
        "t = 0.10 s  1 and 2 stay together",
    ]


def test_what_is_summed_up_pushes_no_train_out():
    assert strip([0, 1], *[[0]] * 20, [0, 1, 2], *[[1]] * 20)[-1] == "t = 0.00 s  1-2-3"


def test_clear_forgets_all():
    trains = ImpactTrains(5)
    for left in (0, 1):
        trains.add(1.0, left, left + 1, True)
    trains.clear()
    assert trains.lines() == []
    for time in (1.0, 2.0, 3.0):
        trains.add(time, 0, 1, True)
    assert len(trains.lines()) == 3  # there is no train before these hits any more


def test_bobs_that_touch_for_ever_take_no_more_memory():
    trains = ImpactTrains(5)
    for tick in range(10_000):
        trains.add(tick * TICK, tick % 4, tick % 4 + 1, True)
    assert sum(len(run) for run in trains.trains[0].runs) < 100
