"""Test that errors of bad input name the parameter, its value and the allowed range."""

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp

import discostorm as ds
from discostorm import drain_times, robots, uncertainty, wifi
from discostorm.messages import PROCESS
from discostorm.notation import N_H, N_P

PAYLOAD = ds.Payload(350, 300, 400, "here")

SWARM: dict[str, Any] = {"hosts": 7, "processes": 2, "endpoints": 10}
LOW = {"hosts": 1, "processes": 1, "endpoints": 0}

NOT_FINITE = [(float("nan"), "nan"), (float("inf"), "inf"), (-float("inf"), "-inf")]
NOT_REAL: list[Any] = [
    "7",
    b"7",
    None,
    True,
    7 + 0j,
    {},
    object,
    np.datetime64("2020-01-01"),
    [1, "2"],
    [None],
]


def fails(kind: type[Exception], text: str, call: Callable[..., object], **given: Any) -> None:
    with pytest.raises(kind, match=re.escape(text)):
        call(**given)


def utilization(**given: Any) -> object:
    return ds.utilization(**{"protocol": ds.DDS, **SWARM, **given})


def breakdown(**given: Any) -> object:
    return ds.breakdown(**{"protocol": ds.DDS, **SWARM, **given})


def saturation_hosts(**given: Any) -> object:
    swarm = {name: SWARM[name] for name in ("processes", "endpoints")}
    return ds.saturation_hosts(**{"protocol": ds.DDS, **swarm, **given})


def taking(name: str) -> list[Callable[..., object]]:
    """Return the functions that have a parameter of that name."""
    both: list[Callable[..., object]] = [utilization, breakdown]
    return both if name == "hosts" else [*both, saturation_hosts]


each_count = pytest.mark.parametrize(
    ("call", "name"),
    [(call, name) for name in SWARM for call in taking(name)],
    ids=lambda value: getattr(value, "__name__", value),
)


@each_count
def test_counts_out_of_range(call: Callable[..., object], name: str) -> None:
    low = LOW[name]
    allowed = f"{name} must be a finite number of at least {low} and at most 1e+09; got "
    for value, shown in [
        (low - 1, f"{low - 1}"),
        (-1, "-1"),
        (low - 1e-9, repr(low - 1e-9)),
        (10**9 + 1, "1000000001"),
        (10**400, "1000000000000000"),
        *NOT_FINITE,
    ]:
        fails(ValueError, allowed + shown, call, **{name: value})


@each_count
@pytest.mark.parametrize("value", NOT_REAL, ids=repr)
def test_counts_that_are_no_numbers(call: Callable[..., object], name: str, value: object) -> None:
    if value is None and call is not saturation_hosts and name != "hosts":
        text = f"{name} must be given unless hosts is a Fleet; got None"
    else:
        text = f"{name} must be a finite number of at least {LOW[name]} and at most 1e+09"
    fails(TypeError, text, call, **{name: value})


@pytest.mark.parametrize("name", SWARM)
def test_one_bad_element_of_an_array(name: str) -> None:
    for bad, shown in [(-1, "-1"), *NOT_FINITE]:
        fails(ValueError, f"{name} must be a finite number", utilization, **{name: [5, bad, 6]})
        fails(ValueError, f"got {shown}", utilization, **{name: np.array([5, bad, 6])})


@each_count
def test_ragged_lists(call: Callable[..., object], name: str) -> None:
    fails(ValueError, f"{name} must be a finite number", call, **{name: [[1, 2], [3]]})
    fails(ValueError, "or an array of them; got [[1, 2], [3]]", call, **{name: [[1, 2], [3]]})


def test_shapes_that_do_not_broadcast() -> None:
    text = "the shapes of the arguments must broadcast together; got "
    fails(
        ValueError,
        f"{text}hosts (2,), endpoints (3,)",
        utilization,
        hosts=[1, 2],
        endpoints=[1, 2, 3],
    )
    fails(
        ValueError,
        f"{text}processes (2,), limit (3,)",
        saturation_hosts,
        processes=[1, 2],
        limit=[1, 2, 3],
    )
    x, y = sp.symbols("x y")
    fails(ValueError, f"{text}x (2,), y (3,)", ds.lambdify([x, y], x), x=[1, 2], y=[1, 2, 3])


def test_arrays_where_one_number_is_needed() -> None:
    fails(
        TypeError, "hosts must be one number, not an array; got array([1., 2.])",
        breakdown, hosts=[1, 2],
    )  # fmt: skip


@pytest.mark.parametrize("call", [utilization, breakdown, saturation_hosts])
def test_protocol_and_wifi_of_another_kind(call: Callable[..., object]) -> None:
    fails(TypeError, "protocol must be a Protocol; got 5", call, protocol=5)
    fails(TypeError, "protocol must be a Protocol; got None", call, protocol=None)
    fails(TypeError, "wifi must be a Wifi; got 6000000.0", call, wifi=6e6)
    fails(TypeError, "wifi must be a Wifi; got None", call, wifi=None)


@pytest.mark.parametrize("phase", ["Scouting", "spdp", "", 3, ["SPDP"]])
def test_unknown_phase(phase: Any) -> None:
    text = f"phase must be 'SPDP' or 'SEDP' for DDS, or None; got {phase!r}"
    fails(ValueError, text, utilization, phase=phase)
    fails(ValueError, text, ds.DDS.load, phase=phase)
    fails(ValueError, text, ds.DDS.utilization, phase=phase)


def test_of_several_wrong_elements_the_first_is_named() -> None:
    # Those at the ends of the range are right.
    fails(ValueError, "got -2.0", utilization, **SWARM | {"hosts": [1, 1e9, -2, -3]})


@pytest.mark.parametrize("value", [-1, -1.0, np.int8(-1), -(10**30), sp.Integer(-1)], ids=repr)
def test_a_wrong_value_is_shown_as_it_was_given(value: Any) -> None:
    with pytest.raises(ValueError, match=rf"; got {value}$"):
        utilization(hosts=value)


def test_limit() -> None:
    allowed = "limit must be a finite number above 0 and at most 1e+100"
    for value, shown in [(0, "0"), (-1, "-1"), (1e101, "1e+101"), *NOT_FINITE]:
        fails(ValueError, f"{allowed}; got {shown}", saturation_hosts, limit=value)
    fails(TypeError, f"{allowed}, or an array of them; got 'all'", saturation_hosts, limit="all")


def test_unknown_model_unit_fleet_product_or_padding() -> None:
    for call in (
        ds.DDS.utilization,
        ds.DDS.messages[0].airtime_up,
        ds.DDS.messages[0].airtime_down,
        ds.DDS.messages[1].airtime_down,
    ):
        text = "model must be 'linear' or 'padded' or 'aggregated'; got 'Linear'"
        fails(ValueError, text, call, model="Linear")
    for call in (ds.DDS.utilization, ds.DDS.messages[0].load):
        fails(TypeError, "fleet must be a Fleet; got 3", call, fleet=3)
    text = "protocol must be a Protocol; got 5"
    for call in (drain_times.drain_time, drain_times.outlook, drain_times.first_idle):
        fails(TypeError, text, call, protocol=5, **SWARM)
    fails(TypeError, text, drain_times.demand, protocol=5, time=1, **SWARM)
    fails(
        TypeError, "padding must be an OfdmSymbols; got 3", ds.Link, rate=1e6, overhead=0, padding=3
    )
    link = ds.Link(6e6, 0, ds.OfdmSymbols(24, 4e-6, 4e-6))
    text = "aggregation must be an Aggregation; got 3"
    fails(TypeError, text, ds.Wifi, name="x", unicast=link, multicast=link, aggregation=3)


@pytest.mark.parametrize("model", [[], {}, np.array([1])], ids=repr)
def test_a_model_that_is_no_word_is_refused_by_name(model: Any) -> None:
    text = "model must be 'linear' or 'padded' or 'aggregated'; got "
    message = ds.DDS.messages[0]
    for call in (ds.DDS.utilization, message.airtime_up, message.airtime_down):
        fails(ValueError, text, call, model=model)
    fails(ValueError, text, wifi.uplink_airtime, frame_bytes=N_H, model=model)
    text = "cast must be 'multicast' or 'unicast'; got "
    fails(ValueError, text, wifi.downlink_airtime, frame_bytes=N_H, cast=model)


def test_schedules_robots_and_seeds() -> None:
    every = ds.Schedule((0.0,), 3)
    text = "window must be a finite number of at least 1e-09, or infinity; got "
    fails(ValueError, f"{text}0", every.mean, window=0)
    fails(TypeError, text.partition(";")[0], every.mean, window="3")
    text = "until must be a finite number of at least 0 and at most 3e+08; got "
    fails(ValueError, f"{text}inf", every.times, until=float("inf"))
    fails(TypeError, f"{text}None", every.times, until=None)
    fails(TypeError, "nodes must be a finite number", robots.shared_endpoints, nodes="3")
    fails(TypeError, "endpoints must be a finite number", robots.likely_nodes, endpoints="3")
    fails(ValueError, "endpoints must be a finite number", robots.likely_nodes, endpoints=-1)
    text = "seed must be a whole number of at least 0; got "
    fails(TypeError, text, uncertainty.sample, protocol=ds.DDS, seed=np.timedelta64(3, "s"))


def test_limit_that_one_host_exceeds() -> None:
    single = ds.utilization(ds.DDS, 1, 2, 10)
    text = (
        f"limit must be at least the utilization of a single host with DDS, {single!r}; got 0.001"
    )
    fails(ValueError, text, saturation_hosts, limit=0.001)
    fails(ValueError, text, saturation_hosts, limit=[1, 0.001, 0.0005])


# Fleets


def test_fractions_that_would_send_a_negative_number_of_messages() -> None:
    for table, counts in (("Cyclone DDS", (1.5, 1, 10)), ("Zenoh router per host", (1.5, 1, 10))):
        with pytest.raises(
            ValueError, match=r"hosts and processes must be whole .* got 1\.5 and 1"
        ):
            ds.breakdown(ds.PROTOCOLS[table], *counts)
    # Where a fraction sends nothing negative, it is counted.
    assert ds.breakdown(ds.DDS, 1.5, 1, 10).loc["SEDP", "uplink_messages"] == 7.5


def test_fleet_and_counts_exclude_each_other() -> None:
    fleet = ds.Fleet.swarm(7, 2, 10)
    fails(
        TypeError,
        "processes must be left out when hosts is a Fleet; got 2",
        ds.utilization,
        protocol=ds.DDS,
        hosts=fleet,
        processes=2,
    )


@pytest.mark.parametrize("name", SWARM)
def test_host_group(name: str) -> None:
    allowed = f"{name} must be a finite number of at least {LOW[name]} and at most 1e+09"
    fails(ValueError, f"{allowed}; got nan", ds.HostGroup, **{**SWARM, name: float("nan")})
    fails(ValueError, f"{allowed}; got -1", ds.HostGroup, **{**SWARM, name: sp.Integer(-1)})
    fails(TypeError, f"{allowed}, or an array", ds.HostGroup, **{**SWARM, name: "many"})
    fails(TypeError, f"{allowed}, or an array", ds.HostGroup, **{**SWARM, name: sp.nan})
    named = {**SWARM, name: 10**300, "name": "scouts"}
    fails(ValueError, f"group 'scouts': {allowed}; got 1000", ds.HostGroup, **named)


def test_what_is_shared_is_at_most_the_fewest_endpoints() -> None:
    for counts in ([10, 4], [4, 10]):
        assert ds.HostGroup(2, 1, counts, shared=4).shared == 4
        fails(
            ValueError,
            "at most 4; got 5",
            ds.HostGroup,
            hosts=2,
            processes=1,
            endpoints=counts,
            shared=5,
        )


def test_symbols_where_numbers_are_needed() -> None:
    text = "hosts must be a number here, not an expression; got N_H"
    fails(TypeError, text, utilization, hosts=N_H)
    fails(TypeError, text, breakdown, hosts=N_H)
    fails(
        TypeError,
        "processes must be a number here, not an expression; got N_P",
        saturation_hosts,
        processes=N_P,
    )


def test_fleet() -> None:
    group = ds.HostGroup(7, 2, 10)
    fails(ValueError, "groups must hold at least one HostGroup; got none", ds.Fleet, groups=())
    fails(TypeError, "groups must be a tuple of HostGroup; got HostGroup(", ds.Fleet, groups=group)
    fails(TypeError, "groups[1] must be a HostGroup; got 3", ds.Fleet, groups=(group, 3))
    assert ds.Fleet([group]).groups == (group,)  # type: ignore[arg-type]
    text = "groups must be a whole number of at least 1 and at most 1000; got "
    for value in (0, 1.5, 2**63):
        fails(ValueError, f"{text}{value}", ds.Fleet.symbolic, groups=value)
    fails(TypeError, f"{text}'2'", ds.Fleet.symbolic, groups="2")
    fails(
        ValueError,
        "arguments must broadcast together; got groups[0].hosts (2,), groups[1].endpoints (3,)",
        ds.Fleet,
        groups=(ds.HostGroup([1, 2], 1, 1), ds.HostGroup(1, 1, [1, 2, 3])),
    )


def test_the_content_of_a_fleet_file_is_bytes_of_any_kind() -> None:
    content = b"[[groups]]\nhosts = 7\nprocesses = 2\nendpoints = 10\n"
    for kind in (bytes, bytearray, memoryview):
        fleet = ds.Fleet((ds.HostGroup(7, 2, 10, shared=2),))
        assert ds.Fleet.from_bytes(kind(content), "it") == fleet
    for value in (content.decode(), None, [1]):
        text = f"content must be bytes, a bytearray or a memoryview; got {value!r}"[:60]
        fails(TypeError, text, ds.Fleet.from_bytes, content=value, name="it")
    fails(TypeError, "name must be a str; got 3", ds.Fleet.from_bytes, content=content, name=3)


# Tables of one's own


def test_payload() -> None:
    def payload(**given: Any) -> object:
        fields: dict[str, Any] = {"nominal": 350, "low": 300, "high": 400, "source": "here"}
        return ds.Payload(**fields | given)

    fails(
        ValueError,
        "payload (here): low must be a finite number of at least 0 and at most 1e+09; got -1",
        payload,
        low=-1,
    )
    fails(
        ValueError,
        "payload (here): nominal must be a finite number of at least 300 and at most 400; got 401",
        payload,
        nominal=401,
    )
    text = "high must be a finite number of at least 300 and at most 1e+09; got inf"
    fails(ValueError, text, payload, high=np.inf)
    fails(TypeError, "low must be a finite number of at least 0", payload, low="little")


def message(**given: Any) -> ds.Message:
    fields: dict[str, Any] = {
        "name": "SPDP",
        "phase": "SPDP",
        "cast": "multicast",
        "transport": "UDP",
        "payload": PAYLOAD,
        "unit": PROCESS,
        "per_unit": 1,
    }
    return ds.Message(**fields | given)


def test_message() -> None:
    fails(
        ValueError, "cast must be 'multicast' or 'unicast'; got 'broadcast'", message,
        cast="broadcast",
    )  # fmt: skip
    fails(ValueError, "transport must be 'UDP' or 'TCP'; got 'QUIC'", message, transport="QUIC")
    fails(TypeError, "payload of SPDP: nominal must be a finite number", message, payload="350 B")
    text = (
        "payload of SPDP: nominal must be a finite number of at least 0 and at most 1e+09; got -1"
    )
    fails(ValueError, text, message, payload=-1)
    fails(TypeError, "unit must be a Unit; got 'process'", message, unit="process")
    fails(ValueError, "per_unit must be a finite number of at least 1e-09", message, per_unit=0)


def test_protocol() -> None:
    def protocol(messages: Any, name: str = "mine") -> object:
        return ds.Protocol(name, messages)

    text = "name must be a non-blank string; got ' '"
    fails(ValueError, text, protocol, messages=ds.DDS.messages, name=" ")
    fails(ValueError, "messages must hold at least one Message; got none", protocol, messages=())
    fails(TypeError, "messages must be a tuple of Message; got 'SPDP'", protocol, messages="SPDP")
    fails(TypeError, "messages[0] must be a Message; got 'SPDP'", protocol, messages=["SPDP"])
    twice = (message(), message(phase="again"))
    fails(
        ValueError, "messages must have distinct names; got 'SPDP' twice", protocol, messages=twice
    )


# The channel


@pytest.mark.parametrize(
    ("name", "low"),
    [("rate", "of at least 1 and at most 1e+15"), ("overhead", "of at least 0 and at most 1e+06")],
)
def test_link(name: str, low: str) -> None:
    def link(**given: Any) -> object:
        return ds.Link(**{"rate": 6e6, "overhead": 120e-6} | given)

    for value, shown in [(-1, "-1"), *NOT_FINITE]:
        text = f"{name} must be a finite number {low}; got {shown}"
        fails(ValueError, text, link, **{name: value})
    fails(TypeError, f"{name} must be a finite number {low}", link, **{name: "fast"})
    fails(TypeError, f"{name} must be one number, not an array; got [1, 2]", link, **{name: [1, 2]})


def test_wifi() -> None:
    link = ds.Link(6e6, 120e-6)
    fails(
        TypeError, "multicast must be a Link; got 6000000.0",
        ds.Wifi, name="mine", unicast=link, multicast=6e6,
    )  # fmt: skip


# Functions made of expressions


def test_lambdify() -> None:
    x, y = sp.symbols("x y")

    def lambdify(symbols: Any, expression: Any) -> object:
        return ds.lambdify(symbols, expression)

    fails(
        ValueError, "symbols must list every symbol in expression; y is missing",
        lambdify, symbols=[x], expression=x * y,
    )  # fmt: skip
    fails(TypeError, "symbols[0] must be a Symbol; got 'x'", lambdify, symbols=["x"], expression=x)
    fails(TypeError, "expression must be an Expr; got 'x'", lambdify, symbols=[x], expression="x")
    for twice in ([x, x], [x, sp.Symbol("x", positive=True)]):
        text = "symbols must have distinct names; got 'x' twice"
        fails(ValueError, text, lambdify, symbols=twice, expression=x)
    function = ds.lambdify([x, y], x)
    fails(TypeError, "the function takes x, y; got 0 in order and x by name", function, x=1)
    fails(TypeError, "the function takes x, y; got 0 in order and x, z by name", function, x=1, z=2)
    for args, given in [((1, 2, 3), "3 in order"), ((1, 2), "2 in order and x by name")]:
        with pytest.raises(TypeError, match=f"the function takes x, y; got {given}$"):
            function(*args, **({} if len(args) == 3 else {"x": 1}))
    imaginary = ds.lambdify([x], sp.I * sp.sqrt(x))
    for value in (4, [1, 4]):
        fails(ValueError, "expression must be real; I*sqrt(x) is not", imaginary, x=value)
    fails(ValueError, "y must be a finite number; got nan", function, x=1, y=float("nan"))
    fails(
        TypeError, "y must be a finite number, or an array of them; got '1'", function, x=1, y="1"
    )
