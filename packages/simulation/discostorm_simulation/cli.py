"""The command ``discostorm simulate``."""

from dataclasses import dataclass, replace
from statistics import median
from typing import Any

import click

import discostorm as ds
from discostorm import _checks, drain_times, wording
from discostorm.cli import fleet_options as fleets, output as out
from discostorm.cli.options import option_group, output_options, protocol_option, radio_options
from discostorm.cli.output import Column, Output
from discostorm.lookup import as_wifi
from discostorm.wifi import Wifi
from discostorm.wifi.radio import aggregation_bounds
from discostorm_simulation import NoRecovery, starts

#: Column: convergence time of the same runs without user data [s].
WITHOUT_DATA_COLUMN = "convergence_without_data_s"
#: Column heads of the delays in the table of topics.
DELAY_HEADS = {"delay_median_s": "median delay", "delay_95_s": "95%", "delay_most_s": "most"}


@dataclass(frozen=True)
class RunOptions:
    """Options of the command `simulate`."""

    runs: int
    seed: int
    loss: float
    window: float
    until: float
    unlimited: bool
    no_recovery: bool

    def arguments(self) -> dict[str, Any]:
        """Return the keyword arguments for `discostorm_simulation.simulate`."""
        _checks.number("--window", self.window, 0, _checks.MAX_SECONDS)
        start = starts.uniform_start(self.window) if self.window else 0.0
        queue = None if self.unlimited else (500, 0.5)
        same = {name: getattr(self, name) for name in ("loss", "runs", "seed", "until")}
        return same | {"queue": queue, "start": start, "recovery": not self.no_recovery}

    def time(self, taken: float) -> str:
        """Format a time; infinity means "not observed", NaN means "not simulated"."""
        if taken != taken:
            return "not simulated"
        if taken < float("inf"):
            return out.format_seconds(taken)
        if self.no_recovery:  # without recovery, nothing retransmits lost frames
            return "never, as frames were lost"
        return self.not_observed_text

    @property
    def not_observed_text(self) -> str:
        """Text for a time that exceeds the simulated period."""
        after = " after the last start" if self.window else ""
        return f"not within {_checks.format_exact(self.until)} s{after}"

    def answer(self, found: ds.Simulation) -> str:
        """State in one or two sentences when discovery is complete."""
        runs = wording.count_noun(self.runs, "run")
        in_time = sorted(time for time in found.convergence_time.tolist() if time < float("inf"))
        if not in_time:
            return f"Not all robots discover each other {self.not_observed_text[4:]} ({runs})."
        late = self.runs - len(in_time)
        missing = f", in {late} of them {self.not_observed_text}" if late else ""
        taken = wording.time_range(in_time[0], in_time[-1])
        lost = int((found.counts["expired"] > 0).sum())
        forget = f" Leases of running robots expire in {lost} of the runs." if lost else ""
        return f"Your robots have discovered each other after {taken} ({runs}{missing}).{forget}"


def describe_drain(protocol: ds.Protocol, fleet: ds.Fleet, wifi: Wifi, found: ds.Simulation) -> str:
    """Describe a run without recovery: how long startup keeps the channel busy."""
    channels = [(seen, own) for _, seen, own in fleets.channels_by_cell(fleet, wifi)]
    taken = max(float(drain_times.drain_time(protocol, seen, wifi=own)) for seen, own in channels)
    busy = f"for {wording.duration(taken)}" if taken < float("inf") else "indefinitely"
    lost = wording.percent_range(found.lost.min(), found.lost.max())
    return (
        f"Drain time: startup keeps the channel busy {busy} if nothing is lost. Until then, some "
        f"robots do not see each other. In these runs, {lost} of the frames are lost for good. "
        "With recovery, startup takes longer."
    )


def compare_drain_times(with_data: ds.Simulation, without_data: ds.Simulation) -> str:
    """Compare the duration of the startup burst with and without user data."""
    longer, usual = (
        f"ends after {wording.duration(taken)}" if taken < float("inf") else "does not end"
        for taken in (median(one.drain_time.tolist()) for one in (with_data, without_data))
    )
    return f" The simulated startup burst {longer} with your data, and {usual} without it."


def _number_option(name: str, default: float, text: str, unit: str | None = None) -> Any:
    """Return a click option for a number."""
    return click.option(
        name, type=type(default), default=default, show_default=True, metavar=unit, help=text
    )


def _flag(name: str, text: str) -> Any:
    return click.option(name, is_flag=True, help=text)


@fleets.describe_matching
@click.command()
@fleets.swarm_options
@protocol_option
@option_group(
    "options",
    RunOptions,
    _number_option("--runs", 5, "Independent runs."),
    _number_option("--seed", 0, "Random seed."),
    _number_option("--loss", 0.0, "Frame error rate, from 0 to below 1."),
    _number_option("--window", 0.0, "Each host starts at a random time within this window.", "s"),
    _number_option(
        "--until", 120.0, "Simulated time after the last start, with recovery or user data.", "s"
    ),
    _flag("--unlimited", "Do not limit queues to 500 frames and 0.5 s."),
    _flag("--no-recovery", "Simulate neither answers nor the recovery of losses."),
)
@radio_options
@output_options
def simulate(
    fleet_input: fleets.FleetInput,
    protocols: tuple[ds.Protocol, ...],
    options: RunOptions,
    wifi: Wifi,
    output: Output,
) -> None:
    """Simulate the startup of a fleet, frame by frame, in several runs.

    FLEET is a fleet file in TOML; `discostorm plan --help` describes the format. Radios put up to
    64 frames for one receiver into an A-MPDU, if their standard allows it. With recovery (the
    default), messages trigger answers, and the middleware recovers lost messages. For a server on a
    robot, we do not simulate recovery, and the result is the drain time. Times beyond the end of a
    run are null in JSON and empty in CSV.

    If FLEET lists topics ([[groups.data]]), hosts publish on them during discovery, and each run is
    repeated without topics. A second table shows the samples' delays and the share of frames that
    arrived. Without recovery, hosts publish until the end of the run.

    "Drained" is the end of the burst's last transmission. "Lost" is the share of frames that never
    arrived. "Converged" is the time at which every process knows all others and their endpoints.

    {matching}

    \b
    Examples:
      discostorm simulate fleet.toml --until 5
      discostorm simulate --robot node --hosts 6 --protocol cyclonedds --protocol fastdds
      discostorm simulate fleet.toml --window 30 --until 5 --json
      discostorm simulate fleet.toml --no-recovery --wifi '802.11ac 80 MHz 2x2'
    """
    found: dict[str, ds.Simulation] = {}
    alone: dict[str, ds.Simulation] = {}
    refused: dict[str, str] = {}
    fleet, wifi = _with_integer_endpoints(fleet_input.fleet), aggregation_bounds(wifi)[0]
    cells = (replace(one, wifi=aggregation_bounds(as_wifi(one.wifi))[0]) for one in fleet.cells)
    fleet = replace(fleet, cells=tuple(cells))
    with out.bad_input():
        arguments = options.arguments()
        for protocol in protocols:
            cases = (fleet, fleet.without_data()) if fleet.has_data else (fleet,)
            try:
                results = [ds.simulate(one, protocol, wifi, **arguments) for one in cases]
            except ImportError as error:
                raise out.BadInput(str(error)) from error
            except NoRecovery as error:
                refused[protocol.name] = error.why
                unrepaired = arguments | {"recovery": False}
                results = [ds.simulate(one, protocol, wifi, **unrepaired) for one in cases]
            found[protocol.name] = results[0]
            if fleet.has_data:
                alone[protocol.name] = results[1]
    if refused:
        text, why = wording.join_words(list(refused)), next(iter(refused.values()))
        click.echo(
            out.visible(f"Note: We do not simulate recovery with {text}, because {why}."), err=True
        )
    if output.as_json:
        beside = {name: {"without_data": one.to_dict()} for name, one in alone.items()}
        answers = [one.to_dict() | beside.get(name, {}) for name, one in found.items()]
        click.echo(out.to_json(answers if len(protocols) > 1 else answers[0]))
        return
    if output.for_people and len(found) == 1:
        ((name, one),) = found.items()
        modeled = not options.no_recovery and name not in refused
        said = options.answer(one) if modeled else describe_drain(protocols[0], fleet, wifi, one)
        if name in alone and not modeled:
            said += compare_drain_times(one, alone[name])
        click.echo(out.visible(wording.wrap(said)) + "\n")
    shown = ("run", "drain_time_s", "lost", "convergence_time_s", WITHOUT_DATA_COLUMN, "collisions")
    rows: list[dict[Any, Any]] = []
    for name, one in found.items():
        table = one.table().reset_index()
        if name in alone:
            place = list(table).index("convergence_time_s") + 1
            table.insert(place, WITHOUT_DATA_COLUMN, alone[name].convergence_time)
        if name in refused:
            without = [c for c in ("convergence_time_s", WITHOUT_DATA_COLUMN) if c in table]
            table[without] = None if output.as_csv else float("nan")
        named = {"protocol": name} if len(protocols) > 1 else {}
        kept = table if output.as_csv else table[[c for c in table if c in shown]]
        rows += [named | row for row in kept.to_dict("records")]
    printed = out.columns_of(
        rows,
        Column("drain_time_s", "drained", options.time, "s"),
        Column("lost", format=out.percent),
        Column("convergence_time_s", "converged", options.time, "s"),
        Column(WITHOUT_DATA_COLUMN, "without data", options.time, "s"),
    )
    out.print_table(rows, output, printed)
    if alone and output.for_people:
        ends = "until the end of the run"
        if not (options.no_recovery or refused):
            ends = "until discovery was complete"
        elif not options.no_recovery and len(refused) < len(found):
            ends = "until discovery was complete or, where it is not simulated, the end of the run"
        click.echo(f"\nData {ends} (medians of all runs):\n")
        late = _user_data_rows(found)
        special = Column("frames", "radio frames"), Column("arrived", format=out.percent)
        out.print_table(late, output, out.columns_of(late, *special))
    fleets.print_channels(fleet, wifi, output)


def _with_integer_endpoints(fleet: ds.Fleet) -> ds.Fleet:
    """Split mean endpoints over processes; print a note if that changes the mean."""
    groups = tuple(group.with_integer_endpoints() for group in fleet.groups)
    for name, group, whole in zip(fleet.names, fleet.groups, groups, strict=True):
        if f"{group.endpoints:.1f}" != f"{whole.endpoints:.1f}":
            note = f'Note: a process of "{name}" has {group.endpoints:g} endpoints on average; we '
            click.echo(out.visible(f"{note}simulate {whole.endpoints:g}."), err=True)
    return replace(fleet, groups=groups)


def _user_data_rows(found: dict[str, ds.Simulation]) -> list[dict[Any, Any]]:
    """Return a row for each topic: frames sent, share that arrived, and sample delays."""
    rows = []
    for name, one in found.items():
        for topic, own in one.data.items():
            frames, arrived = float(own["frames"].sum()), float(own["arrived"].sum())
            # Leave out runs in which no frame arrived: their delay is NaN.
            seen = {key: [one for one in own[key].tolist() if one == one] for key in DELAY_HEADS}
            row: dict[Any, Any] = {"protocol": name} if len(found) > 1 else {}
            row |= {"topic": topic, "frames": median(own["frames"].tolist())}
            row |= {"arrived": arrived / frames if frames else 0.0}
            for key, times in seen.items():
                row[DELAY_HEADS[key]] = wording.duration(median(times)) if times else "none arrived"
            rows.append(row)
    return rows
