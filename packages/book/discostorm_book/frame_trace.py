"""One startup, frame by frame: the messages of each transmission, and the queues after it."""

from dataclasses import dataclass
from typing import Any

from discostorm import figures
from discostorm.data import read_data
from discostorm.protocols import DDS
from discostorm_book import sweeps
from discostorm_simulation.result import CAUSES

#: Random seed of all starts; the chapter's sweeps have the same seed.
SEED = 2026
_WORD_ROWS = read_data("simulated/words_of_trace.csv", "discostorm_book")
#: Names of the roles of messages, and how receptions are lost, by cause.
MESSAGE_WORDS = {row["key"]: row["words"] for row in _WORD_ROWS if row["what"] == "role"}
LOSS_WORDS = {row["key"]: row["words"] for row in _WORD_ROWS if row["what"] == "cause"}


@dataclass(frozen=True)
class TracedStart:
    """A fleet with the paper's DDS that starts at once, whose burst nothing repairs."""

    label: str
    hosts: int
    processes: int
    endpoints: int
    #: Queue limits: frames and seconds; None for no limit.
    queue: tuple[int, float] | None


#: The chapter's first figure, and the first fleet whose frames also expire at the robots.
SMALL_START = TracedStart("3 robots, unlimited queues", 3, 1, 2, None)
FULL_START = TracedStart("7 robots, queues of 500 frames", 7, *sweeps.SWARM, (500, 0.5))
TRACED_STARTS = (SMALL_START, FULL_START)
#: Columns of a transmission: first those of `Simulation.transmissions`.
LOG_COLUMNS = ("start", "end", "station", "kind", "frames", "outcome")
#: Then source and destination process of its frame, its index among the messages of the same kind
#: between them, and its arrival time at the station [ticks].
FRAME_COLUMNS = ("source", "destination", "item", "came")
#: Then, after the exchange, receptions lost by cause, and frames waiting at each station.
COLUMNS = (*LOG_COLUMNS, *FRAME_COLUMNS, *CAUSES)


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
        for m in DDS.messages
    ]
    sizes = {name: getattr(start, name) for name in ("hosts", "processes", "endpoints")}
    setting = {"table": DDS.name, "radio": sweeps.sweep_channel().name, "recovery": False}
    setting |= {"fleet": {"groups": [sizes]}, "queue": start.queue, "seed": SEED}
    shown = {"label": start.label, "hosts": start.hosts, "processes": start.processes}
    # From each robot to each other one.
    shown |= {"announcements": start.processes**2 * start.endpoints}
    color = figures.css_color_property(DDS)
    return shown | {"color": color, "messages": messages, "setting": setting}
