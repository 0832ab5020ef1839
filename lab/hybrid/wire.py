"""One speaker of the hybrid discovery, over UDP: its packets, and the process that sends them.

What it does when is `speaker`, the same rules as in the simulator. Here is
what these leave out: octets. Each datagram must have as many of them as the rules say.
"""

import os
import select
import socket
import struct
import time
import zlib
from dataclasses import dataclass, field
from hashlib import blake2b
from typing import Any

import numpy as np

import discostorm as ds
from discostorm.messages import header_bytes
from hybrid.channel import timing_of
from hybrid.speaker import NEVER, Message, Rules, Sizes, Speakers, parameters

GROUP, PORT = "239.255.77.1", 17777
#: Kind and flags, part, address, incarnation, how many sets it holds, hash of these.
HEADER = struct.Struct("!BBHHHQ")
#: GUID prefix, two ports, domain, number of endpoints, octets of the set.
PROCESS = struct.Struct("!12sHHHHI")
#: Word, octets of each part, and which are in it; the parts' exclusive-or follows.
CODED = struct.Struct("!HHQ")
SET_HASH = 8
#: Longer than any datagram.
NO_SET = 2**16
KINDS = ("Announce", "Digest", "Repair", "Heartbeat", "Pull", "Data")
SETTLED, WHOLE = 0x80, 0x40
UNKNOWN, LACKED, GONE, FIRST_VERSION = range(4)

#: What robots of ROS 2 talk about, and of which type it is.
TOPICS = (
    *(("cmd_vel", "geometry_msgs/msg/Twist"), ("odom", "nav_msgs/msg/Odometry")),
    *(("map", "nav_msgs/msg/OccupancyGrid"), ("plan", "nav_msgs/msg/Path")),
    *(("scan", "sensor_msgs/msg/LaserScan"), ("imu", "sensor_msgs/msg/Imu")),
    *(("camera/image_raw", "sensor_msgs/msg/Image"), ("tf", "tf2_msgs/msg/TFMessage")),
    *(("tf_static", "tf2_msgs/msg/TFMessage"), ("rosout", "rcl_interfaces/msg/Log")),
    ("parameter_events", "rcl_interfaces/msg/ParameterEvent"),
    ("diagnostics", "diagnostic_msgs/msg/DiagnosticArray"),
    *(
        ("goal_pose", "geometry_msgs/msg/PoseStamped"),
        ("joint_states", "sensor_msgs/msg/JointState"),
    ),
    ("battery_state", "sensor_msgs/msg/BatteryState"),
    ("robot_description", "std_msgs/msg/String"),
    ("local_costmap/costmap", "nav_msgs/msg/OccupancyGrid"),
    ("global_costmap/costmap", "nav_msgs/msg/OccupancyGrid"),
    *(
        ("initialpose", "geometry_msgs/msg/PoseWithCovarianceStamped"),
        ("clock", "rosgraph_msgs/msg/Clock"),
    ),
)
READER = 0x04  # of the kind of an entity id: DDSI-RTPS 2.5, 9.3.1.2


def description(host: int, processes: int, endpoints: int, alike: bool) -> bytes:
    """Return all endpoints of a host, deflated: entity id, kind and QoS, names of topic and type.

    Of like software the names are relative to the robot, else each robot has its own.
    """
    told = []
    for number in range(processes * endpoints):
        topic, type_ = TOPICS[number % len(TOPICS)]
        again = f"part_{number // len(TOPICS)}/" if number >= len(TOPICS) else ""
        name = f"{'' if alike else f'robot_{host:02}/'}{again}{topic}"
        entity = struct.pack("!IB", number << 8 | 3 | number % 2 * READER, number % 3)
        told.append(entity + f"{name}\0{type_}\0".encode())
    packer = zlib.compressobj(9, wbits=-15)
    return packer.compress(b"".join(told)) + packer.flush() if told else b""


def set_of(host: int, processes: int, endpoints: int, alike: bool) -> bytes:
    """Return a host's set: its processes, then its endpoints."""
    told = description(host, processes, endpoints, alike)
    octets = PROCESS.size * processes + len(told)
    return told_processes(host, processes, endpoints, octets) + told


def told_processes(host: int, processes: int, endpoints: int, octets: int) -> bytes:
    """Return the records of a host's processes."""
    prefixes = (
        b"\x77\x77" + struct.pack("!HII", host, processes, number) for number in range(processes)
    )
    return b"".join(
        PROCESS.pack(prefix, 7410 + 2 * number, 7411 + 2 * number, 0, endpoints, octets)
        for number, prefix in enumerate(prefixes)
    )


def hashed(octets: bytes) -> bytes:
    """Return a set with the hash of its endpoints in their place."""
    processes = struct.unpack_from("!I", octets, 4)[0]
    at = PROCESS.size * processes
    return octets[:at] + blake2b(octets[at:], digest_size=SET_HASH).digest()


def size_told(octets: bytes) -> int:
    """Return how many octets a set has, without what pads it."""
    return int(PROCESS.unpack_from(octets)[-1])


@dataclass(eq=False)
class Store:
    """The octets of the sets that a speaker holds, and the equations that it cannot solve yet."""

    alike: bool
    sets: dict[int, bytes] = field(default_factory=dict)
    equations: dict[int, list[tuple[int, int]]] = field(default_factory=dict)

    def number(self, host: int) -> int:
        return int.from_bytes(self.sets[host], "little")

    def fingerprint(self) -> int:
        """Return the hash of all that it holds."""
        found = 0
        for host, octets in self.sets.items():
            told = blake2b(struct.pack("!H", host) + octets, digest_size=8).digest()
            found ^= int.from_bytes(told, "big")
        return found

    def keep(self, host: int, octets: bytes) -> None:
        self.sets.setdefault(host, octets)
        self.solve(host // 64)

    def add(self, word: int, mask: int, octets: bytes) -> None:
        """Keep the exclusive-or of the sets in a mask."""
        told = int.from_bytes(octets, "little")
        self.equations.setdefault(word, []).append((mask, told))
        self.solve(word)

    def solve(self, word: int) -> None:
        """Gaussian elimination: what follows from all equations of a word."""
        rows: dict[int, tuple[int, int]] = {}
        for host in [host for host in self.sets if host // 64 == word]:
            rows[host % 64] = (1 << host % 64, self.number(host))
        for mask, told in self.equations.get(word, []):
            while mask:
                low = (mask & -mask).bit_length() - 1
                if low not in rows:
                    rows[low] = (mask, told)
                    break
                mask, told = mask ^ rows[low][0], told ^ rows[low][1]
        for low in sorted(rows, reverse=True):  # the later ones have no others but solved ones
            mask, told = rows[low]
            for other in [place for place in rows if place > low and mask >> place & 1]:
                mask, told = mask ^ rows[other][0], told ^ rows[other][1]
            rows[low] = (mask, told)
        for low, (mask, told) in rows.items():
            if mask == 1 << low and 64 * word + low not in self.sets:
                octets = told.to_bytes(-(-told.bit_length() // 8), "little")
                size = PROCESS.size * struct.unpack_from("!I", octets, 4)[0] + SET_HASH
                size = size if self.alike else size_told(octets)
                self.sets[64 * word + low] = octets.ljust(size, b"\0")
        self.equations[word] = [
            row for low, row in sorted(rows.items()) if 64 * word + low not in self.sets
        ]

    def drop(self, hosts: set[int]) -> None:
        """Forget hosts, and with them what was told of them together with others."""
        for host in hosts:
            del self.sets[host]
            self.equations[host // 64] = []


@dataclass(eq=False)
class Speaker:
    """A host's speaker: the rules, its octets, and its socket."""

    host: int
    job: dict[str, Any]
    log: int

    def __post_init__(self) -> None:
        job, host, value = self.job, self.host, parameters()
        capacity, headers = job["capacity"], header_bytes()["UDP"]
        own = set_of(host, job["processes"], job["endpoints"], job["alike"])
        self.whole = own
        self.store = Store(job["alike"])
        self.store.keep(host, hashed(own) if job["alike"] else own)
        if len(own) + HEADER.size > value["datagram"]:
            raise SystemExit(f"a set of {len(own)} B does not fit a datagram")
        base = headers + HEADER.size
        # Sizes of others' sets are noted when they are held.
        self.sizes = Sizes(
            np.full((capacity, 1), base + len(own)),
            np.full((capacity, 1), base + len(self.store.sets[host])),
            headers,
        )
        start = np.full(capacity, -1.0)
        start[host] = job["starts"][host]
        speakers = Speakers(capacity, start, np.ones(capacity, np.int64))
        self.rules = Rules(
            speakers,
            self.sizes,
            timing_of(ds.PAPER),
            np.random.default_rng([job["seed"], host]),
            job["alike"],
            self.send,
            lambda _: False,
            lambda _: None,
        )

    def held(self) -> set[int]:
        """Return whose sets the rules say that it holds."""
        bits = self.rules.speakers.held[self.host]
        return set(np.flatnonzero(np.unpackbits(bits.view(np.uint8), bitorder="little")).tolist())

    def tell(self, what: str, **more: Any) -> None:
        told = " ".join([what, f"{self.rules.now:.6f}", *(f"{k}={v}" for k, v in more.items())])
        os.write(self.log, f"{told}\n".encode())

    # ------------------------------------------------------------ to octets

    def header(self, kind: str, *, host: int, flags: int = 0) -> bytes:
        code = KINDS.index(kind) | flags
        return HEADER.pack(code, 0, host, 1, len(self.store.sets), self.store.fingerprint())

    def send(self, message: Message) -> None:
        """Put a message of the rules into octets and send it."""
        kind, content = message.kind, message.content
        flags = SETTLED * message.settled
        if kind == "Announce":
            flags |= WHOLE * content[1]
            body = self.whole if content[1] else self.store.sets[self.host]
        elif kind in ("Digest", "Pull"):
            body = self.listed(content if kind == "Digest" else (content, None, None))
        elif kind == "Repair":
            body = self.coded(*content)
        elif kind == "Heartbeat":
            recent = np.zeros(int(self.rules.span(self.host)), np.uint8)
            recent[[host for host in content[1] if host < recent.size]] = 1
            body = np.packbits(recent, bitorder="little").tobytes()
        else:
            bits = np.unpackbits(content.view(np.uint8), bitorder="little")
            one, *others = np.flatnonzero(bits).tolist()
            body = self.store.sets[one]
            for host in others:
                body += self.header("Data", host=host, flags=flags) + self.store.sets[host]
            datagram = self.header("Data", host=one, flags=flags) + body
        if kind != "Data":
            datagram = self.header(kind, host=self.host, flags=flags) + body
        if len(datagram) + self.sizes.headers != message.octets:
            said = message.octets - self.sizes.headers
            raise SystemExit(f"{kind}: {len(datagram)} B, and the rules say {said} B")
        to = GROUP if message.to is None else f"10.77.0.{message.to + 1}"
        try:
            self.socket.sendto(datagram, (to, PORT))
        except OSError as error:  # the link is down
            self.tell("unsent", error=error.errno)

    def listed(self, content: tuple[Any, Any, Any]) -> bytes:
        """Return a byte for each host of the range of addresses."""
        length = int(self.rules.span(self.host))
        found = np.zeros(length, np.uint8)
        for bits, code in zip(content, (FIRST_VERSION, LACKED, GONE), strict=True):
            if bits is not None:
                some = np.unpackbits(bits.view(np.uint8), bitorder="little")[:length]
                found[some == 1] = code
        return found.tobytes()

    def coded(self, word: int, masks: list[np.uint64]) -> bytes:
        """Return the exclusive-ors of sets."""
        among = [host for host in self.store.sets if host // 64 == word]
        wanted = int(self.rules.speakers.wanted[self.host, word])
        length = max(len(self.store.sets[host]) for host in among if wanted >> host % 64 & 1)
        body = b""
        for mask in map(int, masks):
            told = 0
            for host in among:
                if mask >> host % 64 & 1:
                    told ^= self.store.number(host)
            body += CODED.pack(word, length, mask) + told.to_bytes(length, "little")
        return body

    # ------------------------------------------------------------ from octets

    def is_ours(self, datagram: bytes) -> bool:
        """Return whether a datagram is one that a speaker of this fleet may have sent."""
        speakers = range(self.rules.speakers.hosts)
        if len(datagram) < HEADER.size or self.sender not in speakers:
            return False
        code, _, sender, *_ = HEADER.unpack_from(datagram)
        if code & 0x0F >= len(KINDS) or sender not in speakers:
            return False
        return self.is_whole(KINDS[code & 0x0F], datagram)

    def is_whole(self, kind: str, datagram: bytes) -> bool:
        """Return whether the parts of a datagram are as long as they say."""
        body, hosts = datagram[HEADER.size :], self.rules.speakers.hosts
        if kind in ("Digest", "Pull"):
            return len(body) <= hosts
        if kind == "Heartbeat":
            return len(body) <= -(-hosts // 8)
        if kind == "Announce":
            return self.set_size(body, whole=bool(datagram[0] & WHOLE)) == len(body)
        while body and kind == "Repair":
            if len(body) < CODED.size:
                return False
            word, length, mask = CODED.unpack_from(body)
            if (
                mask >> max(hosts - 64 * word, 0)
                or 64 * word >= hosts
                or len(body) < CODED.size + length
            ):
                return False
            body = body[CODED.size + length :]
        while datagram and kind == "Data":
            if len(datagram) < HEADER.size or HEADER.unpack_from(datagram)[2] >= hosts:
                return False
            size = HEADER.size + self.set_size(datagram[HEADER.size :])
            if len(datagram) < size:
                return False
            datagram = datagram[size:]
        return True

    def set_size(self, octets: bytes, *, whole: bool = False) -> int:
        """Return how many octets a set has that these begin with; `NO_SET` if it is none."""
        if len(octets) < PROCESS.size:
            return NO_SET
        if self.store.alike and not whole:
            return PROCESS.size * int(struct.unpack_from("!I", octets, 4)[0]) + SET_HASH
        return size_told(octets)

    def receive(self, datagram: bytes) -> None:
        """Hear a datagram: keep its sets, then follow the rules."""
        rules, speakers, me = self.rules, self.rules.speakers, self.host
        code, _, sender, _, holds, told_hash = HEADER.unpack_from(datagram)
        body, kind = datagram[HEADER.size :], KINDS[code & 0x0F]
        to = me if kind in ("Pull", "Data") else None
        content: Any
        before = set(self.store.sets)
        if kind == "Announce":
            whole = bool(code & WHOLE)
            self.store.keep(sender, hashed(body) if whole and self.store.alike else body)
            content = (0, whole)
        elif kind in ("Digest", "Pull"):
            content = self.read_list(body)
            content = content if kind == "Digest" else content[0]
        elif kind == "Repair":
            word, masks = 0, []
            while body:
                word, length, mask = CODED.unpack_from(body)
                self.store.add(word, mask, body[CODED.size : CODED.size + length])
                masks.append(np.uint64(mask))
                body = body[CODED.size + length :]
            content = (word, masks)
        elif kind == "Heartbeat":
            # The hash says whether it holds what this one does.
            own = speakers.held[me].copy()
            held = own if told_hash == self.store.fingerprint() else ~own
            content = (
                held,
                np.flatnonzero(np.unpackbits(np.frombuffer(body, np.uint8), bitorder="little")),
            )
        else:
            content, rest = np.zeros_like(speakers.held[me]), datagram
            while rest:
                of = HEADER.unpack_from(rest)[2]
                octets = rest[HEADER.size :]
                size = self.set_size(octets)
                self.store.keep(of, octets[:size])
                content |= speakers.own[of]
                rest = octets[size:]
            sender = self.sender
        new = set(self.store.sets) - before
        sizes = rules.sets
        for host in new:
            sizes[host, 0] = self.sizes.headers + HEADER.size + len(self.store.sets[host])
        length = len(datagram) + self.sizes.headers
        message = Message(kind, sender, length, bool(code & SETTLED), holds, content, to)
        rules.hear(np.array([me]), message)

    def read_list(self, body: bytes) -> tuple[Any, Any, Any]:
        """Return who is held, lacked and gone by a list."""
        speakers = self.rules.speakers
        codes = np.frombuffer(body, np.uint8)
        zero = np.zeros_like(speakers.held[self.host])
        parts = (codes >= FIRST_VERSION, codes == LACKED, codes == GONE)
        held, lacked, gone = (zero | speakers.bits_of(np.flatnonzero(part)) for part in parts)
        return held, lacked, gone

    # ------------------------------------------------------------ the loop

    def run(self, zero: float, seconds: float) -> None:
        """Speak until the end; times are since ``zero`` of the monotonic clock."""
        rules, due = self.rules, self.rules.speakers.due[:, self.host]
        self.socket = listen()  # not before: what others have said until now is not heard
        late, last = 0.0, None
        while True:
            # What is read may change whom the rules hold; the octets follow.
            held = self.held()
            self.store.drop(set(self.store.sets) - held)
            if held != set(self.store.sets):
                raise SystemExit(f"rules hold {sorted(held)}, octets {sorted(self.store.sets)}")
            if held != last:
                self.tell("holds", hosts=",".join(str(host) for host in sorted(held)))
                last = held
            rules.now = time.monotonic() - zero
            if rules.now >= seconds:
                break
            kind = int(due.argmin())
            wait = min(due[kind], seconds) - rules.now
            if wait <= 0:
                late = max(late, -wait if due[kind] < NEVER else 0.0)
                rules.act(kind, self.host)
                continue
            if select.select([self.socket], [], [], wait)[0]:
                rules.now = time.monotonic() - zero
                datagram, (address, _) = self.socket.recvfrom(65535)
                self.sender = int(address.rpartition(".")[2]) - 1
                if self.is_ours(datagram):
                    self.receive(datagram)
        self.tell("end", late=f"{late:.4f}")


def listen() -> socket.socket:
    """Return a socket of the group."""
    found = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    found.bind(("", PORT))
    member = socket.inet_aton(GROUP) + socket.inet_aton("0.0.0.0")
    found.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
    found.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 0)
    return found
