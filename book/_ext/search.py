"""Search by section: what the search page reads, made from what the pages say."""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

_CODE = (nodes.literal_block, nodes.doctest_block)
#: What Python writes of an object that pages show in another form.
_OF_PYTHON = re.compile(r"<[\w.]+ object>|<Figure .*>")
_UNREAD = (nodes.math_block, nodes.raw, nodes.comment, nodes.system_message)


def _words(node: nodes.Node, env: BuildEnvironment) -> Iterator[tuple[bool, str]]:
    """Yield whether it is code, and the text, of all that stands in a section itself."""
    for child in node.children:
        if isinstance(child, (nodes.section, nodes.title, *_UNREAD)):
            continue
        if isinstance(child, (*_CODE, nodes.paragraph, nodes.caption, nodes.term, nodes.rubric)):
            text = " ".join(_text(child, env).split())
            if not _OF_PYTHON.fullmatch(text):
                yield isinstance(child, _CODE), text
        else:
            yield from _words(child, env)


def _text(node: nodes.Node, env: BuildEnvironment) -> str:
    """Return the text of a paragraph; of its formulas those that read without TeX."""
    if isinstance(node, _UNREAD):
        return " "
    if isinstance(node, addnodes.pending_xref):
        return _link_text(node, env)
    if isinstance(node, (nodes.math, nodes.Text)):
        text = str(node.astext())
        return "…" if isinstance(node, nodes.math) and "\\" in text else text
    return "".join(_text(child, env) for child in node.children)


def _link_text(node: addnodes.pending_xref, env: BuildEnvironment) -> str:
    """Return what a link says, with the number of its chapter; nothing if it says its label."""
    said, label = str(node.astext()), str(node["reftarget"])
    page, _ = env.domaindata["std"]["anonlabels"].get(label, ("", ""))
    number = ".".join(map(str, env.toc_secnumbers.get(page, {}).get("", ())))
    return said.replace("{number}", number) if said != label else ""


def _sections(app: Sphinx) -> Iterator[dict[str, str]]:
    numbers = app.env.toc_secnumbers
    for name in sorted(app.env.found_docs):
        tree = app.env.get_doctree(name)
        page = app.env.titles[name].astext()
        address = app.builder.get_target_uri(name)
        for section in tree.findall(nodes.section):
            title = next(section.findall(nodes.title)).astext()
            words = [*_words(section, app.env)]
            anchor = "" if isinstance(section.parent, nodes.document) else f"#{section['ids'][0]}"
            yield {
                "title": title,
                "page": page,
                "number": ".".join(map(str, numbers.get(name, {}).get("", ()))),
                "url": address + anchor,
                "text": " ".join(text for is_code, text in words if not is_code and text),
                "code": " ".join(text for is_code, text in words if is_code),
            }


def _no_other_index(app: Sphinx) -> None:
    if app.builder.format == "html":
        app.builder.search = False  # type: ignore[attr-defined]


def _page(app: Sphinx) -> Iterator[tuple[str, dict[str, Any], str]]:
    yield "search", {"title": "Search"}, "search.html"


def _write(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        found = ",\n".join(json.dumps(each, ensure_ascii=False) for each in _sections(app))
        path = Path(app.outdir) / "_static" / "search" / "sections.js"
        path.write_text(f"window.SECTIONS = [\n{found}\n];\n", encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("builder-inited", _no_other_index)
    app.connect("html-collect-pages", _page)
    app.connect("build-finished", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
