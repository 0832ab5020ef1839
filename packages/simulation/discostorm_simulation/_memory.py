"""How much memory there is for a run."""

import math
import os
from collections.abc import Iterator
from pathlib import Path

#: Of control groups, version 2 and 1: where they are, limit, what is used, and what part of that is
#: given back on demand (Linux, Documentation/admin-guide: cgroup-v2.rst, cgroup-v1/memory.rst).
_V2 = ("", "memory.max", "memory.current", "inactive_file")
_V1 = ("memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file")


def available(root: Path = Path("/")) -> float:
    """Return the memory that this process or its container still gets [MB], or infinity."""
    return max(0.0, min([_machine(root), *_groups(root)]) / 1e6)


def _machine(root: Path) -> float:
    try:
        lines = (root / "proc/meminfo").read_text(encoding="ascii").splitlines()
        (found,) = (line.split()[1] for line in lines if line.startswith("MemAvailable:"))
        return int(found) * 1024
    except (OSError, ValueError):
        pass
    try:  # of what is not Linux all that there is
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):
        return math.inf


def _groups(root: Path) -> Iterator[float]:
    """Yield what is left in the control groups of this process and in those around them [B]."""
    try:
        lines = (root / "proc/self/cgroup").read_text(encoding="utf-8").splitlines()
    except (OSError, ValueError):
        return
    for line in lines:
        _, controllers, own = line.split(":", 2)
        if controllers and "memory" not in controllers.split(","):
            continue
        place, *names = _V1 if controllers else _V2
        # In a container the path may be that outside of it, which is not there; its top is.
        path = Path(own.lstrip("/"))
        for group in (path, *path.parents):
            yield _left(root / "sys/fs/cgroup" / place / group, *names)


def _left(group: Path, limit: str, used: str, spare: str) -> float:
    try:
        most, now = (int((group / name).read_text(encoding="ascii")) for name in (limit, used))
        stat = (group / "memory.stat").read_text(encoding="ascii").splitlines()
    except (OSError, ValueError):  # none there, or the limit is "max"
        return math.inf
    return most - now + sum(int(line.split()[1]) for line in stat if line.split()[:1] == [spare])
