"""Capture effect: of overlapping frames, one may arrive if stations differ in received power."""

from typing import Any

import numpy as np
import pandas as pd
import pytest
from support import transmission_table

import discostorm as ds
from discostorm_simulation import disc, powers

SWARM = ds.Fleet.swarm(5, 2, 10)


def channel(mpdus: int = 1) -> ds.Wifi:
    return ds.Radio("802.11n", streams=2, aifsn=3, mpdus=mpdus).wifi()


def burst(fleet: ds.Fleet = SWARM, mpdus: int = 1, **options: Any) -> ds.Simulation:
    given: dict[str, Any] = {"queue": None, "recovery": False, "runs": 3} | options
    return ds.simulate(fleet, ds.DDS, channel(mpdus), block_ack="established", **given)


def first_of(found: ds.Simulation) -> pd.DataFrame:
    """Return the transmissions of the first instant, when all hosts send at once."""
    table = transmission_table(found)
    return table[table["start_s"] == table["start_s"].min()]


def near_and_far(decibels: float) -> Any:
    """Return the received powers of two hosts; the first is stronger at the access point."""
    heard = np.zeros((3, 3))
    heard[0, 2] = decibels
    return heard


@pytest.mark.parametrize("mpdus", [1, 64])
def test_stations_heard_alike_lose_all_that_overlaps_as_before(mpdus: int) -> None:
    alike, before = burst(mpdus=mpdus, power=np.full((6, 6), -50.0)), burst(mpdus=mpdus)
    np.testing.assert_array_equal(alike.drain_time, before.drain_time)
    for name, count in before.counts.items():
        np.testing.assert_array_equal(alike.counts[name], count)
    pd.testing.assert_frame_equal(transmission_table(alike), transmission_table(before))


@pytest.mark.parametrize(("decibels", "arrives"), [(21.9, False), (22.1, True)])
def test_the_stronger_frame_arrives_beyond_the_threshold(decibels: float, arrives: bool) -> None:
    first = first_of(burst(ds.Fleet.swarm(2, 1, 2), power=near_and_far(decibels)))
    outcome = first.set_index("station")["outcome"]
    assert outcome["host 1"] == ("success" if arrives else "collision")
    assert outcome["host 2"] == "collision"


def test_a_threshold_of_ones_own_is_taken() -> None:
    power = near_and_far(10.0)
    for threshold, arrives in (((9.0, 0.0), True), ((11.0, 0.0), False), ((9.0, 11.0), False)):
        first = first_of(burst(ds.Fleet.swarm(2, 1, 2), power=power, threshold=threshold))
        assert ("success" in first["outcome"].tolist()) == arrives


def test_the_sum_of_all_others_counts() -> None:
    heard = np.zeros((4, 4))
    heard[0, 3] = 24.0  # 21 dB above the sum of two others
    assert set(first_of(burst(ds.Fleet.swarm(3, 1, 2), power=heard))["outcome"]) == {"collision"}
    heard[0, 3] = 25.1
    assert "success" in set(first_of(burst(ds.Fleet.swarm(3, 1, 2), power=heard))["outcome"])


def test_of_an_aggregate_that_is_heard_what_follows_the_others_arrives() -> None:
    # The first host sends more, so its A-MPDU is longer than the second's.
    fleet = ds.Fleet((ds.HostGroup(1, 1, 60), ds.HostGroup(1, 1, 1)))
    first = first_of(burst(fleet, 64, power=near_and_far(10.0))).set_index("station")
    assert first.loc["host 1", "outcome"] == "success"
    assert first.loc["host 1", "end_s"] > first.loc["host 2", "end_s"]
    # With exchanged roles, the whole A-MPDU overlaps.
    shorter = near_and_far(0.0)
    shorter[1, 2] = 10.0
    first = first_of(burst(fleet, 64, power=shorter)).set_index("station")
    assert set(first["outcome"]) == {"collision"}
    found = burst(fleet, 64, power=near_and_far(10.0))
    assert (found.counts["arrived"] + found.counts["on_air"] == found.counts["expected"]).all()


@pytest.mark.parametrize("mpdus", [1, 64])
@pytest.mark.parametrize("recovery", [False, True])
def test_nothing_is_lost_twice_or_without_a_cause(mpdus: int, recovery: bool) -> None:
    found = burst(mpdus=mpdus, power=powers(disc(5)), recovery=recovery, loss=0.1, runs=10)
    lost = sum(found.counts[cause] for cause in ("host_retry", "ap_retry", "on_air"))
    total = found.counts["arrived"] + lost + found.counts["waiting"]
    np.testing.assert_array_equal(found.counts["expected"], total)
    assert (found.counts["waiting"] == 0).all() or recovery
    assert (found.busy_time <= found.drain_time).all() or recovery
    assert np.isfinite(found.convergence_time).all() or not recovery


def test_multicast_is_received_by_whom_the_access_point_is_near() -> None:
    lost = {}
    for name, power in (("alike", None), ("disc", powers(disc(5)))):
        lost[name] = burst(power=power, runs=40).counts["on_air"].mean()
    assert 0.1 * lost["alike"] < lost["disc"] < 0.7 * lost["alike"]


def test_a_disc_is_covered_evenly() -> None:
    places = disc(400)
    radius = np.hypot(*places.T)
    assert (np.diff(radius) > 0).all()
    assert ((radius < 0.5).mean(), radius.max()) == pytest.approx((0.25, 1.0), abs=0.01)
    assert abs(places.mean(axis=0)).max() < 0.01


def test_power_fades_with_the_distance() -> None:
    heard = powers([(3, 0), (0, 4)], exponent=2)
    assert heard[0, 1] == heard[1, 0] == pytest.approx(-20 * np.log10(5))
    assert heard[1, 2] == pytest.approx(-20 * np.log10(4))
    assert (np.diag(heard) == 0).all()


@pytest.mark.parametrize(
    ("options", "kind", "told"),
    [
        ({"power": np.zeros((5, 5))}, ValueError, r"power must be of shape \(6, 6\).*got \(5, 5\)"),
        ({"power": "near"}, TypeError, "power must"),
        ({"power": np.full((6, 6), np.nan)}, ValueError, "power must"),
        ({"threshold": 10.0}, TypeError, "threshold must be a tuple of two numbers"),
        ({"threshold": (-1.0, 1.0)}, ValueError, r"threshold\[0\] must .* got -1"),
    ],
)
def test_bad_power_is_refused_by_name(
    options: dict[str, Any], kind: type[Exception], told: str
) -> None:
    with pytest.raises(kind, match=told):
        burst(**options)


def test_bad_places_are_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"places must be of shape \(hosts, 2\); got \(2,\)"):
        powers([1.0, 2.0])
    with pytest.raises(ValueError, match="places must be distinct and not the access point"):
        powers([(1, 0), (1, 0)])
    with pytest.raises(ValueError, match="places must be distinct and not the access point"):
        powers([(0, 0)])
    with pytest.raises(ValueError, match="exponent must"):
        powers([(1, 0)], exponent=-1)
    with pytest.raises(ValueError, match="hosts must"):
        disc(0)
