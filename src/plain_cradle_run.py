"""The handout's program, on VPython's own page: it needs nothing of support/page."""

if __name__ == "__main__":
    import begin

from vpython import rate

from src.special_cradles import make_newton_cradle
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import DT, G, NC_FP, R_PARAM, THETA_INIT

if __name__ == "__main__":
    pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
    while True:
        rate(1 / DT)  # ticks a second: real time
        newton_cradle_tick(pend_list, R_PARAM, DT, G)
