"""Measure the speed that the project promises, and compare it with the limits.

Ratios are medians of several rounds; in each round both sides run one after the other, so
that what else the machine does touches both.
"""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np
from numpy.typing import NDArray

import discostorm as ds

ROOT = Path(__file__).parents[1]

Floats = NDArray[np.float64]


def seconds(action: Callable[[], object]) -> float:
    """Return how long an action takes."""
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


def ratio(first: Callable[[], object], second: Callable[[], object], rounds: int) -> float:
    """Return how many times as long as the second the first takes: the median of rounds."""
    first()
    second()
    return median(seconds(first) / seconds(second) for _ in range(rounds))


def by_hand(hosts: Floats, processes: Floats, endpoints: Floats) -> Floats:
    """Return the utilization of DDS, written for NumPy by hand, as short as it goes."""
    up = 8 / 144.4e6
    process = 414 * up + 180e-6 + 414 * 8 / 6e6 + 120e-6
    pair = 2 * (2 * (116 + 114) * up + 4 * 180e-6)
    endpoint = 2 * (464 * up + 180e-6)
    remote = (hosts - 1) * processes
    result: Floats = hosts * processes * (process + remote * (pair + endpoints * endpoint))
    return result


def utilization() -> float:
    """Compare utilization on a grid of 10^6 points with the closed form by hand."""
    grid = np.meshgrid(np.arange(1.0, 101), np.arange(1.0, 101), np.arange(100.0))
    hosts, processes, endpoints = (axis.ravel() for axis in grid)
    assert np.allclose(
        ds.utilization(ds.DDS, hosts, processes, endpoints),
        by_hand(hosts, processes, endpoints),
        rtol=1e-12,  # as both round each of some ten operations
        atol=0,
    )
    return ratio(
        lambda: ds.utilization(ds.DDS, hosts, processes, endpoints),
        lambda: by_hand(hosts, processes, endpoints),
        rounds=41,
    )


def run(*command: str) -> None:
    """Run a command in the project; show its output only if it fails."""
    env = {name: value for name, value in os.environ.items() if name not in LEFT_OUT}
    done = subprocess.run(command, cwd=ROOT, env=env, text=True, capture_output=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")


#: The make that started this would have another wait for its jobs; and the package is compiled
#: when first imported, as its libraries were when installed.
LEFT_OUT = {"MAKEFLAGS", "MAKELEVEL", "MFLAGS", "PYTHONDONTWRITEBYTECODE"}


def import_time() -> float:
    """Compare importing discostorm with importing sympy, each in a fresh process."""
    return ratio(
        lambda: run(sys.executable, "-c", "import discostorm"),
        lambda: run(sys.executable, "-c", "import sympy"),
        rounds=7,
    )


#: What is measured, how, the limit and its unit.
MEASURES: list[tuple[str, Callable[[], float], float, str]] = [
    ("utilization on 10^6 points / the same by hand", utilization, 1.2, ""),
    ("import discostorm / import sympy", import_time, 1.5, ""),
    ("clean book build (make book)", lambda: seconds(lambda: run("make", "book")), 60, " s"),
    ("whole test suite (make test)", lambda: seconds(lambda: run("make", "test")), 150, " s"),
]


def main() -> int:
    """Print each measure with its limit; return 1 if one is exceeded."""
    width = max(len(name) for name, *_ in MEASURES)
    print(f"{'':{width}}  {'measured':>9}  {'at most':>9}")
    exceeded = 0
    for name, measure, limit, unit in MEASURES:
        print(f"{name:{width}}  ", end="", flush=True)
        value = measure()
        exceeded += value > limit
        verdict = "pass" if value <= limit else "FAIL"
        print(f"{f'{value:.2f}{unit}':>9}  {f'{limit:g}{unit}':>9}  {verdict}", flush=True)
    return 1 if exceeded else 0


if __name__ == "__main__":
    sys.exit(main())
