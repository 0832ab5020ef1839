"""Frames on the air: what the first page simulates, and a still picture of its first run.

The page simulates in the browser (``book/_static/live/``), `start` does the same in Python, and
``data/simulated/air.csv`` holds what `picture` draws of it.
"""

from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from discostorm import figures
from discostorm.data import data_path
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.palette import lights
from discostorm.protocols import PROTOCOLS
from discostorm.wifi import WIFI, Radio, Wifi

#: Processes of a robot, and endpoints of each: the paper's Fig. 2.
PROCESSES, ENDPOINTS = figures.FIG2_PROCESSES, figures.FIG2_ENDPOINTS
#: Where the page begins, and what the picture shows.
HOSTS, TABLE, SEED = 12, "Fast DDS", 0
#: What that is compared with, if the reader chooses nothing else.
OTHER = "Zenoh peer"
#: The most robots to choose [1].
MOST = 15

#: One message per frame, and aggregated: the same radio.
SINGLE = WIFI["802.11n 20 MHz 2x2"]
AGGREGATED = Radio("802.11n", streams=2, mpdus=64).wifi()

#: Frames and seconds that a queue holds.
QUEUE = (500, 0.5)
#: How much of the start the picture shows, and the shortest frame that is still seen [s].
SHOWN, THIN = 0.25, 0.35e-3

#: What the tables to choose stand on, in order.
_BASES = ("measured", "mitigated", "paper")


def choices() -> list[Protocol]:
    """Return the tables to choose from: of each product the first, then the paper's."""
    tables = [p for basis in _BASES for p in PROTOCOLS.values() if p.basis == basis]
    first: dict[str | None, Protocol] = {}
    for protocol in tables:
        if protocol.product:
            first.setdefault(protocol.product, protocol)
    return [*first.values(), *(protocol for protocol in tables if protocol.basis == "paper")]


def export() -> dict[str, Any]:
    """Return what the page offers: robots, queue, channels, tables with their colors."""
    return {
        "hosts": HOSTS,
        "most": MOST,
        "table": TABLE,
        "other": OTHER,
        "processes": PROCESSES,
        "endpoints": ENDPOINTS,
        "queue": list(QUEUE),
        "radios": [SINGLE.name, AGGREGATED.name],
        "tables": [
            {
                "name": protocol.name,
                "label": protocol.name + ", as the paper counts" * (protocol.basis == "paper"),
                "color": figures.property_of(protocol),
            }
            for protocol in choices()
        ],
    }


def start(
    until: float = SHOWN, table: str = TABLE, hosts: int = HOSTS, wifi: Wifi = SINGLE
) -> pd.DataFrame:
    """Return what is sent at first in the page's run, and how long the access point's queue is.

    Columns: ``start_s`` and ``end_s``, ``station`` (the access point has the last number),
    ``outcome``, ``waiting`` (frames at the access point, as last looked at), ``source``.
    """
    from discostorm_simulation import simulate

    fleet = Fleet.swarm(hosts, PROCESSES, ENDPOINTS)
    found = simulate(fleet, PROTOCOLS[table], wifi, queue=QUEUE, seed=SEED, until=until)
    sent = found.transmissions
    time, _, waiting = found.queues[0].T
    last = np.searchsorted(time, sent["start"] * 1e-7, side="right") - 1
    return pd.DataFrame(
        {
            "start_s": [f"{value * 1e-7:.7f}" for value in sent["start"]],
            "end_s": [f"{value * 1e-7:.7f}" for value in sent["end"]],
            "station": sent["station"],
            "outcome": sent["outcome"],
            "waiting": waiting[last].astype(int),
            "source": f"ds.simulate, seed {SEED}",
        }
    )


def picture(table: str = TABLE, hosts: int = HOSTS) -> Figure:
    """Draw the first part of the run: a lane a robot, one for the access point, and its queue."""
    sent = pd.read_csv(data_path("simulated/air.csv", "discostorm_book"))
    color, bad = figures.color_of(PROTOCOLS[table]), lights("state")["bad"]
    charcoal = lights("neutral")["charcoal"]
    with figures.style():
        figure = Figure(figsize=(figures.WIDTH, 4.2))
        lanes, queue = figure.subplots(2, 1, sharex=True, height_ratios=(4, 1))
        # Lines instead of boxes, one path for each look: a small file, and sharp at any size.
        for failed, at_point, look, width in (
            (False, False, color, 8.0),
            (False, True, charcoal, 8.0),
            (True, None, bad, 10.0),
        ):
            chosen = (sent["outcome"] != 0) == failed
            if at_point is not None:
                chosen &= (sent["station"] == hosts) == at_point
            rows = sent[chosen]
            begin = rows["start_s"].to_numpy()
            end = begin + np.maximum(rows["end_s"] - rows["start_s"], THIN)
            none = np.full(len(rows), np.nan)
            lanes.plot(
                np.column_stack([begin, end, none]).ravel() * 1e3,
                np.column_stack([rows["station"], rows["station"], none]).ravel(),
                color=look,
                linewidth=width,
                solid_capstyle="butt",
            )
        lanes.set(
            yticks=range(hosts + 1),
            yticklabels=[*(f"robot {host + 1}" for host in range(hosts)), "access point"],
            ylim=(hosts + 0.6, -0.6),
        )
        lanes.grid(visible=False)
        looks = sent.drop_duplicates("waiting")
        time = [*looks["start_s"] * 1e3, SHOWN * 1e3]
        waiting = [*looks["waiting"], sent["waiting"].iloc[-1]]
        full = next(at for at, many in zip(time, waiting, strict=True) if many >= QUEUE[0])
        figures.headline(figure, f"Robots collide, and the queue is full after {full / 1e3:.2f} s")
        queue.fill_between(time, waiting, step="post", color=charcoal, alpha=0.35, lw=0)
        queue.axhline(QUEUE[0], color=bad, lw=1)
        queue.annotate(
            "full: the access point drops frames",
            (2, QUEUE[0]),
            (0, -3),
            textcoords="offset points",
            color=bad,
            va="top",
            fontsize=8,
        )
        queue.set(
            xlabel="time since the robots were switched on [ms]",
            ylabel="frames\nwaiting",
            xlim=(0, SHOWN * 1e3),
            ylim=(0, QUEUE[0] * 1.1),
        )
    return figure
