"""Tables of ``data/field/`` for the page "What is wrong with my robots?"."""

from IPython.display import Markdown

from discostorm import wording
from discostorm.data import read_data
from discostorm.snippets import snippets

#: Languages for the highlighting of files, by their suffix.
LANGUAGES = {"sh": "bash", "xml": "xml", "json5": "javascript", "conf": "ini", "cpp": "cpp"}
LANGUAGES |= {"launch": "python"}


def configuration_to_copy(kind: str, *names: str, only: str = "") -> Markdown:
    """Return the configuration to copy for a kind of ``data/vendors/remedies.csv``, in a fold."""
    pieces = [piece for piece in snippets(kind, *names) if only in piece.file]
    if not pieces:
        raise ValueError(f"kind must have a configuration to copy; got {kind!r}")
    files = [piece.file for piece in pieces]
    codes = [
        f"```{LANGUAGES[piece.file.rsplit('.', 1)[-1]]}\n{piece.text.rstrip()}\n```"
        for piece in pieces
    ]
    title = wording.join_words(files) if len(files) < 4 else f"{len(files)} files"
    if len(pieces) == 1:
        title += f", {pieces[0].where}"
    else:
        places = [f"`{piece.file}`, {piece.where}:" for piece in pieces]
        codes = [f"{place}\n\n{code}" for place, code in zip(places, codes, strict=True)]
    inside = "\n\n".join(codes)
    return Markdown(f"````{{dropdown}} To paste: {title}\n{inside}\n````")


def _rows_of(entry: str, table: str) -> list[dict[str, str]]:
    rows = read_data(f"field/{table}.csv", "discostorm_book")
    return [row for row in rows if row["entry"] == entry]


def related_threads(entry: str) -> Markdown:
    """Return the threads with an entry's question, the fixes that helped, and its sources."""
    threads, sources = _rows_of(entry, "threads"), _rows_of(entry, "sources")
    lines = [
        f"- [{row['thread']}]({row['source']}): {row['asks']}"
        + (f" (what helped: {row['helped']})" if row["helped"] else "")
        for row in threads
    ]
    lines += [f"- Source of {row['about']}: {row['source']}" for row in sources]
    title = "Who asked this, and sources" if threads else "Sources"
    return Markdown("\n".join([f"````{{dropdown}} {title}", *lines, "````"]))
