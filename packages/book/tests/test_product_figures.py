"""Test the chapters' tables of products against the ledger and the fits."""

import numpy as np
import pytest

import discostorm as ds
from discostorm.data import data_path
from discostorm_book import comparison, lab_counts, products, published_numbers
from discostorm_book.figures import captures as lanes, measured_messages as drawn
from discostorm_book.ledger.quantities import QUANTITIES, captured


def test_counts_are_those_that_decide_the_ledger() -> None:
    for row in products.sent_per_counted_message().to_dict("records"):
        assert row["min"] <= row["median"] <= row["max"]
        wanted = captured.sent_for_counted(row["product"], row["message"])
        assert row["median"] == pytest.approx(wanted, rel=1e-12)
        assert row["max"] / row["min"] == pytest.approx(
            QUANTITIES["sent_spread"](row["product"], row["message"]), rel=1e-12
        )


def test_airtime_by_purpose_is_all_airtime() -> None:
    for swarm in ((7, *products.SMALL), (3, *products.NAV2)):
        spent = products.airtime_by_purpose(*swarm).sum(axis=1)
        for name, total in spent.items():
            wanted = ds.utilization(ds.PROTOCOLS[str(name)], *swarm)
            assert total == pytest.approx(wanted, rel=1e-12)
        kinds = {message.kind for message in ds.PROTOCOLS["Fast DDS"].messages}
        assert products.airtime_of_kinds(kinds, "Fast DDS", *swarm) == pytest.approx(
            spent["Fast DDS"], rel=1e-12
        )


def test_the_paper_has_no_message_without_an_equation() -> None:
    for protocol in (ds.DDS, ds.ZENOH):
        assert {message.kind for message in protocol.messages} <= products.PURPOSES.keys()
    spent = products.airtime_by_purpose(7, *products.SMALL)
    assert (spent.loc[list(products.PAPER_TABLES), products.NO_EQUATION] == 0).all()


def test_saturation_fills_a_second() -> None:
    hosts = products.saturation_points()
    for name in hosts.index:
        protocol = ds.PROTOCOLS[name]
        assert ds.utilization(protocol, hosts["small robots"][name], *products.SMALL) == (
            pytest.approx(1, rel=1e-9)
        )
        processes = hosts["processes"][name]
        used = ds.utilization(protocol, 3, processes, 40 / processes)
        assert used == pytest.approx(1, rel=1e-4)
    assert hosts["in a lease"].notna().sum() == len(products.MODELS)


def test_what_is_within_and_what_is_not_are_all() -> None:
    within, missed = products.count_within_limits(), products.cases_beyond_limits()
    for quantity in ("messages", "bytes"):
        all_of = within[["phases", "kinds"]].sum().sum()
        right = within[[f"phases, {quantity}", f"kinds, {quantity}"]].sum().sum()
        assert all_of - right == (missed["quantity"] == quantity).sum()
    off = products.held_out_errors()
    for row in within.to_dict("records"):
        mine = off[(off["model"] == row["model"]) & (off["window"] == row["window"])]["error"]
        inside = (mine.abs() <= comparison.MAX_PHASE_ERROR * (1 + 1e-12)).sum()
        assert inside == row["phases, messages"]
    assert products.miss_reasons()["cases"].sum() == len(missed)


def test_without_guesses_a_model_sends_no_more() -> None:
    swarm = (7, *products.SMALL)
    for name in products.MODELS:
        bare = products.without_unsourced_messages(name)
        assert ds.utilization(bare, *swarm) <= ds.utilization(ds.PROTOCOLS[name], *swarm)


def test_every_published_number_is_compared() -> None:
    assert (
        len(published_numbers.comparison_table())
        == published_numbers.published_with_counts()["number"].notna().sum()
    )


def test_a_lane_turns_when_its_host_knows_all_others() -> None:
    capture = ds.read_capture(data_path("captures/cyclone_healthy.pcap.xz", "discostorm_capture"))
    data = lanes.message_lanes_data({"healthy": capture}, end_s=1.0)
    hosts = capture.diagnosis().hosts()
    assert set(data["host"]) == set(hosts.index)
    assert data.groupby("host")["complete_s"].first().to_dict() == hosts["knows_all_s"].to_dict()
    assert data["time_s"].max() <= 1.0 < capture.messages()["time"].max()
    figure = lanes.message_lanes({"healthy": capture}, end_s=1.0)
    said = {text.get_text() for text in figure.axes[0].texts}
    assert {f"{second:.2f} s" for second in hosts["knows_all_s"]} <= said


def test_titles_say_what_is_drawn() -> None:
    start = products.startup_counts("Fast DDS").set_index("kind")
    ratio = start["measured"]["SPDP"] / start["paper"]["SPDP"]
    assert f"SPDP is sent {ratio:.0f} times" in drawn.startup_messages("Fast DDS").get_suptitle()
    right = products.sent_per_counted_message()
    (only,) = right[right["as_counted"] == 1].to_dict("records")
    assert f"{only['message']} of {only['product']}" in drawn.message_counts().get_suptitle()
    small, large = drawn.startup_airtime({"small": (7, 2, 10), "large": (3, 1, 678)}).axes
    assert small.get_title(loc="left").endswith(": more than the paper counts")
    assert large.get_title(loc="left").endswith(": less than the paper counts")
    points = [p for p in lab_counts.grid_points("Fast DDS") if p.name == products.HELD_OUT_SWARM]
    assert [point.use for point in points] == ["test"]
    assert np.isclose(float(products.HELD_OUT_FLEET.hosts()), 3)
