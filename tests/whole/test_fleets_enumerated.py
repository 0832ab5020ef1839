"""Compare the counts of fleets with the book's enumeration."""

from collections import Counter
from collections.abc import Sequence
from typing import Any

from hypothesis import given, settings, strategies as st

import discostorm as ds
from discostorm_book.enumeration import enumerate_messages

#: Hosts, processes and endpoints of each group.
Groups = Sequence[tuple[Any, Any, Any]]

PROTOCOLS = (ds.DDS, ds.ZENOH)
protocols = st.sampled_from(PROTOCOLS)

# Groups of hosts, processes and endpoints; small enough to walk the protocol.
groups = st.tuples(st.integers(1, 3), st.integers(1, 3), st.integers(0, 5))
few_groups = st.lists(groups, min_size=1, max_size=3)


def fleet_of(counts: Groups) -> ds.Fleet:
    return ds.Fleet(tuple(ds.HostGroup(*group) for group in counts))


def hosts_of(counts: Groups) -> list[list[int]]:
    return [[endpoints] * processes for hosts, processes, endpoints in counts for _ in range(hosts)]


@given(protocols, few_groups)
@settings(max_examples=40, deadline=None)
def test_random_fleets_count_what_the_walk_sends(protocol: ds.Protocol, counts: Groups) -> None:
    fleet = fleet_of(counts)
    sent = list(enumerate_messages(protocol.name, hosts_of(counts)))
    kinds = Counter((message.kind, message.hop) for message in sent)
    table = ds.breakdown(protocol, fleet)
    for message in protocol.messages:
        expected = message.load(fleet)
        assert kinds[message.name, "up"] == expected
        assert kinds[message.name, "down"] == expected
        assert table.loc[message.name, "uplink_messages"] == expected
