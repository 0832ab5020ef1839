"""Write the model of the calculator, book/_static/calculator/model.js, from the package.

Every formula is an expression of the package, printed by sympy as JavaScript, once however many
messages share it; what the formulas are fed with (sizes, schedules, channels, robots, ranges) is
written beside them as data.
"""

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

import sympy as sp

import discostorm as ds
from discostorm import (
    _checks,
    figures,
    measured,
    notation as nt,
    timeline,
    words,
)
from discostorm._numeric import share
from discostorm.data import read_data
from discostorm.fleet import LEAST, SWARM, Fleet, symbolic_group
from discostorm.messages import PAPER_WINDOW, Message, Protocol, Unit
from discostorm.planner.changes import Change, Setting
from discostorm.planner.known import family, known, product, row_of
from discostorm.planner.search import changes_of
from discostorm.planner.snippets import snippets
from discostorm.protocols import ARRANGED, MEASURED
from discostorm.robots import (
    endpoints_of_a_node,
    laptop,
    parameter_service_endpoints,
    robots,
    shared_endpoints,
)
from discostorm.saturation import solve_hosts
from discostorm.wifi import Cast, Model, Wifi, bits_airtime, downlink_airtime, uplink_airtime

TARGET = Path(__file__).parents[1] / "book" / "_static" / "calculator" / "model.js"

#: Another version of sympy may order the same sums otherwise.
HEAD = "// Made from the package by `make calculator` with sympy {}; do not edit.\n"

#: The paper's tables.
PAPERS = (ds.DDS, ds.ZENOH)

#: Channels of the standard on which frames to one receiver share exchanges.
AGGREGATED = (
    ds.Radio("802.11n", streams=2, mpdus=64).wifi(),
    ds.Radio("802.11ac", streams=2, width=80e6, mpdus=64).wifi(),
    ds.Radio("802.11ax", streams=2, width=80e6, mpdus=64).wifi(),
)
CHANNELS = (ds.PAPER, *ds.WIFI.values(), *AGGREGATED)

#: Where the calculator starts, with how many of which robots.
START_HOSTS, START_ROBOT = 5, "Nav2 in one process"
START_MIDDLEWARE = "Fast DDS"

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
PRODUCTS = tuple(
    {
        row["defaults"]: row["protocol"] for row in reversed(read_data("vendors/products.csv"))
    }.values()
)

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
COEFFICIENTS = sp.symbols("c b a third", positive=True)

#: Headings of the middlewares, in order.
GROUPS = (
    "Products as built",
    "Products arranged against the storm",
    "As the paper counts",
    "The paper's messages, a product's periods",
    "Proposals and other tables",
)

#: The largest whole number of hosts below saturation.
N_SAT = sp.Symbol("N_sat", positive=True)
LARGEST = sp.ceiling(N_SAT) - 1

Code = str | dict[str, "Code"] | list["Code"]


def data(value: object) -> str:
    """Return a value as JavaScript, whole numbers without a point."""
    return json.dumps(value, ensure_ascii=False)


def number(value: float) -> str:
    """Return a number as JavaScript, which JSON cannot hold if it is infinite."""
    if value == sp.oo:
        return "Infinity"
    return data(int(value) if float(value).is_integer() and value < 1e15 else float(value))


def javascript_of(expression: sp.Expr) -> str:
    """Return an expression as a JavaScript function of an object that holds its symbols."""
    names = ", ".join(sorted(symbol.name for symbol in expression.free_symbols))
    shared, rest = share(sp.sympify(expression))
    lines = [f"const {symbol} = {sp.jscode(part)};" for symbol, part in shared]
    return " ".join([f"({{ {names} }}) => {{", *lines, f"return {sp.jscode(rest)}; }}"])


class Formulas:
    """The distinct formulas, each with a name that says what it is."""

    def __init__(self) -> None:
        self.names: dict[str, str] = {}

    def name(self, expression: sp.Expr, hint: str) -> str:
        """Return the name of an expression, as data."""
        known = self.names.setdefault(javascript_of(expression), "")
        if not known:
            same = sum(name.rstrip("0123456789") == hint for name in self.names.values())
            known = f"{hint}{same + 1 if same else ''}"
            self.names[javascript_of(expression)] = known
        return data(known)

    def code(self) -> Code:
        """Return all of them by their names."""
        return {name: code for code, name in self.names.items()}


def values(given: Iterable[tuple[sp.Symbol, float]]) -> Code:
    """Return the values of symbols as data."""
    inner = ", ".join(f"{data(symbol.name)}: {number(value)}" for symbol, value in given)
    return f"{{{inner}}}"


def channel(wifi: Wifi) -> dict[str, Code]:
    """Return the data of a Wi-Fi channel."""
    return {
        "name": data(wifi.name),
        "model": data(wifi.model),
        "values": values(wifi.values().items()),
    }


def radio_remedies(wifi: Wifi) -> Code:
    """Return what the planner would change of a channel: the channel before and after."""
    base = Setting(SMALL, ds.DDS, wifi)
    return [
        {
            "kind": data(change.kind),
            "what": data(change.what),
            "note": data(change.note),
            "base": channel(base.before([change]).wifi),
            "wifi": channel(base.after([change]).wifi),
        }
        for change in changes_of(base, (0.0,), "")
        if not isinstance(change, str) and change.kind in RADIO
    ]


def table_changes(protocol: Protocol) -> list[Change]:
    """Return the changes of the planner that put another table in its place.

    But for what nobody can have yet.
    """
    return [
        change
        for change in changes_of(Setting(SMALL, protocol, ds.PAPER), (0.0,), "")
        if not isinstance(change, str)
        and change.table is not None
        and change.steps == (change.kind,)
        and known(change.kind, change.table)["effort"] != "research"
    ]


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


def table_remedies(protocol: Protocol) -> Code:
    """Return which other table the planner would put in its place, and what each is held against.

    Nothing for a table that is such a change itself.
    """
    if protocol not in ds.PROTOCOLS.values():
        return []
    return [
        [
            data(change.kind),
            data(change.what),
            data(change.note),
            data(key(protocol, change)),
            data((change.base or protocol).name),
        ]
        for change in table_changes(protocol)
    ]


#: Kinds of remedies that change the channel.
RADIO = ("multicast rate", "radio", "aggregation")
#: Any fleet will do for changes of the channel.
SMALL = Fleet.swarm(2, 1, 0)


def field(
    name: str,
    label: str,
    symbol: str,
    start: float,
    allowed: tuple[float, float, bool],
    unit: str = "",
    scale: float = 1,
    whole: bool = False,
) -> Code:
    """Return the data of an input field: what it asks for and which numbers are allowed."""
    low, high, above = allowed
    range_ = _checks.wanted(low, high, above).replace(
        "a finite number", "a whole number" if whole else "a number"
    )
    return {
        "name": data(name),
        "label": data(label),
        "symbol": data(symbol),
        "unit": data(unit),
        "scale": number(scale),  # from the unit of the field to SI
        "start": data(f"{start:.6g}"),
        "low": number(low),
        "high": number(high),
        "above": data(above),
        "whole": data(whole),
        "allowed": data(range_.replace(f"{_checks.MOST:g}", f"{_checks.MOST:,.0f}")),
    }


def counts(
    prefix: str, titles: Sequence[str], symbols: Iterable[sp.Symbol], start: Sequence[float]
) -> Code:
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


def fields() -> Code:
    """Return the data of all input fields."""
    robot = robots()[START_ROBOT]
    links = (
        ("unicast", "unicast", ds.PAPER.unicast, nt.R_UNI, nt.O_UNI),
        ("multicast", "multicast", ds.PAPER.multicast, nt.R_MULTI, nt.O_MULTI),
    )
    own: list[Code] = []
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
            ("Robots", "Processes on each", "Endpoints of each process"),
            SWARM.counts(),
            (START_HOSTS, robot.processes, robot.endpoints),
        ),
        "beside": counts(
            "beside_",
            ("How many", "Processes on each of them", "Endpoints of each of these"),
            BESIDE.counts(),
            laptop().counts(),
        ),
        "own": own,
    }


def ready_made() -> Code:
    """Return the ready-made robots with what the data file says of their parts."""
    rows = read_data("fleets/robots.csv")
    return [
        {
            "name": data(name),
            "processes": data(f"{host.processes:.6g}"),
            "endpoints": data(f"{host.endpoints:.6g}"),
            "nodes": number(host.nodes or 0),
            "parts": data(
                [
                    {
                        "what": row["part"],
                        "processes": int(row["processes"]),
                        "endpoints": int(row["endpoints"]),
                        "kind": row["kind"],
                        "source": row["source"],
                    }
                    for row in rows
                    if row["robot"] == name
                ]
            ),
        }
        for name, host in robots().items()
    ]


def group(protocol: Protocol) -> str:
    """Return under which heading a table is offered."""
    if protocol in PAPERS:
        return GROUPS[2]
    if protocol.name in ARRANGED:
        return GROUPS[1]
    papers = [message for table in PAPERS for message in table.messages]
    if protocol.name not in MEASURED and not any(m in papers for m in protocol.messages):
        return GROUPS[4]
    return GROUPS[0] if protocol.name in MEASURED else GROUPS[3]


def row(message: Message, windows: dict[str, float], units: list[Unit]) -> dict[str, Code]:
    """Return what the calculator knows of a message."""
    schedule = message.schedule
    return {
        "name": data(message.name),
        "cast": data(message.cast),
        "bytes": number(message.frame_bytes),
        "frames": number(message.frames),
        "unit": data(units.index(message.unit)),
        "per_unit": number(message.per_unit),
        "hops": data(" ".join(message.hops)),
        "sent": {
            "burst": number(schedule.extra),
            **{name: number(schedule.mean(window)) for name, window in windows.items()},
        },
    }


def airtimes(known: Formulas) -> Code:
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


def outlooks(protocol: Protocol) -> Code:
    """Return which word `timeline.outlook` has for a drain time up to a limit [s]."""
    *told, never = timeline.OUTLOOKS
    limits = (PAPER_WINDOW, protocol.lease, sp.oo)
    return {
        "until": [[number(limit), data(word)] for limit, word in zip(limits, told, strict=True)],
        "never": data(never),
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


def unit_code(unit: Unit, fleet: Fleet, known: Formulas) -> Code:
    """Return how many of a unit a fleet has, and what further hosts add to it."""
    return {
        "count": known.name(sp.sympify(unit.count(fleet)), "count"),
        "more": [known.name(part, "more") for part in coefficients(unit, fleet)],
    }


def measured_up_to(protocol: Protocol) -> list[float]:
    """Return the most hosts, processes and endpoints of a process that a product ran with [1].

    None for a table that was not fitted to captures.
    """
    if protocol.name not in MEASURED | ARRANGED:
        return []
    return [*map(float, measured.largest(protocol.name))]


def about(protocol: Protocol, known: Formulas) -> dict[str, Any]:
    """Return all that the calculator knows of a protocol."""
    windows = {"second": PAPER_WINDOW}
    if protocol.lease < sp.oo:
        windows["lease"] = protocol.lease
    windows["ever"] = sp.oo
    units = list(protocol.units())
    return {
        # What only a change can have is not on offer.
        "group": data(group(protocol) if protocol in ds.PROTOCOLS.values() else None),
        "family": data(family(protocol)),
        "product": data(product(protocol)),
        "tables": table_remedies(protocol),
        "about": data(ABOUT.get(protocol.name, "")),
        "color": data(figures.property_of(protocol)),
        "measured": [number(most) for most in measured_up_to(protocol)],
        "variant": data(protocol.name in MEASURED and protocol.name not in PRODUCTS),
        "lease": number(protocol.lease),
        "repeats": data(protocol.repeats),
        "outlooks": outlooks(protocol),
        "windows": {name: number(window) for name, window in windows.items()},
        "units": [[unit_code(unit, fleet, known) for fleet in FLEETS] for unit in units],
        "degree": number(
            max(len(coefficients(unit, fleet)) - 1 for unit in units for fleet in FLEETS)
        ),
        "messages": [[*row(message, windows, units).values()] for message in protocol.messages],
    }


def remedies(kinds: Iterable[str]) -> Code:
    """Return of each kind of remedy what it takes, what to mind, by family, and what to paste."""
    families = [*dict.fromkeys(map(family, ds.PROTOCOLS.values())), None]
    efforts = {row["effort"]: row for row in read_data("vendors/efforts.csv")}

    def told(kind: str, family: str | None) -> Code:
        found = row_of(kind, family)
        if found is None or not found["effort"]:
            return "null"
        return {
            "effort": number(int(efforts[found["effort"]]["rank"])),
            "takes": data(efforts[found["effort"]]["what"]),
            "best_case": data(found["gain"] == "best case"),
            "mind": data("; ".join(filter(None, (found["price"], found["fails"])))),
        }

    return {
        kind: {
            "of": {str(family): told(kind, family) for family in families},
            "paste": data(
                {
                    row["for"]: [
                        {"where": piece.where, "version": piece.version, "text": piece.text}
                        for piece in snippets(kind, row["for"])
                        if row["for"] == "any" or piece not in snippets(kind, "")
                    ]
                    for row in read_data("vendors/snippets.csv")
                    if row["kind"] == kind
                }
            ),
        }
        for kind in kinds
    }


def model() -> Code:
    """Return all that the calculator reads."""
    known = Formulas()
    protocols: dict[str, Any] = {
        name: about(protocol, known) for name, protocol in tables().items()
    }
    degrees = range(1, len(COEFFICIENTS))
    full: list[Code] = ["null", *(saturation(degree, known) for degree in degrees)]
    kinds = {row[0] for about in protocols.values() for row in about["tables"]}
    kinds |= set(map(data, ("processes", "endpoints", *RADIO)))
    drain = known.name(timeline.DRAIN, "drain")
    largest = known.name(LARGEST, "largest")
    return {
        "start": {
            "robot": data(START_ROBOT),
            "middleware": data(START_MIDDLEWARE),
        },
        "groups": data(GROUPS),
        "fields": fields(),
        "robots": ready_made(),
        "channels": [{**channel(wifi), "remedies": radio_remedies(wifi)} for wifi in CHANNELS],
        "limit": number(1.0),
        "times": data(words.TIMES),
        "airtime": airtimes(known),
        "laptop_nodes": number(laptop().nodes or 0),
        "service_endpoints": number(parameter_service_endpoints()),
        "endpoints_of_a_node": number(endpoints_of_a_node()),
        "shared_endpoints": [number(shared_endpoints(nodes)) for nodes in (0, 1)],
        "remedies": remedies(sorted(map(json.loads, kinds))),
        "largest": largest,
        "saturation": full,
        "drain": drain,
        "formulas": known.code(),
        # What the rows of messages hold, in order.
        "columns": data(list(row(ds.DDS.messages[0], {}, list(ds.DDS.units())))),
        "protocols": protocols,
    }


def written(code: Code, indent: str = "") -> str:
    """Return nested code as JavaScript, one entry a line where it is long."""
    inner = indent + "  "
    if isinstance(code, dict):
        entries = [f"{data(key)}: {written(part, inner)}" for key, part in code.items()]
        braces = "{}"
    elif isinstance(code, list):
        entries, braces = [written(part, inner) for part in code], "[]"
    else:
        return code
    line = ", ".join(entries)
    if len(line) + len(indent) < 300 and "\n" not in line:
        return f"{braces[0]}{line}{braces[1]}"
    return "\n".join([braces[0], *(f"{inner}{entry}," for entry in entries), indent + braces[1]])


def said_once(code: Code) -> tuple[dict[str, Code], Code]:
    """Return what occurs more than once, by a name that stands for it, and the rest.

    A later one may stand on earlier ones. Short ones stay where they are.
    """
    many = Counter[str]()

    def count(part: Code) -> None:
        many[written(part)] += 1
        if many[written(part)] == 1 and not isinstance(part, str):
            for inner in part.values() if isinstance(part, dict) else part:
                count(inner)

    names: dict[str, str] = {}
    said: dict[str, Code] = {}

    def named(part: Code) -> Code:
        whole = written(part)
        if whole in names:
            return names[whole]
        rest: Code = part
        if isinstance(part, dict):
            rest = {key: named(inner) for key, inner in part.items()}
        elif isinstance(part, list):
            rest = [named(inner) for inner in part]
        if many[whole] == 1 or len(whole) < SHORT:
            return rest
        names[whole] = f"shared{len(names) + 1}"
        said[names[whole]] = rest
        return names[whole]

    count(code)
    rest = named(code)
    return said, rest


#: Characters from which on it is worth a name.
SHORT = 40


def javascript() -> str:
    """Return the text of model.js."""
    said, rest = said_once(model())
    lines = [f"  const {name} = {written(part, '  ')};" for name, part in said.items()]
    body = "\n".join([*lines, f"  return {written(rest, '  ')};"])
    return f"{HEAD.format(sp.__version__)}const DISCOSTORM = (() => {{\n{body}\n}})();\n"


if __name__ == "__main__":
    TARGET.write_text(javascript(), encoding="utf-8")
