"""The command ``discostorm utilization``."""

from typing import Any

import click

import discostorm as ds
from discostorm import wording
from discostorm.cli import fleet_options as fleets, output as out
from discostorm.cli.options import output_options, protocol_option, wifi_options
from discostorm.cli.output import Column, Output
from discostorm.wifi import Wifi
from discostorm.wifi.radio import aggregation_bounds

COLUMNS = (
    *map(Column, ("protocol", "fleet", "cell", "hosts", "processes", "endpoints")),
    Column("utilization", format=out.percent),
    Column("utilization_full_ampdus", "full A-MPDUs", out.percent),
    Column("fits", format=out.format_bool),
    Column("may_fit", format=out.format_bool),
    Column("data_utilization", "data", out.percent),
    Column("total_utilization", "both", out.percent),
)


@fleets.describe_matching
@click.command()
@fleets.several_swarms_options
@protocol_option
@wifi_options
@output_options
def utilization(
    inputs: list[fleets.FleetInput], protocols: tuple[ds.Protocol, ...], wifi: Wifi, output: Output
) -> None:
    """Compute the airtime that the discovery of a fleet needs in one second.

    If a fleet file lists topics ([[groups.data]]), their data gets separate columns. If it lists
    access points ([[cells]]), each gets a separate row.

    {matching}

    \b
    Examples:
      discostorm utilization --hosts 3,5,7 --processes 2 --endpoints 10
      discostorm utilization --robot turtlebot4 --hosts 12 --protocol cyclonedds
      discostorm utilization fleet.toml --protocol all --json
      discostorm utilization --hosts 7 --processes 2 --endpoints 10 \\
          --wifi '802.11ac 80 MHz 2x2'
    """
    channels = [
        (each.columns | cell, fleet, *aggregation_bounds(own))
        for each in inputs
        for cell, fleet, own in fleets.channels_by_cell(each.fleet, wifi)
    ]
    aggregates = any(full != single for _, _, full, single in channels)
    cases = [(protocol, *channel) for protocol in protocols for channel in channels]
    banded = not output.for_people and any(protocol.captured for protocol in protocols)
    with out.bad_input(), out.show_slow_task("computing"):
        rows = [
            {"protocol": protocol.name}
            | columns
            | _discovery_utilization(protocol, fleet, full if aggregates else None, single)
            | (fleets.error_band_columns(protocol, fleet) if banded else {})
            | (_utilization_with_data(protocol, fleet, single) if fleet.has_data else {})
            for protocol, columns, fleet, full, single in cases
        ]
    fleets.print_robot_name(rows, output)
    out.print_table(rows, output, COLUMNS)
    if output.for_people:
        fleets.print_channels(inputs[0].fleet, channels[0][-1], output)
        if aggregates:
            out.print_note(wording.AGGREGATION_NOTE)
        if len(inputs) == 1:
            fleets.print_fleet_note(inputs[0].fleet)
        fleets.print_error_bands((protocol, fleet) for protocol, _, fleet, _, _ in cases)


def _discovery_utilization(
    protocol: ds.Protocol, fleet: ds.Fleet, full: Wifi | None, single: Wifi
) -> dict[str, Any]:
    """Return utilization with one message per frame and, if requested, with full A-MPDUs."""
    channels = {"utilization": single} | ({"utilization_full_ampdus": full} if full else {})
    loads = {key: float(ds.utilization(protocol, fleet, wifi=w)) for key, w in channels.items()}
    fits = map(wording.below_capacity, loads.values())
    return loads | dict(zip(("fits", "may_fit"), fits, strict=False))


def _utilization_with_data(protocol: ds.Protocol, fleet: ds.Fleet, wifi: Wifi) -> dict[str, float]:
    """Return the utilization of user data alone, and of user data and discovery together."""
    data, discovery = (
        float(ds.utilization(protocol, fleet, wifi=wifi, phase=phase)) for phase in ("data", None)
    )
    return {"data_utilization": data, "total_utilization": discovery + data}
