"""The command ``discostorm`` itself, whose commands are one module each."""

from __future__ import annotations

import errno
import io
import os
import sys
from importlib import import_module
from typing import Any

import click

import discostorm as ds

#: The commands, each in the module of its name, which is loaded when it is needed.
COMMANDS = {
    "breakdown": "What each message costs.",
    "capture": "What a capture holds, against the model.",
    "claims": "The paper's claims and their verdicts.",
    "figures": "Write the paper's figures and their data.",
    "plan": "Advice for a fleet: what would help most.",
    "saturation": "Hosts at which the channel is full.",
    "simulate": "The start of a fleet on the air, frame by frame.",
    "utilization": "Airtime of discovery in one second.",
}


class Commands(click.Group):
    """Commands whose output may fail: a full disk is told, a closed pipe is not."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        """Return the names of the commands; see `click.Group.list_commands`."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:  # noqa: ARG002
        """Return the command of that name; see `click.Group.get_command`."""
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = getattr(import_module(f"discostorm.cli.{cmd_name}"), cmd_name)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:  # noqa: ARG002
        """Write what each command does, without loading it."""
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))

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
