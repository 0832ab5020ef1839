"""The command ``discostorm`` itself, whose commands are one module each."""

from __future__ import annotations

import errno
import io
import os
import sys
from typing import Any

import click

import discostorm as ds
from discostorm.cli import (
    breakdown,
    capture,
    claims,
    figures,
    plan,
    saturation,
    simulate,
    utilization,
)


class Commands(click.Group):
    """Commands whose output may fail: a full disk is told, a closed pipe is not."""

    def main(self, *args: Any, **kwargs: Any) -> Any:
        """Run a command; see `click.Group.main`."""
        for stream in (sys.stdout, sys.stderr):
            # What the terminal cannot show is escaped.
            if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
                stream.reconfigure(errors="backslashreplace")
        try:
            if sys.stdout is None:  # closed before the start: click would write to nobody
                raise OSError(errno.EBADF, os.strerror(errno.EBADF))
            return super().main(*args, **kwargs)
        except OSError as error:  # click itself answers a closed pipe
            click.echo(f"Error: the output could not be written: {error.strerror}", err=True)
            sys.stdout = None  # or it would be tried again at the end
            sys.exit(1)


@click.group(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 it worked, 1 the output could not be written or was stopped, "
    "2 wrong usage or input.",
)
@click.version_option(ds.__version__, message="%(prog)s %(version)s")
def main() -> None:
    """How much Wi-Fi airtime the discovery of ROS 2 robots takes, and what helps.

    Utilization is airtime per second: at 1, or 100%, the channel does nothing else; at 2
    discovery asks for two seconds of airtime in one, and does not fit.

    \b
    Examples:
      discostorm utilization --hosts 7 --processes 2 --endpoints 10
      discostorm plan fleet.toml
    """


for _command in (
    breakdown.breakdown,
    capture.capture,
    claims.claims,
    figures.figures,
    plan.plan,
    saturation.saturation,
    simulate.simulate,
    utilization.utilization,
):
    main.add_command(_command)
