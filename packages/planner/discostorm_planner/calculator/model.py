"""The text of the calculator's model, book/_static/calculator/model.js.

sympy prints each of the package's formulas once as JavaScript, also if several messages share the
formula. The inputs of the formulas (sizes, schedules, channels, robots, ranges) follow as data.
"""

from typing import Any

import sympy as sp

import discostorm as ds
from discostorm import timeline, wording
from discostorm.data import read_data
from discostorm.fleet_file import security_warning
from discostorm.measured import BEYOND, SIZE_CLASSES
from discostorm.protocols import BASES
from discostorm.robots import (
    endpoints_of_a_node,
    laptop,
    parameter_service_endpoints,
    shared_endpoints,
)
from discostorm.wifi.radio import TOPOLOGY
from discostorm_planner.answer_text import SENTENCES
from discostorm_planner.calculator.changes import changes, pastes, radio_remedies, remedies, tables
from discostorm_planner.calculator.inputs import (
    CHANNELS,
    START_MIDDLEWARE,
    START_ROBOT,
    START_ROS,
    channel,
    discovery_rules,
    fields,
    robot_presets,
    ros_releases,
)
from discostorm_planner.calculator.javascript import Formulas, Value, name_repeated_parts, written
from discostorm_planner.calculator.tables import COEFFICIENTS, airtimes, row, saturation, table_data

#: Other versions of sympy may order the same sums differently.
HEAD = "// Made from the package by `make calculator` with sympy {}; do not edit.\n"

#: The largest integer number of hosts below saturation.
N_SAT = sp.Symbol("N_sat", positive=True)

LARGEST = sp.ceiling(N_SAT) - 1


def model() -> Value:
    """Return all data and formulas of the calculator."""
    formulas = Formulas()
    protocols: dict[str, Any] = {
        name: table_data(protocol, formulas) for name, protocol in tables().items()
    }
    degrees = range(1, len(COEFFICIENTS))
    full: list[Value] = [None, *(saturation(degree, formulas) for degree in degrees)]
    single = [change for table in ds.PROTOCOLS.values() for change in changes(table, ds.PAPER)]
    shown = [change for change in single if change.table or change.radio or change.fleet]
    ways = sorted({change.steps for change in shown} | {("staggered start",)})
    drain = formulas.name(timeline.DRAIN, "drain")
    largest = formulas.name(LARGEST, "largest")
    return {
        "start": {
            "robot": START_ROBOT,
            "middleware": START_MIDDLEWARE,
            "ros": START_ROS,
            "product": "Fast DDS",
        },
        "ros": ros_releases(),
        # What commands call a table whose name stands for the newest release of its product.
        "exact": {
            r["protocol"]: r["alias"] for r in read_data("vendors/aliases.csv") if r["exact"]
        },
        "groups": list(BASES.values()),
        "fields": fields(),
        "robots": robot_presets(),
        "channels": [{**channel(wifi), "remedies": radio_remedies(wifi)} for wifi in CHANNELS],
        "discovery": discovery_rules(),
        "sentences": {**SENTENCES},
        "alone": wording.ALONE,
        "security": list(security_warning()),
        "topology": TOPOLOGY,
        "limit": 1.0,
        # Largest extrapolation as a multiple of the captured range, and the text for larger fleets.
        "told": SIZE_CLASSES[1],
        "beyond": BEYOND,
        "times": [list(row) for row in wording.TIMES],
        "airtime": airtimes(formulas),
        "laptop_nodes": laptop().nodes or 0,
        "service_endpoints": parameter_service_endpoints(),
        "endpoints_of_a_node": endpoints_of_a_node(),
        "shared_endpoints": [shared_endpoints(nodes) for nodes in (0, 1)],
        "remedies": remedies(ways),
        "pastes": pastes(sorted({kind for steps in ways for kind in steps})),
        # Changes of the hosts for which calculator.js has a function.
        "fleets": list(dict.fromkeys(change.kind for change in shown if change.fleet)),
        "largest": largest,
        "saturation": full,
        "drain": drain,
        "formulas": formulas.code(),
        # Columns of the message rows, in order.
        "columns": list(row(ds.DDS.messages[0], {}, list(ds.DDS.units()))),
        "protocols": protocols,
    }


def model_js() -> str:
    """Return the text of model.js."""
    said, rest = name_repeated_parts(model())
    lines = [f"const {name} = {written(part)};" for name, part in said.items()]
    body = "\n".join([*lines, f"return {written(rest)};"])
    return f"{HEAD.format(sp.__version__)}const DISCOSTORM = (() => {{\n{body}\n}})();\n"
