"""The command ``discostorm breakdown``."""

from __future__ import annotations

import math
from typing import Any

import click

import discostorm as ds
from discostorm import _checks, words
from discostorm.cli.fleet_options import Members, says_what_matches, swarm_options
from discostorm.cli.options import output_options, protocol_option, wifi_options
from discostorm.cli.output import (
    Output,
    bad_input,
    percent,
    plain,
    print_channel,
    print_rows,
    working,
)
from discostorm.model import message_costs
from discostorm.wifi import Wifi

#: What a delivery is called where there is little room.
CASTS = {"unicast": "uni", "multicast": "multi"}


@says_what_matches
@click.command()
@swarm_options
@protocol_option
@wifi_options
@click.option(
    "--window",
    type=float,
    default=1.0,
    show_default=True,
    metavar="S",
    help="Count the messages of the first S seconds; the paper counts one second.",
)
@output_options
def breakdown(
    members: Members,
    protocols: tuple[ds.Protocol, ...],
    wifi: Wifi,
    window: float,
    output: Output,
) -> None:
    """Show the cost of each message type, on the uplink and on the downlink.

    {matching}

    \b
    Examples:
      discostorm breakdown --hosts 7 --processes 2 --endpoints 10 --protocol paper
      discostorm breakdown --robot turtlebot4 --hosts 12
      discostorm breakdown fleet.toml --csv
    """
    rows: list[dict[str, Any]] = []
    with bad_input(), working("computing"):
        fleet = members.fleet
        _checks.number("--window", window, _checks.LEAST_SECONDS, _checks.MOST_SECONDS)
        for chosen in protocols:
            costs = _in_all(message_costs(chosen, fleet, wifi, window), chosen, fleet, window)
            whole = math.fsum(row["uplink_s"] + row["downlink_s"] for row in costs)
            rows += [
                {"protocol": chosen.name}
                | row
                | {"share": (row["uplink_s"] + row["downlink_s"]) / whole}
                for row in costs
            ]
    if output.for_people:  # without what would make the lines too long
        payload = math.fsum(row["payload_bytes"] for row in rows)
        without = {"phase", "payload_bytes"}
        if len(protocols) == 1:
            click.echo(f"Protocol: {protocols[0].name}\n")
            without |= {"protocol"}
        sent = [row for row in rows if row["uplink_messages"] or row["downlink_s"]]
        rows = [{name: row[name] for name in row if name not in without} for row in sent or rows]
    print_rows(
        rows,
        output,
        {
            "cast": CASTS.__getitem__,
            "frame_bytes": "{:,.0f}".format,
            "uplink_messages": _count,
            "uplink_s": _seconds,
            "downlink_s": _seconds,
            "share": percent,
        },
        {
            "frame_bytes": "frame [B]",
            "uplink_messages": "messages",
            "uplink_s": "up [s]",
            "downlink_s": "down [s]",
        },
    )
    print_channel(wifi, output)
    if output.for_people:
        click.echo(
            f"Counted: the messages of the first {window:g} s, with {payload:,.0f} B of payload."
        )
        members.tell_alone()


def _count(value: float) -> str:
    return f"{value:,.0f}" if 10 <= value < words.HUGE else plain(float(f"{value:.2g}"))


def _seconds(value: float) -> str:
    return f"{value:,.4f}" if value < words.HUGE else f"{value:.3g}"


def _in_all(
    costs: list[dict[str, Any]], protocol: ds.Protocol, fleet: ds.Fleet, window: float
) -> list[dict[str, Any]]:
    """Return rows of what an average second costs as those of the whole window, with bytes."""
    columns = ("uplink_messages", "uplink_s", "downlink_s")
    rows = []
    for row, message in zip(costs, protocol.messages, strict=True):
        count = float(message.load(fleet)) * float(message.schedule.mean(window)) * window
        sent = {key: row[key] * window for key in columns}
        rows.append(row | sent | {"payload_bytes": count * message.payload.nominal})
    return rows
