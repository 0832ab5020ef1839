"""Numbers in the text of a chapter are those that a cell above it computes."""

import runpy
from pathlib import Path
from typing import Any

import pytest
from compare_facts import disagreements, has_facts, read_cells
from myst_nb.core.read import read_myst_markdown_notebook
from nbclient import NotebookClient
from support import ROOT

from discostorm_book.facts import (
    KEY,
    facts,
    first_mismatch,
    numerals,
)

NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
#: Chapters in which each number is guarded; it may only grow.
GUARDED = [path for path in NOTEBOOKS if has_facts(read_cells(path))]


def test_there_are_guarded_chapters() -> None:
    assert "01_who_tells_whom.ipynb" in [path.name for path in GUARDED]


def execute_page(page: Path) -> list[dict[str, Any]]:
    """Run the code of a Markdown page and return its cells."""
    notebook = read_myst_markdown_notebook(page.read_text(encoding="utf-8"))
    NotebookClient(
        notebook, kernel_name="python3", resources={"metadata": {"path": page.parent}}
    ).execute()
    return [dict(cell) for cell in notebook.cells]


@pytest.mark.parametrize("name", ["index", "limits"])
def test_text_and_facts_of_a_page_agree(name: str) -> None:
    cells = execute_page(ROOT / "book" / f"{name}.md")
    assert disagreements(cells) == []
    (wrong,) = (cell for cell in cells if " at 7.16 " in cell["source"])
    wrong["source"] = wrong["source"].replace("7.16", "7.61")
    assert "7.61" in disagreements(cells)[0]


@pytest.mark.parametrize("path", GUARDED, ids=lambda path: path.stem)
def test_text_and_facts_of_a_chapter_agree(path: Path) -> None:
    assert disagreements(read_cells(path)) == []


def test_a_wrong_digit_of_a_guarded_chapter_is_noticed() -> None:
    measure = runpy.run_path(str(ROOT / "scripts/book/measure_fact_guard.py"))["try_changes"]
    found = measure(GUARDED, trials=400, seed=7)
    digits = found[found["what"] == "digits"]
    assert len(digits) == 400
    assert digits["caught"].mean() >= 0.95


@pytest.mark.parametrize("path", GUARDED, ids=lambda path: path.stem)
def test_no_sentence_of_a_guarded_chapter_is_put_together_by_code(path: Path) -> None:
    code = ["".join(cell["source"]) for cell in read_cells(path) if cell["cell_type"] == "code"]
    assert [cell for cell in code if "notebook.say(" in cell or "notebook.answer(" in cell] == []


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("It takes 0.95 s, or 95.4%.", {"airtime": 0.9541, "share": 0.9541}),
        ("about 100,000 robots fit", {"robots": 103_423}),
        ("between 12 and 15 ms", {"least": 0.0121, "most": 0.0149}),
        ("2 to 3 kB each", {"least": 1990, "most": 3049}),
        ("Seven robots; 7 of them, again 7.", {"robots": 7}),
        ("Two of four robots", {"robots": 4}),
        ("a rate of 144.4 Mbit/s at 5 GHz", {"rate": 144.44e6, "band": 5e9}),
        ("half of it, 1.5 s", {"share": 0.5, "time": 1.5}),
        ("802.11n, ROS 2, Fig. 2, equations (8) to (10), `x = 3`, $W = 1$, [4]", {}),
        ("[See 3](page.html#eq-5) for Fast DDS 2.9.1 of 2023, chapter 3 and row 7", {"three": 3}),
        ("1. One\n2. Two", {}),
        ("with Table II and 1.73 s with chapter 3, 4 and 5", {"time": 1.73}),
    ],
)
def test_text_that_states_its_facts(text: str, values: dict[str, float]) -> None:
    assert first_mismatch(text, values) is None


@pytest.mark.parametrize(
    ("text", "values", "problem"),
    [
        ("It takes 0.96 s.", {"airtime": 0.9541}, "'0.96' in “…It takes 0.96 s.…”: the next facts"),
        ("It takes 0.95 ms.", {"airtime": 0.9541}, "the next facts are airtime = 0.9541"),
        ("It takes 95%.", {"airtime": 95.0}, "the next facts are airtime = 95"),
        ("4 of 7 robots", {"of": 7, "robots": 4}, "'4' in"),
        ("7 robots", {"robots": 7, "fit": 5}, "the text does not state fit = 5"),
        ("Six robots", {"robots": 7}, "the text does not state robots = 7"),
        ("7 robots, 3 laptops", {"robots": 7}, "'3' in “…7 robots, 3 laptops…”: no fact is left"),
        ("100,001 robots", {"robots": 100_002}, "'100,001' in"),
        ("10,500 robots", {"robots": 10_600}, "'10,500' in"),
    ],
)
def test_text_that_does_not(text: str, values: dict[str, float], problem: str) -> None:
    found = first_mismatch(text, values)
    assert found is not None
    assert problem in found


def test_a_range_shares_the_unit_of_its_end() -> None:
    assert [number.value for number in numerals("12\N{EN DASH}15 ms, 3 s")] == [0.012, 0.015, 3.0]


def cells(*sources: Any) -> list[dict[str, Any]]:
    """Return a notebook: texts, and the facts of code."""
    return [
        {"cell_type": "markdown", "source": source}
        if isinstance(source, str)
        else {"cell_type": "code", "source": "", "outputs": [{"metadata": {KEY: source}}]}
        for source in sources
    ]


def test_facts_are_for_the_text_below_until_the_next() -> None:
    seven = {"of": "", "values": [["robots", 7]]}
    three = {"of": "", "values": [["robots", 3]]}
    assert disagreements(cells("No number.", seven, "7 robots", three, "3 robots")) == []
    assert disagreements(cells("7 robots", seven, "7 robots", three, "3 robots")) != []
    assert disagreements(cells(seven, "7 robots", three, "7 robots")) != []
    assert disagreements(cells(seven, three, "3 robots")) != []


def test_facts_of_a_paragraph_above_say_how_it_begins() -> None:
    short = {"of": "**In short.**", "values": [["robots", 7]]}
    assert disagreements(cells("# Title\n\n**In short.** 7 robots.\n\nMore.", short)) == []
    assert disagreements(cells("# Title\n\n**In short.** 8 robots.\n\nMore.", short)) != []
    assert disagreements(cells("# Title\n\nMore.", short)) != []


def test_facts_are_kept_with_all_their_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[dict[str, Any]] = []

    def display(data: object, *, raw: bool, metadata: object) -> None:
        shown.append({"data": data, "raw": raw, "metadata": metadata})

    monkeypatch.setattr("discostorm_book.facts.display", display)
    facts(airtime=0.95412345, robots=7)
    assert shown == [
        {
            "data": {"text/plain": "airtime 0.9541, robots 7"},
            "raw": True,
            "metadata": {KEY: {"of": "", "values": [["airtime", "0.95412345"], ["robots", "7"]]}},
        }
    ]
