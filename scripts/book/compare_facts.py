"""Compare the text of notebooks with the facts that their cells keep."""

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from discostorm_book.facts import KEY, first_mismatch


@dataclass(frozen=True)
class Paragraphs:
    """Markdown of a notebook, with the facts that it states; None where no cell has any."""

    cells: tuple[int, ...]
    text: str
    values: Mapping[str, float] | None


def _facts_in_cell(cell: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [
        {"of": kept["of"], "values": {name: float(value) for name, value in kept["values"]}}
        for output in cell.get("outputs", [])
        if (kept := output.get("metadata", {}).get(KEY))
    ]


def paragraphs(cells: Sequence[Mapping[str, Any]]) -> list[Paragraphs]:
    """Return the Markdown of a notebook, each piece with the facts that are for it."""
    named = {
        kept["of"]: kept["values"] for cell in cells for kept in _facts_in_cell(cell) if kept["of"]
    }
    pieces: list[tuple[list[int], list[str], Mapping[str, float] | None]] = [([], [], None)]
    for index, cell in enumerate(cells):
        if cell["cell_type"] != "markdown":
            pieces += [([], [], kept["values"]) for kept in _facts_in_cell(cell) if not kept["of"]]
            continue
        for text in re.split(r"\n{2,}", "".join(cell["source"])):
            start = next((of for of in named if text.startswith(of)), None)
            if start is None:
                pieces[-1][0].append(index)
                pieces[-1][1].append(text)
            else:
                pieces.insert(-1, ([index], [text], named[start]))
    return [
        Paragraphs(tuple(dict.fromkeys(where)), "\n\n".join(texts), values)
        for where, texts, values in pieces
    ]


def disagreements(cells: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return where the text of a notebook and its facts disagree."""
    texts = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    problems = [
        f"no paragraph begins with {kept['of']!r}"
        for cell in cells
        for kept in _facts_in_cell(cell)
        if not any(re.search(rf"^{re.escape(kept['of'])}", text, re.MULTILINE) for text in texts)
    ]
    for piece in paragraphs(cells):
        if problem := first_mismatch(piece.text, piece.values or {}):
            where = ", ".join(map(str, piece.cells))
            problems.append(f"cell {where or 'of facts'}: {problem}")
    return problems


def has_facts(cells: Sequence[Mapping[str, Any]]) -> bool:
    """Return whether a notebook keeps facts."""
    return any(_facts_in_cell(cell) for cell in cells)


def read_cells(path: Path) -> list[dict[str, Any]]:
    """Return the cells of a notebook."""
    return list(json.loads(path.read_text(encoding="utf-8"))["cells"])
