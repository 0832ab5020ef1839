"""Write the simulator's files for pages and package: `make live`.

``engine.wasm`` of the package is the simulator's inner loop, see `compile_wasm`;
``book/_static/live/engine.js`` holds the same bytes for pages. ``tables.js`` holds the set-up of
runs: records of the cell, and all parts of a table or channel that depend on neither fleet nor
seed; ``calculator/changed_tables.js`` adds what only the calculator's changes need. With
``--tables``, write only the tables.
"""

import base64
import json
import sys
import zlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import compile_wasm
import numpy as np

import discostorm as ds
from discostorm.data import data_path
from discostorm.messages import Message, Protocol
from discostorm.messages.legs import rows_to_every_port
from discostorm.wifi import OfdmSymbols
from discostorm.wifi.channel import TICK
from discostorm.wifi.radio import aggregation_bounds
from discostorm_book import sweeps
from discostorm_planner.calculator import offered_changes
from discostorm_planner.calculator.inputs import CHANNELS
from discostorm_planner.calculator.javascript import JsCode, JsValue, js_text, scalar_as_javascript
from discostorm_simulation import cell_setup, initial_state, state as st
from discostorm_simulation.result import CAUSES
from discostorm_simulation.run import Scenario, Setup, set_up

LIVE_FOLDER = Path(__file__).parents[2] / "book" / "_static" / "live"
TABLES_JS, ENGINE_JS = LIVE_FOLDER / "tables.js", LIVE_FOLDER / "engine.js"
CHANGED_TABLES_JS = LIVE_FOLDER.parent / "calculator" / "changed_tables.js"
ENGINE_WASM = data_path("engine.wasm", "discostorm_simulation")

#: A channel with a separate rate for multicast, and few frames in an A-MPDU.
FEW_MPDUS_CHANNEL = ds.Radio("802.11n", mpdus=16).wifi()
#: Channels with full A-MPDUs: the calculator has one entry for both ends of a radio's range.
AGGREGATED_CHANNELS = [full for wifi in CHANNELS if (full := aggregation_bounds(wifi)[0]) != wifi]
#: The last channel is that of the chapters' sweeps.
CHANNELS_BY_NAME = {
    wifi.name: wifi
    for wifi in (*CHANNELS, *AGGREGATED_CHANNELS, FEW_MPDUS_CHANNEL, sweeps.sweep_channel())
}

#: A placeholder fleet: the exported data do not depend on the fleet.
PLACEHOLDER_FLEET = ds.Fleet.swarm(4, 2, 3)
#: Fields that depend on the fleet, which the page computes.
FIELDS_OF_FLEET = ("octets", "set", "whole", "time_up", "time_down")
#: Fields that depend on a run's settings, not on the radio.
FIELDS_OF_RUN_SETTINGS = ("queue", "lifetime")
#: Kinds of a run's first events.
FIRST_EVENTS = ("SEND", "ANNOUNCE", "LEASE_CHECK")


def run_setup(
    protocol: Protocol, recovery: bool, eifs: bool = True, wifi: ds.Wifi = ds.PAPER
) -> Setup:
    """Return the set-up of a run with the placeholder fleet."""
    return set_up(Scenario(PLACEHOLDER_FLEET, protocol, wifi, recovery=recovery, eifs=eifs))


def record_layouts() -> tuple[dict[str, JsValue], dict[str, JsValue]]:
    """Return the layouts of a cell's records by name, and the type of each of its arrays."""
    cell, _ = run_setup(ds.DDS, True).cell(np.random.SeedSequence(0))
    found: dict[str, JsValue] = {}
    types: dict[str, JsValue] = {}
    for name, array in zip(cell._fields, cell, strict=True):
        kind = np.asarray(array).dtype
        types[name] = name if kind.names else kind.str[1:]
        if kind.names:
            fields: Any = kind.fields
            found[name] = {
                "size": kind.itemsize,
                "fields": {
                    field: [int(fields[field][1]), fields[field][0].str[1:]]
                    for field in kind.names
                    if not field.startswith("_")
                },
            }
    return found, types


def shared_constants() -> dict[str, JsValue]:
    """Return the constants that the set-up in JavaScript shares with the inner loop."""
    events: dict[str, JsValue] = {name: JsCode(f"{getattr(st, name)}n") for name in FIRST_EVENTS}
    return events | {
        "NEVER": int(st.NEVER),
        "TICK": TICK,
        "KIND_BITS": st.KIND_BITS,
        "PROCESS_BITS": st.PROCESS_BITS,
        "ITEM_BITS": st.ITEM_BITS,
        "OCTETS": cell_setup._MAX_OCTETS,
        "DATA": st.DATA,
        "TO_SERVER": st.TO_SERVER,
        "FROM_SERVER": st.FROM_SERVER,
        "PASSED_ON": st.PASSED_ON,
        "QUEUE_SAMPLES": initial_state.QUEUE_SAMPLES,
        "LOG": initial_state.LOG_ROWS,
        "POOL": initial_state.POOL_ENTRIES,
        "OVER": st.OVER,
        "MEMORY": st.MEMORY,
        "CAUSES": list(CAUSES),
    }


def nonzero_columns(records: Any, without: Sequence[str] = ()) -> dict[str, JsValue]:
    """Return the columns of records that are not all zero."""
    return {
        name: [int(value) for value in records[name]]
        for name in records.dtype.names
        if name not in without and records[name].any()
    }


def nonzero_fields(records: Any, without: Sequence[str] = ()) -> dict[str, JsValue]:
    """Return the fields of a record that are not zero."""
    row = {name: records[name][0].item() for name in records.dtype.names if name not in without}
    return {name: value for name, value in row.items() if value}


def message_data(row: Message) -> JsValue:
    """Return a message's unit, counts and frame length; with ``alone``, its count when unpacked."""
    unit = row.unit
    found: dict[str, JsValue] = {
        "name": row.name,
        "unit": [unit.what, unit.to, *([unit.factor] if unit.factor else [])],
        "multicast": int(row.cast == "multicast"),
        "sent": row.per_unit * row.frames,
        "bytes": row.frame_bytes,
    }
    return found | ({} if row.frames == 1 else {"alone": row.per_unit})


def schedule_data(protocol: Protocol, recovery: bool) -> dict[str, JsValue]:
    """Return the schedule of a table's messages, or the reason why the page cannot simulate it."""
    try:
        setup = run_setup(protocol, recovery)
    except ValueError as error:
        return {"refused": str(error)}
    bursts = setup.bursts
    found: dict[str, JsValue] = {
        "kinds": nonzero_columns(setup.kinds, FIELDS_OF_FLEET),
        "bursts": {
            "messages": [list(rows) for rows in bursts.rows_by_burst],
            "periods": [cell_setup.to_ticks(period) if period else 0 for period in bursts.periods],
            "times": [list(time) for time in bursts.sends],
        },
    }
    if setup.repairs is not None:
        found["repairs"] = nonzero_fields(setup.repairs, ("server",))
        if setup.server:
            found["server"] = True
        if rows := rows_to_every_port(protocol):
            found["spread"] = list(rows)
    return found


def protocol_data(protocol: Protocol) -> JsValue:
    """Return a table of messages as data of the page."""
    rows = protocol.messages
    return {
        "messages": [message_data(row) for row in rows],
        "inside": [
            [number, cell_setup.carrier_row(protocol, row), row.payload.nominal]
            for number, row in enumerate(rows)
            if not row.frames
        ],
        "alone": schedule_data(protocol, recovery=False),
        "recovering": schedule_data(protocol, recovery=True),
    }


def airtime_data(padding: OfdmSymbols, preamble: int) -> JsValue:
    """Return the parameters of a frame's airtime."""
    return {
        "bits": int(padding.bits),
        "added": int(padding.added),
        "symbol": cell_setup.to_ticks(padding.symbol),
        "grid": cell_setup.to_ticks(padding.grid),
        "preamble": preamble,
    }


def channel_data(wifi: ds.Wifi) -> JsValue:
    """Return a channel as data of the page: its radio and airtime parameters."""
    fast, slow = (airtime_data(*of_one) for of_one in cell_setup.symbols_and_preambles(wifi))
    return {
        "record": nonzero_fields(run_setup(ds.DDS, False, wifi=wifi).radio, FIELDS_OF_RUN_SETTINGS),
        "aggregates": wifi.aggregation is not None,
        "fast": fast,
        "slow": slow,
    }


def difference_code(data: JsValue, base: JsValue, name: str) -> JsValue:
    """Return JavaScript code for data, as its difference from a base with a name."""
    if not isinstance(data, dict) or not isinstance(base, dict) or base.keys() - data.keys():
        return data
    entries = [f"...{name}"]
    for key, value in data.items():
        if key not in base or value != base[key]:
            part = difference_code(value, base.get(key), f"{name}.{key}")
            entries.append(f"{scalar_as_javascript(key)}: {js_text(part)}")
    return JsCode(f"{{{', '.join(entries)}}}")


def added_tables_code(tables: dict[str, JsValue], existing: dict[str, JsValue]) -> list[str]:
    """Return code that adds tables to the known ones, each as its shortest difference from one."""
    lines = []
    for name, table in tables.items():
        ways = [
            table,
            *(difference_code(table, existing[base], table_expression(base)) for base in existing),
        ]
        lines.append(f"  {table_expression(name)} = {min(map(js_text, ways), key=len)};")
        existing = existing | {name: table}
    return ["{", "  const { tables } = LIVE_TABLES;", *lines, "}"]


def table_expression(name: str) -> str:
    """Return the JavaScript expression for a table by its name."""
    return f"tables[{json.dumps(name)}]"


def packaged_tables() -> dict[str, JsValue]:
    """Return the tables of the package by name, as data of the page."""
    return {name: protocol_data(protocol) for name, protocol in ds.PROTOCOLS.items()}


def tables_text() -> str:
    """Return the text of tables.js."""
    records, arrays = record_layouts()
    data: JsValue = {
        "layouts": records,
        "arrays": arrays,
        "constants": shared_constants(),
        "tables": packaged_tables(),
        "radios": {name: channel_data(wifi) for name, wifi in CHANNELS_BY_NAME.items()},
    }
    head = "// What a run is set up from; made from the package by `make live`; do not edit.\n"
    return f"{head}const LIVE_TABLES = {js_text(data)};\n"


def changed_tables_text() -> str:
    """Return the text of changed_tables.js: tables and radios that changes create."""
    radios = {
        wifi.name: wifi
        for channel in CHANNELS
        for wifi in offered_changes.channels_after_changes(channel)
    }
    known, changed = packaged_tables(), offered_changes.all_tables()
    tables = {name: protocol_data(changed[name]) for name in changed if name not in known}
    more: JsValue = {
        name: channel_data(w) for name, w in radios.items() if name not in CHANNELS_BY_NAME
    }
    lines = [
        "// Tables and radios after changes; made from the package by `make live`; do not edit.",
        *added_tables_code(tables, known),
        f"Object.assign(LIVE_TABLES.radios, {js_text(more)});",
    ]
    return "\n".join([*lines, ""])


def engine_text(code: bytes) -> str:
    """Return the text of engine.js: the engine, compressed without a header, in base64."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    packed = base64.b64encode(packer.compress(code) + packer.flush()).decode()
    return f'{compile_wasm.script_header()}const LIVE_ENGINE = "{packed}";\n'


if __name__ == "__main__":
    TABLES_JS.write_text(tables_text(), encoding="utf-8")
    CHANGED_TABLES_JS.write_text(changed_tables_text(), encoding="utf-8")
    if "--tables" not in sys.argv:
        ENGINE_WASM.write_bytes(compile_wasm.compile_webassembly())  # takes a minute or two
        ENGINE_JS.write_text(engine_text(ENGINE_WASM.read_bytes()), encoding="utf-8")
