"""The command ``discostorm simulate``."""

from __future__ import annotations

from dataclasses import dataclass, replace
from statistics import median
from typing import Any

import click

import discostorm as ds
from discostorm import _checks, timeline, words
from discostorm.cli.fleet_options import FleetInput, describe_matching, swarm_options
from discostorm.cli.options import option_group, output_options, protocol_option, radio_options
from discostorm.cli.output import (
    BadInput,
    Column,
    Output,
    bad_input,
    columns_of,
    percent,
    print_channel,
    print_table,
    seconds,
    to_json,
    visible,
)
from discostorm.wifi import Wifi
from discostorm_simulation import NoRecovery, starts

#: When discovery would be complete without user data, a column.
ALONE = "convergence_without_data_s"
#: What delays are called in the table of topics.
TOLD = {"delay_median_s": "median delay", "delay_95_s": "95%", "delay_most_s": "most"}


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
        _checks.number("--window", self.window, 0, _checks.MAX_SECONDS)
        start = starts.at_random(self.window) if self.window else 0.0
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
        """Return a time in words; infinity is what was not seen, NaN what is not simulated."""
        if taken != taken:
            return "not simulated"
        if taken < float("inf"):
            return seconds(taken)
        if self.no_recovery:  # nothing more will be sent
            return "never, as frames were lost"
        return self.not_within

    @property
    def not_within(self) -> str:
        """What is said of a time that did not come."""
        after = " after the last start" if self.window else ""
        return f"not within {_checks.format_exact(self.until)} s{after}"

    def answer(self, found: ds.Simulation) -> str:
        """Return in a sentence or two when the robots know each other."""
        runs = words.count_noun(self.runs, "run")
        known = sorted(found.convergence_time.tolist())
        in_time = [time for time in known if time < float("inf")]
        if not in_time:
            return f"Your robots do not all know each other {self.not_within[4:]} ({runs})."
        late = len(known) - len(in_time)
        missing = f", in {late} of them {self.not_within}" if late else ""
        taken = words.durations(in_time[0], in_time[-1])
        return f"Your robots know each other after {taken} ({runs}{missing})."


def drain(protocol: ds.Protocol, fleet: ds.Fleet, wifi: Wifi, found: ds.Simulation) -> str:
    """Return what is known where recovery is not simulated: how long the channel is busy."""
    taken = float(timeline.drain_time(protocol, fleet, wifi=wifi))
    busy = f"for {words.duration(taken)}" if taken < float("inf") else "indefinitely"
    lost = words.percents(found.lost.min(), found.lost.max())
    return (
        f"Drain time: startup keeps the channel busy {busy} if nothing is lost. Until then some "
        f"robots do not see each other. Here {lost} of the frames are lost, and nothing sends them "
        "again; with recovery it takes longer."
    )


def beside(found: ds.Simulation, alone: ds.Simulation) -> str:
    """Return how much longer the simulated burst takes beside user data."""
    longer, usual = (
        f"over after {words.duration(taken)}" if taken < float("inf") else "not over by the end"
        for taken in (median(one.drain_time.tolist()) for one in (found, alone))
    )
    return f" The simulated startup burst is {longer} beside your data, and {usual} without them."


def _number(name: str, default: float, told: str, unit: str | None = None) -> Any:
    """Return an option that is a number."""
    return click.option(
        name, type=type(default), default=default, show_default=True, metavar=unit, help=told
    )


@describe_matching
@click.command()
@swarm_options
@protocol_option
@option_group(
    "how",
    Runs,
    _number("--runs", 5, "Independent runs."),
    _number("--seed", 0, "Random seed."),
    _number("--loss", 0.0, "Frame error rate, 0 to below 1."),
    _number("--window", 0.0, "Time within which the hosts start, at random.", "s"),
    _number(
        "--until", 120.0, "Simulated time after the last start, with recovery or user data.", "s"
    ),
    click.option(
        "--unlimited", is_flag=True, help="Unlimited queues instead of 500 frames and 0.5 s."
    ),
    click.option("--no-recovery", is_flag=True, help="Let no message answer, and recover no loss."),
)
@radio_options
@output_options
def simulate(
    members: FleetInput, protocols: tuple[ds.Protocol, ...], how: Runs, wifi: Wifi, output: Output
) -> None:
    """Simulate how a fleet starts, frame by frame, in several runs.

    FLEET is a TOML file as `discostorm plan` takes it. With recovery, which is the default,
    messages answer messages and the middleware repairs what is lost. A time that did not come
    is null in JSON, and empty in CSV. Recovery through servers and routers is not simulated:
    for these the answer is the drain time.

    If FLEET lists topics ([[groups.data]]), they are sent beside discovery, and each run is
    repeated without them. A second table tells how late samples were, and which frames arrived.
    Without recovery they are sent from each host's start on, until the end of the simulated time.

    Drained is the end of the last transmission of the start, lost the part of the frames that
    never arrived, converged when every process first knew each other one and its endpoints.

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
    fleet = _whole(members.fleet)
    with bad_input():
        arguments = how.arguments()
        for protocol in protocols:
            fleets = (fleet, fleet.without_data()) if fleet.has_data else (fleet,)
            try:
                results = [ds.simulate(one, protocol, wifi, **arguments) for one in fleets]
            except ImportError as error:
                raise BadInput(str(error)) from error
            except NoRecovery as error:
                refused[protocol.name] = error.why
                unrepaired = arguments | {"recovery": False}
                results = [ds.simulate(one, protocol, wifi, **unrepaired) for one in fleets]
            found[protocol.name] = results[0]
            if fleet.has_data:
                alone[protocol.name] = results[1]
    if refused:
        told, why = words.join_words(list(refused)), next(iter(refused.values()))
        click.echo(visible(f"Note: recovery is not simulated with {told}: {why}."), err=True)
    if output.as_json:
        answers = [
            one.to_dict() | ({"without_data": alone[name].to_dict()} if name in alone else {})
            for name, one in found.items()
        ]
        click.echo(to_json(answers if len(protocols) > 1 else answers[0]))
        return
    if output.for_people and len(found) == 1:
        ((name, one),) = found.items()
        modeled = not how.no_recovery and name not in refused
        said = how.answer(one) if modeled else drain(protocols[0], fleet, wifi, one)
        if name in alone and not modeled:
            said += beside(one, alone[name])
        click.echo(visible(words.wrapped(said)) + "\n")
    shown = ("run", "drain_time_s", "lost", "convergence_time_s", ALONE, "collisions")
    rows: list[dict[Any, Any]] = []
    for name, one in found.items():
        table = one.table().reset_index()
        if name in alone:
            place = list(table).index("convergence_time_s") + 1
            table.insert(place, ALONE, alone[name].convergence_time)
        if name in refused:
            without = [c for c in ("convergence_time_s", ALONE) if c in table]
            table[without] = None if output.as_csv else float("nan")
        named = {"protocol": name} if len(protocols) > 1 else {}
        kept = table if output.as_csv else table[[c for c in table if c in shown]]
        rows += [named | row for row in kept.to_dict("records")]
    printed = columns_of(
        rows,
        Column("drain_time_s", "drained", how.time, "s"),
        Column("lost", format=percent),
        Column("convergence_time_s", "converged", how.time, "s"),
        Column(ALONE, "without data", how.time, "s"),
    )
    print_table(rows, output, printed)
    if alone and output.for_people:
        ends = "until the end of the run"
        if not (how.no_recovery or refused):
            ends = "until discovery was complete"
        elif not how.no_recovery and len(refused) < len(found):
            ends = "until discovery was complete or, where it is not simulated, the end of the run"
        click.echo(f"\nData {ends}, median of the runs:\n")
        late = _late(found)
        special = Column("frames", "frames sent"), Column("arrived", format=percent)
        print_table(late, output, columns_of(late, *special))
    print_channel(wifi, output)


def _whole(fleet: ds.Fleet) -> ds.Fleet:
    """Return a fleet with whole numbers of endpoints, as frames are; say if it had others."""
    groups = []
    for group in fleet.groups:
        endpoints = float(round(group.endpoints))
        groups.append(replace(group, endpoints=endpoints))
        if endpoints != group.endpoints:
            name = f" of {group.name}" if group.name else ""
            note = f"Note: {group.endpoints:g} endpoints of each process{name}, a mean, are "
            click.echo(visible(f"{note}simulated as {endpoints:g}."), err=True)
    return replace(fleet, groups=tuple(groups))


def _late(found: dict[str, ds.Simulation]) -> list[dict[Any, Any]]:
    """Return a row for each topic: frames, the part of them that arrived, and samples' delays."""
    rows = []
    for name, one in found.items():
        for topic, own in one.data.items():
            frames, arrived = float(own["frames"].sum()), float(own["arrived"].sum())
            # Of the runs in which anything arrived; else it is NaN.
            seen = {key: [one for one in own[key].tolist() if one == one] for key in TOLD}
            rows.append(
                ({"protocol": name} if len(found) > 1 else {})
                | {"topic": topic, "frames": median(own["frames"].tolist())}
                | {"arrived": arrived / frames if frames else 0.0}
                | {
                    TOLD[key]: words.duration(median(times)) if times else "none arrived"
                    for key, times in seen.items()
                }
            )
    return rows
