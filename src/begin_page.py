"""The first import of a program with a page: begin, and VPython that draws for our page."""

import begin
from support.page.vpython_inside import draw_without_its_page

draw_without_its_page()
