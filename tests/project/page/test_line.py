"""The line between a tab in a browser and a far program: a proxy, a cut, an end."""

import asyncio
import shutil
import signal
import ssl
import subprocess
import threading
from contextlib import contextmanager, suppress
from urllib.parse import urljoin, urlsplit

import pages
import programs
import pytest
from pages import new_page, open_cradle, press, wait_for_moves
from programs import end, first_lines, needs_vpython, QUIETLY, running
from web_client import BELOW

pytestmark = [pytest.mark.browser, *needs_vpython]

ENDED = "The program has ended."
NO_ANSWER = "The program does not answer."


class Proxy:
    """Passes on all data that reach its own port; while is_cut is True, it ends each connection.

    It cuts off the prefix of a path.
    """

    def __init__(self, program_port, prefix, tls):
        self.program_port = program_port
        self.root = prefix.rstrip("/").encode()
        self.writers = []
        self.is_cut = False
        self.loop = asyncio.new_event_loop()
        threading.Thread(target=self.loop.run_forever, daemon=True).start()
        start = asyncio.start_server(self.serve, "127.0.0.1", 0, ssl=tls)
        server = asyncio.run_coroutine_threadsafe(start, self.loop).result()
        self.port = server.sockets[0].getsockname()[1]

    def set_cut(self, is_cut):
        self.is_cut = is_cut
        for writer in self.writers:
            self.loop.call_soon_threadsafe(writer.transport.abort)

    async def serve(self, browser, to_browser):
        self.writers.append(to_browser)
        with suppress(OSError, asyncio.IncompleteReadError):
            if not self.is_cut:
                head = await browser.readuntil(b"\r\n\r\n")
                program, to_program = await asyncio.open_connection("127.0.0.1", self.program_port)
                to_program.write(head.replace(b" " + self.root, b" ", 1))
                await asyncio.gather(
                    self.pass_on(browser, to_program), self.pass_on(program, to_browser)
                )
        to_browser.close()

    async def pass_on(self, reader, writer):
        with suppress(OSError):
            while data := await reader.read(2**16):
                writer.write(data)
        writer.close()


@contextmanager
def far_tab(browser, csv, name="127.0.0.1", prefix="/", tls=None):
    """Run a program and a Proxy.

    Yield the process, a tab, the page's address at the proxy, and the proxy.
    """
    with running(None, str(csv)) as process, new_page(browser, ignore_https_errors=True) as page:
        near = urlsplit(first_lines(process))
        scheme = "https" if tls else "http"
        proxy = Proxy(near.port, prefix, tls)
        yield process, page, f"{scheme}://{name}:{proxy.port}{prefix}?{near.query}", proxy


@pytest.fixture
def tls(tmp_path):
    """TLS with a certificate that nobody has signed."""
    if not shutil.which("openssl"):
        pytest.skip("openssl is not installed")
    command = (
        "openssl req -x509 -newkey rsa:2048 -nodes -keyout key -out certificate -days 1 -subj /CN=a"
    )
    subprocess.run(command.split(), cwd=tmp_path, check=True, capture_output=True)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(tmp_path / "certificate", tmp_path / "key")
    return context


def test_a_page_moves_through_a_proxy_with_tls_and_another_name_and_path_until_the_end(
    chromium, csv, tls
):
    """It asks nobody else. When the program has ended, the page says so."""
    addresses = []
    prefix = BELOW.rstrip("/")  # the page adds the slash
    with far_tab(chromium, csv, "cradle.localhost", prefix, tls) as (process, page, address, _):
        page.on("request", lambda request: addresses.append(request.url))
        page.on(
            "websocket", lambda websocket: addresses.append(websocket.url.replace("ws", "http", 1))
        )
        open_cradle(page, address)
        wait_for_moves(page)
        whole = address.replace("?", "/?")
        assert page.url == whole
        assert any(url.startswith(whole.replace("?", "ws?")) for url in addresses)
        assert all(url.startswith((urljoin(address, "."), "data:", "blob:")) for url in addresses)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY
        page.get_by_text(ENDED).wait_for()
        command = page.locator(".notice code").inner_text()
        assert command.endswith(f"src/visualize_cradle_run.py {csv}")
        assert pages.violations(page) == {}


def test_a_page_goes_on_by_itself_when_its_line_was_cut(chromium, csv):
    """It is not loaded again, nothing is made twice, and the same cradle swings on.

    Present and the view stay. A bob that is held swings on at once, though the mouse is still down.
    """
    with far_tab(chromium, csv) as (_, page, address, proxy):
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
        proxy.set_cut(True)
        page.get_by_text(NO_ANSWER).wait_for()
        page.evaluate("one('[name=arrows]').click()")  # it is not sent
        proxy.set_cut(False)
        page.get_by_text(NO_ANSWER).wait_for(state="detached")
        page.mouse.move(*pages.pixel(page, 3, 30), steps=3)
        wait_for_moves(page)
        page.mouse.up()
        assert page.evaluate(own) == before
        assert pages.readout(page, "t") > time


def test_share_shows_an_address_whose_tab_sees_all_turns_its_view_and_changes_nothing(
    chromium, csv
):
    """It has the host by which the page came; if nobody else can reach this, it says so."""
    with (
        far_tab(chromium, csv, "cradle.localhost") as (_, page, address, _),
        new_page(chromium) as follower,
    ):
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
        follower.keyboard.press("Space")
        wait_for_moves(follower)
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
