"""Print a diagnosis as text, tables and JSON; the option ``--expect`` for expected hosts."""

from __future__ import annotations

import math
import shutil
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import discostorm as ds
from discostorm import wording
from discostorm.cli.fleet_options import read_fleet
from discostorm.cli.output import Column, Output, bad_input, columns_of, print_table, visible
from discostorm.data import data_path, read_data
from discostorm.snippets import Snippet, snippets
from discostorm_capture.diagnosis.finding import Finding, remedies
from discostorm_capture.diagnosis.hosts import parse_expected_hosts
from discostorm_capture.diagnosis.observations import ExpectedHosts

if TYPE_CHECKING:
    from discostorm_capture import Capture
    from discostorm_capture.diagnosis.diagnose import Diagnosis

#: Maximum number of pairs in printed tables; the JSON has all.
MAX_PRINTED_PAIRS = 12
_TEXTS = tomllib.loads(data_path("written/help.toml", "discostorm_capture").read_text("utf-8"))
#: Help texts of options, by name; the note on tables and fleets if announcements are encrypted.
OPTIONS: dict[str, str] = _TEXTS["options"]
ENDPOINTS_ENCRYPTED: str = _TEXTS["endpoints_encrypted"]


def read_command_help(command: str) -> str:
    """Return the help text of a command."""
    text: str = _TEXTS[command].replace("\\b", "\b")
    to_file, to_pipe = (wording.TCPDUMP.format(file=file) for file in ("discovery.pcap", "-"))
    return text.format(record_file=to_file, record_out=to_pipe)


def snippets_for_finding(finding: Finding, capture: Capture) -> list[Snippet]:
    """Return configuration to copy for a finding, for the captured products."""
    processes = capture.processes()
    families = {name.replace("RTPS", "DDS") for name in processes["protocol"]}
    names = {*families, *processes["product"], *(f"{family} peers" for family in families)}
    works = {
        row["kind"]
        for row in read_data("vendors/remedies.csv")
        if row["works"] != "no" and row["family"] in (*families, "any")
    }
    plans = remedies()[finding.remedy]["plan"].split(";") if finding.remedy else []
    return [piece for kind in plans if kind in works for piece in snippets(kind, *names)]


def diagnosis_to_json(diagnosis: Diagnosis, capture: Capture) -> dict[str, Any]:
    """Return a diagnosis as JSON, with configuration to copy."""
    answer = diagnosis.to_dict()
    for row, finding in zip(answer["findings"], diagnosis.findings, strict=True):
        row["paste"] = [piece.to_dict() for piece in snippets_for_finding(finding, capture)]
    return answer


def print_diagnosis(diagnosis: Diagnosis) -> None:
    """Print the state of discovery, its cause and remedy; then all other findings."""
    answer = diagnosis.summary()
    lines = [answer]
    for finding in diagnosis.findings:
        evidence = wording.capitalized(finding.evidence)
        if evidence not in answer:
            advice = "" if finding.about == "event" else f" {finding.advice}"
            lines.append(f"- {wording.capitalized(finding.summary)}. {evidence}.{advice}")
    width = min(max(shutil.get_terminal_size().columns, 40), 79)
    for line in lines:
        click.echo(visible(wording.wrap(line, width)))


def print_diagnosis_tables(diagnosis: Diagnosis, output: Output) -> None:
    """Print a table with one row per host, and the pairs that never completed."""
    hosts = diagnosis.hosts().drop(columns=["sent_bytes", "received_bytes", "known_s"])
    if len(hosts):
        click.echo()
        rows = hosts.reset_index().to_dict("records")
        columns = columns_of(
            rows,
            Column("announced_s", "first", _format_time, "s"),
            Column("knows_all_s", "complete", _format_time, "s"),
            Column("endpoints", "endp."),
            Column("processes", "proc."),
        )
        print_table(rows, output, columns)
    pairs = diagnosis.incomplete()
    if len(pairs):
        click.echo(f"\nPairs that never completed ({len(pairs)} of {diagnosis.pairs}):")
        shown = pairs.head(MAX_PRINTED_PAIRS)
        table = {
            "process": shown["of"] + " " + shown["of_process"].str[:12],
            "not fully known to": shown["by"] + " " + shown["by_process"].str[:12],
            "answered [s]": shown["heard_s"].map(_format_time),
            "endpoints announced": shown["sent"],
        }
        print_table(shown.assign(**table)[[*table]].to_dict("records"), output)
        if len(pairs) > MAX_PRINTED_PAIRS:
            click.echo(f"and {len(pairs) - MAX_PRINTED_PAIRS} more; all are in the JSON")
    click.echo()


def _format_time(value: float) -> str:
    if math.isinf(value):
        return "never"
    return "" if math.isnan(value) else f"{value:.2f}"


def count_hosts(fleet: ds.Fleet) -> int | None:
    """Return the number of hosts in a fleet; None if it is no positive integer."""
    hosts = float(fleet.hosts())
    return int(hosts) if hosts.is_integer() and hosts >= 1 else None


def _parse_expected(_: click.Context, _of: click.Parameter, value: str | None) -> ExpectedHosts:
    """Return the expected number of hosts or addresses, from a number, a fleet file or a list."""
    if value is None:
        return None
    if not value.isdecimal() and (value.endswith(".toml") or Path(value).is_file()):
        with bad_input():
            return count_hosts(read_fleet(value))
    try:
        return parse_expected_hosts(int(value) if value.isdecimal() else value.split(","))
    except ValueError as error:
        raise click.BadParameter(str(error).removeprefix("expected ")) from None


expect_option = click.option(
    "--expect",
    "expected",
    metavar="N|FILE|ADDRESS[,...]",
    callback=_parse_expected,
    help=OPTIONS["expect"],
)
