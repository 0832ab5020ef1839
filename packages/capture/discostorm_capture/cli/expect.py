"""The option ``--expect``: which hosts ought to be there."""

from __future__ import annotations

from pathlib import Path

import click

import discostorm as ds
from discostorm.cli.fleet_options import read_fleet
from discostorm.cli.output import bad_input
from discostorm_capture.diagnosis import expected_hosts


def count_hosts(fleet: ds.Fleet) -> int | None:
    """Return how many hosts a fleet has; None if that is no whole number."""
    hosts = float(fleet.hosts())
    return int(hosts) if hosts.is_integer() and hosts >= 1 else None


def _expected(
    _: click.Context, _parameter: click.Parameter, value: str | None
) -> int | tuple[str, ...] | None:
    """Return how many hosts, or which addresses, a number, a fleet file or a list names."""
    if value is None:
        return None
    if value.isdecimal():
        value_read: int | list[str] = int(value)
    elif value.endswith(".toml") or Path(value).is_file():
        with bad_input():
            return count_hosts(read_fleet(value))
    else:
        value_read = value.split(",")
    try:
        return expected_hosts(value_read)
    except ValueError as error:
        raise click.BadParameter(str(error).removeprefix("expected ")) from None


expect_option = click.option(
    "--expect",
    "expected",
    metavar="N|FILE|ADDRESS[,...]",
    callback=_expected,
    help="Hosts that ought to be there: their number, a fleet file, or their addresses. The "
    "missing ones are named first.",
)
