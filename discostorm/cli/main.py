"""The command ``discostorm`` itself; packages add commands by entry points."""

from __future__ import annotations

import errno
import io
import logging
import os
import sys
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import click

import discostorm as ds
from discostorm import _names

#: Each command of the project: the extra that brings it ("" if the core does), and its help line,
#: which is shown without loading the command.
COMMANDS = {
    "breakdown": ("", "Show the airtime of each message type."),
    "capture": ("capture", "Diagnose a packet capture, and compare it with a model."),
    "claims": ("book", "List the paper's claims with their verdicts."),
    "figures": ("", "Write the paper's figures and their data."),
    "fleet": ("planner", "Write a fleet file from the output of ROS 2 commands."),
    "plan": ("planner", "Say whether a fleet's startup works, and what helps."),
    "robots": ("", "List the ready-made robots."),
    "saturation": ("", "Compute how many hosts fill the channel."),
    "simulate": ("simulation", "Simulate the startup of a fleet, frame by frame."),
    "utilization": ("", "Compute the airtime that discovery needs in one second."),
    "watch": ("capture", "Watch live discovery, with a diagnosis."),
}


@cache
def installed_commands() -> dict[str, EntryPoint]:
    """Return the entry point of each installed command, by its name."""
    return {point.name: point for point in sorted(entry_points(group="discostorm.commands"))}


def _install_hint(name: str) -> str:
    return f"pip install 'discostorm[{COMMANDS[name][0]}]'"


class Commands(click.Group):
    """Commands that load when they run, and report an output that cannot be written."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        """Return the names of the commands; see `click.Group.list_commands`."""
        return list(installed_commands())

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:  # noqa: ARG002
        """Return the command of that name; see `click.Group.get_command`."""
        point = installed_commands().get(cmd_name)
        return None if point is None else point.load()

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command and its arguments; suggest a name for an unknown command."""
        name = args[0]
        if name in COMMANDS and name not in installed_commands():
            hint = _install_hint(name)
            raise click.UsageError(f"{name!r} is not installed; to get it: {hint}", ctx)
        try:
            _, command, rest = super().resolve_command(ctx, args)
        except click.UsageError as error:
            like = _names.did_you_mean(name, installed_commands())
            raise click.UsageError(f"No such command {name[:99]!r}{like}", ctx) from error
        if command is not None and not ctx.resilient_parsing:
            _refuse_repeated_options(click.Context(command, ctx, name), rest)
        return name, command, rest

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:  # noqa: ARG002
        """Write the help line of each command without loading the command."""
        with formatter.section("Commands"):
            named = ((name, COMMANDS.get(name, ("", ""))) for name in installed_commands())
            formatter.write_dl([(name, told) for name, (_, told) in named])
        if missing := [name for name in COMMANDS if name not in installed_commands()]:
            with formatter.section("Not installed"):
                formatter.write_dl([(name, _install_hint(name)) for name in missing])

    def main(self, *args: Any, **kwargs: Any) -> Any:
        """Run a command; see `click.Group.main`."""
        logging.getLogger("matplotlib").setLevel(logging.ERROR)  # hide warnings about its cache
        for stream in (sys.stdout, sys.stderr):
            # Escape characters that the terminal cannot show.
            if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
                stream.reconfigure(errors="backslashreplace")
        try:
            if sys.stdout is None:  # already closed: click would print nothing
                raise OSError(errno.EBADF, os.strerror(errno.EBADF))
            return super().main(*args, **kwargs)
        except OSError as error:  # click itself answers a closed pipe
            click.echo(f"Error: the output could not be written: {error.strerror}", err=True)
            sys.stdout = None  # so that Python does not flush it again at exit
            sys.exit(1)


def _refuse_repeated_options(ctx: click.Context, args: list[str]) -> None:
    """Raise a UsageError for a repeated option with one value, which click would ignore."""
    parser = ctx.command.make_parser(ctx)
    ctx.resilient_parsing = True  # other errors are answered where the command runs
    _, _, given = parser.parse_args(list(args))
    ctx.resilient_parsing = False
    for option in given:
        once = isinstance(option, click.Option) and not (option.multiple or option.is_flag)
        if once and (count := given.count(option)) > 1:
            hint = ", with all values separated by commas"
            raise click.UsageError(
                f"{option.opts[0]} is given {count} times; give it once"
                f"{hint if ',' in str(option.metavar) else ''}",
                ctx,
            )


@click.group(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 success, 1 interrupted or output not written, 2 invalid usage or input.",
)
@click.version_option(ds.__version__, message="%(prog)s %(version)s")
def main() -> None:
    """Compute the Wi-Fi airtime that ROS 2 discovery needs, and show what reduces it.

    Utilization is airtime per second. At 1, or 100%, the channel carries nothing else. At 2,
    discovery needs two seconds of airtime in one second, so it does not fit.

    \b
    Examples:
      discostorm plan --robot turtlebot4 --hosts 12
      discostorm utilization --hosts 7 --processes 2 --endpoints 10 --protocol all
      discostorm plan fleet.toml

    Is something wrong already? Start with your symptom: see the book's page "What is wrong with my
    robots?" (book/what_is_wrong).
    """
