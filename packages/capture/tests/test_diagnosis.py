"""Sick fleets get the right diagnosis, healthy ones none, and times are those of logs."""

import json
import lzma
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner
from handmade_captures import packets, pcap
from support import REFERENCE

import discostorm as ds
from discostorm.cli import main
from discostorm.data import data_path, read_data
from discostorm.snippets import snippets
from discostorm_capture import Capture
from discostorm_capture.diagnosis.diagnose import MAX_TIMELINE_ROWS
from discostorm_capture.diagnosis.finding import finding_kinds, remedies
from discostorm_capture.diagnosis.observations import remove_clock_steps
from discostorm_capture.dissection import Recording
from discostorm_capture.live_capture import PacketStream

ILLS = REFERENCE / "captures" / "ills"
SECOND = 10**9
#: What each capture of `captures/ills` is of: the kind of its first finding,
#: and the last parts of the hosts' addresses that it names.
STAGED: dict[str, tuple[str, str]] = {
    "multicast_filtered-cyclone_dds_0_10": ("nobody hears", "123"),
    "multicast_filtered-zenoh_peer": ("nobody hears", "123"),
    "firewall_on_one_host-cyclone_dds_0_10": ("firewall", "2"),
    "firewall_on_one_host-zenoh_peer": ("firewall", "2"),
    "loss_of_20__-fast_dds": ("heavy loss", ""),
    "loss_of_20__-zenoh_peer": ("heavy loss", ""),
    "one_direction_of_a_host-cyclone_dds_0_10": ("one direction", "2"),
    "one_direction_of_a_pair-zenoh_peer": ("one direction of pairs", "3"),
    "client_isolation-zenoh_peer": ("unicast dropped", "123"),
    "client_isolation_but_for_one-cyclone_dds_0_10": ("client isolation", "234"),
    "two_domains-fast_dds": ("two domains", "1234"),
    "other_subnet-zenoh_peer": ("other subnet", "2"),
    "wrong_interface-cyclone_dds_0_10": ("wrong interface", "2"),
    "capture_began_late-cyclone_dds_0_10": ("capture began late", ""),
    "capture_filter-fast_dds": ("nobody hears, or filter", "123"),
    "capture_filter-zenoh_peer": ("nobody hears, or filter", "123"),
    "view_of_one_robot-cyclone_dds_0_10": ("view of one host", "2"),
    "crash-cyclone_dds_0_10": ("crash", "2"),
    "restart-cyclone_dds_0_10": ("restart", "2"),
    "late_joiner-cyclone_dds_0_10": ("late joiner", "4"),
    "leases_expire-cyclone_dds_0_10": ("leases expire", "2"),
    "server_never_there-zenoh-router": ("server down", "101"),
    "server_never_there-fast_dds-server": ("server down", "101"),
    "server_dies-zenoh-router": ("server down", "101"),
    "clock_set_back-cyclone_dds_0_10": ("clock back", ""),
    "clock_set_forward-zenoh_peer": ("clock on", ""),
}


def ill(name: str) -> Capture:
    return ds.read_capture(ILLS / f"{name}.pcap.xz")


def rewritten(tmp_path: Path, name: str, change: Any) -> Capture:
    """Return one of the captures here with its packets, each with its time, changed."""
    path = tmp_path / "capture"
    path.write_bytes(pcap(change(packets(name))))
    return ds.read_capture(path)


# ---------------------------------------------------------------- what was staged is found


@pytest.mark.parametrize("name", STAGED)
def test_what_was_staged_is_found_first(name: str) -> None:
    kind, hosts = STAGED[name]
    first = ill(name).diagnosis().findings[0]
    assert first.kind == kind
    named = sorted(host.rpartition(".")[2] for host in first.hosts)
    assert "".join(named) == hosts


def test_every_capture_is_told_of() -> None:
    healthy = {"healthy-fast_dds-server", "healthy-zenoh-router"}
    assert {path.name.removesuffix(".pcap.xz") for path in ILLS.glob("*.xz")} == healthy | {*STAGED}


@pytest.mark.parametrize("name", ["healthy-fast_dds-server", "healthy-zenoh-router"])
def test_healthy_fleets_with_a_server_have_no_findings(name: str) -> None:
    diagnosis = ill(name).diagnosis()
    assert diagnosis.findings == ()
    assert (diagnosis.healthy, diagnosis.complete, diagnosis.over) == (True, True, True)
    assert diagnosis.summary().startswith("Discovery is healthy, complete and settled: ")


@pytest.mark.parametrize("name", ["fast_dds", "cyclone_dds_010", "zenoh_data"])
def test_the_chapters_captures_are_healthy(name: str) -> None:
    diagnosis = ds.read_capture(
        data_path(f"captures/{name}.pcap.xz", "discostorm_capture")
    ).diagnosis()
    assert diagnosis.wrong == ()
    assert diagnosis.complete
    assert diagnosis.incomplete().empty


@pytest.mark.parametrize("name", ["fast_dds_server", "zenoh_router", "zenoh_udp"])
def test_other_captures_of_healthy_fleets_are_healthy(name: str) -> None:
    diagnosis = ds.read_capture(ILLS.parent / f"{name}.pcap.xz").diagnosis()
    assert diagnosis.wrong == ()
    assert diagnosis.complete


# ---------------------------------------------------------------- what is told of it


def test_kinds_and_remedies_belong_together() -> None:
    known = {row["kind"] for row in read_data("vendors/remedies.csv")}
    used = {row["remedy"] for row in finding_kinds().values()} - {""}
    assert used == {*remedies()}
    for row in finding_kinds().values():
        assert row["about"] in ("fleet", "event", "capture")
        assert row["summary"]
        assert row["source"]
    for row in remedies().values():
        assert row["what"]
        assert row["source"]
        for plan in filter(None, row["plan"].split(";")):
            assert plan in known
            assert snippets(plan, "DDS", "Zenoh", "Fast DDS", "Cyclone DDS")


def test_who_never_answered_is_in_the_tables() -> None:
    diagnosis = ill("firewall_on_one_host-cyclone_dds_0_10").diagnosis()
    pairs = diagnosis.incomplete()
    assert set(pairs["of"]) | set(pairs["by"]) == {"10.77.0.1", "10.77.0.2", "10.77.0.3"}
    assert all("10.77.0.2" in ends for ends in zip(pairs["of"], pairs["by"], strict=True))
    hosts = diagnosis.hosts()
    assert hosts.loc["10.77.0.2", "knows_all_s"] == np.inf
    assert hosts.loc["10.77.0.2", "received"] > hosts.loc["10.77.0.2", "sent"] > 0
    assert diagnosis.complete is False


def test_the_last_host_is_told_apart() -> None:
    diagnosis = ill("late_joiner-cyclone_dds_0_10").diagnosis()
    hosts = diagnosis.hosts()
    assert hosts["announced_s"].idxmax() == "10.77.0.4"
    assert diagnosis.complete_at == pytest.approx(hosts["knows_all_s"].max())
    assert diagnosis.complete_at > hosts.loc["10.77.0.4", "announced_s"]


def test_a_jump_of_the_clock_changes_no_time(tmp_path: Path) -> None:
    def later(found: Any) -> Any:
        half = found[len(found) // 2][0]
        return [(time + 7200 * SECOND * (time > half), *rest) for time, *rest in found]

    def plain(found: Any) -> Any:
        return found

    jumped, straight = (rewritten(tmp_path, "fast_dds", change) for change in (later, plain))
    diagnosis, expected = jumped.diagnosis(), straight.diagnosis()
    assert [finding.kind for finding in diagnosis.findings] == ["clock on"]
    assert expected.findings == ()
    assert diagnosis.complete_at == pytest.approx(expected.complete_at, abs=0.1)


def test_times_without_clock_steps() -> None:
    table = pd.DataFrame({"time": [5.0, 6.0, 106.0, 76.0], "frame": [1, 2, 3, 4]})
    found = remove_clock_steps(table, Recording(0, ((3, 100.0), (4, -30.0)), 5.0, 71, {}, ()))
    assert found["time"].tolist() == [0.0, 1.0, 1.0, 1.0]


def test_without_the_last_part_nothing_is_invented(tmp_path: Path) -> None:
    """A capture that ends right after the start shows neither a crash nor a firewall."""
    for seconds in (1, 2, 3, 5, 9):

        def short(found: Any, seconds: int = seconds) -> Any:
            return [packet for packet in found if packet[0] < found[0][0] + seconds * SECOND]

        assert rewritten(tmp_path, "fast_dds", short).diagnosis().wrong == ()


def test_of_the_later_part_alone_it_says_that_it_began_late(tmp_path: Path) -> None:
    def late(found: Any) -> Any:
        return [packet for packet in found if packet[0] > found[0][0] + 20 * SECOND]

    diagnosis = rewritten(tmp_path, "fast_dds", late).diagnosis()
    assert [finding.kind for finding in diagnosis.findings] == ["capture began late"]
    assert diagnosis.wrong == ()
    assert diagnosis.healthy is not False


FIRST_HOST = bytes([10, 77, 0, 1])


def without_sender(found: Any) -> Any:
    return [packet for packet in found if packet[1][26:30] != FIRST_HOST]


def without_unicast_to(found: Any) -> Any:
    return [packet for packet in found if packet[1][30:34] != FIRST_HOST]


def after_a_second(found: Any) -> Any:
    return [packet for packet in found if packet[0] > found[0][0] + SECOND]


def mirrored(found: Any) -> Any:
    return [(when + late, *rest) for when, *rest in found for late in (0, 5000)]


def cut(found: Any) -> Any:
    return [(when, data[:90], length) for when, data, length in found]


@pytest.mark.parametrize("name", ["fast_dds", "cyclone_dds_11", "zenoh_data"])
@pytest.mark.parametrize("change", [mirrored, without_sender, after_a_second, cut])
def test_what_a_capture_lacks_or_repeats_is_no_fault_of_the_fleet(
    name: str, change: Any, tmp_path: Path
) -> None:
    diagnosis = rewritten(tmp_path, name, change).diagnosis()
    assert diagnosis.wrong == ()
    assert not [one for one in diagnosis.findings if one.kind == "late joiner"]
    assert diagnosis.complete is (True if change is mirrored else None)
    if change is without_sender:
        lost = [one for one in diagnosis.findings if one.kind == "capture lost part"]
        assert any("10.77.0.1" in one.hosts for one in lost)


def test_confirmed_samples_that_the_capture_lacks_clear_who_should_have_sent_them(
    tmp_path: Path,
) -> None:
    diagnosis = rewritten(tmp_path, "cyclone_dds_010", without_unicast_to).diagnosis()
    assert diagnosis.wrong == ()
    assert [one.kind for one in diagnosis.findings] == ["capture lost part"]


def test_two_hosts_of_which_one_is_not_in_the_capture_are_not_one_alone(tmp_path: Path) -> None:
    diagnosis = rewritten(tmp_path, "cyclone_dds_010", without_sender).diagnosis()
    assert diagnosis.wrong == ()
    assert "but the capture contains no message from" in diagnosis.summary()


def test_two_hosts_with_keys_of_which_one_is_not_in_the_capture(tmp_path: Path) -> None:
    name = ILLS.parent / "security" / "fast_dds.pcap.xz"
    found = PacketStream("x").feed(lzma.decompress(name.read_bytes()))
    path = tmp_path / "capture"
    path.write_bytes(
        pcap(
            (int(when * SECOND), packet[16:], len(packet) - 16)
            for when, packet in found
            if packet[42:46] != FIRST_HOST
        )
    )
    diagnosis = ds.read_capture(path).diagnosis()
    assert diagnosis.wrong == ()
    (lost,) = [one for one in diagnosis.findings if one.kind == "capture lost part"]
    assert lost.hosts == ("10.77.0.1",)
    assert "(1 process on 1 host)" in diagnosis.summary()


def test_who_asks_no_more_was_answered(tmp_path: Path) -> None:
    """Without the answers of one host the capture lacks them, as its peers stop asking."""
    content = lzma.decompress((ILLS / "healthy-fast_dds-server.pcap.xz").read_bytes())
    kept = [
        (int(when * SECOND), packet[16:], len(packet) - 16)
        for when, packet in PacketStream("x").feed(content)
        if packet[46:50] != FIRST_HOST
    ]
    path = tmp_path / "capture"
    path.write_bytes(pcap(kept))
    diagnosis = ds.read_capture(path).diagnosis()
    assert (diagnosis.complete, diagnosis.wrong) == (None, ())
    assert "no longer ask" in diagnosis.summary()


def test_a_sick_fleet_that_is_complete_is_said_to_be_so() -> None:
    text = ill("loss_of_20__-zenoh_peer").diagnosis().summary()
    assert text.startswith("Discovery is complete, but not healthy: many frames are lost")


def test_discovery_that_fills_the_channel_is_why_frames_are_lost() -> None:
    capture = ill("loss_of_20__-fast_dds")
    rows = capture._messages
    more = rows["frames"].where(rows["kind"].str.startswith("User"), np.float32(300))
    first = replace(capture, _messages=rows.assign(frames=more)).diagnosis().findings[0]
    assert first.kind == "discovery fills channel"
    assert first.advice.startswith("Use fewer processes")


@pytest.mark.parametrize(
    "name", ["firewall_on_one_host-cyclone_dds_0_10", "one_direction_of_a_host-cyclone_dds_0_10"]
)
def test_the_first_seconds_of_a_sick_fleet_are_not_called_healthy(
    name: str, tmp_path: Path
) -> None:
    found = list(PacketStream("x").feed(lzma.decompress((ILLS / f"{name}.pcap.xz").read_bytes())))
    for span in (1, 3):
        path = tmp_path / "capture"
        kept = [one for one in found if one[0] < found[0][0] + span]
        path.write_bytes(
            pcap((int(when * SECOND), packet[16:], len(packet) - 16) for when, packet in kept)
        )
        diagnosis = ds.read_capture(path).diagnosis()
        assert diagnosis.healthy is None
        assert "capture ended early" in [one.kind for one in diagnosis.findings]
        assert "Capture for longer" in diagnosis.summary()


def test_an_empty_capture_says_so(tmp_path: Path) -> None:
    diagnosis = rewritten(tmp_path, "fast_dds", lambda _: []).diagnosis()
    said, what_to_do = diagnosis.summary().split(". ", 1)
    assert said == "The capture shows no DDS or Zenoh discovery"
    assert what_to_do.startswith("Record on the interface that the robots use")
    assert (diagnosis.healthy, diagnosis.complete, diagnosis.over) == (None, None, None)


# ---------------------------------------------------------------- the command


def run(*arguments: str) -> Any:
    return CliRunner().invoke(main, ["capture", *arguments], catch_exceptions=False)


def test_the_command_says_the_answer_first() -> None:
    result = run(str(ILLS / "firewall_on_one_host-cyclone_dds_0_10.pcap.xz"))
    assert result.exit_code == 0
    text = " ".join(result.output.split())
    assert text.startswith(
        "Discovery is neither healthy nor complete: 10.77.0.2 hears no other host"
    )
    assert "Pairs that never completed (" in text
    assert text.index("ufw status") < text.index("first [s]") < text.index("message units")


def test_json_has_the_findings_with_what_to_paste() -> None:
    result = run(str(ILLS / "multicast_filtered-cyclone_dds_0_10.pcap.xz"), "--json")
    answer = json.loads(result.output)["diagnosis"]
    assert answer["healthy"] is False
    (finding,) = answer["findings"]
    assert finding["kind"] == "nobody hears"
    assert finding["hosts"] == sorted(finding["hosts"]) or len(finding["hosts"]) == 3
    assert any("Peers" in piece["text"] for piece in finding["paste"])
    assert all(host["knows_all_s"] is None for host in answer["hosts"])
    assert len(answer["incomplete"]) == answer["pairs"] == 6


def test_json_has_the_times_of_messages_in_a_bounded_table() -> None:
    path = ILLS / "multicast_filtered-cyclone_dds_0_10.pcap.xz"
    told = json.loads(run(str(path), "--json").output)["diagnosis"]["timeline"]
    assert told.keys() == {"until_s", "step_s", "left_out", "rows"}
    assert len(told["rows"]) <= MAX_TIMELINE_ROWS
    capture = ds.read_capture(path)
    assert told["until_s"] == capture.messages()["time"].max()  # it never completed
    assert sum(row["bytes"] for row in told["rows"]) == capture.messages()["bytes"].sum()


def test_the_timeline_ends_a_little_after_the_startup() -> None:
    diagnosis = ds.read_capture(
        data_path("captures/cyclone_links_fail.pcap.xz", "discostorm_capture")
    ).diagnosis()
    timeline = diagnosis.timeline()
    assert timeline.attrs == {"until_s": 2.0, "step_s": 0.0, "left_out": 0}
    assert timeline["time_s"].is_monotonic_increasing
    assert timeline["time_s"].max() <= 2.0 < 1.35 * diagnosis.complete_at
    first = timeline.iloc[0]
    assert (first["host"], first["receiver"], first["kind"]) == ("10.77.0.3", "239.255.0.1", "SPDP")
    assert first["multicast"] is True or first["multicast"]


@pytest.mark.parametrize("most", [300, 60, 7])
def test_steps_of_the_timeline_keep_every_message(most: int) -> None:
    diagnosis = ds.read_capture(
        data_path("captures/fast_dds.pcap.xz", "discostorm_capture")
    ).diagnosis()
    whole, some = diagnosis.timeline(10**6), diagnosis.timeline(most)
    assert whole.attrs["step_s"] == 0 < some.attrs["step_s"]
    assert len(some) <= most < len(whole)
    assert some["receiver"].isna().all()
    left = whole["messages"].sum() - some["messages"].sum()
    assert left == some.attrs["left_out"]
    assert (left == 0) == (most > 7)
    if most == 300:  # each host says as much, and each step is as short as it can be
        sums = [one.groupby(["host", "kind"])["bytes"].sum() for one in (whole, some)]
        assert sums[0].equals(sums[1])
        assert diagnosis.timeline(len(some) - 1).attrs["step_s"] > some.attrs["step_s"]
    with pytest.raises(ValueError, match="most must be a whole number"):
        diagnosis.timeline(0)


def test_small_captures_are_small() -> None:
    assert sum(path.stat().st_size for path in ILLS.glob("*.xz")) < 400_000
    for path in ILLS.glob("*.xz"):
        assert lzma.decompress(path.read_bytes())[:4] == b"\xd4\xc3\xb2\xa1"


def test_discovery_and_user_data_are_two_sums() -> None:
    with_data = ill("crash-cyclone_dds_0_10")
    sums = with_data.sums()
    assert list(sums.index) == ["discovery", "user data"]
    assert sums["bytes"].sum() == pytest.approx(with_data.compare(ds.DDS)["bytes"].sum())
    assert sums["airtime_s"].sum() == pytest.approx(with_data.compare(ds.DDS)["airtime_s"].sum())
    rows = with_data.compare(ds.DDS)
    user = rows[[str(kind).startswith("User") for kind in rows.index]]
    assert sums.loc["user data", "bytes"] == user["bytes"].sum() > 0
    zenoh = ds.read_capture(data_path("captures/zenoh_data.pcap.xz", "discostorm_capture"))
    # A put of 100 kB, as its README says.
    assert zenoh.sums().loc["user data", "bytes"] > 100_000 > zenoh.sums().loc["discovery", "bytes"]


def test_a_window_counts_its_seconds_alone() -> None:
    capture = ds.read_capture(data_path("captures/fast_dds.pcap.xz", "discostorm_capture"))
    table = ds.PROTOCOLS["Fast DDS"]
    assert capture.compared_seconds(table, 12) == 12
    short, whole = capture.compare(table, window=12), capture.compare(table)
    assert short.loc["SPDP", "unicast"] < whole.loc["SPDP", "unicast"]
    assert short.loc["SPDP", "expected"] < whole.loc["SPDP", "expected"]
    with pytest.raises(ValueError, match="window must be"):
        capture.compare(table, window=0)


def test_breakdown_counts_the_same_window() -> None:
    fleet = "[[groups]]\nhosts = 3\nprocesses = 2\nendpoints = 10\nshared = 0\n"
    arguments = ["breakdown", "-", "--protocol", "Fast DDS 2.9", "--window"]
    result = CliRunner().invoke(main, [*arguments, "12", "--json"], input=fleet)
    rows = json.loads(result.output)
    capture = ds.read_capture(data_path("captures/fast_dds.pcap.xz", "discostorm_capture"))
    found = capture.compare(ds.PROTOCOLS["Fast DDS"], window=12)["bytes"].sum()
    assert sum(row["payload_bytes"] for row in rows) == pytest.approx(found, rel=0.16)
    bad = CliRunner().invoke(main, [*arguments, "0"], input=fleet)
    assert bad.exit_code == 2
    assert "--window must be" in bad.output


def test_the_fleet_that_was_seen_is_written(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    result = run(
        str(ILLS / "client_isolation_but_for_one-cyclone_dds_0_10.pcap.xz"),
        "--write-fleet",
        str(path),
        "--wired",
        "10.77.0.1",
    )
    assert result.exit_code == 0
    fleet = ds.Fleet.from_toml(path)
    assert sum(group.hosts for group in fleet.groups) == 4
    assert [group.hosts for group in fleet.groups if group.wired] == [1]
    (following,) = [line for line in result.stdout.splitlines() if line.startswith("Wrote ")]
    assert f"Next: discostorm plan {path}" in following
    bad = run(str(ILLS / "crash-cyclone_dds_0_10.pcap.xz"), "--write-fleet", "-")
    assert (bad.exit_code, "- is not a file" in bad.output) == (2, True)
    bad = run(
        str(ILLS / "crash-cyclone_dds_0_10.pcap.xz"), "--write-fleet", str(tmp_path / "no" / "f")
    )
    assert bad.exit_code == 2
    assert list(tmp_path.iterdir()) == [path]
