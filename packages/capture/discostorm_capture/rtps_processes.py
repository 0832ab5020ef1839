"""The processes of RTPS: what their messages and announcements say of them."""

from collections import Counter, defaultdict
from typing import Any

import numpy as np

from discostorm_capture import endpoints as sedp, ip, rtps
from discostorm_capture._bytes import Array, Bytes, Columns, IdTable, factorize, numbers, take_rows
from discostorm_capture.tables import RTPS, Dissection, Process, first_seen
from discostorm_capture.transport import Transport

#: A prefix of zeros, by which an INFO_DST speaks to all.
_EVERYBODY = bytes(12)
#: The bits of an entity id that mark entities that are built in, or a vendor's.
_NOT_USER = 0xC0


def dissect(transport: Transport, datagrams: Columns, notes: Counter[str]) -> Dissection:
    """Return the messages in RTPS datagrams, and the processes that they show."""
    data, addresses, prefixes = transport.data, transport.addresses, IdTable()
    messages, announcements = rtps.rtps_messages(data, datagrams, prefixes, notes)
    datagram = messages.pop("datagram")
    _, first = factorize(messages["process"], messages["source"])
    columns = (messages[name][first].tolist() for name in ("process", "frame", "source"))
    senders, frames, sources = columns
    vendors = numbers(data, datagrams["at"][datagram[first]] + 6, ">u2").tolist()
    vendor_of = dict(zip(reversed(senders), reversed(vendors), strict=True))
    sightings = list(zip(frames, senders, sources, strict=True))
    domains = dict(_domains(messages, datagrams["to_port"][datagram], addresses, notes))
    # What is announced of each process.
    endpoints: dict[int, set[int]] = defaultdict(set)
    own_addresses: dict[int, list[int]] = defaultdict(list)
    about: dict[int, dict[str, Any]] = defaultdict(dict)
    known = take_rows(announcements, announcements["guid"] > 0)
    of, entity = prefixes.ids_of(data, known["guid"], 12), numbers(data, known["guid"] + 12, ">u4")
    wanted = ("frame", "sender", "is_participant", "list_at", "list_end", "little")
    lists = (column.tolist() for column in (of, entity, *(known[name] for name in wanted)))
    for id_, end, frame, sender, is_participant, *parameters in zip(*lists, strict=True):
        endpoints[id_].update(() if is_participant or end & _NOT_USER else (end,))
        if is_participant:
            said, octets = sedp.parse_participant(data, *parameters)
            locators = [addresses.id_of(address) for address in octets]
            about[id_] |= said
            if id_ == sender and len(locators) >= len(own_addresses[id_]):
                own_addresses[id_] = locators
            elif id_ not in vendor_of and locators:
                sightings.append((frame, id_, locators[-1]))  # known from others alone
    seen = first_seen(sightings, ip.is_loopback(addresses))
    names = [prefix.hex() for prefix in prefixes.ids]
    processes = {}
    for id_ in sorted({*vendor_of, *endpoints} - {prefixes.ids.get(_EVERYBODY)}):
        vendor, (host, first_frame) = vendor_of.get(id_), seen.get(id_, (-1, -1))
        unknown = {"name": "" if vendor is None else f"vendor 0x{vendor:04x}"}
        product = rtps.VENDORS.get(-1 if vendor is None else vendor, unknown)["name"]
        processes[id_] = Process(
            protocol=RTPS,
            name=names[id_],
            product=product + " Discovery Server" * ("server" in about[id_]),
            host=host,
            first_frame=first_frame,
            endpoints=len(endpoints[id_]) if id_ in endpoints else 0,
            announced=id_ in endpoints,
            domain=domains.get(id_, -1),
            announced_addresses=tuple(dict.fromkeys(own_addresses[id_])),
            **about[id_],
        )
    return Dissection(messages, processes, _endpoints(data, announcements, prefixes))


def _endpoints(
    data: Bytes, announcements: Columns, prefixes: IdTable
) -> dict[tuple[str, int], tuple[int, sedp.Endpoint | None]]:
    """Return number and endpoint of user endpoints as announced last, by GUID prefix and id."""
    names, rows = list(prefixes.ids), take_rows(announcements, ~announcements["is_participant"])
    guid = rows["guid"]
    # One whose announcement does not even have its id counts below 0, for the process that sent it.
    entity, below = numbers(data, guid + 12, ">u4").astype(np.int64), -1 - np.arange(len(guid))
    columns = (
        np.where(guid > 0, prefixes.ids_of(data, guid, 12), rows["sender"]),
        np.where(guid > 0, entity, below),
        *(rows[name] for name in ("number", "list_at", "list_end", "little")),
    )
    return {
        (names[of].hex(), id_): (number, sedp.parse_endpoint(data, at, end, little, id_))
        for of, id_, number, at, end, little in zip(*map(np.ndarray.tolist, columns), strict=True)
        if id_ < 0 or not id_ & _NOT_USER
    }


def _domains(
    messages: Columns, to_port: Array, addresses: IdTable, notes: Counter[str]
) -> list[tuple[int, int]]:
    """Return processes and their domains, as multicast messages of SPDP say; note if several."""
    domain, rest = np.divmod(to_port.astype(np.int64) - rtps.PORT_BASE, rtps.DOMAIN_GAIN)
    spdp = messages["kind"] >> 8 == rtps.GROUPS.index("SPDP")
    spdp &= ip.is_multicast(addresses)[messages["target"]]
    rows = np.flatnonzero(spdp & (rest == 0) & (domain >= 0))
    process, domain = messages["process"][rows], domain[rows]
    _, first = factorize(process, domain)
    different = np.unique(domain).tolist()
    if len(different) > 1:
        which = f"domains of RTPS ({', '.join(map(str, different))}): only processes of the same "
        notes[f"{which}one find each other, which the fleet does not know"] = len(different)
    return sorted(zip(process[first].tolist(), domain[first].tolist(), strict=True))
