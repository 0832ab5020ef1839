"""What others published, beside the model: the columns that are computed."""

import math

import numpy as np
import pytest

import discostorm as ds
from discostorm import measured
from discostorm.data import read_data

ROWS = {row["id"]: row for row in read_data("vendors/published.csv")}


def test_the_papers_count_by_hand() -> None:
    found = measured.published()["paper"]
    # 52 processes as hosts of their own, of 18 endpoints: SPDP, SEDP, and four of control a pair.
    assert found["ros-simple"] == 52 + 52 * 51 * (18 + 4)
    # Three processes on each of two hosts: 60 endpoints in all on one, 69 on the other.
    pairs, endpoint_pairs = 2 * 3 * 3, 3 * (60 + 69)
    assert found["turtlebot-dds-packets"] == 6 + endpoint_pairs + 4 * pairs
    # Payloads of Table II, with 42 bytes around each.
    spdp, sedp, heartbeat, acknack = 350 + 42, 400 + 42, 52 + 42, 50 + 42
    assert found["turtlebot-dds-bytes"] == (
        6 * spdp + endpoint_pairs * sedp + 2 * pairs * (heartbeat + acknack)
    )
    # Declarations, and two KeepAlives from each bridge to the other.
    assert found["turtlebot-zenoh-packets"] == 60 + 69 + 2 * 2
    assert found["turtlebot-zenoh-bytes"] == (60 + 69) * (100 + 66) + 4 * (8 + 66)


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
        measured.expected(message, fleet, "startup")
        for message in protocol.messages
        if message.phase in row["counted"].split()
    )
    assert measured._as_counted(protocol, row | {"window_s": "12"}) == pytest.approx(in_startup)
    assert measured.published()["as_built"][name] == measured._as_counted(protocol, row)


def test_what_cannot_be_computed_is_left_out_and_every_difference_has_a_reason() -> None:
    table = measured.published()
    assert list(table.index) == list(ROWS)
    for name, row in table.iterrows():
        assert row["why"], name
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
