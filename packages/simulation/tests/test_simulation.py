"""The simulator, compared with the closed form, Markov chains, Bianchi and itself."""

import json
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import product
from math import comb
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from numpy.typing import NDArray
from support import transmission_table

import discostorm as ds
from discostorm.cli import main
from discostorm.data import data_path
from discostorm.lookup import with_timers_of
from discostorm.messages import PAIR, PROCESS, UNITS, Hop, Hosts
from discostorm.messages.legs import rows_to_every_port
from discostorm.robots import robots
from discostorm_simulation import starts
from discostorm_simulation._memory import available_megabytes
from discostorm_simulation.cell_setup import TICK, host_table, to_ticks
from discostorm_simulation.engine import LoadedCell, run_to_end
from discostorm_simulation.result import CAUSES, Simulation
from discostorm_simulation.run import Scenario, Setup, set_up, simulate_run
from discostorm_simulation.state import SUCCESS, CellState

FLEET = data_path("fleets/nav2_laptop.toml")
RADIO = ds.Radio("802.11n", streams=2, aifsn=3)
SPDP, SEDP = ds.DDS.messages[:2]
UNLIMITED = (np.inf, np.inf)


def plan(
    fleet: ds.Fleet,
    protocol: ds.Protocol,
    wifi: ds.Wifi,
    *,
    start: Any = 0.0,
    loss: Any = 0.0,
    recovery: bool = False,
    until: float = 1e5,
) -> Setup:
    """Return a set-up without queue limits whose radio a test may change."""
    given = {"start": start, "loss": loss, "recovery": recovery, "until": until}
    scenario = Scenario(fleet, protocol, wifi, queue=UNLIMITED, block_ack="established", **given)
    return set_up(scenario)


def cell_of(what: Setup, seed: int = 0) -> CellState:
    return what.cell(np.random.SeedSequence(seed))[0]


# ---------------------------------------------------------------- the closed form, exactly


def mean_drain_tick(what: Setup) -> int:
    """Return the end of the last frame [ticks] if every back-off has its mean, also the first."""
    waiting = int(what.radio["cw_min"][0]) * int(what.radio["slot"][0]) // 2
    what.radio["cw_min"] = what.radio["cw_max"] = 0
    what.radio["aifs"] += waiting
    cell = cell_of(what)
    cell.state["base"] = what.radio["aifs"]
    cell = run_to_end(cell, to_ticks(1e6), what.reserve)
    assert cell.state["collisions"] == 0
    return int(cell.state["drained"][0])


def numbers(message: ds.Message, hop: str, wifi: ds.Wifi) -> float:
    """Return the closed form's airtime of a message's frame on a hop [s]."""
    up, down = message.airtime_up(wifi.model), message.airtime_down(wifi.model)
    values = ds.Protocol("one", (message,)).values() | wifi.values()
    return float((up if hop == "up" else down).subs(values))


@pytest.mark.parametrize("band", [2.4e9, 5e9])
@pytest.mark.parametrize("standard", ["802.11a", "802.11g", "802.11n", "802.11ax"])
def test_access_point_alone_takes_the_time_of_the_closed_form(standard: str, band: float) -> None:
    if (standard, band) in (("802.11a", 2.4e9), ("802.11g", 5e9)):
        band = {"802.11a": 5e9, "802.11g": 2.4e9}[standard]
    wifi = ds.Radio(standard, band=band).wifi()
    rows = tuple(replace(message, hops=("down",), answers=None) for message in ds.DDS.messages)
    fleet = ds.Fleet.swarm(4, 2, 3)
    found = mean_drain_tick(plan(fleet, ds.Protocol("down", rows), wifi))
    closed = sum(message.load(fleet) * numbers(message, "down", wifi) for message in rows)
    assert found == round(closed / TICK)


@pytest.mark.parametrize("endpoints", [64, 640])
def test_a_full_aggregate_takes_the_time_of_the_closed_form(endpoints: int) -> None:
    wifi = replace(RADIO, mpdus=64).wifi()
    for hop in ("up", "down"):
        row = replace(SEDP, hops=(hop,), answers=None)
        fleet = ds.Fleet((ds.HostGroup(1, 1, endpoints), ds.HostGroup(1, 1, 0)))
        found = mean_drain_tick(plan(fleet, ds.Protocol("one way", (row,)), wifi))
        closed = row.load(fleet) * numbers(row, hop, wifi)
        assert found == round(closed / TICK)


def sent_down(
    fleet: ds.Fleet, rows: tuple[ds.Message, ...], loss: list[float], seed: int
) -> NDArray[np.void]:
    """Return the access point's transmissions with aggregation; one link loses frames."""
    wifi = replace(RADIO, mpdus=64).wifi()
    what = plan(fleet, ds.Protocol("in turn", rows), wifi, loss=loss)
    sent = run_to_end(cell_of(what, seed), to_ticks(100.0), what.reserve).log
    return sent[(sent["station"] == len(loss)) & (sent["frames"] > 0)]


def test_the_access_point_sends_next_to_whoever_has_waited_longest() -> None:
    """Queue A, B, A, B: after the first A has arrived, B's first frame is older than A's second."""
    fleet = ds.Fleet((ds.HostGroup(1, 2, 1), ds.HostGroup(2, 1, 0)))
    row = replace(SEDP, answers=None)
    seen = set()
    for seed in range(40):
        sent = sent_down(fleet, (row,), [0.0, 0.5, 0.0], seed)
        seen.add(tuple(sent["frames"][sent["outcome"] == SUCCESS].tolist()))
    # All frames; only A's first missing; only A's second missing, which B's frames precede.
    assert seen >= {(2, 2), (2, 1, 2), (2, 2, 1)}


def test_what_comes_after_a_missing_frame_waits_for_it() -> None:
    """So the first frame of a host is also the first that the access point forwards."""
    fleet = ds.Fleet((ds.HostGroup(1, 1, 1), ds.HostGroup(1, 1, 0)))
    first = replace(SEDP, answers=None)
    after = replace(SEDP, answers=None, name="after", per_unit=20)
    begun = []
    for seed in range(40):
        sent = sent_down(fleet, (first, after), [0.5, 0.0], seed)
        assert sent[0]["kind"] == 0
        begun.append(sent[0]["frames"])
    assert len(set(begun)) > 5, "errors differ from run to run"


# ---------------------------------------------------------------- conservation

UNLIKE = ds.Fleet(
    (ds.HostGroup(3, 2, 10), ds.HostGroup(2, 1, 40), ds.HostGroup(1, 3, 0)), matching=0.25
)
QUEUES = ((500, 0.5), (20, 0.05), None)
#: The one table whose recovery is not simulated, and all others.
ON_A_ROBOT = "Fast DDS Discovery Server, on a robot"
RECOVERING = [name for name in ds.PROTOCOLS if name != ON_A_ROBOT]
#: Those whose processes learn of each other through a wired server or router.
SERVED = [
    name for name in RECOVERING if any(m.hops == ("up",) for m in ds.PROTOCOLS[name].messages)
]


@pytest.mark.parametrize(
    ("name", "mpdus", "queue", "recovery"),
    [
        *((name, *rest) for name in ("DDS", "Zenoh") for rest in product((1, 64), QUEUES, (0, 1))),
        *(
            (name, *rest)
            for name in ds.PROTOCOLS
            for rest in ((1, None, 0), (64, (20, 0.05), int(name in RECOVERING)))
        ),
    ],
)
def test_each_frame_arrives_or_is_lost_for_a_reason(
    name: str, mpdus: int, queue: tuple[float, float] | None, recovery: int
) -> None:
    found = ds.simulate(
        UNLIKE,
        ds.PROTOCOLS[name],
        replace(RADIO, mpdus=mpdus).wifi(),
        queue=queue,
        loss=0.1,
        recovery=bool(recovery),
        runs=2,
        until=10,
    )
    counts = found.counts
    gone = sum(counts[cause] for cause in CAUSES)
    assert (counts["waiting"] >= 0).all()
    done = np.isfinite(found.drain_time)
    assert (counts["waiting"][done] == 0).all()
    assert recovery or done.all()
    assert (gone / counts["expected"] == found.lost).all()
    if not recovery and name in ("DDS", "Zenoh"):
        (several, *single) = ds.PROTOCOLS[name].messages
        hosts = 6
        expected = several.load(UNLIKE) * (hosts - 1) + sum(m.load(UNLIKE) for m in single)
        assert (counts["expected"] == expected).all()
    # Each attempt of a frame is counted, so the counts must fit together.
    assert (counts["mpdus"] >= counts["ppdus"]).all()
    assert (counts["collided"] >= 2 * counts["collisions"]).all()
    assert (found.airtime.sum(axis=(1, 2)) >= found.busy_time * 0.99).all()


# ---------------------------------------------------------------- tables of any kind


FLEETS = [
    ds.Fleet.swarm(2, 1, 0),
    ds.Fleet.swarm(4, 3, 7),
    UNLIKE,
    ds.Fleet((ds.HostGroup(1, 1, 5), ds.HostGroup(3, 4, 2)), matching=1),
    ds.Fleet((ds.HostGroup(2, 2, 10, shared=4), ds.HostGroup(2, 1, 3, shared=3)), matching=0.25),
    ds.Fleet((ds.HostGroup(2, 2, 9), ds.HostGroup(1, 3, 10, shared=2))),
    ds.Fleet((ds.HostGroup(2, (ds.Process(1, 2), ds.Process(2, 9))), UNLIKE.groups[0]), 0.5),
]


@pytest.mark.parametrize("unit", UNITS.values(), ids=list(UNITS))
def test_senders_and_receivers_of_a_unit_are_as_many_as_it_counts(unit: ds.Unit) -> None:
    for fleet in FLEETS:
        hosts, found = host_table(fleet), 0.0
        sent, received = unit.units_per_process(hosts), unit.receiver_mask(hosts)
        for sender, here in enumerate(hosts.host_of):
            if received is None:
                found += sent[sender]
                continue
            for receiver, there in enumerate(hosts.host_of):
                found += sent[sender] * received[receiver] * (here != there)
        assert found == pytest.approx(unit.count(fleet), rel=1e-12)


def test_each_process_announces_its_own_endpoints() -> None:
    """Unlike processes: as many endpoint announcements as counted, and each process has its own."""
    sizes = (ds.Process(1, 12), ds.Process(2, 3))
    fleet = ds.Fleet((ds.HostGroup(3, sizes, name="robots"), ds.HostGroup(1, 1, 5)))
    assert host_table(fleet).endpoints_per_process.tolist() == [12, 3, 3] * 3 + [5]
    what = plan(fleet, ds.DDS, RADIO.wifi())
    row = [message.name for message in ds.DDS.messages].index("SEDP")
    assert what.shares.each[:, row].tolist() == [12, 3, 3] * 3 + [5]
    found = ds.simulate(fleet, ds.DDS, RADIO.wifi(), runs=2, queue=None)
    mean = ds.Fleet((ds.HostGroup(3, 3, 6), ds.HostGroup(1, 1, 5)))
    assert np.isfinite(found.convergence_time).all()
    both = [ds.simulate(f, ds.DDS, RADIO.wifi(), runs=1, recovery=False) for f in (fleet, mean)]
    assert both[0].counts["expected"] == both[1].counts["expected"]
    with pytest.raises(ValueError, match=r"groups\[0\].endpoints must be a whole number"):
        ds.simulate(ds.Fleet((ds.HostGroup(3, 3, 5.5),)), ds.DDS, RADIO.wifi())


def frames_of_rows(what: Setup, seed: int) -> NDArray[np.int64]:
    """Return the frames of each row that each run queues, if nothing is lost."""
    rows = np.zeros(what.kinds.size, np.int64)
    cell = run_to_end(cell_of(what, seed), to_ticks(1e6), what.reserve)
    assert cell.state["open"] == 0
    for row in range(rows.size):
        rows[row] = round(cell.airtime[row, 0] / 1024 / TIME)
    return rows


#: Airtime of each frame, so that the airtime of a row gives its number of frames [ticks].
TIME = 1000


@pytest.mark.parametrize("name", ["Fast DDS", "Cyclone DDS, wired", "Zenoh peer, tokens"])
def test_fractions_are_right_in_the_mean_and_whole_numbers_always(name: str) -> None:
    once = tuple(
        replace(m, schedule=ds.Schedule((0.0,)), answers=None, hops=("up",))
        for m in ds.PROTOCOLS[name].messages
    )
    what = plan(UNLIKE, ds.Protocol(name, once), RADIO.wifi())
    what.radio["cw_min"] = what.radio["cw_max"] = 4095
    what.radio["attempts"] = 10**6
    what.radio["ack"], what.radio["sifs"] = 0, 0
    what.kinds_of_cells["time_up"] = TIME
    runs = np.array([frames_of_rows(what, seed) for seed in range(40)])
    wanted = np.array([float(m.load(UNLIKE)) * m.frames for m in once])
    senders, whole = 12, what.kinds["whole"] > 0
    assert (runs[:, whole] == wanted[whole]).all()
    assert whole.any()
    assert (np.abs(runs - wanted) < senders).all()  # each sends less than one more or fewer
    # The errors of the senders are uniform between -1 and 1 at most: allow 4 sigma of their mean.
    assert (np.abs(runs.mean(axis=0) - wanted) < 4 * np.sqrt(senders / 4 / len(runs))).all()
    assert (runs[:, ~whole].std(axis=0) > 0).any()
    assert (frames_of_rows(what, 3) == runs[3]).all()


def test_what_is_inside_a_frame_makes_it_longer() -> None:
    fleet = ds.Fleet.swarm(4, 3, 7)
    what = plan(fleet, ds.PROTOCOLS["hybrid"], RADIO.wifi())
    rows = {m.name: m for m in ds.PROTOCOLS["hybrid"].messages}
    octets = dict(zip(rows, what.kinds["octets"], strict=True))
    inside = 3 * rows["Process"].payload.nominal + 21 * rows["Endpoint"].payload.nominal
    assert octets["Announce"] == round(rows["Announce"].frame_bytes + inside)
    lonely = ds.Protocol("lonely", (replace(rows["Process"], schedule=ds.Schedule((0.0,))),))
    with pytest.raises(ValueError, match=r"message 'Process': .* inside must name the one message"):
        plan(fleet, lonely, RADIO.wifi())


@pytest.mark.parametrize("hops", [("up",), ("down",), ("up", "down")])
def test_units_of_ones_own_and_single_hops_are_simulated(hops: tuple[Hop, ...]) -> None:
    fleet = ds.Fleet.swarm(5, 2, 10)
    to_server = ds.Unit("process", "server")
    row = replace(SEDP, unit=to_server, per_unit=3, hops=hops, answers=None)
    found = ds.simulate(fleet, ds.Protocol("own", (row,)), RADIO.wifi(), queue=None, recovery=False)
    assert found.counts["expected"] == found.counts["arrived"] == 3 * 8
    assert (found.airtime[0, 0, :2] > 0).tolist() == ["up" in hops, "down" in hops]
    wired = replace(row, unit=PROCESS, hops=hops)
    if len(hops) == 1:
        table = ds.Protocol("own", (wired,))
        found = ds.simulate(fleet, table, RADIO.wifi(), queue=None, recovery=False)
        assert found.counts["arrived"] == 3 * 10


def test_a_server_on_a_robot_does_not_recover() -> None:
    wanted = f"recovery must be False for the protocol '{ON_A_ROBOT}': it does not say how"
    with pytest.raises(ValueError, match=wanted):
        ds.simulate(SWARM, ds.PROTOCOLS[ON_A_ROBOT], RADIO.wifi())


def test_listed_hosts_are_announced_to_at_every_port() -> None:
    """A host's processes share the frames of the table, and each process learns of the sender."""
    table = ds.PROTOCOLS["Cyclone DDS peers"]
    (row,) = rows_to_every_port(table)
    spdp = table.messages[row]
    assert (spdp.name, spdp.per_unit) == ("SPDP", 9)
    (cell, _), found = (
        plan(UNLIKE, table, RADIO.wifi(), recovery=True).cell(np.random.SeedSequence(0)),
        ds.simulate(UNLIKE, table, RADIO.wifi(), queue=None, runs=3, until=7),
    )
    hosts = Hosts(np.array([2, 2, 2, 1, 1, 3]), np.array([10, 10, 10, 40, 40, 0]))
    remote = 11 - hosts.processes[hosts.host_of]
    assert cell.each[:, row] == pytest.approx(9 * spdp.frames * 5 / remote)
    assert np.isfinite(found.convergence_time).all()
    crowded = ds.Fleet.swarm(2, 10, 1)
    with pytest.raises(
        ValueError, match=r"at most 9 processes on average, one for each port, .* got 10"
    ):
        ds.simulate(crowded, table, RADIO.wifi())


def test_peers_that_are_told_of_each_other_discover_by_unicast() -> None:
    spdp, *others = ds.DDS.messages
    again = ds.Schedule((0.0, 0.1), 3.0)
    unicast = replace(spdp, cast="unicast", unit=PAIR, schedule=again)
    table = replace(ds.DDS, name="peers", messages=(unicast, *others))
    found = ds.simulate(SWARM, table, RADIO.wifi(), loss=0.05, runs=2)
    assert np.isfinite(found.convergence_time).all()


def with_other_names(table: ds.Protocol) -> ds.Protocol:
    """Return a table with other names, in another alphabetical order."""
    names: dict[str | None, str | None] = {None: None}
    names |= {m.name: f"M{len(table.messages) - n}" for n, m in enumerate(table.messages)}
    rows = (
        replace(
            message,
            name=names[message.name],
            phase=f"of {message.phase[::-1]}",
            kind=f"like {message.kind[::-1]}",
            answers=names[message.answers],
            inside=names[message.inside],
        )
        for message in table.messages
    )
    return replace(table, name="mine", messages=tuple(rows))


@pytest.mark.parametrize("name", ds.PROTOCOLS)
def test_names_decide_nothing(name: str) -> None:
    """Not even the timers depend on a table's name."""
    table, fleet = ds.PROTOCOLS[name], ds.Fleet((ds.HostGroup(2, 2, 5), ds.HostGroup(1, 1, 8)), 0.5)
    told: Any = {"loss": 0.1, "until": 4.0, "recovery": name in RECOVERING}
    found, again = (
        ds.simulate(fleet, one, RADIO.wifi(), **told) for one in (table, with_other_names(table))
    )
    assert replace(again, protocol=table) == found
    assert found.counts["arrived"] > 0


PING, PONG = (
    replace(ds.DDS.message("ACKNACK"), name=one, role="other", answers=other)
    for one, other in (("ping", "pong"), ("pong", "ping"))
)
REFUSED: list[tuple[dict[str, Any], str]] = [
    (
        {"messages": (SPDP, replace(SEDP, role=None))},
        "recovery must be False for the protocol 'mine': its message 'SEDP' has no role; give each",
    ),
    ({"timers": None}, "recovery must be False for the protocol 'mine': it has no timers; give it"),
    (
        {"messages": (replace(SPDP, role="other"), SEDP)},
        "recovery must be False for the protocol 'mine': it does not say how processes find",
    ),
    (
        {"messages": (SPDP, replace(SEDP, cast="multicast", unit=PROCESS))},
        "protocol 'mine', message 'SEDP': unit must have receivers",
    ),
    (
        {"messages": ds.DDS.messages[:3]},
        "must have one heartbeat .*, or neither; got 'Heartbeat' \\(heartbeat\\)$",
    ),
    (
        {"messages": (*ds.DDS.messages[:3], replace(ds.DDS.messages[3], answers="SEDP"))},
        "one acknowledgement that answers it, or neither; got 'Heartbeat'.*, 'ACKNACK'",
    ),
    (
        {"messages": (*ds.DDS.messages, PING, PONG)},
        "message 'ping': answers must not lead back to itself; got ping answers pong answers ping$",
    ),
    (
        {"messages": (SPDP, replace(SEDP, answers="Z"))},
        "message 'SEDP': answers must be 'SPDP' or 'SEDP', or None; got 'Z'$",
    ),
    (
        {"lease": 4e-8},
        "protocol 'mine': lease must be at least 1e-07 s to be simulated; got 4e-08$",
    ),
]


@pytest.mark.parametrize(("change", "wanted"), REFUSED)
def test_tables_that_do_not_say_what_recovery_takes_are_refused(
    change: dict[str, Any], wanted: str
) -> None:
    table = replace(ds.DDS, name="mine", **change)
    with pytest.raises(ValueError, match=wanted):
        ds.simulate(SWARM, table, RADIO.wifi())
    found = ds.simulate(SWARM, table, RADIO.wifi(), recovery=False)
    assert found.counts["arrived"] > 0


# ---------------------------------------------------------------- saturation


def bianchi(stations: int, success: float, collision: float, slot: float) -> float:
    """Return frames per second by Bianchi, IEEE JSAC 18(3), 2000, with W = 16 and m = 6."""
    window, stages = 16, 6

    def send(p: float) -> float:
        growth = sum((2 * p) ** k for k in range(stages))
        return 2 / (1 + window + p * window * growth)

    low, high = 0.0, 1.0
    for _ in range(100):
        p = (low + high) / 2
        low, high = (p, high) if 1 - (1 - send(p)) ** (stations - 1) > p else (low, p)
    tau = send((low + high) / 2)
    busy = 1 - (1 - tau) ** stations
    good = stations * tau * (1 - tau) ** (stations - 1)
    return good / ((1 - busy) * slot + good * success + (busy - good) * collision)


def saturation_rate(what: Setup, stations: int, seconds: float) -> float:
    """Return the frames per second that arrive if all but the last host always send."""
    cell = cell_of(what)
    cell = run_to_end(cell, to_ticks(seconds), what.reserve)
    assert (cell.stations["length"][:stations] > 0).all(), "some had nothing left to send"
    return int(cell.state["arrived"][0]) / seconds


def frozen(stations: int, success: float, collision: float, slot: float) -> float:
    """Return frames a second if a busy slot does not count, as without QoS, also W = 16, m = 6.

    Then nobody else sends right after AIFS but who has just sent and draws a zero (Bianchi and
    Tinnirello, IEEE Communications Letters 9(8), 2005). Such a frame arrives: that several who
    have collided draw a zero at once is left out.
    """
    window, stages = 16, 6

    def of_success(p: float) -> tuple[float, float]:
        """Return the idle slots and transmissions per frame that arrives."""
        slots, sendings, drawn = 0.0, 0.0, 1.0
        for stage in range(200):
            size = window << min(stage, stages)
            slots += drawn * (size - 1) / 2
            drawn *= 1 - 1 / size
            sendings += drawn
            drawn *= p
        return slots, sendings

    low, high = 0.0, 1.0
    for _ in range(100):
        p = (low + high) / 2
        slots, sendings = of_success(p)
        tau = sendings / slots
        low, high = (p, high) if 1 - (1 - tau) ** (stations - 1) > p else (low, p)
    good = stations / slots
    collides = 1 - (1 - tau) ** stations - stations * tau * (1 - tau) ** (stations - 1)
    return good / (slot + good * success + collides * collision)


def saturation_plan(
    stations: int, endpoints: int, radio: ds.Radio = RADIO, payload: ds.Payload = SEDP.payload
) -> Setup:
    starts = np.zeros(stations + 1)
    starts[-1] = 1e4  # a receiver that sends nothing
    row = replace(SEDP, hops=("up",), answers=None, payload=payload)
    fleet = ds.Fleet.swarm(stations + 1, 1, endpoints)
    return plan(fleet, ds.Protocol("saturation", (row,)), radio.wifi(), start=starts)


#: Short frames, whose airtime is mostly contention.
SHORT = ds.Payload(50, 50, 50, "short")


@pytest.mark.parametrize("stations", [1, 2, 5, 10, 20, 50])
@pytest.mark.parametrize(("radio", "chain"), [(RADIO, bianchi), (ds.Radio("802.11a"), frozen)])
def test_saturation_is_that_of_bianchis_chain(
    stations: int, radio: ds.Radio, chain: Callable[..., float]
) -> None:
    what = saturation_plan(stations, min(max(20_000 // stations**2, 200), 16_000), radio, SHORT)
    # The chains have no timeouts and never drop a frame.
    what.radio["timeout"] = 0
    what.radio["attempts"] = 10**6
    record = what.radio[0]
    data = int(what.kinds["time_up"][0])
    success = data + int(record["sifs"]) + int(record["ack"]) + int(record["aifs"])
    collision = data + int(record["aifs"])
    wanted = chain(stations, success * TICK, collision * TICK, radio.slot)
    assert saturation_rate(what, stations, 2.0) == pytest.approx(wanted, rel=0.015)


@pytest.mark.parametrize(("radio", "chain"), [(RADIO, bianchi), (ds.Radio("802.11a"), frozen)])
def test_two_stations_that_collide_both_wait_for_their_timeout(
    radio: ds.Radio, chain: Callable[..., float]
) -> None:
    """So they send one to two percent less than the chain without timeouts."""
    what = saturation_plan(2, 5_000, radio, SHORT)
    record, data = what.radio[0], int(what.kinds["time_up"][0])
    short = data + int(record["aifs"])
    success, long = short + int(record["sifs"]) + int(record["ack"]), short + int(record["timeout"])
    ideal, wanted = (chain(2, success * TICK, end * TICK, radio.slot) for end in (short, long))
    assert 0.98 < wanted / ideal < 0.99
    assert saturation_rate(what, 2, 2.0) == pytest.approx(wanted, rel=0.015)


# ---------------------------------------------------------------- repair alone


def repair_chain(items: int, good: float, rounds: int) -> NDArray[np.float64]:
    """Return the chance that a reader has all items after each round of Heartbeat and ACKNACK.

    State: how many are missing. At the begin each item arrives with chance ``good``. A round
    repeats all that is missing if both its Heartbeat and its ACKNACK arrive.
    """
    lose = np.zeros((items + 1, items + 1))
    for before in range(items + 1):
        for after in range(before + 1):
            chance = comb(before, after) * (1 - good) ** after * good ** (before - after)
            lose[before, after] = chance
    step = good**2 * lose + (1 - good**2) * np.eye(items + 1)
    state = lose[items]
    chances = [state[0]]
    for _ in range(rounds):
        state = state @ step
        chances.append(state[0])
    return np.array(chances)


@pytest.mark.parametrize("loss", [0.2, 0.5])
def test_time_to_repair_is_that_of_the_markov_chain(loss: float) -> None:
    items, runs, rounds = 4, 400, 12
    announcement = replace(
        ds.DDS.message("SPDP"), hops=("down",), schedule=ds.Schedule((0.0, 0.1), 1000.0)
    )
    rows = (
        announcement,
        replace(SEDP, hops=("down",)),
        replace(ds.DDS.message("Heartbeat"), hops=("down",), per_unit=1),
        replace(ds.DDS.message("ACKNACK"), hops=("down",), per_unit=1),
    )
    # Only the access point sends, so nothing collides, and Wi-Fi does not retry losses.
    what = plan(
        ds.Fleet.swarm(2, 1, items),
        replace(ds.DDS, name="repair", messages=rows),
        RADIO.wifi(),
        start=[0.0, 0.01],
        recovery=True,
    )
    what.radio["attempts"] = 1
    period = int(what.repairs["heartbeat_period_initial"][0])  # type: ignore[index]
    times = []
    for seed in range(runs):
        cell = cell_of(what, seed)
        cell = run_to_end(cell, to_ticks(0.0999), what.reserve)
        loaded = LoadedCell(cell)
        # The first host knows the second; now the second discovers the first and sends to it.
        while not cell.pairs["discovered"][1, 0]:
            loaded.advance(to_ticks(1e6), what.reserve, 1)
            cell = loaded.cell
        begin = int(cell.pairs["announced_at"][1, 0])
        cell.stations["loss"] = loss
        while not cell.pairs["completed_at"][0, 1]:
            loaded.advance(to_ticks(1e6), what.reserve, 1)
            cell = loaded.cell
        times.append(int(cell.pairs["completed_at"][0, 1]) - begin)
    taken = np.array(times)
    # The Heartbeat sent with the items is the first round; the timer starts the other rounds, which
    # take some milliseconds each.
    first = np.ceil((taken - to_ticks(0.02)) / period).clip(0)
    found = [(first <= round_).mean() for round_ in range(rounds)]
    chain = repair_chain(items, 1 - loss, rounds)[1 : rounds + 1]
    # Kolmogorov and Smirnov: the distance exceeds 1.63 / sqrt(runs) in one of a hundred cases.
    assert np.abs(found - chain).max() < 1.63 / np.sqrt(runs)


# ---------------------------------------------------------------- what users rely on


SWARM = ds.Fleet.swarm(5, 2, 10)
small = partial(ds.simulate, SWARM, ds.DDS, RADIO.wifi(), runs=3)


def test_the_same_seed_gives_the_same_bits() -> None:
    one, same, other = small(), small(), small(seed=1)
    assert one.to_json() == same.to_json()
    assert (one.pair_times == same.pair_times).all()
    assert (one.drain_time != other.drain_time).any()
    # Each run draws its own numbers, whatever the number of runs.
    assert small(runs=2).drain_time.tolist() == one.drain_time[:2].tolist()


def test_runs_side_by_side_are_the_same_as_one_after_the_other(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    several = small()
    monkeypatch.setattr("os.cpu_count", lambda: 1)
    assert small().to_json() == several.to_json()


def test_nothing_is_lost_without_limits_and_collisions() -> None:
    # Hosts that start far apart do not collide.
    found = small(queue=None, start=lambda _, hosts: 5.0 * np.arange(hosts), recovery=False)
    assert (found.counts["host_full"] == 0).all()
    assert (found.drain_time > 20).all()
    assert np.isfinite(found.convergence_time[found.lost == 0]).all()


def test_everybody_knows_everybody_in_the_end() -> None:
    assert len(RECOVERING) > 15
    for name in RECOVERING:
        found = ds.simulate(SWARM, ds.PROTOCOLS[name], RADIO.wifi(), loss=0.05, runs=2)
        assert np.isfinite(found.convergence_time).all(), name
        # With a wired server also those on the same host.
        others = 9 if name in SERVED and "star" not in name else 8
        assert found.pair_times.shape == (2, 10 * others), name
        assert (found.pair_times.max(axis=1) == found.convergence_time).all(), name


def test_a_server_repairs_what_it_passes_on() -> None:
    """Where topics match, with so many errors that some frames are lost for good."""
    assert len(SERVED) == 4
    fleet = ds.Fleet((ds.HostGroup(3, 2, 4, shared=2), ds.HostGroup(2, 1, 8)), 0.5)
    for name in (*SERVED, "Zenoh router per host"):
        found = ds.simulate(fleet, ds.PROTOCOLS[name], RADIO.wifi(), loss=0.6, runs=3)
        assert (found.lost > 0).all(), name
        assert np.isfinite(found.convergence_time).all(), name


SERVER = ds.PROTOCOLS["Fast DDS Discovery Server"]


def simulate_with_server(hosts: int, release: str, mpdus: int = 64, **timers: float) -> Simulation:
    """Simulate robots that share their topics, with a server and the timers of a release."""
    table = with_timers_of(SERVER, ds.PROTOCOLS[release])
    assert table.timers is not None
    table = replace(table, timers=replace(table.timers, **timers))
    fleet = ds.Fleet((ds.HostGroup(hosts, 2, 10, shared=10),))
    wifi = ds.Radio("802.11n", streams=2, aifsn=3, mpdus=mpdus).wifi()
    return ds.simulate(fleet, table, wifi, runs=3, queue=(500, 0.5), until=20, start=0.01)


def test_a_server_introduces_processes_before_it_passes_their_endpoints_on() -> None:
    found = simulate_with_server(2, "Fast DDS 2.14")
    names = np.array([message.name for message in SERVER.messages])
    sent = found.transmissions[found.transmissions["kind"] >= 0]
    first = {
        name: sent["start"][names[sent["kind"]] == name].min() / 1e7
        for name in ("SPDP of others", "SEDP of others")
    }
    assert 0.44 < first["SEDP of others"] - first["SPDP of others"] < 0.47
    assert found.pair_times.min() > first["SPDP of others"] + 0.44
    # With eight robots that do not aggregate, introductions are lost, and all that follows waits.
    lossy = simulate_with_server(8, "Fast DDS 2.14", mpdus=1)
    assert lossy.pair_times.min() > 1.0


def test_a_server_asks_again_those_who_had_acknowledged_all_introductions() -> None:
    """A client may lose all that comes later, and then hears no Heartbeat that rides on it."""
    fleet = ds.Fleet((ds.HostGroup(12, 2, 10, shared=2),))
    table = with_timers_of(SERVER, ds.PROTOCOLS["Fast DDS 2.14"])
    found = ds.simulate(fleet, table, ds.PAPER, runs=10, until=20)
    assert (found.lost > 0.4).all()
    assert (found.convergence_time < 6).all()


def test_clients_of_a_server_ask_for_what_they_lack_at_once() -> None:
    """Not only when the server's next Heartbeat comes, a second later."""
    newer, older = (simulate_with_server(8, name) for name in ("Fast DDS 2.14", "Fast DDS"))
    assert (newer.lost > 0.3).all()
    assert (newer.convergence_time < 2).all()
    # Those that answer at once send more, and do not get further without aggregation.
    alone = {name: simulate_with_server(8, name, mpdus=1) for name in ("Fast DDS 2.14", "Fast DDS")}
    assert np.isfinite(alone["Fast DDS 2.14"].convergence_time).all()
    assert not np.isfinite(alone["Fast DDS"].convergence_time).any()
    assert older.lost.mean() > 0.3
    # While the other direction is missing, readers ask writers for Heartbeats.
    silent = simulate_with_server(8, "Fast DDS 2.14", preemptive_acknack_delay=0.0)
    asked, unasked = (found.counts["expected"].mean() for found in (newer, silent))
    assert asked > 1.2 * unasked


def test_all_processes_of_a_host_learn_when_its_router_does() -> None:
    found = ds.simulate(SWARM, ds.PROTOCOLS["Zenoh router per host"], RADIO.wifi(), runs=1)
    times, counts = np.unique(found.pair_times, return_counts=True)
    assert (counts % 2 == 0).all()
    assert times.size > 20


def test_a_process_that_the_server_forgets_is_found_again() -> None:
    """With a lease of 5 s, so that it ends now and then where announcements are lost."""
    for name in SERVED:
        hasty = replace(ds.PROTOCOLS[name], lease=5.0)
        found = ds.simulate(SWARM, hasty, RADIO.wifi(), loss=[0.0] * 4 + [0.9], until=500.0, runs=3)
        assert found.counts["expired"].sum() > 0, name
        assert np.isfinite(found.pair_times).any(axis=0).mean() > 0.5, name


def test_a_run_that_gets_no_further_ends_as_never() -> None:
    hasty = replace(ds.PROTOCOLS["DDS, periods of Fast DDS"], lease=0.05)
    plain = ds.simulate(SWARM, hasty, RADIO.wifi(), until=60)
    found = ds.simulate(SWARM, hasty, RADIO.wifi(), until=60, give_up=3)
    assert found.convergence_time[0] == plain.convergence_time[0] == np.inf
    # After three periods of 3 s.
    assert found.queues[0][-1, 0] < 15 < 50 < plain.queues[0][-1, 0]
    assert found.settings["give_up"] == 3
    good, same = (small(loss=0.1, give_up=wait) for wait in (None, 3))
    assert replace(same, settings=good.settings) == good
    with pytest.raises(ValueError, match="give_up must be a finite number above 0; got 0"):
        small(give_up=0)


def test_a_run_goes_on_while_announcements_arrive_although_no_pair_is_complete() -> None:
    """A process of 1,500 endpoints needs longer for the first pair than `give_up` waits."""
    found = ds.simulate(ds.Fleet.swarm(3, 1, 1500), "Fast DDS 2.14", until=60, give_up=3)
    assert 3 * 3.0 < np.min(found.pair_times[found.pair_times > 0]) < 60
    assert np.isfinite(found.convergence_time).all()


def test_a_run_waits_for_hosts_that_start_long_after_the_others() -> None:
    """The first hosts finish within seconds, and nothing happens until the last one starts."""
    found, same = (small(start=[0.0] * 4 + [30.0], give_up=wait, until=60) for wait in (3, None))
    assert (found.convergence_time > 30).all()
    assert replace(found, settings=same.settings) == same


def test_heartbeats_that_ride_on_repeats_make_a_lossy_startup_longer() -> None:
    """Those of Humble's release, once a process has sent more than its send buffer holds."""
    humble = ds.PROTOCOLS["Fast DDS 2.6"]
    assert humble.timers is not None
    endless = replace(humble, timers=replace(humble.timers, send_buffer=0.0))
    riding, none = (
        ds.simulate(ds.Fleet.swarm(5, 2, 10), table, ds.PAPER, runs=3, until=60)
        for table in (humble, endless)
    )
    assert riding.convergence_time.min() > none.convergence_time.max()
    assert riding.lost.min() > none.lost.max()


def test_a_lease_that_is_too_short_never_settles() -> None:
    hasty = replace(ds.PROTOCOLS["DDS, periods of Fast DDS"], lease=0.05)
    found = ds.simulate(SWARM, hasty, RADIO.wifi(), until=5)
    assert found.convergence_time[0] == np.inf
    assert found.counts["expired"][0] > 100


def test_losses_make_discovery_longer() -> None:
    medians = [np.median(small(loss=loss, runs=15).convergence_time) for loss in (0.0, 0.5)]
    assert medians[0] < medians[1] < np.inf


def test_starting_one_after_the_other_loses_less() -> None:
    big = ds.Fleet.swarm(10, 2, 10)

    def lost(start: Any) -> float:
        found = ds.simulate(big, ds.DDS, RADIO.wifi(), start=start, recovery=False, runs=5)
        return float(np.median(found.lost))

    assert lost(lambda rng, hosts: rng.uniform(0, 10, hosts)) < 0.1 < 0.5 < lost(0.0)


def test_a_burst_is_not_over_while_some_of_it_is_still_to_come() -> None:
    """Fast DDS multicasts its last initial announcement after half a second."""
    pair = ds.Fleet.swarm(2, 1, 1)
    for until, over in ((0.05, False), (0.6, True)):
        found = ds.simulate(pair, ds.PROTOCOLS["Fast DDS"], ds.PAPER, until=until)
        assert found.convergence_time < 0.05
        assert found.counts["waiting"] == 0
        assert np.isfinite(found.drain_time) == over
    assert 0.5 < found.drain_time < 0.6


def test_tables_and_json_hold_the_same() -> None:
    found = small()
    table = found.table()
    assert table["drain_time_s"].tolist() == found.drain_time.tolist()
    assert table["collisions"].tolist() == found.counts["collisions"].tolist()
    answer = json.loads(found.to_json())
    assert answer["drain_time"] == found.drain_time.tolist()
    assert answer["counts"]["ppdus"] == found.counts["ppdus"].tolist()
    names = [message.name for message in found.protocol.messages]
    up = answer["airtime"]["SEDP"]["up"]
    assert up == found.airtime[:, names.index("SEDP"), 0].tolist()
    assert min(up) > 0
    assert answer["lost_by_host"] == found.lost_by_host.tolist()
    time, hosts, access_point = found.queues[1].T.tolist()
    assert answer["queues"][1] == {"time_s": time, "hosts": hosts, "access_point": access_point}
    pairs = answer["pair_times"]
    assert pairs["pairs"] == found.pair_times.shape[1] == 80
    for of_run, run in zip(pairs["times"], found.pair_times, strict=True):
        for share, value in zip(pairs["quantiles"], of_run, strict=True):
            # This share of the pairs is complete by then, and not before.
            assert (run <= value).mean() >= share
            assert (run < value).mean() <= share
    sent = transmission_table(found)
    assert (sent["start_s"].diff().dropna() >= 0).all()
    # At the start, all hosts send at once.
    first = sent[sent["start_s"] == sent["start_s"].min()]
    assert sorted(first["station"]) == [f"host {number}" for number in range(1, 6)]
    assert set(first["outcome"]) == {"collision"}
    assert "DDS" in repr(found)
    never = json.loads(small(loss=0.9, until=0.01, runs=1).to_json())
    assert never["convergence_time"] == [None]
    assert never["pair_times"]["times"] == [[None] * 21]


class Uniform:
    """A stand-in for frozen distributions of SciPy."""

    dist, args, kwds = SimpleNamespace(name="uniform"), (0.0,), {"scale": 3.0}

    def rvs(self, size: int, random_state: np.random.Generator) -> Any:
        return random_state.uniform(self.args[0], self.kwds["scale"], size)


def one_each_second(_: np.random.Generator, hosts: int) -> Any:
    return np.arange(hosts)


@pytest.mark.parametrize(
    ("start", "said"),
    [
        (1, 1.0),
        (np.arange(6.0), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]),
        (starts.uniform_start(2.5), "at random within 2.5 s, each time equally likely"),
        (Uniform(), "scipy.stats.uniform(0.0, scale=3.0)"),
        (one_each_second, "test_simulation.one_each_second"),
    ],
)
def test_a_run_can_be_repeated_from_its_json(start: Any, said: Any) -> None:
    wifi = ds.Radio("802.11n", streams=2, aifsn=3, mpdus=8).wifi()
    fleet = ds.Fleet((ds.HostGroup(2, 2, 7, "robots", shared=3), ds.HostGroup(4, 1, 9)), 0.25)
    loss = np.linspace(0, 0.2, 6)
    table = ds.PROTOCOLS["Fast DDS"]
    found = ds.simulate(
        fleet, table, wifi, queue=(50, 0.25), start=start, loss=loss, seed=7, until=9.0, eifs=True
    )
    told = json.loads(found.to_json())
    settings = told["settings"]
    assert settings["start"] == said
    groups = tuple(ds.HostGroup(**group) for group in told["fleet"])
    again = ds.simulate(
        ds.Fleet(groups, told["matching"]),
        ds.PROTOCOLS[told["protocol"]],
        ds.Radio(**told["radio"]).wifi(),
        queue=(settings["queue_frames"], settings["queue_s"]),
        start=told["starts"][0],
        loss=settings["loss"],
        **{name: settings[name] for name in ("recovery", "runs", "seed", "eifs")},
        until=settings["until_s"],
    ).to_dict()
    assert again["settings"]["start"] == told["starts"][0]
    for answer in (again, told):
        del answer["settings"]["start"]
    assert again == told


def test_time_grows_with_transmissions_not_with_stations() -> None:
    from time import process_time

    def cost(hosts: int) -> float:
        what = plan(ds.Fleet.swarm(hosts, 2, 10), ds.DDS, RADIO.wifi())
        cell = run_to_end(cell_of(what), to_ticks(0.01), what.reserve)
        begin, before = process_time(), int(cell.state["ppdus"][0])
        cell = run_to_end(cell, to_ticks(4.0), what.reserve)
        return (process_time() - begin) / (int(cell.state["ppdus"][0]) - before)

    cost(10)
    assert min(cost(500) for _ in range(3)) < 5 * min(cost(10) for _ in range(3))


BAD: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"queue": (0, 0.5)}, ValueError, r"queue\[0\] must be .* at least 1.*; got 0"),
    ({"queue": (2.5, 0.5)}, ValueError, r"queue\[0\] must be a whole .* 1, or infinity; got 2.5"),
    (
        {"queue": ("a", 0.5)},
        TypeError,
        r"queue\[0\] must be a whole number of at least 1, or infinity; got 'a'",
    ),
    ({"queue": (500, 0)}, ValueError, r"queue\[1\] must be .* above 0, or infinity; got 0"),
    ({"queue": 500}, TypeError, "queue must be None or a tuple"),
    ({"start": -1.0}, ValueError, "start must be .* at least 0 and .*; got -1"),
    ({"start": [0.0, 1.0]}, ValueError, r"start must give one time for each of the 5 hosts"),
    ({"start": "soon"}, TypeError, "start must be"),
    (
        {"start": 1e15},
        ValueError,
        r"start must be .* at least 0 and at most 1e\+06; got 1000000000000000.0",
    ),
    ({"loss": 1.0}, ValueError, "loss must be .* at least 0 and below 1; got 1.0"),
    ({"loss": 2.0}, ValueError, "loss must be .* at least 0 and below 1; got 2.0"),
    ({"loss": -0.1}, ValueError, "loss must be .* at least 0 and below 1; got -0.1"),
    ({"loss": [0.1, 0.1]}, ValueError, "loss must be one number, or one for each of the 5 hosts"),
    (
        {"start": lambda _: 1},
        TypeError,
        "^start must be a function of a numpy.random.Generator and a number of hosts; got one",
    ),
    ({"recovery": 1}, TypeError, "recovery must be a bool; got 1"),
    ({"runs": 0}, ValueError, "^runs must be a whole number of at least 1; got 0$"),
    ({"runs": "a"}, TypeError, "^runs must be a whole number of at least 1; got 'a'$"),
    ({"runs": [1, 2]}, TypeError, r"^runs must be one number, not an array; got .*\[1, 2\]"),
    ({"seed": 1.5}, ValueError, "seed must be a whole number of at least 0; got 1.5"),
    ({"until": 0}, ValueError, "until must be .* above 0 and .*; got 0"),
    ({"until": 1e15}, ValueError, r"until must be .* at most 1e\+06; got 1000000000000000.0"),
    ({"until": "a"}, TypeError, r"^until must be a finite number above 0 and at most 1e\+06; got"),
]


@pytest.mark.parametrize(("argument", "error", "message"), BAD)
def test_bad_input_is_refused_by_name(
    argument: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        small(**argument)


def test_what_cannot_be_simulated_is_refused() -> None:
    wifi = RADIO.wifi()
    with pytest.raises(ValueError, match=r"groups\[0\].hosts must be a whole number .*; got 2.5"):
        ds.simulate(ds.Fleet.swarm(2.5, 1, 1), ds.DDS, wifi)
    named = ds.Fleet((ds.HostGroup(2, 2.5, 1, name="robots"),))
    allowed = "a whole number of at least 1 and at most 1048576"
    with pytest.raises(ValueError, match=rf'processes of "robots" must be {allowed}; got 2.5'):
        ds.simulate(named, ds.DDS, wifi)
    with pytest.raises(ValueError, match="fleet must have at least 2 hosts to simulate; got 1"):
        ds.simulate(ds.Fleet.swarm(1, 1, 1), ds.DDS, wifi)
    with pytest.raises(TypeError, match="must be a number to simulate; got N_H"):
        ds.simulate(ds.Fleet.symbolic(1), ds.DDS, wifi)
    with pytest.raises(ValueError, match="wifi must have a radio"):
        ds.simulate(SWARM, ds.DDS, replace(wifi, radio=None))
    table = ds.Protocol("own", (replace(SEDP, unit=PROCESS, answers=None),))
    with pytest.raises(
        ValueError, match=r"'SEDP': cast must be 'multicast', or hops have one entry"
    ):
        ds.simulate(SWARM, table, wifi)
    twice = replace(ds.DDS, messages=(ds.DDS.message("SPDP"), replace(SEDP, per_unit=2)))
    with pytest.raises(ValueError, match="a process must send at most 16384 per receiver"):
        ds.simulate(ds.Fleet.swarm(2, 1, 16_000), twice, wifi)


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        (
            {"schedule": ds.Schedule((0.0,), 4e-8)},
            ValueError,
            "period must be at least 1e-07 s to be simulated; got 4e-08",
        ),
        (
            {"payload": ds.Payload(65_472, 0, 1e9, "own")},
            ValueError,
            "its frames must have at most 65535 B with headers to be simulated; got 65536",
        ),
    ],
)
def test_rows_that_cannot_be_simulated_are_refused(
    change: dict[str, Any], error: type[Exception], message: str
) -> None:
    table = ds.Protocol("own", (replace(SEDP, name="A", answers=None, **change),))
    with pytest.raises(error, match=f"^protocol 'own', message 'A': {message}"):
        ds.simulate(SWARM, table, RADIO.wifi(), recovery=False)


def test_a_table_with_too_many_messages_is_refused() -> None:
    table = ds.Protocol("own", tuple(replace(SPDP, name=f"{n}") for n in range(65)))
    with pytest.raises(ValueError, match=r"at most 64 messages to simulate; got 65$"):
        ds.simulate(SWARM, table, RADIO.wifi())


def test_a_queue_too_large_to_count_has_no_limit() -> None:
    yes: Any = np.True_
    none, large = (small(queue=queue, recovery=yes) for queue in (None, (10**20, 1e300)))
    assert (none.table() == large.table()).all(axis=None)
    assert none.settings["recovery"] is True


def test_package_does_not_load_what_only_the_simulator_needs() -> None:
    code = "import sys, discostorm, discostorm_simulation; print('wasmtime' in sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"


def test_without_wasmtime_it_says_so_and_the_rest_works() -> None:
    code = """
import sys
import time
sys.modules["wasmtime"] = sys.modules["numba"] = None
import discostorm as ds
from discostorm.cli import main
from discostorm_simulation import starts
fleet = ds.Fleet.swarm(4, 2, 10)
assert str(starts.uniform_start(2.0)).startswith("at random within 2 s")
try:
    ds.simulate(fleet, ds.DDS, ds.PAPER)
except ImportError as error:
    print(error)
main(["simulate", "--hosts", "4", "--processes", "2", "--endpoints", "10"])
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    says = "the simulator needs wasmtime, which exists for 64-bit Linux, macOS and Windows: "
    assert run.returncode == 2
    assert run.stdout.startswith(says)
    assert run.stderr.endswith(f"Error: {says}pip install wasmtime\n")


def test_long_runs_are_announced(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("discostorm_simulation._ESTIMATE_FROM_S", 0.0)
    small()
    assert "3 runs of about" in capsys.readouterr().err
    what = plan(ds.Fleet.swarm(1000, 2, 10), ds.DDS, RADIO.wifi())
    seconds, megabytes = what.estimate()
    assert 5 < seconds < 200
    assert 500 < megabytes < 10_000


def test_long_runs_are_estimated_by_how_long_they_are() -> None:
    # One table schedules its announcements; the other relies on the middleware's timers.
    for name in ("Fast DDS", "DDS"):
        table = ds.PROTOCOLS[name]

        def seconds(table: ds.Protocol = table, **given: Any) -> float:
            return plan(SWARM, table, RADIO.wifi(), recovery=True, **given).estimate()[0]

        short, long, longest = (seconds(until=until) for until in (10.0, 1e5, 1e6))
        assert short < 1
        assert longest > 1
        assert longest - short == pytest.approx(10 * (long - short), rel=1e-3)
        # Holders of a lease check its expiry.
        assert seconds(replace(table, lease=1e-6), until=10.0) > 60
        # Only hosts that have started send.
        late = np.full(5, 1e6)
        assert seconds(until=10.0, start=late) == short
        assert seconds(until=10.0, start=late * (np.arange(5) > 0)) == pytest.approx(
            longest, rel=1e-3
        )


def test_estimates_are_right_to_an_order_of_magnitude() -> None:
    """In processor time of the thread; of up to ten runs the fastest, as others use the caches."""
    channel = ds.WIFI["802.11ac 80 MHz 2x2"]
    turtlebot = robots()["TurtleBot 4 with Nav2"]
    fleets = (
        ds.Fleet.swarm(12, 2, 10),
        ds.Fleet((replace(turtlebot, hosts=2),)),
        ds.Fleet((replace(turtlebot, hosts=4),)),
    )
    protocol = ds.PROTOCOLS["Fast DDS 3.6"]
    setups = [plan(one, protocol, channel, recovery=True, until=60.0) for one in fleets]
    small()  # loads the engine
    ratios = np.full(len(setups), np.inf)
    for _ in range(10):
        for index, what in enumerate(setups):
            began = time.thread_time()
            simulate_run(what, np.random.SeedSequence(0))
            took = time.thread_time() - began
            ratios[index] = min(ratios[index], took / what.estimate()[0])
        # A busy machine slows all of them down.
        alike = (ratios / ratios[-1] > 0.1) & (ratios / ratios[-1] < 10)
        if alike.all() and 0.1 < ratios[-1] < 10:
            return
    pytest.fail(f"measured times are {ratios} of those estimated")


def test_what_does_not_fit_the_memory_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("discostorm_simulation.available_megabytes", lambda: 0.01)
    with pytest.raises(ValueError, match=r"^fleet must be smaller .* 0 MB available; got 10 pr"):
        small()
    monkeypatch.undo()
    assert 100 < available_megabytes() < 1e8
    monkeypatch.setattr("discostorm_simulation.available_megabytes", lambda: float("inf"))
    large = ds.Fleet.swarm(7000, 1, 1)
    with pytest.raises(ValueError, match=r"needs about \d+ MB, but .* at most 4295 MB"):
        ds.simulate(large, ds.DDS, ds.PAPER)


@pytest.mark.parametrize(
    ("own", "files", "megabytes"),
    [
        (None, {}, 4096.0),
        ("0::/a/b", {}, 4096.0),
        ("0::/a/b", {"a/b/memory.max": "max", "a/b/memory.current": "5"}, 4096.0),
        # The kernel can reclaim cached files.
        ("0::/a/b", {"a/b/memory.max": "900000000", "a/b/memory.current": "200000000"}, 750.0),
        # The limit of a control group also holds for the groups inside.
        ("0::/a/b", {"a/memory.max": "900000000", "a/memory.current": "200000000"}, 750.0),
        # Inside a container.
        ("0::/", {"memory.max": "900000000", "memory.current": "200000000"}, 750.0),
        ("0::/", {"memory.max": "900000000", "memory.current": "999000000"}, 0.0),
        (
            "5:cpu,cpuacct:/x\n4:memory:/outside\n0::/x",
            {"memory/memory.limit_in_bytes": "9" * 8, "memory/memory.usage_in_bytes": "9"},
            99.99999 + 60.0,
        ),
    ],
)
def test_a_container_has_the_memory_that_it_is_given(
    own: str | None, files: dict[str, str], megabytes: float, tmp_path: Path
) -> None:
    groups, proc = tmp_path / "sys/fs/cgroup", tmp_path / "proc"
    (proc / "self").mkdir(parents=True)
    (proc / "meminfo").write_text("MemTotal: 9999999 kB\nMemAvailable: 4000000 kB\n")
    if own is not None:
        (proc / "self/cgroup").write_text(own + "\n")
    for name, text in files.items():
        (groups / name).parent.mkdir(parents=True, exist_ok=True)
        (groups / name).write_text(text + "\n")
        (groups / name).with_name("memory.stat").write_text(
            "anon 1\ninactive_file 50000000\ntotal_inactive_file 60000000\n"
        )
    assert available_megabytes(tmp_path) == pytest.approx(megabytes)


def test_the_same_simulation_is_equal() -> None:
    one, same, other = small(seed=1), small(seed=1), small(seed=2)
    assert one == same
    assert hash(one) == hash(same)
    assert one != other
    assert one != "simulation"
    assert one != replace(one, counts=one.counts | {"arrived": one.counts["arrived"] + 1})
    assert one != replace(one, fleet=ds.Fleet.swarm(6, 2, 10))


def test_one_run_fits_the_others() -> None:
    what = plan(SWARM, ds.DDS, RADIO.wifi())
    run = simulate_run(what, np.random.SeedSequence(0).spawn(1)[0])
    assert run.drain_time == small(queue=None, recovery=False, runs=1).drain_time[0]


# ---------------------------------------------------------------- command line


def command(*arguments: str) -> Any:
    usual = {"--runs": "2", "--protocol": "DDS"}
    own = [word for name, value in usual.items() if name not in arguments for word in (name, value)]
    return CliRunner().invoke(main, ["simulate", str(FLEET), *own, *arguments])


def test_command_prints_what_the_package_finds() -> None:
    answer = json.loads(command("--no-recovery", "--json").stdout)
    found = ds.simulate(
        ds.Fleet.from_toml(FLEET), ds.DDS, ds.PAPER, recovery=False, runs=2
    ).to_dict()
    assert answer == found
    rows = command("--no-recovery", "--csv").stdout.splitlines()
    assert rows[0].startswith("run,drain_time_s,lost,convergence_time_s")
    assert len(rows) == 3
    table = command("--no-recovery", "--protocol", "Zenoh", "--window", "3")
    assert "drained [s]" in table.stdout
    assert "never, as frames were lost" in table.stdout
    # A time that was not reached may still come later.
    table = command("--until", "0.01")
    assert "not within 0.01 s" in table.stdout
    assert "never" not in table.stdout
    assert (
        "not within 0.01 s after the last start"
        in command("--until", "0.01", "--window", "3").stdout
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--protocol", "CORBA"), "Invalid value for '--protocol': 'CORBA'"),
        (("--window", "-1"), "--window must be a finite number of at least 0 and at most 1e+06;"),
        (("--window", "1e15"), "at most 1e+06; got 1000000000000000.0"),
        (("--runs", "0"), "runs must be"),
        (("--loss", "1"), "of at least 0 and below 1"),
        (("--wifi", "tin cans"), "'--wifi list' lists channels and radios"),
        # A channel that has only rates and overheads has no radio to contend with.
        (("--unicast-rate", "100"), "No such option '--unicast-rate'"),
        (("--multicast-rate", "24"), "--multicast-rate needs a radio here; got --wifi 'paper'"),
    ],
)
def test_command_refuses_bad_input(arguments: tuple[str, ...], message: str) -> None:
    result = command(*arguments)
    assert result.exit_code == 2
    assert message in result.output
