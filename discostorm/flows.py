"""User data: the topics that hosts publish once discovery is complete."""

from dataclasses import dataclass
from typing import Any, Literal, get_args

from discostorm import _checks, _names
from discostorm.data import read_data

#: Receivers of each sample; see `Flow`.
Receivers = Literal["one host", "wired host", "all others", "multicast"]

#: Allowed rates [Hz] and sizes [B].
_RANGES = {"rate": (1e-6, 1e6), "bytes": (0.0, 1e8)}
#: Allowed keys of a table of a fleet file.
FLOW_KEYS = ("topic", "to", "rate", "bytes", "reliable")


@dataclass(frozen=True)
class Flow:
    """A topic that each host of a group publishes, once, to readers on other hosts.

    Its readers, `to`, are on "one host" of the others, each as likely; on a "wired host" at the
    access point, whether the fleet lists it or not; or on "all others", in unicast. With
    "multicast" they are on every other host, too, but Zenoh sends over TCP in unicast. `rate` is
    the samples a second of each host [Hz], from 1e-6 to 1e6; `bytes` the size of a serialized
    sample without the four octets of its encapsulation [B], to 1e8; `reliable` whether readers
    acknowledge, which multicast lacks.
    """

    topic: str
    to: Receivers
    rate: float
    bytes: float
    reliable: bool

    def __post_init__(self) -> None:
        _checks.nonblank("topic", self.topic)
        _checks.choice("to", self.to, get_args(Receivers))
        for name, (low, high) in _RANGES.items():
            object.__setattr__(self, name, _checks.number(name, getattr(self, name), low, high))
        object.__setattr__(self, "reliable", _checks.boolean("reliable", self.reliable))
        if self.reliable and self.to == "multicast":
            raise ValueError(
                "reliable must be false with multicast, as we do not count its answers; got true. "
                "Use 'all others' for one unicast copy per host"
            )


def topics() -> dict[str, dict[str, Any]]:
    """Return rate, bytes and reliability of each ready-made topic (``fleets/topics.csv``)."""
    return {
        row["topic"]: {
            "rate": float(row["rate_Hz"]),
            "bytes": float(row["bytes"]),
            "reliable": row["reliability"] == "reliable",
        }
        for row in read_data("fleets/topics.csv")
    }


def flow(topic: str, to: Receivers, **own: Any) -> Flow:
    """Return a flow of a ready-made topic, or of your own with `rate`, `bytes`, `reliable`."""
    _checks.instance("topic", topic, str)
    ready = topics()
    given = ready.get(topic, {}) | own
    for name in ("rate", "bytes", "reliable"):
        if name not in given:
            like, may = _names.did_you_mean(topic, ready), ", ".join(ready)
            raise ValueError(f"{name} is missing; only these topics may omit it: {may}{like}")
    return Flow(topic, to, **given)


def flow_from_table(table: Any) -> Flow:
    """Return the flow of a table ``[[groups.data]]`` in a fleet file."""
    _names.check_keys(table, FLOW_KEYS, "topic and to")
    for key, allowed in (("topic", "a text"), ("to", " or ".join(map(repr, get_args(Receivers))))):
        if key not in table:
            raise ValueError(f"{key} is missing; it must be {allowed}")
    if not isinstance(table.get("reliable", False), bool):
        got = _checks.short_repr(table["reliable"])
        raise TypeError(f"reliable must be true or false; got {got}")
    return flow(**table)
