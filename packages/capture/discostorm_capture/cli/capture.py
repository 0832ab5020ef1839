"""The command ``discostorm capture``."""

from __future__ import annotations

import io
import json
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import discostorm as ds
from discostorm import _checks, words
from discostorm.cli.calculator_link import Link, link_of
from discostorm.cli.fleet_options import compared, display_name, robot_option, standard_input
from discostorm.cli.options import A_FILE, output_options, protocol_option_of
from discostorm.cli.output import (
    BadInput,
    Output,
    Rows,
    bad_input,
    percent,
    plain,
    print_rows,
    to_json,
    visible,
    working,
    write_file,
)
from discostorm.fleet import COUNTS
from discostorm_capture.cli.diagnosis_output import (
    NO_ENDPOINTS,
    is_encrypted,
    show_answer,
    show_tables,
    told,
)

if TYPE_CHECKING:
    import pandas as pd

    from discostorm_capture import Capture


def _drawable(_: click.Context, _parameter: click.Parameter, value: str | None) -> str | None:
    """Return the name of a picture if it says in which of the formats it is to be."""
    if value is not None and Path(value).suffix.lower() not in (".svg", ".pdf", ".png"):
        raise click.BadParameter(f"must end in .svg, .pdf or .png; got {_checks.brief(value)!r}")
    return value


@click.command()
@click.argument("file", **A_FILE)
@protocol_option_of("--against", None, "Model to compare the capture with, instead of the paper's")
@click.option(
    "--fleet",
    **A_FILE,
    help="Fleet file (TOML) to compare with; default: the fleet in the capture.",
)
@robot_option
@click.option("--hosts", type=float, metavar="N", help="Hosts of that robot.")
@click.option(
    "--wired",
    metavar="ADDRESS",
    multiple=True,
    help="Host that is wired to the access point, or 'none'. Repeat the option for several. "
    "Default: hosts that run nothing but Discovery Servers and Zenoh routers.",
)
@click.option(
    "--window",
    type=float,
    metavar="S",
    help="Compare the first S seconds from the first discovery message on, as `breakdown --window` "
    "counts; default: the whole capture.",
)
@click.option(
    "--write-fleet",
    "written",
    **A_FILE,
    help="Write the captured fleet, with wired hosts, as a fleet file (TOML), and give the link "
    "that opens the calculator with it.",
)
@click.option(
    "--picture",
    **A_FILE,
    callback=_drawable,
    help="Draw the capture into a .svg, .pdf or .png file.",
)
@output_options
def capture(
    file: str,
    against: str | None,
    fleet: str | None,
    robot: str | None,
    hosts: float | None,
    wired: tuple[str, ...],
    window: float | None,
    written: str | None,
    picture: str | None,
    output: Output,
) -> None:
    """Diagnose discovery in a capture, and compare its messages with a model.

    The answer comes first: whether discovery is healthy, complete and over. If it is not, the
    command says why and what to do. Then come a table of hosts and a table of messages.

    FILE is pcap or pcapng, plain or as .gz or .xz, or - for standard input, which is read to its
    end. "per unit" divides the captured messages by the processes, pairs of processes or endpoints
    in the capture. Airtime is that of the paper's channel; messages of wired hosts take one hop.
    Record with:

    \b
      {record_file}

    \b
    Examples:
      discostorm capture discovery.pcap
      discostorm capture discovery.pcap --against DDS --fleet fleet.toml --json
      timeout 60 {record_out} |
        discostorm capture -
    """
    with bad_input(), working("reading"):
        if file == fleet == "-":
            raise click.UsageError("either FILE or --fleet may be -, for standard input")
        found = ds.read_capture(standard_input() if file == "-" else file)
        members = compared(fleet, robot, hosts)
        on_wires = _wired(wired)
        spoken = set(found.processes()["protocol"])
        papers = [own for wire, own in (("RTPS", ds.DDS), ("Zenoh", ds.ZENOH)) if wire in spoken]
        tables = papers if against is None else [ds.PROTOCOLS[against]]
        rows = [
            {"protocol": protocol.name} | row
            for protocol in tables
            for row in _whole_rows(
                found.compare(protocol, members, wired=on_wires, window=window).reset_index()
            )
        ]
        seconds = {protocol.name: found.compared_seconds(protocol, window) for protocol in tables}
        sums = found.sums(wired=on_wires)
        diagnosis = found.diagnosis()
        seen = found.fleet(wired=on_wires) if spoken else None
        if written is not None:
            if is_encrypted(diagnosis):
                raise BadInput(f"--write-fleet: {NO_ENDPOINTS}")
            content = _fleet_file(seen or found.fleet(wired=on_wires), display_name(file))
            write_file("--write-fleet", written, content.encode(), file, fleet)
        link = None if seen is None or is_encrypted(diagnosis) else link_of(seen, spoken_by(found))
        groups = () if members is not None or seen is None else seen.groups
        if picture is not None:
            drawing = io.BytesIO()
            kind = Path(picture).suffix[1:].lower()
            found.picture(wired=on_wires).savefig(drawing, format=kind)
            write_file("--picture", picture, drawing.getvalue(), file, fleet)
    if output.as_csv and rows:
        print_rows(rows, output)
    elif output.as_json:
        answer = {
            "file": display_name(file),
            "diagnosis": told(diagnosis, found),
            "packets": found.packets,
            "duration_s": found.duration,
            "hosts": [
                dict(zip(COUNTS, group.counts(), strict=True)) | {"wired": group.wired}
                for group in groups
            ],
            "wired": list(found.serving() if on_wires is None else on_wires),
            "window_s": seconds,
            "sums": _whole_rows(sums.reset_index()),
            "messages": rows,
            "notes": list(found.notes),
            "calculator": None if link is None else link.address,
        }
        click.echo(to_json(answer))
    elif output.for_people:
        show_answer(diagnosis)
        show_tables(diagnosis, output)
        _show_capture(found, groups, rows, output)
        if is_encrypted(diagnosis):
            click.echo(f"Note: {NO_ENDPOINTS}.")
        _show_sums(found, sums, seconds if rows else {})
        if on_wires is None and (serving := found.serving()):
            click.echo(
                f"Note: {' and '.join(serving)}: nothing but servers or routers, taken for wired "
                "to the access point; --wired says which hosts are, --wired none that no host is."
            )
        if against is None and rows:
            _name_own_tables(found)
        if written is not None:
            _name_uses(written, link)


assert capture.help
capture.help = capture.help.format(
    record_file=words.RECORD.format(file="discovery.pcap"), record_out=words.RECORD.format(file="-")
)


def _wired(addresses: tuple[str, ...]) -> tuple[str, ...] | None:
    """Return which hosts are wired, None if the capture is to tell."""
    if not addresses:
        return None
    if "none" in addresses and len(addresses) > 1:
        raise BadInput(f"--wired: none must be the only one; got {', '.join(addresses)}")
    return () if addresses == ("none",) else addresses


def _whole_rows(table: pd.DataFrame) -> list[dict[Any, Any]]:
    """Return the rows of a table, with None where it has no number."""
    return table.astype(object).where(table.notna(), None).to_dict("records")


def _fleet_file(fleet: ds.Fleet, source: str) -> str:
    """Return a fleet file that `plan` and the others take."""
    lines = [f"# Seen in {visible(_checks.brief(source))}."]
    for group in fleet.described():
        lines += ["", "[[groups]]"]
        # A capture does not tell what matches by ROS 2's own names: `shared` is left to the reader.
        known = {key: value for key, value in group.items() if key != "shared"}
        lines += [f"{key} = {_toml(value)}" for key, value in known.items()]
    return "\n".join([*lines, ""])


def _toml(value: str | float | bool) -> str:
    """Return a value in TOML; whole numbers without a point."""
    whole = isinstance(value, float) and value.is_integer()
    return json.dumps(int(value) if whole else value)


def _show_sums(found: Capture, sums: pd.DataFrame, seconds: dict[str, float]) -> None:
    """Say what discovery and users' data take, and for how long was counted."""
    for name, row in sums.iterrows():
        if row["messages"]:
            click.echo(
                f"{words.capitalized(str(name))}: {row['messages']:,.0f} messages, "
                f"{row['bytes']:,.0f} B, {row['airtime_s']:.3f} s of airtime on the paper's "
                f"channel ({percent(row['of_time'])} of {found.duration:.1f} s)"
            )
    for name, time in seconds.items():
        click.echo(f"Counted against {name}: {time:.1f} s from its first message on.")


def _show_capture(
    found: Capture, groups: Sequence[ds.HostGroup], rows: Rows, output: Output
) -> None:
    packets = words.many(found.packets, "packet")
    click.echo(visible(f"{found.path}: {packets} in {found.duration:.3f} s"))
    for group in groups:
        hosts, processes, endpoints = group.counts()
        each = words.many(processes, "process", "es")
        wired = ", wired" if group.wired else ""
        click.echo(f"hosts: {plain(hosts)} with {each} of {plain(endpoints)} endpoints each{wired}")
    if rows:
        print_rows(
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
    if (view := found.view()) is not None:
        click.echo(
            visible(
                f"Note: seen from {view}: of unicast only what it sends and receives; airtime, "
                "too, is that of this part."
            )
        )
    for note in found.notes:
        click.echo(visible(f"Note: {note}."))


def _name_own_tables(found: Capture) -> None:
    """Say how to hold the capture against the tables of the products that sent it."""
    own = sorted(set(found.processes()["product"]) & set(ds.PROTOCOLS))
    if own:
        options = " or ".join(f'--against "{name}"' for name in own)
        click.echo(f"Expected is what the paper counts; {options} has what the product sends.")


def _name_uses(written: str, link: Link | None) -> None:
    """Say what takes the fleet that was written."""
    command = ["discostorm", "plan", written]
    if link is not None and link.middleware is not None:
        command += ["--protocol", link.middleware]
    click.echo(f"Wrote {visible(_checks.brief(written))}. Next: {visible(shlex.join(command))}")
    if link is not None:
        click.echo(f"In the calculator: {link.address}")
        for note in link.notes:
            click.echo(f"Note: {note}.")


def _count(value: float | None) -> str:
    return "" if value is None else f"{value:,.0f}"


def _ratio(value: float | None) -> str:
    return "" if value is None else f"{value:,.3g}"


def spoken_by(capture: Capture) -> str | None:
    """Return which table fits what was captured: that of a server or router, or the commonest."""
    seen = capture.processes()
    seen = seen[seen["product"].isin(list(ds.PROTOCOLS))]
    serving = seen[seen["server"].to_numpy(bool)]
    some = serving if len(serving) else seen
    return str(some["product"].mode().iloc[0]) if len(some) else None
