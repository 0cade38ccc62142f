"""The port at which the page is served."""

import socket


def listen(host: str, port: int) -> socket.socket:
    """Return a socket that listens at this address and port; port 0 finds a free one.

    Raises a ValueError with a one-line message if it is not available.
    """
    try:
        return socket.create_server((host, port))
    except OSError as error:
        raise ValueError(
            f"port {port} of {host} is not available: {error.strerror}; choose another --port "
            "(0 is any free one), or another --host"
        ) from error
