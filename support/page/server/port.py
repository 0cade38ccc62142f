"""The port at which the page is served."""

import socket

# Ports from 1024 on that browsers refuse (https://fetch.spec.whatwg.org/#port-blocking). Those
# below are for the system's own services.
# fmt: off
REFUSED = {
    1719, 1720, 1723, 2049, 3659, 4045, 4190, 5060, 5061, 6000, 6566, 6665, 6666, 6667, 6668, 6669,
    6679, 6697, 10080,
}
# fmt: on


def listen(host: str, port: int) -> socket.socket:
    """Return a socket that listens at this address and port; port 0 finds a free one.

    Raises a ValueError with a one-line message if it is not available, or if browsers refuse it.
    """
    try:
        if port in REFUSED:
            raise OSError(0, "browsers refuse it")
        listener = bind(host, port)
    except (socket.gaierror, UnicodeError) as error:
        raise ValueError(
            f"--host: found {host!r}, allowed is an address of this machine"
        ) from error
    except OSError as error:
        choice = "choose another --port, or 0 for any free one"
        raise ValueError(
            f"port {port} of {host} is not available: {error.strerror}; {choice}"
        ) from error
    is_refused = listener.getsockname()[1] in REFUSED  # a free port that the system has chosen
    return listen(host, port) if is_refused else listener


def bind(host: str, port: int) -> socket.socket:
    """Return a socket that listens there; raises an OSError or a UnicodeError."""
    family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    listener = socket.socket(family, kind)
    # With SO_REUSEADDR, the port of a program that has just ended is free. On Windows, SO_REUSEADDR
    # would share a port in use; SO_EXCLUSIVEADDRUSE prevents this.
    option = getattr(socket, "SO_EXCLUSIVEADDRUSE", socket.SO_REUSEADDR)
    listener.setsockopt(socket.SOL_SOCKET, option, 1)
    listener.bind(address)
    listener.listen()
    return listener
