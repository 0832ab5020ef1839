"""The fleet of a command: a fleet file, ready-made robots, or hosts, processes and endpoints."""

import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, BinaryIO

import click

import discostorm as ds
from discostorm import _checks, _names, robots, wording
from discostorm.cli import options
from discostorm.cli.output import Output, Rows, print_note, print_paragraph
from discostorm.fleet import HostGroup
from discostorm.fleet_file import MAX_BYTES
from discostorm.lookup import as_wifi
from discostorm.prediction_error import error_band
from discostorm.ros2_endpoints import likely_shared
from discostorm.wifi import Wifi
from discostorm.wifi.radio import TOPOLOGY, aggregation_bounds

_MATCHING_RULE = (
    "Models fitted to measurements need the share of endpoints that match. We count ROS 2's own "
    "topics as shared by all processes, unless a fleet file sets `shared` (for other DDS or Zenoh "
    "programs, set it to 0)."
)
#: Maximum number of tables whose error is printed.
_MAX_PRINTED_ERRORS = 3


@dataclass(frozen=True)
class FleetInput:
    """A fleet, and the table columns that identify it."""

    columns: dict[str, Any]
    fleet: ds.Fleet

    @property
    def error_prefix(self) -> str:
        """The start of messages about a fleet file; empty where there is none."""
        return f"{self.columns['fleet']}: " if "fleet" in self.columns else ""


def channels_by_cell(fleet: ds.Fleet, wifi: Wifi) -> list[tuple[dict[str, str], ds.Fleet, Wifi]]:
    """Return extra columns, fleet and channel of each cell; of the whole fleet if it has none."""
    cells = fleet.by_cell().items()
    seen = [({"cell": cell.name}, of_cell, as_wifi(cell.wifi)) for cell, of_cell in cells]
    return seen or [({}, fleet, wifi)]


def print_channels(fleet: ds.Fleet, wifi: Wifi, output: Output) -> None:
    """Print the channel that the table above assumes, or the channel of each cell, for people."""
    if not output.for_people:
        return
    if not fleet.cells:
        print_note(f"Channel: {wifi.name}, {TOPOLOGY}.")
        return
    singles = {cell.name: aggregation_bounds(as_wifi(cell.wifi))[1] for cell in fleet.cells}
    channels = "; ".join(f'{single.name} in "{cell}"' for cell, single in singles.items())
    print_note(f"Channels: {channels}. Each is {TOPOLOGY}; cells do not interfere.")


def is_all_wired(fleet: ds.Fleet) -> bool:
    """Return whether no host of a fleet uses the Wi-Fi."""
    return all(group.wired for group in fleet.groups)


def print_fleet_note(fleet: ds.Fleet) -> None:
    """Say why a fleet of one host, or without Wi-Fi, needs little or no airtime."""
    if is_all_wired(fleet):
        print_note(wording.ALL_WIRED_NOTE)
    elif fleet.hosts() == 1:
        print_note(wording.LONE_HOST_NOTE)


def print_robot_name(rows: Rows, output: Output) -> None:
    """Print the name of a ready-made robot above a table for people."""
    if output.for_people and "robot" in rows[0]:
        click.echo(f"Robot: {rows[0]['robot']}\n")


def describe_matching(command: click.Command) -> click.Command:
    """Fill ``{matching}`` in the help of a command with the rule for matching endpoints."""
    command.help = (command.help or "").replace("{matching}", _MATCHING_RULE)
    return command


def standard_input() -> BinaryIO:
    """Return the bytes of standard input."""
    if sys.stdin is None:
        raise click.UsageError("standard input (-) is closed")
    return sys.stdin.buffer


def display_name(file: str) -> str:
    """Return the name of a file in messages."""
    return "standard input" if file == "-" else file


def read_fleet(file: str) -> ds.Fleet:
    """Return the fleet of a file, or of standard input for ``-``."""
    if file == "-":
        return ds.Fleet.from_bytes(standard_input().read(MAX_BYTES + 1), display_name(file))
    return ds.Fleet.from_toml(file)


def robot_preset(name: str, hosts: Any = 1) -> HostGroup:
    """Return a group of hosts of the ready-made robot that ``--robot`` names."""
    try:
        return replace(robots.robot(name), hosts=hosts)
    except ValueError:
        like = _names.did_you_mean(name, (*robots.robots(), *robots.aliases(), "laptop"))
        raise click.UsageError(
            f"--robot: {_checks.shorten_name(name)!r} is not a known robot{like or '.'} "
            "`discostorm robots` lists them."
        ) from None


def ros2_swarm(hosts: Any, processes: Any, endpoints: Any) -> ds.Fleet:
    """Return a fleet of identical hosts that share ROS 2's own topics, as in a fleet file."""
    group = HostGroup(hosts, processes, endpoints)
    return ds.Fleet((replace(group, shared=likely_shared(group.endpoints)),))


def fleet_source(
    fleet: str | None, file: str | None, robot: str | None, counts: Mapping[str, Any]
) -> str | None:
    """Return the fleet file; None if a robot or counts are given instead of a file.

    Raise a UsageError if a fleet is given in no way, or in more than one.
    """
    given = [f"--{name}" for name, value in counts.items() if value is not None]
    if fleet is not None and file is not None:
        one, other = map(_checks.shorten_name, (file, fleet))
        raise click.UsageError(f"give one fleet; got {one!r} and --fleet {other!r}")
    if fleet is not None or file is not None:
        if robot is not None or given:
            flags = wording.join_words([*(f"--{name}" for name in counts), "--robot"])
            raise click.UsageError(f"--fleet cannot be combined with {flags}")
    elif robot is not None:
        if others := [flag for flag in given if flag != "--hosts"]:
            flags = wording.join_words(others)
            rule = "--robot brings its own numbers and cannot be combined with"
            raise click.UsageError(f"{rule} {flags}")
        if "hosts" in counts and counts["hosts"] is None:
            raise click.UsageError("--robot needs --hosts, the number of these robots")
    elif missing := [f"--{name}" for name, value in counts.items() if value is None]:
        flags = wording.join_words(missing)
        raise click.UsageError(f"give {flags}, --fleet FILE, or --robot NAME")
    return file if fleet is None else fleet


def _fleet_inputs(
    robot: str | None, fleet: str | None, file: str | None, **counts: Any
) -> list[FleetInput]:
    hosts = counts["hosts"]
    source = fleet_source(fleet, file, robot, counts)
    if source is not None:
        given = read_fleet(source)
        options.prefer_distribution(given.ros)
        options.refuse_wifi_with_cells(given.cells)
        return [FleetInput({"fleet": display_name(source)}, given)]
    inputs = []
    for count in hosts if isinstance(hosts, list) else [hosts]:
        if robot is None:
            numbers = counts | {"hosts": count}
            inputs.append(FleetInput(numbers, ros2_swarm(**numbers)))
        else:
            group = robot_preset(robot, count)
            inputs.append(FleetInput({"robot": group.name, "hosts": count}, ds.Fleet((group,))))
    return inputs


def _fleet_input(**given: Any) -> FleetInput:
    if isinstance(given["hosts"], list):
        raise click.UsageError("--hosts must be one number here")
    return _fleet_inputs(**given)[0]


def comparison_fleet(fleet: str | None, robot: str | None, hosts: float | None) -> ds.Fleet | None:
    """Return the fleet to compare with, from a file or of ready-made robots; None without both."""
    if fleet is None and robot is None:
        if hosts is not None:
            raise click.UsageError("--hosts needs --robot")
        return None
    source = fleet_source(fleet, None, robot, {"hosts": hosts})
    return ds.Fleet((robot_preset(str(robot), hosts),)) if source is None else read_fleet(source)


file_options = (
    click.option("--fleet", **options.FILE_ARGS, help="Fleet file, the same as FLEET."),
    click.argument("file", **options.FILE_ARGS | {"metavar": "[FLEET]"}, required=False),
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


def _swarm_options(name: str, make: Any, metavar: str, text: str) -> Callable[[Any], Any]:
    hosts = click.option("--hosts", callback=options.parse_number_list, metavar=metavar, help=text)
    return options.option_group(name, make, hosts, *count_options, *file_options)


swarm_options = _swarm_options("fleet_input", _fleet_input, "N", "Number of hosts.")
several_swarms_options = _swarm_options(
    "inputs", _fleet_inputs, "N[,N...]", "Number of hosts, or several numbers, one row each."
)


def error_band_columns(protocol: ds.Protocol, fleet: ds.Fleet) -> dict[str, float | bool | None]:
    """Return columns for the range of measured over modeled airtime; see `ErrorBand`."""
    error = error_band(protocol.name, fleet, protocol.captured) if protocol.captured else None
    low, high = (error.low, error.high) if error and error.coverage else (None, None)
    return {"band_low": low, "band_high": high, "band_beyond": error.beyond if error else None}


def print_error_bands(cases: Iterable[tuple[ds.Protocol, ds.Fleet]]) -> None:
    """Print below a table the errors of measured models for swarms that we did not fit."""
    sentences: dict[str, None] = {}
    for protocol, fleet in cases:
        if protocol.captured and (error := error_band(protocol.name, fleet, protocol.captured)):
            hosts, processes, endpoints = protocol.captured
            sentences[
                f"We captured {protocol.name} with up to {wording.count_noun(hosts, 'host')}, "
                f"{wording.count_noun(processes, 'process', 'es')} and "
                f"{wording.count_noun(endpoints, 'endpoint')} per process. {error.sentence()}"
            ] = None
    if 0 < len(sentences) <= _MAX_PRINTED_ERRORS:
        click.echo()
        for sentence in sentences:
            print_paragraph(sentence)
