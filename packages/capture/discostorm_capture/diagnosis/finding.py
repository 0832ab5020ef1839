"""A finding: what is wrong, where, and how the capture shows it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from discostorm import wording
from discostorm.data import read_data
from discostorm_capture._types import Array

#: So many addresses are named; of more, the number of the others.
MAX_NAMES = 6


@cache
def finding_kinds() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/diagnosis/findings.csv`` by kind, in the order of findings."""
    return {row["kind"]: row for row in read_data("diagnosis/findings.csv", "discostorm_capture")}


@cache
def remedies() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/diagnosis/remedies.csv`` by the key that findings name."""
    return {row["remedy"]: row for row in read_data("diagnosis/remedies.csv", "discostorm_capture")}


def listing(names: Sequence[str] | Array) -> str:
    """Return names with commas; of many the first ones, and how many more there are."""
    if len(names) > MAX_NAMES:
        names = [*names[: MAX_NAMES - 1], f"{len(names) - MAX_NAMES + 1} more"]
    return wording.join_words([*names])


def to_sentence(text: str) -> str:
    """Return a text with a capital and a full stop."""
    return f"{wording.capitalized(text).rstrip('.')}." if text else ""


@dataclass(frozen=True)
class Finding:
    """What is wrong, or what the capture cannot show."""

    #: A kind of ``data/diagnosis/findings.csv``.
    kind: str
    #: The addresses that it is about; empty if all.
    hosts: tuple[str, ...]
    #: How the capture shows it: a sentence with its numbers.
    evidence: str

    @property
    def about(self) -> str:
        """Whether it is about the "fleet", an "event" or the "capture"."""
        return finding_kinds()[self.kind]["about"]

    @property
    def role(self) -> str:
        """How it ranks: it "explains" others of its hosts, "blocks" pairs, or is a "headline"."""
        return finding_kinds()[self.kind]["role"]

    @property
    def summary(self) -> str:
        """What is the matter; where it may be one of two things, both."""
        summary = finding_kinds()[self.kind]["summary"]
        if not self.hosts:
            return summary.removeprefix("HOSTS: ")
        return summary.replace("HOSTS", listing(self.hosts))

    @property
    def remedy(self) -> str:
        """The key of the remedy, in ``data/diagnosis/remedies.csv``; empty if there is none."""
        return finding_kinds()[self.kind]["remedy"]

    @property
    def advice(self) -> str:
        """What to do, in wording."""
        advice = remedies()[self.remedy]["what"] if self.remedy else ""
        advice = advice.replace("HOSTS", listing(self.hosts) or "all hosts")
        return advice.replace("RECORD", wording.RECORD.format(file="discovery.pcap"))

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold."""
        return {
            "kind": self.kind,
            "about": self.about,
            "what": self.summary,
            "hosts": list(self.hosts),
            "evidence": self.evidence,
            "remedy": self.remedy,
            "advice": self.advice,
        }
