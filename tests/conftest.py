"""All suites run on the headless stand-in for VPython; a test that needs VPython itself starts a process of its own."""

from support import headless_vpython

headless_vpython.install()
