"""What to paste for a remedy: pieces of configuration, each for a version of a product.

The pieces are files of ``data/vendors/snippets/``; ``data/vendors/snippets.csv`` says for which
remedy each is, where it goes and where its settings are documented. A test has the product itself
load each of them (``tests/test_snippets.py``).
"""

from dataclasses import dataclass

from discostorm.data import data_path, read_data

#: How a comment begins and ends, by the end of the file's name; of others as in a shell.
_COMMENTS = {".xml": ("<!-- ", " -->"), ".json5": ("// ", ""), ".cpp": ("// ", "")}


@dataclass(frozen=True)
class Snippet:
    """A piece of configuration.

    Parameters
    ----------
    file : str
        Name of its file, whose end says the language.
    where : str
        Where it goes.
    version : str
        The product and version that it is for.
    source : str
        Where its settings are documented.
    """

    file: str
    where: str
    version: str
    source: str

    @property
    def text(self) -> str:
        """What to paste, with a first line that says for what and where."""
        end = f".{self.file.rsplit('.', 1)[-1]}"
        begins, ends = _COMMENTS.get(end, ("# ", ""))
        content = data_path(f"vendors/snippets/{self.file}").read_text(encoding="utf-8")
        return f"{begins}{self.version}: {self.where}{ends}\n{content}"


def snippets(kind: str, *names: str) -> tuple[Snippet, ...]:
    """Return what to paste for a kind of remedy.

    Parameters
    ----------
    kind : str
        A kind of ``data/vendors/remedies.csv``.
    *names : str
        What it is for, such as a family, a product or a radio; what is for any is always there.

    Examples
    --------
    >>> print(snippets("multicast rate")[0].text)
    # hostapd 2.10: hostapd.conf of the access point
    # Frames to a group and those of management go out at the lowest basic rate, here 24 Mbit/s (in
    # units of 100 kbit/s). Older rates (not those of 802.11n and later) below it are gone: who is
    # too far away for it cannot join.
    supported_rates=240 360 480 540
    basic_rates=240
    <BLANKLINE>
    """
    return tuple(
        Snippet(row["file"], row["where"], row["version"], row["source"])
        for row in read_data("vendors/snippets.csv")
        if row["kind"] == kind and row["for"] in ("any", *names)
    )
