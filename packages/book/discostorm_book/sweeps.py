"""Stored sweeps for the chapters: simulated results, and those of ns-3."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import pandas as pd

from discostorm.data import data_path
from discostorm.fleet import Fleet
from discostorm.model import utilization
from discostorm.protocols import PROTOCOLS
from discostorm.wifi import Radio, Wifi

#: Processes of a robot and endpoints of each, in the sweeps.
SWARM = (2, 10)


def load_sweep(name: str, folder: str = "simulated") -> pd.DataFrame:
    """Return a stored sweep, such as ``convergence``; those of ns-3 are in ``measured``."""
    return pd.read_csv(data_path(f"{folder}/{name}.csv", "discostorm_book"))


def sweep_channel(mpdus: int = 1) -> Wifi:
    """Return the channel of the sweeps: 802.11n, two streams, 20 MHz, best effort."""
    return Radio("802.11n", streams=2, aifsn=3, mpdus=mpdus).wifi()


def robots_with_user_data(image_hz: float) -> Fleet:
    """Return robots that also send user data, with that rate of their largest topic [Hz]."""
    fleet = Fleet.from_toml(data_path("fleets/mixed_data.toml"))
    (robots,) = fleet.groups
    data = tuple(replace(f, rate=image_hz) if f.topic == "image" else f for f in robots.data)
    return replace(fleet, groups=(replace(robots, data=data),))


def burst_airtimes(rows: pd.DataFrame, channels: Mapping[int, Wifi] | None = None) -> pd.Series:
    """Return the airtime of each row's burst by the formula [s], by default on `sweep_channel`."""
    channels = channels or {mpdus: sweep_channel(mpdus) for mpdus in rows["mpdus"].unique()}
    columns = zip(rows["protocol"], rows["hosts"], rows["mpdus"], strict=True)
    seconds = [
        utilization(PROTOCOLS[str(protocol)], int(hosts), *SWARM, channels[int(mpdus)])
        for protocol, hosts, mpdus in columns
    ]
    return pd.Series(seconds, rows.index, dtype=float)


def drain_times() -> pd.DataFrame:
    """Return drain times without limits of the queues, by simulation, formula and ns-3 [s]."""
    # With aggregation ns-3 has Zenoh only, with stations that were just switched on as here.
    rows = load_sweep("drain")
    rows["formula_s"] = burst_airtimes(rows)
    alone = load_sweep("ns3_bursts", "measured").query("scenario == 'unlimited' and ampdu == 0")
    others = load_sweep("ns3_agreements", "measured")
    cold = others.query("scenario == 'cold' and queue_frames == 0")
    ns3 = _with_mpdus(pd.concat([alone, cold]))
    keys = ["protocol", "hosts", "mpdus"]
    ns3 = ns3[[*keys, "drain_time_s", "runs"]].rename(columns={"drain_time_s": "ns3_s"})
    rows = rows.merge(ns3, on=keys, suffixes=("", "_ns3"), how="left")
    rows["ratio"] = rows["drain_time_s"] / rows["formula_s"]
    rows["ratio_ns3"] = rows["ns3_s"] / rows["formula_s"]
    return rows


def losses_compared_with_ns3() -> pd.DataFrame:
    """Return deliveries lost with limited queues, ours and those of ns-3, and the difference."""
    theirs = load_sweep("ns3_bursts", "measured")
    theirs = _with_mpdus(theirs[theirs["scenario"].isin(["queue", "short_queue", "errors"])])
    keys = ["protocol", "hosts", "mpdus", "queue_frames", "loss"]
    rows = load_sweep("beside_ns3").merge(theirs, on=keys, suffixes=("", "_ns3"))
    rows["points"] = 100 * (rows["lost"] - rows["lost_ns3"])
    # Errors of medians are from quartiles, as if the runs were normal.
    variances = [
        (1.2533 * 100 * (rows[f"lost_q75{of}"] - rows[f"lost_q25{of}"]) / 1.349) ** 2
        / rows[f"runs{of}"]
        for of in ("", "_ns3")
    ]
    rows["error"] = np.sqrt(sum(variances))
    return rows


def mean_and_error(rows: pd.DataFrame) -> tuple[float, float]:
    """Return the mean of some differences and its standard error [points]."""
    error = np.sqrt((rows["error"] ** 2).sum()) / len(rows)
    return float(rows["points"].mean()), float(error)


def ns3_capture_losses() -> pd.DataFrame:
    """Return the losses of ns-3 with hosts on a disc, with the share of multicast."""
    rows = _with_mpdus(load_sweep("ns3_capture", "measured"))
    many = rows["hosts"] * (rows["hosts"] - 1) * rows["processes"]
    rows["multicast_lost"] = rows["on_air"] / many / rows["runs"]
    return rows


def _with_mpdus(ns3: pd.DataFrame) -> pd.DataFrame:
    """Return ns-3's rows with the mpdus of the sweeps."""
    return ns3.assign(mpdus=np.where(ns3["ampdu"] > 0, 64, 1))


def round_up(value: float, step: float) -> float:
    """Round a value up to a multiple of a step, except for a rounding error."""
    return float(np.ceil(value / step - 1e-9) * step)


def bianchi_throughput(
    stations: Sequence[int], wifi: Wifi, success: float, collision: float
) -> list[float]:
    """Return the throughput of saturated stations by Bianchi's chain [frames/s]."""
    assert wifi.radio is not None
    slot, window = wifi.radio.slot, wifi.radio.cw_min + 1
    stages = int(np.log2((wifi.radio.cw_max + 1) / window))
    found = []
    for count in stations:
        low, high = 0.0, 1.0
        for _ in range(60):  # the chain's fixed point, by bisection
            p = (low + high) / 2
            steps = ((2 * p) ** np.arange(stages)).sum()
            tau = 2 / (1 + window + p * window * steps)
            low, high = (p, high) if 1 - (1 - tau) ** (count - 1) > p else (low, p)
        idle = (1 - tau) ** count
        good = count * tau * (1 - tau) ** (count - 1)
        lasts = idle * slot + good * success + (1 - idle - good) * collision
        found.append(float(good / lasts))
    return found


def staggered_start_rows(**wanted: object) -> pd.DataFrame:
    """Return rows of the sweep of starts, by default of 802.11n without aggregation."""
    rows = load_sweep("staggered")
    wanted = {"radio": "n", "mpdus": 1} | wanted
    return rows[(rows[list(wanted)] == pd.Series(wanted)).all(axis=1)]


def converges_sooner(row: pd.Series, reference: pd.Series) -> bool:
    """Return whether `row` converges sooner than `reference`, by more than the runs scatter."""
    return bool(row["convergence_time_s_high"] < reference["convergence_time_s_low"])


def convergence_time_ratio(slow: pd.Series, fast: pd.Series) -> tuple[float, float, float]:
    """Return the ratio of two convergence times, with its minimum and maximum."""
    time, low, high = (f"convergence_time_s{end}" for end in ("", "_low", "_high"))
    least, most = slow[low] / fast[high], slow[high] / fast[low]
    return float(slow[time] / fast[time]), float(least), float(most)
