"""Arguments that `plan` refuses: errors name the parameter, the value and the allowed values."""

from collections.abc import Callable
from typing import Any

import pytest
from planner_by_hand import FIG3, PLAN_OF_FIG3

import discostorm as ds
from discostorm_planner.fleet_changes import split_hosts

#: Neither text nor a fleet.
WRONG: Any = 5
#: Values that are not a single number.
PROTOCOL_SETS: Any = [1, 2]
MANY = ds.Fleet(tuple(ds.HostGroup(1, 1, endpoints) for endpoints in range(1001)))
WIDTH = "width must be a whole number of at least 1"


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: ds.plan(WRONG), TypeError, "fleet must be a Fleet; got 5"),
        (lambda: ds.plan(FIG3, WRONG), TypeError, "protocol must be a Protocol; got 5"),
        (lambda: ds.plan(FIG3, ds.DDS, WRONG), TypeError, "wifi must be a Wifi; got 5"),
        (
            lambda: ds.plan(ds.Fleet.swarm(2.5, 1, 1)),
            ValueError,
            r"hosts must be a whole number of at least 1; got 2\.5",
        ),
        (
            lambda: ds.plan(ds.Fleet.swarm(3, 2.5, 10)),
            ValueError,
            r"processes must be a whole number of at least 1; got 2\.5",
        ),
        (
            lambda: ds.plan(ds.Fleet((ds.HostGroup(2.5, 1, 1, name="r"),))),
            ValueError,
            r'hosts of "r" must be a whole number of at least 1; got 2\.5',
        ),
        (
            lambda: ds.plan(ds.Fleet.swarm([1, 2], 1, 1)),
            TypeError,
            "hosts must be one number, not an array",
        ),
        (
            lambda: ds.plan(ds.Fleet.symbolic(1)),
            TypeError,
            "hosts must be a number here, not an expression",
        ),
        (lambda: ds.plan(FIG3, window=0), ValueError, "window must be a finite number"),
        (lambda: ds.plan(FIG3, window=PROTOCOL_SETS), TypeError, "window must be one number"),
        (
            lambda: ds.plan(MANY),
            ValueError,
            r"a plan takes at most 1,000 groups; got 1,001\. Put",
        ),
        (lambda: split_hosts(FIG3, 0), ValueError, r"parts must be .* at most 3; got 0"),
        (lambda: split_hosts(FIG3, 4), ValueError, r"parts must be .* at most 3; got 4"),
        *(
            (lambda width=width: PLAN_OF_FIG3.advice(width), ValueError, WIDTH)
            for width in (float("nan"), float("inf"), 0, -1, 70.5)
        ),
    ],
)
def test_wrong_arguments_are_named(
    call: Callable[[], object], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        call()
