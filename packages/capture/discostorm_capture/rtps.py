"""RTPS: every submessage of every datagram, told apart by its entities."""

import re
from collections import Counter
from functools import cache

import numpy as np

from discostorm.data import read_data
from discostorm_capture._bytes import (
    PAD as ZEROS,
    Array,
    Bytes,
    Columns,
    Numbers,
    Places,
    codes,
    number,
    take,
)

#: The first four bytes of a message; the second is of Connext.
_MAGIC = (0x52545053, 0x52545058)
_OVER_TCP = 0x52544350
_HEADER = 20
#: SPDP's port for multicast in domain 0, and how far those of two domains are apart.
_PORT, _PORTS = 7400, 250
PAD, INFO_TS, INFO_SRC, INFO_DST, DATA = 0x01, 0x09, 0x0C, 0x0E, 0x15
#: Parameters: where unicast discovery goes to, GUIDs, properties, the end.
_UNICAST, _PARTICIPANT_GUID, _ENDPOINT_GUID, _KEY_HASH, _SENTINEL = 0x32, 0x50, 0x5A, 0x70, 1
_PROPERTIES = 0x59
#: Added to a parameter: the first one of several, not the last.
_FIRST = 0x10000
#: How a participant of Fast DDS says in its properties that it is a Discovery Server
#: (parameter_property_participant_type; two strings of CDR).
_SERVER = re.compile(rb"PARTICIPANT_TYPE\0{4}.{4}(SERVER|BACKUP)\0", re.DOTALL)
#: The GUID prefix of servers with a number, the third byte (eProsima/Fast-DDS 2.9.1,
#: include/fastdds/rtps/attributes/ServerAttributes.h, DEFAULT_ROS2_SERVER_GUIDPREFIX).
_SERVER_PREFIX = re.compile(rb"DS._EPROSIMA", re.DOTALL)
#: The kind of a locator of UDP over IPv4.
_UDP_4 = 1
#: What DDS Security puts before a submessage or a message that it signs or encrypts, and what is
#: encrypted (DDS Security 1.1, 9.5.2.1): the kinds of transformation, and the key that both ends
#: derive from their handshake, by which they then tell each other all other keys.
_PREFIXES, _BODY, _SIGNED, _ENCRYPTED, _SHARED_KEY = (0x31, 0x33), 0x30, (1, 3), (2, 4), 0
#: The encrypted length of an INFO_DST, the longest of what is no message of its own.
_INFO = 20
_TELLS_KEYS = 0xFF0202C3
_MOST_PARAMETERS = 512

SUBMESSAGES = {
    int(row["id"], 16): row
    for row in read_data("vendors/rtps_submessages.csv", "discostorm_capture")
}
ENTITIES = {
    int(row["id"], 16): row for row in read_data("vendors/rtps_entities.csv", "discostorm_capture")
}
VENDORS = {
    int(row["id"], 16): row["name"]
    for row in read_data("vendors/rtps_vendors.csv", "discostorm_capture")
}


def _places(column: str) -> Array:
    """Return, by the id of a submessage, where something stands in it; 0 if nowhere."""
    places = np.zeros(256, np.int64)
    for kind, row in SUBMESSAGES.items():
        places[kind] = int(row[column] or 0)
    return places


_READER_AT, _WRITER_AT = _places("reader_at"), _places("writer_at")
#: Where the lower half of a sequence number stands: of a sample, the last one of a Heartbeat, the
#: first one that an ACKNACK lacks; and how many bits follow it there.
_NUMBER_AT = _places("number_at")
_HAS_NUMBER = _NUMBER_AT > 0
_BITS, _MOST_BITS, ACKNACK = 4, 256, 0x06
#: What is a message of its own; the others say how to read what follows them, or fill up.
_IS_MESSAGE = np.array([bool(SUBMESSAGES.get(kind, {}).get("message")) for kind in range(256)])
#: What those without a known entity are called, by the upper two bits of its last byte.
_OTHER = ("User", "Vendor", "Vendor", "Builtin")
_UNKNOWN = "Unknown"
GROUPS = tuple(dict.fromkeys([row["group"] for row in ENTITIES.values()] + [*_OTHER, _UNKNOWN]))
ENTITY_NAMES = (*dict.fromkeys(row["what"] for row in ENTITIES.values()), "user", "other")


@cache
def kind_names() -> tuple[str, ...]:
    """Return what messages are called, by 256 times the number of the group and submessage."""
    names = []
    for group in GROUPS:
        for kind in range(256):
            row = SUBMESSAGES.get(kind, {})
            suffix = row.get("message") or f"0x{kind:02x}"
            if suffix == "Encrypted":
                names.append(suffix + " key exchange" * (group == "Key exchange"))
            elif suffix == "data":
                names.append("User data" if group == "User" else group)
            else:
                names.append(suffix if group == "SEDP" else f"{group} {suffix}")
    return tuple(names)


def submessage_names() -> list[str]:
    """Return the names of the submessages, by their ids."""
    return [SUBMESSAGES.get(kind, {}).get("name", f"0x{kind:02x}") for kind in range(256)]


def starts(data: Bytes, at: Places) -> Array:
    """Return which datagrams are RTPS messages."""
    found: Array = np.isin(number(data, at, ">u4"), _MAGIC)
    return found


def over_tcp(data: Bytes, at: Places) -> Array:
    """Return which TCP segments start with a message, in Fast DDS behind a header of its own."""
    found: Array = np.isin(number(data, at, ">u4"), (_OVER_TCP, *_MAGIC))
    return found


def domains(process: Array, kind: Array, to_port: Array) -> set[tuple[int, int]]:
    """Return whose messages by multicast are for which domain: SPDP's ports tell (9.6.1)."""
    spdp = kind >> 8 == GROUPS.index("SPDP")
    process, (domain, rest) = process[spdp], np.divmod(to_port[spdp] - _PORT, _PORTS)
    known = (rest == 0) & (domain >= 0)
    process, domain = process[known], domain[known]
    _, first = codes(process, domain)
    return set(zip(process[first].tolist(), domain[first].tolist(), strict=True))


def messages(
    data: Bytes, found: Columns, processes: Numbers, notes: Counter[str]
) -> tuple[Columns, Columns]:
    """Return the messages in RTPS datagrams, and what those of SPDP and SEDP announce.

    Parameters
    ----------
    data : numpy.ndarray
        Where the datagrams are.
    found : dict
        As `ip.datagrams` returns it, of those that `starts` chose.
    processes : Numbers
        The numbers of GUID prefixes; those found are added.
    notes : Counter
        What could not be read is counted here.

    Returns
    -------
    tuple
        The messages: ``datagram``, its row in `found`; ``kind``, see `kind_names`; the
        ``submessage``, its ``size``, ``reader`` and ``writer``; its ``number``, and how many are
        ``missing``, see `Capture.messages`; ``bytes``, its own and those
        around it; ``process`` and ``peer``; ``entity`` and ``ends``. The announcements: see
        `_announced`.
    """
    good = (data[found["at"] + 4] == 2) & (found["size"] >= _HEADER)
    if count := int(np.count_nonzero(~good)):
        notes["RTPS messages that are cut, or not of version 2"] += count
    rows = np.flatnonzero(good)
    found = take(found, good)
    at = found["at"]
    wire_end = at + found["wire"]
    which, place, after = _walk(data, at + _HEADER, at + found["size"], wire_end)
    after = np.minimum(after, wire_end[which])
    kind = data[place]
    source, target = _prefixes(data, at, which, place, kind)
    no_message, keys = _secured(data, place, kind)
    chosen = np.flatnonzero(_IS_MESSAGE[kind] & ~no_message)
    keys = keys[chosen]
    which, place, after, kind = which[chosen], place[chosen], after[chosen], kind[chosen]
    source, target = source[chosen], target[chosen]
    # The bytes of a datagram are those of its messages: each has what stands before it, too.
    new = np.diff(which, prepend=-1) != 0
    begin = np.where(new, at[which], np.roll(after, 1))
    stop = np.where(np.roll(new, -1), wire_end[which], after)
    little = data[place + 1] & 1 > 0
    length = number(data, place + 2, "<u2")
    last = (at + found["size"])[which]
    reader, writer = (
        # Of a message that was cut they may be missing.
        np.where((where[kind] > 0) & (place + where[kind] + 4 <= last), value, 0)
        for where in (_READER_AT, _WRITER_AT)
        for value in [number(data, np.minimum(place + where[kind], last), ">u4")]
    )
    writer = np.where(keys, np.uint32(_TELLS_KEYS), writer)
    group, entity = _groups(reader, writer)
    sequence = _sequence(data, place + _NUMBER_AT[kind], last, kind, little)
    found_messages = {
        "datagram": rows[which],
        "kind": group * 256 + kind,
        "submessage": kind,
        "size": np.where(little, length, length.byteswap()).astype(np.int32),
        "reader": reader,
        "writer": writer,
        "number": sequence,
        "missing": _missing(data, place, last, kind, little),
        "bytes": (stop - begin).astype(np.int32),
        "process": processes.of(data, source, 12),
        "peer": processes.of(data, target, 12),
        "entity": entity,
        # Only a key: it is disposed of or unregistered.
        "ends": (kind == DATA) & (data[place + 1] & 8 > 0),
    }
    announcing = np.isin(writer, ANNOUNCING) & (kind == DATA) & ~found_messages["ends"]
    stop = np.minimum(stop, last)
    announced = _announced(
        data,
        take(found_messages, announcing),
        place[announcing],
        stop[announcing],
        little[announcing],
    )
    return found_messages, announced


def _secured(data: Bytes, place: Places, kind: Array) -> tuple[Array, Array]:
    """Return which submessages are prefixes of no message, and of which encrypted keys follow.

    What is signed alone follows as it is; an INFO submessage is no message, encrypted or not.
    """
    prefix = np.isin(kind, _PREFIXES)
    how = data[np.where(prefix, place + 7, 0)]
    signed = prefix & np.isin(how, _SIGNED)
    after = np.roll(place, -1)
    length = number(data, after + 2, "<u2")
    length = np.where(data[after + 1] & 1, length, length.byteswap())
    hidden = prefix & np.isin(how, _ENCRYPTED) & (np.roll(kind, -1) == _BODY)
    key = number(data, np.where(prefix, place + 8, 0), ">u4")
    keys = hidden & (kind == _PREFIXES[0]) & (key == _SHARED_KEY)
    return signed | (hidden & (length <= _INFO)), keys


def _sequence(data: Bytes, at: Places, last: Places, kind: Array, little: Array) -> Array:
    """Return the lower half of the sequence number of each message, 0 if it has none."""
    # Behind the last message there is padding.
    value: Array = number(data, at, "<u4")
    if not little.all():
        value = np.where(little, value, value.byteswap())
    value &= 0x7FFFFFFF
    value[(at + 4 > last) | ~_HAS_NUMBER[kind]] = 0
    return value.view(np.int32)


def _missing(data: Bytes, place: Places, last: Places, kind: Array, little: Array) -> Array:
    """Return how many samples each ACKNACK says that it lacks."""
    missing = np.zeros(len(kind), np.int16)
    rows = np.flatnonzero(kind == ACKNACK)
    rows = rows[place[rows] + _NUMBER_AT[ACKNACK] + _BITS + 4 <= last[rows]]
    at = place[rows] + _NUMBER_AT[ACKNACK] + _BITS
    bits = _number(data, at, "u4", little[rows])
    asking = np.flatnonzero((bits > 0) & (bits <= _MOST_BITS))
    rows, at, bits = rows[asking], at[asking], bits[asking].astype(np.int64)
    for word in range(_MOST_BITS // 32):
        here = np.flatnonzero((bits > 32 * word) & (at + 8 + 4 * word <= last[rows]))
        if not len(here):
            break
        value = _number(data, at[here] + 4 + 4 * word, "u4", little[rows[here]])
        kept = np.minimum(bits[here] - 32 * word, 32)
        value = value.astype(np.uint64) >> (32 - kept).astype(np.uint64)
        missing[rows[here]] += np.bitwise_count(value).astype(np.int16)
    return missing


def _walk(data: Bytes, at: Places, end: Places, wire_end: Places) -> tuple[Array, Places, Places]:
    """Return all submessages: which datagram each is in, where it starts and ends."""
    which = np.arange(len(at))
    steps: list[tuple[Array, Places, Places]] = [(which[:0], at[:0], at[:0])]
    while len(at):
        inside = at + 4 <= end
        if not inside.all():
            which, at, end, wire_end = which[inside], at[inside], end[inside], wire_end[inside]
        kind = data[at]
        length = number(data, at + 2, "<u2")
        length = np.where(data[at + 1] & 1, length, length.byteswap()).astype(np.int64)
        # Of the last one the length may be left out.
        rest = (length == 0) & (kind != PAD) & (kind != INFO_TS)
        after = np.where(rest, wire_end, at + 4 + length)
        steps.append((which, at, after))
        at = after
    which, at, after = (np.concatenate(parts) for parts in zip(*steps, strict=True))
    order = np.argsort(which, kind="stable")
    return which[order], at[order], after[order]


def _prefixes(
    data: Bytes, at: Places, which: Array, place: Places, kind: Array
) -> tuple[Places, Places]:
    """Return where the GUID prefixes of sender and receiver of each submessage stand."""
    index = np.arange(len(which))
    first = np.searchsorted(which, which)
    source = at[which] + 8
    target = np.full(len(which), len(data) - ZEROS)  # zeros: everybody
    for found, at_prefix in ((INFO_SRC, 12), (INFO_DST, 4)):
        told = np.maximum.accumulate(np.where(kind == found, index, -1)) if len(index) else index
        valid = (told >= first) & (place[told] + at_prefix + 12 <= len(data))
        prefix = place[told] + at_prefix
        if found == INFO_SRC:
            source = np.where(valid, prefix, source)
        else:
            target = np.where(valid, prefix, target)
    return source, target


_KNOWN = np.array(sorted(ENTITIES), np.uint32)
_KNOWN_GROUP = np.array([GROUPS.index(ENTITIES[int(key)]["group"]) for key in _KNOWN])
_KNOWN_NAME = np.array([ENTITY_NAMES.index(ENTITIES[int(key)]["what"]) for key in _KNOWN])
_OTHER_GROUP = np.array([GROUPS.index(name) for name in _OTHER])
#: The writers of SPDP and SEDP, as they are and for signed messages.
ANNOUNCING = np.array(
    [key for key, row in ENTITIES.items() if row["group"] in ("SPDP", "SEDP")], np.uint32
)


def _groups(reader: Array, writer: Array) -> tuple[Array, Array]:
    """Return the group of each message, and what its entities are about."""
    # The writer tells; where it is not given, the reader.
    entity = np.where(writer == 0, reader, writer).astype(np.uint32)
    place = np.searchsorted(_KNOWN, entity).clip(0, len(_KNOWN) - 1)
    known = _KNOWN[place] == entity
    source = (entity & 0xC0) >> 6
    group = np.where(known, _KNOWN_GROUP[place], _OTHER_GROUP[source])
    group[entity == 0] = GROUPS.index(_UNKNOWN)
    other = np.where(
        (source == 0) & (entity != 0), ENTITY_NAMES.index("user"), ENTITY_NAMES.index("other")
    )
    return group, np.where(known, _KNOWN_NAME[place], other).astype(np.uint8)


def _announced(data: Bytes, found: Columns, place: Places, end: Places, little: Array) -> Columns:
    """Return what messages of SPDP and SEDP announce, each once.

    Of each ``guid``, the place of its sixteen bytes; ``spdp``, whether it is a participant;
    ``address``, the place of its last IPv4 address for unicast discovery, ``first_address``, that
    of its first, and ``properties``, that of
    its properties, and their ``size``, 0 if it says none; the
    ``sender``, a process, and its ``datagram``.
    """
    high = _number(data, place + 16, "u4", little)
    low = _number(data, place + 20, "u4", little)
    _, first = codes(found["process"], found["writer"], high, low)
    found = take(found, first)
    place, end, little = place[first], end[first], little[first]
    qos = _number(data, place + 6, "u2", little)
    at = place + 8 + qos.astype(np.int64)
    inline = data[place + 1] & 2 > 0
    in_qos, after = _parameters(data, at, np.where(inline, end, at), little, (_KEY_HASH,))
    at = np.where(inline, after, at)
    inside = at + 4 <= end
    encoding = np.where(inside, number(data, np.where(inside, at, 0), ">u2"), 0)
    inside &= (encoding == 2) | (encoding == 3)
    wanted = (_PARTICIPANT_GUID, _ENDPOINT_GUID, _UNICAST, _FIRST + _UNICAST, _PROPERTIES)
    told, _ = _parameters(data, at + 4, np.where(inside, end, at), encoding == 3, wanted)
    spdp = np.isin(found["writer"], [k for k, row in ENTITIES.items() if row["group"] == "SPDP"])
    guid = np.where(spdp, told[_PARTICIPANT_GUID], told[_ENDPOINT_GUID])
    guid = np.where(guid > 0, guid, in_qos[_KEY_HASH])
    locators = [
        np.where((at > 0) & (_number(data, at, "u4", encoding == 3) == _UDP_4), at + 20, 0)
        for at in (told[_UNICAST], told[_FIRST + _UNICAST])
    ]
    properties = told[_PROPERTIES]
    size = _number(data, np.maximum(properties - 2, 0), "u2", encoding == 3).astype(np.int64)
    return {
        "guid": guid,
        "spdp": spdp,
        "properties": properties,
        "size": np.where(spdp & (properties > 0), np.minimum(size, end - properties), 0),
        "address": locators[0],
        "first_address": locators[1],
        "sender": found["process"],
        "datagram": found["datagram"],
    }


def serves(data: Bytes, announced: Columns) -> Array:
    """Return which announcements are of a Discovery Server of Fast DDS."""
    columns = (announced[key].tolist() for key in ("guid", "properties", "size"))
    found = [
        bool(
            _SERVER_PREFIX.match(data[guid : guid + 12].tobytes())
            or (size and _SERVER.search(data[at : at + size].tobytes()))
        )
        for guid, at, size in zip(*columns, strict=True)
    ]
    return np.array(found, bool)


def _parameters(
    data: Bytes, at: Places, end: Places, little: Array, wanted: tuple[int, ...]
) -> tuple[dict[int, Places], Places]:
    """Return where the values of parameters of lists stand, 0 if nowhere, and the lists' ends."""
    found = {parameter: np.zeros(len(at), np.int64) for parameter in wanted}
    after = at.copy()
    which = np.arange(len(at))
    for _ in range(_MOST_PARAMETERS):
        inside = at + 4 <= end
        if not inside.all():
            which, at, end, little = which[inside], at[inside], end[inside], little[inside]
        if not len(at):
            break
        kind, length = (
            _number(data, at + place, "u2", little).astype(np.int64) for place in (0, 2)
        )
        for parameter, places in found.items():
            # All values that are wanted have 16 bytes or more.
            mine = (kind == parameter & 0xFFFF) & (length >= 16) & (at + 20 <= end)
            if parameter >= _FIRST:
                mine &= places[which] == 0
            places[which[mine]] = at[mine] + 4
        last = kind == _SENTINEL
        after[which] = at + 4 + np.where(last, 0, length)
        which, at, end, little = (
            which[~last],
            at[~last] + 4 + length[~last],
            end[~last],
            little[~last],
        )
    return found, after


def _number(data: Bytes, at: Places, dtype: str, little: Array) -> Array:
    return np.where(little, number(data, at, "<" + dtype), number(data, at, ">" + dtype))
