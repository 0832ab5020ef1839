"""Editions of the book: all say what they were made from; the printed one is in parts."""

import subprocess
from os import PathLike

from docutils import nodes
from sphinx.addnodes import start_of_file, toctree
from sphinx.application import Sphinx
from sphinx.config import Config

import discostorm


def _commit(folder: str | PathLike[str]) -> str:
    """Return the commit that is checked out, or nothing outside of a git checkout."""
    done = subprocess.run(
        ["git", "describe", "--always", "--dirty", "--abbrev=8", "--exclude=*"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stdout.strip()


def _set_release(app: Sphinx, config: Config) -> None:
    commit = _commit(app.srcdir)
    config.version = discostorm.__version__
    config.release = f"{discostorm.__version__} ({commit})" if commit else config.version
    config.latex_elements["releasename"] = "Version"


def _latex(text: str) -> nodes.raw:
    return nodes.raw("", text, format="latex")


def _arrange_for_print(app: Sphinx, tree: nodes.document, name: str) -> None:
    """Make the landing page a preface, the contents' captions parts, numbers those of the HTML."""
    if app.builder.name != "latex":
        return
    chapters = {node["docname"]: node for node in tree.findall(start_of_file)}
    for chapter in chapters.values():
        chapter.parent.remove(chapter)
    landing = next(tree.findall(nodes.section))
    title, *text = landing.children
    landing.children = []
    landing += [title, _latex(r"\setcounter{secnumdepth}{-1}")]
    landing += nodes.section("", nodes.title("", "Preface"), *text, ids=["preface"])
    for contents in app.env.get_doctree(name).findall(toctree):
        number, _, caption = contents["caption"].rpartition(": ")
        depth = 2 if number else -1
        landing += _latex(rf"\setcounter{{secnumdepth}}{{{depth}}}\part{{{caption}}}")
        landing += [chapters[chapter] for _, chapter in contents["entries"]]


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("config-inited", _set_release)
    app.connect("doctree-resolved", _arrange_for_print)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
