"""A finding: what is wrong, at which hosts, and how the capture shows it."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace
from typing import Any, Self

from discostorm import wording
from discostorm.data import read_data
from discostorm_capture.endpoints import QOS_REMEDIES
from discostorm_capture.sentences import join_names, say

#: Thresholds of the rules by name, in the units of ``data/diagnosis/thresholds.csv``.
_THRESHOLDS = read_data("diagnosis/thresholds.csv", "discostorm_capture")
LIMITS: Any = SimpleNamespace(**{row["name"]: float(row["value"]) for row in _THRESHOLDS})

#: The keys of a finding in JSON.
JSON_KEYS = ("kind", "about", "what", "hosts", "evidence", "remedy", "advice")


@cache
def finding_kinds() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/diagnosis/findings.csv`` by kind, in the order of findings."""
    return {row["kind"]: row for row in read_data("diagnosis/findings.csv", "discostorm_capture")}


@cache
def remedies() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/diagnosis/remedies.csv`` by the key that findings name."""
    return {row["remedy"]: row for row in read_data("diagnosis/remedies.csv", "discostorm_capture")}


def to_sentence(text: str) -> str:
    """Return a text with a capital letter and a full stop."""
    return f"{wording.capitalized(text).rstrip('.')}." if text else ""


@dataclass(frozen=True)
class Finding:
    """What is wrong, what happened, or what the capture cannot show."""

    #: A kind of ``data/diagnosis/findings.csv``.
    kind: str
    #: The addresses concerned; empty for all.
    hosts: tuple[str, ...]
    #: How the capture shows it: a sentence with its numbers.
    evidence: str

    @classmethod
    def of(cls, kind: str, hosts: Iterable[str], *values: Any) -> Self:
        """Return a finding of a kind; fill hosts and values into the sentence of the kind."""
        hosts = tuple(hosts)
        return cls(kind, hosts, say(kind, hosts, *values))

    @property
    def _names(self) -> str:
        # Only the host that recorded can record what stays on it.
        own = "127.0.0.1"
        return join_names([f"{own} (the recording host)" if of == own else of for of in self.hosts])

    @property
    def about(self) -> str:
        """The subject: the "fleet", an "event" or the "capture"."""
        return finding_kinds()[self.kind]["about"]

    @property
    def role(self) -> str:
        """Its role, in words of ``data/README.md``, such as "explains" or "headline"."""
        return finding_kinds()[self.kind]["role"]

    @property
    def replaces(self) -> list[str]:
        """The kinds of findings that it explains, so that these are not told."""
        return finding_kinds()[self.kind]["replaces"].split("; ")

    @property
    def summary(self) -> str:
        """What is wrong, in one clause; if there are two possible causes, both."""
        summary = finding_kinds()[self.kind]["summary"].replace("HOSTS", self._names)
        return re.sub(r"\{(.*?)\|(.*?)\}", r"\2" if len(self.hosts) > 1 else r"\1", summary)

    @property
    def remedy(self) -> str:
        """The key of the remedy in ``data/diagnosis/remedies.csv``; "" if there is none."""
        return finding_kinds()[self.kind]["remedy"]

    @property
    def advice(self) -> str:
        """What to do about it, as text."""
        advice = remedies()[self.remedy]["what"] if self.remedy else ""
        advice = advice.replace("HOSTS", self._names or "all hosts")
        own = [text for policy, text in QOS_REMEDIES.items() if f"({policy}_" in self.evidence]
        advice = advice.replace("RECORD", wording.TCPDUMP.format(file="discovery.pcap"))
        return " ".join([advice, *own])

    def to_dict(self) -> dict[str, Any]:
        """Return all fields as JSON can hold them."""
        values = (self.kind, self.about, self.summary, [*self.hosts], self.evidence)
        return dict(zip(JSON_KEYS, (*values, self.remedy, self.advice), strict=True))
