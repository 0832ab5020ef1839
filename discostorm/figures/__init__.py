"""Figures: functions that return a matplotlib Figure, and the data that they draw.

`fig2`, `fig3` and `fig4` are the paper's; `save_all` writes them as SVG, PDF and PNG, with CSV: the
command ``discostorm figures``. `style` holds the look that all figures share.
"""

from discostorm.figures.export import (
    FIGURES as FIGURES,
    FILES as FILES,
    save as save,
    save_all as save_all,
)
from discostorm.figures.paper import (
    FIG2_ENDPOINTS as FIG2_ENDPOINTS,
    FIG2_PROCESSES as FIG2_PROCESSES,
    FIG3_ENDPOINTS_IN_ALL as FIG3_ENDPOINTS_IN_ALL,
    FIG3_HOSTS as FIG3_HOSTS,
    FIG4_ENDPOINTS as FIG4_ENDPOINTS,
    FIG4_PROCESSES as FIG4_PROCESSES,
    PAPER_PROTOCOLS as PAPER_PROTOCOLS,
    fig2 as fig2,
    fig2_data as fig2_data,
    fig3 as fig3,
    fig3_data as fig3_data,
    fig4 as fig4,
    fig4_data as fig4_data,
    steps as steps,
    whole_divisions as whole_divisions,
)
from discostorm.figures.style import (
    COLORS as COLORS,
    MESSAGE_COLORS as MESSAGE_COLORS,
    SHEETS as SHEETS,
    WIDTH as WIDTH,
    color_of as color_of,
    headline as headline,
    palette_of as palette_of,
    property_of as property_of,
    style as style,
)
