"""Compile the simulator's inner loop to WebAssembly: numba's LLVM IR, llvmlite, and LLVM's linker.

The IR of `discostorm_simulation.kernels.advance` is for a generic processor, so every machine
produces the same IR. LLVM optimizes it for size on wasm32, and `wasm-ld` links it. Equal versions
of numba, llvmlite and lld give equal bytes.

Exports: the memory; `advance`, which takes three numbers; `__heap_base`, the start of free memory;
and `arrays`, where the caller writes numba's arguments for each array of the cell.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path

from discostorm.data import data_path

#: LLVM release of the linker that made the committed file, as in Debian's package name.
LLD_RELEASE = 14
#: The linker: Debian's name of that release, or the newest.
LINKERS = (f"wasm-ld-{LLD_RELEASE}", "wasm-ld")
#: Exports besides the memory: the loop, its table of arrays, and the start of free memory.
LOOP_EXPORT, ARRAYS_EXPORT, HEAP_EXPORT = "advance", "arrays", "__heap_base"
#: The compiled package.
SIMULATION_PACKAGE = data_path("", "discostorm_simulation").parent

#: numba's settings for a generic processor.
GENERIC_PROCESSOR = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
TARGET_TRIPLE = "wasm32-unknown-unknown"
#: Fill memory by an instruction (in all browsers since 2021) instead of an imported function.
WASM_FEATURES = "+bulk-memory"

#: Script: compile the loop and write its IR. Called kernels stay functions, and LLVM inlines them
#: where that pays off: a third of the code at the same speed.
_IR_SCRIPT = """
import sys
from pathlib import Path
import numba
import numpy as np
import discostorm as ds
from discostorm_simulation.kernels import decorators
from discostorm_simulation.run import Scenario, set_up

decorators.inlined = decorators.not_inlined
from discostorm_simulation.kernels.advance import advance

setup = set_up(Scenario(ds.Fleet.swarm(2, 1, 0), ds.DDS, ds.PAPER))
cell, _ = setup.cell(np.random.SeedSequence(0))
advance.compile((numba.typeof(cell), numba.int64, numba.int64, numba.int64))
(signature,) = advance.signatures
Path(sys.argv[1]).write_text(advance.inspect_llvm(signature), encoding="utf-8")
"""

#: The loop without array arguments; numba's function returns whether the loop has failed.
_WRAPPER_IR = """
@{arrays} = global [{count} x i64] zeroinitializer, align 64

define i32 @{name}(i64 %arg.until, i64 %arg.reserve, i64 %arg.steps) {{
  %ret = alloca i64
  %exc = alloca ptr
  %failed = call i32 @{loop}({given})
  %good = icmp eq i32 %failed, 0
  br i1 %good, label %answer, label %trap
answer:
  %state = load i32, ptr %ret
  ret i32 %state
trap:
  call void @llvm.trap()
  unreachable
}}

declare void @llvm.trap()
!9999 = !{{}}
"""


@cache
def sources_digest() -> str:
    """Return a digest of all compiled sources."""
    files = [
        *sorted((SIMULATION_PACKAGE / "kernels").glob("*.py")),
        SIMULATION_PACKAGE / "state.py",
    ]
    return sha256(b"".join(file.read_bytes() for file in files)).hexdigest()[:16]


def find_linker() -> str | None:
    """Return the program that links WebAssembly, or None."""
    return next(filter(None, map(shutil.which, LINKERS)), None)


def linker_release() -> int | None:
    """Return the release of the linker, such as 14."""
    program = find_linker()
    if program is None:
        return None
    answer = subprocess.run([program, "--version"], check=True, capture_output=True, text=True)
    found = re.search(r"LLD (\d+)", answer.stdout)
    return int(found[1]) if found else None


def tool_versions() -> str:
    """Return the tool versions on which the bytes depend."""
    return f"numba {version('numba')}, llvmlite {version('llvmlite')}, lld {linker_release()}"


def script_header() -> str:
    """Return the first lines of the page's script: tool versions and the digest of the sources."""
    return (
        "// The simulator's inner loop, engine.wasm of discostorm_simulation; made by `make live`; "
        f"do not edit.\n// {tool_versions()}; sources {sources_digest()}\n"
    )


def _loop_ir(folder: Path) -> str:
    """Return the loop's IR for a generic processor."""
    target = folder / "advance.ll"
    environment = os.environ | GENERIC_PROCESSOR | {"NUMBA_CACHE_DIR": str(folder)}
    subprocess.run([sys.executable, "-c", _IR_SCRIPT, str(target)], check=True, env=environment)
    return target.read_text(encoding="utf-8")


def _read_arrays_from_memory(ir: str) -> str:
    """Return IR whose functions read the descriptions of the cell's arrays from memory.

    numba passes these descriptions, more than 200 numbers, to each function. WebAssembly would
    copy the numbers for each call, which takes longer than the simulation itself.
    """
    slots: dict[str, int] = {}

    def kind(argument: str) -> str:
        # Fields of an array: owner, parent, item count, item size, data, shape and strides.
        return "ptr" if argument.split(".")[3] in ("0", "1", "4") else "i64"

    def reading(found: re.Match[str]) -> str:
        arguments = re.findall(r"%arg\.cell\.[0-9.]+", found[1])
        slots.update({argument: slot for slot, argument in enumerate(arguments)})
        reads = [
            f"  {argument} = load {kind(argument)}, "
            f"ptr getelementptr (i64, ptr @{ARRAYS_EXPORT}, i32 {slot}), !invariant.load !9999\n"
            for slot, argument in enumerate(arguments)
        ]
        return found[1].replace("%arg.cell.", "%unused.cell.") + found[2] + "".join(reads)

    # The function's head, and the start of its first block.
    function = r"(?m)^(define [^\n]*%arg\.cell\.[^\n]*\n)((?:[\w.\"$-]+:[^\n]*\n)?)"
    ir = re.sub(function, reading, ir)
    ir = re.sub(r"memory\([^)]*\)", "", ir)  # memory attributes of the arguments no longer hold
    # Other functions of this name are wrappers for Python and C.
    loop = re.search(
        rf"(?m)^define [^\n]*@(_ZN\S*kernels7{LOOP_EXPORT}7{LOOP_EXPORT}[^\s(]*)\(.*", ir
    )
    assert loop is not None
    unused = ", ".join(f"{kind(argument)} undef" for argument in slots)
    numbers = "i64 %arg.until, i64 %arg.reserve, i64 %arg.steps"
    given = f"ptr %ret, ptr %exc, {unused}, {numbers}"
    return ir + _WRAPPER_IR.format(
        arrays=ARRAYS_EXPORT, count=len(slots), name=LOOP_EXPORT, loop=loop[1], given=given
    )


def _optimize_for_wasm(ir: str, layout: str) -> str:
    """Return size-optimized IR with the target's layout instead of this machine's."""
    ir = re.sub(r'target datalayout = "[^"]*"', f'target datalayout = "{layout}"', ir)
    ir = re.sub(r'target triple = "[^"]*"', f'target triple = "{TARGET_TRIPLE}"', ir)
    ir = re.sub(r'"(target-cpu|target-features|tune-cpu)"="[^"]*"', "", ir)
    # WebAssembly has no common symbols.
    ir = ir.replace("= common ", "= weak ")
    return re.sub(r"(?m)^(attributes #\d+ = \{)", r"\1 minsize optsize", ir)


def _object_file(ir: str) -> bytes:
    """Return the loop as an object file of WebAssembly."""
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple(TARGET_TRIPLE)
    machine = target.create_target_machine(opt=2, cpu="mvp", features=WASM_FEATURES)
    module = llvm.parse_assembly(
        _optimize_for_wasm(_read_arrays_from_memory(ir), str(machine.target_data))
    )
    module.verify()
    for function in module.functions:
        if not function.is_declaration and function.name != LOOP_EXPORT:
            function.linkage = "internal"
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


def compile_webassembly(keep: Path | None = None) -> bytes:
    """Return the loop as a module without imports; ``keep`` is a folder for numba's cache."""
    program = find_linker()
    if program is None:
        raise SystemExit(
            f"discostorm: make live needs wasm-ld (Debian: apt-get install lld-{LLD_RELEASE})"
        )
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "advance.o").write_bytes(_object_file(_loop_ir(keep or folder)))
        options = ["--no-entry", "--gc-sections", "--stack-first", "--strip-all"]
        exports = [f"--export={name}" for name in (LOOP_EXPORT, ARRAYS_EXPORT, HEAP_EXPORT)]
        command = [program, *options, *exports, "advance.o", "-o", "advance.wasm"]
        subprocess.run(command, check=True, cwd=folder)
        return (folder / "advance.wasm").read_bytes()
