"""The functions that the handout provides, and the rooms of the programs: cradle, files, start,
page, terminal.

Words
    contact  a change of two velocities, mostly by a call of handle_two_bobs
    hit      a contact that is noted: who hits whom, at which speed, with the velocities before and after
    fast     of a hit: its speed is at least a tenth of that of the fastest bob
    train    hits that follow each other quickly; it has a line in the list of impacts
    path     bobs of a train that pass a hit on, by their numbers: 1-2-3-4-5
    frame    one picture, with the ticks that come before it
    part     ticks of a frame that are done without a look at the cradle
    lift     the angle of a cord from straight down, positive outwards, away from the other pendula (degrees)
"""


def load_tests(*_) -> None:
    """Say how checks are run: python -m unittest calls this, and finds none of them."""
    from support.start.checks_command import checks_command

    raise SystemExit(f"unittest does not find the checks. Type {checks_command()} to run them.")
