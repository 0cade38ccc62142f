"""The loop of a program: is_running, or VPython's rate in its place; and bare VPython."""

import pytest

from support import simulation

HEAD = """
from support.simulation import is_running, rate

ticks = 0
rate(1)  # before there is a list
pend_list = [{"objects": ()}]

def tick():
    global ticks
    ticks += 1
    assert ticks < 9
"""
LOOPS = {  # a loop, and its ticks
    "while is_running(pend_list): tick()": 3,
    "while True: rate(1 / 1e-4); tick()": 3,
    "for _ in range(2): rate(100); tick()": 2,
    "while is_running(pend_list): tick(); rate(1)": 3,
    "while True: is_running(pend_list); tick()": 4,  # it does not hear the answer
    """def main():
        pendula = pend_list
        del globals()["pend_list"]
        while True: rate(1); tick()
main()""": 3,
    """while True:
        rate(1)
        tick()
        pend_list = [*map(dict, pend_list)]""": 3,
}


class ThreeTicks:
    """A player that lets a loop do three ticks."""

    def __init__(self):
        self.asked = []  # for these lists

    def is_running(self, pend_list):
        self.asked.append(pend_list)
        return len(self.asked) <= 3


@pytest.mark.parametrize("loop", LOOPS)
def test_each_loop_does_the_ticks_of_its_player_and_then_ends(loop):
    player = ThreeTicks()
    names = {}
    simulation.run(lambda: exec(HEAD + loop, names), player)
    assert names["ticks"] == LOOPS[loop]
    assert all(pend_list == [{"objects": ()}] for pend_list in player.asked)


def test_without_a_player_is_running_says_what_it_needs_and_rate_does_not_wait():
    simulation.rate(1e-9)
    with pytest.raises(RuntimeError, match=r"^is_running needs a program: `import begin_page` "):
        simulation.is_running([])
