"""What the pages say of the model's numbers: their assumptions stand with them."""

import json
import re

import pytest
import yaml
from support import ROOT
from test_pages import TOC, toc_files

import discostorm as ds

#: In which direction a number errs for what it leaves out.
DIRECTIONS = {"more", "less", "either", "later"}


def prose(page: str) -> str:
    """Return what a page of the book says: its Markdown, and what its code prints."""
    path = ROOT / page
    if path.with_suffix(".md").exists():
        return path.with_suffix(".md").read_text(encoding="utf-8")
    cells = json.loads(path.with_suffix(".ipynb").read_text(encoding="utf-8"))["cells"]
    return "\n\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")


PAGES = {
    page: prose(page) for page in sorted(toc_files(yaml.safe_load(TOC.read_text(encoding="utf-8"))))
}


def left_out() -> dict[str, str]:
    """Return what the page of limits lists, with the direction."""
    rows = re.findall(r"^\| (.+?) \| (.+?) \| .+ \|$", PAGES["book/limits"], re.MULTILINE)
    return {what: direction for what, direction in rows if what != "left out" and "---" not in what}


def test_whatever_the_model_leaves_out_has_a_direction() -> None:
    rows = left_out()
    assert len(rows) > 20
    assert set(rows.values()) == DIRECTIONS
    for direction in DIRECTIONS:
        assert f"**{direction}**" in PAGES["book/limits"]


@pytest.mark.parametrize(
    ("what", "direction"),
    [
        ("Collisions", "more"),
        ("Lost frames", "more"),
        ("Queues of limited", "either"),
        ("RTS and CTS; protection", "more"),
        ("TXOP", "less"),
        ("DTIM", "later"),
        ("OFDMA", "either"),
        ("LDPC", "more"),
        ("faster DSSS rates", "less"),
        ("Submessages packed", "less"),
        ("Concurrent back-off", "less"),
        ("A-MSDU", "less"),
        ("start spacing", "more"),
        ("Opening of sessions", "more"),
    ],
)
def test_what_is_left_out_is_listed_once(what: str, direction: str) -> None:
    assert [found for name, found in left_out().items() if what in name] == [direction]


def test_every_page_that_speaks_of_what_is_left_out_links_to_the_list() -> None:
    speaks = re.compile(r"lower bound|collision|collides|aggregat|retransmission", re.IGNORECASE)
    speaking = {page: text for page, text in PAGES.items() if speaks.search(text)}
    speaking["README"] = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(speaking) > 8
    link = re.compile(r"limits\.md|<limits>")
    assert [page for page, text in speaking.items() if not link.search(text)] == ["book/limits"]


def test_whoever_names_a_product_says_that_its_messages_differ() -> None:
    names = "|".join(name for name, protocol in ds.PROTOCOLS.items() if protocol.repeats)
    timed = {
        page: text
        for page, text in PAGES.items()
        if re.search(
            rf"(periods|defaults?) of ({names})|({names})('s)? timers|({names}) does by default",
            text,
        )
    }
    assert {"book/index", "notebooks/07_what_100_percent_means"} <= timed.keys()
    assert [page for page, text in timed.items() if "products-differ" not in text] == []
