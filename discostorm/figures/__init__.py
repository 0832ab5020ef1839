"""Figures: functions that return a matplotlib Figure, and the data that they draw.

`fig2`, `fig3` and `fig4` are the paper's; `save_all` writes them as SVG, PDF and PNG, with CSV: the
command ``discostorm figures``. `narrowed` draws any figure again for a phone. There are more
drawings: `airtime`, of one frame of each message; and, of any protocol, `bars`, of what each
message adds to utilization, `remedies`, of what a plan would change, and `who_tells_whom`, of the
way that each message takes.
"""

from discostorm.figures.files import (
    FIGURES,
    PaperFigure,
    files_of_all,
    replacing,
    save,
    save_all,
)
from discostorm.figures.looks import (
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
from discostorm.figures.messages import airtime, airtime_data, bars, bars_data, who_tells_whom
from discostorm.figures.narrow import NARROW, narrowed
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
from discostorm.figures.plan import remedies

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
    "NARROW",
    "PAPER_PROTOCOLS",
    "SHEETS",
    "STYLES",
    "WIDTH",
    "PaperFigure",
    "airtime",
    "airtime_data",
    "bars",
    "bars_data",
    "color_of",
    "fig2",
    "fig2_data",
    "fig3",
    "fig3_data",
    "fig4",
    "fig4_data",
    "files_of_all",
    "headline",
    "narrowed",
    "palette_of",
    "phases_data",
    "property_of",
    "remedies",
    "replacing",
    "save",
    "save_all",
    "steps",
    "style",
    "who_tells_whom",
    "whole_divisions",
]
