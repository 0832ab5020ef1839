"""The command ``discostorm plan``."""

from __future__ import annotations

import shutil
import sys
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

import discostorm as ds
from discostorm import wording
from discostorm.cli.fleet_options import FleetInput, swarm_options
from discostorm.cli.options import output_options, parse_number_list, protocol_option, wifi_options
from discostorm.cli.output import (
    Column,
    Output,
    bad_input,
    format_bool,
    is_live_terminal,
    percent,
    print_channel,
    print_table,
    show_slow_task,
    to_json,
    visible,
)
from discostorm.files import write_folder
from discostorm.fleet import Fleet
from discostorm.ros2 import usually_shared
from discostorm.snippets import set_window
from discostorm.wifi import Wifi
from discostorm_planner.discovery import WITHIN, start_window
from discostorm_planner.remedy import Remedy
from discostorm_planner.written_folder import folder_texts

#: Estimated simulations from which progress is shown [s].
_LONG_WORK = 2.0
#: Of the table that compares protocols.
COMPARED = (
    Column("protocol"),
    Column("utilization", format=percent),
    Column("fits", format=format_bool),
    Column("saves", format=percent),
    Column("best_change"),
)


@click.command()
@swarm_options
@protocol_option
@click.option(
    "--nodes",
    callback=parse_number_list,
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
    "--within",
    type=float,
    metavar="SECONDS",
    help="Target of the discovery time: a startup works if nine of ten simulated runs meet it.  "
    f"[default: that of the file, else {WITHIN:g}]",
)
@click.option("--all", "every", is_flag=True, help="Name all changes that were tried.")
@click.option(
    "--why",
    is_flag=True,
    help="Add explanations: drain time, airtime and its parts, configurations, assumptions.",
)
@click.option(
    "--paste",
    metavar="NAME",
    help="Print the configuration of a change, with the lines that load it.",
)
@click.option(
    "--write",
    "folder",
    metavar="DIR",
    help="Write this configuration, or that of the first change that suffices, for each host into "
    "a folder, with a README.",
)
@click.option("--force", is_flag=True, help="Let --write replace files.")
@wifi_options
@output_options
def plan(
    members: FleetInput,
    protocols: tuple[ds.Protocol, ...],
    nodes: Any,
    shared: float | None,
    within: float | None,
    every: bool,
    why: bool,
    paste: str | None,
    folder: str | None,
    force: bool,
    wifi: Wifi,
    output: Output,
) -> None:
    """Say whether a fleet's startup works, and what to change first.

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

    Above the groups, within = 20 sets the target. A group of ready-made robots has robot =
    "turtlebot4" in place of processes and endpoints. Processes of unlike size are tables below
    their group, in place of its processes and endpoints:

    \b
      [[groups.processes]]
      count = 2
      endpoints = 40

    What robots send besides discovery is a table for each topic, below its group. The ready-made
    topics scan, odometry, tf, camera, point cloud and map know their rate and size:

    \b
      [[groups.data]]
      topic = "scan"
      to = "wired host"   # or "one host", "all others", "multicast"
      rate = 10           # of each host [Hz]; with bytes and reliable for topics of your own

    The answer is the discovery time: until every process knows every endpoint that it should.
    The fleet and its most promising changes are simulated, 10 times each, or 3 times if a run
    takes long. Changes come in the order of their effort. Ctrl-C prints what is known by then.

    \b
    Examples:
      discostorm plan fleet.toml
      discostorm plan --robot turtlebot4 --hosts 12 --protocol cyclonedds
      discostorm plan --hosts 12 --processes 2 --endpoints 40 --protocol all
      discostorm plan fleet.toml --protocol rmw_zenoh_cpp --wifi '802.11n 20 MHz'
      discostorm plan fleet.toml --nodes 13,2 --json
      discostorm plan fleet.toml --within 20 --all
      discostorm plan fleet.toml --protocol 'fast dds' --paste 'discovery server'
      discostorm plan fleet.toml --paste 'discovery server' --write for_my_robots
    """
    with bad_input(), show_slow_task("planning"):
        try:
            fleet = _add_counts(members.fleet, nodes, shared)
            plans = [ds.plan(fleet, protocol, wifi, within=within) for protocol in protocols]
        except ValueError as error:
            raise ValueError(f"{members.error_prefix}{error}") from error
    if force and folder is None:
        raise click.UsageError("--force goes with --write")
    if paste is not None or folder is not None:
        with bad_input():
            if len(plans) > 1:
                option = "--paste" if folder is None else "--write"
                raise ValueError(f"{option} needs one --protocol; got several")
            if folder is None:
                _print_configuration(plans[0], str(paste), output)
            else:
                _write_configuration(plans[0], paste, folder, force)
    elif output.as_csv:
        print_table([row for each in plans for row in _remedy_rows(each, len(plans) > 1)], output)
    elif output.as_json:
        if len(plans) > 1:
            click.echo(to_json([each.to_dict(simulate=False) for each in plans]))
            return
        _simulate(plans[0])
        click.echo(to_json(plans[0].to_dict()))
    elif len(plans) > 1:
        _print_comparison(plans, output)
    else:
        width = min(max(shutil.get_terminal_size().columns, 40), 79)
        _simulate(plans[0])
        click.echo(visible(plans[0].advice(width, every=every)))
        if why:
            click.echo("\n" + visible(plans[0].why(width)))


def _simulate(answer: ds.Plan) -> None:
    """Simulate a plan; say on standard error how far it is, if it takes long."""
    if answer.all_wired or answer.fleet.hosts() == 1:
        return
    with ExitStack() as shown:
        bars: list[Any] = []

        def show(done: float, total: float) -> None:
            if is_live_terminal() and not bars and total > _LONG_WORK:
                busy = wording.durations(*answer.startup.ends, never="ever")
                say = f"If nothing is lost, startup keeps the channel busy for {busy}. Simulating"
                click.echo(f"{say} it and its changes; Ctrl-C prints what is known.", err=True)
                bar = click.progressbar(length=int(100 * total), label="runs", file=sys.stderr)
                bars.append(shown.enter_context(bar))
            if bars:
                bars[0].update(max(0, int(100 * done) - bars[0].pos))

        answer.simulate(show, interruptible=True)


def _remedy_rows(answer: ds.Plan, named: bool) -> list[dict[Any, Any]]:
    """Return a row for each remedy, with the name of the protocol if there are several."""
    rows = answer.to_frame().reset_index().to_dict("records")
    return [{"protocol": answer.protocol.name} | row for row in rows] if named else rows


def _print_comparison(plans: list[ds.Plan], output: Output) -> None:
    """Print a row for each protocol: its airtime, and its best change."""
    rows = []
    for answer in plans:
        best = next((r for section in answer.sections().values() for r in section), None)
        rows.append(
            {
                "protocol": answer.protocol.name,
                "utilization": answer.utilization,
                "fits": wording.below_capacity(answer.utilization),
                "saves": 0.0 if best is None else best.saved,
                "best_change": "nothing" if best is None else best.what,
            }
        )
    print_table(rows, output, COMPARED)
    print_channel(plans[0].wifi, output)
    click.echo("Name one protocol for its discovery time, and what each change makes of it.")


def _configured_change(answer: ds.Plan, name: str) -> Remedy:
    """Return a change that is done by configuration, by its name in the advice."""
    try:
        remedy = answer.change_named(name)
        if not remedy.snippets:
            raise ValueError(f"{remedy.what} is not done by configuration; choose another change")
    except ValueError as error:
        raise ValueError(f"--paste: {error}") from error
    return remedy


def _write_configuration(answer: ds.Plan, name: str | None, folder: str, force: bool) -> None:
    """Write what to configure for a change, or for the first that suffices, into a folder."""
    if name is None:
        _simulate(answer)
        enough = [c.name for c in answer.discovery.sufficient if c.remedy.snippets]
        if answer.discovery.works or not enough:
            works = answer.discovery.works
            why = "the startup works as it is" if works else "no change of files suffices"
            raise ValueError(f"--write: {why}; name a change with --paste")
        name = enough[0]
    remedy = _configured_change(answer, name)
    files = folder_texts(answer.fleet, remedy, answer.within)
    try:
        write_folder(Path(folder), files, replace=force)
    except ValueError as error:
        raise ValueError(f"--write: {error}") from error
    said = f"{wording.capitalized(remedy.what)}: {len(files)} files. Begin with"
    click.echo(visible(f"{said} {Path(folder) / 'README.md'}"))


def _print_configuration(answer: ds.Plan, name: str, output: Output) -> None:
    """Print what to configure for a change, by its name in the advice."""
    remedy = _configured_change(answer, name)
    pieces = [piece.to_dict() for piece in remedy.snippets]
    if window := start_window(remedy, answer.within):
        for piece in pieces:
            piece["text"] = set_window(piece["text"], window)
    if not output.for_people:
        print_table([{"change": remedy.what, **piece} for piece in pieces], output)
        return
    # On standard error, so that the output is nothing but configuration.
    click.echo(visible(f"{wording.capitalized(remedy.what)}:\n"), err=True)
    # Not escaped: it is to be copied as it is.
    click.echo("\n".join(piece["text"] for piece in pieces), nl=False)


def _add_counts(fleet: Fleet, nodes: float | list[float] | None, shared: float | None) -> Fleet:
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
