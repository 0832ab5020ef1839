"""Words in figures cover nothing: the measure, which `run_notebooks.py` applies to each figure."""

import numpy as np
import pytest
from check_figures import find_collisions
from matplotlib.figure import Figure


def falling_line(x: float, y: float) -> Figure:
    """Return a falling line with a dot at its middle, and a word somewhere."""
    figure = Figure(figsize=(4, 3), dpi=100)
    axes = figure.subplots()
    axes.plot([0, 1], [1, 0])
    axes.plot(0.5, 0.5, "o", ms=8)
    axes.axhline(0.9)
    axes.text(x, y, "word", ha="center", va="center")
    return figure


@pytest.mark.parametrize(
    ("x", "y", "covered"),
    [
        (0.25, 0.25, []),
        (0.2, 0.8, ["'word' and a line"]),
        (0.8, 0.9, ["'word' and a line"]),
        (0.5, 0.5, ["'word' and a line", "'word' and a dot"]),
        (1.2, 0.8, ["'word' and the edge"]),
    ],
)
def test_covered_lines_dots_and_edges_are_found(x: float, y: float, covered: list[str]) -> None:
    assert find_collisions(falling_line(x, y)) == covered


def test_words_on_words_are_found_and_lines_outside_the_panel_are_not() -> None:
    figure = falling_line(0.25, 0.25)
    (axes,) = figure.axes
    axes.text(0.27, 0.25, "other")
    axes.set_xlim(*axes.get_xlim())
    axes.plot([2, 3], [0.25, np.nan])
    assert find_collisions(figure) == ["'word' and 'other'"]
