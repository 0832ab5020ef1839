"""Compile the simulator's inner loop to WebAssembly: numba's LLVM IR, llvmlite, and LLVM's linker.

It is the IR of `discostorm_simulation.engine.advance` for a processor without anything special, so
that every machine makes the same. LLVM optimizes it anew for size, for wasm32, and `wasm-ld` links
it: the same versions of numba, llvmlite and lld give the same bytes.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

#: LLVM's release whose linker the committed file was made with, as Debian names its package.
LLD = 14
#: The linker: Debian's name of that release, or the newest.
LINKERS = (f"wasm-ld-{LLD}", "wasm-ld")
#: What is exported beside the memory: the loop, and where a page may put its arrays.
NAME, FREE = "advance", "__heap_base"

TRIPLE = "wasm32-unknown-unknown"
#: Filling memory is one instruction (in all browsers since 2021) instead of a function to import.
FEATURES = "+bulk-memory"

#: Compile the loop and write its IR. What is called inside becomes functions, which LLVM
#: inlines where that is worth it: a third of the code, as fast in a browser.
_IR = """
import sys
from pathlib import Path
import discostorm_simulation._compile as how

how.njit = how.shared
from discostorm_simulation.engine import advance
from discostorm_simulation.run import compiled

compiled()
(signature,) = advance.signatures
Path(sys.argv[1]).write_text(advance.inspect_llvm(signature), encoding="utf-8")
"""


def linker() -> str | None:
    """Return the program that links WebAssembly, if there is one."""
    return next(filter(None, map(shutil.which, LINKERS)), None)


def linker_release() -> int | None:
    """Return the release of the linker, such as 14."""
    program = linker()
    if program is None:
        return None
    told = subprocess.run([program, "--version"], check=True, capture_output=True, text=True)
    found = re.search(r"LLD (\d+)", told.stdout)
    return int(found[1]) if found else None


def made_with() -> str:
    """Return which versions decide the bytes."""
    return f"numba {version('numba')}, llvmlite {version('llvmlite')}, lld {linker_release()}"


def head() -> str:
    """Return the first lines of the committed file: what it was made with, and of which sources."""
    from discostorm_simulation._compile import sources

    return (
        "// The simulator's inner loop, discostorm_simulation/engine.py, as WebAssembly; made by "
        f"`make live`; do not edit.\n// {made_with()}; sources {sources()}\n"
    )


def _ir(folder: Path) -> str:
    """Return the loop's IR for a generic processor."""
    target = folder / "advance.ll"
    generic = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
    environment = os.environ | generic | {"NUMBA_CACHE_DIR": str(folder)}
    subprocess.run([sys.executable, "-c", _IR, str(target)], check=True, env=environment)
    return target.read_text(encoding="utf-8")


def _for_wasm(ir: str, layout: str) -> str:
    """Return IR with the target's layout instead of this machine's, to be made small."""
    ir = re.sub(r'target datalayout = "[^"]*"', f'target datalayout = "{layout}"', ir)
    ir = re.sub(r'target triple = "[^"]*"', f'target triple = "{TRIPLE}"', ir)
    ir = re.sub(r'"(target-cpu|target-features|tune-cpu)"="[^"]*"', "", ir)
    # WebAssembly has no common symbols.
    ir = ir.replace("= common ", "= weak ")
    return re.sub(r"(?m)^(attributes #\d+ = \{)", r"\1 minsize optsize", ir)


def _object(ir: str) -> bytes:
    """Return the loop as an object file of WebAssembly."""
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple(TRIPLE)
    machine = target.create_target_machine(opt=2, cpu="mvp", features=FEATURES)
    module = llvm.parse_assembly(_for_wasm(ir, str(machine.target_data)))
    module.verify()
    defined = [function for function in module.functions if not function.is_declaration]
    # Others of that name are what Python and C would call.
    (loop,) = (
        function
        for function in defined
        if re.match(r"_ZN10discostorm10simulation6engine8_advance.*7advance", function.name)
    )
    for function in defined:
        if function.name != loop.name:
            function.linkage = "internal"
    loop.name = NAME
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_vectorization = options.slp_vectorization = options.loop_unrolling = False
    builder = llvm.create_pass_builder(machine, options)
    passes = builder.getModulePassManager()
    passes.add_global_dead_code_eliminate_pass()
    passes.run(module, builder)
    missing = [f.name for f in module.functions if f.is_declaration and f.name[:5] != "llvm."]
    if missing:
        raise RuntimeError(f"the loop must not call what a browser has not; it calls {missing}")
    return bytes(machine.emit_object(module))


def webassembly() -> bytes:
    """Return the loop as a module that imports nothing."""
    program = linker()
    if program is None:
        raise SystemExit(f"discostorm: make live needs wasm-ld (Debian: apt-get install lld-{LLD})")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "advance.o").write_bytes(_object(_ir(folder)))
        options = ["--no-entry", "--gc-sections", "--stack-first", "--strip-all"]
        exports = [f"--export={NAME}", f"--export={FREE}"]
        command = [program, *options, *exports, "advance.o", "-o", "advance.wasm"]
        subprocess.run(command, check=True, cwd=folder)
        return (folder / "advance.wasm").read_bytes()
