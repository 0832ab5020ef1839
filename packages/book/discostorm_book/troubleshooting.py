"""The page "What is wrong with my robots?": what it shows of the tables of ``data/field/``."""

from IPython.display import Markdown

from discostorm import words
from discostorm.data import read_data
from discostorm.snippets import snippets

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
    """Return what to paste for a kind of remedy, in a fold.

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
    if len(pieces) == 1:
        title = f"{pieces[0].file}, {pieces[0].where}"
    else:
        files = [piece.file for piece in pieces]
        title = words.listed(files) if len(files) < 4 else f"{len(files)} files"
    codes = [
        f"```{LANGUAGES[piece.file.rsplit('.', 1)[-1]]}\n{piece.text.rstrip()}\n```"
        for piece in pieces
    ]
    if len(pieces) > 1:
        codes = [
            f"`{piece.file}`, {piece.where}:\n\n{code}"
            for piece, code in zip(pieces, codes, strict=True)
        ]
    inside = "\n\n".join(codes)
    return Markdown(f"````{{dropdown}} To paste: {title}\n{inside}\n````")


def asked(entry: str) -> Markdown:
    """Return who asked what an entry answers, what helped there, and the sources of the entry."""
    threads = [
        row for row in read_data("field/threads.csv", "discostorm_book") if row["entry"] == entry
    ]
    sources = [
        row for row in read_data("field/sources.csv", "discostorm_book") if row["entry"] == entry
    ]
    lines = [
        f"- [{row['thread']}]({row['source']}): {row['asks']}"
        + (f" (what helped: {row['helped']})" if row["helped"] else "")
        for row in threads
    ]
    lines += [f"- Source of {row['about']}: {row['source']}" for row in sources]
    title = "Who asked this, and sources" if threads else "Sources"
    return Markdown("\n".join([f"````{{dropdown}} {title}", *lines, "````"]))
