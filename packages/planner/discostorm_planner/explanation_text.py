"""Write the explanations of a plan: drain time, airtime and its parts, changes, assumptions."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from discostorm import wording
from discostorm.messages import ENDPOINT, PAPER_WINDOW, Unit
from discostorm.protocols import DDS, ZENOH
from discostorm.wifi.radio import TOPOLOGY
from discostorm_planner.aggregation_range import AggregationRange
from discostorm_planner.answer_text import describe_change, describe_time, fill, phrase, time_after
from discostorm_planner.further_loads import ConfigurationLoad, UserDataLoad
from discostorm_planner.service_reply_wait import MAX_BLOCKING_TIME

if TYPE_CHECKING:
    from discostorm_planner.remedy import Remedy
    from discostorm_planner.result import Plan

#: Maximum number of groups that are named.
_MAX_GROUPS = 5


def format_explanation(plan: Plan, width: int) -> str:
    """Return all explanations in lines of at most ``width`` letters."""
    if plan.all_wired:
        return wording.wrap(wording.ALL_WIRED_NOTE, width)
    alone = plan.fleet.hosts() == 1
    lines = [] if alone else [*_drain_time_lines(plan), *_service_wait_lines(plan), ""]
    if plan.data:
        lines += [*_user_data_lines(plan.data, plan.window), ""]
    lines += [*_airtime_lines(plan), "", *_share_lines(plan)]
    if alone:  # a lone robot needs no change
        return _wrap_lines([*lines, "", wording.LONE_HOST_NOTE], width)
    number = 0
    for title, remedies in plan.sections().items():
        lines += ["", title]
        for remedy in remedies:
            number += 1
            told = wording.join_sentences(remedy.gain_clause("it "), remedy.note)
            what = _times_of_change(plan, remedy) or f"{remedy.what}: {told}"
            lines += [f"{number:2}. {wording.capitalized(what)}.", f"    {remedy.caution()}"]
    lines += ["", "The same fleet with each measured configuration:"]
    rests_on = [f"- {line}" for line in _basis_lines(plan)]
    basis = ["", "What these numbers rest on:", *rests_on] * bool(rests_on)
    rest = wording.count_noun(len(plan.remedies) + len(plan.combinations) - number, "more change")
    basis += [
        "",
        "`discostorm plan --paste NAME` prints the configuration for a change. `--json` lists all "
        f"configurations and {rest}, and says why it omits other changes.",
    ]
    table = configuration_table(plan.configurations, width)
    return "\n".join([_wrap_lines(lines, width), *table, _wrap_lines(basis, width)])


def _times_of_change(plan: Plan, remedy: Remedy) -> str:
    """Describe a change and the discovery times before and after it; "" if not simulated."""
    today = plan.discovery.today
    for change in plan.discovery.changes:
        if change.remedy is remedy and change.time and today:
            return f"{describe_change(change)}: {describe_time(today)} -> {time_after(change)}"
    return ""


def _wrap_lines(lines: list[str], width: int) -> str:
    return "\n".join(wording.wrap(line, width) for line in lines)


def _drain_time_lines(plan: Plan) -> Iterator[str]:
    """Yield sentences on the drain time and its assumptions."""
    steady, startup = plan.steady_range, plan.startup
    if not wording.below_capacity(steady.full) and math.isfinite(plan.window):
        yield fill("never fits", share=wording.percent(steady.full))
        return
    busy = f"startup keeps the channel busy for {_time_range(startup)} if nothing is lost"
    if math.isinf(startup.bounds[0]):
        busy = "startup never ends"
    today = plan.discovery.today
    time = today.median if today else 0.0
    why = "" if math.isinf(time) else fill("later" if time > startup.bounds[0] else "sooner")
    yield fill("drain time", busy=busy, why=why).strip()
    if startup.differs:
        yield fill("full A-MPDUs")
    if not wording.below_capacity(steady.single) and math.isfinite(plan.window):
        yield fill("may never fit", share=wording.percent(steady.single))


def _service_wait_lines(plan: Plan) -> Iterator[str]:
    """Yield how long servers must wait for the reply readers of their clients during startup."""
    today, kinds = plan.discovery.today, {message.kind for message in plan.protocol.messages}
    if today and today.pairs_done and "SEDP" in kinds and today.reply_wait > MAX_BLOCKING_TIME:
        wait, usual = wording.duration(today.reply_wait), wording.duration(MAX_BLOCKING_TIME)
        key = "reply wait" if math.isfinite(today.reply_wait) else "endless reply wait"
        yield fill(key, wait=wait, usual=usual)


def _user_data_lines(load: UserDataLoad, window: float) -> Iterator[str]:
    """Yield whether the data fit, once discovery is complete and until then."""
    data, both = _percent_range(load.data), _percent_range(load.with_periodic)
    key = "data load" if data != both else "data load and little else"
    yield fill(key, data=data, both=both, fit=load.with_periodic.verdict)
    if math.isfinite(window):
        airtime = _time_range(load.with_discovery, window)
        fit, time = load.with_discovery.verdict, _first_seconds(window)
        yield fill("data during startup", fit=fit, airtime=airtime, time=time)
    if wording.below_capacity(load.with_periodic.full):
        alone = wording.duration(load.drain_time_alone.bounds[0])
        if (time := _time_range(load.drain_time_with_data)) != alone:
            yield fill("data wait", time=time, alone=alone)
    else:
        yield fill("no room for data")


def _airtime_lines(plan: Plan) -> Iterator[str]:
    """Yield the airtime of discovery and of a reboot, and the channel."""
    found, steady = plan.utilization_range, math.isinf(plan.window)
    airtime, channel = _time_range(found, plan.window), _percent_range(found)
    needs = f"{channel} of the channel" if steady else f"{airtime} of airtime"
    hosts = wording.count_noun(plan.fleet.hosts(), "host")
    processes = wording.count_noun(plan.fleet.processes(), "process", "es")
    yield f"Discovery of {hosts} ({processes}) over {phrase(plan.protocol.name)} needs {needs}."
    fits = f"the fleet {plan.verdict}" if steady else f"discovery {plan.verdict}"
    load = wording.format_load(found.bounds[0], "", "the capacity").strip()
    time = "the steady state" if steady else _first_seconds(plan.window)
    yield f"Utilization in {time}: {_at_least(found)}{load}, so {fits}."
    if plan.reboot is not None:
        robot = f' in "{plan.reboot.group}"' if len(plan.fleet.groups) > 1 else ""
        low = wording.duration(plan.reboot.low)
        yield f"When one robot{robot} reboots, discovery needs at least {low} of airtime."
    exchanges = "full A-MPDUs" if found.differs else "one message per frame"
    assumed = f"no losses · no collisions · {exchanges}"
    yield f"Channel: {phrase(plan.wifi.name)}, {TOPOLOGY}. This estimate assumes: {assumed}."


def _share_lines(plan: Plan) -> Iterator[str]:
    """Yield the largest message, the largest phase and the largest groups."""
    yield "The largest shares of this airtime (they overlap):"
    for kind, noun in (("message", "Message type"), ("phase", "Phase")):
        largest = plan.shares_of_kind(kind)[0]
        yield f"- {noun}: {phrase(largest.name)} ({wording.format_share(largest.share)})."
    groups = plan.shares_of_kind("group")
    for group in groups[:_MAX_GROUPS] * (len(groups) > 1):
        yield f'- Traffic to or from "{group.name}": {wording.format_share(group.share)}.'
    if len(groups) > _MAX_GROUPS:
        rest, share = len(groups) - _MAX_GROUPS, wording.format_share(groups[_MAX_GROUPS].share)
        others = wording.count_noun(rest, "other group")
        yield f"- Traffic to or from {others}: at most {share}{' each' * (rest > 1)}."


def _basis_lines(plan: Plan) -> Iterator[str]:
    """Yield the sources and the limits of the model behind the plan."""
    table = plan.protocol
    if table.captured is not None:
        endpoints = max(group.endpoints for group in plan.fleet.groups)
        sizes = (plan.fleet.hosts(), plan.fleet.processes(), endpoints)
        beyond = any(size > limit for size, limit in zip(sizes, table.captured, strict=True))
        nouns = {"hosts": ("host",), "processes": ("process", "es"), "endpoints": ("endpoint",)}
        pairs = zip(nouns.items(), table.captured, strict=True)
        limits = {name: wording.count_noun(limit, *noun) for (name, noun), limit in pairs}
        captured = fill("captured", name=phrase(table.name), **limits)
        yield f"{captured} {fill('beyond captures')}" if beyond else captured
        if plan.band is not None:
            yield plan.band.sentence()
        matched = Unit("matched endpoint").count(plan.fleet)
        share = wording.percent(matched / (ENDPOINT.count(plan.fleet) or 1))
        yield f"In this fleet, {share} of the endpoints have a match in every other process."
    if table.repeats:
        of_paper = {*DDS.messages, *ZENOH.messages}
        if names := [message.name for message in table.messages if message in of_paper]:
            yield fill("as the paper", names=wording.join_words(names))
        if math.isfinite(plan.window):
            yield fill("whole burst", window=_first_seconds(plan.window))
    timed = [r.before for r in plan.remedies if r.wifi != plan.wifi]
    before = next((value for value in timed if value != plan.utilization), None)
    if before is not None and not plan.utilization_range.differs:
        needs = wording.airtime_text(before, plan.window).replace("of the time", "of the airtime")
        yield fill("standard timing", airtime=needs + " of airtime" * math.isfinite(plan.window))


def _first_seconds(window: float) -> str:
    """Name the time in which the airtime of a startup is counted."""
    return "the first second" if window == PAPER_WINDOW else f"the first {window:g} s"


def _at_least(number: AggregationRange) -> str:
    """Return "at least " if a number depends on the aggregation, else an empty string."""
    return "at least " * number.differs


def _percent_range(number: AggregationRange) -> str:
    return _at_least(number) + wording.percent(number.bounds[0])


def _time_range(number: AggregationRange, window: float = 1.0) -> str:
    low = number.bounds[0] * window
    return _at_least(number) + wording.time_range(low, low)


def configuration_table(configurations: tuple[ConfigurationLoad, ...], width: int) -> list[str]:
    """Return one line per configuration: a table row, or a sentence if rows would be too wide."""
    differs = any(row.startup.differs for row in configurations)
    title = ("", "drain time" + ", at least" * differs, "steady state")
    rows = [
        (
            row.name,
            wording.time_range(row.startup.bounds[0], row.startup.bounds[0], never="never done"),
            wording.percent(row.steady_range.bounds[0]),
        )
        for row in sorted(configurations, key=lambda row: row.startup.bounds)
    ]
    widths = [max(map(len, column)) for column in zip(title, *rows, strict=True)]
    if sum(widths) + 6 > width:
        sentences = (f"- {n}: {title[1]} {time}, {title[2]} {share}" for n, time, share in rows)
        return [wording.wrap(sentence, width) for sentence in sentences]
    return [
        f"  {name:<{widths[0]}}  {time:>{widths[1]}}  {share:>{widths[2]}}"
        for name, time, share in (title, *rows)
    ]
