"""What decides each claim of ``data/paper/claims.csv``, by its key.

A test is a quantity with its arguments, a relation, and the value that the paper gives. Some
claims have a weaker test as well: what remains of the same sentence when the first fails. The
last three numbers of most arguments are hosts, processes and endpoints.
"""

from collections.abc import Callable

from discostorm.messages import Protocol
from discostorm.model import utilization
from discostorm.notation import N_E, N_H, N_P
from discostorm.protocols import DDS, ZENOH
from discostorm.saturation import saturation_hosts
from discostorm_book import lab_counts
from discostorm_book.ledger.criteria import Test
from discostorm_book.ledger.quantities import captured, evidence, frames, model

#: From the processes of a host to those of all others: how many pairs there are.
PAIRS = (N_H - 1) * N_P**2
#: The control messages of DDS.
CONTROL = ("Heartbeat_message", "ACKNACK_message")
SERVER = "Fast DDS Discovery Server"
ROUTER = "Zenoh router"
ROUTERS = "Zenoh router per host"
ONE_HUB = "Zenoh router per host, one hub"
#: How long the steady state was captured [s].
STEADY = lab_counts.WINDOWS["steady"][1] - lab_counts.WINDOWS["steady"][0]
#: How far a count of captures may be off, as chapter 10 has it.
WITHIN = 0.1


def quadratic(protocol: Protocol, name: str, *levels: float) -> Test:
    """Return the test that airtime grows by the square, from and to hosts, processes, endpoints."""
    return Test(model.growth_exponent, (protocol, name, *levels), "is", "quadratic")


def as_counted(product: str, message: str) -> Test:
    """Return the test that a product's start has the messages that the paper counts."""
    return Test(captured.sent_for_counted, (product, message), "≈", 1, WITHIN)


def disturbed(configuration: str, who: str) -> Test:
    """Return the test that these noticed in some runs that a server or router was killed."""
    return Test(evidence.runs_undisturbed, (configuration, "server killed", who), "<", 1)


#: Tests, by section of the paper. Claims without one cannot be checked.
TESTS: dict[str, Test] = {
    # Abstract and introduction (Sec. I)
    "exponential-growth": Test(model.growth_factor, (DDS,), ">", 1),
    "ten-hosts-melt-dds": Test(utilization, (DDS, 10, 1, 2), "≥", 1),
    "ten-hosts-melt-zenoh": Test(utilization, (ZENOH, 10, 1, 2), "≥", 1),
    "hundred-hosts-melt-dds": Test(utilization, (DDS, 100, 1, 0), "≥", 1),
    "hundred-hosts-melt-zenoh": Test(utilization, (ZENOH, 100, 1, 0), "≥", 1),
    "deterministic": Test(evidence.enumeration_agrees, (DDS, 4, 2, 6), "=", 1),
    "broadcast-is-excessive": Test(model.airtime, (DDS, "SPDP", 100, 2, 10), "is", "excessive"),
    "multicast-is-the-root-cause": Test(model.share, (DDS, "multicast", 7, 2, 10), "is", "cause"),
    "multicast-is-a-vulnerability": Test(frames.multicast_cost, ("SPDP",), ">", 1),
    "multicast-airtime-spdp": Test(frames.multicast_cost, ("SPDP",), "is", "high"),
    "multicast-airtime-scout": Test(frames.multicast_cost, ("Scout",), "is", "high"),
    "multicast-is-unreliable": Test(evidence.multicast_lost, (DDS, 7), "is", "poor"),
    "volume-saturates": Test(utilization, (DDS, 8, 2, 10), "≥", 1),
    "connectivity-collapses": Test(evidence.runs_converged, (8,), "≤", 0),
    "zenoh-is-lightweight": Test(model.gap, (7, 2, 10), "is", "lightweight"),
    "upper-bounds": Test(evidence.drained_over_saturation, (DDS, 64), "≤", 1),
    # Entities and assumptions (Sec. II and III-A)
    "configuration-suffices": Test(evidence.remedies_by_configuration, (), "≥", 1),
    "three-levels-dds": Test(captured.matching_ratio, ("Fast DDS",), "≈", 1, WITHIN),
    "three-levels-zenoh": Test(captured.matching_ratio, ("Zenoh peer",), "≈", 1, WITHIN),
    "locators-known-before": Test(evidence.default, ("rmw_zenoh", "router_multicast"), "=", 0),
    "peers-are-the-worst-case": Test(evidence.start_saved, (ROUTERS, 100), ">", 0),
    # DDS (Sec. III-B)
    "spdp-is-periodic": Test(captured.repeats, ("Fast DDS", "SPDP"), ">", 0),
    "spdp-of-a-host": as_counted("Fast DDS", "SPDP"),
    "spdp-needs-processes-alone": Test(captured.sent_spread, ("Fast DDS", "SPDP"), "≈", 1, WITHIN),
    "spdp-of-all": Test(model.load, (DDS, "SPDP"), "=", N_H * N_P),
    "spdp-both-ways": Test(evidence.enumerated_down_for_up, (DDS, "SPDP", 4, 2, 6), "=", 1),
    "spdp-downlink-costs-more": Test(frames.multicast_cost, ("SPDP",), ">", 1),
    "sedp-of-a-host": Test(model.host_load, (DDS, "SEDP_message"), "=", PAIRS * N_E),
    "sedp-is-unicast": Test(evidence.default, ("Cyclone DDS", "sedp_multicast_wired"), "=", 0),
    "sedp-of-a-host-squared": Test(model.host_load_degree, (DDS, "N_H", "SEDP_message"), "=", 2),
    "control-is-significant": Test(model.control_share, (DDS, 7, 2, 10), "is", "significant"),
    "heartbeat-per-topic": Test(model.messages_per_direction, (DDS, "Heartbeat_message"), "=", 2),
    "dds-control-of-a-host": Test(model.host_load, (DDS, *CONTROL), "=", 4 * PAIRS),
    "four-to-pair": Test(model.messages_per_link, (DDS, *CONTROL), "=", 4),
    "sedp-of-all": Test(model.load, (DDS, "SEDP"), "=", N_H * PAIRS * (N_E + 4)),
    "sedp-both-ways": Test(evidence.enumerated_down_for_up, (DDS, "SEDP", 4, 2, 6), "=", 1),
    # Zenoh (Sec. III-C)
    "scout-is-periodic": Test(captured.repeats, ("Zenoh peer", "Scout"), ">", 0),
    "scouting-of-a-host": Test(model.host_load, (ZENOH, "Scouting"), "=", N_P + PAIRS),
    "one-scout-per-process": as_counted("Zenoh peer", "Scout"),
    "a-hello-to-every-scout": as_counted("Zenoh peer", "Hello"),
    "scouting-connects-all": Test(model.messages_per_direction, (ZENOH, "Hello_message"), "=", 1),
    "scouting-of-all": Test(model.load, (ZENOH, "Scouting"), "=", N_H * N_P + N_H * PAIRS),
    "scouting-both-ways": Test(
        evidence.enumerated_down_for_up, (ZENOH, "Scouting", 4, 2, 6), "=", 1
    ),
    "sessions-with-all": Test(captured.sessions_per_pair, ("Zenoh peer",), "≈", 2, 2 * WITHIN),
    "declares-of-a-host": as_counted("Zenoh peer", "Declare"),
    "declares-as-sedp": Test(
        captured.sent_ratio, ("Zenoh peer", "Declare", "Fast DDS", "SEDP"), "≈", 1, WITHIN
    ),
    "zenoh-control-of-a-host": Test(model.host_load, (ZENOH, "KeepAlive_message"), "=", 2 * PAIRS),
    "two-to-keep-a-link": Test(model.messages_per_link, (ZENOH, "KeepAlive_message"), "=", 2),
    "keepalives-consolidate": Test(model.kinds_over, ("UDP", ZENOH, "Declaration"), ">", 0),
    "zenoh-control-is-efficient": Test(model.control_saved, (), "is", "significant"),
    "declares-of-all": Test(model.load, (ZENOH, "Declaration"), "=", N_H * PAIRS * (N_E + 2)),
    "declares-both-ways": Test(
        evidence.enumerated_down_for_up, (ZENOH, "Declaration", 4, 2, 6), "=", 1
    ),
    # Frames and rates (Sec. IV-A)
    "one-message-one-frame": Test(captured.messages_per_frame, ("Cyclone DDS",), "≈", 1, WITHIN),
    "frame-spdp": Test(frames.frame_bytes, ("SPDP",), "=", 414),
    "frame-sedp": Test(frames.frame_bytes, ("SEDP",), "=", 464),
    "frame-heartbeat": Test(frames.frame_bytes, ("Heartbeat",), "=", 116),
    "frame-acknack": Test(frames.frame_bytes, ("ACKNACK",), "=", 114),
    "frame-scout": Test(frames.frame_bytes, ("Scout",), "=", 80),
    "frame-hello": Test(frames.frame_bytes, ("Hello",), "=", 144),
    "frame-declare": Test(frames.frame_bytes, ("Declare",), "=", 176),
    "frame-keepalive": Test(frames.frame_bytes, ("KeepAlive",), "=", 84),
    "headers-udp": Test(frames.header, ("UDP",), "=", 64),
    "headers-tcp": Test(frames.header, ("TCP",), "=", 76),
    "payload-varies": Test(frames.payload_spread, ("SEDP",), ">", 0),
    "payload-of-heartbeat": Test(frames.payload_spread, ("Heartbeat",), "=", 0),
    "payload-of-acknack": Test(frames.payload_spread, ("ACKNACK",), "is", "near-fixed"),
    "payloads-from-captures": Test(evidence.payloads_measured, (DDS,), "=", 1),
    "headers-are-a-minimum": Test(model.header_slope, (DDS,), "≥", 0),
    "unicast-rate": Test(frames.ht_rate, (15,), "≈", 144.4e6),
    "lowest-basic-rate": Test(frames.lowest_basic_rate, (2.4,), "=", 6e6),
    "rate-is-mcs-7": Test(frames.ht_rate, (7,), "≈", 144.4e6, 0.05e6),
    "two-streams-are-conservative": Test(frames.ht_rates_above, (2, 20), "is", "conservative"),
    # Airtime (Sec. IV-B)
    "overhead-of-multicast": Test(frames.overhead_of_named_intervals, ("multicast",), "≈", 120e-6),
    "overhead-of-unicast": Test(frames.overhead_of_named_intervals, ("unicast",), "≈", 180e-6),
    "overhead-dominates-dds": Test(model.overhead_share, (DDS, 7, 2, 10), "is", "dominant"),
    "overhead-dominates-zenoh": Test(model.overhead_share, (ZENOH, 7, 2, 10), "is", "dominant"),
    "bytes-over-bits": Test(frames.bits_per_byte, (), "=", 1),
    "utilization-adds-up": Test(evidence.enumeration_ratio, (DDS, 4, 2, 6), "≈", 1, 1e-12),
    "lower-bound": Test(evidence.burst_over_model, (DDS, 7, 64), "≥", 1),
    "bursts-are-worse": Test(evidence.collided, (DDS, 7, 1), "is", "significant"),
    # Hosts: Fig. 2 (Sec. IV-C)
    "quadratic-hosts-dds": quadratic(DDS, "all", 2, 12, 2, 2, 10, 10),
    "quadratic-hosts-zenoh": quadratic(ZENOH, "all", 2, 12, 2, 2, 10, 10),
    "quadratic-sedp": quadratic(DDS, "SEDP", 2, 12, 2, 2, 10, 10),
    "quadratic-declares": quadratic(ZENOH, "Declaration", 2, 12, 2, 2, 10, 10),
    "declaration-is-more-efficient": Test(model.gap_of_phases, (7, 2, 10), "is", "slightly"),
    "declaration-saves-control": Test(model.gap_from_control, (7, 2, 10), "is", "cause"),
    "gap-is-marginal": Test(model.gap, (7, 2, 10), "is", "marginal"),
    "saturation-dds": Test(saturation_hosts, (DDS, 2, 10), "≈", 7),
    "saturation-zenoh": Test(saturation_hosts, (ZENOH, 2, 10), "≈", 8),
    "spdp-is-minor": Test(model.share, (DDS, "SPDP", 7, 2, 10), "is not", "dominant"),
    "scouting-is-minor": Test(model.share, (ZENOH, "Scouting", 7, 2, 10), "is not", "dominant"),
    "scouting-above-spdp": Test(model.scouting_above_spdp, (2, 12, 2, 10), "=", 11),
    "scouting-by-hello": Test(
        model.share_of_phase, (ZENOH, "Hello_message", "Scouting", 7, 2, 10), "is", "cause"
    ),
    # Processes and endpoints: Fig. 3 (Sec. IV-C)
    "design-of-processes": Test(model.saved_by_composing, (DDS, 3, 8, 40), "is", "significant"),
    "one-process-is-low-dds": Test(utilization, (DDS, 3, 1, 40), "is", "low"),
    "one-process-is-low-zenoh": Test(utilization, (ZENOH, 3, 1, 40), "is", "low"),
    "eight-processes-exceed-dds": Test(utilization, (DDS, 3, 8, 5), ">", 1),
    "eight-processes-exceed-zenoh": Test(utilization, (ZENOH, 3, 8, 5), ">", 1),
    "quadratic-processes-dds": quadratic(DDS, "all", 3, 3, 1, 8, 5, 5),
    "quadratic-processes-zenoh": quadratic(ZENOH, "all", 3, 3, 1, 8, 5, 5),
    "surge-dds": quadratic(DDS, "all", 3, 3, 1, 8, 40, 5),
    "surge-zenoh": quadratic(ZENOH, "all", 3, 3, 1, 8, 40, 5),
    "surge-by-pairs": Test(model.part_of_increase, (DDS, "SEDP", 3, 8, 40), "is", "cause"),
    "composing-reduces-control": quadratic(DDS, "control", 3, 3, 1, 8, 40, 5),
    "composing-fits-more-dds": Test(model.hosts_gained, (DDS, 8, 40), ">", 0),
    "composing-fits-more-zenoh": Test(model.hosts_gained, (ZENOH, 8, 40), ">", 0),
    # Nav2: Fig. 4 (Sec. IV-C)
    "three-robots-exceed-dds": Test(model.airtime, (DDS, "SEDP", 3, 1, 678), ">", 1),
    "three-robots-exceed-zenoh": Test(model.airtime, (ZENOH, "Declaration", 3, 1, 678), ">", 1),
    "two-robots-fit-dds": Test(utilization, (DDS, 2, 1, 678), "<", 1),
    "two-robots-fit-zenoh": Test(utilization, (ZENOH, 2, 1, 678), "<", 1),
    "sustained-saturation": Test(model.repeated_utilization, (ZENOH, 3, 3, 678), "≥", 1),
    "more-processes": Test(model.growth_exponent, (DDS, "all", 3, 3, 1, 3, 678, 678), ">", 0),
    "servers-reduce-traffic": Test(evidence.start_saved, (ROUTERS, 100), "is", "significant"),
    "routers-manage": Test(evidence.default, ("rmw_zenoh", "router_connect_endpoints"), ">", 0),
    "server-single-point": Test(evidence.runs_found, (SERVER, "server killed"), "=", 0),
    "router-single-point": disturbed(ROUTERS, "orphans and survivors"),
    "server-disrupts": disturbed(SERVER, "survivors"),
    "router-disrupts": disturbed(ROUTER, "survivors"),
    # Conclusion (Sec. V)
    "precise-saturation": Test(model.saturation_spread, (DDS, 2, 10), "is", "precise"),
    "beyond-saturation-dds": Test(utilization, (DDS, 8, 2, 10), ">", 1),
    "beyond-saturation-zenoh": Test(utilization, (ZENOH, 8, 2, 10), ">", 1),
    "small-clusters": Test(saturation_hosts, (DDS, 1, 2), "is", "small"),
}

#: What is left of the same sentence where the test fails.
WEAKER: dict[str, Test] = {
    "ten-hosts-melt-dds": Test(utilization, (DDS, 10, 2, 10), "≥", 1),
    "ten-hosts-melt-zenoh": Test(utilization, (ZENOH, 10, 2, 10), "≥", 1),
    "broadcast-is-excessive": Test(model.airtime, (DDS, "SPDP", 100, 2, 10), "is", "significant"),
    "connectivity-collapses": Test(evidence.runs_converged, (24,), "≤", 0),
    "upper-bounds": Test(evidence.drained_over_saturation, (DDS, 1), "≤", 1),
    "configuration-suffices": Test(evidence.remedies_by_configuration, (), ">", 0),
    "three-levels-dds": Test(captured.sent_spread, ("Fast DDS", "SEDP"), "≈", 1, WITHIN),
    "three-levels-zenoh": Test(captured.sent_spread, ("Zenoh peer", "Declare"), "≈", 1, WITHIN),
    "spdp-of-a-host": Test(model.host_load, (DDS, "SPDP"), "=", N_P),
    "spdp-needs-processes-alone": Test(evidence.enumerated_spread, (DDS, "SPDP", 4, 2, 6), "=", 1),
    "sedp-is-unicast": Test(evidence.default, ("Cyclone DDS", "sedp_multicast_wifi"), "=", 0),
    "four-to-pair": Test(model.messages_per_direction, (DDS, *CONTROL), "=", 4),
    "one-scout-per-process": Test(model.host_load, (ZENOH, "multicast"), "=", N_P),
    "a-hello-to-every-scout": Test(model.host_load, (ZENOH, "Hello_message"), "=", PAIRS),
    "sessions-with-all": Test(captured.sessions_per_pair, ("Zenoh peer",), "≥", 1),
    "declares-of-a-host": Test(model.host_load, (ZENOH, "Declare_message"), "=", PAIRS * N_E),
    "declares-as-sedp": Test(
        model.load_difference, (ZENOH, "Declare_message", DDS, "SEDP_message"), "=", 0
    ),
    "two-to-keep-a-link": Test(model.messages_per_direction, (ZENOH, "KeepAlive_message"), "=", 2),
    "keepalives-consolidate": Test(evidence.default, ("Zenoh", "keep_alives"), ">", 0),
    "one-message-one-frame": Test(captured.messages_per_frame, ("Fast DDS",), "≥", 1),
    "payloads-from-captures": Test(evidence.payloads_measured, (DDS,), ">", 0),
    "lowest-basic-rate": Test(frames.lowest_basic_rate, (5,), "=", 6e6),
    "rate-is-mcs-7": Test(frames.ht_rate_of_streams, (7, 2), "≈", 144.4e6, 0.05e6),
    "two-streams-are-conservative": Test(frames.ht_rates_above, (3, 20), "is", "conservative"),
    "overhead-of-multicast": Test(frames.overhead_with_backoff, ("multicast",), "≈", 120e-6),
    "overhead-of-unicast": Test(frames.overhead_with_backoff, ("unicast",), "≈", 180e-6),
    "bytes-over-bits": Test(frames.bits_per_byte, (), "=", 8),
    "lower-bound": Test(evidence.burst_excess, (DDS, 2, 1), "≥", 0),
    "declaration-is-more-efficient": Test(model.gap_of_phases, (7, 2, 10), ">", 0),
    "gap-is-marginal": Test(model.gap_limit, (), "is", "marginal"),
    "surge-dds": quadratic(DDS, "control", 3, 3, 1, 8, 40, 5),
    "surge-zenoh": quadratic(ZENOH, "control", 3, 3, 1, 8, 40, 5),
    "sustained-saturation": Test(model.repeated_utilization, (ZENOH, 3, 13, 0), "≥", 1),
    "routers-manage": Test(evidence.default, ("rmw_zenoh", "session_multicast"), "=", 0),
    "server-disrupts": Test(evidence.runs_found, (SERVER, "server killed"), "<", 1),
    "precise-saturation": Test(model.saturation_spread_by_payloads, (DDS, 2, 10), "is", "precise"),
    "small-clusters": Test(saturation_hosts, (DDS, 2, 10), "is", "small"),
}

#: Numbers of a remark, beside the ``{ours}`` and ``{weaker}`` that its tests found.
NUMBERS: dict[str, Callable[[], dict[str, float]]] = {
    "multicast-is-the-root-cause": lambda: {
        "unicast": model.share(DDS, "unicast", 7, 2, 10),
        "unicast_nav2": model.share(DDS, "unicast", 3, 1, 678),
    },
    "multicast-airtime-spdp": lambda: {"multicast": model.share(DDS, "multicast", 7, 2, 10)},
    "multicast-is-unreliable": lambda: {
        "standard": evidence.multicast_lost_on_a_disc(DDS, 7, "standard"),
        "ns3": evidence.multicast_lost_on_a_disc(DDS, 7, "ns-3"),
    },
    "deterministic": lambda: {
        "matching": captured.matching_ratio("Fast DDS"),
        "scatter": captured.run_scatter("Fast DDS"),
    },
    "half-publish": lambda: {"declares": captured.sent_for_counted("Zenoh peer", "Declare")},
    "peers-are-the-worst-case": lambda: {"one_router": evidence.start_saved(ROUTER, 100)},
    "control-is-significant": lambda: {"nav2": model.control_share(DDS, 3, 1, 678)},
    "spdp-is-periodic": lambda: {
        "fast": STEADY / captured.repeats("Fast DDS", "SPDP"),
        "cyclone": STEADY / captured.repeats("Cyclone DDS", "SPDP"),
    },
    "spdp-of-a-host": lambda: {"cyclone": captured.sent_for_counted("Cyclone DDS", "SPDP")},
    "sedp-of-a-host": lambda: {
        "fast": captured.sent_for_counted("Fast DDS", "SEDP"),
        "cyclone": captured.sent_for_counted("Cyclone DDS", "SEDP"),
    },
    "dds-control-of-a-host": lambda: {
        "heartbeats": captured.sent_for_counted("Fast DDS", "Heartbeat"),
        "acknacks": captured.sent_for_counted("Cyclone DDS", "ACKNACK"),
    },
    "scout-is-periodic": lambda: {"period": STEADY / captured.repeats("Zenoh peer", "Scout")},
    "a-hello-to-every-scout": lambda: {"scouts": captured.sent_for_counted("Zenoh peer", "Scout")},
    "zenoh-control-of-a-host": lambda: {
        "sent": captured.sent_for_counted("Zenoh peer", "KeepAlive")
    },
    "one-message-one-frame": lambda: {"zenoh": captured.messages_per_frame("Zenoh peer")},
    "lower-bound": lambda: {
        "saved": -evidence.burst_excess(DDS, 2, 1),
        "two": evidence.burst_over_model(DDS, 2, 1),
        "thirty": evidence.burst_over_model(DDS, 30, 1),
        "standard": frames.standard_bound(DDS, 7, 2, 10),
    },
    "bursts-are-worse": lambda: {
        "single": -evidence.burst_excess(DDS, 7, 1),
        "aggregated": evidence.burst_excess(DDS, 7, 64),
    },
    "surge-by-pairs": lambda: {
        "control": model.part_of_increase(DDS, "control", 3, 8, 40),
        "endpoints": model.part_of_increase(DDS, "SEDP_message", 3, 8, 40),
    },
    "headers-tcp": lambda: {"timestamps": frames.timestamps_bytes()},
    "declaration-is-more-efficient": lambda: {"nav2": model.gap_of_phases(3, 1, 678)},
    "surge-dds": lambda: {"times": model.split_ratio(DDS, 3, 8, 40)},
    "surge-zenoh": lambda: {"times": model.split_ratio(ZENOH, 3, 8, 40)},
    "servers-reduce-traffic": lambda: {
        "routers_7": evidence.start_saved(ROUTERS, 7),
        "routers_100": evidence.start_saved(ROUTERS, 100),
        "server_7": evidence.start_saved(SERVER, 7),
        "server_100": evidence.start_saved(SERVER, 100),
        "on_robot_7": evidence.start_saved("Fast DDS Discovery Server, on a robot", 7),
        "on_robot_100": evidence.start_saved("Fast DDS Discovery Server, on a robot", 100),
    },
    "server-single-point": lambda: {
        "survivors": evidence.runs_undisturbed(SERVER, "server killed", "survivors"),
        "with_two": evidence.runs_found("Fast DDS Discovery Server, two", "server killed"),
    },
    "router-single-point": lambda: {
        "one_hub": evidence.runs_undisturbed(ONE_HUB, "server killed", "survivors"),
    },
}
