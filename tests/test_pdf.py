"""The PDF that `make pdf` made last: A4, no blank pages, vectors, numbered as the HTML."""

import re
from pathlib import Path

import pytest
import yaml
from bs4 import BeautifulSoup
from conftest import HTML, missing, newest, sources
from pypdf import PdfReader
from test_browser import PAGES, source

import discostorm as ds

pytestmark = pytest.mark.book

ROOT = Path(__file__).parents[1]
PDF = ROOT / "build" / "discostorm.pdf"
#: Where LaTeX says which number and page a label got.
LABELS = ROOT / "_build" / "latex" / "discostorm.aux"
LABEL = re.compile(r"\\newlabel\{equation:([\w/]+):([\w-]+)\}\{\{(.*?)\}\{(\d+)\}")


@pytest.fixture(scope="module")
def pdf() -> PdfReader:
    if not (PDF.exists() and LABELS.exists()):
        missing("no PDF here: run `make pdf`")
    if PDF.stat().st_mtime < newest(sources()):
        missing("the PDF is older than its sources: run `make pdf`")
    return PdfReader(PDF)


@pytest.fixture(scope="module")
def text(pdf: PdfReader) -> list[str]:
    return [page.extract_text() for page in pdf.pages]


def printed_equations() -> dict[tuple[str, str], tuple[str, str]]:
    """Return number and printed page of each equation, by its page in the HTML and its label."""
    lines = LABELS.read_text(encoding="utf-8")
    return {(m[1], m[2]): (m[3], m[4]) for m in LABEL.finditer(lines)}


def test_pages_are_a4_and_none_is_blank(pdf: PdfReader, text: list[str]) -> None:
    sizes = {(round(float(p.mediabox.width)), round(float(p.mediabox.height))) for p in pdf.pages}
    assert sizes == {(595, 842)}
    assert len(text) > 100
    # A head and a foot alone have fewer letters; a page of a part has a number and a word.
    bare = [n for n, words in enumerate(text) if len("".join(words.split())) < 120]
    parts = [n for n in bare if re.match(r"Part\s+[IV]+\s+\w+\s+\d+$", text[n].strip())]
    assert len(parts) == len(yaml.safe_load((ROOT / "_toc.yml").read_text())["parts"])
    assert [n for n in bare if n not in parts] == [0]  # the title page


def test_the_title_page_says_version_and_commit(text: list[str]) -> None:
    assert "DiscoveryStorm,executable" in "".join(text[0].split())
    assert re.search(rf"{re.escape(ds.__version__)} \([0-9a-f]{{8}}(-dirty)?\)", text[0])


def test_figures_are_vectors(pdf: PdfReader) -> None:
    drawn = 0
    for page in pdf.pages:
        assert not page.images, "pixels"
        drawings = page["/Resources"].get("/XObject") or {}  # type: ignore[union-attr]
        drawn += sum(thing.get_object()["/Subtype"] == "/Form" for thing in drawings.values())
    assert drawn == sum(len(source(page)[1]) for page in PAGES)


def test_equations_are_numbered_as_in_the_html(pdf: PdfReader, text: list[str]) -> None:
    if not HTML.exists():
        missing("no HTML here: run `make book`")
    shown = {}
    for page in PAGES:
        html = BeautifulSoup((HTML / f"{page}.html").read_text(encoding="utf-8"), "html.parser")
        for equation in html.select("div.math[id^=equation-]"):
            number = equation.select_one(".eqno")
            assert number is not None
            label = str(equation["id"]).removeprefix("equation-")
            shown[page, label] = number.get_text().strip("()\N{PILCROW SIGN}# ")
    printed = printed_equations()
    assert len(shown) > 50
    assert {label: number for label, (number, _) in printed.items()} == shown
    pages = dict(zip(pdf.page_labels, text, strict=True))
    assert not {n for n, page in printed.values() if f"({n})" not in pages[page]}
