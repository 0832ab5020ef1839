"""Discovery is watched as it happens: in bounded memory, with clear errors, and a clean end."""

import io
import lzma
import os
import shutil
import signal
import socket
import struct
import subprocess
import sys
import time
import urllib.request
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner
from handmade_captures import CAPTURES, packets, pcap
from support import REFERENCE, ROOT, skip_or_fail

from discostorm.cli import main
from discostorm_capture import CaptureError, read_capture
from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.live_capture import PacketStream, Watch
from discostorm_capture.presence import Activity, Presence

ILLS = REFERENCE / "captures" / "ills"
FAST = lzma.decompress((CAPTURES / "fast_dds.pcap.xz").read_bytes())


def watched(content: bytes, *arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(main, ["watch", "-", *arguments], input=content)
    return result.exit_code, " ".join(result.output.split())


def test_a_stream_gives_the_same_packets_in_any_pieces() -> None:
    whole = list(PacketStream("x").feed(FAST))
    assert len(whole) == len(packets("fast_dds"))
    pieces = PacketStream("x")
    found = [one for at in range(0, len(FAST), 997) for one in pieces.feed(FAST[at : at + 997])]
    assert found == whole
    assert pieces.error_if_ended == ""


def test_it_counts_what_a_file_holds() -> None:
    code, text = watched(FAST)
    assert code == 0
    assert "1,063 packets in 40.5 s" in text
    assert "Discovery is healthy, complete and settled: 6 processes on 3 hosts" in text
    assert "SPDP" in text
    assert "10.77.0.3" in text


def test_findings_become_certain_after_two_diagnoses() -> None:
    content = lzma.decompress((ILLS / "firewall_on_one_host-cyclone_dds_0_10.pcap.xz").read_bytes())
    stream, told = PacketStream("x"), Watch()
    kinds = []
    for at in range(0, len(content), 4096):
        for when, packet in stream.feed(content[at : at + 4096]):
            told.add_packet(when, packet)
        told.count_and_diagnose(stream.header)
        kinds.append({kind for kind, _ in told.certain_findings})
    assert not kinds[0]
    assert kinds[-1] == {"firewall"}
    assert told.packets == len(list(PacketStream("x").feed(content)))


def test_old_packets_are_dropped_and_all_are_counted() -> None:
    stream, told = PacketStream("x"), Watch(max_bytes=40_000)
    for when, packet in stream.feed(FAST):
        told.add_packet(when, packet)
        if told.must_count_now:
            told.count_and_diagnose(stream.header)
    told.count_and_diagnose(stream.header)
    assert told.packets == 1063
    assert told.kept_bytes <= 40_000 + 1500
    whole = Watch()
    for when, packet in PacketStream("x").feed(FAST):
        whole.add_packet(when, packet)
    whole.count_and_diagnose(FAST[:24])
    # A datagram in fragments may be cut by what is dropped.
    assert sum(told.messages.values()) == pytest.approx(sum(whole.messages.values()), rel=0.02)
    assert told.airtime == pytest.approx(whole.airtime, rel=0.02)
    assert told.airtime_peak == pytest.approx(whole.airtime_peak, rel=0.05)


STAGED = Path(__file__).with_name("captures")
CLOCKS = ("clock_set_back-cyclone_dds_0_10", "clock_set_forward-zenoh_peer")
#: Robots that ran before the capture began. 10.77.0.2 was disconnected for 14 s after 22.5 s, and
#: from 44.5 s on a firewall on 10.77.0.3 dropped what came in (Cyclone DDS 11.0.1, 2 samples/s).
BESIDE = lzma.decompress((STAGED / "watched_beside_robots.pcap.xz").read_bytes())
#: Captures in which 10.77.0.2 falls silent (lab/grids/fault_missing_hosts.toml), with a time after
#: that and before it comes back, if it does [s].
SILENT = {
    "watched_beside_robots": 30.0,
    "watched_fast_dds_cut": 99.0,
    "watched_zenoh_cut": 99.0,
    "watched_zenoh_killed": 99.0,
}


def each_second(content: bytes) -> list[tuple[float, str, set[str], Watch]]:
    """Return when each second ended, what was said then, the certain findings, and the watch."""
    stream, watch = PacketStream("x"), Watch()
    seconds: list[tuple[float, str, set[str], Watch]] = []
    last = 0.0
    for when, packet in stream.feed(content):
        last = last or when
        if abs(when - last) > 1:
            last = when
            watch.count_and_diagnose(stream.header)
            kinds = {kind for kind, _ in watch.certain_findings}
            seconds.append((when - watch.begin, watch.summary(), kinds, watch))
        watch.add_packet(when, packet)
    return seconds


def test_beside_running_robots_it_learns_who_speaks_and_names_who_stops() -> None:
    seconds = each_second(BESIDE)
    said = {int(when): text for when, text, _, _ in seconds}
    assert said[5].endswith("We first learn for 10 s how often each one sends.")
    healthy = "Robots were already running when we began: 3 hosts, no host is silent, "
    healthy += "and none asks for repeats."
    assert {said[second] for second in range(11, 22)} == {healthy}
    first = min(when for when, _, kinds, _ in seconds if "silent" in kinds)
    assert 22.5 < first < 22.5 + 3 * 1.0  # in steps of more than a second
    assert said[26].startswith("10.77.0.2 fell silent. Nothing came from 10.77.0.2 for ")
    assert ". Check whether 10.77.0.2 is on and within Wi-Fi range" in said[26]
    _, text, kinds, _ = seconds[-1]
    assert "answers no more" in kinds
    assert text.startswith("10.77.0.3 still sends, but no longer answers any host")


def test_a_host_heard_too_briefly_to_be_judged_is_named_and_not_called_present() -> None:
    """It announces itself every 8 s, and stopped 8 s after the capture began."""
    hosts = {"10.77.0.1": Activity(0.0, 29.5), "10.77.0.3": Activity(0.2, 8.2, longest_pause=8.0)}
    presence = Presence(hosts, now=30.0)
    assert presence.findings() == []
    told = "2 hosts, nothing came lately from 10.77.0.3, and none asks for repeats."
    assert presence.summary(0.0).endswith(told)


def test_a_host_that_just_fell_silent_is_not_said_to_send_still() -> None:
    asked = Activity(0.0, 28.5, longest_pause=0.5, asked_at=29.9)
    presence = Presence({"10.77.0.3": Activity(0.0, 28.8)}, {("10.77.0.3", "10.77.0.1"): asked})
    for last, kinds in ((28.8, []), (29.8, ["answers no more"])):
        presence.hosts["10.77.0.3"].last, presence.now = last, 30.0
        assert [one.kind for one in presence.findings()] == kinds


def listened(content: bytes) -> list[tuple[float, list[str]]]:
    """Return when others were absent than before, and who, while the command listens."""
    stream, watch = PacketStream("x"), Watch()
    found, now, newest = list[tuple[float, list[str]]](), 0.0, 0.0
    for when, packet in stream.feed(content):
        now = now or when
        while when - now >= LIMITS.renewal_period:  # also while nothing comes
            now += LIMITS.renewal_period
            if watch.update_presence(stream.header, now - newest):
                found.append((now - watch.begin, [one.kind for one in watch.host_findings]))
        watch.add_packet(when, packet)
        newest = when
    return found


@pytest.mark.parametrize("name", SILENT)
def test_a_robot_that_falls_silent_is_missed_within_three_of_its_periods(name: str) -> None:
    """Which count as half a second at least, as Wi-Fi pauses, too."""
    content = lzma.decompress((STAGED / f"{name}.pcap.xz").read_bytes())
    spoke = read_capture(io.BytesIO(content)).messages().query("sender == '10.77.0.2'")["time"]
    before = spoke[spoke < spoke.min() + SILENT[name]]
    period = max(0.5, before.sort_values().diff().max())
    ((told, kinds), *_) = listened(content)
    # Of two hosts the other one has nobody to speak to.
    assert {*kinds} == {"silent"}
    assert before.max() + period < told <= before.max() + 3 * period


def test_who_left_and_came_back_is_named_as_it_happens() -> None:
    changes = [said for _, said in each_second(BESIDE)[-1][-1].presence.changes]
    assert [said.partition(" after ")[0].partition(":")[0] for said in changes] == [
        "10.77.0.2 fell silent",
        "10.77.0.2 came back",
        "10.77.0.3 still sends, but has answered no other host for 1.4 s",
    ]
    code, text = watched(BESIDE, "--follow-fleet")
    assert code == 0
    assert "10.77.0.2 came back after 21.8 s" in text
    code, text = watched(BESIDE)
    assert "came back" not in text


@pytest.mark.parametrize("name", ["fast_dds", "zenoh_data", *CLOCKS])
def test_no_host_of_a_healthy_fleet_is_silent_or_comes_back(name: str) -> None:
    folder = ILLS if name.startswith("clock") else CAPTURES
    content = lzma.decompress((folder / f"{name}.pcap.xz").read_bytes())
    absent = {"silent", "answers no more", "refuses"}
    seconds = each_second(content)
    assert not [kinds for _, _, kinds, _ in seconds if kinds & absent]
    changes = [said for _, said in seconds[-1][-1].presence.changes]
    assert not [said for said in changes if "left with a goodbye" not in said]


@pytest.mark.parametrize("step", [-60, 3600])
def test_a_clock_that_is_set_makes_no_host_silent(step: int) -> None:
    found = packets("watched_beside_robots", STAGED)
    start, second = found[0][0], 10**9
    found = [
        (time + step * second * (time > start + 15 * second), *rest)
        for time, *rest in found
        if time < start + 21 * second
    ]
    seconds = each_second(pcap(found, link=276))
    assert not [kinds for _, _, kinds, _ in seconds if "silent" in kinds]
    assert not seconds[-1][-1].presence.changes


@pytest.mark.parametrize(("name", "port"), [("fast_dds-server", 11811), ("zenoh-router", 7447)])
def test_a_server_that_refuses_is_told_at_once(name: str, port: int) -> None:
    content = lzma.decompress((ILLS / f"server_never_there-{name}.pcap.xz").read_bytes())
    when, kinds = listened(content)[0]
    assert (when < 1.5, kinds) == (True, ["refuses"])
    text = next(text for _, text, kinds, _ in each_second(content) if "refuses" in kinds)
    assert ". 10.77.0.101 refuses packets from 10.77.0." in text
    assert f"to port {port}" in text


def test_a_port_of_other_programs_that_is_closed_is_no_refusal() -> None:
    """10.77.0.2 copies files from 10.77.0.1, and calls its port 22 in vain."""
    assert not listened(lzma.decompress((STAGED / "healthy_file_copy.pcap.xz").read_bytes()))


def test_metrics_are_written_whole(tmp_path: Path) -> None:
    path = tmp_path / "discostorm.prom"
    assert watched(FAST, "--text-file", str(path))[0] == 0
    lines = path.read_text().splitlines()
    assert "discostorm_packets_total 1063" in lines
    airtime = read_capture(CAPTURES / "fast_dds.pcap.xz").airtime().sum()
    assert f"discostorm_airtime_seconds_total {airtime:.10g}" in lines
    assert "discostorm_hosts 3" in lines
    assert "discostorm_complete 1" in lines
    assert 'discostorm_messages_total{kind="SEDP"} 244' in lines
    assert [one.name for one in tmp_path.iterdir()] == ["discostorm.prom"]


def test_metrics_are_served() -> None:
    port = free_port()
    with subprocess.Popen(
        [sys.executable, "-m", "discostorm", "watch", "-", "--prometheus", str(port)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
    ) as running:
        assert running.stdin is not None
        running.stdin.write(FAST)
        running.stdin.flush()
        wait_for(lambda: "discostorm_hosts 3" in answer_of(port))
        running.stdin.close()
        assert running.wait(30) == 0


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "ended before any packet arrived"),
        (FAST[:10], "ended before any packet arrived"),
        (bytes(100), "not a pcap: it starts with the bytes 00 00 00 00"),
        (FAST[:-3], "ended in the middle of a packet"),
    ],
)
def test_a_pipe_that_is_none_or_ends_is_told(content: bytes, said: str) -> None:
    code, text = watched(content)
    assert code == 2
    assert said in text


def test_a_broken_length_is_told() -> None:
    content = pcap(packets("fast_dds")[:2]) + struct.pack("<IIII", 0, 0, 1 << 30, 1 << 30)
    with pytest.raises(CaptureError, match="a packet has 1073741824 bytes"):
        list(PacketStream("x").feed(content))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "give either -i INTERFACE, or - for standard input"),
        (["-i", "lo", "-"], "give either -i INTERFACE, or - for standard input"),
        (["-", "--seconds", "0"], "--seconds must be above 0"),
        (["-", "--text-file", "/nowhere/at/all.prom"], "there is no such folder"),
    ],
)
def test_wrong_usage_is_told(arguments: list[str], said: str) -> None:
    result = CliRunner().invoke(main, ["watch", *arguments], input=FAST)
    assert result.exit_code == 2
    assert said in " ".join(result.output.split())


def test_an_interface_that_is_none_is_told() -> None:
    if not shutil.which("tcpdump"):
        skip_or_fail("no tcpdump here; on Debian: apt-get install tcpdump")
    result = CliRunner().invoke(main, ["watch", "-i", "none0", "--seconds", "1"])
    assert result.exit_code == 2
    assert "cannot capture on none0" in result.output.replace("'", "")


NO_PERMISSION = """\
dumpcap: The capture session could not be initiated on capture device "wlan0" (You don't have \
permission to capture on that device).
Please check to make sure you have sufficient permissions.
"""


def capturing(folder: Path, name: str, script: str) -> dict[str, str]:
    """Return an environment in which a script stands for a program that captures."""
    path = folder / name
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    return os.environ | {"PATH": str(folder), "PYTHONPATH": str(ROOT)}


def heed_signals() -> None:
    """Undo what nohup and shells do to programs in the background."""
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def watching(folder: Path, name: str) -> subprocess.Popen[bytes]:
    """Watch an interface with a script in place of a program, which says its number in a file."""
    (folder / "storm.pcap").write_bytes(FAST)
    script = f'cd {folder}; echo "$@" > asked\n/bin/cat storm.pcap; echo $$ > number\n'
    return subprocess.Popen(
        [sys.executable, "-m", "discostorm", "watch", "-i", "wlan7", "--text-file", "x.prom"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=folder,
        env=capturing(folder, name, script + "exec /bin/sleep 99"),
        preexec_fn=heed_signals,
    )


def wait_for(condition: Callable[[], bool]) -> None:
    for _ in range(600):
        if condition():
            return
        time.sleep(0.05)
    raise AssertionError("it took more than 30 s")


def has_ended(number: int) -> bool:
    try:
        os.kill(number, 0)
    except ProcessLookupError:
        return True
    state = Path(f"/proc/{number}/stat")  # a zombie has ended, too
    return state.exists() and state.read_text().rpartition(")")[2].split()[0] == "Z"


@pytest.mark.parametrize("name", ["tcpdump", "dumpcap"])
@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_it_watches_an_interface_until_it_is_told_to_stop(
    name: str, end: signal.Signals, tmp_path: Path
) -> None:
    with watching(tmp_path, name) as running:
        wait_for((tmp_path / "x.prom").exists)
        running.send_signal(end)
        said, wrong = (text.decode() for text in running.communicate(timeout=30))
    assert (running.returncode, wrong) == (0, "")
    assert said.startswith("1,063 packets in 40.5 s")
    asked = (tmp_path / "asked").read_text().split()
    assert asked[:2] == ["-i", "wlan7"]
    assert ("-f" in asked) == (name == "dumpcap")
    assert has_ended(int((tmp_path / "number").read_text()))


@pytest.mark.parametrize("end", [signal.SIGHUP, signal.SIGQUIT, signal.SIGKILL])
def test_however_it_ends_what_captures_ends_too(end: signal.Signals, tmp_path: Path) -> None:
    """Also right after the program began, and where nothing can be handled."""
    with watching(tmp_path, "tcpdump") as running:
        wait_for(
            lambda: (tmp_path / "number").exists() and (tmp_path / "number").stat().st_size > 1
        )
        running.send_signal(end)
        running.communicate(timeout=30)
    number = int((tmp_path / "number").read_text())
    wait_for(lambda: has_ended(number))


def free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def answer_of(port: int) -> str:
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/metrics", timeout=5) as answer:
            return str(answer.read().decode())
    except OSError:
        return ""


def test_ended_before_a_packet_came_it_says_by_whom() -> None:
    port = free_port()
    with subprocess.Popen(
        [sys.executable, "-m", "discostorm", "watch", "-", "--prometheus", str(port)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
    ) as running:
        wait_for(lambda: "discostorm_packets_total 0" in answer_of(port))
        running.send_signal(signal.SIGTERM)
        assert running.stdout is not None
        said = running.stdout.read().decode()
    assert (running.returncode, said) == (0, "No packet came before SIGTERM ended it.\n")


def test_without_packets_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("discostorm_capture.cli.watch.IDLE_WARNING", -1.0)
    monkeypatch.setattr(
        "discostorm_capture.cli.watch.read_chunks", lambda _: iter([b"", b"", FAST])
    )
    code, text = watched(b"")
    assert (code, text.count("No packet from standard input for")) == (0, 1)


def test_a_pipe_without_a_writer_is_told(tmp_path: Path) -> None:
    path = tmp_path / "pipe"
    os.mkfifo(path)
    with subprocess.Popen(
        [sys.executable, "-m", "discostorm", "capture", str(path), "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
    ) as running:
        assert running.stderr is not None
        assert running.stderr.readline().startswith(b"Waiting for a program that writes into ")
        path.write_bytes(FAST)
        assert b'"packets": 1063' in running.communicate(timeout=60)[0]
    assert running.returncode == 0


def test_a_lack_of_permission_is_told_with_what_to_do(tmp_path: Path) -> None:
    (tmp_path / "why").write_text(NO_PERMISSION)
    done = subprocess.run(
        [sys.executable, "-m", "discostorm", "watch", "-i", "wlan0"],
        capture_output=True,
        text=True,
        check=False,
        env=capturing(tmp_path, "dumpcap", f"/bin/cat {tmp_path}/why >&2; exit 2"),
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert "dumpcap cannot capture on wlan0: The capture session could not be" in done.stderr
    assert "run it with sudo, or allow dumpcap to capture: sudo setcap" in done.stderr


def test_without_a_program_that_captures_it_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    result = CliRunner().invoke(main, ["watch", "-i", "lo"])
    assert result.exit_code == 2
    assert "neither tcpdump nor dumpcap is installed" in result.output
