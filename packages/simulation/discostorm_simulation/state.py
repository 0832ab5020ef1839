"""What a simulated cell consists of, as arrays that the engine and Python share.

Time is counted in whole ticks of 100 ns. Stations are the hosts, then the access point.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Records = NDArray[np.void]
#: Numbers of stations, as short as they go: all are needed all the time.
Places = NDArray[np.int32]

#: Later than anything.
NEVER = np.int64(2**62)

#: Bits of kind, destination process, source process and item, from the lowest on.
KIND_BITS, PROCESS_BITS, ITEM_BITS = 6, 20, 14
KIND_MASK, PROCESS_MASK, ITEMS = (2**bits - 1 for bits in (KIND_BITS, PROCESS_BITS, ITEM_BITS))
DESTINATION_SHIFT = KIND_BITS
SOURCE_SHIFT = DESTINATION_SHIFT + PROCESS_BITS
ITEM_SHIFT = SOURCE_SHIFT + PROCESS_BITS
#: Of a frame that belongs to the traffic that stays, not to the burst.
STEADY = np.int64(1) << (ITEM_SHIFT + ITEM_BITS)
#: From a frame to the next like it.
NEXT_ITEM = np.int64(1) << ITEM_SHIFT
#: Of a frame that the middleware sends again.
REPAIR = STEADY << 1

#: Octets of a line of the processor's cache: what is needed together should be in one.
LINE = 64


def _record(fields: str, lines: int = 0) -> np.dtype[np.void]:
    """Return a record of named whole numbers, "/4" short ones, "/f" floats; of so many lines."""
    kinds = {"": np.int64, "4": np.int32, "f": np.float64}
    named = [
        (name, kinds[kind]) for name, _, kind in (one.partition("/") for one in fields.split())
    ]
    if lines:
        rest = lines * LINE - np.dtype(named).itemsize
        named += [(f"_{number}", np.int64) for number in range(rest // 8)]
    return np.dtype(named)


#: The radio in ticks, bytes and counts; `timeout`: after a frame, when no answer has begun;
#: `eifs_extra`: EIFS - AIFS; by which factors a frame exceeds all that overlap it (capture).
RADIO = _record(
    "slot sifs aifs cw_min cw_max attempts edca timeout eifs_extra ack block_ack bar preamble "
    "symbol grid bits added addba basic_ack mpdus max_bytes min_subframe window queue lifetime "
    "capture_threshold/f capture_threshold_basic/f"
)

#: What the cell is at: slot ``slot`` begins at the tick ``base``, the medium is idle from ``idle``
#: on. ``open``: frames of the burst on their way, ``coming``: its parts still to be sent. ``cold``:
#: block acknowledgements are to be agreed on. Of a captured frame ``overlapping`` counts what is
#: sent with it, until ``others``; ``damaged`` MPDUs it loses. ``stamp``: ticks between two stamps.
STATE = _record(
    "clock base slot idle ahead waiting deferred deferred_time events free spare open coming "
    "drained queued sample step samples logged random hosts links kinds per_receiver finished "
    "pairs converged repairs expected arrived host_full host_age host_retry ap_full ap_age "
    "ap_retry on_air ppdus mpdus retried collisions collided requests busy wasted expired cold "
    "addba_frames unlike overlapping others damaged stamp"
)

#: Causes of losses, for `count_drop`. (Of plain numbers numba would compile a function for each.)
QUEUE_FULL, EXPIRED, RETRY_LIMIT, LOST_ON_AIR = (np.int64(number) for number in range(4))

#: A station: its back-off, its queue, the frames it holds, and where it is in making a burst:
#: frames ``made``, ``times`` of ``number`` alike, the ``last`` one. The access point's frames for
#: host h hang on ``to_head`` and ``to_tail`` of h. What most transmissions need is in the first
#: line of cache; of an even number of lines first ones would share few places in the cache.
STATION = _record(
    "held/4 failures/4 waits/4 begun/4 times/4 number/4 length made last missed head tail "
    "following send_slot to_head to_tail processes first loss/f sent/4 bar_pending/4 stage "
    "process steps there kind sought to_number/4 passed/4",
    lines=3,
)

#: A frame that is sent, when it came, its number, its failures; at an access point that aggregates
#: a copy of the entry ``number`` of `CellState.pool`.
WINDOW = _record("frame came number tries")

#: An agreement on block acknowledgements: request and response that wait, by their order (0: none).
BLOCK_ACK = _record("state request response request_tries response_tries")
#: Not agreed on; asked for; not answered in time; agreed on.
NO_BLOCK_ACK, REQUESTED, UNANSWERED, ESTABLISHED = (np.int64(number) for number in range(4))
UPWARD, DOWNWARD = np.int64(0), np.int64(1)

#: Requests and responses that wait at a station; it sends that of 2 * host + direction, -1: none.
ADDBA = _record("waiting sends")

#: A frame or burst that waits, and the next; at the access point also the next to the same host.
ENTRY = _record("frame came next same number/4 tries/4")

#: Who waits beside the wheel: from which tick on, for how many slots, and so until when.
DEFERRED = _record("station base left time")

#: Who sends now, until when, from which tick and for how many slots it waits then; what arrived.
SENDER = _record("station end base slots frame")

#: What happens later.
EVENT = _record("time what")

#: A row of the protocol's table. ``to_all``: its sender counts it, not its receivers; ``set``: a
#: row of `CellState.receivers_before`; ``whole``: nobody sends a fraction; ``since`` parts early
#: from late messages for ``when``; ``user``: the row of `CellState.delays`, from 1 on; 0: none.
KIND = _record(
    "octets multicast to_all up down set whole time_up time_down role informs of_host trigger "
    "answers when since tcp to_unknown gap_first gap_number user"
)

#: What a message is for: `role`; and when it is sent: `trigger`.
OTHER, DATA, HEARTBEAT, ACKNACK = range(4)
CLOCK, ANSWER, DISCOVERY = range(3)
ALWAYS, LATER, FIRST = range(3)

#: How the middleware repairs, in ticks; see `kernels.recovery`.
REPAIRS = _record(
    "announce_interval_initial announce_interval_max heartbeat_period_initial "
    "heartbeat_period_max lease topics heartbeat acknack rto_first rto_min rto_max"
)

#: What process x holds of process y, at [x, y]: whether it knows y and has all its items; since
#: when y was told of x, and which topics y has acknowledged; and its TCP timer and round trip to y.
PAIR = _record(
    "discovered last_heard missing completed_at announced_at acknowledged rto expires_at srtt "
    "rttvar timer_running"
)

PROCESS = _record("host start announce heartbeat heartbeat_active")

TRANSMISSION = _record("start end station kind frames outcome")
SUCCESS, COLLISION, ERROR = (np.int64(number) for number in range(3))

QUEUE_SAMPLE = _record("time hosts access_point")


class CellState(NamedTuple):
    """All that a run reads and changes."""

    radio: Records
    state: Records
    stations: Records
    window: Records
    #: Of each host what has come to the access point before a frame with a lower number, or -1.
    ordered: Ints
    #: Who waits for a slot, and who waits behind them for the same.
    wheel: Places
    behind: Places
    deferred: Records
    senders: Records
    pool: Records
    #: At [host, direction].
    block_acks: Records
    addba: Records
    events: Records
    kinds: Records
    bursts: Ints
    processes: Records
    #: At [process, row]: messages to each receiver, to all or in all, and where fractions begin.
    each: Floats
    to_all: Floats
    part: Floats
    #: How many processes before one receive what is for a set of them, at [set, process].
    receivers_before: Ints
    #: At [sender, receiver]; of one number if all are heard alike.
    power: Floats
    repairs: Records
    pairs: Records
    received_bitmap: Ints
    #: Frames of user data late by so many stamps; from `SENT_FRAMES` on those sent, lost by cause.
    delays: Ints
    airtime: Ints
    queue_samples: Records
    log: Records


#: Where a row of `CellState.delays` counts what was sent, and where its losses begin and end.
SENT_FRAMES = ITEMS + 1
LOSSES, COUNTED = SENT_FRAMES + 1, SENT_FRAMES + 8

#: What happens, above the bits that say to whom: a host or process, another, a row of the table.
_EVENT = 56
SEND, ANNOUNCE, HEARTBEAT_DUE, LEASE_CHECK, RTO, REPEAT, ADDBA_TIMEOUT = (
    np.int64(n) << _EVENT for n in range(7)
)

#: What the engine answers: the run is over, it needs more memory, or it has done its steps.
OVER, MEMORY, GO_ON = range(3)
#: Columns of `CellState.airtime`, which counts in parts of a tick.
UP, DOWN, FAILED = range(3)
PARTS = 1024
