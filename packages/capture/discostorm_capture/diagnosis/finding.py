"""A finding: what is wrong, where, and how the capture shows it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from discostorm import words
from discostorm.data import read_data


@cache
def kinds() -> dict[str, dict[str, str]]:
    """Return what is known of each kind of finding, in the order in which they are told."""
    return {row["kind"]: row for row in read_data("diagnosis/findings.csv", "discostorm_capture")}


@cache
def remedies() -> dict[str, dict[str, str]]:
    """Return what to do, by the key that findings name."""
    return {row["remedy"]: row for row in read_data("diagnosis/remedies.csv", "discostorm_capture")}


@dataclass(frozen=True)
class Finding:
    """What is wrong, or what the capture cannot show.

    Parameters
    ----------
    kind : str
        A kind of ``data/diagnosis/findings.csv``.
    hosts : tuple of str
        The addresses that it is about; empty if all.
    evidence : str
        How the capture shows it: a sentence with its numbers.
    """

    kind: str
    hosts: tuple[str, ...]
    evidence: str

    @property
    def about(self) -> str:
        """What it is about: "fleet", what is wrong; "event", what happened; "capture"."""
        return kinds()[self.kind]["about"]

    @property
    def what(self) -> str:
        """What is the matter, in words; where it may be one of two things, both."""
        what = kinds()[self.kind]["what"]
        return (
            what.replace("HOSTS", listed(self.hosts)) if self.hosts else what.split("HOSTS: ")[-1]
        )

    @property
    def remedy(self) -> str:
        """The key of what to do, in ``data/diagnosis/remedies.csv``; empty if nothing."""
        return kinds()[self.kind]["remedy"]

    @property
    def advice(self) -> str:
        """What to do, in words."""
        row = remedies().get(self.remedy)
        if row is None:
            return ""
        named = row["what"].replace("HOSTS", listed(self.hosts) or "all hosts")
        return named.replace("RECORD", words.RECORD.format(file="discovery.pcap"))

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold."""
        return {
            "kind": self.kind,
            "about": self.about,
            "what": self.what,
            "hosts": list(self.hosts),
            "evidence": self.evidence,
            "remedy": self.remedy,
            "advice": self.advice,
        }


#: So many addresses are told by name; of more, the number of the others.
_MOST = 6


def listed(names: tuple[str, ...] | list[str], last: str = "and") -> str:
    """Return names with commas; of many the first ones, and how many more there are."""
    named = list(names)
    if len(named) > _MOST:
        named = [*named[: _MOST - 1], f"{len(named) - _MOST + 1} more"]
    if len(named) < 2:
        return "".join(named)
    return f"{', '.join(named[:-1])} {last} {named[-1]}"
