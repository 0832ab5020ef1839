"""Measured tables: the messages that products send, by captures and source code.

``data/vendors/as_built.csv`` lists each message: its unit, its times, and the line of the source.
``data/measured/as_built.csv``, which `lab/measure/fit_models.py` writes, has its number and size.
``mitigations.csv`` in both folders has the same for configurations that send less. The tables
themselves are rows of ``products.csv`` and ``configurations.csv``.

A message of a server or router takes one hop if the server is wired to the access point. If it runs
on a robot, the message takes two hops, but none to its own host, which is one of the first group.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache, partial
from typing import Any

import numpy as np

from discostorm import _checks, _names
from discostorm._numeric import int_if_integral
from discostorm.data import read_data
from discostorm.messages import (
    HOPS,
    UNIT_IF_SERVER_ON_ROBOT,
    UNITS,
    Message,
    Payload,
    Protocol,
    Schedule,
    Timers,
)
from discostorm.protocols.defaults import defaults, timers

#: Files with the messages of tables, by the basis of the table.
ROW_FILES = {"measured": "as_built", "mitigated": "mitigations"}
#: Columns of tables that are timers.
_TIMERS = set(Timers.__dataclass_fields__)
#: Measured values of a row that is not fitted yet.
_NOT_FITTED = {"per_unit": "0"}


@cache
def _tables(file: str) -> dict[str, dict[str, str]]:
    return {row["protocol"]: row for row in read_data(f"vendors/{file}.csv")}


#: Each returns the rows of its file in ``data/vendors/``, by the name of the message table.
products, product_releases, configurations = (
    partial(_tables, file) for file in ("products", "releases", "configurations")
)


def schedule_from_row(row: Mapping[str, Any]) -> Schedule:
    """Return the schedule of a row; once, at startup, for a row without times."""
    starts = tuple(float(time) for time in row.get("starts_s", "0").split())
    return Schedule(starts, float(row.get("period_s") or np.inf))


def messages_from_rows(rows: Iterable[Mapping[str, Any]]) -> tuple[Message, ...]:
    """Return the messages of a table's rows; each answers a message of the same table or none."""
    table = {row["message"]: row for row in rows}
    return tuple(_message_from_row(row, table) for row in table.values())


def message_rows(table: Mapping[str, str]) -> list[dict[str, str]]:
    """Return the message rows of a table's product; rows that list releases hold only for these."""
    name = table.get("rows") or table["protocol"]
    return [
        row
        for row in read_data(f"vendors/{ROW_FILES[table['basis']]}.csv")
        if row["protocol"] == name
        and (not row.get("releases") or table["release"] in row["releases"].split())
    ]


def measured_table(name: str) -> Protocol:
    """Return the table of a product, release or configuration, without messages never captured."""
    tables = products() | product_releases() | configurations()
    if name not in tables:
        _checks.instance("name", name, str)
        raise ValueError(
            f"name must name a measured model, such as {next(iter(tables))!r}; got "
            f"{_checks.shorten_name(name)!r}{_names.did_you_mean(name, tables)}"
        )
    table = tables[name]
    if table.get("on_robot_of"):
        wired = measured_table(table["on_robot_of"])
        messages = tuple(map(_moved_to_robot, wired.messages))
        return replace(wired, name=name, messages=messages, captured=_maxima(table), key=name)
    file = "releases" if name in product_releases() else ROW_FILES[table["basis"]]
    rows = (row for row in read_data(f"measured/{file}.csv") if row["protocol"] == name)
    measured = {row["message"]: row for row in rows}
    return table_with_counts(name, table, measured, f"discostorm/data/measured/{file}.csv")


def table_with_counts(
    name: str, table: Mapping[str, Any], measured: Mapping[str, dict[str, str]], source: str
) -> Protocol:
    """Return a table whose messages have these measured counts and sizes, by their names."""
    size = f"size: measured ({source})"
    rows = (
        row | measured[row["message"]] | {"source": f"{row['source']}; {size}"}
        for row in message_rows(table)
        if float(measured.get(row["message"], _NOT_FITTED)["per_unit"])
    )
    own_timers = {timer: float(table[timer]) for timer in _TIMERS & set(table) if table[timer]}
    return Protocol(
        name,
        messages_from_rows(rows),
        lease=defaults(table["defaults"])["lease"],
        wired=measured_table(table["wired"]) if table["wired"] else None,
        family=table["family"],
        product=table["defaults"],
        basis=table["basis"],
        timers=replace(timers(table["defaults"]), **own_timers),
        captured=_maxima(table),
        key=name,
    )


def _maxima(table: Mapping[str, str]) -> tuple[int, int, int]:
    """Return the maxima of hosts, processes and endpoints that were captured for a table."""
    return int(table["max_hosts"]), int(table["max_processes"]), int(table["max_endpoints"])


def _moved_to_robot(message: Message) -> Message:
    """Return a wired server's message as a server on a robot would send it."""
    if message.hops == HOPS:
        return message
    return replace(message, unit=UNIT_IF_SERVER_ON_ROBOT[message.unit], hops=HOPS)


def _message_from_row(row: Mapping[str, Any], table: Mapping[str, Any]) -> Message:
    size, low, high = (float(row[column]) for column in ("payload_B", "low_B", "high_B"))
    return Message(
        row["message"],
        payload=Payload(size, low, high, row["source"]),
        unit=UNITS[row["unit"]],
        per_unit=int_if_integral(float(row["per_unit"])),
        schedule=schedule_from_row(row),
        hops=(row["hops"],) if row.get("hops") else HOPS,
        answers=row["answers"] if row["answers"] in table else None,
        frames=float(row.get("frames", 1)),
        kind=row.get("kind", ""),
        informs=row["informs"] == "yes",
        inside=row.get("inside") or None,
        **{name: row[name] for name in ("phase", "cast", "transport", "role")},
    )
