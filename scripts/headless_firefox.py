"""Open a page in headless Firefox, and receive what its script posts."""

import json
import subprocess
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any


class AnswerServer(HTTPServer):
    """A server on a free port of this machine that keeps what is posted to it.

    ``script`` is the JavaScript that it answers to each GET.
    """

    timeout = 300

    def __init__(self, script: str = "") -> None:
        super().__init__(("127.0.0.1", 0), _AnswerHandler)
        self.script = script
        self.answers: list[dict[str, Any]] = []


class _AnswerHandler(BaseHTTPRequestHandler):
    server: AnswerServer

    def do_GET(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "text/javascript")
        self.end_headers()
        self.wfile.write(self.server.script.encode())

    def do_POST(self) -> None:
        length = int(self.headers["Content-Length"])
        self.server.answers.append(json.loads(self.rfile.read(length)))
        self.send_response(204)
        self.end_headers()

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002
        pass


def ask_firefox(
    program: str, profile: Path, address: str, server: AnswerServer, requests: int = 1
) -> dict[str, Any]:
    """Open an address with an empty profile, serve some requests, and return the posted answer."""
    command = [program, "--headless", "--no-remote", "--profile", str(profile), address]
    with subprocess.Popen(command, stderr=subprocess.DEVNULL) as process:
        for _ in range(requests):
            server.handle_request()
        process.terminate()
    if not server.answers:
        raise SystemExit(f"discostorm: {program} gave no answer on {address}")
    return server.answers.pop()
