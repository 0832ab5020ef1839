"""Each threshold of the diagnosis lies where it is said to: just below and just above it."""

import io
import struct
from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from handmade_captures import (
    SPDP,
    Packet,
    acknowledge,
    announce,
    dds,
    endpoint,
    packets,
    pcap,
    prefix,
    sample,
    startup,
    submessage,
    udp,
)

import discostorm as ds
from discostorm_capture.diagnosis import losses
from discostorm_capture.diagnosis.diagnose import Diagnosis
from discostorm_capture.live_capture import PacketStream, Watch

STAGED = Path(__file__).with_name("captures")


def diagnosed(found: Iterable[Packet]) -> Diagnosis:
    return ds.read_capture(io.BytesIO(pcap(sorted(found, key=lambda one: one[0])))).diagnosis()


def regularly(host: int, until: float, since: float = 0.0) -> list[Packet]:
    return [announce(float(time), host) for time in np.arange(since, until, 2.0)]


def kinds(diagnosis: Diagnosis, host: int = 0) -> set[str]:
    return {
        one.kind
        for one in diagnosis.findings
        if not host or any(name.endswith(f".{host}") for name in one.hosts)
    }


def test_a_startup_made_by_hand_is_healthy() -> None:
    diagnosis = diagnosed([*startup(0.0, 1, 2, 3), *regularly(1, 10), *regularly(2, 10)])
    assert diagnosis.findings == ()
    assert (diagnosis.healthy, diagnosis.over, diagnosis.pairs) == (True, True, 6)


def rtps_silence(quiet: float) -> bool:
    """Whether the second host is silent, this long after its last announcement."""
    found = [*startup(0.0, 1, 2), *regularly(2, 10.1), *regularly(1, 10.1)]
    return "crash" in kinds(diagnosed([*found, announce(10.0 + quiet, 1)]), 2)


def zenoh_silence(quiet: float) -> bool:
    """Whether a host is silent, this long after its last message."""
    found = packets("zenoh_data")
    found = [one for one in found if one[0] < found[0][0] + 3 * 10**9]
    last = max(time for time, data, _ in found if data[26:30] == bytes([10, 77, 0, 2]))
    scout = next(
        one
        for one in found
        if one[1][26:30] == bytes([10, 77, 0, 1]) and one[1][30:34] == bytes([224, 0, 0, 224])
    )
    times = [*np.arange(10.0, quiet, 10.0), quiet]  # a longer pause of all hosts would be a jump
    found += [(last + round(time * 1e9), *scout[1:]) for time in times]
    return "crash" in kinds(diagnosed(found), 2)


def repeated(rate: float, until: float = 10.0) -> bool:
    """Whether a flood is told, if a host acknowledges so often a second until a time."""
    found = [*startup(0.0, 1, 2), *regularly(1, 10.1), *regularly(2, 10.1)]
    found += [acknowledge(time, 1, 2, 2) for time in np.arange(3.0, until, 1 / rate)]
    return "flood" in kinds(diagnosed(found), 1)


def rare_announcements(later: float) -> bool:
    """Whether two hosts ought to hear each other, if one announces itself once, one so late on."""
    found = diagnosed([announce(0.0, 2), *regularly(1, 20, later)])
    return bool(kinds(found) & {"nobody hears", "nobody hears, or filter"})


def heavy_loss(share: float) -> bool:
    """Whether loss is heavy, if the last 40 samples of so many are asked for again."""
    count = round(40 / share)
    found = [*startup(0.0, 1, 2)]
    found += [endpoint(2.0 + 0.1 * one, 1, 2, one) for one in range(2, count + 2)]
    found += [acknowledge(2.05 + 0.1 * one, 2, 1, one, 1) for one in range(count - 38, count + 2)]
    losses = kinds(diagnosed([*found, acknowledge(2.2 + 0.1 * count, 2, 1, count + 2)]))
    assert losses & {"loss", "heavy loss"}
    return "heavy loss" in losses


def some_loss(lost: int) -> bool:
    """Whether samples are lost, if so many are asked for again."""
    found = [*startup(0.0, 1, 2)]
    found += [endpoint(2.0 + 0.1 * one, 1, 2, one) for one in range(2, 22)]
    found += [acknowledge(2.05 + 0.1 * one, 2, 1, one, 1) for one in range(2, 2 + lost)]
    found += [acknowledge(5.0, 2, 1, 22)]
    return bool(kinds(diagnosed(found)) & {"loss", "heavy loss"})


def reading(late: float) -> bool:
    """Whether samples are lost that are asked for so long after they were sent."""
    found = [*startup(0.0, 1, 2)]
    found += [endpoint(2.0 + one, 1, 2, one) for one in range(2, 5)]
    found += [acknowledge(2.0 + one + late, 2, 1, one, 1) for one in range(2, 5)]
    found += [acknowledge(8.0, 2, 1, 5)]
    return bool(kinds(diagnosed(found)) & {"loss", "heavy loss"})


def quiet_end(quiet: float) -> bool:
    """Whether discovery is over, so long after the last endpoint was announced."""
    found = [*startup(0.0, 1, 2), endpoint(3.0, 1, 2, 2), acknowledge(3.01, 2, 1, 3)]
    return bool(diagnosed([*found, announce(3.0 + quiet, 1)]).over)


def late_begin(later: float) -> bool:
    """Whether the capture began late, if samples from the fifth on come so late."""
    found = [announce(0.0, 1), announce(0.0, 2)]
    found += [endpoint(later, 1, 2, 5), acknowledge(later + 0.01, 2, 1, 6)]
    found += [endpoint(later, 2, 1, 5), acknowledge(later + 0.01, 1, 2, 6)]
    return "capture began late" in kinds(diagnosed(found))


def patience(together: float) -> bool:
    """Whether two hosts ought to hear each other after this time."""
    found = diagnosed([announce(time, host) for host in (1, 2) for time in (0.0, together)])
    return bool(kinds(found) & {"nobody hears", "nobody hears, or filter"})


def late_joiner(later: float) -> bool:
    """Whether a host joined later."""
    found = [*startup(0.0, 1, 2), *startup(later, 1, 2, 3), *regularly(1, 20), *regularly(2, 20)]
    return "late joiner" in kinds(diagnosed(found), 3)


def announcing(until: float, seconds: Iterable[float]) -> bool:
    """Whether a storm lasts, if endpoints are announced at these times of a capture."""
    found = [*startup(0.0, 1, 2), announce(until + 0.01, 2)]
    for number, time in enumerate(seconds, 2):
        found += [endpoint(time, 1, 2, number), acknowledge(time + 0.01, 2, 1, number + 1)]
    return "storm" in kinds(diagnosed(found))


def short_storm(until: float) -> bool:
    """Whether what goes on for so long is a storm."""
    return announcing(until, np.arange(0.5, until, 0.5).tolist())


def rare_storm(count: int) -> bool:
    """Whether a storm lasts, if endpoints are announced in so many of the last ten seconds."""
    return announcing(30.0, [*np.arange(0.5, 20.0, 0.5), *(20.5 + one for one in range(count))])


def startup_is_over(later: float) -> bool:
    """Whether an endpoint that is announced so late, and never confirmed, is not of the startup."""
    found = [*startup(0.0, 1, 2), endpoint(0.01 + later, 1, 2, 2)]
    return diagnosed([*found, *regularly(1, 20), *regularly(2, 20)]).complete is True


def crash_loop(starts: int) -> bool:
    """Whether a host is in a crash loop, if its process starts so many times."""
    found = regularly(2, 25.0 * starts)
    for start in range(starts):
        for time in np.arange(25.0 * start, 25.0 * start + 10, 0.5):
            when, frame, length = announce(float(time), 1)
            other = prefix(1)[:2] + bytes([start]) + prefix(1)[3:]
            found.append((when, frame.replace(prefix(1), other), length))
    losses = kinds(diagnosed(found), 1)
    assert losses & {"restart", "crash loop"}
    return "crash loop" in losses


def asked_in_vain(times: int) -> bool:
    """Whether unicast is dropped, if a host asks so many times for the address of another one."""
    found = [*regularly(1, 10), *regularly(2, 10)]
    ends = bytes(6) + bytes([10, 0, 0, 1]) + bytes(6) + bytes([10, 0, 0, 2])
    request = bytes(12) + struct.pack(">HHHBBH", 0x0806, 1, 0x0800, 6, 4, 1) + ends
    found += [(round((1.5 + time) * 1e9), request, len(request)) for time in range(times)]
    return "client isolation" in kinds(diagnosed(found))


def late_delivery(later: float) -> bool:
    """Whether a process left that is heard once more so long after its goodbye."""
    goodbye = sample(SPDP, 2)
    key_only = submessage(0x15, goodbye[4:], flags=8)
    found = [*startup(0.0, 1, 2), *regularly(1, 40), dds(5.0, 2, key_only)]
    return "left" in kinds(diagnosed([*found, announce(5.0 + later, 2)]), 2)


@pytest.mark.parametrize(
    ("holds", "below", "above"),
    [
        (startup_is_over, 4.9, 5.1),
        (crash_loop, 3, 4),
        (asked_in_vain, 2, 3),
        (short_storm, 11.9, 12.1),
        (rare_storm, 4, 6),
        (rtps_silence, 11.9, 12.1),
        (zenoh_silence, 74.0, 76.0),
        (heavy_loss, 0.0152, 0.0168),
        (some_loss, 2, 3),
        (reading, 0.019, 0.021),
        (quiet_end, 0.95, 1.05),
        (late_begin, 0.95, 1.05),
        (patience, 3.95, 4.05),
        (late_joiner, 4.9, 5.1),
    ],
)
def test_above_its_threshold_it_is_a_finding(holds, below, above) -> None:  # type: ignore[no-untyped-def]
    assert (holds(below), holds(above)) == (False, True)


@pytest.mark.parametrize(
    ("holds", "below", "above"),
    [
        (rare_announcements, 5.9, 6.1),
        (late_delivery, 0.95, 1.05),
    ],
)
def test_below_its_threshold_it_is_a_finding(holds, below, above) -> None:  # type: ignore[no-untyped-def]
    assert (holds(below), holds(above)) == (True, False)


def test_of_many_hosts_those_that_were_heard_last_are_kept() -> None:
    content = pcap(announce(0.01 * number, 1) for number in range(1100))
    stream, state = PacketStream("x"), Watch(max_bytes=20_000)
    for number, (when, packet) in enumerate(stream.feed(content)):
        # Each packet is from another address.
        source = bytes([10, 9, number >> 8, number & 255])
        state.add_packet(when, packet[:42] + source + packet[46:])
        if state.must_count_now:
            state.count_and_diagnose(stream.header)
    state.count_and_diagnose(stream.header)
    numbers = [
        int(high) * 256 + int(low)
        for _, _, high, low in (name.split(".") for name in state.presence.hosts)
    ]
    assert sorted(numbers) == list(range(1100 - 1024, 1100))


def test_a_flood_is_told_from_twenty_messages_a_second_on_until_the_end() -> None:
    assert (repeated(18), repeated(22), repeated(22, until=8.0)) == (False, True, False)


def test_segments_to_a_host_that_has_ended_are_not_lost() -> None:
    found = packets("zenoh_data")
    here, there = (bytes([10, 77, 0, host]) for host in (1, 2))
    ended = found[0][0] + 20 * 10**9
    alive = [one for one in found if one[0] < ended or there not in one[1][26:34]]
    segments = [
        one for one in alive if one[1][23] == 6 and one[1][26:34] == here + there and one[2] > 80
    ]
    last = segments[-1]
    again = [
        # Another IP id each, as if the sender tried again and again.
        (ended + (n + 1) * 10**8, last[1][:18] + bytes([200, n]) + last[1][20:], last[2])
        for n in range(60)
    ]
    assert not kinds(diagnosed([*alive, *again])) & {"loss", "heavy loss"}


@pytest.mark.parametrize(
    ("counts", "told"),
    [
        (((7, 3811), (0, 0)), set[str]()),
        (((7, 1500), (0, 0)), {"some loss"}),
        (((0, 0), (3, 48)), {"loss"}),
        (((30, 1000), (0, 0)), {"heavy loss"}),
    ],
)
def test_loss_is_told_if_its_interval_is_above_the_threshold(
    counts: tuple[object, object], told: set[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    ends, when = Counter({"10.77.0.1": 1, "10.77.0.2": 1}), np.array([1.0])
    monkeypatch.setattr(losses, "find_losses", lambda _: (*counts, ends, ends, when))
    diagnosis = diagnosed([*startup(0.0, 1, 2), *regularly(1, 10), *regularly(2, 10)])
    assert kinds(diagnosis) == told
    assert diagnosis.healthy == (told <= {"some loss"})


@pytest.mark.parametrize(("share", "kind"), [(0.45, "heavy loss"), (0.55, "crowded link")])
def test_a_transfer_of_most_bytes_is_named_where_frames_are_lost(
    share: float, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    ends, when = Counter({"10.0.0.1": 1}), np.array([1.0])
    found = ((30, 1000), (0, 0), ends, ends, when)
    monkeypatch.setattr(losses, "find_losses", lambda _: found)
    fleet = [*startup(0.0, 1, 2), *regularly(1, 10), *regularly(2, 10)]
    of_ros = int(ds.read_capture(io.BytesIO(pcap(sorted(fleet))))._messages["bytes"].sum())
    octets = round(share / (1 - share) * of_ros)
    head = fleet[0][1][:14]  # of Ethernet
    frames = [head + udp(bytes(octets // 5), 2, 1, (5555, 6666)) for _ in range(5)]
    copied = [(round(1e9 * (1 + at)), frame, len(frame)) for at, frame in enumerate(frames)]
    (wrong,) = diagnosed([*fleet, *copied]).wrong
    assert wrong.kind == kind
    if kind == "crowded link":
        assert wrong.hosts == ("10.0.0.2",)
        rate = 8e-6 * 5 * (octets // 5) / 8
        assert f"other programs on 10.0.0.2 send {rate:.2g} Mbit/s" in wrong.evidence
        assert "30 of 1000 captured frames" in wrong.evidence
        assert "rsync --bwlimit" in wrong.advice


def test_a_topic_that_takes_most_of_a_lossy_link_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    ends, total = Counter({"10.77.0.1": 30}), Counter({"10.77.0.1": 1000})
    found = ((30, 1000), (0, 0), ends, total, np.array([1.0]))
    monkeypatch.setattr(losses, "find_losses", lambda _: found)
    capture = ds.read_capture(STAGED / "healthy_dual_stack.pcap.xz")
    rows = capture._messages
    data = rows["kind"].eq("Push")
    of_one = data & rows["process"].eq(rows["process"][data].iloc[0])
    for frames, kind in ((3.0, "heavy loss"), (900.0, "stream on a slow link")):
        more = rows["frames"].where(~of_one, np.float32(frames))
        (wrong,) = replace(capture, _messages=rows.assign(frames=more)).diagnosis().wrong
        assert wrong.kind == kind
    assert "30 of 1000 captured frames" in wrong.evidence


def stopping(share: float, only: str = "User data") -> Diagnosis:
    """Diagnose a healthy capture without the samples of a writer after this share of its time."""
    seen = ds.read_capture(STAGED / "watched_beside_robots.pcap.xz")
    rows = seen._messages
    later = rows["time"] > rows["time"].min() + share * np.ptp(rows["time"])
    process = "0110fa7cb201f9de1cb398d6"
    own = rows["process"].eq(process) & rows["writer"].eq(1027) & rows["kind"].eq(only)
    return replace(seen, _messages=rows[~(own & later)].reset_index(drop=True)).diagnosis()


def test_a_topic_that_stops_is_an_event_if_its_writer_stays() -> None:
    away, late = stopping(1.0).findings  # another host was cut off for a while
    assert (away.kind, away.hosts, late.kind) == ("away", ("10.77.0.2",), "capture began late")
    stopped = stopping(0.4)
    (found,) = (one for one in stopped.findings if one not in (away, late))
    assert (found.kind, found.hosts, stopped.wrong) == ("topic stops", ("10.77.0.3",), ())
    assert "samples of /a_rather_long_topic_name_of_a_robot_0 from 0.0 s to 19." in found.evidence
    assert "check the sensor or other source behind it" in found.advice


def test_a_process_that_deletes_none_of_its_many_endpoints_is_named() -> None:
    seen = ds.read_capture(STAGED / "client_for_each_call.pcap.xz")
    kept = replace(seen, _messages=seen._messages.assign(ends=False)).diagnosis()
    assert "10.77.0.2 announced " in kept.wrong[0].evidence
    assert kept.wrong[0].kind == "endpoints pile up"
    assert "new endpoints of /set_mode (service)" in kept.wrong[0].evidence
    assert "publishers and subscriptions once and reuse them" in kept.wrong[0].advice


def test_a_host_that_announces_the_address_of_another_interface_is_named() -> None:
    elsewhere, here = bytes([192, 168, 123, 3]), bytes([10, 0, 0, 3])
    found = [*startup(0.0, 1, 2), *regularly(1, 20), *regularly(2, 20)]
    found += [
        (time, frame[:26] + elsewhere + frame[30:], length)
        for time, frame, length in regularly(3, 20)
    ]
    for time, address in ((0.1, elsewhere), (0.2, here)):
        ends = bytes([2, 0, 0, 0, 0, 3]) + address + bytes(6) + bytes([10, 0, 0, 1])
        request = bytes(12) + struct.pack(">HHHBBH", 0x0806, 1, 0x0800, 6, 4, 1) + ends
        found.append((round(time * 1e9), request, len(request)))
    seen = ds.read_capture(io.BytesIO(pcap(sorted(found, key=lambda one: one[0]))))
    processes = seen._processes.assign(announces=seen._processes["host"])
    (wrong,) = replace(seen, _processes=processes).diagnosis().wrong
    assert (wrong.kind, wrong.hosts) == ("other interface", ("10.0.0.3", "192.168.123.3"))
    assert wrong.evidence.endswith(
        "have one MAC address, and the host announces only 192.168.123.3"
    )
