"""Test the tables of ns-3: complete, consistent, and equal to theory in simple cases."""

from collections import Counter
from itertools import product
from math import ceil
from statistics import mean

import lab_data
import pytest
import sympy as sp
from paper_equations import messages

from discostorm.data import read_data

BURSTS = read_data("measured/ns3_bursts.csv", "discostorm_book")
FRAMES = lab_data.read_lab_table("ns3_frames.csv")
SATURATION = lab_data.read_lab_table("ns3_saturation.csv")
QUARTILES = ("_q25", "", "_q75")
CAUSES = ("host_full", "host_age", "host_retry", "ap_full", "ap_age", "ap_retry", "on_air")

# Independent of the package: Table II of the paper [B], and 802.11n, 20 MHz, 5 GHz [us].
TABLE_2 = {
    "DDS": {"SPDP": 414, "SEDP": 464, "Heartbeat": 116, "ACKNACK": 114},
    "Zenoh": {"Scout": 80, "Hello": 144, "Declare": 176, "KeepAlive": 84},
}
SLOT, SIFS, ACK, BLOCK_ACK = 9, 16, 28, 32


def ht_mixed(octets: int) -> float:
    """MCS 15 with short guard interval, without rounding to 4 us, which ns-3 leaves out."""
    return 40 + 3.6 * ceil((8 * octets + 22) / 520)


def number(row: dict[str, str], name: str) -> float:
    return float(row[name])


def whole(row: dict[str, str], name: str) -> int:
    return int(row[name])


@pytest.mark.parametrize("row", FRAMES, ids=lambda row: row["source"].rpartition("build/")[2])
def test_airtime_of_frames(row: dict[str, str]) -> None:
    frame, mpdus = whole(row, "frame_B"), whole(row, "mpdus")
    assert frame == TABLE_2[row["protocol"]][row["message"]]
    if row["cast"] == "multicast":
        assert row["direction"] == "down"
        assert (row["answer"], mpdus) == ("none", 1)
        assert whole(row, "data_ns") == 1000 * (20 + 4 * ceil((8 * frame + 22) / 24))
        return
    # Delimiter, frame, and padding to 4 bytes except for the last.
    octets = (mpdus - 1) * (4 + 4 * ceil(frame / 4)) + 4 + frame if mpdus > 1 else frame
    assert whole(row, "data_ns") == pytest.approx(1000 * ht_mixed(octets), abs=0.5)
    assert whole(row, "sifs_ns") == 1000 * SIFS
    answer, airtime = ("ack", ACK) if mpdus == 1 else ("block_ack", BLOCK_ACK)
    assert (row["answer"], whole(row, "answer_ns")) == (answer, 1000 * airtime)


def test_every_message_was_measured_up_and_down() -> None:
    single = Counter((row["message"], row["direction"]) for row in FRAMES if row["mpdus"] == "1")
    assert single == {
        (message, direction): 1
        for table in TABLE_2.values()
        for message in table
        for direction in ("up", "down")
    }


def expected_messages(row: dict[str, str], what: str) -> int:
    """Count messages sent, or receivers that expect them, in all runs of a row."""
    hosts, processes, endpoints = (whole(row, name) for name in ("hosts", "processes", "endpoints"))
    sent = messages(hosts, processes, endpoints)
    phases = ("SPDP", "SEDP") if row["protocol"] == "DDS" else ("Scouting", "Declaration")
    # Of what is sent by multicast, one message of each process, all other hosts are receivers.
    more = hosts * processes * (hosts - 2) if what == "receivers" else 0
    return whole(row, "runs") * (sum(sent[phase, "all"] for phase in phases) + more)


def test_bursts_add_up() -> None:
    for row in BURSTS:
        assert whole(row, "sent") == expected_messages(row, "messages"), row
        assert whole(row, "expected") == expected_messages(row, "receivers"), row
        lost = sum(whole(row, cause) for cause in CAUSES)
        assert whole(row, "expected") == whole(row, "arrived") + lost, row
        assert row["waiting"] == "0", row
        low, middle, high = (number(row, f"lost{part}") for part in ("_q25", "", "_q75"))
        assert 0 <= low <= middle <= high <= 1, row


def test_bursts_have_only_the_losses_of_their_settings() -> None:
    for row in BURSTS:
        lost = {cause: whole(row, cause) for cause in CAUSES}
        if row["queue_frames"] == "0":
            assert lost["host_full"] == lost["ap_full"] == 0, row
        if number(row, "queue_s") == 0:
            assert lost["host_age"] == lost["ap_age"] == 0, row
        if row["ampdu"] != "0" and number(row, "loss") == 0:
            # Under a block ACK agreement ns-3 repeats without limit.
            assert lost["host_retry"] == lost["ap_retry"] == 0, row
        # All of a host's frames come at once: no more than its queue holds get in.
        if row["queue_frames"] != "0":
            bursts = whole(row, "runs") * whole(row, "hosts")
            burst = whole(row, "sent") // bursts
            left_out = max(0, burst - whole(row, "queue_frames"))
            assert lost["host_full"] == bursts * left_out, row


def test_a_burst_beside_data_adds_up() -> None:
    rows = read_data("measured/ns3_mixed.csv", "discostorm_book")
    settings = Counter((row["image_hz"], row["ampdu"]) for row in rows)
    assert settings == dict.fromkeys(product(("10.0", "35.0"), ("0", "65535")), 4)
    for row in rows:
        runs = whole(row, "runs")
        assert runs == 40
        lost = sum(whole(row, cause) for cause in CAUSES)
        assert whole(row, "expected") == whole(row, "arrived") + lost + whole(row, "waiting"), row
        # Five robots: the paper's messages of 2 processes of 10 endpoints; each second 5 scans and
        # 50 transforms, which four others hear, and images of 14 frames.
        each = {
            "burst": 10 * 8 * 14 + 10 * 4,
            "scan": 5 * 5 * 4 * 2,
            "tf": 5 * 50 * 4 * 4,
            "image": 5 * number(row, "image_hz") * 4 * 14,
        }
        assert whole(row, "expected") == runs * each[row["what"]], row
        if row["what"] == "burst":
            low, middle, high = (number(row, f"drain_time_s{part}") for part in QUARTILES)
            assert 0 < low <= middle <= high < number(row, "busy_s")
            assert row["waiting"] == "0"
        else:
            assert 0 < number(row, "delay_median_s") < number(row, "delay_95_s") < 1
        # What goes to a wired host does not wait at the access point, and only multicast is lost
        # on the air.
        if row["what"] == "image":
            assert row["ap_full"] == row["ap_age"] == row["ap_retry"] == "0"
        if row["what"] in ("image", "scan"):
            assert row["on_air"] == "0"


def test_bursts_on_the_air() -> None:
    for row in BURSTS:
        assert whole(row, "collided") >= 2 * whole(row, "collisions"), row
        low, middle, high = (number(row, f"drain_time_s{part}") for part in ("_q25", "", "_q75"))
        assert 0 < low <= middle <= high, row
        assert 0 < number(row, "busy_s") / whole(row, "runs") < high, row
        if row["ampdu"] == "0":
            assert row["mpdus"] == row["ppdus"], row
        else:
            assert whole(row, "ppdus") < whole(row, "mpdus") <= 64 * whole(row, "ppdus"), row
        if row["ampdu"] == "0" or row["request"] == "0":
            assert row["others"] == "0", row
        if row["scenario"] == "unlimited" and whole(row, "host_retry") == 0:
            # Each message is sent once up and once down, and repeated.
            assert whole(row, "mpdus") - whole(row, "retries") == 2 * whole(row, "sent"), row


def test_no_setting_is_there_twice_and_medians_have_ten_runs() -> None:
    for rows, result in ((BURSTS, "runs"), (SATURATION, "runs")):
        settings = list(rows[0])[: list(rows[0]).index(result)]
        assert len({tuple(row[name] for name in settings) for row in rows}) == len(rows)
        assert all(whole(row, "runs") >= 10 for row in rows)


@pytest.mark.parametrize("protocol", TABLE_2)
@pytest.mark.parametrize("scenario", ["unlimited", "queue"])
def test_the_papers_scenarios_are_there(scenario: str, protocol: str) -> None:
    rows = [row for row in BURSTS if (row["scenario"], row["protocol"]) == (scenario, protocol)]
    hosts = [2, 3, 4, 5, 6, 7, 8, 10]
    drain, lost = (
        {(whole(row, "hosts"), whole(row, "ampdu")): number(row, name) for row in rows}
        for name in ("drain_time_s", "lost")
    )
    assert {(count, ampdu) for count in hosts for ampdu in (0, 65535)} <= drain.keys()
    for count in hosts:
        assert drain[count, 65535] < drain[count, 0] / 2
    if scenario == "unlimited":
        # Only multicast frames are lost, in collisions, and few unicast at their last attempt.
        assert max(lost.values()) < 0.03
    else:
        assert min(lost[count, ampdu] for count in (8, 10) for ampdu in (0, 65535)) > 0.4


def bianchi(stations: int, frame: int, aifsn: int) -> float:
    """Frames a second by the fixed point of G. Bianchi, IEEE JSAC 18(3), 2000."""
    window, stages = 16, 6
    p = sp.Symbol("p")
    attempts = 2 / (1 + window + p * window * sum((2 * p) ** stage for stage in range(stages)))
    collision = sp.nsolve(p - 1 + (1 - attempts) ** (stations - 1), (0, 0.99), solver="bisect")
    tau = float(attempts.subs(p, collision))
    idle = (1 - tau) ** stations
    success = stations * tau * (1 - tau) ** (stations - 1)
    busy = ht_mixed(frame) + SIFS + aifsn * SLOT
    slot = idle * SLOT + success * (busy + SIFS + ACK) + (1 - idle - success) * busy
    return 1e6 * success / slot


@pytest.mark.parametrize("row", SATURATION, ids=lambda row: row["source"])
def test_saturation_agrees_with_theory(row: dict[str, str]) -> None:
    stations, frame, aifsn = (whole(row, name) for name in ("stations", "frame_bytes", "aifsn"))
    if stations == 1:
        # Nothing but the mean back-off between one frame and the next.
        cycle = SIFS + aifsn * SLOT + mean(range(16)) * SLOT + ht_mixed(frame) + SIFS + ACK
        assert number(row, "frames_per_s") == pytest.approx(1e6 / cycle, rel=0.005)
        assert row["dropped"] == row["collisions"] == "0"
    else:
        theory = bianchi(stations, frame, aifsn)
        assert number(row, "frames_per_s") == pytest.approx(theory, rel=0.02)


def test_saturation_of_one_to_fifty_stations_was_measured() -> None:
    papers = {"frame_bytes": str(TABLE_2["DDS"]["SEDP"]), "aifsn": "3"}
    rows = [row for row in SATURATION if all(row[name] == papers[name] for name in papers)]
    assert {1, 2, 5, 10, 20, 30, 50} <= {whole(row, "stations") for row in rows}


def test_the_simulator_is_a_thousand_times_as_fast_without_aggregation() -> None:
    rows = lab_data.read_lab_table("ns3_speed.csv")
    assert {(row["protocol"], row["hosts"]) for row in rows} == {("DDS", "12"), ("Zenoh", "12")}
    for row in rows:
        ratio = number(row, "ns3_cpu_s") / number(row, "simulate_cpu_s")
        assert ratio == pytest.approx(number(row, "ratio"), rel=0.02)  # of three digits each
        if row["ampdu"] == "0":
            assert ratio > 1000
