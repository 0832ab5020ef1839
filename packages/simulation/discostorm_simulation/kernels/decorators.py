"""Decorators that compile the kernels with numba; no other module of the package imports numba."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Function = TypeVar("Function", bound=Callable[..., Any])

#: Compile without reference counts, which would dominate the run time. Kernels create no arrays.
_OPTIONS: dict[str, Any] = {"nogil": True, "_nrt": False}
#: Compile without wrappers for Python and C, because only compiled functions call these kernels.
_INNER: dict[str, Any] = _OPTIONS | {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def inlined(function: Function) -> Function:
    """Compile a function for inlining into each of its callers."""
    compiled: Function = numba.njit(**_INNER, forceinline=True)(function)
    return compiled


def not_inlined(function: Function) -> Function:
    """Compile a function once for all its callers, which shortens compilation."""
    compiled: Function = numba.njit(**_INNER)(function)
    return compiled


def called_from_python(function: Function) -> Function:
    """Compile a function that Python calls, and cache the result on disk."""
    compiled: Function = numba.njit(**_OPTIONS, cache=True)(function)
    return compiled
