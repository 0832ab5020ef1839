"""Who is on the channel: a fleet file, ready-made robots, or hosts, processes and endpoints."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, BinaryIO

import click

import discostorm as ds
from discostorm import _checks, _names, robots, words
from discostorm.cli.options import A_FILE, numbers, packed
from discostorm.cli.output import Output
from discostorm.fleet import HostGroup
from discostorm.measured import band

_MATCHING = (
    "Measured models depend on the endpoints that match. The processes of a fleet file and of "
    "--robot share ROS 2's own topics, unless the file says `shared`. Hosts given by --processes "
    "and --endpoints share no topic."
)

#: So many tables get a sentence on how far they were off.
_BANDS = 3


@dataclass(frozen=True)
class Members:
    """Who is on the channel: the fleet, and columns that name it."""

    columns: dict[str, Any]
    fleet: ds.Fleet

    @property
    def alone(self) -> bool:
        """Whether it is a single host."""
        hosts = self.fleet.hosts()
        return isinstance(hosts, float) and hosts == 1

    @property
    def told(self) -> str:
        """How messages begin that are about a fleet file; nothing where there is none."""
        return f"{self.columns['fleet']}: " if "fleet" in self.columns else ""

    def tell_alone(self) -> None:
        """Say that one is alone."""
        if self.alone:
            click.echo(f"\n{words.ALONE}")


def without_robot(rows: list[dict[Any, Any]], output: Output) -> list[dict[Any, Any]]:
    """Return rows for people, above which the ready-made robot is named once for all."""
    if not (output.for_people and "robot" in rows[0]):
        return rows
    click.echo(f"Robot: {rows[0]['robot']}\n")
    return [{name: row[name] for name in row if name != "robot"} for row in rows]


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


def ready_made(name: str) -> HostGroup:
    """Return one host of the ready-made robot of ``--robot``."""
    try:
        return robots.robot(name)
    except ValueError:
        like = _names.did_you_mean(name, (*robots.robots(), *robots.aliases()))
        raise click.UsageError(
            f"--robot: {_checks.brief(name)!r} is no ready-made robot{like or '.'} "
            "`discostorm robots` lists them."
        ) from None


@dataclass(frozen=True)
class Who:
    """One way to say who is on the channel: a file, a ready-made robot, or counts of our own."""

    file: str | None
    robot: str | None


def who(fleet: str | None, file: str | None, robot: str | None, counts: Mapping[str, Any]) -> Who:
    """Return which way it is; ``counts`` has what the command must have without a file.

    Raises
    ------
    click.UsageError
        If it is none, or more than one.
    """
    chosen = _one_file(fleet, file)
    given = [f"--{name}" for name, value in counts.items() if value is not None]
    if chosen is not None:
        if robot is not None or given:
            more = [f"--{name}" for name in counts]
            raise click.UsageError(f"--fleet goes without {words.listed([*more, '--robot'])}")
    elif robot is not None:
        if own := [name for name in given if name != "--hosts"]:
            raise click.UsageError(
                f"--robot says how many there are of each; it goes without {words.listed(own)}"
            )
        if "hosts" in counts and counts["hosts"] is None:
            raise click.UsageError("--hosts must be given with --robot: how many of them there are")
    elif missing := [f"--{name}" for name, value in counts.items() if value is None]:
        raise click.UsageError(
            f"{', '.join(missing)} must be given, or --fleet FILE, or --robot NAME"
        )
    return Who(chosen, robot)


def _several(
    hosts: float | list[float] | None,
    processes: float | None,
    endpoints: float | None,
    robot: str | None,
    fleet: str | None,
    file: str | None,
) -> list[Members]:
    counts = {"hosts": hosts, "processes": processes, "endpoints": endpoints}
    way = who(fleet, file, robot, counts)
    if way.file is not None:
        return [Members({"fleet": called(way.file)}, read(way.file))]
    each = hosts if isinstance(hosts, list) else [hosts]
    if way.robot is not None:
        one = ready_made(way.robot)
        return [
            Members({"robot": one.name, "hosts": many}, ds.Fleet((replace(one, hosts=many),)))
            for many in each
        ]
    return [
        Members(counts | {"hosts": many}, ds.Fleet.swarm(many, processes, endpoints))
        for many in each
    ]


def _one(hosts: float | list[float] | None, **given: Any) -> Members:
    if isinstance(hosts, list):
        raise click.UsageError("--hosts must be one number here")
    return _several(hosts, **given)[0]


def compared(fleet: str | None, robot: str | None, hosts: float | None) -> ds.Fleet | None:
    """Return the fleet to compare with: of a file, or of ready-made robots; None for neither."""
    if fleet is None and robot is None:
        if hosts is not None:
            raise click.UsageError("--hosts goes with --robot")
        return None
    way = who(fleet, None, robot, {"hosts": hosts})
    if way.file is not None:
        return read(way.file)
    assert way.robot is not None
    return ds.Fleet((replace(ready_made(way.robot), hosts=hosts),))


file_options = (
    click.option("--fleet", **A_FILE, help="Fleet file, the same as FLEET."),
    click.argument("file", **A_FILE | {"metavar": "[FLEET]"}, required=False),
)
robot_option = click.option(
    "--robot",
    metavar="NAME",
    help="Ready-made robot, such as turtlebot4, in place of processes and endpoints; "
    "`discostorm robots` lists them.",
)
count_options = (
    click.option("--processes", type=float, metavar="N", help="Processes on each host."),
    click.option("--endpoints", type=float, metavar="N", help="Endpoints in each process."),
    robot_option,
)


def _hosts_option(metavar: str, told: str) -> Callable[[Any], Any]:
    return click.option("--hosts", callback=numbers, metavar=metavar, help=told)


hosts_option = _hosts_option("N", "Hosts.")
swarm_options = packed("members", _one, hosts_option, *count_options, *file_options)
several_swarms_options = packed(
    "members",
    _several,
    _hosts_option("N[,N...]", "Hosts; several give a row each."),
    *count_options,
    *file_options,
)


def error_band(protocol: ds.Protocol, fleet: ds.Fleet) -> dict[str, float | bool | None]:
    """Return between which multiples of what a table says captures lay; see `measured.Band`."""
    known = band(protocol.name, fleet, protocol.captured) if protocol.captured else None
    return {
        "band_low": known.low if known else None,
        "band_high": known.high if known else None,
        "band_beyond": known.beyond if known else None,
    }


def say_bands(asked: Iterable[tuple[ds.Protocol, ds.Fleet]], output: Output) -> None:
    """Say below a table how far measured tables were off where they were not fitted."""
    if not output.for_people:
        return
    told = {
        f"We captured {table.name} with up to {words.many(table.captured[0], 'host')}, "
        f"{words.many(table.captured[1], 'process', 'es')} and "
        f"{words.many(table.captured[2], 'endpoint')} per process. {known.sentence()}": None
        for table, fleet in asked
        if table.captured and (known := band(table.name, fleet, table.captured))
    }
    if 0 < len(told) <= _BANDS:
        click.echo("\n" + "\n".join(words.wrapped(sentence) for sentence in told))
