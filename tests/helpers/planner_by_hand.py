"""Fleets for the planner's tests, and their airtime computed by hand from hosts and frames."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import pytest

import discostorm as ds
from discostorm.data import read_data

#: Hosts, each as a list with the endpoints of each process.
Hosts = Sequence[Sequence[float]]


#: The paper's channel: functions from octets to airtime [s], for both modes of delivery.
Frames = dict[str, Callable[[int], float]]


PAPER: Frames = {
    "unicast": lambda octets: 8 * octets / 144.4e6 + 180e-6,
    "multicast": lambda octets: 8 * octets / 6e6 + 120e-6,
}


ROBOTS = ds.HostGroup(10, 1, 678, name="robots")


LAPTOP = ds.HostGroup(1, 1, 90, name="laptop")


NAV2 = ds.Fleet((ROBOTS, LAPTOP))


#: The same fleet with its nodes and always-matching endpoints.
NAV2_WITH_NODES = ds.Fleet(
    (replace(ROBOTS, nodes=13, shared=28), replace(LAPTOP, nodes=2, shared=6))
)


MITIGATION_ROWS = [row for row in read_data("vendors/remedies.csv") if row["table"] and row["base"]]


MITIGATION_KINDS = {row["kind"] for row in MITIGATION_ROWS}


PRODUCT_OF = {row["table"]: row["base"] for row in MITIGATION_ROWS}


CHANNEL_KINDS = {"radio", "multicast rate", "aggregation"}


RADIO = ds.WIFI["802.11n 20 MHz 2x2"]


FIG3 = ds.Fleet.swarm(3, 8, 5)


PLAN_OF_FIG3 = ds.plan(FIG3)


def groups_as_toml(fleet: ds.Fleet) -> Hosts:
    return [
        [group.endpoints] * int(group.processes)
        for group in fleet.groups
        for _ in range(int(group.hosts))
    ]


def in_symbols(octets: int, padding: ds.OfdmSymbols) -> float:
    """Return the airtime in whole symbols, rounded up to a grid, in tenths of a microsecond."""
    symbols = -(-(padding.added + 8 * octets) // padding.bits)
    ticks, grid = round(padding.symbol * 1e7), round(padding.grid * 1e7)
    return -(-symbols * ticks // grid) * grid * 1e-7


def frames_of(wifi: ds.Wifi) -> Frames:
    """Return functions from octets to airtime on a channel, written out from its numbers."""

    def alone(octets: int, link: ds.Link) -> float:
        if link.padding is None:
            return 8 * octets / link.rate + link.overhead
        return link.overhead + in_symbols(octets, link.padding)

    def unicast(octets: int) -> float:
        if wifi.aggregation is None:
            return alone(octets, wifi.unicast)
        subframe = 4 + -(-(octets + 2) // 4) * 4  # a delimiter, QoS Control, padding
        many = min(wifi.aggregation.mpdus, wifi.aggregation.most_bytes // subframe)
        assert wifi.unicast.padding is not None
        data = in_symbols(many * subframe, wifi.unicast.padding)
        return (wifi.aggregation.overhead + data) / many

    return {"unicast": unicast, "multicast": lambda octets: alone(octets, wifi.multicast)}


def by_hand(hosts: Hosts, protocol: str = "DDS", frames: Frames = PAPER) -> float:
    """Return the airtime, summed over all pairs of processes, with the frames of Table II."""

    def frame(octets: int, cast: str) -> float:
        return frames[cast](octets)

    def relayed(octets: int) -> float:
        return 2 * frame(octets, "unicast")

    multicast = 414 if protocol == "DDS" else 80
    endpoint = relayed(464) if protocol == "DDS" else relayed(176)
    pair = (
        2 * relayed(116) + 2 * relayed(114) if protocol == "DDS" else relayed(144) + 2 * relayed(84)
    )
    total = 0.0
    for here, own in enumerate(hosts):
        for endpoints in own:
            total += frame(multicast, "unicast") + frame(multicast, "multicast")
            for there, others in enumerate(hosts):
                if here != there:
                    total += len(others) * (pair + endpoints * endpoint)
    return total


def remedy(plan: ds.Plan, kind: str, index: int = 0) -> ds.Remedy:
    return [found for found in plan.remedies if found.kind == kind][index]


def approx(value: Any) -> Any:
    # The sums have up to a few thousand terms, added in another order.
    return pytest.approx(value, rel=1e-10)
