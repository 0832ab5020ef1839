"""The changes that the calculator offers, with the configuration to copy."""

from collections.abc import Iterable
from dataclasses import replace
from typing import get_args

import discostorm as ds
from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import Family, Protocol
from discostorm.robots import parameter_service_endpoints
from discostorm.snippets import snippets
from discostorm.wifi import Wifi
from discostorm.wifi.radio import aggregation_bounds
from discostorm_planner.calculator.inputs import channel_data, release_tables
from discostorm_planner.calculator.javascript import JsValue
from discostorm_planner.changes import Change, Setting
from discostorm_planner.plan import STAGGERED_START, candidate_changes
from discostorm_planner.remedy_rules import describe_efforts, efforts, rule, rule_for

#: A fleet to which every change of hosts applies: processes to compose, endpoints to remove.
BASE_FLEET = Fleet.swarm(2, 2, parameter_service_endpoints())


def changes(protocol: Protocol, wifi: Wifi, ros: str | None = None) -> list[Change]:
    """Return the planner's changes in a ROS 2 release, without those that need a prototype."""
    return [
        change
        for change in candidate_changes(Setting(replace(BASE_FLEET, ros=ros), protocol, wifi))
        if not isinstance(change, str)
        and all(
            rule_for(kind, change.table or protocol)["effort"] != "research"
            for kind in change.kinds
        )
    ]


def radio_remedies(wifi: Wifi) -> JsValue:
    """Return the planner's channel changes, each with the channel before and after it."""
    base = Setting(BASE_FLEET, ds.DDS, wifi)
    # The paper's channel does not aggregate, so neither side of its comparisons does.
    fixed = aggregation_bounds(wifi)[0] == wifi
    return [
        {
            "kind": change.kind,
            "what": change.what,
            "note": change.note,
            "base": channel_data(base.baseline_of([change]).wifi, fixed),
            "wifi": channel_data(base.with_changes([change]).wifi, fixed),
        }
        for change in changes(ds.DDS, wifi)
        if change.radio is not None
    ]


def channels_after_changes(wifi: Wifi) -> list[Wifi]:
    """Return the channels after the planner's channel changes, with full A-MPDUs where allowed."""
    base, fixed = Setting(BASE_FLEET, ds.DDS, wifi), aggregation_bounds(wifi)[0] == wifi
    after = [base.with_changes([change]).wifi for change in changes(ds.DDS, wifi) if change.radio]
    return after if fixed else [aggregation_bounds(changed)[0] for changed in after]


def table_replacements(protocol: Protocol, ros: str | None = None) -> list[Change]:
    """Return the planner's changes that replace the protocol's table by another table."""
    return [change for change in changes(protocol, ds.PAPER, ros) if change.table is not None]


def table_name_of_change(protocol: Protocol, change: Change) -> str:
    """Return the name of a change's table; without a key, a name made of protocol and change."""
    assert change.table is not None
    if change.table.key is None:
        return f"{protocol.name}, {change.what}"
    return name_by_release(change.table)


def name_by_release(table: Protocol) -> str:
    """Return a table's name; with timers of another release, that release replaces the product."""
    if table == ds.PROTOCOLS.get(table.name, table):
        return table.name
    tables = (t for t in ds.PROTOCOLS.values() if t.product == table.product)
    release = next(t.name for t in tables if t.timers == table.timers)
    return table.name.replace(str(table.product), release)


def all_tables() -> dict[str, Protocol]:
    """Return all message tables by name: those of the package, and those that changes create."""
    return dict(ds.PROTOCOLS) | {
        name: change.table
        for protocol in ds.PROTOCOLS.values()
        for ros in (None, *release_tables())
        for change in table_replacements(protocol, ros)
        if (name := table_name_of_change(protocol, change)) not in ds.PROTOCOLS and change.table
    }


def table_changes_by_release(protocol: Protocol) -> JsValue:
    """Return the table changes of a packaged table: `any`, and releases where they differ."""
    if protocol != ds.PROTOCOLS.get(protocol.key or ""):
        return {"any": []}
    releases = [ros for ros, own in release_tables().items() if protocol.key in own.values()]
    rows = {ros: _change_rows(protocol, ros) for ros in releases}
    usual = _change_rows(protocol)
    return {"any": usual} | {ros: own for ros, own in rows.items() if own != usual}


def _change_rows(protocol: Protocol, ros: str | None = None) -> JsValue:
    """Return each change of a table as a row that names the new table and the compared one."""
    return [
        [
            change.kind,
            change.what,
            change.note,
            table_name_of_change(protocol, change),
            (change.baseline or protocol).name,
            " and ".join(change.kinds),
        ]
        for change in table_replacements(protocol, ros)
    ]


def remedy_data(ways: Iterable[tuple[str, ...]]) -> JsValue:
    """Return effort and trade-offs of each combination of changes, by protocol family."""
    families = (*get_args(Family), None)

    def about(steps: tuple[str, ...], family: str | None) -> JsValue:
        # Switching to a configuration uses the rule for any family; other families count peers.
        switch = len({*steps} - {STAGGERED_START.kind}) > 1
        rules = [rule(kind, None if switch and kind == "middleware" else family) for kind in steps]
        rows = [row for row in rules if row is not None and row["effort"]]
        if len(rows) < len(steps):
            return None
        parts = [row["price"] for row in rows] + [row["fails"] for row in rows if row["fails"]]
        return {
            "efforts": [row["effort"] for row in rows],
            "effort": max(int(efforts()[row["effort"]]["rank"]) for row in rows),
            "takes": describe_efforts(row["effort"] for row in rows),
            "best_case": any(row["gain"] == "best case" for row in rows),
            "cost": "; ".join(dict.fromkeys(parts)),
        }

    return {
        " and ".join(steps): {
            "steps": list(steps),
            "of": {str(family): about(steps, family) for family in families},
        }
        for steps in ways
    }


def snippet_data(kinds: Iterable[str]) -> JsValue:
    """Return the configuration to copy for each kind of remedy, by target."""
    return {
        kind: {
            row["for"]: [
                {"where": piece.where, "version": piece.version, "text": piece.text}
                for piece in snippets(kind, row["for"])
                if row["for"] == "any" or piece not in snippets(kind, "")
            ]
            for row in read_data("vendors/snippets.csv")
            if row["kind"] == kind
        }
        for kind in kinds
    }
