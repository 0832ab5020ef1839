"""A node of ROS 2 with Cyclone DDS 11: `node_cyclone_dds.py NAME ENDPOINTS [SETTINGS]`.

ENDPOINTS lists "w TOPIC TYPE HZ BYTES" and "r TOPIC TYPE", with commas between them, in the names
of DDS. SETTINGS is JSON: `hash` (of all types), `best_effort`. The node announces itself in
ros_discovery_info, and prints how many samples came by topic.
"""

import json
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, sequence, uint8
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

NAME, ENDPOINTS = sys.argv[1:3]
SETTINGS = json.loads(sys.argv[3]) if len(sys.argv) > 3 else {}


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


def sample_type(name: str) -> type:
    """Return the type of a topic, which is a String of another name."""

    @dataclass
    class Sample(IdlStruct, typename=name):  # type: ignore
        data: str

    return Sample


def gid(entity: object) -> Gid:
    return Gid(list(entity.guid.bytes))  # type: ignore


def main() -> None:
    reliable = Policy.Reliability.Reliable(duration(seconds=1))
    how = Policy.Reliability.BestEffort if SETTINGS.get("best_effort") else reliable
    policies = [how, Policy.History.KeepLast(10)]
    if "hash" in SETTINGS:
        policies.append(Policy.Userdata(f"typehash={SETTINGS['hash']};".encode()))
    qos = Qos(*policies)
    kept = Qos(reliable, Policy.Durability.TransientLocal, Policy.History.KeepLast(1))
    participant = DomainParticipant(0, Qos(Policy.Userdata(b"enclave=/;")))
    info = Topic(participant, "ros_discovery_info", Participant)
    graph, tells = DataReader(participant, info, kept), DataWriter(participant, info, kept)
    readers, writers = {}, []
    for role, name, kind, *told in (item.split() for item in ENDPOINTS.split(",")):
        made = sample_type(kind)
        topic = Topic(participant, name, made)
        if role == "r":
            readers[name] = DataReader(participant, topic, qos)
        else:
            sample = made("x" * int(told[1]))
            writers.append([DataWriter(participant, topic, qos), 1 / float(told[0]), sample, 0.0])
    own = Node("/", NAME, [gid(one) for one in readers.values()], [gid(one[0]) for one in writers])
    tells.write(Participant(gid(participant), [own]))
    came, told_at = dict.fromkeys(readers, 0), time.monotonic() + 5
    for one in writers:
        one[3] = time.monotonic() + 2
    while True:
        now = time.monotonic()
        for one in writers:
            while one[3] <= now:
                one[0].write(one[2])
                one[3] += one[1]
        for name, reader in readers.items():
            came[name] += len(reader.take(1000))
        graph.take(10)
        if now > told_at:
            print(f"{now:.3f} came", json.dumps(came), flush=True)
            told_at += 5
        nearest = min([one[3] for one in writers], default=now + 0.02)
        time.sleep(max(0.0005, min(0.02, nearest - time.monotonic())))


main()
