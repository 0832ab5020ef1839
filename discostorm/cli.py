"""The command ``discostorm``: the package's answers as tables, JSON and CSV."""

from __future__ import annotations

import csv
import errno
import functools
import io
import json
import math
import os
import shutil
import sys
import textwrap
import unicodedata
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, NoReturn, TypeVar

import click

import discostorm as ds
from discostorm import _checks, staggered, words
from discostorm.fleet import COUNTS
from discostorm.scalability import message_costs
from discostorm.wifi import Wifi
from discostorm.wifi.radio import radio_named

if TYPE_CHECKING:
    import pandas as pd

    from discostorm.capture import Capture

# What a command needs beyond the package itself is imported when it runs: tables of a few rows
# do without pandas, which takes as long to import as the rest.

Command = TypeVar("Command", bound=Callable[..., Any])
Rows = Sequence[Mapping[Any, Any]]

#: What ``--protocol both`` stands for: the paper's.
BOTH = (ds.DDS, ds.ZENOH)

#: What an option replaces of a channel, and in which unit.
LINK_OPTIONS = {
    "unicast_rate": ("unicast", "rate", "Mbit/s"),
    "unicast_overhead": ("unicast", "overhead", "µs"),
    "multicast_rate": ("multicast", "rate", "Mbit/s"),
    "multicast_overhead": ("multicast", "overhead", "µs"),
}
#: Units in SI.
UNITS = {"Mbit/s": 1e6, "µs": 1e-6}


class BadInput(click.ClickException):
    """What the user gave is wrong; the message says what and what is allowed."""

    exit_code = 2


@contextmanager
def _bad_input() -> Iterator[None]:
    """Answer what the package refuses with its message and exit code 2."""
    try:
        yield
    except OSError as error:
        if error.filename is None:  # of the output
            raise
        raise BadInput(visible(f"{error.filename}: {error.strerror}")) from error
    except ValueError as error:
        raise BadInput(visible(str(error))) from error


def visible(text: str) -> str:
    """Return a text with escapes for what a terminal would act on."""
    return "".join(
        ascii(character)[1:-1]
        if unicodedata.category(character) in ("Cc", "Cf", "Cs") and character != "\n"
        else character
        for character in text
    )


class Commands(click.Group):
    """Commands whose output may fail: a full disk is told, a closed pipe is not."""

    def main(self, *args: Any, **kwargs: Any) -> Any:
        """Run a command; see `click.Group.main`."""
        for stream in (sys.stdout, sys.stderr):
            # What the terminal cannot show is escaped.
            if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
                stream.reconfigure(errors="backslashreplace")
        try:
            if sys.stdout is None:  # closed before the start: click would write to nobody
                raise OSError(errno.EBADF, os.strerror(errno.EBADF))
            return super().main(*args, **kwargs)
        except OSError as error:
            if error.errno != errno.EPIPE:
                click.echo(f"Error: the output could not be written: {error.strerror}", err=True)
            if sys.stdout is not None:
                # Or the interpreter would try again when it ends.
                os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            sys.exit(1)


# ---------------------------------------------------------------- options


def _options(*decorators: Callable[[Any], Any]) -> Callable[[Command], Command]:
    def decorate(command: Command) -> Command:
        for decorator in reversed(decorators):
            command = decorator(command)
        return command

    return decorate


def _numbers(_: click.Context, _parameter: click.Parameter, value: str | None) -> Any:
    """Return the numbers of a comma-separated list, a single one as a float."""
    if value is None:
        return None
    try:
        found = [float(part) for part in value.split(",")]
    except ValueError:
        raise click.BadParameter(
            f"must be a number, or several with commas between; got {value!r}"
        ) from None
    return found[0] if len(found) == 1 else found


def _listing(
    names: Iterable[str],
) -> Callable[[click.Context, click.Parameter, str | None], str | None]:
    """Return what prints these names where ``list`` is given instead of one of them."""

    def callback(context: click.Context, _: click.Parameter, value: str | None) -> str | None:
        if value is not None and value.lower() == "list":
            click.echo("\n".join(names))
            context.exit()
        return value

    return callback


def _packed(
    name: str, make: Callable[..., Any], *options: Callable[[Any], Any]
) -> Callable[[Command], Command]:
    """Return a decorator that adds options, of which a command gets one thing that is made."""

    def decorate(command: Command) -> Command:
        known: list[click.Parameter] = []

        @functools.wraps(command)
        def call(**given: Any) -> Any:
            own = {str(option.name): given.pop(str(option.name)) for option in known}
            with _bad_input():
                made = make(**own)
            return command(**{name: made}, **given)

        for option in reversed(options):
            option(call)
            known.append(vars(call)["__click_params__"][-1])
        packed: Any = call
        return packed  # type: ignore[no-any-return]

    return decorate


@dataclass(frozen=True)
class Output:
    """What an answer is printed as."""

    as_json: bool
    as_csv: bool

    @property
    def for_people(self) -> bool:
        """Whether it is a table."""
        return not (self.as_json or self.as_csv)


def _one_format(context: click.Context, _: click.Parameter, value: bool) -> bool:
    if value and (context.params.get("as_json") or context.params.get("as_csv")):
        raise click.UsageError("--json and --csv exclude each other")
    return value


output_options = _packed(
    "output",
    Output,
    click.option(
        "--json",
        "as_json",
        is_flag=True,
        callback=_one_format,
        help="Print JSON instead of a table.",
    ),
    click.option(
        "--csv", "as_csv", is_flag=True, callback=_one_format, help="Print CSV instead of a table."
    ),
)


def _wifi(channel: str, **given: float | None) -> Wifi:
    """Return the channel of a name, with other rates and overheads."""
    changes = {option: value for option, value in given.items() if value is not None}
    if channel.lower() == "paper":
        return _own_channel(changes) if changes else ds.PAPER
    try:
        radio = radio_named(channel)
    except ValueError as error:
        known = ", ".join(repr(preset) for preset in ("paper", *ds.WIFI))
        raise click.UsageError(
            f"--wifi must be one of {known}, or made like them: {error}"
        ) from None
    rate = changes.pop("multicast_rate", None)
    if changes:
        option = next(iter(changes)).replace("_", "-")
        raise click.UsageError(f"--{option} goes with --wifi paper alone; got --wifi {channel!r}")
    return (radio if rate is None else replace(radio, multicast_rate=rate * 1e6)).wifi()


def _own_channel(changes: Mapping[str, float]) -> Wifi:
    links = {"unicast": ds.PAPER.unicast, "multicast": ds.PAPER.multicast}
    for option, value in changes.items():
        cast, quantity, unit = LINK_OPTIONS[option]
        try:
            change: dict[str, Any] = {quantity: value * UNITS[unit]}
            links[cast] = replace(links[cast], **change)
        except ValueError as error:
            si = "bit/s" if quantity == "rate" else "s"
            must, _, _ = str(error).rpartition("; got ")
            raise ValueError(f"{cast} {must} {si}; got {value:g} {unit}") from error
    return Wifi("own channel", links["unicast"], links["multicast"])


def _radio(channel: str, **given: float | None) -> Wifi:
    """Return the channel of a name with its radio, with another multicast rate."""
    wifi = _wifi(channel, **given)
    if wifi.radio is None:
        raise click.UsageError(f"--multicast-rate goes with a radio here; got --wifi {channel!r}")
    return wifi


def _wifi_options(make: Callable[..., Wifi], *options: str) -> Callable[[Any], Any]:
    return _packed(
        "wifi",
        make,
        click.option(
            "--wifi",
            "channel",
            default="paper",
            show_default=True,
            metavar="NAME",
            callback=_listing(("paper", *ds.WIFI)),
            help="The channel: paper, or a radio such as '802.11ac 80 MHz 2x2' or "
            "'802.11n 20 MHz 2x2, A-MPDU 64', in any case of letters; 'list' lists some.",
        ),
        *(
            click.option(
                f"--{option.replace('_', '-')}",
                type=float,
                metavar=LINK_OPTIONS[option][2],
                help="Instead of the channel's."
                if option == "multicast_rate"
                else "Instead of the paper's.",
            )
            for option in options
        ),
    )


wifi_options = _wifi_options(_wifi, *LINK_OPTIONS)
#: Of what needs more of a channel than rates and overheads.
radio_options = _wifi_options(_radio, "multicast_rate")


def _protocols(protocol: str) -> tuple[ds.Protocol, ...]:
    return BOTH if protocol == "both" else (ds.PROTOCOLS[protocol],)


def _protocol_option(
    flag: str, default: str | None, told: str, others: tuple[str, ...] = ()
) -> Callable[[Any], Any]:
    names = (*ds.PROTOCOLS, *others)
    return click.option(
        flag,
        type=click.Choice([*names, "list"], case_sensitive=False),
        metavar="NAME",
        default=default,
        show_default=True,
        callback=_listing(names),
        help=f"{told}, in any case of letters; 'list' lists them.",
    )


protocol_option = _packed(
    "protocols",
    _protocols,
    _protocol_option("--protocol", "both", "The middleware; both are the paper's two", ("both",)),
)

one_protocol_option = _packed(
    "protocol",
    lambda protocol: ds.PROTOCOLS[protocol],
    _protocol_option("--protocol", ds.DDS.name, "The middleware"),
)

hosts_option = click.option("--hosts", callback=_numbers, metavar="N", help="Hosts.")
several_hosts_option = click.option(
    "--hosts", callback=_numbers, metavar="N[,N...]", help="Hosts; several give a row each."
)


@dataclass(frozen=True)
class Members:
    """Who is on the channel: columns that name them, and arguments of the package."""

    columns: dict[str, Any]
    arguments: dict[str, Any]

    @property
    def alone(self) -> bool:
        """Whether it is a single host."""
        hosts: Any = self.arguments["hosts"]
        if isinstance(hosts, ds.Fleet):
            hosts = sum(group.hosts for group in hosts.groups)
        return bool(hosts == 1)


def _read(file: str) -> ds.Fleet:
    """Return the fleet of a file, or of standard input for ``-``."""
    if file == "-":
        return ds.Fleet.from_bytes(_standard_input().read(), _called(file))
    return ds.Fleet.from_toml(file)


def _standard_input() -> BinaryIO:
    if sys.stdin is None:
        raise click.UsageError("- is standard input, which is closed")
    return sys.stdin.buffer


def _called(file: str) -> str:
    """Return what messages call a file."""
    return "standard input" if file == "-" else file


def _one_file(fleet: str | None, file: str | None) -> str | None:
    if fleet is not None and file is not None:
        raise click.UsageError(f"one fleet at a time; got {file!r} and --fleet {fleet!r}")
    return file if fleet is None else fleet


def _members(
    hosts: Any,
    processes: float | None,
    endpoints: float | None,
    fleet: str | None,
    file: str | None,
) -> Members:
    counts = {"hosts": hosts, "processes": processes, "endpoints": endpoints}
    chosen = _file_or_counts(fleet, file, counts)
    if chosen is None:
        return Members(counts, counts)
    return Members({"fleet": _called(chosen)}, {"hosts": _read(chosen)})


def _file_or_counts(fleet: str | None, file: str | None, counts: Mapping[str, Any]) -> str | None:
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
    click.option("--fleet", metavar="FILE", help="The same as FLEET."),
    click.argument("file", metavar="[FLEET]", required=False),
)
file_option = _packed("file", _the_file, *file_options)
count_options = (
    click.option("--processes", type=float, metavar="N", help="Processes on each host."),
    click.option("--endpoints", type=float, metavar="N", help="Endpoints of each process."),
)
swarm_options = _packed("members", _members, hosts_option, *count_options, *file_options)
several_swarms_options = _packed(
    "members", _members, several_hosts_option, *count_options, *file_options
)

# ---------------------------------------------------------------- output

Format = Callable[[Any], str]


def _width() -> int:
    """Return the characters in a line, if a table can be made as narrow."""
    return max(shutil.get_terminal_size().columns - 1, 40)


def _plain(value: Any) -> str:
    if not isinstance(value, float):
        return visible(str(value)).replace("\n", "\\n")
    return f"{value:,.10g}" if value < 1e10 else f"{value:.3g}"


def _percent(value: float) -> str:
    return words.percent(value, decimals=1, below="<")


def _seconds(value: float) -> str:
    return f"{value:.6f}" if value < words.HUGE else f"{value:.3g}"


def _print(
    rows: Rows,
    output: Output,
    formats: dict[str, Format] | None = None,
    headings: dict[str, str] | None = None,
) -> None:
    """Print a table for people, or all its digits for machines."""
    if output.as_json:
        click.echo(_json(rows))
    elif output.as_csv:
        text = io.StringIO()
        writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:  # what is null in JSON, which has no infinity, is empty
            writer.writerow(
                {key: None if value == math.inf else value for key, value in row.items()}
            )
        click.echo(text.getvalue(), nl=False)
    else:
        click.echo(_aligned(rows, formats or {}, headings or {}))


def _json(value: Any) -> str:
    """Return JSON that every reader takes, in letters that the output can hold."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    text = functools.partial(json.dumps, value, indent=2, default=str, allow_nan=False)
    found = text(ensure_ascii=False)
    try:
        found.encode(encoding)
    except UnicodeEncodeError:
        return text(ensure_ascii=True)
    return found


def _aligned(rows: Rows, formats: dict[str, Format], headings: dict[str, str]) -> str:
    """Return a table with aligned columns: numbers to the right, words to the left.

    Long words in the last column are broken into lines.
    """
    columns = []
    for name in rows[0]:
        values = [row[name] for row in rows]
        cells = [formats.get(name, _plain)(value) for value in values]
        heading = headings.get(name, name.replace("_", " "))
        width = max(map(len, [heading, *cells]))
        there = [value for value in values if value is not None]
        number = all(type(value) in (int, float) for value in there)  # a truth is a word
        columns.append(
            [cell.rjust(width) if number else cell.ljust(width) for cell in (heading, *cells)]
        )
    start = sum(len(column[0]) + 2 for column in columns[:-1])
    lines: list[str] = []
    for *row, last in zip(*columns, strict=True):
        parts = textwrap.wrap(last.rstrip(), max(_width() - start, 20)) or [""]
        if last != last.lstrip():
            parts = [last]  # a number, already in its place
        lines.append(("  ".join([*row, parts[0]])).rstrip())
        lines += [" " * start + part for part in parts[1:]]
    lines.insert(1, "-" * max(map(len, lines)))
    return "\n".join(lines)


def _live() -> bool:
    """Return whether a line of standard error can be written over."""
    return sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


@contextmanager
def _working(what: str) -> Iterator[None]:
    """Say on a terminal what takes its time, and wipe it out afterwards."""
    shown = _live()
    if shown:
        click.echo(f"{what} ...", err=True, nl=False)
    try:
        yield
    finally:
        if shown:
            click.echo("\r" + " " * (len(what) + 4) + "\r", err=True, nl=False)


# ---------------------------------------------------------------- commands


@click.group(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 it worked, 1 the output could not be written or was stopped, "
    "2 wrong usage or input.",
)
@click.version_option(ds.__version__, message="%(prog)s %(version)s")
def main() -> None:
    """How much Wi-Fi airtime the discovery of ROS 2 robots takes, and what helps.

    Utilization is airtime per second: at 1, or 100%, the channel does nothing else; at 2
    discovery asks for two seconds of airtime in one, and does not fit.

    \b
    Examples:
      discostorm utilization --hosts 7 --processes 2 --endpoints 10
      discostorm plan fleet.toml
    """


@main.command(short_help="Airtime of discovery in one second.")
@several_swarms_options
@protocol_option
@wifi_options
@output_options
def utilization(
    members: Members, protocols: tuple[ds.Protocol, ...], wifi: Wifi, output: Output
) -> None:
    """Compute the airtime of discovery in one second, of a swarm or of a fleet file.

    \b
    Examples:
      discostorm utilization --hosts 3,5,7 --processes 2 --endpoints 10
      discostorm utilization fleet.toml --protocol zenoh --json
      discostorm utilization --hosts 7 --processes 2 --endpoints 10 \\
          --wifi '802.11ac 80 MHz 2x2'
    """
    rows: list[dict[str, Any]] = []
    with _bad_input(), _working("computing"):
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
    _print(rows, output, {"utilization": _percent, "fits": _yes})
    if output.for_people and members.alone:
        click.echo(f"\n{words.ALONE}")


def _yes(value: bool) -> str:
    return "yes" if value else "no"


@main.command(short_help="What each message costs.")
@swarm_options
@protocol_option
@wifi_options
@output_options
def breakdown(
    members: Members, protocols: tuple[ds.Protocol, ...], wifi: Wifi, output: Output
) -> None:
    """Show what each message of the discovery costs, up to the access point and down.

    \b
    Examples:
      discostorm breakdown --hosts 7 --processes 2 --endpoints 10 --protocol dds
      discostorm breakdown fleet.toml --csv
    """
    counts = members.arguments
    if isinstance(counts["hosts"], list):
        raise click.UsageError("--hosts must be one number here")
    rows: list[dict[str, Any]] = []
    with _bad_input(), _working("computing"):
        hosts = counts["hosts"]
        fleet = hosts if isinstance(hosts, ds.Fleet) else ds.Fleet.swarm(**counts)
        for chosen in protocols:
            costs = message_costs(chosen, fleet, wifi)
            whole = math.fsum(row["uplink_s"] + row["downlink_s"] for row in costs)
            rows += [
                {"protocol": chosen.name}
                | row
                | {"share": (row["uplink_s"] + row["downlink_s"]) / whole}
                for row in costs
            ]
    if output.for_people:  # without what would make the lines too long
        rows = [{name: row[name] for name in row if name != "phase"} for row in rows]
    _print(
        rows,
        output,
        {"uplink_s": _seconds, "downlink_s": _seconds, "share": _percent},
        {
            "frame_bytes": "frame [B]",
            "uplink_messages": "messages",
            "uplink_s": "up [s]",
            "downlink_s": "down [s]",
        },
    )
    if output.for_people and members.alone:
        click.echo(f"\n{words.ALONE}")


def _hosts(value: float | None) -> str:
    return "less than 1" if value is None else f"{value:.2f}"


@dataclass(frozen=True)
class Kind:
    """A kind of host of which there may be more: columns that name it, and who else is there."""

    columns: dict[str, Any]
    processes: float
    endpoints: float
    others: tuple[ds.HostGroup, ...]


def _kinds(
    processes: float | None,
    endpoints: float | None,
    fleet: str | None,
    file: str | None,
    beside: str | None,
) -> list[Kind]:
    counts: dict[str, Any] = {"processes": processes, "endpoints": endpoints}
    chosen = _file_or_counts(fleet, file, counts)
    others: tuple[ds.HostGroup, ...] = ()
    if chosen == beside == "-":
        raise click.UsageError("either FLEET or --beside may be -, for standard input")
    if beside is not None:  # without their names, which may be those of FLEET
        others = tuple(replace(group, name="") for group in _read(beside).groups)
    if chosen is None:
        return [Kind({}, **counts, others=others)]
    members = _read(chosen)
    return [
        Kind(
            {"group": name},
            float(group.processes),
            float(group.endpoints),
            (*members.groups[:index], *members.groups[index + 1 :], *others),
        )
        for index, (name, group) in enumerate(zip(members.names, members.groups, strict=True))
    ]


@main.command(short_help="Hosts at which the channel is full.")
@_packed(
    "kinds",
    _kinds,
    *count_options,
    *file_options,
    click.option("--beside", metavar="FILE", help="Fleet file of other hosts on the channel."),
)
@click.option(
    "--limit",
    type=float,
    default=1.0,
    show_default=True,
    help="Utilization to reach, 1 is 100%.",
)
@protocol_option
@wifi_options
@output_options
def saturation(
    kinds: Sequence[Kind],
    limit: float,
    protocols: tuple[ds.Protocol, ...],
    wifi: Wifi,
    output: Output,
) -> None:
    """Tell how many like hosts there are when discovery fills the channel.

    Of a fleet file, FLEET, each group is asked for in turn: how many of its hosts there are
    then, beside the other groups as they are.

    \b
    Examples:
      discostorm saturation --processes 2 --endpoints 10
      discostorm saturation --processes 1 --endpoints 678 --limit 0.5 --json
      discostorm saturation fleet.toml --protocol zenoh
    """
    with _bad_input(), _working("computing"):
        rows = [
            {"protocol": protocol.name} | _full(kind, limit, protocol, wifi)
            for protocol in protocols
            for kind in kinds
        ]
    if output.for_people and "group" in rows[0]:  # or the lines would be too long
        rows = [{name: row[name] for name in row if name != "limit"} for row in rows]
    _print(
        rows,
        output,
        {"limit": _percent, "hosts": _hosts},
        {"hosts": "saturated at hosts", "fit": "hosts that fit"},
    )


def _full(kind: Kind, limit: float, protocol: ds.Protocol, wifi: Wifi) -> dict[str, Any]:
    """Return at how many hosts of a kind the channel is full; None if one is too many."""
    counts = (kind.processes, kind.endpoints)
    others = ds.Fleet(kind.others) if kind.others else None
    least = ds.Fleet((ds.HostGroup(1, *counts), *kind.others))
    hosts = None
    if not ds.utilization(protocol, least, wifi=wifi) > limit > 0:
        hosts = ds.saturation_hosts(protocol, *counts, wifi, limit=limit, beside=others)
    return kind.columns | {
        "processes": kind.processes,
        "endpoints": kind.endpoints,
        "limit": limit,
        "hosts": hosts,
        "fit": 0 if hosts is None else words.whole_below(float(hosts)),
    }


@main.command(short_help="Advice for a fleet: what would help most.")
@file_option
@one_protocol_option
@click.option(
    "--nodes",
    callback=_numbers,
    metavar="N[,N...]",
    help="Nodes with parameter services in each process; with commas, one number for each "
    "group.  [default: those of the file, else 1 where the endpoints are enough]",
)
@click.option(
    "--shared",
    type=float,
    metavar="N",
    help="Endpoints of each process that match one in every other, whatever its namespace; 0 "
    "without ROS 2.  [default: what ROS 2 shares: 2, and 2 more for each node]",
)
@wifi_options
@output_options
def plan(
    file: str,
    protocol: ds.Protocol,
    nodes: Any,
    shared: float | None,
    wifi: Wifi,
    output: Output,
) -> None:
    """Tell what dominates the discovery of a fleet, and what would help most.

    FLEET is a TOML file, or - for standard input, with a table for each group of like hosts:

    \b
      [[groups]]
      name = "robots"
      hosts = 10
      processes = 1       # of each host
      endpoints = 678     # of each process
      nodes = 13          # with parameter services; may be left out

    \b
    Examples:
      discostorm plan fleet.toml
      discostorm plan fleet.toml --protocol zenoh --wifi '802.11n 20 MHz 2x2'
      discostorm plan fleet.toml --nodes 13,2 --json
    """
    with _bad_input(), _working("planning"):
        members = _read(file)
        try:
            answer = ds.plan(members, protocol, wifi, nodes=nodes, shared=shared)
        except ValueError as error:
            raise ValueError(f"{_called(file)}: {error}") from error
    if output.as_csv:
        _print(answer.to_frame().reset_index().to_dict("records"), output)
    elif output.as_json:
        click.echo(_json(answer.to_dict()))
    else:
        click.echo(visible(answer.advice()))


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

    def time(self, seconds: float) -> str:
        """Return a time in words; infinity is what was not seen."""
        if seconds < float("inf"):
            return _seconds(seconds)
        if self.no_recovery:  # nothing more will be sent
            return "never, as frames were lost"
        after = " after the last start" * bool(self.window)
        return f"not within {_checks.exactly(self.until)} s{after}"


@main.command(short_help="The start of a fleet on the air, frame by frame.")
@file_option
@one_protocol_option
@_packed(
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

    \b
    Examples:
      discostorm simulate fleet.toml --until 5
      discostorm simulate fleet.toml --window 30 --until 5 --json
      discostorm simulate fleet.toml --no-recovery --wifi '802.11ac 80 MHz 2x2'
    """
    with _bad_input():
        try:
            found = ds.simulate(_read(file), protocol, wifi, **how.arguments())
        except ImportError as error:
            raise click.ClickException(str(error)) from error
    if output.as_json:
        click.echo(_json(found.to_dict()))
        return
    table = found.table().reset_index()
    if not output.as_csv:
        table = table[["run", "drain_time_s", "lost", "convergence_time_s", "collisions"]]
    _print(
        table.to_dict("records"),
        output,
        {"drain_time_s": how.time, "lost": _percent, "convergence_time_s": how.time},
        {"drain_time_s": "drained [s]", "convergence_time_s": "converged [s]"},
    )


@main.command(short_help="Write the paper's figures and their data.")
@click.option("--out", required=True, metavar="DIR", help="Folder to write to, made if missing.")
@output_options
def figures(out: str, output: Output) -> None:
    """Write Figs. 2 to 4 of the paper as SVG, PDF and PNG, and their data as CSV.

    \b
    Example:
      discostorm figures --out figures
    """
    if not out:
        raise click.UsageError("--out must name a folder; got ''")
    with _working("loading"):
        from discostorm import figures as drawing
    paths: list[str] = []
    count = drawing.files_of_all()
    files = drawing.save_all(Path(out))
    while True:
        try:
            path = next(files, None)
        except OSError as error:
            _not_written(out, error)
        if path is None:
            break
        paths.append(str(path))
        click.echo(
            visible(f"[{len(paths):{len(str(count))}}/{count}] {path}"), err=not output.for_people
        )
    if not output.for_people:
        _print([{"path": path} for path in paths], output)


def _not_written(out: str, error: OSError) -> NoReturn:
    raise BadInput(
        visible(f"--out must be a folder to write to; got {out!r}: {error.strerror}")
    ) from error


def _drawable(_: click.Context, _parameter: click.Parameter, value: str | None) -> str | None:
    """Return the name of a picture if it says in which of the formats it is to be."""
    if value is not None and Path(value).suffix.lower() not in (".svg", ".pdf", ".png"):
        raise click.BadParameter(f"must end in .svg, .pdf or .png; got {value!r}")
    return value


@main.command(short_help="What a capture holds, against the model.")
@click.argument("file", metavar="FILE")
@_protocol_option(
    "--against", None, "Instead of the paper's tables of what is found, the one to hold it against"
)
@click.option("--fleet", metavar="FILE", help="Fleet file (TOML); the fleet found if left out.")
@click.option(
    "--picture",
    metavar="FILE",
    callback=_drawable,
    help="Draw it, too: a file .svg, .pdf or .png.",
)
@output_options
def capture(
    file: str, against: str | None, fleet: str | None, picture: str | None, output: Output
) -> None:
    """Read a capture of tcpdump or Wireshark, and count discovery traffic by message.

    FILE is pcap or pcapng, also as .gz or .xz, or - for standard input, which is read to its
    end. Per unit is what was captured for each
    process, pair of processes or endpoint of the fleet that the capture itself tells of;
    airtime is that on the paper's channel. Record with:

    \b
      {record_file}

    \b
    Examples:
      discostorm capture discovery.pcap
      discostorm capture discovery.pcap --against DDS --fleet fleet.toml --json
      timeout 60 {record_out} |
        discostorm capture -
    """
    with _bad_input(), _working("reading"):
        if file == fleet == "-":
            raise click.UsageError("either FILE or --fleet may be -, for standard input")
        found = ds.read_capture(_standard_input() if file == "-" else file)
        members = None if fleet is None else _read(fleet)
        spoken = set(found.processes()["protocol"])
        papers = [own for wire, own in (("RTPS", ds.DDS), ("Zenoh", ds.ZENOH)) if wire in spoken]
        rows = [
            {"protocol": protocol.name} | row
            for protocol in (papers if against is None else [ds.PROTOCOLS[against]])
            for row in _whole_rows(found.compare(protocol, members).reset_index())
        ]
        groups = found.fleet().groups if members is None and spoken else ()
        if picture is not None:
            try:
                found.picture().savefig(picture)
            except OSError as error:
                raise BadInput(f"--picture: {picture}: {error.strerror}") from error
    if output.as_csv and rows:
        _print(rows, output)
    elif output.as_json:
        answer = {
            "file": _called(file),
            "packets": found.packets,
            "duration_s": found.duration,
            "hosts": [dict(zip(COUNTS, group.counts(), strict=True)) for group in groups],
            "messages": rows,
            "notes": list(found.notes),
        }
        click.echo(_json(answer))
    elif output.for_people:
        _show_capture(found, groups, rows, output)
        if against is None and rows:
            _name_own_tables(found)


assert capture.help
capture.help = capture.help.format(
    record_file=words.RECORD.format(file="discovery.pcap"), record_out=words.RECORD.format(file="-")
)


def _whole_rows(table: pd.DataFrame) -> list[dict[Any, Any]]:
    """Return the rows of a table, with None where it has no number."""
    return table.astype(object).where(table.notna(), None).to_dict("records")


def _show_capture(
    found: Capture, groups: Sequence[ds.HostGroup], rows: Rows, output: Output
) -> None:
    packets = words.many(found.packets, "packet")
    click.echo(visible(f"{found.path}: {packets} in {found.duration:.3f} s"))
    for group in groups:
        hosts, processes, endpoints = group.counts()
        each = words.many(processes, "process", "es")
        click.echo(f"hosts: {_plain(hosts)} with {each} of {_plain(endpoints)} endpoints each")
    if rows:
        _print(
            [{key: row[key] for key in row if key != "protocol"} for row in rows],
            output,
            formats={
                **dict.fromkeys(("units", "expected"), _count),
                "per_unit": _ratio,
                "airtime_s": "{:.4f}".format,
            },
            headings={"unicast": "uni", "multicast": "multi", "airtime_s": "air [s]"},
        )
    else:
        click.echo("There is no message of RTPS or Zenoh in it.")
    for note in found.notes:
        click.echo(visible(f"Note: {note}."))


def _name_own_tables(found: Capture) -> None:
    """Say how to hold the capture against the tables of the products that sent it."""
    own = sorted(set(found.processes()["product"]) & set(ds.PROTOCOLS))
    if own:
        options = " or ".join(f'--against "{name}"' for name in own)
        click.echo(f"Expected is what the paper counts; {options} has what the product sends.")


def _count(value: float | None) -> str:
    return "" if value is None else f"{value:,.6g}"


def _ratio(value: float | None) -> str:
    return "" if value is None else f"{value:,.3g}"


@main.command(short_help="The paper's claims and their verdicts.")
@click.option(
    "--verdict",
    type=click.Choice(["reproduced", "qualified", "contradicted", "not checkable"]),
    help="Only claims with this verdict.",
)
@output_options
def claims(verdict: str | None, output: Output) -> None:
    """List the paper's claims, what we computed, and what became of them.

    \b
    Examples:
      discostorm claims --verdict contradicted
      discostorm claims --csv > claims.csv
    """
    with _working("loading"):
        from discostorm.paper import claims as ledger
    with click.progressbar(
        ledger.claims(), label="computing", file=sys.stderr, hidden=not _live()
    ) as bar:
        rows = [row | {"ours": ledger.exact(row["ours"])} for row in map(ledger.row, bar)]
    counts = Counter(row["verdict"] for row in rows)
    chosen = [row for row in rows if verdict in (None, row["verdict"])]
    if output.for_people:
        shown = ("id", "where", "verdict", "statement")
        chosen = [{name: row[name] for name in shown} for row in chosen]
    _print(chosen, output)
    if output.for_people:
        found = ", ".join(f"{counts[known]} {known}" for known in ledger.VERDICTS)
        click.echo(f"\n{len(rows)} claims: {found}.")
