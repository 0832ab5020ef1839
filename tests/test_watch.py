"""Discovery is watched as it happens: in bounded memory, with clear errors, and a clean end."""

import lzma
import os
import shutil
import socket
import struct
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest
from capture_files import CAPTURES, packets, pcap
from click.testing import CliRunner

from discostorm.capture import CaptureError
from discostorm.capture.live import Packets, Watch
from discostorm.cli import main

ILLS = Path(__file__).parent / "captures" / "ills"
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
        told.fold(stream.head)
        kinds.append({kind for kind, _ in told.certain})
    assert not kinds[0]
    assert kinds[-1] == {"firewall"}
    assert told.packets == len(list(Packets("x").of(content)))


def test_old_packets_are_dropped_and_all_are_counted() -> None:
    stream, told = Packets("x"), Watch(kept=40_000)
    for when, packet in stream.of(FAST):
        told.add(when, packet)
        if told.full:
            told.fold(stream.head)
    told.fold(stream.head)
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


def test_an_hour_of_storm_takes_no_more_memory_than_a_minute(tmp_path: Path) -> None:
    """Forty thousand packets and ten times as many: what is kept does not grow."""
    program = (
        "import resource, sys; from discostorm.capture.live import Packets, Watch\n"
        "told, stream, head = Watch(kept=1 << 20), Packets('x'), sys.argv[1]\n"
        "data = open(head, 'rb').read()\n"
        "for second in range(int(sys.argv[2])):\n"
        "    for when, packet in stream.of(data if not second else data[24:]):\n"
        "        told.add(when + 41 * second, packet)\n"
        "        told.full and told.fold(stream.head)\n"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, told.packets)\n"
    )
    path = tmp_path / "storm.pcap"
    path.write_bytes(FAST)
    used = []
    for repeats in (4, 40):
        done = subprocess.run(
            [sys.executable, "-c", program, str(path), str(repeats)],
            capture_output=True,
            text=True,
            check=True,
            env=os.environ | {"PYTHONPATH": str(Path(__file__).parents[1])},
        )
        kilobytes, count = map(int, done.stdout.split())
        assert count == 1063 * repeats
        used.append(kilobytes)
    assert used[1] < used[0] + 20_000


def test_metrics_are_written_whole(tmp_path: Path) -> None:
    path = tmp_path / "discostorm.prom"
    assert watched(FAST, "--text-file", str(path))[0] == 0
    lines = path.read_text().splitlines()
    assert "discostorm_packets_total 1063" in lines
    assert "discostorm_hosts 3" in lines
    assert "discostorm_complete 1" in lines
    assert 'discostorm_messages_total{kind="SEDP"} 244' in lines
    assert [one.name for one in tmp_path.iterdir()] == ["discostorm.prom"]


def test_metrics_are_served() -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with subprocess.Popen(
        [sys.executable, "-m", "discostorm", "watch", "-", "--prometheus", str(port)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env=os.environ | {"PYTHONPATH": str(Path(__file__).parents[1])},
    ) as running:
        assert running.stdin is not None
        running.stdin.write(FAST)
        running.stdin.flush()
        text = ""
        for _ in range(200):
            time.sleep(0.1)
            try:
                with urllib.request.urlopen(
                    f"http://127.0.0.1:{port}/metrics", timeout=5
                ) as answer:
                    text = answer.read().decode()
            except OSError:
                continue
            if "discostorm_hosts 3" in text:
                break
        running.stdin.close()
        assert "discostorm_hosts 3" in text
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


@pytest.mark.skipif(not shutil.which("tcpdump"), reason="needs tcpdump")
def test_an_interface_that_is_none_is_told() -> None:
    result = CliRunner().invoke(main, ["watch", "-i", "none0", "--seconds", "1"])
    assert result.exit_code == 2
    assert "cannot capture on none0" in result.output.replace("'", "")


def test_without_a_program_that_captures_it_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    result = CliRunner().invoke(main, ["watch", "-i", "lo"])
    assert result.exit_code == 2
    assert "neither tcpdump nor dumpcap is installed" in result.output
