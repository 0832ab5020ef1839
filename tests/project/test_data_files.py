"""Test that data files name a source on every row, and that every symbol has a meaning."""

import re
from importlib.resources import files
from pathlib import Path

import pytest
from check_distributions import read_packages

import discostorm as ds
from discostorm.data import data_path, read_data
from discostorm.messages import header_bytes
from discostorm.notation import NOTATION, payload_symbol
from discostorm.saturation import saturation

PROTOCOLS = [ds.DDS, ds.ZENOH]

#: Each table, with the package whose code reads it.
DATA_FILES = sorted(
    (str(path.relative_to(data_path("", row["import"]))), row["import"])
    for row in read_packages()
    for path in data_path("", row["import"]).rglob("*.csv")
)


#: Where a table says it in a column of another name: a claim where the paper makes it, a run its
#: capture.
SOURCES = {
    "paper/claims.csv": "where",
    "measured/runs.csv": "sha256",
    "measured/mitigation_runs.csv": "sha256",
    "measured/shared_runs.csv": "sha256",
    "measured/beyond_runs.csv": "sha256",
}
#: Tables without such a column, by the README that says where all their rows are from.
DESCRIBED = {
    "measured/README.md": (
        *("configurations", "as_built", "counts", "deaths", "hybrid"),
        *("releases", "release_airtime", "release_servers", "air", "backup_restarts"),
        *(
            "misses",
            "mitigation_counts",
            "mitigation_misses",
            "mitigations",
            "outages",
            "staged",
            "reasons",
            "shared_counts",
        ),
        *(
            "bands",
            "beyond_counts",
            "refits",
            "security",
            "security_strangers",
            "watch",
        ),
    ),
    "README.md": (
        *("simulated/hybrid", "simulated/hybrid_lab", "paper/quantities", "paper/claim_tests"),
        *(
            "vendors/products",
            "vendors/configurations",
            "vendors/releases",
            "vendors/units",
            "palette",
        ),
    ),
}
WITHOUT = {
    str(Path(readme).parent / f"{table}.csv")
    for readme, tables in DESCRIBED.items()
    for table in tables
}


@pytest.mark.parametrize(("name", "package"), DATA_FILES)
def test_every_row_has_a_source_and_every_column(name: str, package: str) -> None:
    rows = read_data(name, package)
    assert rows
    assert (name in WITHOUT) == (SOURCES.get(name, "source") not in rows[0])
    for row in rows:
        assert name in WITHOUT or row[SOURCES.get(name, "source")].strip(), row
        # csv puts what is too much under None, and None where something is missing
        assert None not in row, row
        assert None not in row.values(), row


@pytest.mark.parametrize("readme", DESCRIBED)
def test_a_readme_tells_of_the_tables_whose_rows_have_no_source(readme: str) -> None:
    text = data_path(readme).read_text(encoding="utf-8")
    assert [name for name in DESCRIBED[readme] if f"`{name}.csv`" not in text] == []


@pytest.mark.parametrize(
    ("table", "runs"), [("products", "runs"), ("configurations", "mitigation_runs")]
)
def test_what_is_named_was_run(table: str, runs: str) -> None:
    # Debian's and PyPI's versions have more behind that of the product.
    ran = {
        (row["product"], row["variant"], re.split(r"[-+]", row["version"])[0])
        for row in read_data(f"measured/{runs}.csv", "discostorm_book")
    }
    for row in read_data(f"vendors/{table}.csv"):
        for version in row["versions"].split(" and "):
            assert (row["product"], row["variant"], version) in ran, row


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
