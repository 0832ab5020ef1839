"""The storm and the ladder of the first page: what is shown there is the package's."""

import io
from collections.abc import Iterator

import pytest

import discostorm as ds
from discostorm.book import ladder, storm
from discostorm.paper.enumeration import EVERYONE, Endpoint, Process, walk
from discostorm.wifi import Radio

EXPORTED = storm.export()
#: Kind, places of sender and receiver, and the number of the endpoint told of (0: none).
Told = tuple[str, int, int, int]


def shown(name: str, hosts: int, processes: int, endpoints: int) -> Iterator[Told]:
    """Yield what the page takes from the exported storm for a smaller swarm."""
    table = EXPORTED["protocols"][name]
    most = EXPORTED["most"]
    everyone = most["hosts"] * most["processes"]

    def takes_part(place: int) -> bool:
        host, process = divmod(place, most["processes"])
        return place == everyone or (host < hosts and process < processes)

    codes = [EXPORTED["letters"].index(letter) for letter in table["runs"]]
    for kind, sender, receiver, part in zip(*(iter(codes),) * 4, strict=True):
        if takes_part(sender) and takes_part(receiver):
            for number in table["numbers"][part] or [0]:
                if number <= endpoints:
                    yield table["kinds"][kind], sender, receiver, number


def walked(name: str, hosts: int, processes: int, endpoints: int) -> Iterator[Told]:
    """Yield the enumeration's own messages in the same terms."""
    most = EXPORTED["most"]

    def place(process: Process | str) -> int:
        if process == EVERYONE or isinstance(process, str):
            return int(most["hosts"] * most["processes"])
        return int((process.host - 1) * most["processes"] + process.number - 1)

    for sent in walk(name, [[endpoints] * processes] * hosts):
        if sent.hop == "up":
            number = sent.about.number if isinstance(sent.about, Endpoint) else 0
            yield sent.kind, place(sent.sender), place(sent.receiver), number


@pytest.mark.parametrize("swarm", [(2, 1, 0), (2, 1, 5), (3, 2, 10), (7, 2, 10), (12, 1, 20)])
@pytest.mark.parametrize("name", ["DDS", "Zenoh"])
def test_a_smaller_storm_is_the_part_of_the_largest(name: str, swarm: tuple[int, int, int]) -> None:
    assert list(shown(name, *swarm)) == list(walked(name, *swarm))


@pytest.mark.parametrize("name", ["DDS", "Zenoh"])
def test_the_airtime_of_a_storm_is_its_utilization(name: str) -> None:
    table = EXPORTED["protocols"][name]
    cost = dict(zip(table["kinds"], map(sum, table["airtimes"]), strict=True))
    used = sum(cost[kind] for kind, *_ in shown(name, 7, 2, 10))
    assert used == pytest.approx(ds.utilization(ds.PROTOCOLS[name], 7, 2, 10), rel=1e-12)


def test_the_ladder_starts_at_the_paper_and_each_switch_moves_it() -> None:
    rungs = {(rung.switches, rung.protocol): rung for rung in ladder.rungs()}
    assert len(rungs) == len(list(ladder.rungs()))
    names = {switch.key: switch for switch in ladder.SWITCHES}
    for switches, protocol in rungs:
        assert switches <= names.keys()
        assert all(set(names[key].needs) <= switches for key in switches)
        assert {(switches, other) for other in ladder.TABLES} <= rungs.keys(), protocol
    for protocol in ladder.TABLES:
        paper = rungs[frozenset(), protocol]
        full = ds.saturation_hosts(ds.PROTOCOLS[protocol], 2, 10)
        assert paper.full == full
        assert paper.fit < full <= paper.fit + 1
        for switch in ladder.SWITCHES:
            with_it = [
                one for (on, of), one in rungs.items() if switch.key in on and of == protocol
            ]
            assert any(one.fit != paper.fit for one in with_it), switch.key
    frames = Radio("802.11n", streams=2, mpdus=ladder.MPDUS).wifi()
    most = rungs[frozenset({"timing", "aggregation", "periods", "as built"}), "DDS"]
    fast = ds.PROTOCOLS["Fast DDS"]
    assert most.full == ds.saturation_hosts(fast, 2, 10, frames, window=fast.lease)


def test_pictures_are_the_same_every_time() -> None:
    pictures = []
    for _ in range(2):
        picture = io.BytesIO()
        storm.preview(ds.DDS, (1200, 630)).savefig(picture, metadata={"Software": None})
        pictures.append(picture.getvalue())
    assert pictures[0] == pictures[1]
