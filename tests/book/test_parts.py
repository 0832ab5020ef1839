"""How the book goes on: each part opens with its question, each chapter points to the next one."""

import json
import re
from itertools import pairwise

import pytest
import yaml
from support import ROOT, TOC

PARTS = yaml.safe_load(TOC.read_text(encoding="utf-8"))["parts"]
#: The page that opens a part, and the chapters of the part.
OPENINGS = {
    part["chapters"][0]["file"]: [chapter["file"] for chapter in PARTS[place + 1]["chapters"]]
    for place, part in enumerate(PARTS)
    if part["chapters"][0]["file"].startswith("book/part_")
}
#: All that have numbers, in the order of the book.
CHAPTERS = [file for files in OPENINGS.values() for file in files]


def markdown(chapter: str) -> list[str]:
    cells = json.loads((ROOT / f"{chapter}.ipynb").read_text(encoding="utf-8"))["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]


def label(chapter: str) -> str:
    found = re.match(r"\(([\w-]+)\)=", markdown(chapter)[0])
    assert found, chapter
    return found[1]


def test_every_numbered_part_has_an_opening() -> None:
    numbered = [part for part in PARTS if part.get("numbered")]
    assert [[chapter["file"] for chapter in part["chapters"]] for part in numbered] == list(
        OPENINGS.values()
    )
    # The caption stands above the opening.
    assert all("caption" not in part for part in numbered)


@pytest.mark.parametrize("page", OPENINGS)
def test_a_part_opens_with_its_question_and_leads_to_its_chapters(page: str) -> None:
    text = (ROOT / f"{page}.md").read_text(encoding="utf-8")
    title = re.search(r"^# (.+)$", text, re.MULTILINE)
    assert title
    assert title[1].endswith("?")
    assert 120 <= len(text.split()) <= 220  # half a page
    linked = re.findall(r"\{numref\}`[^`]*<([\w-]+)>`", text)
    assert set(linked) == {label(chapter) for chapter in OPENINGS[page]}
    assert linked == sorted(linked, key=[label(chapter) for chapter in CHAPTERS].index)


@pytest.mark.parametrize(("chapter", "after"), list(pairwise(CHAPTERS)), ids=CHAPTERS[:-1])
def test_a_chapter_points_to_the_next_one(chapter: str, after: str) -> None:
    (text,) = (text for text in markdown(chapter) if "**What is next.**" in text)
    links = re.findall(r"\{numref\}`[^`]*<([\w-]+)>`", text.partition("**What is next.**")[2])
    assert links[:1] == [label(after)]
