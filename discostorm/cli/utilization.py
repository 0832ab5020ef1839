"""The command ``discostorm utilization``."""

from __future__ import annotations

from typing import Any

import click

import discostorm as ds
from discostorm import wording
from discostorm.cli import fleet_options as fleets
from discostorm.cli.options import output_options, protocol_option, wifi_options
from discostorm.cli.output import (
    Column,
    Output,
    bad_input,
    format_bool,
    percent,
    print_channel,
    print_paragraph,
    print_table,
    show_slow_task,
)
from discostorm.wifi import Wifi
from discostorm.wifi.radio import aggregation_bounds

COLUMNS = (
    *map(Column, ("protocol", "fleet", "hosts", "processes", "endpoints")),
    Column("utilization", format=percent),
    Column("utilization_full_ampdus", "full A-MPDUs", percent),
    Column("fits", format=format_bool),
    Column("may_fit", format=format_bool),
    Column("data_utilization", "data", percent),
    Column("total_utilization", "both", percent),
)


@fleets.describe_matching
@click.command()
@fleets.several_swarms_options
@protocol_option
@wifi_options
@output_options
def utilization(
    members: list[fleets.FleetInput], protocols: tuple[ds.Protocol, ...], wifi: Wifi, output: Output
) -> None:
    """Compute the airtime that the discovery of a fleet needs in one second.

    Of a fleet file that lists topics ([[groups.data]]) the data have columns of their own.

    {matching}

    \b
    Examples:
      discostorm utilization --hosts 3,5,7 --processes 2 --endpoints 10
      discostorm utilization --robot turtlebot4 --hosts 12 --protocol cyclonedds
      discostorm utilization fleet.toml --protocol all --json
      discostorm utilization --hosts 7 --processes 2 --endpoints 10 \\
          --wifi '802.11ac 80 MHz 2x2'
    """
    ends = aggregation_bounds(wifi)
    cases = [(protocol, each) for protocol in protocols for each in members]
    banded = not output.for_people and any(protocol.captured for protocol in protocols)
    with bad_input(), show_slow_task("computing"):
        rows = [
            {"protocol": protocol.name}
            | each.columns
            | _discovery_utilization(protocol, each.fleet, *ends)
            | (fleets.error_band(protocol, each.fleet) if banded else {})
            | (_utilization_with_data(protocol, each.fleet, ends[1]) if each.fleet.has_data else {})
            for protocol, each in cases
        ]
    fleets.print_robot(rows, output)
    print_table(rows, output, COLUMNS)
    if output.for_people:
        print_channel(ends[1], output)
        if ends[0] != ends[1]:
            click.echo()
            print_paragraph(wording.AGGREGATES)
        if len(members) == 1:
            fleets.print_fleet_note(members[0].fleet)
        fleets.print_error_bands((protocol, each.fleet) for protocol, each in cases)


def _discovery_utilization(
    protocol: ds.Protocol, fleet: ds.Fleet, full: Wifi, single: Wifi
) -> dict[str, Any]:
    """Return utilization with one message per frame and, if it differs, with full A-MPDUs."""
    load = float(ds.utilization(protocol, fleet, wifi=single))
    if full == single:
        return {"utilization": load, "fits": wording.below_capacity(load)}
    minimum = float(ds.utilization(protocol, fleet, wifi=full))
    return {
        "utilization": load,
        "utilization_full_ampdus": minimum,
        "fits": wording.below_capacity(load),
        "may_fit": wording.below_capacity(minimum),
    }


def _utilization_with_data(protocol: ds.Protocol, fleet: ds.Fleet, wifi: Wifi) -> dict[str, float]:
    """Return the utilization of the fleet's data, and that of data and discovery."""
    data, discovery = (
        float(ds.utilization(protocol, fleet, wifi=wifi, phase=phase)) for phase in ("data", None)
    )
    return {"data_utilization": data, "total_utilization": discovery + data}
