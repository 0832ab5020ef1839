"""One startup, frame by frame: the messages of each transmission, and the queues after it."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm import figures
from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.protocols import PROTOCOLS
from discostorm_book import sweeps
from discostorm_simulation.result import CAUSES

#: Random seed of all starts; the chapter's sweeps have the same seed.
SEED = 2026
_WORDS = read_data("simulated/words_of_trace.csv", "discostorm_book")
#: Names of the roles of messages, and how receptions are lost, by cause.
MESSAGE_WORDS = {row["key"]: row["words"] for row in _WORDS if row["what"] == "role"}
LOSS_WORDS = {row["key"]: row["words"] for row in _WORDS if row["what"] == "cause"}


@dataclass(frozen=True)
class TracedStart:
    """A fleet that starts at once, whose burst nothing repairs."""

    label: str
    hosts: int
    processes: int
    endpoints: int
    #: Queue limits: frames and seconds; None for no limit.
    queue: tuple[int, float] | None
    table: str = "DDS"

    @property
    def fleet(self) -> Fleet:
        """The robots on the channel."""
        return Fleet.swarm(self.hosts, self.processes, self.endpoints)

    @property
    def protocol(self) -> Protocol:
        """Their traffic."""
        return PROTOCOLS[self.table]


#: The chapter's first figure, and the first fleet whose frames also expire at the robots.
SMALL_START = TracedStart("3 robots, unlimited queues", 3, 1, 2, None)
FULL_START = TracedStart("7 robots, queues of 500 frames", 7, *sweeps.SWARM, (500, 0.5))
TRACED_STARTS = (SMALL_START, FULL_START)

#: Columns of a transmission: first those of `Simulation.transmissions`.
LOG = ("start", "end", "station", "kind", "frames", "outcome")
#: Then source and destination process of its frame, its index among the messages of the same kind
#: between them, and its arrival time at the station [ticks].
FRAME = ("source", "destination", "item", "came")
#: Then, after the exchange, receptions lost by cause, and frames waiting at each station.
COLUMNS = (*LOG, *FRAME, *CAUSES)


def page_data() -> dict[str, Any]:
    """Return the page's data: settings of the starts, columns, and names of messages."""
    return {
        "columns": COLUMNS,
        "causes": {cause: LOSS_WORDS[cause] for cause in CAUSES},
        "starts": list(map(_settings_of_start, TRACED_STARTS)),
    }


def _settings_of_start(start: TracedStart) -> dict[str, Any]:
    messages = [
        {"name": MESSAGE_WORDS[str(m.role)], "multicast": m.cast == "multicast"}
        | {"endpoint": m.role == "data"}
        for m in start.protocol.messages
    ]
    sizes = {name: getattr(start, name) for name in ("hosts", "processes", "endpoints")}
    setting = {"table": start.table, "radio": sweeps.sweep_channel().name, "recovery": False}
    setting |= {"fleet": {"groups": [sizes]}, "queue": start.queue, "seed": SEED}
    shown = {"label": start.label, "hosts": start.hosts, "processes": start.processes}
    # Of each robot, for each other one.
    shown |= {"announcements": start.processes**2 * start.endpoints}
    color = figures.css_color_property(start.protocol)
    return shown | {"color": color, "messages": messages, "setting": setting}


def transmission_rows(start: TracedStart) -> NDArray[np.float64]:
    """Return one row per transmitted message: `COLUMNS`, then the frames waiting at stations."""
    from discostorm_simulation.engine import LoadedCell
    from discostorm_simulation.run import Scenario, set_up
    from discostorm_simulation.state import ITEM_BITS, KIND_BITS, NEVER, PROCESS_BITS

    queue = start.queue or (np.inf, np.inf)
    channel = sweeps.sweep_channel()
    setup = set_up(Scenario(start.fleet, start.protocol, channel, queue=queue, recovery=False))
    (seed,) = np.random.SeedSequence(SEED).spawn(1)
    loaded, found = LoadedCell(setup.cell(seed)[0]), []
    while not loaded.advance(int(NEVER) - 1, setup.reserve, 1):
        cell = loaded.cell
        now = cell.state[0]
        after = [*(now[cause] for cause in CAUSES), *cell.stations["length"]]
        for sent in cell.log[: now["logged"]]:
            held = cell.window[sent["station"], 0]
            frame = int(held["frame"]) >> KIND_BITS
            frame, to = divmod(frame, 2**PROCESS_BITS)
            frame, source = divmod(frame, 2**PROCESS_BITS)
            item = frame % 2**ITEM_BITS
            found.append([*(sent[name] for name in LOG), source, to, item, held["came"], *after])
        now["logged"] = 0
    return np.array(found, dtype=float)
