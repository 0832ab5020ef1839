"""What a capture shows, as the diagnosis reads it: rows of messages with numbers for names."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from discostorm_capture._bytes import Array

if TYPE_CHECKING:
    import pandas as pd

#: Of RTPS what SEDP's messages are called: samples, Heartbeats, acknowledgements.
DATA, HEARTBEAT, ACKNACK = "SEDP", "Heartbeat", "ACKNACK"
#: Of DDS Security: the handshake, the keys that follow it, and what these encrypt.
HANDSHAKE, KEYS, ENCRYPTED = "Authentication", "Encrypted key exchange", "Encrypted"
SECURED = (HANDSHAKE, KEYS, ENCRYPTED)


@dataclass(frozen=True)
class Seen:
    """What a capture shows.

    Parameters
    ----------
    rows : pandas.DataFrame
        The messages between hosts, once each, as `Capture.messages` has them; their ``time`` is
        without jumps of the clock, and they are in its order.
    processes, asides : pandas.DataFrame
        As `Capture` has them, with such times.
    duration : float
        From the first packet to the last [s], without jumps of the clock.
    view : str or None
        The host whose unicast alone was captured.
    serving : frozenset of str
        Hosts with nothing but servers.
    others : dict of str to int
        How many packets there are of what is no message: of "ARP", "TCP", "UDP", "other".
    jumps : tuple of tuple
        See `Capture`.
    lost : tuple of str
        What the capture itself says that it lacks: cut packets, fragments that are missing.
    cut : float
        The share of its packets that were cut [1].
    """

    rows: pd.DataFrame
    processes: pd.DataFrame
    asides: pd.DataFrame
    duration: float
    view: str | None
    serving: frozenset[str]
    others: dict[str, int]
    jumps: tuple[tuple[int, float], ...]
    lost: tuple[str, ...]
    cut: float

    @cached_property
    def time(self) -> Array:
        """When each message was captured [s]."""
        return self.rows["time"].to_numpy(np.float64)

    @cached_property
    def process(self) -> Array:
        """The place of each message's sender among the processes, -1 if it does not say."""
        return self._places("process")

    @cached_property
    def peer(self) -> Array:
        """The place of each message's receiver among the processes, -1 if it does not say."""
        return self._places("peer")

    def _places(self, column: str) -> Array:
        words = self.rows[column].cat
        places = self.processes.index.get_indexer(words.categories)
        found: Array = (
            places[words.codes.to_numpy()] if len(places) else np.full(len(self.rows), -1)
        )
        return found

    @cached_property
    def host(self) -> Array:
        """The address of each process."""
        return self.processes["host"].to_numpy(object)

    def of(self, column: str, *values: str) -> Array:
        """Return which messages have one of these values in a column of words."""
        words = self.rows[column].cat
        wanted = np.isin(words.categories.to_numpy(object), values)
        found: Array = (
            wanted[words.codes.to_numpy()] if len(wanted) else np.zeros(len(self.rows), bool)
        )
        return found

    @cached_property
    def multicast(self) -> Array:
        """Which messages are multicast."""
        return self.rows["multicast"].to_numpy(bool)

    @cached_property
    def number(self) -> Array:
        """The sequence number of each message."""
        return self.rows["number"].to_numpy(np.int64)

    @cached_property
    def missing(self) -> Array:
        """How many samples each message says that it lacks."""
        return self.rows["missing"].to_numpy(np.int64)

    @cached_property
    def keyed(self) -> frozenset[tuple[int, int]]:
        """Which process told which other one its keys."""
        told = self.of("kind", KEYS) & (self.process >= 0) & (self.peer >= 0)
        ends = np.unique(np.column_stack((self.process[told], self.peer[told])), axis=0)
        return frozenset((one, other) for one, other in ends.tolist())

    @cached_property
    def secured(self) -> frozenset[int]:
        """Which processes use DDS Security."""
        return frozenset(np.unique(self.process[self.of("kind", *SECURED)]).tolist()) - {-1}

    @cached_property
    def life(self) -> tuple[Array, Array]:
        """When each process was heard first and last [s]; infinite if it never spoke."""
        first = np.full(len(self.processes), np.inf)
        last = np.full(len(self.processes), -np.inf)
        spoke = self.process >= 0
        np.minimum.at(first, self.process[spoke], self.time[spoke])
        np.maximum.at(last, self.process[spoke], self.time[spoke])
        return first, last

    @cached_property
    def host_life(self) -> dict[str, tuple[float, float]]:
        """When each host was heard first and last [s]."""
        times = self.rows.groupby("sender", observed=True)["time"].agg(["min", "max"])
        return {str(host): (low, high) for host, low, high in times.itertuples()}

    def alone(self, kinds: tuple[str, ...]) -> bool:
        """Return whether all that was captured are messages of these kinds."""
        return not sum(self.others.values()) and bool(self.of("kind", *kinds).all())


def view_of(rows: pd.DataFrame, serving: frozenset[str]) -> str | None:
    """Return the host whose unicast alone was captured, if there are at least three hosts.

    As `Capture.view`; hosts that only look for others count, too.
    """
    hosts = set(rows["sender"].astype(str).unique())
    unicast = rows[~rows["multicast"].to_numpy(bool)]
    ends = unicast[["sender", "receiver"]].drop_duplicates().astype(str)
    pairs = [set(pair) for pair in ends.itertuples(index=False, name=None)]
    if len(hosts) < 3 or not pairs:
        return None
    common = set.intersection(*pairs) & hosts - serving
    return common.pop() if len(common) == 1 else None


def without_jumps(
    times: Array, frames: Array, jumps: tuple[tuple[int, float], ...], start: float
) -> Array:
    """Return times since the first packet, as if the clock had not jumped.

    A jump takes no time itself. The clock read ``start`` [s] when the first packet came.
    """
    if not jumps:
        return times - start
    where, steps = np.array(jumps).T
    before = np.append(0.0, np.cumsum(steps))
    found: Array = times - start - before[np.searchsorted(where, frames, side="right")]
    return found
