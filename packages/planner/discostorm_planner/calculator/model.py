"""The text of the calculator's model, book/_static/calculator/model.js.

Every formula is an expression of the package, printed by sympy as JavaScript, once however many
messages share it; what the formulas are fed with (sizes, schedules, channels, robots, ranges) is
written beside them as data.
"""

from typing import Any

import sympy as sp

import discostorm as ds
from discostorm import timeline, words
from discostorm.measured import BEYOND, CLASSES
from discostorm.protocols import BASES
from discostorm.robots import (
    endpoints_of_a_node,
    laptop,
    parameter_service_endpoints,
    shared_endpoints,
)
from discostorm.wifi.radio import TOPOLOGY
from discostorm_planner.calculator.changes import changes, pastes, radio_remedies, remedies, tables
from discostorm_planner.calculator.inputs import (
    CHANNELS,
    START_MIDDLEWARE,
    START_ROBOT,
    channel,
    fields,
    ready,
    ready_made,
    simulation,
)
from discostorm_planner.calculator.javascript import Formulas, Value, said_once, written
from discostorm_planner.calculator.tables import COEFFICIENTS, about, airtimes, row, saturation

#: Another version of sympy may order the same sums otherwise.
HEAD = "// Made from the package by `make calculator` with sympy {}; do not edit.\n"

#: The largest whole number of hosts below saturation.
N_SAT = sp.Symbol("N_sat", positive=True)

LARGEST = sp.ceiling(N_SAT) - 1


def model() -> Value:
    """Return all data and formulas of the calculator."""
    formulas = Formulas()
    protocols: dict[str, Any] = {
        name: about(protocol, formulas) for name, protocol in tables().items()
    }
    degrees = range(1, len(COEFFICIENTS))
    full: list[Value] = [None, *(saturation(degree, formulas) for degree in degrees)]
    single = [change for table in ds.PROTOCOLS.values() for change in changes(table, ds.PAPER)]
    shown = [change for change in single if change.table or change.radio or change.fleet]
    ways = sorted({change.steps for change in shown})
    drain = formulas.name(timeline.DRAIN, "drain")
    largest = formulas.name(LARGEST, "largest")
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
        # Up to how many times what was captured a number is told, and what is said beyond all.
        "told": CLASSES[1],
        "beyond": BEYOND,
        "times": [list(row) for row in words.TIMES],
        "airtime": airtimes(formulas),
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
        "formulas": formulas.code(),
        # What the rows of messages hold, in order.
        "columns": list(row(ds.DDS.messages[0], {}, list(ds.DDS.units()))),
        "protocols": protocols,
    }


def model_js() -> str:
    """Return the text of model.js."""
    said, rest = said_once(model())
    lines = [f"const {name} = {written(part)};" for name, part in said.items()]
    body = "\n".join([*lines, f"return {written(rest)};"])
    return f"{HEAD.format(sp.__version__)}const DISCOSTORM = (() => {{\n{body}\n}})();\n"
