"""Discovery is watched as it happens: in bounded memory, with clear errors, and a clean end."""

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
from support import REFERENCE, ROOT, missing

from discostorm.cli import main
from discostorm_capture import CaptureError, read_capture
from discostorm_capture.live import Packets, Watch

ILLS = REFERENCE / "captures" / "ills"
FAST = lzma.decompress((CAPTURES / "fast_dds.pcap.xz").read_bytes())


def watched(content: bytes, *arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(main, ["watch", "-", *arguments], input=content)
    return result.exit_code, " ".join(result.output.split())


def test_a_stream_gives_the_same_packets_in_any_pieces() -> None:
    whole = list(Packets("x").of(FAST))
    assert len(whole) == len(packets("fast_dds"))
    pieces = Packets("x")
    found = [one for at in range(0, len(FAST), 997) for one in pieces.of(FAST[at : at + 997])]
    assert found == whole
    assert pieces.cut == ""


def test_it_counts_what_a_file_holds() -> None:
    code, text = watched(FAST)
    assert code == 0
    assert "1,063 packets in 40.5 s" in text
    assert "Discovery is healthy, complete and over: 6 processes on 3 hosts" in text
    assert "SPDP" in text
    assert "10.77.0.3" in text


def test_findings_become_certain_after_two_diagnoses() -> None:
    content = lzma.decompress((ILLS / "firewall_on_one_host-cyclone_dds_0_10.pcap.xz").read_bytes())
    stream, told = Packets("x"), Watch()
    kinds = []
    for at in range(0, len(content), 4096):
        for when, packet in stream.of(content[at : at + 4096]):
            told.add(when, packet)
        told.fold(stream.header)
        kinds.append({kind for kind, _ in told.certain})
    assert not kinds[0]
    assert kinds[-1] == {"firewall"}
    assert told.packets == len(list(Packets("x").of(content)))


def test_old_packets_are_dropped_and_all_are_counted() -> None:
    stream, told = Packets("x"), Watch(kept=40_000)
    for when, packet in stream.of(FAST):
        told.add(when, packet)
        if told.full:
            told.fold(stream.header)
    told.fold(stream.header)
    assert told.packets == 1063
    assert told.size <= 40_000 + 1500
    whole = Watch()
    for when, packet in Packets("x").of(FAST):
        whole.add(when, packet)
    whole.fold(FAST[:24])
    # A datagram in fragments may be cut by what is dropped.
    assert sum(told.messages.values()) == pytest.approx(sum(whole.messages.values()), rel=0.02)
    assert told.airtime == pytest.approx(whole.airtime, rel=0.02)
    assert told.peak == pytest.approx(whole.peak, rel=0.05)


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
        (b"", "it ended before a packet came"),
        (FAST[:10], "it ended before a packet came"),
        (bytes(100), "no pcap: it starts with 00 00 00 00"),
        (FAST[:-3], "it ended inside of a packet"),
    ],
)
def test_a_pipe_that_is_none_or_ends_is_told(content: bytes, said: str) -> None:
    code, text = watched(content)
    assert code == 2
    assert said in text


def test_a_broken_length_is_told() -> None:
    content = pcap(packets("fast_dds")[:2]) + struct.pack("<IIII", 0, 0, 1 << 30, 1 << 30)
    with pytest.raises(CaptureError, match="a packet of 1073741824 bytes"):
        list(Packets("x").of(content))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "either -i with an interface, or -"),
        (["-i", "lo", "-"], "either -i with an interface, or -"),
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
        missing("no tcpdump here; on Debian: apt-get install tcpdump")
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
    monkeypatch.setattr("discostorm_capture.cli.watch.PATIENCE", -1.0)
    monkeypatch.setattr("discostorm_capture.cli.watch._chunks", lambda _: iter([b"", b"", FAST]))
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
