"""The command ``discostorm capture``."""

from __future__ import annotations

import io
import json
import shlex
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

import discostorm as ds
from discostorm import _checks, wording
from discostorm.cli import fleet_options, output as cli_output
from discostorm.cli.calculator_link import CalculatorLink, calculator_link
from discostorm.cli.options import FILE_ARGS, output_options, protocol_option_of
from discostorm.fleet import COUNTS
from discostorm_capture.cli import diagnosis_output
from discostorm_capture.cli.diagnosis_output import OPTIONS
from discostorm_capture.dissection import json_rows
from discostorm_capture.sentences import say

if TYPE_CHECKING:
    from discostorm_capture import Capture


def _check_picture_suffix(_: click.Context, _of: click.Parameter, value: str | None) -> str | None:
    """Return the path of a picture if its suffix names a supported format."""
    if value is not None and Path(value).suffix.lower() not in (".svg", ".pdf", ".png"):
        name = _checks.shorten_name(value)
        raise click.BadParameter(f"must end in .svg, .pdf or .png; got {name!r}")
    return value


@click.command(help=diagnosis_output.read_command_help("capture"))
@click.argument("file", **FILE_ARGS)
@protocol_option_of("--against", None, "Model to compare the capture with, instead of the paper's")
@click.option("--fleet", **FILE_ARGS, help=OPTIONS["fleet"])
@fleet_options.robot_option
@click.option("--hosts", type=float, metavar="N", help=OPTIONS["hosts"])
@diagnosis_output.expect_option
@click.option("--wired", metavar="ADDRESS", multiple=True, help=OPTIONS["wired"])
@click.option("--window", type=float, metavar="S", help=OPTIONS["window"])
@click.option("--write-fleet", "written", **FILE_ARGS, help=OPTIONS["write-fleet"])
@click.option("--picture", **FILE_ARGS, callback=_check_picture_suffix, help=OPTIONS["picture"])
@output_options
def capture(
    file: str,
    against: str | None,
    fleet: str | None,
    robot: str | None,
    hosts: float | None,
    expected: int | tuple[str, ...] | None,
    wired: tuple[str, ...],
    window: float | None,
    written: str | None,
    picture: str | None,
    output: cli_output.Output,
) -> None:
    """Diagnose discovery in a capture, and compare its messages with a model."""
    if file == fleet == "-":
        raise click.UsageError("FILE and --fleet cannot both be -, standard input")
    if file != "-" and Path(file).is_fifo():
        pipe = cli_output.visible(fleet_options.display_name(file))
        click.echo(f"Waiting for a program that writes into {pipe}.", err=True)
    with cli_output.bad_input(), cli_output.show_slow_task("reading"):
        captured = ds.read_capture(fleet_options.standard_input() if file == "-" else file)
        compared = fleet_options.comparison_fleet(fleet, robot, hosts)
        if "none" in wired and len(wired) > 1:
            raise cli_output.BadInput(f"--wired: 'none' must stand alone; got {', '.join(wired)}")
        wired_hosts = () if wired == ("none",) else wired or None  # None: as the capture shows
        wires = set(captured.processes()["protocol"])
        models = [own for wire, own in (("RTPS", ds.DDS), ("Zenoh", ds.ZENOH)) if wire in wires]
        if against is not None:
            models = [ds.PROTOCOLS[against]]
        rows, seconds = [], {}
        for model in models:
            table = captured.compare(model, compared, wired=wired_hosts, window=window)
            rows += [{"protocol": model.name} | row for row in json_rows(table.reset_index())]
            seconds[model.name] = captured.compared_seconds(model, window)
        sums = captured.sums(wired=wired_hosts)
        if expected is None and compared is not None:
            expected = diagnosis_output.count_hosts(compared)
        diagnosis = captured.diagnosis(expected)
        encrypted = any(finding.kind == "encrypted" for finding in diagnosis.findings)
        if written is not None and encrypted:
            raise cli_output.BadInput(f"--write-fleet: {diagnosis_output.ENDPOINTS_ENCRYPTED}")
        own = captured.fleet(wired=wired_hosts) if wires or written is not None else None
        if own is not None and written is not None:
            content = _format_fleet_file(own, fleet_options.display_name(file)).encode()
            cli_output.write_file("--write-fleet", written, content, file, fleet)
        link = None
        if own is not None and not encrypted:
            link = calculator_link(own, most_common_product(captured))
        groups = () if compared is not None or own is None else own.groups
        if picture is not None:
            drawing = io.BytesIO()
            kind = Path(picture).suffix[1:].lower()
            captured.picture(wired=wired_hosts).savefig(drawing, format=kind)
            cli_output.write_file("--picture", picture, drawing.getvalue(), file, fleet)
    if output.as_csv and rows:
        cli_output.print_table(rows, output)
    elif output.as_json:
        answer = {
            "file": fleet_options.display_name(file),
            "diagnosis": diagnosis_output.diagnosis_to_json(diagnosis, captured),
            "packets": captured.packets,
            "duration_s": captured.duration,
            "hosts": [
                dict(zip(COUNTS, group.counts(), strict=True)) | {"wired": group.wired}
                for group in groups
            ],
            "wired": list(captured.servers() if wired_hosts is None else wired_hosts),
            "window_s": seconds,
            "sums": json_rows(sums.reset_index()),
            "messages": rows,
            "notes": list(captured.notes),
            "calculator": None if link is None else link.address,
        }
        click.echo(cli_output.to_json(answer))
    elif output.for_people:
        diagnosis_output.print_diagnosis(diagnosis)
        diagnosis_output.print_diagnosis_tables(diagnosis, output)
        _print_fleet_and_messages(captured, groups, rows, output)
        limits = [*captured.notes, *[diagnosis_output.ENDPOINTS_ENCRYPTED] * encrypted]
        if (view := captured.vantage_host()) is not None:
            limits.insert(0, say("view", view))
        for note in limits:
            click.echo(cli_output.visible(f"Note: {note}."))
        for name, row in sums[sums["messages"] > 0].iterrows():
            sizes = *row[["messages", "bytes", "airtime_s"]], cli_output.percent(row["of_time"])
            click.echo(say("totals", wording.capitalized(str(name)), *sizes, captured.duration))
        for name, time in seconds.items():
            click.echo(say("compared", time, name))
        if wired_hosts is None and (serving := captured.servers()):
            click.echo(say("wired servers", " and ".join(serving)))
        products = sorted(set(captured.processes()["product"]) & set(ds.PROTOCOLS))
        if against is None and rows and products:
            options = " or ".join(f'--against "{name}"' for name in products)
            click.echo(say("expected column", options))
        if written is not None:
            _print_next_command(written, link)


def _format_fleet_file(fleet: ds.Fleet, source: str) -> str:
    """Return the text of a fleet file, for `plan` and other commands."""
    lines = [f"# The fleet captured in {cli_output.visible(_checks.shorten_name(source))}."]
    for group in fleet.to_dicts():
        lines += ["", "[[groups]]"]
        for key, value in group.items():
            is_integer = isinstance(value, float) and value.is_integer()
            # A capture does not show which of ROS 2's own topics the processes share.
            if key != "shared":
                lines.append(f"{key} = {json.dumps(int(value) if is_integer else value)}")
    return "\n".join([*lines, ""])


def _print_fleet_and_messages(
    captured: Capture,
    groups: Sequence[ds.HostGroup],
    rows: cli_output.Rows,
    output: cli_output.Output,
) -> None:
    """Print the captured fleet and the table of messages."""
    packets = wording.count_noun(captured.packets, "packet")
    click.echo(cli_output.visible(f"{captured.path}: {packets} in {captured.duration:.3f} s"))
    for group in groups:
        each = wording.count_noun(group.processes, "process", "es")
        wired = ", wired" if group.wired else ""
        hosts, endpoints = map(cli_output.as_text, (group.hosts, group.endpoints))
        noun = "endpoint" if group.endpoints == 1 else "endpoints"
        click.echo(f"hosts: {hosts} with {each} of {endpoints} {noun} each{wired}")
    if not rows:
        click.echo("The capture shows no RTPS or Zenoh discovery.")
        return
    shown = [{key: row[key] for key in row if key != "protocol"} for row in rows]
    count = _format_or_empty("{:,.0f}")
    columns = cli_output.columns_of(
        shown,
        *(cli_output.Column(key, format=count) for key in ("units", "expected")),
        cli_output.Column("per_unit", format=_format_or_empty("{:,.3g}")),
        cli_output.Column("unicast", "uni"),
        cli_output.Column("multicast", "multi"),
        cli_output.Column("airtime_s", "air", "{:.4f}".format, "s"),
    )
    cli_output.print_table(shown, output, columns)


def _format_or_empty(template: str) -> Callable[[float | None], str]:
    return lambda value: "" if value is None else template.format(value)


def _print_next_command(written: str, link: CalculatorLink | None) -> None:
    """Print the next command for the written fleet file, and the link of the calculator."""
    command = ["discostorm", "plan", written]
    if link is not None and link.middleware is not None:
        command += ["--protocol", link.middleware]
    name = cli_output.visible(_checks.shorten_name(written))
    click.echo(f"Wrote {name}. Next: {cli_output.visible(shlex.join(command))}")
    if link is not None:
        click.echo(f"In the calculator: {link.address}")
        for note in link.notes:
            click.echo(f"Note: {note}.")


def most_common_product(captured: Capture) -> str | None:
    """Return the model of the most common captured product, of servers and routers if any."""
    processes = captured.processes()
    processes = processes[processes["product"].isin(list(ds.PROTOCOLS))]
    serving = processes[processes["server"].to_numpy(bool)]
    products = (serving if len(serving) else processes)["product"]
    return str(products.mode().iloc[0]) if len(products) else None
