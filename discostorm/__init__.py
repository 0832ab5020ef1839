"""Discovery traffic of ROS 2 middlewares on Wi-Fi: the model of the paper, executable."""

from typing import Any

import lazy_loader

from discostorm._renamed import MODULES, answer_imports

__version__ = "0.3.0"

# What is public is listed in __init__.pyi, which type checkers read as well. It is loaded when it
# is asked for, so that the command line can answer Ctrl-C before NumPy and SymPy are loaded.
_public, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


answer_imports()


def __getattr__(name: str) -> Any:
    if name in MODULES:
        raise AttributeError(f"discostorm.{name} is {MODULES[name]} since 0.3.0")
    return _public(name)
