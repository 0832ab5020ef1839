"""Requests of services that come before the reader for their reply was announced.

The captures are made by hand: 10.0.0.1 asks for the state of a node on 10.0.0.2.
"""

import io
import struct

import handmade_captures as handmade
import pytest

import discostorm as ds
from discostorm_capture.diagnosis.diagnose import Diagnosis

#: Writers of SEDP; the client's writer and reader, the server's writer and reader.
PUBLICATIONS, SUBSCRIPTIONS = 0x000003C2, 0x000004C2
ASKS, READS, REPLIES, HEARS = 0x0103, 0x0204, 0x0303, 0x0404
REQUEST, REPLY = "rq/amcl/get_stateRequest", "rr/amcl/get_stateReply"


def announced(time: float, host: int, to: int, entity: int, topic: str) -> handmade.Packet:
    """Return the first announcement of a kind of endpoint."""
    name = topic.encode() + b"\0"
    name += bytes(-len(name) % 4)
    text = struct.pack("<I", len(topic) + 1) + name
    guid = handmade.prefix(host) + struct.pack(">I", entity)
    parameters = ((0x5A, guid), (0x05, text), (0x07, text), (0x01, b""))
    values = b"".join(struct.pack("<HH", id_, len(value)) + value for id_, value in parameters)
    writer = PUBLICATIONS if entity & 0xFF == 3 else SUBSCRIPTIONS
    ids = struct.pack(">II", writer + 5, writer)
    body = bytes(2) + struct.pack("<H", 16) + ids + struct.pack("<iI", 0, 1)
    data = handmade.submessage(0x15, body + b"\0\3\0\0" + values, flags=4)
    return handmade.dds(time, host, data, to=to)


def confirmed(time: float, host: int, to: int, writer: int) -> handmade.Packet:
    ids = struct.pack(">II", writer + 5, writer)
    body = ids + struct.pack("<iII", 0, 2, 0) + bytes(4)
    return handmade.dds(time, host, handmade.submessage(6, body), to=to)


def call(*reader_at: float, replies: tuple[float, ...] = ()) -> Diagnosis:
    """Return the diagnosis of a request after 1 s, by when the reply's reader was announced."""
    found = [handmade.announce(0.0, 1), handmade.announce(0.0, 2)]
    for host, entity, topic in ((1, ASKS, REQUEST), (2, REPLIES, REPLY), (2, HEARS, REQUEST)):
        found.append(announced(0.2, host, 3 - host, entity, topic))
        writer = PUBLICATIONS if entity & 0xFF == 3 else SUBSCRIPTIONS
        found.append(confirmed(0.3, 3 - host, host, writer))
    found += [announced(time, 1, 2, READS, REPLY) for time in reader_at]
    found.append(confirmed(reader_at[-1] + 0.01, 2, 1, SUBSCRIPTIONS))
    found.append(handmade.dds(1.0, 1, handmade.sample(ASKS, 1), to=2))
    found += [handmade.dds(time, 2, handmade.sample(REPLIES, 1), to=1) for time in replies]
    found += [handmade.announce(float(time), host) for time in range(2, 12, 2) for host in (1, 2)]
    return ds.read_capture(io.BytesIO(handmade.pcap(sorted(found)))).diagnosis()


@pytest.mark.parametrize("reader_at", [(1.5,), (0.2, 1.5)], ids=["late", "lost at first"])
def test_a_request_before_the_reader_of_its_reply_is_named(reader_at: tuple[float, ...]) -> None:
    diagnosis = call(*reader_at)
    (finding,) = diagnosis.wrong
    assert (finding.kind, finding.hosts) == ("early requests", ("10.0.0.1", "10.0.0.2"))
    assert finding.evidence == (
        "/amcl/get_state (service): 10.0.0.1 called 10.0.0.2 at 1.0 s, but announced its "
        "reply reader only 0.5 s later; 1 request got no reply"
    )
    assert diagnosis.summary().startswith("Discovery is complete, but not healthy: ")
    assert "max_blocking_time" in finding.advice


@pytest.mark.parametrize(
    ("reader_at", "replies"),
    [((0.2,), ()), ((1.05,), ()), ((1.5,), (1.6,)), ((0.2, 1.5), (1.01,))],
    ids=["known before", "within the wait", "answered later", "repeated without need"],
)
def test_no_other_request_is(reader_at: tuple[float, ...], replies: tuple[float, ...]) -> None:
    assert call(*reader_at, replies=replies).wrong == ()
