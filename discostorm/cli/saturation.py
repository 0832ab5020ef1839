"""The command ``discostorm saturation``."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import click

import discostorm as ds
from discostorm import wording
from discostorm.cli import fleet_options as fleets, options, output as out
from discostorm.cli.output import Column, Output
from discostorm.prediction_error import max_covered_hosts
from discostorm.wifi import Wifi
from discostorm.wifi.radio import aggregation_bounds


@dataclass(frozen=True)
class VariedGroup:
    """A group of variable size: its columns, fleet and index, the size asked about, and channel."""

    columns: dict[str, Any]
    fleet: ds.Fleet
    index: int = 0
    asked: float | None = None
    wifi: Wifi = ds.PAPER

    def with_hosts(self, hosts: float) -> ds.Fleet:
        """Return the fleet with another number of hosts in the group."""
        return self.fleet.with_hosts(self.index, hosts)


def _varied_groups(
    hosts: float | None,
    robot: str | None,
    fleet: str | None,
    file: str | None,
    beside: str | None,
    **counts: float | None,
) -> list[VariedGroup]:
    source = fleets.fleet_source(fleet, file, robot, counts)
    if source == beside == "-":
        raise click.UsageError("FLEET and --beside cannot both be -, standard input")
    if source is not None and hosts is not None:
        raise click.UsageError("--fleet cannot be combined with --hosts here")
    if source is not None:
        own = fleets.read_fleet(source)
        options.refuse_wifi_with_cells(own.cells)
    elif robot is not None:
        own = ds.Fleet((fleets.robot_preset(robot),))
    else:
        own = fleets.ros2_swarm(1, **counts)
    together = own
    if beside is not None:
        others = fleets.read_fleet(beside)
        if own.cells or others.cells:
            raise click.UsageError("--beside cannot be combined with [[cells]]: use one FLEET")
        if source is not None and others.matching != own.matching:
            got = f"{own.matching:g} and {others.matching:g}"
            raise click.UsageError(f"matching must be the same in FLEET and --beside; got {got}")
        # The names are left out, because they may occur in both fleets.
        unnamed = (replace(group, name="") for group in others.groups)
        together = ds.Fleet((*own.groups, *unnamed), others.matching)
    if source is not None:
        return [VariedGroup({"group": name}, together, n) for n, name in enumerate(own.names)]
    columns = {} if robot is None else {"robot": own.groups[0].name}
    return [VariedGroup(columns, together, asked=hosts)]


@fleets.describe_matching
@click.command()
@options.option_group(
    "varied",
    _varied_groups,
    click.option(
        "--hosts", type=float, metavar="N", help="Number of your hosts, to see whether they fit."
    ),
    *fleets.count_options,
    *fleets.file_options,
    click.option("--beside", **options.FILE_ARGS, help="Fleet file of other hosts on the channel."),
)
@click.option(
    "--limit", type=float, default=1.0, show_default=True, help="Utilization to reach; 1 is 100%."
)
@options.protocol_option
@options.wifi_options
@options.output_options
def saturation(
    varied: Sequence[VariedGroup],
    limit: float,
    protocols: tuple[ds.Protocol, ...],
    wifi: Wifi,
    output: Output,
) -> None:
    """Compute how many identical hosts fill the channel with discovery traffic.

    With a fleet file, FLEET, the command varies one group at a time and keeps the others fixed. If
    the file has [[cells]], each row says how many hosts of a group fill the channel of one cell,
    even if the group is in another one. With --hosts, the command says whether that many hosts fit.

    {matching}

    \b
    Examples:
      discostorm saturation --processes 2 --endpoints 10
      discostorm saturation --robot turtlebot4 --hosts 12 --protocol all
      discostorm saturation --processes 1 --endpoints 678 --limit 0.5 --json
      discostorm saturation fleet.toml --protocol paper
    """
    own = varied[0].fleet
    channels = [
        replace(group, columns=group.columns | cell, fleet=fleet, wifi=own)
        for group in varied
        for cell, fleet, own in fleets.channels_by_cell(group.fleet, wifi)
    ]
    ranges = (aggregation_bounds(group.wifi) for group in channels)
    aggregates = any(full != single for full, single in ranges)
    cases = [(protocol, group) for protocol in protocols for group in channels]
    with out.bad_input(), out.show_slow_task("computing"):
        rows = [
            {"protocol": protocol.name} | _saturation_row(group, limit, protocol, aggregates)
            for protocol, group in cases
        ]
    saturated = [
        (protocol, group.fleet if row["hosts"] == math.inf else group.with_hosts(row["hosts"] or 1))
        for row, (protocol, group) in zip(rows, cases, strict=True)
    ]
    if not output.for_people:
        if any(protocol.captured for protocol in protocols):
            for row, (protocol, fleet) in zip(rows, saturated, strict=True):
                row |= fleets.error_band_columns(protocol, fleet)
        out.print_table(rows, output)
        return
    fleets.print_robot_name(rows, output)
    out.print_table([_without_unmeasured_hosts(row) for row in rows], output, _columns(rows[0]))
    fleets.print_channels(own, aggregation_bounds(wifi)[1], output)
    if any(row["more_than"] is not None for row in rows):
        out.print_note('"More than" means that we captured too few such hosts for a number.')
    if aggregates:
        out.print_note(wording.AGGREGATION_NOTE)
    if fleets.is_all_wired(own):
        out.print_note(wording.ALL_WIRED_NOTE)
    fleets.print_error_bands(saturated)


def _saturation_row(
    group: VariedGroup, limit: float, protocol: ds.Protocol, aggregates: bool
) -> dict[str, Any]:
    """Return the hosts that fill the channel, with one message per frame and full A-MPDUs."""
    full, single = aggregation_bounds(group.wifi)
    host = group.fleet.groups[group.index]
    hosts = _saturation_hosts(group, limit, protocol, single)
    row = group.columns | {
        "processes": float(host.processes),
        "endpoints": float(host.endpoints),
        "limit": limit,
        "hosts": hosts,
        "fit": _fitting_hosts(hosts),
        "more_than": _exceeded_maximum(protocol, host, hosts),
    }
    if group.asked is not None:
        row |= {"asked": group.asked, "asked_fit": hosts is not None and group.asked < hosts}
    if aggregates:
        maximum = _saturation_hosts(group, limit, protocol, full)
        row["more_than"] = row["more_than"] or _exceeded_maximum(protocol, host, maximum)
        row |= {"hosts_full_ampdus": maximum, "fit_full_ampdus": _fitting_hosts(maximum)}
    return row


def _saturation_hosts(
    group: VariedGroup, limit: float, protocol: ds.Protocol, wifi: Wifi
) -> float | None:
    """Return the number of hosts that fill the channel; None if a single host is too many."""
    if fleets.is_all_wired(group.fleet):
        return math.inf
    if limit > 0 and ds.utilization(protocol, group.with_hosts(1), wifi=wifi) > limit:
        return None
    fleet, index = group.fleet, group.index
    return float(ds.saturation_hosts(protocol, wifi=wifi, limit=limit, fleet=fleet, group=index))


def _fitting_hosts(hosts: float | None) -> float:
    if hosts is None:
        return 0
    return hosts if hosts == math.inf else wording.last_integer_below(hosts)


def _exceeded_maximum(protocol: ds.Protocol, host: ds.HostGroup, hosts: float | None) -> int | None:
    """Return the maximum number of hosts that a measured model covers; None if not exceeded."""
    if protocol.captured is None or hosts is None or hosts == math.inf:
        return None
    maximum = max_covered_hosts(protocol.captured, float(host.processes))
    return maximum if hosts > maximum else None


def _without_unmeasured_hosts(row: dict[str, Any]) -> dict[str, Any]:
    """Return a row that says "more than N" where no measurement covers the number of hosts."""
    maximum = row["more_than"]
    if maximum is None:
        return row
    names = ("hosts", "fit", "hosts_full_ampdus", "fit_full_ampdus")
    return row | {name: f"more than {maximum}" for name in names if (row.get(name) or 0) > maximum}


def _format_hosts(value: float | str | None) -> str:
    if value is None:
        return "less than 1"
    if value == math.inf:
        return "any number"
    return f"{value:.2f}" if isinstance(value, float) else str(value)


def _columns(row: dict[str, Any]) -> list[Column]:
    """Return the columns for people, without the counts of the input, for shorter lines."""
    asked, named = "asked" in row, "robot" in row
    return [
        *map(Column, ("protocol", "group", "cell")),
        *map(Column, () if asked or named else ("processes", "endpoints")),
        *(() if asked or "group" in row else (Column("limit", format=out.percent),)),
        Column("hosts", "saturated at" if asked else "saturated at hosts", _format_hosts),
        Column("fit", "hosts that fit", _format_hosts),
        Column("asked", "yours"),
        Column("asked_fit", "fit", out.format_bool),
        Column("hosts_full_ampdus", "with full A-MPDUs", _format_hosts),
        Column("fit_full_ampdus", "hosts that may fit", _format_hosts),
    ]
