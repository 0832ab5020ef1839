"""The counts of the message tables against a walk that names everybody."""

from collections import Counter
from itertools import product
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st
from paper_equations import messages

import discostorm as ds
from discostorm_book import enumeration
from discostorm_book.enumeration import EVERYONE, Endpoint, Process, enumerate_messages

SWARMS = list(product(range(1, 6), range(1, 5), (0, 2, 4, 6)))
PROTOCOLS = (ds.DDS, ds.ZENOH)


@pytest.mark.parametrize("protocol", PROTOCOLS, ids=lambda protocol: protocol.name)
def test_counts_equal_the_closed_forms_for_each_message_phase_and_hop(
    protocol: ds.Protocol,
) -> None:
    for n_h, n_p, n_e in SWARMS:
        sent = list(enumerate_messages(protocol.name, [[n_e] * n_p] * n_h))
        fleet = ds.Fleet.swarm(n_h, n_p, n_e)
        kinds = Counter((message.kind, message.hop) for message in sent)
        phases = Counter((message.phase, message.hop) for message in sent)
        hosts = Counter((message.phase, message.hop, message.sender.host) for message in sent)
        right = messages(n_h, n_p, n_e)
        for hop in ("up", "down"):
            for message in protocol.messages:
                assert kinds[message.name, hop] == message.load(fleet)
            for phase in protocol.phases:
                assert phases[phase, hop] == right[phase, "all"]
                for host in range(1, n_h + 1):
                    assert hosts[phase, hop, host] == right[phase, "host"]
        assert sum(kinds.values()) == 2 * sum(right[phase, "all"] for phase in protocol.phases)


unlike_hosts = st.lists(st.lists(st.integers(0, 5), min_size=1, max_size=3), min_size=1, max_size=5)


@given(st.sampled_from(PROTOCOLS), unlike_hosts)
@settings(max_examples=60, deadline=None)
def test_a_fleet_of_one_group_a_host_counts_what_the_walk_sends(
    protocol: ds.Protocol, hosts: list[list[int]]
) -> None:
    # Processes of one host may be unlike, too: as a list, or by their mean number of endpoints.
    unlike = [tuple(ds.Process(1, endpoints) for endpoints in counts) for counts in hosts]
    fleet = ds.Fleet(tuple(ds.HostGroup(1, sizes) for sizes in unlike))
    means = ds.Fleet(tuple(ds.HostGroup(1, g.processes, g.endpoints) for g in fleet.groups))
    kinds = Counter(
        (message.kind, message.hop) for message in enumerate_messages(protocol.name, hosts)
    )
    for message in protocol.messages:
        # The mean of up to three numbers is not exact in binary.
        expected = pytest.approx(message.load(fleet), rel=1e-12)
        assert kinds[message.name, "up"] == kinds[message.name, "down"] == expected
        assert message.load(means) == expected


@given(st.sampled_from(PROTOCOLS), unlike_hosts)
@settings(max_examples=60, deadline=None)
def test_every_process_learns_of_every_endpoint_on_other_hosts(
    protocol: ds.Protocol, hosts: list[list[int]]
) -> None:
    sent = list(enumerate_messages(protocol.name, hosts))
    learned = Counter(
        (message.receiver, message.about)
        for message in sent
        if message.hop == "down" and isinstance(message.about, Endpoint)
    )
    everybody = [
        (Process(host, number), count)
        for host, counts in enumerate(hosts, start=1)
        for number, count in enumerate(counts, start=1)
    ]
    expected = {
        (receiver, str(owner), index)
        for receiver, _ in everybody
        for owner, count in everybody
        for index in range(1, count + 1)
        if owner.host != receiver.host
    }
    found = {
        (receiver, str(about.process), about.number)
        for receiver, about in learned
        if isinstance(about, Endpoint)
    }
    assert found == expected
    assert set(learned.values()) <= {1}


@pytest.mark.parametrize("protocol", ["DDS", "Zenoh"])
def test_every_message_is_its_own_goes_up_and_down_and_leaves_its_host(protocol: str) -> None:
    sent = list(enumerate_messages(protocol, [[3, 2], [0], [4]]))
    assert len(set(sent)) == len(sent)
    for up, down in zip(sent[::2], sent[1::2], strict=True):
        assert (up.hop, down.hop) == ("up", "down")
        for field in ("sender", "receiver", "kind", "about"):
            assert getattr(up, field) == getattr(down, field)
        if isinstance(up.receiver, Process):
            assert up.receiver.host != up.sender.host
        else:
            assert up.receiver == EVERYONE


def test_the_walk_shares_no_code_with_what_it_confirms() -> None:
    used = {getattr(value, "__module__", None) for value in vars(enumeration).values()}
    others = {name for name in used if str(name).startswith("discostorm")}
    assert others == {"discostorm_book.enumeration"}


def test_a_host_without_endpoints_is_still_found() -> None:
    kinds = Counter(message.kind for message in enumerate_messages("DDS", [[0], [0]]))
    assert kinds == {"SPDP": 4, "Heartbeat": 8, "ACKNACK": 8}


@pytest.mark.parametrize(
    ("protocol", "hosts", "message"),
    [
        ("RTPS", [[1]], "protocol must be 'DDS' or 'Zenoh'; got 'RTPS'"),
        ("DDS", [[1], [2, -1]], r"hosts\[1\]\[1\] must be a whole number .* at least 0; got -1"),
        ("DDS", [[1.5]], r"hosts\[0\]\[0\] must be a whole number .*; got 1.5"),
    ],
)
def test_wrong_input_is_named(protocol: str, hosts: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        list(enumerate_messages(protocol, hosts))


@pytest.mark.parametrize(
    ("hosts", "message"),
    [
        (3, "hosts must be a sequence; got 3"),
        ("12", "hosts must be a sequence; got '12'"),
        ([[1], 2], r"hosts\[1\] must be a sequence; got 2"),
    ],
)
def test_hosts_that_are_no_sequences_are_named(hosts: Any, message: str) -> None:
    with pytest.raises(TypeError, match=message):
        list(enumerate_messages("DDS", hosts))


def test_endpoints_alternate_between_topics_and_each_topic_ends_with_its_heartbeat() -> None:
    first, second = Process(1, 1), Process(2, 1)
    told = [
        sent.about.builtin_topic if isinstance(sent.about, Endpoint) else f"end of {sent.about}"
        for sent in enumerate_messages(ds.DDS.name, [[3], [0]])
        if (sent.sender, sent.receiver, sent.hop) == (first, second, "up")
        and sent.kind in {"SEDP", "Heartbeat"}
    ]
    one, other = sorted({topic for topic in told if not topic.startswith("end")}, key=told.index)
    assert told == [one, one, f"end of {one}", other, f"end of {other}"]
