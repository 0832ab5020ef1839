"""Tables other than sweeps: single bursts, saturated stations, and the capture effect."""

from collections.abc import Iterable
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from sweep_definitions import COMPARED_WITH_NS3, combinations
from sweep_setting import PAPER_TABLES, SEED, SweepSetting, median_and_quartiles, round_six_digits

import discostorm as ds
from discostorm.data import data_path
from discostorm.lookup import as_protocol
from discostorm_book import frame_trace, landing, sweeps
from discostorm_planner.service_reply_wait import (
    MAX_BLOCKING_TIME,
    REQUIRED_REPLY_SHARE,
    lost_reply_share,
    required_reply_wait,
)
from discostorm_simulation import disc, powers, state as st
from discostorm_simulation.cell_setup import to_ticks
from discostorm_simulation.engine import LoadedCell, run_to_end
from discostorm_simulation.propagation import THRESHOLD
from discostorm_simulation.result import CAUSES
from discostorm_simulation.run import Scenario, set_up


def transmission_rows(start: frame_trace.TracedStart) -> NDArray[np.float64]:
    """Return each transmitted message: `frame_trace.COLUMNS`, then the queues of all stations."""
    queue = start.queue or (np.inf, np.inf)
    fleet = ds.Fleet.swarm(start.hosts, start.processes, start.endpoints)
    channel = sweeps.sweep_channel()
    setup = set_up(Scenario(fleet, ds.DDS, channel, queue=queue, recovery=False))
    (seed,) = np.random.SeedSequence(frame_trace.SEED).spawn(1)
    loaded, found = LoadedCell(setup.cell(seed)[0]), []
    while not loaded.advance(int(st.NEVER) - 1, setup.reserve, 1):
        cell = loaded.cell
        now = cell.state[0]
        after = [*(now[cause] for cause in CAUSES), *cell.stations["length"]]
        for sent in cell.log[: now["logged"]]:
            held = cell.window[sent["station"], 0]
            frame = int(held["frame"]) >> st.KIND_BITS
            frame, to = divmod(frame, 2**st.PROCESS_BITS)
            frame, source = divmod(frame, 2**st.PROCESS_BITS)
            item = frame % 2**st.ITEM_BITS
            logged = (sent[name] for name in frame_trace.LOG_COLUMNS)
            found.append([*logged, source, to, item, held["came"], *after])
        now["logged"] = 0
    return np.array(found, dtype=float)


def burst_transmissions() -> list[dict[str, object]]:
    """Return every transmission of a small burst [s]: three robots with one process each."""
    assert frame_trace.SEED == SEED
    start = frame_trace.SMALL_START
    names = [*(f"host {number + 1}" for number in range(start.hosts)), "access point"]
    waiting = [f"waiting_{name.replace(' ', '_')}" for name in names]
    log = pd.DataFrame(transmission_rows(start), columns=[*frame_trace.COLUMNS, *waiting])
    messages = [ds.DDS.messages[int(kind)] for kind in log["kind"]]
    hosts = (log[["source", "destination"]] // start.processes).astype(int)
    receivers = zip(messages, hosts["destination"], strict=True)

    def seconds(column: str) -> list[str]:
        return [f"{tick * 1e-7:.7f}" for tick in log[column]]

    return stored_rows(
        pd.DataFrame(
            {
                "start_s": seconds("start"),
                "end_s": seconds("end"),
                "station": [names[int(number)] for number in log["station"]],
                "message": [message.name for message in messages],
                "frames": log["frames"].astype(int),
                "outcome": np.where(log["outcome"] != 0, "collision", "success"),
                "from": [names[host] for host in hosts["source"]],
                "to": ["all" if m.cast == "multicast" else names[host] for m, host in receivers],
                "came_s": seconds("came"),
                **{name: log[name].astype(int) for name in waiting},
            }
        )
    )


def first_page_run() -> list[dict[str, object]]:
    """Return the first transmissions of the landing page's run, and the access point's queue.

    Columns: ``start_s`` and ``end_s``, ``station`` (the access point has the last number),
    ``outcome``, ``waiting`` (frames at the access point, as last observed), ``source``.
    """
    fleet = ds.Fleet.swarm(landing.HOSTS, landing.PROCESSES, landing.ENDPOINTS)
    options: dict[str, Any] = {"queue": landing.QUEUE, "seed": landing.SEED}
    options["until"] = landing.PICTURE_END_S
    result = ds.simulate(fleet, ds.PROTOCOLS[landing.TABLE], landing.SINGLE_FRAMES, **options)
    sent = result.transmissions
    time, _, waiting = result.queues[0].T
    last = np.searchsorted(time, sent["start"] * 1e-7, side="right") - 1
    times = {f"{end}_s": [f"{tick * 1e-7:.7f}" for tick in sent[end]] for end in ("start", "end")}
    columns: dict[str, Any] = {"station": sent["station"], "outcome": sent["outcome"]}
    columns |= {"waiting": waiting[last].astype(int), "source": f"ds.simulate, seed {landing.SEED}"}
    return stored_rows(pd.DataFrame({**times, **columns}))


def stored_rows(table: pd.DataFrame) -> list[dict[str, object]]:
    """Return the rows of a table."""
    return [{str(name): value for name, value in row.items()} for row in table.to_dict("records")]


#: Saturated stations: their number, number of runs, and simulated seconds.
STATIONS, TRIES, SATURATED_SECONDS = (1, 2, 5, 10, 20, 30, 50), 20, 2.0


def saturated_throughput(stations: Iterable[int] = STATIONS) -> list[dict[str, object]]:
    """Return the throughput when a number of stations always have frames to send.

    Two sets of rules: the standard's, and those of Bianchi's Markov chain, which has no timeout
    for acknowledgements and never drops a frame.
    """
    sedp = replace(ds.DDS.message("SEDP"), hops=("up",), answers=None)
    rows: list[dict[str, object]] = []
    for count, rules in product(stations, ("standard", "Bianchi")):
        starts = np.zeros(count + 1)
        starts[-1] = 1e4  # a receiver that sends nothing
        scenario = Scenario(
            ds.Fleet.swarm(count + 1, 1, max(16_000 // count**2, 100)),
            ds.Protocol("saturation", (sedp,)),
            SweepSetting("DDS", 2).wifi,
            queue=(np.inf, np.inf),
            start=starts,
            recovery=False,
        )
        what = set_up(scenario)
        if rules == "Bianchi":
            what.radio["timeout"], what.radio["attempts"] = 0, 10**6
        arrived = []
        for seed in np.random.SeedSequence(SEED).spawn(TRIES):
            cell = run_to_end(what.cell(seed)[0], to_ticks(SATURATED_SECONDS), what.reserve)
            assert (cell.stations["length"][:count] > 0).all(), "some had nothing left to send"
            arrived.append(int(cell.state["arrived"][0]) / SATURATED_SECONDS)
        row: dict[str, object] = {
            "stations": count,
            "rules": rules,
            "duration_s": SATURATED_SECONDS,
        }
        rows.append(row | {"runs": TRIES} | median_and_quartiles("frames_per_s", np.array(arrived)))
    return rows


def losses_by_host() -> list[dict[str, object]]:
    """Return the losses of each host: eight equal robots, and one that sends more."""
    robots = ds.HostGroup(7, 2, 10, name="robot")
    fleets = {
        "alike": ds.Fleet((replace(robots, hosts=8),)),
        "with a laptop": ds.Fleet((robots, ds.HostGroup(1, 2, 60, name="laptop"))),
    }
    rows: list[dict[str, object]] = []
    for name, fleet in fleets.items():
        found = ds.simulate(
            fleet, ds.DDS, SweepSetting("DDS", 8).wifi, recovery=False, runs=40, seed=SEED
        )
        hosts = [group for group in fleet.groups for _ in range(int(group.hosts))]
        for number, group in enumerate(hosts):
            row = {"fleet": name, "host": number + 1, "kind": group.name}
            row |= {"processes": int(group.processes), "endpoints": int(group.endpoints)}
            rows.append(row | median_and_quartiles("lost", found.lost_by_host[:, number]))
    return rows


def queue_lengths(hosts: Iterable[int] = (7, 12)) -> list[dict[str, object]]:
    """Return the queued frames over time in one burst: at all hosts, and at the access point."""
    rows: list[dict[str, object]] = []
    for count in hosts:
        fleet = ds.Fleet.swarm(count, 2, 10)
        found = ds.simulate(
            fleet, ds.DDS, SweepSetting("DDS", count).wifi, recovery=False, seed=SEED
        )
        for time, at_hosts, at_access_point in found.queues[0]:
            row: dict[str, object] = {
                "protocol": "DDS",
                "hosts": count,
                "time_s": round_six_digits(time),
            }
            rows.append(row | {"at_hosts": int(at_hosts), "at_access_point": int(at_access_point)})
    return rows


def user_data_delays(runs: int = 20) -> list[dict[str, object]]:
    """Return the convergence time without and with user data, and the data's delay."""
    fleet = ds.Fleet.from_toml(data_path("fleets/small_data.toml"))
    rows: list[dict[str, object]] = []
    for name in ("Fast DDS 3.6", "Cyclone DDS", "Zenoh peer"):
        alone, beside = (
            ds.simulate(one, ds.PROTOCOLS[name], ds.PAPER, runs=runs, seed=SEED)
            for one in (fleet.without_data(), fleet)
        )
        for topic, own in beside.data.items():
            row: dict[str, object] = {"protocol": name, "topic": topic, "runs": runs}
            row |= median_and_quartiles("convergence_alone_s", alone.convergence_time)
            row |= median_and_quartiles("convergence_s", beside.convergence_time)
            row |= {"arrived": round_six_digits(float((own["arrived"] / own["frames"]).mean()))}
            for column in ("delay_median_s", "delay_95_s", "delay_most_s"):
                row |= {column: round_six_digits(float(np.median(own[column])))}
            rows.append(row)
    return rows


def service_reply_wait(
    hosts: Iterable[int] = (2, 5, 8, 10), runs: int = 10
) -> list[dict[str, object]]:
    """Return which share of replies is dropped while small robots start, and which wait is safe."""
    rows: list[dict[str, object]] = []
    for name, count in product(("Fast DDS 2.6", "Fast DDS 2.14", "Fast DDS 3.6"), hosts):
        fleet = ds.Fleet.swarm(count, 2, 10)
        options: dict[str, Any] = {"runs": runs, "until": 60.0, "seed": SEED}
        found = ds.simulate(fleet, as_protocol(name), sweeps.sweep_channel(), **options)
        row: dict[str, object] = {"protocol": name, "hosts": count, "runs": runs}
        row |= {
            "wait_s": MAX_BLOCKING_TIME,
            "lost": round_six_digits(lost_reply_share(found.pair_times)),
        }
        longest = max(map(required_reply_wait, found.pair_times))  # as plans say
        rows.append(row | {"safe": REQUIRED_REPLY_SHARE, "safe_wait_s": round_six_digits(longest)})
    return rows


def mixed_traffic(runs: int = 40) -> list[dict[str, object]]:
    """Return bursts alongside user data, with the settings of ``measured/ns3_mixed.csv``."""
    rows: list[dict[str, object]] = []
    for mpdus, hz in product((1, 64), (10.0, 35.0)):
        found = ds.simulate(
            sweeps.robots_with_user_data(hz),
            ds.DDS,
            sweeps.sweep_channel(mpdus),
            recovery=False,
            runs=runs,
            seed=SEED,
            until=4.0,
            block_ack="established",
        )
        own = {"lost": found.lost, "drain_time_s": found.drain_time, "busy_s": found.busy_time}
        of = {"burst": (own, found.counts)} | {
            name.partition(" of ")[0]: (
                {"lost": 1 - topic["arrived"] / topic["frames"]}
                | {delay: topic[delay] for delay in ("delay_median_s", "delay_95_s")},
                {"expected": topic["frames"], **topic},
            )
            for name, topic in found.data.items()
        }
        for what, (values, counts) in of.items():
            row: dict[str, object] = {"protocol": "DDS", "image_hz": hz, "mpdus": mpdus}
            row |= {"what": what, "runs": runs}
            for name, times in values.items():
                row |= median_and_quartiles(name, times)
            named = ("expected", "arrived", *CAUSES)
            rows.append(row | {name: int(counts[name].sum()) for name in named})
    return rows


#: Reception of the stations: equal power, or distances on a disc with capture thresholds [dB].
#: Thresholds: from the standard, from ns-3 (lab/ns3/README.md), and 0 for receivers that always
#: decode the strongest frame.
CAPTURE_THRESHOLDS = {
    "alike": None,
    "standard": THRESHOLD,
    "ns-3": (18.7, 1.0),
    "strongest": (0.0, 0.0),
}


def capture_effect(hosts: Iterable[int] = (3, 5, 7, 10)) -> list[dict[str, object]]:
    """Return bursts of hosts with equal received power, and of hosts at distances on a disc."""
    queues = ((500, 0.5), (0, 0.0))
    settings = combinations(COMPARED_WITH_NS3, protocol=PAPER_TABLES, mpdus=(1, 64), hosts=hosts)
    rows: list[dict[str, object]] = []
    for one, (frames, seconds), (where, threshold) in product(
        settings, queues, CAPTURE_THRESHOLDS.items()
    ):
        protocol = ds.PROTOCOLS[one.protocol]
        unlike: dict[str, Any] = {}
        if threshold:
            unlike = {"power": powers(disc(one.hosts)), "threshold": threshold}
        fleet = ds.Fleet.swarm(one.hosts, one.processes, one.endpoints)
        found = ds.simulate(
            fleet,
            protocol,
            one.wifi,
            queue=(frames or np.inf, seconds or np.inf),
            recovery=False,
            runs=one.runs,
            seed=SEED,
            block_ack="established",
            **unlike,
        )
        multicast = sum(
            float(message.load(fleet))
            for message in protocol.messages
            if message.cast == "multicast"
        )
        names = ("protocol", "hosts", "processes", "endpoints", "mpdus", "agreements", "runs")
        row = {name: getattr(one, name) for name in names}
        row |= {"queue_frames": frames, "queue_s": seconds, "heard": where}
        row |= median_and_quartiles("drain_time_s", found.drain_time) | median_and_quartiles(
            "lost", found.lost
        )
        on_air = found.counts["on_air"].mean() / (multicast * (one.hosts - 1))
        rows.append(row | {"multicast_lost": round_six_digits(float(on_air))})
    return rows
