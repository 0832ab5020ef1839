"""Discovery traffic of ROS 2 middlewares on Wi-Fi: the model of the paper, executable."""

import lazy_loader

__version__ = "0.2.0"

# What is public is listed in __init__.pyi, which type checkers read as well. It is loaded when it
# is asked for, so that the command line can answer Ctrl-C before NumPy and SymPy are loaded.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
