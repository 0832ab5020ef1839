"""The changes that the calculator offers, with what to paste: see `model`."""

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
from discostorm_planner.remedy_rules import known, row_of

#: Hosts that have something to compose and to leave out: every change of hosts applies to them.
ANY = Fleet.swarm(2, 2, parameter_service_endpoints())


def changes(protocol: Protocol, wifi: Wifi) -> list[Change]:
    """Return what the planner would change, but for what nobody can have yet."""
    return [
        change
        for change in changes_of(Setting(ANY, protocol, wifi))
        if not isinstance(change, str)
        and all(
            known(kind, change.table or protocol)["effort"] != "research" for kind in change.steps
        )
    ]


def way(change: Change) -> str:
    """Return the name of what is to be done for a change: its kind, or several kinds."""
    return " and ".join(change.steps)


def radio_remedies(wifi: Wifi) -> Value:
    """Return what the planner would change of a channel: the channel before and after."""
    base = Setting(ANY, ds.DDS, wifi)
    # Of the paper's channel, which does not aggregate, both sides of a comparison do not.
    told = one_channel if both_ends(wifi)[0] == wifi else channel
    return [
        {
            "kind": change.kind,
            "what": change.what,
            "note": change.note,
            "base": told(base.before([change]).wifi),
            "wifi": told(base.after([change]).wifi),
        }
        for change in changes(ds.DDS, wifi)
        if change.radio is not None
    ]


def table_changes(protocol: Protocol) -> list[Change]:
    """Return the changes of the planner that put another table in its place."""
    return [change for change in changes(protocol, ds.PAPER) if change.table is not None]


def key(protocol: Protocol, change: Change) -> str:
    """Return the name of the table of a change; one that is not of `PROTOCOLS` has none yet."""
    assert change.table is not None
    of_its_own = change.table != ds.PROTOCOLS[change.table.name]
    return f"{protocol.name}, {change.what}" if of_its_own else change.table.name


def tables() -> dict[str, Protocol]:
    """Return each table that the calculator computes with, by name: all, and what changes make."""
    return dict(ds.PROTOCOLS) | {
        name: change.table
        for protocol in ds.PROTOCOLS.values()
        for change in table_changes(protocol)
        if (name := key(protocol, change)) not in ds.PROTOCOLS and change.table
    }


def table_remedies(protocol: Protocol) -> Value:
    """Return which other table the planner would put in its place, and what each is held against.

    Nothing for a table that is such a change itself.
    """
    if protocol not in ds.PROTOCOLS.values():
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
    """Return of each way to change something what it takes and what to mind, by family."""
    families = (*get_args(Family), None)
    efforts = {row["effort"]: row for row in read_data("vendors/efforts.csv", "discostorm_planner")}

    def told(steps: tuple[str, ...], family: str | None) -> Value:
        # What a family counts of switching to it is of its peers, not of an configuration.
        switch = len(steps) > 1
        rows = [row_of(kind, None if switch and kind == "middleware" else family) for kind in steps]
        found = [row for row in rows if row is not None and row["effort"]]
        if len(found) < len(steps):
            return None
        parts = [row["price"] for row in found] + [row["fails"] for row in found if row["fails"]]
        return {
            "effort": max(int(efforts[row["effort"]]["rank"]) for row in found),
            "takes": words.listed(
                list(dict.fromkeys(efforts[row["effort"]]["what"] for row in found))
            ),
            "best_case": any(row["gain"] == "best case" for row in found),
            "mind": "; ".join(dict.fromkeys(parts)),
        }

    return {
        " and ".join(steps): {
            "steps": list(steps),
            "of": {str(family): told(steps, family) for family in families},
        }
        for steps in ways
    }


def pastes(kinds: Iterable[str]) -> Value:
    """Return what to paste for each kind of remedy, by what it is for."""
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
