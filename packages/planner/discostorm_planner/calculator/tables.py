"""What the calculator knows of each table of messages: see `model`."""

from dataclasses import replace
from typing import Any, get_args

import sympy as sp

import discostorm as ds
from discostorm import figures, notation as nt, timeline
from discostorm.data import read_data
from discostorm.fleet import SWARM, Fleet
from discostorm.measured import bands_of
from discostorm.messages import PAPER_WINDOW, Message, Protocol, Unit
from discostorm.protocols import BASES
from discostorm.saturation import solve_hosts
from discostorm.wifi import Cast, Model, bits_airtime, downlink_airtime, uplink_airtime
from discostorm_planner.calculator.changes import table_remedies
from discostorm_planner.calculator.inputs import BESIDE
from discostorm_planner.calculator.javascript import Formulas, Value
from discostorm_planner.reboot import factors
from discostorm_planner.remedy_rules import software

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
    for table in ("products", "configurations")
    for row in read_data(f"vendors/{table}.csv")
} | {
    "hybrid": "this book's proposal, for hosts with unlike software",
    "hybrid, alike": "this book's proposal, for hosts that are alike",
}

#: Further hosts than the first.
MORE = sp.Symbol("x", positive=True)

#: What the powers of these are multiplied with [1]; of higher ones there is no closed form.
COEFFICIENTS = sp.symbols("c b a", positive=True)


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
        # How far it was off where it was not fitted, up to how many times that range.
        "band": [
            [row.up_to, row.most_hosts, row.most_endpoints, row.sentence().removesuffix(".")]
            for row in bands_of(protocol.name)
        ],
        # How many times its pairs' part of a start a robot takes that reboots: least and most.
        "reboot": list(factors(protocol) or ()),
        "variant": protocol.basis == "measured" and protocol.name not in FIRST,
        "lease": protocol.lease,
        "repeats": protocol.repeats,
        "outlooks": outlooks(protocol),
        "windows": {**windows},
        "units": [[unit_code(unit, fleet, known) for fleet in FLEETS] for unit in units],
        "degree": max(len(coefficients(unit, fleet)) - 1 for unit in units for fleet in FLEETS),
        "messages": [[*row(message, windows, units).values()] for message in protocol.messages],
    }
