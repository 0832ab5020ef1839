"""Compare the kernels of recovery with the standards, rule by rule: TCP and leases."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import discostorm as ds
from discostorm_simulation import state as st
from discostorm_simulation.kernels import acknacks, middleware_events, repair
from discostorm_simulation.run import Scenario, set_up


def timers(trips, least, most):
    """Return the retransmission timeout after each round trip, as RFC 6298, 2.2 to 2.4, says."""
    smoothed = variation = None
    for trip in trips:
        if smoothed is None:
            smoothed, variation = trip, trip / 2
        else:
            variation = 3 / 4 * variation + 1 / 4 * abs(smoothed - trip)
            smoothed = 7 / 8 * smoothed + 1 / 8 * trip
        yield min(max(smoothed + 4 * variation, least), most)


@pytest.mark.parametrize(
    ("least", "most"), [(1, 10**9), (90_000, 10**9), (1, 70_000)], ids=["", "least", "most"]
)
def test_timer_of_tcp_is_that_of_rfc_6298(least, most):
    trips = np.random.default_rng(0).integers(10_000, 50_000, 40).tolist()
    cell = SimpleNamespace(repairs=[SimpleNamespace(rto_min=least, rto_max=most)])
    pair = SimpleNamespace(srtt=0, rttvar=0, rto=0)
    for trip, expected in zip(trips, timers(trips, least, most), strict=True):
        repair.update_rto.py_func(cell, pair, trip)
        # Whole ticks: what is cut off adds up to less than 8 of each sum, 4 times for the spread.
        assert pair.rto == pytest.approx(expected, abs=24)


def test_a_repeat_that_arrives_lets_two_more_go_as_in_slow_start(monkeypatch):
    arrived, sent = {0, 1, 2, 4}, []
    monkeypatch.setattr(repair, "announcement_count", lambda *_: 9)
    monkeypatch.setattr(repair, "has_received", lambda *given: given[-1] in arrived)
    monkeypatch.setattr(repair, "resend_announcement", lambda *given: sent.append(given[3]))
    pairs = np.zeros((2, 2), [("missing", int), ("expires_at", int), ("rto", int)])
    pairs["rto"], pairs["missing"] = 30, 5
    cell = SimpleNamespace(pairs=pairs.view(np.recarray))
    repair.on_tcp_ack.py_func(cell, 0, 1, 2, st.REPAIR, 100)
    assert sent == [3, 5]
    assert pairs["expires_at"][0, 1] == 130  # and the timer starts anew


@pytest.mark.parametrize(("protocol", "both"), [(ds.DDS, False), (ds.ZENOH, True)])
def test_a_lease_that_ends_ends_a_connection_for_both_but_not_a_match(protocol, both, monkeypatch):
    wifi = ds.Radio("802.11n", streams=2).wifi()
    plan = set_up(Scenario(ds.Fleet.swarm(3, 1, 1), protocol, wifi, queue=(np.inf, np.inf)))
    cell, _ = plan.cell(np.random.SeedSequence(0))
    lease = cell.repairs["lease"] = 1000
    cell.pairs["discovered"] = 1 - np.eye(3, dtype=int)
    cell.pairs["last_heard"] = lease  # all were heard of a while ago but for what 0 hears of 1
    cell.pairs["last_heard"][0, 1] = 5
    forgotten, looks = [], []
    monkeypatch.setattr(repair, "is_relayed", lambda *_: False)
    monkeypatch.setattr(
        middleware_events, "forget_process", lambda *given: forgotten.append(given[1:3])
    )
    monkeypatch.setattr(
        middleware_events.primitives, "schedule_event", lambda *given: looks.append(given[1])
    )
    rows = {name: getattr(cell, name).view(np.recarray) for name in ("repairs", "pairs")}
    middleware_events.expire_leases.py_func(cell._replace(**rows), 0, lease + 5)
    assert forgotten == [(0, 1), (1, 0)][: 1 + both]
    assert looks == [2 * lease]


def test_requests_within_the_delay_get_one_answer(monkeypatch):
    """As a timer of the writer that a request starts, and no second one (StatefulWriter.cpp)."""
    sent, due = [], []
    fields = ("due", "announced_at", "asked_in", "served")
    pairs = np.zeros((3, 3), [(name, int) for name in fields]).view(np.recarray)
    pairs["announced_at"], pairs["served"] = 1, -1
    repairs = {"nack_response_delay": 100, "riding": False, "data_octets": 0}
    cell = SimpleNamespace(
        pairs=pairs, processes=[SimpleNamespace(sent=0)], repairs=[SimpleNamespace(**repairs)]
    )
    monkeypatch.setattr(repair, "first_of_topic", lambda *given: given[-1])
    monkeypatch.setattr(
        acknacks, "is_requested", lambda *given: (pairs[given[1], given[2]].due >> given[3]) & 1
    )
    monkeypatch.setattr(acknacks, "is_in_topic", lambda *given: given[-2] == given[-1])
    monkeypatch.setattr(repair, "send_piggybacked_heartbeats", lambda *_: None)
    monkeypatch.setattr(repair, "resend_announcement", lambda *given: sent.append(given[1:]))
    schedule = "schedule_pair_event"
    monkeypatch.setattr(acknacks.primitives, schedule, lambda *given: due.append(given[1:]))
    for reader, topic, time in ((1, 0, 5), (1, 0, 7), (2, 0, 60), (2, 1, 80)):
        acknacks.accept_request.py_func(cell, 0, reader, topic, time)
    assert sent == []
    assert due == [(105, st.ANSWER_DUE, 0, 0, 0), (180, st.ANSWER_DUE, 0, 0, 1)]
    for topic, time in ((0, 105), (1, 180), (0, 300)):
        acknacks.answer_requests.py_func(cell, 0, topic, 0, 3, time)
    again = st.REPAIR
    assert sent == [(0, 1, 0, 105, again), (0, 2, 0, 105, again), (0, 2, 1, 180, again)]
    monkeypatch.setattr(acknacks, "answer_requests", lambda *given: due.append(given[2:]))
    cell.repairs[0].nack_response_delay = 0
    acknacks.accept_request.py_func(cell, 0, 1, 0, 400)
    assert due[2:] == [(0, 1, 2, 400)]


@pytest.mark.parametrize("delay", [0.02, 0.1, 0.3])
def test_first_data_wait_for_the_delay(delay):
    fleet, wifi = ds.Fleet.swarm(2, 1, 2), ds.Radio("802.11n", streams=2).wifi()
    table = ds.PROTOCOLS["Fast DDS 3.6"]
    at_once, late = (
        ds.simulate(
            fleet, replace(table, timers=replace(table.timers, nack_response_delay=wait)), wifi
        )
        for wait in (0.0, delay)
    )
    (gain,) = late.convergence_time - at_once.convergence_time
    assert gain == pytest.approx(delay, abs=0.01)
