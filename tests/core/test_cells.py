"""Several access points: each cell counts its own hops, and the hosts elsewhere are on the wire."""

import itertools
import json
import pickle
import re
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

import discostorm as ds
from discostorm.cli.main import main
from discostorm.messages import HOPS

HALL, YARD = ds.Cell("hall", "802.11ac 80 MHz", channel=36), ds.Cell("yard", "paper")
ROBOTS = ds.HostGroup(3, 2, 10, "robots", shared=2, cell="hall")
CARTS = ds.HostGroup(2, 1, 4, "carts", shared=1, cell="yard")
FILE = """
[[cells]]
name = "hall"
wifi = "802.11ac 80 MHz"
channel = 36
[[cells]]
name = "yard"
wifi = "paper"
channel = 100
[[groups]]
name = "robots"
hosts = 3
processes = 2
endpoints = 10
cell = "hall"
[[groups]]
name = "carts"
hosts = 2
processes = 1
endpoints = 4
cell = "yard"
[[groups]]
name = "server"
hosts = 1
processes = 1
endpoints = 3
wired = true
"""


def two_and_one() -> ds.Fleet:
    hosts = [ds.HostGroup(number, 1, 5, cell=cell) for number, cell in ((2, "hall"), (1, "yard"))]
    return ds.Fleet(tuple(hosts), cells=(ds.Cell("hall", "paper"), ds.Cell("yard", "paper")))


def test_two_hosts_and_one_by_hand() -> None:
    """The paper's DDS, one process of five endpoints on each of three hosts."""
    up, down = (
        {m.name: float(m.airtime_of(hop).subs(ds.DDS.values() | ds.PAPER.values())) for m in rows}
        for hop, rows in zip(HOPS, itertools.repeat(ds.DDS.messages), strict=False)
    )
    # Each hop's messages: SPDP is multicast, one for each of the three processes goes down in both
    # cells. SEDP has one for each endpoint and remote process, the others two and two for a pair.
    per_pair = {"SEDP": 5, "Heartbeat": 2, "ACKNACK": 2}
    hall = 2 * up["SPDP"] + 3 * down["SPDP"]
    yard = 1 * up["SPDP"] + 3 * down["SPDP"]
    for name, each in per_pair.items():
        # Two hosts in the hall send to two others each; each is sent to by two others.
        hall += 4 * each * up[name] + 4 * each * down[name]
        yard += 2 * each * up[name] + 2 * each * down[name]
    found = ds.cell_utilization(ds.DDS, two_and_one())
    assert found == pytest.approx({"hall": hall, "yard": yard}, rel=1e-12)


@pytest.mark.parametrize("table", ds.PROTOCOLS.values(), ids=list(ds.PROTOCOLS))
def test_one_cell_is_the_fleet_without_cells(table: ds.Protocol) -> None:
    groups = (ROBOTS, replace(CARTS, cell="hall"), ds.HostGroup(1, 1, 3, wired=True))
    for some in (groups[:1], groups[:2], groups):
        fleet = ds.Fleet(some, matching=0.5, cells=(HALL,))
        alone = ds.Fleet(tuple(replace(group, cell="") for group in some), matching=0.5)
        for phase, window in ((None, 1.0), (None, float("inf")), ("data", 1.0)):
            expected = ds.utilization(table, alone, wifi=HALL.wifi, phase=phase, window=window)
            assert ds.cell_utilization(table, fleet, phase, window) == {"hall": expected}


@pytest.mark.parametrize("table", ds.PROTOCOLS.values(), ids=list(ds.PROTOCOLS))
def test_what_goes_up_in_one_cell_comes_down_in_another(table: ds.Protocol) -> None:
    """On one kind of channel, unicast takes as much in two cells as in one; multicast more."""
    cells = (ds.Cell("hall", "paper"), ds.Cell("yard", "paper"))
    fleet = ds.Fleet((ROBOTS, CARTS), matching=0.5, cells=cells)
    alone = ds.Fleet(tuple(replace(group, cell="") for group in fleet.groups), matching=0.5)
    parts = [
        ds.breakdown(table, seen).assign(cell=cell.name) for cell, seen in fleet.by_cell().items()
    ]
    one = ds.breakdown(table, alone)
    for message in table.messages:
        down = [float(part.loc[message.name, "downlink_s"]) for part in parts]
        up = sum(float(part.loc[message.name, "uplink_s"]) for part in parts)
        assert up == pytest.approx(one.loc[message.name, "uplink_s"]), message
        whole = float(one.loc[message.name, "downlink_s"])
        if len(message.hops) == 2 and not (message.cast == "unicast" and message.unit.to_each):
            assert down == pytest.approx([whole, whole]), message
        else:
            assert sum(down) == pytest.approx(whole), message


def test_a_cell_sees_the_hosts_of_others_on_the_wire() -> None:
    fleet = ds.Fleet((ROBOTS, CARTS), cells=(HALL, YARD))
    seen = fleet.by_cell()
    assert [*seen] == [HALL, YARD]
    assert [group.wired for group in seen[YARD].groups] == [True, False]
    expected = ds.utilization("Fast DDS", seen[YARD], wifi="paper")
    assert ds.cell_utilization("Fast DDS", fleet)["yard"] == expected
    assert pickle.loads(pickle.dumps(fleet)) == fleet != replace(fleet, cells=(YARD, HALL))
    assert fleet.to_dicts()[0]["cell"] == "hall"
    assert "cells=<hall, yard>" in repr(fleet)
    assert "cell='yard'" in repr(CARTS)


def test_data_for_another_cell_are_on_one_hop_there() -> None:
    scan = ds.flows.flow("scan", "one host")
    robots = ds.HostGroup(1, 1, 5, "robot", data=(scan,), cell="hall")
    fleet = ds.Fleet((robots, ds.HostGroup(1, 1, 5, cell="yard")), cells=(HALL, YARD))
    both = ds.cell_utilization("Fast DDS", fleet, phase="data")
    whole = ds.utilization(
        "Fast DDS",
        ds.Fleet(tuple(replace(group, cell="") for group in fleet.groups)),
        wifi="paper",
        phase="data",
    )
    assert both["yard"] == pytest.approx(whole / 2)
    assert 0 < both["hall"] < both["yard"]  # a faster radio


def test_what_counts_one_channel_refuses_cells() -> None:
    fleet = ds.Fleet((ROBOTS, CARTS), cells=(HALL, YARD))
    calls = (
        lambda: ds.utilization(ds.DDS, fleet),
        lambda: ds.breakdown(ds.DDS, fleet),
        lambda: ds.drain_time(ds.DDS, fleet),
        lambda: ds.bounds(ds.DDS, fleet),
        lambda: ds.saturation_hosts(ds.DDS, fleet=fleet),
        lambda: ds.DDS.utilization(fleet=fleet),
        lambda: ds.DDS.burst(fleet=fleet),
    )
    for call in calls:
        with pytest.raises(ValueError, match=r"no cells here.*got hall and yard.*cell_utilization"):
            call()
    with pytest.raises(ValueError, match="fleet must have cells"):
        ds.cell_utilization(ds.DDS, ds.Fleet.swarm(2, 1, 1))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (
            "channel = 100",
            "channel = 36",
            "hall (channel 36) and yard (channel 36) share airtime: make",
        ),
        (
            'cell = "yard"',
            'cell = "yrad"',
            "cell of carts must be 'hall' or 'yard'; got 'yrad'. Did",
        ),
        ('cell = "yard"', "", "cell of carts must be 'hall' or 'yard'; got none"),
        (
            'cell = "yard"',
            'cell = "hall"',
            "cell 'yard' must be used by a group; no group names it",
        ),
        (
            "wired = true",
            'wired = true\ncell = "hall"',
            "cell must be left out of server, which is",
        ),
        ('wifi = "paper"', 'wifi = "802.11ax 80 GHz"', "cell 'yard': wifi must be 'paper', "),
        ('wifi = "paper"', "", "cell 2 (yard): wifi must be a text; got None"),
        (
            'wifi = "paper"',
            'wifi = "paper"\nband = 5',
            "cell 2 (yard): unknown key band = 5. Valid keys are name, wifi",
        ),
        ('name = "yard"', 'name = " "', "name must be a non-blank string"),
        ('name = "yard"', 'name = "hall"', "cells must have distinct names; got 'hall' twice"),
        ("channel = 100", "channel = 0.5", "cell 'yard': channel must be a whole number"),
        ("channel = 100", "channel = 234", "cell 'yard': channel must be a whole number"),
        ('cell = "yard"', "cell = 2", "group 2 (carts): cell must be the name of a cell; got 2"),
        (
            FILE[: FILE.index("[[groups")],
            "",
            "cell must be left out of robots, or defined in a [[cells]] table",
        ),
        (FILE[: FILE.index("[[groups")], "cells = []\n", "cells must be tables [[cells]]; got []"),
        (FILE[: FILE.index("[[groups")], "cells = [1]\n", "it must be a table with name and wifi"),
    ],
)
def test_files_that_are_refused(old: str, new: str, told: str) -> None:
    assert old in FILE
    with pytest.raises(ValueError, match=r"^a\.toml: ") as error:
        ds.Fleet.from_bytes(FILE.replace(old, new).encode(), "a.toml")
    assert told in str(error.value)


@pytest.mark.parametrize(
    ("one", "other", "wifi", "overlap"),
    [
        (36, 40, "802.11ac 80 MHz", True),
        (36, 48, "802.11ac 80 MHz", True),
        (48, 52, "802.11ac 80 MHz", False),
        (48, 52, "802.11ax 160 MHz", True),
        (36, 40, "802.11n 40 MHz", True),
        (40, 44, "802.11n 40 MHz", False),
        (36, 40, "802.11n 20 MHz", False),
        (144, 149, "802.11ac 80 MHz", False),
        (149, 161, "802.11ac 80 MHz", True),
        (1, 5, "802.11n 20 MHz", True),
        (1, 6, "802.11n 20 MHz", False),
        (9, 13, "802.11n 20 MHz", True),
        (13, 14, "802.11n 20 MHz", True),
        (1, 6, "802.11n 40 MHz", True),  # the first also takes 5, the other 2 or 10
        (3, 11, "802.11n 40 MHz", True),  # the first also takes 7, the other also 7
        (5, 9, ds.Radio("802.11be", width=320e6).wifi(), True),  # 6 GHz
        (1, 5, ds.Radio("802.11be", width=20e6, band=6e9).wifi(), False),
    ],
)
def test_cells_whose_channels_overlap_are_refused(
    one: int, other: int, wifi: ds.Wifi | str, overlap: bool
) -> None:
    cells = ds.Cell("hall", wifi, channel=one), ds.Cell("yard", wifi, channel=other)
    if not overlap:
        ds.Fleet((ROBOTS, CARTS), cells=cells)
        return
    told = f"hall (channel {one}) and yard (channel {other}) share airtime: make them one cell"
    with pytest.raises(ValueError, match=re.escape(told)):
        ds.Fleet((ROBOTS, CARTS), cells=cells)


@pytest.mark.parametrize(
    ("wide", "narrow", "overlap"),
    [
        (1, 9, True),  # 1 has nothing below, so 40 MHz are 1 and 5
        (1, 10, False),
        (13, 5, True),  # 13 has nothing above, so 40 MHz are 13 and 9
        (13, 4, False),
        (7, 1, True),  # 7 has both, and the file does not say which
        (7, 13, True),
    ],
)
def test_40_mhz_in_2_4_ghz_take_the_numbers_above_or_below(
    wide: int, narrow: int, overlap: bool
) -> None:
    cells = (
        ds.Cell("hall", "802.11n 40 MHz", channel=wide),
        ds.Cell("yard", "802.11n 20 MHz", channel=narrow),
    )
    if not overlap:
        ds.Fleet((ROBOTS, CARTS), cells=cells)
        return
    with pytest.raises(ValueError, match="share airtime: make them one cell"):
        ds.Fleet((ROBOTS, CARTS), cells=cells)


def run(tmp_path: Path, *arguments: str) -> str:
    (tmp_path / "fleet.toml").write_text(FILE)
    command, *options = arguments
    result = CliRunner().invoke(main, [command, str(tmp_path / "fleet.toml"), *options])
    assert result.exit_code == (2 if "Error" in result.output else 0), result.output
    return result.output


def test_commands_give_a_row_for_each_cell(tmp_path: Path) -> None:
    fleet = ds.Fleet.from_bytes(FILE.encode(), "fleet.toml")
    needed = ds.cell_utilization("Fast DDS", fleet)
    rows = json.loads(run(tmp_path, "utilization", "--json"))
    assert {row["cell"]: row["utilization"] for row in rows} == pytest.approx(needed)
    parts = json.loads(run(tmp_path, "breakdown", "--json"))
    for cell, total in needed.items():
        own = [row for row in parts if row["cell"] == cell]
        assert sum(row["uplink_s"] + row["downlink_s"] for row in own) == pytest.approx(total)
    told = run(tmp_path, "breakdown")
    shown = 'Channels: 802.11ac 80 MHz 2x2 in "hall"; paper (802.11n) in "yard".'
    assert shown in told.replace("\n", " ")
    assert "hall" in run(tmp_path, "utilization")


def test_a_group_fills_its_own_cell_and_the_others(tmp_path: Path) -> None:
    found = json.loads(run(tmp_path, "saturation", "--json", "--protocol", "cyclonedds"))
    assert [(row["group"], row["cell"]) for row in found] == [
        (group, cell) for group in ("robots", "carts", "server") for cell in ("hall", "yard")
    ]
    fleet = ds.Fleet.from_bytes(FILE.encode(), "fleet.toml")
    row = next(row for row in found if (row["group"], row["cell"]) == ("robots", "yard"))
    groups = (replace(fleet.groups[0], hosts=row["hosts"]), *fleet.groups[1:])
    needed = ds.cell_utilization("Cyclone DDS", replace(fleet, groups=groups))
    assert needed["yard"] == pytest.approx(1)


def test_of_what_does_not_reach_another_cell_any_number_of_hosts_fits() -> None:
    groups = (ds.HostGroup(2, 1, 5, cell="hall"), ds.HostGroup(2, 1, 5, cell="yard"))
    fleet = ds.Fleet(groups, cells=(HALL, YARD))
    table = ds.PROTOCOLS["Fast DDS Discovery Server"]
    assert ds.saturation_hosts(table, fleet=fleet.by_cell()[YARD], group=0) == float("inf")


@pytest.mark.parametrize("option", [("--wifi", "paper"), ("--multicast-rate", "12")])
@pytest.mark.parametrize("command", ["utilization", "breakdown", "saturation"])
def test_a_channel_beside_cells_is_refused(
    tmp_path: Path, command: str, option: tuple[str, str]
) -> None:
    told = run(tmp_path, command, *option)
    assert "--wifi cannot be combined with [[cells]]: each cell names its own" in told


def test_beside_goes_without_cells(tmp_path: Path) -> None:
    file = str(tmp_path / "fleet.toml")
    told = run(tmp_path, "saturation", "--beside", file)
    assert "--beside cannot be combined with [[cells]]" in told
