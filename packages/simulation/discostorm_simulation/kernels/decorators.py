"""How the inner loops are compiled: to machine code that is kept on disk."""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeVar

try:
    import numba
    from numba.core import event
except ImportError as error:
    raise ImportError(
        "discostorm_simulation needs numba; to get it: pip install 'discostorm[simulation]'",
        name="numba",
    ) from error

Function = TypeVar("Function", bound=Callable[..., Any])


#: Without reference counts (nothing here makes an array), which would cost more than all else.
_OPTIONS: dict[str, Any] = {"nogil": True, "_nrt": False}
#: Of what only other compiled functions call: without the code by which Python and C would.
_INNER: dict[str, Any] = _OPTIONS | {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def njit(function: Function) -> Function:
    """Compile a function that becomes part of each that calls it."""
    compiled: Function = numba.njit(**_INNER, forceinline=True)(function)
    return compiled


def shared(function: Function) -> Function:
    """Compile a function that many call: once, so that compiling does not take too long."""
    compiled: Function = numba.njit(**_INNER)(function)
    return compiled


def entry(function: Function) -> Function:
    """Compile a function that Python calls and keep it on disk, if anywhere."""
    try:
        options: dict[str, Any] = _OPTIONS | {"cache": True}
        compiled: Function = numba.njit(**options)(function)
    except RuntimeError:  # nowhere to write
        compiled = numba.njit(**_OPTIONS)(function)
    return compiled


def keeps(function: Any) -> bool:
    """Return whether what is compiled of an `entry` can be written to disk."""
    folder = function.stats.cache_path
    return folder is not None and os.access(folder, os.W_OK)


#: What is said of what was compiled.
_KEPT = "kept when all of it is done ..."
_NOT_KEPT = "not kept, as no folder for it can be written; NUMBA_CACHE_DIR may name one ..."


class _Parts(event.Listener):
    """Counts the parts that are compiled; of what is loaded from disk numba does not tell it."""

    def __init__(self, say: Callable[[str], None], kept: bool) -> None:
        self.say, self.kept, self.bar = say, kept, None

    def on_start(self, _: Any) -> None:
        from tqdm import tqdm

        if self.bar is None:
            self.say(
                f"compiling the simulator, {'once on a machine' if self.kept else 'each time'}: "
                "about a minute of a core of its own, longer beside others; "
                + (_KEPT if self.kept else _NOT_KEPT)
            )
            self.bar = tqdm(desc="compiling", unit=" parts", mininterval=1.0)

    def on_end(self, _: Any) -> None:
        if self.bar is not None:
            self.bar.update()


@contextmanager
def shown(say: Callable[[str], None], kept: bool) -> Iterator[None]:
    """Say so if something is compiled meanwhile, and whether it is kept; count its parts."""
    parts = _Parts(say, kept)
    try:
        with event.install_listener("numba:compile", parts):
            yield
    finally:
        if parts.bar is not None:
            parts.bar.close()


@cache
def sources() -> str:
    """Return a digest of all that is compiled: other sources must not use old machine code."""
    texts = (file.read_bytes() for file in sorted(Path(__file__).parent.glob("*.py")))
    return sha256(b"".join(text for text in texts if b"_compile import" in text)).hexdigest()
