"""Block acknowledgement agreements: the first frames of a robot after power-on."""

from typing import Any, Literal

import numpy as np
import pytest
from support import transmission_table

import discostorm as ds


def channel(mpdus: int = 64) -> ds.Wifi:
    return ds.Radio("802.11n", streams=2, aifsn=3, mpdus=mpdus).wifi()


def burst(
    block_ack: Literal["negotiate", "established"], mpdus: int = 64, **options: Any
) -> ds.Simulation:
    given: dict[str, Any] = {"queue": None, "recovery": False, "runs": 5} | options
    swarm = ds.Fleet.swarm(4, 2, 10)
    return ds.simulate(swarm, ds.ZENOH, channel(mpdus), block_ack=block_ack, **given)


def test_request_and_response_come_before_the_first_aggregate() -> None:
    # The second host starts after the first has finished, so nothing collides.
    found = ds.simulate(
        ds.Fleet.swarm(2, 1, 10),
        ds.ZENOH,
        channel(),
        queue=None,
        start=np.array([0.0, 1.0]),
        recovery=False,
        block_ack="negotiate",
    )
    table = transmission_table(found)
    first = table[table["start_s"] < 1.0]
    together = first["frames"] > 1
    asked = first["message"] == "block ACK agreement"
    up = first["station"] == "host 1"
    # Uplink: host, then access point; downlink: access point, then the other host.
    assert first["station"][asked].tolist()[:2] == ["host 1", "access point"]
    assert sorted(first["station"][asked].tolist()[2:]) == ["access point", "host 2"]
    assert first.index[asked][1] < first.index[together & up][0]
    assert first.index[asked][3] < first.index[together & ~up][0]
    # 37 bytes at 6 Mbit/s, SIFS, and an acknowledgement of 14 bytes.
    length = first["end_s"][asked] - first["start_s"][asked]
    np.testing.assert_allclose(length, 76e-6 + 16e-6 + 44e-6, atol=1e-9)
    assert (asked.sum(), (table["message"] == "block ACK agreement").sum()) == (4, 8)


def test_each_agreement_is_made_once_and_nothing_is_lost() -> None:
    found = burst("negotiate", loss=0.1)
    assert (found.counts["arrived"] + found.counts["on_air"] == found.counts["expected"]).all()
    warm = burst("established", loss=0.1)
    # Two frames for each of four hosts, on uplink and downlink.
    assert (found.counts["requests"] >= warm.counts["requests"].min() + 16).all()
    assert np.median(found.drain_time) > np.median(warm.drain_time)


def test_without_aggregation_there_is_nothing_to_agree_on() -> None:
    cold, warm = burst("negotiate", 1), burst("established", 1)
    np.testing.assert_array_equal(cold.drain_time, warm.drain_time)
    for name, count in cold.counts.items():
        np.testing.assert_array_equal(count, warm.counts[name])


def test_an_unknown_start_is_refused() -> None:
    with pytest.raises(ValueError, match="block_ack must be 'negotiate' or"):
        burst("warm")  # type: ignore[arg-type]
