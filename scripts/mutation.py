"""Let Cosmic Ray change the package in small ways, and hold what no test notices to a list.

It tests the last commit, in clones. A session that was interrupted goes on where it stopped.
What no test notices must be in tests/mutation_survivors.csv, with the reason why.
"""

import argparse
import csv
import os
import signal
import socket
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.parse import urlsplit

from cosmic_ray.config import load_config
from cosmic_ray.work_db import WorkDB, use_db
from cosmic_ray.work_item import TestOutcome, WorkerOutcome, WorkResult

CONFIG = Path("cosmic-ray.toml")
SESSION = Path("build/mutation.sqlite")
SURVIVORS = Path("tests/mutation_survivors.csv")
#: Not changed, as nothing outside can differ: they guard or speed up the code itself.
INNER = ("strict=True", "slots=True", "if TYPE_CHECKING", "*,")


def lines(diff: str) -> tuple[str, str]:
    """Return what a diff takes away and what it puts there, each on one line."""
    body = [line for line in diff.splitlines() if not line.startswith(("---", "+++"))]
    old, new = (" ".join(x[1:].strip() for x in body if x.startswith(sign)) for sign in "-+")
    return old, new


def start(modules: list[str], config: Path) -> None:
    """Make a session of all changes of the modules, unless it is there for the same commit."""
    paths = [f"discostorm/{module}.py" for module in modules] or ["discostorm"]
    git = ["git", "rev-parse", "HEAD"]
    commit = subprocess.run(git, text=True, capture_output=True, check=True).stdout
    text = CONFIG.read_text(encoding="utf-8").replace('= "discostorm"', f"= {paths}")
    text = f"# {commit}{text}"
    if SESSION.exists() and config.exists() and config.read_text(encoding="utf-8") == text:
        return
    config.write_text(text, encoding="utf-8")
    subprocess.run(["cosmic-ray", "init", "--force", config, SESSION], check=True)
    subprocess.run(["cr-filter-operators", SESSION, config], check=True)
    with use_db(SESSION, WorkDB.Mode.open) as database:
        for item in database.pending_work_items:
            (change,) = item.mutations
            code = change.module_path.read_text(encoding="utf-8").splitlines()
            if any(word in code[change.start_pos[0] - 1] for word in INNER):
                database.set_result(item.job_id, WorkResult(WorkerOutcome.SKIPPED))


def execute(config: Path) -> None:
    """Run what is left of the session, by workers in clones of the last commit."""
    with TemporaryDirectory() as clones, SESSION.with_suffix(".log").open("w") as log:
        workers = subprocess.Popen(
            ["cr-http-workers", config, "."],
            env=os.environ | {"TMPDIR": clones},
            stdout=log,
            stderr=log,
            start_new_session=True,
        )
        try:
            for url in load_config(config).distributor_config["worker-urls"]:
                wait(urlsplit(url).port)
            # Tests that fail without a change would be taken for some that notice every change.
            if subprocess.run(["cosmic-ray", "baseline", config], check=False).returncode:
                sys.exit("mutation: tests fail without any change; run `make test`")
            session = subprocess.Popen(["cosmic-ray", "exec", config, SESSION])
            while session.poll() is None:
                time.sleep(30)
                with use_db(SESSION, WorkDB.Mode.open) as database:
                    left = sum(1 for _ in database.pending_work_items)
                    print(f"{left} of {database.num_work_items} changes left", flush=True)
        finally:
            os.killpg(workers.pid, signal.SIGTERM)
            workers.wait()


def wait(port: int) -> None:
    """Return when something answers at a port of this machine."""
    for _ in range(600):
        with suppress(OSError):
            socket.create_connection(("127.0.0.1", port)).close()
            return
        time.sleep(0.1)
    sys.exit(f"mutation: no worker at port {port}; see {SESSION.with_suffix('.log')}")


def compare(modules: list[str]) -> int:
    """Print what no test noticed and the list does not have, or the other way round."""
    found: set[tuple[str, ...]] = set()
    tried = survived = 0
    with use_db(SESSION, WorkDB.Mode.open) as database:
        for item, result in database.completed_work_items:
            if result.worker_outcome == WorkerOutcome.NORMAL:
                tried += 1
                if result.test_outcome == TestOutcome.SURVIVED:
                    survived += 1
                    path = item.mutations[0].module_path.relative_to("discostorm")
                    found.add((path.with_suffix("").as_posix(), *lines(result.diff)))
            elif result.worker_outcome != WorkerOutcome.SKIPPED:
                sys.exit(f"mutation: {item.mutations[0]} could not be tried: {result.output}")
    with SURVIVORS.open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if not modules or row["module"] in modules]
    known = {(row["module"], row["before"], row["after"]) for row in rows if row["reason"]}
    print(f"{tried} changes, {1 - survived / tried:.1%} noticed (at least 90%)")
    for where, these in (("not in", found - known), ("noticed, but in", known - found)):
        for module, before, after in sorted(these):
            print(f"{where} {SURVIVORS.name}: {module}\n  - {before}\n  + {after}")
    return 0 if survived <= 0.1 * tried and found == known else 1


def main() -> int:
    """Run the session of the named modules, or of all; compare what is left with the list."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("modules", nargs="*", metavar="MODULE", help="such as wifi/radio")
    modules = parser.parse_args().modules
    config = SESSION.with_suffix(".toml")
    start(modules, config)
    execute(config)
    return compare(modules)


if __name__ == "__main__":
    sys.exit(main())
