"""Check that programs of this machine can connect through 127.0.0.1.

Kernels of executable pages and browser tests need such connections; without them, both would wait
for minutes.
"""

import socket
import sys


def check_loopback() -> None:
    """Exit with a message unless this machine can connect to itself."""
    try:
        with socket.create_server(("127.0.0.1", 0)) as server:
            socket.create_connection(server.getsockname(), timeout=5).close()
    except OSError as error:
        sys.exit(
            "discostorm: the book needs the loopback interface, but 127.0.0.1 does not answer"
            f" ({error}); on Linux: ip link set lo up"
        )


if __name__ == "__main__":
    check_loopback()
