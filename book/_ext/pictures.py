"""Figures of pages: their size, those for phones and dark pages, files to save, how to cite."""

import json
import posixpath
import re
from functools import cache
from html import escape, unescape
from pathlib import Path
from typing import Any

import yaml  # type: ignore[import-untyped]
from dark import dark_picture
from sphinx.application import Sphinx

from discostorm_book.show import PHONE_KEY

#: As custom.js and custom.css call a screen narrow.
_PHONE = "(width < 37.5rem)"
_FIGURE = re.compile(
    r'(?P<start><figure [^>]*id="(?P<name>fig-[\w-]+)"[^>]*>\s*(?:<a [^>]*>)?)'
    r'(?P<image><img [^>]*?src="(?P<source>[^"]+\.svg)"[^>]*?)(?P<close>\s*/?>)'
    r"(?P<rest>.*?)</figure>",
    re.S,
)
_SIZE = re.compile(
    r'<svg\b[^>]*?\s(width|height)="([\d.]+)(pt|px)?"[^>]*?\s(?:width|height)="([\d.]+)'
)
#: CSS pixels of a point.
_PIXELS = {"pt": 4 / 3}


def _size(svg: str) -> str:
    """Return the size of a picture as attributes, so that nothing moves when it has come."""
    found = _SIZE.search(svg)
    if not found:
        raise ValueError(f"a picture says not how large it is: {svg[:200]!r}")
    first, one, unit, other = found.groups()
    second = "width" if first == "height" else "height"
    factor = _PIXELS.get(unit, 1)
    sizes = {first: float(one) * factor, second: float(other) * factor}
    return f'width="{sizes["width"]:.0f}" height="{sizes["height"]:.0f}"'


def _narrow(app: Sphinx, page: str) -> dict[str, str]:
    """Return the pictures for phones that a page keeps, by the figure's name."""
    path = Path(app.srcdir) / f"{page}.ipynb"
    if not path.exists():  # a page in Markdown is executed by the build
        path = Path(app.outdir).parent / "jupyter_execute" / f"{page}.ipynb"
    if not path.exists():
        return {}
    return {
        cell["metadata"]["mystnb"]["figure"]["name"]: output["metadata"]["image/svg+xml"][PHONE_KEY]
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if "figure" in cell["metadata"].get("mystnb", {})
        for output in cell.get("outputs", ())
        if PHONE_KEY in output.get("metadata", {}).get("image/svg+xml", {})
    }


@cache
def _cff(path: Path) -> dict[str, Any]:
    read: dict[str, Any] = yaml.safe_load(path.read_text(encoding="utf-8"))
    return read


def citation(app: Sphinx, page: str, name: str, caption: str, title: str) -> str:
    """Return how to cite a figure of a page, as text."""
    cff = _cff(Path(app.srcdir) / "CITATION.cff")
    authors = " and ".join(author["name"] for author in cff["authors"])
    number = re.search(r'class="caption-number">([^<]*)', caption)
    shown = unescape(number[1]).strip() if number else "Figure"
    title = unescape(re.sub(r"<[^>]*>", "", title))
    base = app.config.html_baseurl.rstrip("/")
    where = f"{base}/{page}.html#{name}" if base else f"{page}.html#{name}"
    doi = f" doi:{cff['doi']}." if "doi" in cff else ""
    return (
        f"{authors} ({cff['date-released'].year}). {shown} in “{title}”, {app.config.html_title},"
        f" version {cff['version']}.{doi} {where}. License: CC BY 4.0."
    )


def _improve(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    body = context.get("body")
    if not body or app.builder.format != "html":
        return
    narrow = _narrow(app, page)
    folder = Path(app.outdir) / "_images"
    to_images = context["pathto"]("_images", 1)
    names = {file: source for source, file in app.builder.images.items()}
    rules: list[str] = []

    def darken(name: str, file: str, svg: str, media: str) -> None:
        """Write a picture for dark pages, and the rule that shows it there instead of the other."""
        dark = f"{Path(file).stem}-dark.svg"
        folder.mkdir(exist_ok=True)
        (folder / dark).write_text(dark_picture(svg), encoding="utf-8")
        shown = f'html[data-theme="dark"] #{name} img {{ content: url({to_images}/{dark}) }}'
        rules.append(f"@media {media} {{ {shown} }}")

    def improve(found: re.Match[str]) -> str:
        name, file = found["name"], posixpath.basename(found["source"])
        svg = (Path(app.srcdir) / names[file]).read_text(encoding="utf-8")
        image = f"{found['image']} {_size(svg)}{found['close']}"
        darken(name, file, svg, "screen")
        if name in narrow:
            darken(name, f"{name}-narrow.svg", narrow[name], f"screen and {_PHONE}")
            (folder / f"{name}-narrow.svg").write_text(narrow[name], encoding="utf-8")
            image = (
                f'<picture><source media="{_PHONE}" srcset="{to_images}/{name}-narrow.svg" '
                f"{_size(narrow[name])}>{image}</picture>"
            )
        # A script can read a script, but no picture, from a file.
        entry = f"{json.dumps(name)}: {json.dumps(svg)}"
        text = f"window.PICTURES = {{ ...window.PICTURES, {entry} }};\n"
        (folder / f"{name}.js").write_text(text, encoding="utf-8")
        cite = escape(citation(app, page, name, found["rest"], context["title"]))
        tools = (
            f'<div class="ds-tools"><a href="{found["source"]}" download="{name}.svg">SVG</a>'
            f'<button type="button" data-picture="{to_images}/{name}.js" hidden>PNG</button>'
            f"<details><summary>Cite this figure</summary><p>{cite}</p></details></div>"
        )
        return f"{found['start']}{image}{found['rest']}{tools}\n</figure>"

    context["body"] = _FIGURE.sub(improve, body)
    style = f"<style>{' '.join(rules)}</style>" if rules else ""
    context["metatags"] = context.get("metatags", "") + style


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("html-page-context", _improve)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
