"""Execute notebooks in place; an unchanged notebook keeps its content.

Without arguments, execute all of notebooks/. If a notebook fails, print its name and cell, leave
it unchanged, and exit with status 1. Output on standard error counts as a failure: warnings are
not for readers, and differ between machines. So do words in figures that cover something, but then
the notebook is written, to be looked at.
"""

import argparse
import copy
import csv
import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from prestarted_notebook_kernels import prestarted_kernels, short_folder
from traitlets.config import Config

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
#: This notebook starts first, because it runs longest.
SLOWEST = "15b_what_to_change.ipynb"
CHECK_FIGURES = Path(__file__).parents[1] / "checks" / "check_figures.py"


@dataclass
class NotebookRun:
    """The result of executing a notebook."""

    seconds: float
    changed: list[int]  # cells, counted from 1, whose outputs changed


def run_notebook(path: Path) -> NotebookRun:
    """Execute one notebook and write it back."""
    start = time.perf_counter()
    notebook = nbformat.read(path, as_version=4)
    before = copy.deepcopy(notebook.cells)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.update(execution_count=None, outputs=[])
    begun = [0]
    try:
        # Use Unix sockets: another program could take a TCP port in the meantime.
        with short_folder() as folder:
            file, noted = f"{folder}/kernel.json", Path(folder, "collisions")
            noted.touch()
            # Leave no names behind, which a cell could use.
            measuring = (
                f"__import__('runpy').run_path({str(CHECK_FIGURES)!r})['record_collisions']"
                f"(__import__('pathlib').Path({str(noted)!r}))"
            )
            NotebookClient(
                notebook,
                config=Config(KernelManager={"transport": "ipc", "connection_file": file}),
                extra_arguments=[f"--IPKernelApp.exec_lines={[measuring]!r}"],
                timeout=600,
                startup_timeout=300,  # a busy machine is slow
                kernel_name="python3",
                record_timing=False,
                on_cell_execute=lambda cell, cell_index: begun.append(cell_index),  # noqa: ARG005
                # Under load, a cell's printed text arrives in pieces; merge them into one output.
                coalesce_streams=True,
                resources={"metadata": {"path": str(path.parent)}},
            ).execute()
            collisions = noted.read_text(encoding="utf-8").rstrip()
    except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
        raise RuntimeError(f"{path.name}, cell {begun[-1] + 1}:\n{error}") from error
    for number, cell in enumerate(notebook.cells, 1):
        for output in cell.get("outputs", []):
            if output.get("name") == "stderr":
                raise RuntimeError(
                    f"{path.name}, cell {number}, wrote to standard error:\n{output['text']}"
                )
    # The kernel reports its own Python version, which differs between machines.
    notebook.metadata["language_info"] = {"name": "python"}
    text = nbformat.writes(notebook).rstrip("\n") + "\n"
    # Leave an unchanged notebook alone, so that files made from it stay up to date.
    if text != path.read_text(encoding="utf-8"):
        # Write a temporary file first, because a full disk would leave half a notebook.
        beside = path.with_suffix(".tmp")
        try:
            beside.write_text(text, encoding="utf-8")
            beside.replace(path)
        finally:
            beside.unlink(missing_ok=True)
    if collisions:
        raise RuntimeError(f"{path.name} has figures whose words cover something:\n{collisions}")
    pairs = enumerate(zip(before, notebook.cells, strict=True), 1)
    changed = [number for number, (old, new) in pairs if old != new]
    return NotebookRun(time.perf_counter() - start, changed)


def write_report(folder: Path, runs: dict[str, NotebookRun]) -> None:
    """Write the run time of each notebook, and the cells whose output changed."""
    tables: dict[str, list[tuple[str, float | str]]] = {
        "run_times.csv": [("notebook", "seconds")],
        "changed_cells.csv": [("notebook", "cells")],
    }
    for name, run in runs.items():
        tables["run_times.csv"].append((name, run.seconds))
        tables["changed_cells.csv"].append((name, " ".join(map(str, run.changed))))
    folder.mkdir(parents=True, exist_ok=True)
    for name, rows in tables.items():
        with (folder / name).open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(rows)


def main(arguments: list[str]) -> int:
    """Run the named notebooks, or all notebooks; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("notebooks", nargs="*", type=Path, metavar="NOTEBOOK")
    parser.add_argument(
        "--report", type=Path, metavar="FOLDER", help="for run_times.csv and changed_cells.csv"
    )
    options = parser.parse_args(arguments)
    paths = [path.resolve() for path in options.notebooks] or sorted(NOTEBOOKS.glob("*.ipynb"))
    paths.sort(key=lambda path: path.name != SLOWEST)
    missing = [path for path in paths if not path.is_file()]
    if missing or not paths:
        print("no such notebook:", *(missing or [NOTEBOOKS / "*.ipynb"]), file=sys.stderr)
        return 2
    runs: dict[str, NotebookRun] = {}
    with prestarted_kernels(), ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = {pool.submit(run_notebook, path): path for path in paths}
        for done, job in enumerate(as_completed(jobs), start=1):
            name = jobs[job].name
            start = f"[{done}/{len(jobs)}] {name}"
            error = job.exception()
            if error is None:
                runs[name] = job.result()
                print(f"{start} {runs[name].seconds:.1f} s", flush=True)
            else:
                print(f"{start} FAILED", flush=True)
                kind = "" if type(error) is RuntimeError else f"{name}: {type(error).__name__}: "
                print(f"{kind}{error}\n", file=sys.stderr, flush=True)
    if options.report:
        write_report(options.report, dict(sorted(runs.items())))
    failed = len(jobs) - len(runs)
    if failed:
        print(f"{failed} of {len(jobs)} notebooks failed", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
