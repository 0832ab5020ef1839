"""Count messages by naming each one, as an independent check of the formulas."""

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import cycle, islice
from typing import Any, Literal, TypeAlias

#: Receiver of a multicast message.
EVERYONE = "everyone"
_TOPICS = ("publications", "subscriptions")
_KINDS_BY_PHASE = {
    "SPDP": ("SPDP",),
    "SEDP": ("SEDP", "Heartbeat", "ACKNACK"),
    "Scouting": ("Scout", "Hello"),
    "Declaration": ("Declare", "KeepAlive"),
}


@dataclass(frozen=True, slots=True)
class Process:
    """A process by its host and its number on it; both count from 1."""

    host: int
    number: int

    def __str__(self) -> str:
        return f"host {self.host} process {self.number}"


@dataclass(frozen=True, slots=True)
class Endpoint:
    """An endpoint by its process and its number in it, with the built-in topic of its kind."""

    process: Process
    number: int
    builtin_topic: str

    def __str__(self) -> str:
        return f"endpoint {self.number}"


@dataclass(frozen=True, slots=True)
class Session:
    """A Zenoh session by the process that opened it."""

    opener: Process

    def __str__(self) -> str:
        return f"session opened by {self.opener}"


About: TypeAlias = Endpoint | Session | str


@dataclass(frozen=True, slots=True)
class SentMessage:
    """One message on its hop up to the access point, or down; about "" is the sender itself."""

    sender: Process
    receiver: Process | str
    kind: str
    about: About
    hop: Literal["up", "down"]

    @property
    def phase(self) -> str:
        """The discovery phase of the message."""
        return next(phase for phase, kinds in _KINDS_BY_PHASE.items() if self.kind in kinds)


# A message before it takes a hop: receiver, kind and subject.
_Message: TypeAlias = tuple[Process | str, str, About]

#: The message that a process of each protocol starts with.
_FIRST_MESSAGE = {"DDS": "SPDP", "Zenoh": "Scout"}


def _answers(process: Process, endpoints: Sequence[Endpoint], sent: SentMessage) -> list[_Message]:
    """Return the answers of a process to a message."""
    other = sent.sender
    answers: list[_Message] = []
    if sent.kind == "SPDP":  # a new participant: announce all, ask what has arrived
        for topic in _TOPICS:
            answers += [(other, "SEDP", one) for one in endpoints if one.builtin_topic == topic]
            answers.append((other, "Heartbeat", topic))
    elif sent.kind == "Heartbeat":
        answers.append((other, "ACKNACK", sent.about))
    elif sent.kind == "Scout":
        answers.append((other, "Hello", ""))
    elif sent.kind == "Hello":  # open a session, declare all, keep it alive
        answers += [(other, "Declare", endpoint) for endpoint in endpoints]
        answers.append((other, "KeepAlive", Session(process)))
    elif sent.kind == "KeepAlive" and sent.about != Session(process):  # its session: answer
        answers.append((other, "KeepAlive", sent.about))
    return answers


def _processes_with_endpoints(hosts: Sequence[Sequence[int]]) -> dict[Process, list[Endpoint]]:
    """Return all processes with their endpoints, alternately of one topic and the other."""
    processes: dict[Process, list[Endpoint]] = {}
    for host, counts in enumerate(_as_sequence("hosts", hosts), start=1):
        for number, count in enumerate(_as_sequence(f"hosts[{host - 1}]", counts), start=1):
            if type(count) is not int or count < 0:
                name = f"hosts[{host - 1}][{number - 1}]"
                wanted = "a whole number of endpoints, at least 0"
                raise ValueError(f"{name} must be {wanted}; got {count!r}")
            process, topics = Process(host, number), islice(cycle(_TOPICS), count)
            endpoints = (Endpoint(process, *named) for named in enumerate(topics, start=1))
            processes[process] = list(endpoints)
    return processes


def _as_sequence(name: str, value: Any) -> Iterable[Any]:
    if isinstance(value, str) or not isinstance(value, Iterable):
        raise TypeError(f"{name} must be a sequence; got {value!r}")
    return value


def enumerate_messages(protocol: str, hosts: Sequence[Sequence[int]]) -> Iterator[SentMessage]:
    """Yield every message of the discovery among hosts, first up and then down.

    Receivers of a message answer it, as Sec. III-B and III-C of the paper describe. `hosts` has
    the endpoints of each process of each host: ``[[N_E] * N_P] * N_H`` is the paper's swarm.

    Examples
    --------
    >>> for sent in enumerate_messages("Zenoh", [[0], [0]]):
    ...     if sent.hop == "up":
    ...         print(f"{sent.kind} from {sent.sender} to {sent.receiver}")
    Scout from host 1 process 1 to everyone
    Scout from host 2 process 1 to everyone
    Hello from host 2 process 1 to host 1 process 1
    Hello from host 1 process 1 to host 2 process 1
    KeepAlive from host 1 process 1 to host 2 process 1
    KeepAlive from host 2 process 1 to host 1 process 1
    KeepAlive from host 2 process 1 to host 1 process 1
    KeepAlive from host 1 process 1 to host 2 process 1
    """
    if protocol not in _FIRST_MESSAGE:
        known = " or ".join(map(repr, _FIRST_MESSAGE))
        raise ValueError(f"protocol must be {known}; got {protocol!r}")
    processes = _processes_with_endpoints(hosts)
    waiting: deque[tuple[Process, _Message]] = deque(
        (process, (EVERYONE, _FIRST_MESSAGE[protocol], "")) for process in processes
    )
    while waiting:
        sender, (receiver, kind, about) = waiting.popleft()
        yield SentMessage(sender, receiver, kind, about, "up")
        yield (down := SentMessage(sender, receiver, kind, about, "down"))
        others = (process for process in processes if process.host != sender.host)
        for process in [receiver] if isinstance(receiver, Process) else others:
            waiting += ((process, each) for each in _answers(process, processes[process], down))
