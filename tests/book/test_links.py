"""Every link and picture within the built book leads to a file, and to a place in it."""

import functools
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from bs4 import BeautifulSoup
from test_pages import PAGES

pytestmark = pytest.mark.book

#: What leads elsewhere, and where that is written.
LEADS = {"a": "href", "link": "href", "img": "src", "script": "src", "source": "src"}


@functools.cache
def parsed(path: Path) -> BeautifulSoup:
    return BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")


@functools.cache
def anchors(path: Path) -> frozenset[str]:
    """Return all places of a page that a link can name."""
    page = parsed(path)
    names = {str(element["name"]) for element in page.find_all("a", attrs={"name": True})}
    return frozenset(names | {str(element["id"]) for element in page.find_all(id=True)})


def leads(path: Path) -> Iterator[str]:
    """Yield what the links of a page within the book say."""
    for name, attribute in LEADS.items():
        for element in parsed(path).find_all(name, attrs={attribute: True}):
            lead = str(element[attribute])
            if not (urlsplit(lead).scheme or urlsplit(lead).netloc):
                yield lead


def fault(path: Path, lead: str, book: Path) -> str:
    """Return what is wrong with a link of a page; nothing if it leads somewhere."""
    parts = urlsplit(lead)
    target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
    if not target.is_relative_to(book):
        return f"{lead}: out of the book"
    if not target.is_file():
        return f"{lead}: no such file"
    place = unquote(parts.fragment)
    if place and target.suffix == ".html" and place not in anchors(target):
        return f"{lead}: no such place"
    return ""


@pytest.mark.parametrize("page", [*PAGES, "search", "index"])
def test_every_link_leads_somewhere(book: Path, page: str) -> None:
    book = book.resolve()
    path = book / f"{page}.html"
    found = set(leads(path))
    if page == "index":  # the front door only sends on
        found |= {
            str(meta["content"]).partition("url=")[2]
            for meta in parsed(path).find_all("meta", attrs={"http-equiv": "Refresh"})
        }
    assert found
    assert not [wrong for lead in sorted(found) if (wrong := fault(path, lead, book))]


@pytest.mark.parametrize("page", PAGES)
def test_every_place_has_a_name_of_its_own(book: Path, page: str) -> None:
    names = [str(element["id"]) for element in parsed(book / f"{page}.html").find_all(id=True)]
    assert len(names) > 10
    assert not {name for name in names if names.count(name) > 1}


@pytest.mark.parametrize(
    ("lead", "wrong"),
    [
        ("#there", ""),
        ("here.html#there", ""),
        ("", ""),
        ("#nowhere", "no such place"),
        ("here.html#nowhere", "no such place"),
        ("nowhere.html", "no such file"),
        ("../here.html", "out of the book"),
    ],
)
def test_a_fault_is_found(tmp_path: Path, lead: str, wrong: str) -> None:
    here = tmp_path / "book" / "here.html"
    here.parent.mkdir()
    here.write_text('<p id="there">', encoding="utf-8")
    assert fault(here, lead, here.parent).endswith(wrong)
    assert bool(fault(here, lead, here.parent)) == bool(wrong)
