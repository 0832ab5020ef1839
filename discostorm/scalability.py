"""Gone since 0.3.0: whoever imports it is told what took its place."""

from discostorm._renamed import MODULES

raise ImportError(f"{__name__} is {MODULES[__name__.rpartition('.')[2]]} since 0.3.0")
