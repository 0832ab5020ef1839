"""How numba compiles the kernels; nothing else of the package needs numba."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

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
    """Compile a function that Python calls, and keep it on disk."""
    compiled: Function = numba.njit(**_OPTIONS, cache=True)(function)
    return compiled
