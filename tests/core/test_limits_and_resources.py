"""Test input that is too large, too long, missing or odd: a message comes soon."""

import time
import warnings
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

import discostorm as ds
from discostorm import drain_times
from discostorm.cli import main
from discostorm.data import data_path

FLEET = str(data_path("fleets/nav2_laptop.toml"))
LONG = "x" * 100_000


def run(*words: str, columns: int = 80) -> Result:
    return CliRunner(env={"COLUMNS": str(columns)}).invoke(main, list(words))


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_messages_shorten_long_names(folder: Path) -> None:
    group = "[[groups]]\nprocesses = 1\nendpoints = 5\n"
    files = {
        "group.toml": f"{group}hosts = 0\nname = '{LONG}'\n",
        "shared.toml": f"{group}hosts = 2\nshared = 6\nname = '{LONG}'\n",
        "twice.toml": 2 * f"{group}hosts = 2\nname = '{LONG}'\n",
        "key.toml": f"{group}hosts = 2\n{LONG} = 1\n",
    }
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    for words in (
        *([name] for name in files),
        *([LONG], [FLEET, "--fleet", LONG], [FLEET, "--wifi", LONG]),
        *([FLEET, "--wifi", f"802.11n 20 MHz 2x2, {LONG}"], [FLEET, "--protocol", LONG]),
        [FLEET, "--hosts", LONG],
    ):
        result = run("utilization", *words)
        assert result.exit_code == 2
        assert "xxx..." in result.output
        assert len(result.output) < 2500
    with pytest.raises(ValueError, match=r"^group 'x{100}\.\.\.x{20}': hosts must be"):
        ds.HostGroup(0, 1, 1, name=LONG)
    name = "robots with arms, in the hall on the left " * 4
    with pytest.raises(ValueError, match=f"^group '{name}': hosts must be"):
        ds.HostGroup(0, 1, 1, name=name)


def test_the_first_silence_of_a_large_fleet_is_found_at_once() -> None:
    table = ds.PROTOCOLS["DDS, periods of Fast DDS"]
    began = time.process_time()
    found = drain_times.first_idle(table, 2, 1, 1e9)
    assert time.process_time() - began < 1
    bound = drain_times.drain_time(table, 2, 1, 1e9)
    assert bound * (1 - 1e-6) < found <= bound * (1 + 1e-9)


def test_a_channel_that_is_all_but_full_is_refused() -> None:
    table = ds.PROTOCOLS["DDS, periods of Fast DDS"]
    low, high = 1.0, 1e9
    for _ in range(200):  # to where what is repeated takes all of the channel but 1e-9
        middle = (low + high) / 2
        full = ds.utilization(table, middle, 2, 10, window=np.inf) >= 1 - 1e-9
        low, high = (low, middle) if full else (middle, high)
    with pytest.raises(
        ValueError, match=r"must be fewer for an exact .* 1e\+06 times are possible; got .*"
    ):
        drain_times.first_idle(table, low, 2, 10)


def test_no_burst_beside_a_full_channel_is_never_through_without_a_warning() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert drain_times.burst_drain_time(0, 1) == np.inf
        assert list(np.asarray(drain_times.burst_drain_time([0, 0, 1], [0.5, 1, 1]))) == [
            0,
            np.inf,
            np.inf,
        ]


def test_a_breakdown_counts_nothing_below_zero() -> None:
    table = ds.PROTOCOLS["Zenoh router per host"]
    with pytest.raises(
        ValueError, match=r"^hosts and processes must be whole numbers .* 1\.5 and 2"
    ):
        ds.breakdown(table, 1.5, 2, 10)
    assert (ds.breakdown(table, 2.5, 2, 10)["uplink_messages"] >= 0).all()
    for protocol in ds.PROTOCOLS.values():
        for hosts in (1, 2, 3):
            counts = ds.breakdown(protocol, hosts, 1, 10)["uplink_messages"]
            assert not np.signbit(counts).any()
