"""Dissect RTPS: submessages by the entities they concern, and announcements of participants.

Clauses are those of DDSI-RTPS 2.5 unless another document is named.
"""

from collections import defaultdict
from functools import cache
from typing import Any, Literal

import numpy as np

from discostorm.data import read_data
from discostorm_capture import endpoints as sedp, ip
from discostorm_capture._arrays import IdTable, factorize, numbers_at, take_rows
from discostorm_capture._types import PADDING, Array, Bytes, Columns, Notes, Offsets
from discostorm_capture.dissection import RTPS, Dissection, Process, first_seen, message_table

#: The first four bytes of a message ("RTPS", "RTPX" of Connext), and of Fast DDS's TCP header.
_MAGIC, _MAGIC_TCP = (0x52545053, 0x52545058), 0x52544350
_HEADER_BYTES = 20
PAD, INFO_TS, INFO_SRC, INFO_DST = 0x01, 0x09, 0x0C, 0x0E
ACKNACK, HEARTBEAT, DATA = 0x06, 0x07, 0x15
#: The multicast port of SPDP is PB + DG * domain (9.6.1.1).
PORT_BASE, DOMAIN_GAIN = 7400, 250
#: Parameter ids (9.6.3).
PID_SENTINEL, PID_PARTICIPANT_GUID, PID_ENDPOINT_GUID, PID_KEY_HASH = 0x01, 0x50, 0x5A, 0x70
_MAX_PARAMETERS = 512
#: Encodings of parameter lists (10.2).
PL_CDR_BE, PL_CDR_LE = 2, 3
#: Submessages of DDS Security: the encrypted body, and the prefixes of a submessage and a message.
SEC_BODY, SEC_PREFIX, SRTPS_PREFIX = 0x30, 0x31, 0x33
#: Transformation kinds that sign and that encrypt; the id of the key that two participants derive
#: from their handshake, and by which they exchange all other keys (DDS Security 1.1, 9.5.2.1).
_SIGNING, _ENCRYPTING, _HANDSHAKE_KEY_ID = (1, 3), (2, 4), 0
PARTICIPANT_VOLATILE_SECURE_WRITER = 0xFF0202C3
#: The GUID prefix by which an INFO_DST addresses all participants: zeros.
_ALL_PARTICIPANTS = bytes(12)
#: The bits of an entity id that mark built-in entities and those of a vendor.
_BUILTIN_OR_VENDOR = 0xC0
#: The encrypted length of an INFO_DST, the longest submessage that is not counted as a message [B].
_MAX_ENCRYPTED_INFO_BYTES = 20

SUBMESSAGES, ENTITIES, VENDORS = (
    {int(row["id"], 16): row for row in read_data(f"vendors/rtps_{name}.csv", "discostorm_capture")}
    for name in ("submessages", "entities", "vendors")
)
_SUBMESSAGES_BY_ID = [SUBMESSAGES.get(kind, {}) for kind in range(256)]
#: The offsets of fields in each kind of submessage, 0 if it lacks the field: entity ids, and the
#: lower half of a sequence number: of the sample, the last one of a Heartbeat, or the first one
#: that an ACKNACK misses; there the number of bits of its bitmap and the bitmap follow.
_READER_OFFSETS, _WRITER_OFFSETS, _SEQUENCE_NUMBER_OFFSETS = (
    np.array([int(row.get(column) or 0) for row in _SUBMESSAGES_BY_ID])
    for column in ("reader_at", "writer_at", "number_at")
)
_MAX_NACKS = 256
#: Submessages that count as messages; the others describe the following ones, or are padding.
_IS_MESSAGE = np.array([bool(row.get("message")) for row in _SUBMESSAGES_BY_ID])
#: Groups of entities outside the data file, by the upper two bits of their id's last byte.
_GROUPS_BY_BITS = ("User", "Vendor", "Vendor", "Builtin")
_GROUPS_OF_ENTITIES = [row["group"] for row in ENTITIES.values()]
ENTITY_GROUPS = tuple(dict.fromkeys([*_GROUPS_OF_ENTITIES, *_GROUPS_BY_BITS, "Unknown"]))
SUBMESSAGE_NAMES = [row.get("name", f"0x{id_:02x}") for id_, row in enumerate(_SUBMESSAGES_BY_ID)]
ENTITY_NAMES = (*dict.fromkeys(row["what"] for row in ENTITIES.values()), "user", "other")


@cache
def message_kinds() -> tuple[str, ...]:
    """Return the kinds of messages; the index is 256 times the group's plus the submessage id."""
    names = []
    for group in ENTITY_GROUPS:
        for kind, row in enumerate(_SUBMESSAGES_BY_ID):
            suffix = row.get("message") or f"0x{kind:02x}"
            if suffix == "Encrypted":
                names.append(suffix + " key exchange" * (group == "Key exchange"))
            elif suffix == "data":
                names.append("User data" if group == "User" else group)
            else:
                names.append(suffix if group == "SEDP" else f"{group} {suffix}")
    return tuple(names)


def is_rtps(data: Bytes, at: Offsets) -> Array:
    """Return whether each datagram is an RTPS message."""
    return np.isin(numbers_at(data, at, ">u4"), _MAGIC)


def is_rtps_over_tcp(data: Bytes, at: Offsets) -> Array:
    """Return whether each TCP segment starts with an RTPS message."""
    return np.isin(numbers_at(data, at, ">u4"), (_MAGIC_TCP, *_MAGIC))


def parse_messages(
    data: Bytes, datagrams: Columns, processes: IdTable, notes: Notes
) -> tuple[Columns, Columns]:
    """Return messages, each with the row of its ``datagram``, and `_announcements`."""
    good = (data[datagrams["at"] + 4] == 2) & (datagrams["size"] >= _HEADER_BYTES)
    notes.add_where(~good, "RTPS messages that are cut, or not of version 2")
    original, datagrams = np.flatnonzero(good), take_rows(datagrams, good)
    start, wire_end = datagrams["at"], datagrams["at"] + datagrams["wire"]
    end = start + datagrams["size"]
    datagram, at, after = _split_submessages(data, start + _HEADER_BYTES, end, wire_end)
    kind = data[at]
    source, target = _find_prefixes(data, start, datagram, at, kind)
    is_hidden, has_keys = _classify_security_prefixes(data, at, kind)
    chosen = np.flatnonzero(_IS_MESSAGE[kind] & ~is_hidden)
    datagram, at, after, kind = datagram[chosen], at[chosen], after[chosen], kind[chosen]
    # Every byte of a datagram belongs to a message: bytes between messages to the following one.
    new = np.diff(datagram, prepend=-1) != 0
    begin = np.where(new, start[datagram], np.roll(after, 1))
    stop = np.where(np.roll(new, -1), wire_end[datagram], after)
    little = data[at + 1] & 1 > 0
    last = end[datagram]
    big = np.zeros(1, bool)
    reader, writer = (
        _read_field(data, at, last, of[kind], big) for of in (_READER_OFFSETS, _WRITER_OFFSETS)
    )
    writer = np.where(has_keys[chosen], np.uint32(PARTICIPANT_VOLATILE_SECURE_WRITER), writer)
    group, entity = _classify_entities(reader, writer)
    missing, holes = _count_nacked_samples(data, at, last, kind, little)
    holes |= (kind == HEARTBEAT) & (data[at + 1] & 2 == 0)  # not final (8.3.8.6)
    share = ((stop - begin) / np.maximum(datagrams["wire"][datagram], 1)).astype(np.float32)
    number = _read_field(data, at, last, _SEQUENCE_NUMBER_OFFSETS[kind], little) & 0x7FFFFFFF
    table = message_table(
        datagrams,
        datagram,
        RTPS,
        group * 256 + kind,
        submessage=kind,
        size=_ints_at(data, at + 2, "u2", little),
        reader=reader,
        writer=writer,
        number=number,
        missing=missing,
        holes=holes,
        bytes=stop - begin,
        process=processes.ids_of(data, source[chosen], 12),
        peer=processes.ids_of(data, target[chosen], 12),
        entity=entity,
        # A DATA without data disposes of or unregisters an instance.
        ends=(kind == DATA) & (data[at + 1] & 4 == 0),
        udp=True,
        frames=datagrams["parts"][datagram] * share,
    )
    table["datagram"] = original[datagram]
    announces = np.isin(writer, _SPDP_WRITERS + _SEDP_WRITERS) & (kind == DATA)
    sent = np.flatnonzero(announces & ~table["ends"])
    # Only the first of several messages with the same sample is parsed.
    high, low = (_ints_at(data, at[sent] + n, "u4", little[sent]) for n in (16, 20))
    _, first = factorize(table["process"][sent], writer[sent], high, low)
    rows = sent[first]
    end = np.minimum(stop, last)[rows]
    announcements = _announcements(data, take_rows(table, rows), at[rows], end, little[rows])
    cut = stop[rows] > end
    return table, take_rows(announcements, (announcements["guid"] > 0) | cut)


def source_times(data: Bytes, datagrams: Columns) -> tuple[Array, Array]:
    """Return rows of datagrams with an INFO_TS, first or after an INFO_DST, and its seconds."""
    at = datagrams["at"] + _HEADER_BYTES
    at = np.where(data[at] == INFO_DST, at + 16, at)
    begins = (data[at] == INFO_TS) & (data[at + 1] & 2 == 0)  # the flag: no time
    rows = np.flatnonzero(begins & (at + 12 <= datagrams["at"] + datagrams["size"]))
    seconds = _ints_at(data, at[rows] + 4, "u4", data[at[rows] + 1] & 1 > 0)
    return rows, seconds.astype(np.int64)


def _split_submessages(
    data: Bytes, at: Offsets, end: Offsets, wire_end: Offsets
) -> tuple[Array, Offsets, Offsets]:
    """Return the datagram, first byte and end of each submessage."""
    datagram = np.arange(len(at))
    steps: list[tuple[Array, Offsets, Offsets]] = [(datagram[:0], at[:0], at[:0])]
    while len(at):
        inside = at + 4 <= end
        datagram, at, end, wire_end = datagram[inside], at[inside], end[inside], wire_end[inside]
        kind = data[at]
        length = _ints_at(data, at + 2, "u2", data[at + 1] & 1 > 0).astype(np.int64)
        # The last submessage may have length 0 and extend to the end.
        rest = (length == 0) & (kind != PAD) & (kind != INFO_TS)
        after = np.where(rest, wire_end, at + 4 + length)
        steps.append((datagram, at, np.minimum(after, wire_end)))
        at = after
    datagram, at, after = (np.concatenate(parts) for parts in zip(*steps, strict=True))
    order = np.argsort(datagram, kind="stable")
    return datagram[order], at[order], after[order]


def _find_prefixes(
    data: Bytes, start: Offsets, datagram: Array, at: Offsets, kind: Array
) -> tuple[Offsets, Offsets]:
    """Return the offsets of the GUID prefixes of each submessage's sender and receiver."""
    index, first = np.arange(len(datagram)), np.searchsorted(datagram, datagram)
    prefixes = []
    # By default the sender is in the header; zeros, taken from the padding, address all.
    everybody = np.full(len(datagram), len(data) - PADDING)
    for info, offset, default in ((INFO_SRC, 12, start[datagram] + 8), (INFO_DST, 4, everybody)):
        last = np.maximum.accumulate(np.where(kind == info, index, -1))
        prefix = at[last] + offset
        valid = (last >= first) & (prefix + 12 <= len(data))
        prefixes.append(np.where(valid, prefix, default))
    return prefixes[0], prefixes[1]


def _classify_security_prefixes(data: Bytes, at: Offsets, kind: Array) -> tuple[Array, Array]:
    """Return two masks: security prefixes that are not counted, and those before encrypted keys."""
    prefix = np.isin(kind, (SEC_PREFIX, SRTPS_PREFIX))
    transformation = data[np.where(prefix, at + 7, 0)]
    after = np.roll(at, -1)
    length = _ints_at(data, after + 2, "u2", data[after + 1] & 1 > 0)
    encrypts = prefix & np.isin(transformation, _ENCRYPTING) & (np.roll(kind, -1) == SEC_BODY)
    key = numbers_at(data, np.where(prefix, at + 8, 0), ">u4")
    # A signed submessage follows in plain text and counts itself; an encrypted INFO is no message.
    signs = prefix & np.isin(transformation, _SIGNING)
    has_keys = encrypts & (kind == SEC_PREFIX) & (key == _HANDSHAKE_KEY_ID)
    return signs | (encrypts & (length <= _MAX_ENCRYPTED_INFO_BYTES)), has_keys


def _read_field(data: Bytes, at: Offsets, last: Offsets, offset: Array, little: Array) -> Array:
    """Return the entity id or sequence number at an offset; 0 if absent or truncated."""
    value = _ints_at(data, np.minimum(at + offset, last), "u4", little)
    return np.where((offset > 0) & (at + offset + 4 <= last), value, 0)


def _count_nacked_samples(
    data: Bytes, at: Offsets, last: Offsets, kind: Array, little: Array
) -> tuple[Array, Array]:
    """Return how many samples each ACKNACK requests (9.4.2.6), and whether it has later ones."""
    nacked, holes = np.zeros(len(kind), np.int16), np.zeros(len(kind), bool)
    bits_at = at + _SEQUENCE_NUMBER_OFFSETS[ACKNACK] + 4
    for row in np.flatnonzero((kind == ACKNACK) & (bits_at + 4 <= last)).tolist():
        order: Literal["little", "big"] = "little" if little[row] else "big"
        words = data[bits_at[row] : min(bits_at[row] + 4 + _MAX_NACKS // 8, last[row])].tobytes()
        count = int.from_bytes(words[:4], order)
        if 0 < count <= _MAX_NACKS:
            bitmap = [words[i : i + 4] for i in range(4, len(words) - 3, 4)]
            bits = "".join(f"{int.from_bytes(word, order):032b}" for word in bitmap)
            nacked[row] = bits[:count].count("1")
            holes[row] = "10" in bits[:count]
    return nacked, holes


#: The writers of SPDP, and of SEDP, with and without DDS Security.
_SPDP_WRITERS, _SEDP_WRITERS = (
    [key for key, row in ENTITIES.items() if row["group"] == group] for group in ("SPDP", "SEDP")
)


def _classify_entities(reader: Array, writer: Array) -> tuple[Array, Array]:
    """Return the group and the name, as indices, of each message's entities."""
    entities, which = np.unique(np.where(writer == 0, reader, writer), return_inverse=True)
    indices = np.zeros((2, len(entities)), np.int64)
    for index, entity in enumerate(entities.tolist()):
        group = _GROUPS_BY_BITS[entity >> 6 & 3] if entity else "Unknown"
        row = ENTITIES.get(entity, {"group": group, "what": "user" if group == "User" else "other"})
        indices[:, index] = ENTITY_GROUPS.index(row["group"]), ENTITY_NAMES.index(row["what"])
    return indices[0, which], indices[1, which]


def _announcements(data: Bytes, sent: Columns, at: Offsets, end: Offsets, little: Array) -> Columns:
    """Return the announcements in messages of SPDP and SEDP; missing offsets are 0."""
    list_at = at + 8 + _ints_at(data, at + 6, "u2", little).astype(np.int64)
    inline = data[at + 1] & 2 > 0
    in_qos, after = _find_params(data, list_at, np.where(inline, end, 0), little, (PID_KEY_HASH,))
    list_at = np.where(inline, after, list_at)
    encoding = numbers_at(data, np.where(list_at + 4 <= end, list_at, len(data) - PADDING), ">u2")
    little = encoding == PL_CDR_LE
    list_end = np.where(little | (encoding == PL_CDR_BE), end, 0)
    wanted = (PID_PARTICIPANT_GUID, PID_ENDPOINT_GUID)
    values, _ = _find_params(data, list_at + 4, list_end, little, wanted)
    is_participant = np.isin(sent["writer"], _SPDP_WRITERS)
    guid = np.where(is_participant, values[PID_PARTICIPANT_GUID], values[PID_ENDPOINT_GUID])
    return {
        "guid": np.where(guid > 0, guid, in_qos[PID_KEY_HASH]),
        "is_participant": is_participant,
        "sender": sent["process"],
        "number": sent["number"],
        "frame": sent["frame"],
        "list_at": list_at + 4,
        "list_end": list_end,
        "little": little,
    }


def _find_params(
    data: Bytes, at: Offsets, end: Offsets, little: Array, wanted: tuple[int, ...]
) -> tuple[dict[int, Offsets], Offsets]:
    """Return the offsets of parameter values, 0 if absent, and where each parameter list ends."""
    values = {parameter: np.zeros(len(at), np.int64) for parameter in wanted}
    after, row = at.copy(), np.arange(len(at))
    for _ in range(_MAX_PARAMETERS):
        inside = at + 4 <= end
        row, at, end, little = row[inside], at[inside], end[inside], little[inside]
        if not len(at):
            break
        kind, length = (_ints_at(data, at + n, "u2", little).astype(np.int64) for n in (0, 2))
        for parameter, offsets in values.items():
            mask = (kind == parameter) & (length >= 16) & (at + 20 <= end)
            offsets[row[mask]] = at[mask] + 4
        at = at + 4 + np.where(kind == PID_SENTINEL, 0, length)
        after[row] = at
        go_on = kind != PID_SENTINEL
        row, at, end, little = row[go_on], at[go_on], end[go_on], little[go_on]
    return values, after


def _ints_at(data: Bytes, at: Offsets, dtype: str, little: Array) -> Array:
    """Return integers, each in its own byte order."""
    value = numbers_at(data, at, "<" + dtype)
    return value if little.all() else np.where(little, value, value.byteswap())


def dissect_rtps(data: Bytes, addresses: IdTable, datagrams: Columns, notes: Notes) -> Dissection:
    """Return the messages in RTPS datagrams, and the processes that they show."""
    prefixes = IdTable()
    messages, announcements = parse_messages(data, datagrams, prefixes, notes)
    datagram = messages.pop("datagram")
    _, first = factorize(messages["process"], messages["source"])
    columns = (messages[name][first].tolist() for name in ("process", "frame", "source"))
    senders, frames, sources = columns
    vendors = numbers_at(data, datagrams["at"][datagram[first]] + 6, ">u2").tolist()
    vendor_of = dict(zip(reversed(senders), reversed(vendors), strict=True))
    sightings = list(zip(frames, senders, sources, strict=True))
    domains = dict(_domains_from_ports(messages, datagrams["to_port"][datagram], addresses, notes))
    endpoints: dict[int, set[int]] = defaultdict(set)
    own_addresses: dict[int, list[int]] = defaultdict(list)
    about: dict[int, dict[str, Any]] = defaultdict(dict)
    known = take_rows(announcements, announcements["guid"] > 0)
    of = prefixes.ids_of(data, known["guid"], 12)
    entity = numbers_at(data, known["guid"] + 12, ">u4")
    wanted = ("frame", "sender", "is_participant", "list_at", "list_end", "little")
    lists = (column.tolist() for column in (of, entity, *(known[name] for name in wanted)))
    for id_, end, frame, sender, is_participant, *parameters in zip(*lists, strict=True):
        endpoints[id_].update(() if is_participant or end & _BUILTIN_OR_VENDOR else (end,))
        if is_participant:
            fields, octets = sedp.parse_participant(data, *parameters)
            locators = [addresses.id_of(address) for address in octets]
            about[id_] |= fields
            if id_ == sender and len(locators) >= len(own_addresses[id_]):
                own_addresses[id_] = locators
            elif id_ not in vendor_of and locators:
                sightings.append((frame, id_, locators[-1]))  # announced only by others
    seen = first_seen(sightings, ip.is_loopback(addresses))
    names = [prefix.hex() for prefix in prefixes.ids]
    processes = {}
    for id_ in sorted({*vendor_of, *endpoints} - {prefixes.ids.get(_ALL_PARTICIPANTS)}):
        product = ""
        if (vendor := vendor_of.get(id_)) is not None:
            product = VENDORS.get(vendor, {"name": f"vendor 0x{vendor:04x}"})["name"]
        processes[id_] = Process(
            RTPS,
            names[id_],
            product + " Discovery Server" * ("is_server" in about[id_]),
            *seen.get(id_, (-1, -1)),
            endpoints=len(endpoints.get(id_, ())),
            announced_anything=id_ in endpoints,
            domain=domains.get(id_, -1),
            announced_addresses=tuple(dict.fromkeys(own_addresses[id_])),
            **about[id_],
        )
    return Dissection(messages, processes, _parse_endpoints(data, announcements, prefixes))


def _parse_endpoints(
    data: Bytes, announcements: Columns, prefixes: IdTable
) -> dict[tuple[str, int], tuple[int, sedp.Endpoint | None]]:
    """Return user endpoints as last announced, with sequence number, by GUID prefix and id."""
    names, rows = list(prefixes.ids), take_rows(announcements, ~announcements["is_participant"])
    guid = rows["guid"]
    # Announcements without a readable id get ids below 0 and belong to the process that sent them.
    entity, below = numbers_at(data, guid + 12, ">u4").astype(np.int64), -1 - np.arange(len(guid))
    columns = (
        np.where(guid > 0, prefixes.ids_of(data, guid, 12), rows["sender"]),
        np.where(guid > 0, entity, below),
        *(rows[name] for name in ("number", "list_at", "list_end", "little")),
    )
    found: dict[tuple[str, int], tuple[int, sedp.Endpoint | None]] = {}
    for of, id_, number, at, end, little in zip(*map(np.ndarray.tolist, columns), strict=True):
        if id_ < 0 or not id_ & _BUILTIN_OR_VENDOR:
            endpoint, key = sedp.parse_endpoint(data, at, end, little, id_), (names[of].hex(), id_)
            # What withdraws an endpoint may have nothing but its key.
            if endpoint is not None or key not in found:
                found[key] = number, endpoint
    return found


def _domains_from_ports(
    messages: Columns, to_port: Array, addresses: IdTable, notes: Notes
) -> list[tuple[int, int]]:
    """Return processes and domains, from the ports of SPDP multicast; note several domains."""
    domain, rest = np.divmod(to_port.astype(np.int64) - PORT_BASE, DOMAIN_GAIN)
    spdp = messages["kind"] >> 8 == ENTITY_GROUPS.index("SPDP")
    spdp &= ip.is_multicast(addresses)[messages["target"]]
    rows = np.flatnonzero(spdp & (rest == 0) & (domain >= 0))
    process, domain = messages["process"][rows], domain[rows]
    _, first = factorize(process, domain)
    different = np.unique(domain).tolist()
    if len(different) > 1:
        which = f"RTPS domains ({', '.join(map(str, different))}): processes discover each other "
        notes[f"{which}only within one, but the fleet here counts all of them"] = len(different)
    return sorted(zip(process[first].tolist(), domain[first].tolist(), strict=True))
