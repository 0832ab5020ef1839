"""Configuration files of each host of a fleet, by their paths on the host.

Texts are those of `discostorm.snippets`; the systemd units for them are in ``data/written``.
"""

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from discostorm import _names
from discostorm.data import data_path
from discostorm.fleet import Fleet, HostGroup
from discostorm.snippets import Snippet, set_start_window, shell_commands

#: Maximum number of hosts that get files [1].
MAX_HOSTS = 1000
#: Files on a host: environment variables, systemd settings of its programs, and the start delay.
VARIABLES_FILE = "etc/ros2_discovery.env"
START_FILE = "etc/systemd/system/robot.service.d/discovery.conf"
SLEEP_FILE = "etc/staggered_start.sh"
#: Time that systemd allows the start of a service by default [s].
_START_TIMEOUT = 90.0


@dataclass(frozen=True)
class HostFiles:
    """The files of a host, as texts by path, and its entries in the README."""

    name: str
    address: str
    description: str
    files: dict[str, str] = field(default_factory=dict)
    variables: dict[str, str] = field(default_factory=dict)

    @property
    def service_name(self) -> str:
        """Name of the systemd service of a server or router; empty for other hosts."""
        found = re.search(r"([\w-]+)\.service$", "\n".join(self.files), re.MULTILINE)
        return found[1] if found else ""

    def add(self, path: str, text: str) -> None:
        """Add a file; refuse a second text for its path."""
        if path in self.files:
            raise ValueError(f"/{path} gets two texts from these changes; write only one")
        self.files[path] = text

    def add_piece(self, piece: Snippet, text: str) -> None:
        """Add configuration of the host's programs."""
        self.variables.update(piece.environment(text))
        if piece.host == "start of each":
            self.add(SLEEP_FILE, text)
        elif piece.path:
            self.add(piece.path.lstrip("/"), text)

    def add_server(self, piece: Snippet, text: str, ros: str | None, place: int) -> None:
        """Add a server or router as a systemd service; ``place`` is the index of its command."""
        if piece.path:
            self.add(piece.path.lstrip("/"), text)
            command = piece.load[piece.load.rindex("(") + 1 : -1]
        else:
            command = shell_commands(text)[place]
        unit = "zenoh-router" if piece.path else "fast-dds-server"
        variables = piece.environment(text).items()
        service = _read_template("server.service").format(
            environment="".join(f"Environment={name}={value}\n" for name, value in variables),
            description=unit.replace("-", " "),
            ros=ros or "*",
            command=command,
        )
        self.add(f"etc/systemd/system/{unit}.service", service)

    def add_start(self, window: float) -> None:
        """Add the variables, and the unit that reads them and waits before the programs start."""
        if not self.variables and SLEEP_FILE not in self.files:
            return
        lines = [f"# {self.name}, {self.address}: {self.description}"]
        lines += [f'{name}="{value}"' for name, value in self.variables.items()]
        self.add(VARIABLES_FILE, "\n".join([*lines, ""]))
        waits = _read_template("staggered.conf").format(timeout=_START_TIMEOUT + window)
        self.add(START_FILE, _read_template("robot.conf") + waits * (SLEEP_FILE in self.files))


def _read_template(name: str) -> str:
    return data_path(f"written/{name}").read_text(encoding="utf-8")


def groups_by_host_name(fleet: Fleet) -> dict[str, HostGroup]:
    """Return the groups of all hosts, by names such as robot1."""
    if fleet.hosts() > MAX_HOSTS:
        raise ValueError(f"hosts must be at most {MAX_HOSTS:,}; got {fleet.hosts():,.10g}")
    counted, hosts = Counter[str](), {}
    for group in fleet.groups:
        words = re.findall(r"\w+", group.name.lower(), re.ASCII)
        name = "_".join(words).removesuffix("s") or "robot"
        for _ in range(int(group.hosts)):
            counted[name] += 1
            hosts[f"{name}{counted[name]}"] = group
    return hosts


def host_addresses(
    fleet: Fleet, groups: Mapping[str, HostGroup], pieces: Sequence[Snippet]
) -> tuple[dict[str, str], list[str]]:
    """Return the addresses of all hosts and servers by name, and the names of the servers."""
    servers = [p for p in pieces if p.host.startswith("server")]
    if any(piece.host == "server on a robot" for piece in servers):
        names = [name for name, group in groups.items() if not group.wired][:1]
    else:
        number = max((1 if p.path else len(shell_commands(p.text)) for p in servers), default=0)
        names = ["server"] if number == 1 else [f"server{n + 1}" for n in range(number)]
    addresses = {name: f"ADDRESS_OF_{name}" for name in dict.fromkeys((*names, *groups))}
    for name, address in fleet.addresses:
        if name not in (*addresses, "server", "server1", "server2"):
            like = _names.did_you_mean(name, addresses)
            raise ValueError(f"addresses must name hosts; got {name!r}{like}")
        addresses[name] = address
    return addresses, names


def host_configuration_files(
    fleet: Fleet, pieces: Sequence[Snippet], window: float = 0.0
) -> tuple[list[HostFiles], dict[str, str]]:
    """Return the files of all hosts and servers, and the pieces to merge by hand, by file name.

    The robots' programs start at random within the ``window`` [s].
    """
    groups = groups_by_host_name(fleet)
    addresses, names = host_addresses(fleet, groups, pieces)
    servers = [p for p in pieces if p.host.startswith("server")]
    runs = {
        name: f"{group.name or 'robot'}: {group.processes:g} processes with "
        f"{group.processes * group.endpoints:.0f} endpoints in all"
        for name, group in groups.items()
    }
    hosts = {n: HostFiles(n, at, runs.get(n, "the server")) for n, at in addresses.items()}
    listed, of_servers = ([addresses[name] for name in some] for some in (groups, names))
    most = max(9, *(int(group.processes) for group in fleet.groups))
    for piece in pieces:
        for place, name in enumerate(groups if piece.host.endswith("each") else ()):
            others = listed if piece.robots == "all" else listed[:place]
            text = piece.filled(of_servers, others).replace("Index>9<", f"Index>{most}<")
            if piece.host == "router of each":
                hosts[name].add_server(piece, text, fleet.ros, 0)
            else:
                hosts[name].add_piece(piece, set_start_window(text, window))
        for place, name in enumerate(names if piece in servers else ()):
            hosts[name].add_server(piece, piece.filled(of_servers, ()), fleet.ros, place)
    for name in groups:
        if fleet.domain is not None:
            hosts[name].variables["ROS_DOMAIN_ID"] = f"{fleet.domain:g}"
        hosts[name].add_start(window)
    by_hand = {p.file: p.filled(of_servers, listed) for p in pieces if p.host == "by hand"}
    return [host for host in hosts.values() if host.files], by_hand
