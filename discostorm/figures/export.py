"""Figures as files: SVG, PDF and PNG, the same bytes every time."""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl
import pandas as pd
from matplotlib.figure import Figure

from discostorm.figures.paper import fig2, fig2_data, fig3, fig3_data, fig4, fig4_data
from discostorm.figures.style import style


@dataclass(frozen=True)
class PaperFigure:
    """A figure of the paper: what it shows, its data, and how it is drawn."""

    title: str
    data: Callable[[], pd.DataFrame]
    draw: Callable[[], Figure]


FIGURES = {
    "fig2": PaperFigure("Fig. 2: utilization against hosts", fig2_data, fig2),
    "fig3": PaperFigure("Fig. 3: utilization against processes and endpoints", fig3_data, fig3),
    "fig4": PaperFigure("Fig. 4: utilization of the Nav2 scenario", fig4_data, fig4),
}

# Without these, each file would carry the time or the version that made it.
_METADATA: dict[str, dict[str, None]] = {
    "svg": {"Date": None, "Creator": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    "png": {"Software": None},
}


def save(figure: Figure, folder: Path, name: str) -> Iterator[Path]:
    """Write a figure as SVG, PDF and PNG, the same bytes every time; yield each path."""
    if engine := figure.get_layout_engine():
        with style():
            engine.execute(figure)
    for kind, metadata in _METADATA.items():
        path = folder / f"{name}.{kind}"
        with style(), replacing(path) as beside:
            # With an engine, even "none", each file would first be drawn once more.
            mpl.rcParams["figure.constrained_layout.use"] = False
            figure.set_layout_engine(None)
            figure.savefig(beside, dpi=200, metadata=metadata, format=kind)
        yield path


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give a file to write beside a path, which takes its place only if all was written."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        yield beside
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)


def files_of_all() -> int:
    """Return how many files `save_all` writes."""
    return len(FIGURES) * (len(_METADATA) + 1)


def save_all(folder: Path) -> Iterator[Path]:
    """Write Figs. 2-4 and their data into a folder, made if missing; yield each path."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, paper in FIGURES.items():
        figure = paper.draw()
        yield from save(figure, folder, name)
        path = folder / f"{name}.csv"
        with replacing(path) as beside:
            paper.data().to_csv(beside, index=False, lineterminator="\n")
        yield path
