"""Write the model of the calculator, book/_static/calculator/model.js, from the package.

Every formula is an expression of the package, printed by sympy as JavaScript, once however many
messages share it; what the formulas are fed with (sizes, schedules, channels, robots, ranges) is
written beside them as data.
"""

import inspect
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

import sympy as sp
from javascript import Formulas, Value, said_once, written

import discostorm as ds
from discostorm import _checks, figures, notation as nt, timeline, words
from discostorm.data import read_data
from discostorm.fleet import LEAST, SWARM, Fleet, HostGroup, symbolic_group
from discostorm.messages import PAPER_WINDOW, Family, Message, Protocol, Unit
from discostorm.planner import spans
from discostorm.planner.changes import Change, Setting
from discostorm.planner.known import known, row_of, software
from discostorm.planner.plan import changes_of
from discostorm.planner.snippets import snippets
from discostorm.protocols import BASES
from discostorm.robots import (
    endpoints_of_a_node,
    laptop,
    parameter_service_endpoints,
    robots,
    shared_endpoints,
)
from discostorm.saturation import solve_hosts
from discostorm.wifi import Cast, Model, Wifi, bits_airtime, downlink_airtime, uplink_airtime
from discostorm.wifi.radio import TOPOLOGY, both_ends

TARGET = Path(__file__).parents[1] / "book" / "_static" / "calculator" / "model.js"

#: Another version of sympy may order the same sums otherwise.
HEAD = "// Made from the package by `make calculator` with sympy {}; do not edit.\n"

#: What one can choose: one entry a radio, whether its frames share exchanges or not.
CHANNELS = (ds.PAPER, *ds.WIFI.values())

#: Where the calculator starts, with how many of which robots.
START_HOSTS, START_ROBOT = 5, "Nav2 in one process"
START_MIDDLEWARE = "Fast DDS"
#: How often the page simulates a fleet.
RUNS = 10

#: Like hosts beside a group of others, of which there may be none.
BESIDE = symbolic_group(1)
#: Endpoints of each process that match everywhere, of each of the two groups.
SHARED = sp.symbols("N_S N_S1", nonnegative=True)
#: No endpoint matches one elsewhere, so many of each process do, or all.
GROUPS_SHARED = tuple(
    replace(group, shared=shared)
    for group, shared in zip((*SWARM.groups, BESIDE), SHARED, strict=True)
)
FLEETS = (
    Fleet((*SWARM.groups, BESIDE)),
    Fleet(GROUPS_SHARED),
    Fleet((*SWARM.groups, BESIDE), matching=1.0),
)

#: The first table of each product as built; the others are variants of one.
FIRST = {
    table.product: table.name
    for table in reversed(tuple(ds.PROTOCOLS.values()))
    if table.basis == "measured"
}.values()

#: Length of a frame [B].
LENGTH = sp.Symbol("L", positive=True)

#: What products' tables were fitted to.
ABOUT = {
    row["protocol"]: f"{row['what']} (measured with {row['versions']})"
    for table in ("products", "arrangements")
    for row in read_data(f"vendors/{table}.csv")
} | {
    "hybrid": "this book's proposal, for hosts with unlike software",
    "hybrid, alike": "this book's proposal, for hosts that are alike",
}

#: Further hosts than the first.
MORE = sp.Symbol("x", positive=True)
#: What the powers of these are multiplied with [1]; of higher ones there is no closed form.
COEFFICIENTS = sp.symbols("c b a", positive=True)

#: The largest whole number of hosts below saturation.
N_SAT = sp.Symbol("N_sat", positive=True)
LARGEST = sp.ceiling(N_SAT) - 1

#: Hosts that have something to compose and to leave out: every change of hosts applies to them.
ANY = Fleet.swarm(2, 2, parameter_service_endpoints())


def changes(protocol: Protocol, wifi: Wifi) -> list[Change]:
    """Return what the planner would change, but for what nobody can have yet."""
    return [
        change
        for change in changes_of(Setting(ANY, protocol, wifi))
        if not isinstance(change, str)
        and all(
            known(kind, change.table or protocol)["effort"] != "research" for kind in change.steps
        )
    ]


def way(change: Change) -> str:
    """Return the name of what is to be done for a change: its kind, or several kinds."""
    return " and ".join(change.steps)


def channel(wifi: Wifi) -> dict[str, Value]:
    """Return the data of a Wi-Fi channel; of a radio that aggregates also with full A-MPDUs."""
    full, single = both_ends(wifi)
    if full in (single, wifi):
        return one_channel(wifi)
    return one_channel(wifi) | {"full": one_channel(full), "simulated": spans.radio_of(wifi)}


def one_channel(wifi: Wifi) -> dict[str, Value]:
    """Return the data of a channel by itself."""
    return {
        "name": wifi.name,
        "model": wifi.model,
        "values": {symbol.name: value for symbol, value in wifi.values().items()},
    }


def radio_remedies(wifi: Wifi) -> Value:
    """Return what the planner would change of a channel: the channel before and after."""
    base = Setting(ANY, ds.DDS, wifi)
    # Of the paper's channel, which does not aggregate, both sides of a comparison do not.
    told = one_channel if both_ends(wifi)[0] == wifi else channel
    return [
        {
            "kind": change.kind,
            "what": change.what,
            "note": change.note,
            "base": told(base.before([change]).wifi),
            "wifi": told(base.after([change]).wifi),
        }
        for change in changes(ds.DDS, wifi)
        if change.radio is not None
    ]


def table_changes(protocol: Protocol) -> list[Change]:
    """Return the changes of the planner that put another table in its place."""
    return [change for change in changes(protocol, ds.PAPER) if change.table is not None]


def key(protocol: Protocol, change: Change) -> str:
    """Return the name of the table of a change; one that is not of `PROTOCOLS` has none yet."""
    assert change.table is not None
    of_its_own = change.table != ds.PROTOCOLS[change.table.name]
    return f"{protocol.name}, {change.what}" if of_its_own else change.table.name


def tables() -> dict[str, Protocol]:
    """Return each table that the calculator computes with, by name: all, and what changes make."""
    return dict(ds.PROTOCOLS) | {
        name: change.table
        for protocol in ds.PROTOCOLS.values()
        for change in table_changes(protocol)
        if (name := key(protocol, change)) not in ds.PROTOCOLS and change.table
    }


def table_remedies(protocol: Protocol) -> Value:
    """Return which other table the planner would put in its place, and what each is held against.

    Nothing for a table that is such a change itself.
    """
    if protocol not in ds.PROTOCOLS.values():
        return []
    return [
        [
            change.kind,
            change.what,
            change.note,
            key(protocol, change),
            (change.base or protocol).name,
            way(change),
        ]
        for change in table_changes(protocol)
    ]


def field(
    name: str,
    label: str,
    symbol: str,
    start: float,
    allowed: tuple[float, float, bool],
    unit: str = "",
    scale: float = 1,
    whole: bool = False,
) -> Value:
    """Return the data of an input field: what it asks for and which numbers are allowed."""
    low, high, above = allowed
    range_ = _checks.wanted(low, high, above).replace(
        "a finite number", "a whole number" if whole else "a number"
    )
    return {
        "name": name,
        "label": label,
        "symbol": symbol,
        "unit": unit,
        "scale": scale,  # from the unit of the field to SI
        "start": f"{start:.6g}",
        "low": low,
        "high": high,
        "above": above,
        "whole": whole,
        "allowed": range_.replace(f"{_checks.MOST:g}", f"{_checks.MOST:,.0f}"),
    }


def counts(
    prefix: str, titles: Sequence[str], symbols: Iterable[sp.Symbol], start: Sequence[float]
) -> Value:
    """Return the fields of a group of hosts; the ranges are those of the package."""
    return [
        field(
            f"{prefix}{name}",
            title,
            symbol.name,
            first,
            (LEAST[name], _checks.MOST, False),
            whole=name != "endpoints",
        )
        for name, title, symbol, first in zip(LEAST, titles, symbols, start, strict=True)
    ]


def fields() -> Value:
    """Return the data of all input fields."""
    robot = robots()[START_ROBOT]
    links = (
        ("unicast", "unicast", ds.PAPER.unicast, nt.R_UNI, nt.O_UNI),
        ("multicast", "multicast", ds.PAPER.multicast, nt.R_MULTI, nt.O_MULTI),
    )
    own: list[Value] = []
    for name, cast, link, rate, overhead in links:
        own += [
            field(
                f"{name}_rate",
                f"Rate, {cast}",
                rate.name,
                link.rate / 1e6,
                (0, float("inf"), True),
                "Mbit/s",
                1e6,
            ),
            field(
                f"{name}_overhead",
                f"Overhead of a frame, {cast}",
                overhead.name,
                link.overhead * 1e6,
                (0, float("inf"), False),
                "µs",
                1e-6,
            ),
        ]
    return {
        "swarm": counts(
            "",
            ("Robots", "Processes per robot", "Endpoints per process"),
            SWARM.counts(),
            (START_HOSTS, robot.processes, robot.endpoints),
        ),
        "beside": counts(
            "beside_",
            ("Computers", "Processes per computer", "Endpoints per process, computers"),
            BESIDE.counts(),
            laptop().counts(),
        ),
        "own": own,
    }


def ready_made() -> Value:
    """Return the ready-made robots with what the data file says of their parts."""
    rows = read_data("fleets/robots.csv")
    return [
        {
            "name": name,
            "processes": f"{host.processes:.6g}",
            "endpoints": f"{host.endpoints:.6g}",
            "nodes": host.nodes or 0,
            "parts": [
                {
                    "what": row["part"],
                    "processes": int(row["processes"]),
                    "endpoints": int(row["endpoints"]),
                    "kind": row["kind"],
                    "source": row["source"],
                }
                for row in rows
                if row["robot"] == name
            ],
        }
        for name, host in robots().items()
    ]


def group(protocol: Protocol) -> str | None:
    """Return under which heading a table is offered; None if only a change can have it."""
    if protocol not in ds.PROTOCOLS.values():
        return None
    return BASES[protocol.basis or "proposal"]


def row(message: Message, windows: dict[str, float], units: list[Unit]) -> dict[str, Value]:
    """Return what the calculator knows of a message."""
    schedule = message.schedule
    return {
        "name": message.name,
        "cast": message.cast,
        "bytes": message.frame_bytes,
        "frames": message.frames,
        "unit": units.index(message.unit),
        "per_unit": message.per_unit,
        "hops": " ".join(message.hops),
        "sent": {
            "burst": schedule.extra,
            **{name: schedule.mean(window) for name, window in windows.items()},
        },
    }


def airtimes(known: Formulas) -> Value:
    """Return the airtime of a frame of L bytes on each hop, by kind of channel and cast.

    And of L bytes inside the frame of another message, on any channel.
    """
    up, *down = (
        known.name(bits_airtime(LENGTH, cast), f"inside_{cast}")
        for cast in ("unicast", *get_args(Cast))
    )
    return {
        "inside": {"up": up, **dict(zip(get_args(Cast), down, strict=True))},
        **{
            model: {
                "up": known.name(uplink_airtime(LENGTH, model), f"{model}_unicast"),
                **{
                    cast: known.name(downlink_airtime(LENGTH, cast, model), f"{model}_{cast}")
                    for cast in get_args(Cast)
                },
            }
            for model in get_args(Model)
        },
    }


def outlooks(protocol: Protocol) -> Value:
    """Return which word `timeline.outlook` has for a drain time up to a limit [s]."""
    *told, never = timeline.OUTLOOKS
    limits = (PAPER_WINDOW, protocol.lease, sp.oo)
    return {
        "until": [[limit, word] for limit, word in zip(limits, told, strict=True)],
        "never": never,
    }


def coefficients(unit: Unit, fleet: Fleet) -> list[sp.Expr]:
    """Return the powers of N_H - 1 in the number of a unit, that of the constant first."""
    count = sp.sympify(unit.count(fleet)).subs(nt.N_H, 1 + MORE)
    parts = [count.diff(MORE, n).subs(MORE, 0) / sp.factorial(n) for n in range(5)]
    while parts and parts[-1] == 0:
        parts.pop()
    return parts


def saturation(degree: int, known: Formulas) -> str:
    """Return the hosts that fill the channel if utilization is a polynomial of that degree."""
    powers = zip(COEFFICIENTS[: degree + 1], range(degree + 1), strict=True)
    return known.name(
        solve_hosts(sp.Add(*(part * (nt.N_H - 1) ** n for part, n in powers))), "saturation"
    )


def unit_code(unit: Unit, fleet: Fleet, known: Formulas) -> Value:
    """Return how many of a unit a fleet has, and what further hosts add to it."""
    return {
        "count": known.name(sp.sympify(unit.count(fleet)), "count"),
        "more": [known.name(part, "more") for part in coefficients(unit, fleet)],
    }


def about(protocol: Protocol, known: Formulas) -> dict[str, Any]:
    """Return all that the calculator knows of a protocol."""
    windows = {"second": PAPER_WINDOW}
    if protocol.lease < sp.oo:
        windows["lease"] = protocol.lease
    windows["ever"] = sp.oo
    units = list(protocol.units())
    return {
        "group": group(protocol),
        "family": protocol.family,
        "product": software(protocol),
        "tables": table_remedies(protocol),
        "about": ABOUT.get(protocol.name, ""),
        "color": figures.property_of(protocol),
        # The most hosts, processes and endpoints of a process that a product ran with.
        "measured": list(protocol.captured or ()),
        "variant": protocol.basis == "measured" and protocol.name not in FIRST,
        "lease": protocol.lease,
        "repeats": protocol.repeats,
        "outlooks": outlooks(protocol),
        "windows": {**windows},
        "units": [[unit_code(unit, fleet, known) for fleet in FLEETS] for unit in units],
        "degree": max(len(coefficients(unit, fleet)) - 1 for unit in units for fleet in FLEETS),
        "messages": [[*row(message, windows, units).values()] for message in protocol.messages],
    }


def remedies(ways: Iterable[tuple[str, ...]]) -> Value:
    """Return of each way to change something what it takes and what to mind, by family."""
    families = (*get_args(Family), None)
    efforts = {row["effort"]: row for row in read_data("vendors/efforts.csv")}

    def told(steps: tuple[str, ...], family: str | None) -> Value:
        # What a family counts of switching to it is of its peers, not of an arrangement.
        switch = len(steps) > 1
        rows = [row_of(kind, None if switch and kind == "middleware" else family) for kind in steps]
        found = [row for row in rows if row is not None and row["effort"]]
        if len(found) < len(steps):
            return None
        parts = [row["price"] for row in found] + [row["fails"] for row in found if row["fails"]]
        return {
            "effort": max(int(efforts[row["effort"]]["rank"]) for row in found),
            "takes": words.listed(
                list(dict.fromkeys(efforts[row["effort"]]["what"] for row in found))
            ),
            "best_case": any(row["gain"] == "best case" for row in found),
            "mind": "; ".join(dict.fromkeys(parts)),
        }

    return {
        " and ".join(steps): {
            "steps": list(steps),
            "of": {str(family): told(steps, family) for family in families},
        }
        for steps in ways
    }


def pastes(kinds: Iterable[str]) -> Value:
    """Return what to paste for each kind of remedy, by what it is for."""
    return {
        kind: {
            row["for"]: [
                {"where": piece.where, "version": piece.version, "text": piece.text}
                for piece in snippets(kind, row["for"])
                if row["for"] == "any" or piece not in snippets(kind, "")
            ]
            for row in read_data("vendors/snippets.csv")
            if row["kind"] == kind
        }
        for kind in kinds
    }


def simulation() -> Value:
    """Return what the page simulates: so many runs with what `discostorm.simulate` assumes."""
    defaults = inspect.signature(ds.simulate).parameters
    return {"runs": RUNS} | {name: defaults[name].default for name in ("seed", "queue", "until")}


def ready() -> Value:
    """Return what was simulated of ready-made robots, and which hosts are as those."""

    def same_as(host: HostGroup) -> Value:
        return {"N_P": host.processes, "N_E": host.endpoints, "N_S": host.shared}

    found: dict[str, Any] = {}
    for (radio, table, robot, laptops), rows in spans.stored().items():
        found.setdefault(radio, {}).setdefault(table, {}).setdefault(robot, {})[laptops] = rows
    (until,) = {
        row["until_s"] for row in read_data("simulated/ready.csv") if row["recovery"] == "1"
    }
    (runs,) = {row["runs"] for row in read_data("simulated/ready.csv") if row["recovery"] == "1"}
    return {
        "robots": {name: same_as(host) for name, host in robots().items()},
        "laptop": same_as(laptop()),
        "shared": spans.SHARED,
        "whole": spans.WHOLE,
        "until": float(until),
        "runs": int(runs),
        "found": found,
    }


def model() -> Value:
    """Return all that the calculator reads."""
    known = Formulas()
    protocols: dict[str, Any] = {
        name: about(protocol, known) for name, protocol in tables().items()
    }
    degrees = range(1, len(COEFFICIENTS))
    full: list[Value] = [None, *(saturation(degree, known) for degree in degrees)]
    single = [change for table in ds.PROTOCOLS.values() for change in changes(table, ds.PAPER)]
    shown = [change for change in single if change.table or change.radio or change.fleet]
    ways = sorted({change.steps for change in shown})
    drain = known.name(timeline.DRAIN, "drain")
    largest = known.name(LARGEST, "largest")
    return {
        "start": {
            "robot": START_ROBOT,
            "middleware": START_MIDDLEWARE,
        },
        "groups": list(BASES.values()),
        "fields": fields(),
        "robots": ready_made(),
        "channels": [{**channel(wifi), "remedies": radio_remedies(wifi)} for wifi in CHANNELS],
        "ready": ready(),
        "simulation": simulation(),
        "topology": TOPOLOGY,
        "limit": 1.0,
        "times": [list(row) for row in words.TIMES],
        "airtime": airtimes(known),
        "laptop_nodes": laptop().nodes or 0,
        "service_endpoints": parameter_service_endpoints(),
        "endpoints_of_a_node": endpoints_of_a_node(),
        "shared_endpoints": [shared_endpoints(nodes) for nodes in (0, 1)],
        "remedies": remedies(ways),
        "pastes": pastes(sorted({kind for steps in ways for kind in steps})),
        # What calculator.js has a function for: changes of the hosts.
        "fleets": list(dict.fromkeys(change.kind for change in shown if change.fleet)),
        "largest": largest,
        "saturation": full,
        "drain": drain,
        "formulas": known.code(),
        # What the rows of messages hold, in order.
        "columns": list(row(ds.DDS.messages[0], {}, list(ds.DDS.units()))),
        "protocols": protocols,
    }


def javascript() -> str:
    """Return the text of model.js."""
    said, rest = said_once(model())
    lines = [f"const {name} = {written(part)};" for name, part in said.items()]
    body = "\n".join([*lines, f"return {written(rest)};"])
    return f"{HEAD.format(sp.__version__)}const DISCOSTORM = (() => {{\n{body}\n}})();\n"


if __name__ == "__main__":
    TARGET.write_text(javascript(), encoding="utf-8")
