"""The folder of ``discostorm plan --write``: files for each host, and a README."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import replace

from discostorm import wording
from discostorm.data import data_path
from discostorm.fleet import Fleet
from discostorm.fleet_file import MAX_DOMAIN
from discostorm.host_configuration_files import (
    MAX_HOSTS,
    SLEEP_FILE,
    START_FILE,
    HostFiles,
    groups_by_host_name,
    host_addresses,
    host_configuration_files,
)
from discostorm.snippets import set_start_window
from discostorm_planner.change_simulation import remedy_start_window
from discostorm_planner.fleet_changes import hosts_in_words
from discostorm_planner.remedy import Remedy

#: The sample nodes of a launch file.
_SAMPLE_NODES = re.compile(r"( +ComposableNode\(package.*\),\n)+")
#: The line of a sample domain.
_SAMPLE_DOMAIN = re.compile(r"^export ROS_DOMAIN_ID=\d+$", re.MULTILINE)


def configuration_texts(fleet: Fleet, remedy: Remedy, within: float) -> list[str]:
    """Return the configuration texts of a change, with the fleet's addresses, groups and window."""
    texts = [piece.text for piece in remedy.snippets]
    if fleet.hosts() <= MAX_HOSTS:
        names = groups_by_host_name(fleet)
        addresses, servers = host_addresses(fleet, names, remedy.snippets)
        filled = [addresses[name] for name in servers], [addresses[name] for name in names]
        texts = [piece.filled(*filled) for piece in remedy.snippets]
    texts = ["\n".join(_launch_file_texts(fleet, text)) or text for text in texts]
    texts = [_SAMPLE_DOMAIN.sub("\n".join(_domain_lines(fleet, remedy)), text) for text in texts]
    window = remedy_start_window(remedy, within)
    return [set_start_window(text, window) if window else text for text in texts]


def _launch_file_texts(fleet: Fleet, text: str) -> Iterator[str]:
    """Yield a launch file for each group of several processes, with a line for each node."""
    for name, group in zip(fleet.names, fleet.groups, strict=True):
        if group.processes > 1 and _SAMPLE_NODES.search(text):
            count = round(group.processes * max(1, group.nodes or 1))
            node = 'ComposableNode(package="PACKAGE{0}", plugin="PLUGIN{0}", name="NAME{0}")'
            lines = [f"        {node.format(n)},\n" for n in range(1, count + 1)]
            head = (
                f'# Group "{name}": {wording.count_noun(group.hosts, "host")}, each with '
                f"{group.processes:,.10g} processes of {group.endpoints:.3g} endpoints on average\n"
                "# Fill in PACKAGE, PLUGIN and NAME of each node, and delete surplus lines; "
                "`ros2 component types` lists packages and plugins\n"
            )
            yield head + _SAMPLE_NODES.sub("".join(lines), text)


def _domain_lines(fleet: Fleet, remedy: Remedy) -> Iterator[str]:
    """Yield a line for the domain of each part, below the names or numbers of its hosts."""
    count = len(remedy.fleets)
    first = min(1 if fleet.domain is None else fleet.domain, MAX_DOMAIN + 1 - count)
    for place, part in enumerate(remedy.fleets):
        hosts = [hosts_in_words(group.hosts, group.name or "hosts") for group in part.groups]
        if fleet.hosts() <= MAX_HOSTS:  # they are dealt in turn
            hosts = [*groups_by_host_name(fleet)][place::count]
        domain = f"export ROS_DOMAIN_ID={first + place:g}"
        yield f"# Part {place + 1}: {wording.join_words(hosts)}\n{domain}"


def texts_by_path(fleet: Fleet, remedy: Remedy, within: float) -> dict[str, str]:
    """Return the texts of all files for a change, by path in the folder."""
    pasted = configuration_texts(fleet, remedy, within)
    fleet = replace(fleet, domain=None) if "domains" in remedy.steps else fleet
    window = remedy_start_window(remedy, within)
    hosts, by_hand = host_configuration_files(fleet, remedy.snippets, window)
    texts = {f"{host.name}/{path}": text for host in hosts for path, text in host.files.items()}
    pieces = zip(remedy.snippets, pasted, strict=True)
    texts |= {f"by_hand/{piece.file}": text for piece, text in pieces if piece.file in by_hand}
    words = [hosts_in_words(group.hosts, group.name or "robots") for group in fleet.groups]
    title = f"{wording.capitalized(remedy.what)}: {wording.join_words(words)}"
    merged = [piece for piece in remedy.snippets if piece.file in by_hand]
    left = [f"| `{piece.file}` | {piece.where} | {piece.load} |\n" for piece in merged]
    how = tomllib.loads(_template("by_hand.toml"))
    left += [f"\n{how[step]}" for step in remedy.steps if step in how]
    return {"README.md": _readme_text(title, hosts, "".join(left))} | texts


def _readme_text(title: str, hosts: Sequence[HostFiles], by_hand: str) -> str:
    """Return the README: which files to copy where, how to check them, how to go back."""
    unknown = [host.name for host in hosts if host.address == f"ADDRESS_OF_{host.name}"]
    names = "\n".join(f"- `ADDRESS_OF_{name}`" for name in unknown)
    steps: dict[str, list[str]] = {}
    for host in hosts:
        steps.setdefault(_host_instructions(host), []).append(f"`{host.name}`")
    parts = {
        "copy": "\n".join(f"| `{h.name}` | {h.address} | {h.description} |" for h in hosts),
        "addresses": f"{names}\n\n```\n[addresses]\n{unknown[0]} = " if unknown else "",
        "robots": "`robot`" if any(START_FILE in host.files for host in hosts) else "",
        "by_hand": by_hand,
    }
    shown = {n: _template(f"{n}.md").format(text=text) if text else "" for n, text in parts.items()}
    on_hosts = [f"## On {wording.join_words(on)}\n\n{text}" for text, on in steps.items()]
    return _template("README.md").format(title=title, steps="".join(on_hosts), **shown)


def _template(name: str) -> str:
    return data_path(f"written/{name}", "discostorm_planner").read_text(encoding="utf-8")


def _host_instructions(host: HostFiles) -> str:
    """Return a host's instructions: how to start its services, check them, and go back."""
    service, variables, files = host.service_name, host.variables, host.files
    values = {
        "enable": f"sudo systemctl enable --now {service}\n" * bool(service),
        "disable": f"sudo systemctl disable --now {service}\n" * bool(service),
        "restart": "sudo systemctl restart robot\n" * (START_FILE in files),
        "names": "|".join(sorted(variables)),
        "lines": "\n".join(sorted(f"{name}={value}" for name, value in variables.items())),
        "sleep": SLEEP_FILE,
        "files": " ".join(f"/{path}" for path in files),
    }
    staggered = SLEEP_FILE in files
    shown = {"start": True, service: service, "variables": variables, "staggered": staggered}
    texts = tomllib.loads(_template("host_readme.toml"))
    parts = [*(part for part, wanted in shown.items() if wanted), "back"]
    return "".join(texts[part].format(**values) for part in parts)
