"""Data files name a source on every row, and every symbol says what it is."""

from importlib.resources import files

import pytest

import discostorm as ds
from discostorm.data import data_path, read_data
from discostorm.messages import header_bytes
from discostorm.notation import NOTATION, payload_symbol
from discostorm.scalability import saturation

PROTOCOLS = [ds.DDS, ds.ZENOH]

DATA_FILES = sorted(str(path.relative_to(data_path(""))) for path in data_path("").rglob("*.csv"))


#: Where a table says it in a column of another name: of a claim the source is where the paper makes
#: it, of what a quantity is called the function that computes it, of a run its capture, of a count
#: its run, of a death how its robots were arranged, and of that the software, of what is fitted or
#: missed the message or kind in other tables, and of a product what of the runs it is.
SOURCES = {
    "paper/claims.csv": "where",
    "paper/quantities.csv": "quantity",
    "measured/runs.csv": "sha256",
    "measured/counts.csv": "run",
    "measured/deaths.csv": "arrangement",
    "measured/arrangements.csv": "version",
    "measured/as_built.csv": "message",
    "measured/misses.csv": "kind",
    "measured/mitigation_counts.csv": "run",
    "measured/mitigation_misses.csv": "kind",
    "measured/mitigation_runs.csv": "sha256",
    "measured/mitigations.csv": "message",
    "measured/reasons.csv": "reason",
    "measured/hybrid.csv": "run",
    "measured/published.csv": "sha256",
    "vendors/arrangements.csv": "product",
    "vendors/products.csv": "product",
    "simulated/hybrid.csv": "scenario",
}


@pytest.mark.parametrize("name", DATA_FILES)
def test_every_row_has_a_source_and_every_column(name: str) -> None:
    rows = read_data(name)
    assert rows
    for row in rows:
        assert row[SOURCES.get(name, "source")].strip(), row
        # csv puts what is too much under None, and None where something is missing
        assert None not in row, row
        assert None not in row.values(), row


def test_table_2_adds_up_to_the_printed_frames() -> None:
    rows = read_data("paper/table2.csv")
    assert len(rows) == 8
    for row in rows:
        frame = int(row["payload_B"]) + header_bytes()[row["transport"]]
        assert frame == int(row["frame_printed_B"]), row
        assert int(row["low_B"]) <= int(row["payload_B"]) <= int(row["high_B"]), row


def test_headers_add_up_to_the_papers() -> None:
    assert header_bytes() == {"UDP": 64, "TCP": 76}


def test_the_protocols_hold_table_2_each_message_once() -> None:
    messages = {message.name: message for protocol in PROTOCOLS for message in protocol.messages}
    rows = {row["message"]: row for row in read_data("paper/table2.csv")}
    assert messages.keys() == rows.keys()
    for name, row in rows.items():
        message = messages[name]
        assert message.frame_bytes == int(row["frame_printed_B"])
        assert message.transport == row["transport"]
        assert message.payload == ds.Payload(
            float(row["payload_B"]), float(row["low_B"]), float(row["high_B"]), row["source"]
        )


def test_the_papers_channel() -> None:
    assert (ds.PAPER.unicast.rate, ds.PAPER.unicast.overhead) == (144.4e6, 180e-6)
    assert (ds.PAPER.multicast.rate, ds.PAPER.multicast.overhead) == (6e6, 120e-6)


@pytest.mark.parametrize("protocol", PROTOCOLS, ids=lambda protocol: protocol.name)
def test_every_symbol_is_in_the_notation_or_a_payload(protocol: ds.Protocol) -> None:
    known = {quantity.symbol for quantity in NOTATION.values()}
    payloads = {payload_symbol(message.name) for message in protocol.messages}
    assert not known & payloads
    for expression in (
        *(protocol.load(phase) for phase in (None, *protocol.phases)),
        *(protocol.utilization(phase) for phase in (None, *protocol.phases)),
        saturation(protocol),
    ):
        assert expression.free_symbols <= known | payloads


@pytest.mark.parametrize("name", NOTATION)
def test_every_symbol_has_meaning_unit_and_source(name: str) -> None:
    quantity = NOTATION[name]
    assert quantity.symbol.name == name
    assert quantity.meaning.strip()
    assert quantity.unit.strip()
    assert quantity.source.strip()


def test_types_are_told_to_those_who_install_the_package() -> None:
    assert (files("discostorm") / "py.typed").is_file()
