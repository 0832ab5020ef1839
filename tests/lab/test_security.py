"""Test DDS Security: the lab's tables, and captures of secured fleets."""

import csv
import re
import struct
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
import security
from click.testing import CliRunner
from counted_airtime import airtime_counted
from handmade_captures import packets, pcap, rtps, submessage, udp
from lab_data import read_lab_table as read_lab
from run_grid import GRIDS
from support import ROOT

import discostorm as ds
from discostorm.cli import main
from discostorm.data import read_data
from discostorm_book import products
from discostorm_capture import Capture

STORED = ROOT / "tests/reference/captures/security"
RUNS = {row["run"]: row for row in read_lab("security_runs.csv")}
#: What is beside which product with security.
PLAIN = {"fast_dds": "default", "cyclone_dds_0.10": "spdp"}
SECURED = ("secure", "secure_discovery")


def command(name: str, *arguments: str) -> Any:
    path = str(STORED / f"{name}.pcap.xz")
    return CliRunner().invoke(main, ["capture", path, *arguments], catch_exceptions=False)


def read(tmp_path: Path, *messages: bytes) -> Capture:
    """Return the capture of messages from host 1 to host 2."""
    frame = bytes(12) + b"\x08\x00"
    found = [(10**9 * n, frame + udp(one), len(frame + udp(one))) for n, one in enumerate(messages)]
    path = tmp_path / "capture"
    path.write_bytes(pcap(found))
    return ds.read_capture(path)


def hidden(key: int, length: int, how: int = 4) -> bytes:
    """Return an encrypted submessage with its prefix and postfix."""
    prefix = submessage(0x31, bytes([0, 0, 0, how]) + struct.pack(">I", key) + bytes(12))
    return prefix + submessage(0x30, bytes(length)) + submessage(0x32, bytes(20))


# ---------------------------------------------------------------- what was measured


def test_every_point_was_run_as_often_as_the_grid_says() -> None:
    shape = ("hosts", "processes", "endpoints", "names", "use")
    with (GRIDS / "security.csv").open(newline="") as file:
        grid = {
            (row["configuration"], *(row[name] for name in shape)): int(row["runs"])
            for row in csv.DictReader(file)
        }
    assert grid == Counter(
        (f"{row['product']}-{row['variant']}", *(row[name] for name in shape))
        for row in RUNS.values()
    )
    assert {(row["product"], row["variant"]) for row in RUNS.values()} == {
        (product, variant) for product, plain in PLAIN.items() for variant in (plain, *SECURED)
    }
    assert {row["run"] for row in read_lab("security_counts.csv")} == RUNS.keys()


def test_runs_were_on_time_on_an_idle_machine_and_name_none_of_its_folders() -> None:
    for row in RUNS.values():
        assert 0 <= float(row["start_skew_s"]) < 0.2
        assert float(row["idle"]) >= 0.2
        secured = row["variant"] in SECURED
        assert secured == ("build/lab/keystore" in row["environment"]) == bool(row["strangers"])
        assert not re.search(r"/(?:work|home|root)\b", row["environment"])


def test_handshakes_keys_and_encryption_are_there_with_security_alone() -> None:
    kinds: dict[str, set[str]] = {}
    for row in read_lab("security_counts.csv"):
        if row["window"] == "startup":
            kinds.setdefault(row["run"], set()).add(row["kind"])
    for run, found in kinds.items():
        of_security = {"Authentication", "Encrypted key exchange", "Encrypted"}
        secured = RUNS[run]["variant"] in SECURED
        assert found & of_security == (of_security if secured else set())
        assert ("SEDP" in found) != secured


@pytest.mark.parametrize("product", PLAIN)
def test_security_takes_more_airtime_at_every_point(product: str) -> None:
    plain, *secured = (
        security.secured_points(product, variant) for variant in (PLAIN[product], *SECURED)
    )
    assert len(plain) == 8
    for points in secured:
        for without, with_ in zip(plain, points, strict=True):
            assert without.fleet == with_.fleet
            least = airtime_counted(without, "startup", False).max()
            assert airtime_counted(with_, "startup", False).min() > least


def test_the_books_tables_are_what_the_counts_say() -> None:
    for name, package, rows in (
        ("security", "discostorm", security.startup_rows()),
        ("security_strangers", "discostorm_book", security.unauthenticated_pair_rows()),
    ):
        made = [{key: str(value) for key, value in row.items()} for row in rows]
        assert made == read_data(f"measured/{name}.csv", package), "run security.py"
    assert set(products.SECURED) == set(security.PRODUCTS)


def test_cyclone_dds_authenticates_every_pair() -> None:
    strangers = {row["strangers"] for row in RUNS.values() if row["product"] != "fast_dds"}
    assert strangers == {"", "0"}


def test_fast_dds_sends_each_handshake_message_to_all_it_knows() -> None:
    """Request, reply and final message of each of 6 pairs, to up to 3 processes instead of one."""
    count: Counter[str] = Counter()
    for row in read_lab("security_counts.csv"):
        if (row["window"], row["kind"]) == ("startup", "Authentication"):
            count[row["run"]] += int(row["messages"])
    four = [run for run, row in RUNS.items() if (row["hosts"], row["processes"]) == ("4", "1")]
    fast = [count[run] for run in four if RUNS[run]["product"] == "fast_dds" and count[run]]
    assert len(fast) == 12
    assert all(2 * 6 * 3 < number < 1.1 * 3 * 6 * 3 for number in fast)


# ---------------------------------------------------------------- what a capture tells


def test_kinds_of_encrypted_messages(tmp_path: Path) -> None:
    spdp = submessage(0x15, bytes(8) + b"\x00\x01\x00\xc2" + bytes(12))
    capture = read(
        tmp_path,
        rtps(hidden(0, 16) + hidden(0, 320)),  # a time stamp, and keys
        rtps(hidden(7, 36)),
        rtps(hidden(7, 20)),  # an INFO_DST is no message
        rtps(
            submessage(0x33, b"\0\0\0\3" + bytes(16)),  # signed: what follows is as it is
            spdp,
            submessage(0x34, bytes(20)),
        ),
        rtps(submessage(0x33, b"\0\0\0\4" + bytes(16)), submessage(0x30, bytes(100))),
    )
    assert list(capture.messages()["kind"]) == [
        *("Encrypted key exchange", "Encrypted", "SPDP", "Encrypted"),
    ]
    assert list(capture.messages()["entity"]) == ["keys", "other", "participants", "other"]
    (note,) = (note for note in capture.notes if "Security" in note)
    assert note.startswith("2 RTPS messages are encrypted by DDS Security; they count as discovery")


def test_a_secured_fleet_is_neither_sick_nor_known_to_be_complete() -> None:
    diagnosis = ds.read_capture(STORED / "fast_dds.pcap.xz").diagnosis()
    assert [finding.kind for finding in diagnosis.findings] == ["encrypted"]
    assert diagnosis.wrong == ()
    assert (diagnosis.complete, diagnosis.healthy) == (None, None)
    assert (
        "of the 2 pairs of such processes on different hosts, 2 exchanged keys"
        in diagnosis.summary()
    )
    assert "ROS_SECURITY_ENABLE=false" in diagnosis.summary()


def test_the_command_says_that_endpoints_are_encrypted(tmp_path: Path) -> None:
    text = " ".join(command("fast_dds").output.split())
    assert "DDS Security encrypts 28 messages from 10.77.0.1 and 10.77.0.2" in text
    assert "Note: DDS Security encrypts SEDP, so endpoints are unknown (shown as 0)" in text
    written = tmp_path / "fleet.toml"
    result = command("fast_dds", "--write-fleet", str(written))
    assert result.exit_code == 2
    assert "endpoints are unknown" in result.output
    assert not written.exists()


def test_a_host_without_security_is_named() -> None:
    diagnosis = ds.read_capture(STORED / "cyclone_dds_off_on_one.pcap.xz").diagnosis()
    first, *others = diagnosis.findings
    assert (first.kind, first.hosts) == ("different security", ("10.77.0.3",))
    assert "enabled on 10.77.0.1 and 10.77.0.2 and disabled on 10.77.0.3" in first.evidence
    assert [finding.kind for finding in others] == ["encrypted"]
    assert set(diagnosis.incomplete()["by"]) == {"10.77.0.3"}


def test_a_handshake_without_end_is_no_client_isolation(tmp_path: Path) -> None:
    """Nothing of what is signed or encrypted, behind an INFO_DST or not, was sent."""

    def hides(data: bytes) -> bool:
        return data[42:46] == b"RTPS" and (data[62] == 0x33 or data[78] == 0x31)

    found = packets(str(STORED / "fast_dds"))
    path = tmp_path / "handshake"
    path.write_bytes(pcap([one for one in found if not hides(one[1])]))
    diagnosis = ds.read_capture(path).diagnosis()
    assert [finding.kind for finding in diagnosis.wrong] == ["not authenticated"]
    assert len(diagnosis.incomplete()) == 2


def test_of_the_later_part_alone_nothing_is_invented(tmp_path: Path) -> None:
    found = packets(str(STORED / "fast_dds"))
    path = tmp_path / "late"
    path.write_bytes(pcap([one for one in found if one[0] > found[0][0] + 10**9]))
    assert ds.read_capture(path).diagnosis().wrong == ()
