"""A link of the lab that Linux's own queues cannot make: frames pass between two interfaces.

`link.py A B delay SECONDS` delays them in both directions. `link.py A B checksum 1` spoils the UDP
checksum of what comes from A, as faulty offloading does. `link.py A B copies N` passes multicast N
times, as some repeaters do. `twice 1` passes every frame twice. `jitter SECONDS` delays each frame
by a random time of at most that. `ahead SECONDS` makes the times in RTPS that come from A later, as
if the clock there were ahead.
"""

import heapq
import random
import select
import socket
import struct
import sys
import time

NEAR, FAR, HOW, VALUE = sys.argv[1:5]
ALL, OUTGOING = 3, 4  # ETH_P_ALL, PACKET_OUTGOING
PAD, INFO_TIMESTAMP, INVALIDATE = 1, 9, 2  # of RTPS: two submessages, and a flag


def start_of_udp(frame: bytes) -> int:
    """Return where the header of UDP starts in a frame: 0 if it has none in IPv4."""
    later = frame[21] or frame[20] & 31  # not a first fragment
    if frame[12:14] != b"\x08\x00" or frame[23] != socket.IPPROTO_UDP or later:
        return 0
    return 14 + 4 * (frame[14] & 15)


def with_wrong_checksum(frame: bytes) -> bytes:
    """Return a frame with a wrong UDP checksum, if it has one."""
    at = start_of_udp(frame)
    if not at:
        return frame
    return frame[: at + 6] + bytes([frame[at + 6] ^ 0x5A, frame[at + 7] | 1]) + frame[at + 8 :]


def with_later_times(frame: bytes, seconds: int) -> bytes:
    """Return a frame with later timestamps of RTPS and without UDP checksum, if it is of RTPS."""
    at = start_of_udp(frame)
    if not at or frame[at + 8 : at + 12] != b"RTPS":
        return frame
    new = bytearray(frame)
    new[at + 6 : at + 8] = bytes(2)
    at += 28
    while at + 4 <= len(new):
        kind, flags = new[at], new[at + 1]
        order = "<" if flags & 1 else ">"
        (size,) = struct.unpack_from(order + "H", new, at + 2)
        if kind == INFO_TIMESTAMP and not flags & INVALIDATE:
            (told,) = struct.unpack_from(order + "I", new, at + 4)
            struct.pack_into(order + "I", new, at + 4, told + seconds)
        if size == 0 and kind not in (PAD, INFO_TIMESTAMP):
            break  # the last submessage
        at += 4 + size
    return bytes(new)


ends = [socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ALL)) for _ in range(2)]
for end, name in zip(ends, (NEAR, FAR), strict=True):
    end.bind((name, ALL))
delay = float(VALUE) if HOW == "delay" else 0.0
waiting: list[tuple[float, int, int, bytes]] = []
number = 0
while True:
    left = max(0.0, waiting[0][0] - time.monotonic()) if waiting else None
    for end in select.select(ends, [], [], left)[0]:
        frame, origin = end.recvfrom(9200)
        if origin[2] != OUTGOING:
            number, came = number + 1, ends.index(end)
            if HOW == "checksum" and came == 0:
                frame = with_wrong_checksum(frame)
            if HOW == "ahead" and came == 0:
                frame = with_later_times(frame, int(VALUE))
            copies = int(VALUE) if HOW == "copies" and frame[0] & 1 else 1 + (HOW == "twice")
            wait = random.uniform(0, float(VALUE)) if HOW == "jitter" else delay
            waiting += [(time.monotonic() + wait, number, 1 - came, frame)] * copies
            heapq.heapify(waiting)
    while waiting and waiting[0][0] <= time.monotonic():
        _, _, to, frame = heapq.heappop(waiting)
        ends[to].send(frame)
