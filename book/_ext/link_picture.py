"""The picture that a link to the book shows: the airtime of discovery in fleets of ten sizes."""

import numpy as np
from matplotlib.figure import Figure

from discostorm import figures, wording
from discostorm.messages import Protocol
from discostorm.model import utilization
from discostorm.palette import light_colors

#: Robots of the picture, each as in the paper's Fig. 2.
_ROBOTS = np.arange(1, 11)
_SWARM = (figures.FIG2_PROCESSES, figures.FIG2_ENDPOINTS)


def draw_link_picture(protocol: Protocol, size: tuple[int, int]) -> Figure:
    """Draw the picture of a link to the book, of that width and height [px]."""
    seconds = np.asarray(utilization(protocol, _ROBOTS, *_SWARM))
    fits = seconds <= 1
    most = int(_ROBOTS[fits].max())
    colors = np.where(fits, figures.color_of(protocol), light_colors("state")["bad"])
    with figures.style():
        figure = Figure(figsize=(size[0] / 100, size[1] / 100), dpi=100)
        figure.set_layout_engine("none")
        figure.text(0.06, 0.84, "Discovery Storm", fontsize=44, weight="bold", va="center")
        text = "How many ROS 2 robots fit\non a Wi-Fi channel before\n"
        text += "their search for each other\nfills the channel?\n\n"
        text += f"{most} small robots keep it busy\nfor {wording.duration(seconds[most - 1])}."
        figure.text(0.06, 0.41, text, fontsize=24, va="center", linespacing=1.4)
        axis = figure.add_axes((0.58, 0.17, 0.38, 0.74))
        axis.bar(_ROBOTS, seconds, color=colors)
        axis.axhline(1, color="black", lw=2)
        axis.text(0.5, 1.03, "one second", fontsize=20)
        axis.set(xticks=_ROBOTS, yticks=[])
        axis.tick_params(labelsize=18, length=0)
        axis.grid(visible=False)
        axis.set_xlabel("robots", fontsize=20)
        axis.spines[["top", "right", "left"]].set_visible(False)
    return figure
