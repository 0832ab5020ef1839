"""Several cells on one clock, compared with the closed form and with one cell."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import discostorm as ds
from discostorm.cli import main
from discostorm.lookup import as_wifi
from discostorm.messages import HOPS
from discostorm_simulation.cell_setup import to_ticks
from discostorm_simulation.result import CAUSES
from discostorm_simulation.state import COLLISION, SUCCESS

SEDP = ds.DDS.messages[1]
FAST = "802.11ac 80 MHz 2x2, A-MPDU 64"
ENDLESS: dict[str, Any] = {"queue": None, "recovery": False}


def fleet_of(hall: int, yard: int, *wifi: str, processes: int = 2, endpoints: int = 5) -> ds.Fleet:
    """Return hosts in two cells, on the paper's channel or these."""
    names = {"hall": hall, "yard": yard}
    groups = [
        ds.HostGroup(hosts, processes, endpoints, name, shared=1, cell=name)
        for name, hosts in names.items()
    ]
    channels = wifi or ("paper", "paper")
    cells = [ds.Cell(name, own) for name, own in zip(names, channels, strict=True)]
    return ds.Fleet(tuple(groups), cells=tuple(cells))


@pytest.mark.parametrize("wifi", ["paper", FAST, "802.11a 20 MHz"])
@pytest.mark.parametrize("recovery", [False, True])
def test_one_cell_runs_as_the_fleet_without_cells(wifi: str, recovery: bool) -> None:
    group = ds.HostGroup(5, 2, 10)
    alone = ds.simulate(ds.Fleet((group,)), "Fast DDS", wifi, recovery=recovery, runs=2)
    fleet = ds.Fleet((replace(group, cell="hall"),), cells=(ds.Cell("hall", wifi),))
    found = ds.simulate(fleet, "Fast DDS", recovery=recovery, runs=2)
    assert replace(found, fleet=alone.fleet, wifi=alone.wifi) == alone


@pytest.mark.parametrize(("hall", "yard"), [(2, 1), (1, 1), (3, 2)])
@pytest.mark.parametrize("name", ["DDS", "Zenoh"])
def test_each_cell_carries_what_the_closed_form_counts(name: str, hall: int, yard: int) -> None:
    fleet, table = fleet_of(hall, yard), ds.PROTOCOLS[name]
    # One after the other, as a frame that collides seven times is lost.
    log = ds.simulate(fleet, table, start=np.arange(hall + yard), **ENDLESS).transmissions
    hosts = [0] * hall + [1] * yard
    for number, seen in enumerate(fleet.by_cell().values()):
        own_hosts = [host for host, of in enumerate(hosts) if of == number]
        check_frames(log, table, seen, own_hosts, hall + yard + number)


def check_frames(log: Any, table: ds.Protocol, seen: ds.Fleet, hosts: list[int], ap: int) -> None:
    """Compare the frames of each message and hop on the air with the closed form's."""
    for row, message in enumerate(table.messages):
        for hop in HOPS:
            stations = hosts if hop == "up" else [ap]
            own = log[np.isin(log["station"], stations) & (log["kind"] == row)]
            sent = own["outcome"] == SUCCESS
            if message.cast == "multicast" and hop == "down":
                sent |= own["outcome"] == COLLISION  # sent once, whether heard or not
            count = message.per_unit * message.wireless_unit(hop).count(seen)
            assert own["frames"][sent].sum() == count, (message.name, hop)


@pytest.mark.parametrize("counts", [(3, 1), (1, 2), (2, 2)])
@pytest.mark.parametrize("name", ["DDS", "Zenoh"])
def test_wired_hosts_use_the_air_as_the_closed_form_counts(
    name: str, counts: tuple[int, int]
) -> None:
    pairs = zip(counts, (False, True), strict=True)
    groups = (ds.HostGroup(n, 2, 5, shared=1, wired=wired) for n, wired in pairs)
    fleet, table, hosts = ds.Fleet(tuple(groups)), ds.PROTOCOLS[name], sum(counts)
    log = ds.simulate(fleet, table, start=np.arange(hosts), **ENDLESS).transmissions
    check_frames(log, table, fleet, [*range(counts[0])], hosts)


@pytest.mark.parametrize(
    "name", ["Fast DDS", "Cyclone DDS", "Zenoh peer", "Zenoh router", "Fast DDS Discovery Server"]
)
def test_a_fleet_with_wired_hosts_is_sooner_complete(name: str) -> None:
    robots, desk = ds.HostGroup(6, 2, 10, "robots"), ds.HostGroup(2, 2, 10, "desk")
    wired, all_on_air = (
        ds.simulate(ds.Fleet((robots, one)), name, FAST, runs=10, loss=0.05, until=60)
        for one in (replace(desk, wired=True), desk)
    )
    assert np.isfinite(wired.pair_times).all()
    assert np.median(wired.busy_time) < np.median(all_on_air.busy_time)
    assert np.median(wired.convergence_time) < np.median(all_on_air.convergence_time)


def test_the_wire_loses_nothing() -> None:
    fleet = ds.Fleet((ds.HostGroup(4, 2, 40, shared=1, wired=True),))
    found = ds.simulate(fleet, "Fast DDS", loss=0.3, queue=(20, 0.5), until=60, runs=3)
    assert (found.counts["arrived"] > 0).all()
    assert not found.lost.any()
    assert not found.counts["collisions"].any()


@pytest.mark.parametrize("queue", [None, (20, 0.01)])
def test_each_frame_arrives_in_its_cell_or_is_lost_for_a_reason(queue: Any) -> None:
    fleet = fleet_of(4, 3)
    found = ds.simulate(fleet, ds.DDS, queue=queue, recovery=False)
    # Two processes of each host announce themselves to the other hosts, the rest goes by unicast.
    unicast = sum(message.load(fleet) for message in ds.DDS.messages[1:])
    assert found.counts["expected"] == 14 * 6 + unicast
    lost = sum(found.counts[cause] for cause in CAUSES)
    assert found.counts["arrived"] + lost == found.counts["expected"]
    assert found.counts["waiting"] == 0
    assert (found.counts["ap_full"] > 0) == (queue is not None)


def test_a_frame_is_in_another_cell_when_it_has_come_up_and_no_sooner() -> None:
    row = replace(SEDP, answers=None)
    groups = (ds.HostGroup(1, 1, 40, cell="hall"), ds.HostGroup(1, 1, 0, cell="yard"))
    cells = (ds.Cell("hall", FAST), ds.Cell("yard", FAST))
    table = ds.Protocol("one way", (row,))
    log = ds.simulate(ds.Fleet(groups, cells=cells), table, block_ack="established", **ENDLESS)
    up, down = (log.transmissions[log.transmissions["station"] == one] for one in (0, 3))
    assert up["frames"].sum() == down["frames"].sum() == 40
    assert not (log.transmissions["station"] == 2).any()  # the hall's access point passes it on
    radio = as_wifi(FAST).radio
    assert radio is not None
    came = up["end"][0] - to_ticks(radio.sifs + radio.block_ack)  # before its acknowledgement
    # The other channel is idle, so that it goes on in the next slot.
    assert 0 <= down["start"][0] - came <= to_ticks(radio.slot)


def test_cells_send_at_once_and_stations_of_a_cell_in_turn() -> None:
    log = ds.simulate(fleet_of(4, 4), ds.DDS, recovery=False).transmissions
    cell = np.array([0] * 4 + [1] * 4 + [0, 1])[log["station"]]
    both = 0
    for number in (0, 1):
        own = log[(cell == number) & (log["outcome"] == SUCCESS)]
        own = np.sort(own, order="start")
        assert (own["start"][1:] >= own["end"][:-1]).all()
        other = log[(cell != number) & (log["outcome"] == SUCCESS)]
        both += sum(
            ((other["start"] < one["end"]) & (other["end"] > one["start"])).any() for one in own
        )
    assert both > len(log) / 2


@pytest.mark.parametrize(
    "name", ["Fast DDS", "Cyclone DDS", "Zenoh peer", "Fast DDS Discovery Server"]
)
@pytest.mark.parametrize("wifi", [("paper", "paper"), (FAST, "802.11a 20 MHz"), (FAST, FAST)])
def test_all_know_all_in_the_end(name: str, wifi: tuple[str, str]) -> None:
    found = ds.simulate(fleet_of(3, 2, *wifi), name, runs=2, loss=0.05)
    assert (found.convergence_time < 60).all()
    assert np.isfinite(found.pair_times).all()
    again = ds.simulate(fleet_of(3, 2, *wifi), name, runs=2, loss=0.05)
    assert again == found


def test_two_cells_carry_a_storm_sooner_than_one() -> None:
    two = fleet_of(8, 8, endpoints=10)
    one = ds.Fleet(tuple(replace(group, cell="") for group in two.groups))
    found, alone = (
        ds.simulate(fleet, ds.DDS, runs=3, **ENDLESS).drain_time for fleet in (two, one)
    )
    # Unicast takes one hop of two in each cell, or both within it: half of the air, as of two.
    assert np.median(found) == pytest.approx(np.median(alone) / 2, rel=0.2)


def test_user_data_reach_other_cells() -> None:
    groups = (
        ds.HostGroup(2, 1, 2, "robots", cell="hall", data=(ds.flows.flow("scan", "one host"),)),
        ds.HostGroup(1, 1, 2, "carts", cell="yard"),
    )
    fleet = ds.Fleet(groups, cells=(ds.Cell("hall", "paper"), ds.Cell("yard", "paper")))
    (scan,) = ds.simulate(fleet, "Fast DDS", recovery=False, until=5).data.values()
    assert scan["frames"] > 0
    assert scan["arrived"] > 0.9 * scan["frames"]


def test_cells_name_their_channels_themselves() -> None:
    fleet = fleet_of(1, 1)
    with pytest.raises(ValueError, match="wifi must be left out, as each cell names its own"):
        ds.simulate(fleet, ds.DDS, "802.11ac 80 MHz")
    desk = ds.Fleet((ds.HostGroup(1, 1, 2), ds.HostGroup(1, 1, 2, wired=True)))
    for one in (fleet, desk):
        with pytest.raises(ValueError, match="power must be left out with cells or wired hosts"):
            ds.simulate(one, ds.DDS, power=np.zeros((3, 3)))
    found = ds.simulate(fleet, ds.DDS)
    told = found.to_dict()
    assert [cell["name"] for cell in told["cells"]] == ["hall", "yard"]
    assert told["cells"][0]["radio"]["standard"] == "802.11n"
    assert "wifi" not in told
    assert "on hall, yard" in repr(found)


def test_the_command_simulates_cells(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    cells = "".join(f'[[cells]]\nname = "{n}"\nwifi = "paper"\n' for n in ("hall", "yard"))
    rest = "hosts = 2\nprocesses = 1\nendpoints = 3\n"
    file.write_text(cells + "".join(f'[[groups]]\n{rest}cell = "{n}"\n' for n in ("hall", "yard")))
    result = CliRunner().invoke(main, ["simulate", str(file), "--runs", "2"])
    assert result.exit_code == 0, result.output
    assert 'Channels: paper (802.11n) in "hall"; paper (802.11n) in "yard".' in result.output
    result = CliRunner().invoke(main, ["simulate", str(file), "--json"])
    assert len(json.loads(result.output)["cells"]) == 2
    result = CliRunner().invoke(main, ["simulate", str(file), "--csv"])
    assert "Channels:" not in result.output
    result = CliRunner().invoke(main, ["simulate", str(file), "--no-recovery"])
    assert result.output.startswith("Drain time: ")
