"""Test input of all packages that is too large, too long, missing or odd."""

import struct
import time
from pathlib import Path

import numpy as np
import pytest
from click.shell_completion import ShellComplete
from click.testing import CliRunner, Result
from handmade_captures import block

import discostorm as ds
from discostorm.cli import main
from discostorm.data import data_path
from discostorm_book import show

FLEET = str(data_path("fleets/nav2_laptop.toml"))


def run(*words: str, columns: int = 80) -> Result:
    return CliRunner(env={"COLUMNS": str(columns)}).invoke(main, list(words))


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_too_little_memory_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_memory(*_: object, **_given: object) -> None:
        np.zeros(2**58)

    for name, words in (
        ("discostorm.simulate", ("simulate", FLEET)),
        ("discostorm.plan", ("plan", FLEET)),
        ("discostorm.read_capture", ("capture", FLEET)),
    ):
        monkeypatch.setattr(name, no_memory)
        result = run(*words)
        assert result.exit_code == 2
        assert result.output.startswith("Error: not enough memory")


def test_a_path_with_a_nul_is_told() -> None:
    for call in (ds.Fleet.from_toml, ds.read_capture):
        with pytest.raises(ValueError, match=r"^path must name .*, without a NUL; got 'a\\x00b'"):
            call("a\0b")
    for words in (
        ("figures", "--out", "a\0b"),
        ("capture", "a\0b"),
        ("plan", "a\0b"),
        (
            "capture",
            str(data_path("captures/fast_dds.pcap.xz", "discostorm_capture")),
            "--picture",
            "a\0b.svg",
        ),
    ):
        result = run(*words)
        assert result.exit_code == 2
        assert "without a NUL; got 'a\\x00b" in result.output


def test_advice_in_markdown_has_no_html_of_its_own() -> None:
    groups = (
        ds.HostGroup(3, 2, 10, name="<img src=x onerror=alert(1)> & co"),
        ds.HostGroup(1, 1, 10, name="<b>bold"),
    )
    shown = show.Advice(ds.plan(ds.Fleet(groups)))
    for text in (shown._repr_markdown_(), shown._repr_html_()):
        assert "&lt;img src=x onerror=alert(1)&gt; &amp; co" in text
        assert "<img" not in text
        assert "<b>" not in text
    assert "*Effort:*" in shown._repr_markdown_()


def test_a_plan_fits_the_terminal() -> None:
    texts = {
        columns: run("plan", FLEET, "--why", columns=columns).stdout
        for columns in (40, 60, 80, 200)
    }
    for columns, text in texts.items():
        assert max(map(len, text.splitlines())) <= min(columns, 79)
    # The table of configurations, which needs more room, comes as a list.
    wide, narrow = (texts[columns].partition("The same fleet") for columns in (80, 40))
    assert wide[0].split() == narrow[0].split()
    assert "- Zenoh router: drain time 8.31 s," in " ".join(narrow[2].split())


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        *((f"{command} ", "file") for command in ("utilization", "breakdown", "saturation")),
        *((f"{command} ", "file") for command in ("plan", "simulate", "capture")),
        ("plan --fleet ", "file"),
        ("capture --fleet ", "file"),
        ("capture --picture ", "file"),
        ("saturation --beside ", "file"),
        ("figures --out ", "dir"),
    ],
)
def test_the_shell_completes_names_of_files(words: str, kind: str) -> None:
    complete = ShellComplete(main, {}, "discostorm", "_DISCOSTORM_COMPLETE")
    (found,) = complete.get_completions(words.split(), "fle")
    assert (found.type, found.value) == (kind, "fle")


def test_many_sections_take_time_as_their_number(folder: Path) -> None:
    section = block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1))
    packet = block(6, struct.pack("<IIIII", 0, 0, 1, 0, 0))

    def seconds(many: int) -> float:
        parts = []
        for number in range(many):
            # Each has a clock of its own: seconds to be added.
            clock = struct.pack("<HHI", 1, 0, 0) + struct.pack("<HHqHH", 14, 8, number, 0, 0)
            parts.append(section + block(1, clock) + packet)
        path = folder / "sections.pcapng"
        path.write_bytes(b"".join(parts))
        began = time.process_time()
        found = ds.read_capture(path)
        taken = time.process_time() - began
        assert found.packets == many
        assert found.duration == pytest.approx(many - 1)
        return taken

    seconds(10)  # what is imported first
    few, many = seconds(2_000), seconds(40_000)
    # Twenty times the sections; with a look at all packets for each it is 400 times the work.
    assert many < 60 * few + 0.5
