"""The cradle on VPython's own page, without ours."""

import socket

from pages import wait_for_throw
from programs import end, running, wait_until
from students import change


def test_with_rate_the_program_throws_the_last_bob_out_on_bare_vpython(page, program):
    """As begin_page says it without the page; until the tab is closed."""
    change(program, "import begin_page", "import begin")
    change(program, "from vpython import mag", "from vpython import mag, rate")
    change(program, "while is_running(pend_list):", "while True:\n        rate(1 / DT)")
    with socket.create_server(("localhost", 0)) as server:
        _, port = server.getsockname()
    with running(program, VPYTHON_HTTP_PORT=str(port)) as process:
        wait_until(lambda: is_open(port))
        page.goto(f"http://localhost:{port}")
        wait_for_throw(page)
        page.close()
        status, stdout, _ = end(process)  # VPython's own server may print an error
        assert (status, stdout) == (0, "")


def is_open(port):
    """Return whether a server listens at this port."""
    with socket.socket() as client:
        return client.connect_ex(("localhost", port)) == 0
