"""The first import of a program with a page: it runs the program in the page, then ends it."""

import sys
from importlib.util import find_spec

import begin

if not find_spec("support.page"):  # the course kit alone
    sys.exit(
        "The page is not in this folder. To see the cradle on VPython's own page, write "
        "`import begin` in place of `import begin_page`, import rate from vpython, and begin the "
        "loop with `while True:` and `rate(1 / DT)`; in the double cradle, `rate(1 / DOUBLE_DT)`."
    )

from support.page.vpython_inside import draw_without_its_page

draw_without_its_page()  # before VPython makes its first object
from support.page.show_cradle import show

show()
raise SystemExit  # it has run
