"""The handout's program, on VPython's own page, in a real browser."""

import socket

from pages import BOBS
from programs import end, PROGRAM, running, wait_until

from support.constants import R_PARAM

PLAIN = PROGRAM.with_name("plain_cradle_run.py")


def test_the_handouts_program_throws_the_last_bob_out_until_the_tab_is_closed(page):
    with socket.create_server(("localhost", 0)) as server:
        _, port = server.getsockname()
    with running(PLAIN, VPYTHON_HTTP_PORT=str(port)) as process:
        wait_until(lambda: is_open(port))
        page.goto(f"http://localhost:{port}")
        farthest = f"Math.max(...({BOBS})().map(bob => bob[0]))"
        page.wait_for_function(f"() => {farthest} > {-0.1 + 5 / 4 * R_PARAM}")
        page.close()
        status, stdout, _ = end(process)  # VPython's own server may print an error
        assert (status, stdout) == (0, "")


def is_open(port):
    """Return whether a server listens at this port."""
    with socket.socket() as client:
        return client.connect_ex(("localhost", port)) == 0
