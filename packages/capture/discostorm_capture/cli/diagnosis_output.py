"""What a capture's diagnosis is printed as, with what to paste."""

from __future__ import annotations

import math
import shutil
from itertools import chain
from typing import TYPE_CHECKING, Any

import click

from discostorm import words
from discostorm.cli.output import Output, print_rows, visible
from discostorm.data import read_data
from discostorm.snippets import Snippet, snippets

if TYPE_CHECKING:
    from discostorm_capture import Capture
    from discostorm_capture.diagnosis import Diagnosis, Finding

#: So many pairs are listed for people; all are in the JSON.
MOST = 12
#: Families of middleware, by what they speak.
FAMILIES = {"RTPS": "DDS", "Zenoh": "Zenoh"}
#: What a table of messages and a fleet lack where announcements are encrypted.
NO_ENDPOINTS = (
    "DDS Security encrypts SEDP, so that endpoints are unknown (shown as 0); capture the same "
    "fleet without security to count them"
)


def is_encrypted(diagnosis: Diagnosis) -> bool:
    """Return whether the endpoints of processes are encrypted."""
    return any(finding.kind == "encrypted" for finding in diagnosis.findings)


def pasted(finding: Finding, capture: Capture) -> tuple[Snippet, ...]:
    """Return what to paste for a finding: the planner's pieces for the products that were seen."""
    known = read_data("diagnosis/remedies.csv", "discostorm_capture")
    plans = [row["plan"].split(";") for row in known if row["remedy"] == finding.remedy]
    seen = capture.processes()
    families = {FAMILIES[name] for name in seen["protocol"]}
    names = {*families, *seen["product"], *(f"{family} peers" for family in families)}
    works = {
        (row["kind"], row["family"])
        for row in read_data("vendors/remedies.csv")
        if row["works"] != "no"
    }
    kinds = [
        kind
        for kind in chain.from_iterable(plans)
        if any((kind, family) in works for family in (*families, "any"))
    ]
    return tuple(piece for kind in kinds for piece in snippets(kind, *names))


def told(diagnosis: Diagnosis, capture: Capture) -> dict[str, Any]:
    """Return what JSON says of a diagnosis."""
    answer = diagnosis.to_dict()
    for row, finding in zip(answer["findings"], diagnosis.findings, strict=True):
        row["paste"] = [piece.to_dict() for piece in pasted(finding, capture)]
    return answer


def show_answer(diagnosis: Diagnosis) -> None:
    """Say how discovery is, why, and what to do; then all else that was found."""
    answer = diagnosis.summary()
    _say(answer)
    for finding in diagnosis.findings:
        if words.capitalized(finding.evidence) in answer:
            continue
        advice = "" if finding.about == "event" else f" {finding.advice}"
        evidence = words.capitalized(finding.evidence)
        _say(f"- {words.capitalized(finding.summary)}. {evidence}.{advice}")


def _say(text: str) -> None:
    width = min(max(shutil.get_terminal_size().columns, 40), 79)
    click.echo(visible(words.wrapped(text, width)))


def show_tables(diagnosis: Diagnosis, output: Output) -> None:
    """Print a table with a row a host, and the pairs that never completed."""
    hosts = diagnosis.hosts().reset_index()
    if len(hosts):
        click.echo()
        rows = hosts.drop(columns=["sent_bytes", "received_bytes", "known_s"]).to_dict("records")
        print_rows(
            rows,
            output,
            formats=dict.fromkeys(("announced_s", "knows_all_s"), _time),
            headings={
                "announced_s": "first [s]",
                "knows_all_s": "complete [s]",
                "endpoints": "endp.",
                "processes": "proc.",
            },
        )
    pairs = diagnosis.incomplete()
    if len(pairs):
        click.echo(f"\nPairs that never completed ({len(pairs)} of {diagnosis.pairs}):")
        rows = [
            {
                "known": f"{row['of']} {row['of_process'][:12]}",
                "to": f"{row['by']} {row['by_process'][:12]}",
                "answered": "never" if row["heard_s"] == math.inf else _time(row["heard_s"]),
                "told": row["sent"],
            }
            for row in pairs.head(MOST).to_dict("records")
        ]
        print_rows(rows, output, headings={"answered": "answered [s]", "told": "endpoints told"})
        if len(pairs) > MOST:
            click.echo(f"and {len(pairs) - MOST} more; all are in the JSON")
    click.echo()


def _time(value: float) -> str:
    if math.isinf(value):
        return "never"
    return "" if math.isnan(value) else f"{value:.2f}"
