"""The memory that a run may use."""

import math
import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

#: Control groups, versions 2 and 1. Fields: folder, limit, memory in use, and the reclaimable part
#: of the memory in use (Linux, Documentation/admin-guide: cgroup-v2.rst, cgroup-v1/memory.rst).
_CGROUP_V2 = ("", "memory.max", "memory.current", "inactive_file")
_CGROUP_V1 = ("memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file")


def available_megabytes(root: Path = Path("/")) -> float:
    """Return the memory that this process or its container may still use [MB], or infinity."""
    return max(0.0, min([_free_machine_memory(root), *_free_in_control_groups(root)]) / 1e6)


def _free_machine_memory(root: Path) -> float:
    with suppress(OSError, ValueError):
        lines = (root / "proc/meminfo").read_text(encoding="ascii").splitlines()
        (found,) = (line.split()[1] for line in lines if line.startswith("MemAvailable:"))
        return int(found) * 1024
    with suppress(AttributeError, OSError, ValueError):  # the only source outside of Linux
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return math.inf


def _free_in_control_groups(root: Path) -> Iterator[float]:
    """Yield the free memory [B] in the control group of this process and in each of its parents."""
    try:
        lines = (root / "proc/self/cgroup").read_text(encoding="utf-8").splitlines()
    except (OSError, ValueError):
        return
    for line in lines:
        _, controllers, own = line.split(":", 2)
        if controllers and "memory" not in controllers.split(","):
            continue
        place, *names = _CGROUP_V1 if controllers else _CGROUP_V2
        # Inside a container, the path may be the host's and not exist. Its topmost folder exists.
        path = Path(own.lstrip("/"))
        for group in (path, *path.parents):
            yield _free_in_group(root / "sys/fs/cgroup" / place / group, *names)


def _free_in_group(group: Path, limit: str, used: str, spare: str) -> float:
    try:
        most, now = (int((group / name).read_text(encoding="ascii")) for name in (limit, used))
        stat = (group / "memory.stat").read_text(encoding="ascii").splitlines()
    except (OSError, ValueError):  # there is no such group, or its limit is "max"
        return math.inf
    return most - now + sum(int(line.split()[1]) for line in stat if line.split()[:1] == [spare])
