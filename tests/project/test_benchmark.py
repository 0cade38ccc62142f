"""That each figure of the benchmark comes out, as a table with numbers."""

import sys
from math import isfinite

import benchmark
import pytest
from programs import with_vpython

on_linux = pytest.mark.skipif(sys.platform != "linux", reason="the benchmark is for Linux")
IN_A_BROWSER = pytest.mark.browser, with_vpython, on_linux


@pytest.mark.parametrize(
    ("figure", "small"),
    [
        (benchmark.ticks, {"counts": [5], "swings": 1000}),
        (benchmark.errors, {"seconds": 0.05}),
        pytest.param(benchmark.first_pictures, {"times": 1}, marks=IN_A_BROWSER),
        pytest.param(benchmark.shares, {"counts": [5], "waits": (0, 1)}, marks=IN_A_BROWSER),
        pytest.param(benchmark.saved_run, {"seconds": 1}, marks=IN_A_BROWSER),
    ],
)
def test_each_figure_is_a_table_of_numbers(request, capsys, figure, small):
    if figure in (benchmark.first_pictures, benchmark.shares, benchmark.saved_run):
        small["browser"] = request.getfixturevalue("chromium")
    figure(**small)
    _, title, _, head, line, *rows = capsys.readouterr().out.splitlines()
    columns = head.count(" | ") + 1
    assert title
    assert line == "| --- " * columns + "|"
    assert rows
    for row in rows:
        cells = row.strip("| ").split(" | ")
        assert len(cells) == columns
        for cell in cells[1:]:
            assert isfinite(float(cell.replace(",", "")))
