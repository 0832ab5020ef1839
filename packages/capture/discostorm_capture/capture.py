"""What a capture tells: its messages, processes and fleet, held against a protocol's table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from discostorm import _checks
from discostorm._numeric import evaluate
from discostorm.fleet import COUNTS, Fleet, HostGroup, reject_symbols_and_cells
from discostorm.lookup import AnyProtocol, AnyWifi, as_protocol, as_wifi
from discostorm.messages import header_bytes
from discostorm.wifi import PAPER, downlink_airtime, uplink_airtime
from discostorm_capture import compare as counts
from discostorm_capture.dissection import PROTOCOLS, RecordingQuality
from discostorm_capture.pcap import CaptureError

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from discostorm_capture.diagnosis.diagnose import Diagnosis


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
    _messages, _processes, _network_events : pandas.DataFrame
        The tables: see `messages`, `processes` and the module `network_events`.
    _endpoints : pandas.DataFrame
        See `endpoints`.
    _quality : Quality
        How it was recorded.
    """

    path: str
    packets: int
    start: float
    duration: float
    notes: tuple[str, ...]
    _messages: pd.DataFrame = field(compare=False)
    _processes: pd.DataFrame = field(compare=False)
    _network_events: pd.DataFrame = field(compare=False)
    _endpoints: pd.DataFrame = field(compare=False)
    _quality: RecordingQuality

    def __repr__(self) -> str:
        size = f"{self.packets} packets, {self.duration:.6g} s, {len(self._messages)} messages"
        return f"Capture({self.path!r}, {size})"

    def messages(self) -> pd.DataFrame:
        """Return the messages, in the order of the frames that completed them.

        One row a message: ``time`` since the earliest packet [s]; ``frame``, the number of the
        packet from 1 on; ``protocol``, "RTPS", "Zenoh" or, of TCP's own segments, "TCP"; ``kind``,
        as the tables of protocols call it; ``multicast``; ``bytes``, its part of the payload of UDP
        or TCP [B]; ``sender`` and ``receiver``, addresses; ``way``, "up" or "down" on Wi-Fi;
        ``process`` and ``peer``, whom it is from and to, "" if it does not say; ``submessage``, its
        name in the standard or in Zenoh. Of RTPS: ``entity``, what it is about; ``reader`` and
        ``writer``, their ids; ``number``, the sequence number of a sample, of the last one of a
        Heartbeat, or of the first that an ACKNACK lacks; ``missing``, how many it lacks (of Zenoh,
        1 if TCP never acknowledged it); ``holes``, whether it has later ones; ``size``, the octets
        to the next header [B]. Of all: ``ends``, whether it takes back an announcement or ends a
        connection; ``copy``, whether the capture shows it once more; ``transport``; ``frames``, its
        part of packets [1].
        """
        return self._messages.copy()

    def processes(self) -> pd.DataFrame:
        """Return the processes that were found, in the order in which they appeared.

        By ``process``, as the messages name them: ``protocol``, ``product``, ``host``, its address,
        ``endpoints``, how many it announced (of rmw_zenoh, its tokens), ``time``, when it was seen
        first [s], and ``server``, whether it says that it is a Discovery Server of Fast DDS or a
        router of Zenoh.
        """
        return self._processes.copy()

    def endpoints(self) -> pd.DataFrame:
        """Return the endpoints of RTPS, as announced last, and those that rmw_zenoh's tokens name.

        A row each: ``process`` and ``entity``, its id; ``number``, the sequence number of its
        announcement, 0 with Zenoh; ``writer``, whether it is a writer or a reader; ``topic`` and
        ``type``, by their names in DDS; what it offers or asks for: ``reliability``,
        ``durability``, ``deadline`` [s], ``liveliness``, ``lease`` [s], ``ownership``,
        ``partitions``, ``destination_order``, ``presentation``, ``latency`` [s] and
        ``representations``; ``type_hash``, of ROS 2 Iron and later, else "". From ``writer`` on all
        is missing if the announcement was cut or cannot be read.
        """
        return self._endpoints.copy()

    def servers(self) -> tuple[str, ...]:
        """Return the addresses of hosts with servers and routers alone, beside hosts without.

        These are taken for wired to the access point where `wired` is left out. Where all processes
        are routers of Zenoh, it is the hub of a star: all others connect to it, and it to none.
        """
        found = self._processes[self._processes["host"] != ""]
        alone = found.groupby("host", sort=False, observed=True)["server"].all()
        if not alone.all():
            return tuple(map(str, alone.index[alone]))
        events = self._network_events
        calls = events[(events["kind"] == "connection").to_numpy()].astype(str)
        hubs, callers = set(calls["receiver"]), set(calls["sender"])
        is_star = len(hubs) == 1 and len(callers) > 1 and {*alone.index} == hubs ^ callers
        return tuple(hubs) if is_star else ()

    def fleet(self, protocol: str | None = None, wired: Sequence[str] | None = None) -> Fleet:
        """Return the fleet that was found: hosts, processes and the endpoints they announced.

        Processes of a `protocol`, "RTPS" or "Zenoh", alone if it is given. `wired` has the
        addresses of all hosts that are wired to the access point, by default those of `servers`.
        Hosts with as many processes and, in the mean, endpoints are a group, wired or not. A wired
        host of `servers` is left out: models of servers have it already. One that is not wired
        comes first, as in models of a server on a robot. Without a process it raises a
        CaptureError, and a ValueError if `wired` has an address that the capture does not show.
        """
        on_wires, serving = self._wired_addresses(wired), set(self.servers())
        found = self._processes
        if protocol is not None:
            _checks.choice("protocol", protocol, PROTOCOLS[:2])
            found = found[found["protocol"] == protocol]
        found = found[(found["host"] != "") & ~found["host"].isin(serving & on_wires)]
        found = found.sort_values("host", key=lambda host: ~host.isin(serving), kind="stable")
        if not len(found):
            what = "of a process" if protocol is None else f"of a process of {protocol}"
            raise CaptureError(f"{self.path}: it contains no message {what}")
        by_host = found.groupby("host", sort=False, observed=True)["endpoints"]
        like: dict[tuple[int, float, bool], list[str]] = {}
        for host, endpoints in by_host:
            alike = len(endpoints), float(endpoints.mean()), str(host) in on_wires
            like.setdefault(alike, []).append(str(host))
        groups = [
            HostGroup(len(hosts), some, each, _group_name(hosts, len(like)), wired=by_wire)
            for (some, each, by_wire), hosts in like.items()
        ]
        return Fleet(tuple(groups))

    def vantage_host(self) -> str | None:
        """Return the host from or to which all unicast is, of at least three; no server counts."""
        from discostorm_capture.diagnosis.observations import vantage_host

        hosts = set(self._processes["host"]) - {""}
        return vantage_host(self._messages_without_shutdown(), hosts, set(self.servers()))

    def airtime(self, wifi: AnyWifi = PAPER, wired: Sequence[str] | None = None) -> pd.Series:
        """Return the airtime of each message on a channel, up and again down [s].

        A message has its part of its packets, with the headers of the paper's Table II. Nothing
        goes up from hosts that are ``wired`` (`servers` if left out), and no unicast down to them.
        """
        wifi = as_wifi(wifi)
        on_wires = self._wired_addresses(wired)
        import pandas as pd

        rows = self._messages
        frames = rows["frames"].to_numpy(np.float64)
        payload = rows["bytes"].to_numpy() / np.where(frames > 0, frames, np.inf)
        udp = (rows["transport"] == "UDP").to_numpy()
        headers = header_bytes()
        size = payload + np.where(udp, headers["UDP"], headers["TCP"])
        # Lengths repeat, and half a byte more or less is from sharing a packet.
        lengths, which = np.unique(np.round(size, 3), return_inverse=True)
        length, model = sp.Symbol("S"), wifi.model
        given: dict[Any, Any] = {length: lengths, **wifi.values()}
        up, multicast, unicast = (
            np.broadcast_to(evaluate(hop, given), lengths.shape)[which]
            for hop in (
                uplink_airtime(length, model),
                *(downlink_airtime(length, cast, model) for cast in ("multicast", "unicast")),
            )
        )
        down = np.where(rows["multicast"], multicast, unicast)
        goes_up, goes_down = (~rows[end].isin(on_wires) for end in ("sender", "receiver"))
        seconds = frames * (goes_up.to_numpy() * up + goes_down.to_numpy() * down)
        return pd.Series(seconds, index=rows.index, name="airtime_s")

    def compare(
        self,
        protocol: AnyProtocol,
        fleet: Fleet | None = None,
        wifi: AnyWifi = PAPER,
        wired: Sequence[str] | None = None,
        window: float | None = None,
    ) -> pd.DataFrame:
        """Hold what was captured against the table of a protocol.

        Left out are what the capture shows twice, what stays on one host, and shutdown. A capture
        without any message that the model sends at startup alone is one of the steady state.

        `protocol` is the model or its name: its `Protocol.wired` if the capture shows multicast of
        what the model sends by unicast alone. `fleet` sent; by default the captured one, with the
        matches, and of Zenoh the publishers, that its messages show. `wifi` and `wired` are those
        of `airtime` and `fleet`, whose errors it raises, too. `window` [s] counts so long from the
        first message of the model on; by default to the end of the capture.

        By ``message``, its kind, first those of the model, then others: ``units``, how many of its
        units the capture shows, of the first row of its kind [1]; ``expected``, how many messages
        the model sends in `compared_seconds` [1]; ``unicast`` and ``multicast``, how many were
        captured [1]; ``per_unit``, captured messages for each unit [1]; ``bytes``, their payload
        [B]; ``airtime_s`` [s]. Where the model has no such message, ``units`` and what follows from
        it are NaN.
        """
        protocol, wifi = as_protocol(protocol), as_wifi(wifi)
        wire = counts.wire_protocol(protocol)
        rows = self._messages_without_shutdown()
        seconds = self.compared_seconds(protocol, window)
        if window is not None:
            first = counts.model_message_times(protocol, self._messages).min()
            rows = rows[rows["time"] <= first + seconds]
        if protocol.wired is not None and counts.has_unexpected_multicast(protocol, rows):
            protocol = protocol.wired
        if fleet is None:
            shown = counts.infer_unannounced(
                self._visible_fleet(self.fleet(wire, wired)), protocol, rows
            )
        else:
            _checks.instance("fleet", fleet, Fleet)
            reject_symbols_and_cells(fleet)
            for group in fleet.groups:
                _checks.require_scalars(zip(COUNTS, group.counts(), strict=True))
            shown = self._visible_fleet(fleet)
        rows = rows.assign(airtime_s=self.airtime(wifi, wired))
        return counts.comparison_table(protocol, shown, rows, wire, seconds)

    def compared_seconds(self, protocol: AnyProtocol, window: float | None = None) -> float:
        """Return how long `compare` counts: from a model's first message on, at most `window` [s].

        It ends with the capture, or when the hosts fall silent.
        """
        protocol = as_protocol(protocol)
        seconds = counts.comparison_window(protocol, self._messages, self.duration)
        if window is None:
            return seconds
        return min(seconds, _checks.number("window", window, _checks.MIN_SECONDS))

    def sums(self, wifi: AnyWifi = PAPER, wired: Sequence[str] | None = None) -> pd.DataFrame:
        """Return what discovery and user data take, without what `compare` leaves out.

        `wifi` and `wired` are those of `compare`. By ``what``, "discovery" and "user data":
        ``messages`` [1], which are no whole numbers where both share segments of TCP; ``bytes``,
        their payload [B]; ``airtime_s`` [s]; and ``of_time``, its part of the duration [1].
        """
        rows = self._messages_without_shutdown().assign(airtime_s=self.airtime(wifi, wired))
        return counts.traffic_totals(rows, self.duration)

    def diagnosis(self, expected: int | Sequence[str] | None = None) -> Diagnosis:
        """Tell whether discovery is healthy, complete and over, and if not, what is wrong.

        `expected` says how many hosts ought to be there, without those of servers alone, or the
        addresses of all that ought to. Hosts that are missing are the first finding.
        """
        from discostorm_capture.diagnosis.diagnose import diagnose
        from discostorm_capture.diagnosis.hosts import parse_expected_hosts
        from discostorm_capture.diagnosis.observations import Observations, remove_clock_steps

        hosts = parse_expected_hosts(expected)
        messages, events = (
            remove_clock_steps(table, self._quality)
            for table in (self._messages_between_hosts(), self._network_events)
        )
        if self._quality.clock_steps:
            messages = messages.sort_values("time", kind="stable")
        processes = self._processes[self._processes["host"] != ""]
        servers = frozenset(self.servers())
        given = self._quality, self._endpoints, hosts
        return diagnose(Observations(messages, processes, events, servers, *given))

    def picture(self, wifi: AnyWifi = PAPER, wired: Sequence[str] | None = None) -> Figure:
        """Draw messages over time by kind, and below their share of the channel.

        `wifi` and `wired` are those of `compare`. Without a message it raises a CaptureError.
        """
        from discostorm_capture.capture_figure import plot_messages_and_airtime

        rows, wifi = self._messages_without_shutdown(), as_wifi(wifi)
        if rows.empty:
            raise CaptureError(f"{self.path}: it contains no message to draw")
        channel = "the paper's channel" if wifi.name == PAPER.name else wifi.name
        return plot_messages_and_airtime(rows.assign(airtime_s=self.airtime(wifi, wired)), channel)

    def _wired_addresses(self, wired: Sequence[str] | None) -> set[str]:
        """Return the addresses of hosts that are wired to the access point."""
        if wired is None:
            return set(self.servers())
        known = {*self._processes["host"], *self._messages["sender"].cat.categories} - {""}
        for address in _checks.tuple_of("wired", wired, str) if len(wired) else ():
            if address not in known:
                raise ValueError(
                    f"wired must have addresses that the capture shows, such as "
                    f"{', '.join(sorted(known)[:3]) or 'none'}; got {address!r}"
                )
        return set(wired)

    def _messages_between_hosts(self) -> pd.DataFrame:
        """Return the messages that go from host to host, once each."""
        rows = self._messages
        here = rows["sender"].astype(str) == rows["receiver"].astype(str)
        own = rows["sender"].str.match(r"127\.|::1$") | rows["receiver"].str.match(r"127\.|::1$")
        return rows[~(rows["copy"] | here | own)]

    def _messages_without_shutdown(self) -> pd.DataFrame:
        """Return the messages between hosts, without those of a shutdown."""
        rows = self._messages_between_hosts()
        return rows[~rows["ends"]]

    def _visible_fleet(self, fleet: Fleet) -> counts.VisibleFleet:
        """Return how much of a fleet the capture shows."""
        if (view := self.vantage_host()) is None:
            return counts.VisibleFleet(fleet)
        return counts.fleet_visible_from(fleet, self._processes[self._processes["host"] == view])


def _group_name(hosts: list[str], groups: int) -> str:
    if groups == 1:
        return ""
    more = f" and {len(hosts) - 1} more" if len(hosts) > 1 else ""
    return hosts[0] + more
