"""Input fields of the calculator, robot presets, limits of its simulations, and stored bursts."""

import inspect
from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp

import discostorm as ds
from discostorm import _checks, notation as nt
from discostorm.cells import MAX_CHANNEL
from discostorm.data import read_data
from discostorm.fleet import MIN_COUNTS, SWARM, symbolic_group
from discostorm.robots import laptop, robots
from discostorm.ros_releases import newest_long_term, shipped_table
from discostorm.wifi import Wifi
from discostorm.wifi.radio import aggregation_bounds
from discostorm_planner import discovery, discovery_time, runs
from discostorm_planner.answer_text import MOST_CHANGES, NEAR
from discostorm_planner.calculator.javascript import Value
from discostorm_planner.discovery_time import MANY_EXPIRED, RUNS

#: Channels to choose from: one entry per radio, with or without aggregation.
CHANNELS = (ds.PAPER, *ds.WIFI.values())

#: Preselected entries.
START_HOSTS, START_ROBOT = 5, "Nav2 in one process"

START_ROS = newest_long_term()
START_MIDDLEWARE = shipped_table("Fast DDS", START_ROS)

#: The second group of hosts, which may be empty.
OTHERS = symbolic_group(1)


def channel(wifi: Wifi) -> dict[str, Value]:
    """Return the data of a channel; if its radio aggregates, also with full A-MPDUs."""
    full, single = aggregation_bounds(wifi)
    if full in (single, wifi):
        return fixed_channel_data(wifi)
    return fixed_channel_data(wifi) | {"full": fixed_channel_data(full)}


def fixed_channel_data(wifi: Wifi) -> dict[str, Value]:
    """Return the data of a channel with fixed aggregation."""
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
    """Return the data of an input field: label, default and allowed numbers."""
    low, high, above = allowed
    range_ = _checks.describe_range(low, high, above).replace(
        "a finite number", "a whole number" if whole else "a number"
    )
    return {
        "name": name,
        "label": label,
        "symbol": symbol,
        "unit": unit,
        "scale": scale,  # factor from the field's unit to the SI unit
        "start": f"{start:.6g}",
        "low": low,
        "high": high,
        "above": above,
        "whole": whole,
        "allowed": range_.replace(f"{_checks.MAX_COUNT:g}", f"{_checks.MAX_COUNT:,.0f}"),
    }


def count_fields(
    prefix: str, titles: Sequence[str], symbols: Iterable[sp.Symbol], start: Sequence[float]
) -> Value:
    """Return the input fields of a group of hosts, with the package's allowed ranges."""
    return [
        field(
            f"{prefix}{name}",
            title,
            symbol.name,
            first,
            (MIN_COUNTS[name], _checks.MAX_COUNT, False),
            whole=name != "endpoints",
        )
        for name, title, symbol, first in zip(MIN_COUNTS, titles, symbols, start, strict=True)
    ]


def fields() -> Value:
    """Return the data of all input fields."""
    robot = robots()[START_ROBOT]
    links = (
        ("unicast", ds.PAPER.unicast, nt.R_UNI, nt.O_UNI),
        ("multicast", ds.PAPER.multicast, nt.R_MULTI, nt.O_MULTI),
    )
    inf = float("inf")
    mega, micro = ((0, inf, True), "Mbit/s", 1e6), ((0, inf, False), "µs", 1e-6)
    own: list[Value] = []
    for cast, link, rate, overhead in links:
        label, waits = f"Overhead of a frame, {cast}", link.overhead * 1e6
        own.append(field(f"{cast}_rate", f"Rate, {cast}", rate.name, link.rate / 1e6, *mega))
        own.append(field(f"{cast}_overhead", label, overhead.name, waits, *micro))
    within = (discovery.WITHIN, (0, discovery.MAX_WITHIN, True), "s")
    return {
        "swarm": count_fields(
            "",
            ("Robots", "Processes per robot", "Endpoints per process"),
            SWARM.counts(),
            (START_HOSTS, robot.processes, robot.endpoints),
        ),
        "beside": count_fields(
            "beside_",
            ("Computers", "Processes per computer", "Endpoints per process, computers"),
            OTHERS.counts(),
            laptop().counts(),
        ),
        "own": own,
        "cells": [field("cells", "Access points", "cells", 1, (1, MAX_CHANNEL, False), whole=True)],
        "target": [field("within", "Discovery within", "within", *within)],
    }


def robot_presets() -> Value:
    """Return the robot presets and their parts."""
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


def discovery_rules() -> Value:
    """Return the limits by which `discostorm_planner.discovery` simulates a fleet and changes."""
    return {
        "within": discovery.WITHIN,
        "give_up": runs.GIVE_UP,
        "runs": RUNS,
        "few_runs": runs.FEW_RUNS,
        "long_run": runs.LONG_RUN,
        "seed": runs.SEED,
        "queue": list(inspect.signature(ds.simulate).parameters["queue"].default),
        "max_seconds": runs.MAX_SECONDS,
        "max_megabytes": runs.MAX_MEGABYTES,
        "max_work": discovery.MAX_WORK,
        "max_processes": runs.MAX_PROCESSES,
        "max_changes": discovery.MAX_CHANGES,
        "most_pairs": runs.MOST_PAIRS,
        "many_lost": discovery.MANY_LOST,
        "few_lost": discovery.FEW_LOST,
        "min_gain": discovery_time.MIN_GAIN,
        "many_expired": MANY_EXPIRED,
        "other_software": [*sorted(discovery.OTHER_SOFTWARE)],
        "too_large": runs.TOO_LARGE,
        "shown": MOST_CHANGES,
        "near": NEAR,
    }


def ros_releases() -> dict[str, Any]:
    """Return the table of each product by ROS 2 distribution."""
    found: dict[str, Any] = {}
    for row in read_data("vendors/ros.csv"):
        found.setdefault(row["ros"], {})[row["product"]] = row["protocol"]
    return found
