"""Test the types and ranges of all arguments; no wrong one passes silently."""

import copy
import decimal
import math
import pickle
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd
import pytest
import sympy as sp

import discostorm as ds
from discostorm import _numeric, drain_times, uncertainty
from discostorm.messages import PROCESS

PAIR = ds.Fleet.swarm(2, 1, 1)
PAYLOAD = ds.Payload(350, 300, 400, "here")


def row(**changes: Any) -> ds.Message:
    fields: dict[str, Any] = {
        "name": "SPDP", "phase": "SPDP", "cast": "multicast", "transport": "UDP",
        "payload": PAYLOAD, "unit": PROCESS, "per_unit": 1,
    }  # fmt: skip
    return ds.Message(**fields | changes)


@pytest.mark.parametrize("make", [Fraction, sp.Integer, np.int16, np.float32])
def test_payloads_are_of_any_kind_of_number(make: Any) -> None:
    payload = ds.Payload(make(350), make(300), make(400), "here")
    assert (payload.nominal, payload.low, payload.high) == (350, 300, 400)
    assert {type(size) for size in (payload.nominal, payload.low, payload.high)} == {float}
    message = ds.Message("SPDP", "SPDP", "multicast", "UDP", payload, PROCESS, 1)
    assert ds.utilization(ds.Protocol("own", (message,)), 7, 2, 10) > 0


class Labelled:
    """As an xarray.DataArray, which need not be installed."""

    shape, ndim = (2,), 1

    def __array__(self, *_: object, **__: object) -> Any:
        return np.array([7.0, 8.0])

    def to_numpy(self) -> Any:
        return self.__array__()


@pytest.mark.parametrize(
    "value",
    [
        pd.Series([7, 8], index=[5, 3]),
        pd.Index([7, 8]),
        Labelled(),
        np.ma.array([7, 8], mask=[0, 1]),
        np.ma.array([7, 8]),
        [pd.Series([7, 8]), pd.Series([7, 8], index=[3, 5])],
        (7, Labelled()),
        [np.ma.masked, 7],
        [[7, 8], [np.ma.array(7.0), 8]],
    ],
    ids=lambda v: type(v).__name__,
)
def test_labels_and_masks_are_refused_as_numpy_would_drop_them(value: Any) -> None:
    text = f"must be .*; got a value of type {type(value).__name__} with labels or a mask, .*array"
    for name, call in {
        "hosts": lambda: ds.utilization(ds.DDS, value, 2, 10),
        "processes": lambda: ds.HostGroup(3, value, 10),
        "endpoints": lambda: ds.saturation_hosts(ds.DDS, 2, value),
        "window": lambda: ds.utilization(ds.DDS, 7, 2, 10, window=value),
        "x": lambda: ds.lambdify([sp.Symbol("x")], sp.Symbol("x"))(value),
    }.items():
        with pytest.raises(TypeError, match=f"{name} {text}"):
            call()


@pytest.mark.parametrize("value", [np.ma.array(7.0), np.ma.array(7.0, mask=True), np.ma.masked])
def test_one_masked_number_is_refused_too(value: Any) -> None:
    for call in (
        lambda: ds.Link(value, 0),
        lambda: ds.HostGroup(value, 2, 10),
        lambda: row(per_unit=value),
        lambda: ds.Radio("802.11n", mpdus=value),
        lambda: ds.Schedule((value,)),
    ):
        with pytest.raises(TypeError, match=r"must be .* with labels or a mask"):
            call()


class Refusing:
    """As an xarray.Dataset, which is no array and says so; or as a type that fails."""

    def __init__(self, error: type[Exception]) -> None:
        self.error = error

    def __array__(self, *_: object, **__: object) -> Any:
        raise self.error("not to be converted")


@pytest.mark.parametrize("error", [TypeError, RuntimeError])
def test_what_refuses_to_be_an_array_is_refused_by_name(error: type[Exception]) -> None:
    value: Any = Refusing(error)
    for call in (
        lambda: ds.utilization(ds.DDS, value, 2, 10),
        lambda: ds.HostGroup(value, 2, 10),
        lambda: ds.breakdown(ds.DDS, value, 2, 10),
        lambda: drain_times.first_idle(ds.DDS, value, 2, 10),
        lambda: drain_times.demand(ds.DDS, 1, value, 2, 10),
    ):
        with pytest.raises(TypeError, match=r"hosts must be .*; got <"):
            call()


@pytest.mark.parametrize(
    "value", [np.array(["UDP", "TCP"]), pd.Series(["UDP"]), pd.NA, ["UDP"], None], ids=repr
)
def test_words_are_one_word(value: Any) -> None:
    payload = ds.Payload(350, 300, 400, "here")
    with pytest.raises(ValueError, match="cast must be 'multicast' or 'unicast'; got"):
        ds.Message("SPDP", "SPDP", value, "UDP", payload, PROCESS, 1)
    with pytest.raises(ValueError, match="transport must be 'UDP' or 'TCP'; got"):
        ds.Message("SPDP", "SPDP", "unicast", value, payload, PROCESS, 1)
    with pytest.raises(TypeError, match="name must be a str; got"):
        ds.Message(value, "SPDP", "unicast", "UDP", payload, PROCESS, 1)
    with pytest.raises(TypeError, match="name must be a str; got"):
        ds.Protocol(value, ds.DDS.messages)
    with pytest.raises(TypeError, match="name must be a str; got"):
        ds.Wifi(value, ds.PAPER.unicast, ds.PAPER.multicast)
    with pytest.raises(TypeError, match="standard must be a str; got"):
        ds.Radio(value)


@pytest.mark.parametrize(
    "value",
    [[[1], [2, 3]], pd.Series([1.0, 2.0]), pd.NA, Labelled(), {}, "7", decimal.Decimal(1)],
    ids=lambda value: type(value).__name__,
)
@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("window", lambda value: ds.utilization(ds.DDS, 7, 2, 10, window=value)),
        ("window", lambda value: ds.breakdown(ds.DDS, 7, 2, 10, window=value)),
        ("window", lambda value: ds.DDS.load("SEDP", value)),
        ("time", lambda value: drain_times.demand(ds.DDS, value, 7, 2, 10)),
        ("hosts", lambda value: drain_times.first_idle(ds.DDS, value, 2, 10)),
        ("endpoints", lambda value: drain_times.outlook(ds.DDS, 7, 2, value)),
        ("extra", lambda value: drain_times.burst_drain_time(value, 0.5)),
        ("steady", lambda value: drain_times.burst_drain_time(1, value)),
        ("processes", lambda value: uncertainty.sensitivity(ds.DDS, value, 10)),
        ("O_uni", lambda value: uncertainty.utilization_at({"O_uni": value}, ds.DDS, PAIR)),
        ("lease", lambda value: ds.Protocol("own", ds.DDS.messages, lease=value)),
        ("frames", lambda value: row(frames=value)),
        ("period", lambda value: ds.Schedule((0.0,), value)),
        ("start_spacing", lambda value: ds.Radio("802.11n", mpdus=4, start_spacing=value)),
        ("content", lambda value: ds.Fleet.from_bytes(value, "x")),
        ("values", lambda value: uncertainty.utilization_at([value], ds.DDS, PAIR)),
    ],
)
def test_errors_are_the_packages_own(name: str, call: Any, value: Any) -> None:
    with pytest.raises((TypeError, ValueError), match=f"{name} must .*; got "):
        call(value)


def test_values_of_parameters_are_those_of_the_notation() -> None:
    usual = ds.utilization(ds.DDS, PAIR)
    # Another order of the same sums.
    assert uncertainty.utilization_at({}, ds.DDS, PAIR) == pytest.approx(usual, rel=1e-14)
    with pytest.raises(ValueError, match=r"values must name .*R_uni.*; got '1'"):
        uncertainty.utilization_at({1: 2}, ds.DDS, PAIR)
    for rate in ("R_uni", "R_multi"):
        with pytest.raises(ValueError, match=f"{rate} must be a finite number above 0; got 0"):
            uncertainty.utilization_at({rate: 0}, ds.DDS, PAIR)
    wired = ds.Fleet((*PAIR.groups, ds.HostGroup(2, 3, 7, "desk", wired=True)))
    usual = ds.utilization(ds.DDS, wired)
    assert uncertainty.utilization_at({}, ds.DDS, wired) == pytest.approx(usual, rel=1e-14)


@pytest.mark.parametrize("value", [-1, 10**400, float("nan"), float("inf")])
def test_bursts_and_steady_states_have_a_range(value: float) -> None:
    for name, given in (("extra", (value, 0.5)), ("steady", (1, value))):
        with pytest.raises(ValueError, match=rf"{name} must be .* at most 1e\+100; got"):
            drain_times.burst_drain_time(*given)


def test_arrays_without_dimensions_are_numbers() -> None:
    one, rate = np.array(1.0), np.array(6e6)
    link = ds.Link(rate, np.array(0.0))
    protocol = ds.Protocol("own", (row(frames=one, per_unit=one),), lease=np.array(20.0))
    found = ds.utilization(protocol, 7, 2, 10, ds.Wifi("own", link, link), window=one)
    link = ds.Link(6e6, 0.0)
    expected = ds.Protocol("own", (row(),), 20.0)
    assert found == ds.utilization(expected, 7, 2, 10, ds.Wifi("own", link, link))
    assert {protocol} == {expected}
    spaced = ds.Radio("802.11n", mpdus=4, start_spacing=np.array(0.0))
    assert spaced == ds.Radio("802.11n", mpdus=4)


def test_no_endpoints_to_ask_for_have_no_answers() -> None:
    assert np.shape(ds.utilization(ds.DDS, 7, 2, [])) == (0,)
    assert np.shape(ds.saturation_hosts(ds.DDS, 2, [])) == (0,)


def test_no_process_has_more_nodes_than_endpoints_for_them() -> None:
    text = "nodes must be at most 0.833333: each needs 12 endpoints .* process has 10; got 50"
    with pytest.raises(ValueError, match=text):
        ds.HostGroup(2, 1, [20, 10], nodes=50)
    with pytest.raises(ValueError, match=f"x: group 1: {text}"):
        ds.Fleet.from_bytes(b"[[groups]]\nhosts=2\nprocesses=1\nendpoints=10\nnodes=50", "x")


@pytest.mark.parametrize("rate", [1.0, 1e15])
@pytest.mark.parametrize("overhead", [0.0, 1e6])
@pytest.mark.parametrize("size", [0, 1e9])
def test_no_answer_is_infinite_and_numpy_need_not_be_patient(
    rate: float, overhead: float, size: float
) -> None:
    link = ds.Link(rate, overhead)
    wifi = ds.Wifi("own", link, link)
    payload = ds.Payload(size, 0, 1e9, "here")
    protocol = ds.Protocol(
        "own",
        tuple(
            ds.Message(m.name, m.phase, m.cast, m.transport, payload, m.unit, per_unit)
            for m, per_unit in zip(ds.DDS.messages, (1e-9, 1, 1, 1e9), strict=True)
        ),
    )
    with np.errstate(all="raise"):
        for count in (1, 1e9):
            for window in (1e-9, 1e6):
                for endpoints in (0, 1e9):
                    used = ds.utilization(protocol, count, count, endpoints, wifi, window=window)
                    both = [count, count]
                    array = ds.utilization(protocol, both, count, endpoints, wifi, window=window)
                    assert math.isfinite(used)
                    assert np.isfinite(array).all()
                    for limit in ([1e100], 1e100):
                        full = ds.saturation_hosts(
                            protocol, count, endpoints, wifi, limit, window=window
                        )
                        assert np.isfinite(full).all()


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: ds.Link(1e-310, 0), r"rate must be .* at least 1 and at most 1e\+15; got 1e-310"),
        (lambda: ds.Link(1e300, 0), r"rate must be .* at most 1e\+15; got 1e\+300"),
        (lambda: ds.Link(1e6, 1e7), r"overhead must be .* at most 1e\+06; got 10000000.0"),
        (lambda: ds.Payload(1, 1, 1e10, "x"), r"high must be .* at most 1e\+09; got 10000000000.0"),
        (lambda: ds.Schedule((0.0,), 1e-310), "period must be .* at least 1e-09, .*; got 1e-310"),
        (lambda: ds.utilization(ds.DDS, 7, 2, 10, window=1e-310), "window must be .* got 1e-310"),
    ],
)
def test_rates_and_times_have_a_lowest_and_a_highest_value(make: Any, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        make()


def test_an_ampdu_that_holds_no_frame_is_refused_where_it_is_used() -> None:
    padded = ds.WIFI["802.11n 20 MHz 2x2"]
    tiny = ds.Wifi("tiny", padded.unicast, padded.multicast, ds.Aggregation(2, 100, 1e-4))
    with pytest.raises(ValueError, match=r"most_bytes .* must hold every frame of SPDP; got 100"):
        ds.utilization(ds.DDS, 7, 2, 10, tiny)


@pytest.mark.parametrize("field", ["band", "width", "mcs", "mpdus"])
def test_a_radio_takes_one_number_each(field: str) -> None:
    for value in ([5e9], np.array([5e9]), pd.Series([5e9])):
        with pytest.raises(TypeError, match=f"{field} must be one number, not an array; got"):
            ds.Radio("802.11n", **{field: value})
    with pytest.raises(TypeError, match="name must be a str; got 3"):
        ds.Radio("802.11n", name=3)  # type: ignore[arg-type]


# Fleets of arrays


def group(**changes: Any) -> ds.HostGroup:
    fields: dict[str, Any] = {
        "hosts": [1, 2], "processes": 2, "endpoints": np.array([[0.0], [3.0]]), "name": "r",
    }  # fmt: skip
    return ds.HostGroup(**fields | changes)


def test_fleets_of_arrays_are_compared_and_hashed() -> None:
    assert group() == group(hosts=np.array([1.0, 2.0]), endpoints=[[-0.0], [3]])
    assert hash(group()) == hash(group(endpoints=[[-0.0], [3]]))
    assert ds.Fleet((group(),)) == ds.Fleet((group(),))
    assert len({ds.Fleet((group(),)), ds.Fleet((group(),))}) == 1
    for other in (
        group(hosts=[1, 3]), group(hosts=1), group(name="s"), group(hosts=[[1, 2]]), "r",
    ):  # fmt: skip
        assert group() != other


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))],
    ids=["copy", "deepcopy", "pickle"],
)  # fmt: skip
def test_copies_of_fleets_stay_frozen(again: Any) -> None:
    fleet = ds.Fleet((group(), ds.HostGroup(sp.Symbol("n", positive=True), 1, 1)))
    twin = again(fleet)
    assert twin == fleet
    with pytest.raises(ValueError, match="read-only"):
        twin.groups[0].hosts[0] = -5
    with pytest.raises(AttributeError):
        twin.groups[0].hosts = 3
    with pytest.raises(ValueError, match="read-only"):
        again(fleet.groups[0]).hosts[0] = -5


def test_tables_can_be_pickled() -> None:
    assert pickle.loads(pickle.dumps(dict(ds.PROTOCOLS))) == dict(ds.PROTOCOLS)


# What fleets are solved with


def test_polynomials_add_and_multiply_like_numbers() -> None:
    x = _numeric.Polynomial((0.0, 1.0))
    array = np.array([1.0, 2.0])

    def at(polynomial: Any, value: float) -> Any:
        parts = polynomial.coefficients
        return sum(part * value**degree for degree, part in enumerate(parts))

    for build in (
        lambda x: (x + 1) * (x - 3) - 2,
        lambda x: 2 + 3 * x,
        lambda x: (x - 1) * (x - 1) * (x + 0.5),
        lambda x: array * x + x * array - array,
    ):
        np.testing.assert_allclose(at(build(x), 1.5), build(1.5), rtol=1e-15)
    assert (1 + x - 1).coefficients == (0, 1)
