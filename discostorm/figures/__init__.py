"""Figures: functions that return a matplotlib Figure, and the data that they draw.

`fig2`, `fig3` and `fig4` are the paper's; `save_all` writes them as SVG, PDF and PNG, with CSV: the
command ``discostorm figures``. `style` holds the look that all figures share.
"""

import io
from collections.abc import Callable, Iterator
from pathlib import Path

import matplotlib as mpl
import pandas as pd
from matplotlib.figure import Figure

from discostorm.figures.paper import (
    FIG2_ENDPOINTS as FIG2_ENDPOINTS,
    FIG2_PROCESSES as FIG2_PROCESSES,
    FIG3_ENDPOINTS_IN_ALL as FIG3_ENDPOINTS_IN_ALL,
    FIG3_HOSTS as FIG3_HOSTS,
    FIG4_ENDPOINTS as FIG4_ENDPOINTS,
    FIG4_PROCESSES as FIG4_PROCESSES,
    PAPER_PROTOCOLS as PAPER_PROTOCOLS,
    even_process_counts as even_process_counts,
    fig2 as fig2,
    fig2_data as fig2_data,
    fig3 as fig3,
    fig3_data as fig3_data,
    fig4 as fig4,
    fig4_data as fig4_data,
    smooth_steps as smooth_steps,
)
from discostorm.figures.style import (
    COLORS as COLORS,
    MESSAGE_COLORS as MESSAGE_COLORS,
    STYLE_SHEETS as STYLE_SHEETS,
    WIDTH as WIDTH,
    color_of as color_of,
    css_color_property as css_color_property,
    headline as headline,
    protocol_colors as protocol_colors,
    style as style,
)
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
