"""Run the simulator's inner loop in wasmtime: `data/engine.wasm`, compiled from `kernels`."""

from functools import cache
from math import prod
from threading import Event
from time import monotonic
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm.data import data_path
from discostorm_simulation.state import LINE, MEMORY, OVER, CellState

try:
    import wasmtime
except ImportError as error:
    raise ImportError(
        "the simulator needs wasmtime, which exists for 64-bit Linux, macOS and Windows: pip "
        "install wasmtime",
        name="wasmtime",
    ) from error

#: The engine's maximum memory [MB], and the step by which its memory grows [B].
MAX_MEGABYTES, _PAGE = 2**32 / 1e6, 2**16
#: Interval between checks for a stop [s], and the number of steps before the first check.
_CHECK_INTERVAL, _FIRST_STEPS = 0.1, 10_000
#: Arrays that grow during a run. They lie behind all other arrays in memory.
_GROWING = ("pool", "events")


class Stopped(Exception):  # noqa: N818 - it is no error
    """The caller stopped a run before its end."""


@cache
def compile_engine(counted: bool = False) -> tuple[wasmtime.Engine, wasmtime.Module]:
    """Compile the engine for this machine; ``counted`` adds a slow counter of instructions."""
    config = wasmtime.Config()
    config.consume_fuel = counted
    engine = wasmtime.Engine(config)
    code = data_path("engine.wasm", "discostorm_simulation").read_bytes()
    return engine, wasmtime.Module(engine, code)


class LoadedCell:
    """A cell whose arrays lie in the engine's memory."""

    def __init__(self, cell: CellState, instructions: int | None = None) -> None:
        engine, module = compile_engine(instructions is not None)
        self.store = wasmtime.Store(engine)
        if instructions is not None:
            self.store.set_fuel(instructions)
        exports: Any = wasmtime.Instance(self.store, module, []).exports(self.store)
        self._memory, self._advance = exports["memory"], exports["advance"]
        self._table: int = exports["arrays"].value(self.store)
        self._top: int = exports["__heap_base"].value(self.store)
        arrays: dict[str, NDArray[Any]] = cell._asdict()
        self._places = {
            name: (self._allocate(array.nbytes), array.dtype, array.shape)
            for name, array in sorted(arrays.items(), key=lambda item: item[0] in _GROWING)
        }
        self._map_memory()
        for name, array in arrays.items():
            getattr(self.cell, name)[:] = array

    def advance(self, until: int, reserve: int, steps: int) -> bool:
        """Simulate a number of steps; return whether the run is over."""
        while (state := self._advance(self.store, until, reserve, steps)) == MEMORY:
            self._double_growing_arrays()
        return bool(state == OVER)

    def _allocate(self, octets: int) -> int:
        """Reserve memory for some octets and return its address; grow the memory if needed."""
        begin = -(-self._top // LINE) * LINE
        self._top = begin + octets
        more = self._top - self._memory.data_len(self.store)
        try:
            if more > 0:
                self._memory.grow(self.store, -(-more // _PAGE))
        except wasmtime.WasmtimeError as error:
            most = f"more than are free or the simulator's {MAX_MEGABYTES:.0f} MB"
            raise MemoryError(f"a run needs {self._top / 1e6:.0f} MB, {most}") from error
        return begin

    def _map_memory(self) -> None:
        """Map the engine's memory to NumPy arrays again, and pass their addresses to the engine."""
        memory = self._memory.get_buffer_ptr(self.store)
        memory.store = self.store  # keep the store: it frees the memory
        octets = np.frombuffer(memory, np.uint8)
        arrays, table = {}, []
        for name in CellState._fields:
            begin, kind, shape = self._places[name]
            count = prod(shape)
            array = octets[begin : begin + count * kind.itemsize].view(kind).reshape(shape)
            arrays[name] = array
            # Same layout as numba's: owner and parent are 0.
            table += [0, 0, count, kind.itemsize, begin, *shape, *array.strides]
        octets[self._table :].view(np.int64)[: len(table)] = table
        self.cell = CellState(**arrays)

    def _double_growing_arrays(self) -> None:
        """Double the arrays of waiting frames and events."""
        old = {name: getattr(self.cell, name).copy() for name in _GROWING}
        self._top = self._places[_GROWING[0]][0]
        for name, array in old.items():
            octets = 2 * array.nbytes
            self._places[name] = (self._allocate(octets), array.dtype, (2 * array.size,))
        self._map_memory()
        for name, array in old.items():
            grown = getattr(self.cell, name)
            grown[: array.size], grown[array.size :] = array, np.zeros((), array.dtype)
        state, pool, size = self.cell.state, self.cell.pool, old["pool"].size
        pool["next"][size:] = np.arange(size + 1, 2 * size + 1)
        pool["next"][-1] = state["free"][0]
        state["free"] = size
        state["spare"] += size


def run_to_end(cell: CellState, until: int, reserve: int, stop: Event | None = None) -> CellState:
    """Simulate a cell to the end of its run; raise `Stopped` soon after ``stop`` is set."""
    loaded, steps, begin = LoadedCell(cell), _FIRST_STEPS, monotonic()
    while not loaded.advance(until, reserve, steps):
        if stop is not None and stop.is_set():
            raise Stopped
        # Steps take longer with more stations, so choose their number for a tenth of a second.
        end = monotonic()
        steps = max(1, min(2 * steps, int(steps * _CHECK_INTERVAL / max(end - begin, 1e-6))))
        begin = end
    return loaded.cell
