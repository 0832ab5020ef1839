"""Changes of a protocol table: other configurations, longer intervals, other middleware."""

from collections.abc import Iterator
from dataclasses import replace

from discostorm import wording
from discostorm.data import read_data
from discostorm.lookup import forward_to_all, with_timers_of
from discostorm.messages import UNIT_IF_SERVER_ON_ROBOT, UNITS, Message, Protocol, Schedule
from discostorm.protocols import PROTOCOLS, ZENOH
from discostorm.protocols.defaults import defaults
from discostorm.ros_releases import forwarding_release, newest_long_term, shipped_table
from discostorm_planner import remedy_rules as rules
from discostorm_planner.changes import Change, Setting


def protocol_changes(protocol: Protocol, ros: str | None = None) -> Iterator[Change | str]:
    """Yield other configurations, longer announcement intervals, and other middleware.

    Other middleware has the release that the ROS 2 distribution ships. Without one it is the newest
    with long-term support that ships this table, else the newest of all.
    """
    ships = [row for row in read_data("vendors/ros.csv") if row["protocol"] == protocol.key]
    if ships and ros not in {row["ros"] for row in ships}:
        ros = next(row["ros"] for row in reversed(ships) if row["long_term"] == "yes")
    ros = ros or newest_long_term()
    yield from _configuration_changes(protocol, ros)
    if protocol.family == "DDS":
        yield _announcement_interval_change(protocol)
    if protocol.family == "Zenoh":
        yield _static_peers_change(protocol)
    proposal = rules.rule("hybrid", None)
    if protocol.family is not None and proposal and proposal["table"] in PROTOCOLS:
        yield Change("hybrid", proposal["title"], "table", table=PROTOCOLS[proposal["table"]])
    yield from _release_changes(protocol)
    yield from _middleware_changes(protocol, ros)


def _configuration_changes(protocol: Protocol, ros: str) -> Iterator[Change | str]:
    """Yield other configurations of products; for the paper's counts, compare measured tables."""
    for row in rules.configuration_rules():
        table, product = PROTOCOLS.get(row["table"]), PROTOCOLS[row["base"]]
        if table is None or rules.same_table(table, protocol):
            continue
        name = rules.product_of(product)
        switches = rules.is_measured(protocol) and name != rules.product_of(protocol)
        if row["family"] != protocol.family and not switches:
            continue
        kind, what = row["kind"], row["title"]
        base, note, kinds = None, "", [kind]
        if switches:
            what = f"switching to {name} with {what}"
            kinds = ["middleware", *kinds]
        elif protocol.basis != "mitigated" and not rules.same_table(product, protocol):
            base = product
            note = f"both values use the measured model of {product.name.replace(', ', ' with ')}"
        if product.family == "DDS" and rules.is_measured(protocol):
            shipped = PROTOCOLS[shipped_table(str(name), ros)]
            table = with_timers_of(table, shipped if switches else protocol)
        if release := _forwarding_release(protocol, product, ros):
            if any(message.unit in UNIT_IF_SERVER_ON_ROBOT.values() for message in table.messages):
                yield f"{what}: not known for {release}, whose servers forward everything"
                continue
            if (forwarding := forward_to_all(table)) != table:
                table = forwarding
                note = f"{note}, and " * bool(note)
                note += f"the server forwards everything, as in {release}"
        yield Change(
            kind, what, "table", table=table, baseline=base, combined_note=note, kinds=tuple(kinds)
        )


def _forwarding_release(protocol: Protocol, product: Protocol, ros: str) -> str:
    """Return the plan's or the shipped release if its servers forward everything, else ""."""
    name, own = rules.product_of(product), rules.product_of(protocol)
    release = forwarding_release(name or "", ros)
    # A server that forwards everything has the key of the table that it was made from.
    server = PROTOCOLS.get(protocol.key or "", protocol).messages != protocol.messages
    same = own != name or server or protocol.key == release
    return release if same and rules.is_measured(protocol) else ""


def _announcement_interval_change(table: Protocol) -> Change | str:
    """Return the table with longer announcement intervals, or the products that support them."""
    announcements = read_data("vendors/announcements.csv", "discostorm_planner")
    own = [row for row in announcements if row["product"] == rules.product_of(table)]
    rows = {(row["kind"], row["cast"], UNITS[row["unit"]]): row for row in own}

    def rescheduled(message: Message) -> Message:
        row = rows.get((message.kind, message.cast, message.unit))
        if row is None or not message.schedule.per_second:
            return message
        starts = tuple(float(time) for time in row["starts_s"].split())
        return replace(message, schedule=Schedule(starts, float(row["period_s"])))

    messages = tuple(map(rescheduled, table.messages))
    if messages == table.messages:
        products = wording.join_words(list(dict.fromkeys(row["product"] for row in announcements)))
        return f"a longer announcement interval: known for the models of {products} only"
    lease = max(float(row["lease_s"]) for row in rows.values())
    changed = replace(table, messages=messages, lease=lease, key=None)
    return Change("announcements", "a longer announcement interval", "table", table=changed)


def _static_peers_change(table: Protocol) -> Change | str:
    """Return a table of Zenoh peers that use static peers instead of Scout messages.

    Messages of a link (``data/vendors/zenoh_links.csv``) count once per pair of processes, because
    only the process with the other on its list dials. With Scout messages, both peers may dial.
    """
    if any(message.role is None for message in table.messages):
        return f"static peers: not known for {table.name}, whose messages have no roles"
    scouts = [m for m in table.messages if m.role == "announcement" and m.cast == "multicast"]
    rest = tuple(m for m in table.messages if m.phase not in {scout.phase for scout in scouts})
    if not scouts or not rest:
        return f"static peers: {table.name} sends no Scouts that they could replace"
    kinds: dict[str | None, str] = {message.name: message.kind for message in table.messages}
    links = read_data("vendors/zenoh_links.csv", "discostorm_planner")
    opens = {(row["kind"], row["answers"]): row["opens"] for row in links}

    def opens_link(message: Message) -> str | None:
        answers = kinds.get(message.answers, "")
        return opens.get((message.kind, "")) or opens.get((message.kind, answers))

    opening = [message for message in rest if opens_link(message) == "yes"]
    if opening:
        once = 0.5 / opening[0].per_unit
        rest = tuple(replace(m, per_unit=m.per_unit * once) if opens_link(m) else m for m in rest)
    return Change("peers", "static peers", "table", table=replace(table, messages=rest, key=None))


def _release_changes(protocol: Protocol) -> Iterator[Change | str]:
    """Yield the product's tables in other ROS releases, in the newest long-term one that has it."""
    own = rules.product_of(protocol) if protocol.basis == "measured" else None
    shipped = [row for row in read_data("vendors/ros.csv") if row["product"] == own]
    if not shipped:
        yield f"another ROS release: none was measured with the messages of {protocol.name}"
    ros = {row["protocol"]: row["ros"] for row in sorted(shipped, key=lambda r: r["long_term"])}
    for name, distribution in ros.items():
        if name != protocol.key:
            what = f"moving to ROS 2 {wording.capitalized(distribution)} ({name})"
            yield Change("release", what, "table", table=PROTOCOLS[name])


def _middleware_changes(protocol: Protocol, ros: str) -> Iterator[Change]:
    """Yield the tables of other middleware with this table's basis, as a distribution ships it."""
    # Skip tables of wired networks: on Wi-Fi, no product sends that traffic.
    wired = {table.wired.key for table in PROTOCOLS.values() if table.wired}
    rows = [row for row in read_data("vendors/ros.csv") if row["ros"] == ros]
    shipped: dict[str | None, str | None] = {row["product"]: row["protocol"] for row in rows}
    for table in PROTOCOLS.values():
        product = rules.product_of(table)
        in_ros2 = rules.rule("middleware", table.family) if rules.is_measured(table) else None
        own = protocol.basis == "measured" and product == rules.product_of(protocol)
        # Within ROS 2, a product may have a separate table.
        separate = in_ros2 is not None and in_ros2["table"] not in ("", table.key)
        unfit = table.family is None or table.basis == "mitigated" or table.key in wired
        skipped = own or separate or unfit or shipped.get(product, table.key) != table.key
        comparable = _comparable_basis(table) == _comparable_basis(protocol)
        if comparable and not skipped and not rules.same_table(table, protocol):
            name = table.name.replace(", periods of ", " with the timers of ")
            name = name.replace(", version ", " ")
            yield Change("middleware", f"switching to {name}", "table", table=table)


def _comparable_basis(table: Protocol) -> str:
    """Return the basis of a table; a user's own counts are compared with the paper's."""
    if rules.is_measured(table):
        return "measured"
    return table.basis or ("timed" if table.repeats else "paper")


def session_setup_note(
    base: Setting, new: Protocol, before: float, after: float, window: float
) -> str:
    """Compare the gain of switching to or from Zenoh with the uncounted setup of sessions."""
    families = (base.protocol.family, new.family)
    if families[0] == families[1] or "Zenoh" not in families or rules.is_measured(new):
        return ""  # measured tables include the session setup
    single, double = (
        replace(base, protocol=_session_setup(sides)).utilization(window) for sides in (1, 2)
    )
    if not single:
        return ""
    gap = after - before if new.family == "Zenoh" else before - after
    so = "more than the sessions need"
    if gap + double >= 0:
        so = "and the sessions add to that" if gap >= 0 else "so either may need less"
    *adds, apart = (wording.airtime_text(value, window) for value in (single, double, abs(gap)))
    return (
        f"the paper does not count how Zenoh opens sessions: that adds {adds[0]} if one side "
        f"dials, {adds[1]} if both do. The protocols differ by {apart}, {so}"
    )


def _session_setup(sides: int) -> Protocol:
    """Return the messages that open sessions, if one side or both sides of a link dial."""
    # A session joins an unordered pair of processes, which is two ordered pairs.
    count = sides * defaults("Zenoh")["session_messages"] / 2
    keep_alive = ZENOH.message("KeepAlive")
    opening = replace(keep_alive, name="SessionOpening", per_unit=count, answers=None)
    return Protocol("Zenoh's sessions", (opening,))
