"""Compare the measured tables with the lab's counts, on the half of the grid not fitted."""

import lzma
import struct
from pathlib import Path

import fit_models
import lab_data
import numpy as np
import pytest
import sympy as sp

import discostorm as ds
from discostorm.data import data_path, read_data
from discostorm.messages import UNITS
from discostorm.protocols import MEASURED, measured_tables
from discostorm.protocols.measured_tables import measured_table, message_rows
from discostorm_book import comparison, lab_counts
from discostorm_capture import rtps, zenoh_messages
from discostorm_capture.zenoh import TCP_KINDS

TABLES = {
    name: ds.PROTOCOLS.get(name) or measured_table(name) for name in measured_tables.products()
}
each_table = pytest.mark.parametrize("name", TABLES)
SWARM = ds.Fleet.swarm(3, 2, 10)
MATCHING = ds.Fleet(SWARM.groups, matching=1)


def test_the_fit_is_that_of_the_measurements(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Again from the counts: the same bytes, and the same list of what the tables miss."""
    for arguments, names, package in (
        ([], ("as_built.csv", "mitigations.csv"), "discostorm"),
        (["--misses"], ("misses.csv", "mitigation_misses.csv"), "discostorm_book"),
    ):
        monkeypatch.setattr("sys.argv", ["fit_models.py", "--out", str(tmp_path), *arguments])
        fit_models.main()
        for name in names:
            now = (tmp_path / name).read_text(encoding="utf-8")
            assert now == data_path(f"measured/{name}", package).read_text(encoding="utf-8")


def test_no_factor_of_the_fit_is_negative() -> None:
    # A falling line meets all three points; of those that do not fall, the flat one through the
    # middle is nearest.
    terms = np.array([[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]])
    assert fit_models.fit_least_absolute_deviations(terms, np.array([3.0, 2.0, 1.0])) == [2.0, 0.0]
    assert fit_models.fit_least_absolute_deviations(terms, np.array([1.0, 2.0, 3.0])) == [1.0, 1.0]


def test_each_row_says_where_it_is_from() -> None:
    given = read_data("vendors/as_built.csv")
    assert {row["protocol"] for row in given} == set(TABLES) == MEASURED
    for row in given:
        assert row["source"].strip()
        assert row["per_unit"] or "measured" in row["source"], row
        assert float(row["per_unit"] or 1) > 0
    for file, tables in (
        ("as_built", measured_tables.products()),
        ("releases", measured_tables.product_releases()),
    ):
        fitted = {
            (row["protocol"], row["message"]): row for row in read_data(f"measured/{file}.csv")
        }
        rows = {
            (name, row["message"]): row
            for name, table in tables.items()
            for row in message_rows(table)
        }
        assert fitted.keys() == rows.keys()
        for key, row in rows.items():
            if row["per_unit"]:
                assert float(fitted[key]["per_unit"]) == float(row["per_unit"])


@each_table
def test_kinds_are_called_as_the_reader_calls_them(name: str) -> None:
    known = {*rtps.message_kinds(), *zenoh_messages.MESSAGE_KINDS, *TCP_KINDS}
    assert {message.kind for message in TABLES[name].messages} <= known


@each_table
def test_a_table_is_within_its_limits_but_where_the_list_says_otherwise(name: str) -> None:
    """Of the half of the grid that it was not fitted to; what is listed is off indeed."""
    listed = {
        tuple(row[column] for column in ("point", "window", "phase", "kind", "quantity"))
        for row in read_data("measured/misses.csv", "discostorm_book")
        if row["protocol"] == name
    }
    table = comparison.compare_with_runs(TABLES[name])
    table = table[table["use"] == "test"]
    off = set()
    for row in table.to_dict("records"):
        limit = 0.05 if row["kind"] == "all" else 0.10
        for quantity, end in (("messages", ""), ("bytes", "_bytes")):
            if abs(row[f"expected{end}"] - row[f"measured{end}"]) > limit * row[f"measured{end}"]:
                off.add((row["point"], row["window"], row["phase"], row["kind"], quantity))
    assert off == listed
    # In the steady state there is nothing to excuse but for the number of Zenoh's connections.
    steady = {phase for _, window, phase, _, _ in off if window == "steady"}
    assert steady <= {"KeepAlive", "TCP"}


def test_what_is_off_has_a_reason_and_what_decides_is_of_a_product() -> None:
    causes = lab_data.read_lab_table("causes.csv")
    reasons = {row["reason"] for row in read_data("measured/reasons.csv", "discostorm_book")}
    assert {
        row["reason"] for row in (*read_data("measured/misses.csv", "discostorm_book"), *causes)
    } <= reasons
    known = {**measured_tables.products(), **measured_tables.configurations()}.values()
    tables = {(row["product"], variant) for row in known for variant in ("", row["variant"])}
    assert {(row["product"], row["variant"]) for row in causes} <= tables


@each_table
def test_all_that_was_counted_has_a_row(name: str) -> None:
    kinds = {message.kind for message in TABLES[name].messages}
    seen = {key[1] for point in lab_counts.grid_points(name) for key in point.runs}
    assert seen - kinds <= {"TCP retransmission"}


def test_units_by_hand() -> None:
    """Three hosts of two processes of ten endpoints, named one by one."""
    processes = [(host, number) for host in range(3) for number in range(2)]
    pairs = [(a, b) for a in processes for b in processes if a[0] != b[0]]
    thirds = [(a, b, c) for a, b in pairs for c in processes if c not in (a, b)]
    others = [(a, b) for a in processes for b in processes if a != b]
    away = [(a, b) for a, b in others if b[0] != 0]
    by_hand = {
        "process": 6,
        "ordered pair of processes on different hosts": len(pairs),
        "endpoint and process on another host": 10 * len(pairs),
        "endpoint": 60,
        "ordered pair of processes": len(others),
        "ordered pair of processes on different hosts and third process": len(thirds),
        "endpoint, process on another host and third process": 10 * len(thirds),
        "matched writer and process on another host": 5 * len(pairs),
        "matched writer, process on another host and third process": 5 * len(thirds),
        "unmatched endpoint and process on another host": 0,
        "host": 3,
        "ordered pair of hosts": 6,
        "endpoint of a kind of host": 20,
        "fleet": 1,
        "unmatched endpoint": 0,
        "matched writer": 30,
        "process and other host": 6 * 2,
        "endpoint and other host": 60 * 2,
        "unmatched endpoint and other host": 0,
        # Ten names that both processes of a host have, on three hosts, for two others each.
        "matched endpoint of a host and other host": 10 * 3 * 2,
        "matched endpoint of a host": 10 * 3,
        "ordered pair of hosts and third host": 6 * 1,
        # Three links have six ends; two hosts hear of each, and each tells the one that is left.
        "end of a link, host that hears of it and other that it tells": 6 * 2 * 1,
        "endpoint and other process": 10 * len(others),
        "two endpoints of a process, or one twice": 6 * 55,
        "two endpoints of a process, or one twice, and process on another host": 55 * len(pairs),
        "ordered pair of matched processes": len(others),
        "ordered pair of matched processes on different hosts": len(pairs),
        "matched endpoint and other process": 10 * len(others),
        "unknown type and process on another host": 0,
        # The server is on the first host.
        "process away from the server": 4,
        "endpoint away from the server": 40,
        "ordered pair of matched processes, one away from the server": len(away),
        "matched endpoint and other process away from the server": 10 * len(away),
    }
    assert {name: unit.count(MATCHING) for name, unit in UNITS.items()} == by_hand
    assert UNITS["unmatched endpoint and process on another host"].count(SWARM) == 10 * len(pairs)
    assert UNITS["matched writer and process on another host"].count(SWARM) == 0
    assert UNITS["unmatched endpoint"].count(SWARM) == 60
    assert UNITS["unmatched endpoint and other host"].count(SWARM) == 60 * 2
    symbols = dict(zip(ds.fleet.PAPER_SWARM.counts(), (3, 2, 10), strict=True))
    for name, unit in UNITS.items():
        symbolic = unit.count(ds.Fleet(ds.fleet.PAPER_SWARM.groups, matching=1))
        assert float(sp.sympify(symbolic).subs(symbols)) == by_hand[name]


def test_fast_dds_by_hand() -> None:
    """Announcements of six processes in twelve seconds: 9 + N - 1 each, and 8 + N / 2 a pair."""
    table = ds.PROTOCOLS["Fast DDS"]
    spdp = [m for m in table.messages if m.kind == "SPDP"]
    counts = {
        cast: sum(comparison.expected_count(m, SWARM, "startup") for m in spdp if m.cast == cast)
        for cast in ("multicast", "unicast")
    }
    assert counts == {"multicast": 6 * (9 + 6 - 1), "unicast": 24 * (8 + 3)}


@each_table
def test_saturation_is_where_utilization_is_one(name: str) -> None:
    table = TABLES[name]
    processes, endpoints = np.array([1, 1, 2, 5]), np.array([678, 10, 10, 0])
    for window in (1.0, 20.0, np.inf):
        full = ds.saturation_hosts(table, processes, endpoints, window=window)
        there = ds.utilization(table, full, processes, endpoints, window=window)
        assert there == pytest.approx(1, rel=1e-9)
    laptops = ds.HostGroup(2, 1, 90)
    mixed = ds.Fleet((ds.HostGroup(1, 2, 10), laptops), matching=0.5)
    full = ds.saturation_hosts(table, fleet=mixed)
    both = ds.Fleet((ds.HostGroup(full, 2, 10), laptops), matching=0.5)
    assert ds.utilization(table, both) == pytest.approx(1, rel=1e-9)


@each_table
def test_names_that_match_cost_more_with_dds_and_less_with_zenoh(name: str) -> None:
    apart, together = (ds.utilization(TABLES[name], fleet) for fleet in (SWARM, MATCHING))
    assert (together > apart) == (not name.startswith("Zenoh"))


@each_table
def test_a_plan_and_an_outlook_can_be_had(name: str) -> None:
    plan = ds.plan(SWARM, TABLES[name])
    assert plan.utilization == ds.utilization(TABLES[name], plan.fleet)
    others = {r.protocol.name for r in plan.remedies if r.kind == "middleware"}
    assert others <= (MEASURED | measured_tables.product_releases().keys()) - {
        name,
        "Cyclone DDS, wired",
    }  # on Wi-Fi nobody gets that one
    assert len(others) >= 2  # of each other product, what the distribution ships


def test_messages_that_share_a_frame_share_its_overhead() -> None:
    alone = ds.DDS.message("SEDP")
    half = ds.Message(*("SEDP", "SEDP", "unicast", "UDP", alone.payload, alone.unit, 1), frames=0.5)
    rate, overhead, header = 144.4e6, 180e-6, 64
    once = 0.5 * (8 * (2 * 400 + header) / rate + overhead)
    values = ds.Protocol("own", (half,)).values() | ds.PAPER.values()
    assert float(half.airtime_up().subs(values)) == pytest.approx(once)
    assert half.frame_bytes == 2 * 400 + header


@pytest.mark.parametrize(
    ("capture", "table", "wired"),
    [
        ("fast_dds", "Fast DDS", False),
        ("cyclone_dds_010", "Cyclone DDS", False),
        ("cyclone_dds_11", "Cyclone DDS, version 11", True),
    ],
)
def test_a_capture_is_held_against_the_table_of_its_network(
    capture: str, table: str, wired: bool
) -> None:
    found = ds.read_capture(data_path(f"captures/{capture}.pcap.xz", "discostorm_capture"))
    compared = found.compare(ds.PROTOCOLS[table])
    own = TABLES[f"{table}, wired" if wired else table]
    assert set(compared.index) == {message.kind for message in own.messages}
    both = compared["unicast"] + compared["multicast"]
    assert both.sum() == pytest.approx(compared["expected"].sum(), rel=0.1)


def later(source: Path, target: Path, seconds: float) -> Path:
    """Write the packets of a capture from some time after the first one on."""
    raw = lzma.decompress(source.read_bytes())
    kept, place, begin = [raw[:24]], 24, None
    while place < len(raw):
        second, part, size = struct.unpack_from("<III", raw, place)
        time = second + part * 1e-6
        begin = time if begin is None else begin
        if time - begin >= seconds:
            kept.append(raw[place : place + 16 + size])
        place += 16 + size
    target.write_bytes(b"".join(kept))
    return target


def test_a_capture_of_the_steady_state_is_not_expected_to_show_a_start(tmp_path: Path) -> None:
    source = data_path("captures/fast_dds.pcap.xz", "discostorm_capture")
    found = ds.read_capture(later(source, tmp_path / "later.pcap", 12))
    compared = found.compare(ds.PROTOCOLS["Fast DDS"], SWARM)
    spdp = compared.loc["SPDP"]
    # Six processes to the group and to 24 pairs, each 3 s.
    assert spdp["expected"] == pytest.approx((6 + 24) * found.duration / 3, rel=0.2)
    assert spdp["unicast"] + spdp["multicast"] == pytest.approx(spdp["expected"], rel=0.15)
    assert (compared.drop("SPDP")["expected"] == 0).all()


def test_names_that_match_are_told_from_what_users_acknowledge() -> None:
    found = ds.read_capture(data_path("captures/cyclone_dds_010.pcap.xz", "discostorm_capture"))
    compared = found.compare(ds.PROTOCOLS["Cyclone DDS"])
    # Two processes with two writers each, all of which match.
    assert compared.loc["User ACKNACK", "units"] == 4
    alone = found.compare(ds.PROTOCOLS["Cyclone DDS"], ds.Fleet.swarm(2, 1, 4))
    assert alone.loc["User ACKNACK", "expected"] == 0


def test_a_fleet_says_how_far_its_endpoints_match(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    group = "[[groups]]\nhosts = 3\nprocesses = 2\nendpoints = 10\n"
    path.write_text(f"matching = 0.5\n{group}", encoding="utf-8")
    fleet = ds.Fleet.from_toml(path)
    shares = ds.HostGroup(3, 2, 10, shared=2)
    assert fleet == ds.Fleet((shares,), matching=0.5) != ds.Fleet((shares,))
    assert repr(fleet).endswith("matching=0.5)")
    for wrong in ("2", "-0.1", "true", '"all"'):
        path.write_text(f"matching = {wrong}\n{group}", encoding="utf-8")
        with pytest.raises(ValueError, match=r"fleet\.toml: matching must be .* at most 1; got"):
            ds.Fleet.from_toml(path)
