"""The command ``discostorm saturation``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import click

import discostorm as ds
from discostorm import words
from discostorm.cli.fleets import count_options, file_options, file_or_counts, read
from discostorm.cli.options import output_options, packed, protocol_option, wifi_options
from discostorm.cli.output import Output, bad_input, percent, print_rows, working
from discostorm.wifi import Wifi


@dataclass(frozen=True)
class Kind:
    """A kind of host of which there may be more: columns that name it, and who else is there."""

    columns: dict[str, Any]
    processes: float
    endpoints: float
    others: tuple[ds.HostGroup, ...]


def _kinds(
    processes: float | None,
    endpoints: float | None,
    fleet: str | None,
    file: str | None,
    beside: str | None,
) -> list[Kind]:
    counts: dict[str, Any] = {"processes": processes, "endpoints": endpoints}
    chosen = file_or_counts(fleet, file, counts)
    others: tuple[ds.HostGroup, ...] = ()
    if chosen == beside == "-":
        raise click.UsageError("either FLEET or --beside may be -, for standard input")
    if beside is not None:  # without their names, which may be those of FLEET
        others = tuple(replace(group, name="") for group in read(beside).groups)
    if chosen is None:
        return [Kind({}, **counts, others=others)]
    members = read(chosen)
    return [
        Kind(
            {"group": name},
            float(group.processes),
            float(group.endpoints),
            (*members.groups[:index], *members.groups[index + 1 :], *others),
        )
        for index, (name, group) in enumerate(zip(members.names, members.groups, strict=True))
    ]


@click.command(short_help="Hosts at which the channel is full.")
@packed(
    "kinds",
    _kinds,
    *count_options,
    *file_options,
    click.option("--beside", metavar="FILE", help="Fleet file of other hosts on the channel."),
)
@click.option(
    "--limit",
    type=float,
    default=1.0,
    show_default=True,
    help="Utilization to reach, 1 is 100%.",
)
@protocol_option
@wifi_options
@output_options
def saturation(
    kinds: Sequence[Kind],
    limit: float,
    protocols: tuple[ds.Protocol, ...],
    wifi: Wifi,
    output: Output,
) -> None:
    """Tell how many like hosts there are when discovery fills the channel.

    Of a fleet file, FLEET, each group is asked for in turn: how many of its hosts there are
    then, beside the other groups as they are.

    \b
    Examples:
      discostorm saturation --processes 2 --endpoints 10
      discostorm saturation --processes 1 --endpoints 678 --limit 0.5 --json
      discostorm saturation fleet.toml --protocol zenoh
    """
    with bad_input(), working("computing"):
        rows = [
            {"protocol": protocol.name} | _full(kind, limit, protocol, wifi)
            for protocol in protocols
            for kind in kinds
        ]
    if output.for_people and "group" in rows[0]:  # or the lines would be too long
        rows = [{name: row[name] for name in row if name != "limit"} for row in rows]
    print_rows(
        rows,
        output,
        {"limit": percent, "hosts": _hosts},
        {"hosts": "saturated at hosts", "fit": "hosts that fit"},
    )


def _full(kind: Kind, limit: float, protocol: ds.Protocol, wifi: Wifi) -> dict[str, Any]:
    """Return at how many hosts of a kind the channel is full; None if one is too many."""
    counts = (kind.processes, kind.endpoints)
    others = ds.Fleet(kind.others) if kind.others else None
    least = ds.Fleet((ds.HostGroup(1, *counts), *kind.others))
    hosts = None
    if not ds.utilization(protocol, least, wifi=wifi) > limit > 0:
        hosts = ds.saturation_hosts(protocol, *counts, wifi, limit=limit, beside=others)
    return kind.columns | {
        "processes": kind.processes,
        "endpoints": kind.endpoints,
        "limit": limit,
        "hosts": hosts,
        "fit": 0 if hosts is None else words.whole_below(float(hosts)),
    }


def _hosts(value: float | None) -> str:
    return "less than 1" if value is None else f"{value:.2f}"
