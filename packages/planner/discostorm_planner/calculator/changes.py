"""The changes that the calculator offers, with the configuration to copy."""

from collections.abc import Iterable
from typing import get_args

import discostorm as ds
from discostorm import words
from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import Family, Protocol
from discostorm.robots import parameter_service_endpoints
from discostorm.snippets import snippets
from discostorm.wifi import Wifi
from discostorm.wifi.radio import both_ends
from discostorm_planner.calculator.inputs import channel, one_channel
from discostorm_planner.calculator.javascript import Value
from discostorm_planner.changes import Change, Setting
from discostorm_planner.plan import changes_of
from discostorm_planner.remedy_rules import efforts, rule, rule_for

#: Hosts that have something to compose and to leave out: every change of hosts applies to them.
ANY = Fleet.swarm(2, 2, parameter_service_endpoints())


def changes(protocol: Protocol, wifi: Wifi) -> list[Change]:
    """Return the planner's changes without prototypes."""
    return [
        change
        for change in changes_of(Setting(ANY, protocol, wifi))
        if not isinstance(change, str)
        and all(
            rule_for(kind, change.table or protocol)["effort"] != "research"
            for kind in change.steps
        )
    ]


def way(change: Change) -> str:
    """Name the kinds of a change."""
    return " and ".join(change.steps)


def radio_remedies(wifi: Wifi) -> Value:
    """Return the planner's changes of a channel: the channel before and after each."""
    base = Setting(ANY, ds.DDS, wifi)
    # The paper's channel does not aggregate, so neither do both sides of a comparison.
    data_of = one_channel if both_ends(wifi)[0] == wifi else channel
    return [
        {
            "kind": change.kind,
            "what": change.what,
            "note": change.note,
            "base": data_of(base.before([change]).wifi),
            "wifi": data_of(base.after([change]).wifi),
        }
        for change in changes(ds.DDS, wifi)
        if change.radio is not None
    ]


def table_changes(protocol: Protocol) -> list[Change]:
    """Return the planner's changes that put another table in its place."""
    return [change for change in changes(protocol, ds.PAPER) if change.table is not None]


def key(protocol: Protocol, change: Change) -> str:
    """Name the table of a change; a table without a key has no name of its own yet."""
    assert change.table is not None
    return change.table.key or f"{protocol.name}, {change.what}"


def tables() -> dict[str, Protocol]:
    """Return all tables by name, those that changes make included."""
    return dict(ds.PROTOCOLS) | {
        name: change.table
        for protocol in ds.PROTOCOLS.values()
        for change in table_changes(protocol)
        if (name := key(protocol, change)) not in ds.PROTOCOLS and change.table
    }


def table_remedies(protocol: Protocol) -> Value:
    """Return the changes of a packaged table: the other table, and the table to compare with."""
    if protocol.key is None:
        return []
    return [
        [
            change.kind,
            change.what,
            change.note,
            key(protocol, change),
            (change.base or protocol).name,
            way(change),
        ]
        for change in table_changes(protocol)
    ]


def remedies(ways: Iterable[tuple[str, ...]]) -> Value:
    """Return effort and trade-offs of each way to change something, by family."""
    families = (*get_args(Family), None)

    def about(steps: tuple[str, ...], family: str | None) -> Value:
        # Switching to a configuration has the row for any family; the others count peers.
        switch = len(steps) > 1
        rules = [rule(kind, None if switch and kind == "middleware" else family) for kind in steps]
        rows = [row for row in rules if row is not None and row["effort"]]
        if len(rows) < len(steps):
            return None
        parts = [row["price"] for row in rows] + [row["fails"] for row in rows if row["fails"]]
        return {
            "effort": max(int(efforts()[row["effort"]]["rank"]) for row in rows),
            "takes": words.join_words(
                list(dict.fromkeys(efforts()[row["effort"]]["what"] for row in rows))
            ),
            "best_case": any(row["gain"] == "best case" for row in rows),
            "mind": "; ".join(dict.fromkeys(parts)),
        }

    return {
        " and ".join(steps): {
            "steps": list(steps),
            "of": {str(family): about(steps, family) for family in families},
        }
        for steps in ways
    }


def pastes(kinds: Iterable[str]) -> Value:
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
