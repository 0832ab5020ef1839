"""The command ``discostorm fleet``."""

from __future__ import annotations

import json
from pathlib import Path

import click

import discostorm as ds
from discostorm import _checks, wording
from discostorm.cli.fleet_options import display_name, standard_input
from discostorm.cli.options import FILE_ARGS, output_options
from discostorm.cli.output import BadInput, Output, bad_input, print_table, to_json, visible
from discostorm_planner import ros2_output


@click.command()
@click.option(
    "--from",
    "file",
    **FILE_ARGS,
    required=True,
    help="File with the output of ROS 2 commands, or - for standard input.",
)
@click.option(
    "--hosts",
    type=float,
    metavar="N",
    help="Number of robots, if the text describes only one.",
)
@click.option(
    "--processes",
    type=float,
    metavar="N",
    help="Processes on each robot.  [default: one for each node, the maximum]",
)
@output_options
def fleet(file: str, hosts: float | None, processes: float | None, output: Output) -> None:
    """Write a fleet file from the output of ROS 2 commands.

    FILE holds the output of `ros2 node list`, `ros2 node info` or `ros2 topic list -v`, or of
    several of these, one after the other. To write such a file:

    \b
      (ros2 node list; for node in $(ros2 node list); do ros2 node info $node; done) > ros2.txt

    Comments in the resulting fleet file say what ROS 2 does not report, and which of these commands
    we never tried on a live system.

    \b
    Examples:
      discostorm fleet --from ros2.txt
      discostorm fleet --from ros2.txt --hosts 12 --processes 3 > fleet.toml
    """
    with bad_input():
        graph = ros2_output.parse_ros2_output(_read_input(file), display_name(file))
        described, notes = ros2_output.fleet_from_graph(graph, hosts, processes)
    notes = [ros2_output.describe_formats(graph), *notes]
    rows = described.to_dicts()
    if output.as_json:
        click.echo(to_json({"groups": rows, "notes": notes}))
    elif output.as_csv:
        print_table(rows, output)
    else:
        click.echo(visible(_fleet_file_text(described, notes)), nl=False)


def _read_input(file: str) -> str:
    try:
        if file == "-":
            return standard_input().read().decode("utf-8")
        return Path(_checks.path("--from", file, "a text file")).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise BadInput(f"{display_name(file)} must be text in UTF-8, as ROS 2 prints it") from None


def _fleet_file_text(described: ds.Fleet, notes: list[str]) -> str:
    lines = [f"# {line}" for note in notes for line in wording.wrap(f"{note}.", 77).splitlines()]
    for group in described.groups:
        lines += ["", "[[groups]]", f"name = {json.dumps(group.name)}"]
        for key in ("hosts", "processes", "endpoints", "nodes"):
            lines.append(f"{key} = {getattr(group, key):.12g}")
    return "\n".join([*lines, ""])
