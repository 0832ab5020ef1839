"""The command ``discostorm utilization``."""

from __future__ import annotations

from typing import Any

import click

import discostorm as ds
from discostorm import words
from discostorm.cli.fleets import Members, says_what_matches, several_swarms_options
from discostorm.cli.options import output_options, protocol_option, wifi_options
from discostorm.cli.output import Output, bad_input, percent, print_channel, print_rows, working
from discostorm.wifi import Wifi


@says_what_matches
@click.command()
@several_swarms_options
@protocol_option
@wifi_options
@output_options
def utilization(
    members: Members, protocols: tuple[ds.Protocol, ...], wifi: Wifi, output: Output
) -> None:
    """Compute the airtime of discovery in one second, of a swarm or of a fleet file.

    {matching}

    \b
    Examples:
      discostorm utilization --hosts 3,5,7 --processes 2 --endpoints 10
      discostorm utilization fleet.toml --protocol zenoh --json
      discostorm utilization --hosts 7 --processes 2 --endpoints 10 \\
          --wifi '802.11ac 80 MHz 2x2'
    """
    rows: list[dict[str, Any]] = []
    with bad_input(), working("computing"):
        hosts = members.columns.get("hosts")
        for chosen in protocols:
            values = ds.utilization(chosen, **members.arguments, wifi=wifi)
            for index, value in enumerate([values] if isinstance(values, float) else values):
                columns = members.columns
                if isinstance(hosts, list):
                    columns = columns | {"hosts": hosts[index]}
                taken = float(value)
                rows.append(
                    {"protocol": chosen.name}
                    | columns
                    | {"utilization": taken, "fits": words.fits(taken)}
                )
    print_rows(rows, output, {"utilization": percent, "fits": _yes})
    print_channel(wifi, output)
    if output.for_people:
        members.tell_alone()


def _yes(value: bool) -> str:
    return "yes" if value else "no"
