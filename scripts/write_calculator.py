"""Write the model of the calculator, book/_static/calculator/model.js, from the package.

Every formula is an expression of the package, printed by sympy as JavaScript; what the
formulas are fed with (sizes, channels, ranges, first values) is written beside them as data.
"""

import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import get_args

import sympy as sp

import discostorm as ds
from discostorm import _checks, figures, notation as nt, timeline
from discostorm._numeric import share
from discostorm.fleet import LEAST
from discostorm.messages import PAPER_WINDOW, Protocol
from discostorm.protocols import MEASURED
from discostorm.scalability import saturation
from discostorm.wifi import Model, Wifi

TARGET = Path(__file__).parents[1] / "book" / "_static" / "calculator" / "model.js"

#: Another version of sympy may order the same sums otherwise.
HEAD = "// Made from the package by `make calculator` with sympy {}; do not edit.\n"

#: The tables that are always compared: the paper's.
COMPARED = (ds.DDS, ds.ZENOH)

#: Channels of the standard on which frames to one receiver share exchanges.
AGGREGATED = (
    ds.Radio("802.11n", streams=2, mpdus=64).wifi(),
    ds.Radio("802.11ac", streams=2, width=80e6, mpdus=64).wifi(),
    ds.Radio("802.11ax", streams=2, width=80e6, mpdus=64).wifi(),
)

#: Where the calculator starts: the largest swarm of Fig. 2 that has room, on the paper's channel.
START = {
    "hosts": 7,
    "processes": figures.FIG2_PROCESSES,
    "endpoints": figures.FIG2_ENDPOINTS,
}

#: The largest whole number of hosts below saturation.
N_SAT = sp.Symbol("N_sat", positive=True)
LARGEST = sp.ceiling(N_SAT) - 1

Code = str | dict[str, "Code"] | list["Code"]


def data(value: object) -> str:
    """Return a value as JavaScript."""
    return json.dumps(value, ensure_ascii=False)


def number(value: float) -> str:
    """Return a number as JavaScript, which JSON cannot hold if it is infinite."""
    return data(value) if value < sp.oo else "Infinity"


def function(expression: sp.Expr) -> str:
    """Return an expression as a JavaScript function of an object that holds its symbols."""
    names = ", ".join(sorted(symbol.name for symbol in expression.free_symbols))
    shared, rest = share(sp.sympify(expression))
    lines = [f"const {symbol} = {sp.jscode(part)};" for symbol, part in shared]
    return " ".join([f"({{ {names} }}) => {{", *lines, f"return {sp.jscode(rest)}; }}"])


def values(given: Iterable[tuple[sp.Symbol, float]]) -> str:
    """Return the values of symbols as data."""
    return data({symbol.name: float(value) for symbol, value in given})


def channel(wifi: Wifi) -> Code:
    """Return the data of a Wi-Fi channel."""
    return {
        "name": data(wifi.name),
        "model": data(wifi.model),
        "values": values(wifi.values().items()),
    }


def field(
    name: str,
    label: str,
    symbol: sp.Symbol,
    start: float,
    allowed: tuple[float, float, bool],
    unit: str = "",
    scale: float = 1,
) -> Code:
    """Return the data of an input field: what it asks for and which numbers are allowed."""
    low, high, above = allowed
    words = _checks.wanted(low, high, above).replace("a finite number", "a number")
    return {
        "name": data(name),
        "label": data(label),
        "symbol": data(symbol.name),
        "unit": data(unit),
        "scale": data(scale),  # from the unit of the field to SI
        "start": data(f"{start:.12g}"),
        "low": data(low),
        "high": number(high),
        "above": data(above),
        "allowed": data(words.replace(f"{_checks.MOST:g}", f"{_checks.MOST:,.0f}")),
    }


def fields() -> Code:
    """Return the data of all input fields; the ranges are those of the package."""
    counts: Sequence[tuple[str, str, sp.Symbol]] = (
        ("hosts", "Hosts", nt.N_H),
        ("processes", "Processes on each host", nt.N_P),
        ("endpoints", "Endpoints of each process", nt.N_E),
    )
    links = (
        ("unicast", "unicast", ds.PAPER.unicast, nt.R_UNI, nt.O_UNI),
        ("multicast", "multicast", ds.PAPER.multicast, nt.R_MULTI, nt.O_MULTI),
    )
    swarm: list[Code] = [
        field(name, label, symbol, START[name], (LEAST[name], _checks.MOST, False))
        for name, label, symbol in counts
    ]
    own: list[Code] = []
    for name, cast, link, rate, overhead in links:
        own.append(
            field(
                f"{name}_rate",
                f"Rate, {cast}",
                rate,
                link.rate / 1e6,
                (0, float("inf"), True),
                "Mbit/s",
                1e6,
            )
        )
        own.append(
            field(
                f"{name}_overhead",
                f"Overhead of a frame, {cast}",
                overhead,
                link.overhead * 1e6,
                (0, float("inf"), False),
                "µs",
                1e-6,
            )
        )
    return {"swarm": swarm, "own": own}


def products(protocol: Protocol) -> list[Protocol]:
    """Return which tables with periods are shown with a protocol: those that start alike."""
    if protocol not in COMPARED:
        return [protocol]
    first = protocol.messages[0].name
    return [
        own
        for own in ds.PROTOCOLS.values()
        if own.repeats and own.name not in MEASURED and own.messages[0].name == first
    ]


def product(own: Protocol, model: Model) -> Code:
    """Return the burst and the steady state of a product, and the sizes of its messages."""
    return {
        "values": values(own.values().items()),
        "burst": function(own.burst(model=model)),
        "steady": function(own.utilization(model=model, window=sp.oo)),
    }


def outlooks(own: Protocol) -> Code:
    """Return which word `timeline.outlook` has for a drain time up to a limit [s]."""
    *words, never = timeline.OUTLOOKS
    limits = (data(PAPER_WINDOW), number(own.lease), "Infinity")
    return {
        "lease": number(own.lease),
        "until": [[limit, data(word)] for limit, word in zip(limits, words, strict=True)],
        "never": data(never),
    }


def formulas(protocol: Protocol, model: Model) -> Code:
    """Return the functions of a protocol on one kind of channel."""
    costs: dict[str, Code] = {}
    for message in protocol.messages:
        load = message.load() * message.schedule.mean(PAPER_WINDOW)
        up = load * message.airtime_up(model) if "up" in message.hops else sp.Integer(0)
        down = load * message.airtime_down(model) if "down" in message.hops else sp.Integer(0)
        costs[message.name] = {
            "up": function(up),
            "down": function(down),
            "both": function(up + down),
        }
    return {
        "utilization": function(protocol.utilization(model=model)),
        "saturation": function(saturation(protocol, model)),
        "costs": costs,
        "products": {own.name: product(own, model) for own in products(protocol)},
    }


def about(protocol: Protocol) -> Code:
    """Return all that the calculator knows of a protocol."""
    messages: list[Code] = [
        {
            "name": data(message.name),
            "phase": data(message.phase),
            "cast": data(message.cast),
            "load": function(message.load() * message.schedule.mean(PAPER_WINDOW)),
        }
        for message in protocol.messages
    ]
    return {
        "color": data(figures.COLORS[protocol.name]),
        "values": values(protocol.values().items()),
        "messages": messages,
        "outlooks": {own.name: outlooks(own) for own in products(protocol)},
        "models": {model: formulas(protocol, model) for model in get_args(Model)},
    }


def model() -> Code:
    """Return all that the calculator reads."""
    return {
        "fields": fields(),
        "channels": [channel(wifi) for wifi in (ds.PAPER, *ds.WIFI.values(), *AGGREGATED)],
        "compared": data([protocol.name for protocol in COMPARED]),
        "limit": values([(nt.U_LIMIT, 1.0)]),
        "largest": function(LARGEST),
        "drain": function(timeline.DRAIN),
        "protocols": {name: about(protocol) for name, protocol in ds.PROTOCOLS.items()},
    }


def written(code: Code, indent: str = "") -> str:
    """Return nested code as JavaScript, one entry a line."""
    inner = indent + "  "
    if isinstance(code, dict):
        entries = [f"{inner}{data(key)}: {written(part, inner)},\n" for key, part in code.items()]
        return "{\n" + "".join(entries) + indent + "}"
    if isinstance(code, list):
        entries = [f"{inner}{written(part, inner)},\n" for part in code]
        return "[\n" + "".join(entries) + indent + "]"
    return code


def javascript() -> str:
    """Return the text of model.js."""
    return f"{HEAD.format(sp.__version__)}const DISCOSTORM = {written(model())};\n"


if __name__ == "__main__":
    TARGET.write_text(javascript(), encoding="utf-8")
