"""Findings about the network: who does not hear whom, and why."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from ipaddress import ip_address

import numpy as np

from discostorm import words
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import Seen
from discostorm_capture.diagnosis.reachability import PATIENCE, Reach, reach, unheard
from discostorm_capture.diagnosis.scopes import Team

#: What a capture has whose filter kept announcements alone.
ANNOUNCEMENTS = ("SPDP", "Scout")
#: Fast DDS announces itself each 100 ms at first; sooner after the one before only if it found
#: somebody (until 2.14.5; data/vendors/middleware_defaults.csv, initial_period) [s].
SOONER = 0.05
#: So often it does by itself in the first second or so [s].
AT_FIRST, QUICK = 6, 1.5
#: So often who asks for an address gets no answer.
AGAIN = 3


def network(seen: Seen, team: Team, holes: Collection[tuple[str, str]] = ()) -> Iterator[Finding]:
    """Yield what is wrong between the hosts of a team; ``holes`` as in `reach`."""
    yield from _interfaces(seen, team)
    found = reach(seen, team, holes)
    if len(found.hosts) < 2:
        yield from _alone(seen, team, found)
    elif not found.expected.any():
        return
    elif not (found.heard | found.taken)[found.expected].any():
        if elsewhere := _subnets(found):
            yield elsewhere
        if elsewhere is None or not _among(found):
            yield _nobody_hears(seen, team, found)
    else:
        yield from _unheard(seen, found)
        yield from _unicast(seen, found)


def _subnets(found: Reach) -> Finding | None:
    """Return that hosts are in different networks, where none answers any other one."""
    part = [_network_of(host, 16) for host in found.hosts]
    if len(set(part)) < 2:
        return None
    most = Counter(part).most_common(1)[0]
    alone = tuple(
        host for host, one in zip(found.hosts, part, strict=True) if one != most[0] or most[1] == 1
    )
    return Finding(
        "other subnet",
        alone,
        f"{listed(found.hosts)} announce themselves from different networks, and none was answered "
        "from another one",
    )


def _among(found: Reach) -> bool:
    """Return whether different networks explain that nobody answers: few share one."""
    part = [_network_of(host, 16) for host in found.hosts]
    return max(Counter(part).values()) <= len(part) // 2 + 1


def _network_of(address: str, bits: int) -> int:
    told = ip_address(address)
    return -1 if told.version == 6 else int(told) >> (32 - bits)


def _alone(seen: Seen, team: Team, found: Reach) -> Iterator[Finding]:
    hosts = set(team.hosts) - seen.serving
    served = len({pair.of for pair in team.pairs}) > 0
    if not found.hosts or len(hosts) != 1 or served or len(seen.host_life) > 1 or unheard(seen):
        return
    first, last = seen.host_life[found.hosts[0]]
    if last - first >= PATIENCE:
        rows = seen.rows[(seen.rows["sender"] == found.hosts[0]).to_numpy() & seen.multicast]
        yield Finding(
            "alone",
            found.hosts,
            f"{found.hosts[0]} announced itself {len(rows)} times in {last - first:.1f} s, and "
            "nothing came from another host",
        )


def _nobody_hears(seen: Seen, team: Team, found: Reach) -> Finding:
    hosts = found.hosts
    count = int((seen.of("kind", *ANNOUNCEMENTS) & seen.multicast).sum())
    said = f"{listed(hosts)} announced themselves {count} times by multicast"
    ends = seen.rows[["sender", "receiver"]].drop_duplicates().astype(str)
    spoke = set(ends.itertuples(index=False, name=None))
    both = [a for a, b in spoke if (b, a) in spoke and a in hosts and b in hosts]
    asks = seen.asides
    taken = asks[(asks["kind"] == "connection").to_numpy()]
    between = [
        (a, b)
        for a, b in zip(taken["sender"].astype(str), taken["receiver"].astype(str), strict=True)
        if a in hosts and b in hosts
    ]
    if both or between:
        return Finding(
            "multicast filtered",
            hosts,
            f"{said}, and none answered, while {listed(both[:2] or between[0])} exchange unicast",
        )
    if asked := _asked_in_vain(seen, hosts):
        return Finding(
            "client isolation",
            hosts,
            f"{said} and heard each other, as they ask by ARP for each other's addresses again and "
            f"again ({asked}), but get no answer",
        )
    if (pairs := _sooner(seen, team)) >= 2:
        return Finding(
            "capture lost part",
            hosts,
            f"{said}, at times less than {SOONER * 1000:.0f} ms after the time before, as Fast DDS "
            f"does when it has found another process ({pairs} processes); what they said to each "
            "other then was not captured",
        )
    if seen.alone(ANNOUNCEMENTS):
        return Finding(
            "nobody hears, or filter",
            hosts,
            f"{said}, and no answer was captured, nor anything else at all",
        )
    return Finding("nobody hears", hosts, f"{said}, and none was ever answered")


def _asked_in_vain(seen: Seen, hosts: tuple[str, ...]) -> str:
    """Return who asks for whose address by ARP, again and again, without an answer."""
    arp = seen.asides[seen.asides["kind"].isin(["ARP request", "ARP reply"])]
    answers = arp[(arp["kind"] == "ARP reply").to_numpy()]
    replied = set(zip(answers["receiver"].astype(str), answers["sender"].astype(str), strict=True))
    asks = arp[(arp["kind"] == "ARP request").to_numpy()]
    count = Counter(zip(asks["sender"].astype(str), asks["receiver"].astype(str), strict=True))
    between = {pair: n for pair, n in count.items() if set(pair) <= set(hosts)}
    if replied & set(between) or max(between.values(), default=0) < AGAIN:
        return ""
    return listed([f"{one} for {other} {n} times" for (one, other), n in between.items()])


def _sooner(seen: Seen, team: Team) -> int:
    """Return how many processes of Fast DDS announced themselves earlier than they do by itself."""
    count = 0
    product = seen.processes["product"].to_numpy(object)
    announced = seen.of("kind", "SPDP") & seen.multicast
    for one in team.members:
        if product[one] == "Fast DDS":
            times = np.sort(seen.time[announced & (seen.process == one)])
            first = times[: np.searchsorted(times, times[:1].sum() + QUICK)]
            # It finds those of its own host in any case.
            beside = int((seen.host == seen.host[one]).sum()) - 1
            count += len(first) > AT_FIRST + beside and bool(np.diff(first).min() < SOONER)
    return count


def _unheard(seen: Seen, found: Reach) -> Iterator[Finding]:
    """Yield who hears no announcement of others, or whose none hears; then single pairs."""
    hosts, missing = found.hosts, found.deaf.copy()
    expected = found.expected
    away = _outside(found)
    if len(away):
        yield Finding(
            "other subnet",
            tuple(hosts[index] for index in away),
            f"{listed([hosts[index] for index in away])} and "
            f"{listed([host for i, host in enumerate(hosts) if i not in away])} announce "
            "themselves, and only hosts with addresses of one network answer each other",
        )
        inside = np.isin(np.arange(len(hosts)), away)
        missing &= inside[:, None] == inside
    rows = missing.sum(axis=1)
    full_row = (rows == expected.sum(axis=1)) & (rows > 0)
    full_column = (missing.sum(axis=0) == expected.sum(axis=0)) & (missing.sum(axis=0) > 0)
    several = expected.sum(axis=1) > 1
    for index in np.flatnonzero(full_row & full_column & several):
        yield Finding("cut off", (hosts[index],), _silent(seen, hosts[index], both=True))
        missing[index, :] = missing[:, index] = False
    for index in np.flatnonzero(full_row & several & missing.any(axis=1)):
        # One host that nobody hears looks as if all others were deaf.
        if full_column[missing[index]].any() and missing[index].sum() == 1:
            continue
        yield Finding("firewall", (hosts[index],), _silent(seen, hosts[index], both=False))
        missing[index, :] = False
    for index in np.flatnonzero(full_column & several & missing.any(axis=0)):
        heard = [hosts[other] for other in np.flatnonzero(found.heard[index])]
        yield Finding(
            "one direction",
            (hosts[index],),
            f"{hosts[index]} answers {listed(heard)}, and none of them ever answered it"
            if heard
            else f"none ever answered {hosts[index]}",
        )
        missing[:, index] = False
    yield from _pairs(found, missing, "never answered")


def _pairs(found: Reach, missing: np.ndarray, what: str) -> Iterator[Finding]:
    hosts = found.hosts
    left = [(hosts[row], hosts[column]) for row, column in np.argwhere(missing)]
    if left:
        told = listed([f"{one} {what} {other}" for one, other in left])
        yield Finding("one direction of pairs", tuple(dict.fromkeys(one for one, _ in left)), told)


def _silent(seen: Seen, host: str, both: bool) -> str:
    asked = seen.asides
    replies = (asked["kind"] == "ARP reply").to_numpy() & (asked["sender"] == host).to_numpy()
    here = (
        f"; it answers ARP ({int(replies.sum())} times), so frames do get there"
        if replies.any()
        else ""
    )
    if both:
        return f"{host} announces itself, answers no other host, and none answers it{here}"
    sent = int(((seen.rows["receiver"] == host).to_numpy()).sum())
    to_it = f", and others sent it {sent} messages" if sent else ""
    return f"{host} announces itself{to_it}, but it never answered any{here}"


def _outside(found: Reach) -> list[int]:
    """Return the hosts of smaller networks, if hearing ends where networks do."""
    for bits in (16, 24):
        part = [_network_of(host, bits) for host in found.hosts]
        if len(set(part)) < 2:
            continue
        same = np.equal.outer(part, part)
        across, within = found.expected & ~same, found.expected & same
        if across.any() and not (found.heard | found.taken)[across].any():
            if within.any() and not (found.heard | found.taken)[within].any():
                continue
            most = Counter(part).most_common(1)[0][0]
            return [index for index, one in enumerate(part) if one != most]
    return []


def _unicast(seen: Seen, found: Reach) -> Iterator[Finding]:
    """Yield who hears announcements alone."""
    apart, hosts = found.apart.copy(), found.hosts
    if not apart.any() or _short(seen):
        return
    good = found.taken & found.expected
    both = apart & apart.T
    count = int(both.sum()) // 2
    if both.any() and not (apart & ~both).any():
        kept = [index for index in range(len(hosts)) if both[index].any()]
        between = np.ix_(kept, kept)
        if not good[between].any() and len(kept) > 1:
            served = [hosts[i] for i in range(len(hosts)) if i not in kept and good[i, kept].all()]
            said = (
                f"{listed([hosts[index] for index in kept])} answer each other's announcements, "
                f"but none of the unicast between them is ever confirmed "
                f"({words.many(count, 'pair')})"
            )
            if served and len(kept) > 1:
                yield Finding(
                    "client isolation",
                    tuple(hosts[index] for index in kept),
                    f"{said}, while {listed(served)} exchanges unicast with all of them",
                )
            elif len(kept) > 2 or len(hosts) == 2:
                yield Finding("unicast dropped", tuple(hosts[index] for index in kept), said)
            else:
                yield from _pairs(found, apart, "gets nothing by unicast from")
            return
    several = found.expected.sum(axis=1) > 1
    tried = found.tried & found.expected
    for index in range(len(hosts)):
        if several[index] and tried[index].any() and (apart[index] == tried[index]).all():
            yield Finding(
                "unicast firewall",
                (hosts[index],),
                f"{hosts[index]} answers announcements, but confirms no unicast from others",
            )
            apart[index] = False
    for index in range(len(hosts)):
        column = tried[:, index]
        if several[index] and apart[:, index].any() and (apart[:, index] == column).all():
            yield Finding(
                "one direction",
                (hosts[index],),
                f"no other host confirms unicast from {hosts[index]}",
            )
            apart[:, index] = False
    yield from _pairs(found, apart, "gets nothing by unicast from")


def _short(seen: Seen) -> bool:
    return seen.duration < PATIENCE


def _interfaces(seen: Seen, team: Team) -> Iterator[Finding]:
    """Yield hosts that announce addresses that they do not send from."""
    told = seen.processes["announces"].to_numpy(object)
    wrong: dict[str, tuple[str, ...]] = {}
    for one in team.members:
        announced = tuple(dict.fromkeys(told[one].split()))
        senders = seen.rows["sender"][seen.process == one]
        latest = str(senders.iloc[-1]) if len(senders) else ""
        if announced and latest and latest not in announced and not _works(team, one):
            wrong[latest] = announced
    for host, announced in wrong.items():
        count = int(seen.rows["receiver"].isin(announced).sum())
        answers = f", to which others sent {count} messages" if count else ""
        yield Finding(
            "wrong interface", (host,), f"{host} announces itself as {listed(announced)}{answers}"
        )


def _works(team: Team, one: int) -> bool:
    """Return whether a process knows another one whole, and is known so."""
    return any(
        np.isfinite(pair.complete) and pair.sent > 0 for pair in team.pairs if pair.by == one
    )
