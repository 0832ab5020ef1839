"""What a simulated cell consists of, as arrays that the engine and Python share.

Time is counted in whole ticks of 100 ns. Stations are the hosts, then the access point.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
#: Numbers of stations, as short as they go: all are needed all the time.
Places = NDArray[np.int32]

#: Later than anything.
NEVER = np.int64(2**62)

# ---------------------------------------------------------------- a frame in one number

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


def _record(
    *names: str, floats: tuple[str, ...] = (), short: tuple[str, ...] = (), lines: int = 0
) -> np.dtype[np.void]:
    """Return a record of whole numbers, but for floats; as long as some lines of cache."""
    kinds = dict.fromkeys(names, np.int64) | dict.fromkeys(floats, np.float64)
    fields = list((kinds | dict.fromkeys(short, np.int32)).items())
    if lines:
        rest = lines * LINE - np.dtype(fields).itemsize
        fields += [(f"_{number}", np.int64) for number in range(rest // 8)]
    return np.dtype(fields)


#: The radio in ticks, bytes and counts; `timeout`: after the end of a frame, when no answer has
#: begun; `eifs_extra`: how much longer who heard a frame with errors waits (EIFS - AIFS). By what
#: factor the power of a frame must exceed that of all that overlap it: at the top rate, and at the
#: basic rate, of which the begin of each frame is.
RADIO = _record(
    *("slot", "sifs", "aifs", "cw_min", "cw_max", "attempts", "edca", "timeout", "eifs_extra"),
    *("ack", "block_ack", "bar", "preamble", "symbol", "grid", "bits", "added"),
    *("addba", "basic_ack"),
    *("mpdus", "max_bytes", "min_subframe", "window", "queue", "lifetime"),
    floats=("capture_threshold", "capture_threshold_basic"),
)

#: What the cell as a whole is at: slot ``slot`` begins at the tick ``base`` if nobody sends before;
#: the medium is idle from ``idle`` on; the first deferred station sends at ``deferred_time``; then
#: counts. ``open``: frames of the burst that are on their way, ``coming``: parts of the burst that
#: hosts have still to send. ``cold``: block acknowledgements have to be agreed on;
#: ``addba_frames``: how many frames for it there were. ``unlike``: stations are heard at unlike
#: strength; of a frame that is received though others overlap it, how many these are with itself,
#: until when they last, and how many MPDUs it loses to them. ``stamp``: ticks between two stamps of
#: user data.
STATE = _record(
    *("clock", "base", "slot", "idle", "ahead", "waiting", "deferred", "deferred_time", "events"),
    *("free", "spare"),
    *("open", "coming", "drained", "queued", "sample", "step", "samples", "logged", "random"),
    *("hosts", "links", "kinds", "per_receiver", "finished", "pairs", "converged", "repairs"),
    *("expected", "arrived", "host_full", "host_age", "host_retry", "ap_full", "ap_age"),
    *("ap_retry", "on_air", "ppdus", "mpdus", "retried", "collisions", "collided", "requests"),
    *("busy", "wasted", "expired", "cold", "addba_frames"),
    *("unlike", "overlapping", "others", "damaged"),
    "stamp",
)

#: Causes of losses, for `count_drop`. (Of plain numbers numba would compile a function for each.)
QUEUE_FULL, EXPIRED, RETRY_LIMIT, LOST_ON_AIR = (np.int64(number) for number in range(4))

#: A station: the slot in which it sends, whether it waits for it or sends; failures in a row;
#: frames that it holds, has just sent, has numbered, and the first that the access point has not
#: passed on; whether it has to ask for a block acknowledgement; its queue; who it is; where it is
#: in making a burst, ``made`` frames, ``times`` of ``number`` that are alike; how many were to
#: receive its processes' frames, and for how many they are lost for good. The access point's frames
#: for host h hang on ``to_head`` and ``to_tail`` of h, ``to_number`` being the next number. What
#: most transmissions need is in the first line of cache, with what the next frame of a burst
#: needs, ``last`` being the one before. (Of an even number of lines the first ones would share few
#: places in the cache.)
STATION = _record(
    *("held", "failures", "waits", "begun", "times", "number"),
    *("length", "made", "last", "missed", "head"),
    *("tail", "following", "send_slot", "to_head", "to_tail", "processes", "first", "loss"),
    *("sent", "bar_pending", "stage", "process", "steps", "there", "kind", "sought"),
    *("to_number", "passed"),
    floats=("loss",),
    short=(
        *("held", "failures", "waits", "begun", "times", "number", "sent", "bar_pending"),
        *("to_number", "passed"),
    ),
    lines=3,
)

#: A frame that a station is sending, the tick at which it came, its number, its failures. Where
#: the access point aggregates it is a copy of the entry ``number`` of `CellState.pool`.
WINDOW = _record("frame", "came", "number", "tries")

#: The agreement on block acknowledgements from a host to the access point, or back; request and
#: response that wait to be sent, by the order in which they came (0: none), and their failures.
BLOCK_ACK = _record("state", "request", "response", "request_tries", "response_tries")
#: Not agreed on; asked for; not answered in time; agreed on.
NO_BLOCK_ACK, REQUESTED, UNANSWERED, ESTABLISHED = (np.int64(number) for number in range(4))
UPWARD, DOWNWARD = np.int64(0), np.int64(1)

#: How many requests and responses wait at a station, and for which agreement it sends one: twice
#: the host and the direction, or -1 for none.
ADDBA = _record("waiting", "sends")

#: A frame that waits, or a burst that does; the next in the queue; at the access point also the
#: next to the same host, which frame to that host it is, and its failures.
ENTRY = _record(*("frame", "came", "next", "same", "number", "tries"), short=("number", "tries"))

#: Who waits beside the wheel: from which tick on, for how many slots, and so until when.
DEFERRED = _record("station", "base", "left", "time")

#: Who sends now, and until when; from which tick on it waits then, for how many slots; also what
#: has just arrived.
SENDER = _record("station", "end", "base", "slots", "frame")

#: What happens later.
EVENT = _record("time", "what")

#: A row of the protocol's table; see `cell_setup`. ``to_all``: it is counted by its sender, not by
#: its receivers; ``set``: its receivers, a row of `CellState.receivers_before`; ``whole``: nobody
#: sends a fraction of one; ``to_unknown``: it goes to undiscovered processes, too; ``of_host``: a
#: process sends it for all of its host. ``when``: it answers all messages, only those that come
#: later than ``since`` after the other's start, or only earlier ones. ``user``: the row of
#: `CellState.delays` of user data, from 1 on; 0 for all else.
KIND = _record(
    *("octets", "multicast", "to_all", "up", "down", "set", "whole", "time_up", "time_down"),
    *("role", "informs", "of_host", "trigger", "answers", "when", "since", "tcp"),
    *("to_unknown", "gap_first", "gap_number", "user"),
)

#: What a message is for: `role`; and when it is sent: `trigger`.
OTHER, DATA, HEARTBEAT, ACKNACK = range(4)
CLOCK, ANSWER, DISCOVERY = range(3)
ALWAYS, LATER, FIRST = range(3)

#: How the middleware repairs, in ticks; see `kernels.recovery`.
REPAIRS = _record(
    *(
        "announce_interval_initial",
        "announce_interval_max",
        "heartbeat_period_initial",
        "heartbeat_period_max",
        "lease",
        "topics",
    ),
    *("heartbeat", "acknack", "rto_first", "rto_min", "rto_max"),
)

#: What process x holds of process y, at [x, y]: whether x knows y, when it heard of it last, how
#: many items of y it misses, when it had all; whether x has sent y its own, which topics y has
#: acknowledged; and of x's connection to y the timer, when it ends, round trip and its spread.
PAIR = _record(
    *("discovered", "last_heard", "missing", "completed_at", "announced_at", "acknowledged"),
    *("rto", "expires_at", "srtt", "rttvar", "timer_running"),
)

#: A process.
PROCESS = _record("host", "start", "announce", "heartbeat", "heartbeat_active")

#: A transmission.
TRANSMISSION = _record("start", "end", "station", "kind", "frames", "outcome")
SUCCESS, COLLISION, ERROR = (np.int64(number) for number in range(3))

#: Queue lengths at a time.
QUEUE_SAMPLE = _record("time", "hosts", "access_point")

Records = NDArray[np.void]


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
    #: Of each message that a process sends, at [process, row]: how many to each receiver, and to
    #: all or in all; where in its fractions it begins.
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
    #: Of user data how many frames were late by so many stamps; from `SENT_FRAMES` on how many
    #: were sent, and lost by cause: at their host, at the access point, on the air.
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
