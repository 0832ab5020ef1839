"""A process of `user_data.py`: a writer of samples of known size and rate, or their reader.

`user_data_process.py PRODUCT write|read BYTES HZ SAMPLES reliable|best-effort`. The sample is a
String of ROS 2, serialized to BYTES octets and a header of four. The writer waits for its reader,
prints the start and the end of its samples, and waits to be killed.
"""

import sys
import time
from dataclasses import dataclass

PRODUCT, ROLE, BYTES, HZ, SAMPLES, HOW = sys.argv[1:7]
RELIABLE = HOW == "reliable"
TOPIC = "rt/lab_data"
#: Length of the text and of its terminating zero.
TEXT = "x" * (int(BYTES) - 5)
SETTLING = 3.0  # s between the match and the first sample


def publish(send: object) -> None:
    time.sleep(SETTLING)
    print("begin", f"{time.time():.6f}", flush=True)
    for _ in range(int(SAMPLES)):
        send()  # type: ignore[operator]
        time.sleep(1 / float(HZ))
    time.sleep(0.5)
    print("end", f"{time.time():.6f}", flush=True)


def cyclone_dds() -> None:
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

    reliability = Policy.Reliability
    qos = Qos(
        reliability.Reliable(duration(seconds=1)) if RELIABLE else reliability.BestEffort,
        Policy.Durability.Volatile,
        Policy.History.KeepLast(10),
    )
    participant = DomainParticipant(0)
    topic = Topic(participant, TOPIC, String_)
    if ROLE == "write":
        writer = DataWriter(participant, topic, qos)
        while not writer.get_matched_subscriptions():
            time.sleep(0.01)
        publish(lambda: writer.write(String_(TEXT)))
    else:
        reader = DataReader(participant, topic, qos)
        print("ready", flush=True)
        while True:
            reader.take(10)
            time.sleep(0.005)


def zenoh_peer() -> None:
    import zenoh

    key = "0/lab_data/std_msgs::msg::dds_::String_/RIHS01_" + 64 * "0"
    session = zenoh.open(zenoh.Config())
    if ROLE == "write":
        kind = zenoh.Reliability.RELIABLE if RELIABLE else zenoh.Reliability.BEST_EFFORT
        control = zenoh.CongestionControl.BLOCK if RELIABLE else zenoh.CongestionControl.DROP
        writer = session.declare_publisher(key, reliability=kind, congestion_control=control)
        # As in rmw_zenoh: with an attachment of sequence number, time and writer.
        attachment = b"\0" * (8 + 8 + 1 + 16)
        while not writer.matching_status.matching:
            time.sleep(0.01)
        publish(lambda: writer.put(b"\0\1\0\0" + b"\0" * int(BYTES), attachment=attachment))
    else:
        session.declare_subscriber(key, lambda _: None)
        print("ready", flush=True)
        time.sleep(1e6)


{"cyclone_dds": cyclone_dds, "zenoh_peer": zenoh_peer}[PRODUCT]()
time.sleep(1e6)
