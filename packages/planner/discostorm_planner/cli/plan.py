"""The command ``discostorm plan``."""

from __future__ import annotations

import shutil
from dataclasses import replace
from typing import Any

import click

import discostorm as ds
from discostorm import _checks, words
from discostorm.cli.fleet_options import FleetInput, swarm_options
from discostorm.cli.options import numbers, output_options, protocol_option, wifi_options
from discostorm.cli.output import (
    Column,
    Output,
    bad_input,
    percent,
    print_channel,
    print_table,
    to_json,
    visible,
    working,
    yes,
)
from discostorm.fleet import Fleet
from discostorm.ros2 import usually_shared
from discostorm.wifi import Wifi

#: Of the table that compares protocols.
COMPARED = (
    Column("protocol"),
    Column("utilization", format=percent),
    Column("fits", format=yes),
    Column("saves", format=percent),
    Column("best_change"),
)


@click.command()
@swarm_options
@protocol_option
@click.option(
    "--nodes",
    callback=numbers,
    metavar="N[,N...]",
    help="Nodes with parameter services in each process; commas separate the groups.  "
    "[default: those of the file, else 1 if the endpoints suffice]",
)
@click.option(
    "--shared",
    type=float,
    metavar="N",
    help="Endpoints of each process that match one in every other process despite namespaces; 0 "
    "without ROS 2.  [default: those of ROS 2, 2 and 2 more for each node; without the number of "
    "nodes, as many as ready-made robots of that size have]",
)
@click.option(
    "--paste",
    type=int,
    metavar="N",
    help="Print the configuration of change N, with the lines that load it.",
)
@wifi_options
@output_options
def plan(
    members: FleetInput,
    protocols: tuple[ds.Protocol, ...],
    nodes: Any,
    shared: float | None,
    paste: int | None,
    wifi: Wifi,
    output: Output,
) -> None:
    """Show what dominates the discovery of a fleet, and rank the changes that help.

    Describe the fleet by a ready-made robot, by your own counts, or by FLEET: a TOML file, or - for
    standard input, with a table for each group of identical hosts:

    \b
      [[groups]]
      name = "robots"
      hosts = 10
      processes = 1       # on each host
      endpoints = 678     # in each process
      nodes = 13          # with parameter services; optional
      shared = 28         # match in every other process; optional

    What robots send besides discovery is a table for each topic, below its group. The ready-made
    topics scan, odometry, tf, camera, point cloud and map know their rate and size:

    \b
      [[groups.data]]
      topic = "scan"
      to = "wired host"   # or "one host", "all others", "multicast"
      rate = 10           # of each host [Hz]; with bytes and reliable for topics of your own

    The answer comes first: the discovery time, or else the drain time of the channel. Radios from
    802.11n on aggregate, so both are ranges from full A-MPDUs to one message per frame. Changes are
    numbered; --paste N prints the configuration of one.

    \b
    Examples:
      discostorm plan fleet.toml
      discostorm plan --robot turtlebot4 --hosts 12 --protocol cyclonedds
      discostorm plan --hosts 12 --processes 2 --endpoints 40 --protocol all
      discostorm plan fleet.toml --protocol rmw_zenoh_cpp --wifi '802.11n 20 MHz'
      discostorm plan fleet.toml --nodes 13,2 --json
      discostorm plan fleet.toml --protocol 'fast dds' --paste 1
    """
    with bad_input(), working("planning"):
        try:
            fleet = _with_counts(members.fleet, nodes, shared)
            plans = [ds.plan(fleet, protocol, wifi) for protocol in protocols]
        except ValueError as error:
            raise ValueError(f"{members.error_prefix}{error}") from error
    if paste is not None:
        with bad_input():
            if len(plans) > 1:
                raise ValueError("--paste needs one --protocol; got several")
            _print_configuration(plans[0], paste, output)
    elif output.as_csv:
        print_table([row for each in plans for row in _remedy_rows(each, len(plans) > 1)], output)
    elif output.as_json:
        answers = [each.to_dict() for each in plans]
        click.echo(to_json(answers if len(answers) > 1 else answers[0]))
    elif len(plans) > 1:
        _print_comparison(plans, output)
    else:
        width = min(max(shutil.get_terminal_size().columns, 40), 79)
        click.echo(visible(plans[0].advice(width)))


def _remedy_rows(answer: ds.Plan, named: bool) -> list[dict[Any, Any]]:
    """Return a row for each remedy, with the name of the protocol if there are several."""
    rows = answer.to_frame().reset_index().to_dict("records")
    return [{"protocol": answer.protocol.name} | row for row in rows] if named else rows


def _print_comparison(plans: list[ds.Plan], output: Output) -> None:
    """Print a row for each protocol: its airtime, and its best change."""
    rows = []
    for answer in plans:
        best = next(iter(answer.numbered_remedies()), None)
        rows.append(
            {
                "protocol": answer.protocol.name,
                "utilization": answer.utilization,
                "fits": words.below_capacity(answer.utilization),
                "saves": 0.0 if best is None else best.saved,
                "best_change": "nothing" if best is None else best.what,
            }
        )
    print_table(rows, output, COMPARED)
    print_channel(plans[0].wifi, output)
    click.echo("Name one protocol for its plan: what dominates, and what each change costs.")


def _print_configuration(answer: ds.Plan, number: int, output: Output) -> None:
    """Print what to configure for a change of the advice, by its number there."""
    remedies = answer.numbered_remedies()
    if not remedies:
        raise ValueError("--paste needs a change to configure; nothing that was tried helps")
    _checks.integer("--paste", number, 1, len(remedies))
    remedy = remedies[number - 1]
    pieces = [piece.to_dict() for piece in remedy.snippets]
    if not pieces:
        raise ValueError(
            f"--paste: change {number}, {remedy.what}, is not done by configuration; choose another"
        )
    if not output.for_people:
        print_table([{"change": remedy.what, **piece} for piece in pieces], output)
        return
    # On standard error, so that the output is nothing but configuration.
    click.echo(visible(f"{words.capitalized(remedy.what)}:\n"), err=True)
    # Not escaped: it is to be copied as it is.
    click.echo("\n".join(piece["text"] for piece in pieces), nl=False)


def _with_counts(fleet: Fleet, nodes: float | list[float] | None, shared: float | None) -> Fleet:
    """Give the groups of a fleet the nodes and shared endpoints of the options, if there are."""
    count = len(fleet.groups)
    of_groups = nodes if isinstance(nodes, list) else [nodes] * count
    if len(of_groups) != count:
        raise ValueError(
            f"nodes must be one number, or one for each of {count} groups; got {nodes}"
        )
    groups = []
    for group, own in zip(fleet.groups, of_groups, strict=True):
        changed = group if own is None else replace(group, nodes=own)
        if shared is not None:
            changed = replace(changed, shared=shared)
        elif group.shared == usually_shared(group.endpoints, group.nodes):
            # ROS 2 shares more for more nodes; what a file says stays.
            changed = replace(changed, shared=usually_shared(group.endpoints, changed.nodes))
        groups.append(changed)
    return replace(fleet, groups=tuple(groups))
