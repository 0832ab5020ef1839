"""The command ``discostorm robots``."""

import click

from discostorm import robots as ready_made
from discostorm.cli.options import output_options
from discostorm.cli.output import Column, Output, print_note, print_table
from discostorm.data import read_data

COLUMNS = (
    *map(Column, ("robot", "processes")),
    Column("endpoints", format="{:,.4g}".format),
    Column("nodes", format="{:.3g}".format),
    Column("numbers"),
)


@click.command()
@output_options
def robots(output: Output) -> None:
    """List the ready-made robots and the operator's laptop, for --robot and fleet files.

    Endpoint counts are means over a robot's processes. CSV and JSON output also names sources.

    \b
    Examples:
      discostorm robots
      discostorm plan --robot turtlebot4 --hosts 12
    """
    rows, aliases = [], []
    laptop = [{"kind": "counted"} | part for part in read_data("fleets/rviz_endpoints.csv")]
    for name, host in (*ready_made.robots().items(), ("laptop", ready_made.laptop())):
        parts = [part for part in read_data("fleets/robots.csv") if part["robot"] == name] or laptop
        own = [alias for alias, robot in ready_made.aliases().items() if robot == name]
        aliases += [" or ".join(own)] * bool(own)
        rows.append(
            {
                "robot": name,
                "processes": float(host.processes),
                "endpoints": float(host.endpoints),
                "nodes": float(host.processes * (host.nodes or 0)),
                "numbers": ", ".join(dict.fromkeys(part["kind"] for part in parts)),
                "also": ", ".join(own),
                "source": "; ".join(f"{part['part']}: {part['source']}" for part in parts),
            }
        )
    print_table(rows, output, COLUMNS)
    if output.for_people:
        print_note(
            "Endpoints are counted per process, and nodes per robot. --robot also accepts short "
            f"names, in the order of the table: {'; '.join(aliases)}. Case, spaces and hyphens "
            "don't matter, so turtlebot4 works, too."
        )
