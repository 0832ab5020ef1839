"""Say of each cell of a table whether its column is one of short words or of long sentences."""

from docutils import nodes
from sphinx.application import Sphinx

#: Letters up to which nothing in a column is broken, and beyond which it needs room.
SHORT, LONG = 18, 40


def _mark(app: Sphinx, doctree: nodes.document) -> None:
    for group in doctree.findall(nodes.tgroup):
        rows = [row.findall(nodes.entry) for body in group.findall(nodes.tbody) for row in body]
        for column in zip(*map(list, rows), strict=False):
            longest = max(len(cell.astext()) for cell in column)
            formula = any(next(cell.findall(nodes.math), None) for cell in column)
            kind = "short" if longest <= SHORT else "long" if longest > LONG else ""
            for cell in column if kind and not formula else ():
                cell["classes"].append(f"ds-{kind}")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("doctree-read", _mark)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
