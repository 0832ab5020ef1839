"""Each notebook, run from its first cell to its last, gives the outputs that are stored in it.

`make book` runs them all and writes down which cells came out otherwise; where the book is older
than its sources, it is made first, and the notebooks stay as they are: a difference is told until
somebody has looked at it. A cell that fails, or writes to standard error, ends that.
"""

import csv
from pathlib import Path

import pytest
from support import ROOT

pytestmark = [pytest.mark.book, pytest.mark.locked]

NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))


@pytest.fixture(scope="module")
def changed(built: Path) -> dict[str, str]:
    """Return the cells of each notebook that came out otherwise."""
    with (built / "changed_cells.csv").open(encoding="utf-8", newline="") as file:
        return {row["notebook"]: row["cells"] for row in csv.DictReader(file)}


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_what_is_stored_is_what_comes_out(path: Path, changed: dict[str, str]) -> None:
    cells = changed[path.name]
    assert not cells, (
        f"cells {cells} of {path.name} came out otherwise when `make book` ran it: run it, "
        "look at the difference of the file, and test again"
    )
