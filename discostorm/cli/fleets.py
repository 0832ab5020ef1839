"""Who is on the channel: a fleet file, or hosts, processes and endpoints."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, BinaryIO

import click

import discostorm as ds
from discostorm import _checks, words
from discostorm.cli.options import A_FILE, numbers, packed

hosts_option = click.option("--hosts", callback=numbers, metavar="N", help="Hosts.")
several_hosts_option = click.option(
    "--hosts", callback=numbers, metavar="N[,N...]", help="Hosts; several give a row each."
)

_MATCHING = (
    "Measured models depend on which endpoints match. The processes of a fleet file share ROS 2's "
    "own topics unless the file says `shared`; hosts given by --hosts share nothing."
)


@dataclass(frozen=True)
class Members:
    """Who is on the channel: columns that name them, and arguments of the package."""

    columns: dict[str, Any]
    arguments: dict[str, Any]

    @property
    def alone(self) -> bool:
        """Whether it is a single host."""
        hosts = self.fleet.hosts()
        return isinstance(hosts, float) and hosts == 1

    @property
    def fleet(self) -> ds.Fleet:
        """They as a fleet."""
        hosts = self.arguments["hosts"]
        return hosts if isinstance(hosts, ds.Fleet) else ds.Fleet.swarm(**self.arguments)

    def tell_alone(self) -> None:
        """Say that one is alone."""
        if self.alone:
            click.echo(f"\n{words.ALONE}")


def read(file: str) -> ds.Fleet:
    """Return the fleet of a file, or of standard input for ``-``."""
    if file == "-":
        return ds.Fleet.from_bytes(standard_input().read(), called(file))
    return ds.Fleet.from_toml(file)


def says_what_matches(command: click.Command) -> click.Command:
    """Say in the help of a command, in the place of ``{matching}``, what matches in a fleet."""
    assert command.help
    command.help = command.help.replace("{matching}", _MATCHING)
    return command


def standard_input() -> BinaryIO:
    """Return the bytes of standard input."""
    if sys.stdin is None:
        raise click.UsageError("- is standard input, which is closed")
    return sys.stdin.buffer


def called(file: str) -> str:
    """Return what messages call a file."""
    return "standard input" if file == "-" else file


def _one_file(fleet: str | None, file: str | None) -> str | None:
    if fleet is not None and file is not None:
        raise click.UsageError(
            f"one fleet at a time; got {_checks.brief(file)!r} and --fleet {_checks.brief(fleet)!r}"
        )
    return file if fleet is None else fleet


def _members(
    hosts: Any,
    processes: float | None,
    endpoints: float | None,
    fleet: str | None,
    file: str | None,
) -> Members:
    counts = {"hosts": hosts, "processes": processes, "endpoints": endpoints}
    chosen = file_or_counts(fleet, file, counts)
    if chosen is None:
        return Members(counts, counts)
    return Members({"fleet": called(chosen)}, {"hosts": read(chosen)})


def file_or_counts(fleet: str | None, file: str | None, counts: Mapping[str, Any]) -> str | None:
    """Return the fleet file; None if all the counts are given instead."""
    chosen = _one_file(fleet, file)
    names = [f"--{name}" for name in counts]
    if chosen is None:
        if missing := [f"--{name}" for name, value in counts.items() if value is None]:
            raise click.UsageError(f"{', '.join(missing)} must be given, or --fleet FILE")
    elif any(value is not None for value in counts.values()):
        raise click.UsageError(f"--fleet goes without {', '.join(names[:-1])} and {names[-1]}")
    return chosen


def _the_file(fleet: str | None, file: str | None) -> str:
    found = _one_file(fleet, file)
    if found is None:
        raise click.UsageError("Missing argument 'FLEET'.")
    return found


file_options = (
    click.option("--fleet", **A_FILE, help="The same as FLEET."),
    click.argument("file", **A_FILE | {"metavar": "[FLEET]"}, required=False),
)
file_option = packed("file", _the_file, *file_options)
count_options = (
    click.option("--processes", type=float, metavar="N", help="Processes on each host."),
    click.option("--endpoints", type=float, metavar="N", help="Endpoints of each process."),
)
swarm_options = packed("members", _members, hosts_option, *count_options, *file_options)
several_swarms_options = packed(
    "members", _members, several_hosts_option, *count_options, *file_options
)
