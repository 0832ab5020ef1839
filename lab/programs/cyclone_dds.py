"""A process of the lab: the same as cyclone_dds.c, with Cyclone DDS's own Python package."""

import os
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration


@dataclass
class String_(IdlStruct, typename="std_msgs::msg::dds_::String_"):  # type: ignore  # noqa: N801
    data: str


def print_time(what: str) -> None:
    print(what, f"{time.time():.6f}", flush=True)


def main() -> None:
    seconds = float(sys.argv[1])
    host, process, endpoints = map(int, sys.argv[2:5])
    matching = {"matching": endpoints // 2, "shared": 1}.get(sys.argv[5], 0)
    qos = Qos(
        Policy.Reliability.Reliable(duration(infinite=True)),
        Policy.Durability.Volatile,
        Policy.History.KeepLast(10),
    )
    # ROS 2 compiles type descriptions in; here, creating one takes 0.2 s, once.
    String_.__idl__.populate()
    String_.__idl__.fill_type_data()
    print_time("ready")
    start = float(sys.stdin.readline())
    time.sleep(max(0.0, start - time.time()))
    print_time("begin")
    participant = DomainParticipant(0, Qos(Policy.Userdata(b"enclave=/;")))
    print_time("participant")
    kept = []
    for number in range(endpoints // 2):
        names = [f"rt/lab_{host:02}{process:02}_{role}{number:03}" for role in "wr"]
        if number < matching:
            names = [f"rt/lab_0000_t{number:03}"]
        topics = [Topic(participant, name, String_) for name in names]
        kept += [DataWriter(participant, topics[0], qos), DataReader(participant, topics[-1], qos)]
    print_time("endpoints")
    time.sleep(max(0.0, start + seconds - time.time()))
    print_time("end")
    os._exit(0)  # exit without goodbyes, which the capture would contain


main()
