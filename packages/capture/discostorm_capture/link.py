"""From packets as they were captured to IP packets: Ethernet, cooked, loopback, raw, 802.11."""

from collections import Counter
from collections.abc import Callable

import numpy as np

from discostorm.data import read_data
from discostorm_capture._bytes import Array, Bytes, Columns, Places, number, stack, take

#: Which way a frame of a Wi-Fi network goes; 0 if it is none, or goes neither to nor from an
#: access point.
UP, DOWN = 1, 2

IPV4, IPV6 = 0x0800, 0x86DD
_TAGS = (0x8100, 0x88A8, 0x9100)
#: PPPoE's sessions, with a header in front of PPP's type, which has numbers of its own; those from
#: 0x8000 on are of PPP's control (RFC 2516, RFC 1661).
_PPPOE, _PPPOE_HEADER = 0x8864, 6
_PPP_IPV4, _PPP_IPV6, _PPP_CONTROL = 0x0021, 0x0057, 0x8000
#: What no IP packet is in: ARP and RARP, LLDP, EAPOL, PPPoE's discovery, PTP, loopback tests, and
#: all below, which are lengths.
_WITHOUT_IP = (0x0806, 0x8035, 0x88CC, 0x888E, 0x88C7, 0x8863, 0x88F7, 0x9000)
_LEAST_TYPE = 0x600
#: More tags than this, or words of radiotap flags, nobody sends.
_MOST_TAGS, _MOST_WORDS = 4, 8


def ip_packets(data: Bytes, packets: Columns, link: int, notes: Counter[str]) -> Columns:
    """Return the IP packets in packets of one link type.

    Parameters
    ----------
    data : numpy.ndarray
        Where they are.
    packets : dict
        ``at``, ``size`` and ``length`` of each, ``frame`` and ``interface``.
    link : int
        Their link type.
    notes : Counter
        What could not be read is counted here.

    Returns
    -------
    dict
        Of each ``at``, its first byte, and ``end``, behind its last byte in the file; its
        ``frame``, ``way``, ``view``, a number for the place it was seen at, and ``retry``,
        whether the frame says that it is sent again.
    """
    reader = READERS.get(LINKS.get(link, ""))
    if reader is None:
        notes[f"packets of link type {link}, which is not read"] += len(packets["at"])
        packets, reader = take(packets, slice(0)), _raw
    found = {
        "frame": packets["frame"],
        "at": packets["at"],
        "end": packets["at"] + packets["size"],
        "way": np.zeros(len(packets["at"]), np.uint8),
        "view": packets["interface"].astype(np.int64),
        "retry": np.zeros(len(packets["at"]), bool),
    }
    return reader(data, found, notes)


def _longer(found: Columns, least: int) -> Columns:
    """Return those that have at least so many bytes."""
    enough = found["end"] - found["at"] >= least
    return found if enough.all() else take(found, enough)


def _ip_only(data: Bytes, found: Columns, kind: Array, at: Places, notes: Counter[str]) -> Columns:
    """Return those whose type is IP, after VLAN tags and PPPoE; the type stands before `at`."""
    for _ in range(_MOST_TAGS):
        tagged = np.isin(kind, _TAGS) & (at + 4 <= found["end"])
        if not tagged.any():
            break
        kind = np.where(tagged, number(data, at * tagged + 2, ">u2"), kind)
        at = at + 4 * tagged
    session = (kind == _PPPOE) & (at + _PPPOE_HEADER + 2 <= found["end"])
    if session.any():
        inner = number(data, at * session + _PPPOE_HEADER, ">u2")
        types = (_PPP_IPV4, IPV4), (_PPP_IPV6, IPV6)
        for ppp, type_ in types:
            kind = np.where(session & (inner == ppp), type_, kind)
        kind = np.where(session & (inner >= _PPP_CONTROL), 0, kind)
        at = at + (_PPPOE_HEADER + 2) * session
    is_ip = (kind == IPV4) | (kind == IPV6)
    other = kind[~is_ip & (kind >= _LEAST_TYPE) & ~np.isin(kind, _WITHOUT_IP)]
    for type_, count in zip(*np.unique(other, return_counts=True), strict=True):
        notes[f"frames of EtherType 0x{type_:04x}, which is not read"] += int(count)
    return take(found | {"at": at}, is_ip & (at < found["end"]))


def _ethernet(data: Bytes, found: Columns, notes: Counter[str]) -> Columns:
    found = _longer(found, 14)
    at = found["at"]
    kind = number(data, at + 12, ">u2")
    # Up to 1500 it is a length, and what follows is LLC.
    at = at + 14
    short = np.flatnonzero(kind <= 1500)
    llc = short[_snap(data, at[short])]
    kind[llc] = number(data, at[llc] + 6, ">u2")
    at[llc] += 8
    return _ip_only(data, found, kind, at, notes)


def _snap(data: Bytes, at: Places) -> Array:
    """Return where LLC says that SNAP follows, with a type of Ethernet."""
    found: Array = (number(data, at, ">u4") == 0xAAAA0300) & (number(data, at + 4, ">u2") == 0)
    return found


def _cooked(data: Bytes, found: Columns, notes: Counter[str]) -> Columns:
    found = _longer(found, 16)
    at = found["at"]
    # Sent or received: one packet may be seen as both.
    view = (found["view"] << 8) | (number(data, at, ">u2") & 0xFF)
    return _ip_only(data, found | {"view": view}, number(data, at + 14, ">u2"), at + 16, notes)


def _cooked_2(data: Bytes, found: Columns, notes: Counter[str]) -> Columns:
    found = _longer(found, 20)
    at = found["at"]
    index = number(data, at + 4, ">u4").astype(np.int64)
    view = (found["view"] << 40) | (index << 8) | data[at + 10]
    return _ip_only(data, found | {"view": view}, number(data, at, ">u2"), at + 20, notes)


def _loopback(data: Bytes, found: Columns, notes: Counter[str]) -> Columns:
    found = _longer(found, 4)
    # The family is in the byte order of the machine that captured, so its IPv6 differs, too.
    family = number(data, found["at"], ">u4")
    family = np.where(family > 0xFFFF, family.byteswap(), family)
    is_ip = np.isin(family, (2, 10, 24, 28, 30))
    if count := int(np.count_nonzero(~is_ip)):
        notes["packets of loopback that are not IP"] += count
    return take(found | {"at": found["at"] + 4}, is_ip)


def _raw(_data: Bytes, found: Columns, _notes: Counter[str]) -> Columns:
    return _longer(found, 1)


def _radiotap(data: Bytes, found: Columns, notes: Counter[str]) -> Columns:
    found = _longer(found, 8)
    at = found["at"]
    length = number(data, at + 2, "<u2").astype(np.int64)
    # The flags stand behind a time stamp, if there is one, at a multiple of eight.
    words = np.ones(len(at), np.int64)
    for _ in range(_MOST_WORDS):
        last = at + 4 * words
        more = (number(data, last, "<u4") >> 31 == 1) & (4 + 4 * words < length)
        if not more.any():
            break
        words = words + more
    present = number(data, at + 4, "<u4")
    place = 4 + 4 * words
    place = np.where(present & 1, (place + 7 & ~7) + 8, place)
    flags = np.where((present & 2 > 0) & (place < length), data[at + place.clip(0, 64)], 0)
    found = found | {"at": at + length, "end": found["end"] - 4 * (flags & 0x10 > 0)}
    if broken := int(np.count_nonzero(flags & 0x40)):
        notes["Wi-Fi frames with a wrong check sequence, left out"] += broken
    good = (flags & 0x40 == 0) & (data[at] == 0) & (length >= 8)
    return _wifi(data, take(found, good), notes, padded=(flags & 0x20 > 0)[good])


def _wifi_plain(data: Bytes, found: Columns, notes: Counter[str]) -> Columns:
    return _wifi(data, found, notes, np.zeros(len(found["at"]), bool))


def _wifi(data: Bytes, found: Columns, notes: Counter[str], padded: Array) -> Columns:
    enough = found["end"] - found["at"] >= 24
    found, padded = take(found, enough), padded[enough]
    at = found["at"]
    first, second = data[at], data[at + 1]
    # Data, of the subtypes that carry some.
    is_data = (first & 0x4F) == 0x08
    protected = is_data & (second & 0x40 > 0)
    if count := int(np.count_nonzero(protected)):
        notes["encrypted Wi-Fi frames"] += count
    pieces = is_data & ((second & 0x04 > 0) | (data[at + 22] & 0x0F > 0))
    if count := int(np.count_nonzero(pieces & ~protected)):
        notes["fragments of Wi-Fi frames"] += count
    readable = is_data & ~protected & ~pieces
    found, padded = take(found, readable), padded[readable]
    at, first, second = found["at"], first[readable], second[readable]
    to, from_ = second & 1 > 0, second & 2 > 0
    qos = first & 0x80 > 0
    control_at = at + 24 + 6 * (to & from_)
    header = 24 + 6 * (to & from_) + 2 * qos + 4 * (qos & (second & 0x80 > 0))
    header = np.where(padded, header + 3 & ~3, header)
    inside = control_at < found["end"]
    bundle = qos & inside & (data[np.where(inside, control_at, 0)] & 0x80 > 0)
    found = found | {
        "at": at + header,
        "way": np.where(to & ~from_, UP, np.where(from_ & ~to, DOWN, 0)).astype(np.uint8),
        "view": (found["view"] << 2) | to | from_ * 2,
        "retry": second & 0x08 > 0,
    }
    return stack(
        [
            _llc(data, take(found, ~bundle), notes),
            _llc(data, _subframes(data, take(found, bundle)), notes),
        ]
    )


def _subframes(data: Bytes, found: Columns) -> Columns:
    """Return what A-MSDUs hold, each behind its own addresses and length."""
    parts = [take(found, slice(0))]
    at = found["at"]
    while len(found["at"]):
        inside = at + 14 <= found["end"]
        found, at = take(found, inside), at[inside]
        length = number(data, at + 12, ">u2").astype(np.int64)
        end = np.minimum(at + 14 + length, found["end"])
        parts.append(found | {"at": at + 14, "end": end})
        at = at + (14 + length + 3 & ~3)
    return stack(parts)


def _llc(data: Bytes, found: Columns, notes: Counter[str]) -> Columns:
    found = _longer(found, 8)
    found = take(found, _snap(data, found["at"]))
    return _ip_only(data, found, number(data, found["at"] + 6, ">u2"), found["at"] + 8, notes)


Reader = Callable[[Bytes, Columns, Counter[str]], Columns]
#: What reads a link type, by what the data file calls it.
READERS: dict[str, Reader] = {
    "Ethernet": _ethernet,
    "Linux cooked": _cooked,
    "Linux cooked v2": _cooked_2,
    "loopback": _loopback,
    "raw IP": _raw,
    "IEEE 802.11": _wifi_plain,
    "IEEE 802.11 with radiotap": _radiotap,
}
LINKS = {
    int(row["id"]): row["what"] for row in read_data("vendors/link_types.csv", "discostorm_capture")
}
