"""Speed and accuracy of the programs.

To compare, there are pymunk (a physics engine for games), an exact cradle, and bare VPython.

Run it on Linux, with Chromium and nothing else running: `.venv/bin/python tests/benchmark.py`.
Compare numbers only within one run.
"""

import os
import re
import sys
import tempfile
import time
from functools import partial
from math import atan2, cos, inf, sin
from pathlib import Path
from statistics import median

if __name__ == "__main__":
    root = Path(__file__).resolve().parents[1]
    # So that Python finds the imports below
    sys.path[:0] = str(root), str(root / "tests" / "project")

import pymunk
import vpython
from exact_cradle import apart, exact_outer_angles, outer_angles, SAMPLE
from pages import ARGUMENTS, BOBS, CHROMIUM, draw, open_cradle, readout
from playwright.sync_api import sync_playwright
from programs import first_lines, ROOT, running
from whole_cradles import do_at_once, GOOD, HEADER, make_row

from src.visualize_cradle_run import newton_cradle_tick
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import BUFFER
from support.start.end import ended_quietly
from support.start.options import OneLineParser

# VPython then believes that the page is open: no server, no browser
vpython.baseObj._view_constructed = True

SPAN = 20.0  # s
STEPS = [0.001, 0.0005, 0.0002, 0.0001, 0.00005]  # s, of pymunk


def by_single_ticks(pend_list, seconds, dt) -> None:
    """Advance the cradle by newton_cradle_tick."""
    for _ in range(round(seconds / dt)):
        newton_cradle_tick(pend_list, R_PARAM, dt, G, approaching_only=True)


def by_the_fast_path(pend_list, seconds, dt) -> list[float]:
    """Advance the cradle by many_ticks; return its thetas (rad)."""
    do_at_once(pend_list, R_PARAM, dt, G, round(seconds / dt), approaching_only=True)
    return [pend["theta"] for pend in pend_list]


def our_cradle(dt, count=5, move=by_the_fast_path):
    """Return a function that moves elastic pendula on by seconds, in ticks of dt (s)."""
    return partial(move, make_row(count, THETA_INIT), dt=dt)


def pymunk_cradle(dt, corrected):
    """The same in pymunk, in steps of dt (s).

    With corrected, a step corrects joints wholly, in 20 iterations.
    """
    space = pymunk.Space()
    space.gravity = 0, -G
    space.collision_slop = 0
    axles = [i * R_PARAM / 4 for i in range(5)]
    for x, pend in zip(axles, make_row(5, THETA_INIT), strict=True):
        body = pymunk.Body(mass=1, moment=inf)
        body.position = x + R_PARAM * sin(pend["theta"]), -R_PARAM * cos(pend["theta"])
        bob = pymunk.Circle(body, BUFFER * pend["objects"][1].radius)
        bob.elasticity = 1
        joint = pymunk.PinJoint(space.static_body, body, (x, 0))
        space.add(body, bob, joint)
        if corrected:
            joint.error_bias = 0
            space.iterations = 20

    def move(seconds):
        for _ in range(round(seconds / dt)):
            space.step(dt)
        return [
            atan2(body.position.x - x, -body.position.y)
            for x, body in zip(axles, space.bodies, strict=True)
        ]

    return move


# Name -> (a function that makes a cradle, its steps in s)
ENGINES = {
    "many_ticks": (our_cradle, [DT * times for times in (2, 1, 0.5, 0.2, 0.1)]),
    "pymunk, its own settings": (partial(pymunk_cradle, corrected=False), STEPS),
    "pymunk, joints corrected at once": (partial(pymunk_cradle, corrected=True), STEPS),
}


def cpu_time(make, seconds) -> float:
    """Return the least processor time (s), of three, that a cradle takes for these seconds."""
    times = []
    for _ in range(3):
        move = make()
        start = time.process_time()
        move(seconds)
        times.append(time.process_time() - start)
    return min(times)


def speeds():
    """Yield rows with the ticks a second of single ticks and of the fast path."""
    for count in (5, 50, 500):
        few, many = 50_000 // count, 1_000_000 // count  # ticks
        single = cpu_time(partial(our_cradle, DT, count, by_single_ticks), few * DT) / few
        fast = cpu_time(partial(our_cradle, DT, count), many * DT) / many
        per_second = f"{1 / single:,.0f}", f"{1 / fast:,.0f}"
        yield count, *per_second, f"{single / fast:.1f}", f"{1e6 * fast / count:.3f}"


def places(exact):
    """Yield rows with how far the outer bobs are from the exact ones."""
    for engine, (make, steps) in ENGINES.items():
        for dt in steps:
            spent = cpu_time(partial(make, dt), SPAN)
            off = apart(exact, outer_angles(make(dt), SPAN))
            yield engine, f"{1000 * dt:g}", f"{spent:.3f}", f"{off:.2f}"


def draw_places(rows, file) -> None:
    """Draw the rows of places into this file, a curve for each engine."""
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 4.5), layout="constrained")
    for engine, mark, place in zip(ENGINES, "os^", [(-32, -12), (6, 4), (6, 4)], strict=True):
        points = [row for row in rows if row[0] == engine]
        _, steps, spent, off = zip(*points, strict=True)
        times, angles = [float(text) for text in spent], [float(text) for text in off]
        axes.loglog(times, angles, marker=mark, label=engine)
        for step, point in zip(steps, zip(times, angles, strict=True), strict=True):
            axes.annotate(f"{step} ms", point, xytext=place, textcoords="offset points", fontsize=8)
    axes.margins(x=0.1)
    axes.set(xlabel="processor time for 20 s (s)", ylabel="the outer bobs are off by (degrees)")
    axes.xaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.legend()
    figure.savefig(file, dpi=120)


def pages(browser):
    """Yield rows with the costs of the page, while the browser draws it and while it does not."""
    for count in (5, 50, 100, 200):
        with tempfile.TemporaryDirectory() as folder:
            (csv := Path(folder, "cradle.csv")).write_text(HEADER + GOOD * count)
            with (
                running(None, str(csv)) as process,
                browser.new_page(viewport={"width": 1366, "height": 768}) as page,
            ):
                open_cradle(page, first_lines(process), count, drawn=True)
                yield count, *rates(process, page, drawn=True), *rates(process, page, drawn=False)


def rates(process, page, drawn) -> list[str]:
    """Return the processor time (s) and the simulated time (s) of a program in a second."""
    draw(page, drawn)
    looks = []
    for wait in (3, 8):  # s
        time.sleep(wait)
        # The user's and the system's
        ticks = map(int, Path(f"/proc/{process.pid}/stat").read_text().split()[13:15])
        looks.append(
            (time.perf_counter(), sum(ticks) / os.sysconf("SC_CLK_TCK"), readout(page, "t"))
        )
    span, *others = (after - before for before, after in zip(*looks, strict=True))
    return [f"{other / span:.2f}" for other in others]


def first_pictures(browser):
    """Yield rows with the seconds until the browser has drawn the first picture of a program."""
    commands = {"bare VPython": ("-c", "from vpython import sphere; sphere()"), "the cradle": ()}
    times = {name: [] for name in commands}
    for name, command in [*commands.items()] * 5:
        start = time.perf_counter()
        with (
            running(*command, VPYTHON_NO_LAUNCH_BROWSER="0", BROWSER="echo %s") as program,
            browser.new_page() as page,
        ):
            page.goto(re.search(r"http:\S+", program.stdout.readline())[0])
            page.wait_for_function(f"() => window.glowObjs && ({BOBS})().length")
            draw(page, True)
            times[name].append(time.perf_counter() - start)
    for name, seconds in times.items():
        yield name, f"{min(seconds):.2f}", f"{median(seconds):.2f}"


def run_files(browser):
    """Yield rows of a run of 30 s as one HTML file: its size, the seconds to write and open it."""
    for name in ("visualize_cradle_run", "visualize_double_cradle_run"):
        with tempfile.TemporaryDirectory() as folder, browser.new_page() as page:
            file = Path(folder, "run.html")
            start = time.perf_counter()
            with running(
                ROOT / f"src/{name}.py", "--html", str(file), "--seconds", "30"
            ) as program:
                program.wait()
            written = time.perf_counter()
            page.goto(file.as_uri())
            page.wait_for_function(f"() => window.glowObjs && ({BOBS})().length")
            draw(page, True)
            opened = time.perf_counter()
            size = file.stat().st_size / 1e6
            yield name, f"{size:.2f}", f"{written - start:.1f}", f"{opened - written:.2f}"


def show(title, head, rows) -> None:
    """Print a table in Markdown."""
    print(f"\n{title}\n\n| {' | '.join(head)} |\n{'| --- ' * len(head)}|")
    for row in rows:
        print(f"| {' | '.join(map(str, row))} |", flush=True)


@ended_quietly()
def main() -> None:
    """Print all measurements."""
    parser = OneLineParser(
        description="Measure the speed and the accuracy of the programs.", allow_abbrev=False
    )
    parser.add_argument(
        "--picture", metavar="FILE", help="also draw where the bobs are; needs matplotlib"
    )
    file = parser.parse_args().picture
    show(
        "Ticks a second",
        ["pendula", "newton_cradle_tick", "many_ticks", "times", "us a swing"],
        speeds(),
    )
    exact = exact_outer_angles(SPAN)
    differs = f"{apart(exact, exact_outer_angles(SPAN, SAMPLE / 2)):.0e}"
    rows = [*places(exact)]
    show(
        f"The outer bobs in {SPAN:g} s. A finer exact cradle differs by {differs} degrees",
        ["engine", "step (ms)", "processor time (s)", "off by (degrees)"],
        rows,
    )
    if file:
        draw_places(rows, file)
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        head = [
            "pendula",
            "share of a core",
            "simulated s in 1 s",
            "share, nothing drawn",
            "simulated, nothing drawn",
        ]
        show("The page", head, pages(browser))
        show(
            "Seconds to the first picture", ["program", "least", "median"], first_pictures(browser)
        )
        head = ["program", "MB", "s to write it", "s until it is drawn"]
        show("A run of 30 s as an HTML file", head, run_files(browser))


if __name__ == "__main__":
    main()
