"""The double Newton's cradle in the browser: the program to play with."""

# This opens the page. The page then runs this file from its top, once for each new cradle.
if __name__ == "__main__":
    import begin_page

from src.double_cradle import double_cradle_tick, make_double_newton_cradle
from support.constants import DOUBLE_DT, G, NC_FP, PHI_INIT, R_PARAM, THETA_INIT
from support.simulation import is_running

if __name__ == "__main__":
    pend_list = make_double_newton_cradle(NC_FP, R_PARAM, THETA_INIT, PHI_INIT)
    # is_running shows them, and waits until a tick is due.
    while is_running(pend_list):
        double_cradle_tick(pend_list, R_PARAM, DOUBLE_DT, G)
