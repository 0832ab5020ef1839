"""The command ``discostorm watch``."""

from __future__ import annotations

import contextlib
import os
import select
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, cast

import click

from discostorm import _checks, words
from discostorm.cli.fleet_options import standard_input
from discostorm.cli.options import A_FILE, wifi_options
from discostorm.cli.output import (
    BadInput,
    Output,
    bad_input,
    percent,
    print_rows,
    visible,
    write_file,
)

if TYPE_CHECKING:
    from discostorm.wifi import Wifi
    from discostorm_capture.live import Watch

#: What is captured; `words.RECORD` says the same for a file.
FILTER = "udp or arp or icmp or ip6 or (tcp and not port 22)"
#: How often it is shown, at the least time between two, and how many hosts and kinds [s], [1].
EVERY, ROWS, KINDS = 1.0, 20, 8
#: How lines begin with which dumpcap and tcpdump say that they begin.
GREETINGS = ("Capturing on", "File:", "Packets captured", "tcpdump: verbose output")
#: How long a program has to say why it cannot capture [s].
SAYS = 0.3


@click.command()
@click.option("-i", "--interface", metavar="NAME", help="Interface to capture on, such as wlan0.")
@click.argument("pipe", required=False, metavar="[-]")
@wifi_options
@click.option(
    "--seconds", type=float, metavar="S", help="Stop after S seconds.  [default: on Ctrl-C]"
)
@click.option(
    "--prometheus",
    "port",
    type=click.IntRange(1, 65535),
    metavar="PORT",
    help="Serve metrics at http://localhost:PORT/metrics.",
)
@click.option(
    "--text-file", **A_FILE, help="Write metrics to this .prom file, for the node exporter."
)
def watch(
    interface: str | None,
    pipe: str | None,
    wifi: Wifi,
    seconds: float | None,
    port: int | None,
    text_file: str | None,
) -> None:
    """Watch live discovery: rates, airtime, hosts and findings.

    The command needs tcpdump or dumpcap, and permission to capture. To watch another machine, pipe
    its capture in and give - instead of an interface. The table is renewed every second. A finding
    is shown once two diagnoses in a row agree on it. The command keeps the newest 8 MiB of packets,
    so it can run for days.

    \b
    Examples:
      sudo discostorm watch -i wlan0
      ssh robot sudo tcpdump -i wlan0 -U -s 0 -w - not port 22 | discostorm watch -
      discostorm watch -i wlan0 --text-file /var/lib/node_exporter/discostorm.prom
    """
    from discostorm_capture.live import Packets, Watch

    if (interface is None) == (pipe != "-"):
        raise click.UsageError("either -i with an interface, or - for standard input")
    if seconds is not None and not 0 < seconds < float("inf"):
        raise click.UsageError(f"--seconds must be above 0; got {seconds:g}")
    if text_file is not None and not Path(text_file).absolute().parent.is_dir():
        raise BadInput(f"--text-file: {_checks.brief(text_file)}: there is no such folder")
    told = Watch(wifi)
    with bad_input(), _served(port, told), _source(interface) as source:
        packets = Packets("standard input" if interface is None else str(interface))
        _run(source, packets, told, seconds, text_file)
        if interface is None and packets.cut:
            raise BadInput(visible(packets.cut))


def _run(
    source: BinaryIO, packets: Any, told: Watch, seconds: float | None, text_file: str | None
) -> None:
    begun = shown = time.monotonic()
    for data in _chunks(source):
        for when, packet in packets.of(data):
            told.add(when, packet)
            if told.full:
                told.fold(packets.head)
        now = time.monotonic()
        if now - shown >= EVERY:
            shown = now
            told.fold(packets.head)
            _show(told, clear=True)
            _write(told, text_file)
        if seconds is not None and now - begun >= seconds:
            break
    if packets.head:
        told.fold(packets.head)
        _show(told, clear=False)
        _write(told, text_file)


def _chunks(source: BinaryIO) -> Iterator[bytes]:
    """Yield what is there to read, nothing when nothing came for a while, until it ends."""
    try:
        number = source.fileno()
    except (OSError, AttributeError):  # not a file of the system
        yield from iter(lambda: source.read(1 << 16), b"")
        return
    with contextlib.suppress(KeyboardInterrupt), _ends_alike():
        while True:
            ready, _, _ = select.select([number], [], [], EVERY / 4)
            data = os.read(number, 1 << 16) if ready else b""
            if ready and not data:
                return
            yield data


@contextlib.contextmanager
def _ends_alike() -> Iterator[None]:
    """Let a closed terminal or a service manager end it as Ctrl-C does, and what captures too."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    numbers = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    before = [(number, signal.signal(number, interrupt)) for number in numbers]
    try:
        yield
    finally:
        for number, handler in before:
            signal.signal(number, handler or signal.SIG_DFL)


@contextlib.contextmanager
def _source(interface: str | None) -> Iterator[BinaryIO]:
    """Give what is captured, as pcap; end what captures."""
    if interface is None:
        yield standard_input()
        return
    known = {"tcpdump": ["-U", "-s", "0", "-n"], "dumpcap": ["-P", "-q", "-s", "0"]}
    program = next((name for name in known if shutil.which(name)), None)
    if program is None:
        raise BadInput(
            "neither tcpdump nor dumpcap is installed: apt-get install tcpdump; or capture "
            "elsewhere, and pipe it to discostorm watch -"
        )
    what = [FILTER] if program == "tcpdump" else ["-f", FILTER]
    command = [program, "-i", interface, *known[program], "-w", "-", *what]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    ) as running:
        assert running.stdout is not None
        assert running.stderr is not None
        try:
            with contextlib.suppress(subprocess.TimeoutExpired):
                running.wait(SAYS)
            yield cast(BinaryIO, running.stdout)
        finally:
            ended = running.poll()
            running.send_signal(signal.SIGINT)
            try:
                said = running.communicate(timeout=5)[1].decode(errors="replace")
            except subprocess.TimeoutExpired:
                running.kill()
                said = running.communicate()[1].decode(errors="replace")
        if ended:
            raise BadInput(visible(_why(program, interface, said)))


def _why(program: str, interface: str, said: str) -> str:
    """Return why a program cannot capture, and what to do."""
    lines = [line for line in said.strip().splitlines() if not line.startswith(GREETINGS)]
    lines = [line for line in lines if "listening on" not in line]
    reason = lines[0].removeprefix(f"{program}: ") if lines else "it ended without a word"
    reason = reason.removeprefix(f"{interface}: ").rstrip(".")
    hint = ""
    if "permission" in said.lower() or "not permitted" in said.lower():
        hint = (
            f"; run it with sudo, or allow {program} to capture: "
            f"sudo setcap cap_net_raw,cap_net_admin+ep $(which {program})"
        )
    elif "no such device" in said.lower() or "doesn't exist" in said.lower():
        hint = "; `ip link` lists the interfaces"
    return f"{program} cannot capture on {_checks.brief(interface)}: {reason}{hint}"


def _show(told: Watch, clear: bool) -> None:
    """Show the table anew, in place on a terminal."""
    if clear and not sys.stdout.isatty():
        return
    if clear:
        click.clear()
    output = Output(as_json=False, as_csv=False)
    span = words.duration(max(told.end - told.begin, 0.0))
    click.echo(
        f"{told.packets:,} packets in {span}; discovery and data take {percent(told.now)} of the "
        f"time on {visible(told.wifi.name)} now, {percent(told.peak)} at peak"
    )
    if told.diagnosis is not None:
        click.echo(visible(words.wrapped(told.diagnosis.summary())))
    for since, finding in told.certain.values():
        sentence = f"- since {since:.0f} s: {finding.what}: {finding.evidence}"
        click.echo(visible(words.wrapped(sentence)))
    kinds = told.messages.most_common(KINDS)
    if kinds:
        click.echo()
        rows = [
            {
                "message": kind,
                "per_second": f"{told.rates.get(kind, 0.0):,.1f}",
                "messages": count,
                "bytes": told.payload[kind],
            }
            for kind, count in kinds
        ]
        print_rows(rows, output)
    if told.hosts:
        click.echo()
        latest = list(told.hosts.items())[-ROWS:]
        rows = [
            {
                "host": name,
                "products": host.products,
                "first": f"{host.first - told.begin:.1f}",
                "last": f"{host.last - told.begin:.1f}",
                "sent": host.sent,
                "bytes": host.payload,
            }
            for name, host in sorted(latest)
        ]
        print_rows(rows, output, headings={"first": "first [s]", "last": "last [s]"})


def metrics(told: Watch) -> str:
    """Return what is known in the format of Prometheus (text, version 0.0.4)."""
    lines = []

    def tell(name: str, kind: str, text: str, values: dict[str, float]) -> None:
        lines.append(f"# HELP discostorm_{name} {text}")
        lines.append(f"# TYPE discostorm_{name} {kind}")
        lines.extend(f"discostorm_{name}{label} {value:g}" for label, value in values.items())

    def by(label: str, values: dict[str, Any]) -> dict[str, float]:
        return {f'{{{label}="{_escaped(key)}"}}': float(value) for key, value in values.items()}

    tell("packets_total", "counter", "Packets captured.", {"": told.packets})
    tell("messages_total", "counter", "Messages, by kind.", by("kind", dict(told.messages)))
    tell("bytes_total", "counter", "Payload of messages [B].", by("kind", dict(told.payload)))
    tell("airtime_seconds_total", "counter", "Airtime of messages [s].", {"": told.airtime})
    tell("airtime_ratio", "gauge", "Airtime now, of the time.", {"": told.now})
    tell("airtime_peak_ratio", "gauge", "Airtime at peak, of the time.", {"": told.peak})
    tell("hosts", "gauge", "Hosts that were heard.", {"": len(told.hosts)})
    diagnosis = told.diagnosis
    if diagnosis is not None and diagnosis.complete is not None:
        tell("complete", "gauge", "Whether discovery is complete.", {"": diagnosis.complete})
        lacking = len(diagnosis.incomplete())
        tell("incomplete_pairs", "gauge", "Pairs that are not complete.", {"": lacking})
    found = {key[0]: 1 for key in told.certain}
    tell("finding", "gauge", "Findings that are certain.", by("kind", found))
    return "\n".join([*lines, ""])


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")


def _write(told: Watch, text_file: str | None) -> None:
    """Write the metrics to a file, which is never half-written."""
    if text_file is not None:
        write_file("--text-file", text_file, metrics(told).encode(), "-")


@contextlib.contextmanager
def _served(port: int | None, told: Watch) -> Iterator[None]:
    """Serve the metrics while this runs."""
    if port is None:
        yield
        return

    class Handler(BaseHTTPRequestHandler):
        """Answers every request with the metrics."""

        def do_GET(self) -> None:
            """Send the metrics."""
            content = metrics(told).encode()
            self.send_response(200)
            self.send_header("Content-Type", "text/plain; version=0.0.4; charset=utf-8")
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

        def log_message(self, *_: object) -> None:
            """Say nothing of requests."""

    try:
        server = ThreadingHTTPServer(("127.0.0.1", port), Handler)
    except OSError as error:
        raise BadInput(f"--prometheus {port}: {error.strerror}") from error
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield
    finally:
        server.shutdown()
        server.server_close()
