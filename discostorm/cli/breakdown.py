"""The command ``discostorm breakdown``."""

from __future__ import annotations

import math
from typing import Any

import click

import discostorm as ds
from discostorm.cli.fleets import Members, says_what_matches, swarm_options
from discostorm.cli.options import output_options, protocol_option, wifi_options
from discostorm.cli.output import (
    Output,
    bad_input,
    percent,
    print_channel,
    print_rows,
    seconds,
    working,
)
from discostorm.model import message_costs
from discostorm.wifi import Wifi


@says_what_matches
@click.command()
@swarm_options
@protocol_option
@wifi_options
@output_options
def breakdown(
    members: Members, protocols: tuple[ds.Protocol, ...], wifi: Wifi, output: Output
) -> None:
    """Show what each message of the discovery costs, up to the access point and down.

    {matching}

    \b
    Examples:
      discostorm breakdown --hosts 7 --processes 2 --endpoints 10 --protocol dds
      discostorm breakdown fleet.toml --csv
    """
    if isinstance(members.arguments["hosts"], list):
        raise click.UsageError("--hosts must be one number here")
    rows: list[dict[str, Any]] = []
    with bad_input(), working("computing"):
        fleet = members.fleet
        for chosen in protocols:
            costs = message_costs(chosen, fleet, wifi)
            whole = math.fsum(row["uplink_s"] + row["downlink_s"] for row in costs)
            rows += [
                {"protocol": chosen.name}
                | row
                | {"share": (row["uplink_s"] + row["downlink_s"]) / whole}
                for row in costs
            ]
    if output.for_people:  # without what would make the lines too long
        rows = [{name: row[name] for name in row if name != "phase"} for row in rows]
    print_rows(
        rows,
        output,
        {"uplink_s": seconds, "downlink_s": seconds, "share": percent},
        {
            "frame_bytes": "frame [B]",
            "uplink_messages": "messages",
            "uplink_s": "up [s]",
            "downlink_s": "down [s]",
        },
    )
    print_channel(wifi, output)
    if output.for_people:
        members.tell_alone()
