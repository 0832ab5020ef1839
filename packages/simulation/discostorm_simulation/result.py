"""Results of a simulation: numbers per run, tables, figures, JSON."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from discostorm import wording
from discostorm.files import json_ready
from discostorm.fleet import Fleet
from discostorm.lookup import as_wifi
from discostorm.messages import Protocol
from discostorm.wifi import Wifi
from discostorm.wifi.radio import TOPOLOGY
from discostorm_simulation.state import Floats, Ints

if TYPE_CHECKING:
    import pandas as pd

#: Causes of lost receptions. Prefix ``host``: at the sender; ``ap``: at the access point.
CAUSES = ("host_full", "host_age", "host_retry", "ap_full", "ap_age", "ap_retry", "on_air")
#: Counts of each run.
COUNTS = (
    *("expected", "arrived", *CAUSES, "waiting"),
    *("ppdus", "mpdus", "retried", "collisions", "collided", "requests", "expired"),
)
DIRECTIONS, QUEUES = ("up", "down", "failed"), ("time_s", "hosts", "access_point")
#: Quantiles of the pairs' times in JSON: every twentieth, from the first pair to the last.
QUANTILES = tuple(part / 20 for part in range(21))


class NoRecovery(ValueError):  # noqa: N818 - says what is wrong
    """Recovery of this protocol is not simulated, for the reason `why`; use ``recovery=False``."""

    def __init__(self, protocol: str, why: str) -> None:
        super().__init__(f"recovery must be False for the protocol {protocol!r}: {why}")
        self.why = why


def _channel_dicts(fleet: Fleet, wifi: Wifi) -> dict[str, Any]:
    """Return the channel, or the channel of each cell, for JSON."""

    def channel(of: Wifi) -> dict[str, Any]:
        assert of.radio is not None
        return {"wifi": of.name, "topology": TOPOLOGY, "radio": asdict(of.radio)}

    own = [
        {"name": cell.name, "channel": cell.channel} | channel(as_wifi(cell.wifi))
        for cell in fleet.cells
    ]
    return {"cells": own} if own else channel(wifi)


def _stack_runs(values: list[Any]) -> Any:
    """Stack the runs' values in an array; dictionaries become one dictionary of arrays."""
    if isinstance(values[0], dict):
        return {key: _stack_runs([value[key] for value in values]) for key in values[0]}
    return np.array(values)


def _are_equal(one: Any, other: Any) -> bool:
    """Return whether two values are equal; compare arrays element by element."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(_are_equal(one[key], other[key]) for key in one)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(_are_equal, one, other))
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=one.dtype.kind == "f")
    return bool(one == other)


@dataclass(frozen=True)
class Run:
    """Result of one run; `Simulation` combines the results of several runs."""

    starts: Floats
    drain_time: float
    lost: float
    lost_by_host: Floats
    convergence_time: float
    busy_time: float
    counts: dict[str, int]
    airtime: Floats
    queues: Floats
    pair_times: Floats
    transmissions: NDArray[np.void]
    data: dict[str, dict[str, float]] = field(default_factory=dict)


@dataclass(frozen=True, eq=False, repr=False)
class Simulation:
    """Result of `simulate`, with one value per run unless noted; equality compares all numbers.

    Parameters
    ----------
    fleet, protocol, wifi : Fleet, Protocol, Wifi
        The simulated hosts, their messages (with user data), and the channel, if no cells name it.
    settings : dict
        The other arguments of `simulate`; ``start`` is text if the starts were drawn. Keys with
        a unit: ``queue_frames``, ``queue_s``, ``until_s``. ``hosts`` is the number of hosts.
    starts : ndarray of shape (runs, hosts)
        Start of each host [s], in the order of the fleet's groups.
    drain_time : ndarray
        End of the burst's last transmission, repairs included [s]; infinity if not over.
    lost : ndarray
        Share of the frames that never arrived [1]. Multicast counts once per receiving host;
        with recovery, retransmitted frames count, too.
    lost_by_host : ndarray of shape (runs, hosts)
        Share of each host's frames that never arrived [1].
    convergence_time : ndarray
        Time at which every process knows every other process and all its endpoints [s];
        infinity if never. Without recovery: the drain time if no frame was lost.
    busy_time : ndarray
        Time during which at least one station sent [s].
    counts : dict of str to ndarray
        Counts [1]. Receptions: ``expected``, ``arrived``, ``waiting``, and losses by cause
        (``host_full``, ``host_age``, ``host_retry``: queue full, expired, retry limit; ``ap_*``
        at the access point; ``on_air``: multicast). Transmissions: ``ppdus``, ``mpdus``,
        ``retried`` MPDUs, ``collisions``, ``collided`` PPDUs, ``requests`` (BlockAckReq and
        ADDBA frames). ``expired``: leases.
    airtime : ndarray of shape (runs, messages + 1, 3)
        Airtime with acknowledgements, by message [s]: uplink, downlink, failed. Last: requests.
    queues : tuple of ndarray
        Per run, rows of time [s] and of queued frames at all hosts and the access point [1].
    pair_times : ndarray of shape (runs, pairs)
        Ascending times at which a process knew another one and its endpoints [s]; infinity if
        not by the end. Without recovery, the shape is (runs, 0).
    transmissions : ndarray
        First transmissions of the first run. Fields: ``start`` and ``end`` [100 ns], ``station``
        (access points last), ``kind`` (row of the message), ``frames`` [1], ``outcome``.
    data : dict of str to dict
        Values per topic until discovery is complete (without recovery, until the end). Keys:
        ``frames`` sent, ``arrived``, losses by cause as in `counts` [1]; ``delay_median_s``,
        ``delay_95_s`` and ``delay_most_s`` from creation of a sample to the arrival of its last
        frame [s], NaN if no frame arrived. Empty without user data.
    """

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    settings: dict[str, Any]
    starts: Floats
    drain_time: Floats
    lost: Floats
    lost_by_host: Floats
    convergence_time: Floats
    busy_time: Floats
    counts: dict[str, Ints]
    airtime: Floats
    queues: tuple[Floats, ...] = field(repr=False)
    pair_times: Floats = field(repr=False)
    transmissions: NDArray[np.void] = field(repr=False)
    data: dict[str, dict[str, Floats]] = field(default_factory=dict)

    @classmethod
    def of_runs(
        cls, fleet: Fleet, protocol: Protocol, wifi: Wifi, settings: dict[str, Any], runs: list[Run]
    ) -> Simulation:
        """Combine the results of several runs."""
        queues, transmissions = tuple(run.queues for run in runs), runs[0].transmissions
        found: dict[str, Any] = {"queues": queues, "transmissions": transmissions}
        for name in set(Run.__dataclass_fields__) - set(found):
            found[name] = _stack_runs([getattr(run, name) for run in runs])
        return cls(fleet, protocol, wifi, settings, **found)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Simulation):
            return NotImplemented
        return all(_are_equal(value, getattr(other, name)) for name, value in vars(self).items())

    def __hash__(self) -> int:
        return hash((self.fleet, self.protocol, self.wifi, self.drain_time.tobytes()))

    def __repr__(self) -> str:
        runs = wording.count_noun(self.drain_time.size, "run")
        channels = ", ".join(cell.name for cell in self.fleet.cells) or self.wifi.name
        drain, lost, known = map(np.median, (self.drain_time, self.lost, self.convergence_time))
        return (
            f"Simulation({self.protocol.name} on {channels}, {runs}; medians: drain_time "
            f"{drain:.4g} s, lost {lost:.4g}, convergence_time {known:.4g} s)"
        )

    def table(self) -> pd.DataFrame:
        """Return a table with one row per run: times, shares and all counts."""
        import pandas as pd

        times = {"drain_time_s": self.drain_time, "lost": self.lost}
        times |= {"convergence_time_s": self.convergence_time, "busy_time_s": self.busy_time}
        return pd.DataFrame(times | self.counts).rename_axis("run")

    def to_dict(self) -> dict[str, Any]:
        """Return the settings and all numbers per run as plain Python, for JSON.

        Infinity becomes None, and `pair_times` become quantiles. The channel, or that of each of
        ``cells``, is ``Radio(**radio).wifi()``. The first run's ``starts`` as ``start`` repeat it.
        """
        names = [*(message.name for message in self.protocol.messages), "block ACK request"]
        arrays = ("starts", "drain_time", "lost", "convergence_time", "busy_time", "lost_by_host")
        found = {
            "protocol": self.protocol.name,
            **_channel_dicts(self.fleet, self.wifi),
            "fleet": self.fleet.to_dicts(),
            "matching": self.fleet.matching,
            "settings": self.settings,
            **{name: getattr(self, name) for name in (*arrays, "counts")},
            "airtime": {
                name: dict(zip(DIRECTIONS, self.airtime[:, row].T, strict=True))
                for row, name in enumerate(names)
            },
            "queues": [dict(zip(QUEUES, run.T, strict=True)) for run in self.queues],
            "pair_times": self._pair_quantiles(),
        }
        plain: dict[str, Any] = json_ready(found | ({"data": self.data} if self.data else {}))
        return plain

    def _pair_quantiles(self) -> dict[str, Any]:
        """Return the number of pairs [1] and the quantiles of their times [s]."""
        pairs = self.pair_times.shape[1]
        if not pairs:
            return {"pairs": 0, "quantiles": [], "times": []}
        found = np.quantile(self.pair_times, QUANTILES, axis=1, method="higher").T
        return {"pairs": pairs, "quantiles": QUANTILES, "times": found}

    def to_json(self) -> str:
        """Return the result of `to_dict` as JSON."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False, allow_nan=False)
