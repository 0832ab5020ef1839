"""Input fields of the calculator, ready-made robots, and startups simulated beforehand."""

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
from discostorm_planner import stored_simulations
from discostorm_planner.calculator.javascript import Value

#: The channels to choose from: one entry per radio, whether it aggregates or not.
CHANNELS = (ds.PAPER, *ds.WIFI.values())

#: The first entries.
START_HOSTS, START_ROBOT = 5, "Nav2 in one process"

START_MIDDLEWARE = "Fast DDS"

#: Simulated runs per fleet.
RUNS = 10

#: The second group of hosts, which may be empty.
OTHERS = symbolic_group(1)


def channel(wifi: Wifi) -> dict[str, Value]:
    """Return the data of a channel; of a radio that aggregates also with full A-MPDUs."""
    full, single = both_ends(wifi)
    if full in (single, wifi):
        return one_channel(wifi)
    return one_channel(wifi) | {
        "full": one_channel(full),
        "simulated": stored_simulations.radio_key(wifi),
    }


def one_channel(wifi: Wifi) -> dict[str, Value]:
    """Return the data of one end of a channel."""
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
    """Return the data of an input field: its label and the allowed numbers."""
    low, high, above = allowed
    range_ = _checks.describe_range(low, high, above).replace(
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
        "allowed": range_.replace(f"{_checks.MAX_COUNT:g}", f"{_checks.MAX_COUNT:,.0f}"),
    }


def counts(
    prefix: str, titles: Sequence[str], symbols: Iterable[sp.Symbol], start: Sequence[float]
) -> Value:
    """Return the fields of a group of hosts, with the package's ranges."""
    return [
        field(
            f"{prefix}{name}",
            title,
            symbol.name,
            first,
            (LEAST[name], _checks.MAX_COUNT, False),
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
            OTHERS.counts(),
            laptop().counts(),
        ),
        "own": own,
    }


def ready_made() -> Value:
    """Return the ready-made robots and their parts."""
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
    """Return the settings of simulated runs: the defaults of `discostorm.simulate`."""
    defaults = inspect.signature(ds.simulate).parameters
    return {"runs": RUNS} | {name: defaults[name].default for name in ("seed", "queue", "until")}


def ready() -> Value:
    """Return the simulated startups of ready-made robots, and which hosts are like those."""

    def counts_of(host: HostGroup) -> Value:
        return {"N_P": host.processes, "N_E": host.endpoints, "N_S": host.shared}

    startups: dict[str, Any] = {}
    for (radio, table, robot, laptops), rows in stored_simulations.ready_made_startups().items():
        startups.setdefault(radio, {}).setdefault(table, {}).setdefault(robot, {})[laptops] = rows
    data = read_data("simulated/ready.csv", "discostorm_planner")
    ((until, runs),) = {(row["until_s"], row["runs"]) for row in data if row["recovery"] == "1"}
    return {
        "robots": {name: counts_of(host) for name, host in robots().items()},
        "laptop": counts_of(laptop()),
        "shared": stored_simulations.SHARED_TOLERANCE,
        "whole": stored_simulations.ENDPOINTS_TOLERANCE,
        "until": float(until),
        "runs": int(runs),
        "found": startups,
    }
