"""What could be changed of a table: its arrangement, its announcements, the middleware."""

from collections.abc import Callable, Iterator
from dataclasses import replace

from discostorm import words
from discostorm.data import read_data
from discostorm.messages import Protocol, Schedule
from discostorm.planner.changes import Change
from discostorm.planner.known import arrangements, family, of_paper, product, row_of
from discostorm.protocols import ARRANGED, PROTOCOLS, ZENOH
from discostorm.protocols.defaults import defaults


def table_changes(protocol: Protocol) -> Iterator[Change | str]:
    """Yield other tables: arranged otherwise, with calmer announcements, of other middleware."""
    yield from _arranged(protocol)
    calm = _calmer(protocol)
    if calm is not None:
        yield Change("announcements", "calmer announcements", "table", table=calm)
    elif family(protocol) == "DDS":
        of = list(dict.fromkeys(row["protocol"] for row in read_data("vendors/announcements.csv")))
        yield f"calmer announcements: known for the tables of {words.listed(of)} alone"
    if family(protocol) == "Zenoh":
        listed = _listed(protocol)
        if listed is not None:
            yield Change("peers", "static peers", "table", table=listed)
        else:
            yield f"static peers: {protocol.name} sends no Scouts whose place they could take"
    hybrid = PROTOCOLS.get("hybrid")
    if hybrid is not None and family(protocol) is not None:
        yield Change("hybrid", "the hybrid discovery", "table", table=hybrid)
    # On Wi-Fi nobody gets what a product sends where it takes the network for wired.
    wired = [table.wired for table in PROTOCOLS.values()]
    arranged = ARRANGED | {row["table"] for row in arrangements()}
    for table in PROTOCOLS.values():
        if table == protocol or table in wired or table.name in arranged:
            continue
        # What ROS 2 makes of a product may be another of its tables.
        of_ros2 = row_of("middleware", family(table))
        if product(table) and of_ros2 and of_ros2["table"] not in ("", table.name):
            continue
        if family(table) is not None and _alike(table, protocol):
            yield Change("middleware", f"switching to {table.name}", "table", table=table)


def _arranged(protocol: Protocol) -> Iterator[Change]:
    """Yield tables of servers, routers and peers in place of a product's.

    What has the paper's counts is compared with them by the product's table as built.
    """
    own, built = product(protocol), product(protocol) is not None
    arranged = protocol.name in {row["table"] for row in arrangements()}
    for row in arrangements():
        table, before = PROTOCOLS.get(row["table"]), PROTOCOLS[row["base"]]
        if table is None or table == protocol:
            continue
        other = built and product(before) != own
        if row["family"] != family(protocol) and not other:
            continue
        what, base, by = row["title"], None, ""
        steps: tuple[str, ...] = (row["kind"],)
        if other:
            what = f"switching to {product(before)} with {what}"
            steps = ("middleware", *steps)
        elif not arranged:
            base = before
            if before != protocol:
                by = f"both as {before.name.replace(', ', ' with ')} was measured"
        yield Change(
            row["kind"], what, "table", table=table, base=base, note=by, by=by, steps=steps
        )


def _listed(table: Protocol) -> Protocol | None:
    """Return a table of Zenoh peers that have a list of others instead of Scouts, if it may.

    What belongs to a connection is counted once for each two processes, as the one of them dials
    that has the other on its list; peers that find each other by Scouts both may.
    """
    first = table.messages[0]
    rest = tuple(message for message in table.messages if message.phase != first.phase)
    if not rest or first.kind != "Scout":
        return None
    dialed = [m.per_unit for m in rest if m.kind == "Init" and m.name == "InitSyn"]
    once = 0.5 / dialed[0] if dialed else 1.0
    linked = ("Init", "Open", "KeepAlive", "TCP control")
    messages = (
        replace(m, per_unit=m.per_unit * once)
        if dialed and (m.kind in linked or m.answers == "KeepAlive")
        else m
        for m in rest
    )
    return replace(table, messages=tuple(messages))


def _calmer(table: Protocol) -> Protocol | None:
    """Return a table with the announcements of ``data/vendors/announcements.csv``, if it may."""
    name = product(table)
    rows = {
        r["message"]: r for r in read_data("vendors/announcements.csv") if r["protocol"] == name
    }
    calm = tuple(
        replace(
            message,
            schedule=Schedule(
                tuple(float(t) for t in row["starts_s"].split()), float(row["period_s"])
            ),
        )
        if (row := rows.get(message.name)) and message.schedule.per_second
        else message
        for message in table.messages
    )
    if calm == table.messages:
        return None
    return replace(table, messages=calm, lease=max(float(row["lease_s"]) for row in rows.values()))


def _alike(one: Protocol, other: Protocol) -> bool:
    """Return whether two tables count alike: as the paper, with periods, or as products do."""
    built = [product(table) is not None for table in (one, other)]
    papers = any(of_paper(message) for message in other.messages) or not other.repeats
    return built[0] == built[1] and (built[0] or (one.repeats == other.repeats and papers))


def sessions_note(
    old: Protocol,
    new: Protocol,
    before: float,
    after: float,
    cost: Callable[[Protocol], float],
    window: float,
) -> str:
    """Return what Zenoh's count leaves out beside what switching to or from it changes."""
    if (family(old) == "Zenoh") == (family(new) == "Zenoh"):
        return ""
    if any(message.kind == "Init" for table in (old, new) for message in table.messages):
        return ""  # it counts them
    one, both = (cost(_openings(sides)) for sides in (1, 2))
    if not one:
        return ""
    to_zenoh = family(new) == "Zenoh"
    more = after - before if to_zenoh else before - after
    if more >= 0:
        so = "which makes the gap larger"
    elif more + both < 0:
        so = "which does not close the gap"
    else:
        so = "so that it is not settled which of the two takes less"
    adds = [words.airtime(value, window) for value in (one, both)]
    return (
        f"the count leaves out that Zenoh opens sessions: {adds[0]} more if one side dials, "
        f"{adds[1]} if both do, beside a gap of {words.airtime(abs(more), window)}, {so}"
    )


def _openings(sides: int) -> Protocol:
    """Return what opens Zenoh's sessions if so many sides dial, each as long as a KeepAlive."""
    messages = defaults("Zenoh")["session_messages"]
    opening = replace(
        ZENOH.message("KeepAlive"),
        name="SessionOpening",
        # A session joins two processes, which are two ordered pairs.
        per_unit=sides * messages / 2,
        answers=None,
    )
    return Protocol("Zenoh's sessions", (opening,))
