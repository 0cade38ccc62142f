"""The connection between a tab in a browser and a far program: its address, a cut, an end."""

import json
import signal
from contextlib import contextmanager
from urllib.parse import urljoin, urlsplit

import pages
import programs
import pytest
from pages import new_page, open_cradle, press, wait_for_moves
from programs import end, first_lines, QUIETLY, running
from web_client import BELOW

ENDED = "The program has ended."
NO_ANSWER = "The program does not answer."


@contextmanager
def far_program(csv, path="/"):
    """Run a program; yield the process, and an address with another name and this path."""
    with running(None, str(csv)) as process:
        near = urlsplit(first_lines(process))
        yield process, f"http://cradle.localhost:{near.port}{path}?{near.query}"


def test_a_page_moves_at_another_name_and_path_until_the_end(page, csv):
    """It asks nobody else. When the program has ended, the page says so."""
    addresses = []
    page.on("request", lambda request: addresses.append(request.url))
    page.on("websocket", lambda socket: addresses.append(socket.url.replace("ws", "http", 1)))
    with far_program(csv, BELOW.rstrip("/")) as (process, address):
        open_cradle(page, address)
        wait_for_moves(page)
        whole = address.replace("?", "/?")  # the page adds the slash
        assert page.url == whole
        assert any(url.startswith(whole.replace("?", "ws?")) for url in addresses)
        assert all(url.startswith((urljoin(address, "."), "data:", "blob:")) for url in addresses)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY
        page.get_by_text(ENDED).wait_for()
        command = page.locator(".notice code").inner_text()
        assert command.endswith(f"src/visualize_cradle_run.py {csv}")
        assert pages.violations(page) == {}


def test_a_page_with_tls_has_a_line_with_tls(page, csv):
    with running(None, str(csv)) as process:
        near, query = first_lines(process).split("?")

        def pass_on(route):
            url = route.request.url.replace("https://a.example/", near)
            route.fulfill(response=route.fetch(url=url))

        message = json.dumps({"drawing": {}, "state": {"title": "By TLS"}})
        page.route("https://a.example/**", pass_on)
        page.route_web_socket(f"wss://a.example/ws?{query}", lambda socket: socket.send(message))
        page.goto(f"https://a.example/?{query}")
        page.get_by_text("By TLS").wait_for()


def test_a_page_goes_on_by_itself_when_its_line_was_cut(page, csv):
    """It is not loaded again, nothing is made twice, and the same cradle swings on.

    Present and the view stay. A bob that is held swings on at once, though the mouse is still down.
    """
    ends = []
    page.route_web_socket("**", lambda socket: ends.extend([socket, socket.connect_to_server()]))
    with far_program(csv) as (_, address):
        open_cradle(page, address)
        wait_for_moves(page)
        page.evaluate("scene().forward = vec(-1, -0.5, -1)")
        page.keyboard.press("f")
        own = """[scene().forward.x, objects.length, one('[name=arrows]').checked,
            one('.present').ariaPressed]"""
        before = page.evaluate(own)
        time = pages.readout(page, "t")
        pages.drag(page, 3, 20, 40)
        programs.wait_until(lambda: pages.bob_angles(page)[3] == pytest.approx(40, abs=1))
        page.route("**", lambda route: route.abort())
        for socket in ends:
            socket.close()
        page.get_by_text(NO_ANSWER).wait_for()
        page.evaluate("one('[name=arrows]').click()")  # it is not sent
        page.unroute_all()
        page.get_by_text(NO_ANSWER).wait_for(state="detached")
        page.mouse.move(*pages.pixel(page, 3, 30), steps=3)
        wait_for_moves(page)
        page.mouse.up()
        assert page.evaluate(own) == before
        programs.wait_until(lambda: pages.readout(page, "t") > time)


def test_share_shows_an_address_whose_tab_sees_all_and_has_no_buttons(page, csv):
    """It has the host by which the page came; if nobody else can reach this, it says so."""
    with far_program(csv) as (_, address), new_page(page.context.browser) as follower:
        open_cradle(page, address)
        press(page, "Share")
        shown = page.locator(".address").inner_text()
        assert shown.startswith(address.partition("?")[0])
        assert urlsplit(address).query.removeprefix("key=") not in shown
        page.get_by_text("--host 0.0.0.0").wait_for(state="hidden")
        open_cradle(follower, shown)
        wait_for_moves(follower)
        buttons = follower.locator("button:visible").all_inner_texts()
        assert buttons == ["Present"]
        assert pages.violations(follower) == {}
        open_cradle(page, address.replace("cradle.localhost", "127.0.0.1"))
        press(page, "Share")
        page.get_by_text("--host 0.0.0.0").wait_for()


def test_a_page_does_not_say_that_a_killed_program_has_ended_until_a_new_one_answers(page, csv):
    """Then it is loaded again, and says that it needs the new address."""
    with running(None, str(csv)) as process:
        open_cradle(page, first_lines(process))
        process.kill()
        page.get_by_text(NO_ANSWER).wait_for()
    with running(None, str(csv), "--port", str(urlsplit(page.url).port)) as process:
        first_lines(process)
        page.get_by_text("Open the whole address that the program has printed").wait_for()
