"""What pages tell messengers of themselves, with and without an address of the book."""

import re
from pathlib import Path
from threading import Thread
from types import SimpleNamespace
from typing import Any, cast
from urllib.error import HTTPError
from urllib.request import urlopen
from xml.etree import ElementTree

import pytest
from docutils import nodes
from docutils.utils import new_document
from sphinx.application import Sphinx
from sphinx.errors import ConfigError

preview = __import__("preview")
#: Of the page that is told of.
PICTURE = "_static/previews/notebooks-08_any_wifi.png"
make_server = __import__("serve_book").make_server


def preview_content(address: str) -> dict[str, str]:
    """Return what the preview of a page holds, in a book with this address."""
    config = SimpleNamespace(
        html_baseurl=address, project="x", html_title="y", root_doc="book/index"
    )
    app = SimpleNamespace(config=config)
    title = '<span class="section-number">8. </span>Any <em>Wi-Fi</em> &amp; more'
    context: dict[str, Any] = {"pathto": lambda *_: "../", "title": title}
    page = new_document("page")
    preview._add(cast(Sphinx, app), "notebooks/08_any_wifi", "page.html", context, page)
    found = re.findall(r'(?:property|name)="([\w:]+)" content="([^"]*)"', context["metatags"])
    return dict(found)


@pytest.mark.parametrize("address", ["https://example.org/storm", "https://example.org/storm/"])
def test_once_the_address_is_known_page_and_picture_are_absolute(address: str) -> None:
    tags = preview_content(address)
    assert tags["og:url"] == "https://example.org/storm/notebooks/08_any_wifi.html"
    assert tags["og:image"] == "https://example.org/storm/" + PICTURE


def test_while_no_address_is_known_none_is_made_up() -> None:
    tags = preview_content("")
    assert "og:url" not in tags
    assert tags["og:image"] == "../" + PICTURE


def test_a_title_has_no_markup() -> None:
    assert preview_content("")["og:title"] == "8. Any Wi-Fi &amp; more"


def test_a_description_says_what_a_page_is_about_and_not_a_label() -> None:
    page = new_document("page")
    section = nodes.section("", nodes.title("", "A title"), nodes.paragraph("", "In a text:"))
    text = "Each robot costs more than the one before it. " * 9
    page += section
    section += nodes.paragraph("", "In short. " + text)
    said = preview._description(page)
    assert said.startswith("Each robot")
    assert said.endswith(" …")
    assert len(said) <= preview.MOST + 2


def test_a_page_that_begins_with_a_scene_is_described_by_its_short_answer() -> None:
    page = new_document("page")
    section = nodes.section("", nodes.paragraph("", "Three robots stand in a hall. " * 3))
    box = nodes.admonition(
        "", nodes.paragraph("", "In short. They send far more messages than you would expect.")
    )
    page += section
    section += box
    assert preview._description(page) == "They send far more messages than you would expect."


def test_a_card_has_the_size_that_is_told_and_words_on_it() -> None:
    card = preview._card("A title " * 20, "A text. " * 60, "The book")
    assert card.size == preview.SIZE
    assert len(card.getcolors()) > 3


@pytest.mark.parametrize("address", ["example.org/storm", "/storm/", "file:///storm"])
def test_an_address_that_is_none_is_refused(address: str) -> None:
    with pytest.raises(ConfigError, match=f"must be empty or an address .* got {address!r}"):
        preview_content(address)


def test_a_book_with_an_address_has_a_site_map(tmp_path: Path) -> None:
    def book(address: str, exists: bool) -> None:
        app = SimpleNamespace(
            config=SimpleNamespace(html_baseurl=address),
            builder=SimpleNamespace(format="html"),
            env=SimpleNamespace(found_docs={"notebooks/08_any_wifi", "book/index"}),
            outdir=tmp_path,
        )
        preview._map(cast(Sphinx, app), None)
        assert (tmp_path / "sitemap.xml").exists() is exists

    book("", False)
    book("https://example.org/storm", True)
    places = [
        place.text
        for place in ElementTree.parse(tmp_path / "sitemap.xml").iter()
        if place.tag.endswith("}loc")
    ]
    page = "https://example.org/storm/"
    assert places == [f"{page}book/index.html", f"{page}notebooks/08_any_wifi.html"]


def test_a_book_is_served_below_an_address(tmp_path: Path) -> None:
    (tmp_path / "page.html").write_text("a page")
    with make_server(tmp_path, "/discostorm/", 0) as serving:
        Thread(target=serving.serve_forever, daemon=True).start()
        root = f"http://127.0.0.1:{serving.server_port}"
        with urlopen(f"{root}/discostorm/page.html?x#y") as answer:
            assert answer.read() == b"a page"
        for outside in ("/page.html", "/", "/discostorm/../../etc/passwd"):
            with pytest.raises(HTTPError, match="404"):
                urlopen(root + outside)
        serving.shutdown()


def test_a_base_without_its_slashes_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="must begin and end with /"):
        make_server(tmp_path, "discostorm")
