"""Every sentence of a plan: the answer, what dominates, what would help, and how sure that is."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from discostorm import words
from discostorm.messages import ENDPOINT, PAPER_WINDOW, Unit
from discostorm.protocols import DDS, ZENOH
from discostorm.wifi.radio import TOPOLOGY
from discostorm_planner.aggregation_range import Verdict
from discostorm_planner.configurations import Configuration
from discostorm_planner.remedy_rules import NEGLIGIBLE, efforts, is_gerund
from discostorm_planner.stored_simulations import ConvergenceTime
from discostorm_planner.user_data import UserDataLoad

if TYPE_CHECKING:
    from discostorm_planner.remedy import Remedy
    from discostorm_planner.result import Plan

#: Maximum number of groups that are named.
_GROUPS = 5
#: The title of the section that a plan has if anything helps.
BEST_CHANGES = "Best single changes:"
_DATA_FIT: dict[Verdict, str] = {
    "fits": "fit",
    "may fit": "may fit",
    "does not fit": "do not fit",
}


def advice(plan: Plan, width: int) -> str:
    """Return the whole plan in lines of at most ``width`` letters."""
    if plan.all_wired:
        return words.wrapped(words.ALL_WIRED, width)
    alone = plan.fleet.hosts() == 1
    lines = [] if alone else [*_answer(plan), ""]
    if plan.data:
        lines += [*_user_data(plan.data, plan.window), ""]
    lines += [*_cost(plan), "", "Largest parts of this airtime:", *_shares(plan)]
    if alone:  # what saves airtime saves what no robot needs
        return _wrapped([*lines, "", words.ALONE], width)
    sections = plan.sections()
    if BEST_CHANGES not in sections:
        lines += ["", "No change that we tried helps."]
    number = 0
    for title, remedies in sections.items():
        lines += ["", title]
        for remedy in remedies:
            number += 1
            lines.append(f"{number:2}. {words.capitalized(remedy.sentence())}.")
            lines.append(f"    {remedy.caution()}")
    lines += ["", "The same fleet with each measured configuration:"]
    rest = len(plan.remedies) + len(plan.combinations) - number
    basis = ["", "What this rests on:", *(f"- {line}" for line in _basis(plan))]
    basis += [
        "",
        "`discostorm plan --paste N` prints the configuration of change N. `--json` adds "
        f"{words.count_noun(rest, 'change')}, why others are left out, and all configurations.",
    ]
    table = configuration_table(plan.configurations, width)
    return "\n".join([_wrapped(lines, width), *table, _wrapped(basis, width)])


def _wrapped(lines: list[str], width: int) -> str:
    return "\n".join(words.wrapped(line, width) for line in lines)


def _answer(plan: Plan) -> Iterator[str]:
    """Yield the discovery time, or else the drain time, and what these assume."""
    steady, startup = plan.steady_range, plan.startup
    if not words.below_capacity(steady.full) and math.isfinite(plan.window):
        yield (
            f"The periodic traffic alone needs {words.percent(steady.full)} of the channel, so "
            "the fleet never fits, however slowly it starts."
        )
        return
    low, high = startup.ends
    time = words.durations(low, high) if math.isfinite(high) else f"{words.duration(low)} or more"
    busy = f"startup keeps the channel busy for {time} if nothing is lost"
    if math.isinf(low):
        busy = "startup never ends"
    if plan.convergence_time is None:
        yield (
            f"Drain time: {busy}. Until then, some robots do not see each other. Losses make "
            "startup longer."
        )
    else:
        converged = convergence_sentence(plan.convergence_time)
        yield f"{converged} {words.capitalized(busy)} (drain time)."
    if startup.differs:
        simulated = ""
        if startup.simulated is not None:
            simulated = f" The simulation needed {words.duration(startup.simulated)}."
        yield (
            "The shorter time assumes full A-MPDUs, and the longer time one message per frame."
            f"{simulated} A-MPDUs are fuller when more frames wait."
        )
    if not words.below_capacity(steady.single) and math.isfinite(plan.window):
        yield (
            "The fleet may never fit: with one message per frame, its periodic traffic alone "
            f"needs {words.percent(steady.single)} of the channel."
        )


def convergence_sentence(time: ConvergenceTime) -> str:
    """Say when discovery was complete in simulations."""
    limit = words.duration(time.until)
    how = (
        f"quartiles of {time.runs} simulated runs with "
        f"{words.join_words([f'{n:,}' for n in time.hosts])} robots, overflowing queues "
        "and recovery"
    )
    if math.isinf(time.low):
        return f"Your robots do not all know each other within {limit} ({how})."
    if math.isinf(time.high):
        return (
            f"Your robots know each other after {words.duration(time.low)} at the earliest "
            f"({how}; {time.hosts[-1]:,} robots did not within {limit})."
        )
    return f"Your robots know each other after {words.durations(time.low, time.high)} ({how})."


def _user_data(load: UserDataLoad, window: float) -> Iterator[str]:
    """Yield whether the data fit, once discovery is complete and until then."""
    yield (
        f"Your data need {words.percents(*load.data.ends)} of the channel. With the periodic "
        f"traffic of discovery, that is {words.percents(*load.after.ends)}, so your data "
        f"{_DATA_FIT[load.after.verdict]} once discovery is complete."
    )
    if math.isfinite(window):
        low, high = (end * window for end in load.during.ends)
        time = "second" if window == PAPER_WINDOW else words.duration(window)
        yield (
            f"During startup, your data {_DATA_FIT[load.during.verdict]}: discovery and data "
            f"together need {words.durations(low, high)} of airtime in the first {time}."
        )
    if words.below_capacity(load.after.full):
        yield (
            "If robots send all data from the beginning, startup keeps the channel busy for "
            f"{words.durations(*load.startup.ends)} instead of "
            f"{words.durations(*load.alone.ends)}, and no data wait longer. Real robots wait "
            "less, because they send only to robots that they have discovered. `discostorm "
            "simulate` shows when discovery is complete, and how late the data are."
        )
    else:
        yield (
            "The channel never has room for all data beside discovery. Send fewer samples, or "
            "send them to fewer hosts."
        )


def _cost(plan: Plan) -> Iterator[str]:
    """Yield the airtime of discovery and of a reboot, and the channel."""
    ends, steady = plan.utilization_range.ends, math.isinf(plan.window)
    needs = f"{words.percents(*ends)} of the time"
    if not steady:
        low, high = (end * plan.window for end in ends)
        needs = f"{words.durations(low, high)} of airtime"
    yield (
        f"Discovery of {words.count_noun(plan.fleet.hosts(), 'host')} with "
        f"{words.count_noun(plan.fleet.processes(), 'process', 'es')} needs {needs} with "
        f"{plan.protocol.name}."
    )
    fit = {"fits": "so it fits", "may fit": "so it may fit"}.get(plan.verdict, "so it does not fit")
    if steady:
        yield f"That is {_charged(ends, 'of the channel', 'its')} in the steady state, {fit}."
    elif plan.window == PAPER_WINDOW:
        yield f"Charged to one second, that is {_charged(ends, 'of it', 'its')}, {fit}."
    else:
        share = _charged(ends, "of them", "their")
        yield f"Charged to the first {plan.window:g} s, that is {share}, {fit}."
    if plan.reboot is not None:
        robot = f" ({plan.reboot.group})" if len(plan.fleet.groups) > 1 else ""
        yield (
            f"When one robot{robot} reboots, discovery needs "
            f"{words.durations(plan.reboot.low, plan.reboot.high)} of airtime."
        )
    differs = plan.utilization_range.differs
    exchanges = "64 messages to one per A-MPDU" if differs else "one message per frame"
    yield (
        f"Channel: {plan.wifi.name}, {TOPOLOGY}. Assumes: no losses · no collisions · {exchanges}."
    )


def _charged(ends: tuple[float, float], to: str, whose: str) -> str:
    low, high = (words.format_load(end, to, f"{whose} capacity") for end in ends)
    return low if low == high else f"{low} to {high}"


def _shares(plan: Plan) -> Iterator[str]:
    """Yield the largest message, the largest phase and the largest groups."""
    for kind, noun in (("message", "Message type"), ("phase", "Phase")):
        largest = plan.of_kind(kind)[0]
        yield f"- {noun}: {largest.name}, {words.format_share(largest.share)}."
    groups = plan.of_kind("group")
    if len(groups) > 1:
        for group in groups[:_GROUPS]:
            yield f"- Group {group.name}: involved in {words.format_share(group.share)} of it."
    if len(groups) > _GROUPS:
        rest, share = len(groups) - _GROUPS, words.format_share(groups[_GROUPS].share)
        each = "" if rest == 1 else " each"
        yield (
            f"- {words.count_noun(rest, 'further group')}:{each} involved in at most {share} of it."
        )


def _basis(plan: Plan) -> Iterator[str]:
    """Yield how far to trust the answer, and how it was counted."""
    table = plan.protocol
    if plan.convergence_time is None:
        yield (
            "Overflowing queues can make startup many times longer. `discostorm simulate` "
            "shows by how much."
        )
    if table.captured is not None:
        endpoints = max(group.endpoints for group in plan.fleet.groups)
        sizes = (plan.fleet.hosts(), plan.fleet.processes(), endpoints)
        beyond = any(size > limit for size, limit in zip(sizes, table.captured, strict=True))
        extrapolated = " This fleet is extrapolated." if beyond else ""
        yield (
            f"The measured model of {table.name} comes from captures of up to "
            f"{words.count_noun(table.captured[0], 'host')} and "
            f"{words.count_noun(table.captured[1], 'process', 'es')} with up "
            f"to {words.count_noun(table.captured[2], 'endpoint')} each, which started together."
            f"{extrapolated}"
        )
        if plan.band is not None:
            yield plan.band.sentence()
        matched = Unit("matched endpoint").count(plan.fleet)
        share = words.percent(matched / (ENDPOINT.count(plan.fleet) or 1))
        yield f"In this fleet, {share} of the endpoints match in every process."
    if table.repeats:
        of_paper = {*DDS.messages, *ZENOH.messages}
        names = [message.name for message in table.messages if message in of_paper]
        if names:
            yield (
                f"{table.name} counts {words.join_words(names)} as the paper does. It "
                "leaves out the messages that the product packs together or adds."
            )
        if math.isfinite(plan.window):
            yield (
                "The whole burst is charged to this time, and periodic traffic at its rate. "
                "The result is an upper bound of the count."
            )
    timed = [r.before for r in plan.remedies if r.wifi != plan.wifi]
    before = next((value for value in timed if value != plan.utilization), None)
    if before is not None and not plan.utilization_range.differs:
        yield (
            "Changes of the radio are compared by standard timing, with which this fleet needs "
            f"{words.airtime(before, plan.window)} today."
        )


def configuration_table(configurations: tuple[Configuration, ...], width: int) -> list[str]:
    """Return a row per configuration, or a sentence where the rows would be too wide."""
    title = ("", "startup", "steady state")
    rows = [
        (
            row.name,
            words.durations(*row.startup.ends, never="never done"),
            words.percents(*row.steady_range.ends),
        )
        for row in configurations
    ]
    widths = [max(map(len, column)) for column in zip(title, *rows, strict=True)]
    if sum(widths) + 6 > width:
        sentences = (f"- {n}: {title[1]} {time}, {title[2]} {share}" for n, time, share in rows)
        return [words.wrapped(sentence, width) for sentence in sentences]
    return [
        f"  {name:<{widths[0]}}  {time:>{widths[1]}}  {share:>{widths[2]}}"
        for name, time, share in (title, *rows)
    ]


def remedy_sentence(remedy: Remedy) -> str:
    """Say what a remedy saves, whether the fleet fits then, and what is compared."""
    fits = ""
    if remedy.now_fits:
        sure = not (remedy.best_case or remedy.wifi.aggregation is not None)
        fits = ", which fits" if sure else ", which would fit"
    elif remedy.may_now_fit:
        fits = ", which may fit"
    return words.sentences(f"{remedy.what} {remedy_gain(remedy)}{fits}", remedy.note)


def remedy_gain(remedy: Remedy) -> str:
    """Say what a remedy saves, in words that follow its name."""
    before, after = (
        words.airtime(value, remedy.window) for value in (remedy.before, remedy.utilization)
    )
    article = remedy.what.split()[0] in ("a", "an", "another", "the") or is_gerund(remedy.what)
    s = "s" if article and remedy.kind != "combination" else ""
    if remedy.kind == "staggered start":
        window = words.duration(remedy.start_window)
        return f"spreads the same {before} of airtime over at least {window}"
    if remedy.utilization and not remedy.before:
        return f"add{s} {after}; nothing was sent before"
    if abs(remedy.saved) < NEGLIGIBLE:
        return f"change{s} less than {NEGLIGIBLE:.1%}"
    if remedy.saved < 0:
        return f"add{s} {words.percent(-remedy.saved)}: {before} becomes {after}"
    # A rest too small for floating point is not nothing.
    limit = math.nextafter(1, 0) if remedy.utilization else 1.0
    gain = f"cut{s} {before} to {after} ({words.percent(min(remedy.saved, limit))})"
    if remedy.basis:
        gain += ", simulated" if remedy.basis == "simulated" else f", with {remedy.basis}"
    return f"{gain} at best" if remedy.best_case else gain


def remedy_caution(remedy: Remedy) -> str:
    """Say the effort of a remedy, its trade-offs and what fails when."""
    needed = list(dict.fromkeys(efforts()[name]["what"] for name in remedy.efforts))
    trade_offs = "; ".join(filter(None, (remedy.trade_offs, remedy.failure_mode)))
    rest = ""
    if not words.below_capacity(remedy.steady):
        rest = (
            f" Periodic traffic still needs {words.percent(remedy.steady)} of the channel, so "
            "the fleet never fits."
        )
    elif remedy.kind == "combination" and remedy.verdict == "does not fit":
        rest = f" Spread the starts over {words.duration(remedy.start_window)}."
    return f"Effort: {words.join_words(needed)}. Trade-offs: {trade_offs}.{rest}"
