"""The command ``discostorm saturation``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import click

import discostorm as ds
from discostorm import words
from discostorm.cli.fleet_options import (
    count_options,
    error_band,
    file_options,
    read,
    ready_made,
    say_bands,
    says_what_matches,
    who,
    without_robot,
)
from discostorm.cli.options import A_FILE, output_options, packed, protocol_option, wifi_options
from discostorm.cli.output import (
    Output,
    bad_input,
    percent,
    plain,
    print_channel,
    print_rows,
    working,
    yes,
)
from discostorm.measured import most_hosts
from discostorm.wifi import Wifi
from discostorm.wifi.radio import both_ends


@dataclass(frozen=True)
class Kind:
    """A kind of host of which there may be more: columns that name it, and who else is there."""

    columns: dict[str, Any]
    fleet: ds.Fleet
    index: int = 0
    asked: float | None = None


def _kinds(
    hosts: float | None,
    processes: float | None,
    endpoints: float | None,
    robot: str | None,
    fleet: str | None,
    file: str | None,
    beside: str | None,
) -> list[Kind]:
    way = who(fleet, file, robot, {"processes": processes, "endpoints": endpoints})
    if way.file == beside == "-":
        raise click.UsageError("either FLEET or --beside may be -, for standard input")
    others = None if beside is None else read(beside)
    if way.file is None:
        if way.robot is None:
            columns, members = {}, ds.Fleet.swarm(1, processes, endpoints)
        else:
            one = ready_made(way.robot)
            columns, members = {"robot": one.name}, ds.Fleet((one,))
        together = members if others is None else _joined(members, others, others.matching)
        return [Kind(columns, together, asked=hosts)]
    if hosts is not None:
        raise click.UsageError("--fleet goes without --hosts here")
    members = read(way.file)
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
    click.option(
        "--hosts", type=float, metavar="N", help="Hosts of your fleet, to see whether they fit."
    ),
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
    """Compute how many identical hosts fill the channel with discovery.

    With a fleet file, FLEET, the command varies one group at a time and keeps the others. With
    --hosts, it says whether that many hosts fit.

    {matching}

    \b
    Examples:
      discostorm saturation --processes 2 --endpoints 10
      discostorm saturation --robot turtlebot4 --hosts 12 --protocol all
      discostorm saturation --processes 1 --endpoints 678 --limit 0.5 --json
      discostorm saturation fleet.toml --protocol paper
    """
    with bad_input(), working("computing"):
        asked_of = [(protocol, kind) for protocol in protocols for kind in kinds]
        rows = [
            {"protocol": protocol.name} | _both(kind, limit, protocol, *both_ends(wifi))
            for protocol, kind in asked_of
        ]
        saturated = [
            (protocol, _with(kind, row["hosts"] or 1.0))
            for row, (protocol, kind) in zip(rows, asked_of, strict=True)
        ]
        if not output.for_people and any(table.captured for table in protocols):
            for row, (protocol, fleet) in zip(rows, saturated, strict=True):
                row |= error_band(protocol, fleet)
    asked = kinds[0].asked is not None
    if output.for_people:  # what was given is left out, or the lines would be too long
        rows = without_robot(rows, output)
        known = {"processes", "endpoints"} if kinds[0].columns.get("robot") or asked else set()
        without = known | ({"limit"} if asked or "group" in rows[0] else set())
        rows = [{name: row[name] for name in row if name not in without} for row in rows]
        rows = [_shown(row) for row in rows]
    print_rows(
        rows,
        output,
        {
            "limit": percent,
            "hosts": _hosts,
            "hosts_full_ampdus": _hosts,
            "asked": plain,
            "asked_fit": yes,
        },
        {
            "hosts": "saturated at" if asked else "saturated at hosts",
            "fit": "hosts that fit",
            "hosts_full_ampdus": "with full A-MPDUs",
            "fit_full_ampdus": "hosts that may fit",
            "asked": "yours",
            "asked_fit": "fit",
        },
    )
    full, single = both_ends(wifi)
    print_channel(single, output)
    if full != single and output.for_people:
        click.echo(f"\n{words.AGGREGATES}")
    say_bands(saturated, output)


def _both(
    kind: Kind, limit: float, protocol: ds.Protocol, full: Wifi, single: Wifi
) -> dict[str, Any]:
    """Return that with one frame in each exchange and, where it differs, with full A-MPDUs."""
    found = _full(kind, limit, protocol, single)
    if full == single:
        return found
    best = _full(kind, limit, protocol, full)
    found["more_than"] = found["more_than"] or best["more_than"]
    return found | {f"{name}_full_ampdus": best[name] for name in ("hosts", "fit")}


def _full(kind: Kind, limit: float, protocol: ds.Protocol, wifi: Wifi) -> dict[str, Any]:
    """Return at how many hosts of a kind the channel is full; None if one is too many."""
    group, hosts = kind.fleet.groups[kind.index], None
    if ds.utilization(protocol, _with(kind, 1.0), wifi=wifi) <= limit or limit <= 0:
        hosts = float(
            ds.saturation_hosts(
                protocol, wifi=wifi, limit=limit, fleet=kind.fleet, group=kind.index
            )
        )
    found = kind.columns | {
        "processes": float(group.processes),
        "endpoints": float(group.endpoints),
        "limit": limit,
        "hosts": hosts,
        "fit": 0 if hosts is None else words.whole_below(hosts),
        "more_than": _not_measured(protocol, group, hosts),
    }
    if kind.asked is None:
        return found
    return found | {"asked": kind.asked, "asked_fit": hosts is not None and kind.asked < hosts}


def _with(kind: Kind, hosts: float) -> ds.Fleet:
    """Return the fleet with so many hosts of the kind."""
    groups = list(kind.fleet.groups)
    groups[kind.index] = replace(groups[kind.index], hosts=hosts)
    return replace(kind.fleet, groups=tuple(groups))


def _not_measured(protocol: ds.Protocol, group: ds.HostGroup, hosts: float | None) -> int | None:
    """Return up to how many hosts a measured table is asked, if the answer is beyond; else None."""
    if protocol.captured is None or hosts is None:
        return None
    most = most_hosts(protocol.captured, float(group.processes))
    return most if hosts > most else None


def _shown(row: dict[str, Any]) -> dict[str, Any]:
    """Return a row for people: no number of hosts beyond twice of what was measured."""
    most, shown = row["more_than"], {k: v for k, v in row.items() if k != "more_than"}
    if most is None:
        return shown
    for name in ("hosts", "fit", "hosts_full_ampdus", "fit_full_ampdus"):
        if (shown.get(name) or 0) > most:
            shown[name] = f"more than {most}" + " (not measured)" * (name == "hosts")
    return shown


def _hosts(value: float | str | None) -> str:
    return value if isinstance(value, str) else "less than 1" if value is None else f"{value:.2f}"
