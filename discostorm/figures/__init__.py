"""Figures: functions that return a matplotlib Figure, and the data that they draw.

`fig2`, `fig3` and `fig4` are the paper's; `save_all` writes them as SVG, PDF and PNG, with CSV: the
command ``discostorm figures``. `style` holds the look that all figures share.
"""

from discostorm.figures.export import FIGURES, PaperFigure, files_of_all, replacing, save, save_all
from discostorm.figures.paper import (
    FIG2_ENDPOINTS,
    FIG2_PROCESSES,
    FIG3_ENDPOINTS_IN_ALL,
    FIG3_HOSTS,
    FIG4_ENDPOINTS,
    FIG4_PROCESSES,
    PAPER_PROTOCOLS,
    fig2,
    fig2_data,
    fig3,
    fig3_data,
    fig4,
    fig4_data,
    phases_data,
    steps,
    whole_divisions,
)
from discostorm.figures.style import (
    COLORS,
    MESSAGE_COLORS,
    SHEETS,
    STYLES,
    WIDTH,
    color_of,
    headline,
    palette_of,
    property_of,
    style,
)

__all__ = [
    "COLORS",
    "FIG2_ENDPOINTS",
    "FIG2_PROCESSES",
    "FIG3_ENDPOINTS_IN_ALL",
    "FIG3_HOSTS",
    "FIG4_ENDPOINTS",
    "FIG4_PROCESSES",
    "FIGURES",
    "MESSAGE_COLORS",
    "PAPER_PROTOCOLS",
    "SHEETS",
    "STYLES",
    "WIDTH",
    "PaperFigure",
    "color_of",
    "fig2",
    "fig2_data",
    "fig3",
    "fig3_data",
    "fig4",
    "fig4_data",
    "files_of_all",
    "headline",
    "palette_of",
    "phases_data",
    "property_of",
    "replacing",
    "save",
    "save_all",
    "steps",
    "style",
    "whole_divisions",
]
