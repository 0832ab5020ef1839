"""Parse announced endpoints (topic, type, QoS) of SEDP and rmw_zenoh, and participants of SPDP."""

import re
import struct
import tomllib
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from discostorm.data import data_path
from discostorm_capture._types import Bytes

_QOS = tomllib.loads(data_path("vendors/qos.toml", "discostorm_capture").read_text("utf-8"))
#: Values of policies from the weakest to the strongest, by ROS 2's names: a writer must offer at
#: least what the reader requests.
RANKED_QOS: dict[str, list[str]] = _QOS["ranked"]
RELIABILITIES, DURABILITIES, LIVELINESSES, DESTINATION_ORDERS, ACCESS_SCOPES = RANKED_QOS.values()
#: Policies with a time that must not be longer at the writer than at the reader, and their field.
TIME_QOS: dict[str, str] = _QOS["times"]
#: What to change at either end, by the policy that is incompatible.
QOS_REMEDIES: dict[str, str] = _QOS["remedies"]
#: Kinds of ownership; data representations, by number (DDS-XTypes 1.3, 7.6.3.1.1).
OWNERSHIPS, DATA_REPRESENTATIONS = (tuple(_QOS[name]) for name in ("ownership", "representation"))
#: Values of the last byte of an entity id that mark a writer (DDSI-RTPS 2.5, 9.3.1.2).
_WRITER_KINDS = (0x02, 0x03)
_PID_SENTINEL, _INFINITE_SECONDS = 0x01, 0x7FFFFFFF
#: Parameter id of a participant's unicast locator, and the kind of an IPv4 locator (9.6.3).
_PID_METATRAFFIC_UNICAST_LOCATOR, _LOCATOR_KIND_UDPV4 = 0x32, 1
#: Parameter id of an endpoint's unicast locator, and the transport of each kind of locator; only
#: Fast DDS has TCP (eProsima/Fast-DDS 2.9.1, include/fastdds/rtps/common/Locator.h).
_PID_UNICAST_LOCATOR, _TRANSPORTS = 0x2F, {1: "UDP", 2: "UDP", 4: "TCP", 8: "TCP"}
#: The property of a Fast DDS Discovery Server (parameter_property_participant_type, in CDR); and
#: the GUID prefix of servers, whose third byte is the server's number (eProsima/Fast-DDS 2.9.1,
#: include/fastdds/rtps/attributes/ServerAttributes.h, DEFAULT_ROS2_SERVER_GUIDPREFIX).
_SERVER_PROPERTY = re.compile(rb"PARTICIPANT_TYPE\0{4}.{4}(SERVER|BACKUP)\0", re.DOTALL)
_PROPERTIES = {"is_server": _SERVER_PROPERTY, "static": re.compile(rb"eProsimaEDPStatic")}
_SERVER_GUID_PREFIX = re.compile(rb"DS._EPROSIMA", re.DOTALL)
#: How rmw_zenoh names an endpoint (docs/design.md; rmw_zenoh_cpp,
#: src/detail/liveliness_utils.cpp). Empty QoS fields mean the default.
ROS_TOKEN_PATTERN = re.compile(
    rb"@ros2_lv/(?P<domain>\d+)/(?P<session>\w+)/\w+/\w+/(?P<kind>MP|MS|SS|SC)/[^/]+/[^/]+/[^/]+/(?P<topic>[^/]+)"
    rb"/(?P<type>[^/]+)/(?P<hash>[^/]+)/(?P<reliability>\d*):(?P<durability>\d*):"
)
#: The hash of an endpoint's type definition, in its user data (rmw_fastrtps_cpp and
#: rmw_cyclonedds_cpp of ROS 2 Iron and later).
_TYPE_HASH = re.compile(rb"typehash=(\w+);")


@dataclass(frozen=True)
class Endpoint:
    """A writer or reader, as its process announced it last.

    Defaults are those of DDS 1.4, 2.2.3. Reliability has none here: writers and readers differ.
    """

    writer: bool
    topic: str
    type: str
    reliability: str
    durability: str = DURABILITIES[0]
    #: The longest time between two samples [s]. `lease`: time until a writer counts as not alive.
    deadline: float = float("inf")
    liveliness: str = LIVELINESSES[0]
    lease: float = float("inf")
    ownership: str = OWNERSHIPS[0]
    partitions: tuple[str, ...] = ("",)
    destination_order: str = DESTINATION_ORDERS[0]
    presentation: str = ACCESS_SCOPES[0]
    latency: float = 0.0
    #: For how long a writer keeps a sample [s].
    lifespan: float = float("inf")
    #: Data representations: a writer uses the first, a reader accepts each.
    representations: tuple[str, ...] = DATA_REPRESENTATIONS[:1]
    type_hash: str = ""
    #: "UDP" or "TCP" if it announces that it receives by this one only; shared memory aside.
    transport: str = ""


def parse_endpoint(data: Bytes, at: int, end: int, little: bool, entity: int) -> Endpoint | None:
    """Return the endpoint in a parameter list; None if the list is truncated or unreadable."""
    order = "<" if little else ">"
    is_writer = entity & 0x3F in _WRITER_KINDS
    values: dict[str, Any] = {"reliability": RELIABILITIES[is_writer]}
    transports = set[str]()
    try:
        for parameter, value in _iterate_parameters(data[at:end].tobytes(), order):
            if parameter in _ENDPOINT_PARAMETERS:
                values |= _ENDPOINT_PARAMETERS[parameter](value, order)
            elif parameter == _PID_UNICAST_LOCATOR:
                transports.add(_TRANSPORTS.get(_uint32(value, 0, order), ""))
        values["transport"] = " and ".join(sorted(transports - {""}))
        return Endpoint(writer=is_writer, **values)
    except (struct.error, LookupError, TypeError):
        return None


def parse_participant(
    data: Bytes, at: int, end: int, little: bool
) -> tuple[dict[str, Any], list[bytes]]:
    """Return fields of `Process` and IPv4 addresses from a parameter list, even a truncated one."""
    order, found, addresses = "<" if little else ">", dict[str, Any](), list[bytes]()
    with suppress(struct.error, IndexError):
        for parameter, value in _iterate_parameters(data[at:end].tobytes(), order):
            is_locator = parameter == _PID_METATRAFFIC_UNICAST_LOCATOR
            if parameter in _PARTICIPANT_PARAMETERS:
                found |= _PARTICIPANT_PARAMETERS[parameter](value, order)
            elif is_locator and _uint32(value, 0, order) == _LOCATOR_KIND_UDPV4:
                addresses += [value[20:24]] * (len(value) == 24)
    return found, addresses


def _iterate_parameters(octets: bytes, order: str) -> Iterator[tuple[int, bytes]]:
    """Yield the id and value of each parameter of a list, up to the sentinel."""
    position, parameter = 0, -1
    while parameter != _PID_SENTINEL:
        parameter, length = struct.unpack_from(order + "HH", octets, position)
        yield parameter, octets[position + 4 : position + 4 + length]
        position += 4 + length


def endpoint_of_ros_token(token: re.Match[bytes]) -> Endpoint:
    """Return the endpoint that a token of rmw_zenoh names."""
    text = {name: value.decode("utf-8", "replace") for name, value in token.groupdict().items()}
    domain = f" (domain {text['domain']})" if text["domain"] != "0" else ""
    topic = text["topic"].replace("%", "/")
    if text["kind"] in ("SS", "SC"):  # named as DDS names the requests of a service
        topic = f"rq{topic}Request"
    return Endpoint(
        writer=text["kind"] in ("MP", "SC"),
        topic=topic + domain,
        type=text["type"],
        # The numbers are those of ros2/rmw, types.h.
        reliability=RELIABILITIES[text["reliability"] != "2"],
        durability=DURABILITIES[text["durability"] == "1"],
        type_hash=text["hash"],
    )


def key_of_ros_token(token: re.Match[bytes]) -> bytes:
    """Return the key expression of the samples of a topic, given a token of rmw_zenoh."""
    topic = token["topic"].replace(b"%", b"/").strip(b"/")
    return b"/".join((token["domain"], topic, token["type"], token["hash"]))


def ros_topic(topic: str) -> str:
    """Return the ROS 2 name of a DDS topic."""
    prefix, _, name = topic.partition("/")
    if prefix == "rt":
        return f"/{name}"
    if prefix in ("rq", "rr"):
        return f"/{name.removesuffix('Request').removesuffix('Reply')} (service)"
    return topic


def ros_type(name: str) -> str:
    """Return the ROS 2 name of a DDS type."""
    return name.replace("::dds_::", "::").removesuffix("_").replace("::", "/")


def _uint32(value: bytes, at: int, order: str) -> int:
    (number,) = struct.unpack_from(order + "I", value, at)
    return int(number)


def _read_string(value: bytes, at: int, order: str) -> tuple[str, int]:
    """Return a CDR string, and the offset of the next one."""
    length = _uint32(value, at, order)
    text = value[at + 4 : at + 4 + length]
    if len(text) < length:
        raise IndexError(at)
    return text.rstrip(b"\0").decode("utf-8", "replace"), at + 4 + length + -length % 4


def _read_seconds(value: bytes, at: int, order: str) -> float:
    whole, fraction = (_uint32(value, at + n, order) for n in (0, 4))
    return float("inf") if whole >= _INFINITE_SECONDS else whole + fraction / 2**32


def _read_partitions(value: bytes, order: str) -> dict[str, Any]:
    names, at = [], 4
    for _ in range(min(_uint32(value, 0, order), len(value))):
        name, at = _read_string(value, at, order)
        names.append(name)
    return {"partitions": tuple(names) or ("",)}


def _read_representations(value: bytes, order: str) -> dict[str, Any]:
    count = min(_uint32(value, 0, order), len(value))
    numbers = struct.unpack_from(f"{order}{count}h", value, 4)
    return {"representations": tuple(DATA_REPRESENTATIONS[one] for one in numbers)} if count else {}


def _read_liveliness(value: bytes, order: str) -> dict[str, Any]:
    kind = LIVELINESSES[_uint32(value, 0, order)]
    return {"liveliness": kind, "lease": _read_seconds(value, 4, order)}


_RELIABILITY = dict(enumerate(RELIABILITIES, 1))
#: Readers of endpoint parameters, by parameter id (DDSI-RTPS 2.5, 9.6.3).
_ENDPOINT_PARAMETERS: dict[int, Callable[[bytes, str], dict[str, Any]]] = {
    0x05: lambda value, order: {"topic": _read_string(value, 0, order)[0]},
    0x07: lambda value, order: {"type": _read_string(value, 0, order)[0]},
    0x1A: lambda value, order: {"reliability": _RELIABILITY[_uint32(value, 0, order)]},
    0x1B: _read_liveliness,
    0x1D: lambda value, order: {"durability": DURABILITIES[_uint32(value, 0, order)]},
    0x1F: lambda value, order: {"ownership": OWNERSHIPS[_uint32(value, 0, order)]},
    0x23: lambda value, order: {"deadline": _read_seconds(value, 0, order)},
    0x21: lambda value, order: {"presentation": ACCESS_SCOPES[_uint32(value, 0, order)]},
    0x25: lambda value, order: {"destination_order": DESTINATION_ORDERS[_uint32(value, 0, order)]},
    0x27: lambda value, order: {"latency": _read_seconds(value, 0, order)},
    0x29: _read_partitions,
    0x2B: lambda value, order: {"lifespan": _read_seconds(value, 0, order)},
    0x73: _read_representations,
    0x2C: lambda value, _: {"type_hash": b"".join(_TYPE_HASH.findall(value)[:1]).decode()},
}
#: Readers of participant parameters; the last is the identity token (DDS Security 1.1, 7.4.1.3).
_PARTICIPANT_PARAMETERS: dict[int, Callable[[bytes, str], dict[str, Any]]] = {
    0x02: lambda value, order: {"lease": _read_seconds(value, 0, order)},
    0x4014: lambda value, order: {"domain_tag": _read_string(value, 0, order)[0]},
    0x50: lambda value, _: {"is_server": True} if _SERVER_GUID_PREFIX.match(value) else {},
    0x59: lambda value, _: {name: True for name, it in _PROPERTIES.items() if it.search(value)},
    # Bits of the built-in endpoints: does it announce its writers, as it does its readers?
    0x58: lambda value, order: {"is_half": _uint32(value, 0, order) & 0x14 in (0x04, 0x10)},
    0x1001: lambda *_: {"has_credentials": True},
}
