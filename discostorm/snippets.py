"""Configuration to copy for a remedy: pieces, each for a version of a product.

``data/vendors/snippets.csv`` has for each file of ``data/vendors/snippets/`` its remedy, place,
loading and source, and whether ``tests/lab/test_snippets.py`` has its product load it.
"""

import textwrap
from dataclasses import dataclass
from typing import Any

from discostorm.data import data_path, read_data

_NOT_RUN = "not run here: compared with its documentation"
#: How a comment begins and ends, by the suffix of the file; else as in a shell.
_COMMENTS = {"xml": ("<!-- ", " -->"), "json5": ("// ", ""), "cpp": ("// ", "")}


@dataclass(frozen=True)
class Snippet:
    """A piece of configuration, and where it comes from and goes."""

    file: str  #: its name; the suffix says the language
    where: str  #: place of the piece
    version: str  #: product and version
    source: str  #: documentation of its settings
    load: str  #: file name, environment variable, process
    run_here: bool  #: whether a test has the product load it

    @property
    def text(self) -> str:
        """The piece, below comments on its version, its place and how it is loaded."""
        begin, end = _COMMENTS.get(self.file.rpartition(".")[2], ("# ", ""))
        comments = [f"{self.version}: {self.where}", *textwrap.wrap(f"Load: {self.load}", 90)]
        comments += [] if self.run_here else [_NOT_RUN.capitalize()]
        content = data_path(f"vendors/snippets/{self.file}").read_text(encoding="utf-8")
        return "".join(f"{begin}{line}{end}\n" for line in comments) + content

    def to_dict(self) -> dict[str, Any]:
        """Return the keys of a piece in JSON."""
        checked = "loaded by the product in a test" if self.run_here else _NOT_RUN
        keys = {name: getattr(self, name) for name in ("where", "version", "load")}
        return keys | {"checked": checked, "text": self.text}


def snippets(kind: str, *names: str) -> tuple[Snippet, ...]:
    """Return the pieces for a kind of ``data/vendors/remedies.csv``.

    ``names`` are families, products or radios; pieces for any of them always come.
    """
    return tuple(
        Snippet(
            **{key: row[key] for key in ("file", "where", "version", "source", "load")},
            run_here=row["run_here"] == "yes",
        )
        for row in read_data("vendors/snippets.csv")
        if row["kind"] == kind and row["for"] in ("any", *names)
    )
