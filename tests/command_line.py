"""The options of the graded suites, for pytest.

Installed, the project brings them as a plugin of pytest's (pyproject.toml). Without, conftest.py adds them; but where
the FILE of --grade-json is there already, pytest looks for conftest.py beside it, and then does not know the option.
"""

TIERS = ["D", "C", "B", "A", "HONOR"]


def pytest_addoption(parser):
    group = parser.getgroup("graded suites")
    text = "run the graded suite of one tier only: D, C, B, A or honor"
    group.addoption("--tier", type=str.upper, choices=TIERS, metavar="TIER", help=text)
    group.addoption("--grade-json", metavar="FILE", help="write the grade to FILE")
