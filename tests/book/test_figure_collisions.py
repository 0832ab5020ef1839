"""Words in figures cover nothing: the measure itself, and all figures of the notebooks."""

import subprocess
import sys

import numpy as np
import pytest
from check_figures import collisions
from matplotlib.figure import Figure
from support import ROOT


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
    assert collisions(falling_line(x, y)) == covered


def test_words_on_words_are_found_and_lines_outside_the_panel_are_not() -> None:
    figure = falling_line(0.25, 0.25)
    (axes,) = figure.axes
    axes.text(0.27, 0.25, "other")
    axes.set_xlim(*axes.get_xlim())
    axes.plot([2, 3], [0.25, np.nan])
    assert collisions(figure) == ["'word' and 'other'"]


@pytest.mark.thorough
def test_no_figure_of_a_notebook_has_a_collision() -> None:
    script = ROOT / "scripts/checks/check_figures.py"
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.strip()) == (0, ""), done.stderr
