"""The speed and the accuracy of the cradle, also compared with pymunk, a physics engine for games.

Run it by hand: `.venv/bin/python tests/benchmark.py`. It takes a few minutes. Compare numbers only within one run.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from functools import partial
from itertools import product
from math import cos, inf, sin
from pathlib import Path

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parent))  # so that Python finds grading, also with -P

from grading.project_path import ROOT
from support import headless_vpython

if "--vpython" not in sys.argv:
    headless_vpython.install()

from src import visualize_cradle_run
from src.beyond.many_ticks import many_ticks
from src.special_cradles import make_newton_cradle
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.energy import kinetic_energy, potential_energy
from support.start.options import OneLineParser
from support.start.output import while_it_is_read

CRADLES = (5, 1), (50, 1), (500, 1), (50, 0)  # number of pendula, and their e
CLING = 3.0  # s; then bobs with e = 0 cling together
MINUTE = 60.0  # s, simulated
SAMPLE = 0.01  # s between two measurements of the energy
TICKS = [DT * times for times in (1, 2, 5, 10, 20)]  # s
STEPS = [1 / 100, 1 / 200, 1 / 500, 1 / 1000, 1 / 2000, 1 / 5000]  # s, of pymunk


def csv_of(count, e=1) -> str:
    """Return the CSV of count equal pendula."""
    return "mass,e,color,texture\n" + f"1,{e},red,metal\n" * count


def cradle_of(count, e=1):
    """Return the pend_list of count equal pendula, the first one lifted; with e = 0, at a time when they cling."""
    with tempfile.TemporaryDirectory() as folder:
        csv = Path(folder, "cradle.csv")
        csv.write_text(csv_of(count, e))
        pend_list = make_newton_cradle(csv, R_PARAM, THETA_INIT)
    if e == 0:
        do_at_once(pend_list, DT, round(CLING / DT))
    return pend_list


def do_at_once(pend_list, dt, ticks) -> None:
    """Do ticks of dt (s) by many_ticks, with the rule of the programs."""
    scope = {**vars(visualize_cradle_run), "DT": dt}
    if many_ticks(scope, pend_list, ticks, {"approaching_only": True}) is None:
        raise ValueError("many_ticks does not know these functions: see tests/project/test_many_ticks.py")


def cpu_time(make, run) -> float:
    """Return the processor time (s) of run(made), with made = make(): the least of five."""
    times = []
    for _ in range(5):
        made, start = make(), time.process_time()
        run(made)
        times.append(time.process_time() - start)
    return min(times)


def energy_error(energy, advance) -> float:
    """Return the largest energy error in a MINUTE, at each SAMPLE, as a part of the energy at the start.

    energy() returns the energy, and advance() moves on by one SAMPLE.
    """
    start, error = energy(), 0.0
    for _ in range(round(MINUTE / SAMPLE)):
        advance()
        error = max(error, abs(energy() / start - 1))
    return error


def show_table(*rows) -> None:
    """Print rows as a table in Markdown; the first row is the head."""
    head, *others = ([str(cell) for cell in row] for row in rows)
    for row in (head, ["---"] * len(head), *others):
        print(f"| {' | '.join(row)} |")
    print(flush=True)


# --- ticks a second --------------------------------------------------------------------------------------------------


def tick_costs() -> list[tuple[float, float]]:
    """Return the time (s) of a tick by newton_cradle_tick and by many_ticks, for each of CRADLES."""
    costs = []
    for count, e in CRADLES:
        ticks, more_ticks = 20_000 // count, 1_000_000 // count

        def one_by_one(pend_list, ticks=ticks):
            for _ in range(ticks):
                newton_cradle_tick(pend_list, R_PARAM, DT, G, approaching_only=True)

        def at_once(pend_list, ticks=more_ticks):
            do_at_once(pend_list, DT, ticks)

        make = partial(cradle_of, count, e)
        costs.append((cpu_time(make, one_by_one) / ticks, cpu_time(make, at_once) / more_ticks))
    return costs


def tick_costs_on_vpython() -> list[tuple[float, float]]:
    """Return tick_costs with VPython's own objects, from this program in another process."""
    done = subprocess.run([sys.executable, __file__, "--vpython"], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def show_ticks() -> None:
    """Print the number of ticks per second."""
    rows = [("pendula", "newton_cradle_tick", "without VPython", "many_ticks", "times", "us a pendulum and tick")]
    for (count, e), (single, at_once), (stub, _) in zip(CRADLES, tick_costs_on_vpython(), tick_costs(), strict=True):
        speeds = (f"{1 / cost:,.0f}" for cost in (single, stub, at_once))
        name = count if e else f"{count}, clinging (e = {e})"
        rows.append((name, *speeds, f"{single / at_once:.1f}", f"{1e6 * at_once / count:.3f}"))
    print("Ticks a second on VPython's objects; times: many_ticks against single ticks.\n")
    show_table(*rows)


# --- a minute of five pendula, and the same in pymunk ----------------------------------------------------------------


def our_minute(dt) -> tuple[float, float]:
    """Return the processor time (s) and the energy error of a minute in ticks of dt (s)."""

    def advance(pend_list, seconds=MINUTE):
        do_at_once(pend_list, dt, round(seconds / dt))

    pend_list = cradle_of(5)
    error = energy_error(
        lambda: kinetic_energy(pend_list, R_PARAM) + potential_energy(pend_list, R_PARAM, G),
        lambda: advance(pend_list, SAMPLE),
    )
    return cpu_time(lambda: cradle_of(5), advance), error


class PymunkCradle:
    """The same five pendula, with circles and pin joints of pymunk."""

    def __init__(self, iterations=10, gap=0.0005, stiff=False, collision_bias=None):
        """iterations refine each step. gap is the distance of bobs at rest (a part of their diameter). stiff joints are
        corrected fully in each step. collision_bias slows the separation of bobs that overlap (None: pymunk's own).
        """
        import pymunk

        self.space = pymunk.Space()
        self.space.gravity = 0, -G
        self.space.iterations, self.space.collision_slop = iterations, 0
        if collision_bias is not None:
            self.space.collision_bias = collision_bias
        for i in range(5):
            theta, x = THETA_INIT if i == 0 else 0, i * R_PARAM / 4
            body = pymunk.Body(mass=1, moment=inf)
            body.position = x + R_PARAM * sin(theta), -R_PARAM * cos(theta)
            bob = pymunk.Circle(body, (1 - gap) * R_PARAM / 8)
            bob.elasticity = 1
            cord = pymunk.PinJoint(self.space.static_body, body, (x, 0))
            if stiff:
                cord.error_bias = 0
            self.space.add(body, bob, cord)

    def energy(self) -> float:
        """Return the kinetic and potential energy (J)."""
        return sum(body.velocity.length**2 / 2 + G * (body.position.y + R_PARAM) for body in self.space.bodies)

    def advance(self, dt, seconds) -> None:
        """Move on by seconds, in steps of dt (s)."""
        for _ in range(round(seconds / dt)):
            self.space.step(dt)


def pymunk_minute(dt, **settings) -> tuple[float, float]:
    """Return the processor time (s) and the energy error of a minute in steps of dt (s)."""
    cradle = PymunkCradle(**settings)
    error = energy_error(cradle.energy, lambda: cradle.advance(dt, SAMPLE))
    return cpu_time(lambda: PymunkCradle(**settings), lambda cradle: cradle.advance(dt, MINUTE)), error


def best_settings(dt) -> dict:
    """Return the settings of pymunk with the least energy error at this step (s)."""
    tried = [
        {"iterations": iterations, "gap": gap, "stiff": stiff, "collision_bias": bias}
        for iterations, gap, stiff, bias in product((2, 5, 10, 30), (0.0005, 0.002, 0.01), (False, True), (None, 1.0))
    ]

    def error(settings):
        cradle = PymunkCradle(**settings)
        return energy_error(cradle.energy, lambda: cradle.advance(dt, SAMPLE))

    return min(tried, key=error)


def show_minutes() -> None:
    """Print and compare processor time and energy error of a minute, ours and pymunk's."""
    ours = [our_minute(dt) for dt in TICKS]
    rows = [("many_ticks, tick", "processor time", "energy error")]
    rows += [(f"{1000 * dt:g} ms", *shown(*minute)) for dt, minute in zip(TICKS, ours, strict=True)]
    print(f"{MINUTE:g} simulated seconds of five pendula. Energy error: the largest at any {SAMPLE:g} s.\n")
    show_table(*rows)

    times, errors = np.log(sorted(ours)).T
    rows = [("pymunk, step", "settings", "processor time", "energy error", "ours in that time", "times less")]
    for dt in STEPS:
        for name, settings in ("its own", {}), ("the best", best_settings(dt)):
            cpu, error = pymunk_minute(dt, **settings)
            # Our error in this time: on a line of the logarithms between two ticks, or that of the smallest tick.
            our_error = np.exp(np.interp(np.log(cpu), times, errors, left=np.nan))
            compared = ("-", "-") if np.isnan(our_error) else (f"{our_error:.2g}", f"{error / our_error:.1f}")
            rows.append((f"{1000 * dt:g} ms", name, *shown(cpu, error), *compared))
    show_table(*rows)


def shown(cpu, error) -> tuple[str, str]:
    """Return a processor time and an energy error as text."""
    return f"{cpu:.3f} s", f"{error:.2g}"


# --- the viewer ------------------------------------------------------------------------------------------------------


def viewer_load(program, count, seconds=40) -> tuple[float, float]:
    """Return the part of a core that a program takes with count pendula, and the simulated seconds per second.

    Chromium draws the page on the same machine.
    """
    from playwright.sync_api import sync_playwright
    from project.programs import ARGUMENTS, CHROMIUM, first_lines, running

    def measure():  # processor time, simulated time, time (s)
        user, system = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[11:13]
        simulated = page.locator(".readout").inner_text().split()[2]
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK"), float(simulated), time.monotonic()

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        Path(folder, "cradle.csv").write_text(csv_of(count))
        with running(program, str(Path(folder, "cradle.csv"))) as process:
            browser = driver.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
            page = browser.new_page(viewport={"width": 1000, "height": 840})
            page.goto(first_lines(process))
            page.wait_for_function("() => $('.readout').length")
            time.sleep(10)  # then it runs evenly
            before = measure()
            time.sleep(seconds)
            cpu, simulated, passed = (end - start for end, start in zip(measure(), before, strict=True))
            browser.close()
    return cpu / passed, simulated / passed


def show_viewer(plain) -> None:
    """Print the load of the viewer, with the fast path, and without it in the project plain."""
    rows = [("pendula", "of a core", "simulated seconds in one", "single ticks: of a core", "simulated seconds in one")]
    for count in (5, 50, 100):
        loads = [viewer_load(root / "src" / "visualize_cradle_run.py", count) for root in (ROOT, plain)]
        rows.append((str(count), *(text for load, pace in loads for text in (f"{load:.1%}", f"{pace:.2f}"))))
    for count in (5, 10):
        load, pace = viewer_load(ROOT / "src" / "visualize_double_cradle_run.py", count)
        rows.append((f"{count} double", "", "", f"{load:.1%}", f"{pace:.2f}"))
    print("The viewer, VPython's serving included, in Chromium.\n")
    show_table(*rows)


def show_recording(plain) -> None:
    """Print the time to record a minute, with the fast path, and without it in the project plain."""
    rows = [("pendula", "--record of a minute", "by single ticks")]
    for count in (5, 100):
        times = []
        for root in (ROOT, plain):
            with tempfile.TemporaryDirectory() as folder:
                Path(folder, "cradle.csv").write_text(csv_of(count))
                options = ["cradle.csv", "--record", "data.csv", "--seconds", f"{MINUTE:g}"]
                before = os.times()
                command = [sys.executable, str(root / "src" / "text_cradle_run.py"), *options]
                subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, check=True)
                times.append(os.times().children_user - before.children_user)
        rows.append((str(count), *(f"{time:.1f} s" for time in times)))
    print("Processor time.\n")
    show_table(*rows)


def project_without_fast_path(folder) -> Path:
    """Copy the project to this folder, with one more line without effect in the tick; return the copy."""
    from project.programs import copy_project

    project = copy_project(Path(folder), csv_of(5))
    file = project / "src" / "visualize_cradle_run.py"
    line = "    full_swing_update(pend_list, r_param, dt, g)\n"
    file.write_text(file.read_text().replace(line, f"    pass\n{line}"))
    return project


@while_it_is_read()
def main() -> None:
    """Print all measurements, or those that another process makes for them."""
    parser = OneLineParser(description="Measure the speed and the accuracy of the cradle.", allow_abbrev=False)
    text = "measure only the ticks on VPython's objects, and print the numbers as JSON"
    parser.add_argument("--vpython", action="store_true", help=text)
    if parser.parse_args().vpython:
        import vpython

        vpython.baseObj._view_constructed = True  # VPython then believes that the page is open: no server, no browser
        print(json.dumps(tick_costs()))
    else:
        show_ticks()
        show_minutes()
        with tempfile.TemporaryDirectory() as folder:
            plain = project_without_fast_path(folder)
            show_recording(plain)
            show_viewer(plain)


if __name__ == "__main__":
    main()
