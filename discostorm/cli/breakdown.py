"""The command ``discostorm breakdown``."""

import math
from typing import Any

import click

import discostorm as ds
from discostorm import _checks, wording
from discostorm.cli import fleet_options as fleets, output as out
from discostorm.cli.options import output_options, protocol_option, wifi_options
from discostorm.cli.output import Column, Output
from discostorm.model import message_costs
from discostorm.wifi import Wifi


def _format_count(value: float) -> str:
    return f"{value:,.0f}" if 10 <= value < wording.HUGE else out.as_text(float(f"{value:.2g}"))


def _format_seconds(value: float) -> str:
    return f"{value:,.4f}" if value < wording.HUGE else f"{value:.3g}"


COLUMNS = (
    *map(Column, ("cell", "message")),
    Column("cast", format={"unicast": "uni", "multicast": "multi"}.__getitem__),
    Column("frame_bytes", "frame", "{:,.0f}".format, "B"),
    Column("uplink_messages", "messages", _format_count),
    Column("uplink_s", "up", _format_seconds, "s"),
    Column("downlink_s", "down", _format_seconds, "s"),
    Column("share", format=out.percent),
)


@fleets.describe_matching
@click.command()
@fleets.swarm_options
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
    fleet_input: fleets.FleetInput,
    protocols: tuple[ds.Protocol, ...],
    wifi: Wifi,
    window: float,
    output: Output,
) -> None:
    """Show the airtime of each message type, on the uplink and on the downlink.

    {matching}

    \b
    Examples:
      discostorm breakdown --hosts 7 --processes 2 --endpoints 10 --protocol paper
      discostorm breakdown --robot turtlebot4 --hosts 12
      discostorm breakdown fleet.toml --csv
    """
    with out.bad_input(), out.show_slow_task("computing"):
        _checks.number("--window", window, _checks.MIN_SECONDS, _checks.MAX_SECONDS)
        channels = fleets.channels_by_cell(fleet_input.fleet, wifi)
        rows = [
            row
            for each in protocols
            for cell, fleet, own in channels
            for row in _message_rows(each, cell, fleet, own, window)
        ]
    columns: tuple[Column, ...] = (Column("protocol"), *COLUMNS)
    if output.for_people and len(protocols) == 1:
        out.print_paragraph(f"Protocol: {protocols[0].name}")
        click.echo()
        columns = COLUMNS
    sent = [row for row in rows if row["uplink_messages"] or row["downlink_s"]]
    out.print_table(sent or rows if output.for_people else rows, output, columns)
    if output.for_people:
        fleets.print_channels(fleet_input.fleet, wifi, output)
        payload = math.fsum(row["payload_bytes"] for row in rows) / len(channels)
        out.print_paragraph(
            f"The messages in the first {window:g} s carry {payload:,.0f} B of payload."
        )
        fleets.print_fleet_note(fleet_input.fleet)


def _message_rows(
    protocol: ds.Protocol, cell: dict[str, str], fleet: ds.Fleet, wifi: Wifi, window: float
) -> list[dict[str, Any]]:
    """Return a row for each message: its airtime in the whole window, and its share of all."""
    rows = []
    costs = message_costs(protocol, fleet, wifi, window)  # of an average second
    for message, cost in zip(protocol.messages, costs, strict=True):
        count = float(message.load(fleet)) * float(message.schedule.mean(window)) * window
        for key in ("uplink_messages", "uplink_s", "downlink_s"):
            cost[key] *= window
        payload = {"payload_bytes": count * message.payload.nominal}
        rows.append({"protocol": protocol.name} | cell | cost | payload)
    airtimes = [row["uplink_s"] + row["downlink_s"] for row in rows]
    total = math.fsum(airtimes) or 1.0  # nothing is sent by a single host, or by wired hosts
    return [row | {"share": each / total} for row, each in zip(rows, airtimes, strict=True)]
