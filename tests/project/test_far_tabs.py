"""Tabs in a real Chromium, far from the program: another port, path or name, TLS, a long way, no websocket."""

import asyncio
import re
import shutil
import signal
import ssl
import subprocess
import threading
from contextlib import contextmanager, suppress
from queue import SimpleQueue
from urllib.parse import urlsplit

import pytest
from programs import end, first_lines, needs_vpython, new_page, open_cradle, QUIETLY, running, wait_for_moves

pytestmark = [pytest.mark.browser, *needs_vpython]

BELOW = "/user/ann/proxy/8000/"
ENDED, UNHEARD = "The program has ended.", "The program runs, but this page does not hear from it."


@contextmanager
def far_tab(chromium, csv, name="127.0.0.1", prefix="/", cuts=False, tls=None, websocket="passes"):
    """Run a program and a proxy; yield the process, a tab, and the page's address at the proxy.

    The proxy knows only paths with the prefix, and cuts it off, or not. A websocket passes, is asked as a page, or is
    never answered.
    """

    async def proxy():
        server = await asyncio.start_server(serve, "127.0.0.1", 0, ssl=tls)
        started.put((asyncio.get_running_loop(), server.sockets[0].getsockname()[1]))
        await is_over.wait()  # asyncio.run then ends the connections

    async def serve(browser, to_browser):
        with suppress(OSError, asyncio.IncompleteReadError, asyncio.CancelledError):
            head = await browser.readuntil(b"\r\n\r\n")
            if websocket == "is never answered" and b"Upgrade: websocket" in head:
                await is_over.wait()
            if websocket == "is asked as a page":
                head = re.sub(rb"(Upgrade|Connection): .*\r\n", b"", head)
            try:
                port = near.port if head.split()[1].startswith(prefix.encode()) else 1  # where nobody answers
                program, to_program = await asyncio.open_connection("127.0.0.1", port)
            except OSError:
                to_browser.write(b"HTTP/1.1 502 Bad Gateway\r\nContent-Length: 5\r\n\r\nSorry")
                to_browser.close()
            else:
                to_program.write(head.replace(f" {prefix if cuts else '/'}".encode(), b" /", 1))
                await asyncio.gather(pass_on(browser, to_program), pass_on(program, to_browser))

    async def pass_on(reader, writer):
        with suppress(OSError):
            while data := await reader.read(2**16):
                writer.write(data)
        writer.close()

    started, is_over = SimpleQueue(), asyncio.Event()
    with running(None, str(csv)) as process, new_page(chromium, ignore_https_errors=True) as page:
        near = urlsplit(first_lines(process))
        (thread := threading.Thread(target=lambda: asyncio.run(proxy()))).start()
        loop, own_port = started.get()
        address = f"{'https' if tls else 'http'}://{name}:{own_port}{prefix}?{near.query}"
        try:
            yield process, page, address
        finally:
            loop.call_soon_threadsafe(is_over.set)
            thread.join()


@pytest.fixture
def tls(tmp_path):
    """TLS with a certificate that nobody has signed."""
    if not shutil.which("openssl"):
        pytest.skip("openssl is not installed")
    command = "openssl req -x509 -newkey rsa:2048 -nodes -keyout key -out certificate -days 1 -subj /CN=a"
    subprocess.run(command.split(), cwd=tmp_path, check=True, capture_output=True)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(tmp_path / "certificate", tmp_path / "key")
    return context


@pytest.mark.parametrize(
    "how", [{}, {"prefix": BELOW, "cuts": True}, {"prefix": BELOW}, {"name": "cradle.localhost", "tls": "tls"}], ids=str
)
def test_a_page_shows_the_moving_bobs_through_a_proxy_and_asks_nobody_else(chromium, csv, request, how):
    """When the program has ended, and the proxy answers in its place, the page says so."""
    how, asked = {**how, "tls": how.get("tls") and request.getfixturevalue("tls")}, []
    with far_tab(chromium, csv, **how) as (process, page, address):
        page.on("request", lambda request: asked.append(request.url))
        page.on("websocket", lambda websocket: asked.append(websocket.url.replace("ws", "http", 1)))
        open_cradle(page, address)
        wait_for_moves(page)
        assert page.url == address and {*asked} > {address, address.replace("?", "ws?")}
        assert all(url.startswith((address.partition("?")[0], "data:", "blob:")) for url in asked)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY
        page.get_by_text(ENDED).wait_for()


@pytest.mark.parametrize("websocket", ["is asked as a page", "is never answered"])
def test_a_page_whose_websocket_does_not_come_through_says_so(chromium, csv, websocket):
    with far_tab(chromium, csv, prefix=BELOW, websocket=websocket) as (_, page, address):
        page.clock.install()
        page.goto(address)
        page.clock.fast_forward("01:00")
        page.get_by_text(UNHEARD).wait_for()
        assert page.get_by_text(ENDED).count() == 0
