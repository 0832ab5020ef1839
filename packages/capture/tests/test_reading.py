"""Captures are read as tshark and Zenoh's own log read them, from any file, and nothing breaks."""

import bz2
import csv
import gzip
import io
import json
import lzma
import os
import random
import re
import shutil
import struct
import subprocess
import time
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner
from handmade_captures import (
    CAPTURES,
    LINKS,
    Packet,
    ipv4_fragments,
    ipv6,
    ipv6_fragments,
    packets,
    pcap,
    pcapng,
    rewrap,
    rtps,
    submessage,
    tcp,
    udp,
    wifi,
)
from support import REFERENCE, skip_or_fail

import discostorm as ds
from discostorm.cli import main
from discostorm_capture import (
    Capture,
    CaptureError,
    pcap as files,
    read_capture,
    rtps as rtps_module,
)

#: What others list of the captures.
LISTED = REFERENCE / "captures"
DDS_CAPTURES = ["fast_dds", "cyclone_dds_010", "cyclone_dds_11"]
Read = Callable[[bytes], Capture]


@pytest.fixture
def read(tmp_path: Path) -> Read:
    """Return a function that reads the bytes of a file."""

    def read_bytes(content: bytes) -> Capture:
        path = tmp_path / "capture"
        path.write_bytes(content)
        return read_capture(path)

    return read_bytes


def captured(name: str) -> Capture:
    return read_capture(CAPTURES / f"{name}.pcap.xz")


def at(found: list[bytes], step: int = 1_000_000) -> list[Packet]:
    """Return packets a millisecond apart."""
    return [(10**18 + index * step, data, len(data)) for index, data in enumerate(found)]


def raw(*found: bytes, link: int = 101) -> bytes:
    """Return a file of IP packets, or of other frames, a millisecond apart."""
    return pcap(at([*found]), link)


def facts(capture: Capture) -> pd.DataFrame:
    """Return what does not depend on the frames around the packets."""
    columns = ["time", "kind", "multicast", "bytes", "process", "peer", "submessage", "reader"]
    found = capture.messages()[[*columns, "writer", "size", "ends", "transport"]]
    words = found.select_dtypes("category").columns
    return found.astype(dict.fromkeys(words, str))


# ---------------------------------------------------------------- second opinions

#: Submessages that are messages; the others say how to read them.
MESSAGES = {6, 7, 8, 0x12, 0x13, 0x15, 0x16}


def numbers(text: str, base: int = 10) -> list[int]:
    return [int(part, base) for part in text.split("|") if part]


def as_tshark_says(rows: list[dict[str, str]]) -> dict[int, tuple[object, ...]]:
    found = {}
    for row in rows:
        # It tells no size of a vendor's own, from 0x80 on.
        ids = [id_ for id_ in numbers(row["submessages"], 16) if id_ < 0x80]
        sizes = numbers(row["sizes"])
        chosen = [pair for pair in zip(ids, sizes, strict=True) if pair[0] in MESSAGES]
        entities = tuple(tuple(numbers(row[key], 16)) for key in ("readers", "writers"))
        if chosen:
            prefix = row["prefixes"].split("|")[0]
            found[int(row["frame"])] = (tuple(chosen), *entities, row["sender"], prefix)
    return found


def as_we_say(capture: Capture) -> dict[int, tuple[object, ...]]:
    ids = {name: number for number, name in enumerate(rtps_module.SUBMESSAGE_NAMES)}
    messages = capture.messages()
    found = {}
    for frame, rows in messages[messages["protocol"] == "RTPS"].groupby("frame"):
        kinds = [ids[name] for name in rows["submessage"]]
        (sender,) = set(rows["sender"])
        (process,) = set(rows["process"])
        found[frame] = (
            tuple(zip(kinds, rows["size"], strict=True)),
            tuple(rows["reader"]),
            tuple(rows["writer"]),
            sender,
            process,
        )
    return found


@pytest.mark.parametrize("name", DDS_CAPTURES)
def test_rtps_is_what_tshark_says_frame_by_frame(name: str) -> None:
    text = lzma.decompress((LISTED / f"{name}.tshark.csv.xz").read_bytes()).decode()
    expected = as_tshark_says(list(csv.DictReader(text.splitlines())))
    assert len(expected) > 40
    assert as_we_say(captured(name)) == expected


FIELDS = {
    "frame": "frame.number",
    "sender": "ip.src",
    "submessages": "rtps.sm.id",
    "sizes": "rtps.sm.octetsToNextHeader",
    "readers": "rtps.sm.rdEntityId",
    "writers": "rtps.sm.wrEntityId",
    "prefixes": "rtps.guidPrefix.src",
}


@pytest.mark.parametrize("link", LINKS)
def test_any_link_type_is_what_tshark_says(link: str, tmp_path: Path) -> None:
    if shutil.which("tshark") is None:
        skip_or_fail("no tshark here; on Debian: apt-get install tshark")
    path = tmp_path / "capture.pcap"
    number, wrap = LINKS[link]
    path.write_bytes(pcap(rewrap(packets("cyclone_dds_11"), wrap), number))
    command = [
        "tshark",
        "-n",
        "-Y",
        "rtps",
        "-T",
        "fields",
        "-E",
        "separator=,",
        "-E",
        "aggregator=|",
        "-r",
        str(path),
    ]
    fields = [part for field in FIELDS.values() for part in ("-e", field)]
    done = subprocess.run([*command, *fields], capture_output=True, text=True, check=True)
    rows = [dict(zip(FIELDS, line.split(","), strict=True)) for line in done.stdout.splitlines()]
    assert len(rows) > 40
    assert as_we_say(read_capture(path)) == as_tshark_says(rows)


def test_zenoh_is_what_its_own_log_says() -> None:
    rows = csv.DictReader((LISTED / "zenoh_data.trace.csv").read_text().splitlines())
    expected = {row["message"]: int(row["count"]) for row in rows}
    messages = captured("zenoh_data").messages()
    found = Counter(messages.loc[messages["protocol"] == "Zenoh", "submessage"])
    found.pop("Frame")  # of which the log says nothing
    assert found == expected


@pytest.mark.parametrize(
    ("name", "hosts", "processes", "endpoints"),
    [("fast_dds", 3, 2, 10), ("cyclone_dds_010", 2, 1, 4), ("cyclone_dds_11", 3, 1, 6)],
)
def test_the_fleet_is_the_one_that_was_run(
    name: str, hosts: int, processes: int, endpoints: int
) -> None:
    capture = captured(name)
    assert capture.fleet() == ds.Fleet.swarm(hosts, processes, endpoints)
    assert capture.notes == ()
    found = capture.processes()
    assert list(found["host"].value_counts()) == [processes] * hosts
    assert set(found["protocol"]) == {"RTPS"}
    product = "Fast DDS" if name == "fast_dds" else "Cyclone DDS"
    assert set(found["product"]) == {product}


def test_zenohs_fleet_is_its_subscribers_and_queryables() -> None:
    capture = captured("zenoh_data")
    # Publishers and tokens are not counted.
    assert capture.fleet() == ds.Fleet.swarm(3, 1, 5)
    assert set(capture.processes()["product"]) == {"Zenoh peer"}
    assert any("publishers" in note for note in capture.notes)


@pytest.mark.parametrize("name", [*DDS_CAPTURES, "zenoh_data"])
def test_bytes_and_frames_add_up_to_what_was_sent(name: str) -> None:
    rows = captured(name).messages()
    payload = pieces = 0
    for _, data, _ in packets(name):
        if data[12:14] != b"\x08\x00":
            continue
        ip = data[14 : 14 + struct.unpack_from(">H", data, 16)[0]]
        first = struct.unpack_from(">H", ip, 6)[0] & 0x1FFF == 0
        if ip[9] == 17:
            payload += len(ip) - 20 - 8 * first
        elif ip[9] == 6:
            payload += len(ip) - 20 - (ip[32] >> 4) * 4
        else:
            continue
        pieces += 1
    assert rows["bytes"].sum() == payload
    assert rows["frames"].sum() == pytest.approx(pieces, rel=1e-5)


# ---------------------------------------------------------------- files and links


@pytest.mark.parametrize("link", LINKS)
@pytest.mark.parametrize("name", ["cyclone_dds_11", "zenoh_data"])
def test_the_same_in_every_kind_of_frame(name: str, link: str, read: Read) -> None:
    number, wrap = LINKS[link]
    found = packets(name)
    same = read(pcap(rewrap(found, wrap), number))
    expected = read(pcap(rewrap(found, lambda ip: ip), 101))
    assert len(expected.messages()) > 100
    pd.testing.assert_frame_equal(facts(same), facts(expected))
    ways = {"radiotap": "down", "802.11": "up", "A-MSDU": "up"}
    way = next((way for start, way in ways.items() if link.startswith(start)), "")
    assert set(same.messages()["way"]) == {"" if "four" in link else way}


def test_the_same_from_every_kind_of_file(read: Read) -> None:
    found = packets("cyclone_dds_010")
    expected = facts(captured("cyclone_dds_010"))
    plain = pcap(found)
    files = [pcap(found, order=order, nano=nano) for order in "<>" for nano in (False, True)]
    files += [pcapng(found, order=order, resolution=r) for order in "<>" for r in (6, 9)]
    files += [
        gzip.compress(plain),
        lzma.compress(plain),
        gzip.compress(plain[:99]) + gzip.compress(plain[99:]),
    ]
    files += [lzma.compress(plain[:999]) + bytes(4) + lzma.compress(plain[999:])]
    for content in files:
        pd.testing.assert_frame_equal(facts(read(content)), expected)
    assert read(plain).start == pytest.approx(found[0][0] / 1e9)
    assert read(plain).duration == pytest.approx((found[-1][0] - found[0][0]) / 1e9)


@pytest.mark.parametrize("order", "<>")
def test_sections_of_one_file_have_one_byte_order(order: str, read: Read) -> None:
    found = packets("cyclone_dds_010")
    first = pcapng(found[:30], order=order)
    both = read(first + pcapng(found[30:], order=order, resolution=6))
    pd.testing.assert_frame_equal(facts(both), facts(captured("cyclone_dds_010")))
    other = pcapng(found[30:], order="<>".replace(order, ""))
    with pytest.raises(CaptureError, match=f"byte {len(first)}: a section with another byte order"):
        read(first + other)


def test_ipv6_with_extensions_and_in_fragments(read: Read) -> None:
    found = packets("cyclone_dds_11")
    expected = facts(read(pcap(rewrap(found, lambda ip: ip), 101)))
    for extension in (False, True):
        plain = read(pcap(rewrap(found, lambda ip, e=extension: ipv6(ip, e)), 229))
        pd.testing.assert_frame_equal(facts(plain), expected)
        assert set(plain.messages()["sender"]) == {f"fe80::a4d:{n:x}" for n in (1, 2, 3)}
    pieces = [
        (time, piece, len(piece))
        for number, (time, ip, _) in enumerate(rewrap(found, lambda ip: ip))
        for piece in ipv6_fragments(ip, 64, number)
    ]
    pd.testing.assert_frame_equal(facts(read(pcap(pieces, 229))), expected)
    shuffled = random.Random(1).sample(pieces, len(pieces))
    assert Counter(read(pcap(shuffled, 229)).messages()["kind"]) == Counter(expected["kind"])
    # Without one of its pieces a datagram is missing, and a note says so.
    some = read(pcap(pieces[:2] + pieces[3:], 229))
    assert len(some.messages()) < len(expected)
    assert any("lack fragments" in note for note in some.notes)


def test_shuffled_fragments_are_read_as_the_packets_that_they_complete(read: Read) -> None:
    """A segment of TCP in fragments is one of its stream, wherever its last fragment comes."""
    found = packets("zenoh_data")
    pieces = []
    for number, (when, frame, length) in enumerate(found):
        ip = frame[14 : 14 + int.from_bytes(frame[16:18], "big")]
        if frame[12:15] == b"\x08\0\x45" and len(ip) > 276:
            parts = [frame[:14] + part for part in ipv4_fragments(ip, 256, number + 1)]
            pieces += [(number, (when, part, len(part))) for part in parts]
        else:
            pieces.append((number, (when, frame, length)))
    for seed in (None, 1, 2):
        order = pieces if seed is None else random.Random(seed).sample(pieces, len(pieces))
        fragmented = read(pcap(packet for _, packet in order))
        last = {number: place for place, (number, _) in enumerate(order)}
        completed = sorted(last, key=lambda number: last[number])
        whole = read(pcap(found[number] for number in completed))
        columns = ["kind", "bytes", "sender", "receiver", "process", "peer"]
        pd.testing.assert_frame_equal(fragmented.messages()[columns], whole.messages()[columns])
        assert fragmented.notes == whole.notes


# ---------------------------------------------------------------- RTPS


def data(
    writer: int, reader: int = 0, little: bool = True, flags: int = 4, size: int = -1
) -> bytes:
    order = "<" if little else ">"
    body = struct.pack(order + "HH", 0, 16) + struct.pack(">II", reader, writer)
    return submessage(
        0x15, body + struct.pack(order + "iI", 0, 1) + b"\0\3\0\0\1\0\0\0", little, flags, size
    )


def control(kind: int, writer: int, reader: int = 0, little: bool = True) -> bytes:
    return submessage(kind, struct.pack(">II", reader, writer) + bytes(20), little)


def kinds(read: Read, *messages: bytes) -> list[str]:
    return list(read(raw(*map(udp, messages))).messages()["kind"])


def test_kinds_by_entity_in_both_byte_orders(read: Read) -> None:
    for little in (True, False):
        message = rtps(
            *(data(entity, little=little) for entity in (0x100C2, 0x3C2, 0x4C2, 0x200C2, 0x300C3)),
            *(control(7, entity, little=little) for entity in (0x3C2, 0xFF0004C2, 0x200C2, 0x102)),
            *(control(6, entity, little=little) for entity in (0x4C2, 0x301C3, 0x103)),
            control(8, 0x3C2, little=little),
            data(0x203, little=little),
            data(0x142, little=little),
        )
        assert kinds(read, message) == [
            *("SPDP", "SEDP", "SEDP", "Liveliness", "Type lookup"),
            *("Heartbeat", "Heartbeat", "Liveliness Heartbeat", "User Heartbeat"),
            *("ACKNACK", "Type lookup ACKNACK", "User ACKNACK"),
            *("Gap", "User data", "Vendor"),
        ]


def test_what_stands_between_messages(read: Read) -> None:
    other = bytes(range(20, 32))
    message = rtps(
        submessage(0x0E, other),
        submessage(0x09, bytes(8)),
        control(6, 0x3C2),
        submessage(0x80, bytes(4)),  # a vendor's
        submessage(0x01, b""),
        submessage(0x0C, bytes(8) + other),
        data(0x3C2, size=0),  # the last: its length may be left out
    )
    rows = read(raw(udp(rtps(data(0x100C2), prefix=other)), udp(message))).messages()
    assert list(rows["kind"]) == ["SPDP", "ACKNACK", "SEDP"]
    assert list(rows["peer"]) == ["", other.hex(), other.hex()]
    assert list(rows["process"]) == [other.hex(), bytes(range(12)).hex(), other.hex()]
    assert rows["bytes"].sum() == 2 * 20 + len(data(1)) * 2 + 16 + 12 + 32 + 8 + 4 + 24


def test_a_key_alone_takes_an_announcement_back(read: Read) -> None:
    capture = read(raw(udp(rtps(data(0x100C2))), udp(rtps(data(0x100C2, flags=8)))))
    assert list(capture.messages()["ends"]) == [False, True]
    assert capture.compare(ds.DDS).loc["SPDP", "unicast"] == 1


def test_what_is_encrypted_or_in_a_tunnel_is_noted(read: Read) -> None:
    spdp = udp(rtps(data(0x100C2)))
    capture = read(
        raw(
            udp(rtps(*(submessage(kind, bytes(8)) for kind in (0x31, 0x30, 0x32)))),
            udp(rtps(submessage(0x33, bytes(8)))),
            udp(b"\x16\xfe\xfd" + bytes(20)),
            udp(b"\xc0\0\0\0\1" + bytes(30)),
            *(udp(bytes([kind, 0, 0, 0]) + bytes(40), ports=(9, 51820)) for kind in (0, 1, 4, 5)),
            tcp(b"\x16\3\1\0\x50\1" + bytes(75), 5, ports=(9, 7447)),
            tcp(b"RTCP" + bytes(30), 5, ports=(9, 7400)),
            tcp(rtps(data(0x100C2)), 5, ports=(9, 7401)),
            *(spdp[:9] + bytes([protocol]) + spdp[10:] for protocol in (4, 41, 47, 50)),
            udp(bytes(8) + bytes(12) + b"\x08\x00" + spdp, ports=(50000, 4789)),
        )
    )
    assert list(capture.messages()["kind"]) == ["Encrypted", "Encrypted"]
    assert set(capture.notes) == {
        "2 RTPS messages are encrypted by DDS Security; they count as discovery, "
        "though some may be user data",
        "1 of 1 processes announced nothing in this capture, so their endpoints are not known",
        "1 datagrams of DTLS, which are encrypted",
        "1 datagrams of QUIC, which are encrypted",
        "2 datagrams of WireGuard, which are encrypted",
        "1 TCP connections are encrypted (TLS)",
        "2 TCP segments with RTPS over TCP",
        "1 encrypted IP packets",
        "4 packets in a tunnel (GRE, IP in IP, VXLAN, Geneve), which are not read",
    }


def test_domains_are_told_apart_by_the_ports_of_spdp(read: Read) -> None:
    def notes(*ports: int, target: int = 0xEFFF0001) -> list[str]:
        spdp = [udp(rtps(data(0x100C2)), ports=(7411, port)) for port in ports]
        group = struct.pack(">I", target)
        capture = read(raw(*(ip[:16] + group + ip[20:] for ip in spdp)))
        return [note for note in capture.notes if "domains" in note]

    (note,) = notes(7400, 7400, 8650, 7401, 11811)
    assert note.startswith("2 RTPS domains (0, 5): ")
    assert notes(7400, 7400) == notes(7400, 7650, target=0x0A000002) == []


def test_a_cut_capture_counts_what_is_there_and_says_so(read: Read) -> None:
    found = packets("cyclone_dds_11")
    cut = read(pcap([(when, packet[:130], length) for when, packet, length in found]))
    expected = captured("cyclone_dds_11")
    assert 0 < len(cut.messages()) < len(expected.messages())
    assert "lower bounds" in cut.notes[0]


# ---------------------------------------------------------------- views


def test_any_shows_a_packet_more_than_once_but_it_is_compared_once(read: Read) -> None:
    found = packets("cyclone_dds_11")
    views = [
        (
            when + view * 1000,
            struct.pack(">HHIHBB8s", 0x800, 0, view + 1, 1, 0, 4 * view, bytes(8)) + data_[14:],
            0,
        )
        for when, data_, _ in found
        if data_[12:14] == b"\x08\x00"
        for view in (0, 1)
    ]
    twice = read(pcap([(when, data_, len(data_)) for when, data_, _ in views], 276))
    once = captured("cyclone_dds_11")
    assert len(twice.messages()) == 2 * len(once.messages())
    assert twice.messages()["copy"].sum() == len(once.messages())
    assert any("are copies" in note for note in twice.notes)
    pd.testing.assert_frame_equal(twice.compare(ds.DDS), once.compare(ds.DDS))


def test_up_and_down_again_is_one_message(read: Read) -> None:
    found = packets("zenoh_data")
    both = [
        (when + flags * 100_000, wifi(data_[14:], flags=flags), 0)
        for when, data_, _ in found
        if data_[12:14] == b"\x08\x00"
        for flags in (1, 2)
    ]
    capture = read(pcap([(when, data_, len(data_)) for when, data_, _ in both], 105))
    once = captured("zenoh_data")
    pd.testing.assert_frame_equal(capture.compare(ds.ZENOH), once.compare(ds.ZENOH))
    scouts = capture.messages().query("kind == 'Scout'")
    assert list(scouts["way"].unique()) == ["up", "down"]


def view_of(address: bytes, found: list[Packet]) -> list[Packet]:
    """Return what the host of an address sees of IPv4."""
    return [
        packet
        for packet in found
        if packet[1][12:14] == b"\x08\x00"
        and (address in (packet[1][26:30], packet[1][30:34]) or packet[1][30] >= 224)
    ]


def with_matches(found: list[Packet], writers: int) -> list[Packet]:
    """Return packets, and acknowledgements of so many user writers by all processes elsewhere."""
    hosts = captured("fast_dds").processes()["host"].items()
    address = {process: bytes(map(int, host.split("."))) for process, host in hosts}
    more = []
    for process, here in address.items():
        for peer, there in address.items():
            for writer in range(writers * (here != there)):
                body = rtps(
                    submessage(0x0E, bytes.fromhex(peer)),
                    control(6, writer << 8 | 0x03, reader=writer << 8 | 0x04),
                    prefix=bytes.fromhex(process),
                )
                frame = (
                    found[0][1][:12] + b"\x08\x00" + udp(body)[:12] + here + there + udp(body)[20:]
                )
                more.append((found[-1][0], frame, len(frame)))
    return found + more


def test_one_robots_view_shows_the_whole_fleet_and_its_own_pairs(read: Read) -> None:
    everybody = captured("fast_dds")
    capture = read(pcap(view_of(b"\x0a\x4d\0\1", packets("fast_dds"))))
    assert capture.vantage_host() == "10.77.0.1"
    assert everybody.vantage_host() is None
    assert capture.fleet() == everybody.fleet()
    table, whole = capture.compare(ds.DDS), everybody.compare(ds.DDS)
    # Of three hosts' six ordered pairs four have the one.
    assert table.loc["SEDP", "units"] == whole.loc["SEDP", "units"] * 4 / 6
    assert table.loc["SPDP", "units"] == whole.loc["SPDP", "units"]
    assert table.loc["SEDP", "per_unit"] == pytest.approx(whole.loc["SEDP", "per_unit"], rel=0.03)


def test_one_robots_view_is_told_with_whole_messages(tmp_path: Path) -> None:
    for name, content in (("mine", view_of(b"\x0a\x4d\0\1", packets("fast_dds"))), ("all", None)):
        (tmp_path / name).write_bytes(pcap(packets("fast_dds") if content is None else content))
    mine, everybody = (
        CliRunner()
        .invoke(main, ["capture", str(tmp_path / name), "--against", "Fast DDS 2.9"])
        .output
        for name in ("mine", "all")
    )
    seen = "Note: the capture shows only unicast to or from 10.77.0.1, so the airtime covers"
    assert seen in mine
    assert "only unicast from" not in everybody
    table = [line.split() for line in everybody.splitlines() if re.search(r"\d\.\d{4}$", line)]
    assert table
    lines = captured("fast_dds").compare(ds.PROTOCOLS["Fast DDS"]).dropna(subset="expected")
    expected = {f"{count:,.0f}" for count in lines["expected"]}
    assert expected <= {word for row in table for word in row}


@pytest.mark.parametrize("writers", [0, 2, 5])
def test_one_robots_view_tells_how_far_all_match(writers: int, read: Read) -> None:
    found = with_matches(packets("fast_dds"), writers)
    for content, pairs in ((found, 24), (view_of(b"\x0a\x4d\0\1", found), 16)):
        table = read(pcap(content)).compare(ds.PROTOCOLS["Fast DDS"])
        assert table.loc["User ACKNACK", "units"] == pytest.approx(pairs * writers)
        assert table.loc["User ACKNACK", "unicast"] == pairs * writers


def test_one_robots_view_of_zenoh_expects_what_it_shows_of_all(read: Read) -> None:
    found = packets("zenoh_data")
    for name in ("Zenoh peer", "Zenoh peer, tokens"):
        mine = read(pcap(view_of(b"\x0a\x4d\0\1", found))).compare(ds.PROTOCOLS[name])
        whole = captured("zenoh_data").compare(ds.PROTOCOLS[name])
        for kind in ("Declare", "Declare key expression"):
            assert mine.loc[kind, "expected"] == pytest.approx(whole.loc[kind, "expected"] * 4 / 6)


# ---------------------------------------------------------------- TCP and Zenoh


def batch(content: bytes) -> bytes:
    return struct.pack("<H", len(content)) + content


ZID = bytes(range(1, 17))
INIT_SYN = batch(b"\x01\x09\xf1" + ZID)
KEEP_ALIVE = batch(b"\x04")
#: Declares the subscribers 1 to 9 in one frame.
DECLARE = batch(
    b"\x25\x07" + b"".join(b"\x1e\x22" + bytes([n, 0, 3]) + b"a/b" for n in range(1, 10))
)


def session(*parts: bytes, start: int = 2**32 - 20, init: bytes = INIT_SYN) -> list[bytes]:
    """Return segments of one side, of which the numbers run over their end."""
    found = [tcp(b"", start, flags=2)]
    at_ = start + 1
    for part in (init, *parts):
        found.append(tcp(part, at_))
        at_ += len(part)
    return found


def zenoh_kinds(capture: Capture) -> list[str]:
    rows = capture.messages()
    return list(rows.loc[rows["protocol"] == "Zenoh", "kind"])


EXPECTED = ["Init", "Frame", *["Declare"] * 9, "KeepAlive", "KeepAlive"]


@pytest.mark.parametrize("size", [1, 2, 7, 40, 1000])
def test_batches_in_segments_of_any_size(size: int, read: Read) -> None:
    whole = DECLARE + KEEP_ALIVE + KEEP_ALIVE
    parts = [whole[place : place + size] for place in range(0, len(whole), size)]
    capture = read(raw(*session(*parts)))
    assert zenoh_kinds(capture) == EXPECTED
    assert capture.processes().index[0] == f"{int.from_bytes(ZID, 'little'):x}"
    assert capture.processes()["endpoints"].to_list() == [9]


@pytest.mark.parametrize("size", [1, 7])
def test_a_session_whose_first_segment_is_a_part_of_it(size: int, read: Read) -> None:
    whole = INIT_SYN + DECLARE + KEEP_ALIVE + KEEP_ALIVE
    first, *parts = (whole[place : place + size] for place in range(0, len(whole), size))
    assert zenoh_kinds(read(raw(*session(*parts, init=first)))) == EXPECTED


def test_sent_again_reordered_overlapping(read: Read) -> None:
    whole = DECLARE + KEEP_ALIVE + KEEP_ALIVE
    parts = [whole[place : place + 9] for place in range(0, len(whole), 9)]
    start = session(*parts)
    assert zenoh_kinds(read(raw(*start))) == EXPECTED
    for seed in range(20):
        order = random.Random(seed)
        mixed = start[:2] + order.sample(start[2:], len(start) - 2)
        # Some once more, one of them with what comes after it.
        again = tcp(whole[5:30], 2**32 - 19 + len(INIT_SYN) + 5)
        for extra in (start[3], start[4], again):
            mixed.insert(order.randrange(2, len(mixed)), extra)
        capture = read(raw(*mixed))
        assert sorted(zenoh_kinds(capture)) == sorted(EXPECTED)
        assert (capture.messages()["kind"] == "TCP retransmission").sum() >= 1


def test_a_gap_is_noted_and_what_follows_it_is_read(read: Read) -> None:
    found = session(*[KEEP_ALIVE] * 5, DECLARE[:20], DECLARE[20:], *[KEEP_ALIVE] * 4)
    capture = read(raw(*found[:7], *found[8:]))
    assert zenoh_kinds(capture) == ["Init", *["KeepAlive"] * 9]
    assert any("gaps" in note for note in capture.notes)


def test_a_part_of_a_message_that_looks_like_a_batch_does_not_end_the_reading(read: Read) -> None:
    payload = b"\x09\x00\x25" + bytes(30)  # as of a Frame of nine bytes, followed by nothing
    found = session(KEEP_ALIVE, DECLARE[:20], payload, *[KEEP_ALIVE] * 4)
    capture = read(raw(*found[:3], *found[4:]))
    assert zenoh_kinds(capture) == ["Init", *["KeepAlive"] * 5]


@pytest.mark.parametrize("first", [1, 2])
def test_a_session_that_was_open_before(first: int, read: Read) -> None:
    capture = read(raw(*session(DECLARE, *[KEEP_ALIVE] * 3)[first:]))
    assert zenoh_kinds(capture) == [*EXPECTED[first - 1 :], "KeepAlive"]


@pytest.mark.parametrize(
    ("frame", "is_zenoh"),
    [(b"\x25\x07\x04", False), (b"\x26\x07\x04", False), (DECLARE[2:], True)],
)
def test_a_frame_of_three_bytes_carries_no_message(
    frame: bytes, is_zenoh: bool, read: Read
) -> None:
    # A session that was open before, at a port of its own: only its segments tell.
    found = session(*[batch(frame)] * 5)[2:]
    other = [ip[:22] + struct.pack(">H", 5000) + ip[24:] for ip in found]
    assert (not read(raw(*other)).messages().empty) is is_zenoh


def test_other_connections_are_left_alone(read: Read) -> None:
    lines = [b"GET / HTTP/1.1\r\nHost: a\r\n\r\n", b"abc" * 50]
    capture = read(raw(*session(*lines, init=b"hello")))
    assert capture.messages().empty


@pytest.mark.parametrize(("extension", "word"), [(6, "compression"), (5, "low latency")])
def test_what_is_compressed_or_of_low_latency_is_left_out(
    extension: int, word: str, read: Read
) -> None:
    init = batch(b"\x81\x09\xf1" + ZID + bytes([extension]))
    answer = batch(b"\xa1\x09\xf1" + ZID[::-1] + b"\x01c" + bytes([extension]))
    opened = batch(b"\x02\x0a\x01\x01c")
    there = session(opened, b"\x07\0\0\0garbage" * 3, init=init)
    back = [tcp(b"", 7, flags=0x12, back=True), tcp(answer, 8, back=True)]
    capture = read(raw(*there[:1], *back, *there[1:]))
    assert sorted(zenoh_kinds(capture)) == ["Init", "Init", "Open"]
    assert any(word in note for note in capture.notes)
    # Asked for, but not agreed on: as always.
    plain = tcp(batch(b"\x21\x09\xf1" + ZID[::-1] + b"\x01c"), 8, back=True)
    there = session(opened, DECLARE, init=init)
    capture = read(raw(there[0], back[0], there[1], plain, *there[2:]))
    assert len(zenoh_kinds(capture)) == 3 + 10


def over_udp(*batches: bytes, port: int = 7447) -> list[bytes]:
    """Return datagrams of one side of a session: batches without their lengths."""
    return [udp(part[2:], ports=(40000, port)) for part in batches]


#: What the other side answers to `INIT_SYN`; it has the endpoints of `DECLARE` as well.
INIT_ACK = b"\x21\x09\xf1" + ZID[::-1] + b"\x01c"


def test_sessions_over_udp(read: Read) -> None:
    answer = udp(INIT_ACK, 2, 1, ports=(7447, 40000))
    init, *rest = over_udp(INIT_SYN, DECLARE, KEEP_ALIVE)
    capture = read(raw(init, answer, *rest))
    assert zenoh_kinds(capture) == ["Init", *EXPECTED[:-1]]
    rows, processes = capture.messages(), capture.processes()
    assert set(rows["transport"]) == {"UDP"}
    assert list(processes["endpoints"]) == [9, 0]
    assert list(processes["host"]) == ["10.0.0.1", "10.0.0.2"]
    assert (rows["process"].iloc[3], rows["peer"].iloc[3]) == tuple(processes.index)
    assert rows["bytes"].sum() == sum(len(part) - 28 for part in (init, answer, *rest))


@pytest.mark.parametrize("port", [7447, 5000])
def test_datagrams_of_a_session_in_ip_fragments(port: int, read: Read) -> None:
    # What opens the session is in one piece, and what is declared in fragments of IP.
    init, *rest = over_udp(INIT_SYN, DECLARE, DECLARE, KEEP_ALIVE, port=port)
    pieces = [piece for id_, ip in enumerate(rest) for piece in ipv4_fragments(ip, 24, id_ + 2)]
    capture = read(raw(init, *pieces))
    assert zenoh_kinds(capture) == [*EXPECTED[:-2], *EXPECTED[1:-2], "KeepAlive"]
    assert list(capture.processes()["endpoints"]) == [9]
    assert capture.messages()["frames"].sum() == pytest.approx(1 + len(pieces))
    assert not any("announcement" in note for note in capture.notes)
    assert any("lack fragments" in note for note in read(raw(init, *pieces[1:])).notes)


def test_messages_in_fragments_of_zenoh_over_udp(read: Read) -> None:
    content = DECLARE[4:]
    parts = [
        batch(b"\x66\x01" + content[:20]),
        batch(b"\x26\x02" + content[20:]),
    ]
    capture = read(raw(*over_udp(INIT_SYN, *parts)))
    assert sorted(zenoh_kinds(capture)) == sorted(["Init", *["Fragment"] * 2, *["Declare"] * 9])
    assert list(capture.processes()["endpoints"]) == [9]


def test_every_datagram_of_zenoh_that_is_not_read_has_its_note(read: Read) -> None:
    # Of a session that was open before, all that can be read is.
    late = over_udp(DECLARE, KEEP_ALIVE)
    capture = read(raw(*late))
    assert zenoh_kinds(capture) == EXPECTED[1:-1]
    assert not any("not read" in note for note in capture.notes)
    # At its port, what is none of it; elsewhere it is of somebody else.
    garbage = [udp(b"\x1bgarbage", ports=(40001, port)) for port in (7447, 7447, 5353)]
    notes = read(raw(*garbage, *late)).notes
    assert [note for note in notes if "not read" in note] == [
        "2 UDP datagrams at Zenoh's ports were not read: they are not Zenoh, or are encrypted or "
        "compressed"
    ]
    # In a session that was opened.
    broken = [*over_udp(INIT_SYN, KEEP_ALIVE), udp(b"\x1bgarbage", ports=(40000, 7447))]
    assert any(
        "1 batches of Zenoh that cannot be read" in note for note in read(raw(*broken)).notes
    )


@pytest.mark.parametrize(("extension", "word"), [(6, "compression"), (5, "low latency")])
def test_compressed_over_udp(extension: int, word: str, read: Read) -> None:
    init = batch(INIT_SYN[2:3].replace(b"\x01", b"\x81") + INIT_SYN[3:] + bytes([extension]))
    answer = b"\xa1" + INIT_ACK[1:] + bytes([extension])
    there = over_udp(init, batch(b"\x02\x0a\x01\x01c"), batch(b"\x1bgarbage"))
    capture = read(raw(there[0], udp(answer, 2, 1, ports=(7447, 40000)), *there[1:]))
    assert zenoh_kinds(capture) == ["Init", "Init", "Open"]
    assert any(note == f"8 bytes of Zenoh sessions with {word}" for note in capture.notes)


def test_a_group_that_peers_join_over_udp(read: Read) -> None:
    join = b"\x07\x09\xf1" + ZID + b"\x0a\x01\x01"
    packets_ = [udp(part, ports=(7450, 7450)) for part in (join, DECLARE[2:])]
    to_all = [ip[:16] + bytes([224, 0, 0, 225]) + ip[20:] for ip in packets_]
    capture = read(raw(*to_all))
    assert zenoh_kinds(capture) == ["Join", *EXPECTED[1:-2]]
    assert list(capture.processes()["endpoints"]) == [9]


# ---------------------------------------------------------------- results


def test_columns_and_types() -> None:
    messages = captured("zenoh_data").messages()
    assert list(messages.columns[:9]) == [
        *("time", "frame", "protocol", "kind", "multicast", "bytes", "sender", "receiver", "way")
    ]
    assert messages["frame"].is_monotonic_increasing
    assert messages["frame"].min() >= 1
    assert not messages.isna().any().any()
    for column in messages.select_dtypes("category"):
        assert set(messages[column].cat.categories) == set(messages[column])


def test_what_is_returned_can_be_changed_without_harm() -> None:
    capture = captured("cyclone_dds_010")
    messages, processes = capture.messages(), capture.processes()
    messages["bytes"] = 0
    processes["endpoints"] = 0
    assert capture.messages()["bytes"].sum() > 0
    assert capture.fleet() == ds.Fleet.swarm(2, 1, 4)


def test_compare_holds_the_capture_against_the_table() -> None:
    capture = captured("fast_dds")
    table = capture.compare(ds.DDS)
    assert list(table.index[:4]) == [message.name for message in ds.DDS.messages]
    columns = ["units", "expected", "unicast", "multicast", "per_unit", "bytes", "airtime_s"]
    assert list(table.columns) == columns
    fleet = capture.fleet()
    for message in ds.DDS.messages:
        row = table.loc[message.name]
        assert row["units"] == message.unit.count(fleet)
        assert row["expected"] == message.load(fleet)
        assert row["per_unit"] == (row["unicast"] + row["multicast"]) / row["units"]
    assert table.loc["SEDP", "expected"] == 240
    others = table.loc[["Liveliness Heartbeat", "Liveliness ACKNACK"]]
    assert others["units"].isna().all()
    assert table["airtime_s"].sum() == pytest.approx(capture.airtime().sum())
    half = capture.compare(ds.DDS, ds.Fleet.swarm(3, 1, 10))
    assert half.loc["SPDP", "units"] == 3


def test_expected_follows_the_schedule() -> None:
    message = ds.DDS.messages[0]
    capture = captured("fast_dds")
    again = ds.Message(
        **{
            name: getattr(message, name)
            for name in ("name", "phase", "cast", "transport", "payload", "unit", "per_unit")
        },
        schedule=ds.Schedule((0.0,), period=3.0),
    )
    table = capture.compare(ds.Protocol("again", (again,)))
    first = capture.messages()["time"].iloc[0]
    assert table.loc["SPDP", "expected"] == 6 * (1 + np.floor((capture.duration - first) / 3))


def test_airtime_is_that_of_the_model() -> None:
    capture = captured("cyclone_dds_010")
    messages = capture.messages()
    whole = messages[messages["frames"] == 1].index
    assert len(whole) > 5
    for row in whole:
        size = messages.loc[row, "bytes"] + 64
        down = (
            8 * size / 6e6 + 120e-6
            if messages.loc[row, "multicast"]
            else 8 * size / 144.4e6 + 180e-6
        )
        assert capture.airtime()[row] == pytest.approx(8 * size / 144.4e6 + 180e-6 + down)
    assert capture.airtime(ds.WIFI["802.11ac 80 MHz 2x2"]).sum() < capture.airtime().sum()


def test_the_picture_shows_all_airtime() -> None:
    capture = captured("zenoh_data")
    above, below = capture.picture().axes
    bars = above.patches
    assert sum(bar.get_height() for bar in bars) == pytest.approx(
        len(capture._messages_without_shutdown())
    )
    seconds = sum(bar.get_height() * bar.get_width() for bar in below.patches)
    assert seconds == pytest.approx(
        capture.airtime()[capture._messages_without_shutdown().index].sum()
    )


def test_nothing_found(read: Read) -> None:
    capture = read(pcap([]))
    assert capture.messages().empty
    assert (capture.packets, capture.duration) == (0, 0.0)
    with pytest.raises(CaptureError, match="no messages from any process"):
        capture.fleet()
    with pytest.raises(CaptureError, match="no message"):
        capture.picture()
    assert capture.compare(ds.DDS, ds.Fleet.swarm(2, 1, 1))["unicast"].sum() == 0


@pytest.mark.parametrize("name", ["protocol", "wifi", "fleet"])
def test_wrong_arguments(name: str) -> None:
    arguments = {"protocol": ds.DDS} | {name: 3}
    with pytest.raises(TypeError, match=name):
        captured("cyclone_dds_010").compare(**arguments)  # type: ignore[arg-type]


def test_a_fleet_to_compare_with_is_of_single_numbers() -> None:
    with pytest.raises(TypeError, match="hosts must be one number, not an array"):
        captured("cyclone_dds_010").compare(ds.DDS, ds.Fleet.swarm([2, 3], 1, 4))
    with pytest.raises(TypeError, match="hosts must be a number here"):
        captured("cyclone_dds_010").compare(ds.DDS, ds.Fleet.symbolic(1))


# ---------------------------------------------------------------- files and clocks


@pytest.mark.parametrize("order", "<>")
@pytest.mark.parametrize("make", [pcap, pcapng])
def test_packets_are_those_written_to_the_file(
    make: Callable[..., bytes], order: str, tmp_path: Path
) -> None:
    expected = packets("fast_dds")
    path = tmp_path / "capture"
    content = make(expected, order=order)
    path.write_bytes(content)
    found = files.read_packets(path)
    table = {name: column.tolist() for name, column in found.table.items()}
    assert table["time"] == [when for when, _, _ in expected]
    assert table["length"] == [length for _, _, length in expected]
    # In pcapng zeros fill up to four bytes, and the length stands at the end again.
    header, behind = (16, 0) if make is pcap else (28, 4)
    ends = []
    for place, size, (_, frame, _) in zip(table["at"], table["size"], expected, strict=True):
        assert found.data[place : place + size].tobytes() == frame
        ends.append(place + size + (-size % 4 if behind else 0) + behind)
    assert ends[-1] == len(content)
    for place in (len(content) - 1, table["at"][400] + 9, len(content) // 2):
        path.write_bytes(content[:place])
        whole = sum(end <= place for end in ends)
        with pytest.raises(CaptureError, match="truncated or corrupt") as error:
            files.read_packets(path)
        # Where the header of the first that is not whole stands.
        assert f": byte {table['at'][whole] - header}: " in str(error.value)


def test_a_clock_that_is_set_back(read: Read) -> None:
    some = packets("fast_dds")
    hour = 3600 * 10**9
    late = [(when - (turn >= 500) * hour, *rest) for turn, (when, *rest) in enumerate(some)]
    straight, capture = read(pcap(some)), read(pcap(late))
    messages = capture.messages()
    assert (messages["time"] >= 0).all()
    assert messages["time"].min() < 1
    assert capture.start == pytest.approx(straight.start - 3600, abs=60)
    assert 3600 - 60 < capture.duration < 3600 + 60
    assert capture.fleet() == straight.fleet()
    kinds_ = [rows.messages()["kind"].value_counts().to_dict() for rows in (straight, capture)]
    assert kinds_[0] == kinds_[1]
    assert len(capture.picture().axes) == 2


@pytest.mark.parametrize(("seconds", "copy"), [(0.9, True), (1.0, True), (1.1, False)])
def test_another_interface_shows_a_packet_again_within_a_second(
    seconds: float, copy: bool, read: Read
) -> None:
    packet = udp(rtps(data(0x100C2)))
    found = [(10**18 + int(turn * seconds * 1e9), packet, len(packet)) for turn in (0, 1)]
    capture = read(pcapng(found, links=(101, 101)))
    assert list(capture.messages()["copy"]) == [False, copy]


@pytest.mark.parametrize(
    ("seconds", "step"), [(29, ()), (31, (31,)), (59, (59,)), (-0.9, ()), (-1.1, (-1.1,))]
)
def test_a_clock_was_set_if_time_goes_back_or_far_on(
    seconds: float, step: tuple[float, ...], read: Read
) -> None:
    packet = udp(rtps(data(0x100C2)))
    found = [(10**18 + int(turn * seconds * 1e9), packet, len(packet)) for turn in (0, 1)]
    steps = read(pcap(found, 101))._recording.clock_steps
    assert [frame for frame, _ in steps] == [2] * len(step)
    assert [by for _, by in steps] == pytest.approx(step)


def secured(length: int, transformation: int = 2) -> bytes:
    """Return a submessage of so many bytes that DDS Security encrypts, or signs."""
    prefix = submessage(0x31, bytes([0, 0, 0, transformation]) + b"\0\0\0\7" + bytes(12))
    return prefix + submessage(0x30, bytes(length)) + submessage(0x32, bytes(8))


@pytest.mark.parametrize(("length", "count"), [(16, 0), (20, 0), (21, 1), (24, 1)])
def test_an_encrypted_info_is_no_message(length: int, count: int, read: Read) -> None:
    # The longest, an INFO_DST, has 20 bytes when it is encrypted.
    assert kinds(read, rtps(secured(length))) == ["Encrypted"] * count
    assert kinds(read, rtps(secured(100, transformation=1)))[:1] != ["Encrypted"]


# ---------------------------------------------------------------- broken files

PLAIN = pcap(packets("cyclone_dds_010"))
NG = pcapng(packets("cyclone_dds_010"))


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "it is empty"),
        (b"\xd4\xc3", "neither"),
        (b"# a text file", "neither a pcap nor a pcapng file; it starts with 23 20 61 20"),
        (PLAIN[:20], "byte 20: it ends inside its header"),
        (PLAIN[:-1], "packet 69 is truncated"),
        (PLAIN + b"x", "is truncated or corrupt"),
        (
            PLAIN[:32] + b"\xff\xff\xff\x7f" + PLAIN[36:],
            "byte 24: packet 1 is truncated or corrupt",
        ),
        (NG[:-3], "is truncated or corrupt"),
        (NG[:8] + bytes(4) + NG[12:], "byte 0: a section without a byte order"),
        (NG[:4] + bytes(4) + NG[8:], "byte 0: a block of 0 bytes is truncated or corrupt"),
        (NG[:28] + NG[60:], "a packet of an undefined interface"),
        (gzip.compress(PLAIN)[:-9], "compressed data"),
        (lzma.compress(PLAIN)[:-9], "compressed data"),
        (gzip.compress(PLAIN) + b"more", "compressed data"),
        (gzip.compress(b"not a capture"), "neither a pcap nor a pcapng file"),
        (gzip.compress(b""), "it is empty"),
        (bz2.compress(PLAIN), "compressed by bzip2: decompress it first"),
        (b"\x28\xb5\x2f\xfd" + PLAIN, "compressed by zstd: decompress it first"),
        (b"\x04\x22\x4d\x18" + PLAIN, "compressed by lz4: decompress it first"),
        (gzip.compress(b"PK\x03\x04" + PLAIN), "compressed by zip: decompress it first"),
        (lzma.compress(PLAIN[:24] + bytes(200_000_000), preset=0), "decompresses to more than"),
    ],
    # Not the bytes of the files: those of gzip hold the time.
    ids=lambda value: value.split(";")[0] if isinstance(value, str) else "file",
)
def test_broken_files_say_what_and_where(content: bytes, words: str, tmp_path: Path) -> None:
    path = tmp_path / "broken.pcap"
    path.write_bytes(content)
    started = time.process_time()
    with pytest.raises(CaptureError) as error:
        read_capture(path)
    assert time.process_time() - started < 1
    assert str(error.value).startswith(f"{path}: byte ")
    assert words in str(error.value)
    done = CliRunner().invoke(main, ["capture", str(path)])
    assert done.exit_code == 2
    assert words.split(";")[0] in " ".join(done.output.split())


def test_a_folder_and_a_missing_file(tmp_path: Path) -> None:
    with pytest.raises(CaptureError, match="must be a file"):
        read_capture(tmp_path)
    with pytest.raises(FileNotFoundError):
        read_capture(tmp_path / "none")
    done = CliRunner().invoke(main, ["capture", str(tmp_path / "none")])
    assert (done.exit_code, "No such file" in done.output) == (2, True)


def test_streams_are_read_to_their_end(tmp_path: Path) -> None:
    expected = facts(captured("cyclone_dds_010"))
    for content in (PLAIN, NG, gzip.compress(PLAIN)):
        pd.testing.assert_frame_equal(facts(read_capture(io.BytesIO(content))), expected)
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with ThreadPoolExecutor(1) as pool:
        written = pool.submit(pipe.write_bytes, PLAIN)
        pd.testing.assert_frame_equal(facts(read_capture(pipe)), expected)
        written.result()
    done = CliRunner().invoke(main, ["capture", "-", "--json"], input=PLAIN)
    assert json.loads(done.output)["packets"] == 69
    for content, words in ((PLAIN[:-1], "packet 69 is truncated"), (b"", "it is empty")):
        with pytest.raises(CaptureError, match=words):
            read_capture(io.BytesIO(content))
    done = CliRunner().invoke(main, ["capture", "-", "--fleet", "-"], input=PLAIN)
    assert (done.exit_code, "cannot both be -, standard input" in done.output) == (2, True)


@pytest.mark.parametrize("path", [None, 3, b"bytes", io.StringIO("text")])
def test_what_is_no_path_is_named(path: Any) -> None:
    with pytest.raises(TypeError, match=r"^path must be"):
        read_capture(path)


def test_pppoe_is_read_and_other_types_are_noted(read: Read) -> None:
    found = packets("cyclone_dds_010")
    ethernet = bytes(12)
    session = b"\x88\x64\x11\0\0\1\0\0"
    same = read(pcap(rewrap(found, lambda ip: ethernet + session + b"\0\x21" + ip)))
    pd.testing.assert_frame_equal(facts(same), facts(captured("cyclone_dds_010")))
    others = {b"\x88\x47": 3, b"\x08\x06": 2, b"\x89\x0d": 1, session + b"\xc0\x21": 4}
    more = [
        frame for kind, count in others.items() for frame in [ethernet + kind + bytes(60)] * count
    ]
    # Of ARP and of PPP's echoes nothing is said: there is never anything in them.
    assert read(pcap(at(more))).notes == (
        "3 frames have EtherType 0x8847, which we do not read",
        "1 frames have EtherType 0x890d, which we do not read",
    )
    broken = [ethernet + b"\x08\0" + first + bytes(40) for first in (b"\x41", b"\x15", b"\x95")]
    assert read(pcap(at(broken))).notes == (
        "2 packets that are said to be IP, and are not",
        "1 IP packets with a broken header",
    )


def test_fragments_seen_twice_count_as_whole_packets_do(read: Read) -> None:
    def notes_and_kinds(pieces: list[bytes]) -> tuple[tuple[str, ...], list[str]]:
        capture = read(pcap(at(pieces), 229))
        notes = tuple(note for note in capture.notes if "fragments" in note)
        return notes, list(capture.messages()["kind"])

    whole = udp(rtps(data(0x100C2), data(0x3C2)))
    kinds_ = ["SPDP", "SEDP"]
    missing = ("1 IP datagrams lack fragments",)
    one, two, _ = pieces = ipv6_fragments(whole, 40, 1)
    for turns in (pieces, pieces[::-1]):
        assert notes_and_kinds(turns * 2) == ((), kinds_ * 2)
        assert notes_and_kinds([piece for piece in turns for _ in range(2)]) == ((), kinds_ * 2)
        for again in pieces:
            assert notes_and_kinds([*turns, again]) == ((), kinds_)
            assert notes_and_kinds([again, *turns]) == ((), kinds_)
    assert notes_and_kinds([one, one, two, two]) == (missing, [])
    other = ipv6_fragments(udp(rtps(data(0x3C2), data(0x100C2))), 40, 1)
    assert notes_and_kinds([*pieces, *other[:2]]) == (missing, kinds_)


def test_a_single_cut_datagram_is_no_gap_of_the_capture(read: Read) -> None:
    cut = [ipv6_fragments(udp(rtps(data(0x100C2))), 40, number)[0] for number in (1, 2)]
    assert read(pcap(at(cut[:1]), 229))._recording.gaps == ()  # it ended meanwhile
    assert read(pcap(at(cut), 229))._recording.gaps == ("2 IP datagrams lack fragments",)


@pytest.mark.parametrize(("seconds", "complete"), [(45, True), (59.9, True), (60.1, False)])
def test_fragments_of_a_datagram_come_within_a_minute(
    seconds: float, complete: bool, read: Read
) -> None:
    first, *rest = ipv4_fragments(udp(rtps(data(0x100C2))), 24, 7)
    found = at([first, *rest], step=0)
    late = [(when + int(seconds * 1e9), *packet) for when, *packet in found[1:]]
    capture = read(pcap([found[0], *late], 228))
    assert list(capture.messages()["kind"]) == ["SPDP"] * complete
    assert any("lack fragments" in note for note in capture.notes) is not complete


def test_a_link_type_that_is_not_read_is_noted(read: Read) -> None:
    capture = read(pcap(packets("cyclone_dds_010"), link=147))
    assert capture.messages().empty
    assert "link type 147" in capture.notes[0]


def mutated(content: bytes, chance: random.Random) -> bytes:
    """Return the content with some bytes changed, taken out, put in, or the end cut off."""
    changed = bytearray(content)
    for _ in range(chance.choice((1, 2, 8))):
        place = chance.randrange(max(len(changed), 1))
        what = chance.random()
        if what < 0.6:
            changed[place : place + 1] = bytes([chance.randrange(256)])
        elif what < 0.75:
            del changed[place : place + chance.randrange(1, 9)]
        elif what < 0.9:
            changed[place:place] = chance.randbytes(chance.randrange(1, 9))
        else:
            del changed[place:]
    return bytes(changed)


@pytest.mark.parametrize("name", [*DDS_CAPTURES, "zenoh_data"])
def test_mutated_captures_are_read_or_refused(name: str, tmp_path: Path) -> None:
    chance = random.Random(name)
    path = tmp_path / "mutated.pcap"
    outcomes: Counter[str] = Counter()
    found = packets(name)
    for turn in range(600):
        first = chance.randrange(len(found))
        some = found[first : first + 12]
        if turn % 3 == 0:  # the framing, too
            content = mutated(pcap(some) if turn % 2 else pcapng(some), chance)
        else:
            link, wrap = chance.choice(list(LINKS.values()))
            frames = [
                (when, mutated(frame, chance), length) for when, frame, length in rewrap(some, wrap)
            ]
            content = pcap(frames, link)
        path.write_bytes(content)
        try:
            read_capture(path)
            outcomes["read"] += 1
        except CaptureError as error:
            assert str(error).startswith(f"{path}: byte ")  # noqa: PT017
            outcomes["refused"] += 1
    assert outcomes["read"] > 300
    assert outcomes["refused"] > 30


# ---------------------------------------------------------------- the command


def test_the_command_tells_what_the_package_does(tmp_path: Path) -> None:
    path = str(CAPTURES / "fast_dds.pcap.xz")
    picture = tmp_path / "picture.svg"
    done = CliRunner().invoke(main, ["capture", path, "--picture", str(picture)])
    assert done.exit_code == 0
    assert "hosts: 3 with 2 processes of 10 endpoints each" in done.output
    hint = 'for the product\'s count, use --against "Fast DDS"'
    assert hint in done.output
    own = CliRunner().invoke(main, ["capture", path, "--against", "fast dds 2.9"])
    assert own.exit_code == 0
    assert hint not in own.output
    assert picture.read_text().startswith("<?xml")
    answer = json.loads(CliRunner().invoke(main, ["capture", path, "--json"]).output)
    table = captured("fast_dds").compare(ds.DDS)
    assert answer["messages"][1]["unicast"] == table.loc["SEDP", "unicast"]
    assert answer["messages"][-1]["units"] is None
    csv_ = CliRunner().invoke(main, ["capture", path, "--csv"]).output.splitlines()
    assert len(csv_) == 1 + len(table)
    wrong = CliRunner().invoke(main, ["capture", path, "--against", "nothing"])
    assert (wrong.exit_code, "'fast dds'" in wrong.output.lower()) == (2, True)
