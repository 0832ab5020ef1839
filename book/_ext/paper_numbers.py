"""Equations and figures of the paper, labeled eq-paper-N and fig-paper-N, carry its number N.

The others are numbered by chapter, without a gap; outside of chapters, where a number would be
taken for one of the paper's, there is none.
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
            for name, (*chapter, _) in [*numbers.items()]:
                if paper := _PAPER.fullmatch(name):
                    numbers[name] = (int(paper[1]),)
                elif not chapter:
                    del numbers[name]
                else:
                    before[kind, tuple(chapter)] += 1
                    numbers[name] = (*chapter, before[kind, tuple(chapter)])
    return []


def _latex(text: str) -> nodes.raw:
    return nodes.raw("", text, format="latex")


def _enclose(figure: nodes.figure, before: str, after: str) -> None:
    """Put commands for this figure alone around it."""
    parent = figure.parent
    at = parent.index(figure)
    parent.insert(at + 1, _latex(f"\\endgroup{after}\n"))
    parent.insert(at, _latex(f"\\begingroup{before}\n"))


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
    pages = app.env.toc_fignumbers.values()
    numbered = {name for of_page in pages for name in of_page.get("figure", {})}
    for figure in list(tree.findall(nodes.figure)):
        if figure["ids"] and numbered.isdisjoint(figure["ids"]):
            # LaTeX writes number, colon and caption: this takes the place of the first two.
            _enclose(figure, r"\makeatletter\def\fnum@figure:{\ignorespaces}\makeatother", "")
        elif paper := _PAPER.fullmatch((figure["ids"] or [""])[0]):
            _enclose(
                figure,
                rf"\renewcommand{{\thefigure}}{{{paper[1]}}}"
                rf"\renewcommand{{\theHfigure}}{{paper.{paper[1]}}}",
                r"\addtocounter{figure}{-1}",
            )


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx: after figures have been numbered, and before the pages are arranged."""
    app.connect("env-get-updated", _number, priority=900)
    app.connect("doctree-resolved", _number_in_print, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
