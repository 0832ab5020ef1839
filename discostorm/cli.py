"""The command ``discostorm``: the package's answers as tables, JSON and CSV."""

from __future__ import annotations

import json
import sys
import textwrap
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

import discostorm as ds
from discostorm import words
from discostorm.wifi import Wifi

# What a command needs beyond the package itself is imported when it runs.
if TYPE_CHECKING:
    import pandas as pd

Command = TypeVar("Command", bound=Callable[..., Any])

PROTOCOLS = {"dds": ds.DDS, "zenoh": ds.ZENOH}

#: What an option replaces of the paper's channel, and in which unit.
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
        raise BadInput(f"{error.filename}: {error.strerror}") from error
    except ValueError as error:
        raise BadInput(str(error)) from error


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


def _list_wifi(context: click.Context, _: click.Parameter, value: str) -> str:
    if value == "list":
        click.echo("\n".join(("paper", *ds.WIFI)))
        context.exit()
    return value


def _one_format(context: click.Context, _: click.Parameter, value: bool) -> bool:
    if value and (context.params.get("as_json") or context.params.get("as_csv")):
        raise click.UsageError("--json and --csv exclude each other")
    return value


output_options = _options(
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

wifi_options = _options(
    click.option(
        "--wifi",
        "channel",
        default="paper",
        show_default=True,
        metavar="NAME",
        callback=_list_wifi,
        help="The channel: paper, or a preset such as '802.11ac 80 MHz 2x2'; 'list' lists them.",
    ),
    *(
        click.option(
            f"--{option.replace('_', '-')}",
            type=float,
            metavar=unit,
            help="Instead of the paper's.",
        )
        for option, (_, _, unit) in LINK_OPTIONS.items()
    ),
)

protocol_option = click.option(
    "--protocol",
    type=click.Choice([*PROTOCOLS, "both"]),
    default="both",
    show_default=True,
    help="The middleware.",
)

hosts_option = click.option("--hosts", callback=_numbers, metavar="N", help="Hosts.")
several_hosts_option = click.option(
    "--hosts", callback=_numbers, metavar="N[,N...]", help="Hosts; several give a row each."
)

swarm_options = _options(
    click.option("--processes", type=float, metavar="N", help="Processes on each host."),
    click.option("--endpoints", type=float, metavar="N", help="Endpoints of each process."),
    click.option("--fleet", metavar="FILE", help="Fleet file (TOML) instead of these counts."),
)


def _wifi(name: str, given: Mapping[str, float | None]) -> Wifi:
    """Return the channel of a name, or the paper's with other rates and overheads."""
    changes = {option: value for option, value in given.items() if value is not None}
    if name == "paper":
        if not changes:
            return ds.PAPER
        links = {"unicast": ds.PAPER.unicast, "multicast": ds.PAPER.multicast}
        for option, value in changes.items():
            cast, quantity, unit = LINK_OPTIONS[option]
            try:
                change: dict[str, Any] = {quantity: value * UNITS[unit]}
                links[cast] = replace(links[cast], **change)
            except ValueError as error:
                # Its ranges end at zero, which is the same in all units.
                must, _, _ = str(error).rpartition("; got ")
                raise ValueError(f"{cast} {must}; got {value:g} {unit}") from error
        return Wifi("own channel", links["unicast"], links["multicast"])
    if changes:
        option = next(iter(changes)).replace("_", "-")
        raise click.UsageError(f"--{option} goes with --wifi paper alone; got --wifi {name!r}")
    if name not in ds.WIFI:
        known = ", ".join(repr(preset) for preset in ("paper", *ds.WIFI))
        raise click.UsageError(f"--wifi must be one of {known}; got {name!r}")
    return ds.WIFI[name]


def _protocols(name: str) -> list[ds.Protocol]:
    return list(PROTOCOLS.values()) if name == "both" else [PROTOCOLS[name]]


def _swarm(hosts: Any, processes: float | None, endpoints: float | None) -> dict[str, Any]:
    """Return the three counts, all of which must be given."""
    counts = {"hosts": hosts, "processes": processes, "endpoints": endpoints}
    if missing := [f"--{name}" for name, value in counts.items() if value is None]:
        raise click.UsageError(f"{', '.join(missing)} must be given, or --fleet FILE")
    return counts


def _fleet(
    file: str | None, hosts: Any, processes: float | None, endpoints: float | None
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the columns that name a swarm or fleet, and its fleet if there is a file."""
    if file is None:
        return _swarm(hosts, processes, endpoints), {}
    if any(value is not None for value in (hosts, processes, endpoints)):
        raise click.UsageError("--fleet goes without --hosts, --processes and --endpoints")
    return {"fleet": file}, {"hosts": ds.Fleet.from_toml(file)}


# ---------------------------------------------------------------- output

Format = Callable[[Any], str]

#: Characters in a line, if a table can be made as narrow.
_WIDTH = 79


def _plain(value: Any) -> str:
    if not isinstance(value, float):
        return str(value)
    return f"{value:,.10g}" if value < 1e10 else f"{value:.3g}"


def _percent(value: float) -> str:
    return words.percent(value, decimals=1, below="<")


def _seconds(value: float) -> str:
    return f"{value:.6f}" if value < words.HUGE else f"{value:.3g}"


def _print(
    table: pd.DataFrame,
    as_json: bool,
    as_csv: bool,
    formats: dict[str, Format] | None = None,
    headings: dict[str, str] | None = None,
) -> None:
    """Print a table for people, or all its digits for machines."""
    if as_json:
        click.echo(json.dumps(table.to_dict("records"), indent=2, ensure_ascii=False, default=str))
    elif as_csv:
        click.echo(table.to_csv(index=False, lineterminator="\n"), nl=False)
    else:
        click.echo(_aligned(table, formats or {}, headings or {}))


def _aligned(table: pd.DataFrame, formats: dict[str, Format], headings: dict[str, str]) -> str:
    """Return a table with aligned columns: numbers to the right, words to the left.

    Long words in the last column are broken into lines.
    """
    columns = []
    for name in table.columns:
        values = table[name].tolist()
        cells = [formats.get(str(name), _plain)(value) for value in values]
        heading = headings.get(str(name), str(name).replace("_", " "))
        width = max(map(len, [heading, *cells]))
        number = all(type(value) in (int, float) for value in values)  # a truth is a word
        columns.append(
            [cell.rjust(width) if number else cell.ljust(width) for cell in (heading, *cells)]
        )
    start = sum(len(column[0]) + 2 for column in columns[:-1])
    lines: list[str] = []
    for *row, last in zip(*columns, strict=True):
        parts = textwrap.wrap(last.rstrip(), max(_WIDTH - start, 20)) or [""]
        if last != last.lstrip():
            parts = [last]  # a number, already in its place
        lines.append(("  ".join([*row, parts[0]])).rstrip())
        lines += [" " * start + part for part in parts[1:]]
    lines.insert(1, "-" * max(map(len, lines)))
    return "\n".join(lines)


@contextmanager
def _working(what: str) -> Iterator[None]:
    """Say on a terminal what takes its time, and wipe it out afterwards."""
    shown = sys.stderr.isatty()
    if shown:
        click.echo(f"{what} ...", err=True, nl=False)
    try:
        yield
    finally:
        if shown:
            click.echo("\r" + " " * (len(what) + 4) + "\r", err=True, nl=False)


# ---------------------------------------------------------------- commands


@click.group(
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 it worked, 2 wrong usage or input.",
)
@click.version_option(ds.__version__, message="%(prog)s %(version)s")
def main() -> None:
    """How much Wi-Fi airtime the discovery of ROS 2 robots takes, and what helps.

    Utilization is airtime in one second: 1, or 100%, is a channel that does nothing else;
    2 are two seconds of airtime, which no second has.

    \b
    Examples:
      discostorm utilization --hosts 7 --processes 2 --endpoints 10
      discostorm plan fleet.toml
    """


@main.command(short_help="Airtime of discovery in one second.")
@several_hosts_option
@swarm_options
@protocol_option
@wifi_options
@output_options
def utilization(
    hosts: Any,
    processes: float | None,
    endpoints: float | None,
    fleet: str | None,
    protocol: str,
    as_json: bool,
    as_csv: bool,
    channel: str,
    **rates: float | None,
) -> None:
    """Compute the airtime of discovery in one second, of a swarm or of a fleet file.

    \b
    Examples:
      discostorm utilization --hosts 3,5,7 --processes 2 --endpoints 10
      discostorm utilization --fleet fleet.toml --protocol zenoh --json
      discostorm utilization --hosts 7 --processes 2 --endpoints 10 \\
          --wifi '802.11ac 80 MHz 2x2'
    """
    with _bad_input(), _working("computing"):
        import pandas as pd

        wifi = _wifi(channel, rates)
        columns, members = _fleet(fleet, hosts, processes, endpoints)
        tables = []
        for chosen in _protocols(protocol):
            value = ds.utilization(chosen, **(members or columns), wifi=wifi)
            row = {"protocol": chosen.name} | columns | {"utilization": value}
            # One row, or one a number of hosts.
            tables.append(pd.DataFrame(row, index=None if isinstance(hosts, list) else [0]))
        table = pd.concat(tables, ignore_index=True)
        table["fits"] = table["utilization"].map(words.fits)
    _print(table, as_json, as_csv, {"utilization": _percent, "fits": _yes})


def _yes(value: bool) -> str:
    return "yes" if value else "no"


@main.command(short_help="What each message costs.")
@hosts_option
@swarm_options
@protocol_option
@wifi_options
@output_options
def breakdown(
    hosts: Any,
    processes: float | None,
    endpoints: float | None,
    fleet: str | None,
    protocol: str,
    as_json: bool,
    as_csv: bool,
    channel: str,
    **rates: float | None,
) -> None:
    """Show what each message of the discovery costs, up to the access point and down.

    \b
    Examples:
      discostorm breakdown --hosts 7 --processes 2 --endpoints 10 --protocol dds
      discostorm breakdown --fleet fleet.toml --csv
    """
    if isinstance(hosts, list):
        raise click.UsageError("--hosts must be one number here")
    with _bad_input(), _working("computing"):
        import pandas as pd

        wifi = _wifi(channel, rates)
        columns, members = _fleet(fleet, hosts, processes, endpoints)
        tables = []
        for chosen in _protocols(protocol):
            costs = ds.breakdown(chosen, **(members or columns), wifi=wifi).reset_index()
            costs.insert(0, "protocol", chosen.name)
            airtime = costs["uplink_s"] + costs["downlink_s"]
            costs["share"] = airtime / airtime.sum()
            tables.append(costs)
        table = pd.concat(tables, ignore_index=True)
    if not (as_json or as_csv):
        table = table.drop(columns="phase")  # which would make the lines too long
    _print(
        table,
        as_json,
        as_csv,
        {"uplink_s": _seconds, "downlink_s": _seconds, "share": _percent},
        {
            "frame_bytes": "frame [B]",
            "uplink_messages": "messages",
            "uplink_s": "up [s]",
            "downlink_s": "down [s]",
        },
    )


def _hosts(value: float | None) -> str:
    return "less than 1" if value is None else f"{value:.2f}"


@main.command(short_help="Hosts at which the channel is full.")
@click.option("--processes", type=float, required=True, metavar="N", help="Of each host.")
@click.option("--endpoints", type=float, required=True, metavar="N", help="Of each process.")
@click.option(
    "--limit", type=float, default=1.0, show_default=True, help="Utilization to reach, 1 is 100%."
)
@click.option("--beside", metavar="FILE", help="Fleet file of other hosts on the channel.")
@protocol_option
@wifi_options
@output_options
def saturation(
    processes: float,
    endpoints: float,
    limit: float,
    beside: str | None,
    protocol: str,
    as_json: bool,
    as_csv: bool,
    channel: str,
    **rates: float | None,
) -> None:
    """Tell how many like hosts there are when discovery fills the channel.

    \b
    Examples:
      discostorm saturation --processes 2 --endpoints 10
      discostorm saturation --processes 1 --endpoints 678 --limit 0.5 --json
    """
    with _bad_input(), _working("computing"):
        import pandas as pd

        wifi = _wifi(channel, rates)
        others = None if beside is None else ds.Fleet.from_toml(beside)
        host = ds.HostGroup(1, processes, endpoints)
        least = ds.Fleet((host, *(others.groups if others else ())))
        rows = []
        for chosen in _protocols(protocol):
            full = ds.utilization(chosen, least, wifi=wifi) > limit > 0
            hosts = (
                None
                if full
                else ds.saturation_hosts(
                    chosen, processes, endpoints, wifi=wifi, limit=limit, beside=others
                )
            )
            rows.append(
                {
                    "protocol": chosen.name,
                    "processes": processes,
                    "endpoints": endpoints,
                    "limit": limit,
                    "hosts": hosts,
                    "fit": 0 if hosts is None else words.whole_below(float(hosts)),
                }
            )
        table = pd.DataFrame(rows, dtype=object)  # keeps the None of no hosts
    _print(
        table,
        as_json,
        as_csv,
        {"limit": _percent, "hosts": _hosts},
        {"hosts": "saturated at hosts", "fit": "hosts that fit"},
    )


@main.command(short_help="Advice for a fleet: what would help most.")
@click.argument("fleet", metavar="FLEET")
@click.option(
    "--protocol",
    type=click.Choice(list(PROTOCOLS)),
    default="dds",
    show_default=True,
    help="The middleware.",
)
@click.option(
    "--nodes",
    callback=_numbers,
    metavar="N[,N...]",
    help="Nodes with parameter services in each process; with commas, one number for each "
    "group.  [default: 1 where the endpoints are enough]",
)
@wifi_options
@output_options
def plan(
    fleet: str,
    protocol: str,
    nodes: Any,
    as_json: bool,
    as_csv: bool,
    channel: str,
    **rates: float | None,
) -> None:
    """Advise the fleet of a file: what dominates, and what would help most.

    FLEET is a TOML file with a table for each group of like hosts:

    \b
      [[groups]]
      name = "robots"
      hosts = 10
      processes = 1       # of each host
      endpoints = 678     # of each process

    \b
    Examples:
      discostorm plan fleet.toml
      discostorm plan fleet.toml --protocol zenoh --wifi '802.11n 20 MHz 2x2'
      discostorm plan fleet.toml --nodes 13,2 --json
    """
    with _bad_input(), _working("planning"):
        wifi = _wifi(channel, rates)
        members = ds.Fleet.from_toml(fleet)
        try:
            answer = ds.plan(members, PROTOCOLS[protocol], wifi, nodes=nodes)
        except ValueError as error:
            raise ValueError(f"{fleet}: {error}") from error
        table = answer.table().reset_index() if as_csv else None
    if table is not None:
        _print(table, as_json=False, as_csv=True)
    else:
        click.echo(answer.to_json() if as_json else answer.advice())


@main.command(short_help="The start of a fleet on the air, frame by frame.")
@click.argument("fleet", metavar="FLEET")
@click.option(
    "--protocol",
    default="DDS",
    show_default=True,
    metavar="NAME",
    help="The middleware, such as 'Fast DDS'.",
)
@click.option("--runs", type=int, default=5, show_default=True, help="Independent runs.")
@click.option("--seed", type=int, default=0, show_default=True, help="Of the random numbers.")
@click.option("--loss", type=float, default=0.0, show_default=True, help="Frame errors, 0 to 1.")
@click.option(
    "--window", type=float, default=0.0, metavar="s", help="Hosts start at random in this time."
)
@click.option("--until", type=float, default=120.0, show_default=True, help="When to give up [s].")
@click.option("--aifsn", type=int, help="Slots after SIFS before the back-off.")
@click.option("--mpdus", type=int, help="Most frames in an A-MPDU.")
@click.option("--unlimited", is_flag=True, help="Queues without limits, not 500 frames and 0.5 s.")
@click.option("--no-recovery", is_flag=True, help="Nothing answers and nothing is repeated.")
@click.option("--wifi", "channel", default="paper", callback=_list_wifi, help="As elsewhere.")
@output_options
def simulate(
    fleet: str,
    protocol: str,
    runs: int,
    seed: int,
    loss: float,
    window: float,
    until: float,
    aifsn: int | None,
    mpdus: int | None,
    unlimited: bool,
    no_recovery: bool,
    channel: str,
    as_json: bool,
    as_csv: bool,
) -> None:
    """Simulate how the fleet of a file starts, frame by frame, in several runs.

    FLEET is a TOML file as `discostorm plan` takes it. With recovery, which is the default,
    messages answer messages and the middleware repairs what is lost.

    \b
    Examples:
      discostorm simulate fleet.toml
      discostorm simulate fleet.toml --protocol 'Fast DDS' --window 30 --json
      discostorm simulate fleet.toml --no-recovery --unlimited --mpdus 64
    """
    with _bad_input():
        if protocol not in ds.PROTOCOLS:
            known = ", ".join(repr(name) for name in ds.PROTOCOLS)
            raise ValueError(f"--protocol must be one of {known}; got {protocol!r}")
        wifi = _wifi(channel, {})
        for name, value in (("aifsn", aifsn), ("mpdus", mpdus)):
            if value is not None and wifi.radio is not None:
                change: dict[str, Any] = {name: value}
                wifi = replace(wifi.radio, **change).wifi()
        if not 0 <= window < float("inf"):
            raise ValueError(f"--window must be a finite number of at least 0; got {window:g}")
        try:
            found = ds.simulate(
                ds.Fleet.from_toml(fleet),
                ds.PROTOCOLS[protocol],
                wifi,
                queue=None if unlimited else (500, 0.5),
                start=(lambda rng, hosts: rng.uniform(0, window, hosts)) if window else 0.0,
                loss=loss,
                recovery=not no_recovery,
                runs=runs,
                seed=seed,
                until=until,
            )
        except ImportError as error:
            raise click.ClickException(str(error)) from error
    if as_json:
        click.echo(found.to_json())
        return
    table = found.table().reset_index()
    if not as_csv:
        table = table[["run", "drain_time_s", "lost", "convergence_time_s", "collisions"]]
    times: dict[str, Format] = {
        "drain_time_s": _seconds,
        "lost": _percent,
        "convergence_time_s": _never,
    }
    _print(
        table,
        False,
        as_csv,
        times,
        {"drain_time_s": "drained [s]", "convergence_time_s": "converged [s]"},
    )


def _never(value: float) -> str:
    return "never" if value == float("inf") else _seconds(value)


@main.command(short_help="Write the paper's figures and their data.")
@click.option("--out", required=True, metavar="DIR", help="Folder to write to, made if missing.")
@output_options
def figures(out: str, as_json: bool, as_csv: bool) -> None:
    """Write Figs. 2 to 4 of the paper as SVG, PDF and PNG, and their data as CSV.

    \b
    Example:
      discostorm figures --out figures
    """
    if not out:
        raise click.UsageError("--out must name a folder; got ''")
    machine = as_json or as_csv
    with _working("loading"):
        import pandas as pd

        from discostorm import figures as drawing
    paths = []
    count = drawing.files_of_all()
    try:
        for number, path in enumerate(drawing.save_all(Path(out)), start=1):
            paths.append(str(path))
            click.echo(f"[{number:{len(str(count))}}/{count}] {path}", err=machine)
    except OSError as error:
        raise BadInput(
            f"--out must be a folder to write to; got {out!r}: {error.strerror}"
        ) from error
    if machine:
        _print(pd.DataFrame({"path": paths}), as_json, as_csv)


@main.command(short_help="The paper's claims and their verdicts.")
@click.option(
    "--verdict",
    type=click.Choice(["reproduced", "qualified", "contradicted", "not checkable"]),
    help="Only claims with this verdict.",
)
@output_options
def claims(verdict: str | None, as_json: bool, as_csv: bool) -> None:
    """List the paper's claims, what we computed, and what became of them.

    \b
    Examples:
      discostorm claims --verdict contradicted
      discostorm claims --csv > claims.csv
    """
    with _working("loading"):
        from discostorm.paper import claims as ledger
    checked = ledger.claims()
    with click.progressbar(
        checked, label="computing", file=sys.stderr, hidden=not sys.stderr.isatty()
    ) as bar:
        for claim in bar:
            claim.verdict()
    table = ledger.ledger().reset_index()
    counts = table["verdict"].value_counts()
    if verdict:
        table = table[table["verdict"] == verdict]
    table["ours"] = [ledger.exact(value) for value in table["ours"]]
    if as_json or as_csv:
        _print(table, as_json, as_csv)
        return
    _print(table[["id", "where", "verdict", "statement"]], as_json, as_csv)
    found = ", ".join(f"{counts.get(known, 0)} {known}" for known in ledger.VERDICTS)
    click.echo(f"\n{len(checked)} claims: {found}.")
