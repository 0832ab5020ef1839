"""Serve a built book on this machine, at the root of an address or below a base path."""

import argparse
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any


def make_server(folder: Path, base: str = "/", port: int = 8000) -> ThreadingHTTPServer:
    """Return a server for a folder that answers only paths below ``base``."""
    if not (base.startswith("/") and base.endswith("/")):
        raise SystemExit(f"serve: BASE must begin and end with /, as /discostorm/; got {base!r}")

    class BaseHandler(SimpleHTTPRequestHandler):
        def __init__(self, *args: Any, **kwargs: Any) -> None:
            super().__init__(*args, directory=str(folder), **kwargs)

        def translate_path(self, path: str) -> str:
            inside = path.removeprefix(base)
            # Paths outside the base do not exist, as on the real host.
            return super().translate_path("/" + inside if path.startswith(base) else "/.none")

    return ThreadingHTTPServer(("127.0.0.1", port), BaseHandler)


def main() -> None:
    """Serve until Ctrl-C."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--base", default="/")
    parser.add_argument("--port", type=int, default=8000)
    given = parser.parse_args()
    with make_server(given.folder, given.base, given.port) as serving:
        print(f"http://localhost:{given.port}{given.base} (Ctrl-C ends)", flush=True)
        try:
            serving.serve_forever()
        except KeyboardInterrupt:
            print()


if __name__ == "__main__":
    main()
