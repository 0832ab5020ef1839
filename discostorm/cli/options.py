"""Options that several commands have: the format of the answer, the channel, the protocol."""

import functools
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import replace
from typing import Any, TypeVar

import click
from click.core import ParameterSource
from click.shell_completion import CompletionItem

import discostorm as ds
from discostorm import _checks, _names, wording
from discostorm._numeric import int_if_integral
from discostorm.cells import Cell
from discostorm.cli.output import Output, bad_input
from discostorm.lookup import as_protocol, as_wifi
from discostorm.protocols import aliases, protocols_in_order
from discostorm.ros_releases import distribution_name, distributions, nearest_release_note
from discostorm.wifi import Wifi

Command = TypeVar("Command", bound=Callable[..., Any])

#: Default of --protocol: the default middleware of ROS 2, with its measured traffic.
DEFAULT = "Fast DDS"
#: Key of the ROS 2 distribution in the metadata of click's context.
_ROS_KEY = "discostorm.ros"
#: Key of whether the fleet of a command has cells.
_CELLS_KEY = "discostorm.cells"
#: Words that stand for several protocols.
PROTOCOL_SETS = {"all": protocols_in_order(), "paper": (ds.DDS, ds.ZENOH)}
#: Options that change a link: the link, the quantity, the unit, and that unit in SI.
LINK_OPTIONS = {
    "unicast_rate": ("unicast", "rate", "Mbit/s", 1e6),
    "unicast_overhead": ("unicast", "overhead", "µs", 1e-6),
    "multicast_rate": ("multicast", "rate", "Mbit/s", 1e6),
    "multicast_overhead": ("multicast", "overhead", "µs", 1e-6),
}
#: Allowed rates [bit/s] and overheads [s].
_ALLOWED = {"rate": (_checks.MIN_RATE, _checks.MAX_RATE), "overhead": (0.0, _checks.MAX_SECONDS)}


def path_completion(kind: str) -> Callable[..., list[CompletionItem]]:
    """Let the shell complete the names of files (``file``) or folders (``dir``)."""
    return lambda _context, _parameter, incomplete: [CompletionItem(incomplete, type=kind)]


#: Arguments of an option that names a file.
FILE_ARGS: dict[str, Any] = {"metavar": "FILE", "shell_complete": path_completion("file")}


def option_group(
    name: str, make: Callable[..., Any], *options: Callable[[Any], Any]
) -> Callable[[Command], Command]:
    """Return a decorator that adds options and passes their values to the command as one object."""

    def decorate(command: Command) -> Command:
        @functools.wraps(command)
        def call(**values: Any) -> Any:
            own = {key: values.pop(key) for key in keys if key in values}
            with bad_input():
                made = make(**own)
            return command(**{name: made}, **values)

        for option in reversed(options):
            option(call)
        added = vars(call)["__click_params__"][-len(options) :]
        keys = [str(option.name) for option in reversed(added)]
        decorated: Any = call
        return decorated  # type: ignore[no-any-return]

    return decorate


def parse_number_list(_: click.Context, _parameter: click.Parameter, value: str | None) -> Any:
    """Return the numbers of a comma-separated list, a single number as a float."""
    if value is None:
        return None
    try:
        parts = [float(part) for part in value.split(",")]
    except ValueError:
        raise click.BadParameter(
            f"must be one or more comma-separated numbers; got {_checks.shorten_name(value)!r}"
        ) from None
    return parts[0] if len(parts) == 1 else parts


def _print_names_on_request(context: click.Context, value: str, names: Iterable[str]) -> str:
    """Print names and exit if ``list`` is given instead of a name."""
    if value.lower() == "list":
        click.echo("\n".join(names))
        context.exit()
    return value


output_options = option_group(
    "output",
    Output,
    click.option("--json", "as_json", is_flag=True, help="Print JSON instead of a table."),
    click.option("--csv", "as_csv", is_flag=True, help="Print CSV instead of a table."),
)


def _parse_wifi(channel: str, **given: float | None) -> Wifi:
    changes = {option: value for option, value in given.items() if value is not None}
    links: dict[str, Any] = {"unicast": ds.PAPER.unicast, "multicast": ds.PAPER.multicast}
    for option, value in changes.items():
        cast, quantity, unit, in_si = LINK_OPTIONS[option]
        low, high = (end / in_si for end in _ALLOWED[quantity])
        _checks.number(f"--{option.replace('_', '-')} in {unit}", int_if_integral(value), low, high)
        links[cast] = replace(links[cast], **{quantity: value * in_si})
    context = click.get_current_context()
    default = context.get_parameter_source("channel") is ParameterSource.DEFAULT
    if context.meta.get(_CELLS_KEY) and (changes or not default):
        raise click.UsageError("--wifi cannot be combined with [[cells]]: each cell names its own")
    try:
        wifi = as_wifi(channel)
    except ValueError as error:
        raise click.UsageError(
            f"--wifi: {error.__cause__}. '--wifi list' lists channels and radios"
        ) from None
    if wifi is ds.PAPER:
        return Wifi("own channel", **links) if changes else wifi
    rate = changes.pop("multicast_rate", None)
    for option in changes:
        flag = option.replace("_", "-")
        raise click.UsageError(f"--{flag} works only with --wifi paper; got --wifi {channel!r}")
    radio: Any = wifi.radio
    try:
        return wifi if rate is None else replace(radio, multicast_rate=rate * 1e6).wifi()
    except ValueError as error:
        raise ValueError(str(error).replace("multicast_rate", "--multicast-rate")) from error


def _parse_radio(channel: str, **given: float | None) -> Wifi:
    wifi = _parse_wifi(channel, **given)
    if wifi.radio is None:
        raise click.UsageError(f"--multicast-rate needs a radio here; got --wifi {channel!r}")
    return wifi


def _wifi_options(make: Callable[..., Wifi], *link_options: str) -> Callable[[Any], Any]:
    names = ("paper", *ds.WIFI)
    channel = click.option(
        "--wifi",
        "channel",
        default="paper",
        show_default=True,
        metavar="NAME",
        callback=lambda context, _, value: _print_names_on_request(context, value, names),
        help="Channel: 'paper', or a radio such as '802.11ac 80 MHz' or "
        "'802.11n 20 MHz 2x2, A-MPDU 64'. 'list' shows more.",
    )
    links = []
    for option in link_options:
        origin = "channel" if option == "multicast_rate" else "paper"
        told = f"{option.replace('_', ' ').capitalize()}; default: the {origin}'s."
        unit, flag = LINK_OPTIONS[option][2], f"--{option.replace('_', '-')}"
        links.append(click.option(flag, type=float, metavar=unit, help=told))
    return option_group("wifi", make, channel, *links)


wifi_options = _wifi_options(_parse_wifi, *LINK_OPTIONS)
#: For commands that need a radio; rates and overheads alone are not enough.
radio_options = _wifi_options(_parse_radio, "multicast_rate")


def _protocol_lines() -> list[str]:
    """Return the names of protocols, with their aliases in brackets."""
    lines = []
    for protocol in protocols_in_order():
        others = [alias for alias, name in aliases().items() if name == protocol.name]
        lines.append(f"{protocol.name} ({', '.join(others)})" if others else protocol.name)
    return lines


def _keep_distribution(context: click.Context, _: click.Parameter, value: str | None) -> None:
    """Keep the ROS 2 distribution for the options that name a protocol."""
    if value is not None:
        try:
            name = _print_names_on_request(context, value, (*distributions(), "all"))
            every = _names.normalize(name) == "all"
            prefer_distribution("all" if every else distribution_name(name))
        except ValueError as error:
            raise click.BadParameter(str(error)) from None


def prefer_distribution(ros: str | None) -> None:
    """Use a ROS 2 distribution for a command's protocols, unless an option names another."""
    if ros is not None:
        click.get_current_context().meta.setdefault(_ROS_KEY, ros)


def chosen_distribution() -> str | None:
    """Return the ROS 2 distribution of a command; None if no option or file names a single one."""
    ros = click.get_current_context().meta.get(_ROS_KEY)
    return None if ros == "all" else ros


def refuse_wifi_with_cells(cells: tuple[Cell, ...]) -> None:
    """Let this command refuse ``--wifi`` if the fleet has cells, which name their own."""
    click.get_current_context().meta[_CELLS_KEY] = bool(cells)


def _name_nearest_release(protocol: ds.Protocol, ros: str) -> None:
    """Print once which release we use if the distribution's own release was not measured."""
    meta = click.get_current_context().meta
    if (note := nearest_release_note(protocol.name, ros)) and note not in meta:
        meta[note] = True
        click.echo(f"Note: {note}", err=True)


def _parse_protocol(value: str, flag: str) -> ds.Protocol:
    try:
        as_protocol(value)
    except ValueError:
        like = _names.did_you_mean(value, (*ds.PROTOCOLS, *aliases(), *PROTOCOL_SETS))
        raise click.BadParameter(
            f"{_checks.shorten_name(value)!r} is not a known name{like or '.'} 'list' lists "
            f"all, such as {DEFAULT!r}, 'Cyclone DDS' or 'rmw_zenoh_cpp'.",
            param_hint=repr(flag),
        ) from None
    try:
        ros = click.get_current_context().meta.get(_ROS_KEY)
        if ros == "all":
            raise ValueError("--ros all needs a command that compares protocols, such as plan")
        protocol = as_protocol(value, ros)
    except ValueError as error:
        raise click.BadParameter(str(error), param_hint=repr(flag)) from None
    _name_nearest_release(protocol, ros or "")
    return protocol


def _list_protocols(
    context: click.Context, _: click.Parameter, values: tuple[str, ...]
) -> tuple[str, ...]:
    papers = wording.join_words([protocol.name for protocol in PROTOCOL_SETS["paper"]])
    names = [*_protocol_lines(), "all (all of these)", f"paper ({papers})"]
    for value in values:
        _print_names_on_request(context, value, names)
    return values


def _parse_protocols(protocols: tuple[str, ...]) -> tuple[ds.Protocol, ...]:
    """Return the protocols that are named, each once, in the order of the calculator."""
    chosen: list[ds.Protocol] = []
    for value in protocols:
        if (several := PROTOCOL_SETS.get(_names.normalize(value))) is None:
            every, found = click.get_current_context().meta.get(_ROS_KEY) == "all", []
            for ros in distributions() if every else ():
                with suppress(ValueError):  # not every distribution ships each product
                    found.append(as_protocol(value, ros))
            several = tuple(found) or (_parse_protocol(value, "--protocol"),)
        chosen += several
    order = [protocol.key for protocol in protocols_in_order()]
    chosen.sort(key=lambda protocol: order.index(protocol.key))
    return tuple({protocol.name: protocol for protocol in chosen}.values())


def _parse_protocol_key(
    context: click.Context, parameter: click.Parameter, value: str | None
) -> str | None:
    if value is None:
        return None
    name = _print_names_on_request(context, value, _protocol_lines())
    return _parse_protocol(name, parameter.opts[0]).key


_ros_option = click.option(
    "--ros",
    metavar="NAME",
    is_eager=True,
    expose_value=False,
    callback=_keep_distribution,
    help="ROS 2 distribution, such as jazzy: use the middleware release that it ships. 'all' "
    "compares all distributions; 'list' lists the names.",
)


def protocol_option_of(flag: str, default: str | None, subject: str) -> Callable[[Any], Any]:
    """Return options that take the name of a protocol, and of a ROS 2 distribution."""
    option = click.option(
        flag,
        metavar="NAME",
        default=default,
        show_default=True,
        callback=_parse_protocol_key,
        help=f"{subject}, such as fastdds or rmw_cyclonedds_cpp; 'list' lists the names.",
    )
    return lambda command: option(_ros_option(command))


#: The middleware, and the ROS 2 distribution that ships it. Options of the fleet stand above them,
#: as a fleet file may name the distribution.
protocol_option = option_group(
    "protocols",
    _parse_protocols,
    click.option(
        "--protocol",
        "protocols",
        metavar="NAME",
        multiple=True,
        default=(DEFAULT,),
        show_default=True,
        callback=_list_protocols,
        help="Middleware, such as fastdds or rmw_zenoh_cpp. Repeat the option to compare several. "
        "'all' compares all, 'paper' the paper's DDS and Zenoh; 'list' lists the names.",
    ),
    _ros_option,
)
