"""The mixed case: a burst alongside user data in ns-3, and its table; see README.md."""

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import discostorm as ds
from discostorm.messages import user_data_protocol
from discostorm_book.sweeps import robots_with_user_data

#: ns-3's names for the receivers of a sample.
_TO = {
    "one host": "next",
    "wired host": "wired",
    "all others": "each",
    "multicast": "multicast",
}
#: Delays of samples. JSON has no NaN, so ns-3 prints -1 if no sample arrived.
DELAY_COLUMNS = ("delay_median_s", "delay_95_s")


@dataclasses.dataclass(frozen=True)
class MixedTraffic:
    """A run of a burst alongside user data; its fields are options and columns."""

    protocol: str = "DDS"
    image_hz: float = 10.0
    ampdu: int = 0
    queue_frames: int = 500
    queue_s: float = 0.5
    until_s: float = 4.0
    seed: int = 1

    def options(self, messages: Callable[[str, int], str]) -> list[str]:
        """Return the program's options."""
        robots = robots_with_user_data(self.image_hz)
        (group,) = robots.groups
        named = "ampdu queue_frames queue_s until_s seed"
        return [
            f"--messages={messages(self.protocol, int(group.endpoints))}",
            f"--data={flow_rows(robots, self.protocol)}",
            f"--hosts={int(group.hosts)}",
            f"--processes={int(group.processes)}",
            *(f"--{name}={getattr(self, name)}" for name in named.split()),
        ]


#: Data that leave room for the burst, and data that nearly fill the channel.
RUNS = [
    MixedTraffic(image_hz=hz, ampdu=ampdu, seed=seed)
    for ampdu in (0, 65535)
    for hz in (10.0, 35.0)
    for seed in range(1, 41)
]


def flow_rows(robots: ds.Fleet, protocol: str) -> str:
    """Return the rows of a fleet's data in the program's input format."""
    table = user_data_protocol(ds.PROTOCOLS[protocol], robots)
    assert table is not None
    to = {flow.topic: _TO[flow.to] for flow in robots.groups[0].data}
    found = []
    for row in table.messages:
        topic = row.name.partition(" of ")[0]
        period, frame, count = row.schedule.period, row.frame_bytes, row.frames
        found.append(f"{topic}:{to[topic]}:{period!r}:{frame:g}:{count:g}")
    return ",".join(found)


def setting_rows(
    results: Mapping[MixedTraffic, Sequence[dict[str, Any]]],
    source: Callable[[MixedTraffic], str],
    spread: Callable[[str, list[float]], dict[str, float]],
) -> list[dict[str, object]]:
    """Return a row for the burst of each setting, and a row for each of its topics."""
    found: list[dict[str, object]] = []
    for run, group in results.items():
        setting: dict[str, object] = dataclasses.asdict(run)
        del setting["seed"]
        for what in group[0]["data"]:
            own = [values["data"][what] for values in group]
            counts = {
                name: sum(one[name] for one in own) for name in own[0] if name not in DELAY_COLUMNS
            }
            row = setting | {"what": what, "runs": len(group)}
            row |= spread("lost", [1 - one["arrived"] / one["expected"] for one in own])
            burst = what == "burst"
            for name, values in (
                ("drain_time_s", [values["drain_time_s"] for values in group] if burst else []),
                ("busy_s", [values["busy_s"] for values in group] if burst else []),
                *((name, [] if burst else [one[name] for one in own]) for name in DELAY_COLUMNS),
            ):
                empty = dict.fromkeys((name, f"{name}_q25", f"{name}_q75"), "")
                row |= spread(name, values) if values else empty
            found.append(row | counts | {"source": f"{source(run)} --seed 1 to {len(group)}"})
    return found
