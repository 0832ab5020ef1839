"""Configuration to copy for a remedy: pieces, each for a version of a product.

``data/vendors/snippets.csv`` lists the files of ``data/vendors/snippets/``: remedy, place, loading,
source, the hosts that need the file, and whether a test has its product load it.
"""

import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from discostorm.data import data_path, read_data

_NOT_RUN_NOTE = "not run here: compared with its documentation"
#: Patterns: a sample server, a listed sample robot, and in `load` the file and its variable.
_SERVER_PATTERN = r"192\.168\.1\.1([01])\b"
_ROBOT_PATTERN = r'( *<Peer Address="|"tcp/|)192\.168\.1\.2\d("/>|:7447"|)'
_SAVED_PATH = re.compile(r"save (?:as|in) ([\w./]+)")
_VARIABLE = re.compile(r"(?:process|router)[^;]* runs with (\w+)=([\w./:]+)(?:.*: (\w+)\))?")
#: How a comment begins and ends, by the suffix of the file; else as in a shell.
_COMMENT_MARKS = {"xml": ("<!-- ", " -->"), "json5": ("// ", ""), "cpp": ("// ", "")}


@dataclass(frozen=True)
class Snippet:
    """A piece of configuration, its source, and its place on a host."""

    file: str  #: its name; the suffix says the language
    where: str  #: place of the piece
    version: str  #: product and version
    source: str  #: documentation of its settings
    load: str  #: file name, environment variable, process
    host: str  #: each host, its router or start, the server, one on a robot, or by hand
    robots: str  #: whether it lists all robots, those before its own, or none
    run_here: bool  #: whether a test has the product load it

    @property
    def text(self) -> str:
        """The configuration text, below comments on its version, file path and loading."""
        begin, end = _COMMENT_MARKS.get(self.file.rpartition(".")[2], ("# ", ""))
        begun = f"{self.where} ({'tested with ' * self.run_here}{self.version})"
        comments = [begun, *textwrap.wrap(f"Load: {self.load}", 90)]
        comments += [] if self.run_here else [_NOT_RUN_NOTE.capitalize()]
        content = data_path(f"vendors/snippets/{self.file}").read_text(encoding="utf-8")
        return "".join(f"{begin}{line}{end}\n" for line in comments) + content

    @property
    def path(self) -> str | None:
        """The path of its file on a host; None for shell commands."""
        saved = _SAVED_PATH.search(self.load)
        return saved[1] if saved else None

    def filled(self, servers: Sequence[str], robots: Sequence[str]) -> str:
        """Return the text with these addresses in place of the sample servers and robots."""
        text = self.text
        found = [*re.finditer(_ROBOT_PATTERN, text)]
        if not found:  # no piece lists both
            given = dict(zip("01", servers, strict=False))
            return re.sub(_SERVER_PATTERN, lambda sample: given.get(sample[1], sample[0]), text)
        (first, *_, last), (before, after) = found, found[0].groups()
        listed = text[first.end() : found[1].start()].join(f"{before}{r}{after}" for r in robots)
        rest = text[last.end() :]
        return text[: first.start()] + listed + (rest if robots else rest.removeprefix(","))

    def environment(self, text: str) -> dict[str, str]:
        """Return the environment variables that a text of this piece sets."""
        if self.path is None:
            return dict(re.findall(r'^export (\w+)="?([^"\n]*)"?$', text, re.MULTILINE))
        named = _VARIABLE.search(self.load)
        return {name: named[2] for name in (named[1], named[3]) if name} if named else {}

    def to_dict(self) -> dict[str, Any]:
        """Return the keys of a piece in JSON."""
        checked = "loaded by the product in a test" if self.run_here else _NOT_RUN_NOTE
        keys = {name: getattr(self, name) for name in ("where", "version", "load")}
        return keys | {"checked": checked, "text": self.text}


def shell_commands(text: str) -> list[str]:
    """Return the lines of a piece for the shell that are no comments."""
    return [line for line in text.splitlines() if not line.startswith("#")]


def set_start_window(text: str, window: float) -> str:
    """Set the start window of a text (``WINDOW=``) [s]; leave texts without a window unchanged."""
    return re.sub(r"(?m)^WINDOW=\d+$", f"WINDOW={window:.0f}", text)


def snippets(kind: str, *names: str) -> tuple[Snippet, ...]:
    """Return the pieces for a kind of ``data/vendors/remedies.csv``.

    ``names`` are families, products or radios; pieces for any of them always come.
    """
    return tuple(
        Snippet(
            **{key: row[key] for key in row.keys() - {"kind", "for", "run_here"}},
            run_here=row["run_here"] == "yes",
        )
        for row in read_data("vendors/snippets.csv")
        if row["kind"] == kind and row["for"] in ("any", *names)
    )
