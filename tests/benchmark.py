"""Three figures of the programs: their speed, their accuracy, and their start.

To compare, there are pymunk (a physics engine for games), an exact cradle, and bare VPython.

Run it on Linux, with Chromium and nothing else running: `.venv/bin/python tests/benchmark.py`.
Compare numbers only within one run.
"""

import re
import sys
import time
from functools import partial
from math import atan2, cos, inf, sin
from pathlib import Path
from statistics import median

if __name__ == "__main__":
    # So that Python finds the imports below
    tests = Path(__file__).resolve().parent
    rooms = [tests / "project" / room for room in (".", "cradle", "page")]
    sys.path[:0] = map(str, [tests.parent, *rooms])

import pymunk
import vpython
from exact_cradle import apart, exact_outer_angles, outer_angles
from pages import ARGUMENTS, CHROMIUM, draw
from programs import running
from whole_cradles import advance, do_ticks, make_row

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import BUFFER
from support.start.end import ended_quietly
from support.start.options import OneLineParser

STEPS = [0.001, 0.0005, 0.0002, 0.0001, 0.00005]  # s, of pymunk


def our_cradle(dt, count=5):
    """Return a function that moves elastic pendula on by seconds, in ticks of dt (s)."""
    return partial(advance, make_row(count, THETA_INIT), dt=dt)


def slow_cradle(count):
    """The same in single ticks of DT, as the programs do them for a changed function."""
    pend_list = make_row(count, THETA_INIT)
    return lambda seconds: do_ticks(pend_list, False, R_PARAM, DT, G, round(seconds / DT))


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


def ticks(counts=(5, 500), swings=1_000_000) -> None:
    """Print the ticks a second of cradles with these counts of pendula.

    The fast path computes this many swings of one pendulum, and single ticks a twentieth of them.
    """
    rows = []
    for count in counts:
        many = swings // count  # ticks
        few = many // 20
        fast = cpu_time(partial(our_cradle, DT, count), many * DT) / many
        single = cpu_time(partial(slow_cradle, count), few * DT) / few
        rows.append([count, f"{1 / single:,.0f}", f"{1 / fast:,.0f}", f"{single / fast:.1f}"])
    show("Ticks a second", ["pendula", "newton_cradle_tick", "many_ticks", "times"], rows)


def errors(seconds=20.0, picture=None) -> None:
    """Print how far the outer bobs are from the exact ones, and draw it into this file."""
    exact = exact_outer_angles(seconds)
    rows = []
    for engine, (make, steps) in ENGINES.items():
        for dt in steps:
            spent = cpu_time(partial(make, dt), seconds)
            off = apart(exact, outer_angles(make(dt), seconds))
            rows.append([engine, f"{1000 * dt:g}", f"{spent:.3f}", f"{off:.2f}"])
    head = ["engine", "step (ms)", "processor time (s)", "off by (degrees)"]
    show(f"The outer bobs in {seconds:g} s", head, rows)
    if picture:
        draw_errors(rows, picture)


def draw_errors(rows, file) -> None:
    """Draw the rows of errors into this file, a curve for each engine."""
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 4.5), layout="constrained")
    for engine in ENGINES:
        times, angles = [], []
        for name, step, spent, off in rows:
            if name == engine:
                times.append(float(spent))
                angles.append(float(off))
                axes.annotate(f" {step} ms", (times[-1], angles[-1]), fontsize=8)
        axes.loglog(times, angles, marker="o", label=engine)
    axes.margins(x=0.1)
    axes.set(xlabel="processor time for 20 s (s)", ylabel="the outer bobs are off by (degrees)")
    axes.xaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.legend()
    figure.savefig(file, dpi=120)


def first_pictures(browser, times=5) -> None:
    """Print the seconds from the start of a program to its first picture, started this often."""
    commands = {"bare VPython": ("-c", "from vpython import sphere; sphere()"), "the cradle": ()}
    found = {name: [] for name in commands}
    for name, command in [*commands.items()] * times:
        start = time.perf_counter()
        starting = running(*command, VPYTHON_NO_LAUNCH_BROWSER="0", BROWSER="echo %s")
        with starting as process, browser.new_page() as page:
            page.goto(re.search(r"http:\S+", process.stdout.readline())[0])
            is_bob = "shape?.constructor.name === 'sphere' && shape.visible"
            page.wait_for_function(f"window.glowObjs?.some(shape => {is_bob})")
            draw(page, True)
            found[name].append(time.perf_counter() - start)
    rows = []
    for name, seconds in found.items():
        rows.append([name, f"{min(seconds):.2f}", f"{median(seconds):.2f}"])
    show("Seconds to the first picture", ["program", "least", "median"], rows)


def show(title, head, rows) -> None:
    """Print a table in Markdown."""
    print(f"\n{title}\n\n| {' | '.join(head)} |\n{'| --- ' * len(head)}|")
    for row in rows:
        print(f"| {' | '.join(map(str, row))} |", flush=True)


@ended_quietly()
def main() -> None:
    """Print all figures."""
    parser = OneLineParser(
        description="Measure the speed and the accuracy of the programs.", allow_abbrev=False
    )
    parser.add_argument(
        "--picture", metavar="FILE", help="also draw where the bobs are; needs matplotlib"
    )
    file = parser.parse_args().picture
    # VPython then believes that the page is open: no server, no browser
    vpython.baseObj._view_constructed = True
    from playwright.sync_api import sync_playwright  # not all who test have it

    ticks()
    errors(picture=file)
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        first_pictures(browser)


if __name__ == "__main__":
    main()
