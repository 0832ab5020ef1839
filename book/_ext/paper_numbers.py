"""Equations and figures of the paper, labeled eq-paper-N and fig-paper-N, carry its number N.

The others are numbered by chapter, without a gap.
"""

import re
from collections import Counter

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.math import wrap_displaymath

_PAPER = re.compile(r"(?:equation-eq|eq|fig)-paper-(\d+)")


def _number(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Give the paper's number to what has one, and close the gaps that this leaves."""
    before: Counter[tuple[str, tuple[int, ...]]] = Counter()
    for of_page in env.toc_fignumbers.values():
        for kind, numbers in of_page.items():
            for name, (*chapter, _) in numbers.items():
                if paper := _PAPER.fullmatch(name):
                    numbers[name] = (int(paper[1]),)
                else:
                    before[kind, tuple(chapter)] += 1
                    numbers[name] = (*chapter, before[kind, tuple(chapter)])
    return []


def _latex(text: str) -> nodes.raw:
    return nodes.raw("", text, format="latex")


def _number_in_print(app: Sphinx, tree: nodes.document, name: str) -> None:
    """Do the same where LaTeX counts."""
    if app.builder.name != "latex":
        return
    for block in list(tree.findall(nodes.math_block)):
        if paper := _PAPER.fullmatch(block.get("label") or ""):
            label = f"equation:{block['docname']}:{block['label']}"
            text = wrap_displaymath(block.astext(), label, numbering=True)
            block.replace_self(
                _latex(text.replace("\\label", rf"\tag{{{paper[1]}}}\label", 1) + "\n")
            )
    for figure in list(tree.findall(nodes.figure)):
        if paper := _PAPER.fullmatch((figure["ids"] or [""])[0]):
            begin, end = (
                _latex(
                    rf"\begingroup\renewcommand{{\thefigure}}{{{paper[1]}}}"
                    rf"\renewcommand{{\theHfigure}}{{paper.{paper[1]}}}" + "\n"
                ),
                _latex("\\endgroup\\addtocounter{figure}{-1}\n"),
            )
            parent = figure.parent
            at = parent.index(figure)
            parent.insert(at + 1, end)
            parent.insert(at, begin)


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx: after figures have been numbered, and before the pages are arranged."""
    app.connect("env-get-updated", _number, priority=900)
    app.connect("doctree-resolved", _number_in_print, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
