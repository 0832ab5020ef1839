"""Compare captured messages with a model, and add up discovery traffic and user data."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from discostorm.fleet import Count, Fleet
from discostorm.messages import ENDPOINT_PAIR, MATCHED_WRITER, PAIR, Message, Protocol
from discostorm_capture import rtps, zenoh_messages
from discostorm_capture._types import Array, DataFrame

#: Kinds of Zenoh's user data, and of messages that only carry the other messages of their packet.
_USER_DATA_KINDS = ("Push", "Request", "Response", "ResponseFinal")
_CARRIER_KINDS = ("Frame", "Fragment")


@dataclass(frozen=True)
class VisibleFleet:
    """A fleet, and the group of the vantage host, if the capture has only that host's unicast."""

    fleet: Fleet
    vantage_group: int | None = None

    def visible_count(self, count: Callable[[Fleet], Count]) -> float:
        """Return how many unicast units of the fleet the capture shows."""
        total = float(count(self.fleet))
        if self.vantage_group is None:
            return total
        groups = list(self.fleet.groups)
        group = groups.pop(self.vantage_group)
        if group.hosts >= 2:
            groups.insert(self.vantage_group, replace(group, hosts=group.hosts - 1))
        if not groups:
            return total
        return total - float(count(Fleet(tuple(groups), self.fleet.matching)))

    def visible_units(self, message: Message) -> float:
        """Return how many units of a message (see `Message.unit`) the capture shows."""
        if message.cast == "multicast":
            return float(message.unit.count(self.fleet))
        return self.visible_count(message.unit.count)


def fleet_visible_from(fleet: Fleet, processes: DataFrame) -> VisibleFleet:
    """Return the fleet as seen from a host of the group most similar to these processes."""
    mean = float(processes["endpoints"].mean()) if len(processes) else 0.0
    n, groups = len(processes), fleet.groups
    differences = [(abs(group.processes - n), abs(group.endpoints - mean)) for group in groups]
    return VisibleFleet(fleet, differences.index(min(differences)))


def infer_unannounced(shown: VisibleFleet, protocol: Protocol, rows: DataFrame) -> VisibleFleet:
    """Return the visible fleet with publishers and matches, inferred from its messages."""
    shown = _infer_publishers(shown, protocol, rows)
    counted = {message.unit.what for message in protocol.messages}
    if "matched writer" not in counted:
        return shown
    groups = shown.fleet.groups
    unmatched, matched = (replace(shown, fleet=Fleet(groups, share)) for share in (0.0, 1.0))
    if "unmatched endpoint" in counted:
        # Only one of two matched endpoints declares the key expression.
        kind = "Declare key expression"
        min_count, max_count = (
            sum(m.per_unit * of.visible_units(m) for m in protocol.messages if m.kind == kind)
            for of in (matched, unmatched)
        )
        saved = max_count - int((rows["kind"] == kind).sum())
        possible = max_count - min_count
    else:
        answers = rows[rows["kind"] == "User ACKNACK"]
        saved = len(answers[["process", "peer", "writer"]].drop_duplicates())
        possible = matched.visible_count(MATCHED_WRITER.count)
    share = min(1.0, max(0.0, saved / possible)) if possible > 0 else 0.0
    return replace(shown, fleet=Fleet(groups, share))


def _infer_publishers(shown: VisibleFleet, protocol: Protocol, rows: DataFrame) -> VisibleFleet:
    """Return the visible fleet with the publishers of Zenoh, which are not announced as such."""
    groups = shown.fleet.groups
    declares = "Declare", ENDPOINT_PAIR
    declared = sum(m.per_unit for m in protocol.messages if (m.kind, m.unit) == declares)
    if 0 < declared < 1:
        groups = tuple(replace(g, endpoints=g.endpoints / declared) for g in groups)
    if declared > 1 and (pairs := shown.visible_count(PAIR.count)) > 0:
        # There is a token for each endpoint and one for the node.
        tokens = int((rows["submessage"] == "DeclareToken").sum()) / pairs - 1
        groups = tuple(replace(g, endpoints=max(g.endpoints, tokens)) for g in groups)
    return replace(shown, fleet=Fleet(groups))


def wire_protocol(protocol: Protocol) -> str | None:
    """Return "RTPS" or "Zenoh", whichever a model's messages use; None if both or neither."""
    names = {message.kind for message in protocol.messages}
    wires = (("RTPS", rtps.message_kinds()), ("Zenoh", zenoh_messages.MESSAGE_KINDS))
    protocols = [wire for wire, kinds in wires if names & set(kinds)]
    return protocols[0] if len(protocols) == 1 else None


def has_unexpected_multicast(protocol: Protocol, rows: DataFrame) -> bool:
    """Return whether a message is multicast that a model sends by unicast alone."""
    by_multicast = {m.kind for m in protocol.messages if m.cast == "multicast"}
    alone = {m.kind for m in protocol.messages} - by_multicast
    return bool(rows.loc[rows["multicast"], "kind"].isin(alone).any())


def captured_times(protocol: Protocol, messages: DataFrame) -> Any:
    """Return when messages of a model were captured [s]."""
    return messages["time"][messages["kind"].isin([message.kind for message in protocol.messages])]


def comparison_window(protocol: Protocol, messages: DataFrame, duration: float) -> float:
    """Return the time from the first message of a model to the end of the capture [s]."""
    times = captured_times(protocol, messages)
    if times.empty:
        return duration
    # Silence for half of the shortest period means that all hosts have left.
    silence = min(message.schedule.period for message in protocol.messages) / 2
    return min(duration, float(times.max()) + silence) - float(times.min())


def comparison_table(
    protocol: Protocol, shown: VisibleFleet, rows: DataFrame, wire: str | None, seconds: float
) -> DataFrame:
    """Return messages by kind, captured and as a model sends them: see `Capture.compare`.

    `wire` is the protocol of the messages to compare; None for all.
    """
    import pandas as pd

    if wire is not None:
        rows = rows[rows["protocol"].isin([wire, "TCP"] if wire == "Zenoh" else [wire])]
    counts = rows.groupby("kind", observed=True).agg(
        unicast=("multicast", lambda column: int((~column).sum())),
        multicast=("multicast", "sum"),
        bytes=("bytes", "sum"),
        airtime_s=("airtime_s", "sum"),
    )
    kinds = list(dict.fromkeys(message.kind for message in protocol.messages))
    others = [kind for kind in counts.index if kind not in kinds]
    table = counts.reindex(pd.Index([*kinds, *others], name="message")).fillna(0)
    # A capture without the kinds that are sent only at startup shows the steady state.
    again = {message.kind for message in protocol.messages if message.schedule.per_second}
    once = {*kinds} - again
    started = not again or not once or rows["kind"].isin(once).any()
    units = dict.fromkeys(others, np.nan)
    expected = dict(units)
    for message in protocol.messages:
        visible = shown.visible_units(message)
        units.setdefault(message.kind, visible)
        each = message.schedule
        times = np.asarray(each.sent(seconds)) if started else seconds * each.per_second
        sent = visible * message.per_unit * float(times)
        expected[message.kind] = expected.get(message.kind, 0.0) + sent
    table.insert(0, "units", pd.Series(units))
    table.insert(1, "expected", pd.Series(expected))
    total = table["unicast"] + table["multicast"]
    table.insert(4, "per_unit", total / table["units"].where(table["units"] > 0))
    integers = ["unicast", "multicast", "bytes"]
    return table.astype(dict.fromkeys(integers, np.int64) | {"airtime_s": np.float64})


def user_data_shares(rows: DataFrame) -> Array:
    """Return the share of user data in each message [1].

    For a TCP segment without a message it is the share among all messages between its two hosts.
    """
    kind, frame = rows["kind"].to_numpy(str), rows["frame"].to_numpy()
    users = np.isin(kind, _USER_DATA_KINDS)
    carriers = np.isin(kind, _CARRIER_KINDS) & np.isin(frame, frame[users])
    part = (users | carriers | np.char.startswith(kind, "User")).astype(np.float64)
    own = (rows["protocol"] == "TCP").to_numpy()
    if own.any():
        # An index for each pair of hosts, in either order.
        pairs = np.sort(rows[["sender", "receiver"]].to_numpy(str), axis=1)
        ends = np.unique(pairs, axis=0, return_inverse=True)[1].ravel()
        content = ~own & (rows["transport"] == "TCP").to_numpy()
        size = int(ends.max()) + 1
        weight = rows["frames"].to_numpy(np.float64)
        total = np.bincount(ends[content], weight[content], size)
        user_part = np.bincount(ends[content], weight[content] * part[content], size)
        part[own] = (user_part / np.where(total > 0, total, 1.0))[ends[own]]
    return part


def traffic_totals(rows: DataFrame, seconds: float) -> DataFrame:
    """Return totals of discovery and user data, given ``airtime_s``; see `Capture.sums`."""
    import pandas as pd

    part = user_data_shares(rows)
    shares = pd.DataFrame({"discovery": 1 - part, "user data": part}, index=rows.index)
    table = pd.DataFrame({"messages": shares.sum()}).rename_axis("what")
    for column in ("bytes", "airtime_s"):
        table[column] = shares.mul(rows[column], axis=0).sum()
    table["of_time"] = table["airtime_s"] / seconds if seconds > 0 else np.nan
    return table
