"""The command ``discostorm plan``."""

from __future__ import annotations

import math
import shutil
import sys
import tomllib
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

import discostorm as ds
from discostorm import _checks, wording
from discostorm.cli.fleet_options import FleetInput, channels_by_cell, print_channels, swarm_options
from discostorm.cli.options import (
    chosen_distribution,
    output_options,
    parse_number_list,
    protocol_option,
    wifi_options,
)
from discostorm.cli.output import (
    Output,
    bad_input,
    is_live_terminal,
    print_paragraph,
    print_table,
    show_slow_task,
    to_json,
    visible,
)
from discostorm.data import data_path
from discostorm.files import write_folder
from discostorm.fleet import Fleet
from discostorm.ros2_endpoints import likely_shared
from discostorm.wifi import Wifi
from discostorm_planner import answer_text
from discostorm_planner.configuration_folder import configuration_texts, texts_by_path
from discostorm_planner.multi_cell_plan import plan_cells
from discostorm_planner.remedy import Remedy
from discostorm_planner.result import TIME_KEYS, simulate_protocols
from discostorm_planner.simulation_jobs import WITHIN_S, Progress

#: Estimated computing time from which progress is shown [s].
_LONG_WORK_S = 2.0
#: Texts of the command's help and of its options.
_HELP = tomllib.loads(data_path("written/plan_help.toml", "discostorm_planner").read_text("utf-8"))
_OPTIONS: dict[str, str] = _HELP["options"]


@click.command(help=_HELP["plan"].replace("\\b", "\b"))
@swarm_options
@protocol_option
@click.option("--nodes", callback=parse_number_list, metavar="N[,N...]", help=_OPTIONS["nodes"])
@click.option("--shared", type=float, metavar="N", help=_OPTIONS["shared"])
@click.option(
    "--within", type=float, metavar="SECONDS", help=_OPTIONS["within"].format(within=WITHIN_S)
)
@click.option("--all", "all_changes", is_flag=True, help=_OPTIONS["all"])
@click.option("--why", is_flag=True, help=_OPTIONS["why"])
@click.option("--paste", metavar="NAME", help=_OPTIONS["paste"])
@click.option("--write", "folder", metavar="DIR", help=_OPTIONS["write"])
@click.option("--force", is_flag=True, help=_OPTIONS["force"])
@wifi_options
@output_options
def plan(
    fleet_input: FleetInput,
    protocols: tuple[ds.Protocol, ...],
    nodes: Any,
    shared: float | None,
    within: float | None,
    all_changes: bool,
    why: bool,
    paste: str | None,
    folder: str | None,
    force: bool,
    wifi: Wifi,
    output: Output,
) -> None:
    """Say whether a fleet's startup works, and what to change first."""
    ((_, seen, wifi), *others) = channels_by_cell(fleet_input.fleet, wifi)
    with bad_input(), show_slow_task("planning"):
        try:
            fleet = _set_counts(fleet_input.fleet if others else seen, nodes, shared)
            fleet = replace(fleet, ros=chosen_distribution())
            if others:
                plans = [plan_cells(fleet, protocol, within) for protocol in protocols]
            else:
                plans = [ds.plan(fleet, protocol, wifi, within=within) for protocol in protocols]
        except ValueError as error:
            raise ValueError(f"{fleet_input.error_prefix}{error}") from error
    if force and folder is None:
        raise click.UsageError("--force needs --write")
    if paste is not None or folder is not None:
        with bad_input():
            if len(plans) > 1:
                option = "--paste" if folder is None else "--write"
                raise ValueError(f"{option} needs one --protocol; got several")
            if folder is None:
                _print_configuration(plans[0], str(paste), output)
            else:
                _write_configuration(plans[0], paste, folder, force)
    elif others and output.as_csv:
        cells = [(plan.protocol.name, *cell) for plan in plans for cell in plan.cells]
        rows = [{"protocol": name, "cell": cell} | used.to_dict() for name, cell, used in cells]
        print_table(rows, output)
    elif len(plans) > 1:
        _print_comparison(plans, output)
    else:
        is_complete = _simulate_plan(plans[0])
        if output.as_csv:
            print_table(_change_rows(plans[0]), output)
        elif output.as_json:
            click.echo(to_json(plans[0].to_dict()))
        else:
            width = min(max(shutil.get_terminal_size().columns, 40), 79)
            click.echo(visible(plans[0].advice(width, all_changes=all_changes)))
            hints = ["why"] * (not why) + ["all"] * (not all_changes)
            if hints and not (plans[0].all_wired or fleet.hosts() == 1):
                click.echo(wording.wrap(" ".join(map(answer_text.fill, hints)), width))
            if why:
                click.echo("\n" + visible(plans[0].why(width)))
        if not is_complete:
            sys.exit(1)


def _change_rows(answer: ds.Plan) -> list[dict[Any, Any]]:
    """Return CSV rows of all changes, with the discovery times of the simulated changes."""
    found = {c.remedy.what: c.time.to_dict() for c in answer.discovery.changes if c.time}
    rows = answer.to_frame().reset_index().to_dict("records")
    timed = [(row, found.get(row["remedy"], {})) for row in rows]
    return [row | {key: times.get(key) for key in TIME_KEYS} for row, times in timed]


@contextmanager
def _progress_bar(busy: str) -> Iterator[tuple[Progress, Callable[[str], None]]]:
    """Print what takes long, and a bar on a terminal; yield what shows progress, and what tells."""
    given, live = click.get_current_context().params, is_live_terminal()
    plain = not (given["as_json"] or given["as_csv"])
    with ExitStack() as shown:
        bars: list[Any] = []

        def show(done: float, total: float) -> None:
            if (live or plain) and not bars and total > _LONG_WORK_S:
                click.echo(f"{busy} Ctrl-C prints the results so far.", err=True)
                length, to = int(100 * total), sys.stderr
                bar = click.progressbar(length=length, label="runs", file=to, hidden=not live)
                bars.append(shown.enter_context(bar))
            if bars:
                bars[0].update(max(0, int(100 * done) - bars[0].pos))

        def tell(known: str) -> None:
            if bars:
                click.echo("\r\033[K" * live + f"So far: {known}", err=True)

        yield show, tell


def _simulate_plan(answer: ds.Plan) -> bool:
    """Simulate a plan with a progress bar; return whether nothing is left to simulate."""
    if answer.all_wired or answer.fleet.hosts() == 1:
        return True
    low = answer.startup.bounds[0]
    busy = "In your startup, periodic traffic alone fills the channel."
    if math.isfinite(low):
        busy = f"Unchanged, your startup needs at least {wording.time_range(low, low)} of airtime."
    with _progress_bar(f"{busy} Simulating it, unchanged and changed.") as (show, tell):
        return answer.simulate(show, tell, interruptible=True).complete


def _print_comparison(plans: list[ds.Plan], output: Output) -> None:
    """Print the discovery time with each protocol, the shortest first."""
    if (plans[0].all_wired or plans[0].fleet.hosts() == 1) and output.for_people:
        print_paragraph(wording.ALL_WIRED_NOTE if plans[0].all_wired else wording.LONE_HOST_NOTE)
        return
    with _progress_bar(f"Simulating the startup with {len(plans)} protocols.") as (show, _):
        simulate_protocols(plans, show)
    plans = sorted(plans, key=lambda plan: plan.discovery.sort_key())
    if output.as_json:
        click.echo(to_json([plan.to_dict() for plan in plans]))
    elif output.as_csv:
        print_table([_comparison_row(plan) for plan in plans], output)
    else:
        rows, notes = answer_text.compare_protocols(plans)
        print_table(rows, output)
        print_channels(plans[0].fleet, plans[0].wifi, output)
        for note in notes:
            print_paragraph(note)


def _comparison_row(plan: ds.Plan) -> dict[str, Any]:
    """Return the CSV row of the discovery time with one protocol."""
    told = plan.discovery.to_dict()
    row = {"protocol": plan.protocol.name, "works": told["works"], "sure": told["sure"]}
    row |= {key: (told["today"] or {}).get(key) for key in TIME_KEYS}
    return row | {"not_simulated": told["not_simulated"]}


def _find_configured(answer: ds.Plan, name: str) -> Remedy:
    """Return the change with this name; raise a ValueError if it cannot be configured."""
    with _checks.prefix_errors("--paste"):
        remedy = answer.find_change(name)
        if not remedy.snippets:
            raise ValueError(f"{remedy.what} cannot be configured; choose another change")
    return remedy


def _write_configuration(answer: ds.Plan, name: str | None, folder: str, force: bool) -> None:
    """Write the configuration of a change, or of the first sufficient one, if one is needed."""
    if name is None:
        _simulate_plan(answer)
        if answer.discovery.surely_works:
            print_paragraph(answer_text.fill("nothing to write"))
            return
        name = next((c.name for c in answer.discovery.sufficient if c.remedy.snippets), None)
        if name is None:
            raise ValueError(answer_text.fill("nothing written"))
    remedy = _find_configured(answer, name)
    files = texts_by_path(answer.fleet, remedy, answer.within)
    with _checks.prefix_errors("--write"):
        write_folder(Path(folder), files, replace=force)
    begin = f"wrote {len(files)} files. Read {Path(folder) / 'README.md'} first"
    click.echo(visible(f"{wording.capitalized(remedy.what)}: {begin}"))


def _print_configuration(answer: ds.Plan, name: str, output: Output) -> None:
    """Print the configuration for the change with this name."""
    remedy = _find_configured(answer, name)
    texts = configuration_texts(answer.fleet, remedy, answer.within)
    if not output.for_people:
        pieces = zip(remedy.snippets, texts, strict=True)
        rows = [{"change": remedy.what, **piece.to_dict(), "text": text} for piece, text in pieces]
        print_table(rows, output)
        return
    # On standard error, so that the output is nothing but configuration.
    said = f"{wording.capitalized(remedy.what)}:\n"
    if any("ADDRESS_OF_" in text for text in texts):
        said += "Fill in each ADDRESS_OF_..., here or under [addresses] in your fleet file.\n"
    click.echo(visible(said), err=True)
    # Not escaped: it is to be copied as it is.
    click.echo("\n".join(texts), nl=False)


def _set_counts(fleet: Fleet, nodes: float | list[float] | None, shared: float | None) -> Fleet:
    """Set the nodes and shared endpoints of each group from the options, if they are given."""
    count = len(fleet.groups)
    of_groups = nodes if isinstance(nodes, list) else [nodes] * count
    if len(of_groups) != count:
        raise ValueError(f"nodes must be one number, or one per group ({count}); got {nodes}")
    groups = []
    for group, given in zip(fleet.groups, of_groups, strict=True):
        own, many = group.shared, group.nodes if given is None else given
        if own == likely_shared(group.endpoints, group.nodes):
            # More nodes share more endpoints; a number from a fleet file stays.
            own = likely_shared(group.endpoints, many)
        groups.append(replace(group, nodes=many, shared=own if shared is None else shared))
    return replace(fleet, groups=tuple(groups))
