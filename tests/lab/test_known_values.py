"""Compare committed files with values stated here by hand."""

import re
import struct
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import lab_data
import numpy as np
import pandas as pd
import pytest
import sympy as sp
from click.testing import CliRunner
from handmade_captures import block, pcap, rtps, submessage, udp

import discostorm as ds
from discostorm import notation as nt
from discostorm.cli import main, output
from discostorm.data import data_path, read_data
from discostorm.messages import Schedule
from discostorm.robots import robots
from discostorm.wifi.aggregation import mpdus as frames_of
from discostorm_capture.compare import comparison_window
from discostorm_capture.rtps import INFO_SRC
from discostorm_simulation.engine import run_to_end
from discostorm_simulation.run import Scenario, set_up, simulate_run

SPDP_WRITER = 0x100C2


def text(name: str) -> str:
    return data_path(f"vendors/snippets/{name}").read_text(encoding="utf-8")


@pytest.mark.parametrize("resolution", [0, 3, 6, 8, 9, 10, 11, 12, 15, 18, 0x80 | 10, 0x80 | 40])
def test_a_clock_of_any_resolution_tells_the_same_time(resolution: int, tmp_path: Path) -> None:
    """pcapng, if_tsresol: a negative power of ten, or with the upper bit set of two."""
    base = 2 if resolution & 0x80 else 10
    per_second = base ** (resolution & 0x7F)
    option = struct.pack("<HHB3xHH", 9, 1, resolution, 0, 0)
    parts = [
        block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1)),
        block(1, struct.pack("<HHI", 101, 0, 0) + option),
    ]
    for seconds in (2, 11):
        ticks = seconds * per_second
        parts.append(block(6, struct.pack("<IIIII", 0, ticks >> 32, ticks & 0xFFFFFFFF, 0, 0)))
    path = tmp_path / "clock.pcapng"
    path.write_bytes(b"".join(parts))
    found = ds.read_capture(path)
    assert (found.start, found.duration) == (2, 9)


def test_info_source_says_who_sent_what_follows(tmp_path: Path) -> None:
    """DDSI-RTPS 2.5, 9.4.5.1.1: INFO_SRC is 0x0c; behind version and vendor is the prefix."""
    assert INFO_SRC == 0x0C
    body = struct.pack("<HH", 0, 16) + struct.pack(">II", 0, SPDP_WRITER)
    announcement = submessage(0x15, body + struct.pack("<iI", 0, 1) + b"\0\3\0\0\1\0\0\0")
    other = b"other prefix"

    def senders(kind: int) -> list[str]:
        told = submessage(kind, bytes(4) + b"\2\5\1\x0f" + other)
        path = tmp_path / "told.pcap"
        path.write_bytes(
            pcap([(0, packet, len(packet)) for packet in [udp(rtps(told, announcement))]], 101)
        )
        return list(ds.read_capture(path).messages()["process"])

    (relayed,), (own,) = senders(0x0C), senders(0x0D)
    assert relayed != own
    rows = {
        row["name"]: row["id"]
        for row in read_data("vendors/rtps_submessages.csv", "discostorm_capture")
    }
    assert rows["INFO_SRC"] == "0x0c"


@pytest.mark.parametrize(("duration", "seconds"), [(10.0, 4.5), (5.0, 4.0), (5.5, 4.5)])
def test_a_captures_window_ends_half_a_period_after_the_last_message(
    duration: float, seconds: float
) -> None:
    spdp, sedp = ds.DDS.messages[:2]
    table = ds.Protocol(
        "own",
        (
            replace(spdp, schedule=Schedule((0.0,), 3.0)),
            replace(sedp, schedule=Schedule((0.0,), 8.0)),
        ),
    )
    kinds = [spdp.kind, sedp.kind, spdp.kind, "other"]
    messages = pd.DataFrame({"kind": kinds, "time": [1.0, 2.0, 4.0, 4.9]})
    assert comparison_window(table, messages, duration) == seconds
    assert comparison_window(table, messages[messages["kind"] == "other"], duration) == duration


def test_what_a_host_lost_is_a_whole_number_of_what_it_sent() -> None:
    fleet = ds.Fleet((ds.HostGroup(3, 2, 5), ds.HostGroup(2, 1, 8)))
    for recovery in (False, True):
        given = {"queue": (20.0, 0.5), "loss": 0.2, "recovery": recovery, "until": 2.0}
        setup = set_up(Scenario(fleet, ds.DDS, ds.PAPER, **given))
        cell, _ = setup.cell(np.random.SeedSequence(3))
        hosts = run_to_end(cell, 20_000_000 if recovery else 10**12, setup.reserve).stations[:5]
        run = simulate_run(setup, np.random.SeedSequence(3))
        sent, lost = hosts["sought"].astype(float), hosts["missed"].astype(float)
        assert lost.sum() > 100
        np.testing.assert_allclose(run.lost_by_host, lost / sent, rtol=1e-12)
        np.testing.assert_allclose((run.lost_by_host * sent).sum(), lost.sum(), rtol=1e-12)


@pytest.mark.parametrize(
    ("file", "rows", "messages", "frames", "octets"),
    [
        ("counts", 14_275, 883_787, 575_907.78, 124_544_690),
        ("mitigation_counts", 11_041, 1_627_128, 807_704.92, 228_518_378),
        ("beyond_counts", 1_200, 920_973, 587_755.98, 131_942_803),
        ("restart_counts", 2_350, 675_165, 455_752.03, 89_188_862),
        ("security_counts", 2_570, 461_573, 380_435.89, 231_578_560),
        ("shared_counts", 1_575, 84_742, 51_336.94, 10_545_026),
    ],
)
def test_what_was_counted_stays(
    file: str, rows: int, messages: int, frames: float, octets: int
) -> None:
    """Only a new measurement changes these, and then by hand."""
    path = lab_data.DATA / f"{file}.csv"
    found = read_data(str(path if path.exists() else lab_data.BOOK / path.name))
    assert len(found) == rows
    assert sum(int(row["messages"]) for row in found) == messages
    assert sum(float(row["frames"]) for row in found) == pytest.approx(frames, abs=0.001)
    assert sum(int(row["bytes"]) for row in found) == octets


def test_a_staggered_start_takes_as_many_seconds_as_the_airtime() -> None:
    """The paper's tables repeat nothing, so that their airtime is what is to be spread."""
    plan = ds.plan(ds.Fleet.swarm(7, 2, 10))
    (found,) = (one for one in plan.to_dict()["remedies"] if one["kind"] == "staggered start")
    assert found["start_within_s"] == pytest.approx(0.95391, abs=1e-5)
    larger = ds.plan(ds.Fleet.swarm(12, 2, 10))
    rows = [one for one in larger.to_dict()["remedies"] if one["protocol"] == "DDS"]
    assert len(rows) > 5
    for row in rows:
        assert row["start_within_s"] == pytest.approx(row["utilization"])
    assert list(larger.to_frame()["start_within_s"])[: len(larger.remedies)] == [
        one["start_within_s"] for one in larger.to_dict()["remedies"]
    ]


@pytest.mark.parametrize(
    ("shown", "value", "said"),
    [
        (output.format_seconds, 1.2345678, "1.234568"),
        (output.format_seconds, 12.3456, "12.3"),
        (output.format_seconds, 1_234.56, "1,234.6"),
        (output.format_seconds, 1_234_567.0, "1.23e+06"),
        (output.as_text, 12_345_678_901.0, "1.23e+10"),
        (output.percent, 12_345_678.0, "1.23e+09%"),
    ],
)
def test_digits_of_numbers_for_people(
    shown: Callable[[float], str], value: float, said: str
) -> None:
    assert shown(value) == said


def test_a_capture_is_told_to_the_millisecond(tmp_path: Path) -> None:
    path = tmp_path / "two.pcap"
    path.write_bytes(pcap([(0, b"", 0), (12_345_678_000, b"", 0)], 101))
    shown = CliRunner().invoke(main, ["capture", str(path)])
    assert f"{path}: 2 packets in 12.346 s\n" in shown.stdout


#: Where servers and routers are in what is pasted, and where clients look for them. The ports are
#: those that `fastdds discovery` (11811) and zenohd (7447) have by default.
PLACES = {
    "fast_dds_server.sh": ["192.168.1.10:11811"],
    "fast_dds_server.xml": ["192.168.1.10:11811"],
    "fast_dds_client.sh": ["192.168.1.10:11811"],
    "fast_dds_two_servers.sh": ["192.168.1.10:11811", "192.168.1.11:11811"],
    "fast_dds_client_of_two.sh": ["192.168.1.10:11811", "192.168.1.11:11811"],
    "zenoh_router.json5": ["0.0.0.0:7447"],
    "zenoh_client.json5": ["192.168.1.10:7447"],
    "zenoh_router_of_host.json5": ["0.0.0.0:7447", "192.168.1.21:7447", "192.168.1.22:7447"],
    "zenoh_router_of_star.json5": ["0.0.0.0:7447", "192.168.1.10:7447"],
    "zenoh_session_of_host.json5": ["localhost:7447", "localhost:0"],
}


@pytest.mark.parametrize("name", list(PLACES))
def test_clients_look_where_their_servers_are(name: str) -> None:
    found = re.findall(
        r"\b(localhost|\d+(?:\.\d+){3})(?::| -p |</address>\s*<port>)(\d+)", text(name)
    )
    assert [":".join(pair) for pair in found] == PLACES[name]


#: 40 MHz upwards, with the short guard interval of 0.4 µs at both widths.
WHOLE = "[HT40+][SHORT-GI-20][SHORT-GI-40]"


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("hostapd_80211n_40mhz.conf", {"ht_capab": WHOLE}),
        (
            "hostapd_80211ac_80mhz.conf",
            {"ht_capab": WHOLE, "vht_oper_chwidth": "1", "vht_oper_centr_freq_seg0_idx": "42"},
        ),
        (
            "hostapd_80211ax_160mhz.conf",
            {
                **{"ht_capab": WHOLE, "vht_oper_chwidth": "2", "he_oper_chwidth": "2"},
                **dict.fromkeys(
                    ("vht_oper_centr_freq_seg0_idx", "he_oper_centr_freq_seg0_idx"), "50"
                ),
            },
        ),
    ],
)
def test_an_access_point_has_the_width_of_its_name(name: str, settings: dict[str, str]) -> None:
    """hostapd.conf: a width of 0 is 20 or 40 MHz, 1 is 80 and 2 is 160; centers from channel 36.

    Channels are 5 MHz apart and 20 MHz wide: of 36 to 48 the center is 42, of 36 to 64 it is 50.
    """
    lines = dict(line.split("=", 1) for line in text(name).splitlines() if line and line[0] != "#")
    assert lines["channel"] == "36"
    told = re.compile(r"ht_capab|(vht|he)_oper_(chwidth|centr_freq_seg0_idx)")
    assert {key: value for key, value in lines.items() if told.fullmatch(key)} == settings


def test_a_bare_node_has_eighteen_endpoints() -> None:
    """Two of the participant, 15 of the node, and its topic: as in rclcpp's sources.

    The node's: six parameter services of a reader and a writer each, a writer of rosout, and a
    writer and a reader of parameter_events.
    """
    bare = robots()["One bare node"]
    assert bare.counts() == (1, 1, 2 + (6 * 2 + 1 + 2) + 1)
    assert (bare.nodes, bare.shared) == (1, 2 + 2)


@pytest.mark.parametrize(
    ("standard", "mpdus", "octets"),
    [
        # Block acknowledgements of 64, 256 and 1024 bits. The length exponents of HT and VHT go up
        # to 2^16 - 1 and 2^20 - 1; the PSDU of HE and EHT has an own limit, aPSDUMaxLength.
        ("802.11n", 64, 2**16 - 1),
        ("802.11ac", 64, 2**20 - 1),
        ("802.11ax", 256, 6_500_631),
        ("802.11be", 1024, 15_523_200),
    ],
)
def test_the_limits_of_an_a_mpdu(standard: str, mpdus: int, octets: int) -> None:
    (row,) = (row for row in read_data("wifi/ampdu.csv") if row["standard"] == standard)
    assert (int(row["most_mpdus"]), int(row["most_bytes"])) == (mpdus, octets)
    ds.Radio(standard, mpdus=mpdus)
    allowed = f"at most {mpdus} for {standard};"
    with pytest.raises(ValueError, match=f"mpdus must be a whole number .* {allowed}"):
        ds.Radio(standard, mpdus=mpdus + 1)


def test_an_a_mpdu_holds_what_just_fits() -> None:
    # A frame of 98 octets makes a subframe of 4 + 100.
    for most, frames in ((207, 1), (208, 2), (209, 2), (6656, 64), (6655, 63), (9999, 64)):
        at = {nt.N_AGG: 64, nt.A_MAX: most, nt.A_MIN: 0}
        assert frames_of(sp.Integer(98)).subs(at) == frames
    assert ds.Radio("802.11n", streams=4, width=40e6, mpdus=64).most_bytes == 65_535
