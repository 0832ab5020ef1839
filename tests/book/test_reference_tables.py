"""The notation table, the data files of chapters 1 and 4, and the map of the paper."""

import json
import re
from fractions import Fraction

import pytest
from support import ROOT

import discostorm as ds
from discostorm.data import data_path, read_data
from discostorm.notation import NOTATION
from discostorm_book import show

#: Everything the paper numbers.
NUMBERED = (
    [f"paper-eq-{number}" for number in range(1, 13)]
    + [f"paper-table-{number}" for number in (1, 2)]
    + [f"paper-fig-{number}" for number in (1, 2, 3, 4)]
)


def shown_symbols(markdown):
    return [line.split("|")[1].strip() for line in markdown.data.splitlines()[2:]]


def test_notation_table_holds_every_defined_symbol_once():
    symbols = shown_symbols(show.notation())
    assert symbols == [f"${show.latex(row.symbol)}$" for row in NOTATION.values()]


@pytest.mark.parametrize("protocol", [ds.DDS, ds.ZENOH], ids=lambda protocol: protocol.name)
def test_notation_table_explains_every_symbol_of_the_utilization(protocol):
    symbols = shown_symbols(show.notation(protocol))
    assert len(set(symbols)) == len(symbols)
    used = {f"${show.latex(symbol)}$" for symbol in protocol.utilization().free_symbols}
    assert used <= set(symbols)


def test_notation_table_gives_unit_and_source_of_every_symbol():
    for line in show.notation(ds.DDS, ds.ZENOH).data.splitlines()[2:]:
        assert all(cell.strip() for cell in line.strip("|").split("|")), line


def test_table1_levels_are_the_three_counts_of_the_notation():
    rows = read_data("paper/table1.csv", "discostorm_book")
    assert [row["level"] for row in rows] == ["Host", "Process", "Endpoint"]
    assert all(row["symbol"] in NOTATION for row in rows)


def test_rates_of_the_paper_follow_from_the_parameters_of_the_standard():
    exact = {
        row["rate"]: int(row["data_subcarriers"])
        * int(row["bits_per_subcarrier"])
        * Fraction(row["coding_rate"])
        * int(row["streams"])
        / Fraction(row["symbol_us"])
        for row in read_data("paper/rates.csv")
    }
    assert exact == {"unicast": Fraction(1300, 9), "multicast": 6}
    for row in read_data("paper/rates.csv"):
        printed = float(row["printed_Mbit_s"])
        # The paper prints one decimal, so its value is within half a unit of that place.
        assert abs(exact[row["rate"]] - Fraction(row["printed_Mbit_s"])) <= Fraction(1, 20)
        assert getattr(ds.PAPER, row["rate"]).rate == pytest.approx(printed * 1e6, rel=1e-15)


def test_paper_map_lists_every_numbered_item_once():
    page = (ROOT / "book" / "paper_map.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"<(paper-[a-z]+-\d+)>", page)) == sorted(NUMBERED)


def test_anchors_to_the_paper_are_known_and_defined_once():
    defined = [
        anchor
        for path in sorted((ROOT / "notebooks").glob("*.ipynb"))
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "markdown"
        for anchor in re.findall(r"^\((paper-[a-z]+-\d+)\)=$", "".join(cell["source"]), re.M)
    ]
    assert len(set(defined)) == len(defined)
    assert set(defined) <= set(NUMBERED)


def test_drawing_of_the_layers_describes_itself():
    svg = data_path("paper/layers.svg", "discostorm_book").read_text(encoding="utf-8")
    assert 'role="img"' in svg
    assert re.search(r"<title[^>]*>[^<]+</title>", svg)
    assert re.search(r"<desc[^>]*>[^<]+</desc>", svg)
    assert "http" not in svg.replace('xmlns="http://www.w3.org/2000/svg"', "")


def test_printed_lines_of_a_cell_are_one_output():
    # Under load they arrive in pieces; pieces kept apart would differ from run to run.
    for path in sorted((ROOT / "notebooks").glob("*.ipynb")):
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            names = [output.get("name") for output in cell.get("outputs", [])]
            assert names.count("stdout") <= 1, (path.name, cell["id"])
