"""The first import of a program with a page: it runs the program in the page, then ends it."""

import begin
from support.page.vpython_inside import draw_without_its_page

draw_without_its_page()  # before VPython makes its first object
from support.page.show_cradle import show

show()
raise SystemExit  # it has run
