"""The command ``discostorm plan``."""

from __future__ import annotations

import shutil
from dataclasses import replace
from typing import Any

import click

import discostorm as ds
from discostorm.cli.fleets import called, file_option, read
from discostorm.cli.options import numbers, one_protocol_option, output_options, wifi_options
from discostorm.cli.output import Output, as_text, bad_input, print_rows, visible, working
from discostorm.fleet import Fleet
from discostorm.ros2 import usually_shared
from discostorm.wifi import Wifi


@click.command()
@file_option
@one_protocol_option
@click.option(
    "--nodes",
    callback=numbers,
    metavar="N[,N...]",
    help="Nodes with parameter services in each process; with commas, one number for each "
    "group.  [default: those of the file, else 1 where the endpoints are enough]",
)
@click.option(
    "--shared",
    type=float,
    metavar="N",
    help="Endpoints of each process that match one in every other, whatever its namespace; 0 "
    "without ROS 2.  [default: what ROS 2 shares: 2, and 2 more for each node; where nobody says "
    "how many nodes, as many as ready-made robots have for so many endpoints]",
)
@wifi_options
@output_options
def plan(
    file: str,
    protocol: ds.Protocol,
    nodes: Any,
    shared: float | None,
    wifi: Wifi,
    output: Output,
) -> None:
    """Tell what dominates the discovery of a fleet, and what would help most.

    FLEET is a TOML file, or - for standard input, with a table for each group of like hosts:

    \b
      [[groups]]
      name = "robots"
      hosts = 10
      processes = 1       # of each host
      endpoints = 678     # of each process
      nodes = 13          # with parameter services; may be left out
      shared = 28         # match in every other process; may be left out

    What to paste for a remedy is in the JSON; it is easiest copied from the page of the book
    with the calculator.

    \b
    Examples:
      discostorm plan fleet.toml
      discostorm plan fleet.toml --protocol zenoh --wifi '802.11n 20 MHz 2x2'
      discostorm plan fleet.toml --nodes 13,2 --json
    """
    with bad_input(), working("planning"):
        members = read(file)
        try:
            answer = ds.plan(_told(members, nodes, shared), protocol, wifi)
        except ValueError as error:
            raise ValueError(f"{called(file)}: {error}") from error
    if output.as_csv:
        print_rows(answer.to_frame().reset_index().to_dict("records"), output)
    elif output.as_json:
        click.echo(as_text(answer.to_dict()))
    else:
        width = min(max(shutil.get_terminal_size().columns, 40), 79)
        click.echo(visible(answer.advice(width)))


def _told(fleet: Fleet, nodes: float | list[float] | None, shared: float | None) -> Fleet:
    """Return the fleet with the nodes and the shared endpoints of the options, where there are."""
    many = len(fleet.groups)
    own = nodes if isinstance(nodes, list) else [nodes] * many
    if len(own) != many:
        raise ValueError(f"nodes must be one number, or one for each of {many} groups; got {nodes}")
    groups = []
    for group, told in zip(fleet.groups, own, strict=True):
        changed = group if told is None else replace(group, nodes=told)
        if shared is not None:
            changed = replace(changed, shared=shared)
        elif group.shared == usually_shared(group.endpoints, group.nodes):
            # What ROS 2 shares for its nodes is that of other nodes now; what a file says stays.
            changed = replace(changed, shared=usually_shared(group.endpoints, changed.nodes))
        groups.append(changed)
    return replace(fleet, groups=tuple(groups))
