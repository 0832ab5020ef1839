"""A capture: its messages, processes and fleet, their airtime, and comparison with a model."""

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
from discostorm_capture.dissection import PROTOCOLS, Recording
from discostorm_capture.pcap import CaptureError
from discostorm_capture.sentences import say

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from discostorm_capture.diagnosis.diagnose import Diagnosis


@dataclass(frozen=True, repr=False)
class Capture:
    """Captured discovery traffic, as `discostorm.read_capture` returns it.

    Parameters
    ----------
    path : str
        The file.
    packets : int
        Number of packets [1].
    start : float
        When its earliest packet was captured, in seconds since 1970 [s].
    duration : float
        Time from its earliest packet to its latest [s].
    notes : tuple of str
        What could not be read or counted, and why.
    _messages, _processes, _network_events, _endpoints : pandas.DataFrame
        See `messages`, `processes`, `endpoints` and the module `network_events`.
    _recording : Recording
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
    _recording: Recording

    def __repr__(self) -> str:
        size = f"{self.packets} packets, {self.duration:.6g} s, {len(self._messages)} messages"
        return f"Capture({self.path!r}, {size})"

    def messages(self) -> pd.DataFrame:
        """Return the messages, in the order of the frames that completed them.

        One row per message: ``time`` since the earliest packet [s]; ``frame``, the number of the
        packet, from 1 on; ``protocol``, "RTPS", "Zenoh", or "TCP" for segments without a message;
        ``kind``, its name in models; ``multicast``; ``bytes``, its share of the payload of UDP or
        TCP [B]; ``sender`` and ``receiver``, addresses; ``way``, "up" or "down" on Wi-Fi;
        ``process`` and ``peer``, its sending and receiving process, "" if unknown; ``submessage``,
        its name in RTPS or Zenoh; ``ends``, whether it withdraws an announcement or closes a
        connection; ``copy``, whether it repeats an earlier packet; ``transport``; ``frames``, its
        share of packets [1]. Samples of RTPS and rmw_zenoh have ``writer``, the id of an endpoint,
        and ``number``, their sequence number. Only RTPS has ``entity``, what the message concerns;
        the id of the ``reader``; the last ``number`` of a Heartbeat, and the first one that an
        ACKNACK requests; ``missing``, how many samples it requests
        (with Zenoh 1 if TCP never acknowledged the message); ``holes``, whether it has later
        samples, or, of a Heartbeat, whether it demands an answer; ``size``, octets to the next
        header [B].
        """
        return self._messages.copy()

    def processes(self) -> pd.DataFrame:
        """Return the captured processes, in the order in which they appeared.

        By ``process``, as in `messages`: ``protocol``; ``product``; ``host``, its address;
        ``endpoints``, the number that it announced (with rmw_zenoh its tokens); ``time``, when it
        was first seen [s]; ``server``, whether it announces itself as a Fast DDS Discovery Server
        or a Zenoh router.
        """
        return self._processes.copy()

    def endpoints(self) -> pd.DataFrame:
        """Return the endpoints of RTPS, as last announced, and those in tokens of rmw_zenoh.

        One row per endpoint: ``process``; ``entity``, its id; ``number``, the sequence number of
        its announcement, 0 with Zenoh; ``writer``, whether it is a writer; ``topic`` and ``type``,
        their names in DDS; the QoS that it offers or requests: ``reliability``, ``durability``,
        ``deadline`` [s], ``liveliness``, ``lease`` [s], ``ownership``, ``partitions``,
        ``destination_order``, ``presentation``, ``latency`` [s] and ``representations``;
        ``type_hash`` (ROS 2 Iron and later, else ""); ``transport``, the only one that it announces
        for data. If the announcement is truncated, all columns from ``writer`` on are missing.
        """
        return self._endpoints.copy()

    def servers(self) -> tuple[str, ...]:
        """Return the addresses of hosts that run only servers or routers, unless all hosts do.

        They count as wired to the access point if `wired` is left out. If all processes are Zenoh
        routers, the result is the hub of a star: all others connect to it, and it to none.
        """
        rows = self._processes[self._processes["host"] != ""]
        alone = rows.groupby("host", sort=False, observed=True)["server"].all()
        if not alone.all():
            return tuple(map(str, alone.index[alone]))
        events = self._network_events
        calls = events[(events["kind"] == "connection").to_numpy()].astype(str)
        hubs, callers = set(calls["receiver"]), set(calls["sender"])
        is_star = len(hubs) == 1 and len(callers) > 1 and {*alone.index} == hubs ^ callers
        return tuple(hubs) if is_star else ()

    def fleet(self, protocol: str | None = None, wired: Sequence[str] | None = None) -> Fleet:
        """Return the captured fleet: hosts, processes and the endpoints that they announced.

        `protocol`, "RTPS" or "Zenoh", selects its processes. `wired` has the addresses of all hosts
        that are wired to the access point, by default those of `servers`. Hosts with the same
        number of processes and mean number of endpoints form a group, wired or not. A wired host of
        `servers` is left out, because models of servers include it. A wireless one comes first, as
        in models of a server on a robot. Raises a CaptureError if there is no process, and a
        ValueError if `wired` has an address that the capture does not show.
        """
        on_wires, serving = self._wired_addresses(wired), set(self.servers())
        rows = self._processes
        if protocol is not None:
            _checks.choice("protocol", protocol, PROTOCOLS[:2])
            rows = rows[rows["protocol"] == protocol]
        rows = rows[(rows["host"] != "") & ~rows["host"].isin(serving & on_wires)]
        rows = rows.sort_values("host", key=lambda host: ~host.isin(serving), kind="stable")
        if not len(rows):
            what = "any process" if protocol is None else f"any {protocol} process"
            raise CaptureError(f"{self.path} contains no messages from {what}")
        by_host = rows.groupby("host", sort=False, observed=True)["endpoints"]
        like: dict[tuple[int, float, bool], list[str]] = {}
        for host, endpoints in by_host:
            alike = len(endpoints), float(endpoints.mean()), str(host) in on_wires
            like.setdefault(alike, []).append(str(host))
        groups = []
        for (some, each, by_wire), hosts in like.items():
            name = hosts[0] + f" and {len(hosts) - 1} more" * (len(hosts) > 1)
            name *= len(like) > 1
            groups.append(HostGroup(len(hosts), some, each, name, wired=by_wire))
        return Fleet(tuple(groups))

    def vantage_host(self) -> str | None:
        """Return the only host with captured unicast, servers aside; None below three hosts."""
        from discostorm_capture.diagnosis.observations import vantage_host

        hosts = set(self._processes["host"]) - {""}
        rows, processes = self._messages_without_shutdown(), self._processes
        return vantage_host(rows, processes, hosts, set(self.servers()))

    def airtime(self, wifi: AnyWifi = PAPER, wired: Sequence[str] | None = None) -> pd.Series:
        """Return the airtime of each message on a channel, uplink and downlink [s].

        A message pays for its share of its packets, with the headers of the paper's Table II. Hosts
        that are ``wired`` (`servers` if left out) use no uplink, and no downlink for unicast.
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
        # Compute each length once; rounding merges those that differ by shares of a packet.
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
        """Compare captured messages with those of a model.

        Duplicates, messages within one host and shutdown are left out. A capture without any of the
        messages that the model sends only at startup is compared with the steady state.

        `protocol` is the model or its name. If the capture shows multicast of messages that the
        model sends by unicast alone, its `Protocol.wired` is used. `fleet` is the sending fleet, by
        default the captured one, with the matches (and publishers of Zenoh) that its messages show.
        `wifi` and `wired` are those of `airtime` and `fleet`, with the same errors. `window` [s]
        begins with the first message of the model; by default it lasts until the capture ends.

        By ``message``, its kind, first those of the model, then others: ``units``, how many of its
        units (in its first row of the model) the capture shows [1]; ``expected``, messages that the
        model sends in `compared_seconds` [1]; ``unicast`` and ``multicast``, captured messages [1];
        ``per_unit``, captured messages per unit [1]; ``bytes``, their payload [B]; ``airtime_s``
        [s]. For messages that the model lacks, ``units`` and what follows from it are NaN.
        """
        protocol, wifi = as_protocol(protocol), as_wifi(wifi)
        wire = counts.wire_protocol(protocol)
        rows = self._messages_without_shutdown()
        seconds = self.compared_seconds(protocol, window)
        if window is not None:
            first = counts.captured_times(protocol, self._messages).min()
            rows = rows[rows["time"] <= first + seconds]
        if protocol.wired is not None and counts.has_unexpected_multicast(protocol, rows):
            protocol = protocol.wired
        if fleet is None:
            shown = self._visible_fleet(self.fleet(wire, wired))
            shown = counts.infer_unannounced(shown, protocol, rows)
        else:
            _checks.instance("fleet", fleet, Fleet)
            reject_symbols_and_cells(fleet)
            for group in fleet.groups:
                _checks.require_scalars(zip(COUNTS, group.counts(), strict=True))
            shown = self._visible_fleet(fleet)
        rows = rows.assign(airtime_s=self.airtime(wifi, wired))
        return counts.comparison_table(protocol, shown, rows, wire, seconds)

    def compared_seconds(self, protocol: AnyProtocol, window: float | None = None) -> float:
        """Return the time that `compare` covers, from the first message of the model on [s].

        It ends after `window`, with the capture, or when the hosts fall silent.
        """
        protocol = as_protocol(protocol)
        seconds = counts.comparison_window(protocol, self._messages, self.duration)
        if window is None:
            return seconds
        return min(seconds, _checks.number("window", window, _checks.MIN_SECONDS))

    def sums(self, wifi: AnyWifi = PAPER, wired: Sequence[str] | None = None) -> pd.DataFrame:
        """Return totals of discovery and of user data, without what `compare` leaves out.

        `wifi` and `wired` are those of `compare`. By ``what``, "discovery" and "user data":
        ``messages`` [1], a fraction where both share TCP segments; ``bytes``, their payload [B];
        ``airtime_s`` [s]; ``of_time``, airtime as a share of the duration [1].
        """
        rows = self._messages_without_shutdown().assign(airtime_s=self.airtime(wifi, wired))
        return counts.traffic_totals(rows, self.duration)

    def diagnosis(self, expected: int | Sequence[str] | None = None) -> Diagnosis:
        """Diagnose whether discovery is healthy, complete and settled, and if not, what is wrong.

        `expected` is the number of expected hosts, without those that run only servers, or the
        addresses of all expected hosts. Missing hosts are the first finding.
        """
        from discostorm_capture.diagnosis import observations
        from discostorm_capture.diagnosis.diagnose import diagnose
        from discostorm_capture.diagnosis.hosts import parse_expected_hosts

        hosts = parse_expected_hosts(expected)
        rows = self._messages_between_hosts()
        airtime = self.airtime().loc[rows.index]  # an empty table would get all rows
        rows = rows.assign(airtime_s=airtime, user=counts.user_data_shares(rows))
        messages = observations.remove_clock_steps(rows, self._recording)
        events = observations.remove_clock_steps(self._network_events, self._recording)
        if self._recording.clock_steps:
            messages = messages.sort_values("time", kind="stable")
        processes = self._processes[self._processes["host"] != ""].copy()
        serves = processes["host"].isin(self.servers())
        observations.merge_addresses(messages, processes, events)
        servers = frozenset(processes["host"][serves])
        given = self._recording, self._endpoints, hosts
        return diagnose(observations.Observations(messages, processes, events, servers, *given))

    def picture(self, wifi: AnyWifi = PAPER, wired: Sequence[str] | None = None) -> Figure:
        """Plot messages over time by kind, and below it their share of the channel.

        `wifi` and `wired` are those of `compare`. Raises a CaptureError if there is no message.
        """
        from discostorm_capture.capture_figure import plot_messages_and_airtime

        rows, wifi = self._messages_without_shutdown(), as_wifi(wifi)
        if rows.empty:
            raise CaptureError(f"{self.path} contains no messages to draw")
        channel = "the paper's channel" if wifi.name == PAPER.name else wifi.name
        return plot_messages_and_airtime(rows.assign(airtime_s=self.airtime(wifi, wired)), channel)

    def _wired_addresses(self, wired: Sequence[str] | None) -> set[str]:
        """Return the addresses of hosts wired to the access point, after checking them."""
        if wired is None:
            return set(self.servers())
        known = {*self._processes["host"], *self._messages["sender"].cat.categories} - {""}
        for address in _checks.tuple_of("wired", wired, str) if len(wired) else ():
            if address not in known:
                shown = ", ".join(sorted(known)[:3]) or "none"
                raise ValueError(say("wired", shown, address))
        return set(wired)

    def _messages_between_hosts(self) -> pd.DataFrame:
        """Return the messages between two hosts, without duplicates."""
        rows = self._messages
        here = rows["sender"].astype(str) == rows["receiver"].astype(str)
        own = rows["sender"].str.match(r"127\.|::1$") | rows["receiver"].str.match(r"127\.|::1$")
        return rows[~(rows["copy"] | here | own)]

    def _messages_without_shutdown(self) -> pd.DataFrame:
        """Return the messages between two hosts, without duplicates and shutdown."""
        rows = self._messages_between_hosts()
        return rows[~rows["ends"]]

    def _visible_fleet(self, fleet: Fleet) -> counts.VisibleFleet:
        """Return a fleet as far as the capture can show it."""
        if (view := self.vantage_host()) is None:
            return counts.VisibleFleet(fleet)
        return counts.fleet_visible_from(fleet, self._processes[self._processes["host"] == view])
