"""Decorators that compile the kernels with numba; no other module of the package imports numba."""

from typing import Any

import numba

#: Compile without reference counts, which would dominate the run time. Kernels create no arrays.
_OPTIONS: dict[str, Any] = {"nogil": True, "_nrt": False}
#: Compile without wrappers for Python and C, because only compiled functions call these kernels.
_INNER: dict[str, Any] = _OPTIONS | {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}

#: Compile a function for inlining into each of its callers.
inlined = numba.njit(**_INNER, forceinline=True)
#: Compile a function once for all its callers, which shortens compilation.
not_inlined = numba.njit(**_INNER)
#: Compile a function that Python calls, and cache the result on disk.
called_from_python = numba.njit(**_OPTIONS, cache=True)
