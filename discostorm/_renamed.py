"""Old names of 0.2.0: whoever still uses one is told the new one.

What is gone stands in these tables only, and in the CHANGELOG's table of old and new names.
"""

import sys
from collections.abc import Callable, Sequence
from functools import wraps
from importlib.abc import MetaPathFinder
from types import ModuleType
from typing import ParamSpec, TypeVar

_TABLES = "discostorm.protocols.PROTOCOLS[name]"

#: What took the place of a module.
MODULES = {
    "capture.reader": "discostorm.capture.read",
    "notebook": "discostorm.book.notebook",
    "paper.ladder": "discostorm.book.ladder",
    "paper.storm": "discostorm.book.storm",
    "planner.search": "discostorm.planner.plan",
    "protocols.cyclone_dds": _TABLES,
    "protocols.cyclone_peers": _TABLES,
    "protocols.discovery_server": _TABLES,
    "protocols.fast_dds": _TABLES,
    "protocols.static_endpoints": _TABLES,
    "protocols.zenoh_peer": _TABLES,
    "protocols.zenoh_router": _TABLES,
    "scalability": "discostorm.model, and saturation of it discostorm.saturation",
    "simulation.channel": "lab/hybrid/channel.py of the source",
    "simulation.hybrid": "lab/hybrid/ of the source",
    "simulation.speaker": "lab/hybrid/speaker.py of the source",
}

#: Units that had a name of their own, and the method of Fleet that counted each.
UNITS = {
    "ENDPOINT_AWAY": ("endpoints_away", "endpoint away from the server"),
    "ENDPOINT_HOST": ("endpoint_hosts", "endpoint and other host"),
    "ENDPOINT_PROCESS": ("endpoint_processes", "endpoint and other process"),
    "ENDPOINT_THIRD": ("endpoint_thirds", "endpoint, process on another host and third process"),
    "FLOOD": ("floods", "end of a link, host that hears of it and other that it tells"),
    "LISTED": ("lists", "two endpoints of a process, or one twice"),
    "LISTED_PAIR": (
        "list_pairs",
        "two endpoints of a process, or one twice, and process on another host",
    ),
    "MATCHED_ENDPOINT": ("matched_endpoints", "matched endpoint and other process"),
    "MATCHED_ENDPOINT_AWAY": (
        "matched_endpoints_away",
        "matched endpoint and other process away from the server",
    ),
    "MATCHED_HOST": ("matched_hosts", "matched endpoint of a host and other host"),
    "MATCHED_PAIR": ("matched_pairs", "ordered pair of matched processes on different hosts"),
    "MATCHED_PROCESS_PAIR": ("matched_process_pairs", "ordered pair of matched processes"),
    "MATCHED_PROCESS_PAIR_AWAY": (
        "matched_process_pairs_away",
        "ordered pair of matched processes, one away from the server",
    ),
    "PROCESS_HOST": ("process_hosts", "process and other host"),
    "PROCESS_PAIR": ("process_pairs", "ordered pair of processes"),
    "THIRD": ("thirds", "ordered pair of processes on different hosts and third process"),
    "UNMATCHED_ENDPOINT": ("unmatched_endpoints", "unmatched endpoint"),
    "UNMATCHED_HOST": ("unmatched_hosts", "unmatched endpoint and other host"),
    "WRITER": ("writers_that_match", "matched writer"),
}
_UNITS = {name: f"discostorm.messages.UNITS[{unit!r}]" for name, (_, unit) in UNITS.items()}

#: What took the place of a name, by module.
NAMES = {
    "capture.result": {"read_capture": "discostorm.capture.read_capture"},
    "fleet": {
        "Hosts": "discostorm.messages.Hosts",
        "as_fleet": "discostorm._arguments.as_fleet",
        "parameter_service_endpoints": "discostorm.ros2.parameter_service_endpoints",
        "reject_symbols": "discostorm._arguments.reject_symbols",
        "shared_endpoints": "discostorm.robots.shared_endpoints",
    },
    "measured": {
        **{
            name: f"discostorm.book.comparison.{name}"
            for name in (
                *("WITHIN_ARRANGED", "WITHIN_KIND", "WITHIN_PHASE"),
                *("expected", "held", "held_hybrid", "misses", "times"),
            )
        },
        **{
            name: f"discostorm.book.literature.{name}" for name in ("AROUND", "published", "staged")
        },
        "largest": "discostorm.protocols.PROTOCOLS[name].captured",
    },
    "messages": _UNITS | {"OfProcesses": "discostorm.messages.Unit.senders"},
    "messages.units": _UNITS,
    "paper.criteria": {
        "Criterion": "discostorm.paper.criteria.Test",
        "value_of": "discostorm.paper.predicates",
    },
    "paper.quantities": {"QUANTITIES": "discostorm.paper.predicates"},
    "planner.known": {
        "family": "discostorm.messages.Protocol.family",
        "product": "discostorm.messages.Protocol.product",
    },
    "simulation.run": {
        "Plan": "discostorm.simulation.run.Setup",
        "plan_runs": "discostorm.simulation.run.set_up",
    },
    "wifi.channel": {"Wifi": "discostorm.wifi.Wifi"},
}

#: What took the place of methods of Fleet.
OF_FLEET = {method: f"{_UNITS[name]}.count(fleet)" for name, (method, _) in UNITS.items()} | {
    "away": "discostorm.messages.UNITS['process away from the server'].count(fleet)",
    "endpoint_pairs": "discostorm.ENDPOINT_PAIR.count(fleet)",
    "endpoints": "discostorm.messages.ENDPOINT.count(fleet)",
    "host_pairs": "discostorm.messages.HOST_PAIR.count(fleet)",
    "kinds_endpoints": "discostorm.messages.KIND_ENDPOINT.count(fleet)",
    "matched": "discostorm.messages.Unit('matched endpoint').count(fleet)",
    "matched_writers": "discostorm.messages.MATCHED_WRITER.count(fleet)",
    "once": "discostorm.messages.FLEET.count(fleet)",
    "pairs": "discostorm.PAIR.count(fleet)",
    "unmatched": "discostorm.messages.UNMATCHED.count(fleet)",
    "without": "discostorm.model.without_each",
}

_P = ParamSpec("_P")
_R = TypeVar("_R")
_C = TypeVar("_C", bound=type)


def renamed(**gone: str) -> Callable[[Callable[_P, _R]], Callable[_P, _R]]:
    """Let a function refuse parameters that it had in 0.2.0, and say what took their place."""

    def decorated(function: Callable[_P, _R]) -> Callable[_P, _R]:
        called = function.__qualname__.removesuffix(".__init__")

        @wraps(function)
        def checked(*args: _P.args, **kwargs: _P.kwargs) -> _R:
            for name in gone.keys() & kwargs.keys():
                raise TypeError(f"{called} has no parameter {name!r} since 0.3.0; use {gone[name]}")
            return function(*args, **kwargs)

        return checked

    return decorated


def renamed_fields(**gone: str) -> Callable[[_C], _C]:
    """Let a class refuse parameters that it had in 0.2.0, and say what took their place."""

    def decorated(cls: _C) -> _C:
        setattr(cls, "__init__", renamed(**gone)(getattr(cls, "__init__")))  # noqa: B009, B010
        return cls

    return decorated


def renamed_members(gone: dict[str, str]) -> Callable[[_C], _C]:
    """Let a class answer members that it had in 0.2.0 by what took their place."""

    def decorated(cls: _C) -> _C:
        def absent(self: object, name: str) -> object:
            kind = type(self).__name__
            if name in gone:
                raise AttributeError(
                    f"{kind} has no {name!r} since 0.3.0; use {gone[name]}", name=name, obj=self
                )
            raise AttributeError(f"{kind!r} object has no attribute {name!r}", name=name, obj=self)

        # Set, not defined, so that type checkers still refuse what is not there.
        setattr(cls, "__getattr__", absent)  # noqa: B010
        return cls

    return decorated


def answer(module: str) -> None:
    """Let a module, which calls this by its name, answer names that it had in 0.2.0.

    By an ImportError: of an AttributeError the statement ``from module import name`` keeps no word.
    """
    gone = NAMES[module.removeprefix("discostorm.")]

    def absent(name: str) -> object:
        if name in gone:
            raise ImportError(f"{module}.{name} is {gone[name]} since 0.3.0", name=module)
        raise AttributeError(f"module {module!r} has no attribute {name!r}", name=name)

    # Set, not defined, so that type checkers still refuse what is not there.
    setattr(sys.modules[module], "__getattr__", absent)  # noqa: B010


class _Gone(MetaPathFinder):
    """Answers imports of modules that 0.2.0 had, after all others have found nothing."""

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None,  # noqa: ARG002
        target: ModuleType | None = None,  # noqa: ARG002
    ) -> None:
        """Find nothing, and say what took the place of a module that is gone."""
        package, _, name = fullname.partition(".")
        if package == "discostorm" and name in MODULES:
            raise ImportError(f"{fullname} is {MODULES[name]} since 0.3.0", name=fullname)


def answer_imports() -> None:
    """Let imports of modules that are gone say what took their place."""
    if not any(type(finder).__name__ == _Gone.__name__ for finder in sys.meta_path):
        sys.meta_path.append(_Gone())
