"""The observations that a diagnosis reads: columns of messages, with indices of processes."""

from collections import Counter
from collections.abc import Iterable, Set
from dataclasses import dataclass
from functools import cached_property
from ipaddress import ip_address
from typing import Any

import numpy as np

from discostorm_capture._types import Array, DataFrame
from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.dissection import Recording

#: The expected number of hosts, or their addresses; None if unknown.
ExpectedHosts = int | tuple[str, ...] | None
#: Kind, sender, receiver, port and time [s] of a network event.
EventRow = tuple[str, str, str, int, float]
#: Kinds of messages that search for others by multicast; kinds of SEDP.
MULTICAST_KINDS, SEDP, HEARTBEAT, ACKNACK = (("SPDP", "Scout"), "SEDP", "Heartbeat", "ACKNACK")
#: Kinds of messages with samples of topics, in DDS and in Zenoh.
SAMPLE_KINDS = ("User data", "Push")
#: Kinds of DDS Security: the handshake, the key exchange after it, and encrypted messages.
HANDSHAKE, NEW_KEYS, ENCRYPTED = "Authentication", "Encrypted key exchange", "Encrypted"


@dataclass(eq=False)
class Observations:
    """Messages between hosts and other tables, without duplicates and clock steps, by time."""

    messages: DataFrame
    processes: DataFrame
    network_events: DataFrame
    #: Hosts that run only servers.
    server_hosts: frozenset[str]
    recording: Recording
    endpoints: DataFrame
    expected_hosts: ExpectedHosts

    def __post_init__(self) -> None:
        processes, hosts = self.processes, set(self.messages["sender"].astype(str).unique())
        #: The only host whose unicast was captured, if any. Hosts without a process count, too.
        self.vantage_host = vantage_host(self.messages, processes, hosts, self.server_hosts)
        calls = self.links_of(self.events("connection", "half", "refused", "unanswered"))
        calls |= {pair for pair in self.links_of(self.events("other traffic")) if {*pair} <= hosts}
        main = main_addresses(processes)
        if any(self.vantage_host not in {main.get(end, end) for end in pair} for pair in calls):
            self.vantage_host = None
        #: For each message: time [s], sequence number, and the index of the sending and of the
        #: receiving process, -1 if unknown.
        self.time, self.seq = self["time"].astype(np.float64), self["number"].astype(np.int64)
        self.sender_index = self.indices_among("process", processes.index)
        self.receiver_index = self.indices_among("peer", processes.index)
        #: The time of the last message [s].
        self.end = float(self.time.max(initial=0.0))
        #: For each process: its address; whether it is a server or router; whether it speaks RTPS.
        self.process_host = processes["host"].to_numpy(object)
        self.is_server = processes["server"].to_numpy(bool)
        self.is_rtps = (processes["protocol"] == "RTPS").to_numpy()
        #: Processes that are servers or routers.
        self.servers = set(np.flatnonzero(self.is_server).tolist())
        #: Which messages exchange keys of DDS Security or are encrypted by them; its processes.
        self.uses_keys = self.isin("kind", NEW_KEYS, ENCRYPTED)
        self.secured_processes = self.senders(self.isin("kind", HANDSHAKE) | self.uses_keys)
        #: The addresses at which processes announce that they listen.
        self.announced_addresses = {*" ".join(processes["announces"]).split()}
        #: A number for the domain tag of each process; 0 without a tag.
        self.domain_tag = np.unique(["", *processes["tag"]], return_inverse=True)[1][1:]

    @staticmethod
    def links_of(table: DataFrame) -> set[tuple[str, str]]:
        """Return the pairs of sender and receiver in a table."""
        ends = table[["sender", "receiver"]].drop_duplicates().astype(str)
        return set(ends.itertuples(index=False, name=None))

    def __getitem__(self, column: str) -> Array:
        """Return a column of `messages`."""
        return self.messages[column].to_numpy()

    def indices_among(self, column: str, values: Any) -> Array:
        """Return for each message the index of its value in `values`, -1 if it is not there."""
        import pandas as pd

        words = self.messages[column].cat
        indices = pd.Index(values, dtype=object).get_indexer(words.categories.astype(object))
        return np.append(indices, -1)[words.codes.to_numpy()]

    def isin(self, column: str, *values: str) -> Array:
        """Return which messages have one of these values in a categorical column."""
        return self.indices_among(column, values) >= 0

    def events(self, *kinds: str) -> DataFrame:
        """Return the network events of these kinds."""
        return self.network_events[self.network_events["kind"].isin(kinds).to_numpy()]

    def event_tuples(self, *kinds: str) -> list[EventRow]:
        """Return kind, sender, receiver, port and time [s] of each event of these kinds."""
        return event_tuples(self.events(*kinds))

    def rows_by(self, mask: Array, *keys: Array) -> dict[tuple[int, ...], Array]:
        """Return the indices of a mask's rows, in order, grouped by the values of the keys."""
        rows = np.flatnonzero(mask)
        values = np.column_stack([key[rows] for key in keys]).astype(np.int64)
        order = np.lexsort(values.T[::-1])
        rows, values = rows[order], values[order]
        begins = np.append(0, np.flatnonzero(np.diff(values, axis=0).any(axis=1)) + 1)[: len(rows)]
        parts = np.split(rows, begins[1:])
        return {tuple(values[at].tolist()): part for at, part in zip(begins, parts, strict=False)}

    def senders(self, mask: Array) -> set[int]:
        """Return the processes that sent a message selected by the mask."""
        return set(np.unique(self.sender_index[mask]).tolist()) - {-1}

    def messages_between(self, process: int, to: int) -> Array:
        """Return which messages a process sent to another one, or by multicast."""
        there: Array = np.isin(self.receiver_index, (to, -1)) & (self.sender_index == process)
        there &= self.isin("receiver", self.process_host[to]) | self["multicast"]
        return there

    def first_sample_times(self, process: int, writer: int, to: int | None = None) -> Array:
        """Return when a process first sent each sample of a writer, to one process or any [s]."""
        data = self.isin("submessage", "DATA", "DATA_FRAG", "Push") & (self["writer"] == writer)
        data &= self.sender_index == process if to is None else self.messages_between(process, to)
        rows = np.flatnonzero(data)
        _, first = np.unique(self.seq[rows], return_index=True)
        return np.asarray(self.time[rows[first]])

    def hosts_of(self, processes: Iterable[int]) -> tuple[str, ...]:
        """Return the distinct addresses of processes, in order."""
        return tuple(dict.fromkeys(str(self.process_host[process]) for process in processes))

    def processes_by_host(self, processes: Iterable[int]) -> dict[str, list[int]]:
        """Return processes by address."""
        groups: dict[str, list[int]] = {}
        for process in processes:
            groups.setdefault(str(self.process_host[process]), []).append(process)
        return groups

    def sees_unicast(self, *hosts: str) -> bool:
        """Return whether the capture shows unicast between these hosts."""
        # What two hosts behind a repeater send each other, nobody else sees.
        near = any({*hosts} <= of for of in self.hosts_by_mac.values())
        return not near and (self.vantage_host is None or self.vantage_host in hosts)

    @cached_property
    def unanswered_arp(self) -> dict[tuple[str, str], list[float]]:
        """Times [s] of unanswered ARP requests, by sender and requested address."""
        answered = {(to, host) for host, to in self.links_of(self.events("ARP reply"))}
        times: dict[tuple[str, str], list[float]] = {}
        for _, asker, target, _, time in self.event_tuples("ARP request"):
            if (asker, target) not in answered:
                times.setdefault((asker, target), []).append(time)
        return times

    @cached_property
    def hosts_refused_by_all(self) -> set[str]:
        """Hosts that search for each other only at ports which all refuse."""
        ports: dict[tuple[str, str], list[int]] = {}
        for _, caller, called, port, _ in self.event_tuples("asked"):
            ports.setdefault((caller, called), []).append(port)
        refused = {row[1:4] for row in self.event_tuples("unreachable")}
        # ICMP is limited in rate, so only the first port of each host counts.
        vain = {ends for ends, asked in ports.items() if (*ends, min(asked)) in refused}
        searches = {ends for ends in vain if len(ports[ends]) >= LIMITS.port_search}
        vain = {ends for ends in searches if ends[::-1] in vain}
        return {caller for caller, _ in vain} - {caller for caller, _ in ports.keys() - vain}

    @cached_property
    def key_exchanges(self) -> set[tuple[int, int]]:
        """Pairs of processes of which the first sent the second its keys."""
        mask = self.isin("kind", NEW_KEYS) & (self.sender_index >= 0) & (self.receiver_index >= 0)
        ends = self.rows_by(mask, self.sender_index, self.receiver_index)
        return {(sender, receiver) for sender, receiver in ends}

    @cached_property
    def first_last(self) -> tuple[Array, Array]:
        """Times of the first and last message of each process [s]; inf and -inf if it sent none."""
        # The last element is for messages without a known process.
        first, last = (np.full(len(self.processes) + 1, time) for time in (np.inf, -np.inf))
        np.minimum.at(first, self.sender_index, self.time)
        np.maximum.at(last, self.sender_index, self.time)
        return first[:-1], last[:-1]

    @cached_property
    def host_first_last(self) -> dict[str, tuple[float, float]]:
        """Times of the first and last message of each host [s]."""
        times = self.messages.groupby("sender", observed=True)["time"].agg(["min", "max"])
        return {str(host): (first, last) for host, first, last in times.itertuples()}

    @cached_property
    def hosts_by_mac(self) -> dict[int, set[str]]:
        """The hosts that share a MAC address in ARP, as behind a repeater, by this address."""
        arp = self.events("ARP request", "ARP reply")
        # Skip addresses with several MACs: an access point may answer ARP for other hosts.
        proxied = arp.groupby("sender", observed=True)["port"].transform("nunique") > 1
        spoke = arp[arp["sender"].isin([*self.host_first_last]) & ~proxied].groupby("port")[
            "sender"
        ]
        hosts = {int(str(mac)): {*rows.astype(str)} for mac, rows in spoke}
        return {mac: of for mac, of in hosts.items() if len(of) > 1}

    @staticmethod
    def subnet_numbers(hosts: Iterable[str], bits: int = 24) -> Array:
        """Return a number for the subnet of each host, with a prefix of ``bits``; -1 for IPv6."""
        addresses = map(ip_address, hosts)
        return np.array([-1 if one.version == 6 else int(one) >> (32 - bits) for one in addresses])

    def subnet_neighbors(self, host: str, others: Iterable[str]) -> list[str]:
        """Return which of the other addresses are in the subnet of an IPv4 address."""
        own, *subnets = self.subnet_numbers([host, *others])
        return [one for one, subnet in zip(others, subnets, strict=True) if subnet == own >= 0]


def vantage_host(
    messages: DataFrame, processes: DataFrame, hosts: Set[str], server_hosts: Set[str]
) -> str | None:
    """Return the only host whose unicast was captured, if there are at least three hosts."""
    unicast = messages.loc[~messages["multicast"].to_numpy(bool), ["sender", "receiver"]]
    main, counts = main_addresses(processes), Counter[tuple[str, ...]]()
    sizes: dict[Any, int] = unicast.groupby([*unicast], observed=True).size().to_dict()
    for ends, count in sizes.items():
        counts[tuple(main.get(end, end) for end in ends)] += count
    # A switch that learns where a host is floods some frames to all ports, without the answers.
    few = LIMITS.max_flooded_share * len(unicast)
    pairs = [pair for pair, count in counts.items() if pair[::-1] in counts or count >= few]
    if len(hosts) < 3 or not pairs:
        return None
    # Servers do not count: all clients talk only to them.
    common = set.intersection(*map(set, pairs)) & hosts - server_hosts
    return common.pop() if len(common) == 1 else None


def main_addresses(processes: DataFrame) -> dict[str, str]:
    """Return the address from which a host sends, by those that it announces, as for a VPN."""
    known = zip(processes["host"].astype(str), processes["announces"].astype(str), strict=True)
    pairs = [(one, host) for host, text in known for one in text.split()]
    return {one: to for one, to in pairs if one.rpartition(".")[0] != to.rpartition(".")[0]}


def merge_addresses(messages: DataFrame, *tables: DataFrame) -> None:
    """Replace IPv6 addresses in tables by the IPv4 address of the same process, if it has one."""
    other = dict[str, str]()
    for process, hosts in messages.groupby("process", observed=True)["sender"].unique().items():
        ipv6 = [host for host in hosts if ":" in host]
        if process and len(hosts) == len(ipv6) + 1:
            other |= dict.fromkeys(ipv6, *({*hosts} - {*ipv6}))
    for table in (messages, *tables) if other else ():
        for column in {"sender", "receiver", "host"} & {*table}:
            kind: Any = table[column].dtype.name
            table[column] = table[column].astype(str).replace(other).astype(kind)


def remove_clock_steps(table: DataFrame, recording: Recording) -> DataFrame:
    """Return a table with times since the first packet, without the steps of the clock."""
    first_frames, seconds = np.array(recording.clock_steps, float).reshape(-1, 2).T
    before = np.append(0.0, np.cumsum(seconds))
    step = before[np.searchsorted(first_frames, table["frame"], side="right")]
    return table.assign(time=table["time"] - recording.first_packet_time - step)


def event_tuples(table: DataFrame) -> list[EventRow]:
    """Return the rows of a table of network events."""
    names = (table[column].astype(str).tolist() for column in ("kind", "sender", "receiver"))
    return [*zip(*names, table["port"].tolist(), table["time"].tolist(), strict=True)]
