"""A node of ROS 2 with Cyclone DDS 11: `node_cyclone_dds.py NAME ENDPOINTS [SETTINGS]`.

ENDPOINTS lists "w TOPIC TYPE HZ BYTES" and "r TOPIC TYPE", with commas between them, in the names
of DDS. Words may follow: "be" (best effort), "tl" (transient local, of the last sample), "until=S"
(a writer that stops after S seconds), "echo=TOPIC" (a reader that answers each sample on a writer).
A writer of 0 Hz writes nothing. SETTINGS is JSON: `hash` (of all types), `best_effort` (all
endpoints), `domain`, `ros` (adds the endpoints that each node of ROS 2 has). The node announces
itself in ros_discovery_info, prints how many samples came by topic, and leaves properly at SIGTERM.
"""

import json
import signal
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import DDSException, Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, sequence, uint8
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

NAME, ENDPOINTS = sys.argv[1:3]
SETTINGS = json.loads(sys.argv[3]) if len(sys.argv) > 3 else {}
NEVER = 1e9  # s
#: Endpoints of each node of ROS 2: its log and its parameters.
OF_ALL_NODES = [
    "w rt/rosout rcl_interfaces::msg::dds_::Log_ 0.2 120 tl",
    "w rt/parameter_events rcl_interfaces::msg::dds_::ParameterEvent_ 0 60",
    "r rt/parameter_events rcl_interfaces::msg::dds_::ParameterEvent_",
]
PARAMETER_SERVICES = {
    "describe_parameters": "DescribeParameters",
    "get_parameter_types": "GetParameterTypes",
    "get_parameters": "GetParameters",
    "list_parameters": "ListParameters",
    "set_parameters": "SetParameters",
    "set_parameters_atomically": "SetParametersAtomically",
}


@dataclass
class Gid(IdlStruct, typename="rmw_dds_common::msg::dds_::Gid_"):  # type: ignore
    data: array[uint8, 16]


@dataclass
class Node(IdlStruct, typename="rmw_dds_common::msg::dds_::NodeEntitiesInfo_"):  # type: ignore
    node_namespace: str
    node_name: str
    reader_gid_seq: sequence[Gid]
    writer_gid_seq: sequence[Gid]


@dataclass
class Participant(IdlStruct, typename="rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_"):  # type: ignore
    gid: Gid
    node_entities_info_seq: sequence[Node]


@dataclass
class Source:
    """A writer, its sample, and when it writes [s]."""

    writer: DataWriter
    sample: object
    period: float
    next: float
    until: float
    sent: int = 0

    def write(self) -> None:
        try:
            self.writer.write(self.sample)
            self.sent += 1
        except DDSException as error:  # its readers confirm too slowly
            print(f"{time.monotonic():.3f} failed", error, flush=True)

    def write_due(self, now: float) -> None:
        """Write the samples that are due; skip those that are more than a second late."""
        while self.next <= now:
            if now < self.until:
                self.write()
            self.next += self.period
            if self.next < now - 1:
                self.next = now + self.period


def sample_type(name: str) -> type:
    """Return the type of a topic, which is a String of another name."""

    @dataclass
    class Sample(IdlStruct, typename=name):  # type: ignore
        data: str

    return Sample


def gid(entity: object) -> Gid:
    return Gid(list(entity.guid.bytes))  # type: ignore


def listed_endpoints() -> list[list[str]]:
    """Return the endpoints that are asked for, in words."""
    found = ENDPOINTS.split(",")
    if SETTINGS.get("ros"):
        found += OF_ALL_NODES
        for name, kind in PARAMETER_SERVICES.items():
            kind = f"rcl_interfaces::srv::dds_::{kind}"
            found.append(f"r rq/{NAME}/{name}Request {kind}_Request_")
            found.append(f"w rr/{NAME}/{name}Reply {kind}_Response_ 0 8")
    return [item.split() for item in found]


def qos_of(words: list[str]) -> Qos:
    """Return the QoS of an endpoint, from the words that follow its type."""
    best_effort = "be" in words or SETTINGS.get("best_effort")
    reliable = Policy.Reliability.Reliable(duration(milliseconds=100))
    policies = [Policy.Reliability.BestEffort if best_effort else reliable]
    if "tl" in words:
        policies += [Policy.Durability.TransientLocal, Policy.History.KeepLast(1)]
    else:
        policies += [Policy.Durability.Volatile, Policy.History.KeepLast(10)]
    if "hash" in SETTINGS:
        policies.append(Policy.Userdata(f"typehash={SETTINGS['hash']};".encode()))
    return Qos(*policies)


def value_of(word: str, words: list[str]) -> str | None:
    """Return what follows the equal sign of a word."""
    return next((one.partition("=")[2] for one in words if one.startswith(f"{word}=")), None)


def main() -> None:
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    kept = Qos(
        Policy.Reliability.Reliable(duration(seconds=1)),
        Policy.Durability.TransientLocal,
        Policy.History.KeepLast(1),
    )
    participant = DomainParticipant(SETTINGS.get("domain", 0), Qos(Policy.Userdata(b"enclave=/;")))
    info = Topic(participant, "ros_discovery_info", Participant)
    graph, tells = DataReader(participant, info, kept), DataWriter(participant, info, kept)
    begin = time.monotonic()
    types: dict[str, type] = {}
    readers: dict[str, DataReader] = {}
    sources: dict[str, Source] = {}
    answered_on: dict[str, str] = {}
    for role, name, kind, *words in listed_endpoints():
        made = types.setdefault(kind, sample_type(kind))
        topic = Topic(participant, name, made)
        if role == "r":
            readers[name] = DataReader(participant, topic, qos_of(words))
            if answer := value_of("echo", words):
                answered_on[name] = answer
            continue
        rate, size = float(words[0]), int(words[1])
        sources[name] = Source(
            DataWriter(participant, topic, qos_of(words)),
            made("x" * size),
            1 / rate if rate else NEVER,
            begin + (2 if rate else NEVER),
            begin + float(value_of("until", words) or NEVER),
        )
    written = [gid(one.writer) for one in sources.values()]
    own = Node("/", NAME, [gid(one) for one in readers.values()], written)
    tells.write(Participant(gid(participant), [own]))
    came, told_at = dict.fromkeys(readers, 0), begin + 5
    while True:
        now = time.monotonic()
        for source in sources.values():
            source.write_due(now)
        for name, reader in readers.items():
            new = len(reader.take(1000))
            came[name] += new
            for _ in range(new if name in answered_on else 0):
                sources[answered_on[name]].write()
        graph.take(10)
        if now > told_at:
            sent = [one.sent for one in sources.values()]
            print(f"{now:.3f} came", json.dumps(came), "sent", sent, flush=True)
            told_at += 5
        nearest = min([one.next for one in sources.values()], default=now + 0.02)
        time.sleep(max(0.0005, min(0.02, nearest - time.monotonic())))


main()
