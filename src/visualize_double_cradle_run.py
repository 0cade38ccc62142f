"""The double Newton's cradle in the browser: the program to play with."""

if __name__ == "__main__":
    import begin_page

from src.double_cradle import double_cradle_tick, make_double_newton_cradle
from support.constants import DOUBLE_DT, G, PHI_INIT, R_PARAM, THETA_INIT
from support.main_page import Page


def main(page: Page) -> None:
    """Make the double cradle, show it, and let it tick until the page stops it.

    page shows the cradle in the browser, and says when to tick. The program calls main again for
    each new cradle.
    """
    pend_list = make_double_newton_cradle(page.csv, R_PARAM, THETA_INIT, PHI_INIT)
    page.show(pend_list)
    while page.is_running():  # in step with the clock, until the page wants another cradle
        double_cradle_tick(pend_list, R_PARAM, DOUBLE_DT, G)


if __name__ == "__main__":
    from src import special_cradles
    from support.page.show_cradle import show_double_cradle

    show_double_cradle(main, special_cradles)
