"""Test plans of fleets with many groups."""

import math
from itertools import pairwise

import pytest

import discostorm as ds


def fleet(groups: int) -> ds.Fleet:
    return ds.Fleet(
        tuple(
            ds.HostGroup(1 + index % 4, 1 + index % 3, 7 * index % 101, name=f"g{index}")
            for index in range(groups)
        )
    )


def test_of_many_groups_the_five_that_matter_are_named() -> None:
    plan = ds.plan(fleet(12))
    assert plan.why().count('- Traffic to or from "g') == 5
    assert "- Traffic to or from 7 other groups: at most" in plan.why()
    shares = [share.share for share in plan.shares_of_kind("group")]
    assert len(shares) == 12
    assert all(one >= another for one, another in pairwise(shares))
    assert "- Traffic to or from 1 other group: at most" in ds.plan(fleet(6)).why()
    assert "other group" not in ds.plan(fleet(5)).why()


@pytest.mark.parametrize("protocol", ds.PROTOCOLS.values(), ids=list(ds.PROTOCOLS))
@pytest.mark.parametrize("shared", [0, 14])
def test_a_plan_counts_what_a_fleet_shares(protocol: ds.Protocol, shared: float) -> None:
    members = ds.Fleet((ds.HostGroup(5, 2, 100, shared=shared),))
    plan = ds.plan(members, protocol)
    assert plan.fleet == members
    assert plan.utilization == ds.utilization(protocol, members)
    assert math.fsum(share.share for share in plan.shares_of_kind("message")) == pytest.approx(1)
