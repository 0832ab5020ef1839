"""What could be changed of a table: its configuration, its announcements, the middleware."""

from collections.abc import Callable, Iterator
from dataclasses import replace

from discostorm import words
from discostorm.data import read_data
from discostorm.messages import UNITS, Message, Protocol, Schedule
from discostorm.protocols import PROTOCOLS, ZENOH
from discostorm.protocols.defaults import defaults
from discostorm_planner.changes import Change
from discostorm_planner.remedy_rules import configuring, is_built, row_of, same, software


def table_changes(protocol: Protocol) -> Iterator[Change | str]:
    """Yield other tables: other topologies, longer announcement intervals, other middleware."""
    yield from _arranged(protocol)
    if protocol.family == "DDS":
        yield _calmer(protocol)
    if protocol.family == "Zenoh":
        yield _listed(protocol)
    if protocol.family is not None:
        yield from _hybrid()
    yield from _switched(protocol)


def _arranged(protocol: Protocol) -> Iterator[Change]:
    """Yield tables of servers, routers and peers in place of a product's.

    What has the paper's counts is compared with them by the product's table as built.
    """
    own = software(protocol)
    for row in configuring():
        table, before = PROTOCOLS.get(row["table"]), PROTOCOLS[row["base"]]
        if table is None or same(table, protocol):
            continue
        other = is_built(protocol) and software(before) != own
        if row["family"] != protocol.family and not other:
            continue
        what, base, by = row["title"], None, ""
        steps: tuple[str, ...] = (row["kind"],)
        if other:
            what = f"switching to {software(before)} with {what}"
            steps = ("middleware", *steps)
        elif protocol.basis != "mitigated" and not same(before, protocol):
            base = before
            by = f"both values are of {before.name.replace(', ', ' with ')}'s measured model"
        yield Change(
            row["kind"], what, "table", table=table, base=base, note=by, by=by, steps=steps
        )


def _calmer(table: Protocol) -> Change | str:
    """Return the announcements of ``data/vendors/announcements.csv``, or for whom they are."""
    calmer = read_data("vendors/announcements.csv", "discostorm_planner")
    rows = {
        (row["kind"], row["cast"], UNITS[row["unit"]]): row
        for row in calmer
        if row["product"] == software(table)
    }

    def calm(message: Message) -> Message:
        row = rows.get((message.kind, message.cast, message.unit))
        if row is None or not message.schedule.per_second:
            return message
        starts = tuple(float(time) for time in row["starts_s"].split())
        return replace(message, schedule=Schedule(starts, float(row["period_s"])))

    messages = tuple(map(calm, table.messages))
    if messages == table.messages:
        of = words.listed(list(dict.fromkeys(row["product"] for row in calmer)))
        return f"a longer announcement interval: known for the models of {of} only"
    lease = max(float(row["lease_s"]) for row in rows.values())
    fewer = replace(table, messages=messages, lease=lease)
    return Change("announcements", "a longer announcement interval", "table", table=fewer)


def _listed(table: Protocol) -> Change | str:
    """Return a table of Zenoh peers that have a list of others instead of Scouts.

    What belongs to a connection (``data/vendors/zenoh_links.csv``) is counted once for each two
    processes, as the one of them dials that has the other on its list; peers that find each other
    by Scouts both may.
    """
    if any(message.role is None for message in table.messages):
        return f"static peers: not known for {table.name}, whose messages have no roles"
    scouts = [m for m in table.messages if m.role == "announcement" and m.cast == "multicast"]
    scouting = {scout.phase for scout in scouts}
    rest = tuple(message for message in table.messages if message.phase not in scouting)
    if not scouts or not rest:
        return f"static peers: {table.name} sends no Scouts whose place they could take"
    kinds: dict[str | None, str] = {message.name: message.kind for message in table.messages}
    rows = {
        (row["kind"], row["answers"]): row
        for row in read_data("vendors/zenoh_links.csv", "discostorm_planner")
    }

    def of_a_link(message: Message) -> dict[str, str] | None:
        answers = kinds.get(message.answers, "")
        return rows.get((message.kind, "")) or rows.get((message.kind, answers))

    opening = [m for m in rest if (row := of_a_link(m)) and row["opens"] == "yes"]
    if opening:
        once = 0.5 / opening[0].per_unit
        rest = tuple(replace(m, per_unit=m.per_unit * once) if of_a_link(m) else m for m in rest)
    return Change("peers", "static peers", "table", table=replace(table, messages=rest))


def _hybrid() -> Iterator[Change]:
    """Yield this book's proposal."""
    row = row_of("hybrid", None)
    if row is not None and row["table"] in PROTOCOLS:
        yield Change("hybrid", row["title"], "table", table=PROTOCOLS[row["table"]])


def _switched(protocol: Protocol) -> Iterator[Change]:
    """Yield the tables of other middleware that count as this one does."""
    # On Wi-Fi nobody gets what a product sends where it takes the network for wired.
    wired = [table.wired for table in PROTOCOLS.values()]
    for table in PROTOCOLS.values():
        if table.family is None or table.basis == "mitigated" or table in wired:
            continue
        # What ROS 2 makes of a product may be another of its tables.
        of_ros2 = row_of("middleware", table.family)
        if is_built(table) and of_ros2 and of_ros2["table"] not in ("", table.name):
            continue
        if _counts(table) == _counts(protocol) and not same(table, protocol):
            yield Change("middleware", f"switching to {table.name}", "table", table=table)


def _counts(table: Protocol) -> str:
    """Return as what a table counts; one of your own as the paper's, with periods or without."""
    if is_built(table):
        return "built"
    return table.basis or ("timed" if table.repeats else "paper")


def sessions_note(
    old: Protocol,
    new: Protocol,
    before: float,
    after: float,
    cost: Callable[[Protocol], float],
    window: float,
) -> str:
    """Return what Zenoh's count leaves out beside what switching to or from it changes."""
    if old.family == new.family or "Zenoh" not in (old.family, new.family) or is_built(new):
        return ""  # products count what opens their sessions
    one, both = (cost(_openings(sides)) for sides in (1, 2))
    if not one:
        return ""
    to_zenoh = new.family == "Zenoh"
    more = after - before if to_zenoh else before - after
    if more >= 0:
        so = "and the sessions make it larger"
    elif more + both < 0:
        so = "and the sessions do not close it"
    else:
        so = "so either may need less"
    adds = [words.airtime(value, window) for value in (one, both)]
    return (
        f"the paper does not count how Zenoh opens sessions: that adds {adds[0]} if one side "
        f"dials, {adds[1]} if both do. The gap is {words.airtime(abs(more), window)}, {so}"
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
