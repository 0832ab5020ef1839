"""The state of a simulated cell, as arrays that the engine and Python share.

Times are whole ticks of 100 ns. Stations are the hosts, then the access point of each cell.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Records = NDArray[np.void]
#: Station indices, kept short because every step reads them.
StationIndices = NDArray[np.int32]

#: A time after every event.
NEVER = np.int64(2**62)

#: Bits of a frame, from the lowest on: row, destination process, source process, item.
KIND_BITS, PROCESS_BITS, ITEM_BITS = 6, 20, 14
KIND_MASK, PROCESS_MASK, ITEMS = (2**bits - 1 for bits in (KIND_BITS, PROCESS_BITS, ITEM_BITS))
DESTINATION_SHIFT = KIND_BITS
SOURCE_SHIFT = DESTINATION_SHIFT + PROCESS_BITS
ITEM_SHIFT = SOURCE_SHIFT + PROCESS_BITS
#: Flag of a frame: periodic traffic, not part of the startup burst.
STEADY = np.int64(1) << (ITEM_SHIFT + ITEM_BITS)
#: Difference between a frame and the next one of equal content.
NEXT_ITEM = np.int64(1) << ITEM_SHIFT
#: Flag of a frame: retransmitted by the middleware.
REPAIR = STEADY << 1

#: Octets of a processor's cache line. Fields that are used together should share a line.
LINE = 64


def _record(fields: str, lines: int = 0) -> np.dtype[np.void]:
    """Return a record type of int64 fields ("/4": int32, "/f": float64), padded to cache lines."""
    kinds = {"": np.int64, "4": np.int32, "f": np.float64}
    parts = (one.partition("/") for one in fields.split())
    named = [(name, kinds[kind]) for name, _, kind in parts]
    if lines:
        rest = lines * LINE - np.dtype(named).itemsize
        named += [(f"_{number}", np.int64) for number in range(rest // 8)]
    return np.dtype(named)


#: The radio in ticks, octets and counts. ``timeout``: wait for an answer after a frame.
#: ``eifs_extra``: EIFS - AIFS. ``capture_threshold``: required power ratio to overlapping frames.
RADIO = _record(
    "slot sifs aifs cw_min cw_max attempts edca timeout eifs_extra ack block_ack bar preamble "
    "symbol grid bits added addba basic_ack mpdus max_bytes min_subframe window queue lifetime "
    "capture_threshold/f capture_threshold_basic/f"
)

#: The state of the current cell: slot ``slot`` begins at the tick ``base``, the medium is idle from
#: ``idle`` on. ``open``: frames of the burst on their way, ``coming``: its parts still to be sent.
#: ``cold``: block acknowledgements are to be agreed on. Of a captured frame ``overlapping`` counts
#: what is sent with it, until ``others``; ``damaged`` MPDUs it loses. ``stamp``: ticks between two
#: stamps. ``most`` pairs were complete at once, ``known`` announcements are, ``most_known`` were; a
#: run ends ``patience`` after the last ``progress`` of either, if set. Of ``cells`` the current one
#: is number ``here``, and its rows begin at ``rows_at``.
STATE = _record(
    "clock base slot idle ahead waiting deferred deferred_time events free spare open coming "
    "drained queued sample step samples logged random hosts links kinds per_receiver finished "
    "pairs converged repairs expected arrived host_full host_age host_retry ap_full ap_age "
    "ap_retry on_air ppdus mpdus retried collisions collided requests busy wasted expired cold "
    "addba_frames unlike overlapping others damaged stamp most known most_known progress patience "
    "cells here rows_at"
)

#: A cell's channel while it is not the current one, as in `STATE`; its hosts, and when it transmits
#: ``next``. `CellState.radio` has the current radio, then that of each of several cells.
CHANNEL = _record(
    "base slot idle ahead waiting deferred deferred_time per_receiver cold hosts next"
)

#: Causes of a loss, for `count_drop`; np.int64, because numba would specialize on plain integers.
QUEUE_FULL, EXPIRED, RETRY_LIMIT, LOST_ON_AIR = (np.int64(number) for number in range(4))

#: A station: back-off, queue, window and burst generator (``made``: frames so far; ``times`` of
#: ``number`` equal ones; ``last`` frame). The access point's frames to host h are a list from
#: ``to_head`` to ``to_tail`` of h. The first cache line holds the most used fields. An odd number
#: of lines spreads the first lines over the cache.
STATION = _record(
    "held/4 failures/4 waits/4 begun/4 times/4 number/4 length made last missed head tail "
    "following send_slot to_head to_tail processes first loss/f sent/4 bar_pending/4 stage "
    "process steps there kind sought to_number/4 passed/4",
    lines=3,
)

#: A frame of a station's window: arrival time, sequence number and failures. If the access point
#: aggregates, ``number`` is the frame's entry in `CellState.pool`.
WINDOW = _record("frame came number tries")

#: A block acknowledgement agreement: order of its waiting request and response (0: none).
BLOCK_ACK = _record("state request response request_tries response_tries")
#: States of an agreement: none, requested, not answered in time, established.
NO_BLOCK_ACK, REQUESTED, UNANSWERED, ESTABLISHED = (np.int64(number) for number in range(4))
UPWARD, DOWNWARD = np.int64(0), np.int64(1)

#: ADDBA frames of a station: number waiting; next one as 2 * host + direction (-1: none).
ADDBA = _record("waiting sends")

#: A waiting frame or burst, with links to the next entry and to the next for the same host.
ENTRY = _record("frame came next same number/4 tries/4")

#: A station outside the wheel: start [tick] and length [slots] of its back-off, and its end.
DEFERRED = _record("station base left time")

#: A current sender: end of its frame, start and length of its next back-off, received frame.
SENDER = _record("station end base slots frame")

#: A future event.
EVENT = _record("time what")

#: A row of the protocol's table. ``to_all``: its sender counts it, not its receivers; ``set``: a
#: row of `CellState.receivers_before`; ``whole``: nobody sends a fraction; ``since`` parts early
#: from late messages for ``when``; ``user``: the row of `CellState.delays`, from 1 on; 0: none;
#: ``to_host``: all processes of a host learn it; ``delay``: after a discovery, in ticks;
#: ``asked``: a Heartbeat without announcements, which readers ask for.
KIND = _record(
    "octets multicast to_all up down set whole time_up time_down role informs of_host trigger "
    "answers when since tcp to_unknown gap_first gap_number user leg to_host delay asked"
)

#: Values of the fields ``role``, ``trigger`` and ``when`` of a row.
OTHER, DATA, HEARTBEAT, ACKNACK = range(4)
CLOCK, ANSWER, DISCOVERY = range(3)
ALWAYS, LATER, FIRST = range(3)
#: ``leg``, between whom a row is sent: two processes, to or from a wired server, through it from
#: one process to another, and back from that to the server.
DIRECT, TO_SERVER, FROM_SERVER, PASSED_ON, BACK = range(5)

#: Repair by the middleware, in ticks (`kernels.middleware_events`). ``server``: last process, or 0.
#: ``send_buffer`` in octets; a frame of data has ``samples`` in `PARTS`; ``riding``: Heartbeats
#: ride on first sendings, too.
REPAIRS = _record(
    "announce_interval_initial announce_interval_max heartbeat_period_initial "
    "heartbeat_period_max lease topics heartbeat acknack rto_first rto_min rto_max server "
    "nack_response_delay heartbeat_response_delay preemptive_acknack_delay "
    "preemptive_acknack_factor send_buffer samples riding data_octets heartbeat_octets"
)

#: What process x records of process y, at [x, y]: whether it has discovered y and all its items;
#: when x, or the server, announced x to y, and which topics y has acknowledged since; and
#: its TCP timer and round trip to y. ``due``: whether that timer runs; over UDP, which topics y has
#: asked for again, and at [x, x], for which an answer is scheduled. ``asked_in``: number of y's
#: first ACKNACK that waits for an answer; x has sent ``acknacks`` to y. ``served``: topics sent to
#: y before; behind a server, -1 once all was passed on. ``heard``: topics, and from bit 32 on rows,
#: of which a Heartbeat of y has come; ``replying``: topics of which x delays its answer.
PAIR = _record(
    "discovered last_heard missing completed_at announced_at acknowledged rto expires_at srtt "
    "rttvar due heard served replying acknacks asked_in"
)

#: A process; one with ``mute`` set learns all through the first process of its host. It has sent
#: ``sent`` octets of data, ``used`` octets of its buffer, and ``samples`` parts of the next sample.
#: ``unintroduced``: introductions that the server has passed on to it and that have not come.
PROCESS = _record(
    "host start announce heartbeat heartbeat_active mute sent used samples unintroduced"
)

TRANSMISSION = _record("start end station kind frames outcome")
SUCCESS, COLLISION, ERROR = (np.int64(number) for number in range(3))

QUEUE_SAMPLE = _record("time hosts access_point")


class CellState(NamedTuple):
    """All arrays that a run reads and changes."""

    radio: Records
    state: Records
    channels: Records
    #: The cell of each station.
    cell_of: Ints
    stations: Records
    window: Records
    #: For each host: frames at the access point that wait for a lower sequence number, or -1.
    ordered: Ints
    #: Timing wheel of each cell: a station for each slot, and a list of further ones behind each.
    wheel: StationIndices
    behind: StationIndices
    deferred: Records
    senders: Records
    pool: Records
    #: At [host, direction].
    block_acks: Records
    addba: Records
    events: Records
    #: Of several cells the rows of each, whose frames take their own octets and times.
    kinds: Records
    bursts: Ints
    processes: Records
    #: At [process, row]: messages to each receiver, to all, and offset before rounding down.
    each: Floats
    to_all: Floats
    part: Floats
    #: Number of receivers before a process, at [set of receivers, process].
    receivers_before: Ints
    #: Received power at [sender, receiver]; one element if all powers are equal.
    power: Floats
    repairs: Records
    pairs: Records
    received_bitmap: Ints
    #: At [reader, writer, item], only if data are sent on request: number of ACKNACKs sent before
    #: the item arrived, plus 1; 0 if it has not arrived.
    came_after: StationIndices
    #: Frames of user data by delay [stamps]; from `SENT_FRAMES` on: frames sent, and lost by cause.
    delays: Ints
    airtime: Ints
    queue_samples: Records
    log: Records


#: Columns of `CellState.delays`: frames sent, first loss, and end of the losses.
SENT_FRAMES = ITEMS + 1
LOSSES, COUNTED = SENT_FRAMES + 1, SENT_FRAMES + 8

#: Kinds of events, above the bits of their arguments: host or process, other process, row.
_EVENTS = [np.int64(number) << 56 for number in range(12)]
SEND, ANNOUNCE, HEARTBEAT_DUE, LEASE_CHECK, RTO, REPEAT = _EVENTS[:6]
ADDBA_TIMEOUT, DELAYED, ANSWER_DUE, WIRE, ACKNACK_DUE, PREEMPTIVE = _EVENTS[6:]

#: Answers of the engine: the run is over, needs more memory, or has done its steps.
OVER, MEMORY, GO_ON = range(3)
#: Columns of `CellState.airtime`, which counts fractions of a tick.
UP, DOWN, FAILED = range(3)
PARTS = 1024
