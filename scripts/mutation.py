"""Change the package in many small ways, one at a time, and see whether the tests notice.

The changes are those of Cosmic Ray. Each is tried in a process of its own, which starts with
the libraries loaded and imports the package anew, so that also what is computed on import
changes. What no test notices must be in tests/mutation_survivors.csv, with the reason why.
"""

import argparse
import csv
import difflib
import os
import resource
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, SourceFileLoader
from importlib.util import spec_from_file_location
from pathlib import Path
from types import CodeType, ModuleType

# Loaded here, once, as every test needs them.
import hypothesis  # noqa: F401
import matplotlib.pyplot as plt  # noqa: F401
import numpy as np  # noqa: F401
import pandas as pd  # noqa: F401
import pytest
import sympy as sp  # noqa: F401
from cosmic_ray.ast import get_ast
from cosmic_ray.mutating import MutationVisitor, mutate_code
from cosmic_ray.plugins import get_operator

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "discostorm"
SURVIVORS = ROOT / "tests" / "mutation_survivors.csv"
#: Not changed: what only shows things in the book, which executes it, or is data.
LEFT_OUT = {"__init__", "__main__", "_data", "notebook"}
#: The tests of the package alone.
TESTS = sorted(
    path.name
    for path in (ROOT / "tests").glob("test_*.py")
    if "pytestmark = pytest.mark.book" not in path.read_text(encoding="utf-8")
)
#: Where to look first for what notices a change, if not in the tests of the same name.
FIRST = {
    "_checks": ["bad_input", "model"],
    "_numeric": ["model", "bad_input"],
    "presets": ["wifi_standard", "model"],
    "notation": ["reference_tables", "model"],
    "wifi": ["wifi_standard", "model"],
}
#: Too slow to be run a thousand times, and others notice what they would.
SLOW = (
    "million_samples_take or loads_neither or same_bytes_twice or figures_shows"
    " or examples_that_run or installed_script"
)
OPERATORS = [
    "NumberReplacer",
    "ReplaceTrueWithFalse",
    "ReplaceFalseWithTrue",
    "ReplaceAndWithOr",
    "ReplaceOrWithAnd",
    "AddNot",
    "ExceptionReplacer",
    "ReplaceBreakWithContinue",
    "ReplaceContinueWithBreak",
    "ZeroIterationForLoop",
    "ReplaceUnaryOperator_Delete_Not",
    "ReplaceUnaryOperator_Delete_USub",
    *(
        f"ReplaceBinaryOperator_{change}"
        for change in ("Add_Sub", "Sub_Add", "Mul_Div", "Div_Mul", "Pow_Mul", "Mod_Mul")
    ),
    *(
        f"ReplaceComparisonOperator_{change}"
        for change in (
            *("Eq_NotEq", "NotEq_Eq", "Is_IsNot", "IsNot_Is"),
            *("Lt_LtE", "LtE_Lt", "Gt_GtE", "GtE_Gt", "Lt_GtE", "LtE_Gt", "Gt_LtE", "GtE_Lt"),
        )
    ),
]
#: Not changed, as nothing outside can differ: they guard or speed up the code itself.
INNER = ("strict=True", "slots=True", "if TYPE_CHECKING", "*,")
#: Occurrence of a change that is none.
NOWHERE = -1
KILLED, SURVIVED = 1, 0
SECONDS, BYTES = 120, 8 * 2**30


@dataclass(frozen=True)
class Mutant:
    """One small change of one module."""

    module: str
    operator: str
    occurrence: int

    @property
    def path(self) -> Path:
        """File of the module."""
        return PACKAGE / f"{self.module}.py"

    def source(self) -> str:
        """Return the module's changed text."""
        text = self.path.read_text(encoding="utf-8")
        if self.occurrence == NOWHERE:
            return text
        operator = get_operator(f"core/{self.operator}")()
        changed = mutate_code(text, operator, self.occurrence)
        assert isinstance(changed, str)
        return changed

    def lines(self) -> tuple[str, str]:
        """Return the lines that differ, before and after."""
        before = self.path.read_text(encoding="utf-8").splitlines()
        diff = list(difflib.unified_diff(before, self.source().splitlines(), n=0, lineterm=""))[2:]
        old, new = (
            " ".join(line[1:].strip() for line in diff if line.startswith(sign)) for sign in "-+"
        )
        return old, new

    def tests(self, stage: int) -> list[Path]:
        """Return the files of tests for the first stage, or all others."""
        first = [f"test_{name}.py" for name in FIRST.get(self.module, [self.module])]
        first = [name for name in first if name in TESTS] or ["test_model.py"]
        if stage == 1:
            return [self.path, *(ROOT / "tests" / name for name in first)]  # its own examples, too
        return [ROOT / "tests" / name for name in TESTS if name not in first]


def mutants(modules: Sequence[str]) -> Iterator[Mutant]:
    """Yield all changes of the modules."""
    for module in modules:
        tree = get_ast((PACKAGE / f"{module}.py").read_text(encoding="utf-8"))
        for operator in OPERATORS:
            counter = MutationVisitor(-1, get_operator(f"core/{operator}")())
            counter.walk(tree)
            for occurrence in range(counter._count):
                mutant = Mutant(module, operator, occurrence)
                before, after = mutant.lines()
                if not any(word in before and word not in after for word in INNER):
                    yield mutant


class Loader(SourceFileLoader):
    """Loads another text than that of the file."""

    text = ""

    def get_code(self, fullname: str) -> CodeType:  # noqa: ARG002
        """Compile the other text."""
        return compile(self.text, self.path, "exec", dont_inherit=True)


class Finder(MetaPathFinder):
    """Finds a changed module before Python finds the unchanged one."""

    def __init__(self, mutant: Mutant) -> None:
        self.mutant = mutant

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None,  # noqa: ARG002
        target: ModuleType | None = None,  # noqa: ARG002
    ) -> ModuleSpec | None:
        """Return how to load the changed module."""
        if fullname != f"discostorm.{self.mutant.module}":
            return None
        loader = Loader(fullname, str(self.mutant.path))
        loader.text = self.mutant.source()
        return spec_from_file_location(fullname, self.mutant.path, loader=loader)


def test(mutant: Mutant | None, files: Sequence[Path]) -> int:
    """Run tests of a mutant, or of the package as it is; return their exit status."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)
    sys.argv[1:] = []  # a module that takes itself for a command finds nothing to do
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    if mutant:
        sys.meta_path.insert(0, Finder(mutant))
    options = [
        "-x",
        "-q",
        "--assert=plain",
        "-k",
        f"not ({SLOW})",
        "-p",
        "no:cacheprovider",
        "-p",
        "no:nbval",
        "-o",
        "python_classes=",  # claims.Test is none of tests
    ]
    return pytest.main([*options, *map(str, files)])


def fork(mutant: Mutant | None, files: Sequence[Path]) -> int:
    """Start a process that tests a mutant; return its number."""
    child = os.fork()
    if child == 0:
        status = KILLED
        try:
            status = KILLED if test(mutant, files) else SURVIVED
        finally:
            os._exit(status)
    return child


def survivors(todo: list[Mutant]) -> list[Mutant]:
    """Test all mutants, a process for each core; return those that no test notices."""
    waiting = [(mutant, 1) for mutant in reversed(todo)]
    running: dict[int, tuple[Mutant, int]] = {}
    found: list[Mutant] = []
    done, start = 0, time.monotonic()
    while waiting or running:
        while waiting and len(running) < (os.cpu_count() or 1):
            mutant, stage = waiting.pop()
            running[fork(mutant, mutant.tests(stage))] = mutant, stage
        child, status = os.wait()
        mutant, stage = running.pop(child)
        if status == SURVIVED and stage == 1:
            waiting.append((mutant, 2))
            continue
        done += 1
        if status == SURVIVED:
            found.append(mutant)
            before, after = mutant.lines()
            print(f"survived: {mutant.module}\n  - {before}\n  + {after}", flush=True)
        if done % 50 == 0 or done == len(todo):
            minutes = (time.monotonic() - start) / 60
            print(f"[{done}/{len(todo)}] {len(found)} survived, {minutes:.0f} min", flush=True)
    return found


def main() -> int:
    """Test the mutants of the named modules, or of all."""
    modules = sorted({path.stem for path in PACKAGE.glob("*.py")} - LEFT_OUT)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("modules", nargs="*", choices=[*modules, []], metavar="MODULE")
    modules = parser.parse_args().modules or modules
    # A test that fails without a change would be taken for one that notices every change.
    everything = [PACKAGE, *(ROOT / "tests" / name for name in TESTS)]
    same = [Mutant(module, OPERATORS[0], NOWHERE) for module in modules]
    for mutant, files in ((None, everything), *((mutant, mutant.tests(1)) for mutant in same)):
        if os.waitpid(fork(mutant, files), 0)[1] != SURVIVED:
            where = mutant.module if mutant else "the package"
            sys.exit(f"mutation: the tests of {where} fail without any change; run `make test`")
    todo = list(mutants(modules))
    left = survivors(todo)
    found = {(mutant.module, *mutant.lines()) for mutant in left}
    with SURVIVORS.open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["module"] in modules]
    known = {(row["module"], row["before"], row["after"]) for row in rows if row["reason"]}
    share = 1 - len(left) / len(todo)
    print(f"{len(todo)} mutants, {share:.1%} killed (at least 90%), {len(left)} survived")
    for module, before, after in sorted(found - known):
        print(f"not in {SURVIVORS.name}: {module}\n  - {before}\n  + {after}")
    for module, before, after in sorted(known - found):
        print(f"in {SURVIVORS.name}, but noticed: {module}\n  - {before}\n  + {after}")
    return 0 if share >= 0.9 and found == known else 1


if __name__ == "__main__":
    sys.exit(main())
