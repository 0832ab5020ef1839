"""The text of the calculator's model, book/_static/calculator/model.js.

sympy prints each of the package's formulas once as JavaScript, also if several messages share the
formula. The inputs of the formulas (sizes, schedules, channels, robots, ranges) follow as data.
"""

from typing import Any

import sympy as sp

import discostorm as ds
from discostorm import drain_times, robots, wording
from discostorm.data import read_data
from discostorm.fleet_file import security_warning
from discostorm.prediction_error import BEYOND_CLAUSE, SIZE_CLASSES
from discostorm.protocols import BASES
from discostorm.wifi.radio import TOPOLOGY
from discostorm_planner.answer_text import SENTENCES
from discostorm_planner.calculator import inputs, javascript, message_tables, offered_changes
from discostorm_planner.calculator.javascript import JsFormulas, JsValue, js_text

#: Other versions of sympy may order the same sums differently.
HEADER = "// Made from the package by `make calculator` with sympy {}; do not edit.\n"

#: The largest integer number of hosts below saturation.
LARGEST_HOST_COUNT = sp.ceiling(sp.Symbol("N_sat", positive=True)) - 1


def model_data() -> JsValue:
    """Return all data and formulas of the calculator."""
    formulas = JsFormulas()
    protocols: dict[str, Any] = {
        name: message_tables.table_data(protocol, formulas)
        for name, protocol in offered_changes.all_tables().items()
    }
    degrees = range(1, len(message_tables.COEFFICIENTS))
    full = [message_tables.saturation_formula(degree, formulas) for degree in degrees]
    shown = [
        change
        for table in ds.PROTOCOLS.values()
        for change in offered_changes.changes(table, ds.PAPER)
        if change.table or change.radio or change.fleet
    ]
    alone = [(), *(change.kinds for change in shown)]
    ways = sorted({(*kinds, *late) for kinds in alone for late in ((), ("staggered start",))})[1:]
    return {
        "start": {
            "robot": inputs.DEFAULT_ROBOT,
            "middleware": inputs.DEFAULT_MIDDLEWARE,
            "ros": inputs.DEFAULT_ROS,
            "product": "Fast DDS",
        },
        "ros": inputs.release_tables(),
        # Names for commands of tables whose own name there means a shipped release.
        "exact": {
            r["protocol"]: r["alias"] for r in read_data("vendors/aliases.csv") if r["exact"]
        },
        "groups": list(BASES.values()),
        "fields": inputs.input_fields(),
        "robots": inputs.robot_presets(),
        "channels": [
            {**inputs.channel_data(wifi), "remedies": offered_changes.radio_remedies(wifi)}
            for wifi in inputs.CHANNELS
        ],
        "discovery": inputs.simulation_limits(),
        "sentences": {**SENTENCES},
        "alone": wording.LONE_HOST_NOTE,
        "security": list(security_warning()),
        "topology": TOPOLOGY,
        "limit": 1.0,
        # Largest extrapolation as a multiple of the captured range, and the text for larger fleets.
        "told": SIZE_CLASSES[1],
        "beyond": BEYOND_CLAUSE,
        "times": [list(row) for row in wording.TIME_UNITS],
        "airtime": message_tables.airtimes(formulas),
        "laptop_nodes": robots.laptop().nodes or 0,
        "service_endpoints": robots.parameter_service_endpoints(),
        "endpoints_of_a_node": robots.endpoints_per_node(),
        "shared_endpoints": [robots.shared_endpoints(nodes) for nodes in (0, 1)],
        "remedies": offered_changes.remedy_data(ways),
        "pastes": offered_changes.snippet_data(sorted({kind for steps in ways for kind in steps})),
        # Changes of the hosts for which calculator.js has a function.
        "fleets": list(dict.fromkeys(change.kind for change in shown if change.fleet)),
        "largest": formulas.name_of(LARGEST_HOST_COUNT, "largest"),
        "saturation": [None, *full],
        "drain": formulas.name_of(drain_times.DRAIN_TIME, "drain"),
        "formulas": {name: code for code, name in formulas.names.items()},
        # Columns of the message rows, in order.
        "columns": list(message_tables.message_row(ds.DDS.messages[0], {}, list(ds.DDS.units()))),
        "protocols": protocols,
    }


def model_js() -> str:
    """Return the text of model.js."""
    said, rest = javascript.name_repeated_parts(model_data())
    lines = [f"const {name} = {js_text(part)};" for name, part in said.items()]
    body = "\n".join([*lines, f"return {js_text(rest)};"])
    return f"{HEADER.format(sp.__version__)}const DISCOSTORM = (() => {{\n{body}\n}})();\n"
