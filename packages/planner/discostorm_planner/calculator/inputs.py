"""What the calculator asks for, and what was simulated beforehand: see `model`."""

import inspect
from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp

import discostorm as ds
from discostorm import _checks, notation as nt
from discostorm.data import read_data
from discostorm.fleet import LEAST, SWARM, HostGroup, symbolic_group
from discostorm.robots import laptop, robots
from discostorm.wifi import Wifi
from discostorm.wifi.radio import both_ends
from discostorm_planner import aggregation_range
from discostorm_planner.calculator.javascript import Value

#: What one can choose: one entry a radio, whether its frames share exchanges or not.
CHANNELS = (ds.PAPER, *ds.WIFI.values())

#: Where the calculator starts, with how many of which robots.
START_HOSTS, START_ROBOT = 5, "Nav2 in one process"

START_MIDDLEWARE = "Fast DDS"

#: How often the page simulates a fleet.
RUNS = 10

#: Like hosts beside a group of others, of which there may be none.
BESIDE = symbolic_group(1)


def channel(wifi: Wifi) -> dict[str, Value]:
    """Return the data of a Wi-Fi channel; of a radio that aggregates also with full A-MPDUs."""
    full, single = both_ends(wifi)
    if full in (single, wifi):
        return one_channel(wifi)
    return one_channel(wifi) | {
        "full": one_channel(full),
        "simulated": aggregation_range.radio_of(wifi),
    }


def one_channel(wifi: Wifi) -> dict[str, Value]:
    """Return the data of a channel by itself."""
    return {
        "name": wifi.name,
        "model": wifi.model,
        "values": {symbol.name: value for symbol, value in wifi.values().items()},
    }


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


def simulation() -> Value:
    """Return what the page simulates: so many runs with what `discostorm.simulate` assumes."""
    defaults = inspect.signature(ds.simulate).parameters
    return {"runs": RUNS} | {name: defaults[name].default for name in ("seed", "queue", "until")}


def ready() -> Value:
    """Return what was simulated of ready-made robots, and which hosts are as those."""

    def same_as(host: HostGroup) -> Value:
        return {"N_P": host.processes, "N_E": host.endpoints, "N_S": host.shared}

    found: dict[str, Any] = {}
    for (radio, table, robot, laptops), rows in aggregation_range.stored().items():
        found.setdefault(radio, {}).setdefault(table, {}).setdefault(robot, {})[laptops] = rows
    (until,) = {
        row["until_s"]
        for row in read_data("simulated/ready.csv", "discostorm_planner")
        if row["recovery"] == "1"
    }
    (runs,) = {
        row["runs"]
        for row in read_data("simulated/ready.csv", "discostorm_planner")
        if row["recovery"] == "1"
    }
    return {
        "robots": {name: same_as(host) for name, host in robots().items()},
        "laptop": same_as(laptop()),
        "shared": aggregation_range.SHARED,
        "whole": aggregation_range.WHOLE,
        "until": float(until),
        "runs": int(runs),
        "found": found,
    }
