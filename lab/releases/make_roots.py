"""Make a root for each release of releases.csv: its library, and the lab's program built with it.

Roots lie in `build/lab/releases`, one folder each. A root whose row, sources and program have not
changed is kept. If a root cannot be made, the program states the reason and continues.

    make_roots.py [--sources FOLDER] [--mirror ADDRESS] [RELEASE ...]

FOLDER holds the sources, one unpacked archive of a tag per folder, such as Fast-DDS-3.6.2. ADDRESS
is a Debian mirror; the default is the machine's own.
"""

import argparse
import csv
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
LAB = HERE.parent
PROGRAMS = LAB / "programs"
BUILD = LAB.parent / "build" / "lab"
ROOTS = BUILD / "releases"
LOCK_FILE = BUILD.parent / "lab.lock"  # as in measure/run_grid.py
TABLE = HERE / "releases.csv"
DESCRIPTION_FILE = "made.json"
LIBRARIES = "usr/lib/x86_64-linux-gnu"
#: Fast DDS contains a copy of SQLite, which some mirrors lack. Discovery does not use it.
SKIPPED_FILE = "sqlite3.c"


class MissingError(Exception):
    """A root cannot be made; the message states the reason."""


def releases(table: Path = TABLE) -> list[dict[str, str]]:
    """Return the rows of the table, each with its name, such as fast_dds-3.6.2."""
    with table.open(newline="", encoding="utf-8") as file:
        return [
            {"release": f"{row['product']}-{row['version']}"} | row for row in csv.DictReader(file)
        ]


def checksum(source: Path) -> str:
    """Return a checksum of the files from which a source is built, however it was packed."""
    files = [source / "CMakeLists.txt"]
    files += [path for name in ("include", "src") for path in (source / name).rglob("*")]
    digest = hashlib.sha256()
    for path in sorted(files, key=lambda path: path.relative_to(source).as_posix()):
        if path.is_file() and not path.is_symlink() and path.name != SKIPPED_FILE:
            one = hashlib.sha256(path.read_bytes()).hexdigest()
            digest.update(f"{one}  {path.relative_to(source).as_posix()}\n".encode())
    return digest.hexdigest()


def run_logged(command: list[str], log: Path, **more: Any) -> None:
    """Run a command and log its output; an error shows the last line."""
    log.parent.mkdir(parents=True, exist_ok=True)
    with log.open("a", encoding="utf-8") as file:
        done = subprocess.run(command, stdout=file, stderr=file, **more)
    if done.returncode:
        lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
        errors = [line for line in lines if re.search(r"\berror\b|^E:", line, re.IGNORECASE)]
        last = (errors or lines or [""])[-1].strip()[:150]
        where = log.relative_to(BUILD.parents[1]) if log.is_relative_to(BUILD.parents[1]) else log
        raise MissingError(f"{Path(command[0]).name} failed: {last} (all of it: {where})")


def sources_with_checksums(row: dict[str, str], column: str) -> Iterator[tuple[str, str]]:
    """Yield the sources or packages of a row, each with its checksum."""
    yield from zip(row[column].split(), row["sha256"].split(), strict=True)


def from_source(row: dict[str, str], root: Path, sources: Path | None) -> None:
    """Build and install sources, one after the other."""
    needed = list(sources_with_checksums(row, "made_of"))
    names = ", ".join(name for name, _ in needed)
    if sources is None:
        raise MissingError(
            f"its sources ({names}) are missing: say where they are by SOURCES=FOLDER"
        )
    for name, pin in needed:
        if not (sources / name / "CMakeLists.txt").is_file():
            raise MissingError(f"there is no {name} in the folder of SOURCES")
        if (found := checksum(sources / name)) != pin:
            raise MissingError(f"{name} is not what was pinned: its checksum is {found}")
    for tool in ("cmake", "make", "c++"):
        if shutil.which(tool) is None:
            raise MissingError(f"{tool} is missing (Debian: apt-get install cmake make g++)")
    for name, _ in needed:
        work = ROOTS / "work" / row["release"] / name
        log = work.parent / f"{name}.log"
        log.unlink(missing_ok=True)
        command = ["sh", str(HERE / "build.sh"), str(sources / name), str(work), str(root)]
        run_logged([*command, *shlex.split(row["options"])], log)


def installed_debian_version(package: str) -> str:
    """Return the installed version of a Debian package, or an empty string."""
    query = ["dpkg-query", "--show", "--showformat=${Version}", package]
    done = subprocess.run(query, capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else ""


def upstream_release(version: str) -> str:
    """Return the upstream release of a Debian version, without Debian's revision."""
    return re.split(r"[+-]", version)[0]


def from_debian(row: dict[str, str], root: Path, mirror: str | None) -> bool:
    """Unpack Debian packages with dependencies; return False if this machine has these releases."""
    needed = [(*name.split("="), pin) for name, pin in sources_with_checksums(row, "made_of")]
    if all(
        upstream_release(installed_debian_version(package)) == upstream_release(version)
        for package, version, _ in needed
    ):
        return False
    if shutil.which("apt-get") is None:
        raise MissingError("apt-get is missing: its packages are those of Debian")
    work = ROOTS / "work" / row["release"]
    run_logged(
        [
            "sh",
            str(HERE / "debian.sh"),
            str(work),
            str(root),
            row["suite"],
            *row["made_of"].split(),
        ],
        work.with_suffix(".log"),
        env=os.environ | ({"MIRROR": mirror} if mirror else {}),
    )
    for package, version, pin in needed:
        # apt writes the colon of an epoch as %3a.
        [deb] = (work / "cache" / "archives").glob(f"{package}_{version.replace(':', '%3a')}_*.deb")
        if hashlib.sha256(deb.read_bytes()).hexdigest() != pin:
            raise MissingError(f"{deb.name} of the mirror is not what was pinned")
    return True


def command_of(root: Path, program: Path, how: str) -> list[str]:
    """Return the command for a root's program; another Debian's root needs its own loader."""
    if how != "unpacked":
        return [str(program)]
    loader = next(root.glob("*/ld-linux-x86-64.so.2"), root / "usr/lib64/ld-linux-x86-64.so.2")
    return [str(loader), "--library-path", str(root / LIBRARIES), str(program)]


def compile_program(row: dict[str, str], root: Path, how: str) -> Path:
    """Compile the lab's program of a product with the release's own library; return the program."""
    program = root / "lab" / f"release_{row['product']}"
    program.parent.mkdir(parents=True, exist_ok=True)
    log = root / "lab" / "compile.log"
    log.unlink(missing_ok=True)
    include, library, link = [], [], ["-Wl,--allow-shlib-undefined"]
    if how == "built":
        include, library = ["-isystem", str(root / "include")], [f"-L{root / 'lib'}"]
        link = [f"-Wl,--disable-new-dtags,-rpath,{root / 'lib'}"]
    elif how == "unpacked":  # its own C library headers would be found first
        for name in ("include", "include/x86_64-linux-gnu"):
            for part in ("fastdds", "fastrtps", "fastcdr"):
                link_of = root / "lab" / name.replace("/", "-") / part
                link_of.parent.mkdir(exist_ok=True)
                link_of.unlink(missing_ok=True)
                link_of.symlink_to(root / "usr" / name / part)
            include += ["-isystem", str(link_of.parent)]
        library = [f"-L{root / LIBRARIES}"]
    if row["product"] == "fast_dds":
        names = ["fastdds" if int(row["version"].split(".")[0]) > 2 else "fastrtps", "fastcdr"]
        source = [str(PROGRAMS / "release_fast_dds.cpp")]
        compiler = ["c++", "-std=c++17"]
    else:
        # The type description is compiled in, where that release's rmw layer has it.
        plain = [] if "described" in row["rmw"] else ["-t"]
        for idl in ("String_.idl", "Graph.idl"):
            idlc = [str(root / "bin" / "idlc"), *plain, "-W", "no-implicit-extensibility"]
            run_logged([*idlc, str(PROGRAMS / idl)], log, cwd=root / "lab")
        names, compiler = ["ddsc"], ["cc", f"-I{root / 'lab'}"]
        source = [str(PROGRAMS / "release_cyclone_dds.c")]
        source += [str(root / "lab" / name) for name in ("String_.c", "Graph.c")]
    flags = ["-O1", "-Wall", "-Wextra", f"-I{PROGRAMS}", "-o", str(program)]
    libraries = [f"-l{name}" for name in names]
    run_logged([*compiler, *flags, *include, *source, *library, *libraries, *link], log)
    return program


def make_root(row: dict[str, str], sources: Path | None, mirror: str | None) -> str:
    """Make one root, unless it exists; return a line about it."""
    root = ROOTS / row["release"]
    used = [
        PROGRAMS / name for name in ("fast_dds.hpp", "cyclone_dds.h", "String_.idl", "Graph.idl")
    ]
    used += [*PROGRAMS.glob("release_*"), *HERE.glob("*.sh"), Path(__file__)]
    recipe = hashlib.sha256(b"".join(path.read_bytes() for path in sorted(used)))
    recipe.update(json.dumps(row, sort_keys=True).encode())
    made = root / DESCRIPTION_FILE
    if made.exists() and json.loads(made.read_text())["recipe"] == recipe.hexdigest():
        return "is there"
    begun = time.monotonic()
    made.unlink(missing_ok=True)
    description: dict[str, Any] = {"recipe": recipe.hexdigest(), "release": row["release"]}
    if row["how"] == "pypi":
        python = BUILD / "venv" / "bin" / "python"
        package = row["made_of"].replace("-", "_").replace("==", "-")
        if not any(BUILD.glob(f"venv/lib/python*/site-packages/{package}.dist-info")):
            raise MissingError(
                f"{row['made_of']} is not in the lab's venv: make lab GRID=short sets it up"
            )
        root.mkdir(parents=True, exist_ok=True)
        description |= {"command": [str(python), str(PROGRAMS / "zenoh_peer.py")]}
        description |= {"server": [str(python), str(PROGRAMS / "zenoh_router.py"), "HOST"]}
    else:
        how = "built"
        if row["how"] == "source":
            from_source(row, root, sources)
        else:
            how = "unpacked" if from_debian(row, root, mirror) else "installed"
        description["command"] = command_of(root, compile_program(row, root, how), how)
        if row["product"] == "fast_dds":
            at = {
                "built": root / "bin",
                "unpacked": root / "usr/bin",
                "installed": Path("/usr/bin"),
            }
            server = at[how] / "fast-discovery-server"
            if not server.exists():
                raise MissingError("fast-discovery-server is not in it")
            # The number of the command `server`, as `fastdds discovery` passes it since 3.2.
            major, minor, _ = map(int, row["version"].split("."))
            command = ["42"] if (major, minor) >= (3, 2) else []
            description["server"] = [*command_of(root, server.resolve(), how), *command]
    took = round(time.monotonic() - begun, 1)
    made.write_text(json.dumps(description | {"seconds": took}, indent=1) + "\n")
    return f"made in {took:.0f} s"


def main() -> int:
    """Make the requested roots, or all."""
    names = [row["release"] for row in releases()]
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("releases", nargs="*", metavar="RELEASE", help=", ".join(names))
    parser.add_argument("--sources", type=Path, help="folder of the sources")
    parser.add_argument("--mirror", help="address of a Debian mirror")
    given = parser.parse_args()
    if unknown := set(given.releases) - set(names):
        parser.error(f"{', '.join(sorted(unknown))}: not one of {', '.join(names)}")
    if given.sources and not given.sources.is_dir():
        parser.error(f"SOURCES={given.sources}: there is no such folder")
    import fcntl  # local import: Windows has no fcntl, but reads the table

    LOCK_FILE.parent.mkdir(parents=True, exist_ok=True)
    with LOCK_FILE.open("a") as lock:
        try:  # shared with tests, and kept until the end
            fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            parser.exit(1, "discostorm: a campaign of the lab is running: wait until it ends\n")
        return make_all(given)


def make_all(given: argparse.Namespace) -> int:
    """Make the requested roots; return 1 if a root cannot be made."""
    failed = 0
    for row in releases():
        if given.releases and row["release"] not in given.releases:
            continue
        try:
            sources = given.sources.resolve() if given.sources else None
            news = make_root(row, sources, given.mirror)
        except MissingError as why:
            failed, news = failed + 1, f"cannot be made: {why}"
        print(f"{row['release']}: {news}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
