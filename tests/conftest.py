"""What all suites share: they run on the headless stand-in for VPython."""

from support import headless_vpython

headless_vpython.install()
