"""The command ``discostorm watch``."""

from __future__ import annotations

import contextlib
import os
import re
import select
import shutil
import signal
import sys
import threading
import time
import tomllib
from collections.abc import Callable, Iterator, Mapping
from datetime import datetime
from pathlib import Path
from subprocess import PIPE, Popen, TimeoutExpired
from typing import TYPE_CHECKING, BinaryIO, cast
from wsgiref.simple_server import WSGIRequestHandler, make_server

import click

from discostorm import _checks, wording
from discostorm.cli import output as cli_output
from discostorm.cli.fleet_options import standard_input
from discostorm.cli.options import FILE_ARGS, wifi_options
from discostorm.data import data_path
from discostorm_capture.cli.diagnosis_output import OPTIONS, expect_option, read_command_help
from discostorm_capture.diagnosis.finding import LIMITS, to_sentence
from discostorm_capture.sentences import say

if TYPE_CHECKING:
    from discostorm.wifi import Wifi
    from discostorm_capture.live_capture import Watch

#: Period in which the table is renewed, and time without a packet until a warning [s].
REFRESH, IDLE_WARNING = 1.0, 10.0
#: Maximum number of hosts and kinds of messages in the tables.
MAX_HOST_ROWS, MAX_KIND_ROWS = 20, 8
MESSAGE_COLUMNS = ("message", "per_second", "messages", "bytes")
HOST_COLUMNS = ("host", "products", "first", "last", "sent", "bytes")
#: Programs that capture: options, what they print, the script that starts them; texts on metrics.
PROGRAM_DATA = tomllib.loads(data_path("written/capturing.toml", "discostorm_capture").read_text())
#: Time for a program to report that it cannot capture, and to end [s].
STARTUP_WAIT, SHUTDOWN_WAIT = 0.3, 5.0
PORT_TYPE = click.IntRange(1, 65535)


@click.command(help=read_command_help("watch"))
@click.option("-i", "--interface", metavar="NAME", help=OPTIONS["interface"])
@click.argument("pipe", required=False, metavar="[-]")
@expect_option
@wifi_options
@click.option("--seconds", type=float, metavar="S", help=OPTIONS["seconds"])
@click.option("--follow-fleet", "follows", is_flag=True, help=OPTIONS["follow-fleet"])
@click.option("--prometheus", "port", type=PORT_TYPE, metavar="PORT", help=OPTIONS["prometheus"])
@click.option("--text-file", **FILE_ARGS, help=OPTIONS["text-file"])
def watch(
    interface: str | None,
    pipe: str | None,
    expected: int | tuple[str, ...] | None,
    wifi: Wifi,
    seconds: float | None,
    follows: bool,
    port: int | None,
    text_file: str | None,
) -> None:
    """Watch live discovery: rates, airtime, hosts and findings."""
    from discostorm_capture.live_capture import PacketStream, Watch

    if (interface is None) == (pipe != "-"):
        raise click.UsageError("give either -i INTERFACE, or - for standard input")
    if seconds is not None and not 0 < seconds < float("inf"):
        raise click.UsageError(f"--seconds must be above 0; got {seconds:g}")
    if text_file is not None and not Path(text_file).absolute().parent.is_dir():
        raise cli_output.BadInput(say("no folder", _checks.shorten_name(text_file)))
    state, packets = Watch(wifi, expected=expected), PacketStream(interface or "standard input")
    with (
        cli_output.bad_input(),
        _catch_signals() as signals,
        open_pcap(interface) as pcap,
        _serve(port, state),
    ):
        begin = shown = ready = came = time.monotonic()
        last_packet: float | None = begin
        for data in read_chunks(pcap):
            for when, packet in packets.feed(data):
                state.add_packet(when, packet)
                if state.must_count_now:
                    state.count_and_diagnose(packets.header)
            now = time.monotonic()
            came = now if data or interface is None else came  # piped packets may come late
            if data or last_packet is None:
                last_packet = now if data else None
            elif now - last_packet > IDLE_WARNING:
                click.echo(f"No packet from {packets.name} for {IDLE_WARNING:.0f} s.", err=True)
                last_packet = None  # warn only once
            if now >= ready:
                if now - shown >= REFRESH or state.update_presence(packets.header, now - came):
                    shown = now
                    _renew_output(state, packets.header, text_file, follows, last=False)
                # Use at most half of the processor time.
                ready = max(now + LIMITS.renewal_period, 2 * time.monotonic() - now)
            if signals or (seconds is not None and now - begin >= seconds):
                break
        if packets.header:
            _renew_output(state, packets.header, text_file, follows, last=True)
        elif signals:
            click.echo(f"No packet came before {signals[0]} ended it.")
        if interface is None and packets.error_if_ended and not signals:
            raise cli_output.BadInput(cli_output.visible(packets.error_if_ended))


def _renew_output(state: Watch, header: bytes, path: str | None, follows: bool, last: bool) -> None:
    """Count new packets, then print and write the state; on a terminal in place."""
    state.count_and_diagnose(header)
    while follows and state.presence.changes:
        when, text = state.presence.changes.popleft()
        click.echo(cli_output.visible(f"{datetime.fromtimestamp(when):%H:%M:%S} {text}"))
    if last or (sys.stdout.isatty() and not follows):
        if not last:
            click.clear()
        _print_state(state)
    if path is not None:
        cli_output.write_file("--text-file", path, prometheus_text(state).encode(), "-")


def read_chunks(source: BinaryIO) -> Iterator[bytes]:
    """Yield bytes as they arrive until the source ends; empty bytes while nothing arrives."""
    try:
        number = source.fileno()
    except (OSError, AttributeError):  # not a file of the operating system
        yield from iter(lambda: source.read(1 << 16), b"")
        return
    while True:
        ready, _, _ = select.select([number], [], [], REFRESH / 4)
        data = os.read(number, 1 << 16) if ready else b""
        if ready and not data:
            return
        yield data


@contextlib.contextmanager
def _catch_signals() -> Iterator[list[str]]:
    """Catch SIGINT, SIGTERM and SIGHUP; yield the list of those received."""
    received: list[str] = []
    before = {}
    if threading.current_thread() is threading.main_thread():
        for name in ("SIGINT", "SIGTERM", "SIGHUP"):
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) != signal.SIG_IGN:  # as nohup does
                handler = signal.signal(number, lambda *_, name=name: received.append(name))
                before[number] = handler or signal.SIG_DFL
    try:
        yield received
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


@contextlib.contextmanager
def open_pcap(interface: str | None) -> Iterator[BinaryIO]:
    """Yield a pcap stream from an interface or standard input; end the capturing program."""
    if interface is None:
        yield standard_input()
        return
    program = next(filter(shutil.which, PROGRAM_DATA["options"]), None)
    if program is None:
        raise cli_output.BadInput(say("no program"))
    options = ["-i", interface, *PROGRAM_DATA["options"][program]]
    command = ["/bin/sh", "-c", PROGRAM_DATA["wrapper"], "sh", program, *options]
    with Popen(command, stdin=PIPE, stdout=PIPE, stderr=PIPE, start_new_session=True) as running:
        try:
            with contextlib.suppress(TimeoutExpired):
                running.wait(STARTUP_WAIT)
            yield cast(BinaryIO, running.stdout)
        finally:
            ended = running.poll()
            running.send_signal(signal.SIGINT)
            try:
                text = running.communicate(b"\n", timeout=SHUTDOWN_WAIT)[1].decode(errors="replace")
            except TimeoutExpired:
                running.kill()
                text = running.communicate()[1].decode(errors="replace")
        if ended:
            raise cli_output.BadInput(_explain_failure(program, interface, text))


def _explain_failure(program: str, interface: str, text: str) -> str:
    """Return why a program cannot capture, and what to do about it."""
    lines = [line for line in text.strip().splitlines() if "listening on" not in line]
    lines = [line for line in lines if not line.startswith(tuple(PROGRAM_DATA["startup_lines"]))]
    reason = lines[0].removeprefix(f"{program}: ") if lines else "it ended without a message"
    reason = reason.removeprefix(f"{interface}: ").rstrip(".")
    known = PROGRAM_DATA["hints"].items()
    hints = [hint for words, hint in known if re.search(words, text, re.IGNORECASE)]
    hint = "".join(hints[:1]).replace("PROGRAM", program)
    name = _checks.shorten_name(interface)
    return cli_output.visible(f"{program} cannot capture on {name}: {reason}{hint}")


def _print_state(state: Watch) -> None:
    """Print totals, the diagnosis, and tables of messages and hosts."""
    output = cli_output.Output(as_json=False, as_csv=False)
    now, peak = cli_output.percent(state.airtime_now), cli_output.percent(state.airtime_peak)
    seconds = state.end - state.begin
    time = wording.duration(seconds) if seconds > 0 else "0 s"
    click.echo(say("watched", state.packets, time, now, cli_output.visible(state.wifi.name), peak))
    text = [state.summary()]
    for since, finding in state.certain_findings.values():
        text.append(f"- found at {since:.0f} s: {finding.summary}. {to_sentence(finding.evidence)}")
    for sentence in text:
        click.echo(cli_output.visible(wording.wrap(sentence)))
    kinds = [
        (kind, f"{state.rates.get(kind, 0.0):,.1f}", count, state.payload[kind])
        for kind, count in state.messages.most_common(MAX_KIND_ROWS)
    ]
    hosts = [
        (address, host.products, *times, host.messages, host.payload)
        for address, host in sorted(list(state.presence.hosts.items())[-MAX_HOST_ROWS:])
        for times in [(f"{time - state.begin:.1f}" for time in (host.first, host.last))]
    ]
    for names, part in ((MESSAGE_COLUMNS, kinds), (HOST_COLUMNS, hosts)):
        if not (rows := [dict(zip(names, row, strict=True)) for row in part]):
            continue
        click.echo()
        times = (cli_output.Column(key, unit="s") for key in ("first", "last"))
        cli_output.print_table(rows, output, cli_output.columns_of(rows, *times))


def prometheus_text(state: Watch) -> str:
    """Return the metrics in Prometheus's text format, version 0.0.4."""
    values: dict[str, Mapping[str, float]] = {
        "packets_total": {"": state.packets},
        "messages_total": state.messages,
        "bytes_total": state.payload,
        "airtime_seconds_total": {"": state.airtime},
        "airtime_ratio": {"": state.airtime_now},
        "airtime_peak_ratio": {"": state.airtime_peak},
        "hosts": {"": len(state.presence.hosts)},
    }
    diagnosis = state.diagnosis
    if diagnosis is not None and diagnosis.complete is not None:
        values["complete"] = {"": diagnosis.complete}
        values["incomplete_pairs"] = {"": len(diagnosis.incomplete())}
    values["finding"] = {kind: 1 for kind, _ in state.certain_findings}
    lines = []
    for name, by_kind in values.items():
        lines += [f"# HELP discostorm_{name} {PROGRAM_DATA['metrics'][name]}"]
        lines += [f"# TYPE discostorm_{name} {'counter' if name.endswith('total') else 'gauge'}"]
        for kind, value in by_kind.items():
            escaped = kind.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
            label = f'{{kind="{escaped}"}}' if kind else ""
            lines.append(f"discostorm_{name}{label} {float(value):.10g}")
    return "\n".join([*lines, ""])


class _SilentHandler(WSGIRequestHandler):
    def log_message(self, *_: object) -> None:
        """Log nothing."""


@contextlib.contextmanager
def _serve(port: int | None, state: Watch) -> Iterator[None]:
    """Serve the metrics over HTTP while the context is active."""
    if port is None:
        yield
        return

    def answer(_: object, start: Callable[[str, list[tuple[str, str]]], object]) -> list[bytes]:
        start("200 OK", [("Content-Type", "text/plain; version=0.0.4; charset=utf-8")])
        return [prometheus_text(state).encode()]

    try:
        server = make_server("127.0.0.1", port, answer, handler_class=_SilentHandler)
    except OSError as error:
        raise cli_output.BadInput(f"--prometheus {port}: {error.strerror}") from error
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield
    finally:
        server.shutdown()
        server.server_close()
