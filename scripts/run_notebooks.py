"""Execute every notebook in place; what an unchanged notebook holds comes out the same."""

import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import nbformat
from nbclient import NotebookClient

NOTEBOOKS = Path(__file__).parents[1] / "notebooks"


def run(path: Path) -> float:
    """Execute one notebook and write it back; return the seconds it took."""
    start = time.perf_counter()
    notebook = nbformat.read(path, as_version=4)
    NotebookClient(
        notebook,
        timeout=120,
        kernel_name="python3",
        record_timing=False,
        resources={"metadata": {"path": str(path.parent)}},
    ).execute()
    # The kernel reports its own Python version, which would differ from reader to reader.
    notebook.metadata["language_info"] = {"name": "python"}
    nbformat.write(notebook, path)
    return time.perf_counter() - start


def main(names: list[str]) -> None:
    """Run the named notebooks, or all of them."""
    paths = [Path(name).resolve() for name in names] or sorted(NOTEBOOKS.glob("*.ipynb"))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = {pool.submit(run, path): path for path in paths}
        for done, job in enumerate(as_completed(jobs), start=1):
            print(f"[{done}/{len(jobs)}] {jobs[job].name} {job.result():.1f} s", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
