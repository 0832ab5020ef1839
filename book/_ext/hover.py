"""Show what a link to an equation, a figure or a chapter leads to: writes the index of hover.js."""

import json
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

#: By address from the book's root: what the preview of a link there shows.
_FOUND: dict[str, dict[str, Any]] = {}


def _collect(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    if app.builder.format != "html":
        return
    page = app.builder.get_target_uri(docname)
    title = doctree.next_node(nodes.title)
    boxes = (box for box in doctree.findall(nodes.admonition) if "question" in box["classes"])
    box = next(boxes, None)
    question = box.next_node(nodes.title) if box else doctree.next_node(nodes.block_quote)
    if title and question:
        _FOUND[page] = {"name": title.astext(), "text": " ".join(question.astext().split())}
        # The same by the anchor in front of the title.
        for anchor in title.parent["ids"]:
            _FOUND[f"{page}#{anchor}"] = _FOUND[page]
    for block in doctree.findall(nodes.math_block):
        if block.get("label"):
            text = block.astext().strip()
            if r"\\" in text and not block.get("nowrap"):
                text = rf"\begin{{split}}{text}\end{{split}}"
            place = nodes.make_id(f"equation-{block['label']}")
            _FOUND[f"{page}#{place}"] = {"tex": text}
    for figure in doctree.findall(nodes.figure):
        image, caption = figure.next_node(nodes.image), figure.next_node(nodes.caption)
        if image and caption:
            shown = {"name": "Figure", "text": caption.astext(), "image": image["uri"]}
            _FOUND.update({f"{page}#{anchor}": shown for anchor in figure["ids"]})


def _write(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        for shown in _FOUND.values():
            if shown.get("image") in app.builder.images:
                shown["image"] = f"_images/{app.builder.images[shown['image']]}"
        index = json.dumps(dict(sorted(_FOUND.items())), ensure_ascii=False, indent=0)
        path = Path(app.outdir, "_static", "hover-index.js")
        path.write_text(f"const HOVER_INDEX = {index};\n", encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("doctree-resolved", _collect)
    app.connect("build-finished", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
