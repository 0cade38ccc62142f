"""advance_cradle: many ticks at once, and the contacts on the way."""

import pytest
from cradles import components, hang, R, row

from src.visualize_cradle_run import advance_cradle, newton_cradle_tick
from support.constants import DT, G


@pytest.mark.parametrize("approaching_only", [False, True])
@pytest.mark.parametrize("ticks", [0, 1, 3000])
def test_it_does_what_so_many_ticks_do(ticks, approaching_only):
    """In 3,000 ticks from this angle there are several hits."""
    at_once, one_by_one = row(4, e=0.9), row(4, e=0.9)
    at_once[0]["theta"] = one_by_one[0]["theta"] = -0.2
    advance_cradle(at_once, R, DT, G, ticks, approaching_only)
    for _ in range(ticks):
        newton_cradle_tick(one_by_one, R, DT, G, approaching_only)
    for pend, same in zip(at_once, one_by_one, strict=True):
        assert (pend["theta"], pend["omega"]) == (same["theta"], same["omega"])
        assert components(pend["objects"][1].pos) == components(same["objects"][1].pos)


def test_it_tells_of_contacts_in_their_order():
    """The first bob runs through the row; the tick of a contact is the one in which omega changes."""
    pend_list = row(4)
    pend_list[0]["theta"] = -0.2
    contacts = advance_cradle(pend_list, R, DT, G, 4000, approaching_only=True)
    assert [left for _, left in contacts] == [0, 1, 2]
    first = contacts[0][0]
    again = row(4)
    again[0]["theta"] = -0.2
    assert advance_cradle(again, R, DT, G, first, approaching_only=True) == []
    assert advance_cradle(again, R, DT, G, 1, approaching_only=True)[0] == (0, 0)


def test_bobs_that_touch_without_a_change_are_no_contact():
    pair = hang(omega=1.0), hang(omega=1.0, axle=(R / 8, 0, 0))
    assert advance_cradle(list(pair), R, DT, 0, 10) == []
