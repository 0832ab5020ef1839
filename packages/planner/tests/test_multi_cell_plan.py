"""Plans of fleets with several access points: one discovery time, and the airtime of each cell."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import discostorm as ds
from discostorm.cli.main import main
from discostorm_planner.multi_cell_plan import plan_cells

CELLS = """
[[cells]]
name = "hall"
wifi = "802.11ac 80 MHz"
[[cells]]
name = "yard"
wifi = "802.11a 20 MHz"
"""
GROUPS = """
[[groups]]
name = "robots"
hosts = 2
processes = 1
endpoints = 6
cell = "hall"
[[groups]]
name = "carts"
hosts = 1
processes = 1
endpoints = 6
cell = "yard"
"""


def run(tmp_path: Path, text: str, *options: str) -> Result:
    file = tmp_path / "fleet.toml"
    file.write_text(text)
    return CliRunner().invoke(main, ["plan", str(file), *options])


def test_a_plan_tells_the_discovery_time_and_the_airtime_of_each_cell(tmp_path: Path) -> None:
    result = run(tmp_path, CELLS + GROUPS)
    assert result.exit_code == 0, result.output
    said = " ".join(result.output.split())
    assert said.startswith("Yes, this startup works: 2 robots and 1 carts discover each other")
    where = 'on 802.11ac 80 MHz 2x2 in "hall" and 802.11a 20 MHz 1x1 in "yard"'
    assert f"(Fast DDS 3.6, {where})" in said
    assert "Cells do not interfere" in said
    assert "one access point" not in said
    assert "If one robot reboots, all others have rediscovered it" in said
    told = json.loads(run(tmp_path, CELLS + GROUPS, "--json").output)
    fleet = ds.Fleet.from_bytes((CELLS + GROUPS).encode(), "fleet.toml")
    needed = ds.cell_utilization("Fast DDS", fleet)
    shares = {cell: row["one_frame"] for cell, row in told["cells"].items()}
    assert shares == pytest.approx(needed)
    assert told["cells"]["hall"]["full_ampdus"] < needed["hall"]
    assert told["discovery"]["works"] is True
    # The simulated radios aggregate, as plans of one channel take it.
    full = ds.Cell("hall", "802.11ac 80 MHz, A-MPDU 64")
    aggregated = ds.Fleet(fleet.groups, cells=(full, fleet.cells[1]))
    found = ds.simulate(aggregated, "Fast DDS", runs=10, until=60, give_up=20)
    assert told["discovery"]["today"]["times_s"] == sorted(found.convergence_time.tolist())
    rows = run(tmp_path, CELLS + GROUPS, "--csv", "--protocol", "paper").output.splitlines()
    assert rows[0].startswith("protocol,cell,")
    assert len(rows) == 5


def test_wired_hosts_beside_cells_use_no_cell(tmp_path: Path) -> None:
    desk = "[[groups]]\nname = 'desk'\nhosts = 1\nprocesses = 1\nendpoints = 30\n"
    wired, in_hall = (
        json.loads(run(tmp_path, CELLS + GROUPS + desk + how, "--json").output)
        for how in ("wired = true\n", "cell = 'hall'\n")
    )
    medians = [told["discovery"]["today"]["median_s"] for told in (wired, in_hall)]
    assert medians[0] < medians[1]
    said = " ".join(run(tmp_path, CELLS + GROUPS + desk + "wired = true\n").output.split())
    assert '- Cell "hall": the startup needs at least' in said


def test_changes_of_hosts_and_middleware_are_compared_for_all_cells(tmp_path: Path) -> None:
    text = CELLS + GROUPS.replace("hosts = 2", "hosts = 8").replace(
        "processes = 1", "processes = 3"
    )
    fleet = ds.Fleet.from_bytes(text.encode(), "fleet.toml")
    plan = plan_cells(fleet, "Fast DDS", within=2)
    assert not plan.discovery.works
    kinds = {change.remedy.kind for change in plan.discovery.changes if change.time}
    assert {"processes", "announcements", "staggered start"} <= kinds
    assert not kinds & {"radio", "channels", "domains", "multicast rate"}
    (composed,) = (c for c in plan.discovery.changes if c.remedy.kind == "processes")
    (whole,) = composed.remedy.fleets
    assert [group.cell for group in whole.groups] == ["hall", "yard"]
    found = ds.simulate(whole, plan.protocol, runs=10, until=60, give_up=20)
    assert composed.time is not None
    assert composed.time.times == tuple(sorted(found.convergence_time.tolist()))
    pasted = run(tmp_path, text, "--paste", "processes")
    assert pasted.stdout.count("# Fill in PACKAGE") == 2
    why = " ".join(run(tmp_path, text, "--why", "--within", "2").stdout.split())
    assert "Changes, in the same order as above: 1. " in why


def test_one_cell_is_planned_as_the_fleet_without(tmp_path: Path) -> None:
    one = CELLS[: CELLS.rindex("[[cells]]")] + GROUPS.replace("yard", "hall")
    alone = GROUPS.replace('cell = "hall"', "").replace('cell = "yard"', "")
    planned = run(tmp_path, alone, "--wifi", "802.11ac 80 MHz", "--csv").output
    assert run(tmp_path, one, "--csv").output == planned
    assert "Discovery Server" in planned


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("--wifi", "paper"), "--wifi cannot be combined with [[cells]]"),
        (("--paste", "radio"), "--paste: no change is named 'radio'"),
    ],
)
def test_what_plans_of_cells_do_not_have(
    tmp_path: Path, options: tuple[str, ...], told: str
) -> None:
    result = run(tmp_path, CELLS + GROUPS, *options)
    assert result.exit_code == 2
    assert told in " ".join(result.output.split())


def test_in_python_a_plan_is_of_one_channel() -> None:
    fleet = ds.Fleet.from_bytes((CELLS + GROUPS).encode(), "fleet.toml")
    with pytest.raises(ValueError, match="as the explanations cover one access point"):
        ds.plan(fleet, "Fast DDS")
