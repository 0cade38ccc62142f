"""A film as one HTML file: its pictures, what is in it, and how it plays without a program."""

import base64
import csv
import gzip
import html
import json
import re
import socket
from math import degrees

import pages
import pytest
from pages import bob_angles, press, wait_for_angles
from programs import PROGRAM, python, ROOT, wait_until, with_vpython
from students import change

OPTIONS = "--seconds", "1", "--e", "0.9"
ADDRESS = "http://course.example/"
# The modules of a film have addresses that begin with data:.
STRICT = "default-src 'self' 'unsafe-inline'; script-src 'unsafe-inline' data:"


def write_film(program):
    """Write a film of a program to a file next to its CSV; return the process, and the file."""
    file = program.parents[1] / "film.html"
    return python(program, "--html", file, *OPTIONS), file


@pytest.fixture(scope="module")
def film_file(file):
    done, film = write_film(file.parent / "src" / PROGRAM.name)
    assert (done.returncode, done.stdout, done.stderr) == (0, f"1 s are in {film}\n", "")
    return film


def pictures_in(file):
    """Return the pictures of a film as text."""
    packed = re.search('class="film">(.*?)</script>', file.read_text(encoding="utf-8"))[1]
    return gzip.decompress(base64.b64decode(packed)).decode()


@with_vpython
def test_a_file_has_the_licences_and_no_name_of_this_machine(film_file):
    text = film_file.read_text(encoding="utf-8")
    for licence in ("jquery.org/license", "glowscript for source code and copyright", "John Coady"):
        assert licence in text
    for name in (str(film_file.parent), str(ROOT), "newton_cradle_pends"):
        assert name not in text + pictures_in(film_file)
    assert not re.search(rf"\b{re.escape(socket.gethostname())}\b", pictures_in(film_file))
    assert len(text) < 1_200_000  # bytes


@with_vpython
def test_a_run_that_fails_names_its_mistake_and_writes_nothing(program):
    change(program, "    momentum = m1", "    open('no')\n    momentum = m1")
    done, file = write_film(program)
    assert done.returncode == 1
    assert "FileNotFoundError: [Errno 2] No such file or directory: 'no'\n" in done.stderr
    assert done.stderr.endswith(f"{file} is not written.\n")
    assert not file.exists()


@with_vpython
def test_all_experiments_are_written_with_an_index(program, tmp_path):
    experiments = program.parents[1] / "support" / "experiments" / "single"
    for experiment in experiments.glob("0[3-9]*"):
        experiment.unlink()
    folder = tmp_path / "all"
    done = python(program, "--html-all", folder, "--seconds", "0.02")
    count = len([*experiments.iterdir()])
    says = f"0.02 s of each of {count} experiments are in {folder}\n"
    assert (done.returncode, done.stdout, done.stderr) == (0, says, "")
    index = (folder / "index.html").read_text()
    links = re.findall('<a href="(.*?)">(.*?)</a><br>', index)
    assert links[1] == ("02_two_bobs.html", "Two bobs")
    assert "Two bobs come in. What leaves on the other side?" in index
    for name, title in links:
        film = json.loads(pictures_in(folder / name))
        assert film[0]["state"]["title"] == f"Newton's cradle: {title}"
    assert len([*folder.iterdir()]) == count + 1


# --- in a browser ----------------------------------------------------------------------------


def test_a_film_plays_what_the_program_computes_and_you_step_and_scrub_it(page, film_file):
    addresses = []
    page.on("request", lambda request: addresses.append(request.url))
    page.goto(film_file.as_uri())
    pages.wait_for_cradle(page)
    page.wait_for_function("isOver()")
    rows = python(ROOT / "src" / "text_cradle_run.py", "--record", "-", *OPTIONS).stdout
    *_, last = csv.DictReader(rows.splitlines())
    thetas = [degrees(float(last[f"theta_{bob}"])) for bob in range(1, 6)]
    assert bob_angles(page) == pytest.approx(thetas, abs=0.01)
    assert page.evaluate("visible('arrow').length") > 0
    buttons = page.locator("button:visible").all_inner_texts()
    assert buttons == ["Run", "Step", "Restart", "Present"]
    moment = page.locator(".moment")
    moment.press("Home")
    wait_for_angles(page, -45, 0, 0, 0, 0)
    assert page.evaluate("visible('arrow').length") == 0  # they are made later
    page.mouse.move(*pages.pixel(page, 1, 0))
    assert page.evaluate("cursor()") == "auto"  # on a bob, which nobody drags here
    moment.blur()
    page.keyboard.press("ArrowRight")
    _, second, *_ = json.loads(pictures_in(film_file))
    assert float(moment.input_value()) == pytest.approx(second["time"], abs=0.005)
    press(page, "Run")
    page.wait_for_function("isOver()")
    assert {url for url in addresses if not url.startswith("data:")} == {film_file.as_uri()}


@pytest.mark.parametrize("page", ["chromium", "firefox"], indirect=True)
def test_a_film_plays_in_a_strict_course_page_without_an_address(page, film_file):
    film = html.escape(film_file.read_text(encoding="utf-8"))
    headers = {"Content-Type": "text/html; charset=utf-8", "Content-Security-Policy": STRICT}
    body = f'<iframe sandbox="allow-scripts" srcdoc="{film}"></iframe>'
    page.route(ADDRESS, lambda route: route.fulfill(body=body, headers=headers))
    page.goto(ADDRESS)
    # A function: the page forbids what Playwright makes of an expression. And the tests' own tools
    # may come too late for a frame.
    page.frames[1].wait_for_function("""() => {
        const { valueAsNumber } = document.querySelector(".moment");
        const spheres = window.glowObjs?.filter(shape => shape?.constructor.name === "sphere");
        return valueAsNumber > 0.99 && spheres.filter(bob => bob.ready).length === 5;
    }""")


def test_homework_asks_what_will_happen_and_what_you_saw_and_explains(page, tmp_path):
    """It waits for your answers. When you restart it, it forgets them."""
    file = tmp_path / "film.html"
    experiment = ROOT / "support" / "experiments" / "single" / "02_two_bobs.toml"
    options = "--html", file, "--experiment", experiment, "--seconds", "1.5"
    assert python(PROGRAM, *options).returncode == 0
    page.goto(file.as_uri())
    pages.wait_for_cradle(page)
    question = page.locator(".question")
    moment = page.locator(".moment")
    for key in ("Space", "ArrowRight", "e"):  # there is no answer E
        page.keyboard.press(key)
    assert not moment.is_visible()
    wait_for_angles(page, -45, -45, 0, 0, 0)
    press(page, "A\u2002One bob, twice as fast")
    question.get_by_text("What did you see?").wait_for()
    wait_for_angles(page, -45, -45, 0, 0, 0)  # nobody reads the answer off the picture
    press(page, "Again slowly")
    moment.press("End")
    wait_for_angles(page, -45, -45, 0, 0, 0)
    press(page, "C\u2002Two bobs, as far as the two")
    question.get_by_text("What happened: C, Two bobs, as far as the two.").wait_for()
    moment.press("Home")
    wait_for_angles(page, -45, -45, 0, 0, 0)
    assert page.evaluate("texts()") == [*"12345"]
    assert question.locator("p").all_inner_texts()[1:] == [
        "You said: A, One bob, twice as fast.",
        "You saw: C, Two bobs, as far as the two.",
    ]
    moment.evaluate("slider => slider.blur()")

    def step_shows_your_answer():
        page.keyboard.press("ArrowRight")
        return "your answer" in page.evaluate("texts()")

    wait_until(step_shows_your_answer)
    press(page, "Restart")
    press(page, "B\u2002One bob, as far as the two")
    question.get_by_text("What did you see?").wait_for()


def test_the_page_saves_a_film(shared):
    shared.locator(".keep summary").click()
    shared.route("**/film.html*", lambda route: route.abort(), times=1)
    press(shared, "Save a film")
    message = shared.get_by_role("alert").get_by_text("so it is not saved")
    message.wait_for()
    name, file = pages.saved(shared, "Save a film")
    assert name == "My cradle.html"
    assert not message.is_visible()
    key = shared.url.partition("key=")[2]
    assert key not in file.read_text(encoding="utf-8") + pictures_in(file)
