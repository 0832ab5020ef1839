"""What to paste for a remedy: pieces of configuration, each for a version of a product.

The pieces are files of ``data/vendors/snippets/``; ``data/vendors/snippets.csv`` says for which
remedy each is, where it goes, how it is loaded, whether its product runs here and where its
settings are documented. What runs here is loaded by the product itself in
``tests/lab/test_snippets.py``; the rest is compared with documentation, and says so.
"""

import textwrap
from dataclasses import dataclass
from typing import Any

from discostorm.data import data_path, read_data

#: How wide a comment is, and what one says of a product that does not run here.
_WIDTH, _NOT_RUN = 90, "not run here: compared with its documentation"
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
    load : str
        How it is loaded: file name, environment variable, process.
    run_here : bool
        Whether a test of ours has the product load it.
    """

    file: str
    where: str
    version: str
    source: str
    load: str
    run_here: bool

    @property
    def text(self) -> str:
        """What to paste; its first lines say for what and where it is, and how it is loaded."""
        end = f".{self.file.rsplit('.', 1)[-1]}"
        begins, ends = _COMMENTS.get(end, ("# ", ""))
        content = data_path(f"vendors/snippets/{self.file}").read_text(encoding="utf-8")
        said = [f"{self.version}: {self.where}", *textwrap.wrap(f"Load: {self.load}", _WIDTH)]
        said += [] if self.run_here else [_NOT_RUN.capitalize()]
        return "".join(f"{begins}{line}{ends}\n" for line in said) + content

    def to_dict(self) -> dict[str, Any]:
        """Return what JSON says of it."""
        return {
            "where": self.where,
            "version": self.version,
            "load": self.load,
            "checked": "loaded by the product in a test" if self.run_here else _NOT_RUN,
            "text": self.text,
        }


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
    # Load: save in /etc/hostapd/hostapd.conf, beside interface and ssid; the process hostapd
    # reads it when it starts
    # Frames to a group and those of management go out at the lowest basic rate, here 24 Mbit/s (in
    # units of 100 kbit/s). Older rates (not those of 802.11n and later) below it are gone: who is
    # too far away for it cannot join.
    # Band and channel: as you have them.
    hw_mode=a
    channel=36
    supported_rates=240 360 480 540
    basic_rates=240
    <BLANKLINE>
    """
    return tuple(
        Snippet(
            file=row["file"],
            where=row["where"],
            version=row["version"],
            source=row["source"],
            load=row["load"],
            run_here=row["run_here"] == "yes",
        )
        for row in read_data("vendors/snippets.csv")
        if row["kind"] == kind and row["for"] in ("any", *names)
    )
