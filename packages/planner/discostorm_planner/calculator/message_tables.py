"""Data and formulas of each message table for the calculator."""

from dataclasses import replace
from typing import Any, get_args

import sympy as sp

import discostorm as ds
from discostorm import drain_times, figures, notation as nt
from discostorm.data import read_data
from discostorm.fleet import PAPER_SWARM, Fleet
from discostorm.messages import PAPER_WINDOW, Message, Protocol, Unit, legs
from discostorm.prediction_error import error_bands
from discostorm.protocols import BASES, PROTOCOLS
from discostorm.saturation import solve_hosts
from discostorm.wifi import Cast, Model, bits_airtime, downlink_airtime, uplink_airtime
from discostorm_planner.calculator.inputs import SECOND_GROUP
from discostorm_planner.calculator.javascript import JsFormulas, JsValue
from discostorm_planner.calculator.offered_changes import table_changes_by_release
from discostorm_planner.further_loads import restart_factors
from discostorm_planner.remedy_rules import product_of, simulation_caution, time_ratios

#: Always-matching endpoints per process, in each of the two groups.
ALWAYS_MATCHING = sp.symbols("N_S N_S1", nonnegative=True)
#: Fleets where no endpoints match, where some of each process match, and where all match.
_GROUPS = (*PAPER_SWARM.groups, SECOND_GROUP)
_MATCHING = (replace(group, shared=n) for group, n in zip(_GROUPS, ALWAYS_MATCHING, strict=True))
FLEETS = (Fleet(_GROUPS), Fleet(tuple(_MATCHING)), Fleet(_GROUPS, matching=1.0))
#: Name of each product's default measured table; its other measured tables are variants.
DEFAULT_TABLES = {
    table.product: table.name
    for table in reversed(tuple(ds.PROTOCOLS.values()))
    if table.basis == "measured"
}.values()
#: Length of a frame [B].
LENGTH = sp.Symbol("L", positive=True)
#: What each table describes, and the versions it was measured with.
DESCRIPTIONS = {
    row["protocol"]: f"{row['what']} (measured with {row['versions']})"
    for table in ("products", "configurations")
    for row in read_data(f"vendors/{table}.csv")
} | {
    "hybrid": "this book's proposal, for hosts with unlike software",
    "hybrid, alike": "this book's proposal, for hosts that are alike",
}
#: Number of hosts beyond the first.
ADDED_HOSTS = sp.Symbol("x", positive=True)
#: Coefficients of the powers of the host count [1]. Higher powers have no closed form.
COEFFICIENTS = sp.symbols("c b a", positive=True)


def message_row(
    message: Message, windows: dict[str, float], units: list[Unit]
) -> dict[str, JsValue]:
    """Return the data of a message."""
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
            "burst": schedule.burst_count,
            **{name: schedule.mean(window) for name, window in windows.items()},
        },
    }


def airtimes(formulas: JsFormulas) -> JsValue:
    """Name the airtime formulas of a frame of L bytes on each hop, alone or inside another."""
    inside = {"up": formulas.name_of(bits_airtime(LENGTH, "unicast"), "inside_unicast")}
    for cast in get_args(Cast):
        inside[cast] = formulas.name_of(bits_airtime(LENGTH, cast), f"inside_{cast}")
    found: dict[str, Any] = {"inside": inside}
    for model in get_args(Model):
        found[model] = {"up": formulas.name_of(uplink_airtime(LENGTH, model), f"{model}_unicast")}
        for cast in get_args(Cast):
            airtime = downlink_airtime(LENGTH, cast, model)
            found[model][cast] = formulas.name_of(airtime, f"{model}_{cast}")
    return found


def coefficients(unit: Unit, fleet: Fleet) -> list[sp.Expr]:
    """Return a unit's count as coefficients of the powers of N_H - 1, the constant first."""
    count = sp.sympify(unit.count(fleet)).subs(nt.N_H, 1 + ADDED_HOSTS)
    parts = [count.diff(ADDED_HOSTS, n).subs(ADDED_HOSTS, 0) / sp.factorial(n) for n in range(5)]
    while parts and parts[-1] == 0:
        parts.pop()
    return parts


def saturation_formula(degree: int, formulas: JsFormulas) -> str:
    """Name the formula of the host count at saturation, for a utilization of this degree."""
    load = sp.Add(*(c * (nt.N_H - 1) ** n for n, c in enumerate(COEFFICIENTS[: degree + 1])))
    return formulas.name_of(solve_hosts(load), "saturation")


def unit_count(unit: Unit, fleet: Fleet, formulas: JsFormulas) -> JsValue:
    """Name the formulas of a unit's count in a fleet, and of its growth with further hosts."""
    return {
        "count": formulas.name_of(sp.sympify(unit.count(fleet)), "count"),
        "more": [formulas.name_of(part, "more") for part in coefficients(unit, fleet)],
    }


def table_data(protocol: Protocol, formulas: JsFormulas) -> dict[str, Any]:
    """Return the data and formulas of a table."""
    windows = {"second": PAPER_WINDOW}
    if protocol.lease < sp.oo:
        windows["lease"] = protocol.lease
    windows["ever"] = sp.oo
    units = list(protocol.units())
    *outlooks, never = drain_times.OUTLOOKS
    limits = (PAPER_WINDOW, protocol.lease, sp.oo)
    return {
        # The heading above a table; a table that only a change creates has none.
        "group": BASES[protocol.basis or "proposal"]
        if protocol == PROTOCOLS.get(protocol.key or "")
        else None,
        "family": protocol.family,
        "product": product_of(protocol),
        "tables": table_changes_by_release(protocol),
        "about": DESCRIPTIONS.get(protocol.name, ""),
        "caution": simulation_caution(protocol),
        "ratios": time_ratios(protocol),
        # Of clients of a wired server, and whether this table has one.
        "server_ratios": time_ratios(protocol, with_server=True),
        "has_server": legs.has_server(protocol),
        "color": figures.css_color_property(protocol),
        # Largest numbers of hosts, processes and endpoints per process in the product's captures.
        "measured": list(protocol.captured or ()),
        # Prediction error on held-out captures, by multiple of the fitted range.
        "band": [
            [row.up_to, row.most_hosts, row.most_endpoints, row.sentence().removesuffix(".")]
            for row in error_bands(protocol.name)
        ],
        # Airtime of a reboot, as minimum and maximum multiple of the pairs' share of a startup.
        "reboot": restart_factors(protocol),
        "variant": protocol.basis == "measured" and protocol.name not in DEFAULT_TABLES,
        "lease": protocol.lease,
        "repeats": protocol.repeats,
        # Outlooks with their maximum drain times [s].
        "outlooks": {
            "until": [[*pair] for pair in zip(limits, outlooks, strict=True)],
            "never": never,
        },
        "windows": {**windows},
        "units": [[unit_count(unit, fleet, formulas) for fleet in FLEETS] for unit in units],
        "degree": max(len(coefficients(unit, fleet)) - 1 for unit in units for fleet in FLEETS),
        "messages": [
            [*message_row(message, windows, units).values()] for message in protocol.messages
        ],
    }
