"""What a link to a page shows where it is shared: title, description and a picture.

Once the book has an address, so has each page: here, in ``sitemap.xml``, and in a canonical link,
which Sphinx writes.
"""

from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ConfigError

from discostorm import DDS
from discostorm.book import storm

PICTURE = "_static/preview.png"
SIZE = (1200, 630)

#: Characters of a description that search engines and messengers show.
MOST = 200


def _description(doctree: nodes.document) -> str:
    """Return the first sentences of a page, as long as they fit."""
    for paragraph in doctree.findall(nodes.paragraph):
        if isinstance(paragraph.parent, nodes.section):
            text = " ".join(paragraph.astext().split())
            return text if len(text) <= MOST else text[:MOST].rsplit(" ", 1)[0] + " …"
    return ""


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
    title = nodes.Text(context.get("title", app.config.html_title)).astext()
    told = {
        ("property", "og:type"): "article",
        ("property", "og:site_name"): app.config.html_title,
        ("property", "og:title"): title,
        ("property", "og:description"): _description(doctree),
        ("property", "og:image"): (base or to_root) + PICTURE,
        ("property", "og:image:width"): str(SIZE[0]),
        ("property", "og:image:height"): str(SIZE[1]),
        ("property", "og:image:alt"): "Robots around an access point, and a bar of airtime",
        ("name", "twitter:card"): "summary_large_image",
        ("name", "description"): _description(doctree),
    }
    if base:
        told["property", "og:url"] = f"{base}{pagename}.html"
    context["metatags"] = context.get("metatags", "") + "".join(
        f'\n<meta {kind}="{name}" content="{_quoted(text)}">' for (kind, name), text in told.items()
    )


def _quoted(text: str) -> str:
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


def _draw(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        figure = storm.preview(DDS, SIZE)
        figure.savefig(Path(app.outdir) / PICTURE, metadata={"Software": None})


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
    app.connect("build-finished", _draw)
    app.connect("build-finished", _map)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
