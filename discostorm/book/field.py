"""The page "What is wrong with my robots?": what it shows of the tables of ``data/field/``."""

from IPython.display import Markdown

from discostorm.data import read_data
from discostorm.planner.snippets import snippets

#: By the end of a file's name, what its text is colored as.
LANGUAGES = {
    "sh": "bash",
    "xml": "xml",
    "json5": "javascript",
    "conf": "ini",
    "cpp": "cpp",
    "launch": "python",
}


def paste(kind: str, *names: str, only: str = "") -> Markdown:
    """Return what to paste for a kind of remedy, each piece in a fold.

    Parameters
    ----------
    kind : str
        A kind of ``data/vendors/remedies.csv``.
    *names : str
        Families or products that it is for; what is for any is always there.
    only : str, optional
        What the names of its files must have in them.

    Raises
    ------
    ValueError
        If there is nothing to paste.
    """
    pieces = [piece for piece in snippets(kind, *names) if only in piece.file]
    if not pieces:
        raise ValueError(f"kind must be one that has something to paste; got {kind!r}")
    return Markdown(
        "\n\n".join(
            f"````{{dropdown}} To paste: {piece.file}, {piece.where}\n"
            f"```{LANGUAGES[piece.file.rsplit('.', 1)[-1]]}\n{piece.text.rstrip()}\n```\n````"
            for piece in pieces
        )
    )


def asked(entry: str) -> Markdown:
    """Return who asked what an entry answers, what helped there, and the sources of the entry."""
    threads = [row for row in read_data("field/threads.csv") if row["entry"] == entry]
    sources = [row for row in read_data("field/sources.csv") if row["entry"] == entry]
    lines = [
        f"- [{row['thread']}]({row['source']}): {row['asks']}"
        + (f" (what helped: {row['helped']})" if row["helped"] else "")
        for row in threads
    ]
    lines += [f"- Source of {row['about']}: {row['source']}" for row in sources]
    title = "Who asked this, and sources" if threads else "Sources"
    return Markdown("\n".join([f"````{{dropdown}} {title}", *lines, "````"]))
