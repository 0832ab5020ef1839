"""A speaker of the hybrid discovery over UDP: its packets, and the process that sends them.

`speaker` decides when to send, as in the simulator. This module adds the octets; each datagram must
have the size that the rules say.
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
from proposed_discovery.channel import timing_of
from proposed_discovery.speaker import NEVER, FrameSizes, Message, Rules, Speakers, parameters

GROUP, PORT = "239.255.77.1", 17777
#: Header. Fields: kind and flags, part, address, incarnation, number of held sets, their hash.
HEADER = struct.Struct("!BBHHHQ")
#: Process record. Fields: GUID prefix, two ports, domain, number of endpoints, octets of the set.
PROCESS = struct.Struct("!12sHHHHI")
#: Repair. Fields: word, octets of each part, and mask of its parts; their exclusive-or follows.
CODED = struct.Struct("!HHQ")
SET_HASH = 8
#: Longer than any datagram.
INVALID_SET_SIZE = 2**16
KINDS = ("Announce", "Digest", "Repair", "Heartbeat", "Pull", "Data")
SETTLED, WHOLE = 0x80, 0x40
UNKNOWN, LACKED, GONE, FIRST_VERSION = range(4)

#: Topics of ROS 2 robots, with their types.
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
READER = 0x04  # of an entity id's kind: DDSI-RTPS 2.5, 9.3.1.2


def description(host: int, processes: int, endpoints: int, alike: bool) -> bytes:
    """Return a host's endpoints, deflated. Fields: entity id, kind and QoS, topic name, type name.

    With equal software, names are relative to the robot; otherwise they contain the robot's number.
    """
    records = []
    for number in range(processes * endpoints):
        topic, type_ = TOPICS[number % len(TOPICS)]
        again = f"part_{number // len(TOPICS)}/" if number >= len(TOPICS) else ""
        name = f"{'' if alike else f'robot_{host:02}/'}{again}{topic}"
        entity = struct.pack("!IB", number << 8 | 3 | number % 2 * READER, number % 3)
        records.append(entity + f"{name}\0{type_}\0".encode())
    packer = zlib.compressobj(9, wbits=-15)
    return packer.compress(b"".join(records)) + packer.flush() if records else b""


def octets_of_set(host: int, processes: int, endpoints: int, alike: bool) -> bytes:
    """Return a host's set: its processes, then its endpoints."""
    names = description(host, processes, endpoints, alike)
    octets = PROCESS.size * processes + len(names)
    return process_records(host, processes, endpoints, octets) + names


def process_records(host: int, processes: int, endpoints: int, octets: int) -> bytes:
    """Return the records of a host's processes."""
    prefixes = (
        b"\x77\x77" + struct.pack("!HII", host, processes, number) for number in range(processes)
    )
    return b"".join(
        PROCESS.pack(prefix, 7410 + 2 * number, 7411 + 2 * number, 0, endpoints, octets)
        for number, prefix in enumerate(prefixes)
    )


def replace_endpoints_by_hash(octets: bytes) -> bytes:
    """Return a set with a hash in place of its endpoints."""
    processes = struct.unpack_from("!I", octets, 4)[0]
    at = PROCESS.size * processes
    return octets[:at] + blake2b(octets[at:], digest_size=SET_HASH).digest()


def size_without_padding(octets: bytes) -> int:
    """Return the number of octets of a set, without padding."""
    return int(PROCESS.unpack_from(octets)[-1])


@dataclass(eq=False)
class Store:
    """The octets of the sets that a speaker holds, and its unsolved equations."""

    alike: bool
    sets: dict[int, bytes] = field(default_factory=dict)
    equations: dict[int, list[tuple[int, int]]] = field(default_factory=dict)

    def set_as_integer(self, host: int) -> int:
        return int.from_bytes(self.sets[host], "little")

    def fingerprint(self) -> int:
        """Return the hash of all held sets."""
        found = 0
        for host, octets in self.sets.items():
            digest = blake2b(struct.pack("!H", host) + octets, digest_size=8).digest()
            found ^= int.from_bytes(digest, "big")
        return found

    def store_set(self, host: int, octets: bytes) -> None:
        self.sets.setdefault(host, octets)
        self.solve_equations(host // 64)

    def store_combination(self, word: int, mask: int, octets: bytes) -> None:
        """Store the exclusive-or of the sets in a mask."""
        value = int.from_bytes(octets, "little")
        self.equations.setdefault(word, []).append((mask, value))
        self.solve_equations(word)

    def solve_equations(self, word: int) -> None:
        """Solve the equations of a word by Gaussian elimination."""
        rows: dict[int, tuple[int, int]] = {}
        for host in [host for host in self.sets if host // 64 == word]:
            rows[host % 64] = (1 << host % 64, self.set_as_integer(host))
        for mask, value in self.equations.get(word, []):
            while mask:
                low = (mask & -mask).bit_length() - 1
                if low not in rows:
                    rows[low] = (mask, value)
                    break
                mask, value = mask ^ rows[low][0], value ^ rows[low][1]
        for low in sorted(rows, reverse=True):  # eliminate later parts first
            mask, value = rows[low]
            for other in [place for place in rows if place > low and mask >> place & 1]:
                mask, value = mask ^ rows[other][0], value ^ rows[other][1]
            rows[low] = (mask, value)
        for low, (mask, value) in rows.items():
            if mask == 1 << low and 64 * word + low not in self.sets:
                octets = value.to_bytes(-(-value.bit_length() // 8), "little")
                size = PROCESS.size * struct.unpack_from("!I", octets, 4)[0] + SET_HASH
                size = size if self.alike else size_without_padding(octets)
                self.sets[64 * word + low] = octets.ljust(size, b"\0")
        self.equations[word] = [
            row for low, row in sorted(rows.items()) if 64 * word + low not in self.sets
        ]

    def drop_hosts(self, hosts: set[int]) -> None:
        """Drop hosts, with all equations that contain their sets."""
        for host in hosts:
            del self.sets[host]
            self.equations[host // 64] = []


@dataclass(eq=False)
class Speaker:
    """A host's speaker: the rules, the octets, and the socket."""

    host: int
    job: dict[str, Any]
    log: int

    def __post_init__(self) -> None:
        job, host, value = self.job, self.host, parameters()
        capacity, headers = job["capacity"], header_bytes()["UDP"]
        own = octets_of_set(host, job["processes"], job["endpoints"], job["alike"])
        self.whole = own
        self.store = Store(job["alike"])
        self.store.store_set(host, replace_endpoints_by_hash(own) if job["alike"] else own)
        if len(own) + HEADER.size > value["datagram"]:
            raise SystemExit(f"a set of {len(own)} B does not fit a datagram")
        base = headers + HEADER.size
        # The sizes of other hosts' sets are filled in when the sets arrive.
        self.sizes = FrameSizes(
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

    def held_hosts(self) -> set[int]:
        """Return the hosts whose sets the speaker holds by the rules."""
        bits = self.rules.speakers.held[self.host]
        return set(np.flatnonzero(np.unpackbits(bits.view(np.uint8), bitorder="little")).tolist())

    def write_log(self, what: str, **more: Any) -> None:
        line = " ".join([what, f"{self.rules.now:.6f}", *(f"{k}={v}" for k, v in more.items())])
        os.write(self.log, f"{line}\n".encode())

    # ------------------------------------------------------------ sending

    def header(self, kind: str, *, host: int, flags: int = 0) -> bytes:
        code = KINDS.index(kind) | flags
        return HEADER.pack(code, 0, host, 1, len(self.store.sets), self.store.fingerprint())

    def send(self, message: Message) -> None:
        """Encode a message of the rules and send the datagram."""
        kind, content = message.kind, message.content
        flags = SETTLED * message.settled
        if kind == "Announce":
            flags |= WHOLE * content[1]
            body = self.whole if content[1] else self.store.sets[self.host]
        elif kind in ("Digest", "Pull"):
            body = self.states_of_addresses(content if kind == "Digest" else (content, None, None))
        elif kind == "Repair":
            body = self.coded_repair(*content)
        elif kind == "Heartbeat":
            recent = np.zeros(int(self.rules.address_list_length(self.host)), np.uint8)
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
            self.write_log("unsent", error=error.errno)

    def states_of_addresses(self, content: tuple[Any, Any, Any]) -> bytes:
        """Return one byte for each address of the range."""
        length = int(self.rules.address_list_length(self.host))
        found = np.zeros(length, np.uint8)
        for bits, code in zip(content, (FIRST_VERSION, LACKED, GONE), strict=True):
            if bits is not None:
                some = np.unpackbits(bits.view(np.uint8), bitorder="little")[:length]
                found[some == 1] = code
        return found.tobytes()

    def coded_repair(self, word: int, masks: list[np.uint64]) -> bytes:
        """Return the exclusive-or of the sets in each mask."""
        among = [host for host in self.store.sets if host // 64 == word]
        wanted = int(self.rules.speakers.wanted[self.host, word])
        length = max(len(self.store.sets[host]) for host in among if wanted >> host % 64 & 1)
        body = b""
        for mask in map(int, masks):
            combined = 0
            for host in among:
                if mask >> host % 64 & 1:
                    combined ^= self.store.set_as_integer(host)
            body += CODED.pack(word, length, mask) + combined.to_bytes(length, "little")
        return body

    # ------------------------------------------------------------ receiving

    def is_from_this_fleet(self, datagram: bytes) -> bool:
        """Return whether a speaker of this fleet may have sent a datagram."""
        speakers = range(self.rules.speakers.hosts)
        if len(datagram) < HEADER.size or self.sender not in speakers:
            return False
        code, _, sender, *_ = HEADER.unpack_from(datagram)
        if code & 0x0F >= len(KINDS) or sender not in speakers:
            return False
        return self.has_stated_lengths(KINDS[code & 0x0F], datagram)

    def has_stated_lengths(self, kind: str, datagram: bytes) -> bool:
        """Return whether the parts of a datagram have the stated lengths."""
        body, hosts = datagram[HEADER.size :], self.rules.speakers.hosts
        if kind in ("Digest", "Pull"):
            return len(body) <= hosts
        if kind == "Heartbeat":
            return len(body) <= -(-hosts // 8)
        if kind == "Announce":
            return self.set_size(body, complete=bool(datagram[0] & WHOLE)) == len(body)
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

    def set_size(self, octets: bytes, *, complete: bool = False) -> int:
        """Return the octets of a set by its first bytes; `INVALID_SET_SIZE` for other data."""
        if len(octets) < PROCESS.size:
            return INVALID_SET_SIZE
        if self.store.alike and not complete:
            return PROCESS.size * int(struct.unpack_from("!I", octets, 4)[0]) + SET_HASH
        return size_without_padding(octets)

    def receive(self, datagram: bytes) -> None:
        """Receive a datagram: store its sets, then follow the rules."""
        rules, speakers, me = self.rules, self.rules.speakers, self.host
        code, _, sender, _, holds, told_hash = HEADER.unpack_from(datagram)
        body, kind = datagram[HEADER.size :], KINDS[code & 0x0F]
        to = me if kind in ("Pull", "Data") else None
        content: Any
        before = set(self.store.sets)
        if kind == "Announce":
            whole = bool(code & WHOLE)
            self.store.store_set(
                sender, replace_endpoints_by_hash(body) if whole and self.store.alike else body
            )
            content = (0, whole)
        elif kind in ("Digest", "Pull"):
            content = self.parse_digest(body)
            content = content if kind == "Digest" else content[0]
        elif kind == "Repair":
            word, masks = 0, []
            while body:
                word, length, mask = CODED.unpack_from(body)
                self.store.store_combination(word, mask, body[CODED.size : CODED.size + length])
                masks.append(np.uint64(mask))
                body = body[CODED.size + length :]
            content = (word, masks)
        elif kind == "Heartbeat":
            # Equal hashes mean that the sender holds the same sets.
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
                self.store.store_set(of, octets[:size])
                content |= speakers.own[of]
                rest = octets[size:]
            sender = self.sender
        new = set(self.store.sets) - before
        sizes = rules.sets
        for host in new:
            sizes[host, 0] = self.sizes.headers + HEADER.size + len(self.store.sets[host])
        length = len(datagram) + self.sizes.headers
        message = Message(kind, sender, length, bool(code & SETTLED), holds, content, to)
        rules.receive_message(np.array([me]), message)

    def parse_digest(self, body: bytes) -> tuple[Any, Any, Any]:
        """Return the held, missing and dropped hosts in a digest."""
        speakers = self.rules.speakers
        codes = np.frombuffer(body, np.uint8)
        zero = np.zeros_like(speakers.held[self.host])
        parts = (codes >= FIRST_VERSION, codes == LACKED, codes == GONE)
        held, lacked, gone = (zero | speakers.bits_of_parts(np.flatnonzero(part)) for part in parts)
        return held, lacked, gone

    # ------------------------------------------------------------ main loop

    def run(self, zero: float, seconds: float) -> None:
        """Run the speaker until the end; times count from ``zero`` of the monotonic clock."""
        rules, due = self.rules, self.rules.speakers.due[:, self.host]
        self.socket = listen()  # earlier messages must be missed
        late, last = 0.0, None
        while True:
            # A received message may change the held hosts, so update the octets as well.
            held = self.held_hosts()
            self.store.drop_hosts(set(self.store.sets) - held)
            if held != set(self.store.sets):
                raise SystemExit(f"rules hold {sorted(held)}, octets {sorted(self.store.sets)}")
            if held != last:
                self.write_log("holds", hosts=",".join(str(host) for host in sorted(held)))
                last = held
            rules.now = time.monotonic() - zero
            if rules.now >= seconds:
                break
            kind = int(due.argmin())
            wait = min(due[kind], seconds) - rules.now
            if wait <= 0:
                late = max(late, -wait if due[kind] < NEVER else 0.0)
                rules.run_timer(kind, self.host)
                continue
            if select.select([self.socket], [], [], wait)[0]:
                rules.now = time.monotonic() - zero
                datagram, (address, _) = self.socket.recvfrom(65535)
                self.sender = int(address.rpartition(".")[2]) - 1
                if self.is_from_this_fleet(datagram):
                    self.receive(datagram)
        self.write_log("end", late=f"{late:.4f}")


def listen() -> socket.socket:
    """Return a socket that has joined the multicast group."""
    found = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    found.bind(("", PORT))
    member = socket.inet_aton(GROUP) + socket.inet_aton("0.0.0.0")
    found.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
    found.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 0)
    return found
