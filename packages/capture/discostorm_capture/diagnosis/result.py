"""The diagnosis of a capture: whether discovery is healthy, complete and over, and why not."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from discostorm import _checks, words
from discostorm_capture.diagnosis import tables
from discostorm_capture.diagnosis.capture_quality import (
    asked_no_more,
    began_late,
    ended_early,
    holes_of,
    record,
    unconfirmed,
    unread,
)
from discostorm_capture.diagnosis.finding import Finding, kinds, listed
from discostorm_capture.diagnosis.lifecycle import events, lives, restarted
from discostorm_capture.diagnosis.network import network
from discostorm_capture.diagnosis.observations import DATA, Seen
from discostorm_capture.diagnosis.pairs import Pair
from discostorm_capture.diagnosis.reachability import unheard
from discostorm_capture.diagnosis.scopes import Team, teams
from discostorm_capture.diagnosis.traffic import loss, servers, storm

if TYPE_CHECKING:
    import pandas as pd

#: What is quiet for so long at the end of a capture is over [s].
QUIET = 1.0
#: From this share of cut packets on, what is missing tells nothing [1].
MOST_CUT = 0.1
#: What to do if there is no discovery in a capture.
RECORD_ANEW = (
    "Record on the interface that the robots use, before their nodes start, and without ports in "
    f"the filter: {words.RECORD.format(file='discovery.pcap')}."
)
#: So many rows what was sent has at most, in JSON [1].
TIMELINE = 2000
#: What is told of endpoints, and said to open sessions.
TELLING = (DATA, "Declare", "Init", "Open")


@dataclass(frozen=True)
class Diagnosis:
    """What a capture tells of the health of discovery; `Capture.diagnosis` makes one.

    Parameters
    ----------
    findings : tuple of Finding
        What is wrong with the fleet, most telling first; then what happened; then what the capture
        cannot show.
    complete : bool or None
        Whether all processes that ought to know each other do, for as long as they were there
        together; None if the capture does not show it.
    over : bool or None
        Whether nothing was told of endpoints any more when the capture ended; None if it shows
        no discovery.
    complete_at : float
        When the last pair completed, since the earliest packet and without jumps of the clock [s];
        infinite if one never did, NaN if that is not known.
    pairs : int
        How many ordered pairs of processes on different hosts ought to be complete [1].
    _hosts, _incomplete : pandas.DataFrame
        What `hosts` and `incomplete` return copies of.
    _rows : pandas.DataFrame
        The messages that were diagnosed, of which `timeline` tells.
    """

    findings: tuple[Finding, ...]
    complete: bool | None
    over: bool | None
    complete_at: float
    pairs: int
    _hosts: pd.DataFrame = field(compare=False, repr=False)
    _incomplete: pd.DataFrame = field(compare=False, repr=False)
    _rows: pd.DataFrame = field(compare=False, repr=False)

    @property
    def wrong(self) -> tuple[Finding, ...]:
        """What is wrong with the fleet; empty if nothing that the capture shows."""
        return tuple(finding for finding in self.findings if finding.about == "fleet")

    @property
    def healthy(self) -> bool | None:
        """Whether nothing is wrong; None if the capture does not show that discovery worked."""
        if self.wrong or self.complete is False:
            return False
        return True if self.complete else None

    def hosts(self) -> pd.DataFrame:
        """Return a row for each host.

        Returns
        -------
        pandas.DataFrame
            By ``host``, its address: ``products``; ``processes`` and ``endpoints`` [1];
            ``announced_s``, when it was heard first, ``knows_all_s``, when its processes had been
            told all that they ought to know of others, and ``known_s``, when all others had been
            told of it [s], infinite if never, NaN if not known; ``sent`` and ``received``
            messages [1] and their ``sent_bytes`` and ``received_bytes`` [B].
        """
        return self._hosts.copy()

    def incomplete(self) -> pd.DataFrame:
        """Return the pairs of processes that never completed.

        Returns
        -------
        pandas.DataFrame
            A row a pair: the host ``of`` whom is told, the host ``by`` whom it ought to be known,
            ``of_process`` and ``by_process``; ``heard_s``, when the one first spoke to the other
            [s], infinite if never, and how many endpoints were ``sent`` to it [1].
        """
        return self._incomplete.copy()

    def timeline(self, most: int = TIMELINE) -> pd.DataFrame:
        """Return who sent what when, until a little after the startup.

        It ends when 1.25 times `complete_at` have passed, and 2 s at least; with the capture if
        that is not finite.

        Parameters
        ----------
        most : int
            The rows that it may have [1]. If there are more, messages are put together in steps of
            time, as short as that allows, and whom they are sent to is left out.

        Returns
        -------
        pandas.DataFrame
            A row for the messages of a ``kind`` in a packet or step: ``time_s``, when the first
            was captured [s]; ``host``, who sent them; ``receiver``, an address, and whether it is
            ``multicast``, None in steps; ``ends``, whether they take back what they are about or
            end a connection; ``messages`` [1] and ``bytes`` [B]. In its ``attrs``: ``until_s``,
            when it ends, ``step_s``, the step [s], 0 if there is none, and ``left_out``, how many
            messages it leaves out [1], as even the hosts and kinds were too many.
        """
        _checks.whole("most", most, 1)
        found, told = tables.timeline(self._rows, self.complete_at, most)
        found.attrs |= told
        return found

    def summary(self) -> str:
        """Return in one to three sentences how discovery is, why, and what to do."""
        sentences = [self._state()]
        if self.wrong:
            first = self.wrong[0]
            sentences += [_sentence(first.evidence), _sentence(first.advice)]
        else:
            limits = [one for one in self.findings if one.about == "capture"]
            limits = [one for one in limits if not one.kind.startswith("clock")]
            gone = [one for one in self.findings if one.kind == "crash"]
            if gone:
                sentences += [_sentence(gone[0].evidence), _sentence(gone[0].advice)]
            elif limits and (self.complete is None or len(self._hosts) < 2):
                sentences += [_sentence(limits[0].evidence), _sentence(limits[0].advice)]
            elif self.complete is None:
                sentences.append(RECORD_ANEW)
        return " ".join(filter(None, sentences))

    def _state(self) -> str:
        processes = words.many(int(self._hosts["processes"].sum()), "process", "es")
        count = f"{processes} on {words.many(len(self._hosts), 'host')}"
        if self.wrong:
            more = len(self.wrong) - 1
            also = f" (and {more} more finding{'s' * (more > 1)})" if more else ""
            good = "complete and over, but " if self.over else "complete, but "
            good = good if self.complete else ""
            bad = ["healthy", *["complete"] * (self.complete is False)]
            bad += ["over"] * (self.over is False)
            return f"Discovery is {good}not {' and not '.join(bad)}: {self.wrong[0].what}{also}."
        if self.complete is False:
            lacking = f"{len(self._incomplete)} of {self.pairs} pairs of processes"
            return f"Discovery is not complete: {lacking} do not know all of each other."
        if self.complete is None:
            if not len(self._hosts):
                return "The capture shows no discovery of DDS or Zenoh."
            return f"The capture does not show whether discovery is complete ({count})."
        state = "healthy, complete and over" if self.over else "healthy and complete, but not over"
        when = f" {_after(self.complete_at)}" if np.isfinite(self.complete_at) else ""
        return f"Discovery is {state}: {count} know each other{when}{self._last()}."

    def _last(self) -> str:
        """Return which host was much later than the others, if any."""
        times = self._hosts["knows_all_s"]
        times = times[np.isfinite(times)].sort_values()
        if len(times) < 2 or times.iloc[-1] < 2 * times.iloc[-2] or times.iloc[-1] < 1.0:
            return ""
        return f" ({times.index[-1]} as the last; without it after {times.iloc[-2]:.1f} s)"

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold: times that never came are null."""
        timeline = self.timeline()
        return {
            "summary": self.summary(),
            "healthy": self.healthy,
            "complete": self.complete,
            "over": self.over,
            "complete_s": _number(self.complete_at),
            "pairs": self.pairs,
            "findings": [finding.to_dict() for finding in self.findings],
            "hosts": _records(self._hosts.reset_index()),
            "incomplete": _records(self._incomplete),
            "timeline": timeline.attrs | {"rows": _records(timeline)},
        }


def _after(time: float) -> str:
    """Return when something was, with the digits that tell."""
    if time < 0.01:
        return "within 10 ms"
    return f"after {time:.1f} s" if time >= 1.0 else f"after {time:.2f} s"


def _number(value: Any) -> Any:
    return value if not isinstance(value, float) or np.isfinite(value) else None


def _records(table: pd.DataFrame) -> list[dict[str, Any]]:
    return [
        {str(key): _number(value) for key, value in row.items()}
        for row in table.astype(object).to_dict("records")
    ]


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:].rstrip('.')}." if text else ""


def diagnose(seen: Seen) -> Diagnosis:
    """Return the diagnosis of what a capture shows."""
    late = began_late(seen)
    found_teams = tuple(
        replace(team, pairs=tuple(_shown(pair, late) for pair in team.pairs))
        for team in teams(seen)
    )
    alive = lives(seen)
    gone = {one for starts in restarted(seen, alive).values() for one in starts[:-1]}
    happened = list(events(seen, found_teams, late))
    holes = holes_of(seen, late)
    wrong = [finding for team in found_teams for finding in network(seen, team, holes)]
    wrong += _domains(found_teams)
    wrong += [*servers(seen)]
    limits = list(record(seen, late))
    pairs = [
        pair for team in found_teams for pair in team.pairs if tables.due(seen, pair, alive, gone)
    ]
    lacking = [pair for pair in pairs if pair.complete == np.inf]
    late_ones = [
        pair
        for team in found_teams
        for pair in team.pairs
        if tables.pending(seen, pair, alive, gone)
    ]
    limits += ended_early(seen, late_ones)
    if lacking and all(asked_no_more(seen, pair) for pair in lacking):
        limits += unconfirmed(seen, lacking)
    wrong += [one for one in happened if one.about == "fleet"]
    lossy = list(loss(seen))
    if seen.cut > MOST_CUT:
        wrong, lossy = _domains(found_teams), []
    if any(one.kind == "heavy loss" for one in lossy):
        # So many losses can look like a direction that does not work.
        wrong = [one for one in wrong if one.kind != "one direction of pairs"]
    strange = [pair for pair in lacking if {pair.of, pair.by} & seen.secured]
    if strange and not wrong:
        wrong.append(_strange(seen, strange, len(pairs)))
    if lacking and not wrong and not lossy and not limits:
        wrong.append(_incomplete(seen, lacking, len(pairs)))
    wrong += [*lossy, *storm(seen)]
    wrong.sort(key=lambda one: list(kinds()).index(one.kind))
    limits += [one for one in wrong if one.about == "capture"]
    wrong = [one for one in wrong if one.about == "fleet"]
    times = [pair.complete for pair in pairs if not np.isnan(pair.complete)]
    telling = seen.time[seen.of("kind", *TELLING)]
    end = float(seen.time.max(initial=0.0))
    return Diagnosis(
        findings=(*wrong, *(one for one in happened if one.about == "event"), *limits),
        complete=None
        if not wrong and (unheard(seen) or unread(seen))
        else _complete(pairs, lacking, bool(wrong), limits),
        over=bool(seen.duration - telling.max(initial=0.0) > QUIET and end > 0)
        if len(telling) or pairs
        else None,
        complete_at=max(times) if times else np.nan,
        pairs=len(pairs),
        _hosts=tables.hosts(seen, found_teams, alive),
        _incomplete=tables.incomplete(seen, lacking),
        _rows=seen.rows,
    )


def _shown(pair: Pair, late: set[int]) -> Pair:
    """Return a pair without a time if the capture shows nothing of what was told before it."""
    untold = pair.of in late and not pair.sent and pair.complete > 0
    return replace(pair, complete=np.nan) if untold else pair


def _complete(
    pairs: list[Pair], lacking: list[Pair], wrong: bool, limits: list[Finding]
) -> bool | None:
    """Return whether all pairs are complete, None if the capture does not show it."""
    if all(np.isnan(pair.complete) for pair in pairs):
        return None
    lost = any(one.kind in ("capture lost part", "capture began late") for one in limits)
    if wrong:
        return not lacking
    began = any(one.kind in ("capture began late", "capture ended early") for one in limits)
    if began or (lacking and lost):
        return None
    return not lacking


def _strange(seen: Seen, strange: list[Pair], pairs: int) -> Finding:
    by = dict.fromkeys(
        f"{seen.host[min(pair.of, pair.by)]} with {seen.host[max(pair.of, pair.by)]}"
        for pair in strange
    )
    return Finding(
        "not authenticated",
        tuple(dict.fromkeys(str(seen.host[one]) for pair in strange for one in (pair.of, pair.by))),
        f"in {len(strange)} of {pairs} pairs of processes one process never sent the other "
        f"its keys: {listed([*by])}",
    )


def _incomplete(seen: Seen, lacking: list[Pair], pairs: int) -> Finding:
    by = listed(
        list(dict.fromkeys(f"{seen.host[one.by]} of {seen.host[one.of]}" for one in lacking))
    )
    return Finding(
        "incomplete",
        tuple(dict.fromkeys(str(seen.host[one.by]) for one in lacking)),
        f"{len(lacking)} of {pairs} pairs of processes never completed: {by}",
    )


def _domains(found_teams: tuple[Team, ...]) -> list[Finding]:
    """Return that hosts are in different domains, if none is in both."""
    of = {team.domain: team.hosts for team in found_teams if team.domain >= 0}
    hosts = [host for members in of.values() for host in members]
    if len(of) < 2 or len(hosts) != len(set(hosts)):
        return []
    told = listed(
        [f"domain {domain} has {listed(members)}" for domain, members in sorted(of.items())]
    )
    return [Finding("two domains", tuple(dict.fromkeys(hosts)), told)]
