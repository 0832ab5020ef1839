"""Old names of 0.2.0: whoever still uses one is told the new one."""

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypeVar

#: What took the place of a module.
MODULES = {
    "notebook": "discostorm.book.notebook",
    "scalability": "discostorm.model, and saturation of it discostorm.saturation",
}

_P = ParamSpec("_P")
_R = TypeVar("_R")


def renamed(**gone: str) -> Callable[[Callable[_P, _R]], Callable[_P, _R]]:
    """Let a function refuse parameters that it had in 0.2.0, and say what took their place."""

    def decorated(function: Callable[_P, _R]) -> Callable[_P, _R]:
        @wraps(function)
        def checked(*args: _P.args, **kwargs: _P.kwargs) -> _R:
            for name in gone.keys() & kwargs.keys():
                raise TypeError(
                    f"{function.__name__} has no parameter {name!r} since 0.3.0; use {gone[name]}"
                )
            return function(*args, **kwargs)

        return checked

    return decorated
