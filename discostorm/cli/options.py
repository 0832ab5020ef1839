"""Options that several commands have: the form of the answer, the channel, the protocol."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any, TypeVar

import click
from click.shell_completion import CompletionItem

import discostorm as ds
from discostorm import _checks, _names, words
from discostorm.cli.output import Output, bad_input
from discostorm.protocols import aliases, named, offered
from discostorm.wifi import Wifi
from discostorm.wifi.radio import radio_named

Command = TypeVar("Command", bound=Callable[..., Any])

#: What commands take unless told otherwise: what ROS 2 uses by default, as it was measured.
DEFAULT = "Fast DDS"

#: Words that stand for several protocols; `both` is what 0.2.0 called the paper's.
SEVERAL = {"all": offered(), "paper": (ds.DDS, ds.ZENOH), "both": (ds.DDS, ds.ZENOH)}

#: What an option replaces of a channel, and in which unit.
LINK_OPTIONS = {
    "unicast_rate": ("unicast", "rate", "Mbit/s"),
    "unicast_overhead": ("unicast", "overhead", "µs"),
    "multicast_rate": ("multicast", "rate", "Mbit/s"),
    "multicast_overhead": ("multicast", "overhead", "µs"),
}
#: Units in SI.
UNITS = {"Mbit/s": 1e6, "µs": 1e-6}


def completes(kind: str) -> Callable[..., list[CompletionItem]]:
    """Return what lets the shell complete the names of files (``file``) or folders (``dir``)."""
    return lambda _context, _parameter, begun: [CompletionItem(begun, type=kind)]


#: Of an option or argument that names a file, or a folder.
A_FILE: dict[str, Any] = {"metavar": "FILE", "shell_complete": completes("file")}


def numbers(_: click.Context, _parameter: click.Parameter, value: str | None) -> Any:
    """Return the numbers of a comma-separated list, a single one as a float."""
    if value is None:
        return None
    try:
        found = [float(part) for part in value.split(",")]
    except ValueError:
        raise click.BadParameter(
            f"must be a number, or several with commas between; got {_checks.brief(value)!r}"
        ) from None
    return found[0] if len(found) == 1 else found


def listing(
    names: Iterable[str],
) -> Callable[[click.Context, click.Parameter, str | None], str | None]:
    """Return what prints these names where ``list`` is given instead of one of them."""

    def callback(context: click.Context, _: click.Parameter, value: str | None) -> str | None:
        if value is not None and value.lower() == "list":
            click.echo("\n".join(names))
            context.exit()
        return value

    return callback


def packed(
    name: str, make: Callable[..., Any], *options: Callable[[Any], Any]
) -> Callable[[Command], Command]:
    """Return a decorator that adds options, of which a command gets one thing that is made."""

    def decorate(command: Command) -> Command:
        known: list[click.Parameter] = []

        @functools.wraps(command)
        def call(**given: Any) -> Any:
            own = {str(option.name): given.pop(str(option.name)) for option in known}
            with bad_input():
                made = make(**own)
            return command(**{name: made}, **given)

        for option in reversed(options):
            option(call)
            known.append(vars(call)["__click_params__"][-1])
        packed: Any = call
        return packed  # type: ignore[no-any-return]

    return decorate


def _one_format(context: click.Context, _: click.Parameter, value: bool) -> bool:
    if value and (context.params.get("as_json") or context.params.get("as_csv")):
        raise click.UsageError("--json and --csv exclude each other")
    return value


output_options = packed(
    "output",
    Output,
    click.option(
        "--json",
        "as_json",
        is_flag=True,
        callback=_one_format,
        help="Print JSON instead of a table.",
    ),
    click.option(
        "--csv", "as_csv", is_flag=True, callback=_one_format, help="Print CSV instead of a table."
    ),
)


def _wifi(channel: str, **given: float | None) -> Wifi:
    """Return the channel of a name, with other rates and overheads."""
    changes = {option: value for option, value in given.items() if value is not None}
    if channel.lower() == "paper":
        return _own_channel(changes) if changes else ds.PAPER
    try:
        radio = radio_named(channel)
    except ValueError as error:
        raise click.UsageError(
            f"--wifi must be 'paper' or a radio; '--wifi list' lists some: {error}"
        ) from None
    rate = changes.pop("multicast_rate", None)
    if changes:
        option = next(iter(changes)).replace("_", "-")
        raise click.UsageError(f"--{option} goes with --wifi paper alone; got --wifi {channel!r}")
    return (radio if rate is None else replace(radio, multicast_rate=rate * 1e6)).wifi()


def _own_channel(changes: Mapping[str, float]) -> Wifi:
    links = {"unicast": ds.PAPER.unicast, "multicast": ds.PAPER.multicast}
    for option, value in changes.items():
        cast, quantity, unit = LINK_OPTIONS[option]
        try:
            change: dict[str, Any] = {quantity: value * UNITS[unit]}
            links[cast] = replace(links[cast], **change)
        except ValueError as error:
            si = "bit/s" if quantity == "rate" else "s"
            must, _, _ = str(error).rpartition("; got ")
            raise ValueError(f"{cast} {must} {si}; got {value:g} {unit}") from error
    return Wifi("own channel", links["unicast"], links["multicast"])


def _radio(channel: str, **given: float | None) -> Wifi:
    """Return the channel of a name with its radio, with another multicast rate."""
    wifi = _wifi(channel, **given)
    if wifi.radio is None:
        raise click.UsageError(f"--multicast-rate goes with a radio here; got --wifi {channel!r}")
    return wifi


def _wifi_options(make: Callable[..., Wifi], *options: str) -> Callable[[Any], Any]:
    return packed(
        "wifi",
        make,
        click.option(
            "--wifi",
            "channel",
            default="paper",
            show_default=True,
            metavar="NAME",
            callback=listing(("paper", *ds.WIFI)),
            help="Channel: 'paper', or a radio such as '802.11ac 80 MHz' or "
            "'802.11n 20 MHz 2x2, A-MPDU 64'. 'list' shows more.",
        ),
        *(
            click.option(
                f"--{option.replace('_', '-')}",
                type=float,
                metavar=LINK_OPTIONS[option][2],
                help="Multicast rate; default: that of the channel."
                if option == "multicast_rate"
                else f"{option.replace('_', ' ').capitalize()}; default: that of the paper.",
            )
            for option in options
        ),
    )


wifi_options = _wifi_options(_wifi, *LINK_OPTIONS)
#: Of what needs more of a channel than rates and overheads.
radio_options = _wifi_options(_radio, "multicast_rate")


def _listed() -> list[str]:
    """Return the lines of ``--protocol list``: names, in brackets what else they are called."""
    lines = []
    for protocol in offered():
        others = [alias for alias, name in aliases().items() if name == protocol.name]
        lines.append(f"{protocol.name} ({', '.join(others)})" if others else protocol.name)
    return lines


def _several_listed() -> list[str]:
    told = {"all": "all of these", "paper": words.listed([one.name for one in SEVERAL["paper"]])}
    return [*_listed(), *(f"{name} ({what})" for name, what in told.items())]


def _one_protocol(value: str) -> ds.Protocol:
    try:
        return named(value)
    except ValueError:
        known = (*ds.PROTOCOLS, *aliases(), *SEVERAL)
        like = _names.did_you_mean(value, known)
        raise click.BadParameter(
            f"{_checks.brief(value)!r} is no product or table{like or '.'} "
            f"'list' lists all, such as {DEFAULT!r}, 'Cyclone DDS' or 'rmw_zenoh_cpp'."
        ) from None


def _protocols(
    context: click.Context, _: click.Parameter, values: tuple[str, ...]
) -> tuple[ds.Protocol, ...]:
    """Return the protocols that are named, each once, in the order of the calculator."""
    chosen: list[ds.Protocol] = []
    for value in values:
        if value.lower() == "list":
            click.echo("\n".join(_several_listed()))
            context.exit()
        chosen += SEVERAL.get(_names.key(value)) or (_one_protocol(value),)
    return tuple(protocol for protocol in offered() if protocol in chosen)


def _protocol_name(context: click.Context, _: click.Parameter, value: str | None) -> str | None:
    """Return the name of the protocol that is meant."""
    if value is None:
        return None
    if value.lower() == "list":
        click.echo("\n".join(_listed()))
        context.exit()
    return _one_protocol(value).name


def protocol_option_of(flag: str, default: str | None, told: str) -> Callable[[Any], Any]:
    """Return an option that takes the name of a protocol."""
    return click.option(
        flag,
        metavar="NAME",
        default=default,
        show_default=True,
        callback=_protocol_name,
        help=f"{told}, such as fastdds or rmw_cyclonedds_cpp; 'list' lists the names.",
    )


protocol_option = click.option(
    "--protocol",
    "protocols",
    metavar="NAME",
    multiple=True,
    default=(DEFAULT,),
    show_default=True,
    callback=_protocols,
    help="Middleware, such as fastdds or rmw_zenoh_cpp. Repeat the option to compare several. "
    "'all' compares all, 'paper' the paper's DDS and Zenoh; 'list' lists the names.",
)
