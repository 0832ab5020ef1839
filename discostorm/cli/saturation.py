"""The command ``discostorm saturation``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import click

import discostorm as ds
from discostorm import words
from discostorm.cli.fleets import (
    count_options,
    file_options,
    file_or_counts,
    read,
    says_what_matches,
)
from discostorm.cli.options import A_FILE, output_options, packed, protocol_option, wifi_options
from discostorm.cli.output import Output, bad_input, percent, print_channel, print_rows, working
from discostorm.wifi import Wifi


@dataclass(frozen=True)
class Kind:
    """A kind of host of which there may be more: columns that name it, and who else is there."""

    columns: dict[str, Any]
    fleet: ds.Fleet
    index: int = 0


def _kinds(
    processes: float | None,
    endpoints: float | None,
    fleet: str | None,
    file: str | None,
    beside: str | None,
) -> list[Kind]:
    counts: dict[str, Any] = {"processes": processes, "endpoints": endpoints}
    chosen = file_or_counts(fleet, file, counts)
    if chosen == beside == "-":
        raise click.UsageError("either FLEET or --beside may be -, for standard input")
    others = None if beside is None else read(beside)
    if chosen is None:
        members = ds.Fleet.swarm(1, processes, endpoints)
        return [Kind({}, members if others is None else _joined(members, others, others.matching))]
    members = read(chosen)
    if others is None:
        together = members
    elif others.matching != members.matching:
        raise click.UsageError(
            f"matching must be the same in FLEET and --beside; got {members.matching:g} and "
            f"{others.matching:g}"
        )
    else:
        together = _joined(members, others, members.matching)
    return [Kind({"group": name}, together, index) for index, name in enumerate(members.names)]


def _joined(members: ds.Fleet, others: ds.Fleet, matching: float) -> ds.Fleet:
    """Return both in one, the others without their names, which may be those of the members."""
    unnamed = (replace(group, name="") for group in others.groups)
    return ds.Fleet((*members.groups, *unnamed), matching)


@says_what_matches
@click.command()
@packed(
    "kinds",
    _kinds,
    *count_options,
    *file_options,
    click.option("--beside", **A_FILE, help="Fleet file of other hosts on the channel."),
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

    {matching}

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
    print_channel(wifi, output)


def _full(kind: Kind, limit: float, protocol: ds.Protocol, wifi: Wifi) -> dict[str, Any]:
    """Return at how many hosts of a kind the channel is full; None if one is too many."""
    group = kind.fleet.groups[kind.index]
    one = replace(group, hosts=1)
    groups = (*kind.fleet.groups[: kind.index], one, *kind.fleet.groups[kind.index + 1 :])
    hosts = None
    if (
        ds.utilization(protocol, replace(kind.fleet, groups=groups), wifi=wifi) <= limit
        or limit <= 0
    ):
        hosts = float(
            ds.saturation_hosts(
                protocol, wifi=wifi, limit=limit, fleet=kind.fleet, group=kind.index
            )
        )
    return kind.columns | {
        "processes": float(group.processes),
        "endpoints": float(group.endpoints),
        "limit": limit,
        "hosts": hosts,
        "fit": 0 if hosts is None else words.whole_below(hosts),
    }


def _hosts(value: float | None) -> str:
    return "less than 1" if value is None else f"{value:.2f}"
