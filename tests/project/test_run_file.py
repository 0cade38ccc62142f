"""A run as one HTML file: its film, what is in it, and how it plays without a program."""

import asyncio
import base64
import csv
import gzip
import html
import json
import re
import socket
from math import degrees, radians, sin
from threading import Event

import pytest
from pages import (
    axle,
    bob_angles,
    new_page,
    pixel,
    press,
    readout,
    saved,
    wait_for_angles,
    wait_for_cradle,
)
from programs import PROGRAM, python, result_of, ROOT, with_vpython

from support.constants import R_PARAM
from support.page.film_recorder import NoTabs
from support.page.server.film import KEPT, LONGEST_PAUSE
from support.page.server.run_file import CURVES
from support.page.server.site import RUN_FILE, Site

OPTIONS = "--seconds", "1", "--e", "0.9"
ADDRESS = "http://course.example/"
# The modules of a run have addresses that begin with data:.
STRICT = "default-src 'self' 'unsafe-inline'; script-src 'unsafe-inline' data:"


@pytest.fixture
def tabs():
    """Tabs whose film has the time that a test sets."""
    return NoTabs()


def show(tabs, now, **state):
    tabs.now = now
    tabs.deliver(state, {})


def seen(tabs):
    """Return the time of each picture of the film, and the value of x in it."""
    found = []
    for picture in tabs.film.pictures:
        found.append((round(picture.time, 6), picture.changes["state"].get("x")))
    return found


def test_a_film_has_thirty_pictures_a_second_and_the_last_one_but_three_seconds_of_a_pause(tabs):
    for number in range(7):
        show(tabs, number / 60, x=number)
    assert [x for _, x in seen(tabs)] == [0, 2, 4, 6]
    show(tabs, 6.2 / 60, x=7)
    tabs.film.take(tabs.all, at_once=True)
    assert seen(tabs)[-1] == (round(6.2 / 60, 6), 7)
    tabs.film.take(tabs.all, at_once=True)
    assert len(seen(tabs)) == 5  # nothing has changed
    show(tabs, 600, x=8)
    assert seen(tabs)[-1] == (round(6.2 / 60 + LONGEST_PAUSE, 6), 8)


def test_the_film_of_a_page_begins_with_a_whole_picture_and_keeps_the_end_of_a_long_run(tabs):
    tabs.film.kept = KEPT
    show(tabs, 0, x="old", y="never again")
    for now in range(1, 100):
        show(tabs, now, x=now)
    first, *_, last = tabs.film.pictures
    assert last.time - first.time == KEPT
    assert first.changes["state"] == {"x": first.time, "y": "never again"}


def test_the_film_of_a_file_keeps_the_start_of_the_present_run(tabs):
    show(tabs, -1, x="old")
    tabs.begin_run()
    for now in range(100):
        show(tabs, now, x=now)
    assert len(seen(tabs)) == 100


# --- the file --------------------------------------------------------------------------------


def write_run(program):
    """Write a run of a program to a file next to its CSV; return the process, and the file."""
    file = program.parents[1] / "run.html"
    return python(program, "--html", file, *OPTIONS), file


@pytest.fixture(scope="module")
def run_file(file):
    done, run = write_run(file.parent / "src" / PROGRAM.name)
    assert (done.returncode, done.stdout, done.stderr) == (0, f"1 s are in {run}\n", "")
    return run


def pictures_in(file):
    """Return the pictures of a run as text."""
    packed = re.search('class="run">(.*?)</script>', file.read_text(encoding="utf-8"))[1]
    return gzip.decompress(base64.b64decode(packed)).decode()


@with_vpython
def test_a_file_has_the_licences_and_no_name_of_this_machine(run_file):
    text = run_file.read_text(encoding="utf-8")
    for licence in ("jquery.org/license", "glowscript for source code and copyright", "John Coady"):
        assert licence in text
    for name in (str(run_file.parent), str(ROOT), "newton_cradle_pends"):
        assert name not in text + pictures_in(run_file)
    assert not re.search(rf"\b{re.escape(socket.gethostname())}\b", pictures_in(run_file))
    assert 29 < len(json.loads(pictures_in(run_file))) <= 31
    assert pictures_in(run_file).count('"curves":{') < 1 / CURVES + 2  # the largest part
    assert len(text) < 1_200_000  # bytes


def test_the_server_goes_on_while_a_run_is_made(monkeypatch):
    """A long run takes seconds."""
    has_gone_on = Event()

    def make(pictures):
        return b"a run" if has_gone_on.wait(10) else b"too late"

    async def ask_for_a_run():
        asyncio.get_running_loop().call_soon(has_gone_on.set)
        return await site.response_to(RUN_FILE, {"key": [site.key]})

    monkeypatch.setattr("support.page.server.run_file.run_as_html", make)
    monkeypatch.setattr("support.page.server.site.keyless_files", dict)
    site = Site({}, None, lambda: ["a picture"])
    assert result_of(ask_for_a_run()).content == b"a run"


@with_vpython
def test_a_run_that_fails_is_written_up_to_the_mistake_and_names_it(program):
    line = "    momentum = m1"
    text = program.read_text()
    program.write_text(text.replace(line, f"    open(__file__ + '.no')\n{line}"))
    done, file = write_run(program)
    assert done.returncode == 1
    ended = json.loads(pictures_in(file))[-1]["state"]["ended"]
    place = r"\(src/visualize_cradle_run\.py, line \d+: open\(.*\)"
    assert re.fullmatch(f"FileNotFoundError: .* {place}", ended)
    assert str(file.parent) not in ended


# --- in a browser ----------------------------------------------------------------------------


@pytest.fixture
def opened(page, run_file):
    """The run in a tab, which has played it to its end; it asks for nothing but its file."""
    errors = []
    addresses = []
    page.on("pageerror", lambda error: errors.append(error))
    page.on("request", lambda request: addresses.append(request.url))
    page.goto(run_file.as_uri())
    wait_for_cradle(page)
    page.wait_for_function("isOver()")
    yield page
    assert errors == []
    assert {url for url in addresses if not url.startswith("data:")} <= {run_file.as_uri(), ADDRESS}


def test_a_run_plays_by_itself_and_shows_what_the_program_computes(opened):
    rows = python(
        ROOT / "src" / "text_cradle_run.py", "--record", "-", *OPTIONS
    ).stdout.splitlines()
    *_, last = csv.DictReader(rows)
    thetas = [degrees(float(last[f"theta_{bob}"])) for bob in range(1, 6)]
    assert bob_angles(opened) == pytest.approx(thetas, abs=0.01)
    assert readout(opened, "t") == float(last["t"])
    assert opened.locator(".plot canvas").count() > 0
    buttons = opened.locator("button:visible").all_inner_texts()
    assert buttons == ["Run", "Step", "Restart", "Present"]


@pytest.mark.parametrize("page", ["chromium", "firefox"], indirect=True)
def test_a_run_plays_in_a_strict_course_page_without_an_address(page, run_file):
    run = html.escape(run_file.read_text(encoding="utf-8"))
    headers = {"Content-Type": "text/html; charset=utf-8", "Content-Security-Policy": STRICT}
    body = f'<iframe sandbox="allow-scripts" srcdoc="{run}"></iframe>'
    page.route(ADDRESS, lambda route: route.fulfill(body=body, headers=headers))
    page.goto(ADDRESS)
    frame = page.frames[1]
    # A function: the page forbids what Playwright makes of an expression.
    frame.wait_for_function("""() =>
        window.isOver?.() && bobs().filter(bob => bob.ready).length === 5""")


def test_you_step_scrub_turn_and_run_it_again(opened, run_file):
    times = [picture["time"] for picture in json.loads(pictures_in(run_file))]
    assert opened.evaluate("visible('arrow').length") > 0
    opened.locator(".moment").press("Home")
    opened.wait_for_function("() => parseFloat(state.motion.t) === 0")
    assert bob_angles(opened) == pytest.approx([-45, 0, 0, 0, 0], abs=0.01)
    assert opened.evaluate("visible('arrow').length") == 0  # they are made later
    opened.locator(".moment").evaluate("slider => slider.blur()")
    for number in (1, 2):
        opened.keyboard.press("ArrowRight")
        place = float(opened.locator(".moment").input_value())
        assert place == pytest.approx(times[number], abs=0.005)
    x, y = pixel(opened, 1, 0)
    fingers = opened.context.new_cdp_session(opened)
    for kind, place in ("touchStart", x), ("touchMove", x + 30), ("touchMove", x + 60):
        points = [{"x": place, "y": y}]  # on a bob, which nobody drags here
        fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    opened.get_by_role("button", name="Reset view").wait_for()
    press(opened, "Run")
    opened.wait_for_function("isOver()")


@pytest.mark.browser
@with_vpython
def test_homework_asks_what_will_happen_and_what_you_saw_and_explains(chromium, tmp_path):
    """By touch on a phone. It has the ghosts of each answer."""
    file = tmp_path / "run.html"
    experiment = ROOT / "support" / "experiments" / "single" / "02_two_bobs.toml"
    options = "--html", file, "--experiment", experiment, "--seconds", "1.5"
    assert python(PROGRAM, *options).returncode == 0
    with new_page(chromium, has_touch=True) as page:
        page.set_viewport_size({"width": 390, "height": 844})
        page.goto(file.as_uri())
        wait_for_cradle(page)
        assert page.title() == "Newton's cradle: Two bobs"
        question = page.locator(".question")
        page.get_by_role("button", name="Run").tap()
        page.get_by_text("Choose an answer first.").wait_for()
        assert not page.locator(".moment").is_visible()
        question.get_by_role("button", name="A\u2002One bob, twice as fast").tap()
        place = axle(4)[0] + R_PARAM * sin(radians(60))
        page.wait_for_function(f"Math.max(...backdrop('sphere')) > {place}")
        question.get_by_text("What did you see?").wait_for()
        wait_for_angles(page, -45, -45, 0, 0, 0)  # nobody reads the answer off the picture
        page.keyboard.press("e")  # there is no such answer
        question.get_by_role("button", name="Again slowly").tap()
        page.wait_for_function("() => parseFloat(state.motion.t) > 0.1")
        wait_for_angles(page, -45, -45, 0, 0, 0)
        question.get_by_role("button", name="C\u2002Two bobs").tap()
        question.get_by_text("What happened: C, Two bobs, as far as the two.").wait_for()
        page.wait_for_function("isOver()")
        page.get_by_role("button", name="Restart").tap()
        question.get_by_role("button", name="B\u2002One bob, as far as the two").tap()
        question.get_by_text("What did you see?").wait_for()


@with_vpython
def test_all_experiments_are_written_with_an_index(program, tmp_path):
    experiments = program.parents[1] / "support" / "experiments" / "single"
    for experiment in experiments.glob("0[3-9]*"):
        experiment.unlink()
    folder = tmp_path / "all"
    options = "--html-all", folder, "--seconds", "0.02"
    done = python(program, *options)
    count = len([*experiments.iterdir()])
    says = f"0.02 s of each of {count} experiments are in {folder}\n"
    assert (done.returncode, done.stdout, done.stderr) == (0, says, "")
    index = (folder / "index.html").read_text()
    links = re.findall('<a href="(.*?)">(.*?)</a><br>(.*?)</li>', index)
    assert links[1] == (
        "02_two_bobs.html",
        "Two bobs",
        "Two bobs come in. What leaves on the other side?",
    )
    names = [*(link[0] for link in links), "index.html"]
    assert sorted(names) == sorted(path.name for path in folder.iterdir())
    for number, (name, title, _) in enumerate(links):
        run = json.loads(pictures_in(folder / name))
        assert run[0]["state"]["title"] == f"Newton's cradle: {title}", number


def test_the_page_saves_its_run(shared):
    shared.locator(".keep summary").click()
    shared.wait_for_function("() => parseFloat(state.motion.t) > 0.5")
    shared.route("**/run.html*", lambda route: route.fulfill(status=500), times=1)
    press(shared, "Save this run")
    message = shared.get_by_role("alert").get_by_text("so it is not saved")
    message.wait_for()
    name, file = saved(shared, "Save this run")
    assert name == "My cradle.html"
    now = readout(shared, "t")
    assert not message.is_visible()
    key = shared.url.partition("key=")[2]
    assert key not in file.read_text(encoding="utf-8") + pictures_in(file)
    first, *_, last = map(float, re.findall('"t":"([0-9.]+) s', pictures_in(file)))
    assert first == 0
    assert 0.5 <= last <= now
