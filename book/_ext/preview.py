"""What a link to a page shows where it is shared: title, description and a picture.

Once the book has an address, so has each page: here, in ``sitemap.xml``, and in a canonical link,
which Sphinx writes.
"""

import re
from html import unescape
from pathlib import Path
from textwrap import wrap
from typing import Any
from urllib.parse import urlsplit

import link_picture
import matplotlib
from docutils import nodes
from PIL import Image, ImageDraw, ImageFont
from sphinx.application import Sphinx
from sphinx.errors import ConfigError

from discostorm import DDS
from discostorm.figures import color_of

#: The picture of the first page; those of the others lie in the folder.
PICTURE = "_static/preview.png"
FOLDER = "_static/previews"
SIZE = (1200, 630)
#: Fonts that Matplotlib brings, of a title and of a text, and letters in a line of them.
_TITLE, _TEXT = ("DejaVuSans-Bold.ttf", 66, 26), ("DejaVuSans.ttf", 34, 52)

#: Characters of a description that search engines and messengers show.
MOST = 200


#: Characters that a paragraph has at least which says what a page is about.
_LEAST = 40


def _description(doctree: nodes.document) -> str:
    """Return the short answer of a page or else its first sentences, as long as they fit."""
    short, first = [], []
    for paragraph in doctree.findall(nodes.paragraph):
        text = " ".join(paragraph.astext().split())
        if text.startswith("In short. "):
            short.append(text.removeprefix("In short. "))
        elif isinstance(paragraph.parent, nodes.section):
            first.append(text)
    text = next((text for text in (*short, *first) if len(text) >= _LEAST), "")
    return text if len(text) <= MOST else text[:MOST].rsplit(" ", 1)[0] + " …"


def _plain(html: str) -> str:
    """Return a title without its markup."""
    return " ".join(unescape(re.sub(r"<[^>]*>", "", html)).split())


def _base(address: str) -> str:
    """Return the address of the book with a slash at its end, or nothing if none is known."""
    if not address:
        return ""
    if urlsplit(address).scheme not in {"http", "https"} or not urlsplit(address).netloc:
        raise ConfigError(
            "html.baseurl in _config.yml must be empty or an address such as "
            f"https://example.org/storm/; got {address!r}"
        )
    return address.rstrip("/") + "/"


def _add(
    app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: Any
) -> None:
    if doctree is None:
        return
    base = _base(app.config.html_baseurl)
    to_root = context["pathto"]("", 1).removesuffix(".").rstrip("/") + "/"
    title = _plain(context.get("title", app.config.html_title))
    picture = PICTURE
    if pagename != app.config.root_doc:
        picture = _picture(pagename)
    told = {
        ("property", "og:type"): "article",
        ("property", "og:site_name"): app.config.html_title,
        ("property", "og:title"): title,
        ("property", "og:description"): _description(doctree),
        ("property", "og:image"): (base or to_root) + picture,
        ("property", "og:image:width"): str(SIZE[0]),
        ("property", "og:image:height"): str(SIZE[1]),
        ("property", "og:image:alt"): title
        if pagename != app.config.root_doc
        else "Bars of the airtime that one to ten robots need, and a line at one second",
        ("name", "twitter:card"): "summary_large_image",
        ("name", "description"): _description(doctree),
    }
    if base:
        told["property", "og:url"] = f"{base}{pagename}.html"
    context["metatags"] = context.get("metatags", "") + "".join(
        f'\n<meta {kind}="{name}" content="{_quoted(text)}">' for (kind, name), text in told.items()
    )


def _picture(pagename: str) -> str:
    return f"{FOLDER}/{pagename.replace('/', '-')}.png"


def _draw_card(
    app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: Any
) -> None:
    """Draw the picture of a page when that is written, and so beside those of other pages."""
    if doctree is None or pagename == app.config.root_doc:
        return
    path = Path(app.outdir) / _picture(pagename)
    path.parent.mkdir(parents=True, exist_ok=True)
    title = _plain(context.get("title", app.config.html_title))
    _card(title, _description(doctree), app.config.html_short_title).save(path)


def _quoted(text: str) -> str:
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


def _draw(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        figure = link_picture.draw_link_picture(DDS, SIZE)
        figure.savefig(Path(app.outdir) / PICTURE, metadata={"Software": None})


def _card(title: str, text: str, book: str) -> Image.Image:
    """Return the picture of a page: its title, what it says first, and the book's name."""
    card = Image.new("RGB", SIZE, "white")
    pen = ImageDraw.Draw(card)
    pen.rectangle((0, 0, 18, SIZE[1]), fill=color_of(DDS))
    fonts = Path(matplotlib.get_data_path(), "fonts/ttf")
    down = 70
    for (file, size, letters), said, most, color in (
        (_TITLE, title, 3, "black"),
        (_TEXT, text, 5, "#3c4146"),
    ):
        font = ImageFont.truetype(str(fonts / file), size)
        lines = wrap(said, letters, max_lines=most, placeholder=" …")
        for line in lines:
            pen.text((80, down), line, fill=color, font=font)
            down += round(1.25 * size)
        down += 30
    font = ImageFont.truetype(str(fonts / _TITLE[0]), 28)
    pen.text((80, SIZE[1] - 70), book, fill=color_of(DDS), font=font)
    return card.quantize(32)


def _map(app: Sphinx, exception: Exception | None) -> None:
    base = _base(app.config.html_baseurl)
    if exception is None and app.builder.format == "html" and base:
        pages = "".join(
            f"  <url><loc>{_quoted(base)}{page}.html</loc></url>\n"
            for page in sorted(app.env.found_docs)
        )
        kind = 'xmlns="http://www.sitemaps.org/schemas/sitemap/0.9"'
        text = f'<?xml version="1.0" encoding="UTF-8"?>\n<urlset {kind}>\n{pages}</urlset>\n'
        (Path(app.outdir) / "sitemap.xml").write_text(text, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("html-page-context", _add)
    app.connect("html-page-context", _draw_card)
    app.connect("build-finished", _draw)
    app.connect("build-finished", _map)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
