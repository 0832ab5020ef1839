"""The command ``discostorm simulate``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import click

import discostorm as ds
from discostorm import _checks, staggered
from discostorm.cli.fleets import file_option, read, says_what_matches
from discostorm.cli.options import one_protocol_option, output_options, packed, radio_options
from discostorm.cli.output import (
    BadInput,
    Output,
    as_text,
    bad_input,
    percent,
    print_channel,
    print_rows,
    seconds,
)
from discostorm.wifi import Wifi


@dataclass(frozen=True)
class Runs:
    """How `simulate` runs: what its options say."""

    runs: int
    seed: int
    loss: float
    window: float
    until: float
    unlimited: bool
    no_recovery: bool

    def arguments(self) -> dict[str, Any]:
        """Return the arguments of the package's function."""
        _checks.number("--window", self.window, 0, _checks.MOST_SECONDS)
        start = staggered.at_random(self.window) if self.window else 0.0
        return {
            "queue": None if self.unlimited else (500, 0.5),
            "start": start,
            "loss": self.loss,
            "recovery": not self.no_recovery,
            "runs": self.runs,
            "seed": self.seed,
            "until": self.until,
        }

    def time(self, taken: float) -> str:
        """Return a time in words; infinity is what was not seen."""
        if taken < float("inf"):
            return seconds(taken)
        if self.no_recovery:  # nothing more will be sent
            return "never, as frames were lost"
        after = " after the last start" if self.window else ""
        return f"not within {_checks.exactly(self.until)} s{after}"


@says_what_matches
@click.command()
@file_option
@one_protocol_option
@packed(
    "how",
    Runs,
    click.option("--runs", type=int, default=5, show_default=True, help="Independent runs."),
    click.option("--seed", type=int, default=0, show_default=True, help="Of the random numbers."),
    click.option(
        "--loss", type=float, default=0.0, show_default=True, help="Frame errors of a link, 0 to 1."
    ),
    click.option(
        "--window",
        type=float,
        default=0.0,
        show_default=True,
        metavar="s",
        help="Hosts start at random within this time.",
    ),
    click.option(
        "--until",
        type=float,
        default=120.0,
        show_default=True,
        metavar="s",
        help="When to give up after the last start, with recovery.",
    ),
    click.option(
        "--unlimited", is_flag=True, help="Queues without limits, not 500 frames and 0.5 s."
    ),
    click.option("--no-recovery", is_flag=True, help="Nothing answers and nothing is repaired."),
)
@radio_options
@output_options
def simulate(file: str, protocol: ds.Protocol, how: Runs, wifi: Wifi, output: Output) -> None:
    """Simulate how the fleet of a file starts, frame by frame, in several runs.

    FLEET is a TOML file as `discostorm plan` takes it. With recovery, which is the default,
    messages answer messages and the middleware repairs what is lost. A time that did not come
    is null in JSON, and empty in CSV.

    Drained is the end of the last transmission of the start, lost the part of the frames that
    never arrived, converged when every process first knew each other one and its endpoints.

    {matching}

    \b
    Examples:
      discostorm simulate fleet.toml --until 5
      discostorm simulate fleet.toml --window 30 --until 5 --json
      discostorm simulate fleet.toml --no-recovery --wifi '802.11ac 80 MHz 2x2'
    """
    with bad_input():
        fleet = read(file)
        try:
            found = ds.simulate(fleet, protocol, wifi, **how.arguments())
        except ImportError as error:
            raise BadInput(str(error)) from error
        except ValueError as error:
            option = str(error).replace("recovery must be False", "--no-recovery must be given", 1)
            raise ValueError(option) from error
    if output.as_json:
        click.echo(as_text(found.to_dict()))
        return
    table = found.table().reset_index()
    if not output.as_csv:
        table = table[["run", "drain_time_s", "lost", "convergence_time_s", "collisions"]]
    print_rows(
        table.to_dict("records"),
        output,
        {"drain_time_s": how.time, "lost": percent, "convergence_time_s": how.time},
        {"drain_time_s": "drained [s]", "convergence_time_s": "converged [s]"},
    )
    print_channel(wifi, output)
