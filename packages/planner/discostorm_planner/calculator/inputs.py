"""Input fields of the calculator, robot presets, limits of its simulations, and stored bursts."""

import inspect
from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp

import discostorm as ds
from discostorm import _checks, notation as nt
from discostorm.cells import MAX_CHANNEL
from discostorm.data import read_data
from discostorm.fleet import MIN_COUNTS, PAPER_SWARM, symbolic_group
from discostorm.robots import laptop, robots
from discostorm.ros_releases import newest_long_term, shipped_table
from discostorm.wifi import Wifi
from discostorm.wifi.radio import aggregation_bounds
from discostorm_planner import change_simulation, discovery_time, simulation_jobs
from discostorm_planner.answer_text import MAX_SHOWN_CHANGES
from discostorm_planner.calculator.javascript import JsValue
from discostorm_planner.discovery_time import MIN_EXPIRED_PER_PAIR, MIN_PAIRS, RUNS

#: Channels to choose from: one entry per radio, with or without aggregation.
CHANNELS = (ds.PAPER, *ds.WIFI.values())
#: Preselected entries.
DEFAULT_HOSTS, DEFAULT_ROBOT, DEFAULT_ROS = 5, "Nav2 in one process", newest_long_term()
DEFAULT_MIDDLEWARE = shipped_table("Fast DDS", DEFAULT_ROS)
#: The second group of hosts, which may be empty.
SECOND_GROUP = symbolic_group(1)


def channel_data(wifi: Wifi, fixed: bool = False) -> dict[str, JsValue]:
    """Return the data of a channel; also with full A-MPDUs, unless its aggregation is fixed."""
    full, single = aggregation_bounds(wifi)
    values: JsValue = {symbol.name: value for symbol, value in wifi.values().items()}
    both = {} if fixed or full in (single, wifi) else {"full": channel_data(full, fixed=True)}
    return {"name": wifi.name, "model": wifi.model, "values": values, **both}


def input_field(
    name: str,
    label: str,
    symbol: str,
    start: float,
    allowed: tuple[float, float, bool],
    unit: str = "",
    scale: float = 1,
    whole: bool = False,
) -> JsValue:
    """Return the data of an input field: label, default and allowed numbers."""
    low, high, above = allowed
    kind = "a whole number" if whole else "a number"
    range_ = _checks.describe_range(low, high, above, what=kind)
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


def group_count_fields(
    prefix: str, titles: Sequence[str], symbols: Iterable[sp.Symbol], start: Sequence[float]
) -> JsValue:
    """Return the input fields of a group of hosts, with the package's allowed ranges."""
    return [
        input_field(
            f"{prefix}{name}",
            title,
            symbol.name,
            first,
            (MIN_COUNTS[name], _checks.MAX_COUNT, False),
            whole=name != "endpoints",
        )
        for name, title, symbol, first in zip(MIN_COUNTS, titles, symbols, start, strict=True)
    ]


def input_fields() -> JsValue:
    """Return the data of all input fields."""
    robot = robots()[DEFAULT_ROBOT]
    links = (
        ("unicast", ds.PAPER.unicast, nt.R_UNI, nt.O_UNI),
        ("multicast", ds.PAPER.multicast, nt.R_MULTI, nt.O_MULTI),
    )
    inf = float("inf")
    mega, micro = ((0, inf, True), "Mbit/s", 1e6), ((0, inf, False), "µs", 1e-6)
    own: list[JsValue] = []
    for cast, link, rate, overhead in links:
        label, waits = f"Overhead of a frame, {cast}", link.overhead * 1e6
        own.append(input_field(f"{cast}_rate", f"Rate, {cast}", rate.name, link.rate / 1e6, *mega))
        own.append(input_field(f"{cast}_overhead", label, overhead.name, waits, *micro))
    within = (simulation_jobs.WITHIN_S, (0, change_simulation.MAX_TARGET_S, True), "s")
    return {
        "swarm": group_count_fields(
            "",
            ("Robots", "Processes per robot", "Endpoints per process"),
            PAPER_SWARM.counts(),
            (DEFAULT_HOSTS, robot.processes, robot.endpoints),
        ),
        "beside": group_count_fields(
            "beside_",
            ("Computers", "Processes per computer", "Endpoints per process, computers"),
            SECOND_GROUP.counts(),
            laptop().counts(),
        ),
        "own": own,
        "cells": [
            input_field("cells", "Access points", "cells", 1, (1, MAX_CHANNEL, False), whole=True)
        ],
        "target": [input_field("within", "Discovery within", "within", *within)],
    }


def robot_presets() -> JsValue:
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


def simulation_limits() -> JsValue:
    """Return the limits of the simulations in `discostorm_planner.change_simulation`."""
    return {
        "within": simulation_jobs.WITHIN_S,
        "give_up": simulation_jobs.MAX_IDLE_PERIODS,
        "runs": RUNS,
        "few_runs": simulation_jobs.RUNS_IF_LONG,
        "long_run": simulation_jobs.LONG_RUN_S,
        "seed": simulation_jobs.SEED,
        "queue": list(inspect.signature(ds.simulate).parameters["queue"].default),
        "max_seconds": simulation_jobs.MAX_RUN_SECONDS,
        "max_megabytes": simulation_jobs.MAX_RUN_MEGABYTES,
        "max_work": change_simulation.MAX_COST_S,
        "max_processes": simulation_jobs.MAX_SIMULATED_PROCESSES,
        "simulated_anyway": [*change_simulation.ALWAYS_SIMULATED],
        "max_changes": change_simulation.MAX_CHANGES,
        "max_combinations": change_simulation.MAX_COMBINATIONS,
        "most_pairs": simulation_jobs.MOST_PAIRS_SHARE,
        "many_lost": change_simulation.MAX_BOUND_LOSS,
        "few_lost": change_simulation.CAUTION_LOSS,
        "min_gain": discovery_time.MIN_RELATIVE_GAIN,
        "many_expired": MIN_EXPIRED_PER_PAIR,
        "other_middleware": [*sorted(change_simulation.MIDDLEWARE_EFFORTS)],
        "other_software": [*sorted(change_simulation.SOFTWARE_EFFORTS)],
        "too_large": simulation_jobs.TOO_LARGE,
        "shown": MAX_SHOWN_CHANGES,
        "near": MIN_PAIRS,
    }


def release_tables() -> dict[str, Any]:
    """Return the table of each product by ROS 2 distribution."""
    found: dict[str, Any] = {}
    for row in read_data("vendors/ros.csv"):
        found.setdefault(row["ros"], {})[row["product"]] = row["protocol"]
    return found
