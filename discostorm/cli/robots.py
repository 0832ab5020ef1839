"""The command ``discostorm robots``."""

from __future__ import annotations

import click

from discostorm import robots as ready_made, words
from discostorm.cli.options import output_options
from discostorm.cli.output import Output, print_rows
from discostorm.data import read_data


@click.command()
@output_options
def robots(output: Output) -> None:
    """List the ready-made robots for --robot.

    Endpoints are the mean over a robot's processes. The numbers are printed in the paper, counted
    in source code, or estimated; CSV and JSON have the source of each part.

    \b
    Examples:
      discostorm robots
      discostorm plan --robot turtlebot4 --hosts 12
    """
    parts = read_data("fleets/robots.csv")
    rows = []
    for name, host in ready_made.robots().items():
        own = [part for part in parts if part["robot"] == name]
        rows.append(
            {
                "robot": name,
                "processes": float(host.processes),
                "endpoints": float(host.endpoints),
                "nodes": float(host.processes * (host.nodes or 0)),
                "numbers": ", ".join(dict.fromkeys(part["kind"] for part in own)),
                "also": ", ".join(_aliases(name)),
                "source": "; ".join(f"{part['part']}: {part['source']}" for part in own),
            }
        )
    if not output.for_people:
        print_rows(rows, output)
        return
    shown = ["robot", "processes", "endpoints", "nodes", "numbers"]
    print_rows(
        [{name: row[name] for name in shown} for row in rows],
        output,
        {"endpoints": "{:,.4g}".format, "nodes": "{:.3g}".format},
    )
    short = "; ".join(" or ".join(_aliases(row["robot"])) for row in rows)
    told = (
        "Endpoints of each process, nodes of the whole robot. --robot takes shorter names, too, in "
        f"this order: {short}. Case, spaces and hyphens don't matter: turtlebot4."
    )
    click.echo(f"\n{words.wrapped(told)}")


def _aliases(name: object) -> list[str]:
    return [also for also, of in ready_made.aliases().items() if of == name]
