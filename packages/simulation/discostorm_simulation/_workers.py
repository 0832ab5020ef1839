"""Processes for runs side by side; they end soon after the one that started them, in any way."""

import os
import threading
import time
from typing import Any

try:
    from joblib import cpu_count
    from joblib.parallel import LokyBackend, get_active_backend
except ImportError as error:
    raise ImportError(
        "discostorm_simulation needs joblib; to get it: pip install 'discostorm[simulation]'",
        name="joblib",
    ) from error

#: How often a process looks whether the one that started it is still there [s].
_LOOK = 0.5


def jobs(most: int) -> dict[str, Any]:
    """Return how many jobs go side by side: what the user says, or as many as can and fit."""
    active, number = get_active_backend()
    if number not in (None, 1):
        return {}
    own = {"backend": _Watched()} if type(active) is LokyBackend else {}
    return {"n_jobs": min(cpu_count(), most)} | own


class _Watched(LokyBackend):  # type: ignore[misc]
    """Processes of joblib's own kind; by themselves these wait for minutes for what comes next."""

    def configure(self, *args: Any, **given: Any) -> Any:
        """Start the processes; each watches this one from then on."""
        own = {"initializer": _watch, "initargs": (os.getpid(),)}
        return super().configure(*args, **given, **own)


def _watch(parent: int) -> None:
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: int) -> None:
    """End this process when its parent has; a process without one gets another parent (POSIX)."""
    while os.getppid() == parent:
        time.sleep(_LOOK)
    os._exit(1)
