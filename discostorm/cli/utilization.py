"""The command ``discostorm utilization``."""

from __future__ import annotations

from typing import Any

import click

import discostorm as ds
from discostorm import words
from discostorm.cli.fleet_options import (
    Members,
    error_band,
    say_bands,
    says_what_matches,
    several_swarms_options,
    without_robot,
)
from discostorm.cli.options import output_options, protocol_option, wifi_options
from discostorm.cli.output import (
    Output,
    bad_input,
    percent,
    print_channel,
    print_rows,
    working,
    yes,
)
from discostorm.wifi import Wifi
from discostorm.wifi.radio import both_ends


@says_what_matches
@click.command()
@several_swarms_options
@protocol_option
@wifi_options
@output_options
def utilization(
    members: list[Members], protocols: tuple[ds.Protocol, ...], wifi: Wifi, output: Output
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
    rows: list[dict[str, Any]] = []
    ends = both_ends(wifi)
    aggregates = ends[0] != ends[1]
    banded = not output.for_people and any(table.captured for table in protocols)
    with bad_input(), working("computing"):
        for chosen in protocols:
            for one in members:
                least, taken = (float(ds.utilization(chosen, one.fleet, wifi=end)) for end in ends)
                rows.append(
                    {"protocol": chosen.name}
                    | one.columns
                    | {"utilization": taken}
                    | ({"utilization_full_ampdus": least} if aggregates else {})
                    | {"fits": words.fits(taken)}
                    | ({"may_fit": words.fits(least)} if aggregates else {})
                    | (error_band(chosen, one.fleet) if banded else {})
                    | (_data(chosen, one.fleet, ends[1], taken) if one.fleet.has_data else {})
                )
    print_rows(
        without_robot(rows, output),
        output,
        {
            **{"utilization": percent, "utilization_full_ampdus": percent, "fits": yes},
            **{"may_fit": yes, "data_utilization": percent, "total_utilization": percent},
        },
        {
            "utilization_full_ampdus": "full A-MPDUs",
            "may_fit": "may fit",
            "data_utilization": "data",
            "total_utilization": "both",
        },
    )
    print_channel(ends[1], output)
    if aggregates and output.for_people:
        click.echo(f"\n{words.AGGREGATES}")
    if output.for_people and len(members) == 1:
        members[0].tell_alone()
    say_bands(((table, one.fleet) for table in protocols for one in members), output)


def _data(protocol: ds.Protocol, fleet: ds.Fleet, wifi: Wifi, taken: float) -> dict[str, float]:
    """Return what the fleet's data take beside discovery, and both together."""
    data = float(ds.utilization(protocol, fleet, wifi=wifi, phase="data"))
    return {"data_utilization": data, "total_utilization": taken + data}
