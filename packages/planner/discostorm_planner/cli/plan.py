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
    Output,
    bad_input,
    percent,
    print_channel,
    print_rows,
    to_json,
    visible,
    working,
    yes,
)
from discostorm.fleet import Fleet
from discostorm.ros2 import usually_shared
from discostorm.wifi import Wifi


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
            fleet = _told(members.fleet, nodes, shared)
            answers = [ds.plan(fleet, protocol, wifi) for protocol in protocols]
        except ValueError as error:
            raise ValueError(f"{members.error_prefix}{error}") from error
    answer = answers[0]
    if paste is not None:
        with bad_input():
            if len(answers) > 1:
                raise ValueError("--paste needs one --protocol; got several")
            _print_pieces(answer, paste, output)
    elif output.as_csv:
        print_rows([row for each in answers for row in _remedies(each, len(answers))], output)
    elif output.as_json:
        found = [each.to_dict() for each in answers]
        click.echo(to_json(found if len(found) > 1 else found[0]))
    elif len(answers) > 1:
        _compare(answers, output)
    else:
        width = min(max(shutil.get_terminal_size().columns, 40), 79)
        click.echo(visible(answer.advice(width)))


def _remedies(answer: ds.Plan, many: int) -> list[dict[Any, Any]]:
    """Return a row for each remedy, which names the protocol where there are several."""
    rows = answer.to_frame().reset_index().to_dict("records")
    return [{"protocol": answer.protocol.name} | row for row in rows] if many > 1 else rows


def _compare(answers: list[ds.Plan], output: Output) -> None:
    """Print a table of the plans of several protocols: airtime, and the change that is best."""
    rows = []
    for answer in answers:
        best = next((remedies[0] for remedies in answer.told().values()), None)
        rows.append(
            {
                "protocol": answer.protocol.name,
                "utilization": answer.utilization,
                "fits": words.fits(answer.utilization),
                "saves": 0.0 if best is None else 1 - best.utilization / best.before,
                "best_change": "nothing" if best is None else best.what,
            }
        )
    print_rows(rows, output, {"utilization": percent, "fits": yes, "saves": percent})
    print_channel(answers[0].wifi, output)
    click.echo("Name one protocol for its plan: what dominates, and what each change costs.")


def _print_pieces(answer: ds.Plan, number: int, output: Output) -> None:
    """Print what to configure for a change of the advice, by its number there."""
    told = answer.numbered()
    if not told:
        raise ValueError("--paste needs a change to configure; nothing that was tried helps")
    _checks.whole("--paste", number, 1, len(told))
    chosen = told[number - 1]
    pieces = [piece.to_dict() for piece in chosen.snippets]
    if not pieces:
        raise ValueError(
            f"--paste: change {number}, {chosen.what}, is not done by configuration; choose another"
        )
    if not output.for_people:
        rows = [{"change": chosen.what, **piece} for piece in pieces]
        print_rows(rows, output)
        return
    # Beside the output, so that this is nothing but configuration.
    click.echo(visible(f"{words.capitalized(chosen.what)}:\n"), err=True)
    # Not escaped: it is to be copied as it is.
    click.echo("\n".join(piece["text"] for piece in pieces), nl=False)


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
