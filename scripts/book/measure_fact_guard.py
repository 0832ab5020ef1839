"""Measure how well facts guard the numbers in the chapters: change random numbers.

Each trial changes one digit of a number in a chapter's Markdown, or one number word, as
`discostorm_book.facts` reads them: without code, formulas, links, names, versions, and numbers of
equations, sections and references. The change is caught if text and facts then disagree.

    .venv/bin/python scripts/book/measure_fact_guard.py [--trials N] [--seed S]
"""

import argparse
import copy
import random
from collections.abc import Sequence
from pathlib import Path

import pandas as pd
from compare_facts import disagreements, has_facts, read_cells

from discostorm_book import facts

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"


def change_number(text: str, chance: random.Random) -> str:
    """Return a number with one random digit changed, or a different number word."""
    if not text[0].isdigit():
        words = [word for word in facts.NUMBER_WORDS if word != text.lower()]
        return chance.choice(words)
    places = [place for place, letter in enumerate(text) if letter.isdigit()]
    place = chance.choice(places)
    digits = [digit for digit in "0123456789" if digit != text[place]]
    return text[:place] + chance.choice(digits) + text[place + 1 :]


def try_changes(paths: Sequence[Path], trials: int, seed: int) -> pd.DataFrame:
    """Return each trial: its chapter, the changed text, and whether the facts caught the change."""
    chance = random.Random(seed)
    chapters = {path.stem: read_cells(path) for path in paths}
    places = [
        (name, index, numeral)
        for name, cells in chapters.items()
        for index, cell in enumerate(cells)
        if cell["cell_type"] == "markdown"
        for numeral in facts.numerals("".join(cell["source"]))
    ]
    rows = []
    for words in (False, True):
        of_kind = [place for place in places if place[2].optional == words]
        for name, index, numeral in chance.choices(of_kind, k=trials):
            cells = copy.deepcopy(chapters[name])
            text = "".join(cells[index]["source"])
            changed = change_number(numeral.text, chance)
            cells[index]["source"] = text[: numeral.start] + changed + text[numeral.end :]
            caught = has_facts(cells) and bool(disagreements(cells))
            rows.append({"chapter": name, "what": "words" if words else "digits", "caught": caught})
    return pd.DataFrame(rows)


def main() -> None:
    """Print the share of caught changes, by chapter and in total."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trials", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    found = try_changes(sorted(NOTEBOOKS.glob("*.ipynb")), asked.trials, asked.seed)
    table = found.groupby(["what", "chapter"])["caught"].agg(["size", "mean"])
    print(table.to_string(header=["tried", "caught"], float_format="{:.0%}".format))
    for what, caught in found.groupby("what")["caught"]:
        print(f"{what}: {caught.mean():.1%} of {len(caught)} changes caught")


if __name__ == "__main__":
    main()
