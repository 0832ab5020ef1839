"""Say where lines of a page may end: not in names such as Wi-Fi or Fig. 2, nor between a number and
its unit; in a table, between parts of code.

A hyphen or a space that lines do not end at would be another character, which neither a search
nor a reader who copies the name would expect. So these are marks around the text, not in it.
"""

import re

from docutils import nodes
from sphinx.application import Sphinx

from discostorm import wording

_NAME = r"(?:Wi-Fi|ns-3|[A-Z]{1,3}-[A-Z]+s?|(?:Fig|Sec)\. [\dIV][\w.-]*)\b"
_WHOLE = re.compile(rf"\b({_NAME}|\d[\d.,]* {wording.UNIT_PATTERN})")
#: Letters of code up to which it is not parted.
_SHORT = 12
_PARTS = re.compile(r"(?<=\w[_/])(?=\w)|(?<=\w)(?=\.\w)")
_NO_TEXT = (nodes.literal, nodes.literal_block, nodes.raw, nodes.math, nodes.math_block)


def _keep(text: nodes.Text) -> None:
    parts: list[nodes.Node] = [
        nodes.inline("", part, classes=["ds-whole"]) if place % 2 else nodes.Text(part)
        for place, part in enumerate(_WHOLE.split(text.astext()))
        if part
    ]
    text.parent.replace(text, parts)


def _part(code: nodes.literal) -> None:
    first, *others = _PARTS.split(code.astext())
    code.children = []
    code += nodes.Text(first)
    for part in others:
        code += [nodes.raw("", "<wbr>", format="html"), nodes.Text(part)]


def _mark(app: Sphinx, tree: nodes.document, page: str) -> None:
    if app.builder.format != "html":
        return
    for text in list(tree.findall(nodes.Text)):
        if not isinstance(text.parent, _NO_TEXT) and _WHOLE.search(text.astext()):
            _keep(text)
    for cell in tree.findall(nodes.entry):
        for code in cell.findall(nodes.literal):
            if len(code.astext()) > _SHORT:
                _part(code)


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx: when pages are complete, and what is searched has been read."""
    app.connect("doctree-resolved", _mark)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
