"""Figures as files: SVG, PDF and PNG, the same bytes every time."""

import io
from collections.abc import Callable, Iterator
from pathlib import Path

import matplotlib as mpl
import pandas as pd
from matplotlib.figure import Figure

from discostorm.figures.paper import fig2, fig2_data, fig3, fig3_data, fig4, fig4_data
from discostorm.figures.style import style
from discostorm.files import atomic_write

#: The paper's figures: functions of their data, and functions that draw them.
FIGURES: dict[str, tuple[Callable[[], pd.DataFrame], Callable[[], Figure]]] = {
    "fig2": (fig2_data, fig2),
    "fig3": (fig3_data, fig3),
    "fig4": (fig4_data, fig4),
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
        path, content = folder / f"{name}.{kind}", io.BytesIO()
        with style():
            # With an engine, even "none", each file would first be drawn once more.
            mpl.rcParams["figure.constrained_layout.use"] = False
            figure.set_layout_engine(None)
            figure.savefig(content, dpi=200, metadata=metadata, format=kind)
        atomic_write(path, content.getvalue())
        yield path


#: Names of the files that `save_all` writes, in this order.
FILES = tuple(f"{name}.{kind}" for name in FIGURES for kind in (*_METADATA, "csv"))


def save_all(folder: Path) -> Iterator[Path]:
    """Write Figs. 2-4 and their data into a folder, made if missing; yield each path."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, (data, draw) in FIGURES.items():
        yield from save(draw(), folder, name)
        path = folder / f"{name}.csv"
        atomic_write(path, data().to_csv(index=False, lineterminator="\n").encode())
        yield path
