"""What a simulation found: numbers a run, tables, pictures, JSON."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from discostorm import words
from discostorm.files import json_ready
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.wifi import Wifi
from discostorm.wifi.radio import TOPOLOGY

if TYPE_CHECKING:
    import pandas as pd

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

#: What becomes of receptions besides arriving; host: at the sender, ap: at the access point.
CAUSES = ("host_full", "host_age", "host_retry", "ap_full", "ap_age", "ap_retry", "on_air")
#: What is counted in each run.
COUNTS = (
    *("expected", "arrived", *CAUSES, "waiting"),
    *("ppdus", "mpdus", "retried", "collisions", "collided", "requests", "expired"),
)
#: What `Simulation` has as one array of all runs.
SIDE_BY_SIDE = (
    *("starts", "drain_time", "lost", "lost_by_host", "convergence_time", "busy_time"),
    *("airtime", "pair_times"),
)
DIRECTIONS, QUEUES = ("up", "down", "failed"), ("time_s", "hosts", "access_point")
#: Which quantiles of the pairs' times JSON has: each twentieth, from the first to the last pair's.
QUANTILES = tuple(part / 20 for part in range(21))


class NoRecovery(ValueError):  # noqa: N818 - says what is wrong
    """The recovery of a protocol is not simulated, as `why` says: it needs ``recovery=False``."""

    def __init__(self, protocol: str, why: str) -> None:
        super().__init__(f"recovery must be False for the protocol {protocol!r}: {why}")
        self.why = why


def _same(one: Any, other: Any) -> bool:
    """Return whether two are equal, number by number if they hold arrays."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(_same(one[key], other[key]) for key in one)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=one.dtype.kind == "f")
    return bool(one == other)


@dataclass(frozen=True)
class Run:
    """What one run found; `Simulation` has them side by side."""

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
    """What `simulate` found, one value a run unless it says otherwise; equal if all numbers are.

    Parameters
    ----------
    fleet, protocol, wifi : Fleet, Protocol, Wifi
        Who was on the channel, what they sent, user data included, and the channel.
    settings : dict
        The other arguments of `simulate`, ``start`` in words if it was drawn; ``queue_frames``,
        ``queue_s`` and ``until_s`` have a unit; and ``hosts``, how many there were.
    starts : ndarray of shape (runs, hosts)
        When each host started [s], in the order of the fleet's groups.
    drain_time : ndarray
        End of the last transmission of the burst, with repairs [s]; infinity if it is not over.
    lost : ndarray
        The part of the frames that never arrived [1], multicast counted once for each host that
        was to receive it; with recovery repeated frames count, too.
    lost_by_host : ndarray of shape (runs, hosts)
        The same part of the frames of each host [1].
    convergence_time : ndarray
        When every process first knew every other one and all its endpoints [s]; infinity if
        never. Without recovery it is the drain time if nothing was lost.
    busy_time : ndarray
        How long at least one station sent [s].
    counts : dict of str to ndarray
        How many [1]: receptions ``expected``, ``arrived``, lost by cause (``host_full``,
        ``host_age``, ``host_retry``: queue full, too old, retry limit; ``ap_*`` at the access
        point; ``on_air``: multicast) and ``waiting``; ``ppdus``, the ``mpdus`` in them, those
        ``retried``; ``collisions``, PPDUs ``collided``; ``requests`` for block acknowledgements
        and agreements on them; ``expired`` leases.
    airtime : ndarray of shape (runs, messages + 1, 3)
        By message, the last row for requests, with acknowledgements: up, down, and failed [s].
    queues : tuple of ndarray
        A run's rows of time [s], and frames waiting at all hosts and at the access point [1].
    pair_times : ndarray of shape (runs, pairs)
        Since when each process has all of each other one, ascending [s]; infinity for those that
        at the end have not. Without recovery of shape (runs, 0).
    transmissions : ndarray
        The first transmissions of the first run: ``start`` and ``end`` [100 ns], ``station`` (the
        access point last), ``kind`` (the row of the message), ``frames`` [1] and ``outcome``.
    data : dict of str to dict
        Of each topic until discovery was complete, without recovery until the end: ``frames``
        sent, of these ``arrived``, and those lost by cause as in `counts` [1];
        ``delay_median_s``, ``delay_95_s`` and ``delay_most_s`` from a sample's making to the
        arrival of its last frame [s], NaN if none arrived. Empty without user data.
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
        """Return the runs side by side."""
        side_by_side = {n: np.array([getattr(run, n) for run in runs]) for n in SIDE_BY_SIDE}
        return cls(
            fleet,
            protocol,
            wifi,
            settings,
            **side_by_side,
            counts={name: np.array([run.counts[name] for run in runs]) for name in COUNTS},
            queues=tuple(run.queues for run in runs),
            transmissions=runs[0].transmissions,
            data={
                topic: {name: np.array([run.data[topic][name] for run in runs]) for name in found}
                for topic, found in runs[0].data.items()
            },
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Simulation):
            return NotImplemented
        return all(_same(value, getattr(other, name)) for name, value in vars(self).items())

    def __hash__(self) -> int:
        return hash((self.fleet, self.protocol, self.wifi, self.drain_time.tobytes()))

    def __repr__(self) -> str:
        runs = words.count_noun(self.drain_time.size, "run")
        drain, lost, known = map(np.median, (self.drain_time, self.lost, self.convergence_time))
        return (
            f"Simulation({self.protocol.name} on {self.wifi.name}, {runs}; medians: drain_time "
            f"{drain:.4g} s, lost {lost:.4g}, convergence_time {known:.4g} s)"
        )

    def table(self) -> pd.DataFrame:
        """Return one row a run: the three times and parts, and all counts."""
        import pandas as pd

        times = {"drain_time_s": self.drain_time, "lost": self.lost}
        times |= {"convergence_time_s": self.convergence_time, "busy_time_s": self.busy_time}
        return pd.DataFrame(times | self.counts).rename_axis("run")

    def to_dict(self) -> dict[str, Any]:
        """Return what was simulated and all numbers a run as plain Python, for JSON.

        Infinity is None; `pair_times` are quantiles; the channel is ``Radio(**radio).wifi()``. A
        run with the ``starts`` of the first one as its ``start`` repeats that.
        """
        assert self.wifi.radio is not None
        names = [*(message.name for message in self.protocol.messages), "block ACK request"]
        data = {
            topic: {name: json_ready(values.tolist()) for name, values in found.items()}
            for topic, found in self.data.items()
        }
        return {
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "topology": TOPOLOGY,
            "radio": asdict(self.wifi.radio),
            "fleet": self.fleet.to_dicts(),
            "matching": self.fleet.matching,
            "settings": json_ready(self.settings),
            "starts": self.starts.tolist(),
            **{
                name: json_ready(getattr(self, name).tolist())
                for name in ("drain_time", "lost", "convergence_time", "busy_time", "lost_by_host")
            },
            "counts": {name: values.tolist() for name, values in self.counts.items()},
            "airtime": {
                name: dict(zip(DIRECTIONS, self.airtime[:, row].T.tolist(), strict=True))
                for row, name in enumerate(names)
            },
            "queues": [dict(zip(QUEUES, run.T.tolist(), strict=True)) for run in self.queues],
            "pair_times": self._pair_quantiles(),
        } | ({"data": data} if data else {})

    def _pair_quantiles(self) -> dict[str, Any]:
        """Return the number of pairs [1], and quantiles of their times that are such times [s]."""
        pairs = self.pair_times.shape[1]
        if not pairs:
            return {"pairs": 0, "quantiles": [], "times": []}
        found = np.quantile(self.pair_times, QUANTILES, axis=1, method="higher").T.tolist()
        return {"pairs": pairs, "quantiles": list(QUANTILES), "times": json_ready(found)}

    def to_json(self) -> str:
        """Return `to_dict` as JSON."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False, allow_nan=False)
