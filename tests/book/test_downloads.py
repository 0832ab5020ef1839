"""What readers take home: the data of every figure as CSV, and every chapter as a notebook."""

import io
import json
import os
import re
import subprocess
import sys
from base64 import b64decode
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from compare_facts import has_facts
from playwright.sync_api import Browser, Page
from support import ROOT
from test_chapter_style import TEACHING

from discostorm import figures
from discostorm_book import show

pytestmark = pytest.mark.book

CHAPTERS = sorted((ROOT / "notebooks").glob("*.ipynb"))
#: Pictures that show no data.
DRAWINGS = {"fig-paper-1", "fig-dds-ways", "fig-zenoh-ways"}
LINK = re.compile(
    r'<a download="(?P<file>[a-z0-9-]+\.csv)" '
    r'href="data:text/csv;charset=utf-8;base64,(?P<data>[A-Za-z0-9+/=]+)">[^<]+</a>'
)

every_chapter = pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)


def code_cells(path: Path) -> list[dict[str, Any]]:
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    return [cell for cell in cells if cell["cell_type"] == "code"]


def outputs(cell: dict[str, Any], kind: str) -> list[str]:
    found = (output.get("data", {}).get(kind) for output in cell["outputs"])
    return ["".join(text) for text in found if text is not None]


def figure_name(cell: dict[str, Any]) -> str:
    name = cell["metadata"].get("mystnb", {}).get("figure", {}).get("name", "")
    assert isinstance(name, str)
    return name


def pictures(path: Path) -> dict[str, str]:
    """Return the pictures in a notebook file, by name."""
    return {
        figure_name(cell): svg
        for cell in code_cells(path)
        for svg in outputs(cell, "image/svg+xml")
    }


@every_chapter
def test_each_figure_is_followed_by_its_data(path: Path) -> None:
    cells = code_cells(path)
    drawn = [cell for cell in cells if outputs(cell, "image/svg+xml")]
    with_data = [cell for cell in drawn if figure_name(cell) not in DRAWINGS]
    links = [LINK.fullmatch(text) for cell in cells for text in outputs(cell, "text/html")]
    links = [link for link in links if link and not link["file"].startswith("table-")]
    assert [link and link["file"] for link in links] == [
        f"{figure_name(cell)}.csv" for cell in with_data
    ]
    for cell in with_data:
        assert "show.download(" in "".join(cells[cells.index(cell) + 1]["source"])
    for link in filter(None, links):
        data = pd.read_csv(io.BytesIO(b64decode(link["data"], validate=True)))
        assert len(data) > 1
        assert not data.columns.str.startswith("Unnamed").any()
        assert not data.isna().all().any(), "a column that holds nothing"


def test_the_landing_page_offers_the_data_of_its_figure() -> None:
    page = (ROOT / "book" / "index.md").read_text(encoding="utf-8")
    assert page.count("figures.fig2()") == 1
    assert 'show.download(figures.fig2_data(), "fig-landing")' in page


@every_chapter
def test_pictures_are_inside_the_notebook(path: Path) -> None:
    assert all(svg.startswith(("<?xml", "<svg")) for svg in pictures(path).values())
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    prose = "".join("".join(c["source"]) for c in cells if c["cell_type"] == "markdown")
    # A picture beside the file would be lost on the way.
    assert not re.search(r"!\[|\{figure\}|\{image\}|<img", prose)


@every_chapter
def test_exercises_have_folded_executed_solutions(path: Path) -> None:
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    headings = [
        (index, heading)
        for index, cell in enumerate(cells)
        if cell["cell_type"] == "markdown"
        for heading in re.findall(r"(?m)^## (.+)$", "".join(cell["source"]))
    ]
    if path.stem in ("06_does_it_reproduce", "10b_releases", "12b_air"):
        return  # one or two screens; what they ask and answer is one fold, or the text
    if path.stem in TEACHING:
        return  # exercises stand where they are needed, see test_chapter_style.py
    names = [heading.replace("Exercises", "Exercise") for _, heading in headings[-2:]]
    assert names == ["Exercise", "The answer"]
    (first, _), (end, _) = headings[-2:]
    solutions = [cell for cell in cells[first:end] if cell["cell_type"] == "code"]
    if has_facts(cells):
        # The solution is text in a fold, and a cell above it computes its numbers.
        text = "".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
        assert 1 <= text.count(":::{dropdown} Answer\n") == len(solutions) <= 3
        for cell in solutions:
            assert {"hide-cell", "remove-output"} & {*cell["metadata"]["tags"]}
            assert "facts(" in "".join(cell["source"])
            assert cell["outputs"]
        return
    assert 1 <= len(solutions) <= 3
    for cell in solutions:
        assert cell["metadata"]["tags"] == ["hide-cell"]
        assert cell["metadata"]["mystnb"]["code_prompt_show"] == "Show the solution"
        assert "assert " in "".join(cell["source"])
        assert cell["outputs"]
        assert all("text/markdown" in output["data"] for output in cell["outputs"])


def downloaded_file(book: Path, chapter: str) -> Path:
    """Return the file to which the download button of a chapter leads."""
    page = book / "notebooks" / f"{chapter}.html"
    links = re.findall(r'href="([^"]+/_sources/[^"]+)"', page.read_text(encoding="utf-8"))
    (address,) = set(links)
    return (page.parent / address).resolve()


@every_chapter
def test_the_book_offers_every_chapter_as_executed(book: Path, path: Path) -> None:
    assert downloaded_file(book, path.stem).read_bytes() == path.read_bytes()


def test_a_downloaded_notebook_runs_and_keeps_its_figures(
    browser: Browser, server: str, tmp_path: Path
) -> None:
    with browser.new_page() as tab:
        tab.goto(server + "notebooks/03_hosts.html")
        tab.get_by_label("Download this page").click()
        with tab.expect_download() as saved:
            tab.get_by_role("link", name=".ipynb").click()
        assert saved.value.suggested_filename == "03_hosts.ipynb"
        copy = tmp_path / "03_hosts.ipynb"
        saved.value.save_as(copy)
    before = pictures(copy)
    assert before.keys() == {"fig-paper-2"}
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    ran = subprocess.run(
        [sys.executable, ROOT / "scripts/book/run_notebooks.py", copy],
        cwd=tmp_path,
        env=environment,
        text=True,
        capture_output=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    assert pictures(copy) == before
    assert [*tmp_path.iterdir()] == [copy]


@pytest.fixture(scope="module")
def chapter(browser: Browser, book: Path) -> Iterator[Page]:
    with browser.new_page() as tab:
        tab.goto((book / "notebooks" / "03_hosts.html").as_uri())
        yield tab


def test_data_is_saved_also_without_a_server(chapter: Page) -> None:
    with chapter.expect_download() as saved:
        chapter.get_by_role("link", name="Data of this figure").click()
    assert saved.value.suggested_filename == "fig-paper-2.csv"
    data = pd.read_csv(saved.value.path())
    assert [*data.columns] == ["protocol", "phase", "hosts", "utilization"]
    np.testing.assert_allclose(
        data["utilization"],
        figures.fig2_data()["utilization"],
        rtol=1e-9,  # ten digits
    )


def test_a_solution_opens_with_the_keyboard(chapter: Page) -> None:
    answer = chapter.get_by_text("Each process may have at most 4 endpoints")
    assert not answer.is_visible()
    chapter.locator("summary", has_text="Answer").last.focus()
    chapter.keyboard.press("Enter")
    answer.wait_for(state="visible")


@pytest.mark.parametrize("name", ["", "Fig 2", "fig-2.csv", "../fig", 'x"'])
def test_names_of_files_are_plain(name: str) -> None:
    with pytest.raises(ValueError, match=r"name must be made of lower-case letters") as error:
        show.download(pd.DataFrame({"hosts": [1]}), name)
    assert repr(name) in str(error.value)


def test_an_empty_table_is_no_data() -> None:
    with pytest.raises(ValueError, match="frame must have rows"):
        show.download(pd.DataFrame({"hosts": []}), "fig")


def test_a_named_index_is_in_the_file() -> None:
    frame = pd.DataFrame({"bytes": [414]}, index=pd.Index(["SPDP"], name="message"))
    assert show.download(frame, "fig").content == "message,bytes\nSPDP,414\n"
