"""Compile the bench into `build/air`: ns-3's cell, preloaded libraries, a program per release.

Each missing capability is one sentence with its remedy.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "measure"), str(HERE.parent / "releases")]

from make_roots import PROGRAMS, ROOTS, releases  # noqa: E402

BENCH = HERE.parents[1] / "build" / "air"
NS3 = HERE.parents[1] / "build" / "ns3" / "packages" / "ns3"
#: Libraries of ns-3 that the cell or its libraries need.
LIBRARIES = [
    "core",
    "network",
    "mobility",
    "propagation",
    "wifi",
    "stats",
    "antenna",
    "spectrum",
    "energy",
]
#: Libraries that each process preloads, in this order.
PRELOADS = ("slow_clock", "sender_waits")
#: The release of which a library with one constant changed is made.
SLOW_EDP_ANSWERS = "fast_dds-2.6.12"


class MissingError(Exception):
    """The bench, or a release, cannot run; the message says why and what to do."""


def refuse_unsuitable_machine() -> None:
    """Fail with a sentence if this machine cannot emulate a cell."""
    if os.geteuid() != 0:
        raise MissingError("the bench makes network namespaces and TAPs: run it as root")
    if not Path("/dev/net/tun").exists():
        raise MissingError("/dev/net/tun is missing: load the kernel's module (modprobe tun)")
    if not (NS3 / "lib64").is_dir():
        raise MissingError("ns-3 is missing: make build/ns3/.ready installs it (PyPI, 70 MB)")
    programs = ("chrt", "g++", "ip", "nice", "nsenter", "setpriv", "sysctl", "unshare")
    if missing := [name for name in programs if shutil.which(name) is None]:
        packages = "g++ iproute2 procps util-linux"
        raise MissingError(f"{' '.join(missing)} missing: apt-get install {packages}")


def compile_if_older(command: list[str], program: Path, sources: list[Path]) -> None:
    """Run a compiler, unless its program is newer than all sources."""
    changed = max(path.stat().st_mtime for path in sources)
    if program.exists() and program.stat().st_mtime > changed:
        return
    program.parent.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([*command, "-o", str(program)], capture_output=True, text=True)
    if done.returncode:
        program.unlink(missing_ok=True)
        raise MissingError(f"could not compile {program.name}: {done.stderr.strip()[-300:]}")


def build_cell() -> None:
    """Compile ns-3's cell and the preloaded libraries."""
    links = [f"-L{NS3 / 'lib64'}", f"-Wl,-rpath,{NS3 / 'lib64'}", "-lpthread"]
    links += [f"-lns3.44-{name}" for name in LIBRARIES]
    command = ["g++", "-std=c++20", "-O2", f"-I{NS3 / 'include'}", str(HERE / "cell.cc"), *links]
    shared = HERE / "in_flight.h"
    compile_if_older(command, BENCH / "cell", [HERE / "cell.cc", shared])
    for name in PRELOADS:
        source = HERE / f"{name}.c"
        command = ["gcc", "-O2", "-Wall", "-Wextra", "-shared", "-fPIC", str(source), "-ldl"]
        compile_if_older(command, BENCH / f"{name}.so", [source, shared])


def build_program(release: str) -> Path:
    """Compile the program of a release with the release's own library; return the program."""
    root = ROOTS / release
    if not (root / "made.json").exists():
        raise MissingError(
            f"{release} has no root: make lab-roots makes it, or says what is missing"
        )
    if (root / "usr").exists():
        raise MissingError(
            f"{release} is of another Debian, whose C library has no slow clock here"
        )
    [row] = [row for row in releases() if row["release"] == release]
    if row["product"] not in ("fast_dds", "cyclone_dds"):
        raise MissingError(f"{row['product']} has its timers in the kernel, which are not slowed")
    program = BENCH / release / f"discover_{row['product']}"
    program.parent.mkdir(parents=True, exist_ok=True)
    include, link = [f"-I{PROGRAMS}"], ["-Wl,--allow-shlib-undefined"]
    if (root / "lib").exists():
        include += ["-isystem", str(root / "include")]
        link += [f"-L{root / 'lib'}", f"-Wl,--disable-new-dtags,-rpath,{root / 'lib'}"]
    if row["product"] == "fast_dds":
        source = HERE / "discover_fast_dds.cpp"
        names = ["fastdds" if int(row["version"].split(".")[0]) > 2 else "fastrtps", "fastcdr"]
        command = ["g++", "-std=c++17", str(source)]
    else:
        source = HERE / "discover_cyclone_dds.c"
        names, include = ["ddsc"], [f"-I{program.parent}", *include]
        plain = [] if "described" in row["rmw"] else ["-t"]
        idlc = [str(root / "bin" / "idlc"), *plain, "-W", "no-implicit-extensibility"]
        idl = subprocess.run([*idlc, str(PROGRAMS / "String_.idl")], cwd=program.parent)
        if idl.returncode:
            raise MissingError(f"idlc of {release} failed")
        command = ["gcc", str(source), str(program.parent / "String_.c")]
    flags = ["-O1", "-Wall", "-Wextra", *include]
    compile_if_older(
        [*command, *flags, *(f"-l{name}" for name in names), *link],
        program,
        [source, root / "made.json"],
    )
    return program


def build_slow_edp_answers() -> Path:
    """Relink Fast DDS 2.6.12 with the delay of its comment; return the library."""
    out = BENCH / "slow_edp_answers"
    library = out / "libfastrtps.so.2.6"
    work = (ROOTS / "work" / SLOW_EDP_ANSWERS / "Fast-DDS-2.6.12").resolve()
    if library.exists():
        return library
    if not (work / "build").is_dir():
        raise MissingError(f"{work} is missing: make lab-roots builds {SLOW_EDP_ANSWERS} there")
    command = ["sh", str(HERE / "slow_edp_answers.sh"), str(work), str(out)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise MissingError(f"slow_edp_answers.sh failed: {done.stderr.strip()[-300:]}")
    return library


def root_description(release: str) -> dict[str, str]:
    """Return the description of a release from its root."""
    made: dict[str, str] = json.loads((ROOTS / release / "made.json").read_text())
    return made
