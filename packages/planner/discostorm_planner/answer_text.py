"""Write the answer of a plan: the verdict, the first steps, and how sure they are."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable, Iterator, Sequence
from statistics import median
from typing import TYPE_CHECKING

from discostorm import wording
from discostorm.data import data_path
from discostorm.wifi import PAPER
from discostorm_planner import remedy_rules
from discostorm_planner.change_simulation import CAUTION_LOSS, SOFTWARE_EFFORTS, SimulatedChange
from discostorm_planner.discovery_time import MIN_PAIRS, RUNS, DiscoveryTime
from discostorm_planner.fleet_changes import hosts_in_words
from discostorm_planner.simulation_jobs import MOST_PAIRS_SHARE, WITHIN_S

if TYPE_CHECKING:
    from discostorm.fleet import HostGroup
    from discostorm_planner.remedy import Remedy
    from discostorm_planner.result import Plan

#: Maximum numbers of lines, of changes and of groups in an answer of the usual width.
_USUAL_WIDTH = 79
_MAX_LINES, MAX_SHOWN_CHANGES, _MAX_GROUPS = 24, 3, 3
#: Sentences by key; braces mark the values that a sentence needs.
SENTENCES: dict[str, str] = tomllib.loads(
    data_path("written/sentences.toml", "discostorm_planner").read_text(encoding="utf-8")
)


def fill(key: str, **values: object) -> str:
    """Return the sentence with this key, with its values filled in."""
    return SENTENCES[key].format(**values)


def phrase(name: str) -> str:
    """Return the name of a protocol or channel as it reads within a sentence."""
    release = " ".join(name.split()[:3]) if name.split()[3:4] == ["Discovery"] else "Fast DDS"
    return SENTENCES.get(name.replace(release, "Fast DDS"), name).replace("Fast DDS", release)


def format_answer(plan: Plan, width: int, *, all_changes: bool = False) -> str:
    """Return the answer in lines of at most ``width`` letters."""
    if plan.all_wired or plan.fleet.hosts() == 1:
        note = wording.ALL_WIRED_NOTE if plan.all_wired else wording.LONE_HOST_NOTE
        return wording.wrap(note, width)
    text = ""
    for count in range(MAX_SHOWN_CHANGES, -1, -1):
        blocks = [_verdict_lines(plan), [*_cell_lines(plan)]]
        blocks += _change_blocks(plan, count, all_changes)
        blocks += [_reboot_lines(plan), _certainty_lines(plan, all_changes)]
        text = _join_blocks(blocks, width)
        if all_changes or len(_join_blocks(blocks, _USUAL_WIDTH).splitlines()) <= _MAX_LINES:
            break
    return text


def _join_blocks(blocks: Iterable[list[str]], width: int) -> str:
    """Join wrapped blocks with an empty line between them."""
    wrapped = ([wording.wrap(line, width) for line in block] for block in blocks if block)
    return "\n\n".join(map("\n".join, wrapped))


def _cell_lines(plan: Plan) -> Iterator[str]:
    """Yield the airtime of each cell, if there are several."""
    for cell, share in plan.cells:
        airtime = "at least " * share.differs + wording.duration(share.bounds[0])
        yield "- " + fill("cell", cell=cell, airtime=airtime)


def _reboot_lines(plan: Plan) -> list[str]:
    """Return when the others have rediscovered a rebooted robot, and how many leases expire."""
    late = plan.late_join
    if late is None or math.isinf(late.median):
        return [fill("not known again")] * (late is not None)
    kept = fill("not kept" if late.expired_lease_runs else "kept", **_lease_counts(late))
    return [fill("reboot", time=_time_text(late.median), kept=kept)]


def verdict(plan: Plan) -> str:
    """Return whether the startup works, in a sentence."""
    return _verdict_lines(plan)[0]


def _verdict_lines(plan: Plan) -> list[str]:
    """Return whether the startup works, how long discovery takes, and what stops it."""
    found, today = plan.discovery, plan.discovery.today
    low = plan.startup.bounds[0]
    values = {
        "fleet": describe_fleet(plan),
        "how": f"{phrase(plan.protocol.name)}, on {phrase(plan.wifi.name)}",
        "within": _time_text(plan.within),
        "drain": _time_text(low),
        "protocol": phrase(plan.protocol.name),
    }
    if today is None:
        key = "endless" if math.isinf(low) else "too busy" if low > plan.within else "unknown"
        return [fill(key, **values), fill("not simulated", reason=found.reason or "interrupted")]
    values |= {
        "until": _time_text(today.simulated_seconds),
        "median": _time_text(today.median),
        "nine": _time_beyond(today.nine_of_ten, plan.within),
        "most": _most_runs(len(today.times)),
        "lost": format_share(today.lost),
        "runs": str(len(today.times)),
        "late": str(sum(map(math.isinf, today.times))),
        "forgetful": str(today.expired_lease_runs),
    }
    if today.is_lower_bound and math.isfinite(today.median):
        slow = today.median > plan.within
        lines = [fill("unrepaired and slow" if slow else "unrepaired", **values)]
        lines.append(fill("busy", **values))
    elif math.isinf(today.median):
        share = format_share(median(today.pairs_done or (0.0,)))
        key = "never in time" if plan.within < today.simulated_seconds else "never"
        lines = [fill("seldom" if math.isfinite(today.times[0]) else key, **values)]
        if today.pairs_done:
            lines.append(fill("share of pairs", share=share, **values))
    else:
        key = "too slow" if today.nine_of_ten > plan.within else "forgotten"
        if found.works:
            unsure = "works in simulations" if found.caution else "probably"
            key = "works" if found.surely_works else unsure
        lines = [fill(key, caution=found.caution, slower=_slower_in_reality(plan, today), **values)]
        key = "times" if len(today.times) > 1 else "time of one"
        times = fill("times of some" if math.isinf(today.nine_of_ten) else key, **values)
        if math.isfinite(today.most_pairs_s):
            share, time = wording.percent(MOST_PAIRS_SHARE), _time_text(today.most_pairs_s)
            times += " " + fill("most pairs", share=share, time=time)
        lines.append(times)
    loses_much = today.repaired and today.lost > CAUTION_LOSS
    if not found.works and (loses_much or math.isinf(today.nine_of_ten)):
        causes = today.slowdown_causes(plan.steady_range.full)
        lines.append(" ".join(fill(cause, **values) for cause in causes))
    if plan.data:
        airtime = wording.duration(plan.data.with_periodic.bounds[0])
        lines.append(fill(f"data {plan.data.with_periodic.verdict}", airtime=airtime))
        startup = plan.data.with_discovery
        if plan.data.with_periodic.verdict != "does not fit" == startup.verdict:
            lines.append(fill("data late", airtime=wording.duration(startup.bounds[0])))
    return [line for line in lines if line]


def _change_blocks(plan: Plan, count: int, all_changes: bool) -> Iterator[list[str]]:
    """Yield blocks for the first step and the next; with ``all_changes``, one for the rest."""
    found, shortest, count = plan.discovery, not count, max(count, 1)
    if found.today is None and not found.helpful:
        rows = [remedy for section in plan.sections().values() for remedy in section]
        gains = [f"- {wording.capitalized(r.what)} {r.gain_clause()}." for r in rows[:count]]
        none = "none known"
        if math.isinf(plan.startup.bounds[0]):
            # An endless startup has no airtime to compare with.
            none, ending = "none ends", [r for r in plan.remedies if math.isfinite(r.start_window)]
            gains = [
                fill("drain", what=wording.capitalized(r.what), after=_time_text(r.start_window))
                for r in ending[:count]
            ]
        yield [fill("closed form"), *gains] if gains else [fill(none)]
        return
    listed = list(found.helpful)
    enough = bool(found.sufficient)
    unsure = found.works or any(c.time and c.time.works(plan.within) for c in listed)
    within = _time_text(plan.within)
    shorter = fill("not sure either" if unsure else "shorter", within=within)
    best = list(found.sufficient) if enough and not found.surely_works else listed
    shown = best if all_changes else list(_first_of_each_kind(best))[:count]
    near = [c for c in listed if c.time and median(c.time.pairs_done or (1.0,)) >= MIN_PAIRS]
    overloaded = plan.data is not None and plan.data.with_periodic.verdict == "does not fit"
    fewer = "" if overloaded else _hosts_in_time_text(plan)
    if fewer and not enough:
        yield [fill("stopgap", fewer=fewer)]
    if not listed:
        tried = sum(bool(c.time and c.remedy.all_discover) for c in found.changes)
        yield [fill("none helps", count=tried) if tried else fill("none known")]
    elif overloaded and found.surely_works and not all_changes:
        return  # a faster discovery makes no room for data
    elif found.surely_works or not enough:
        title = fill("faster") if found.surely_works else shorter
        nearest = sorted(near, key=lambda change: change.sort_key(plan.within)[-1])[:1]
        named = [change for change in shown if all_changes or change in near] or nearest
        until = _time_text(max(plan.within, WITHIN_S))
        yield [title, *_change_lines(plan, named, 1)] if named else [fill("none near", until=until)]
    else:
        first = len(shown) if found.works else 1
        title = "covered" if found.works else "changes" if overloaded else "first"
        yield [fill(title), *_change_lines(plan, shown[:first], 1)]
        if fewer:
            yield [fill("until then", fewer=fewer)]
        easy = [c for c in listed if SOFTWARE_EFFORTS.isdisjoint(c.remedy.efforts)]
        no_need = all_changes or found.works or shown[0] in easy or shortest
        easier = [] if no_need else [change for change in easy if change in near][:1]
        if easier:
            works = any(c.time and c.time.works(plan.within) for c in easier)
            title = fill("easier, perhaps" if works else "easier", within=within)
            yield [title, *_change_lines(plan, easier, first + 1)]
        if shown[first:]:
            yield [fill("then"), *_change_lines(plan, shown[first:], first + len(easier) + 1)]
        if more := [change for change in listed if all_changes and change not in best]:
            yield [fill("shorter", within=within), *_change_lines(plan, more, len(best) + 1)]
    possible = () if found.surely_works or enough or all_changes else found.possibly_sufficient[:1]
    for change in possible:
        yield [fill("possible", names=_change_with_time(change))]
    if all_changes:
        rest = [c for c in found.changes if c not in listed]
        timed: dict[str, list[str]] = {}
        for change in rest:
            if change.time:
                key = "bounds" if change.time.is_lower_bound else "others"
                key = key if change.remedy.all_discover else "parts"
                timed.setdefault(key, []).append(_change_with_time(change))
        yield [fill(key, names="; ".join(names)) for key, names in timed.items()] + [
            fill("domains") for change in rest if change.time and change.remedy.kind == "domains"
        ]
        reasons = dict.fromkeys(change.reason for change in rest if change.reason)
        yield [
            fill("left out", reason=reason, names="; ".join(names))
            for reason in reasons
            if (names := [c.remedy.what for c in rest if c.reason == reason])
        ]


def _hosts_in_time_text(plan: Plan) -> str:
    """Return the sentence on how many hosts of a group meet the target; "" if unknown."""
    if plan.discovery.hosts_in_time is None:
        return ""
    (name, count, time), groups = plan.discovery.hosts_in_time, _groups_in_discovery(plan)
    hosts = max(group.hosts for group in groups if group.name == name)
    others = [hosts_in_words(g.hosts, g.name or "other host") for g in groups]
    del others[[g.name for g in groups].index(name)]
    beside = f", plus {wording.join_words(others)}," * bool(others)
    values = {"count": count, "group": hosts_in_words(hosts, name or "hosts")}
    total = wording.count_noun(sum(g.hosts for g in groups) - hosts + count, "host")
    return fill("fewer", beside=beside, total=total, time=describe_time(time), **values)


def _first_of_each_kind(changes: Iterable[SimulatedChange]) -> Iterator[SimulatedChange]:
    """Yield the first discovery server, the first router, and the first of each other kind."""
    seen = set()
    for change in changes:
        kind = change.remedy.kind
        kind = next((like for like in ("discovery server", "router") if like in kind), kind)
        if kind not in seen or kind == "combination":
            seen.add(kind)
            yield change


def _change_lines(plan: Plan, changes: Iterable[SimulatedChange], first: int) -> Iterator[str]:
    """Yield a paragraph for each change: what, before and after, effort, cost, configuration."""
    today = plan.discovery.today
    for number, change in enumerate(changes, first):
        remedy, time = change.remedy, change.time
        ends = today and math.isinf(today.median) and time and math.isfinite(time.median)
        line = fill(
            "change",
            number=number,
            what=wording.capitalized(describe_change(change)),
            before="never" if ends else describe_time(today),
            after=time_after(change),
            effort=remedy_rules.describe_efforts(remedy.efforts),
            cost=_main_trade_offs(remedy, number == 1),
        )
        name = f"'{change.name}'" if " " in change.name else change.name
        line += fill("paste", name=name) * bool(remedy.snippets)
        said = change.is_cautious and change.caution == plan.discovery.caution
        if time and time.works(plan.within) and not (said or change.suffices(plan.within)):
            slow = _time_text(change.slowest * time.nine_of_ten_unexpired)
            key = "doubtful" if change.is_cautious else "perhaps"
            line += fill(key, caution=change.caution, slow=slow)
        yield line


def _main_trade_offs(remedy: Remedy, is_first: bool) -> str:
    """Return the first trade-off with the failure mode; without one, the first change has two."""
    trade_offs, failure = remedy.trade_offs.split("; "), remedy.failure_mode
    shown = [trade_offs[0], failure] if failure else trade_offs[: 1 + is_first]
    return f"Trade-off{'s' * (len(shown) > 1)}: {'; '.join(shown)}"


def _slower_in_reality(plan: Plan, today: DiscoveryTime) -> str:
    """Return by which factor reality may be slower, and the discovery time with this factor."""
    ratios, times = remedy_rules.time_ratios(plan.protocol), plan.discovery.slowest
    key = "slower" if ratios["measured"] else "slower elsewhere"
    slow = _time_text(times * today.nine_of_ten_unexpired)
    return fill(key, times=f"{times:.2g}", slow=slow, **ratios)


def describe_change(change: SimulatedChange) -> str:
    """Describe a change, or its smallest sufficient variant."""
    what = (change.smallest or change).remedy.what
    window = f", at random times within {_time_text(change.start_window)}"
    return what + window * bool(change.start_window)


def time_after(change: SimulatedChange) -> str:
    """Describe the discovery time after a change, with the number of runs where leases expire."""
    time = change.time
    assert time is not None
    words = describe_time(time)
    if change.remedy.kind == "domains" and math.isfinite(time.median):
        words = f"{words} or longer"
    if time.expired_lease_runs:
        words = fill("leases", time=words, **_lease_counts(time))
    if change.smallest is None:
        return words
    return fill("enough", time=describe_time(change.smallest.time), least=words)


def _most_runs(runs: int) -> str:
    """Name the runs that `DiscoveryTime.nine_of_ten` counts: all, if there are fewer than ten."""
    return "nine of ten runs" if runs >= RUNS else "both runs" if runs == 2 else f"all {runs} runs"


def _lease_counts(time: DiscoveryTime) -> dict[str, int]:
    return {"forgetful": time.expired_lease_runs, "runs": len(time.times)}


def _change_with_time(change: SimulatedChange) -> str:
    return f"{describe_change(change)}, {time_after(change)}"


def compare_protocols(plans: Sequence[Plan]) -> tuple[list[dict[str, str]], list[str]]:
    """Return one table row per protocol, and notes below the table."""
    rows, more = [], []
    for plan in plans:
        found, today = plan.discovery, plan.discovery.today
        median, nine, notes = "", "", [fill("not simulated", reason=found.reason)]
        if today is not None:
            lost = format_share(today.lost)
            notes = [_done_text(today)] if math.isinf(today.median) else []
            notes += [fill("some leases", **_lease_counts(today))] * bool(today.expired_lease_runs)
            notes += [fill("lost", lost=lost)] * today.is_lower_bound
            median = "at least " * today.is_lower_bound + _time_text(today.median)
            nine = "" if today.is_lower_bound else _time_text(today.nine_of_ten)
        unsure = "probably" if found.works and not found.caution else "not sure"
        works = ("yes" if found.works else "no") if found.is_sure else unsure
        notes += [_slower_in_reality(plan, today)] if today and works == "probably" else []
        row = {"protocol": plan.protocol.name, "discovery_time": median, "nine_of_ten": nine}
        rows.append(row | {"works": works})
        more += [f"- {plan.protocol.name}: {'; '.join(notes)}."] * bool(notes)
    runs, _ = _describe_runs([plan.discovery.today for plan in plans])
    within = _time_text(plans[0].within)
    lines = [fill("compared", runs=runs, within=within)]
    for caution in filter(None, dict.fromkeys(plan.discovery.caution for plan in plans)):
        names = [plan.protocol.name for plan in plans if plan.discovery.caution == caution]
        lines.append(fill("cautious", names=wording.join_words(names), caution=caution))
    return rows, [*more, " ".join(lines)]


def _done_text(time: DiscoveryTime) -> str:
    """Describe the share of completed pairs in the worst and in the best run."""
    low, high = format_share(time.pairs_done[0]), format_share(time.pairs_done[-1])
    span = f"at most {high}" if low.startswith("less") else f"{low} to {high}"
    return f"{low if low == high else span} of pairs complete"


def _describe_runs(times: Iterable[DiscoveryTime | None]) -> tuple[str, str]:
    """Describe the number of runs, and the meaning of the median's interval."""
    counts = sorted({len(time.times) for time in times if time}, reverse=True) or [RUNS]
    intervals = [
        fill("most runs" if runs >= RUNS else "all runs" if runs > 2 else "both runs", runs=runs)
        for runs in counts
        if runs > 1
    ]
    few = ", ".join(fill("long runs" if n > 1 else "hopeless run", runs=n) for n in counts[1:])
    ranges = intervals[:1] + ["with fewer runs, all of them"] * (len(intervals) > 1)
    return wording.count_noun(counts[0], "run") + f" ({few})" * bool(few), " or, ".join(ranges)


def _certainty_lines(plan: Plan, all_changes: bool) -> list[str]:
    """Return how the times were simulated, what they assume, and what would confirm them."""
    found, today, table = plan.discovery, plan.discovery.today, plan.protocol
    times = [t for t in (today, *(c.time for c in found.changes)) if t]
    lines = []
    if times:
        runs, interval = _describe_runs(times)
        until = _time_text(times[0].simulated_seconds)
        assumed = fill("assumed of cells" if plan.cells else "assumed")
        ranges = [fill("ranges", interval=interval)] * bool(interval)
        sure = [fill("sure", runs=runs, until=until), *ranges, assumed]
        if any(math.isinf(time.median) for time in times if all_changes or time is today):
            sure.append(fill("never means", until=until))
        if table.captured and plan.fleet.hosts() > table.captured[0]:
            hosts = wording.count_noun(table.captured[0], "host")
            sure.append(fill("extrapolated", protocol=phrase(table.name), hosts=hosts))
        ratios = remedy_rules.time_ratios(table)
        known = today is not None and math.isfinite(today.median)
        measured = [("not compared", ratios)] * known
        listed = found.helpful if all_changes or not found.sufficient else found.sufficient
        if any(remedy_rules.uses_server_of(c.remedy.protocol, table) for c in listed):
            own = remedy_rules.time_ratios(table, with_server=True)
            measured.append(("server not compared", own))
        named = [(key, row | {"measured": phrase(row["measured"])}) for key, row in measured]
        sure += {fill("air" if row["measured"] else key, **row): 0 for key, row in named}
        if known and today and 0 < float(ratios["seconds"]) < today.median:
            sure.append(fill("watched", seconds=ratios["seconds"]))
        lines.append(" ".join(sure))
    if plan.fleet.domain is not None:
        lines.append(fill("domain", domain=f"{plan.fleet.domain:g}"))
    of_paper = " messages" * (table.basis == "paper") + " channel" * (plan.wifi == PAPER)
    lines += [fill(f"of paper:{of_paper}")] if of_paper else []
    kinds = {row["kind"] for row in remedy_rules.configuration_rules() if row["table"] == table.key}
    lines += [fill("server")] * bool(kinds & {"discovery server", "router", "star of routers"})
    for name, mean, whole in found.rounded[:_MAX_GROUPS]:
        if (shown := f"{mean:.1f}") != (simulated := f"{whole:.1f}"):
            lines.append(fill("rounded", name=name, mean=shown, whole=simulated))
    lines += [fill("interrupted")] * (not found.complete)
    return [" ".join([*lines, fill("surer")])]


def _groups_in_discovery(plan: Plan) -> list[HostGroup]:
    """Return the groups that take part in discovery: all except wired hosts without endpoints."""
    return [group for group in plan.fleet.groups if group.endpoints or not group.wired]


def describe_fleet(plan: Plan) -> str:
    """Name the hosts of a fleet, by group if they have names."""
    groups = _groups_in_discovery(plan)
    if len(groups) > _MAX_GROUPS or not all(group.name for group in groups):
        return wording.count_noun(sum(group.hosts for group in groups), "host")
    return wording.join_words([hosts_in_words(group.hosts, group.name) for group in groups])


def describe_time(time: DiscoveryTime | None) -> str:
    """Describe a discovery time with its interval, or the completed pairs if it never ends."""
    if time is None:
        return "not simulated"
    if math.isinf(time.median):
        return f"never ({_done_text(time)})"
    text = _time_text(time.median)
    low, high = (_time_text(end) for end in time.median_interval)
    if low != high:
        late = math.isinf(time.median_interval[1])
        number, unit = low.split(" ", 1)
        least = number if high.endswith(f" {unit}") else low
        text += f" ({low} or more)" if late else f" ({least} to {high})"
    if time.is_lower_bound:
        return f"{text} or longer, with {format_share(time.lost)} of the messages lost"
    return text if time.repaired else f"{text}, with nothing lost"


def _time_text(time: float) -> str:
    """Format a time with two digits, or an integer number of seconds exactly."""
    if 0 < time < 0.1:
        return f"{float(f'{1000 * time:.2g}'):g} ms"
    if 0.1 <= time < 100:
        return f"{time:g} s" if time == round(time) else f"{float(f'{time:.2g}'):g} s"
    return "never" if math.isinf(time) else wording.duration(time)


def _time_beyond(time: float, within: float) -> str:
    """Format a time with enough digits to show that it exceeds a target."""
    words = _time_text(time)
    return f"{time:.3g} s" if words == _time_text(within) and time > within else words


def format_share(share: float) -> str:
    """Format a share in percent; never as 0% or 100% if it is neither."""
    if 0.995 <= share < 1:
        return "more than 99%"
    return "less than 1%" if 0 < share < 0.01 else wording.percent(share)
