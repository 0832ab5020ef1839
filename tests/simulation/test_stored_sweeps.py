"""The stored sweeps: a part of them comes out the same again, and their tables add up."""

import csv
import importlib
import io
from dataclasses import asdict

import numpy as np
import pytest

import discostorm as ds
from discostorm.data import read_data
from discostorm.model import burst
from discostorm_planner import staggered_start
from discostorm_simulation import starts
from discostorm_simulation.result import CAUSES

ladder_of_fleet_sizes = importlib.import_module("ladder_of_fleet_sizes")
single_simulations = importlib.import_module("single_simulations")
sweep_setting = importlib.import_module("sweep_setting")
sweep_definitions = importlib.import_module("sweep_definitions")


def stored_rows(name: str) -> list[dict[str, str]]:
    with sweep_setting.table_path(name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


#: What tells a setting of ns-3's table, besides whether it aggregates.
BESIDE = ("protocol", "hosts", "queue_frames", "loss")


def text(row: dict[str, object]) -> dict[str, str]:
    """Return a row as text, as in a file."""
    file = io.StringIO()
    writer = csv.DictWriter(file, list(row))
    writer.writeheader()
    writer.writerow(row)
    file.seek(0)
    return next(csv.DictReader(file))


@pytest.mark.parametrize("name", list(sweep_definitions.SWEEPS))
def test_every_setting_has_its_row_in_order(name: str) -> None:
    rows = stored_rows(name)
    settings = sweep_definitions.table_settings(name)
    assert len(rows) == len(settings)
    for row, setting in zip(rows, settings, strict=True):
        assert text(asdict(setting)).items() <= row.items()


@pytest.mark.parametrize("name", list(sweep_definitions.SWEEPS))
def test_a_part_comes_out_the_same_again(name: str) -> None:
    rows = stored_rows(name)
    settings = sweep_definitions.table_settings(name)
    # The small ones, of every protocol and kind of start.
    again = {(one.protocol, one.start, one.mpdus): n for n, one in enumerate(settings)}
    small = [n for n, one in enumerate(settings) if one.hosts <= 5]
    chosen = {*small[:: max(1, len(small) // 4)], *again.values()} & set(small)
    assert len(chosen) >= 3
    for number in chosen:
        found = text(asdict(settings[number]) | settings[number].run() | sweep_setting.SOURCE)
        # Settings of few runs have no interval.
        assert dict.fromkeys(rows[number], "") | found == rows[number]


def test_one_burst_and_its_hosts_come_out_the_same_again() -> None:
    for name, rows in (
        ("events", single_simulations.burst_transmissions()),
        ("hosts", single_simulations.losses_by_host()),
        ("waiting", single_simulations.queue_lengths()),
    ):
        assert [text(row | sweep_setting.SOURCE) for row in rows] == stored_rows(name)


def test_bursts_at_unlike_distances_come_out_the_same_again() -> None:
    stored = read_data("simulated/heard.csv", "discostorm_book")
    again = [text(row | sweep_setting.SOURCE) for row in single_simulations.capture_effect((3,))]
    assert again == [row for row in stored if row["hosts"] == "3"]
    assert {row["heard"] for row in stored} == single_simulations.CAPTURE_THRESHOLDS.keys()


def test_less_is_lost_the_less_a_frame_must_exceed() -> None:
    rows = read_data("simulated/heard.csv", "discostorm_book")
    for hosts, mpdus in ((7, 1), (10, 1), (7, 64), (10, 64)):
        lost = {
            row["heard"]: float(row["lost"])
            for row in rows
            if (row["protocol"], row["hosts"], row["mpdus"]) == ("DDS", f"{hosts}", f"{mpdus}")
            and row["queue_frames"] == "500"
        }
        # Medians of 100 runs, with aggregation of a few points' standard error.
        assert lost["strongest"] < lost["alike"]
        assert lost["standard"] < lost["alike"] + (0.03 if mpdus > 1 else 0.01)


def test_saturation_comes_out_the_same_again() -> None:
    stored = read_data("simulated/saturation.csv", "discostorm_book")
    assert [int(row["stations"]) for row in stored[::2]] == list(single_simulations.STATIONS)
    again = [
        text(row | sweep_setting.SOURCE) for row in single_simulations.saturated_throughput((2,))
    ]
    assert again == [row for row in stored if row["stations"] == "2"]


def test_the_ladder_is_that_of_its_sweep() -> None:
    rows = [
        asdict(setting) | row
        for setting, row in zip(
            sweep_definitions.table_settings("fits"),
            read_data("simulated/fits.csv", "discostorm_book"),
            strict=True,
        )
    ]
    typed = [row | {name: int(row[name]) for name in ("mpdus", "recovery")} for row in rows]
    assert [text(row) for row in ladder_of_fleet_sizes.ladder_rows(typed)] == read_data(
        "simulated/ladder.csv", "discostorm_book"
    )
    for row in read_data("simulated/ladder.csv", "discostorm_book"):
        assert float(row["value_s"]) <= float(row["limit_s"]) < float(row["one_more_s"])


def test_a_number_of_the_ladder_is_sure_or_has_a_range() -> None:
    for row in read_data("simulated/ladder.csv", "discostorm_book"):
        ends = float(row["value_high_s"]), float(row["one_more_low_s"])
        sure = ends[0] <= float(row["limit_s"]) < ends[1]
        assert (row["hosts_low"] == row["hosts_high"]) == sure, row
        assert int(row["hosts_low"]) <= int(row["hosts"]) <= int(row["hosts_high"])
        assert min(int(row["runs"]), int(row["one_more_runs"])) >= sweep_setting.MANY_RUNS
        # What is not sure has had all the runs that there are.
        assert sure or max(int(row["runs"]), int(row["one_more_runs"])) >= sweep_setting.MAX_RUNS


def test_an_interval_holds_the_median_as_often_as_it_says() -> None:
    rng = np.random.default_rng(0)
    held = 0
    for _ in range(2000):
        ends = sweep_setting.median_interval("x", rng.exponential(size=100))
        held += float(ends["x_low"]) <= np.log(2) <= float(ends["x_high"])
    # At least 97.5 % of the times; the standard error of 2000 tries is 0.35 %.
    assert held / 2000 > 0.975 - 0.01
    assert sweep_setting.median_interval("x", np.arange(1e4))  # in whole numbers


def test_losses_are_those_of_ns3_in_the_mean_of_all_settings() -> None:
    """Single settings are too much a matter of chance; the means of many are not."""
    theirs = {
        (*(row[name] for name in BESIDE), row["ampdu"] != "0"): row
        for row in read_data("measured/ns3_bursts.csv", "discostorm_book")
        if row["scenario"] in ("queue", "short_queue", "errors")
    }
    apart: dict[tuple[bool, str], list[float]] = {}
    for row in read_data("simulated/beside_ns3.csv", "discostorm_book"):
        joined = row["mpdus"] != "1"
        other = theirs[(*(row[name] for name in BESIDE), joined)]
        lost = sum(float(row[cause]) for cause in CAUSES)
        points = 100 * (lost - 1 + int(other["arrived"]) / int(other["expected"]))
        apart.setdefault((joined, row["loss"]), []).append(points)
    means = {key: np.mean(points) for key, points in apart.items()}
    for loss in ("0.0", "0.05", "0.2"):
        assert abs(means[False, loss]) < 0.5
    # Of single runs with aggregation the standard deviation is 10 points, of 24 means of 40 runs
    # 0.4; with frame errors it is 0.8 of 4 means of 20 and 100 runs, beside 100 of ours.
    assert abs(means[True, "0.0"]) < 1.2
    assert abs(means[True, "0.05"]) < 2.4
    assert abs(means[True, "0.2"]) < 2.4


@pytest.mark.parametrize("name", ["drain", "queues"])
def test_causes_of_losses_are_parts_of_what_was_sent(name: str) -> None:
    for row in stored_rows(name):
        parts = [float(row[cause]) for cause in CAUSES]
        assert min(parts) >= 0
        low, high = float(row["lost_q25"]), float(row["lost_q75"])
        assert sum(parts) == pytest.approx(float(row["lost"]), abs=max(0.05, high - low))


def test_a_window_is_the_airtime_of_the_burst() -> None:
    for protocol in (ds.DDS, ds.ZENOH):
        window = staggered_start.start_window(protocol, 12, 2, 10)
        assert window == pytest.approx(ds.utilization(protocol, 12, 2, 10))
        drawn = starts.uniform_start(window)(np.random.default_rng(0), 1000)
        assert 0 <= drawn.min() < 0.05 * window
        assert 0.95 * window < drawn.max() <= window


def test_the_burst_of_unlike_hosts_is_what_utilization_has_beyond_the_steady_state() -> None:
    groups = (ds.HostGroup(3, 2, 40), ds.HostGroup(1, 1, 90), ds.HostGroup(2, 5, 0))
    for table in ds.PROTOCOLS.values():
        for matching in (0.0, 0.3):
            fleet = ds.Fleet(groups, matching)
            first, later = (ds.utilization(table, fleet, window=w) for w in (1.0, np.inf))
            # The difference of two sums of some ten terms.
            assert burst(table, fleet) == pytest.approx(first - later, rel=1e-9)
            # All of the start, beside what is repeated, fits into it: W = B + rho W.
            if later < 1:
                within = staggered_start.start_window(table, fleet)
                assert within == pytest.approx(first - later + later * within, rel=1e-9)
            else:
                assert staggered_start.start_window(table, fleet) == np.inf
    grown = burst(ds.DDS, ds.Fleet((ds.HostGroup([1, 2], 2, 10), groups[1])))
    assert np.shape(grown) == (2,)
    with pytest.raises(TypeError, match="processes must be left out when hosts is a Fleet"):
        staggered_start.start_window(ds.DDS, ds.Fleet(groups), 2, 10)


def test_in_turn_everybody_waits_for_those_before() -> None:
    starts = staggered_start.start_times_in_turn(ds.DDS, 6, 2, 10)
    assert starts[0] == 0
    for before in range(1, 6):
        assert starts[before] == pytest.approx(ds.utilization(ds.DDS, before, 2, 10))


def test_bad_input_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"within must be .* got -1"):
        starts.uniform_start(-1)
    with pytest.raises(ValueError, match=r"hosts must be a whole number.*2.5"):
        staggered_start.start_times_in_turn(ds.DDS, 2.5, 2, 10)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="hosts must"):
        staggered_start.start_window(ds.DDS, 0, 2, 10)
    with pytest.raises(TypeError, match=r"hosts must be one number, not an array; got \[2, 3\]"):
        staggered_start.start_window(ds.DDS, [2, 3], 2, 10)  # type: ignore[arg-type]
    grown = ds.Fleet((ds.HostGroup(2, [1, 2], 10),))
    with pytest.raises(TypeError, match=r"groups\[0\].processes must be one number, not an array"):
        staggered_start.start_window(ds.DDS, grown)
    with pytest.raises(TypeError, match="endpoints must be one number, not an array"):
        staggered_start.start_times_in_turn(ds.DDS, 2, 2, [5, 10])  # type: ignore[arg-type]


def test_what_hosts_lose_adds_up() -> None:
    fleet = ds.Fleet((ds.HostGroup(4, 2, 10), ds.HostGroup(2, 1, 60)))
    found = ds.simulate(fleet, ds.DDS, ds.PAPER, loss=0.1, recovery=False, runs=3)
    groups = np.repeat([0, 1], [4, 2])
    sent = np.zeros(6)
    for host, group in enumerate(groups):
        alone = fleet.groups[group]
        remote = float(sum(g.hosts * g.processes for g in fleet.groups) - alone.processes)
        own = float(alone.processes)
        for message in ds.DDS.messages:
            each = message.per_unit * (
                float(alone.endpoints) if "endpoint" in message.unit.name else 1
            )
            receivers = 5 if message.cast == "multicast" else remote
            sent[host] += own * each * receivers
    np.testing.assert_allclose(sent.sum(), found.counts["expected"])
    np.testing.assert_allclose((found.lost_by_host * sent).sum(axis=1) / sent.sum(), found.lost)
