"""What a capture tells: its messages, processes and fleet, held against a protocol's table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import lru_cache
from os import PathLike
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
import sympy as sp

from discostorm import _checks
from discostorm._numeric import evaluate
from discostorm.capture import gathered, ip, reader, rtps, zenoh
from discostorm.capture.pcap import CaptureError
from discostorm.capture.zenoh_reader import TCP_KINDS
from discostorm.fleet import COUNTS, Count, Fleet, HostGroup, reject_symbols
from discostorm.messages import (
    ENDPOINT_PAIR,
    MATCHED_WRITER,
    UNMATCHED,
    Message,
    Protocol,
    header_bytes,
)
from discostorm.wifi import PAPER, Cast, Wifi, downlink_airtime, uplink_airtime

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

NANOSECOND = 1e-9


@dataclass(frozen=True, repr=False)
class Capture:
    """Discovery traffic that was captured; `discostorm.read_capture` makes one.

    Parameters
    ----------
    path : str
        The file.
    packets : int
        How many packets it holds [1].
    start : float
        When its earliest packet was captured, in seconds since 1970 [s].
    duration : float
        Time from its earliest packet to its latest [s].
    notes : tuple of str
        What could not be read or counted, and why.
    _messages, _processes : pandas.DataFrame
        What `messages` and `processes` return copies of.
    """

    path: str
    packets: int
    start: float
    duration: float
    notes: tuple[str, ...]
    _messages: pd.DataFrame = field(compare=False)
    _processes: pd.DataFrame = field(compare=False)

    def __repr__(self) -> str:
        return (
            f"Capture({self.path!r}, {self.packets} packets, {self.duration:.6g} s, "
            f"{len(self._messages)} messages)"
        )

    def messages(self) -> pd.DataFrame:
        """Return the messages, in the order of the frames that completed them.

        Returns
        -------
        pandas.DataFrame
            One row a message: ``time`` since the earliest packet [s]; ``frame``, the number of
            the packet from 1 on; ``protocol``, "RTPS", "Zenoh" or, of TCP's own segments,
            "TCP"; ``kind``, as the tables of protocols call it; ``multicast``; ``bytes``, its
            part of the payload of UDP or TCP [B], so that they add up to it; ``sender`` and
            ``receiver``, addresses; ``way``, "up" or "down" if the capture is of a Wi-Fi
            network. Then ``process`` and ``peer``, whom it is from and to, "" if it does
            not say; ``submessage``, its name in the standard or in Zenoh; of RTPS, ``entity``,
            what its entities are about, ``reader`` and ``writer``, their ids, and ``size``,
            the octets to the next header [B]; ``ends``, whether it takes back what it is
            about, or ends a connection; ``copy``, whether the capture shows it once more;
            ``transport``; ``frames``, its part of packets [1].
        """
        return self._messages.copy()

    def processes(self) -> pd.DataFrame:
        """Return the processes that were found, in the order in which they appeared.

        Returns
        -------
        pandas.DataFrame
            By ``process``, as the messages name them: ``protocol``, ``product``, ``host``,
            its address, ``endpoints``, how many it announced, and ``time``, when it was seen
            first [s]. A publisher of Zenoh announces nothing; of rmw_zenoh the tokens are
            counted.
        """
        return self._processes.copy()

    def fleet(self, protocol: str | None = None) -> Fleet:
        """Return the fleet that was found: hosts, processes and the endpoints they announced.

        It is the whole fleet also from one robot's view, as everybody announces to everybody.

        Parameters
        ----------
        protocol : {"RTPS", "Zenoh"}, optional
            Take processes of that one only.

        Returns
        -------
        Fleet
            A group for the hosts with as many processes and, in the mean, endpoints.

        Raises
        ------
        CaptureError
            If no process was found.
        """
        if protocol is not None:
            _checks.choice("protocol", protocol, gathered.PROTOCOLS[:2])
        found = self._processes
        if protocol is not None:
            found = found[found["protocol"] == protocol]
        found = found[found["host"] != ""]
        if not len(found):
            what = "of a process" if protocol is None else f"of a process of {protocol}"
            raise CaptureError(f"{self.path}: there is no message {what} in it")
        by_host = found.groupby("host", sort=False, observed=True)["endpoints"]
        like: dict[tuple[int, float], list[str]] = {}
        for host, endpoints in by_host:
            like.setdefault((len(endpoints), float(endpoints.mean())), []).append(str(host))
        groups = [
            HostGroup(len(hosts), processes, endpoints, _group_name(hosts, len(like)))
            for (processes, endpoints), hosts in like.items()
        ]
        return Fleet(tuple(groups))

    def view(self) -> str | None:
        """Return the address of the host whose traffic alone was captured, if it is so.

        It is if there are at least three hosts, and all that is unicast is from or to that one.
        """
        hosts = set(self._processes["host"]) - {""}
        messages = self._on_air()
        unicast = messages[~messages["multicast"]]
        if len(hosts) < 3 or unicast.empty:
            return None
        pairs = unicast[["sender", "receiver"]].drop_duplicates().astype(str).to_numpy().tolist()
        common = set(pairs[0]).intersection(*map(set, pairs[1:])) & hosts
        return common.pop() if len(common) == 1 else None

    def airtime(self, wifi: Wifi = PAPER) -> pd.Series:
        """Return the airtime of each message on a channel, up and again down [s].

        A message has its part of that of the packets that carried it. A packet is a frame
        of its payload and the headers of the paper's Table II.
        """
        _checks.instance("wifi", wifi, Wifi)
        import pandas as pd

        rows = self._messages
        frames = rows["frames"].to_numpy(np.float64)
        payload = rows["bytes"].to_numpy() / np.where(frames > 0, frames, np.inf)
        udp = (rows["transport"] == "UDP").to_numpy()
        headers = header_bytes()
        size = payload + np.where(udp, headers["UDP"], headers["TCP"])
        # Lengths repeat, and half a byte more or less is from sharing a packet.
        lengths, which = np.unique(np.round(size, 3), return_inverse=True)
        each = {
            cast: np.broadcast_to(_airtime(lengths, cast, wifi), lengths.shape)[which]
            for cast in ("unicast", "multicast")
        }
        seconds = frames * np.where(rows["multicast"], each["multicast"], each["unicast"])
        return pd.Series(seconds, index=rows.index, name="airtime_s")

    def compare(
        self, protocol: Protocol, fleet: Fleet | None = None, wifi: Wifi = PAPER
    ) -> pd.DataFrame:
        """Hold what was captured against the table of a protocol.

        Left out are what the capture shows twice, what stays on one host, and what takes back
        an announcement or ends a connection (shutdown). A capture without any message that the
        table has for the start alone is taken for one of the steady state.

        Parameters
        ----------
        protocol : Protocol
            The table; messages are found by their kind. Where it has another table for networks
            that are taken for wired (`Protocol.wired`), that one is taken if the capture shows
            messages by multicast that the first has by unicast alone.
        fleet : Fleet, optional
            The fleet that sent; the one found in the capture if left out. How far its endpoints
            match is then told from the acknowledgements of user endpoints, and of Zenoh from how
            few key expressions are declared. Of Zenoh without tokens, which does not announce
            publishers, it has as many of them as the table takes it to have.
        wifi : Wifi, optional
            The channel to compute airtime for; the paper's if left out.

        Returns
        -------
        pandas.DataFrame
            By ``message``, its kind, first those of the table, then what else of RTPS or of Zenoh
            and its TCP was captured: ``units``,
            of how many of its units the capture shows the messages [1], where a kind has several
            rows in the table those of the first; ``expected``, how many
            messages these send from the first message in the capture to its end, or
            until nobody sends any more [1];
            ``unicast`` and ``multicast``, how many were captured [1]; ``per_unit``, captured
            messages for each unit [1]; ``bytes``, their payload [B]; ``airtime_s`` [s].
            Where the table has no such message, ``units`` and what follows from it are NaN.

        Raises
        ------
        TypeError
            If an argument is of another type.
        CaptureError
            If no fleet is given, and no process was found.
        """
        _checks.instance("protocol", protocol, Protocol)
        _checks.instance("wifi", wifi, Wifi)
        import pandas as pd

        wire = self._spoken(protocol)
        on_air = self._on_air()
        if protocol.wired is not None and self._as_if_wired(protocol, on_air):
            protocol = protocol.wired
        if fleet is None:
            seen = self._sending(self._seen(self.fleet(wire)), protocol, on_air)
        else:
            _checks.instance("fleet", fleet, Fleet)
            reject_symbols(fleet)
            for group in fleet.groups:
                _checks.one_each(zip(COUNTS, group.counts(), strict=True))
            seen = self._seen(fleet)
        rows = on_air.assign(airtime_s=self.airtime(wifi))
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
        window = self._window(protocol)
        started = self._started(protocol, rows)
        units = dict.fromkeys(others, np.nan)
        expected = dict(units)
        for message in protocol.messages:
            visible = seen.units(message)
            units.setdefault(message.kind, visible)
            if started:
                times = float(np.asarray(message.schedule.sent(window)))
            else:
                times = window * message.schedule.per_second
            sent = visible * message.per_unit * times
            expected[message.kind] = expected.get(message.kind, 0.0) + sent
        table.insert(0, "units", pd.Series(units))
        table.insert(1, "expected", pd.Series(expected))
        total = table["unicast"] + table["multicast"]
        table.insert(4, "per_unit", total / table["units"].where(table["units"] > 0))
        whole = ["unicast", "multicast", "bytes"]
        return table.astype(dict.fromkeys(whole, np.int64) | {"airtime_s": np.float64})

    def picture(self, wifi: Wifi = PAPER) -> Figure:
        """Draw messages over time, and their airtime against the channel.

        Parameters
        ----------
        wifi : Wifi, optional
            The channel to compute airtime for; the paper's if left out.

        Returns
        -------
        matplotlib.figure.Figure
            Above, how many messages of each kind there were in each of some tens of
            intervals; below, the part of the interval that they take on the channel.

        Raises
        ------
        CaptureError
            If there is no message.
        """
        from discostorm.capture.picture import draw

        rows = self._on_air()
        if rows.empty:
            raise CaptureError(f"{self.path}: there is no message in it to draw")
        channel = "the paper's channel" if wifi.name == PAPER.name else wifi.name
        return draw(rows.assign(airtime_s=self.airtime(wifi)), channel)

    def _on_air(self) -> pd.DataFrame:
        """Return the messages that go from host to host, once each."""
        rows = self._messages
        here = rows["sender"].astype(str) == rows["receiver"].astype(str)
        loop = _loopback_rows(rows["sender"]) | _loopback_rows(rows["receiver"])
        return rows[~(rows["copy"] | rows["ends"] | here | loop)]

    def _spoken(self, protocol: Protocol) -> str | None:
        """Return which protocol on the wire has the messages of a table."""
        names = {message.kind for message in protocol.messages}
        spoken = [
            wire
            for wire, kinds in (("RTPS", rtps.kind_names()), ("Zenoh", zenoh.KINDS))
            if names & set(kinds)
        ]
        return spoken[0] if len(spoken) == 1 else None

    def _window(self, protocol: Protocol) -> float:
        """Return the time from the first message of a table to the end of the capture [s]."""
        names = [message.kind for message in protocol.messages]
        mine = self._messages.loc[self._messages["kind"].isin(names), "time"]
        if mine.empty:
            return self.duration
        # Who is silent for longer than this is gone.
        periods = [m.schedule.period for m in protocol.messages]
        end = min(self.duration, float(mine.max()) + min(periods) / 2)
        return end - float(mine.min())

    def _started(self, protocol: Protocol, rows: pd.DataFrame) -> bool:
        """Return whether the capture shows what a table has for the start alone."""
        again = {m.kind for m in protocol.messages if m.schedule.per_second}
        once = {m.kind for m in protocol.messages} - again
        return not again or not once or bool(rows["kind"].isin(once).any())

    def _as_if_wired(self, protocol: Protocol, rows: pd.DataFrame) -> bool:
        """Return whether something is multicast that a table has by unicast alone."""
        by_multicast = {m.kind for m in protocol.messages if m.cast == "multicast"}
        alone = {m.kind for m in protocol.messages} - by_multicast
        return bool(rows.loc[rows["multicast"], "kind"].isin(alone).any())

    def _seen(self, fleet: Fleet) -> _Seen:
        """Return how much of a fleet the capture shows."""
        if (view := self.view()) is None:
            return _Seen(fleet)
        own = self._processes[self._processes["host"] == view]
        return _Seen(fleet, _host_like(fleet, own))

    def _sending(self, seen: _Seen, protocol: Protocol, rows: pd.DataFrame) -> _Seen:
        """Return the fleet that was found, with what it does not announce itself."""
        announced = sum(
            m.per_unit for m in protocol.messages if (m.kind, m.unit) == ("Declare", ENDPOINT_PAIR)
        )
        groups = seen.fleet.groups
        if 0 < announced < 1:
            groups = tuple(replace(g, endpoints=g.endpoints / announced) for g in groups)
        if announced > 1 and (pairs := seen.count(Fleet.pairs)) > 0:
            # A token for each endpoint and for the node.
            tokens = int((rows["submessage"] == "DeclareToken").sum()) / pairs - 1
            groups = tuple(replace(g, endpoints=max(g.endpoints, tokens)) for g in groups)
        seen = replace(seen, fleet=Fleet(groups))
        units = {message.unit for message in protocol.messages}
        if MATCHED_WRITER not in units:
            return seen
        none, all_ = (replace(seen, fleet=Fleet(groups, matching)) for matching in (0.0, 1.0))
        if UNMATCHED in units:
            # With every match one of two does not declare the key expression.
            kind = "Declare key expression"
            least, most = (
                sum(m.per_unit * of.units(m) for m in protocol.messages if m.kind == kind)
                for of in (all_, none)
            )
            saved, most = most - int((rows["kind"] == kind).sum()), most - least
        else:
            answers = rows[rows["kind"] == "User ACKNACK"]
            saved = len(answers[["process", "peer", "writer"]].drop_duplicates())
            most = all_.count(Fleet.matched_writers)
        share = min(1.0, max(0.0, saved / most)) if most > 0 else 0.0
        return replace(seen, fleet=Fleet(groups, share))


@dataclass(frozen=True)
class _Seen:
    """A fleet, and the number of the group whose one host alone shows its unicast, if any."""

    fleet: Fleet
    own: int | None = None

    def count(self, count: Callable[[Fleet], Count]) -> float:
        """Return how many of what a fleet has of something by unicast the capture shows."""
        every = float(count(self.fleet))
        if self.own is None:
            return every
        groups = list(self.fleet.groups)
        mine = groups.pop(self.own)
        if mine.hosts >= 2:
            groups.insert(self.own, replace(mine, hosts=mine.hosts - 1))
        if not groups:
            return every
        return every - float(count(Fleet(tuple(groups), self.fleet.matching)))

    def units(self, message: Message) -> float:
        """Return of how many units of a message the capture shows what they send."""
        if message.cast == "multicast":
            return float(message.unit.count(self.fleet))
        return self.count(message.unit.count)


def _host_like(fleet: Fleet, processes: pd.DataFrame) -> int:
    """Return the number of the group whose hosts are most like the one of these processes."""
    mean = float(processes["endpoints"].mean()) if len(processes) else 0.0
    unlike = [
        (abs(group.processes - len(processes)), abs(group.endpoints - mean))
        for group in fleet.groups
    ]
    return unlike.index(min(unlike))


def _group_name(hosts: list[str], groups: int) -> str:
    if groups == 1:
        return ""
    more = f" and {len(hosts) - 1} more" if len(hosts) > 1 else ""
    return hosts[0] + more


def _loopback_rows(addresses: pd.Series) -> pd.Series:
    loop = [name for name in addresses.cat.categories if name.startswith("127.") or name == "::1"]
    return addresses.isin(loop)


def _airtime(lengths: np.ndarray, cast: Cast, wifi: Wifi) -> Any:
    length = sp.Symbol("S")
    model = wifi.model
    expression = uplink_airtime(length, model) + downlink_airtime(length, cast, model)
    given: dict[Any, Any] = {length: lengths}
    return evaluate(expression, given | wifi.values())


def read_capture(path: str | PathLike[str] | BinaryIO) -> Capture:
    """Read a capture of discovery traffic.

    Parameters
    ----------
    path : str, path-like or binary file
        A file of tcpdump, Wireshark or dumpcap: pcap or pcapng, also as gz or xz; of Ethernet
        (also VLAN), Linux's "any" interface, loopback, raw IP or 802.11, with or without
        radiotap, also in PPPoE. It may hold other traffic as well. A pipe, or a file that is
        open, such as ``sys.stdin.buffer``, is read to its end.

    Returns
    -------
    Capture
        The messages of RTPS (version 2) and Zenoh (versions 8 and 9 on the wire) in it.

    Raises
    ------
    OSError
        If the file cannot be opened.
    CaptureError
        If it is no capture, is broken or ends inside of a packet; the message names the
        file and the place. It is a ValueError.
    TypeError
        If `path` is neither a path nor a file opened in binary mode.

    Examples
    --------
    >>> import discostorm as ds
    >>> capture = ds.read_capture("tests/captures/fast_dds.pcap.xz")
    >>> capture.fleet()
    Fleet(groups=(HostGroup(hosts=3, processes=2, endpoints=10),))
    >>> capture.compare(ds.DDS).loc["SEDP", "expected"]
    np.float64(240.0)
    """
    import pandas as pd

    found = reader.read(path)
    rows, time = found.rows, found.time
    addresses = ip.names(found.addresses)
    multicast = ip.multicast(found.addresses)
    processes = [process.name for process in found.processes]
    is_rtps = rows["protocol"] == gathered.RTPS
    is_tcp = rows["protocol"] == gathered.TCP
    # One list of names for all protocols; those of RTPS come first.
    kinds = [*rtps.kind_names(), *zenoh.KINDS, *TCP_KINDS]
    zenohs, tcps = len(kinds) - len(zenoh.KINDS) - len(TCP_KINDS), len(TCP_KINDS)
    kind = rows["kind"] + np.where(is_rtps, 0, np.where(is_tcp, len(kinds) - tcps, zenohs))
    submessages = [*rtps.submessage_names(), *zenoh.NAMES, *TCP_KINDS]
    submessage = rows["submessage"].astype(np.int64) + np.where(
        is_rtps, 0, np.where(is_tcp, 256 + len(zenoh.NAMES), 256)
    )
    entities = [*rtps.ENTITY_NAMES, ""]
    entity = np.where(is_rtps, rows["entity"], len(rtps.ENTITY_NAMES))
    # Clocks are set back, and files are merged.
    begin = int(time.min()) if len(time) else 0
    since = (time - begin) * NANOSECOND
    messages = pd.DataFrame(
        {
            "time": since[rows["frame"]],
            "frame": rows["frame"].astype(np.int64) + 1,
            "protocol": _words(rows["protocol"], gathered.PROTOCOLS),
            "kind": _words(kind, kinds),
            "multicast": multicast[rows["target"]] if len(multicast) else rows["copy"],
            "bytes": rows["bytes"],
            "sender": _words(rows["source"], addresses),
            "receiver": _words(rows["target"], addresses),
            "way": _words(rows["way"], reader.WAYS),
            "process": _words(rows["process"], [*processes, ""]),
            "peer": _words(rows["peer"], [*processes, ""]),
            "submessage": _words(submessage, submessages),
            "entity": _words(entity, entities),
            "reader": rows["reader"],
            "writer": rows["writer"],
            "size": rows["size"],
            "ends": rows["ends"],
            "copy": rows["copy"],
            "transport": _words(rows["udp"].astype(np.int64), ("TCP", "UDP")),
            "frames": rows["frames"],
        }
    )
    table = pd.DataFrame(
        {
            "protocol": [gathered.PROTOCOLS[process.protocol] for process in found.processes],
            "product": [process.product for process in found.processes],
            "host": [
                addresses[process.host] if process.host >= 0 else "" for process in found.processes
            ],
            "endpoints": [_endpoints(process) for process in found.processes],
            "time": [
                float(since[process.since]) if process.since >= 0 else np.nan
                for process in found.processes
            ],
        },
        index=pd.Index(processes, name="process", dtype=object),
    )
    return Capture(
        path=found.name,
        packets=found.packets,
        start=begin * NANOSECOND,
        duration=float(since.max()) if len(time) else 0.0,
        notes=_notes(found, messages),
        _messages=messages,
        _processes=table,
    )


def _words(codes: np.ndarray, names: Any) -> Any:
    """Return names by their numbers, -1 for the last one; only those used are kept."""
    import pandas as pd

    known, of_name = _numbered(tuple(names))
    codes = of_name[codes]
    used = np.bincount(codes, minlength=len(known)) > 0
    new = np.cumsum(used) - 1
    kept = _categories(tuple(known[index] for index in np.flatnonzero(used)))
    smallest: Any = np.int8 if len(kept.categories) < 128 else np.int32
    return pd.Categorical.from_codes(new[codes].astype(smallest), dtype=kept)


@lru_cache(maxsize=16)
def _categories(names: tuple[str, ...]) -> pd.CategoricalDtype:
    """Return the names as pandas wants them; it takes longer for these than for a few packets."""
    import pandas as pd

    return pd.CategoricalDtype(list(names))


@lru_cache(maxsize=16)
def _numbered(names: tuple[str, ...]) -> tuple[tuple[str, ...], np.ndarray]:
    """Return each name once, and which of these each is."""
    known = {name: index for index, name in enumerate(dict.fromkeys(names))}
    return tuple(known), np.array([known[name] for name in names], np.int64)


def _endpoints(process: gathered.Process) -> int:
    """Return how many endpoints a process announced, without those of discovery itself."""
    if process.protocol == gathered.ZENOH:
        return process.tokens or len(process.endpoints)
    return sum(1 for id_ in process.endpoints if not id_ & 0xC0)


def _notes(found: reader.Reading, messages: pd.DataFrame) -> tuple[str, ...]:
    notes = []
    if found.cut:
        notes.append(
            f"{found.cut} of {found.packets} packets were cut when they were captured (snaplen): "
            "what they held is missing, counts are lower bounds"
        )
    counts: Counter[str] = found.notes
    notes += [f"{count} {what}" for what, count in counts.items()]
    if encrypted := int((messages["kind"] == "Encrypted").sum()):
        notes.append(f"{encrypted} messages of RTPS encrypted by DDS Security: of unknown kind")
    silent = [process for process in found.processes if not process.announced]
    if silent:
        notes.append(
            f"{len(silent)} of {len(found.processes)} processes of which no announcement was "
            "captured: their endpoints are not known"
        )
    if any(p.protocol == gathered.ZENOH and p.endpoints and not p.tokens for p in found.processes):
        notes.append(
            "Zenoh does not announce publishers: its endpoints are subscribers and queryables alone"
        )
    return tuple(notes)
