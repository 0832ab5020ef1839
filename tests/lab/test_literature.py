"""Test the computed columns of the table of published numbers."""

import csv
import math
from collections import Counter
from statistics import median

import lab_data
import numpy as np
import pytest
from literature import summary_rows
from run_grid import GRIDS

import discostorm as ds
from discostorm.data import read_data
from discostorm_book import comparison, published_numbers

ROWS = {row["id"]: row for row in read_data("vendors/published.csv", "discostorm_book")}


def test_the_papers_count_by_hand() -> None:
    found = published_numbers.published_with_counts()["paper"]
    # 52 processes as hosts of their own, of 18 endpoints: SPDP, SEDP, and four of control a pair.
    assert found["ros-simple"] == 52 + 52 * 51 * (18 + 4)
    # Three processes on each of two hosts: 98 endpoints in all on one, 84 on the other.
    pairs, endpoint_pairs = 2 * 3 * 3, 3 * (98 + 84)
    assert found["turtlebot-dds-packets"] == pytest.approx(6 + endpoint_pairs + 4 * pairs)
    # Payloads of Table II, with 42 bytes around each.
    spdp, sedp, heartbeat, acknack = 350 + 42, 400 + 42, 52 + 42, 50 + 42
    assert found["turtlebot-dds-bytes"] == pytest.approx(
        6 * spdp + endpoint_pairs * sedp + 2 * pairs * (heartbeat + acknack)
    )
    # Declarations, and two KeepAlives from each bridge to the other.
    assert found["turtlebot-zenoh-packets"] == 98 + 84 + 2 * 2
    assert found["turtlebot-zenoh-bytes"] == (98 + 84) * (100 + 66) + 4 * (8 + 66)


@pytest.mark.parametrize(
    ("name", "table"),
    [("ros-simple", "Fast DDS"), ("turtlebot-zenoh-packets", "Zenoh peer")],
)
def test_the_tables_as_built_expect_what_they_do_elsewhere(name: str, table: str) -> None:
    row = ROWS[name]
    groups = tuple(ds.HostGroup(*map(int, part.split("x"))) for part in row["fleet"].split())
    fleet = ds.Fleet(groups, matching=1.0)
    protocol = ds.PROTOCOLS[table]
    in_startup = sum(
        comparison.expected_count(message, fleet, "startup")
        for message in protocol.messages
        if message.phase in row["counted"].split()
    )
    assert published_numbers._number_by_model(protocol, row | {"window_s": "12"}) == pytest.approx(
        in_startup
    )
    assert published_numbers.published_with_counts()["as_built"][
        name
    ] == published_numbers._number_by_model(protocol, row)


def test_what_cannot_be_computed_is_left_out_and_every_difference_has_a_reason() -> None:
    table = published_numbers.published_with_counts()
    assert list(table.index) == list(ROWS)
    for name, row in table.iterrows():
        assert row["why"], name
        assert row["here"], name
        assert row["read"].startswith(("at the source", "the abstract at the source")), name
        assert math.isnan(row["paper"]) == math.isnan(row["as_built"]) == (not row["fleet"]), name
    assert table.loc[["turtlebot-dds-packets", "turtlebot-dds-bytes"], "number"].tolist() == [
        686,
        251_576,
    ]
    # As printed there: the average size of a packet, to a hundredth of a byte.
    for start, average in (("dds", 366.73), ("zenoh", 213.45), ("zenoh-warm", 276.41)):
        packets, size = (table["number"][f"turtlebot-{start}-{of}"] for of in ("packets", "bytes"))
        assert np.isclose(size / packets, average, atol=0.01)


def test_the_paper_and_zettascale_agree_on_what_sedp_grows_with() -> None:
    """Their formula: n participants of r readers and w writers send n (n - 1) (r + w)."""
    for n, readers, writers in ((2, 3, 4), (7, 10, 10), (52, 9, 9)):
        sedp = ds.DDS.message("SEDP").load(ds.Fleet.swarm(n, 1, readers + writers))
        assert sedp == n * (n - 1) * (readers + writers)


def staging_rows() -> list[dict[str, str]]:
    with (GRIDS / "literature.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def test_each_staging_was_run_as_often_as_it_says_and_each_capture_is_its_own() -> None:
    runs = {(row["staging"], row["run"]): row for row in lab_data.read_lab_table("literature.csv")}
    wanted = {row["staging"]: int(row["runs"]) for row in staging_rows()}
    assert Counter(staging for staging, _ in runs) == wanted
    assert min(wanted.values()) >= 5
    assert len({row["sha256"] for row in runs.values()}) == len(runs)
    for row in staging_rows():
        mine = runs[row["staging"], "1"]
        assert all(mine[name] == row[name] for name in ("product", "variant", "spacing_s"))
        assert float(mine["seconds"]) == float(row["seconds"])


def test_the_books_table_is_what_the_runs_say() -> None:
    rows = summary_rows(lab_data.read_lab_table("literature.csv"), GRIDS / "literature.csv")
    made = [{key: str(value) for key, value in row.items()} for row in rows]
    assert made == read_data("measured/staged.csv", "discostorm_book")
    assert set(published_numbers.staged_counts_table()["staged"]) == {
        row["title"] for row in staging_rows()
    }


def test_what_was_counted_of_a_run_fits_together() -> None:
    runs: dict[tuple[str, str], dict[str, tuple[int, int]]] = {}
    for row in lab_data.read_lab_table("literature.csv"):
        kinds = runs.setdefault((row["staging"], row["run"]), {})
        assert row["kind"] not in kinds
        kinds[row["kind"]] = int(row["count"]), int(row["bytes"])
    for kinds in runs.values():
        packets, octets = kinds.pop("packets")
        kinds.pop("packets of data", None)
        assert 0 < packets <= sum(count for count, _ in kinds.values())
        # Ethernet, IPv4 and UDP around each, or TCP with its timestamps.
        assert octets >= sum(size for _, size in kinds.values()) + 42 * packets


def test_the_programs_of_the_turtlebot_have_the_endpoints_that_the_model_is_given() -> None:
    """A node has 15, a participant 2, a service and a client 2 each; counted line by line."""
    with (GRIDS / "literature_endpoints.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    each = {"node": 15, "service": 2, "client": 2, "writer": 1, "reader": 1}
    ends = Counter({row["program"]: 2 for row in rows})
    for row in rows:
        assert row["source"]
        ends[row["program"]] += each[row["what"]]
    assert ends["talker"] == ends["listener"] == 18
    (shown,) = (row for row in staging_rows() if row["staging"] == "turtlebot-fast_dds")
    hosts = [host.split() for host in shown["programs"].split(" / ")]
    made = [f"1x{len(some)}x{sum(ends[one] for one in some)}/{len(some)}" for some in hosts]
    assert ROWS["turtlebot-dds-packets"]["fleet"] == " ".join(made)


def test_every_number_stands_beside_the_median_of_the_staging_that_its_row_names() -> None:
    table = published_numbers.published_with_counts()
    rows = lab_data.read_lab_table("literature.csv")
    for name, row in table.iterrows():
        some = row["staged"].split()
        assert set(some) <= {staging["staging"] for staging in staging_rows()}, name
        of = [one for one in rows if (one["staging"], one["kind"]) == (some[0], "packets")]
        unit = {"packets": "count", "bytes": "bytes"}[row["quantity"]]
        assert row["measured"] == median(int(one[unit]) for one in of)
        assert row["least"] <= row["measured"] <= row["most"]
    # As two users found, and not as the documentation has it.
    assert table["measured"]["ros-server"] > 2 * table["measured"]["ros-simple"]
    assert table["number"]["ros-server"] < 0.5 * table["number"]["ros-simple"]
    # Without shared memory more is seen of the same.
    lab = published_numbers.staged_counts()["count"]
    assert lab["ros-few-udp", "packets"] > 10 * lab["ros-few", "packets"]
