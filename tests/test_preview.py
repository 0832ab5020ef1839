"""What pages tell messengers of themselves, with and without an address of the book."""

import re
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from docutils.utils import new_document
from sphinx.application import Sphinx
from sphinx.errors import ConfigError

sys.path.insert(0, str(Path(__file__).parents[1] / "book/_ext"))
preview = __import__("preview")


def told(address: str) -> dict[str, str]:
    """Return what the preview of a page holds, in a book with this address."""
    app = SimpleNamespace(config=SimpleNamespace(html_baseurl=address, project="x", html_title="y"))
    context: dict[str, Any] = {"pathto": lambda *_: "../", "title": "Any Wi-Fi"}
    page = new_document("page")
    preview._add(cast(Sphinx, app), "notebooks/11_any_wifi", "page.html", context, page)
    found = re.findall(r'(?:property|name)="([\w:]+)" content="([^"]*)"', context["metatags"])
    return dict(found)


@pytest.mark.parametrize("address", ["https://example.org/storm", "https://example.org/storm/"])
def test_once_the_address_is_known_page_and_picture_are_absolute(address: str) -> None:
    tags = told(address)
    assert tags["og:url"] == "https://example.org/storm/notebooks/11_any_wifi.html"
    assert tags["og:image"] == "https://example.org/storm/_static/preview.png"


def test_while_no_address_is_known_none_is_made_up() -> None:
    tags = told("")
    assert "og:url" not in tags
    assert tags["og:image"] == "../_static/preview.png"


@pytest.mark.parametrize("address", ["example.org/storm", "/storm/", "file:///storm"])
def test_an_address_that_is_none_is_refused(address: str) -> None:
    with pytest.raises(ConfigError, match=f"must be empty or an address .* got {address!r}"):
        told(address)
