"""Test the lab's counts: consistent tables, and numbers that the vendors' sources fix."""

import csv
from collections import Counter

import pytest
from run_grid import GRIDS

from discostorm.data import read_data

RUNS = {row["run"]: row for row in read_data("measured/runs.csv", "discostorm_book")}
CountKey = tuple[str, str, str, bool]
COUNTS: Counter[CountKey] = Counter()
for _row in read_data("measured/counts.csv", "discostorm_book"):
    COUNTS[_row["run"], _row["window"], _row["kind"], _row["multicast"] == "1"] += int(
        _row["messages"]
    )
KINDS = {(row["kind"], row["about"]) for row in read_data("measured/counts.csv", "discostorm_book")}


def runs_of(product: str, variant: str = "") -> list[dict[str, str]]:
    found = [
        row
        for row in RUNS.values()
        if row["product"].startswith(product) and variant in ("", row["variant"])
    ]
    assert found
    return found


def processes(run: dict[str, str]) -> int:
    return int(run["hosts"]) * int(run["processes"])


def pairs(run: dict[str, str]) -> int:
    """Ordered pairs of processes on different hosts, counted one by one."""
    hosts = [host for host in range(int(run["hosts"])) for _ in range(int(run["processes"]))]
    return sum(one != other for one in hosts for other in hosts)


def count(run: dict[str, str], window: str, kind: str, multicast: bool) -> int:
    return COUNTS[run["run"], window, kind, multicast]


def test_every_count_has_its_run_and_every_run_its_counts() -> None:
    assert {run for run, *_ in COUNTS} == set(RUNS)
    assert all(count > 0 for count in COUNTS.values())
    assert len({row["sha256"] for row in RUNS.values()}) == len(RUNS)


def test_every_point_was_run_as_often_as_the_grid_says() -> None:
    shape = ("hosts", "processes", "endpoints", "names", "use")
    with (GRIDS / "grid.csv").open(newline="") as file:
        grid = {
            tuple(row[name] for name in shape): int(row["runs"]) for row in csv.DictReader(file)
        }
    products = {(row["product"], row["variant"]) for row in RUNS.values()}
    assert len(products) == 8
    for product in products:
        mine = [row for row in RUNS.values() if (row["product"], row["variant"]) == product]
        assert Counter(tuple(row[name] for name in shape) for row in mine) == grid


def test_every_configuration_was_run_as_often_as_its_grid_says() -> None:
    shape = ("hosts", "processes", "endpoints", "names", "use")
    with (GRIDS / "mitigations.csv").open(newline="") as file:
        grid = {
            (row["configuration"], *(row[name] for name in shape)): int(row["runs"])
            for row in csv.DictReader(file)
        }
    rows = read_data("measured/mitigation_runs.csv", "discostorm_book")
    assert grid == Counter(
        (f"{row['product']}-{row['variant']}", *(row[name] for name in shape)) for row in rows
    )
    assert len({row["run"] for row in rows}) == len(rows)
    assert all(row["sha256"].startswith(row["run"]) for row in rows)
    assert {
        row["run"] for row in read_data("measured/mitigation_counts.csv", "discostorm_book")
    } == {row["run"] for row in rows}


def test_no_process_began_late_and_all_had_their_endpoints_within_the_first_seconds() -> None:
    assert all(0 <= float(row["start_skew_s"]) < 0.25 for row in RUNS.values())
    assert all(float(row["endpoints_created_s"]) < 4 for row in RUNS.values())


def test_nobody_sends_user_data_or_closes_a_session() -> None:
    assert not {kind for kind, _ in KINDS} & {"User data", "Close", "Push", "Encrypted"}


def test_fast_dds_announces_every_three_seconds_to_the_group_and_to_everyone_known() -> None:
    for run in runs_of("fast_dds"):
        assert count(run, "steady", "SPDP", True) == 8 * processes(run)
        assert count(run, "steady", "SPDP", False) == 8 * pairs(run)


def test_fast_dds_announces_once_more_for_everyone_it_discovers() -> None:
    """At once, five times 0.1 s apart, at 3.5, 6.5 and 9.5 s, and for each of the others."""
    for run in runs_of("fast_dds"):
        everyone = processes(run)
        assert count(run, "startup", "SPDP", True) == everyone * (9 + everyone - 1)


@pytest.mark.parametrize("product", ["fast_dds", "cyclone_dds"])
def test_every_endpoint_is_announced_to_every_remote_process(product: str) -> None:
    """At least once: what is unicast, and what a multicast brings to all but the sender."""
    for run in runs_of(product):
        sent = count(run, "startup", "SEDP", False)
        sent += count(run, "startup", "SEDP", True) * (processes(run) - 1)
        assert sent >= pairs(run) * int(run["endpoints"])
        assert count(run, "steady", "SEDP", False) == count(run, "steady", "SEDP", True) == 0


def test_cyclone_dds_announces_every_eight_seconds() -> None:
    for run in runs_of("cyclone_dds"):
        for window in ("startup", "steady"):
            assert count(run, window, "SPDP", True) == 3 * processes(run)
        beyond_the_group = run["variant"] == "spdp"
        assert count(run, "steady", "SPDP", False) == 3 * pairs(run) * beyond_the_group


def test_cyclone_dds_asserts_liveliness_to_each_or_to_the_group() -> None:
    for run in runs_of("cyclone_dds"):
        alone = run["variant"] == "spdp" or processes(run) == 2
        together = not alone and pairs(run) > 0
        assert count(run, "steady", "Liveliness", False) == 3 * pairs(run) * alone
        assert count(run, "steady", "Liveliness", True) == 3 * processes(run) * together
        assert count(run, "steady", "Liveliness ACKNACK", False) == 3 * pairs(run)


def test_cyclone_dds_sends_a_heartbeat_with_each_and_again_if_the_answer_is_late() -> None:
    """It was once: in a run of twelve processes, which two cores have to share."""
    late = []
    for run in runs_of("cyclone_dds"):
        for cast in (False, True):
            sent = count(run, "steady", "Liveliness Heartbeat", cast)
            needed = count(run, "steady", "Liveliness", cast)
            assert needed <= sent <= 1.05 * needed
            if sent > needed:
                late.append(processes(run))
    assert late == [12]


def test_a_zenoh_peer_scouts_for_ever_and_each_scout_is_answered() -> None:
    """At 0, 1, 3, 7, 15, 23 and 31 s; the first ones meet peers that do not listen yet."""
    for run in runs_of("zenoh"):
        assert count(run, "startup", "Scout", True) == 4 * processes(run)
        assert count(run, "steady", "Scout", True) == 3 * processes(run)
        assert count(run, "steady", "Hello", False) == 3 * pairs(run)
        assert 3 * pairs(run) <= count(run, "startup", "Hello", False) <= 4 * pairs(run)


def test_zenoh_declares_subscribers_and_tokens_but_no_publishers() -> None:
    for run in runs_of("zenoh"):
        tokens = (int(run["endpoints"]) + 1) * (run["variant"] == "tokens")
        expected = pairs(run) * (int(run["endpoints"]) // 2 + tokens)
        assert count(run, "startup", "Declare", False) == expected


def test_two_zenoh_peers_have_one_connection_or_two() -> None:
    for run in runs_of("zenoh"):
        assert pairs(run) <= count(run, "startup", "Init", False) <= 2 * pairs(run)
        assert count(run, "startup", "Open", False) == count(run, "startup", "Init", False)
